//! Follows the path of equilibria under increasing compression, from the equilibrium without compression.
//!
//! A [bonded solve](crate::contact::bonded) is a Newton step for the minimum of the energy. Its pivots show whether the
//! second variation is positive. The path of stable equilibria ends at a limit point, at a bifurcation, or where the beam
//! loses its shear stiffness. See *Compression* in `docs/existence.md`.

use crate::cancel::Cancel;
use crate::chain::node::NotDefinite;
use crate::contact::bonded::Bonded;
use crate::contact::continuation::secant;
use crate::contact::intervals::{Interval, joined, longest_difference, positions};
use crate::contact::obstacle;
use crate::contact::state::ContactState;
use crate::element::element::MOST_COMPRESSION;
use crate::equilibrium::buckling::{BELOW_FOLDING, folding_compression};
use crate::equilibrium::one_way;
use crate::mesh::mesh::required_positions;
use crate::model::Model;
use crate::model::compressed;
use crate::solution::candidate::{Candidate, Workspace};
use std::borrow::Cow;

/// First step in compression, as a fraction of the required compression.
const FIRST: f64 = 0.25;
/// Smallest step in compression, relative to the larger of the required compression and the compression reached so far.
/// The end of the path is located with this accuracy.
const LAST: f64 = 1e-10;
/// Maximum number of Newton steps at one value of the compression, with one set of active supports.
const NEWTON_STEPS: usize = 10;
/// Maximum number of changes of the set of active supports at one value of the compression.
const SUPPORT_CHANGES: usize = 10;
/// A move of the contact edges in a Newton step below this fraction of the beam's length is rounding error.
const STILL: f64 = 1e-13;
/// A move of the contact edges below this fraction of the length is accepted if it is at least a quarter of the
/// previous one.
const ACCEPTED_MOVE: f64 = 1e-9;
/// Two equilibria are the same if their contact edges differ by at most this fraction of the beam's length.
const RETURNED: f64 = 1e-7;
/// Two equilibria are neighbours on the path if their contact edges differ by at most this fraction of the length.
const NEXT: f64 = 1e-3;

/// A stable equilibrium on the path of equilibria under increasing compression.
#[derive(Debug, Clone)]
pub(crate) struct PathPoint {
    /// The compression −P \[N\].
    pub compression: f64,
    pub contact: Vec<Interval>,
    /// Whether each support is active. Two-way supports are always active.
    pub active: Vec<bool>,
}

impl PathPoint {
    /// The model with the active supports only.
    pub fn on_active_supports<'a>(&self, model: &'a Model) -> Cow<'a, Model> {
        if !model.has_one_way_supports() {
            return Cow::Borrowed(model);
        }
        Cow::Owned(model.with_supports_that(|i, _| self.active[i]))
    }
}

/// The result of following the path of equilibria.
#[derive(Debug, Clone)]
pub(crate) struct EquilibriumPath {
    /// The equilibrium under the model's own compression, if the path reaches it.
    pub wanted: Option<PathPoint>,
    /// The last stable equilibrium on the path. Its compression is infinite if the path does not end.
    pub last: PathPoint,
    /// The reason why the path ends.
    pub end: PathEnd,
}

/// The reason why even the smallest step in compression fails.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum PathEnd {
    /// The second variation of the energy is not positive. The list states for each support whether it was active.
    NotStable(Vec<bool>),
    /// Newton's method does not converge, because the step passes a limit point or because the contact zones
    /// alternate.
    NotConverged,
}

/// Follows the path from the equilibrium without compression through the required compression to the end of the
/// path.
pub(crate) fn follow(model: &Model, begin: PathPoint, cancel: &Cancel) -> EquilibriumPath {
    let wanted = -model.beam.axial_force;
    let l = model.beam.length;
    let most = MOST_COMPRESSION * model.beam.stiffest() / (l * l);
    let places = required_positions(model, &[]);
    let mut found = None;
    let mut last = PathPoint { contact: joined(begin.contact, l), ..begin };
    // The last two equilibria before `last`, the older one first.
    let mut before: [Option<PathPoint>; 2] = [None, None];
    let mut step = FIRST * wanted;
    let mut failed = false;
    let mut folding = folding_compression(model, &last.contact);
    let mut end = PathEnd::NotStable(last.active.clone());
    while step > LAST * if found.is_none() { wanted } else { last.compression }
        && !cancel.is_cancelled()
    {
        let nearly_folding = (1.0 - BELOW_FOLDING) * folding;
        let ends_by_folding = found.is_some() || wanted >= folding;
        if ends_by_folding && last.compression >= nearly_folding {
            last.compression = folding;
            end = PathEnd::NotStable(last.active.clone());
            break;
        }
        let mut target = last.compression + step;
        if found.is_none() {
            target = target.min(wanted);
        }
        if ends_by_folding {
            target = target.min(nearly_folding);
        }
        if target > most {
            let last = PathPoint { compression: f64::INFINITY, ..last };
            return EquilibriumPath { wanted: found, last, end };
        }
        let start = predicted(&before, &last, target, l);
        match next(model, &places, &last, &start, target, cancel) {
            Ok(state) => {
                if target == wanted {
                    found = Some(state.clone());
                }
                let [_, newer] = before;
                before = [newer, Some(std::mem::replace(&mut last, state))];
                folding = folding_compression(model, &last.contact);
                if !failed {
                    step *= 2.0;
                }
                failed = false;
            }
            Err(why) => {
                end = why;
                step = 0.5 * (target - last.compression);
                failed = true;
            }
        }
    }
    EquilibriumPath { wanted: found, last, end }
}

/// Returns the initial guess at the next compression, with edges extrapolated from the last three or two equilibria.
/// `before` contains the two equilibria before `last`.
fn predicted(
    before: &[Option<PathPoint>; 2],
    last: &PathPoint,
    compression: f64,
    l: f64,
) -> PathPoint {
    let alike = |before: &&PathPoint| before.active == last.active;
    let [older, newer] = before.each_ref().map(|point| point.as_ref().filter(alike));
    let on_parabola = || parabola([older?, newer?, last], compression, l);
    let on_secant = || {
        let newer = newer?;
        let part = (compression - last.compression) / (last.compression - newer.compression);
        secant(&newer.contact, &last.contact, part, l)
    };
    let edges = on_parabola().or_else(on_secant).unwrap_or_else(|| last.contact.clone());
    PathPoint { contact: edges, ..last.clone() }
}

/// Extrapolates the contact edges to `compression`, as quadratic functions of the position of the edge that moved most.
/// Near a limit point, the compression is such a function too. Returns `None` if no valid zones result.
fn parabola(points: [&PathPoint; 3], compression: f64, l: f64) -> Option<Vec<Interval>> {
    let [older, newer, last] = points.map(|point| point.contact.as_flattened());
    if older.len() != last.len() || newer.len() != last.len() {
        return None;
    }
    let moved = |i: &usize| (last[*i] - newer[*i]).abs();
    let most = (0..last.len()).max_by(|a, b| moved(a).total_cmp(&moved(b)))?;
    let parameter = [older, newer].map(|edges| edges[most] - last[most]);
    // Returns [b, c] of the parabola b d + c d² that has the two values `differences` at the two values
    // d = `parameter`.
    let coefficients = |differences: [f64; 2]| {
        let [first, second] = [0, 1].map(|i| differences[i] / parameter[i]);
        let square = (first - second) / (parameter[0] - parameter[1]);
        [second - square * parameter[1], square]
    };
    let step = |i: usize| points[i].compression - points[2].compression;
    let [linear, square] = coefficients([step(0), step(1)]);
    let is_monotone = parameter[0] / parameter[1] > 1.0 && linear * parameter[1] < 0.0;
    if !is_monotone {
        return None;
    }
    let wanted = compression - points[2].compression;
    let root = (linear * linear + 4.0 * square * wanted).sqrt();
    let at = 2.0 * wanted / (linear + root.copysign(linear));
    let edge = |i: usize| {
        let [linear, square] = coefficients([older[i] - last[i], newer[i] - last[i]]);
        (last[i] + at * (linear + at * square)).clamp(0.0, l)
    };
    let edges: Vec<f64> = (0..last.len()).map(edge).collect();
    let is_valid = edges.iter().all(|edge| edge.is_finite()) && edges.is_sorted();
    is_valid.then(|| edges.chunks(2).map(|ends| [ends[0], ends[1]]).collect())
}

/// Returns the next equilibrium on the path. To exclude another path, Newton's method must lead from it back to `last`,
/// unless both are neighbours by [`NEXT`] or `last` has no compression.
fn next(
    model: &Model,
    places: &[f64],
    last: &PathPoint,
    start: &PathPoint,
    compression: f64,
    cancel: &Cancel,
) -> Result<PathPoint, PathEnd> {
    let l = model.beam.length;
    let next = settled(model, places, compression, start, cancel)?;
    let near = longest_difference(&next.contact, &last.contact) <= NEXT * l;
    if last.compression == 0.0 || (near && next.active == last.active) {
        return Ok(next);
    }
    let back = settled(model, places, last.compression, &next, cancel)?;
    let same = longest_difference(&back.contact, &last.contact) <= RETURNED * l
        && back.active == last.active;
    if same { Ok(next) } else { Err(PathEnd::NotConverged) }
}

/// Computes the equilibrium by Newton steps from the contact zones of `near`. Returns an error if a second variation is
/// not positive or the steps do not converge.
fn settled(
    model: &Model,
    places: &[f64],
    compression: f64,
    near: &PathPoint,
    cancel: &Cancel,
) -> Result<PathPoint, PathEnd> {
    let model = compressed(model, compression);
    let mut contact = near.contact.clone();
    let mut acts = near.active.clone();
    let mut held = near.on_active_supports(&model);
    'supports: for _ in 0..=SUPPORT_CHANGES {
        let mut bonded = Bonded::new(&held, cancel);
        let mut before = f64::INFINITY;
        for _ in 0..NEWTON_STEPS {
            let found = bonded
                .solve_on(&contact)
                .map_err(|NotDefinite| PathEnd::NotStable(acts.clone()))?;
            let zones = obstacle::contact(&found.deflection());
            let next = joined(positions(&found.mesh, &zones, places), model.beam.length);
            let moved = longest_difference(&contact, &next) / model.beam.length;
            contact = next;
            if moved <= STILL || (moved <= ACCEPTED_MOVE && moved >= 0.25 * before) {
                let state = PathPoint { compression, contact, active: acts };
                let Some(asked) = other_supports(&model, &held, &state, &found) else {
                    return Ok(state);
                };
                held = asked.on_active_supports(&model);
                (contact, acts) = (asked.contact, asked.active);
                continue 'supports;
            }
            before = moved;
        }
        break;
    }
    Err(PathEnd::NotConverged)
}

/// Returns `state` with its active supports updated from the support forces and clearances of the solution `found`.
/// Returns `None` if no support changes.
fn other_supports(
    model: &Model,
    held: &Model,
    state: &PathPoint,
    found: &ContactState,
) -> Option<PathPoint> {
    if !model.has_one_way_supports() {
        return None;
    }
    let candidate = Candidate::of(held, found, &mut Workspace::default());
    let acts = one_way::asked_for(model, &state.active, &candidate);
    (acts != state.active).then(|| PathPoint { active: acts, ..state.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The equilibrium path has a limit point where the compression is 1. Near this point, the positions of the contact
    /// edges are linear functions of √(1 − compression).
    #[test]
    fn edges_are_extrapolated_exactly_near_a_limit_point() {
        let contact = |compression: f64| {
            let root = (1.0 - compression).sqrt();
            vec![[0.1 + 0.01 * root, 0.5 - 0.1 * root], [0.7, 0.9 + 0.05 * root]]
        };
        let point = |compression: f64| PathPoint {
            compression,
            contact: contact(compression),
            active: Vec::new(),
        };
        let points = [0.7, 0.8, 0.9].map(point);
        let found = parabola(points.each_ref(), 0.99, 1.0).expect("edges");
        for (found, exact) in found.as_flattened().iter().zip(contact(0.99).as_flattened()) {
            assert!((found - exact).abs() < 1e-14, "{found} {exact}");
        }
        assert_eq!(parabola(points.each_ref(), 1.01, 1.0), None);
        let one_zone = PathPoint { contact: vec![[0.1, 0.9]], ..points[1].clone() };
        assert_eq!(parabola([&points[0], &one_zone, &points[2]], 0.99, 1.0), None);
    }
}
