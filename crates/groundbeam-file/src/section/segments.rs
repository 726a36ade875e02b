//! Computes segments of the beam (EI, S) and of the ground (k, μ) from their tables and the table for the
//! whole beam.
//!
//! A factor that a segment leaves out has the value of the whole beam at the same position. The same holds
//! for EI or k if the segment gives only S or μ. A variation along the whole beam applies outside the
//! segments.

use crate::profile::{Along, left_out};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::model::Profile;

/// Quantities of the beam or of the ground.
pub(super) struct Body {
    pub segment: fn(usize) -> Part,
    /// Fields of the model: EI and S, or k and μ.
    pub fields: [&'static str; 2],
    /// Keys of EI or k.
    pub keys: Keys,
}

/// A stretch of the beam or of the ground.
pub(super) struct Segment {
    pub from: f64,
    pub to: f64,
    /// EI or k.
    pub stiffness: Profile,
    /// S or μ; `None` if the value of the whole beam applies.
    pub second: Option<Profile>,
}

/// Data of the table for the whole beam.
pub(super) struct Whole {
    pub length: f64,
    given: Given,
    stiffness: Stiffness,
    /// S or μ, for segments that leave it out.
    second: Option<Along>,
    body: &'static Body,
}

impl Whole {
    pub fn new(
        reader: &mut Reader,
        length: f64,
        given: Given,
        second: Option<Along>,
        body: &'static Body,
    ) -> Self {
        let stiffness = given.resolve(reader, &Given::default(), &body.keys);
        Whole { length, given, stiffness, second, body }
    }

    /// The quantities given for the whole beam, restricted to a part of it.
    pub fn given(&self, way: [f64; 2]) -> Given {
        self.given.between(way)
    }

    /// Whether any quantity varies along the whole beam.
    pub fn varies(&self) -> bool {
        let [a, b] = &self.given.factors;
        let all = [&self.given.product, a, b, &self.second];
        all.into_iter().flatten().any(|along| !along.profile.is_constant())
    }

    /// Ends of a segment: positions, and fractions of the beam's length.
    pub fn ends(&self, reader: &mut Reader, table: &Section) -> ([f64; 2], [f64; 2]) {
        let ends = ["from", "to"].map(|key| reader.required(table, key).value);
        (ends, ends.map(|x| (x / self.length).clamp(0.0, 1.0)))
    }

    /// A segment with the values in `own`, and S or μ if it gives one.
    pub fn segment(
        &self,
        reader: &mut Reader,
        table: &Section,
        ([from, to], way): ([f64; 2], [f64; 2]),
        own: &Given,
        second: Option<Along>,
    ) -> Segment {
        let [name, second_name] = self.body.fields;
        let stiffness = own.resolve(reader, &self.given(way), &self.body.keys);
        let stiffness = match (stiffness, &self.stiffness) {
            // A wrong value of the whole beam is reported at its own table.
            (Stiffness::NotGiven, Stiffness::Known(whole)) if second.is_some() => {
                reader.place(table, name, &Field::unreadable(0..0));
                whole.between(way)
            }
            (own, _) => {
                let own = reader.settle(own, table, &self.body.keys);
                reader.place(table, name, &own.field());
                own
            }
        };
        let place = second.as_ref().map_or(Field::unreadable(0..0), Along::field);
        reader.place(table, second_name, &place);
        let second = second.or_else(|| self.second.as_ref().map(|whole| whole.between(way)));
        let second = second.map(|along| along.profile);
        Segment { from, to, stiffness: stiffness.profile, second }
    }

    /// Constants outside all segments. Adds segments where a quantity of the whole beam varies.
    pub fn complete(
        self,
        reader: &mut Reader,
        table: &Section,
        segments: &mut Vec<Segment>,
    ) -> (f64, Option<f64>) {
        let Whole { length, stiffness, second, body, .. } = self;
        let [name, second_name] = body.fields;
        let stretches: Vec<(f64, f64)> = segments.iter().map(|s| (s.from, s.to)).collect();
        let rightmost = segments.iter().max_by(|a, b| a.to.total_cmp(&b.to));
        if let (Stiffness::NotGiven | Stiffness::Half(..), Some(last)) = (&stiffness, rightmost)
            && cover(length, stretches.iter().copied())
        {
            // The segments cover the whole beam, so the constants apply nowhere. They must only be valid.
            reader.place(table, name, &Field::unreadable(0..0));
            return (last.stiffness.end(), last.second.map(|second| second.end()));
        }
        let stiffness = reader.settle(stiffness, table, &body.keys);
        reader.place(table, name, &stiffness.field());
        let start = |along: &Along| along.profile.start();
        let constants = (start(&stiffness), second.as_ref().map(start));
        let all = [Some(&stiffness), second.as_ref()];
        let varies = all.into_iter().flatten().any(|along| !along.profile.is_constant());
        // An invalid value at the start has been reported already.
        if !varies || constants.0 <= 0.0 || constants.1.is_some_and(|second| second < 0.0) {
            return constants;
        }
        for [from, to] in left_out(length, stretches.into_iter()) {
            let way = [from / length, to / length];
            let part = (body.segment)(segments.len());
            let stiffness = stiffness.between(way);
            reader.places.field(part, name, &stiffness.field());
            let second = second.as_ref().map(|second| second.between(way));
            if let Some(second) = &second {
                reader.places.field(part, second_name, &second.field());
            }
            let second = second.map(|along| along.profile);
            segments.push(Segment { from, to, stiffness: stiffness.profile, second });
        }
        constants
    }
}
