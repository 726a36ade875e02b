//! Computes the equilibrium of a beam with unloaded end parts: parts beyond a free hinge, without loads and supports.
//!
//! The contact pressure on an unloaded end part is zero, so its slope is not unique. The solver takes the first trial
//! slope that the certificate confirms. See *Parts without load* in `docs/methods.md`.

use crate::cancel::Cancel;
use crate::contact::bonded::{Bonded, GivenRotation};
use crate::contact::intervals::{Interval, positions};
use crate::contact::point_contact::turned_clear;
use crate::contact::state::{ContactState, Unconverged};
use crate::existence::rigid_motions::Mechanism;
use crate::model::{Action, Model, SupportKind};
use crate::numeric::polynomial::{ends, value};

/// Trial slopes of the unloaded end parts, as multiples of the `steepness` of the rest of the beam.
const STEEPER: [f64; 6] = [1.5, 1e1, 1e3, 1e6, 1e9, 1e11];

/// Returns the interval of the beam between its unloaded end parts, or `None` if the beam has no unloaded end part.
pub(crate) fn loaded_stretch(model: &Model) -> Option<Interval> {
    let nodes = Mechanism::of(model).nodes;
    let last = nodes.len() - 1;
    if model.beam.axial_force != 0.0 || last == 1 {
        return None;
    }
    let from = (1..last).rfind(|i| is_unloaded(model, 0.0, nodes[*i])).unwrap_or(0);
    let to = (from + 1..last).find(|i| is_unloaded(model, nodes[last], nodes[*i])).unwrap_or(last);
    (to - from < last).then(|| [nodes[from], nodes[to]])
}

/// Returns whether no load, no support and, on a shear layer, no ground segment acts between an end of the beam and a
/// hinge. A force or a pinned support at the hinge is allowed.
fn is_unloaded(model: &Model, end: f64, hinge: f64) -> bool {
    let [from, to] = [end.min(hinge), end.max(hinge)];
    let reaches = |ends: [f64; 2]| ends[0] < to && from < ends[1];
    let beyond = |x: f64| x != hinge && from <= x && x <= to;
    let loaded = model.beam_loads().any(|load| match load.at_point(Action::Force) {
        Some((at, _)) => beyond(at),
        None => {
            let ends = load.extent().ends();
            reaches(ends) || ends[0] == ends[1] && (ends[0] == hinge || beyond(ends[0]))
        }
    });
    let held = model.supports.iter().any(|support| {
        beyond(support.at) || support.at == hinge && support.kind != SupportKind::Pinned
    });
    // The rest is solved as if the ground beyond the hinge had the properties at the hinge. So no ground segment may
    // lie under the end part.
    let (_, layer) = model.foundation.largest();
    let changes = layer > 0.0 && model.foundation.segments.iter().any(|s| reaches([s.from, s.to]));
    !(loaded || held || changes)
}

/// Solves the beam without its unloaded end parts by a call of `solve`. Then rotates these parts until they are
/// clear of the ground.
pub(crate) fn solve_stretch(
    model: &Model,
    [from, to]: Interval,
    cancel: &Cancel,
    solve: impl FnOnce(&Model) -> Result<ContactState, Unconverged>,
    judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let rest = solve(&model.part([from, to]))?;
    let zones = positions(&rest.mesh, &rest.zones, &[]).into_iter();
    let contact: Vec<Interval> = zones.map(|ends| ends.map(|x| x + from)).collect();
    let steep = steepness(&rest);
    let nodes = Mechanism::of(model).nodes;
    let parts = nodes.windows(2).filter(|ends| ends[1] <= from || to <= ends[0]);
    let middles: Vec<f64> = parts.map(|ends| 0.5 * (ends[0] + ends[1])).collect();
    let balanced = balanced(&rest, &contact, from);
    let turns = STEEPER.into_iter().map(|steeper| {
        let turned = |at: f64| if at < from { steeper * steep } else { -steeper * steep };
        let parts = middles.iter().map(|at| GivenRotation { at: *at, slope: turned(*at) });
        parts.chain(balanced).collect()
    });
    turned_clear(&mut Bonded::new(model, cancel), &contact, turns, rest.history, judge)
}

/// Computes the largest slope at the two ends of a beam, or the largest deflection at these ends divided by the
/// length of the beam if this quotient is larger.
fn steepness(rest: &ContactState) -> f64 {
    let w = rest.deflection();
    let last = rest.mesh.cells.len() - 1;
    let length = rest.mesh.cells[last].x[1];
    let of_end = |cell: usize, end: usize| {
        let slope = ends(&rest.rotation(cell))[end].abs();
        slope.max(ends(w.cell(cell))[end].abs() / length)
    };
    of_end(0, 0).max(of_end(last, 1)).max(f64::MIN_POSITIVE)
}

/// Returns the rotation at the middle of a beam that is balanced on one contact point. Returns `None` if the contact
/// is not a single point.
fn balanced(rest: &ContactState, contact: &[Interval], from: f64) -> Option<GivenRotation> {
    let [[left, right]] = contact else { return None };
    let middle = 0.5 * rest.mesh.cells[rest.mesh.cells.len() - 1].x[1];
    let cell = rest.mesh.cell_at(middle);
    let slope = value(&rest.rotation(cell), rest.mesh.cells[cell].local(middle));
    (left == right).then_some(GivenRotation { at: middle + from, slope })
}
