//! Solves the beam that is bonded to the ground on given intervals, with exact elements.

use crate::cancel::Cancel;
use crate::chain::elimination::Chain;
use crate::chain::node::{ChainNode, NotDefinite};
use crate::contact::intervals::{Interval, zones_of};
use crate::contact::layout::Layout;
use crate::contact::state::{ContactState, rotation_terms};
use crate::contact::stopping::{STIFFEN, STIFFEST_SPRING, ULPS};
use crate::element::element::Element;
use crate::element::operator::{Operator, ZoneKind};
use crate::element::{ElementRow, ExactElement, cut, cut_equally};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::MeshZone;
use crate::mesh::mesh::{Mesh, Node};
use crate::model::Model;
use crate::numeric::elementary::power;
use crate::numeric::polynomial::{TERMS, value};
use std::borrow::Cow;

/// Solver for a beam that is bonded to the ground on given intervals. It keeps the elements of the last solve for
/// reuse.
#[derive(Debug)]
pub(crate) struct Bonded<'a> {
    pub model: &'a Model,
    cancel: &'a Cancel,
    /// Whether all elements are short compared with the wavelength of the beam. Otherwise, a long loaded stretch in
    /// contact has one long [element](crate::element) in its middle.
    is_fine: bool,
    /// Elements of the previous step, which are reused for unchanged cells.
    known: Vec<Known>,
    /// Memory for the elements of the next step.
    spare: Vec<Known>,
}

/// An element, and the cell for which it was computed.
#[derive(Debug)]
struct Known {
    x: [f64; 2],
    touch: ZoneKind,
    exact: ExactElement,
}

/// The stabilising springs of a bonded beam.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Springs {
    /// Sum over the springs of stiffness times the square of the extension, which is twice their elastic energy.
    pub work: f64,
    /// Whether the forces of the stabilising springs are zero up to rounding error. Then the beam is in
    /// equilibrium without these springs.
    pub at_rest: bool,
}

/// A stabilising spring.
struct StabilisingSpring {
    at: f64,
    stiffness: f64,
    /// The deflection at which the spring has no force.
    rest: f64,
}

/// Creates springs at all nodes, unstressed at the deflection of `now`. Their stiffness is `epsilon` times the
/// stiffness of the ground under half of each neighbouring cell.
fn stabilising_springs(mesh: &Mesh, now: &ContactState, epsilon: f64) -> Vec<StabilisingSpring> {
    let spring = |node: &Node| StabilisingSpring {
        at: node.x,
        stiffness: 0.0,
        rest: deflection_at(now, node.x),
    };
    let mut springs: Vec<StabilisingSpring> = mesh.nodes.iter().map(spring).collect();
    for (i, cell) in mesh.cells.iter().enumerate() {
        let half = 0.5 * epsilon * cell.subgrade * cell.length();
        springs[i].stiffness += half;
        springs[i + 1].stiffness += half;
    }
    springs
}

fn deflection_at(found: &ContactState, x: f64) -> f64 {
    let cell = found.mesh.cell_at(x);
    value(found.deflection().cell(cell), found.mesh.cells[cell].local(x))
}

/// Builds the linear system of a mesh from its elements. The beam is bonded to the ground in the given
/// contact zones, whose ends must be nodes.
pub(crate) fn chain_of(
    mesh: &Mesh,
    zones: &[MeshZone],
    elements: impl Iterator<Item = Element>,
) -> Chain {
    let layout = Layout::of(mesh, zones);
    let cells = layout.cells(mesh, elements);
    Chain { nodes: layout.nodes(mesh), cells, meeting: layout.meeting_node(mesh) }
}

/// Returns the kind of zone in which a cell lies: contact within an interval, open outside the intervals.
pub(crate) fn zone_kind_of(intervals: &[Interval]) -> impl Fn(&Cell) -> ZoneKind + '_ {
    |cell| {
        let x = 0.5 * (cell.x[0] + cell.x[1]);
        let next = intervals.partition_point(|s| s[1] <= x);
        let touches = intervals.get(next).is_some_and(|s| s[0] < x);
        if touches { ZoneKind::Contact } else { ZoneKind::Open }
    }
}

/// Whether compression removes all shear stiffness of the beam at some point, so that the beam buckles in
/// arbitrarily short waves.
pub(crate) fn folds(model: &Model, places: &[f64], touch: &impl Fn(&Cell) -> ZoneKind) -> bool {
    let axial = model.beam.axial_force;
    if axial >= 0.0 || !model.beam.shears() {
        return false;
    }
    let stands =
        |cell: &Cell| Operator::of(cell, axial, touch(cell)).bears_shear(model.beam.length);
    !Mesh::build(model, places, |_| 1).cells.iter().all(stands)
}

impl<'a> Bonded<'a> {
    pub fn new(model: &'a Model, cancel: &'a Cancel) -> Self {
        Bonded { model, cancel, is_fine: false, known: Vec::new(), spare: Vec::new() }
    }

    /// Creates a solver whose elements are all short compared with the wavelength of the beam. Such elements
    /// resolve the response to any load.
    pub fn fine(model: &'a Model, cancel: &'a Cancel) -> Self {
        Bonded { is_fine: true, ..Bonded::new(model, cancel) }
    }

    /// Solves the beam bonded on the given intervals and free elsewhere. Returns [`NotDefinite`] also after a
    /// cancellation.
    pub fn solve_on(&mut self, intervals: &[Interval]) -> Result<ContactState, NotDefinite> {
        self.solve_with(intervals, &[], |_, _| ())
    }

    /// Whether the energy of the beam bonded to the ground on given intervals is positive definite. Returns `false` if
    /// the solve is cancelled.
    pub fn is_stable_on(&self, intervals: &[Interval]) -> bool {
        let touch = zone_kind_of(intervals);
        if self.must_stop(intervals, &touch) {
            return false;
        }
        let (mesh, zones) = self.mesh_on(intervals, &[]);
        let axial = self.model.beam.axial_force;
        let mut row = ElementRow::default();
        let elements = mesh.cells.iter().map(|cell| row.next(cell, axial, touch(cell)).element);
        let solved = chain_of(&mesh, &zones, elements).solve();
        solved.is_ok_and(|shapes| shapes.as_flattened().iter().all(|v| v.is_finite()))
    }

    /// Whether the solve is cancelled, or compression removes all shear stiffness of the beam at some point.
    fn must_stop(&self, intervals: &[Interval], touch: &impl Fn(&Cell) -> ZoneKind) -> bool {
        self.cancel.is_cancelled() || folds(self.model, intervals.as_flattened(), touch)
    }

    /// Solves the bonded beam with prescribed rotations.
    pub fn solve_held(
        &mut self,
        intervals: &[Interval],
        held: &[GivenRotation],
    ) -> Result<ContactState, NotDefinite> {
        let spring = self.model.beam.bending_stiffness / self.model.beam.length;
        let places: Vec<f64> = held.iter().map(|rotation| rotation.at).collect();
        self.solve_with(intervals, &places, |mesh, nodes| {
            for rotation in held {
                let node = &mut nodes[mesh.node_at(rotation.at)];
                node.rotational_spring += spring;
                node.moment += spring * rotation.slope;
            }
        })
    }

    /// Solves a mechanism with springs at all nodes, unstressed at the deflection of `now`. Their stiffness relative to
    /// the ground, `epsilon`, grows until the solve succeeds.
    pub fn solve_stabilised(
        &mut self,
        intervals: &[Interval],
        now: &ContactState,
        epsilon: &mut f64,
    ) -> Option<(ContactState, Springs)> {
        while *epsilon <= STIFFEST_SPRING {
            let mut springs = Vec::new();
            let solved = self.solve_with(intervals, &[], |mesh, nodes| {
                springs = stabilising_springs(mesh, now, *epsilon);
                for (node, spring) in nodes.iter_mut().zip(&springs) {
                    node.spring += spring.stiffness;
                    node.force += spring.stiffness * (spring.rest - node.settlement);
                }
            });
            if let Ok(found) = solved {
                let (mut work, mut extension, mut deflection) = (0.0, 0.0_f64, 0.0_f64);
                for spring in &springs {
                    let w = deflection_at(&found, spring.at);
                    work += spring.stiffness * power(w - spring.rest, 2);
                    extension = extension.max((w - spring.rest).abs());
                    deflection = deflection.max(w.abs());
                }
                // Springs stiffer than the ground can carry the loads with a small extension. So the extension is
                // scaled by the stiffness ratio.
                let at_rest = extension * epsilon.max(1.0) <= ULPS * f64::EPSILON * deflection;
                return Some((found, Springs { work, at_rest }));
            }
            if self.cancel.is_cancelled() {
                return None;
            }
            *epsilon *= STIFFEN;
        }
        None
    }

    /// Solves the beam bonded to the ground, with additional nodes at the positions `more`. The function `hold`
    /// adds springs and loads to the nodes before the solve.
    fn solve_with(
        &mut self,
        intervals: &[Interval],
        more: &[f64],
        hold: impl FnOnce(&Mesh, &mut [ChainNode]),
    ) -> Result<ContactState, NotDefinite> {
        let touch = zone_kind_of(intervals);
        if self.must_stop(intervals, &touch) {
            return Err(NotDefinite);
        }
        let (mesh, zones) = self.mesh_on(intervals, more);
        self.make_elements(&mesh, &touch);
        let elements = self.known.iter().map(|known| known.exact.element);
        let mut chain = chain_of(&mesh, &zones, elements);
        hold(&mesh, &mut chain.nodes);
        let shapes = chain.solve()?;
        let layered = self.known.iter().any(|known| known.exact.layers().is_some());
        let (mesh, coefficients, zones) = if layered {
            let (fine, coefficients) = self.in_layers(&mesh, &shapes);
            let zones = zones_of(&fine, intervals, &touch);
            (fine, coefficients, zones)
        } else {
            (mesh, self.unfolded(&shapes), zones)
        };
        let rotation = self.rotations(&mesh, &coefficients, &shapes);
        if !coefficients.iter().chain(&rotation).all(|c| c.is_finite()) {
            return Err(NotDefinite);
        }
        Ok(ContactState::exact(mesh, coefficients, rotation, zones))
    }

    /// Creates the mesh of the beam bonded on given intervals, with one cell for each element, and the zones on this
    /// mesh. `more` has positions of additional nodes.
    pub fn mesh_on(&self, intervals: &[Interval], more: &[f64]) -> (Mesh, Vec<MeshZone>) {
        let axial = self.model.beam.axial_force;
        let touch = zone_kind_of(intervals);
        let edges = intervals.as_flattened();
        let places: Cow<'_, [f64]> =
            if more.is_empty() { edges.into() } else { [edges, more].concat().into() };
        let cut = if self.is_fine { cut_equally } else { cut };
        let mesh = Mesh::graded(self.model, &places, |cell, x| {
            cut(&Operator::of(cell, axial, touch(cell)), cell, x);
        });
        let zones = zones_of(&mesh, intervals, &touch);
        (mesh, zones)
    }

    /// Computes the elements of a mesh. Elements of the previous step are reused.
    fn make_elements(&mut self, mesh: &Mesh, touch: &impl Fn(&Cell) -> ZoneKind) {
        let axial = self.model.beam.axial_force;
        let mut row = ElementRow::default();
        let Bonded { known, spare, .. } = self;
        std::mem::swap(known, spare);
        known.reserve(mesh.cells.len());
        // A peekable iterator would move each element twice.
        let mut before = spare.drain(..);
        for cell in &mesh.cells {
            let (x, touch) = (cell.x, touch(cell));
            while before.as_slice().first().is_some_and(|known| known.x[0] < x[0]) {
                before.next();
            }
            let next = before.as_slice().first();
            let is_same = next.is_some_and(|next| next.x == x && next.touch == touch);
            let reused = if is_same { before.next() } else { None };
            known.push(reused.unwrap_or_else(|| Known {
                x,
                touch,
                exact: row.next(cell, axial, touch),
            }));
        }
    }

    /// Computes the coefficients of the rotation φ of the cross-sections in all cells. `coefficients` are those of the
    /// deflection.
    fn rotations(&self, mesh: &Mesh, coefficients: &[f64], shapes: &[[f64; 4]]) -> Vec<f64> {
        if !self.model.beam.shears() {
            return Vec::new();
        }
        let mut rotations = Vec::with_capacity(coefficients.len());
        let mut known = self.known.iter().zip(shapes).peekable();
        for (cell, w) in mesh.cells.iter().zip(coefficients.chunks(TERMS)) {
            let middle = 0.5 * (cell.x[0] + cell.x[1]);
            while known.next_if(|(known, _)| known.x[1] < middle).is_some() {}
            let own = known.peek().and_then(|(known, v)| known.exact.rotation(v));
            rotations.extend_from_slice(&rotation_terms(own, cell, w));
        }
        rotations
    }

    /// Returns the deflection w as power series, one for each element.
    fn unfolded(&self, shapes: &[[f64; 4]]) -> Vec<f64> {
        let mut coefficients = Vec::with_capacity(self.known.len() * TERMS);
        for (known, v) in self.known.iter().zip(shapes) {
            coefficients.extend_from_slice(&known.exact.unfold(v).0);
        }
        coefficients
    }

    /// Cuts the elements with boundary layers into parts. Returns the resulting mesh, and the deflection w as one
    /// power series for each of its cells.
    fn in_layers(&self, mesh: &Mesh, shapes: &[[f64; 4]]) -> (Mesh, Vec<f64>) {
        let parts = self.known.iter().zip(shapes).map(|(known, v)| known.exact.unfold(v));
        let parts: Vec<([f64; TERMS], [f64; 2])> = parts.collect();
        let mut x = Vec::new();
        for (known, (_, heights)) in self.known.iter().zip(&parts) {
            x.push(known.x[1]);
            if let Some(layers) = known.exact.layers() {
                x.extend(layers.cuts(known.x, *heights));
            }
        }
        let fine = Mesh::build(self.model, &x, |_| 1);
        let mut coefficients = Vec::with_capacity(fine.cells.len() * TERMS);
        let mut i = 0;
        for run in &fine.cells {
            let middle = 0.5 * (run.x[0] + run.x[1]);
            while mesh.cells[i].x[1] < middle {
                i += 1;
            }
            let c = self.known[i].exact.deflection_on(&mesh.cells[i], run.x, &parts[i]);
            coefficients.extend_from_slice(&c);
        }
        (fine, coefficients)
    }
}

/// A rotation prescribed for a mechanism by a spring that is unstressed at this rotation. In equilibrium, the spring
/// carries no moment.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GivenRotation {
    pub at: f64,
    pub slope: f64,
}

impl GivenRotation {
    /// Returns a prescribed rotation at the left end of the beam, equal to the rotation in the given contact
    /// state.
    pub fn as_in(found: &ContactState) -> GivenRotation {
        GivenRotation { at: 0.0, slope: value(&found.rotation(0), -1.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};
    use crate::numeric::polynomial::jet;

    /// A gap of length h inside a contact zone changes the fields beside it by less than h² plus 10⁻¹³ of rounding
    /// error.
    #[test]
    fn fields_beside_a_short_gap_keep_their_digits() {
        let model = Model::new(Beam::uniform(1.0, 10.0), Foundation::pasternak(1.0, 3.4))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.1));
        let solved = |intervals: &[Interval], node: f64| {
            let model = model.clone().with_load(Load::point_force(node, f64::MIN_POSITIVE));
            let found =
                Bonded::new(&model, &Cancel::default()).solve_on(intervals).expect("a solution");
            let cell = found.mesh.cells.iter().position(|c| c.x[1] == 0.3).expect("a node");
            let [w, _, bend, _] = jet(found.deflection().cell(cell), 1.0);
            [w, bend / power(0.5 * found.mesh.cells[cell].length(), 2)]
        };
        let bonded = solved(&[[0.0, 0.3], [0.3, 1.0]], 0.3);
        for h in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11] {
            let intervals = [[0.0, 0.3], [0.3 + h, 1.0]];
            for node in [0.0, 0.3 + 0.4 * h] {
                let here = solved(&intervals, node);
                for (a, b) in here.iter().zip(bonded) {
                    assert!((a - b).abs() <= h * h + 1e-13, "{h}: {here:?} {bonded:?}");
                }
            }
        }
    }
}
