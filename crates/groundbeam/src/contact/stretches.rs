//! Contact as positions, and as zones of a mesh with a node at each of them.

use crate::element::operator::Touch;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{Spot, Zone};
use crate::mesh::mesh::Mesh;
use crate::numeric::tolerance::same_place;

/// Open ground this short, as a part of the length, is hardly more than rounding.
const SLIT: f64 = 1e-10;

/// Stretches of contact as positions; a point has both equal.
pub(crate) type Stretch = [f64; 2];

/// Zones as positions. An edge within rounding of a place of the model's own is there.
pub(crate) fn positions(mesh: &Mesh, zones: &[Zone], places: &[f64]) -> Vec<Stretch> {
    let l = mesh.cells[mesh.cells.len() - 1].x[1];
    let at = |spot: Spot| at_place(mesh.cells[spot.cell].global(spot.s), places, l);
    // Without a shear layer a stretch that rounding made is no point of contact: it carries nothing.
    let carries = |zone: &Zone| mesh.cells[zone.from.cell].shear > 0.0;
    let kept = |(zone, [from, to]): &(&Zone, Stretch)| from < to || carries(zone);
    let all = zones.iter().map(|zone| (zone, [at(zone.from), at(zone.to)]));
    all.filter(kept).map(|(_, stretch)| stretch).collect()
}

/// Stretches without the slits that rounding leaves between them, on a beam of length l. A point stays: it may be
/// the end of a shear layer beside separate springs.
pub(crate) fn joined(stretches: Vec<Stretch>, l: f64) -> Vec<Stretch> {
    let mut joined: Vec<Stretch> = Vec::with_capacity(stretches.len());
    for stretch in stretches {
        match joined.last_mut() {
            Some(last)
                if last[0] < last[1]
                    && stretch[0] < stretch[1]
                    && stretch[0] - last[1] <= SLIT * l =>
            {
                last[1] = stretch[1];
            }
            _ => joined.push(stretch),
        }
    }
    joined
}

/// A position on a beam of length l; within rounding of a place of the model's own that place.
pub(crate) fn at_place(x: f64, places: &[f64], l: f64) -> f64 {
    let near = same_place(l);
    let next = places.partition_point(|place| *place < x - near);
    places.get(next).copied().filter(|place| *place <= x + near).unwrap_or(x)
}

/// Stretches as zones of a mesh that has a node at each of their ends.
pub(crate) fn zones_of(
    mesh: &Mesh,
    stretches: &[Stretch],
    touch: &impl Fn(&Cell) -> Touch,
) -> Vec<Zone> {
    let mut zones: Vec<Zone> = Vec::new();
    let kind = |i: usize| mesh.cells[i].shear > 0.0;
    for (i, cell) in mesh.cells.iter().enumerate() {
        if touch(cell) == Touch::Open {
            continue;
        }
        let end = Spot { cell: i, s: 1.0 };
        match zones.last_mut() {
            Some(last) if last.to.cell + 1 == i && kind(i - 1) == kind(i) => last.to = end,
            _ => zones.push(Zone { from: Spot { cell: i, s: -1.0 }, to: end }),
        }
    }
    // Points: the node nearest to them, if no zone holds it already.
    let count = mesh.cells.len();
    for x in stretches.iter().filter(|s| s[1] <= s[0]).map(|s| s[0]) {
        let right = mesh.nodes.partition_point(|n| n.x < x).min(count);
        let left = right.saturating_sub(1);
        let node = if x - mesh.nodes[left].x < mesh.nodes[right].x - x { left } else { right };
        let node_of = |spot: Spot| spot.cell + usize::from(spot.s == 1.0);
        let held = |zone: &Zone| {
            kind(zone.from.cell) && node_of(zone.from) <= node && node <= node_of(zone.to)
        };
        if zones.iter().any(held) {
            continue;
        }
        // A point can carry a force only on a shear layer: of two cells that meet, the one that has it.
        let cell = if node == count || (node > 0 && !kind(node)) { node - 1 } else { node };
        let spot = Spot { cell, s: if cell == node { -1.0 } else { 1.0 } };
        zones.push(Zone { from: spot, to: spot });
    }
    zones.sort_by_key(|zone| (zone.from.cell, zone.from.s > 0.0));
    zones
}

/// The largest move of an edge; infinite if a zone came or went.
pub(crate) fn distance(a: &[Stretch], b: &[Stretch]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
