//! Writes a model as text and reads it back, with one line for each part and all bits of each number.

use super::record::{Line, Record};
use groundbeam::{
    Beam, Foundation, Hinge, Load, Model, Support, SupportKind,
    model::{Action, Acts, BeamSegment, Extent, FoundationSegment, GapPoint, GroundEnd, Profile},
};

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
    let Foundation { subgrade: spring, shear_layer: shear, segments: _, ends, soil } = foundation;
    assert!(soil.is_none(), "a frozen model gives k and mu");
    let [left, right] = ends.map(|end| match end {
        GroundEnd::Endless => "endless".to_owned(),
        GroundEnd::Free { at } => format!("free:{at:?}"),
        GroundEnd::Held { at } => format!("held:{at:?}"),
    });
    format!("ground {spring:?} {shear:?} {left} {right}")
}

fn of_ground_segment(segment: &FoundationSegment) -> String {
    let FoundationSegment { from, to, subgrade: spring, shear_layer: shear } = segment;
    format!("ground_segment {from:?} {to:?} {} {}", of_profile(spring), of_profile(shear))
}

fn of_profile(profile: &Profile) -> String {
    let values: Vec<String> =
        profile.control_values().iter().map(|value| format!("{value:?}")).collect();
    values.join(",")
}

fn of_load(load: &Load) -> String {
    let key = match (load.action(), load.extent().is_distributed(), load.is_on_ground()) {
        (Action::Force, false, false) => "point_force",
        (Action::Force, false, true) => "ground_force",
        (Action::Force, true, false) => "distributed_force",
        (Action::Force, true, true) => "ground_distributed",
        (Action::Moment, false, _) => "point_moment",
        (Action::Moment, true, _) => "distributed_moment",
        (Action::Curvature, ..) => "curvature",
    };
    match load.extent() {
        Extent::Point { at, size } => format!("{key} {at:?} {size:?}"),
        Extent::Distributed { from, to, start, end } => {
            format!("{key} {from:?} {to:?} {start:?} {end:?}")
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

/// Reads the model of a record.
///
/// # Errors
///
/// Returns the first line that does not belong to a model.
pub fn read(record: &Record) -> Result<Model, String> {
    let mut model = Model::new(Beam::uniform(0.0, 0.0), Foundation::winkler(0.0));
    for line in &record.lines {
        let Line { key, words } = line;
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        add(&mut model, key, &words).ok_or_else(|| {
            format!("{}: the line {line:?} does not describe a part of a model", record.title)
        })?;
    }
    Ok(model)
}

fn add(model: &mut Model, key: &str, words: &[&str]) -> Option<()> {
    let number = |i: usize| words.get(i)?.parse::<f64>().ok();
    match key {
        "beam" => {
            model.beam.length = number(0)?;
            model.beam.bending_stiffness = number(1)?;
            model.beam.shear_stiffness = unless_none(words.get(2)?, |word| word.parse().ok())?;
            model.beam.axial_force = number(3)?;
        }
        "beam_segment" => model.beam.segments.push(BeamSegment {
            from: number(0)?,
            to: number(1)?,
            bending_stiffness: profile(words.get(2)?)?,
            shear_stiffness: unless_none(words.get(3)?, profile)?,
        }),
        "ground" => {
            model.foundation.subgrade = number(0)?;
            model.foundation.shear_layer = number(1)?;
            model.foundation.ends = [ground_end(words.get(2)?)?, ground_end(words.get(3)?)?];
        }
        "ground_segment" => model.foundation.segments.push(FoundationSegment {
            from: number(0)?,
            to: number(1)?,
            subgrade: profile(words.get(2)?)?,
            shear_layer: profile(words.get(3)?)?,
        }),
        "support" => model.supports.push(Support {
            at: number(0)?,
            kind: support_kind(words.get(1)?)?,
            settlement: number(2)?,
            acts: acts(words.get(3)?)?,
        }),
        "hinge" => model.hinges.push(Hinge { at: number(0)?, rotational_spring: number(1)? }),
        "gap" => model.gap.push(GapPoint { at: number(0)?, value: number(1)? }),
        load => model.loads.push(read_load(load, number)?),
    }
    Some(())
}

fn read_load(key: &str, number: impl Fn(usize) -> Option<f64>) -> Option<Load> {
    match key {
        "point_force" => Some(Load::point_force(number(0)?, number(1)?)),
        "point_moment" => Some(Load::point_moment(number(0)?, number(1)?)),
        "ground_force" => Some(Load::ground_force(number(0)?, number(1)?)),
        _ => {
            let [from, to] = [number(0)?, number(1)?];
            let [start, end] = [number(2)?, number(3)?];
            match key {
                "distributed_force" => Some(Load::distributed_force(from, to, start, end)),
                "distributed_moment" => Some(Load::distributed_moment(from, to, start, end)),
                "curvature" => Some(Load::distributed_curvature(from, to, start, end)),
                "ground_distributed" => Some(Load::distributed_ground_force(from, to, start, end)),
                _ => None,
            }
        }
    }
}

/// Returns `Some(None)` for the word `-`, and otherwise the value of the word, if it can be read.
fn unless_none<T>(word: &str, read: impl Fn(&str) -> Option<T>) -> Option<Option<T>> {
    if word == "-" { Some(None) } else { read(word).map(Some) }
}

fn profile(word: &str) -> Option<Profile> {
    let values: Option<Vec<f64>> = word.split(',').map(|value| value.parse().ok()).collect();
    Profile::by_control_values(&values?)
}

fn ground_end(word: &str) -> Option<GroundEnd> {
    match word.split_once(':') {
        None => (word == "endless").then_some(GroundEnd::Endless),
        Some(("free", at)) => Some(GroundEnd::Free { at: at.parse().ok()? }),
        Some(("held", at)) => Some(GroundEnd::Held { at: at.parse().ok()? }),
        Some(_) => None,
    }
}

fn support_kind(word: &str) -> Option<SupportKind> {
    let parts: Vec<&str> = word.split(':').collect();
    match parts[..] {
        ["pinned"] => Some(SupportKind::Pinned),
        ["fixed"] => Some(SupportKind::Fixed),
        ["spring", spring, rotational_spring] => Some(SupportKind::Spring {
            spring: spring.parse().ok()?,
            rotational_spring: rotational_spring.parse().ok()?,
        }),
        _ => None,
    }
}

fn acts(word: &str) -> Option<Acts> {
    match word {
        "both" => Some(Acts::Both),
        "up" => Some(Acts::Up),
        "down" => Some(Acts::Down),
        _ => None,
    }
}
