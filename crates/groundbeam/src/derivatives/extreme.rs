//! Extremes of a field, and the derivative of their place.

use super::change::{Against, Change};
use super::linearised::Linearised;
use super::output::Functional;
use crate::derivatives::{NotDifferentiable, Quantity, Side, Solution};
use crate::model::Load;
use crate::numeric::elementary::power;
use crate::numeric::polynomial::{derivative, jet, value};
use crate::numeric::tolerance::{OTHER_EXTREME, TURNING_POINT};

/// The place of an extreme.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub x: f64,
    /// The side from which the field has the value there.
    pub side: Side,
    pub value: f64,
    /// The field's derivative by x there; 0 where it is stationary.
    pub slope: f64,
    /// Whether it is so whatever changes: the gap where they touch, the pressure where they do not.
    pub always: bool,
    /// Another place at which it is as large.
    pub rival: Option<f64>,
}

/// A field is as large elsewhere if it differs by no more than this part of its size.
const SAME: f64 = 1e-7;

impl Linearised {
    /// Whether one end of one load is all that stands at a place inside the beam.
    pub fn stands_alone(&self, x: f64) -> bool {
        let (model, node) = (&self.model, self.mesh.node_at(x));
        let here = |x: f64| self.mesh.node_at(x) == node;
        let begins_or_ends = |load: &&Load| load.extent.ends().into_iter().any(here);
        let loads = model.loads.iter().filter(begins_or_ends).count();
        let segments = model.beam.segments.iter().map(|s| [s.from, s.to]);
        let segments = segments.chain(model.foundation.segments.iter().map(|s| [s.from, s.to]));
        let others = segments.flatten().chain(model.supports.iter().map(|s| s.at));
        let others = others.chain(model.hinges.iter().map(|h| h.at));
        let mut others = others.chain(model.gap.iter().map(|g| g.at));
        let l = model.beam.length;
        loads == 1 && x > 0.0 && x < l && !others.any(|x| x >= 0.0 && x <= l && here(x))
    }
}

impl Linearised {
    /// The edge of contact at a position, if it can move and the field kinks there for its sake: at a load, a support or a
    /// hinge it kinks anyway.
    pub fn edge_at(&self, x: f64) -> Option<Functional> {
        let own = self.mesh.nodes[self.mesh.node_at(x)];
        let loaded = own.force != 0.0 || own.moment != 0.0;
        let held = own.pinned || own.spring != 0.0 || own.rotational_spring != 0.0;
        if loaded || held || own.hinge.is_some() {
            return None;
        }
        let at = |side| self.zone_at(x, side).map(|zone| self.edge(zone, side));
        let edges = [Side::Left, Side::Right].map(at).into_iter().flatten();
        edges.into_iter().find(|edge| !edge.push.is_empty())
    }

    /// How far an extreme follows a load. Alone at its place a load takes the kink with it; what else stands there
    /// stays, and so do the beam's ends.
    pub fn follows(&self, place: &Place, change: &Change) -> f64 {
        let node = self.mesh.node_at(place.x);
        let own = change.moves.is_some_and(|x| self.mesh.node_at(x) == node);
        if own && place.slope != 0.0 && self.stands_alone(place.x) { 1.0 } else { 0.0 }
    }

    /// Where what moves leaves something else behind that stands at the same place, and a new piece of the field begins
    /// between the two.
    pub fn leaves_others(&self, field: Quantity, place: &Place, change: &Change) -> Option<f64> {
        let x = change.moves.filter(|x| !self.stands_alone(*x))?;
        let here = self.mesh.node_at(x) == self.mesh.node_at(place.x);
        let kinks = self.shear_stiffness_at(self.spot(x, Side::Left)).is_some()
            || self.shear_stiffness_at(self.spot(x, Side::Right)).is_some();
        let smooth =
            !kinks && matches!(field, Quantity::Deflection | Quantity::Settlement | Quantity::Gap);
        let tears = change.points.iter().any(|point| match point.against {
            Against::SlopeBeside => self.steps(field, x),
            Against::BendBeside => {
                matches!(field, Quantity::Moment | Quantity::ShearForce | Quantity::Pressure)
            }
            _ => false,
        });
        (tears || here && !smooth && place.slope != 0.0).then_some(x)
    }
}

impl Solution {
    /// Where a field is largest, or smallest.
    pub(super) fn extreme(&self, field: Quantity, largest: bool) -> Place {
        let sign = if largest { 1.0 } else { -1.0 };
        let mut best: Option<(usize, f64, f64)> = None;
        let mut all: Vec<(f64, f64)> = Vec::new();
        for (i, piece) in self.pieces().iter().enumerate() {
            for s in piece.candidates(field) {
                let value = piece.fields(s).get(field);
                all.push((piece.global(s), value));
                if best.is_none_or(|(_, _, best)| sign * value > sign * best) {
                    best = Some((i, s, value));
                }
            }
        }
        let Some((i, s, value)) = best else {
            let (x, side) = (0.0, Side::Right);
            return Place { x, side, value: 0.0, slope: 0.0, always: true, rival: None };
        };
        let (x, l) = (self.pieces()[i].global(s), self.model().beam.length);
        let size = all.iter().map(|(_, value)| value.abs()).fold(0.0, f64::max);
        // Where they touch the gap is zero and where they do not the pressure is, whatever the parameters are.
        let touches = self.contact().iter().any(|region| region.from <= x && x <= region.to);
        let closed = field == Quantity::Gap && !largest && touches;
        let always = closed || value == 0.0 && matches!(field, Quantity::Gap | Quantity::Pressure);
        let rival = all
            .iter()
            .filter(|_| !always)
            .filter(|(at, other)| {
                (at - x).abs() > OTHER_EXTREME * l && (other - value).abs() <= SAME * size
            })
            .map(|(at, _)| *at)
            .next();
        // A turning point may be an end but for rounding.
        let end = self.pieces()[i].x[usize::from(s > 0.0)];
        let x = if (x - end).abs() <= TURNING_POINT * l { end } else { x };
        let side = if s > 0.0 { Side::Left } else { Side::Right };
        let slope = if s.abs() < 1.0 || always { 0.0 } else { self.rise(i, s, field) };
        Place { x, side, value, slope, always, rival }
    }

    /// The derivative of a field by x on a piece.
    fn rise(&self, i: usize, s: f64, field: Quantity) -> f64 {
        let piece = &self.pieces()[i];
        let half = piece.half;
        let fields = piece.fields(s);
        let moments = |order: usize| {
            let c = (0..order).fold(piece.moment, |c, _| derivative(&c));
            value(&c, s) / power(half, order)
        };
        let settles = || piece.settlement(s, fields.deflection, fields.slope)[1];
        match field {
            Quantity::Deflection => fields.slope,
            Quantity::Rotation if !piece.rotation.is_empty() => jet(&piece.rotation, s)[1] / half,
            Quantity::Slope | Quantity::Rotation => jet(&piece.deflection, s)[2] / (half * half),
            Quantity::Moment => fields.shear_force,
            Quantity::ShearForce => moments(2),
            Quantity::Settlement => settles(),
            Quantity::Gap if piece.open.is_none() => 0.0,
            Quantity::Gap => settles() + piece.cell.gap_slope - fields.slope,
            Quantity::Pressure => jet(&piece.pressure, s)[1] / half,
        }
    }

    /// How the place of an extreme moves that is not stationary there: with an edge of contact, or with a load.
    pub(super) fn moves(
        &self,
        lin: &Linearised,
        place: &Place,
        changes: &[Change],
    ) -> Result<Vec<f64>, NotDifferentiable> {
        if place.slope == 0.0 {
            return Ok(vec![0.0; changes.len()]);
        }
        if let Some(edge) = lin.edge_at(place.x) {
            let rates = self.rates(lin, &edge, changes)?;
            return Ok(rates.into_iter().map(|rate| rate.value).collect());
        }
        Ok(changes.iter().map(|change| lin.follows(place, change)).collect())
    }
}
