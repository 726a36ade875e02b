//! Computes the reactions of the supports from the equilibrium of the beam between the middles of the adjacent spans.
//!
//! Beside a rigid support, the deformation of the first element is a small difference of deflections. So the forces of
//! the beam are taken from elements in the middles of the spans.

use super::beam::Beam;
use super::grid::Grid;
use super::newton::Workspace;
use crate::element::element::Element;
use crate::model::support::Reaction;
use crate::model::{Model, Support, SupportKind};

/// Returns the reactions of the supports, in the order of the model, from the solution in the workspace. Sets the slope
/// at each hinge to the slope on its right side.
pub(crate) fn reactions(model: &Model, grid: &Grid, workspace: &mut Workspace) -> Vec<Reaction> {
    if model.supports.is_empty() && model.hinges.is_empty() {
        return Vec::new();
    }
    let Workspace { layout, deflection, slope, force, .. } = workspace;
    let nodes = |positions: &mut dyn Iterator<Item = f64>| {
        let mut nodes: Vec<usize> = positions.map(|x| grid.nearest(x)).collect();
        nodes.sort_unstable();
        nodes
    };
    let held = nodes(&mut model.supports.iter().map(|support| support.at));
    let hinges = nodes(&mut model.hinges.iter().map(|hinge| hinge.at));
    let middles: Vec<usize> = held.windows(2).map(|s| s[0] + (s[1] - s[0]) / 2).collect();
    let mut cuts = vec![Cut::default(); middles.len()];
    // Each part of the beam has the unknowns `v` of its element.
    let mut visit = |[from, to]: [usize; 2], v: [f64; 4]| {
        if hinges.binary_search(&from).is_ok() {
            slope[from] = v[1];
        }
        let next = middles.partition_point(|middle| *middle < from);
        for (cut, _) in cuts[next..].iter_mut().zip(&middles[next..]).take_while(|m| *m.1 < to) {
            *cut = Cut::at_start(&element(grid, [from, to], grid.axial_force), v, from);
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
    let reaction = |support: &Support| {
        let node = grid.nearest(support.at);
        let order = held.partition_point(|other| *other < node);
        let left = order.checked_sub(1).map(|span| cuts[span]);
        let rigid = || needed(grid, force, deflection, support.at, left, cuts.get(order).copied());
        let (force, moment) = match support.kind {
            SupportKind::Pinned => (rigid()[0], 0.0),
            SupportKind::Fixed => rigid().into(),
            SupportKind::Spring { spring, rotational_spring } => {
                let compression = deflection[node] - support.settlement;
                (spring * compression, -rotational_spring * slope[node])
            }
        };
        Reaction { at: support.at, force, moment }
    };
    model.supports.iter().map(reaction).collect()
}

/// A cut through the beam just right of a node.
#[derive(Debug, Clone, Copy, Default)]
struct Cut {
    node: usize,
    /// Force of the beam left of the cut on the beam right of it, positive downwards.
    force: f64,
    /// Moment of the beam left of the cut on the beam right of it, positive clockwise.
    moment: f64,
}

impl Cut {
    /// Returns the cut at the left end of an element with the unknowns `v`. The force and the moment are derivatives of
    /// the energy ½ vᵀKv − qᵀv of the element.
    fn at_start(element: &Element, v: [f64; 4], node: usize) -> Self {
        let dot = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let gradient: [f64; 4] =
            std::array::from_fn(|i| dot(element.stiffness[i], v) - element.load[i]);
        let [force, moment] =
            [false, true].map(|rotates| dot(element.moved_end(false, rotates), gradient));
        Cut { node, force, moment }
    }
}

/// Returns the force (positive upwards) and the moment (positive clockwise) that a support at `x` must exert on the beam
/// between two cuts. `None` stands for the end of the beam.
fn needed(
    grid: &Grid,
    ground: &[f64],
    deflection: &[f64],
    x: f64,
    left: Option<Cut>,
    right: Option<Cut>,
) -> [f64; 2] {
    let from = left.map_or(0, |cut| cut.node);
    let to = right.map_or(grid.last(), |cut| cut.node);
    let is_inside = |node: usize| (from < node || left.is_none()) && node <= to;
    // Sums of the forces, positive downwards, and of the moments about the support, positive clockwise.
    let (mut force, mut moment) = (0.0, 0.0);
    let mut add = |f: f64, at: f64, m: f64| {
        force += f;
        moment += f * (at - x) + m;
    };
    for (run, a, b) in grid.parts(from, to) {
        let run = &grid.runs[run];
        let [f, m, ..] = element(grid, [a, b], 0.0).load;
        add(f, run.x(a), m);
        (a..b)
            .filter(|node| is_inside(*node))
            .for_each(|node| add(-ground[node], run.x(node), 0.0));
    }
    add(-ground[to], grid.x(to), 0.0);
    for (_, place) in grid.firsts().zip(&grid.nodes).filter(|(node, _)| is_inside(*node)) {
        add(place.force, place.x, place.moment);
    }
    for (cut, sign) in [(left, 1.0), (right, -1.0)] {
        if let Some(cut) = cut {
            add(sign * cut.force, grid.x(cut.node), sign * cut.moment);
        }
    }
    add(0.0, x, grid.axial_force * (deflection[from] - deflection[to]));
    [force, -moment]
}

/// Returns the element of the beam without ground between two nodes of a row, under an axial force.
fn element(grid: &Grid, [from, to]: [usize; 2], axial_force: f64) -> Element {
    let run = &grid.runs[grid.run_at(from)];
    run.element.unwrap_or_else(|| {
        let length = run.h * (to - from) as f64;
        Beam::new(run.cell.stiffness, &run.part(from, to), axial_force, length).element()
    })
}
