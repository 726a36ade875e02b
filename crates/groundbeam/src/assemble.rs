//! From a deflection and its contact to a certified [`Solution`].

use crate::certificate::{Claim, ClaimedPiece, certify};
use crate::contact::active_set::{Found, Pressure};
use crate::contact::layout::gap_at;
use crate::contact::majorant::{Spot, pressure_of};
use crate::contact::recover;
use crate::contact::surface::{Atom, Part, Surface};
use crate::existence::Existence;
use crate::mesh::{Cell, Mesh};
use crate::model::{Model, SupportKind};
use crate::polynomial::rescale;
use crate::solution::{
    ConcentratedForce, ContactRegion, EndForces, Reaction, Side, Solution, Stretch,
};
use crate::solve::Method;

/// Everything a solution holds, and its certificate.
pub(crate) fn assemble(
    model: &Model,
    method: Method,
    existence: Existence,
    stability: f64,
    found: Found,
) -> Solution {
    let given = found.surface.clone();
    let surface = given.unwrap_or_else(|| Surface::of(&found.deflection(), &found.zones));
    let stretches = stretches(&found, &surface);
    let mesh = &found.mesh;
    let at = |atom: &Atom| mesh.cells[atom.spot.cell].global(atom.spot.s);
    let l = model.beam.length;
    // Adding zero turns −0 into 0.
    let [left, right] = surface.end_forces(mesh).map(|force| force + 0.0);
    let inner = surface.atoms.iter().filter(|atom| at(atom) > 0.0 && at(atom) < l);
    let concentrated: Vec<ConcentratedForce> = inner
        .filter(|atom| atom.force != 0.0)
        .map(|atom| ConcentratedForce { at: at(atom), force: atom.force })
        .collect();
    let mut solution = Solution {
        model: model.clone(),
        method,
        existence,
        contact: regions(&found),
        end_forces: EndForces { left, right },
        concentrated,
        reactions: Vec::new(),
        certificate: Default::default(),
        history: found.history,
        elements: found.mesh.cells.len(),
        stretches,
    };
    solution.reactions = reactions(&solution);
    solution.certificate = certify(model, &claim(&solution, stability));
    solution
}

/// What the certificate is asked to prove.
fn claim(solution: &Solution, stability: f64) -> Claim<'_> {
    let EndForces { left, right } = solution.end_forces;
    let l = solution.model.beam.length;
    let mut forces = vec![(0.0, left)];
    forces.extend(solution.concentrated.iter().map(|c| (c.at, c.force)));
    forces.push((l, right));
    let pieces = solution.stretches.iter().map(|stretch| ClaimedPiece {
        x: stretch.x,
        half: stretch.half,
        deflection: &stretch.deflection,
        pressure: &stretch.pressure,
        open: stretch.open,
    });
    Claim {
        pieces: pieces.collect(),
        forces,
        reactions: solution.reactions.iter().map(|r| (r.at, r.force, r.moment)).collect(),
        stability,
    }
}

fn stretches(found: &Found, surface: &Surface) -> Vec<Stretch> {
    let w = found.deflection();
    let exact = found.terms > crate::elements::hermite::TERMS;
    let recovered = if exact {
        Vec::new()
    } else {
        // Forces at nodes are the elements' own business: only those within a cell are needed, and nodal
        // pressures (5.5) have none.
        let within = surface.atoms.iter().filter(|a| a.spot.s.abs() < 1.0);
        let forces: Vec<(usize, f64, f64)> =
            within.map(|a| (a.spot.cell, a.spot.s, a.force)).collect();
        recover::moments(found, &surface.parts, &forces)
    };
    let mut recovered = recovered.into_iter();
    let mut stretches = Vec::with_capacity(surface.parts.len());
    for part in &surface.parts {
        let cell = cut(&found.mesh, part);
        let [from, to] = part.s;
        let (middle, quarter) = (0.5 * (from + to), 0.5 * (to - from));
        let half = 0.5 * found.mesh.cells[part.cell].length() * quarter;
        let whole = part.s == [-1.0, 1.0];
        let deflection = if whole {
            w.cell(part.cell).to_vec()
        } else {
            rescale(w.cell(part.cell), middle, quarter)
        };
        let touching = part.open.is_none() && found.pressure == Pressure::Distributed;
        let pressure = if touching {
            let mut obstacle = deflection.clone();
            obstacle[0] -= 0.5 * (cell.gap[0] + cell.gap[1]);
            obstacle[1] -= cell.gap_slope * half;
            pressure_of(&cell, half, &obstacle)
        } else {
            Vec::new()
        };
        let moment = recovered.next().unwrap_or_else(|| {
            let factor = -cell.stiffness / (half * half);
            let bend = deflection.iter().enumerate().skip(2);
            bend.map(|(j, c)| factor * (j * (j - 1)) as f64 * c).collect()
        });
        stretches.push(Stretch {
            half,
            x: cell.x,
            cell,
            deflection,
            moment,
            pressure,
            open: part.open,
        });
    }
    stretches
}

/// A cell cut to a part of it.
fn cut(mesh: &Mesh, part: &Part) -> Cell {
    let cell = mesh.cells[part.cell];
    let linear = |v: [f64; 2]| part.s.map(|s| 0.5 * (v[0] + v[1]) + 0.5 * (v[1] - v[0]) * s);
    Cell {
        x: part.s.map(|s| cell.global(s)),
        load: linear(cell.load),
        moment_load: linear(cell.moment_load),
        gap: part.s.map(|s| gap_at(&cell, s)),
        ..cell
    }
}

/// Stretches and points of contact, those that meet joined.
fn regions(found: &Found) -> Vec<ContactRegion> {
    let mesh = &found.mesh;
    let position = |spot: Spot| mesh.cells[spot.cell].global(spot.s);
    let mut regions: Vec<ContactRegion> = Vec::new();
    let mut last_node = None;
    for zone in &found.zones {
        let (from, to) = (position(zone.from), position(zone.to));
        // Nodal contact: nodes that follow one another are a stretch.
        let node = zone.from.cell + usize::from(zone.from.s == 1.0);
        let nodal = found.pressure == Pressure::Dirac;
        let follows = nodal && last_node.is_some_and(|last: usize| last + 1 == node);
        last_node = Some(node);
        match regions.last_mut() {
            Some(last) if last.to == from || follows => last.to = to,
            _ => regions.push(ContactRegion { from, to }),
        }
    }
    regions
}

/// From the jumps of shear and moment at each support, and the springs' own laws.
fn reactions(solution: &Solution) -> Vec<Reaction> {
    let model = &solution.model;
    let axial = model.beam.axial_force;
    let mesh = Mesh::build(model, &[], |_| 1);
    let total = |x: f64, side: Side| {
        let i = mesh.cells.partition_point(|c| c.x[1] < x);
        let beyond = match side {
            Side::Left => x <= 0.0,
            Side::Right => x >= model.beam.length,
        };
        if beyond {
            return [0.0, 0.0];
        }
        let fields = solution.at(x, side);
        // g at x from the given side.
        let cell = match side {
            Side::Left => &mesh.cells[i],
            Side::Right => &mesh.cells[mesh.cell_at(x)],
        };
        let g = if cell.x[0] >= x { cell.moment_load[0] } else { cell.moment_load[1] };
        [fields.shear_force + axial * fields.slope - g, fields.moment]
    };
    model
        .supports
        .iter()
        .map(|support| {
            let x = support.at;
            let [before, after] = [total(x, Side::Left), total(x, Side::Right)];
            let node = mesh.nodes.iter().find(|n| (n.x - x).abs() <= 1e-12 * model.beam.length);
            let (force, moment) = node.map_or((0.0, 0.0), |n| (n.force, n.moment));
            let contact: f64 =
                solution.concentrated.iter().filter(|c| c.at == x).map(|c| c.force).sum::<f64>()
                    + if x == 0.0 { solution.end_forces.left } else { 0.0 }
                    + if x == model.beam.length { solution.end_forces.right } else { 0.0 };
            let up = after[0] - before[0] + force - contact;
            let turn = after[1] - before[1] - moment;
            let (force, moment) = match support.kind {
                SupportKind::Pinned => (up, 0.0),
                SupportKind::Fixed => (up, turn),
                SupportKind::Spring { spring, rotational_spring } => {
                    let here = solution.at(x, Side::Right);
                    (spring * here.deflection, -rotational_spring * here.slope)
                }
            };
            Reaction { at: x, force, moment }
        })
        .collect()
}
