//! Builds the linearised problem of a solution: cells, nodes and zones of the beam bonded to the ground on its contact zones.
//!
//! To first order, the contact edges are fixed, because their moves change the energy only in third order. See *The
//! linear problem* in `docs/derivatives.md`.

use crate::cancel::Cancel;
use crate::contact::bonded::{Bonded, zone_kind_of};
use crate::contact::intervals::{Interval, zones_of};
use crate::contact::surface::can_carry;
use crate::element::layers::Layers;
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::mesh::Mesh;
use crate::model::{Load, Model};
use crate::numeric::tolerance::same_place;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;
use std::ops::Range;

/// Model, cells and contact zones of the linearised problem, without derivatives with respect to the parameters.
#[derive(Debug)]
pub(super) struct Frame<'a> {
    pub solution: &'a Solution,
    /// The model with the active supports only.
    pub model: Model,
    /// Mesh with one cell for each element.
    pub mesh: Mesh,
    /// Contact zones on the mesh `mesh`.
    pub zones: Vec<MeshZone>,
    /// Whether each cell of `mesh` is in contact.
    pub touch: Vec<ZoneKind>,
    /// Finer mesh with cells short enough for power series, and the contact zones on this mesh, if elements have
    /// boundary layers; otherwise `None`.
    pub fine: Option<(Mesh, Vec<MeshZone>)>,
}

impl<'a> Frame<'a> {
    pub fn at(solution: &'a Solution) -> Self {
        let intervals = contact_of(solution);
        let acts = |i: usize| solution.reactions()[i].force != 0.0;
        let model = solution.model().with_supports_that(|i, s| !s.is_one_way() || acts(i));
        let (mesh, zones) = Bonded::fine(&model, &Cancel::default()).mesh_on(&intervals, &[]);
        let kind = zone_kind_of(&intervals);
        let touch: Vec<ZoneKind> = mesh.cells.iter().map(&kind).collect();
        let mut x: Vec<f64> = Vec::new();
        for (cell, touch) in mesh.cells.iter().zip(&touch) {
            let operator = Operator::of(cell, mesh.axial_force, *touch);
            if let Some(layers) = Layers::of(&operator, cell.length()) {
                x.extend(layers.cuts(cell.x, [1.0; 2]));
            }
        }
        let fine = (!x.is_empty()).then(|| {
            x.extend(mesh.nodes.iter().map(|node| node.x));
            let fine = Mesh::build(&model, &x, |_| 1);
            let zones = zones_of(&fine, &intervals, &kind);
            (fine, zones)
        });
        Frame { solution, model, mesh, zones, touch, fine }
    }

    /// Returns the mesh on which w is a power series in each cell, and the contact zones on this mesh.
    pub fn series(&self) -> (&Mesh, &[MeshZone]) {
        let own = (&self.mesh, &self.zones[..]);
        self.fine.as_ref().map_or(own, |(fine, zones)| (fine, &zones[..]))
    }

    /// Returns the indices of the cells of the [series](Self::series) mesh in element i.
    pub fn series_of(&self, i: usize) -> Range<usize> {
        let Some((fine, _)) = &self.fine else { return i..i + 1 };
        let [from, to] = self.mesh.cells[i].x;
        let before = |x: f64| fine.cells.partition_point(|cell| 0.5 * (cell.x[0] + cell.x[1]) < x);
        before(from)..before(to)
    }

    /// Returns the index of support i among the active supports, or `None` if the support is not active.
    pub fn number_among_acting(&self, i: usize) -> Option<usize> {
        let solution = self.solution;
        let acts = |i: usize| {
            !solution.model().supports[i].is_one_way() || solution.reactions()[i].force != 0.0
        };
        acts(i).then(|| (0..i).filter(|i| acts(*i)).count())
    }

    /// Returns the cell end on the given side of the node at x. At an end of the beam, only one side exists.
    pub fn spot(&self, x: f64, side: Side) -> BeamPoint {
        let node = self.mesh.node_at(x);
        let left = node > 0 && (side == Side::Left || node == self.mesh.cells.len());
        if left { BeamPoint { cell: node - 1, s: 1.0 } } else { BeamPoint { cell: node, s: -1.0 } }
    }

    /// Whether two positions belong to the same node.
    pub fn is_same_node(&self, a: f64, b: f64) -> bool {
        self.mesh.node_at(a) == self.mesh.node_at(b)
    }

    /// Whether two positions are equal within rounding error.
    pub fn is_same_place(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= same_place(self.model.beam.length)
    }

    /// Whether a position lies between the beam's ends.
    pub fn is_inside(&self, x: f64) -> bool {
        x > 0.0 && x < self.model.beam.length
    }

    /// The end of a zone.
    pub fn end_of(&self, zone: usize, side: Side) -> BeamPoint {
        let zone = &self.zones[zone];
        if side == Side::Left { zone.from } else { zone.to }
    }

    /// Position of a cell end.
    pub fn position(&self, spot: BeamPoint) -> f64 {
        self.mesh.nodes[spot.cell + usize::from(spot.s > 0.0)].x
    }

    /// Finds the zone whose left or right end is at a position. `side` selects the end.
    pub fn zone_at(&self, x: f64, side: Side) -> Option<usize> {
        let node = self.mesh.node_at(x);
        (0..self.zones.len()).find(|zone| {
            let spot = self.end_of(*zone, side);
            spot.cell + usize::from(spot.s > 0.0) == node
        })
    }

    /// Whether a contact edge cannot move. An edge cannot move where a concentrated contact force can act, at a point
    /// contact, and at an end of a stretch of Winkler ground.
    pub fn stays(&self, zone: usize, side: Side) -> bool {
        let (spot, cells) = (self.end_of(zone, side), &self.mesh.cells);
        if self.zones[zone].from == self.zones[zone].to {
            return true;
        }
        if cells[spot.cell].shear_layer > 0.0 {
            return can_carry(&self.mesh, spot);
        }
        let node = spot.cell + usize::from(spot.s > 0.0);
        node == 0
            || node == cells.len()
            || cells[node - 1].shear_layer > 0.0
            || cells[node].shear_layer > 0.0
    }

    /// Whether the beam has shear deformation, on the left and on the right of a position.
    pub fn shears_at(&self, x: f64) -> [bool; 2] {
        [Side::Left, Side::Right]
            .map(|side| self.mesh.cells[self.spot(x, side).cell].beam_shear.is_some())
    }

    /// Whether exactly one load acts, begins or ends at a position inside the beam, and no segment, support, hinge or
    /// gap point has the same position.
    pub fn stands_alone(&self, x: f64) -> bool {
        let model = &self.model;
        let here = |other: f64| self.is_same_node(x, other);
        let begins_or_ends = |load: &&Load| load.extent.ends().into_iter().any(here);
        let loads = model.loads.iter().filter(begins_or_ends).count();
        let segments = model.beam.segments.iter().map(|s| [s.from, s.to]);
        let segments = segments.chain(model.foundation.segments.iter().map(|s| [s.from, s.to]));
        let others = segments.flatten().chain(model.supports.iter().map(|s| s.at));
        let others = others.chain(model.hinges.iter().map(|h| h.at));
        let mut others = others.chain(model.gap.iter().map(|g| g.at));
        let l = model.beam.length;
        loads == 1 && self.is_inside(x) && !others.any(|x| x >= 0.0 && x <= l && here(x))
    }
}

/// Returns the contact zones, with a point contact at each zone end that carries a concentrated force. A shear layer
/// may end there.
fn contact_of(solution: &Solution) -> Vec<Interval> {
    let mut stretches = Vec::with_capacity(solution.contact().len());
    let carries = |x: f64| solution.concentrated_forces().iter().any(|force| force.at == x);
    for region in solution.contact() {
        let [from, to] = [region.from, region.to];
        if from < to && carries(from) {
            stretches.push([from; 2]);
        }
        stretches.push([from, to]);
        if from < to && carries(to) {
            stretches.push([to; 2]);
        }
    }
    stretches
}
