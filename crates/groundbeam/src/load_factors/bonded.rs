//! Computes contact pressures and forces of a beam bonded along its whole length, to find where lift-off begins.

use crate::cancel::Cancel;
use crate::chain::node::NotDefinite;
use crate::contact::bonded::Bonded;
use crate::contact::state::ContactState;
use crate::contact::surface::Surface;
use crate::load_factors::lift_off_candidate::{LiftOffCandidate, Side};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::pressure_under;
use crate::model::Model;
use crate::numeric::polynomial::{Coefficients, rescale};
use crate::numeric::tolerance::same_place;

/// The deflection of a beam bonded to the ground along its whole length, with compressive or tensile contact.
pub(super) fn bonded_everywhere(
    model: &Model,
    cancel: &Cancel,
) -> Result<ContactState, NotDefinite> {
    Bonded::new(model, cancel).solve_on(&[[0.0, model.beam.length]])
}

/// Returns the pressures and concentrated forces along the whole beam, from left to right, for the deflections under
/// the constant and the increasing loads. The cells of the two deflections may differ.
pub(super) fn lift_off_candidates(
    staying: &ContactState,
    growing: &ContactState,
) -> Vec<LiftOffCandidate> {
    let mut all = forces(staying, growing);
    let l = staying.mesh.cells.last().map_or(0.0, |cell| cell.x[1]);
    let (mut i, mut j, mut from) = (0, 0, 0.0);
    while let (Some(a), Some(b)) = (staying.mesh.cells.get(i), growing.mesh.cells.get(j)) {
        let same = (a.x[1] - b.x[1]).abs() <= same_place(l);
        let to = if same { a.x[1] } else { a.x[1].min(b.x[1]) };
        let x = [from, to];
        let mut sides = [pressure(staying, i, x), pressure(growing, j, x)];
        // At a zero under all loads, the slope or the curvature of the pressure decides the first lift-off.
        for (end, root) in known_roots(staying, x, a) {
            for side in &mut sides {
                for _ in 0..root {
                    without_root(&mut side.coefficients, end);
                }
            }
        }
        let [stays, grows] = sides;
        all.push(LiftOffCandidate { x, staying: stays, growing: grows });
        i += usize::from(same || a.x[1] < b.x[1]);
        j += usize::from(same || b.x[1] < a.x[1]);
        from = to;
    }
    all.sort_by(|a, b| a.x[0].total_cmp(&b.x[0]));
    all
}

/// Returns the pressure on the part `x` of cell `i`, and the sum of the absolute values of the terms of the pressure.
fn pressure(found: &ContactState, i: usize, x: [f64; 2]) -> Side {
    let cell = &found.mesh.cells[i];
    let half = 0.5 * cell.length();
    let deflection = Coefficients::from(found.deflection().cell(i));
    let whole = pressure_under(cell, half, &deflection);
    let factor = cell.shear_layer / (half * half);
    let term = |(j, c): (usize, &f64)| {
        (cell.subgrade + factor * (j * j.saturating_sub(1)) as f64) * c.abs()
    };
    let [gap, load] = [cell.gap, cell.ground_load].map(|ends| ends[0].abs().max(ends[1].abs()));
    let size = deflection.iter().enumerate().map(term).sum::<f64>() + cell.subgrade * gap + load;
    let coefficients = if x == cell.x {
        whole
    } else {
        let [a, b] = x.map(|x| cell.local(x));
        rescale(&whole, 0.5 * (a + b), 0.5 * (b - a))
    };
    Side { coefficients, size }
}

/// Returns the ends s = ∓1 at which a rigid support on Winkler ground keeps the pressure zero under all loads, and the
/// multiplicity of each zero.
fn known_roots(found: &ContactState, x: [f64; 2], cell: &Cell) -> Vec<(f64, usize)> {
    if cell.shear_layer > 0.0 {
        return Vec::new();
    }
    let mut roots = Vec::new();
    for (i, end) in [(0, -1.0), (1, 1.0)] {
        let nodes = &found.mesh.nodes;
        let at = nodes.partition_point(|node| node.x < x[i]);
        let Some(node) = nodes.get(at).filter(|node| node.x == x[i] && node.pinned) else {
            continue;
        };
        if x[i] == cell.x[i] && cell.gap[i] == node.settlement {
            let flat = node.clamped && cell.gap_slope == 0.0;
            roots.push((end, if flat { 2 } else { 1 }));
        }
    }
    roots
}

/// Divides c(s) by 1 + s if `end` is −1, and by 1 − s if `end` is 1. Both divisors are positive between the
/// ends.
fn without_root(c: &mut Coefficients, end: f64) {
    // Synthetic division divides c(s) by the linear factor of its root s = `end`, from the highest power down. The
    // remainder is c(`end`), which is zero up to rounding error.
    let mut carried = 0.0;
    for a in c.iter_mut().rev() {
        let quotient = if end < 0.0 { *a - carried } else { carried - *a };
        *a = carried;
        carried = quotient;
    }
    c.pop();
}

/// Returns the concentrated contact forces under the ends of the beam and of the shear layer, at corners of the
/// gap and at kinks of the beam.
fn forces(staying: &ContactState, growing: &ContactState) -> Vec<LiftOffCandidate> {
    let [stays, grows] = [staying, growing].map(forces_of);
    let find = |all: &[(f64, Side)], x: f64| {
        let nothing = Side { coefficients: Coefficients::zeros(1), size: 0.0 };
        all.iter().find(|(at, _)| *at == x).map_or(nothing, |(_, side)| side.clone())
    };
    // The initial gap belongs to the constant loads, so its corners cause contact forces only under the
    // constant loads.
    let all = stays.iter().map(|(x, side)| {
        let growing = find(&grows, *x);
        LiftOffCandidate { x: [*x; 2], staying: side.clone(), growing }
    });
    // On a beam with shear deformation, each point force among the increasing loads causes a kink of the
    // deflection and therefore a contact force.
    let kinks = grows.iter().filter(|(x, _)| stays.iter().all(|(at, _)| at != x));
    let kinks = kinks.map(|(x, side)| {
        let staying = find(&stays, *x);
        LiftOffCandidate { x: [*x; 2], staying, growing: side.clone() }
    });
    all.chain(kinks).collect()
}

fn forces_of(found: &ContactState) -> Vec<(f64, Side)> {
    let w = found.deflection();
    let surface = Surface::of(&w, &found.zones);
    let force = |point_force: &crate::contact::surface::PointForce| {
        let cell = &found.mesh.cells[point_force.point.cell];
        let slope = 2.0 * cell.shear_layer / cell.length();
        let outside = (cell.subgrade * cell.shear_layer).sqrt();
        let obstacle = w.obstacle(point_force.point.cell);
        let terms = obstacle.iter().enumerate();
        let size = terms.map(|(j, c)| (outside + slope * j as f64) * c.abs()).sum();
        (
            cell.global(point_force.point.s),
            Side { coefficients: [point_force.force][..].into(), size },
        )
    };
    surface.point_forces.iter().map(force).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::deflection::{BeamPoint, MeshZone};
    use crate::mesh::mesh::Mesh;
    use crate::model::{Beam, Foundation, Support};
    use crate::numeric::polynomial::{TERMS, value};

    #[track_caller]
    fn near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() <= 1e-14 * wanted.abs().max(1.0), "{found} {wanted}");
    }

    /// The polynomials (1 + s)(2 + 3s + s²) and (1 − s)(2 + 3s + s²) are divided by their first factors.
    #[test]
    fn a_known_root_is_divided_out() {
        for (end, c) in [(-1.0, [2.0, 5.0, 4.0, 1.0]), (1.0, [2.0, 1.0, -2.0, -1.0])] {
            let mut left = Coefficients::from(&c[..]);
            without_root(&mut left, end);
            assert_eq!(left[..], [2.0, 3.0, 1.0], "{end}");
        }
    }

    /// Returns the state of a beam that is bonded along its whole length. Its deflection is a polynomial in x.
    /// Its mesh has additional nodes.
    fn found(model: &Model, more: &[f64], deflection: &[f64]) -> ContactState {
        let mesh = Mesh::build(model, more, |_| 1);
        let own = |cell: &Cell| {
            let [from, to] = cell.x;
            let c = rescale(deflection, 0.5 * (from + to), 0.5 * (to - from));
            c.at_least(TERMS).to_vec()
        };
        let coefficients = mesh.cells.iter().flat_map(own).collect();
        let end = BeamPoint { cell: mesh.cells.len() - 1, s: 1.0 };
        let zones = vec![MeshZone { from: BeamPoint { cell: 0, s: -1.0 }, to: end }];
        ContactState::exact(mesh, coefficients, Vec::new(), zones)
    }

    fn on(ground: Foundation) -> Model {
        Model::new(Beam::uniform(4.0, 1.0), ground)
    }

    /// The pressure under w = 1 + x + x² with k = 3 and μ = 5 is 3w − 10. On \[1, 4\], w = 9.75 + 9 s + 2.25 s², so the
    /// absolute values of the terms add up to 3 · 21 + 10. The gap adds 3 · 0.75, and the load on the ground adds 2.
    #[test]
    fn the_pressure_on_a_part_of_a_cell_and_its_size() {
        let model = on(Foundation::pasternak(3.0, 5.0));
        let mut of = found(&model, &[1.0], &[1.0, 1.0, 1.0]);
        let p = |x: f64| 3.0 * (1.0 + x + x * x) - 10.0;
        for x in [[1.0, 4.0], [1.0, 2.0], [2.0, 3.0], [3.5, 4.0]] {
            let Side { coefficients, size } = pressure(&of, 1, x);
            near(size, 63.0 + 10.0);
            for s in [-1.0, -0.25, 0.0, 1.0] {
                near(value(&coefficients, s), p(0.5 * (x[0] + x[1]) + 0.5 * (x[1] - x[0]) * s));
            }
        }
        of.mesh.cells[1].gap = [0.5, -0.75];
        of.mesh.cells[1].ground_load = [-2.0, 1.0];
        near(pressure(&of, 1, [1.0, 4.0]).size, 73.0 + 3.0 * 0.75 + 2.0);
    }

    /// The nodes of two meshes with different nodes together divide the beam into parts. On Winkler ground, the
    /// pressure on each part is k times the deflection.
    #[test]
    fn two_meshes_are_merged_at_all_of_their_nodes() {
        let model = on(Foundation::winkler(2.0));
        let merged = |first: &[f64], second: &[f64]| {
            let staying = found(&model, first, &[1.0, 2.0, 3.0]);
            let growing = found(&model, second, &[-1.0, 0.5]);
            let all = lift_off_candidates(&staying, &growing);
            for LiftOffCandidate { x, staying, growing } in &all {
                for (s, x) in [-1.0, 1.0].into_iter().zip(*x) {
                    let [stays, grows] =
                        [2.0 * (1.0 + 2.0 * x + 3.0 * x * x), 2.0 * (0.5 * x - 1.0)];
                    // A merged position may differ from the node by 16 machine epsilons times the beam length.
                    assert!((value(&staying.coefficients, s) - stays).abs() < 1e-11);
                    assert!((value(&growing.coefficients, s) - grows).abs() < 1e-12);
                }
            }
            all.into_iter().map(|candidate| candidate.x).collect::<Vec<_>>()
        };
        let wanted = [[0.0, 1.0], [1.0, 2.0], [2.0, 3.0], [3.0, 4.0]];
        assert_eq!(merged(&[1.0, 3.0], &[2.0, 3.0]), wanted);
        assert_eq!(merged(&[2.0, 3.0], &[1.0, 3.0]), wanted);
        assert_eq!(merged(&[1.0, 2.0, 3.0], &[]), wanted);
        assert_eq!(merged(&[], &[1.0, 2.0, 3.0]), wanted);
        // Positions that differ by less than 16 machine epsilons times the beam length 4 count as equal. `unit`
        // is one machine epsilon times this length.
        let unit = 4.0 * f64::EPSILON;
        assert_eq!(merged(&[1.0], &[1.0 + 15.0 * unit]), [[0.0, 1.0], [1.0, 4.0]]);
        assert_eq!(merged(&[1.0 + 15.0 * unit], &[1.0]).len(), 2);
        assert_eq!(merged(&[1.0], &[1.0 + 17.0 * unit]).len(), 3);
    }

    /// On Winkler ground at the height of a support, the pressure is zero at a pin, and its slope is also zero at a
    /// clamp.
    #[test]
    fn supports_at_undeformed_ground_are_roots_of_the_pressure() {
        let roots = |model: &Model, x: [f64; 2]| {
            let of = found(model, &[2.0], &[0.0]);
            let cell = of.mesh.cells.iter().find(|cell| cell.x[0] <= x[0] && x[1] <= cell.x[1]);
            known_roots(&of, x, cell.expect("a cell"))
        };
        let springs = || on(Foundation::winkler(1.0));
        let [pin, clamp] = [Support::pinned, Support::fixed];
        let (left, right) = ([0.0, 2.0], [2.0, 4.0]);
        assert_eq!(roots(&springs(), left), []);
        assert_eq!(roots(&springs().with_support(pin(0.0)), left), [(-1.0, 1)]);
        assert_eq!(roots(&springs().with_support(clamp(0.0)), left), [(-1.0, 2)]);
        assert_eq!(roots(&springs().with_support(pin(0.0)), right), []);
        assert_eq!(roots(&springs().with_support(pin(2.0)), left), [(1.0, 1)]);
        assert_eq!(roots(&springs().with_support(pin(2.0)), right), [(-1.0, 1)]);
        let both = springs().with_support(clamp(2.0)).with_support(pin(4.0));
        assert_eq!(roots(&both, right), [(-1.0, 2), (1.0, 1)]);
        // A root at an end of the cell is returned only if this end is also an end of the part.
        assert_eq!(roots(&both, [2.5, 4.0]), [(1.0, 1)]);
        assert_eq!(roots(&both, [2.0, 3.5]), [(-1.0, 2)]);
        assert_eq!(roots(&springs().with_support(Support::spring(0.0, 1.0, 1.0)), left), []);
        // If the settlement of a support equals the gap, the pressure is zero at the support. For other
        // settlements it is not zero.
        let settled = |down: f64| springs().with_support(pin(0.0).settled(down));
        assert_eq!(roots(&settled(0.5), left), []);
        assert_eq!(roots(&settled(0.5).with_gap(0.0, 0.5), left), [(-1.0, 1)]);
        assert_eq!(roots(&settled(0.0).with_gap(0.0, 0.5), left), []);
        // If the gap has a slope, the clamped beam and the ground form an angle at the support.
        let sloping = springs().with_support(clamp(0.0)).with_gap(0.0, 0.0).with_gap(4.0, 1.0);
        assert_eq!(roots(&sloping, left), [(-1.0, 1)]);
        let pinned = springs().with_support(pin(0.0)).with_gap(0.0, 0.0).with_gap(4.0, 0.0);
        assert_eq!(roots(&pinned, left), [(-1.0, 1)]);
        let layer = on(Foundation::pasternak(1.0, 1.0)).with_support(pin(0.0));
        assert_eq!(roots(&layer, left), []);
    }

    /// The forces under the ends are 6 w ∓ 9 w′, because √(kμ) = 6 and μ = 9. A coefficient c of sʲ in the deflection w
    /// adds |c| (6 + 9 j/a) to the size of each force, where a is half the length of the beam.
    #[test]
    fn forces_under_the_ends_and_their_sizes() {
        // The deflection is w = 3 + x. In terms of s = (x − 2)/2, it is w = 5 + 2 s.
        let of = found(&on(Foundation::pasternak(4.0, 9.0)), &[], &[3.0, 1.0]);
        let [(a, left), (b, right)] = &forces_of(&of)[..] else { panic!("two ends") };
        assert_eq!((*a, *b), (0.0, 4.0));
        near(left.coefficients[0], 6.0 * 3.0 - 9.0);
        near(right.coefficients[0], 6.0 * 7.0 + 9.0);
        for end in [left, right] {
            near(end.size, 6.0 * (5.0 + 2.0) + 4.5 * 2.0);
        }
        assert_eq!(forces_of(&found(&on(Foundation::winkler(4.0)), &[], &[1.0])).len(), 0);
    }

    /// In the first model, the slope of the initial gap jumps from 0 to 1 at x = 2, so a contact force μ acts there.
    /// The second model has no gap. Both orders of the two solutions are tested.
    #[test]
    fn forces_of_one_of_two_deflections() {
        let even = on(Foundation::pasternak(4.0, 9.0));
        let corner = even.clone().with_gap(0.0, 0.0).with_gap(2.0, 0.0).with_gap(4.0, 2.0);
        let [even, corner] = [even, corner].map(|model| found(&model, &[], &[1.0]));
        let both = |staying: &ContactState, growing: &ContactState| {
            let mut all = forces(staying, growing);
            all.sort_by(|a, b| a.x[0].total_cmp(&b.x[0]));
            let of = |side: &Side| side.coefficients[0];
            all.iter().map(|at| (at.x, of(&at.staying), of(&at.growing))).collect::<Vec<_>>()
        };
        // At the right end, the deflection minus the gap is 1 − 2 = −1 and has the slope −1, so the force is
        // √(kμ) (−1) + μ (−1).
        let [left, middle, right] = [6.0, 9.0, -6.0 - 9.0];
        let wanted = [([0.0; 2], left, 6.0), ([2.0; 2], middle, 0.0), ([4.0; 2], right, 6.0)];
        assert_eq!(both(&corner, &even), wanted);
        assert_eq!(both(&even, &corner), wanted.map(|(x, a, b)| (x, b, a)));
        assert_eq!(both(&even, &even).len(), 2);
    }
}
