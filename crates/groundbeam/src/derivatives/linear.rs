//! The linearised problem: the data of the beam bonded on its contact and its unknowns, with derivatives in dual numbers.
//!
//! The residual of the equations at fixed unknowns gives the loads of each parameter. The fields at fixed data give the
//! loads of each output. The stiffness is symmetric, so either list of loads can be solved for.

use super::frame::Frame;
use super::output::{Follows, Read, Reading};
use super::tangent::Tangent;
use crate::chain::elimination::Chain;
use crate::chain::node::Tie;
use crate::contact::bonded::chain_of;
use crate::contact::short_span::bonded_fluxes;
use crate::contact::surface::{SurfacePart, short_parts_of};
use crate::element::ExactElement;
use crate::element::element::{Element, TERMS};
use crate::element::operator::{Operator, ZoneKind};
use crate::ground::link::{self, TwoPort};
use crate::mesh::cell::{Cell, gap_at};
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::free_field::{self, Line};
use crate::mesh::ground_runs::ground_runs;
use crate::mesh::lifted::Rates;
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::{heights, open_links};
use crate::model::Model;
use crate::numeric::dual::Dual;
use crate::numeric::polynomial::derivative;
use crate::numeric::real::Real;
use crate::solution::field::Field;
use crate::solution::fields::{Side, SolutionPiece};
use std::collections::BTreeSet;
use std::ops::Range;

/// The bonded beam in equilibrium, without derivatives.
#[derive(Debug)]
pub(super) struct Equilibrium<'a> {
    pub frame: &'a Frame<'a>,
    elements: Vec<Element>,
    /// The four unknowns of each element.
    shapes: Vec<[f64; 4]>,
    /// Coefficients of w, and of φ if the beam has shear deformation, on the mesh of power series.
    pub deflection: Vec<f64>,
    pub rotation: Vec<f64>,
    /// Open ground on the mesh of elements.
    spans: Vec<Span<f64>>,
    /// The equations without loads.
    chain: Chain,
}

/// Loads on the four unknowns of some elements.
pub(super) type Loads<T> = Vec<(usize, [T; 4])>;

impl<'a> Equilibrium<'a> {
    /// `None` if the beam is a mechanism on its contact.
    pub fn at(frame: &'a Frame<'a>) -> Option<Self> {
        let mesh = &frame.mesh;
        let element = |(cell, touch)| {
            ExactElement::new(&Operator::of(cell, mesh.axial_force, touch), cell.length())
        };
        let cells = mesh.cells.iter().zip(frame.touch.iter().copied());
        let exact: Vec<ExactElement> = cells.map(element).collect();
        let elements: Vec<Element> = exact.iter().map(|exact| exact.element).collect();
        let mut chain = chain_of(mesh, &frame.zones, elements.iter().copied());
        let shapes = chain.solve().ok()?;
        let series = frame.series().0;
        let [mut deflection, mut rotation] = [const { Vec::new() }; 2];
        let shears = frame.model.beam.shears();
        for (i, exact) in exact.iter().enumerate() {
            for cell in frame.series_of(i) {
                let cells = [&mesh.cells[i], &series.cells[cell]];
                let [w, turned] = curves(cells, exact, &shapes[i], shears);
                deflection.extend(w);
                rotation.extend(turned);
            }
        }
        for node in &mut chain.nodes {
            (node.force, node.moment, node.settlement, node.gap) = (0.0, 0.0, 0.0, 0.0);
        }
        for cell in &mut chain.cells {
            cell.element.load = [0.0; 4];
            for tie in cell.links.iter_mut().flat_map(|link| [&mut link.left, &mut link.right]) {
                if let Tie::Beam { gap, .. } = tie {
                    *gap = 0.0;
                }
            }
        }
        let spans = Span::all(mesh, &frame.zones);
        Some(Equilibrium { frame, elements, shapes, deflection, rotation, spans, chain })
    }

    /// The unknowns of all elements under given loads alone.
    pub fn displaced(
        &self,
        loads: impl Iterator<Item = (usize, [f64; 4])>,
    ) -> Option<Vec<[f64; 4]>> {
        let mut chain = self.chain.clone();
        for (cell, load) in loads {
            let own = &mut chain.cells[cell].element.load;
            own.iter_mut().zip(load).for_each(|(own, load)| *own += load);
        }
        chain.solve().ok()
    }

    /// w and the rotations on both sides of a node.
    fn at_node(&self, node: usize) -> [f64; 3] {
        let cells = [node.saturating_sub(1), node.min(self.shapes.len() - 1)];
        let at = |i: usize, row: [f64; 4]| (0..4).map(|j| row[j] * self.shapes[i][j]).sum::<f64>();
        let turned = |side: usize| {
            let i = cells[side];
            at(i, self.elements[i].rotation_row(i < node))
        };
        let i = cells[1];
        [at(i, self.elements[i].end_row(i < node)), turned(0), turned(1)]
    }

    /// The elements on which an output depends at fixed data.
    fn reads(&self, of: &Read) -> BTreeSet<usize> {
        let (frame, mut read) = (self.frame, BTreeSet::new());
        let cells = &frame.mesh.cells;
        let mut add = |x: f64| {
            let cell = frame.mesh.cell_at(x);
            read.extend([cell - usize::from(cell > 0 && x <= cells[cell].x[0]), cell]);
        };
        let end_of = |zone, side| frame.position(frame.end_of(zone, side));
        match *of {
            Read::Constant | Read::Energy => return read,
            Read::Field { x, follows, .. } => {
                add(x);
                if let Follows::Edge { zone, side, .. } = follows {
                    add(end_of(zone, side));
                }
            }
            Read::Beside { x } => add(x.clamp(0.0, frame.model.beam.length)),
            Read::Edge { zone, side } | Read::EdgeForce { zone, side } => add(end_of(zone, side)),
            Read::Support { number, .. } => add(frame.model.supports[number].at),
        }
        // The surface of an open span depends on w at both ends of the span; if the span is short, on all of it.
        for Span { ends, .. } in &self.spans {
            let at = |end: BeamPoint| cells[end.cell].global(end.s);
            let from = ends[0].map_or(f64::NEG_INFINITY, at);
            let to = ends[1].map_or(f64::INFINITY, at);
            if !read.iter().any(|i| cells[*i].x[0] <= to && cells[*i].x[1] >= from) {
                continue;
            }
            for end in ends.iter().flatten() {
                read.extend(end.cell.saturating_sub(1)..(end.cell + 2).min(cells.len()));
            }
            if let [Some(from), Some(to)] = ends
                && to.cell <= from.cell + SHORT
            {
                read.extend(from.cell..=to.cell);
            }
        }
        read
    }

    /// The elements on which some outputs depend at fixed data.
    pub fn read_by(&self, readings: &[Reading]) -> BTreeSet<usize> {
        readings.iter().flat_map(|reading| self.reads(&reading.of)).collect()
    }

    /// For each output the displacements under the loads that are its derivatives with respect to the unknowns.
    pub fn adjoints(&self, readings: &[Reading]) -> Option<Vec<Vec<[f64; 4]>>> {
        let mut linear = Linear::<4>::new(self);
        let reads: Vec<BTreeSet<usize>> = readings.iter().map(|own| self.reads(&own.of)).collect();
        let mut loads: Vec<Loads<f64>> = vec![Vec::new(); readings.len()];
        for cell in self.read_by(readings) {
            for (j, v) in linear.shapes[cell].iter_mut().enumerate() {
                v.by[j] = 1.0;
            }
            linear.refresh([cell].into_iter());
            for ((load, read), reading) in loads.iter_mut().zip(&reads).zip(readings) {
                if read.contains(&cell) {
                    load.push((cell, linear.read(reading)));
                }
            }
            linear.shapes[cell] = self.shapes[cell].map(Dual::from);
            linear.unfold(cell);
        }
        loads.into_iter().map(|load| self.displaced(load.into_iter())).collect()
    }
}

/// Maximum number of elements of a [short span](crate::contact::short_span).
const SHORT: usize = 4;

/// Data and unknowns of the bonded beam, with derivatives with respect to N variables.
#[derive(Debug)]
pub(super) struct Linear<'a, const N: usize> {
    pub equilibrium: &'a Equilibrium<'a>,
    pub frame: &'a Frame<'a>,
    pub tangents: Vec<Tangent>,
    /// The mesh of elements, and the mesh of power series if it differs, each with the cells that have derivatives.
    elements: Mesh<Dual<N>>,
    varied: Range<usize>,
    series: Option<(Mesh<Dual<N>>, Range<usize>)>,
    /// Elements whose data or unknowns have derivatives.
    pub exact: Vec<Option<Box<ExactElement<Dual<N>>>>>,
    /// The four unknowns of each element, from the displacements of its nodes.
    pub shapes: Vec<[Dual<N>; 4]>,
    /// Coefficients of w and φ.
    deflection: Vec<Dual<N>>,
    rotation: Vec<Dual<N>>,
    spans: Vec<Span<Dual<N>>>,
    moved: Vec<MovedEnd<N>>,
}

/// Steps at the end of an element, caused by a load that moves with a parameter or by a support that settles.
#[derive(Debug, Clone, Copy)]
struct MovedEnd<const N: usize> {
    cell: usize,
    right: bool,
    x: f64,
    /// Excess of the unknowns of the element over those from the displacements of its nodes.
    jump: [Dual<N>; 4],
    moment: Dual<N>,
    slope: Dual<N>,
    drift: Dual<N>,
}

/// Open ground between two contact zones, or between a zone and the ground outside the beam.
#[derive(Debug)]
struct Span<R> {
    /// Points at which the span ends at a contact zone; `None` if it includes the ground beyond the run.
    ends: [Option<BeamPoint>; 2],
    /// The two-ports of the span; for a two-port under the beam also its cell and the part of the cell.
    links: Vec<(Option<(usize, [f64; 2])>, TwoPort<R>)>,
    /// All two-ports in series.
    whole: TwoPort<R>,
    /// u − u₀ at both ends, and the forces on the ground at both ends.
    held: [R; 2],
    fluxes: [R; 2],
}

impl<R: Real> Span<R> {
    fn all(mesh: &Mesh<R>, zones: &[MeshZone]) -> Vec<Self> {
        let mut spans = Vec::new();
        for run in ground_runs(mesh).iter().filter(|run| run.pasternak) {
            let own = || zones.iter().filter(|zone| run.cells.contains(&zone.from.cell));
            let left = [None].into_iter().chain(own().map(|zone| Some(zone.to)));
            for (left, right) in left.zip(own().map(|zone| Some(zone.from)).chain([None])) {
                let links = open_links(mesh, run, left, right);
                let whole = links.iter().map(|(_, link)| *link).reduce(TwoPort::then);
                let (ends, whole) = ([left, right], whole.unwrap_or_default());
                spans.push(Span { ends, links, whole, held: [R::ZERO; 2], fluxes: [R::ZERO; 2] });
            }
        }
        spans
    }
}

impl<'a, const N: usize> Linear<'a, N> {
    /// Data and unknowns without derivatives.
    pub fn new(equilibrium: &'a Equilibrium<'a>) -> Self {
        let frame = equilibrium.frame;
        let lifted = |c: &[f64]| c.iter().map(|c| Dual::from(*c)).collect();
        let mut linear = Linear {
            equilibrium,
            frame,
            tangents: Vec::new(),
            elements: frame.mesh.still(),
            varied: 0..0,
            series: frame.fine.as_ref().map(|(fine, _)| (fine.still(), 0..0)),
            exact: frame.mesh.cells.iter().map(|_| None).collect(),
            shapes: equilibrium.shapes.iter().map(|v| v.map(Dual::from)).collect(),
            deflection: lifted(&equilibrium.deflection),
            rotation: lifted(&equilibrium.rotation),
            spans: Vec::new(),
            moved: Vec::new(),
        };
        linear.spans = Span::all(linear.mesh(), linear.zones());
        linear
    }

    /// Replaces the derivatives by those of the data with respect to at most N parameters. The unknowns have none.
    pub fn vary(&mut self, tangents: Vec<Tangent>) {
        let still = self.equilibrium;
        for (v, own) in self.shapes.iter_mut().zip(&still.shapes) {
            *v = own.map(Dual::from);
        }
        for i in (0..self.exact.len()).filter(|i| self.exact[*i].is_some()).collect::<Vec<_>>() {
            self.exact[i] = None;
            for part in self.frame.series_of(i) {
                for at in part * TERMS..(part + 1) * TERMS {
                    self.deflection[at] = still.deflection[at].into();
                    self.rotation
                        .get_mut(at)
                        .into_iter()
                        .for_each(|c| *c = still.rotation[at].into());
                }
            }
        }
        let by: Vec<&Model> = tangents.iter().map(|tangent| &tangent.model).collect();
        let rates = Rates { model: &self.frame.model, by: &by };
        self.varied = self.frame.mesh.vary(&rates, self.varied.clone(), &mut self.elements);
        if let (Some((mesh, varied)), Some((fine, _))) = (&mut self.series, &self.frame.fine) {
            *varied = fine.vary(&rates, varied.clone(), mesh);
        }
        self.tangents = tangents;
        self.moved.clear();
        self.move_loads();
        self.settle_supports();
        let jumps = self.moved.iter().filter(|end| end.jump != [Dual::ZERO; 4]).map(|end| end.cell);
        let moved: Vec<usize> = jumps.collect();
        for i in 0..self.exact.len() {
            let varies = self.varied.contains(&i) && !self.operator(i).is_still();
            if varies || moved.contains(&i) {
                self.make_exact(i);
            }
        }
        self.spans = Span::all(self.mesh(), self.zones());
    }

    /// Sets the derivatives of the unknowns with respect to one parameter.
    pub fn displace(&mut self, n: usize, by: &[[f64; 4]]) {
        for (v, by) in self.shapes.iter_mut().flatten().zip(by.iter().flatten()) {
            v.by[n] = *by;
        }
    }

    fn move_loads(&mut self) {
        let moved = self.tangents.iter().map(|tangent| tangent.moved);
        for (n, moved) in moved.enumerate().collect::<Vec<_>>() {
            let Some(moved) = moved else { continue };
            let steps = self.frame.steps(&moved);
            let (cell, right) = (steps.spot.cell, steps.spot.s > 0.0);
            let dual = |by: f64| {
                let mut dual = Dual::ZERO;
                dual.by[n] = by;
                dual
            };
            let jump = self.jump(cell, right, steps.jump.map(dual));
            let [moment, slope, drift] = [steps.moment, steps.slope, steps.drift].map(dual);
            self.moved.push(MovedEnd { cell, right, x: moved.x, jump, moment, slope, drift });
        }
    }

    /// A rigid support that settles moves the ends of both elements beside it; its node stays.
    fn settle_supports(&mut self) {
        for (node, own) in self.elements.nodes.iter().enumerate() {
            let settles = drift(own.settlement);
            if !own.pinned || settles == 0.0 {
                continue;
            }
            for (cell, right) in self.beside(node) {
                let jump = self.jump(cell, right, [settles, Dual::ZERO]);
                let (x, moment) = (own.x, Dual::ZERO);
                let (slope, drift) = (moment, moment);
                self.moved.push(MovedEnd { cell, right, x, jump, moment, slope, drift });
            }
        }
    }

    /// The unknowns of an element for a displacement and a rotation of one end.
    fn jump(&self, cell: usize, right: bool, [sinks, turns]: [Dual<N>; 2]) -> [Dual<N>; 4] {
        let element = &self.equilibrium.elements[cell];
        let [sunk, turned] = [false, true].map(|turns| element.moved_end(right, turns));
        std::array::from_fn(|j| sinks * sunk[j] + turns * turned[j])
    }

    /// The elements at a node, and whether the node is their right end.
    fn beside(&self, node: usize) -> impl Iterator<Item = (usize, bool)> + use<N> {
        let count = self.shapes.len();
        let cells = [(node.checked_sub(1), true), (Some(node), false)];
        cells.into_iter().filter_map(move |(i, right)| Some((i.filter(|i| *i < count)?, right)))
    }

    fn operator(&self, i: usize) -> Operator<Dual<N>> {
        Operator::of(&self.elements.cells[i], self.elements.axial_force, self.frame.touch[i])
    }

    fn make_exact(&mut self, i: usize) {
        let length = self.elements.cells[i].length();
        self.exact[i] = Some(Box::new(ExactElement::new(&self.operator(i), length)));
    }

    fn element(&self, i: usize) -> Element<Dual<N>> {
        let still = || self.equilibrium.elements[i].still();
        self.exact[i].as_ref().map_or_else(still, |exact| exact.element)
    }

    /// The unknowns of an element with the steps at its ends.
    fn own_shape(&self, i: usize) -> [Dual<N>; 4] {
        let mut own = self.shapes[i];
        for end in self.moved.iter().filter(|end| end.cell == i) {
            own.iter_mut().zip(end.jump).for_each(|(v, jump)| *v += jump);
        }
        own
    }

    /// Computes w and φ in some elements, and the settlements and forces at the ends of all spans.
    pub fn refresh(&mut self, elements: impl Iterator<Item = usize>) {
        elements.for_each(|i| self.unfold(i));
        (0..self.spans.len()).for_each(|span| self.hold(span));
    }

    /// Computes w and φ from the unknowns of an element.
    fn unfold(&mut self, i: usize) {
        if self.exact[i].is_none() {
            self.make_exact(i);
        }
        let Some(exact) = &self.exact[i] else { return };
        let (cell, own) = (&self.elements.cells[i], self.own_shape(i));
        let series = self.series.as_ref().map_or(&self.elements, |(series, _)| series);
        for part in self.frame.series_of(i) {
            let shears = !self.rotation.is_empty();
            let [w, turned] = curves([cell, &series.cells[part]], exact, &own, shears);
            let at = part * TERMS..(part + 1) * TERMS;
            self.deflection[at.clone()].copy_from_slice(&w);
            if shears {
                self.rotation[at].copy_from_slice(&turned);
            }
        }
    }

    /// The derivatives of the loads of all elements at the unknowns of the equilibrium: those on the elements, on the
    /// nodes, and of the open ground.
    pub fn loads(&self) -> Loads<Dual<N>> {
        let mut loads = Vec::new();
        for (i, exact) in self.exact.iter().enumerate() {
            if let Some(exact) = exact {
                loads.push((i, exact.element.forces(&self.own_shape(i)).map(|force| -force)));
            }
            for right in [false, true] {
                let [force, moment] = self.end_loads(i, right).map(drift);
                if force != 0.0 || moment != 0.0 {
                    loads.push((i, self.on_end(i, right, [force, moment])));
                }
            }
        }
        for (Span { whole, .. }, Span { ends, .. }) in
            self.spans.iter().zip(&self.equilibrium.spans)
        {
            let held = [0, 1].map(|end| {
                let Some(point) = ends[end] else { return Dual::ZERO };
                let right = point.s > 0.0;
                let node = &self.elements.nodes[point.cell + usize::from(right)];
                let gap = gap_at(&self.elements.cells[point.cell], point.s);
                let settles = if node.pinned { drift(node.settlement) } else { Dual::ZERO };
                let [w, ..] = self.equilibrium.at_node(point.cell + usize::from(right));
                self.drifted(node.x, end) + settles - gap + w
            });
            let fluxes = [whole.force_left(held[0], held[1]), whole.force_right(held[0], held[1])];
            for (end, flux) in ends.iter().zip(fluxes) {
                if let Some(end) = end {
                    loads.push((end.cell, self.on_end(end.cell, end.s > 0.0, [-flux, Dual::ZERO])));
                }
            }
        }
        loads
    }

    /// The load on the unknowns of an element from a force and a moment on one end.
    fn on_end(&self, i: usize, right: bool, [force, moment]: [Dual<N>; 2]) -> [Dual<N>; 4] {
        let element = &self.equilibrium.elements[i];
        let (row, turned) = (element.end_row(right), element.rotation_row(right));
        std::array::from_fn(|j| force * row[j] + moment * turned[j])
    }

    /// Force and moment on one end of an element from loads and springs of its node, from a hinge, from the free field
    /// and from a load that moves. The right node of an element belongs to the next element.
    fn end_loads(&self, i: usize, right: bool) -> [Dual<N>; 2] {
        let j = i + usize::from(right);
        let (node, cell) = (&self.elements.nodes[j], &self.elements.cells[i]);
        let [w, before, after] = self.equilibrium.at_node(j);
        let moved = self.moved.iter().filter(|end| end.cell == i && end.right == right);
        let (mut force, mut moment) = (Dual::ZERO, moved.map(|end| end.moment).sum());
        if !right || j == self.exact.len() {
            force += node.force - node.spring * (-node.settlement + w);
            moment += node.moment - node.rotational_spring * after;
        }
        if let Some(hinge) = node.hinge {
            moment += hinge * (if right { after - before } else { before - after });
        }
        if self.frame.touch[i] == ZoneKind::Contact && cell.has_free_field() {
            // In contact, ∫(k u₀z + μu₀′z′) over a cell is ∫q z plus μu₀′z at its ends.
            let flux = cell.shear_layer * cell.free_field_at(if right { 1.0 } else { -1.0 })[1];
            force += if right { flux } else { -flux };
        }
        [force, moment]
    }

    /// The mesh on which w is a power series in each cell, and the contact zones on it.
    pub fn mesh(&self) -> &Mesh<Dual<N>> {
        self.series.as_ref().map_or(&self.elements, |(series, _)| series)
    }

    pub fn zones(&self) -> &'a [MeshZone] {
        self.frame.series().1
    }

    fn w(&self) -> Deflection<'_, Dual<N>> {
        Deflection { mesh: self.mesh(), terms: TERMS, coefficients: &self.deflection }
    }

    /// Computes the settlements and the forces at the ends of a span.
    fn hold(&mut self, span: usize) {
        let Span { ends, whole, .. } = &self.spans[span];
        let w = self.w();
        let mut held = ends.map(|end| end.map_or(Dual::ZERO, |end| w.obstacle_at(end)));
        let mut fluxes = bonded_fluxes(&w, *ends, whole);
        for (end, point) in ends.iter().enumerate() {
            let Some(point) = point else { continue };
            let mut drifts = [Dual::ZERO; 2];
            drifts[end] = self.drifted(w.position(*point), end);
            if drifts[end] != 0.0 {
                held[end] += drifts[end];
                fluxes[0] += whole.force_left(drifts[0], drifts[1]);
                fluxes[1] += whole.force_right(drifts[0], drifts[1]);
            }
        }
        let span = &mut self.spans[span];
        (span.held, span.fluxes) = (held, fluxes);
    }

    /// Excess of the surface of open ground at an end of a span over the surface at the node there.
    fn drifted(&self, x: f64, end: usize) -> Dual<N> {
        let own = |moved: &&MovedEnd<N>| {
            usize::from(moved.right) == end && self.frame.is_same_node(moved.x, x)
        };
        self.moved.iter().filter(own).map(|moved| moved.drift).sum()
    }

    /// A field at a position x, on one side of x.
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

    /// u at a position x outside the beam.
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

    /// A function of the ground outside the beam and of the loads on the ground.
    pub fn on_line(&self, of: impl FnOnce(&Line<Dual<N>>) -> Dual<N>) -> Dual<N> {
        let by: Vec<&Model> = self.tangents.iter().map(|tangent| &tangent.model).collect();
        let rates = Rates { model: &self.frame.model, by: &by };
        let cells = &self.mesh().cells;
        let [left, right] = [cells[0].ground_at(-1.0), cells[cells.len() - 1].ground_at(1.0)];
        let [left, right] = [rates.beyond(false, left), rates.beyond(true, right)];
        let length = self.frame.model.beam.length;
        of(&Line { length, beyond: [&left, &right], loads: &rates.ground_loads() })
    }

    /// u − u₀ at both ends of a cell; `None` if the cell is in contact.
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

    /// Force of the bond at an end of a zone.
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

    /// μψ' at the end of a zone, without the step of w' that a moving load causes there.
    fn flux(&self, point: BeamPoint) -> Dual<N> {
        let x = self.w().position(point);
        let own = |end: &&MovedEnd<N>| self.frame.is_same_node(end.x, x);
        let steps: Dual<N> = self.moved.iter().filter(own).map(|end| end.slope).sum();
        self.w().flux(point) - self.mesh().cells[point.cell].ground_at(point.s)[1] * steps
    }

    /// Derivatives of the position of an edge that can move.
    pub fn edge(&self, zone: usize, side: Side) -> [f64; N] {
        let MeshZone { from, to } = self.zones()[zone];
        let spot = if side == Side::Left { from } else { to };
        let [psi, slope, pressure] = self.w().obstacle_and_pressure(spot);
        if self.mesh().cells[spot.cell].shear_layer.value() == 0.0 {
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
        let element = &self.equilibrium.elements[spot.cell];
        let dot = |row: [f64; 4]| (0..4).map(|j| v[j] * row[j]).sum();
        [dot(element.end_row(right)), dot(element.rotation_row(right))]
    }

    /// Force (positive up) and moment of the constraints at a node: the loads at the node minus the forces taken by
    /// elements and ground.
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

/// The derivatives of a number alone.
fn drift<const N: usize>(number: Dual<N>) -> Dual<N> {
    Dual { value: 0.0, by: number.by }
}

/// Coefficients of w, and of φ if the beam has shear deformation, on a part of an element's cell.
fn curves<R: Real>(
    [cell, part]: [&Cell<R>; 2],
    exact: &ExactElement<R>,
    v: &[R; 4],
    shears: bool,
) -> [Vec<R>; 2] {
    let c = exact.deflection_on(cell, part.x, &exact.unfold(v));
    let turned = shears.then(|| match exact.rotation(v) {
        Some(own) => own.to_vec(),
        None => {
            let mut slope = derivative(&c).at_least(TERMS);
            slope.iter_mut().for_each(|c| *c *= 2.0 / part.length());
            slope.to_vec()
        }
    });
    [c.to_vec(), turned.unwrap_or_default()]
}
