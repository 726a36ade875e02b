//! Represents contact zones as intervals of positions, and converts them to zones of a mesh.

use crate::contact::stopping::SLIT;
use crate::element::operator::ZoneKind;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::mesh::Mesh;
use crate::numeric::tolerance::same_place;

/// A contact zone from one position to another; equal positions are a point contact.
pub(crate) type Interval = [f64; 2];

/// Converts zones to intervals of positions. An edge within rounding error of one of the model's `places` is moved to
/// this place.
pub(crate) fn positions(mesh: &Mesh, zones: &[MeshZone], places: &[f64]) -> Vec<Interval> {
    let l = mesh.cells[mesh.cells.len() - 1].x[1];
    let at = |point: BeamPoint| snapped(mesh.cells[point.cell].global(point.s), places, l);
    // Without a shear layer, an interval as short as rounding error carries no force and is not a contact point.
    let carries = |zone: &MeshZone| mesh.cells[zone.from.cell].shear_layer > 0.0;
    let kept = |(zone, [from, to]): &(&MeshZone, Interval)| from < to || carries(zone);
    let all = zones.iter().map(|zone| (zone, [at(zone.from), at(zone.to)]));
    all.filter(kept).map(|(_, interval)| interval).collect()
}

/// Joins neighbouring intervals whose distance is rounding error, on a beam of length l. Point contacts stay separate,
/// because a shear layer beside Winkler ground can have one at its end.
pub(crate) fn joined(intervals: Vec<Interval>, l: f64) -> Vec<Interval> {
    let mut joined: Vec<Interval> = Vec::with_capacity(intervals.len());
    for interval in intervals {
        match joined.last_mut() {
            Some(last)
                if last[0] < last[1]
                    && interval[0] < interval[1]
                    && interval[0] - last[1] <= SLIT * l =>
            {
                last[1] = interval[1];
            }
            _ => joined.push(interval),
        }
    }
    joined
}

/// Returns the position in `places` that equals x up to rounding error. If no position equals x, returns x. The
/// rounding error is proportional to the beam length l.
pub(crate) fn snapped(x: f64, places: &[f64], l: f64) -> f64 {
    let near = same_place(l);
    let next = places.partition_point(|place| *place < x - near);
    places.get(next).copied().filter(|place| *place <= x + near).unwrap_or(x)
}

/// Converts intervals to zones of a mesh that has nodes at the ends of the intervals.
pub(crate) fn zones_of(
    mesh: &Mesh,
    intervals: &[Interval],
    touch: &impl Fn(&Cell) -> ZoneKind,
) -> Vec<MeshZone> {
    let mut zones: Vec<MeshZone> = Vec::new();
    let kind = |i: usize| mesh.cells[i].shear_layer > 0.0;
    for (i, cell) in mesh.cells.iter().enumerate() {
        if touch(cell) == ZoneKind::Open {
            continue;
        }
        let end = BeamPoint { cell: i, s: 1.0 };
        match zones.last_mut() {
            Some(last) if last.to.cell + 1 == i && kind(i - 1) == kind(i) => last.to = end,
            _ => zones.push(MeshZone { from: BeamPoint { cell: i, s: -1.0 }, to: end }),
        }
    }
    // A point contact becomes a zone at the nearest node, unless another zone contains this node.
    let count = mesh.cells.len();
    for x in intervals.iter().filter(|s| s[1] <= s[0]).map(|s| s[0]) {
        let right = mesh.nodes.partition_point(|n| n.x < x).min(count);
        let left = right.saturating_sub(1);
        let node = if x - mesh.nodes[left].x < mesh.nodes[right].x - x { left } else { right };
        let node_of = |point: BeamPoint| point.cell + usize::from(point.s == 1.0);
        let held = |zone: &MeshZone| {
            kind(zone.from.cell) && node_of(zone.from) <= node && node <= node_of(zone.to)
        };
        if zones.iter().any(held) {
            continue;
        }
        // Only a shear layer carries a force at a point. So of two adjoining cells, the cell with a shear layer is
        // chosen.
        let cell = if node == count || (node > 0 && !kind(node)) { node - 1 } else { node };
        let point = BeamPoint { cell, s: if cell == node { -1.0 } else { 1.0 } };
        zones.push(MeshZone { from: point, to: point });
    }
    zones.sort_by_key(|zone| (zone.from.cell, zone.from.s > 0.0));
    zones
}

/// Returns the longest interval on which two contact sets differ, or a larger distance of a point contact from the
/// other set. This distance is infinite if the other set is empty, or has a zone but no separate contact at this point.
pub(crate) fn longest_difference(a: &[Interval], b: &[Interval]) -> f64 {
    if a == b {
        return 0.0;
    }
    let lengths = differences(&[a, b]).into_iter().map(|[from, to]| to - from);
    let longest = lengths.fold(0.0, f64::max);
    let points = |of: &[Interval], other: &[Interval]| {
        let points = of.iter().filter(|interval| interval[0] == interval[1]);
        let apart = |&[x, _]: &Interval| {
            let zones =
                |contact: &[Interval]| contact.iter().filter(|zone| contains(zone, x)).count();
            if zones(other) > 0 && zones(of) > zones(other) {
                f64::INFINITY
            } else {
                distance_to(other, x)
            }
        };
        points.map(apart).fold(0.0, f64::max)
    };
    longest.max(points(a, b)).max(points(b, a))
}

/// The intervals that belong to at least one, but not to all, of the given contacts.
pub(crate) fn differences(contacts: &[&[Interval]]) -> Vec<Interval> {
    let mut ends: Vec<f64> =
        contacts.iter().flat_map(|contact| contact.as_flattened()).copied().collect();
    ends.sort_by(f64::total_cmp);
    let mut differences: Vec<Interval> = Vec::new();
    for part in ends.windows(2).filter(|part| part[0] < part[1]) {
        let middle = 0.5 * (part[0] + part[1]);
        let touching = contacts.iter().filter(|contact| covers(contact, middle)).count();
        if touching == 0 || touching == contacts.len() {
            continue;
        }
        match differences.last_mut() {
            Some(last) if last[1] == part[0] => last[1] = part[1],
            _ => differences.push([part[0], part[1]]),
        }
    }
    differences
}

/// Whether a position is inside a contact zone.
pub(crate) fn covers(contact: &[Interval], x: f64) -> bool {
    let next = contact.partition_point(|interval| interval[1] <= x);
    contact.get(next).is_some_and(|interval| interval[0] < x)
}

/// Whether a position is inside a contact zone or at its end.
fn contains([from, to]: &Interval, x: f64) -> bool {
    *from <= x && x <= *to
}

/// Distance of a position from the nearest contact zone.
fn distance_to(contact: &[Interval], x: f64) -> f64 {
    let apart = |[from, to]: &Interval| (from - x).max(x - to).max(0.0);
    contact.iter().map(apart).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_at_the_end_of_a_zone_is_a_contact_of_its_own() {
        let zone = [1.0, 3.0];
        assert_eq!(longest_difference(&[zone], &[[1.0, 1.0], zone]), f64::INFINITY);
        assert_eq!(longest_difference(&[[0.5, 1.0], zone], &[[1.0, 1.0], zone]), 0.5);
        assert_eq!(longest_difference(&[zone], &[zone, [3.25, 3.25]]), 0.25);
        assert_eq!(longest_difference(&[], &[[2.0, 2.0]]), f64::INFINITY);
    }
}
