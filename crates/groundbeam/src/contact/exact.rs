//! The contact problem without a mesh: the edges of contact as unknowns.
//!
//! Between loads, supports, joints and edges of contact the deflection solves (2.11) in closed form, so
//! the only unknowns are which stretches touch and where they end. A coarse [mesh](super::active_set)
//! tells the first; then each step
//!
//! 1. puts a node at every edge and solves the glued chain with [exact elements](crate::elements::exact);
//! 2. lays the ground under the beam found, anew and exactly ([majorant](super::majorant)): its edges
//!    are where the unloaded ground leaves the beam tangentially, u' = w' − g₀' (w = g₀ for μ = 0). Zones
//!    split, merge, appear and vanish here of themselves.
//!
//! This is Newton's method on Φ in the space of all deflections: the error of the edges is squared in
//! every step. If the steps do not settle, the mesh that began them is refined.

use super::active_set::{Found, Pressure, Stalled, Step};
use super::balanced::Held;
use super::deflection::{Deflection, Zone};
use super::descent::shorten;
use super::layout::Layout;
use super::majorant;
use super::near;
use super::nested;
use super::stretches::{Stretch, distance, positions, zones_of};
use crate::chain::{Chain, ChainCell, Loose};
use crate::elements::exact::{ExactElement, TERMS, parts};
use crate::elements::{Operator, Touch};
use crate::mesh::{Cell, Mesh};
use crate::model::Model;
use crate::polynomial::{jet, rescale};

/// Cells of the first coarse mesh per wave length of the beam on its ground.
const COARSE: f64 = 1.0;
/// How often the coarse mesh is refined threefold before the model is given up.
const REFINEMENTS: u32 = 5;
/// Newton steps from one start, and for a beam that only gives the next one its start.
const MOST_STEPS: usize = 200;
const STAGE_STEPS: usize = 100;
/// The same from edges that are known to be near: if it takes more, they are not.
const NEAR_STEPS: usize = 24;
/// The most wave lengths of the beam between two nodes of the model on the first coarse mesh.
const MOST_WAVES: f64 = 32.0;
/// The last move of an edge, relative to the beam's length, of a beam that only gives the next its start.
const ROUGH: f64 = 1e-6;
/// What may be left of its energy to fall, relative to twice the strain energy.
const ROUGH_DECREMENT: f64 = 1e-12;
/// A move of the edges, relative to the beam's length, after which no step is shortened.
const LOCAL: f64 = 1e-8;
/// How much less stiff (as a power of two) one beam is than the one it starts from.
const STIFFER: f64 = 2.0;

/// Steps after which the certificate is asked whether the edges' last digits matter.
const PATIENCE: usize = 4;
/// How often that, whatever the steps do, before the certificate's answer is good enough.
const ROUNDS: usize = 12;

/// Steps in a row that did not halve the move, after which the beam is tried without its weakest zones.
const WALKING: usize = 8;
/// The weakest zone that is kept in that, relative to the strongest, and the most that the others may move,
/// relative to the beam's length.
const WEAKEST: f64 = 1e-10;
const STILL: f64 = 1e-3;

/// What the certificate must show.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Proof {
    /// The largest relative gap.
    pub gap: f64,
    /// The largest violation of balance, signs and complementarity. An edge that is off by δ leaves pδ
    /// unbalanced.
    pub violation: f64,
}

/// What a row of Newton steps is for.
#[derive(Debug, Clone, Copy)]
enum Goal {
    /// The answer, in so many steps at most.
    Answer(usize),
    /// A start for the next, softer beam.
    Start,
}

/// What ends the iteration early, and what is accepted in the end.
const PROVEN: Proof = Proof { gap: 1e-22, violation: 1e-13 };
pub(super) const ENOUGH: Proof = Proof { gap: 1e-11, violation: 3e-8 };
/// What is accepted where rounding moves the edges for ever, after so many steps.
const LAST: Proof = Proof { gap: 5e-10, violation: 5e-8 };
const LAST_STEPS: usize = 100;

/// Solves a model. `proven` tells whether a deflection with its contact passes the certificate to a tolerance: where an
/// edge cannot be told from its neighbours (a zone without pressure, a beam balanced on one point), that
/// and not the edge's last digit ends the iteration.
pub(crate) fn solve(
    model: &Model,
    proven: impl Fn(&Found, Proof) -> bool,
) -> Result<Found, Stalled> {
    if let Some(stretches) = near::edges(model)
        && let Ok(found) = from_edges(model, &stretches, &proven)
    {
        return Ok(found);
    }
    let mut last = Stalled::default();
    let mut iterations = 0;
    for level in 0..=REFINEMENTS {
        let start = coarse(model, level);
        let found = start.and_then(|start| refine(model, start, Goal::Answer(MOST_STEPS), &proven));
        match found {
            Ok(found) => return Ok(found),
            Err(stalled) => {
                iterations += stalled.iterations;
                last = stalled;
            }
        }
    }
    Err(Stalled { iterations, ..last })
}

/// From the beam glued to the ground on given stretches. Where it asks for just these, it is the answer.
fn from_edges(
    model: &Model,
    stretches: &[Stretch],
    proven: &impl Fn(&Found, Proof) -> bool,
) -> Result<Found, Stalled> {
    let (found, zones) = glued(model, stretches, None).map_err(|Loose| unsettled(0, f64::NAN))?;
    if positions(&found.mesh, &zones, &[]) == stretches {
        let history = vec![Step { zones: stretches.len(), step: 1.0, decrement: 0.0 }];
        return Ok(Found { history, ..found });
    }
    refine(model, Found { zones, ..found }, Goal::Answer(NEAR_STEPS), proven)
}

/// A deflection to start from: on a coarse mesh, for a beam so stiff that the mesh sees its waves, and
/// from there to the beam itself by beams ever less stiff.
fn coarse(model: &Model, level: u32) -> Result<Found, Stalled> {
    let axial = model.beam.axial_force;
    let waves = |cell: &Cell| {
        Operator::of(cell, axial, Touch::Contact).wave_number() * cell.length() / MOST_WAVES
    };
    let cells = Mesh::build(model, &[], |_| 1).cells;
    // |r| falls at least like EI^(−1/4).
    let most = cells.iter().map(waves).fold(1.0, f64::max);
    let times = most.powi(4).log2();
    // Where that fails, a fine mesh may not.
    let stages =
        if level % 2 == 1 { 0 } else { (times * f64::from(level + 1) / STIFFER).ceil() as u32 };
    let stiffer = |stage: u32| {
        let mut model = model.clone();
        let factor = (times * f64::from(stage) / f64::from(stages.max(1))).exp2();
        model.beam = model.beam.stiffened(factor);
        model
    };
    let per_wave = COARSE * 3_f64.powi(level as i32);
    let stiffest = stiffer(stages);
    let meshes = nested::coarse_meshes(&stiffest, per_wave);
    let mut found = nested::solve(meshes, Pressure::Distributed)?;
    for stage in (1..=stages).rev() {
        found = refine(&stiffer(stage), found, Goal::Start, &|_, _| false)?;
    }
    Ok(found)
}

/// Newton's steps on the edges, from the deflection of a coarser problem.
fn refine(
    model: &Model,
    mut start: Found,
    goal: Goal,
    proven: &impl Fn(&Found, Proof) -> bool,
) -> Result<Found, Stalled> {
    let (rough, most_steps) = match goal {
        Goal::Answer(most_steps) => (false, most_steps),
        Goal::Start => (true, STAGE_STEPS),
    };
    let places: Vec<f64> = Mesh::build(model, &[], |_| 1).nodes.iter().map(|n| n.x).collect();
    let mut stretches = positions(&start.mesh, &start.zones, &places);
    let mut history = std::mem::take(&mut start.history);
    let l = model.beam.length;
    let mut moved = f64::INFINITY;
    // Steps in a row that did not halve the move, and whether all have so far.
    let mut idle = 0;
    let mut shrinks = true;
    // The deflection that asked for the stretches, and the last that equilibrium made.
    let mut now = start;
    let mut last: Option<Found> = None;
    for step in 0..most_steps {
        let Ok((found, zones)) = glued(model, &stretches, None) else {
            // A beam balanced on one point may turn about it, as far as no other point touches.
            let held = glued(model, &stretches, Some(Held::as_in(&now))).map(|(found, _)| found);
            let proven = |found: &Found| proven(found, LAST);
            return match held.ok().filter(proven).or(last.filter(proven)) {
                Some(found) => Ok(Found { history, ..found }),
                None if rough => Ok(Found { history, ..now }),
                None => Err(unsettled(step, moved)),
            };
        };
        let next = positions(&found.mesh, &zones, &places);
        let before = moved;
        moved = distance(&stretches, &next) / l;
        history.push(Step { zones: next.len(), step: 1.0, decrement: moved });
        // Quadratic convergence ends at rounding: no further step would make it smaller.
        let settled = moved <= 1e-15 || (moved <= 1e-12 && moved >= 0.25 * before);
        if rough && moved <= ROUGH {
            return Ok(Found { history, zones, ..found });
        }
        let halved = moved <= 0.5 * before && moved.is_finite();
        idle = if halved { 0 } else { idle + 1 };
        let proof = match step {
            _ if step > LAST_STEPS => LAST,
            _ if idle > PATIENCE || step > ROUNDS * PATIENCE => ENOUGH,
            _ => PROVEN,
        };
        if settled || (step >= PATIENCE && proven(&found, proof)) {
            return Ok(Found { history, ..found });
        }
        if most_steps > NEAR_STEPS
            && idle > 0
            && idle.is_multiple_of(WALKING)
            && let Some(start) = without_the_weakest(model, &found, &next)
            && let Ok(found) = refine(model, start, Goal::Answer(NEAR_STEPS), proven)
        {
            return Ok(Found { history, ..found });
        }
        // Steps that shrink end by themselves. Once one has not, the energy decides how far each goes.
        shrinks &= halved && (before.is_finite() || step < 2);
        let mut between = None;
        if !shrinks && moved > LOCAL {
            let shortened = shorten(model, &now, &found);
            if rough && shortened.decrement <= ROUGH_DECREMENT {
                return Ok(Found { history, zones, ..found });
            }
            if let Some(step) = history.last_mut() {
                step.step = shortened.part;
            }
            between = shortened.between;
        }
        (now, stretches) = match between {
            Some(between) => {
                moved = f64::INFINITY;
                let stretches = positions(&between.mesh, &between.zones, &places);
                (between, stretches)
            }
            None => (found.clone(), next),
        };
        last = Some(found);
    }
    match last.filter(|found| proven(found, ENOUGH)) {
        Some(found) => Ok(Found { history, ..found }),
        None if rough => Ok(Found { history, ..now }),
        None => Err(unsettled(most_steps, moved)),
    }
}

/// The beam glued to the ground where it presses most, if it asks for just that.
///
/// A step moves an end of contact by a wave length at most. Beyond the last load of a beam hundreds of waves
/// long, zones each a thousand times weaker than the one before walk to the end of the beam that way, where
/// in truth all of it lifts.
fn without_the_weakest(model: &Model, found: &Found, stretches: &[Stretch]) -> Option<Found> {
    let weight = |[a, b]: &Stretch| {
        let x = 0.5 * (a + b);
        let cell = found.mesh.cell_at(x);
        let [w, ..] = jet(found.deflection().cell(cell), found.mesh.cells[cell].local(x));
        w.abs() * (b - a)
    };
    let weights: Vec<f64> = stretches.iter().map(weight).collect();
    let mut ranked = weights.clone();
    ranked.sort_by(|a, b| b.total_cmp(a));
    let worth_keeping = |w: &&f64| **w > WEAKEST * ranked[0];
    let most = ranked.iter().take_while(worth_keeping).count().min(stretches.len() - 1);
    (1..=most).rev().find_map(|count| {
        let strong = stretches.iter().zip(&weights).filter(|(_, w)| **w >= ranked[count - 1]);
        let strong: Vec<Stretch> = strong.map(|(stretch, _)| *stretch).collect();
        let (found, zones) = glued(model, &strong, None).ok()?;
        let moved = distance(&strong, &positions(&found.mesh, &zones, &[]));
        (moved <= STILL * model.beam.length).then_some(Found { zones, ..found })
    })
}

pub(super) fn unsettled(iterations: usize, reached: f64) -> Stalled {
    let what = "the last move of an edge of contact, relative to the beam's length,";
    Stalled { iterations, what, tolerance: 1e-12, reached }
}

/// The beam glued to the ground on given stretches, solved exactly, and the contact it asks for.
pub(crate) fn glued(
    model: &Model,
    stretches: &[Stretch],
    held: Option<Held>,
) -> Result<(Found, Vec<Zone>), Loose> {
    let axial = model.beam.axial_force;
    let edges: Vec<f64> = stretches.iter().flatten().copied().collect();
    let touches = |x: f64| {
        let next = stretches.partition_point(|s| s[1] <= x);
        stretches.get(next).is_some_and(|s| s[0] < x)
    };
    let touch = |cell: &Cell| {
        if touches(0.5 * (cell.x[0] + cell.x[1])) { Touch::Contact } else { Touch::Open }
    };
    let mesh = Mesh::graded(model, &edges, |cell| {
        parts(&Operator::of(cell, axial, touch(cell)), cell.length())
    });
    let assumed = zones_of(&mesh, stretches, &touch);
    let layout = Layout::of(&mesh, &assumed);
    let elements: Vec<ExactElement> = mesh
        .cells
        .iter()
        .map(|cell| ExactElement::new(&Operator::of(cell, axial, touch(cell)), cell.length()))
        .collect();
    let cells: Vec<ChainCell> = elements
        .iter()
        .enumerate()
        .map(|(i, exact)| {
            // Only ends are tied.
            layout.chain_cell(&mesh, i, exact.element, |s| exact.element.end_row(s > 0.0))
        })
        .collect();
    let mut nodes = layout.nodes(&mesh);
    if let Some(held) = held {
        let node = if held.left { 0 } else { nodes.len() - 1 };
        let spring = model.beam.bending_stiffness / model.beam.length;
        nodes[node].rotational_spring += spring;
        nodes[node].moment += spring * held.slope;
    }
    let shapes = Chain { nodes, cells, meeting: layout.meeting_node(&mesh) }.solve()?;
    let (fine, coefficients) = unfolded(model, &mesh, &elements, &shapes);
    if !coefficients.iter().all(|c| c.is_finite()) {
        return Err(Loose);
    }
    let w = Deflection { mesh: &fine, terms: TERMS, coefficients: &coefficients };
    let wanted = majorant::contact(&w);
    let zones = zones_of(&fine, stretches, &touch);
    let found = Found {
        mesh: fine,
        terms: TERMS,
        shapes: Vec::new(),
        coefficients,
        zones,
        history: Vec::new(),
        pressure: Pressure::Distributed,
        surface: None,
    };
    Ok((found, wanted))
}

/// w as short series: each element's own, and where it has boundary layers cut into pieces.
fn unfolded(
    model: &Model,
    mesh: &Mesh,
    elements: &[ExactElement],
    shapes: &[[f64; 4]],
) -> (Mesh, Vec<f64>) {
    let parts = elements.iter().zip(shapes).map(|(element, v)| element.unfold(v));
    let parts: Vec<([f64; TERMS], [f64; 2])> = parts.collect();
    let mut x = Vec::new();
    for ((element, cell), (_, heights)) in elements.iter().zip(&mesh.cells).zip(&parts) {
        x.push(cell.x[1]);
        if let Some(layers) = &element.layers {
            x.extend(layers.cuts(cell.x, *heights));
        }
    }
    if x.len() == mesh.cells.len() {
        return (mesh.clone(), parts.into_iter().flat_map(|(series, _)| series).collect());
    }
    let fine = Mesh::build(model, &x, |_| 1);
    let mut coefficients = Vec::with_capacity(fine.cells.len() * TERMS);
    let mut i = 0;
    for piece in &fine.cells {
        let middle = 0.5 * (piece.x[0] + piece.x[1]);
        while mesh.cells[i].x[1] < middle {
            i += 1;
        }
        let cell = &mesh.cells[i];
        let (series, heights) = &parts[i];
        let mut c = if piece.x == cell.x {
            series.to_vec()
        } else {
            let [a, b] = piece.x.map(|x| cell.local(x));
            rescale(series, 0.5 * (a + b), piece.length() / cell.length())
        };
        if let Some(layers) = &elements[i].layers {
            layers.add(cell.x, *heights, piece.x, &mut c);
        }
        coefficients.extend(c);
    }
    (fine, coefficients)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};

    /// Kikuchi's case IV: the edge from 60-digit arithmetic, and how fast it is reached.
    #[test]
    fn edges_converge_quadratically() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point(1.0, 0.5))
            .with_load(Load::moment(0.49, 0.5));
        let mut stretches = vec![[0.8, 1.0]];
        let mut errors = Vec::new();
        for _ in 0..4 {
            let (found, zones) = glued(&model, &stretches, None).expect("a solution");
            stretches = positions(&found.mesh, &zones, &[]);
            errors.push((stretches[0][0] - 0.811_326_256_449_155).abs());
        }
        assert!(errors[3] < 2e-15, "{errors:?}");
        assert!(errors[1] < errors[0] * errors[0] * 10.0, "{errors:?}");
    }

    /// A gap of length h takes −π h off the ground's force and changes w by O(h), however short it is and
    /// wherever a node stands in it: 10⁻¹³ of w is left for rounding.
    #[test]
    fn a_short_gap_keeps_the_digits_beside_it() {
        let model = Model::new(Beam::uniform(1.0, 10.0), Foundation::pasternak(1.0, 3.4))
            .with_load(Load::point(1.0, 0.5))
            .with_load(Load::moment(0.1, 0.5));
        let solved = |stretches: &[Stretch], node: f64| {
            let model = model.clone().with_load(Load::point(f64::MIN_POSITIVE, node));
            let (found, _) = glued(&model, stretches, None).expect("a solution");
            let cell = found.mesh.cells.iter().position(|c| c.x[1] == 0.3).expect("a node");
            let [w, _, bend, _] = jet(found.deflection().cell(cell), 1.0);
            [w, bend / (0.5 * found.mesh.cells[cell].length()).powi(2)]
        };
        let bonded = solved(&[[0.0, 0.3], [0.3, 1.0]], 0.3);
        for h in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11] {
            let stretches = [[0.0, 0.3], [0.3 + h, 1.0]];
            for node in [0.0, 0.3 + 0.4 * h] {
                let here = solved(&stretches, node);
                for (a, b) in here.iter().zip(bonded) {
                    assert!((a - b).abs() <= h * h + 1e-13, "{h}: {here:?} {bonded:?}");
                }
            }
        }
    }
}
