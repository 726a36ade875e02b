//! The bonded beam in dual numbers: one solve gives w, φ and u with their derivatives with respect to N parameters.

use super::frame::Frame;
use super::tangent::Tangent;
use crate::chain::elimination::Chain;
use crate::chain::node::Tie;
use crate::contact::bonded::chain_of;
use crate::contact::short_span::bonded_fluxes;
use crate::contact::surface::{SurfacePart, short_parts_of};
use crate::element::ExactElement;
use crate::element::element::{Element, TERMS};
use crate::element::operator::Operator;
use crate::ground::link::{self, TwoPort};
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::free_field::{self, Line};
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::lifted::Rates;
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::{heights, open_links};
use crate::model::Model;
use crate::numeric::dual::Dual;
use crate::numeric::polynomial::derivative;
use crate::numeric::real::Real;
use crate::solution::field::Field;
use crate::solution::fields::{Side, SolutionPiece};

/// The solution of the linearised problem.
#[derive(Debug)]
pub(super) struct Linear<'a, const N: usize> {
    pub frame: &'a Frame<'a>,
    chain: Chain<Dual<N>>,
    /// The four unknowns of each element.
    shapes: Vec<[Dual<N>; 4]>,
    /// The cells on which w is a power series, and the contact zones.
    pub mesh: Mesh<Dual<N>>,
    pub zones: &'a [MeshZone],
    /// Coefficients of w, and of φ if the beam has shear deformation.
    pub deflection: Vec<Dual<N>>,
    pub rotation: Vec<Dual<N>>,
    spans: Vec<Span<N>>,
    moved: Vec<MovedEnd<N>>,
}

/// Steps at the end of a cell, caused by a load that moves with a parameter.
#[derive(Debug, Clone, Copy)]
struct MovedEnd<const N: usize> {
    x: f64,
    right: bool,
    slope: Dual<N>,
    drift: Dual<N>,
}

/// Open ground between two contact zones, or between a zone and the ground outside the beam.
#[derive(Debug)]
struct Span<const N: usize> {
    /// Points at which the span ends at a contact zone; `None` if it includes the ground beyond the run.
    ends: [Option<BeamPoint>; 2],
    /// The two-ports of the span; for a two-port under the beam also its cell and the part of the cell.
    links: Vec<(Option<(usize, [f64; 2])>, TwoPort<Dual<N>>)>,
    /// u − u₀ at both ends, and the forces on the ground at both ends.
    held: [Dual<N>; 2],
    fluxes: [Dual<N>; 2],
}

impl<'a, const N: usize> Linear<'a, N> {
    /// Solves for at most N parameters. `still` has the elements without derivatives. w is computed in the cells marked
    /// in `read` and in the cells whose data have derivatives. `None` if the beam is a mechanism on its contact.
    pub fn solve(
        frame: &'a Frame<'a>,
        still: &[Element],
        read: &[bool],
        tangents: &[Tangent],
    ) -> Option<Self> {
        let by: Vec<&Model> = tangents.iter().map(|tangent| &tangent.model).collect();
        let rates = Rates { model: &frame.model, by: &by };
        let coarse: Mesh<Dual<N>> = frame.mesh.lifted(&rates);
        let exact = |i: usize| {
            let cell = &coarse.cells[i];
            let operator = Operator::of(cell, coarse.axial_force, frame.touch[i]);
            let wanted = read[i] || !operator.is_still();
            wanted.then(|| Box::new(ExactElement::new(&operator, cell.length())))
        };
        let exact: Vec<Option<Box<ExactElement<Dual<N>>>>> = (0..still.len()).map(exact).collect();
        let element = |(exact, still): (&Option<Box<ExactElement<Dual<N>>>>, &Element)| {
            exact.as_ref().map_or_else(|| still.still(), |exact| exact.element)
        };
        let mut elements: Vec<Element<Dual<N>>> = exact.iter().zip(still).map(element).collect();
        let mut jumps: Vec<(usize, [Dual<N>; 4])> = Vec::new();
        let (mut ends, mut parted) = (Vec::new(), Vec::new());
        for (n, moved) in tangents.iter().enumerate().filter_map(|(n, t)| Some((n, t.moved?))) {
            let steps = frame.steps(&moved);
            let right = steps.spot.s > 0.0;
            let element = &mut elements[steps.spot.cell];
            let row = element.rotation_row(right);
            let [sinks, turns] = [false, true].map(|turns| element.moved_end(right, turns));
            let mut jump = [Dual::ZERO; 4];
            for j in 0..4 {
                element.load[j].by[n] += row[j] * steps.moment;
                jump[j].by[n] = sinks[j] * steps.jump[0] + turns[j] * steps.jump[1];
            }
            // The forces are K (v + jump) − q, so the load for the unknowns v of the nodes is q − K jump.
            for (load, row) in element.load.iter_mut().zip(&element.stiffness) {
                for (k, jump) in row.iter().zip(&jump) {
                    *load -= *k * *jump;
                }
            }
            jumps.push((steps.spot.cell, jump));
            let mut end = MovedEnd { x: moved.x, right, slope: Dual::ZERO, drift: Dual::ZERO };
            (end.slope.by[n], end.drift.by[n]) = (steps.slope, steps.drift);
            let links = (end.drift != 0.0).then_some(steps.spot.cell);
            parted.extend(links.map(|cell| (cell, end)));
            ends.push(end);
        }
        let mut chain = chain_of(&coarse, &frame.zones, elements.into_iter());
        for (cell, MovedEnd { right, drift, .. }) in &parted {
            let links = &mut chain.cells[*cell].links;
            let tie = if *right {
                links.last_mut().map(|link| &mut link.right)
            } else {
                links.first_mut().map(|link| &mut link.left)
            };
            if let Some(Tie::Beam { gap, .. }) = tie {
                *gap -= *drift;
            }
        }
        let shapes = chain.solve().ok()?;
        let mut own = shapes.clone();
        for (cell, jump) in &jumps {
            for (v, jump) in own[*cell].iter_mut().zip(jump) {
                *v += *jump;
            }
        }
        let (fine, zones) = match &frame.fine {
            Some((fine, zones)) => (Some(fine.lifted(&rates)), &zones[..]),
            None => (None, &frame.zones[..]),
        };
        let [deflection, rotation] = curves(&coarse, fine.as_ref(), &exact, &own);
        let mesh = fine.unwrap_or(coarse);
        let spans = Vec::new();
        let mut linear =
            Linear { frame, chain, shapes, mesh, zones, deflection, rotation, spans, moved: ends };
        linear.spans = linear.open_spans();
        Some(linear)
    }

    pub fn w(&self) -> Deflection<'_, Dual<N>> {
        Deflection { mesh: &self.mesh, terms: TERMS, coefficients: &self.deflection }
    }

    fn open_spans(&self) -> Vec<Span<N>> {
        let mut spans = Vec::new();
        for run in ground_runs(&self.mesh).iter().filter(|run| run.pasternak) {
            let zones = self.zones.iter().filter(|zone| run.cells.contains(&zone.from.cell));
            let mut left = None;
            for zone in zones {
                spans.push(self.open_span(run, [left, Some(zone.from)]));
                left = Some(zone.to);
            }
            spans.push(self.open_span(run, [left, None]));
        }
        spans
    }

    fn open_span(&self, run: &GroundRun<Dual<N>>, ends: [Option<BeamPoint>; 2]) -> Span<N> {
        let (w, frame) = (self.w(), self.frame);
        let links = open_links(&self.mesh, run, ends[0], ends[1]);
        let whole = links.iter().map(|(_, link)| *link).reduce(TwoPort::then).unwrap_or_default();
        let mut held = ends.map(|end| end.map_or(Dual::ZERO, |end| w.obstacle_at(end)));
        let mut fluxes = bonded_fluxes(&w, ends, &whole);
        for MovedEnd { x, right, drift, .. } in self.moved.iter().filter(|end| end.drift != 0.0) {
            let end = usize::from(*right);
            if ends[end].is_some_and(|point| frame.is_same_node(w.position(point), *x)) {
                held[end] += *drift;
                let mut moved = [Dual::ZERO; 2];
                moved[end] = *drift;
                fluxes[0] += whole.force_left(moved[0], moved[1]);
                fluxes[1] += whole.force_right(moved[0], moved[1]);
            }
        }
        Span { ends, links, held, fluxes }
    }

    /// A field at a position x, on one side of x.
    pub fn field(&self, field: Field, x: f64, side: Side) -> Dual<N> {
        let cells = &self.mesh.cells;
        let i = match side {
            Side::Right => cells.partition_point(|cell| cell.x[1] <= x),
            Side::Left => cells.partition_point(|cell| cell.x[1] < x),
        };
        let i = i.min(cells.len() - 1);
        let s = cells[i].local(x);
        let mut parts = Vec::new();
        short_parts_of(
            &self.mesh,
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

    /// u at a position x outside the beam.
    pub fn settlement_beside(&self, x: f64, tangents: &[Tangent]) -> Dual<N> {
        let l = self.frame.model.beam.length;
        let right = x > l;
        let (end, side, distance) =
            if right { (l, Side::Left, x - l) } else { (0.0, Side::Right, -x) };
        let end = self.field(Field::Settlement, end, side);
        self.on_line(tangents, |line| {
            let own = |distance: f64| free_field::at(line, right, &self.mesh.cells, distance);
            let outside = line.beyond[usize::from(right)];
            link::beside(outside, end - own(0.0), distance) + own(distance)
        })
    }

    /// A function of the ground outside the beam and of the loads on the ground.
    pub fn on_line(
        &self,
        tangents: &[Tangent],
        of: impl FnOnce(&Line<Dual<N>>) -> Dual<N>,
    ) -> Dual<N> {
        let by: Vec<&Model> = tangents.iter().map(|tangent| &tangent.model).collect();
        let rates = Rates { model: &self.frame.model, by: &by };
        let cells = &self.mesh.cells;
        let [left, right] = [cells[0].ground_at(-1.0), cells[cells.len() - 1].ground_at(1.0)];
        let [left, right] = [rates.beyond(false, left), rates.beyond(true, right)];
        let length = self.frame.model.beam.length;
        of(&Line { length, beyond: [&left, &right], loads: &rates.ground_loads() })
    }

    /// u − u₀ at both ends of a cell; `None` if the cell is in contact.
    fn open(&self, cell: usize) -> Option<[Dual<N>; 2]> {
        let holds = |zone: &MeshZone| zone.from.cell <= cell && cell <= zone.to.cell;
        if self.zones.iter().any(|zone| zone.from != zone.to && holds(zone)) {
            return None;
        }
        let under = |span: &Span<N>| {
            let at =
                span.links.iter().position(|(part, _)| part.is_some_and(|(i, _)| i == cell))?;
            let links: Vec<TwoPort<Dual<N>>> = span.links.iter().map(|(_, link)| *link).collect();
            let (heights, _) = heights(&links, span.held);
            Some([heights[at], heights[at + 1]])
        };
        Some(self.spans.iter().find_map(under).unwrap_or([Dual::ZERO; 2]))
    }

    /// Force of the bond at an end of a zone.
    pub fn force_at_edge(&self, zone: usize, side: Side) -> Dual<N> {
        let MeshZone { from, to } = self.zones[zone];
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

    /// μψ' at the end of a zone, without the step of w' that a moving load causes there.
    fn flux(&self, point: BeamPoint) -> Dual<N> {
        let x = self.w().position(point);
        let own = |end: &&MovedEnd<N>| self.frame.is_same_node(end.x, x);
        let steps: Dual<N> = self.moved.iter().filter(own).map(|end| end.slope).sum();
        self.w().flux(point) - self.mesh.cells[point.cell].ground_at(point.s)[1] * steps
    }

    /// Derivatives of the position of an edge that can move.
    pub fn edge(&self, zone: usize, side: Side) -> [f64; N] {
        let MeshZone { from, to } = self.zones[zone];
        let spot = if side == Side::Left { from } else { to };
        let [psi, slope, pressure] = self.w().obstacle_and_pressure(spot);
        if self.mesh.cells[spot.cell].shear_layer.value() == 0.0 {
            // ψ = 0 at the edge: δx = −δψ/ψ'.
            return psi.by.map(|by| -by / slope.value);
        }
        // The point force A is 0 at the edge, and dA = π dx for dx out of the zone.
        let outward = if side == Side::Left { -1.0 } else { 1.0 };
        self.force_at_edge(zone, side).by.map(|by| outward * by / pressure.value)
    }

    /// w and φ of the node at a position.
    pub fn at_node(&self, x: f64) -> [Dual<N>; 2] {
        let spot = self.frame.spot(x, Side::Right);
        let (v, right) = (&self.shapes[spot.cell], spot.s > 0.0);
        let element = &self.chain.cells[spot.cell].element;
        let (row, turned) = (element.end_row(right), element.rotation_row(right));
        let dot = |term: &dyn Fn(usize) -> Dual<N>| (0..4).map(term).sum();
        [dot(&|j| row[j] * v[j]), dot(&|j| v[j] * turned[j])]
    }

    /// Force (positive up) and moment of the constraints at a node: the loads at the node minus the forces taken by
    /// elements and ground.
    pub fn reaction(&self, x: f64) -> [Dual<N>; 2] {
        let node = self.frame.mesh.node_at(x);
        let loads = &self.chain.nodes[node];
        let mut held = [loads.force, loads.moment];
        for (cell, right) in [(node.checked_sub(1), true), (Some(node), false)] {
            let Some(cell) = cell.filter(|cell| *cell < self.shapes.len()) else { continue };
            let element = &self.chain.cells[cell].element;
            let forces = element.forces(&self.shapes[cell]);
            for (held, turns) in held.iter_mut().zip([false, true]) {
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

/// Coefficients of w and φ on a mesh that may be finer than the elements; 0 in cells that are not evaluated.
fn curves<const N: usize>(
    coarse: &Mesh<Dual<N>>,
    fine: Option<&Mesh<Dual<N>>>,
    elements: &[Option<Box<ExactElement<Dual<N>>>>],
    shapes: &[[Dual<N>; 4]],
) -> [Vec<Dual<N>>; 2] {
    let mesh = fine.unwrap_or(coarse);
    let mut deflection = Vec::with_capacity(mesh.cells.len() * TERMS);
    let mut rotation = Vec::new();
    let shears = coarse.cells.iter().any(|cell| cell.beam_shear.is_some());
    let mut element = 0;
    let unfold = |i: usize| Some((elements[i].as_ref()?, elements[i].as_ref()?.unfold(&shapes[i])));
    let mut unfolded = unfold(0);
    for cell in &mesh.cells {
        let middle = 0.5 * (cell.x[0] + cell.x[1]);
        while coarse.cells[element].x[1] < middle {
            element += 1;
            unfolded = unfold(element);
        }
        let Some((exact, unfolded)) = &unfolded else {
            deflection.extend([Dual::ZERO; TERMS]);
            rotation.extend(shears.then_some([Dual::ZERO; TERMS]).iter().flatten());
            continue;
        };
        let c = exact.deflection_on(&coarse.cells[element], cell.x, unfolded);
        deflection.extend_from_slice(&c);
        if shears {
            match exact.rotation(&shapes[element]) {
                Some(own) => rotation.extend_from_slice(&own),
                None => {
                    let mut slope = derivative(&c).at_least(TERMS);
                    slope.iter_mut().for_each(|c| *c *= 2.0 / cell.length());
                    rotation.extend_from_slice(&slope);
                }
            }
        }
    }
    [deflection, rotation]
}
