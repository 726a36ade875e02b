//! Formats the numbers of one solution: rounded, or with error bounds if they are proven.

use crate::bound::{not_proven, rounded_with_bound, with_bound};
use crate::quantity::{Kind, Unit, Units};
use crate::size::Sizes;
use crate::verified::Named;
use groundbeam::proof::{Bound, PlacedExtreme, ReactionBound, Verification};
use groundbeam::{Field, Solution, solution::Extreme};

/// Maximum width, relative to the beam length, of an interval that is printed as one position with an error bound.
const NARROW: f64 = 1e-3;

/// Formats the numbers of one solution.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Numbers<'a> {
    pub units: Units,
    sizes: Sizes,
    /// The proof of the solution; `None` if no proof is requested.
    proof: Option<&'a Named>,
}

impl<'a> Numbers<'a> {
    /// Returns a formatter for the numbers of a solution. The formatter adds no error bounds.
    pub fn plain(solution: &Solution, units: Units) -> Self {
        Numbers { units, sizes: Sizes::of(solution), proof: None }
    }

    /// Returns a formatter that adds the error bounds of `proof`; with `None`, it adds no error bounds.
    pub fn with_proof(self, proof: Option<&'a Named>) -> Self {
        Numbers { proof, ..self }
    }

    /// Whether the numbers have error bounds.
    pub fn have_bounds(&self) -> bool {
        self.proof.is_some()
    }

    pub fn sizes(&self) -> &Sizes {
        &self.sizes
    }

    /// Formats a number in a unit. With a proof, `value` is printed with its error bound. Without a proof,
    /// `rounded` is printed.
    fn write(
        &self,
        unit: Unit,
        value: f64,
        rounded: f64,
        error: impl Fn(&Verification) -> f64,
    ) -> String {
        match self.proof {
            None => unit.write(rounded),
            Some(named) => {
                let error = named.found.as_ref().map_or(f64::INFINITY, error);
                with_bound(value, error, unit)
            }
        }
    }

    /// Formats a key figure. With a proof, it has four digits, and its error bound includes the rounding to
    /// these digits.
    fn key(&self, kind: Kind, value: f64, rounded: f64, error: impl Fn(&Named) -> f64) -> String {
        match self.proof {
            None => self.units.write(kind, rounded),
            Some(named) => rounded_with_bound(value, error(named), self.units.unit(kind, value), 4),
        }
    }

    /// Formats the largest or the smallest value of a field as a key figure, and formats the position of this
    /// value.
    pub fn key_of(&self, field: Field, is_max: bool, extreme: Extreme) -> [String; 2] {
        let rounded = self.sizes.value(field, extreme.value);
        let value =
            self.key(Kind::of(field), extreme.value, rounded, |named| named.error_of(field));
        let place = match self.proof {
            None => self.units.write(Kind::Position, self.sizes.position(extreme.x)),
            Some(_) => self.place_of(field, is_max, extreme.x),
        };
        [value, place]
    }

    /// Formats the force under an end of the beam as a key figure; `end` is 0 for the left end.
    pub fn key_of_end(&self, end: usize, force: f64) -> String {
        let rounded = self.sizes.force(force);
        self.key(Kind::Force, force, rounded, |named| named.error_of_end_force(end))
    }

    /// Formats the value of a field in `unit`, or in a suitable unit if `unit` is `None`.
    pub fn field(&self, field: Field, value: f64, unit: Option<Unit>) -> String {
        let unit = unit.unwrap_or_else(|| self.units.unit(Kind::of(field), value));
        let rounded = self.sizes.value(field, value);
        self.write(unit, value, rounded, |found| found.error_of(field.name()))
    }

    /// Formats the position of an extreme. No error bound is added to the position.
    pub fn place(&self, x: f64) -> String {
        self.units.position(self.sizes.position(x))
    }

    /// Formats a position without a proven bound. If the numbers have bounds, the position is marked as not
    /// proven.
    pub fn place_without_bound(&self, x: f64) -> String {
        let place = self.place(x);
        if self.have_bounds() { not_proven(&place) } else { place }
    }

    /// Formats the position of the largest gap in a lift-off zone. It has a proven bound only in the zone with the
    /// largest gap of the whole beam.
    pub fn place_of_gap(&self, x: f64) -> String {
        let found = self.proof.and_then(|named| named.found.as_ref().ok());
        let largest = |e: &PlacedExtreme| e.field == Field::Gap.name() && e.is_max && e.listed == x;
        match found.is_some_and(|found| found.extremes.iter().any(largest)) {
            true => self.place_of(Field::Gap, true, x),
            false => self.place_without_bound(x),
        }
    }

    /// Formats the position of an extreme, with its error bound or with the interval of the exact position.
    pub fn place_of(&self, field: Field, is_max: bool, x: f64) -> String {
        let found = self.proof.and_then(|named| named.found.as_ref().ok());
        let placed = found.and_then(|found| {
            let same = |e: &&PlacedExtreme| e.field == field.name() && e.is_max == is_max;
            found.extremes.iter().find(same)
        });
        let Some((placed, [low, high])) = placed.and_then(|p| Some((p, p.nearest()?))) else {
            return self.place_without_bound(x);
        };
        let unit = self.units.unit(Kind::Position, x);
        let place = match high - low <= NARROW * self.sizes.length() {
            true => with_bound(x, placed.error(), unit),
            false => {
                format!("{} ({} to {})", self.place(x), unit.number(low), unit.write(high))
            }
        };
        match placed.places.len() {
            1 => place,
            _ => format!("{place} or elsewhere"),
        }
    }

    /// Formats the fraction of the beam that has lifted off, in percent.
    pub fn lifted_share(&self, solution: &Solution) -> String {
        let share = solution.lifted_share();
        match self.proof {
            None => self.units.percent().write(share),
            Some(named) => {
                with_bound(share, named.error_of_lifted_share(solution), self.units.percent())
            }
        }
    }

    /// Formats the position of one end of a contact zone.
    pub fn edge(&self, region: usize, end: usize, x: f64) -> String {
        let unit = self.units.unit(Kind::Position, x);
        let error = |found: &Verification| of(found.listed.edges.get(region).map(|ends| ends[end]));
        self.write(unit, x, self.sizes.position(x), error)
    }

    /// Formats the force under an end of the beam; `end` is 0 for the left end.
    pub fn end_force(&self, end: usize, force: f64) -> String {
        let error = |found: &Verification| of(found.listed.end_forces.map(|ends| ends[end]));
        self.force(force, error)
    }

    /// Formats a point contact force between the ends of the beam. The index `i` does not count the forces
    /// under the ends.
    pub fn inner_force(&self, i: usize, force: f64) -> String {
        self.force(force, |found| of(found.listed.forces.get(i + 1).copied()))
    }

    /// Formats the reaction force of a support.
    pub fn reaction(&self, support: usize, force: f64) -> String {
        self.force(force, |found| reaction(found, support, |bound| bound.force))
    }

    /// Formats the reaction moment of a support.
    pub fn reaction_moment(&self, support: usize, moment: f64) -> String {
        let unit = self.units.unit(Kind::Moment, moment);
        let error = |found: &Verification| reaction(found, support, |bound| bound.moment);
        self.write(unit, moment, self.sizes.moment(moment), error)
    }

    fn force(&self, force: f64, error: impl Fn(&Verification) -> f64) -> String {
        let unit = self.units.unit(Kind::Force, force);
        self.write(unit, force, self.sizes.force(force), error)
    }

    /// Formats the rotation and the moment of a hinge.
    pub fn hinge(&self, i: usize, rotation: f64, moment: f64) -> [String; 2] {
        let error = |which: usize| {
            move |found: &Verification| of(found.listed.hinges.get(i).map(|hinge| hinge[which]))
        };
        let [turn, bend] = [(Kind::Slope, rotation), (Kind::Moment, moment)]
            .map(|(kind, x)| self.units.unit(kind, x));
        [
            self.write(turn, rotation, self.sizes.value(Field::Slope, rotation), error(0)),
            self.write(bend, moment, self.sizes.moment(moment), error(1)),
        ]
    }

    /// Returns an extreme. Without error bounds, an extreme that is only rounding error is set to zero.
    pub fn extreme(&self, field: Field, extreme: Extreme) -> Extreme {
        if self.have_bounds() { extreme } else { self.sizes.extreme(field, extreme) }
    }
}

/// Returns the error bound, or infinity if there is no bound.
fn of(error: Option<f64>) -> f64 {
    error.unwrap_or(f64::INFINITY)
}

fn reaction(
    found: &Verification,
    support: usize,
    of_bound: impl Fn(&ReactionBound) -> Bound,
) -> f64 {
    of(found.proof.reactions.get(support).map(|bound| of_bound(bound).error))
}
