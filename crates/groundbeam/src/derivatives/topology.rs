//! Computes how close a solution is to the nearest change of contact, at which derivatives with respect to parameters jump.

use super::frame::Frame;
use crate::contact::surface::can_carry;
use crate::numeric::polynomial::{derivative, value};
use crate::numeric::roots::sign_changes;
use crate::numeric::tolerance::TURNING_POINT;
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// The quantity that is zero at a change of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Condition {
    /// The pressure inside a contact zone or at its edge.
    Pressure,
    /// A concentrated contact force. It can act at an end of the beam, at a corner of the initial gap, at a jump of the
    /// stiffness μ of the shear layer, at a hinge or at a point contact.
    Force,
    /// The gap outside contact.
    Gap,
    /// The angle between beam and ground at a contact edge on ground without a shear layer.
    Angle,
    /// The length of a contact zone, or of a span out of contact.
    Length,
    /// The force of a support that acts in one direction only.
    SupportForce,
    /// The clearance of a support that acts in one direction only.
    SupportClearance,
}

impl Condition {
    /// The quantity as text.
    pub fn in_words(self) -> &'static str {
        match self {
            Condition::Pressure => "the pressure",
            Condition::Force => "a concentrated force",
            Condition::Gap => "the gap",
            Condition::Angle => "the angle between beam and ground",
            Condition::Length => "the length of a contact zone or of a span out of contact",
            Condition::SupportForce => "the force of a support",
            Condition::SupportClearance => "the clearance of a support",
        }
    }
}

/// The change of contact to which a solution is nearest. The contact changes when one of several quantities becomes
/// zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// The quantity that becomes zero at the nearest change of contact.
    pub condition: Condition,
    /// Position \[m\] of the quantity that becomes zero. For the length of a contact zone or of a span out of contact,
    /// it is the left end of the zone or span.
    pub at: f64,
    /// Size of the quantity that becomes zero, divided by a reference value. For example, a pressure is divided by the
    /// largest pressure, and a length by the length of the beam.
    pub margin: f64,
}

/// Depth of a minimum of the gap, relative to the largest deflection or gap, below which the minimum is due to
/// rounding error.
const ROUNDING_MINIMUM: f64 = 1e-8;

/// Returns the indices of the local minima in a list of positions and gaps. The gap must rise by more than `least` on
/// both sides, or on one side at a beam end.
fn deepest_between_peaks(places: &[(f64, f64)], ends: [f64; 2], least: f64) -> Vec<usize> {
    let count = places.len();
    let mut before = vec![f64::NEG_INFINITY; count];
    let mut after = before.clone();
    for i in 1..count {
        before[i] = before[i - 1].max(places[i - 1].1);
        after[count - 1 - i] = after[count - i].max(places[count - i].1);
    }
    let lowest = |i: usize| {
        let (x, gap) = places[i];
        // At a minimum, neither neighbouring gap is smaller. On both sides of a minimum, the gap rises by more than
        // `least`; at an end of the beam, this is required on one side only.
        let beside = [i.checked_sub(1), Some(i + 1).filter(|next| *next < count)];
        let turns = beside.into_iter().flatten().all(|j| places[j].1 >= gap);
        let peaks = [(before[i], ends[0]), (after[i], ends[1])];
        turns && peaks.into_iter().all(|(peak, end)| x == end || peak - gap > least)
    };
    (0..count).filter(|i| lowest(*i)).collect()
}

impl Solution {
    /// Finds the nearest change of contact: the quantity of [`Condition`] with the smallest
    /// [margin](Nearest::margin). Returns `None` if no condition applies to the solution.
    pub(super) fn nearest_change_in(&self, frame: &Frame) -> Option<Nearest> {
        let mut all: Vec<Nearest> = Vec::new();
        self.pressures(frame, &mut all);
        self.forces(frame, &mut all);
        self.gaps(&mut all);
        self.lengths(&mut all);
        self.one_way(&mut all);
        all.into_iter().min_by(|a, b| a.margin.total_cmp(&b.margin))
    }

    /// Appends the minima of the pressure in contact zones, the pressures at edges on a shear layer and the angles at
    /// edges on Winkler ground.
    fn pressures(&self, frame: &Frame, all: &mut Vec<Nearest>) {
        let largest = self.range(Quantity::Pressure).max.value;
        if largest <= 0.0 {
            return;
        }
        let mut add = |condition, at, size: f64| {
            all.push(Nearest { condition, at, margin: size.max(0.0) });
        };
        for piece in self.pieces().iter().filter(|piece| piece.open.is_none()) {
            let winkler = piece.cell.shear_layer == 0.0;
            let edge = |x: f64| {
                self.contact().iter().any(|region| region.from == x || region.to == x)
                    && x > 0.0
                    && x < self.model().beam.length
            };
            let mut candidates = vec![-1.0];
            sign_changes(&derivative(&piece.pressure), &mut candidates);
            candidates.push(1.0);
            for s in candidates {
                let x =
                    if s.abs() == 1.0 { piece.x[usize::from(s > 0.0)] } else { piece.global(s) };
                if !(winkler && edge(x)) {
                    add(Condition::Pressure, x, value(&piece.pressure, s) / largest);
                }
            }
        }
        // At an edge on Winkler ground, the margin is the angle between beam and ground, divided by p/(k l) for the
        // largest pressure p, the subgrade modulus k and the beam's length l.
        let l = self.model().beam.length;
        for zone in 0..frame.zones.len() {
            for side in [Side::Left, Side::Right] {
                let spot = frame.end_of(zone, side);
                let cell = &frame.mesh.cells[spot.cell];
                if cell.shear_layer > 0.0 || frame.stays(zone, side) {
                    continue;
                }
                let x = frame.position(spot);
                // The slope of the beam is taken on the side of the edge that is in contact.
                let within = if side == Side::Left { Side::Right } else { Side::Left };
                let rise = self.at(x, within).slope - cell.gap_slope;
                let scale = largest / cell.subgrade / l;
                add(Condition::Angle, x, rise.abs() / scale);
            }
        }
    }

    /// Appends to `all` the concentrated contact forces at all positions that can carry one.
    fn forces(&self, frame: &Frame, all: &mut Vec<Nearest>) {
        let (l, ends, cells) = (self.model().beam.length, self.end_forces(), &frame.mesh.cells);
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * l;
        let inside = self.concentrated_forces().iter().map(|force| (force.at, force.force));
        let known: Vec<(f64, f64)> =
            [(0.0, ends.left), (l, ends.right)].into_iter().chain(inside).collect();
        let force_at =
            |x: f64| known.iter().find(|(at, _)| near(*at, x)).map_or(0.0, |known| known.1);
        let mut places: Vec<f64> = Vec::new();
        for zone in frame.zones.iter().filter(|zone| cells[zone.from.cell].shear_layer > 0.0) {
            let [from, to] = [zone.from, zone.to].map(|s| s.cell + usize::from(s.s > 0.0));
            let nodes = (from..=to).map(|node| frame.mesh.nodes[node].x);
            places.extend(nodes.filter(|x| can_carry(&frame.mesh, frame.spot(*x, Side::Right))));
        }
        let contact: f64 = self
            .pieces()
            .iter()
            .map(|piece| {
                let even = piece.pressure.iter().step_by(2).enumerate();
                2.0 * piece.half * even.map(|(j, c)| c / (2 * j + 1) as f64).sum::<f64>()
            })
            .sum();
        let forces: f64 = places.iter().map(|x| force_at(*x).abs()).sum();
        // The margin of a concentrated force is its ratio to the total contact force or to the largest shear force of
        // the beam, whichever is larger.
        let carried = self.range(Quantity::ShearForce);
        let carried = carried.max.value.abs().max(carried.min.value.abs());
        let total = (contact.abs() + forces).max(carried);
        for x in places {
            let margin = if total > 0.0 { (force_at(x) / total).max(0.0) } else { 0.0 };
            all.push(Nearest { condition: Condition::Force, at: x, margin });
        }
    }

    /// Appends to `all` the minima of the gap between beam and ground, for each span out of contact between two contact
    /// zones or at an end of the beam.
    fn gaps(&self, all: &mut Vec<Nearest>) {
        let l = self.model().beam.length;
        let deflections = self.range(Quantity::Deflection);
        let gaps = self.range(Quantity::Gap).max.value;
        let scale = deflections.max.value.abs().max(deflections.min.value.abs()).max(gaps);
        if scale <= 0.0 {
            return;
        }
        // For one span out of contact, `open` collects from left to right the positions at which the gap between beam
        // and ground may have a minimum, and the gap at each position.
        let mut open: Vec<(f64, f64)> = Vec::new();
        let mut add = |open: &mut Vec<(f64, f64)>| {
            let touches = |x: f64| {
                let near = TURNING_POINT * l;
                self.contact().iter().any(|c| x >= c.from - near && x <= c.to + near)
            };
            let deepest = deepest_between_peaks(open, [0.0, l], ROUNDING_MINIMUM * scale);
            for at in deepest.into_iter().filter(|at| !touches(open[*at].0)) {
                let margin = (open[at].1 / scale).max(0.0);
                all.push(Nearest { condition: Condition::Gap, at: open[at].0, margin });
            }
            open.clear();
        };
        for piece in self.pieces() {
            let parts = self.contact().iter().any(|c| c.from == c.to && c.from == piece.x[0]);
            if piece.open.is_none() || parts {
                add(&mut open);
            }
            if piece.open.is_some() {
                let gap = |s: f64| (piece.global(s), piece.fields(s).gap);
                open.extend(piece.candidates(Quantity::Gap).into_iter().map(gap));
            }
        }
        add(&mut open);
    }

    /// Appends to `all` the length of each contact zone and of each span out of contact.
    fn lengths(&self, all: &mut Vec<Nearest>) {
        let l = self.model().beam.length;
        let mut at = None;
        for region in self.contact() {
            if region.from < region.to {
                let margin = (region.to - region.from) / l;
                all.push(Nearest { condition: Condition::Length, at: region.from, margin });
            }
            let before: f64 = at.unwrap_or(0.0);
            let open = region.from - before;
            if open > 0.0 {
                all.push(Nearest { condition: Condition::Length, at: before, margin: open / l });
            }
            at = Some(region.to);
        }
        if let Some(last) = at.filter(|last| *last < l) {
            let margin = (l - last) / l;
            all.push(Nearest { condition: Condition::Length, at: last, margin });
        }
    }

    /// Appends to `all` the forces and clearances of supports that act in one direction only.
    fn one_way(&self, all: &mut Vec<Nearest>) {
        let supports = || self.model().supports.iter().zip(self.reactions());
        let forces: f64 = supports().map(|(_, reaction)| reaction.force.abs()).sum();
        let range = self.range(Quantity::Deflection);
        let scale = range.max.value.abs().max(range.min.value.abs());
        for (support, reaction) in supports().filter(|(support, _)| support.is_one_way()) {
            let at = support.at;
            if reaction.force != 0.0 {
                let margin = reaction.force.abs() / forces;
                all.push(Nearest { condition: Condition::SupportForce, at, margin });
            } else if scale > 0.0 {
                let clear = self.at(at, Side::Right).deflection - support.settlement;
                let margin = clear.abs() / scale;
                all.push(Nearest { condition: Condition::SupportClearance, at, margin });
            }
        }
    }
}
