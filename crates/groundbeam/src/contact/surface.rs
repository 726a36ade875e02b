//! Computes the surface of the ground and the concentrated contact forces from a deflection and its contact zones.

use crate::contact::short_span;
use crate::ground::link::TwoPort;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;
use crate::mesh::open_ground::{heights, open_link, open_links};
use crate::numeric::real::Real;

/// A part of a cell that is in contact everywhere or nowhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SurfacePart<R = f64> {
    pub cell: usize,
    /// Left and right end of this part of the cell, in the local coordinate s ∈ \[−1, 1\] of the cell.
    pub s: [f64; 2],
    /// Ground displacement u minus free field u₀ at both ends of the part; `None` if the part is in contact.
    pub open: Option<[R; 2]>,
}

/// A concentrated contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PointForce<R = f64> {
    pub point: BeamPoint,
    pub force: R,
}

/// The surface of the ground under the beam.
#[derive(Debug, Clone)]
pub(crate) struct Surface<R = f64> {
    /// Parts of the surface from left to right. The parts cover all cells.
    pub parts: Vec<SurfacePart<R>>,
    /// Concentrated contact forces at point contacts, and at all points of contact zones where concentrated forces
    /// are possible ([`can_carry`]).
    pub point_forces: Vec<PointForce<R>>,
}

impl<R: Real> Surface<R> {
    pub fn of(w: &Deflection<R>, zones: &[MeshZone]) -> Self {
        let mut surface = Surface { parts: Vec::new(), point_forces: Vec::new() };
        for run in ground_runs(w.mesh) {
            let cells = run.cells.clone();
            let own: Vec<MeshZone> =
                zones.iter().filter(|z| cells.contains(&z.from.cell)).copied().collect();
            if run.pasternak {
                surface.add_pasternak(w, &run, &own);
            } else {
                surface.add_winkler(&run, &own);
            }
        }
        surface
    }

    fn add_winkler(&mut self, run: &GroundRun<R>, zones: &[MeshZone]) {
        let mut at = BeamPoint { cell: run.cells.start, s: -1.0 };
        let end = BeamPoint { cell: run.cells.end - 1, s: 1.0 };
        for zone in zones.iter().filter(|z| z.from != z.to) {
            self.cover(at, zone.from, Some([R::ZERO; 2]));
            self.cover(zone.from, zone.to, None);
            at = zone.to;
        }
        self.cover(at, end, Some([R::ZERO; 2]));
    }

    fn cover(&mut self, from: BeamPoint, to: BeamPoint, open: Option<[R; 2]>) {
        for cell in from.cell..=to.cell {
            let start = if cell == from.cell { from.s } else { -1.0 };
            let end = if cell == to.cell { to.s } else { 1.0 };
            if end > start {
                self.parts.push(SurfacePart { cell, s: [start, end], open });
            }
        }
    }

    fn add_pasternak(&mut self, w: &Deflection<R>, run: &GroundRun<R>, zones: &[MeshZone]) {
        let end = BeamPoint { cell: run.cells.end - 1, s: 1.0 };
        let mut left: Option<BeamPoint> = None;
        // On each side of a contact zone, the two-port of the ground out of contact gives the force on the ground
        // at the end of the zone.
        for (i, zone) in zones.iter().enumerate() {
            let before = self.open(w, run, left, Some(zone.from));
            let last = i + 1 == zones.len();
            let next = if last { None } else { Some(zones[i + 1].from) };
            let after = open_link(w.mesh, run, Some(zone.to), next);
            let fluxes = |ends: [Option<BeamPoint>; 2], link: Option<TwoPort<R>>| {
                short_span::fluxes(w, ends, &link.unwrap_or_default())
            };
            let [_, flux_in] = fluxes([left, Some(zone.from)], before);
            let [flux_out, _] = fluxes([Some(zone.to), next], after);
            if zone.from == zone.to {
                self.point_forces.push(PointForce { point: zone.from, force: flux_in + flux_out });
            } else {
                self.cover(zone.from, zone.to, None);
                self.add_zone_atoms(w, zone, flux_in, flux_out);
            }
            left = Some(zone.to);
        }
        if left != Some(end) {
            self.open(w, run, left, None);
        }
    }

    /// Adds the concentrated contact forces at the ends of a contact zone, and at points within the zone
    /// where concentrated forces are possible, such as corners of the initial gap.
    fn add_zone_atoms(&mut self, w: &Deflection<R>, zone: &MeshZone, flux_in: R, flux_out: R) {
        if can_carry(w.mesh, zone.from) {
            let force = flux_in - w.flux(zone.from);
            self.point_forces.push(PointForce { point: zone.from, force });
        }
        for cell in zone.from.cell + 1..=zone.to.cell {
            let [a, b] = [BeamPoint { cell: cell - 1, s: 1.0 }, BeamPoint { cell, s: -1.0 }];
            if can_carry(w.mesh, b) {
                self.point_forces.push(PointForce { point: b, force: w.flux(a) - w.flux(b) });
            }
        }
        if can_carry(w.mesh, zone.to) {
            self.point_forces
                .push(PointForce { point: zone.to, force: w.flux(zone.to) + flux_out });
        }
    }

    /// Adds the surface of the ground between two points to `self.parts`. This ground is out of contact with the
    /// beam. Returns the force–displacement relation of this ground.
    fn open(
        &mut self,
        w: &Deflection<R>,
        run: &GroundRun<R>,
        from: Option<BeamPoint>,
        to: Option<BeamPoint>,
    ) -> Option<TwoPort<R>> {
        let links = open_links(w.mesh, run, from, to);
        let start = from.map_or(R::ZERO, |point| w.obstacle_at(point));
        let end = to.map_or(R::ZERO, |point| w.obstacle_at(point));
        let row: Vec<TwoPort<R>> = links.iter().map(|(_, link)| *link).collect();
        let (values, whole) = heights(&row, [start, end]);
        for (i, (part, _)) in links.iter().enumerate() {
            if let Some((cell, s)) = *part {
                self.parts.push(SurfacePart { cell, s, open: Some([values[i], values[i + 1]]) });
            }
        }
        whole
    }

    /// Returns the parts of the surface. If EI or the ground varies, each part is divided into pieces on which
    /// short power series are sufficient.
    pub fn short_parts(&self, mesh: &Mesh<R>) -> Vec<SurfacePart<R>> {
        let mut parts = Vec::with_capacity(self.parts.len());
        for part in &self.parts {
            short_parts_of(mesh, part, &mut parts);
        }
        parts
    }

    /// Concentrated contact forces between beam and ground at the left and the right end of the beam.
    pub fn end_forces(&self, mesh: &Mesh<R>) -> [R; 2] {
        let last = mesh.cells.len() - 1;
        let at = |point: BeamPoint| {
            self.point_forces.iter().filter(|a| a.point == point).map(|a| a.force).sum::<R>()
        };
        [at(BeamPoint { cell: 0, s: -1.0 }), at(BeamPoint { cell: last, s: 1.0 })]
    }
}

/// Adds `part`, a part of the ground surface, to the list `parts`. If EI or the ground varies along it, adds
/// shorter pieces of it instead, on which short power series are sufficient.
pub(crate) fn short_parts_of<R: Real>(
    mesh: &Mesh<R>,
    part: &SurfacePart<R>,
    parts: &mut Vec<SurfacePart<R>>,
) {
    let cell = &mesh.cells[part.cell];
    if !cell.beam_varies() && !cell.ground_varies() {
        return parts.push(*part);
    }
    let short = |s: [f64; 2]| {
        let within = cell.part(s);
        let half = 0.25 * (s[1] - s[0]) * cell.length();
        within.is_smooth() && (part.open.is_none() || within.is_short_for_open_ground(half))
    };
    let mut cuts = vec![part.s[0]];
    halved(part.s, &short, MOST_HALVINGS, &mut cuts);
    cuts.push(part.s[1]);
    let runs = || cuts.windows(2).map(|s| [s[0], s[1]]);
    let values = match part.open {
        Some(ends) if cuts.len() > 2 && cell.shear_layer.value() > 0.0 => {
            let row: Vec<TwoPort<R>> = runs().map(|[a, b]| cell_part(cell, a, b)).collect();
            heights(&row, ends).0
        }
        _ => Vec::new(),
    };
    let at = |i: usize| values.get(i..i + 2).map(|u| [u[0], u[1]]);
    parts.extend(runs().enumerate().map(|(i, s)| SurfacePart {
        cell: part.cell,
        s,
        open: part.open.map(|ends| at(i).unwrap_or(ends)),
    }));
}

/// Maximum number of times that a part of the surface is halved.
const MOST_HALVINGS: u32 = 40;

fn halved(
    [from, to]: [f64; 2],
    short: &impl Fn([f64; 2]) -> bool,
    halvings: u32,
    cuts: &mut Vec<f64>,
) {
    if halvings == 0 || short([from, to]) {
        return;
    }
    let middle = 0.5 * (from + to);
    halved([from, middle], short, halvings - 1, cuts);
    cuts.push(middle);
    halved([middle, to], short, halvings - 1, cuts);
}

/// Whether a contact force can be concentrated at a point: an end of the beam, a jump of the shear layer, a corner of
/// the gap, a force on the ground, a hinge, or a kink of a beam with shear deformation.
pub(crate) fn can_carry<R: Real>(mesh: &Mesh<R>, point: BeamPoint) -> bool {
    let node = match point.s {
        -1.0 => point.cell,
        1.0 => point.cell + 1,
        _ => return false,
    };
    if node == 0 || node == mesh.cells.len() {
        return true;
    }
    let [left, right] = [&mesh.cells[node - 1], &mesh.cells[node]];
    left.shear_layer_ends()[1] != right.shear_layer_ends()[0]
        || left.gap_slope != right.gap_slope
        || mesh.nodes[node].hinge.is_some()
        || mesh.nodes[node].kinked
        || right.ground_force != 0.0
}
