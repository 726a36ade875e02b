//! Computes buckling loads of the beam without ground and of the beam bonded to the ground in given contact zones.
//!
//! Below the buckling load without ground, the energy is convex for all contact zones.

use crate::cancel::Cancel;
use crate::chain::elimination::Chain;
use crate::chain::node::{ChainCell, ChainNode};
use crate::contact::bonded::{Bonded, folds, zone_kind_of};
use crate::contact::intervals::Interval;
use crate::element::element::MOST_COMPRESSION;
use crate::element::operator::{Operator, ZoneKind};
use crate::element::{ExactElement, cut_equally};
use crate::existence::rigid_motions::held_rigidly;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::model::compressed;

/// A search for instability ends below the [compression that removes the shear stiffness](folding_compression). The
/// remaining distance is this fraction of the distance from the model's compression for a buckling load, and this
/// fraction of the compression itself for the path of equilibria. Closer to it, a solve needs more elements.
pub(crate) const BELOW_FOLDING: f64 = 1e-8;

/// Returns the buckling load \[N\] of a valid model without its ground. It is a lower bound, accurate to twelve digits,
/// and infinite if the beam does not buckle.
pub fn own_buckling_load(model: &Model) -> f64 {
    unsupported_buckling_load(model, &Cancel::default())
}

/// Buckling load of the beam on its supports, without ground \[N\].
fn unsupported_buckling_load(model: &Model, cancel: &Cancel) -> f64 {
    let is_stable = |compression| !cancel.is_cancelled() && is_stable(model, compression);
    least_unstable(model, f64::INFINITY, is_stable)
}

/// Returns a lower bound of the second variation of the energy, relative to that without compression: 1 minus the
/// compression divided by the buckling load without ground. Returns `None` if the energy is not convex.
pub(crate) fn convexity(model: &Model, cancel: &Cancel) -> Option<f64> {
    let axial = model.beam.axial_force;
    if axial >= 0.0 {
        return Some(1.0);
    }
    if !held_rigidly(model) {
        return None;
    }
    // One-way supports are omitted, because each of them resists a deflection in one direction only.
    let held = model.with_supports_that(|_, support| !support.is_one_way());
    let left = 1.0 + axial / unsupported_buckling_load(&held, cancel);
    (left > 0.0).then_some(left)
}

/// Returns the compression \[N\] that removes the shear stiffness of the beam somewhere, if the beam is bonded to the
/// ground on given intervals. It is infinite for a beam without shear deformation.
pub(crate) fn folding_compression(model: &Model, contact: &[Interval]) -> f64 {
    if !model.beam.shears() {
        return f64::INFINITY;
    }
    let touch = zone_kind_of(contact);
    let has_shear_stiffness =
        |compression: f64| !folds(&compressed(model, compression), contact.as_flattened(), &touch);
    least_unstable(model, f64::INFINITY, has_shear_stiffness)
}

/// Returns the buckling load \[N\] of the beam bonded to the ground on given intervals, a lower bound accurate to
/// twelve digits. If the shear stiffness vanishes first, the load minus the model's compression has eight digits.
pub(crate) fn bonded_buckling_load(model: &Model, contact: &[Interval], cancel: &Cancel) -> f64 {
    let folding = folding_compression(model, contact);
    let above = folding + model.beam.axial_force;
    let distance = if above > 0.0 { above } else { folding };
    let enough = if folding.is_finite() { folding - BELOW_FOLDING * distance } else { folding };
    least_unstable(model, enough, |compression| {
        is_stable_bonded(model, contact, compression, cancel)
    })
}

/// Whether the beam is stable under the given compression if it is bonded to the ground on the intervals `contact`.
pub(crate) fn is_stable_bonded(
    model: &Model,
    contact: &[Interval],
    compression: f64,
    cancel: &Cancel,
) -> bool {
    Bonded::new(&compressed(model, compression), cancel).is_stable_on(contact)
}

/// A lower bound of the compression at which the beam becomes unstable. Returns `enough` if the beam is stable at this
/// compression.
fn least_unstable(model: &Model, enough: f64, is_stable: impl Fn(f64) -> bool) -> f64 {
    let l = model.beam.length;
    let unit = model.beam.stiffest() / (l * l);
    let mut low = 0.0;
    let mut high = unit.min(enough);
    while is_stable(high) {
        if high == enough {
            return enough;
        }
        low = high;
        high = (2.0 * high).min(enough);
        if high > MOST_COMPRESSION * unit {
            return f64::INFINITY;
        }
    }
    while high - low > 1e-13 * high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if is_stable(middle) { low = middle } else { high = middle }
    }
    low
}

fn is_stable(model: &Model, compression: f64) -> bool {
    let model = &compressed(model, compression);
    if folds(model, &[], &|_: &_| ZoneKind::Open) {
        return false;
    }
    let operator = |cell: &_| Operator::of(cell, -compression, ZoneKind::Open);
    let mesh = Mesh::graded(model, &[], |cell, x| cut_equally(&operator(cell), cell, x));
    let cell = |cell: &crate::mesh::cell::Cell| ChainCell {
        element: ExactElement::of(cell, -compression, ZoneKind::Open).element,
        open: None,
    };
    // Stability does not depend on loads and settlements.
    let nodes = mesh.nodes.iter().map(ChainNode::of);
    let cells: Vec<ChainCell> = mesh.cells.iter().map(cell).collect();
    let supported = mesh.nodes.iter().position(|n| n.clamped || n.pinned || n.spring > 0.0);
    let chain = Chain { nodes: nodes.collect(), cells, meeting: supported.unwrap_or(0) };
    chain.solve().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Hinge, Support};
    use crate::numeric::elementary::tan;
    use std::f64::consts::PI;

    fn load(supports: &[Support]) -> f64 {
        let mut model = Model::new(Beam::uniform(2.0, 3.0), Foundation::winkler(1.0));
        model.supports = supports.to_vec();
        own_buckling_load(&model) * 4.0 / 3.0
    }

    #[test]
    fn eulers_four_columns() {
        // Euler's four columns have P l²/EI = π²/4, π², 20.190728556426629… and 4π² (Timoshenko and Gere, Theory of
        // Elastic Stability). The third number is z² for the first root z > 0 of tan z = z.
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}");
        close(load(&[Support::fixed(0.0)]), PI * PI / 4.0);
        close(load(&[Support::pinned(0.0), Support::pinned(2.0)]), PI * PI);
        close(load(&[Support::fixed(0.0), Support::pinned(2.0)]), 20.190_728_556_426_63);
        close(load(&[Support::fixed(0.0), Support::fixed(2.0)]), 4.0 * PI * PI);
    }

    /// A column has a hinge with a rotational spring C at its middle. Its buckling load P satisfies
    /// z tan z = C l/EI with z = l/2 √(P/EI).
    #[test]
    fn a_spring_in_the_middle() {
        for z in [0.1, 0.5, PI / 4.0, 1.2, 1.5] {
            let spring = 3.0 * z * tan(z) / 2.0;
            let model = Model::new(Beam::uniform(2.0, 3.0), Foundation::winkler(1.0))
                .with_support(Support::pinned(0.0))
                .with_support(Support::pinned(2.0))
                .with_hinge(Hinge::elastic(1.0, spring));
            let found = own_buckling_load(&model);
            assert!((found / (3.0 * z * z) - 1.0).abs() < 1e-11, "{z}: {found}");
        }
    }

    /// A cantilever supports a nearly rigid bar through a pin. The inclined bar exerts a lateral force on the tip.
    #[test]
    fn a_cantilever_under_a_pinned_bar() {
        // For a cantilever of length a and a rigid bar of length b, tan z = z (1 + b/a) with z = a √(P/EI).
        let (a, b) = (1.0, 0.5);
        let model = Model::new(
            Beam::uniform(a + b, 2.0).with_segment(a, a + b, 2e9),
            Foundation::winkler(1.0),
        )
        .with_support(Support::fixed(0.0))
        .with_support(Support::pinned(a + b))
        .with_hinge(Hinge::free(a));
        let z = (own_buckling_load(&model) / 2.0).sqrt() * a;
        assert!((tan(z) - z * (1.0 + b / a)).abs() < 1e-6, "{z}");
    }

    #[test]
    fn a_pin_on_a_rotational_spring() {
        // A rigid bar on a rotational spring k_φ buckles at k_φ/l. This bar is a thousand times stiffer than
        // its spring, so its buckling load is close to k_φ/l.
        let p = load(&[Support::pinned(0.0), Support::spring(2.0, 0.0, 3e-3)]);
        assert!((p / 2e-3 - 1.0).abs() < 1e-3, "{p}");
    }
}
