//! Divides the cells and nodes of a mesh into contact and open ground. The ends of contact zones are nodes.

use crate::chain::node::{ChainCell, ChainNode, OpenGround, Tie};
use crate::element::element::Element;
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::cell::gap_at;
use crate::mesh::deflection::MeshZone;
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;
use std::ops::Range;

/// Distance of a node from contact, times the wave number, up to which its surface unknown is relative to the beam.
const NARROW_GAP: f64 = 1e-2;

/// Contact of the cells and nodes of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Layout {
    /// Whether each cell is in contact.
    touching: Vec<bool>,
    /// Whether each node is in contact on its left side and on its right side.
    touched: Vec<[bool; 2]>,
}

impl Layout {
    /// Determines the contact of cells and nodes from zones whose ends are nodes.
    pub fn of(mesh: &Mesh, zones: &[MeshZone]) -> Self {
        let mut touching = vec![false; mesh.cells.len()];
        let mut touched = vec![[false; 2]; mesh.nodes.len()];
        let mut touch = |cell: usize, s: f64| {
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
        for MeshZone { from, to } in zones {
            touch(from.cell, from.s);
            touch(to.cell, to.s);
            for cell in from.cell..=to.cell {
                let start = if cell == from.cell { from.s } else { -1.0 };
                let end = if cell == to.cell { to.s } else { 1.0 };
                if start < end {
                    touching[cell] = true;
                    touch(cell, start);
                    touch(cell, end);
                }
            }
        }
        Layout { touching, touched }
    }

    /// Chooses the node at which the eliminations from both ends of the beam meet: the middle of the longest
    /// contact interval, or a rigid support if there are only point contacts.
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

    /// Returns the nodes of the linear system, with their loads, supports and ground springs.
    pub fn nodes(&self, mesh: &Mesh) -> Vec<ChainNode> {
        let mut nodes: Vec<ChainNode> = mesh.nodes.iter().map(ChainNode::of).collect();
        // In contact, integration by parts converts the load from the free-field settlement u₀ to a distributed load
        // and the forces −μu₀′ and μu₀′ at the left and right end of a cell.
        for (i, cell) in mesh.cells.iter().enumerate() {
            if self.touching[i] && cell.has_free_field() {
                let [from, to] = [-1.0, 1.0].map(|s| cell.shear_layer * cell.free_field_at(s)[1]);
                nodes[i].force -= from;
                nodes[i + 1].force += to;
            }
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

    /// Computes the distance of each node of a stretch of ground from the nearest point in contact.
    fn distances_to_contact(&self, mesh: &Mesh, cells: &Range<usize>) -> Vec<f64> {
        let x = |node: usize| mesh.nodes[node].x;
        let mut distance = vec![f64::INFINITY; cells.len() + 1];
        let mut last = f64::NEG_INFINITY;
        for node in cells.start..=cells.end {
            if node > cells.start && self.touching[node - 1] {
                last = x(node);
            }
            distance[node - cells.start] = x(node) - last;
            if self.touched[node].contains(&true) {
                last = x(node);
            }
        }
        let mut next = f64::INFINITY;
        for node in (cells.start..=cells.end).rev() {
            if node < cells.end && self.touching[node] {
                next = x(node);
            }
            let distance = &mut distance[node - cells.start];
            *distance = distance.min(next - x(node));
            if self.touched[node].contains(&true) {
                next = x(node);
            }
        }
        distance
    }

    /// Returns the ground under cell i if it has a shear layer and is out of contact with the beam; otherwise
    /// `None`.
    fn open_ground(&self, mesh: &Mesh, i: usize) -> Option<OpenGround> {
        let cell = &mesh.cells[i];
        if cell.shear_layer <= 0.0 || self.touching[i] {
            return None;
        }
        let tie = |touches: bool, s: f64| {
            if touches { Tie::Beam { gap: gap_at(cell, s) } } else { Tie::Surface }
        };
        let ties = [tie(self.touched[i][1], -1.0), tie(self.touched[i + 1][0], 1.0)];
        Some(OpenGround { two_port: cell_part(cell, -1.0, 1.0), ties })
    }

    /// Returns the cells of the linear system. A cell is a beam element and, where the beam is out of contact, also
    /// the ground under it if this ground has a shear layer.
    pub fn cells(&self, mesh: &Mesh, elements: impl Iterator<Item = Element>) -> Vec<ChainCell> {
        let cell = |(i, element)| ChainCell { element, open: self.open_ground(mesh, i) };
        elements.enumerate().map(cell).collect()
    }
}
