//! Open ground between two zones of contact, or between one and the ground beyond.

use crate::derivatives::piece::Piece;
use crate::element::operator::ZoneKind;
use crate::ground::link::TwoPort;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::ground_runs::ground_runs as grounds;
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;
use crate::mesh::open_ground::heights;

/// Open ground as a row of strips, each of them a piece or all that is beyond an end.
#[derive(Debug, Clone)]
pub(super) struct Joint {
    /// Where it is tied to the beam; beyond an end nowhere.
    pub ends: [Option<BeamPoint>; 2],
    /// The piece of each strip, none for the ground beyond.
    pub strips: Vec<Option<usize>>,
    links: Vec<TwoPort>,
    whole: TwoPort,
}

/// The joints of all ground with a shear layer, from left to right.
pub(super) fn joints(mesh: &Mesh, zones: &[MeshZone], pieces: &[Piece]) -> Vec<Joint> {
    let mut joints = Vec::new();
    for ground in grounds(mesh).into_iter().filter(|ground| ground.pasternak) {
        let own = |zone: &&MeshZone| ground.cells.contains(&zone.from.cell);
        let mut left: Option<BeamPoint> = None;
        let zones: Vec<&MeshZone> = zones.iter().filter(own).collect();
        let rights = zones.iter().map(|zone| Some(zone.from)).chain([None]);
        let lefts = zones.iter().map(|zone| Some(zone.to)).chain([None]);
        for (right, next) in rights.zip(lefts) {
            let first = left.map_or(ground.cells.start, |s| s.cell + usize::from(s.s > 0.0));
            let end = right.map_or(ground.cells.end, |s| s.cell + usize::from(s.s > 0.0));
            let open = pieces.iter().enumerate().filter(|(_, piece)| {
                piece.touch == ZoneKind::Open && (first..end).contains(&piece.element)
            });
            let mut strips: Vec<Option<usize>> = open.map(|(i, _)| Some(i)).collect();
            let mut links: Vec<TwoPort> =
                strips.iter().flatten().map(|i| link(&pieces[*i])).collect();
            if left.is_none() {
                let shunt_right = ground.beyond[0];
                strips.insert(0, None);
                links.insert(0, TwoPort { series: 0.0, shunt_left: 0.0, shunt_right });
            }
            if right.is_none() {
                let shunt_left = ground.beyond[1];
                strips.push(None);
                links.push(TwoPort { series: 0.0, shunt_left, shunt_right: 0.0 });
            }
            let whole = links.iter().copied().reduce(TwoPort::then).unwrap_or_default();
            joints.push(Joint { ends: [left, right], strips, links, whole });
            left = next;
        }
    }
    joints
}

fn link(piece: &Piece) -> TwoPort {
    if piece.cell.ground_varies() {
        return cell_part(&piece.cell, -1.0, 1.0);
    }
    TwoPort::uniform(piece.cell.subgrade, piece.cell.shear_layer, 2.0 * piece.half)
}

impl Joint {
    /// u at the ends of all strips, from that at both ends.
    pub fn heights(&self, ends: [f64; 2]) -> Vec<f64> {
        heights(&self.links, ends).0
    }

    /// What the ground takes at both ends, held there.
    pub fn forces(&self, [left, right]: [f64; 2]) -> [f64; 2] {
        [self.whole.force_left(left, right), self.whole.force_right(left, right)]
    }

    /// The same under forces on the strips, each at the start of one: without differences of neighbouring heights.
    pub fn forces_under(
        &self,
        heights: &[f64],
        forces: impl Iterator<Item = (usize, f64)>,
    ) -> [f64; 2] {
        let last = self.strips.len();
        let mut sum = self.forces([heights[0], heights[last]]);
        for (strip, force) in forces {
            let carried = self.carried(strip);
            sum = [sum[0] - force * carried[0], sum[1] - force * carried[1]];
        }
        sum
    }

    /// The parts of a force at the start of a strip that its two ends bear.
    pub fn carried(&self, strip: usize) -> [f64; 2] {
        [[1.0, 0.0], [0.0, 1.0]].map(|ends| self.heights(ends)[strip])
    }

    /// u under a unit force at the start of a strip, both ends being held.
    pub fn bulge(&self, strip: usize) -> Vec<f64> {
        let [left, right] = [&self.links[..strip], &self.links[strip..]];
        let [before, after] = [left, right]
            .map(|links| links.iter().copied().reduce(TwoPort::then).unwrap_or_default());
        let hold = before.series + before.shunt_right + after.series + after.shunt_left;
        let top = if hold > 0.0 { 1.0 / hold } else { 0.0 };
        let mut bulge = heights(left, [0.0, top]).0;
        bulge.pop();
        bulge.extend(heights(right, [top, 0.0]).0);
        bulge
    }
}
