//! Contact zones cell by cell: the parts of cells in contact, the nodes in contact, and the two-ports between them.

use crate::chain::node::{ChainCell, ChainNode};
use crate::chain::node::{Tie, TiedTwoPort};
use crate::element::element::Element;
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::cell::gap_at;
use crate::mesh::deflection::MeshZone;
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;
use std::ops::Range;

/// Distance of a node to a point of contact, in units of 1/wave number, below which r = u − ψ is the unknown of the
/// surface.
const NARROW_GAP: f64 = 1e-2;

/// Contact of the cells and nodes of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Layout {
    /// Parts \[s_from, s_to\] of cells in contact, ordered by cell. Equal ends are a point contact.
    parts: Vec<(usize, [f64; 2])>,
    /// Whether each node is in contact, as an end of the cell on its left and on its right.
    pub touched: Vec<[bool; 2]>,
}

impl Layout {
    pub fn of(mesh: &Mesh, zones: &[MeshZone]) -> Self {
        let mut parts = Vec::with_capacity(mesh.cells.len());
        let mut touched = vec![[false; 2]; mesh.nodes.len()];
        let mut touch = |cell: usize, s: f64| {
            if s.abs() < 1.0 {
                return;
            }
            let (node, side, next) = if s < 0.0 {
                (cell, 1, cell.checked_sub(1))
            } else {
                (cell + 1, 0, Some(cell + 1).filter(|&i| i < mesh.cells.len()))
            };
            touched[node][side] = true;
            // At a change between ground with and without a shear layer, each side has its own surface.
            let kind = |i: usize| mesh.cells[i].shear_layer > 0.0;
            if next.is_none_or(|next| kind(next) == kind(cell)) {
                touched[node][1 - side] = true;
            }
        };
        for zone in zones {
            let (from, to) = (zone.from, zone.to);
            if from == to && from.s.abs() == 1.0 {
                touch(from.cell, from.s);
                continue;
            }
            for cell in from.cell..=to.cell {
                let start = if cell == from.cell { from.s } else { -1.0 };
                let end = if cell == to.cell { to.s } else { 1.0 };
                if end > start || from == to {
                    parts.push((cell, [start, end]));
                }
                touch(cell, start);
                touch(cell, end);
            }
        }
        Layout { parts, touched }
    }

    /// The parts of cell i in contact.
    pub fn parts(&self, i: usize) -> impl DoubleEndedIterator<Item = [f64; 2]> + '_ {
        let first = self.parts.partition_point(|(cell, _)| *cell < i);
        let end = first + self.parts[first..].partition_point(|(cell, _)| *cell == i);
        self.parts[first..end].iter().map(|(_, part)| *part)
    }

    /// The node at which the sweeps meet: the middle of the longest contact interval, otherwise a rigid support.
    pub fn meeting_node(&self, mesh: &Mesh) -> usize {
        let mut best = (0.0, mesh.nodes.len() / 2);
        let mut start: Option<usize> = None;
        for node in 0..=mesh.nodes.len() {
            let touches = node < mesh.nodes.len() && self.touched[node].contains(&true);
            match (touches, start) {
                (true, None) => start = Some(node),
                (false, Some(first)) => {
                    let length = mesh.nodes[node - 1].x - mesh.nodes[first].x;
                    if length > best.0 || best.0 == 0.0 {
                        let middle = 0.5 * (mesh.nodes[node - 1].x + mesh.nodes[first].x);
                        let at = mesh.nodes.partition_point(|n| n.x < middle);
                        best = (length.max(f64::MIN_POSITIVE), at.clamp(first, node - 1));
                    }
                    start = None;
                }
                _ => {}
            }
        }
        if best.0 <= f64::MIN_POSITIVE {
            let held = |n: &crate::mesh::mesh::Node| n.clamped || n.pinned;
            if let Some(support) = mesh.nodes.iter().position(held) {
                return support;
            }
        }
        best.1
    }

    /// The nodes of the chain for this contact.
    pub fn nodes(&self, mesh: &Mesh) -> Vec<ChainNode> {
        let mut nodes: Vec<ChainNode> = mesh
            .nodes
            .iter()
            .map(|n| ChainNode {
                force: n.force,
                moment: n.moment,
                pinned: n.pinned,
                settlement: n.settlement,
                clamped: n.clamped,
                spring: n.spring,
                rotational_spring: n.rotational_spring,
                hinge: n.hinge,
                ..ChainNode::default()
            })
            .collect();
        // In contact, ∫(k u₀z + μu₀′z′) over a cell is ∫q z plus μu₀′z at its ends.
        for &(i, part) in self.parts.iter().filter(|(i, _)| mesh.cells[*i].has_free_field()) {
            let cell = &mesh.cells[i];
            let [from, to] = part.map(|s| cell.shear_layer * cell.free_field_at(s)[1]);
            nodes[i].force -= from;
            nodes[i + 1].force += to;
        }
        for GroundRun { cells, pasternak, beyond } in ground_runs(mesh) {
            if !pasternak {
                continue;
            }
            for node in cells.start..=cells.end {
                if node > cells.start {
                    nodes[node].surface[0] = !self.touched[node][0];
                }
                if node < cells.end {
                    nodes[node].surface[1] = !self.touched[node][1];
                }
            }
            for (node, side, cell, end) in
                [(cells.start, 1, cells.start, 0), (cells.end, 0, cells.end - 1, 1)]
            {
                let spring = beyond[end];
                if self.touched[node][side] {
                    nodes[node].ground_spring += spring;
                    nodes[node].gap = gap_at(&mesh.cells[cell], [-1.0, 1.0][end]);
                } else {
                    nodes[node].surface_spring += spring;
                }
            }
            let own = cells.start..=cells.end;
            if nodes[own.clone()].iter().all(|node| !node.surface.contains(&true)) {
                continue;
            }
            let distances = self.distances_to_contact(mesh, &cells);
            for (node, distance) in own.zip(distances) {
                let cell = &mesh.cells[node.min(cells.end - 1)];
                let waves = || {
                    Operator::of(cell, mesh.axial_force, ZoneKind::Contact).wave_number() * distance
                };
                if nodes[node].surface.contains(&true) && waves() <= NARROW_GAP {
                    nodes[node].from_beam = true;
                    let right = node.min(mesh.cells.len() - 1);
                    nodes[node].gap = gap_at(&mesh.cells[right], [-1.0, 1.0][node - right]);
                }
            }
        }
        nodes
    }

    /// Distance of each node of a run to the nearest point of contact. Near such a point the open ground is a very
    /// stiff two-port.
    fn distances_to_contact(&self, mesh: &Mesh, cells: &Range<usize>) -> Vec<f64> {
        let x = |node: usize| mesh.nodes[node].x;
        let at = |cell: usize, s: f64| mesh.cells[cell].global(s);
        let mut distance = vec![f64::INFINITY; cells.len() + 1];
        let mut last = f64::NEG_INFINITY;
        for node in cells.start..=cells.end {
            if node > cells.start {
                last = self.parts(node - 1).last().map_or(last, |part| at(node - 1, part[1]));
            }
            distance[node - cells.start] = x(node) - last;
            if self.touched[node].contains(&true) {
                last = x(node);
            }
        }
        let mut next = f64::INFINITY;
        for node in (cells.start..=cells.end).rev() {
            if node < cells.end {
                next = self.parts(node).next().map_or(next, |part| at(node, part[0]));
            }
            let distance = &mut distance[node - cells.start];
            *distance = distance.min(next - x(node));
            if self.touched[node].contains(&true) {
                next = x(node);
            }
        }
        distance
    }

    /// The two-ports of open ground in cell i. `row` gives w at s as a linear combination of the element's four
    /// unknowns.
    pub fn links(&self, mesh: &Mesh, i: usize, row: impl Fn(f64) -> [f64; 4]) -> Vec<TiedTwoPort> {
        let cell = &mesh.cells[i];
        if cell.shear_layer <= 0.0 {
            return Vec::new();
        }
        let beam = |s: f64| Tie::Beam { row: row(s), gap: gap_at(cell, s) };
        let mut links = Vec::new();
        let mut left = if self.touched[i][1] { beam(-1.0) } else { Tie::SurfaceLeft };
        let mut at = -1.0;
        let mut link_to = |to: f64, left: Tie, right: Tie, at: f64| {
            if to > at {
                links.push(TiedTwoPort { two_port: cell_part(cell, at, to), left, right });
            }
        };
        for [from, to] in self.parts(i) {
            link_to(from, left, beam(from), at);
            (left, at) = (beam(to), to);
        }
        let right = if self.touched[i + 1][0] { beam(1.0) } else { Tie::SurfaceRight };
        link_to(1.0, left, right, at);
        links
    }

    /// A chain cell: its element and the two-ports of open ground.
    pub fn chain_cell(
        &self,
        mesh: &Mesh,
        i: usize,
        element: Element,
        row: impl Fn(f64) -> [f64; 4],
    ) -> ChainCell {
        ChainCell { element, links: self.links(mesh, i, row) }
    }
}
