//! Computes the error of a claimed solution relative to its proven bound, and the energy of this error, from the exact solution.

use groundbeam::proof::Proof;
use groundbeam::{Field, Model, Solution, SupportKind};

/// Rounding error allowed in the comparison with the true answer, relative to the largest value of the field.
const ROUNDING: f64 = 1e-10;

/// Changes of a model; each function multiplies one kind of number of the model by a factor.
pub const CHANGES: [fn(&mut Model, f64); 7] = [
    |model, factor| {
        let stiffness = &mut model.beam.shear_stiffness;
        *stiffness = stiffness.map(|stiffness| stiffness * factor);
        for segment in &mut model.beam.segments {
            segment.shear_stiffness = segment.shear_stiffness.map(|s| s.scaled(factor));
        }
    },
    |model, factor| {
        model.beam.bending_stiffness *= factor;
        for segment in &mut model.beam.segments {
            segment.bending_stiffness = segment.bending_stiffness.scaled(factor);
        }
    },
    |model, factor| model.foundation = model.foundation.clone().scaled(factor, 1.0),
    |model, factor| model.foundation = model.foundation.clone().scaled(1.0, factor),
    |model, factor| *model = model.clone().with_loads_scaled(factor),
    |model, factor| {
        for support in &mut model.supports {
            support.settlement *= factor;
            if let SupportKind::Spring { spring, rotational_spring } = &mut support.kind {
                (*spring, *rotational_spring) = (*spring * factor, *rotational_spring * factor);
            }
        }
    },
    |model, factor| model.beam.axial_force *= factor,
];

/// The proven error bound of a field; `None` for the gap, which has no bound of its own.
pub fn error_bound(proof: &Proof, field: Field) -> Option<f64> {
    let named = proof.bounds.named().into_iter().find(|(name, _)| *name == field.name());
    named.map(|(_, bound)| bound.error)
}

/// Whether the error bound of a field is valid at x. The bound of the pressure is valid only outside the intervals
/// that enclose the contact edges.
pub fn holds_at(proof: &Proof, field: Field, x: f64) -> bool {
    let inside = |[low, high]: [f64; 2]| low <= x && x <= high;
    match (field, &proof.contact) {
        (Field::Pressure, Ok(set)) => {
            !set.regions.iter().any(|region| inside(region.from) || inside(region.to))
        }
        (Field::Pressure, Err(_)) => false,
        _ => true,
    }
}

/// Returns the largest ratio of error to proven bound, at positions where no field jumps. Settlements are compared only
/// if both models have the same ground.
pub fn over_bound(claimed: &Solution, truth: &Solution, proof: &Proof, ground: bool) -> f64 {
    let length = truth.model().beam.length;
    let mut worst: f64 = 0.0;
    for field in Field::ALL.into_iter().filter(|field| ground || *field != Field::Settlement) {
        let Some(bound) = error_bound(proof, field) else { continue };
        let range = truth.range(field);
        let largest = range.max.value.abs().max(range.min.value.abs());
        let positions = (0..97).map(|i| length * (0.003 + 0.010_263 * f64::from(i)));
        for x in positions.filter(|x| holds_at(proof, field, *x)) {
            let error = (claimed.value(field, x) - truth.value(field, x)).abs();
            worst = worst.max((error - ROUNDING * largest) / bound);
        }
    }
    worst
}

/// Returns the bending energy of the moment error, and if `ground` is true, the energy of the settlement error in the
/// springs. Gauss's rule with two points integrates between stations.
pub fn energy_of_error(claimed: &Solution, truth: &Solution, ground: bool) -> f64 {
    let model = truth.model();
    let density = |x: f64| {
        let of = |field| claimed.value(field, x) - truth.value(field, x);
        let (moment, settled) = (of(Field::Moment), of(Field::Settlement));
        let (spring, _) = model.foundation.constants_at(x);
        let spring = if ground { spring } else { 0.0 };
        moment * moment / model.beam.bending_stiffness_at(x) + spring * settled * settled
    };
    let mut stations = [claimed.stations(1000), truth.stations(1000)].concat();
    stations.sort_by(f64::total_cmp);
    let between = |ends: &[f64]| {
        let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        let off = half / 3_f64.sqrt();
        half * (density(middle - off) + density(middle + off))
    };
    0.5 * stations.windows(2).map(between).sum::<f64>()
}
