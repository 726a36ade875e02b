//! Where pieces meet: jumps of w and w', and what it costs to close them.
//!
//! A jump is closed by a smooth deflection on one side of it, which dies out before it meets a rigid
//! support, or, where there is none, moves that side of the beam rigidly up to its end. At a hinge w' may jump:
//! what that costs is its own.

use super::curve::rounding;
use super::outside::Outside;
use super::{Claim, ClaimedPiece};
use crate::model::{Model, SupportKind};

/// The stiffest of everything, which bounds what a small deflection costs.
#[derive(Debug)]
struct Stiffest {
    bending: f64,
    spring: f64,
    /// μ and P.
    tension: f64,
    /// Springs of supports and of the ground beyond the ends.
    springs: f64,
    rotational: f64,
    /// P < 0: its size.
    compression: f64,
}

/// What a rigid support holds.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Hold {
    /// Nothing: the beam is clear of it, and what closes a jump must not reach it.
    Clear,
    Deflection,
    Slope,
}

#[derive(Debug)]
pub(super) struct Joints {
    stiffest: Stiffest,
    length: f64,
    near: f64,
    /// Rigid supports: position, what each holds, how far it has settled.
    rigid: Vec<(f64, Hold, f64)>,
    /// Hinges, where w' may jump.
    hinges: Vec<f64>,
    seen: usize,
    /// w, w' at the right end of the last piece, and their rounding.
    last: Option<[f64; 4]>,
    at: f64,
    /// The norm of everything added, and its largest deflection.
    pub norm: f64,
    pub moved: f64,
    /// The largest jumps of w and of w', and of positions.
    pub jump: [f64; 2],
    pub misplaced: f64,
}

impl Joints {
    pub fn new(model: &Model, claim: &Claim, outside: &Outside) -> Self {
        let beam = &model.beam;
        let ground = &model.foundation;
        let segments =
            ground.segments.iter().map(|s| (s.subgrade.largest(), s.shear_layer.largest()));
        let (mut spring, mut shear) = (ground.subgrade, ground.shear_layer);
        for (k, mu) in segments {
            (spring, shear) = (spring.max(k), shear.max(mu));
        }
        let mut stiffest = Stiffest {
            bending: beam.stiffest(),
            spring,
            tension: shear + beam.axial_force.max(0.0),
            springs: outside.stiffness[0] + outside.stiffness[1],
            rotational: 0.0,
            compression: (-beam.axial_force).max(0.0),
        };
        let mut rigid = Vec::new();
        let mut pierced = Vec::new();
        for (i, support) in model.supports.iter().enumerate() {
            let acts = claim.reactions.get(i).is_some_and(|reaction| reaction.1 != 0.0);
            match support.kind {
                SupportKind::Pinned if support.is_one_way() && !acts => {
                    rigid.push((support.at, Hold::Clear, support.settlement));
                    let w = claim.deflection(support.at)[0] - support.settlement;
                    let beyond = support.acts.sign() * w;
                    if beyond > 0.0 {
                        pierced.push((support.at, beyond));
                    }
                }
                SupportKind::Pinned => {
                    rigid.push((support.at, Hold::Deflection, support.settlement))
                }
                SupportKind::Fixed => rigid.push((support.at, Hold::Slope, support.settlement)),
                SupportKind::Spring { spring, rotational_spring } => {
                    stiffest.springs += spring;
                    stiffest.rotational += rotational_spring;
                }
            }
        }
        rigid.sort_by(|a, b| a.0.total_cmp(&b.0));
        let length = beam.length;
        let near = super::NEAR * length;
        let mut joints = Joints {
            stiffest,
            length,
            near,
            rigid,
            hinges: model.hinges.iter().map(|hinge| hinge.at).collect(),
            seen: 0,
            last: None,
            at: 0.0,
            norm: 0.0,
            moved: 0.0,
            jump: [0.0; 2],
            misplaced: 0.0,
        };
        for (x, beyond) in pierced {
            joints.jump[0] = joints.jump[0].max(beyond);
            for room in joints.rooms(x) {
                joints.close(beyond, 0.0, &[room]);
            }
        }
        joints
    }

    /// How far it is to the next rigid support on either side, or to the end of the beam, which is free.
    fn rooms(&self, x: f64) -> [(f64, bool); 2] {
        let before = self.rigid.iter().rev().find(|r| r.0 < x - self.near);
        let next = self.rigid.iter().find(|r| r.0 > x + self.near);
        [
            (x - before.map_or(0.0, |r| r.0), before.is_none()),
            (next.map_or(self.length, |r| r.0) - x, next.is_none()),
        ]
    }

    /// One piece more, with w and half·φ at its ends.
    pub fn add(&mut self, piece: &ClaimedPiece, ends: [[f64; 2]; 2]) {
        let [from, to] = piece.x;
        let [noise, mut tilt] = rounding(piece.deflection);
        if !piece.rotation.is_empty() {
            tilt = piece.half * rounding(piece.rotation)[0];
        }
        let [left, right] = ends.map(|[w, dw]| [w, dw / piece.half, noise, tilt / piece.half]);
        let off = (to - from - 2.0 * piece.half).abs().max((from - self.at).abs());
        self.misplaced = self.misplaced.max(off);
        self.meet(self.at, self.last, Some(left));
        (self.last, self.at) = (Some(right), to);
    }

    pub fn finish(&mut self, claim: &Claim) {
        self.meet(self.length, self.last, None);
        self.misplaced = self.misplaced.max((self.at - self.length).abs());
        if self.seen < self.rigid.len() || claim.pieces.is_empty() {
            self.misplaced = f64::INFINITY;
        }
    }

    fn meet(&mut self, x: f64, left: Option<[f64; 4]>, right: Option<[f64; 4]>) {
        let (mut held, mut clamped, mut settled) = (false, false, 0.0);
        while let Some(&(at, hold, settlement)) = self.rigid.get(self.seen)
            && at <= x + self.near
        {
            self.seen += 1;
            if hold == Hold::Clear {
                continue;
            }
            if at >= x - self.near {
                (held, clamped, settled) = (true, clamped || hold == Hold::Slope, settlement);
            } else {
                self.misplaced = f64::INFINITY;
            }
        }
        let [room_left, room_right] = self.rooms(x);
        let slope_jump = match (left, right) {
            (Some(a), Some(b)) if !(clamped || self.is_hinge(x)) => {
                [(a[1] - b[1]).abs(), a[3] + b[3]]
            }
            _ => [0.0; 2],
        };
        if held {
            // Each side comes to rest by itself; a jump of the slope is given to the roomier one.
            let mut slope_jump = Some(slope_jump);
            let mut sides = [(left, room_left), (right, room_right)];
            if room_left.0 < room_right.0 {
                sides.swap(0, 1);
            }
            for (side, room) in sides {
                let Some([w, dw, noise, tilt]) = side else { continue };
                let off = (w - settled).abs();
                let slope = if clamped { [dw.abs(), tilt] } else { [0.0; 2] };
                let [b, b_noise] = slope_jump
                    .take()
                    .map_or(slope, |jump| [jump[0] + slope[0], jump[1] + slope[1]]);
                self.jump = [self.jump[0].max(off), self.jump[1].max(b)];
                self.close(off + noise, b + b_noise, &[room]);
            }
        } else if let (Some(a), Some(b)) = (left, right) {
            let jump = (a[0] - b[0]).abs();
            self.jump = [self.jump[0].max(jump), self.jump[1].max(slope_jump[0])];
            let rooms = [room_left, room_right];
            self.close(jump + a[2] + b[2], slope_jump[0] + slope_jump[1], &rooms);
        }
    }

    fn is_hinge(&self, x: f64) -> bool {
        self.hinges.iter().any(|at| (at - x).abs() <= self.near)
    }

    /// A deflection that is `a` and has the slope `b` at one end: the cheapest that fits into one of the
    /// rooms, each with its length and whether its end is free.
    fn close(&mut self, a: f64, b: f64, rooms: &[(f64, bool)]) {
        if a == 0.0 && b == 0.0 {
            return;
        }
        let all = &self.stiffest;
        let wave = (4.0 * all.bending / all.spring).sqrt().sqrt();
        let mut best = (f64::INFINITY, 0.0);
        for &(room, free) in rooms {
            if free {
                let moved = a + b * room;
                let energy = moved * moved * (all.spring * room + all.springs)
                    + b * b * (all.tension * room + all.rotational);
                if energy < best.0 {
                    best = (energy, moved);
                }
            }
            // A sliver beside a support has no room to bend.
            for room in [room, room.min(wave)].into_iter().filter(|room| *room > 0.0) {
                // The cubic that ends level at zero.
                let moved = a + 0.25 * b * room;
                let slope = 1.5 * a / room + b;
                let bent = (12.0 * a * (a / room + b) + 4.0 * b * b * room) / (room * room);
                let energy = all.bending * bent
                    + moved * moved * (all.spring * room + all.springs)
                    + slope * slope * (all.tension * room + all.rotational);
                if energy < best.0 {
                    best = (energy, moved);
                }
            }
        }
        self.norm += best.0.sqrt();
        self.moved += best.1;
    }

    /// The largest jump, relative to the largest of its kind.
    pub fn continuity(&self, model: &Model, deflection: f64, slope: f64) -> f64 {
        let l = model.beam.length;
        let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
        relative(self.jump[0], deflection)
            .max(relative(self.jump[1], slope.max(deflection / l)))
            .max(self.misplaced / l)
    }

    /// What compression makes of the deflections added: a moment.
    pub fn moment(&self) -> f64 {
        self.stiffest.compression * self.moved
    }
}
