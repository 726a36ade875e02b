//! Where the beam pierces open ground: what it costs to lift the ground, and only there.
//!
//! The ground is moved by v so that it lies nowhere below the beam and still touches where forces stand.
//! v vanishes where there is pressure, so it costs ½ b(v, v) and nothing of first order.

use super::curve::{Curve, Edge, depth, depth_of, edge};
use super::surface::{Clearance, Under};

/// Open ground between two places where v must vanish, or where the ground ends.
#[derive(Debug, Clone, Copy, Default)]
struct Stretch {
    /// How deep the beam may pierce it.
    depth: f64,
    /// b(v, v) of v = 1 that falls to zero at the edges.
    stiffness: f64,
    /// Forces that stand clear of the ground on it, which v = 1 would do work on.
    forces: f64,
    moved: f64,
}

#[derive(Debug, Default)]
pub(super) struct Lifting {
    current: Stretch,
    /// b(v, v) of each kind of v: at edges, of the beam below them, at joints, of whole stretches.
    squares: [f64; 4],
    /// ⟨p, v⟩.
    pub work: f64,
    /// The largest |v|.
    pub moved: f64,
    /// The deepest place found.
    pub deepest: f64,
}

/// How one end of an open piece of ground is held; a force may stand clear of the ground there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum End {
    /// The ground touches the beam: v takes the clearance out and vanishes beyond.
    Edge,
    /// Open ground goes on, with what the clearance jumps by.
    Open { jump: f64, force: f64 },
    /// The layer stops, or there is none; at an end of the beam it may go on, as stiff as it is there.
    Free { stiffness: f64, force: f64 },
}

impl Lifting {
    /// One open piece between its ends.
    pub fn add(&mut self, under: &Under, ends: [End; 2]) {
        let Some(clearance) = Clearance::of(under) else { return };
        let [_, k, mu] = under.bounds();
        let length = 2.0 * under.half;
        if ends.contains(&End::Edge) {
            let (left, middle, right) = (clearance.at(-1.0), clearance.at(0.0), clearance.at(1.0));
            for (end, point) in [(ends[0], left), (ends[1], right)] {
                if end == End::Edge {
                    let found = edge(&clearance, &point, &middle, 0);
                    let off = point.value.abs() + clearance.noise()[0];
                    self.at_edge(under, &found, off);
                    self.deepest = self.deepest.max(-point.value);
                } else {
                    let [a, b] = if point.s < 0.0 { [&point, &middle] } else { [&middle, &point] };
                    self.pierced(depth(&clearance, a, b, 0));
                }
            }
        } else {
            self.pierced(depth_of(&clearance));
        }
        self.current.stiffness += k * length;
        for end in ends {
            match end {
                End::Open { jump, force } => {
                    self.squares[2] += jump * jump * (k * length / 3.0 + mu / length);
                    self.current.moved += jump;
                    self.current.forces += force;
                }
                End::Free { stiffness, force } => {
                    self.current.stiffness += stiffness;
                    self.current.forces += force;
                }
                End::Edge => {}
            }
        }
        if !matches!(ends[1], End::Open { .. }) {
            self.close();
        }
    }

    fn pierced(&mut self, depth: f64) {
        self.current.depth = self.current.depth.max(depth);
    }

    /// v takes out what the clearance is `off` zero at the edge, over its reach; and it rises as the beam
    /// may fall below the ground, up to where the beam has come out again, and falls as much beyond.
    fn at_edge(&mut self, under: &Under, edge: &Edge, off: f64) {
        let [_, k, mu] = under.bounds();
        let (reach, until) = (edge.reach * under.half, edge.until * under.half);
        let fall = edge.fall / under.half;
        self.squares[0] += off * off * (k * reach / 3.0 + mu / reach);
        self.squares[1] += fall * fall * until * (2.0 * mu + 2.0 / 3.0 * k * until * until);
        self.current.stiffness += mu / reach;
        self.current.moved += off + fall * until;
        self.pierced(edge.depth);
    }

    /// The stretch ends here.
    fn close(&mut self) {
        let Stretch { depth, stiffness, forces, moved } = std::mem::take(&mut self.current);
        if depth > 0.0 {
            self.squares[3] += depth * depth * stiffness;
            self.work += forces * depth;
            self.deepest = self.deepest.max(depth);
        }
        self.moved = self.moved.max(moved + depth);
    }

    /// ‖v‖ in the norm of b.
    pub fn norm(&self) -> f64 {
        self.squares.iter().map(|square| square.sqrt()).sum()
    }
}
