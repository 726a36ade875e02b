//! From a deflection and its contact to a certified [`Solution`].

use crate::certificate::{Claim, ClaimedPiece, certify};
use crate::contact::recover;
use crate::contact::state::Found;
use crate::contact::surface::{Atom, Surface};
use crate::existence::existence::Existence;
use crate::ground::link::settled;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{Spot, pressure_under};
use crate::model::{Load, Model, Support, SupportKind};
use crate::numeric::polynomial::{Coefficients, derivative, product, rescale};
use crate::numeric::tolerance::same_place;
use crate::options::Method;
use crate::options::Pressure;
use crate::solution::solution::{
    ConcentratedForce, ContactRegion, EndForces, Reaction, Side, Solution, Stretch,
};

/// Everything a solution holds, and its certificate, in the memory of one that is no longer needed.
pub(crate) fn assemble(
    model: &Model,
    method: Method,
    existence: Existence,
    stability: f64,
    found: &Found,
    kept: Option<Box<Solution>>,
) -> Box<Solution> {
    let surface = match &found.surface {
        Some(given) => given,
        None => &Surface::of(&found.deflection(), &found.zones),
    };
    let mut solution = match kept {
        Some(mut kept) => {
            kept.model.become_like(model);
            kept
        }
        None => Box::new(Solution::without_fields(model.clone())),
    };
    let mesh = &found.mesh;
    let at = |atom: &Atom| mesh.cells[atom.spot.cell].global(atom.spot.s);
    let l = model.beam.length;
    // Adding zero turns −0 into 0.
    let [left, right] = surface.end_forces(mesh).map(|force| force + 0.0);
    let inner = surface.atoms.iter().filter(|atom| at(atom) > 0.0 && at(atom) < l);
    let inner = inner.filter(|atom| atom.force != 0.0);
    solution.concentrated.clear();
    solution
        .concentrated
        .extend(inner.map(|atom| ConcentratedForce { at: at(atom), force: atom.force }));
    regions(found, &mut solution.contact);
    stretches(found, surface, &mut solution.stretches);
    solution.method = method;
    solution.existence = existence.with_contact(model, &solution.contact_positions());
    solution.end_forces = EndForces { left, right };
    solution.elements = found.mesh.cells.len();
    solution.reactions = reactions(&solution);
    solution.certificate = certify(model, &claim(&solution, stability));
    solution
}

/// From the solution on the supports that act to the one of the whole model, whose others do not.
pub(crate) fn on_one_way_supports(
    solution: &mut Solution,
    model: &Model,
    acts: &[bool],
    existence: Existence,
    stability: f64,
) {
    let mut acting = std::mem::take(&mut solution.reactions).into_iter();
    let reaction = |(support, acts): (&Support, &bool)| {
        let none = Reaction { at: support.at, force: 0.0, moment: 0.0 };
        let mut reaction = if *acts { acting.next().unwrap_or(none) } else { none };
        // What rounding alone makes act the wrong way.
        if support.acts.sign() * reaction.force < 0.0 {
            reaction.force = 0.0;
        }
        reaction
    };
    solution.reactions = model.supports.iter().zip(acts).map(reaction).collect();
    let carries = |i: usize| solution.reactions[i].force != 0.0;
    let holding = model.with_supports_that(|i, support| !support.is_one_way() || carries(i));
    solution.existence = existence.with_contact(&holding, &solution.contact_positions());
    solution.model.become_like(model);
    solution.certificate = certify(model, &claim(solution, stability));
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
        rotation: &stretch.rotation,
        pressure: &stretch.pressure,
        open: stretch.open.map(|ends| {
            let own = [-1.0, 1.0].map(|s| stretch.cell.settled_at(s)[0]);
            [ends[0] + own[0], ends[1] + own[1]]
        }),
    });
    Claim {
        pieces: pieces.collect(),
        forces,
        reactions: solution.reactions.iter().map(|r| (r.at, r.force, r.moment)).collect(),
        stability,
    }
}

fn stretches(found: &Found, surface: &Surface, stretches: &mut Vec<Stretch>) {
    let w = found.deflection();
    let parts = surface.short_parts(&found.mesh);
    let exact = found.terms > crate::element::cubic::TERMS;
    let recovered = if exact {
        Vec::new()
    } else {
        // Forces at nodes are the elements' own business: only those within a cell are needed, and nodal
        // pressures (5.5) have none.
        let within = surface.atoms.iter().filter(|a| a.spot.s.abs() < 1.0);
        let forces: Vec<(usize, f64, f64)> =
            within.map(|a| (a.spot.cell, a.spot.s, a.force)).collect();
        recover::moments(found, &parts, &forces)
    };
    let mut recovered = recovered.into_iter();
    stretches.clear();
    stretches.reserve(parts.len());
    for part in &parts {
        let [from, to] = part.s;
        let (middle, quarter) = (0.5 * (from + to), 0.5 * (to - from));
        let half = 0.5 * found.mesh.cells[part.cell].length() * quarter;
        let (cell, deflection) = if part.s == [-1.0, 1.0] {
            (found.mesh.cells[part.cell], w.cell(part.cell).into())
        } else {
            let cell = found.mesh.cells[part.cell].part(part.s);
            (cell, rescale(w.cell(part.cell), middle, quarter))
        };
        let touching = part.open.is_none() && found.pressure == Pressure::Distributed;
        let pressure = if touching {
            pressure_under(&cell, half, &deflection)
        } else {
            Coefficients::default()
        };
        let rotation = match cell.beam_shear {
            Some(_) if part.s == [-1.0, 1.0] => found.rotation(part.cell),
            Some(_) => rescale(&found.rotation(part.cell), middle, quarter),
            None => Coefficients::default(),
        };
        let moment = recovered.next().unwrap_or_else(|| bent(&cell, half, &deflection, &rotation));
        let settlement = match part.open {
            Some(ends) if cell.ground_varies() && cell.shear > 0.0 => {
                settled(&cell.spring_course(), &cell.shear_course(), half, ends)
            }
            _ => Coefficients::default(),
        };
        stretches.push(Stretch {
            half,
            x: cell.x,
            cell,
            deflection,
            rotation,
            moment,
            pressure,
            open: part.open,
            settlement,
        });
    }
}

/// The coefficients of M = −EI (φ' − κ₀), with φ = w' where the beam does not shear.
fn bent(cell: &Cell, half: f64, deflection: &[f64], rotation: &[f64]) -> Coefficients {
    let times = if cell.beam_varies() { 1.0 } else { cell.stiffness };
    let (factor, mut bend) = if rotation.is_empty() {
        (-times / (half * half), derivative(&derivative(deflection)))
    } else {
        (-times / half, derivative(rotation))
    };
    for c in bend.iter_mut() {
        *c *= factor;
    }
    let bent = if cell.beam_varies() { product(&cell.stiffness_course(), &bend) } else { bend };
    if !cell.is_curled() {
        return bent;
    }
    let curling = cell.curling_moment();
    let mut moment = bent.at_least(curling.len());
    for (moment, curling) in moment.iter_mut().zip(curling.iter()) {
        *moment += curling;
    }
    moment
}

/// Stretches and points of contact, those that meet joined.
fn regions(found: &Found, regions: &mut Vec<ContactRegion>) {
    let mesh = &found.mesh;
    let position = |spot: Spot| mesh.cells[spot.cell].global(spot.s);
    regions.clear();
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
}

/// From the equilibrium of the beam about each support, and the springs' own laws.
fn reactions(solution: &Solution) -> Vec<Reaction> {
    let supports = &solution.model.supports;
    let reaction = |support: &Support| {
        let x = support.at;
        let (force, moment) = match support.kind {
            SupportKind::Pinned => (lift(solution, x), 0.0),
            SupportKind::Fixed => (lift(solution, x), turn(solution, x)),
            SupportKind::Spring { spring, rotational_spring } => {
                let here = solution.at(x, Side::Right);
                let pressed = here.deflection - support.settlement;
                (spring * pressed, -rotational_spring * here.rotation)
            }
        };
        Reaction { at: x, force, moment }
    };
    supports.iter().map(reaction).collect()
}

/// The force of a support at x: what the beam between the middles of the spans on both sides of it lacks
/// to be in equilibrium. Next to a pin, where the beam hardly does more than turn, an element's own shear
/// has lost its digits; half a span away it has not.
fn lift(solution: &Solution, x: f64) -> f64 {
    let model = &solution.model;
    let (axial, l) = (model.beam.axial_force, model.beam.length);
    let others = || model.supports.iter().map(|support| support.at);
    let span_left = others().filter(|&at| at < x).fold(0.0, f64::max);
    let span_right = others().filter(|&at| at > x).fold(l, f64::min);
    // T = V + P w' − g at an end of a stretch.
    let total = |stretch: &Stretch, s: f64, end: usize| {
        let fields = stretch.fields(s);
        fields.shear_force + axial * fields.slope - stretch.cell.moment_load[end]
    };
    let stretches = &solution.stretches;
    let holding = |x: f64| stretches.partition_point(|s| s.x[1] < x).min(stretches.len() - 1);
    let (first, from, before) = if x <= 0.0 {
        (0, 0.0, 0.0)
    } else {
        let i = holding(0.5 * (span_left + x));
        (i + 1, stretches[i].x[1], total(&stretches[i], 1.0, 1))
    };
    let (end, to, after) = if x >= l {
        (stretches.len(), l, 0.0)
    } else {
        let i = holding(0.5 * (x + span_right));
        (i, stretches[i].x[0], total(&stretches[i], -1.0, 0))
    };
    let near = same_place(l);
    let inside = |at: f64| from - near <= at && at <= to + near;
    let mut force = after - before;
    for stretch in stretches.get(first..end).unwrap_or_default() {
        let even = stretch.pressure.iter().enumerate().step_by(2);
        let pressure: f64 = even.map(|(j, c)| c / (j + 1) as f64).sum();
        let [left, right] = stretch.cell.load;
        force += stretch.half * (left + right - 2.0 * pressure);
    }
    for load in &model.loads {
        if let Load::PointForce { at, force: load } = *load
            && inside(at)
        {
            force += load;
        }
    }
    let EndForces { left, right } = solution.end_forces;
    let ends = [(0.0, left), (l, right)];
    let contact = solution.concentrated.iter().map(|c| (c.at, c.force)).chain(ends);
    force - contact.filter(|(at, _)| inside(*at)).map(|(_, force)| force).sum::<f64>()
}

/// The moment of a fixed support at x: the jump of the beam's own less the loads'.
fn turn(solution: &Solution, x: f64) -> f64 {
    let l = solution.model.beam.length;
    let before = if x <= 0.0 { 0.0 } else { solution.at(x, Side::Left).moment };
    let after = if x >= l { 0.0 } else { solution.at(x, Side::Right).moment };
    let loads = solution.model.loads.iter().map(|load| match *load {
        Load::PointMoment { at, moment } if (at - x).abs() <= same_place(l) => moment,
        _ => 0.0,
    });
    after - before - loads.sum::<f64>()
}
