//! The contact problem linearised at a solution: the chain bonded on its own contact, without loads.
//!
//! Moving an edge of contact changes the energy in third order only: no force stands there, and the pressure is finite.
//! To first order a change of the model changes w as if beam and ground were bonded where they touch and nowhere
//! else. The small force that the bonded edge then carries equals the pressure on the strip by which the edge moves.

use super::field::{Field, Point};
use super::joint::{Joint, joints};
use super::push::Push;
use crate::cancel::Cancel;
use crate::chain::elimination::Chain;
use crate::chain::node::NotDefinite;
use crate::contact::bonded::{Bonded, BondedSystem};
use crate::contact::intervals::Interval;
use crate::derivatives::piece::Piece;
use crate::element::ExactElement;
use crate::element::element::Basis;
use crate::element::element::TERMS;
use crate::element::operator::ZoneKind;
use crate::ground::link;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::mesh::Mesh;
use crate::model::{Model, SupportKind};
use crate::numeric::polynomial::{Coefficients, jet, rescale};
use crate::solution::fields::{ConcentratedForce, Side};
use crate::solution::solution::Solution;

/// Beam and ground bonded on the contact of a solution.
#[derive(Debug)]
pub(super) struct Linearised {
    /// The model, on the supports that act.
    pub model: Model,
    pub mesh: Mesh,
    pub zones: Vec<MeshZone>,
    pub pieces: Vec<Piece>,
    pub joints: Vec<Joint>,
    /// The solution.
    pub state: Field,
    /// Its concentrated forces on the ground.
    pub atoms: Vec<ConcentratedForce>,
    /// The chain and its elements, without loads.
    pub chain: Chain,
    pub elements: Vec<ExactElement>,
}

/// Halvings of a piece of ground that varies.
const MOST_HALVINGS: u32 = 40;

impl Linearised {
    /// At a solution of the exact method, with nodes at `places`. None where the contact leaves the beam loose: it may
    /// turn about a point.
    pub fn at(solution: &Solution, places: &[f64]) -> Option<Self> {
        let stretches = contact_of(solution);
        let acts = |i: usize| solution.reactions()[i].force != 0.0;
        let model = solution.model().with_supports_that(|i, s| !s.is_one_way() || acts(i));
        let never = Cancel::default();
        let mut glue = Bonded::fine(&model, &never);
        let BondedSystem { mesh, zones, chain } = glue.system_on(&stretches, places);
        let shapes = chain.solve().ok()?;
        let (loaded, touch): (Vec<ExactElement>, Vec<ZoneKind>) =
            glue.elements().map(|(element, touch)| (element.clone(), touch)).unzip();
        let bare = without_loads(&model);
        let mut glue = Bonded::fine(&bare, &never);
        let nodes: Vec<f64> = mesh.nodes.iter().map(|node| node.x).collect();
        let BondedSystem { mesh: same, chain, .. } = glue.system_on(&stretches, &nodes);
        if same.nodes.len() != mesh.nodes.len() {
            return None;
        }
        let elements: Vec<ExactElement> =
            glue.elements().map(|(element, _)| element.clone()).collect();
        let pieces = pieces(&mesh, &loaded, &touch);
        let joints = joints(&mesh, &zones, &pieces);
        let state = Field::of(shapes);
        let atoms = solution.concentrated_forces().to_vec();
        let mut linearised =
            Linearised { model, mesh, zones, pieces, joints, state, atoms, chain, elements };
        let mut state = std::mem::take(&mut linearised.state);
        state.curves = linearised.curves(&loaded, &state.shapes);
        state.heights = linearised.heights(&state, true, &Push::default());
        state.sample(&linearised.pieces, &linearised.joints, true);
        linearised.state = state;
        Some(linearised)
    }

    /// How beam and ground answer to what is pushed, glued together and without any other load.
    pub fn answer(&self, push: &Push) -> Result<Field, NotDefinite> {
        let mut chain = self.chain.clone();
        for (element, row) in &push.loads {
            add(&mut chain.cells[*element].element.load, row);
        }
        for (element, jump) in &push.jumps {
            let stiffness = self.elements[*element].element.stiffness;
            let load = stiffness.map(|row| dot(&row, jump));
            add(&mut chain.cells[*element].element.load, &load);
        }
        for (joint, jump) in &push.parted {
            let joint = &self.joints[*joint];
            self.press(&mut chain, joint, joint.forces(*jump));
        }
        for (joint, strip, force) in &push.on_ground {
            let joint = &self.joints[*joint];
            self.press(&mut chain, joint, joint.carried(*strip).map(|share| share * force));
        }
        for (node, settlement) in &push.settled {
            chain.nodes[*node].settlement += settlement;
        }
        let shapes = chain.solve()?;
        let mut within = shapes.clone();
        for (element, jump) in &push.jumps {
            for (v, jump) in within[*element].iter_mut().zip(jump) {
                *v -= jump;
            }
        }
        let mut field = Field::of(shapes);
        field.curves = self.curves(&self.elements, &within);
        field.heights = self.heights(&field, false, push);
        field.sample(&self.pieces, &self.joints, false);
        Ok(field)
    }

    /// The field of given fours of every element, the open ground at rest.
    pub fn spanned(&self, shapes: Vec<[f64; 4]>) -> Field {
        let mut field = Field::of(shapes);
        field.curves = self.curves(&self.elements, &field.shapes);
        field.sample(&self.pieces, &[], false);
        field
    }

    /// Open ground on a piece, moved at its ends, under a beam at rest: at the points of quadrature.
    pub fn open_strip(&self, piece: usize, ends: [f64; 2]) -> Vec<Point> {
        Field::of_open_ground(&self.pieces[piece], ends)
    }

    /// Forces on the beam, down, where a joint of open ground is tied to it.
    fn press(&self, chain: &mut Chain, joint: &Joint, forces: [f64; 2]) {
        for (end, force) in joint.ends.into_iter().zip(forces) {
            if let Some(spot) = end {
                let (element, row) = self.deflection_row(spot);
                add(&mut chain.cells[element].element.load, &row.map(|r| r * force));
            }
        }
    }

    /// w on every piece, and φ where the beam shears.
    fn curves(&self, elements: &[ExactElement], shapes: &[[f64; 4]]) -> Vec<[Coefficients; 2]> {
        let mut curves = Vec::with_capacity(self.pieces.len());
        let mut at = usize::MAX;
        let mut unfolded = ([0.0; TERMS], [0.0; 2]);
        let mut rotation = None;
        for piece in &self.pieces {
            let exact = &elements[piece.element];
            if piece.element != at {
                at = piece.element;
                unfolded = exact.unfold(&shapes[at]);
                rotation = exact.rotation(&shapes[at]);
            }
            let [a, b] = piece.part;
            let own = |whole: &[f64; TERMS]| -> Coefficients {
                if piece.part == [-1.0, 1.0] {
                    whole[..].into()
                } else {
                    rescale(whole, 0.5 * (a + b), 0.5 * (b - a))
                }
            };
            let mut curve = own(&unfolded.0);
            if let Some(layers) = exact.layers() {
                layers.add(self.mesh.cells[at].x, unfolded.1, piece.cell.x, &mut curve);
            }
            curves.push([curve, rotation.as_ref().map_or_else(Coefficients::default, own)]);
        }
        curves
    }

    /// What the beam makes of u at the ends of every strip of open ground.
    fn heights(&self, field: &Field, loaded: bool, push: &Push) -> Vec<Vec<f64>> {
        let held = |spot: Option<BeamPoint>| {
            let Some(spot) = spot else { return 0.0 };
            let cell = &self.mesh.cells[spot.cell];
            let (element, row) = self.deflection_row(spot);
            let clear = crate::mesh::cell::gap_at(cell, spot.s);
            dot(&row, &field.shapes[element]) - if loaded { clear } else { 0.0 }
        };
        let of = |(i, joint): (usize, &Joint)| {
            let mut ends = joint.ends.map(held);
            for (_, jump) in push.parted.iter().filter(|(j, _)| *j == i) {
                ends = [ends[0] - jump[0], ends[1] - jump[1]];
            }
            let mut heights = joint.heights(ends);
            for (strip, force) in push.on_joint(i) {
                for (height, own) in heights.iter_mut().zip(joint.bulge(strip)) {
                    *height += force * own;
                }
            }
            heights
        };
        self.joints.iter().enumerate().map(of).collect()
    }

    /// What multiplies the four of which element in w at a spot, which is an end of it.
    pub fn deflection_row(&self, spot: BeamPoint) -> (usize, [f64; 4]) {
        (spot.cell, self.elements[spot.cell].element.end_row(spot.s > 0.0))
    }

    /// The same for φ.
    pub fn rotation_row(&self, spot: BeamPoint) -> (usize, [f64; 4]) {
        let row = match (spot.s > 0.0, self.elements[spot.cell].element.basis) {
            (false, _) => [0.0, 1.0, 0.0, 0.0],
            (true, Basis::Deformation) => [0.0, 1.0, 0.0, 1.0],
            (true, Basis::Ends) => [0.0, 0.0, 0.0, 1.0],
        };
        (spot.cell, row)
    }

    /// The four of an element whose end at a spot sinks, or turns, by one while its other end stays.
    pub fn moved_end(&self, spot: BeamPoint, turns: bool) -> [f64; 4] {
        let element = &self.elements[spot.cell].element;
        let h = element.length;
        match (spot.s > 0.0, element.basis, turns) {
            (false, Basis::Deformation, false) => [1.0, 0.0, -1.0, 0.0],
            (false, Basis::Deformation, true) => [0.0, 1.0, -h, -1.0],
            (false, Basis::Ends, false) => [1.0, 0.0, 0.0, 0.0],
            (false, Basis::Ends, true) => [0.0, 1.0, 0.0, 0.0],
            (true, _, false) => [0.0, 0.0, 1.0, 0.0],
            (true, _, true) => [0.0, 0.0, 0.0, 1.0],
        }
    }

    /// The end of an element at a position at which there is a node; at the beam's ends there is one side only.
    pub fn spot(&self, x: f64, side: Side) -> BeamPoint {
        let node = self.mesh.node_at(x);
        let left = node > 0 && (side == Side::Left || node == self.mesh.cells.len());
        if left { BeamPoint { cell: node - 1, s: 1.0 } } else { BeamPoint { cell: node, s: -1.0 } }
    }

    /// The piece at an end of an element.
    pub fn piece_at(&self, spot: BeamPoint) -> usize {
        if spot.s > 0.0 {
            self.pieces.partition_point(|piece| piece.element <= spot.cell) - 1
        } else {
            self.pieces.partition_point(|piece| piece.element < spot.cell)
        }
    }

    /// A field at an end of an element.
    pub fn look(&self, field: &Field, spot: BeamPoint, loaded: bool) -> Point {
        let piece = self.piece_at(spot);
        field.look(&self.pieces[piece], piece, spot.s, loaded)
    }

    /// w and φ of the chain's own at a node, on one side.
    pub fn at_node(&self, field: &Field, spot: BeamPoint) -> [f64; 2] {
        let v = &field.shapes[spot.cell];
        [self.deflection_row(spot).1, self.rotation_row(spot).1].map(|row| dot(&row, v))
    }

    /// The shear stiffness of the beam at an end of an element, and by how much it grows with x; none where it does not
    /// shear.
    pub fn shear_stiffness_at(&self, spot: BeamPoint) -> Option<[f64; 2]> {
        let cell = &self.mesh.cells[spot.cell];
        let [shear, by_s, ..] = jet(&cell.beam_shear?, spot.s);
        Some([shear, by_s * 2.0 / cell.length()])
    }

    /// What holds the beam at a node up against an answer to `push`.
    pub fn reaction(&self, field: &Field, push: &Push, x: f64) -> f64 {
        let node = self.mesh.node_at(x);
        let mut force = 0.0;
        for spot in [node.checked_sub(1).map(|i| (i, 1.0)), Some((node, -1.0))]
            .into_iter()
            .flatten()
            .filter(|(cell, _)| *cell < self.mesh.cells.len())
            .map(|(cell, s)| BeamPoint { cell, s })
        {
            let element = &self.elements[spot.cell].element;
            let mut v = field.shapes[spot.cell];
            for (_, jump) in push.jumps.iter().filter(|(e, _)| *e == spot.cell) {
                for (v, jump) in v.iter_mut().zip(jump) {
                    *v -= jump;
                }
            }
            let end = self.moved_end(spot, false);
            let demanded = element.stiffness.map(|row| dot(&row, &v));
            force += dot(&end, &demanded);
            let loads = push.loads.iter().filter(|(e, _)| *e == spot.cell);
            force -= loads.map(|(_, row)| dot(&end, row)).sum::<f64>();
        }
        for (j, (joint, heights)) in self.joints.iter().zip(&field.heights).enumerate() {
            let forces = joint.forces_under(heights, push.on_joint(j));
            for (end, taken) in joint.ends.into_iter().zip(forces) {
                if end.is_some_and(|spot| spot.cell + usize::from(spot.s > 0.0) == node) {
                    force += taken;
                }
            }
        }
        -force
    }
}

/// The stretches that touch; and points that do, where a shear layer ends beside separate springs that touch as well.
fn contact_of(solution: &Solution) -> Vec<Interval> {
    let mut stretches = Vec::with_capacity(solution.contact().len());
    let carries = |x: f64| solution.concentrated_forces().iter().any(|force| force.at == x);
    for region in solution.contact() {
        let [from, to] = [region.from, region.to];
        if from < to && carries(from) {
            stretches.push([from; 2]);
        }
        stretches.push([from, to]);
        if from < to && carries(to) {
            stretches.push([to; 2]);
        }
    }
    stretches
}

/// The model with its nodes and nothing that acts.
fn without_loads(model: &Model) -> Model {
    let mut bare = model.clone().with_loads_scaled(0.0);
    for corner in &mut bare.gap {
        corner.value = 0.0;
    }
    for support in &mut bare.supports {
        support.settlement = 0.0;
    }
    bare
}

/// Every element cut so that w and u are short power series.
fn pieces(mesh: &Mesh, elements: &[ExactElement], touch: &[ZoneKind]) -> Vec<Piece> {
    let mut pieces = Vec::with_capacity(mesh.cells.len());
    for (i, (cell, exact)) in mesh.cells.iter().zip(elements).enumerate() {
        let mut cuts: Vec<f64> = Vec::new();
        if let Some(layers) = exact.layers() {
            cuts.extend(layers.cuts(cell.x, [1.0; 2]));
        }
        let open = touch[i] == ZoneKind::Open && cell.shear_layer > 0.0;
        if open && !cell.ground_varies() {
            link::cut(cell.x, (cell.shear_layer / cell.subgrade).sqrt(), &mut cuts);
        }
        if open && cell.ground_varies() {
            halve(cell, [-1.0, 1.0], MOST_HALVINGS, &mut cuts);
        }
        let [from, to] = cell.x;
        cuts.sort_by(f64::total_cmp);
        let near = 1e-9 * cell.length();
        cuts.retain(|x| *x > from + near && *x < to - near);
        cuts.dedup_by(|b, a| *b - *a < near);
        let ends: Vec<f64> =
            [from].into_iter().chain(cuts).chain([to]).map(|x| cell.local(x)).collect();
        for part in ends.windows(2).map(|s| [s[0], s[1]]) {
            let whole = part == [-1.0, 1.0];
            pieces.push(Piece {
                element: i,
                cell: if whole { *cell } else { cell.part(part) },
                half: 0.25 * (part[1] - part[0]) * elements[i].element.length,
                touch: touch[i],
                part,
            });
        }
    }
    pieces
}

/// Cuts where open ground that varies is no short power series.
fn halve(cell: &Cell, part: [f64; 2], halvings: u32, cuts: &mut Vec<f64>) {
    let own = cell.part(part);
    let half = 0.25 * (part[1] - part[0]) * cell.length();
    if halvings == 0 || (own.is_short_for_open_ground(half) && own.is_smooth()) {
        return;
    }
    let middle = 0.5 * (part[0] + part[1]);
    halve(cell, [part[0], middle], halvings - 1, cuts);
    cuts.push(cell.global(middle));
    halve(cell, [middle, part[1]], halvings - 1, cuts);
}

/// Whether w at a support is its settlement.
pub(super) fn is_rigid(kind: SupportKind) -> bool {
    matches!(kind, SupportKind::Pinned | SupportKind::Fixed)
}

pub(super) fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn add(sum: &mut [f64; 4], row: &[f64; 4]) {
    for (sum, r) in sum.iter_mut().zip(row) {
        *sum += r;
    }
}
