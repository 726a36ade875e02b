//! Writes a model as text, with one line for each part and all bits of each number.

use groundbeam::{Beam, Foundation, Hinge, Load, Model, Support, SupportKind, model::{Acts, BeamSegment, FoundationSegment, GapPoint, GroundEnd, Profile}};

/// The lines of a model.
pub fn text(model: &Model) -> String {
    let Model { beam, foundation, loads, supports, hinges, gap } = model;
    let mut lines = vec![of_beam(beam)];
    lines.extend(beam.segments.iter().map(of_beam_segment));
    lines.push(of_ground(foundation));
    lines.extend(foundation.segments.iter().map(of_ground_segment));
    lines.extend(loads.iter().map(of_load));
    lines.extend(supports.iter().map(of_support));
    lines.extend(
        hinges
            .iter()
            .map(|Hinge { at, rotational_spring }| format!("hinge {at:?} {rotational_spring:?}")),
    );
    lines.extend(gap.iter().map(|GapPoint { at, value }| format!("gap {at:?} {value:?}")));
    lines.iter().map(|line| format!("{line}\n")).collect()
}

fn of_beam(beam: &Beam) -> String {
    let Beam { length, bending_stiffness, shear_stiffness, segments: _, axial_force } = beam;
    let shear = shear_stiffness.map_or("-".to_owned(), |shear| format!("{shear:?}"));
    format!("beam {length:?} {bending_stiffness:?} {shear} {axial_force:?}")
}

fn of_beam_segment(segment: &BeamSegment) -> String {
    let BeamSegment { from, to, bending_stiffness, shear_stiffness } = segment;
    let shear = shear_stiffness.map_or("-".to_owned(), |shear| of_profile(&shear));
    format!("beam_segment {from:?} {to:?} {} {shear}", of_profile(bending_stiffness))
}

fn of_ground(foundation: &Foundation) -> String {
    let Foundation { spring, shear, segments: _, ends } = foundation;
    let [left, right] = ends.map(|end| match end {
        GroundEnd::Endless => "endless".to_owned(),
        GroundEnd::Free { at } => format!("free:{at:?}"),
        GroundEnd::Held { at } => format!("held:{at:?}"),
    });
    format!("ground {spring:?} {shear:?} {left} {right}")
}

fn of_ground_segment(segment: &FoundationSegment) -> String {
    let FoundationSegment { from, to, spring, shear } = segment;
    format!("ground_segment {from:?} {to:?} {} {}", of_profile(spring), of_profile(shear))
}

fn of_profile(profile: &Profile) -> String {
    let values: Vec<String> =
        profile.control_values().iter().map(|value| format!("{value:?}")).collect();
    values.join(",")
}

fn of_load(load: &Load) -> String {
    match load {
        Load::PointForce { at, force } => format!("point_force {at:?} {force:?}"),
        Load::PointMoment { at, moment } => format!("point_moment {at:?} {moment:?}"),
        Load::Distributed { from, to, start, end } => {
            format!("distributed_force {from:?} {to:?} {start:?} {end:?}")
        }
        Load::DistributedMoment { from, to, start, end } => {
            format!("distributed_moment {from:?} {to:?} {start:?} {end:?}")
        }
        Load::Curvature { from, to, start, end } => {
            format!("curvature {from:?} {to:?} {start:?} {end:?}")
        }
        Load::GroundForce { at, force } => format!("ground_force {at:?} {force:?}"),
        Load::GroundDistributed { from, to, start, end } => {
            format!("ground_distributed {from:?} {to:?} {start:?} {end:?}")
        }
    }
}

fn of_support(support: &Support) -> String {
    let Support { at, kind, settlement, acts } = support;
    let kind = match kind {
        SupportKind::Pinned => "pinned".to_owned(),
        SupportKind::Fixed => "fixed".to_owned(),
        SupportKind::Spring { spring, rotational_spring } => {
            format!("spring:{spring:?}:{rotational_spring:?}")
        }
    };
    let acts = match acts {
        Acts::Both => "both",
        Acts::Up => "up",
        Acts::Down => "down",
    };
    format!("support {at:?} {kind} {settlement:?} {acts}")
}
