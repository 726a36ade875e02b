//! Computes the reactions of the supports from the deflection at elastic supports, and from the equilibrium at rigid supports.
//!
//! The equilibrium is that of a part of the beam around the support. It has cuts on both sides of the support. Beside a
//! rigid support, the deformation of the first element is a small difference of deflections. So the cuts are a few
//! elements away from the support, if the span is long enough.

use super::beam::Beam;
use super::grid::Grid;
use super::newton::Workspace;
use crate::element::element::Element;
use crate::model::support::Reaction;
use crate::model::{Model, Support};
use crate::numeric::sum::Rounded;

/// Largest distance from a support to a cut, times the wave number. Over longer distances, the sum of the ground forces
/// loses digits.
const REACH: f64 = 3.0;

/// Returns the reactions of the supports, in the order of the model, from the solution in the workspace.
pub(crate) fn reactions(model: &Model, grid: &Grid, workspace: &Workspace) -> Vec<Reaction> {
    if model.supports.is_empty() {
        return Vec::new();
    }
    let places: Vec<[Option<usize>; 2]> = cut_nodes(model, grid);
    let cuts = cuts(grid, workspace, places.as_flattened());
    let reaction = |(support, places): (&Support, &[Option<usize>; 2])| {
        let ends = places.map(|place| cuts.iter().find(|cut| Some(cut.place) == place));
        let needed = Needed::of(grid, workspace, support.at, ends);
        support.reaction(|| needed.motion, || needed.force, || needed.moment)
    };
    model.supports.iter().zip(&places).map(reaction).collect()
}

/// Returns the nodes near which the beam is cut to the left and to the right of each support. `None` stands for the end
/// of the beam, if the support is there.
fn cut_nodes(model: &Model, grid: &Grid) -> Vec<[Option<usize>; 2]> {
    let last = grid.last();
    let mut held: Vec<usize> = model.supports.iter().map(|s| grid.nearest(s.at)).collect();
    held.sort_unstable();
    let reach = REACH / grid.wave_number();
    let near = |x: f64, other: usize| {
        let distance = (0.5 * (grid.x(other) - x)).clamp(-reach, reach);
        grid.nearest(x + distance)
    };
    let places = |support: &Support| {
        let node = grid.nearest(support.at);
        let before = held.partition_point(|other| *other < node).checked_sub(1);
        let before = before.map_or(0, |i| held[i]);
        let after = held.get(held.partition_point(|other| *other <= node));
        let after = after.copied().unwrap_or(last);
        let left = (before < node).then(|| near(support.at, before).clamp(before, node - 1));
        let right = (node < after)
            .then(|| near(support.at, after).clamp((node + 1).min(after - 1), after - 1));
        [left, right]
    };
    model.supports.iter().map(places).collect()
}

/// A cut through the beam just right of a node.
#[derive(Debug, Clone, Copy)]
struct Cut {
    /// The node for which this cut is made. It lies in the element that begins at `node`.
    place: usize,
    node: usize,
    /// Force of the beam left of the cut on the beam right of it, positive downwards.
    force: f64,
    /// Moment of the beam left of the cut on the beam right of it, positive clockwise.
    moment: f64,
}

/// Cuts the beam at the left ends of the elements that contain the nodes `places`.
fn cuts(grid: &Grid, workspace: &Workspace, places: &[Option<usize>]) -> Vec<Cut> {
    let mut places: Vec<usize> = places.iter().copied().flatten().collect();
    places.sort_unstable();
    places.dedup();
    let layout = &workspace.layout;
    let mut cuts = Vec::with_capacity(places.len());
    // The force and the moment are derivatives of the energy ½ vᵀKv − qᵀv of an element with the unknowns v.
    let mut visit = |[from, to]: [usize; 2], v: [f64; 4]| {
        let next = places.partition_point(|place| *place < from);
        for place in places[next..].iter().copied().take_while(|place| *place < to) {
            let dot = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let element = element(grid, [from, to], grid.axial_force);
            let gradient: [f64; 4] =
                std::array::from_fn(|i| dot(element.stiffness[i], v) - element.load[i]);
            let [force, moment] =
                [false, true].map(|rotates| dot(element.moved_end(false, rotates), gradient));
            cuts.push(Cut { place, node: from, force, moment });
        }
    };
    layout.each_element(grid, |left, v| visit([left, left + 1], v));
    for placed in layout.spans() {
        let shape = &layout.sides[placed.side].shapes[placed.stretch];
        placed.span.unfold(shape, |piece, own| {
            let v = if placed.span.mirrored { piece.mirrored(own) } else { own };
            visit(piece.nodes, v);
        });
    }
    cuts
}

/// Force and moment that a support must exert on the beam, and the motion of the beam.
struct Needed {
    /// Force, positive upwards. Its size is the sum of the magnitudes of the forces in equilibrium with it.
    force: Rounded,
    /// Moment, positive clockwise. Its size is the sum of the magnitudes of the moments in equilibrium with it.
    moment: Rounded,
    /// Deflection and rotation at the support. Their sizes are the largest magnitudes between the cuts.
    motion: [Rounded; 2],
}

impl Needed {
    /// Computes what a support at `x` must exert on the beam between two cuts. `None` stands for the end of the beam.
    fn of(grid: &Grid, workspace: &Workspace, x: f64, [left, right]: [Option<&Cut>; 2]) -> Self {
        let Workspace { deflection, slope, force: ground, .. } = workspace;
        let from = left.map_or(0, |cut| cut.node);
        let to = right.map_or(grid.last(), |cut| cut.node);
        let is_inside = |node: usize| (from < node || left.is_none()) && node <= to;
        let node = grid.nearest(x);
        let motion = [deflection, slope].map(|values| Rounded {
            value: values[node],
            size: values[from..=to].iter().fold(0.0, |most: f64, value| most.max(value.abs())),
        });
        let [mut force, mut moment] = [Rounded::default(); 2];
        // Adds a force at a position, positive downwards, and a moment, positive clockwise.
        let mut add = |f: f64, at: f64, m: f64| {
            let lever = f * (at - x);
            force.add(f);
            moment.value -= lever + m;
            moment.size += lever.abs() + m.abs();
        };
        for (i, a, b) in grid.parts(from, to) {
            let run = &grid.runs[i];
            let [f, m, ..] = element(grid, [a, b], 0.0).load;
            add(f, run.x(a), m);
            for node in (a..b).filter(|node| is_inside(*node)) {
                add(-ground[node], run.x(node), 0.0);
            }
            if a == run.first && is_inside(a) {
                let place = &grid.nodes[i];
                add(place.force, place.x, place.moment);
            }
        }
        add(-ground[to], grid.x(to), 0.0);
        if let Some(place) = grid.place(to) {
            add(place.force, place.x, place.moment);
        }
        for (cut, sign) in [(left, 1.0), (right, -1.0)] {
            if let Some(cut) = cut {
                add(sign * cut.force, grid.x(cut.node), sign * cut.moment);
            }
        }
        add(0.0, x, grid.axial_force * (deflection[from] - deflection[to]));
        Needed { force, moment, motion }
    }
}

/// Returns the element of the beam without ground between two nodes of a row, under an axial force.
fn element(grid: &Grid, [from, to]: [usize; 2], axial_force: f64) -> Element {
    let run = &grid.runs[grid.run_at(from)];
    run.element.unwrap_or_else(|| {
        let length = run.h * (to - from) as f64;
        Beam::new(run.cell.stiffness, &run.part(from, to), axial_force, length).element()
    })
}
