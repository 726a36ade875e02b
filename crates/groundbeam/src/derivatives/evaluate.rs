//! Computes outputs and their derivatives with respect to parameters from the data and unknowns of the linearised problem.

use super::equilibrium::Span;
use super::linear::Linear;
use super::output::{Follows, Read, Reading};
use super::tangent::Moved;
use crate::contact::surface::{SurfacePart, short_parts_of};
use crate::ground::link::{self, TwoPort};
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::free_field::{self, Line};
use crate::mesh::lifted::Rates;
use crate::mesh::open_ground::heights;
use crate::model::{Model, Support, SupportKind};
use crate::numeric::dual::Dual;
use crate::numeric::polynomial::TERMS;
use crate::numeric::real::Real;
use crate::solution::field::Field;
use crate::solution::fields::{Side, SolutionPiece};

impl<const N: usize> Linear<'_, N> {
    /// Computes the derivatives of an output with respect to the N variables.
    pub fn read(&self, reading: &Reading) -> [f64; N] {
        let frame = self.frame;
        match reading.of {
            Read::Constant => [0.0; N],
            Read::Energy => self.energy(),
            Read::Beside { x } => self.settlement_beside(x).by,
            Read::EdgeForce { zone, side } => self.force_at_edge(zone, side).by,
            Read::Edge { zone, side } if !frame.stays(zone, side) => self.edge(zone, side),
            Read::Edge { zone, side } => {
                let follows = |moved: Moved| frame.edge_follows(zone, side, &moved);
                self.moved_by(|moved| if follows(moved) { 1.0 } else { 0.0 })
            }
            Read::Support { number, moment } => self.support(number, moment),
            Read::Field { field, x, side, follows } => {
                let place = match follows {
                    Follows::Given | Follows::Nothing | Follows::Kink => [0.0; N],
                    Follows::Edge { zone, side, slope } => {
                        self.edge(zone, side).map(|moved| slope * moved)
                    }
                    Follows::Load { slope } => {
                        let here = |moved: Moved| frame.is_same_place(moved.x, x);
                        self.moved_by(|moved| if here(moved) { slope } else { 0.0 })
                    }
                };
                (self.field(field, x, side) + Dual { value: 0.0, by: place }).by
            }
        }
    }

    fn moved_by(&self, of: impl Fn(Moved) -> f64) -> [f64; N] {
        let moved = |n: usize| self.tangents.get(n).and_then(|tangent| tangent.moved);
        std::array::from_fn(|n| moved(n).map_or(0.0, &of))
    }

    fn support(&self, number: usize, moment: bool) -> [f64; N] {
        let support = &self.frame.model.supports[number];
        let [w, rotation] = self.at_node(support.at);
        let [spring, rotational, settlement] = self.numbers_of_support(number);
        match (support.kind, moment) {
            (SupportKind::Spring { .. }, true) => (-rotational * rotation).by,
            (SupportKind::Spring { .. }, false) => (spring * (w - settlement)).by,
            (SupportKind::Pinned, true) => [0.0; N],
            (_, moment) => self.reaction(support.at)[usize::from(moment)].by,
        }
    }

    /// Returns the spring constant, the rotational spring constant and the settlement of a support, with their
    /// derivatives with respect to the parameters.
    pub fn numbers_of_support(&self, number: usize) -> [Dual<N>; 3] {
        let numbers = |model: &Model| match model.supports[number] {
            Support {
                kind: SupportKind::Spring { spring, rotational_spring }, settlement, ..
            } => [spring, rotational_spring, settlement],
            Support { settlement, .. } => [0.0, 0.0, settlement],
        };
        let mut duals = numbers(&self.frame.model).map(Dual::from);
        for (n, tangent) in self.tangents.iter().enumerate() {
            let rates = numbers(&tangent.model);
            duals.iter_mut().zip(rates).for_each(|(dual, rate)| dual.by[n] = rate);
        }
        duals
    }

    /// Computes a field on one side of the position x.
    pub fn field(&self, field: Field, x: f64, side: Side) -> Dual<N> {
        let cells = &self.mesh().cells;
        let i = match side {
            Side::Right => cells.partition_point(|cell| cell.x[1] <= x),
            Side::Left => cells.partition_point(|cell| cell.x[1] < x),
        };
        let i = i.min(cells.len() - 1);
        let s = cells[i].local(x);
        let mut parts = Vec::new();
        short_parts_of(
            self.mesh(),
            &SurfacePart { cell: i, s: [-1.0, 1.0], open: self.open(i) },
            &mut parts,
        );
        let beyond = |part: &SurfacePart<Dual<N>>| match side {
            Side::Right => part.s[1] <= s,
            Side::Left => part.s[1] < s,
        };
        let part = parts.partition_point(beyond).min(parts.len() - 1);
        let own = i * TERMS..(i + 1) * TERMS;
        let rotation = cells[i].beam_shear.and_then(|_| self.rotation.get(own.clone()));
        let piece =
            SolutionPiece::of(&cells[i], &parts[part], &self.deflection[own], rotation, true);
        piece.one(field, piece.local(x))
    }

    /// Computes the ground displacement u at a position x outside the beam.
    pub fn settlement_beside(&self, x: f64) -> Dual<N> {
        let l = self.frame.model.beam.length;
        let right = x > l;
        let (end, side, distance) =
            if right { (l, Side::Left, x - l) } else { (0.0, Side::Right, -x) };
        let end = self.field(Field::Settlement, end, side);
        self.on_line(|line| {
            let own = |distance: f64| free_field::at(line, right, &self.mesh().cells, distance);
            let outside = line.beyond[usize::from(right)];
            link::beside(outside, end - own(0.0), distance) + own(distance)
        })
    }

    /// Evaluates a function of the ground outside the beam and of the loads on the ground.
    pub fn on_line(&self, of: impl FnOnce(&Line<Dual<N>>) -> Dual<N>) -> Dual<N> {
        let by: Vec<&Model> = self.tangents.iter().map(|tangent| &tangent.model).collect();
        let rates = Rates { model: &self.frame.model, by: &by, reach: [0.0; 2] };
        let cells = &self.mesh().cells;
        let [left, right] = [cells[0].ground_at(-1.0), cells[cells.len() - 1].ground_at(1.0)];
        let [left, right] = [rates.beyond(false, left), rates.beyond(true, right)];
        let length = self.frame.model.beam.length;
        of(&Line { length, beyond: [&left, &right], loads: &rates.ground_loads() })
    }

    /// Computes the ground displacement u minus the free field u₀ at both ends of a cell. Returns `None` if the cell
    /// is in contact.
    fn open(&self, cell: usize) -> Option<[Dual<N>; 2]> {
        let holds = |zone: &MeshZone| zone.from.cell <= cell && cell <= zone.to.cell;
        if self.zones().iter().any(|zone| zone.from != zone.to && holds(zone)) {
            return None;
        }
        let under = |span: &Span<Dual<N>>| {
            let at =
                span.links.iter().position(|(part, _)| part.is_some_and(|(i, _)| i == cell))?;
            let links: Vec<TwoPort<Dual<N>>> = span.links.iter().map(|(_, link)| *link).collect();
            let (heights, _) = heights(&links, span.held);
            Some([heights[at], heights[at + 1]])
        };
        Some(self.spans.iter().find_map(under).unwrap_or([Dual::ZERO; 2]))
    }

    /// Computes the concentrated force between the bonded beam and the ground at an end of a contact zone.
    pub fn force_at_edge(&self, zone: usize, side: Side) -> Dual<N> {
        let MeshZone { from, to } = self.zones()[zone];
        let taken = |point: BeamPoint, end: usize| -> Dual<N> {
            let own = self.spans.iter().find(|span| span.ends[end] == Some(point));
            own.map_or(Dual::ZERO, |span| span.fluxes[end])
        };
        match side {
            _ if from == to => taken(from, 1) + taken(to, 0),
            Side::Left => taken(from, 1) - self.flux(from),
            Side::Right => taken(to, 0) + self.flux(to),
        }
    }

    /// Computes μψ' at an end of a contact zone (obstacle ψ, shear layer μ), without the jump of w' that represents a
    /// moving load.
    fn flux(&self, point: BeamPoint) -> Dual<N> {
        let x = self.w().position(point);
        let steps = self.moved_at(x, |steps| steps.slope);
        self.w().flux(point) - self.mesh().cells[point.cell].ground_at(point.s)[1] * steps
    }

    /// Computes the derivatives of the position of a movable contact edge with respect to the parameters.
    pub fn edge(&self, zone: usize, side: Side) -> [f64; N] {
        let MeshZone { from, to } = self.zones()[zone];
        let spot = if side == Side::Left { from } else { to };
        let [psi, slope, pressure] = self.w().obstacle_and_pressure(spot);
        if self.mesh().cells[spot.cell].shear_layer.value() == 0.0 {
            // The edge stays at a zero of the obstacle ψ, so a change δψ moves the edge by −δψ/ψ'.
            return psi.by.map(|by| -by / slope.value);
        }
        // At a fixed edge, a change of a parameter causes a concentrated force dA. The true edge has no such force, and
        // moves outward by dA/π with the pressure π.
        let outward = if side == Side::Left { -1.0 } else { 1.0 };
        self.force_at_edge(zone, side).by.map(|by| outward * by / pressure.value)
    }

    /// Returns the deflection w and the rotation φ of the beam at the node at `x`.
    pub fn at_node(&self, x: f64) -> [Dual<N>; 2] {
        let spot = self.frame.spot(x, Side::Right);
        let (v, right) = (&self.shapes[spot.cell], spot.s > 0.0);
        let element = &self.equilibrium.elements[spot.cell];
        let dot = |row: [f64; 4]| (0..4).map(|j| v[j] * row[j]).sum();
        [dot(element.end_row(right)), dot(element.rotation_row(right))]
    }

    /// Computes the reactions of the constraints at a node: a force (positive up) and a moment. They balance the loads
    /// at the node and the forces of the elements and of the ground.
    pub fn reaction(&self, x: f64) -> [Dual<N>; 2] {
        let mut held = [Dual::ZERO; 2];
        for (cell, right) in self.beside(self.frame.mesh.node_at(x)) {
            let element = self.element(cell);
            let (forces, loads) =
                (element.forces(&self.own_shape(cell)), self.end_loads(cell, right));
            for ((held, load), turns) in held.iter_mut().zip(loads).zip([false, true]) {
                *held += load;
                for (force, part) in forces.iter().zip(element.moved_end(right, turns)) {
                    *held -= *force * part;
                }
            }
        }
        let w = self.w();
        let here = |point: BeamPoint| self.frame.is_same_node(w.position(point), x);
        for span in &self.spans {
            for (end, flux) in span.ends.iter().zip(span.fluxes) {
                if end.is_some_and(here) {
                    held[0] -= flux;
                }
            }
        }
        [held[0], -held[1]]
    }
}
