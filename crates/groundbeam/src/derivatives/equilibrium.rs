//! Computes the equilibrium of the beam bonded to the ground on its contact zones: elements, unknowns and stiffness.

use super::frame::Frame;
use crate::chain::elimination::Chain;
use crate::chain::node::Tie;
use crate::contact::bonded::chain_of;
use crate::element::ExactElement;
use crate::element::element::Element;
use crate::ground::link::TwoPort;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::ground_runs::ground_runs;
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::open_links;
use crate::numeric::polynomial::{TERMS, derivative};
use crate::numeric::real::Real;

/// Elements, unknowns and linear equations of the beam bonded to the ground on its contact zones. All values are plain
/// numbers without derivatives with respect to the parameters.
#[derive(Debug)]
pub(super) struct Equilibrium<'a> {
    pub frame: &'a Frame<'a>,
    pub elements: Vec<Element>,
    /// The four unknowns of each element.
    pub shapes: Vec<[f64; 4]>,
    /// Power series coefficients of the deflection w in each cell. [`Frame::series`] returns the mesh of these cells.
    pub deflection: Vec<f64>,
    /// Power series coefficients of the rotation φ of the cross-sections, in the same cells as `deflection`; empty if
    /// the beam has no shear deformation.
    pub rotation: Vec<f64>,
    /// Spans of ground without contact. Their ends are points of the cells of `frame.mesh`.
    pub spans: Vec<Span<f64>>,
    /// Linear equations of the bonded beam with all loads zero.
    chain: Chain,
}

/// Loads on the four unknowns of some elements, as pairs of an element's index and its loads.
pub(super) type Loads<T> = Vec<(usize, [T; 4])>;

impl<'a> Equilibrium<'a> {
    /// Solves the beam bonded to the ground on the contact zones of `frame`. Returns `None` if the beam is a
    /// mechanism.
    pub fn at(frame: &'a Frame<'a>) -> Option<Self> {
        let mesh = &frame.mesh;
        let element = |(cell, touch)| ExactElement::of(cell, mesh.axial_force, touch);
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
            for tie in cell.open.iter_mut().flat_map(|open| &mut open.ties) {
                if let Tie::Beam { gap } = tie {
                    *gap = 0.0;
                }
            }
        }
        let spans = Span::all(mesh, &frame.zones);
        Some(Equilibrium { frame, elements, shapes, deflection, rotation, spans, chain })
    }

    /// Computes the unknowns of all elements for each of several lists of loads. Each list acts alone. Returns `None`
    /// if the beam is a mechanism.
    pub fn displaced(&self, loads: impl Iterator<Item = Loads<f64>>) -> Option<Vec<Vec<[f64; 4]>>> {
        let mut chain = self.chain.clone();
        let under = |loads: Loads<f64>| {
            for (cell, load) in &loads {
                let own = &mut chain.cells[*cell].element.load;
                own.iter_mut().zip(load).for_each(|(own, load)| *own += load);
            }
            let displaced = chain.solve().ok();
            loads.iter().for_each(|(cell, _)| chain.cells[*cell].element.load = [0.0; 4]);
            displaced
        };
        loads.map(under).collect()
    }

    /// Returns the deflection w at a node, and the rotations just left and just right of the node.
    pub fn at_node(&self, node: usize) -> [f64; 3] {
        let cells = [node.saturating_sub(1), node.min(self.shapes.len() - 1)];
        let at = |i: usize, row: [f64; 4]| (0..4).map(|j| row[j] * self.shapes[i][j]).sum::<f64>();
        let turned = |side: usize| {
            let i = cells[side];
            at(i, self.elements[i].rotation_row(i < node))
        };
        let i = cells[1];
        [at(i, self.elements[i].end_row(i < node)), turned(0), turned(1)]
    }
}

/// Ground without contact between two contact zones, or between a contact zone and the ground outside the beam.
#[derive(Debug)]
pub(super) struct Span<R> {
    /// Contact edges at the ends of the span; `None` if the span includes the ground beyond this end of the
    /// `GroundRun`.
    pub ends: [Option<BeamPoint>; 2],
    /// Two-ports of the span. A two-port under the beam is stored with its cell and with the interval of the cell that
    /// it covers.
    pub links: Vec<(Option<(usize, [f64; 2])>, TwoPort<R>)>,
    /// Two-port of the whole span: all its two-ports in series.
    pub whole: TwoPort<R>,
    /// Ground displacement u minus free-field settlement u₀ at both ends of the span.
    pub held: [R; 2],
    /// Downward forces on the ground at both ends of the span, which cause the displacements `held`.
    pub fluxes: [R; 2],
}

impl<R: Real> Span<R> {
    pub fn all(mesh: &Mesh<R>, zones: &[MeshZone]) -> Vec<Self> {
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

/// Computes the power series of the deflection and, with shear deformation, of the rotation φ of the cross-sections on
/// the part `part` of an element with the unknowns `v`.
pub(super) fn curves<R: Real>(
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
