//! Outputs: numbers of a solution, each with the dual load that gives it.

use super::change::Change;
use super::field::Point;
use super::linearised::Linearised;
use super::push::Push;
use crate::contact::surface::can_carry;
use crate::element::operator::ZoneKind;
use crate::mesh::deflection::BeamPoint;
use crate::model::SupportKind;
use crate::numeric::polynomial::jet;
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;

/// A number of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Output {
    /// A field at a position of the beam \[m\], seen from a side; the position stays where it is.
    Value(Quantity, f64, Side),
    /// The smallest value of a field on the beam, wherever that is.
    Smallest(Quantity),
    /// The largest.
    Largest(Quantity),
    /// The position of an end of a region of contact \[m\], counted from 0 as in
    /// [`Solution::contact`](crate::Solution::contact).
    Edge(usize, Side),
    /// p₀ or p_l \[N\].
    EndForce(Side),
    /// The force of a support, up \[N\].
    SupportForce(usize),
    /// The moment of a support, as it turns the beam's right side down \[N·m\].
    SupportMoment(usize),
    /// The energy that is least: ½∫(EI (w″ − κ₀)² + P w'²) + ½b(u, u) + springs − F(w) \[N·m\].
    PotentialEnergy,
}

/// An output as a functional of beam and ground: j(y), linear, and what of it depends on parameters itself.
#[derive(Debug, Clone, Default)]
pub(super) struct Functional {
    pub push: Push,
    /// Terms that name a property of the model themselves.
    terms: Vec<Term>,
    /// At which field it looks, where, and from which side.
    pub looks: Option<(Quantity, f64, Side)>,
}

/// A term weight·(…) of a functional at an end of an element.
#[derive(Debug, Clone, Copy)]
struct Term {
    what: What,
    spot: BeamPoint,
    weight: f64,
}

#[derive(Debug, Clone, Copy)]
enum What {
    /// (S + N) w' − Sφ − T, where the beam shears.
    Slope,
    /// μψ', where ψ = w − g₀.
    GroundFlux,
    /// ψ itself, and ψ in the air.
    Obstacle,
    /// A force on the ground.
    GroundForce,
    /// P w'.
    AxialPull,
    /// g.
    SpreadMoment,
    /// kψ − (μψ')'.
    Pressure,
    /// k_s (w − δ) of the support with a number.
    Spring(usize),
    /// k_φ φ of one.
    RotationalSpring(usize),
}

impl Linearised {
    /// Adds weight·w at a spot.
    pub fn read_deflection(&self, functional: &mut Functional, spot: BeamPoint, weight: f64) {
        let (element, row) = self.deflection_row(spot);
        functional.push.loads.push((element, row.map(|r| r * weight)));
    }

    /// Adds weight·φ.
    pub fn read_rotation(&self, functional: &mut Functional, spot: BeamPoint, weight: f64) {
        let (element, row) = self.rotation_row(spot);
        functional.push.loads.push((element, row.map(|r| r * weight)));
    }

    /// Adds weight·w': φ, or where the beam shears what (S + N) w' = Sφ + T makes of it, T = S (w' − φ) + N w' being the
    /// vertical force, with what the ground takes along where it touches, N = P + μ there.
    pub fn read_slope(&self, functional: &mut Functional, spot: BeamPoint, weight: f64) {
        let Some([shear, _]) = self.shear_stiffness_at(spot) else {
            return self.read_rotation(functional, spot, weight);
        };
        let part = weight / (shear + self.tension_at(spot));
        self.read_rotation(functional, spot, part * shear);
        self.read_pull(functional, spot, part);
        functional.terms.push(Term { what: What::Slope, spot, weight: part });
    }

    /// N.
    pub fn tension_at(&self, spot: BeamPoint) -> f64 {
        let touches = self.pieces[self.piece_at(spot)].touch == ZoneKind::Contact;
        let [_, mu] = self.mesh.cells[spot.cell].ground_at(spot.s);
        self.model.beam.axial_force + if touches { mu } else { 0.0 }
    }

    /// Adds weight·M: what the element demands of an end that turns.
    pub fn read_moment(&self, functional: &mut Functional, spot: BeamPoint, weight: f64) {
        let sign = if spot.s > 0.0 { -weight } else { weight };
        let jump = self.moved_end(spot, true).map(|v| sign * v);
        functional.push.jumps.push((spot.cell, jump));
    }

    /// Adds weight·(V + N w' − G), with what the ground takes along where it touches.
    fn read_pull(&self, functional: &mut Functional, spot: BeamPoint, weight: f64) {
        let sign = if spot.s > 0.0 { weight } else { -weight };
        let jump = self.moved_end(spot, false).map(|v| sign * v);
        functional.push.jumps.push((spot.cell, jump));
    }

    /// Adds weight·μψ'.
    fn read_flux(&self, functional: &mut Functional, spot: BeamPoint, weight: f64) {
        let [_, mu] = self.mesh.cells[spot.cell].ground_at(spot.s);
        self.read_slope(functional, spot, weight * mu);
        functional.terms.push(Term { what: What::GroundFlux, spot, weight });
    }

    /// A field at a position that is a node.
    pub fn field_at(&self, quantity: Quantity, x: f64, side: Side) -> Functional {
        let spot = self.spot(x, side);
        let cell = self.mesh.cells[spot.cell];
        let touches = self.pieces[self.piece_at(spot)].touch == ZoneKind::Contact;
        let mut f = Functional { looks: Some((quantity, x, side)), ..Functional::default() };
        match quantity {
            Quantity::Deflection => self.read_deflection(&mut f, spot, 1.0),
            Quantity::Slope => self.read_slope(&mut f, spot, 1.0),
            Quantity::Rotation => self.read_rotation(&mut f, spot, 1.0),
            Quantity::Moment => self.read_moment(&mut f, spot, 1.0),
            Quantity::ShearForce => {
                let axial = self.model.beam.axial_force;
                self.read_pull(&mut f, spot, 1.0);
                self.read_slope(&mut f, spot, -axial);
                f.terms.push(Term { what: What::AxialPull, spot, weight: -1.0 });
                f.terms.push(Term { what: What::SpreadMoment, spot, weight: 1.0 });
                if touches {
                    self.read_flux(&mut f, spot, -1.0);
                }
            }
            Quantity::Settlement if touches => {
                self.read_deflection(&mut f, spot, 1.0);
                f.terms.push(Term { what: What::Obstacle, spot, weight: 1.0 });
            }
            Quantity::Settlement => self.read_ground(&mut f, spot, 1.0),
            Quantity::Gap if touches => {}
            Quantity::Gap => {
                self.read_deflection(&mut f, spot, -1.0);
                f.terms.push(Term { what: What::Obstacle, spot, weight: -1.0 });
                self.read_ground(&mut f, spot, 1.0);
            }
            Quantity::Pressure if touches => {
                // kψ − μ'ψ' − μ w″ with w″ = κ₀ − M/EI; where the beam shears with
                // (S + N) w″ = kψ − μ'ψ' − f − S' (w' − φ) + S (κ₀ − M/EI).
                let [k, mu, rise] = cell.ground_rising_at(spot.s);
                let rise = rise * 2.0 / cell.length();
                let mut bent = mu;
                let mut kept = 1.0;
                if let Some([shear, grows]) = self.shear_stiffness_at(spot) {
                    let part = mu / (shear + self.tension_at(spot));
                    (bent, kept) = (part * shear, 1.0 - part);
                    self.read_slope(&mut f, spot, part * grows);
                    self.read_rotation(&mut f, spot, -part * grows);
                }
                self.read_deflection(&mut f, spot, kept * k);
                self.read_slope(&mut f, spot, -kept * rise);
                self.read_moment(&mut f, spot, bent / self.stiffness_at(spot));
                f.terms.push(Term { what: What::Pressure, spot, weight: 1.0 });
            }
            Quantity::Pressure => {}
        }
        f
    }

    /// Adds weight·u of open ground at a node: a force there, which the ground hands on to where it is held.
    pub fn read_ground(&self, f: &mut Functional, spot: BeamPoint, weight: f64) {
        let piece = self.piece_at(spot);
        for (j, joint) in self.joints.iter().enumerate() {
            let strip = joint.strips.iter().position(|strip| *strip == Some(piece));
            if let Some(strip) = strip {
                self.read_height(f, j, strip + usize::from(spot.s > 0.0), weight);
            }
        }
    }

    /// The same at the start of a strip of a joint, or at its very end.
    pub fn read_height(&self, f: &mut Functional, j: usize, strip: usize, weight: f64) {
        let joint = &self.joints[j];
        if strip > 0 && strip < joint.strips.len() {
            f.push.on_ground.push((j, strip, weight));
        } else if let Some(spot) = joint.ends[usize::from(strip > 0)] {
            // Where ground and beam meet, what holds the one holds the other.
            self.read_deflection(f, spot, weight);
            f.terms.push(Term { what: What::Obstacle, spot, weight });
        }
    }

    /// The concentrated force at an end of a zone: the force that the bond would carry there.
    pub fn force_at_edge(&self, zone: usize, side: Side) -> Functional {
        let mut f = Functional::default();
        let zone = self.zones[zone];
        let spot = if side == Side::Left { zone.from } else { zone.to };
        for (j, joint) in self.joints.iter().enumerate() {
            if side == Side::Left && joint.ends[1] == Some(spot)
                || zone.from == zone.to && joint.ends[1] == Some(spot)
            {
                f.push.parted.push((j, [0.0, 1.0]));
            }
            if side == Side::Right && joint.ends[0] == Some(spot)
                || zone.from == zone.to && joint.ends[0] == Some(spot)
            {
                f.push.parted.push((j, [1.0, 0.0]));
            }
        }
        f.terms.push(Term { what: What::GroundForce, spot, weight: -1.0 });
        if zone.from != zone.to {
            self.read_flux(&mut f, spot, if side == Side::Left { -1.0 } else { 1.0 });
        }
        f
    }

    /// The zone that begins, or ends, at a position.
    pub fn zone_at(&self, x: f64, side: Side) -> Option<usize> {
        let node = self.mesh.node_at(x);
        self.zones.iter().position(|zone| {
            let spot = if side == Side::Left { zone.from } else { zone.to };
            spot.cell + usize::from(spot.s > 0.0) == node
        })
    }

    /// The position of an edge of contact. Nothing where it stays where it is.
    pub fn edge(&self, zone: usize, side: Side) -> Functional {
        let Some(ends) = self.zones.get(zone) else { return Functional::default() };
        let spot = if side == Side::Left { ends.from } else { ends.to };
        if ends.from == ends.to || self.stays(spot) {
            return Functional::default();
        }
        let point = self.look(&self.state, spot, true);
        let [k, mu, rise] = self.mesh.cells[spot.cell].ground_rising_at(spot.s);
        if mu == 0.0 {
            // ψ = 0 there: δx = −δψ/ψ'.
            let mut f = Functional::default();
            let weight = -1.0 / point.rise;
            self.read_deflection(&mut f, spot, weight);
            f.terms.push(Term { what: What::Obstacle, spot, weight });
            return f;
        }
        // A = 0 there, and dA = π dx out of the zone.
        let piece = self.piece_at(spot);
        let rising = rise / self.pieces[piece].half * self.part_of_cell(piece);
        let pressure = k * point.u
            - rising * point.rise
            - mu * self.second_rise(piece, spot)
            - self.ground_load(spot);
        let mut f = self.force_at_edge(zone, side);
        f.scale(if side == Side::Left { -1.0 } else { 1.0 } / pressure);
        f
    }

    /// How much of its cell a piece is.
    fn part_of_cell(&self, piece: usize) -> f64 {
        2.0 * self.pieces[piece].half / self.mesh.cells[self.pieces[piece].element].length()
    }

    /// w″ of the solution.
    fn second_rise(&self, piece: usize, spot: BeamPoint) -> f64 {
        let [_, _, bend, _] = jet(&self.state.curves[piece][0], spot.s);
        bend / (self.pieces[piece].half * self.pieces[piece].half)
    }

    fn ground_load(&self, spot: BeamPoint) -> f64 {
        let [left, right] = self.mesh.cells[spot.cell].ground_load;
        if spot.s > 0.0 { right } else { left }
    }

    /// Whether an edge of contact cannot move: where a force may stand, and where separate springs end that press.
    pub fn stays(&self, spot: BeamPoint) -> bool {
        let cells = &self.mesh.cells;
        if cells[spot.cell].shear_layer > 0.0 {
            return can_carry(&self.mesh, spot);
        }
        let node = spot.cell + usize::from(spot.s > 0.0);
        node == 0 || node == cells.len() || {
            cells[node - 1].shear_layer > 0.0 || cells[node].shear_layer > 0.0
        }
    }

    /// p₀ or p_l.
    pub fn end_force(&self, side: Side) -> Functional {
        let x = if side == Side::Left { 0.0 } else { self.model.beam.length };
        let layered = self.mesh.cells[self.spot(x, Side::Right).cell].shear_layer > 0.0;
        match self.zone_at(x, side) {
            Some(zone) if layered => self.force_at_edge(zone, side),
            _ => Functional::default(),
        }
    }

    /// The force or the moment of a support.
    pub fn support(&self, number: usize, moment: bool) -> Functional {
        let mut f = Functional::default();
        let Some(support) = self.model.supports.get(number) else { return f };
        let node = self.mesh.node_at(support.at);
        let spot = self.spot(support.at, Side::Right);
        match (support.kind, moment) {
            (SupportKind::Pinned, true) => {}
            (SupportKind::Pinned | SupportKind::Fixed, false) => f.push.settled.push((node, 1.0)),
            (SupportKind::Fixed, true) => {
                // The support turns by −1, and both ends of the beam with it.
                let sides = [Side::Left, Side::Right].map(|side| self.spot(support.at, side));
                for spot in sides.into_iter().take(if sides[0] == sides[1] { 1 } else { 2 }) {
                    f.push.jumps.push((spot.cell, self.moved_end(spot, true)));
                }
            }
            (SupportKind::Spring { spring, .. }, false) => {
                self.read_deflection(&mut f, spot, spring);
                f.terms.push(Term { what: What::Spring(number), spot, weight: 1.0 });
            }
            (SupportKind::Spring { rotational_spring, .. }, true) => {
                self.read_rotation(&mut f, spot, -rotational_spring);
                f.terms.push(Term { what: What::RotationalSpring(number), spot, weight: -1.0 });
            }
        }
        f
    }

    /// What a parameter changes in the functional itself, y being the solution.
    pub fn direct(&self, functional: &Functional, change: &Change) -> f64 {
        functional.terms.iter().map(|term| term.weight * self.term(term, change)).sum()
    }

    fn term(&self, term: &Term, change: &Change) -> f64 {
        let spot = term.spot;
        let i = self.piece_at(spot);
        let piece = &self.pieces[i];
        let rates = change.at(&self.model, piece, spot.s);
        let y: Point = self.look(&self.state, spot, true);
        let [k, mu, by_s] = piece.cell.ground_rising_at(spot.s);
        let rise = by_s / piece.half;
        let spring = |number: usize| {
            use super::parameter::SupportNumber::{RotationalSpring, Settlement, Spring};
            let (own, what) = change.support?;
            let support = self.model.supports.get(number).filter(|_| own == number)?;
            let SupportKind::Spring { spring, .. } = support.kind else { return None };
            Some(match (what, term.what) {
                (Settlement, What::Spring(_)) => -spring,
                (Spring, What::Spring(_)) => y.w - support.settlement,
                (RotationalSpring, What::RotationalSpring(_)) => y.rotation,
                _ => 0.0,
            })
        };
        let touches = piece.touch == ZoneKind::Contact;
        match term.what {
            What::Slope => {
                let shear = self.shear_stiffness_at(spot).map_or(0.0, |[shear, _]| shear);
                let flux =
                    if touches { mu * (rates.gap_slope - rates.shear * y.rise) } else { 0.0 };
                flux - rates.axial * y.slope - rates.shear_stiffness * shear * y.strain
            }
            What::GroundFlux => rates.shear * mu * y.rise - mu * rates.gap_slope,
            What::Obstacle => -rates.gap,
            What::GroundForce => {
                let node = spot.cell + usize::from(spot.s > 0.0);
                let here = |x: f64| {
                    x >= 0.0 && x <= self.model.beam.length && self.mesh.node_at(x) == node
                };
                change.forces_on_ground().filter(|(x, _)| here(*x)).map(|(_, force)| force).sum()
            }
            What::AxialPull => rates.axial * y.slope,
            What::SpreadMoment => rates.moment,
            What::Pressure => {
                let bend = self.second_rise(i, spot);
                let carried = k * (rates.spring * y.u - rates.gap) - rates.shear * rise * y.rise
                    + rise * rates.gap_slope;
                let pressed = carried - rates.shear * mu * bend - rates.ground;
                let curls = rates.curvature - rates.stiffness * y.bend;
                let Some([shear, grows]) = self.shear_stiffness_at(spot) else {
                    return pressed - mu * curls;
                };
                // w″ by its own equation, where the beam shears.
                let turns = y.bend + self.pieces[i].cell.curvature[usize::from(spot.s > 0.0)];
                let sheared = shear * (turns - bend) - grows * y.strain;
                let stretched = (rates.axial + rates.shear * mu) * bend;
                let pushed = carried - rates.force - rates.ground + shear * curls - stretched
                    + rates.shear_stiffness * sheared;
                pressed - mu / (shear + self.tension_at(spot)) * pushed
            }
            What::Spring(number) | What::RotationalSpring(number) => spring(number).unwrap_or(0.0),
        }
    }
}

impl Functional {
    pub fn scale(&mut self, factor: f64) {
        let push = &mut self.push;
        for (_, row) in push.loads.iter_mut().chain(&mut push.jumps) {
            *row = row.map(|r| r * factor);
        }
        for (_, jump) in &mut push.parted {
            *jump = jump.map(|r| r * factor);
        }
        for term in &mut self.terms {
            term.weight *= factor;
        }
    }
}
