//! Builds the linearised problem of the bonded beam from dual numbers, which contain derivatives.
//!
//! The stiffness matrix is symmetric, so the derivatives follow from one solve per parameter or from one adjoint solve
//! per output. See *The linear problem* in `docs/derivatives.md`.

use super::equilibrium::{Equilibrium, Loads, Span, curves};
use super::frame::Frame;
use super::moved::Steps;
use super::tangent::Tangent;
use crate::contact::short_span::bonded_fluxes;
use crate::element::ExactElement;
use crate::element::element::Element;
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::cell::gap_at;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::lifted::Rates;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::numeric::dual::Dual;
use crate::numeric::polynomial::TERMS;
use crate::numeric::real::Real;
use std::ops::Range;

/// Data and unknowns of the bonded beam, with derivatives with respect to N parameters or unknowns.
#[derive(Debug)]
pub(super) struct Linear<'a, const N: usize> {
    pub equilibrium: &'a Equilibrium<'a>,
    pub frame: &'a Frame<'a>,
    pub tangents: Vec<Tangent>,
    /// Mesh of elements, with the derivatives of its data with respect to the parameters.
    elements: Mesh<Dual<N>>,
    /// Range of the cells of `elements` whose data depend on the parameters.
    varied: Range<usize>,
    /// Finer mesh on which w is a power series in each cell, and the range of its cells whose data depend on the
    /// parameters; `None` if w is a power series in each cell of `elements`.
    series: Option<(Mesh<Dual<N>>, Range<usize>)>,
    /// Elements with derivatives with respect to the parameters. [`Self::vary`] sets `None` for an element that no
    /// parameter changes or displaces.
    pub exact: Vec<Option<Box<ExactElement<Dual<N>>>>>,
    /// The four unknowns of each element, computed from the displacements of its nodes.
    pub shapes: Vec<[Dual<N>; 4]>,
    /// Power series coefficients of the deflection w and of the rotation φ of the cross-sections.
    pub deflection: Vec<Dual<N>>,
    pub rotation: Vec<Dual<N>>,
    pub spans: Vec<Span<Dual<N>>>,
    /// Jumps between nodes and element ends: the unknowns of an element minus their values computed from the
    /// displacements of its nodes.
    jumps: Loads<Dual<N>>,
    /// For each load whose position is a parameter: the index of the parameter, and the derivatives of moment and jumps
    /// at the load.
    moved: Vec<(usize, Steps)>,
}

impl<'a, const N: usize> Linear<'a, N> {
    /// Creates the linearised problem. All derivatives of its data with respect to the parameters are zero until
    /// [`Self::vary`] sets them.
    pub fn new(equilibrium: &'a Equilibrium<'a>) -> Self {
        let frame = equilibrium.frame;
        Linear {
            equilibrium,
            frame,
            tangents: Vec::new(),
            elements: frame.mesh.still(),
            varied: 0..0,
            series: frame.fine.as_ref().map(|(fine, _)| (fine.still(), 0..0)),
            exact: Vec::new(),
            shapes: Vec::new(),
            deflection: Vec::new(),
            rotation: Vec::new(),
            spans: Vec::new(),
            jumps: Vec::new(),
            moved: Vec::new(),
        }
    }

    /// Sets the derivatives of the data to the derivatives `tangents` with respect to at most N parameters. Sets the
    /// derivatives of the unknowns to zero.
    pub fn vary(&mut self, tangents: Vec<Tangent>) {
        let still = self.equilibrium;
        self.shapes.clear();
        self.shapes.extend(still.shapes.iter().map(|v| v.map(Dual::from)));
        for (lifted, still) in
            [(&mut self.deflection, &still.deflection), (&mut self.rotation, &still.rotation)]
        {
            lifted.clear();
            lifted.extend(still.iter().map(|c| Dual::from(*c)));
        }
        let by: Vec<&Model> = tangents.iter().map(|tangent| &tangent.model).collect();
        let reach = tangents.iter().map(|tangent| tangent.reach);
        let reach = reach.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).unwrap_or_default();
        let rates = Rates { model: &self.frame.model, by: &by, reach };
        self.varied = self.frame.mesh.vary(&rates, self.varied.clone(), &mut self.elements);
        if let (Some((mesh, varied)), Some((fine, _))) = (&mut self.series, &self.frame.fine) {
            *varied = fine.vary(&rates, varied.clone(), mesh);
        }
        let steps = |(n, tangent): (usize, &Tangent)| Some((n, self.frame.steps(&tangent.moved?)));
        self.moved = tangents.iter().enumerate().filter_map(steps).collect();
        self.tangents = tangents;
        self.find_jumps();
        self.exact.clear();
        for i in 0..self.shapes.len() {
            let varies = self.varied.contains(&i) && !self.operator(i).is_still();
            let jumps = self.jumps.iter().any(|(cell, _)| *cell == i);
            self.exact.push((varies || jumps).then(|| self.new_exact(i)));
        }
        self.spans = Span::all(self.mesh(), self.zones());
    }

    /// Sets the derivatives of the unknowns with respect to one parameter.
    pub fn displace(&mut self, n: usize, by: &[[f64; 4]]) {
        for (v, by) in self.shapes.iter_mut().flatten().zip(by.iter().flatten()) {
            v.by[n] = *by;
        }
    }

    /// Computes the jumps between nodes and element ends, at moving loads and at rigid supports that settle.
    fn find_jumps(&mut self) {
        self.jumps.clear();
        for (n, steps) in self.moved.clone() {
            self.jump(steps.spot.cell, steps.spot.s > 0.0, steps.jump.map(|jump| along(n, jump)));
        }
        for node in 0..self.elements.nodes.len() {
            let own = &self.elements.nodes[node];
            let steps = [drift(own.settlement), Dual::ZERO];
            if own.pinned && steps[0] != 0.0 {
                self.beside(node).for_each(|(cell, right)| self.jump(cell, right, steps));
            }
        }
    }

    /// Displaces and rotates one end of an element, but not its node.
    fn jump(&mut self, cell: usize, right: bool, steps: [Dual<N>; 2]) {
        let element = &self.equilibrium.elements[cell];
        for (step, turns) in steps.into_iter().zip([false, true]).filter(|(step, _)| *step != 0.0) {
            self.jumps.push((cell, element.moved_end(right, turns).map(|part| step * part)));
        }
    }

    /// Returns the elements at a node, and for each element whether the node is its right end.
    pub fn beside(&self, node: usize) -> impl Iterator<Item = (usize, bool)> + use<N> {
        let count = self.shapes.len();
        let cells = [(node.checked_sub(1), true), (Some(node), false)];
        cells.into_iter().filter_map(move |(i, right)| Some((i.filter(|i| *i < count)?, right)))
    }

    fn operator(&self, i: usize) -> Operator<Dual<N>> {
        Operator::of(&self.elements.cells[i], self.elements.axial_force, self.frame.touch[i])
    }

    fn new_exact(&self, i: usize) -> Box<ExactElement<Dual<N>>> {
        Box::new(ExactElement::new(&self.operator(i), self.elements.cells[i].length()))
    }

    pub fn element(&self, i: usize) -> Element<Dual<N>> {
        let still = || self.equilibrium.elements[i].still();
        self.exact[i].as_ref().map_or_else(still, |exact| exact.element)
    }

    /// Returns the unknowns of an element. They include the jumps by which the deflections and rotations of the
    /// element's ends differ from those of its nodes.
    pub fn own_shape(&self, i: usize) -> [Dual<N>; 4] {
        let mut own = self.shapes[i];
        for (_, jump) in self.jumps.iter().filter(|(cell, _)| *cell == i) {
            own.iter_mut().zip(jump).for_each(|(v, jump)| *v += *jump);
        }
        own
    }

    /// Computes deflection and rotation in the given `elements`, and displacements and forces at the ends of all open
    /// ground.
    pub fn refresh(&mut self, elements: impl Iterator<Item = usize>) {
        elements.for_each(|i| self.unfold(i));
        (0..self.spans.len()).for_each(|span| self.hold(span));
    }

    /// Computes w and φ from the unknowns of an element.
    pub fn unfold(&mut self, i: usize) {
        let exact = self.exact[i].take().unwrap_or_else(|| self.new_exact(i));
        let (cell, own) = (&self.elements.cells[i], self.own_shape(i));
        let series = self.series.as_ref().map_or(&self.elements, |(series, _)| series);
        for part in self.frame.series_of(i) {
            let shears = !self.rotation.is_empty();
            let [w, turned] = curves([cell, &series.cells[part]], &exact, &own, shears);
            let at = part * TERMS..(part + 1) * TERMS;
            self.deflection[at.clone()].copy_from_slice(&w);
            if shears {
                self.rotation[at].copy_from_slice(&turned);
            }
        }
        self.exact[i] = Some(exact);
    }

    /// Computes minus the derivatives of the residual with respect to the parameters, at fixed unknowns.
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

    /// Converts a force and a moment on one end of an element to loads on the unknowns of the element.
    fn on_end(&self, i: usize, right: bool, [force, moment]: [Dual<N>; 2]) -> [Dual<N>; 4] {
        let element = &self.equilibrium.elements[i];
        let (row, turned) = (element.end_row(right), element.rotation_row(right));
        std::array::from_fn(|j| force * row[j] + moment * turned[j])
    }

    /// Computes the external force and moment on one end of an element, from its node, a hinge, the free field and a
    /// moving load. Loads and springs of an inner node act on the element on its right.
    pub fn end_loads(&self, i: usize, right: bool) -> [Dual<N>; 2] {
        let j = i + usize::from(right);
        let (node, cell) = (&self.elements.nodes[j], &self.elements.cells[i]);
        let [w, before, after] = self.equilibrium.at_node(j);
        let spot = BeamPoint { cell: i, s: if right { 1.0 } else { -1.0 } };
        let moved = self.moved.iter().filter(|(_, steps)| steps.spot == spot);
        let (mut force, mut moment) =
            (Dual::ZERO, moved.map(|(n, steps)| along(*n, steps.moment)).sum());
        if !right || j == self.exact.len() {
            force += node.force - node.spring * (-node.settlement + w);
            moment += node.moment - node.rotational_spring * after;
        }
        if let Some(hinge) = node.hinge {
            moment += hinge * (if right { after - before } else { before - after });
        }
        if self.frame.touch[i] == ZoneKind::Contact && cell.has_free_field() {
            // In contact, the element has the load q = k u₀ − (μu₀′)′ on the ground. Integration by parts of (μu₀′)′
            // adds the end forces ±μu₀′.
            let flux = cell.shear_layer * cell.free_field_at(if right { 1.0 } else { -1.0 })[1];
            force += if right { flux } else { -flux };
        }
        [force, moment]
    }

    /// Returns the mesh on which w is a power series in each cell.
    pub fn mesh(&self) -> &Mesh<Dual<N>> {
        self.series.as_ref().map_or(&self.elements, |(series, _)| series)
    }

    pub fn zones(&self) -> &'a [MeshZone] {
        self.frame.series().1
    }

    pub fn w(&self) -> Deflection<'_, Dual<N>> {
        Deflection { mesh: self.mesh(), coefficients: &self.deflection }
    }

    /// Computes the ground displacement minus the free field, and the force on the ground, at both ends of an open
    /// span.
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

    /// Computes the settlement at one end of open ground minus that of the node at x. The value is 0, but its
    /// derivative with respect to the position of a load may differ from 0.
    fn drifted(&self, x: f64, end: usize) -> Dual<N> {
        let is_end = |steps: &Steps| usize::from(steps.spot.s > 0.0) == end;
        self.moved_at(x, |steps| if is_end(steps) { steps.drift } else { 0.0 })
    }

    /// Sums a quantity of [`Steps`] over all moving loads at the node at x, for each parameter. The sums are the
    /// derivatives of the returned dual number, and its value is 0.
    pub fn moved_at(&self, x: f64, of: impl Fn(&Steps) -> f64) -> Dual<N> {
        let here = |steps: &Steps| self.frame.is_same_node(self.frame.position(steps.spot), x);
        let moved = self.moved.iter().filter(|(_, steps)| here(steps));
        moved.map(|(n, steps)| along(*n, of(steps))).sum()
    }
}

/// Returns a dual number with the value 0 and the derivatives of `number`.
fn drift<const N: usize>(number: Dual<N>) -> Dual<N> {
    Dual { value: 0.0, by: number.by }
}

/// Returns a dual number with the value 0. Its derivative with respect to parameter n is `by`.
fn along<const N: usize>(n: usize, by: f64) -> Dual<N> {
    let mut dual = Dual::ZERO;
    dual.by[n] = by;
    dual
}
