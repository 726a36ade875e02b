//! Computes the fields, contact zones and forces of a [`Candidate`] from a deflection and its contact set.

use crate::contact::state::ContactState;
use crate::contact::surface::{PointForce, Surface};
use crate::mesh::deflection::BeamPoint;
use crate::model::support::Reaction;
use crate::model::{Action, Model, Support};
use crate::numeric::sum::Rounded;
use crate::numeric::tolerance::same_place;
use crate::solution::candidate::{Candidate, Workspace};
use crate::solution::fields::{ConcentratedForce, ContactZone, EndForces, Side, SolutionPiece};

impl Candidate {
    /// Computes a candidate solution (fields, contact zones and forces) from the deflection and the contact set
    /// `found`. The lists of the candidate reuse the memory of `workspace`.
    pub fn of(model: &Model, found: &ContactState, workspace: &mut Workspace) -> Self {
        let surface = match &found.surface {
            Some(given) => given,
            None => &Surface::of(&found.deflection(), &found.zones),
        };
        let mut candidate = workspace.blank(model);
        let mesh = &found.mesh;
        let at = |point_force: &PointForce| {
            mesh.cells[point_force.point.cell].global(point_force.point.s)
        };
        let l = model.beam.length;
        // Adding zero changes −0 to 0.
        let [left, right] = surface.end_forces(mesh).map(|force| force + 0.0);
        let inner = surface
            .point_forces
            .iter()
            .filter(|point_force| at(point_force) > 0.0 && at(point_force) < l);
        let inner = inner.filter(|point_force| point_force.force != 0.0);
        let concentrated = &mut candidate.concentrated;
        concentrated.extend(inner.map(|point_force| ConcentratedForce {
            at: at(point_force),
            force: point_force.force,
        }));
        regions(found, &mut candidate.contact);
        pieces(found, surface, &mut candidate.pieces);
        candidate.end_forces = EndForces { left, right };
        candidate.edge_error.clone_from(&found.edge_error);
        candidate.elements = found.nodal_elements.unwrap_or(mesh.cells.len());
        candidate.reactions = reactions(&candidate);
        candidate
    }

    /// Converts a candidate of a model from which the inactive supports were removed to a candidate of the whole
    /// model. The inactive supports get zero reactions.
    pub fn on_one_way_supports(self, model: &Model, acts: &[bool]) -> Self {
        let mut acting = self.reactions.into_iter();
        let reaction = |(support, acts): (&Support, &bool)| {
            let none = Reaction { at: support.at, force: 0.0, moment: 0.0 };
            let mut reaction = if *acts { acting.next().unwrap_or(none) } else { none };
            // A reaction with the wrong sign is rounding error.
            if support.acts.sign() * reaction.force < 0.0 {
                reaction.force = 0.0;
            }
            reaction
        };
        let reactions = model.supports.iter().zip(acts).map(reaction).collect();
        Candidate { reactions, model: model.clone(), ..self }
    }
}

fn pieces(found: &ContactState, surface: &Surface, pieces: &mut Vec<SolutionPiece>) {
    let w = found.deflection();
    let parts = surface.short_parts(&found.mesh);
    let presses = found.nodal_elements.is_none();
    pieces.reserve(parts.len());
    for part in &parts {
        let cell = &found.mesh.cells[part.cell];
        let rotation = cell.beam_shear.map(|_| found.rotation(part.cell));
        pieces.push(SolutionPiece::of(cell, part, w.cell(part.cell), rotation.as_deref(), presses));
    }
}

/// Appends the contact zones and contact points to `regions`. Adjacent zones are merged.
fn regions(found: &ContactState, regions: &mut Vec<ContactZone>) {
    let mesh = &found.mesh;
    let position = |point: BeamPoint| mesh.cells[point.cell].global(point.s);
    for zone in &found.zones {
        let (from, to) = (position(zone.from), position(zone.to));
        match regions.last_mut() {
            Some(last) if last.to == from => last.to = to,
            _ => regions.push(ContactZone { from, to }),
        }
    }
}

/// The pieces that end at x.
fn pieces_beside(candidate: &Candidate, x: f64) -> impl Iterator<Item = &SolutionPiece> {
    let near = same_place(candidate.model.beam.length);
    let is_end = move |end: &f64| (end - x).abs() <= near;
    candidate.pieces.iter().filter(move |piece| piece.x.iter().any(is_end))
}

/// The deflection and the rotation at x. Their sizes are bounds of their terms in the pieces beside x.
fn motion(candidate: &Candidate, x: f64) -> [Rounded; 2] {
    let here = candidate.at(x, Side::Right);
    let mut motion = [here.deflection, here.rotation].map(|value| Rounded { value, size: 0.0 });
    for piece in pieces_beside(candidate, x) {
        let size = |c: &[f64]| c.iter().map(|c| c.abs()).sum::<f64>();
        let slopes = piece.deflection.iter().enumerate().map(|(j, c)| j as f64 * c / piece.half);
        let slopes: Vec<f64> = slopes.collect();
        motion[0].size = motion[0].size.max(size(&piece.deflection));
        motion[1].size = motion[1].size.max(size(&slopes));
    }
    motion
}

/// Computes the reactions of the supports.
fn reactions(candidate: &Candidate) -> Vec<Reaction> {
    let reaction = |support: &Support| {
        let x = support.at;
        support.reaction(|| motion(candidate, x), || lift(candidate, x), || turn(candidate, x))
    };
    candidate.model.supports.iter().map(reaction).collect()
}

/// Force of a rigid support at x, from the equilibrium of the beam between the middles of the adjacent spans. The shear
/// force is accurate there, but not near the support.
fn lift(candidate: &Candidate, x: f64) -> Rounded {
    let model = &candidate.model;
    let (axial, l) = (model.beam.axial_force, model.beam.length);
    let others = || model.supports.iter().map(|support| support.at);
    let span_left = others().filter(|&at| at < x).fold(0.0, f64::max);
    let span_right = others().filter(|&at| at > x).fold(l, f64::min);
    // `total` computes the transverse force T = V + P w' − g at an end of a piece, with the axial tension P
    // and the distributed moment g.
    let total = |piece: &SolutionPiece, s: f64, end: usize| {
        let fields = piece.fields(s);
        fields.shear_force + axial * fields.slope - piece.cell.moment_load[end]
    };
    let pieces = &candidate.pieces;
    let holding = |x: f64| pieces.partition_point(|s| s.x[1] < x).min(pieces.len() - 1);
    let mut force = Rounded::default();
    let (first, from, before) = if x <= 0.0 {
        (0, 0.0, 0.0)
    } else {
        let i = holding(0.5 * (span_left + x));
        force.size += third_derivative_size(&pieces[i]);
        (i + 1, pieces[i].x[1], total(&pieces[i], 1.0, 1))
    };
    let (end, to, after) = if x >= l {
        (pieces.len(), l, 0.0)
    } else {
        let i = holding(0.5 * (x + span_right));
        force.size += third_derivative_size(&pieces[i]);
        (i, pieces[i].x[0], total(&pieces[i], -1.0, 0))
    };
    let near = same_place(l);
    let inside = |at: f64| from - near <= at && at <= to + near;
    force.add(after);
    force.add(-before);
    for piece in pieces.get(first..end).unwrap_or_default() {
        let even = piece.pressure.iter().enumerate().step_by(2);
        let pressure: f64 = even.map(|(j, c)| c / (j + 1) as f64).sum();
        let [left, right] = piece.cell.load;
        force.add(piece.half * (left + right - 2.0 * pressure));
    }
    for load in &model.loads {
        if let Some((at, load)) = load.at_point(Action::Force)
            && inside(at)
        {
            force.add(load);
        }
    }
    let EndForces { left, right } = candidate.end_forces;
    let ends = [(0.0, left), (l, right)];
    let contact = candidate.concentrated.iter().map(|c| (c.at, c.force)).chain(ends);
    contact.filter(|(at, _)| inside(*at)).for_each(|(_, ground)| force.add(-ground));
    force
}

/// The size of EI w‴ in a piece, if the rounding error of each coefficient is proportional to the deflection w.
fn third_derivative_size(piece: &SolutionPiece) -> f64 {
    let deflection: f64 = piece.deflection.iter().map(|c| c.abs()).sum();
    piece.cell.stiffness * deflection / (piece.half * piece.half * piece.half)
}

/// Moment of a fixed support at x: the jump of the bending moment at x minus the moment loads at x.
fn turn(candidate: &Candidate, x: f64) -> Rounded {
    let l = candidate.model.beam.length;
    let before = if x <= 0.0 { 0.0 } else { candidate.at(x, Side::Left).moment };
    let after = if x >= l { 0.0 } else { candidate.at(x, Side::Right).moment };
    let loads = candidate.model.loads.iter().map(|load| match load.at_point(Action::Moment) {
        Some((at, moment)) if (at - x).abs() <= same_place(l) => moment,
        _ => 0.0,
    });
    let mut moment = Rounded::default();
    for piece in pieces_beside(candidate, x) {
        moment.size += third_derivative_size(piece) * piece.half;
    }
    moment.add(after);
    moment.add(-before);
    loads.for_each(|load| moment.add(-load));
    moment
}
