//! Sets values that are only rounding error to zero, by comparison with the loads and dimensions of the model.

use groundbeam::{Field, Load, Model, Solution, model::Action, solution::Extreme};

/// A field value below this fraction of the typical magnitude of its field is printed as zero.
const ROUNDING: f64 = 1e-12;

/// Typical magnitudes of the fields of a solution, computed from loads, reactions, deflections and the beam
/// length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sizes {
    length: f64,
    force: f64,
    deflection: f64,
    pressure: f64,
}

impl Sizes {
    pub fn of(solution: &Solution) -> Self {
        let model = solution.model();
        let largest = |field| {
            let range = solution.range(field);
            range.min.value.abs().max(range.max.value.abs())
        };
        let reactions = solution.reactions().iter().map(|r| r.force.abs());
        let force = load_size(model) + reactions.sum::<f64>();
        let length = model.beam.length;
        let deflection = largest(Field::Deflection).max(largest(Field::Settlement));
        // `force` includes moments that balance each other and cause no pressure. Then k times the deflection is the
        // better estimate of the pressure.
        let (subgrade, _) = model.foundation.largest();
        let pressure = (force / length).min(subgrade * deflection);
        Sizes { length, force, deflection, pressure }
    }

    /// The length of the beam.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Returns the value of a field, or zero if the value is only rounding error.
    pub fn value(&self, field: Field, value: f64) -> f64 {
        let Sizes { length, force, deflection, pressure } = *self;
        let natural = field.natural_size(length, force, deflection, pressure);
        if value.abs() <= ROUNDING * natural { 0.0 } else { value }
    }

    /// A position, or zero if it is only rounding error.
    pub fn position(&self, x: f64) -> f64 {
        if x.abs() <= ROUNDING * self.length { 0.0 } else { x }
    }

    pub fn force(&self, force: f64) -> f64 {
        self.value(Field::ShearForce, force)
    }

    pub fn moment(&self, moment: f64) -> f64 {
        self.value(Field::Moment, moment)
    }

    pub fn extreme(&self, field: Field, extreme: Extreme) -> Extreme {
        Extreme { x: self.position(extreme.x), value: self.value(field, extreme.value) }
    }
}

/// Sum of the magnitudes of all loads; a moment counts as a pair of forces at the beam's ends.
fn load_size(model: &Model) -> f64 {
    let l = model.beam.length;
    let size = |load: &Load| match load.action() {
        Action::Curvature => load.extent().largest() * model.beam.bending_stiffness / l,
        _ => load.as_force(l),
    };
    model.loads.iter().map(size).sum()
}
