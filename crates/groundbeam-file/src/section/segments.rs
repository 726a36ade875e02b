//! Computes segments of the beam (EI, S) and of the ground (k, μ) from their tables and the table for the whole beam.
//!
//! A segment inherits missing factors of EI = E·I and k = `subgrade_modulus`·`width` from the whole beam at the same
//! position. A segment that gives only S or μ inherits EI or k.

use crate::profile::{Along, left_out};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::model::Profile;

/// Segments, field names and keys of the beam or of the ground.
pub(super) struct Body {
    pub segment: fn(usize) -> Part,
    /// Names of two fields of the model: EI and S of the beam, or k and μ of the ground.
    pub fields: [&'static str; 2],
    /// Keys of EI or k.
    pub keys: Keys,
}

/// A segment of the beam or of the ground.
pub(super) struct Segment {
    pub from: f64,
    pub to: f64,
    /// EI of a beam segment, or k of a ground segment.
    pub stiffness: Profile,
    /// Shear stiffness S of a beam segment, or stiffness μ of the shear layer of a ground segment; `None` if the value
    /// of the table `[beam]` or `[foundation]` applies.
    pub second: Option<Profile>,
}

/// Data of the table `[beam]` or `[foundation]`, which apply wherever no segment applies.
pub(super) struct Whole {
    pub length: f64,
    given: Given,
    stiffness: Stiffness,
    /// Shear stiffness S from `[beam]`, or stiffness μ of the shear layer from `[foundation]`. A segment without its
    /// own S or μ has this value.
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

    /// Returns the data given for the whole beam, restricted to the part between two fractions of its
    /// length.
    pub fn given(&self, way: [f64; 2]) -> Given {
        self.given.between(way)
    }

    /// Whether the table `[beam]` or `[foundation]` gives a quantity that is not constant along the beam.
    pub fn varies(&self) -> bool {
        let [a, b] = &self.given.factors;
        let all = [&self.given.product, a, b, &self.second];
        all.into_iter().flatten().any(|along| !along.profile.is_constant())
    }

    /// Reads the ends of a segment. Returns their positions \[m\], and their positions as fractions of the
    /// beam length.
    pub fn ends(&self, reader: &mut Reader, table: &Section) -> ([f64; 2], [f64; 2]) {
        let ends = ["from", "to"].map(|key| reader.required(table, key).value);
        (ends, ends.map(|x| (x / self.length).clamp(0.0, 1.0)))
    }

    /// Computes a segment from its table: `own` is EI or k, or its two factors, and `second` is S or μ.
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
            // The segment inherits EI from `[beam]` or k from `[foundation]`. A wrong value is reported at that table.
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

    /// Returns the constants EI and S, or k and μ, that apply outside all segments. If one of them varies, adds
    /// segments where none is given.
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
            // The segments cover the whole beam, so the returned constants apply nowhere. Any valid constants
            // are suitable.
            reader.place(table, name, &Field::unreadable(0..0));
            return (last.stiffness.end(), last.second.map(|second| second.end()));
        }
        let stiffness = reader.settle(stiffness, table, &body.keys);
        reader.place(table, name, &stiffness.field());
        let start = |along: &Along| along.profile.start();
        let constants = (start(&stiffness), second.as_ref().map(start));
        let all = [Some(&stiffness), second.as_ref()];
        let varies = all.into_iter().flatten().any(|along| !along.profile.is_constant());
        // Constants that are invalid at the left end of the beam are reported by the model.
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
