//! The report's section on the input: drawing, beam, ground, supports, loads and assumptions.

use super::content::{Block, Section, Table, facts, numbers, wording};
use super::equations;
use super::{Source, print};
use crate::characteristics::Characteristics;
use crate::context::{Context, clean};
use crate::load::{is_moment_per_length, load_name, load_size};
use crate::quantity::{Kind, Units};
use crate::svg::figures;
use crate::text;
use groundbeam::{
    Existence, Hinge, Method, Model, SupportKind,
    existence::RigidMotion,
    model::{Acts, Profile},
};

/// Returns the section on the input. `models` contains the model of a file or the models of its combinations.
/// `existence` is the result of the existence check, if it is known.
pub(super) fn section(
    models: &[&Model],
    existence: Option<&Existence>,
    motion: Option<RigidMotion>,
    context: &Context,
    source: &Source,
) -> Section {
    let units = context.units;
    let model = models.first().copied().unwrap_or(source.model);
    let caption = match motion {
        Some(_) => {
            "The model as given; dashed lines show the rigid motion in which the loads do work"
        }
        None => "The model as given",
    };
    let drawing = figures::model(source.model, motion, context);
    let mut blocks = vec![Block::Figure { svg: drawing, caption: caption.to_owned() }];
    if let Some(found) = existence.and_then(|of| Characteristics::of_all(models, of)) {
        blocks.extend(facts(|sheet| text::structure(sheet, models, &found, context)));
    }
    let units = units.of_input();
    blocks.extend(segments(model, units));
    blocks.extend(supports(model, units));
    blocks.extend(hinges(model, units));
    blocks.extend(gap(model, context));
    blocks.extend(loads(source, units));
    Section::new("Input", blocks)
}

fn unit_name(units: Units, kind: Kind, largest: f64) -> (crate::quantity::Unit, &'static str) {
    let unit = units.unit(kind, largest);
    (unit, unit.name)
}

/// Formats a profile as its constant value or as its values at both ends. A profile of degree 2 or higher is
/// marked as curved.
fn profile(units: Units, kind: Kind, profile: &Profile) -> String {
    let unit = units.unit(kind, profile.largest());
    if profile.is_constant() {
        return unit.write(profile.start());
    }
    let words = format!("{} to {}", unit.number(profile.start()), unit.write(profile.end()));
    if profile.control_values().len() > 2 { words + ", curved" } else { words }
}

fn segments(model: &Model, units: Units) -> Vec<Block> {
    let mut blocks = Vec::new();
    let (unit, name) = unit_name(units, Kind::Position, model.beam.length);
    if !model.beam.segments.is_empty() {
        let shears = model.beam.shears();
        let mut columns = vec![numbers("from", name), numbers("to", name), wording("EI")];
        columns.extend(shears.then(|| wording("GA")));
        let mut table = Table::new("Segments of the beam", columns);
        for segment in &model.beam.segments {
            let stiffness = profile(units, Kind::BendingStiffness, &segment.bending_stiffness);
            let own = segment.shear_stiffness.or(model.beam.shear_stiffness.map(Into::into));
            let shear = own.map_or("–".to_owned(), |own| profile(units, Kind::Constant, &own));
            let ends = [segment.from, segment.to].map(|x| unit.number(x));
            table.push(ends.into_iter().chain([stiffness]).chain(shears.then_some(shear)));
        }
        blocks.push(Block::Table(table));
    }
    if !model.foundation.segments.is_empty() {
        let columns = vec![numbers("from", name), numbers("to", name), wording("k"), wording("μ")];
        let mut table = Table::new("Segments of the ground", columns);
        for segment in &model.foundation.segments {
            table.push([
                unit.number(segment.from),
                unit.number(segment.to),
                profile(units, Kind::Spring, &segment.subgrade),
                profile(units, Kind::Constant, &segment.shear_layer),
            ]);
        }
        blocks.push(Block::Table(table));
    }
    blocks
}

fn supports(model: &Model, units: Units) -> Option<Block> {
    let (unit, name) = unit_name(units, Kind::Position, model.beam.length);
    let mut table = Table::new("Supports", vec![numbers("x", name), wording("kind")]);
    for support in &model.supports {
        let kind = match support.kind {
            SupportKind::Pinned => "pinned".to_owned(),
            SupportKind::Fixed => "fixed".to_owned(),
            SupportKind::Spring { spring, rotational_spring } => {
                // The constant of a support spring is a force per deflection. Its unit equals the unit of the
                // contact pressure, which is a force per length of the beam.
                let linear = units.write(Kind::Pressure, spring);
                let turning = units.write(Kind::Moment, rotational_spring);
                let per = units.per_radian();
                format!("spring {linear}, rotational spring {turning}{per}")
            }
        };
        let mut words = kind;
        words += match support.acts {
            Acts::Both => "",
            Acts::Up => ", acting up alone",
            Acts::Down => ", holding down alone",
        };
        if support.settlement != 0.0 {
            words += &format!(", settled by {}", units.write(Kind::Deflection, support.settlement));
        }
        table.push([unit.number(support.at), print::words(&words)]);
    }
    (!table.rows.is_empty()).then_some(Block::Table(table))
}

fn hinges(model: &Model, units: Units) -> Option<Block> {
    let (unit, name) = unit_name(units, Kind::Position, model.beam.length);
    let mut table = Table::new("Hinges", vec![numbers("x", name), wording("kind")]);
    for hinge in &model.hinges {
        let per = units.per_radian();
        let spring = units.write(Kind::Moment, hinge.rotational_spring);
        let kind =
            if hinge.is_free() { "free".to_owned() } else { format!("spring {spring}{per}") };
        table.push([unit.number(hinge.at), kind]);
    }
    (!table.rows.is_empty()).then_some(Block::Table(table))
}

/// Returns the table of the points of the initial gap. Returns `None` if chords replace settlement troughs,
/// because the ends of the chords follow from the troughs in the input file.
fn gap(model: &Model, context: &Context) -> Option<Block> {
    if context.chords.is_some() {
        return None;
    }
    let units = context.units.of_input();
    let deepest = model.gap.iter().fold(0.0_f64, |most, corner| most.max(corner.value.abs()));
    let (position, x) = unit_name(units, Kind::Position, model.beam.length);
    let (depth, clearance) = unit_name(units, Kind::Deflection, deepest);
    let columns = vec![numbers("x", x), numbers("clearance", clearance)];
    let mut table = Table::new("Initial gap, linear between these points", columns);
    for corner in &model.gap {
        table.push([position.number(corner.at), depth.number(corner.value)]);
    }
    (!table.rows.is_empty()).then_some(Block::Table(table))
}

fn loads(source: &Source, units: Units) -> Option<Block> {
    let model = source.model;
    let (unit, name) = unit_name(units, Kind::Position, model.beam.length);
    let has_cases = source.cases.iter().any(Option::is_some);
    let mut columns = vec![
        numbers("#", ""),
        wording("load"),
        numbers("from", name),
        numbers("to", name),
        wording("size"),
    ];
    if has_cases {
        columns.push(wording("case"));
    }
    let mut table = Table::new("Loads as written", columns);
    table.note = "Positive forces act downward. Positive moment loads act clockwise.".to_owned();
    for (i, load) in model.loads.iter().enumerate() {
        let [from, to] = load.extent().ends();
        let per = if is_moment_per_length(load, units) { " (moment per length)" } else { "" };
        let size = load_size(load, units, " to ") + per;
        let to = if from == to { String::new() } else { unit.number(to) };
        let mut row = vec![
            (i + 1).to_string(),
            load_name(load).to_owned(),
            unit.number(from),
            to,
            print::words(&size),
        ];
        if has_cases {
            let case = source.cases.get(i).and_then(Option::as_deref);
            row.push(case.map_or_else(|| "always".to_owned(), clean));
        }
        table.push(row);
    }
    (!table.rows.is_empty()).then_some(Block::Table(table))
}

/// Returns the section on the assumptions, the equations and the solution method.
pub(super) fn assumptions(model: &Model, method: Method) -> Section {
    let layer = model.foundation.shear_layer > 0.0
        || model.foundation.segments.iter().any(|segment| segment.shear_layer.largest() > 0.0);
    let ground = if layer {
        "The ground consists of springs k under a shear layer μ (Pasternak), also on both sides of the \
         beam."
    } else {
        "The ground consists of independent springs k (Winkler)."
    };
    let beam = if model.beam.shears() {
        "The beam has shear deformation (Timoshenko): plane sections remain plane and rotate by φ, w′ − φ is the shear force over \
         GA, small slopes, linearly elastic. Its slope jumps where a point force acts."
    } else {
        "The beam has no shear deformation (Euler–Bernoulli): plane sections remain plane, small slopes, linearly \
         elastic."
    };
    let mut items = vec![
        beam.to_owned(),
        ground.to_owned(),
        "The ground carries no tension: the contact pressure is zero where the beam lifts off. The contact zones \
         are unknowns of the problem. There is no friction."
            .to_owned(),
        "Loads are static. Superposition does not hold: each combination is solved separately.".to_owned(),
    ];
    if model.beam.axial_force != 0.0 {
        items.push(
            "The axial force is constant and acts on the deflected beam (second order).".to_owned(),
        );
    }
    let how = match method {
        Method::Exact => {
            "Between the contact edges the equations have closed-form solutions; the edges are unknowns, determined by \
             u′\u{a0}=\u{a0}w′ there (w\u{a0}=\u{a0}u\u{a0}+\u{a0}g₀ where μ\u{a0}=\u{a0}0). No mesh is used."
        }
        _ => {
            "The equations were solved on a mesh of elements; the error of the mesh is bounded in \
             the certificate."
        }
    };
    let source = "Numbers are those of N. Kikuchi, Beam bending problems on a Pasternak foundation using reciprocal \
                  variational inequalities (1980). Deflections w, u and forces are positive downward, pressures p and \
                  the end forces p₀, p_l push the beam up, M = −EI w″ is positive sagging, V = M′.";
    let text = |words: &str| Block::Text { words: words.to_owned() };
    let blocks = vec![
        Block::List { items },
        equations::problem(model.beam.shears()),
        text(how),
        text(source),
    ];
    Section::new("Assumptions and method", blocks)
}

/// Returns the section of the report that shows whether an equilibrium exists, from the loads and supports alone.
pub(super) fn statics(model: &Model, existence: &Existence, context: &Context) -> Section {
    let units = context.units;
    let mut blocks: Vec<Block> =
        facts(|sheet| text::verdict_row(sheet, model, existence, units)).into_iter().collect();
    let free = model.supports.is_empty() && model.beam.axial_force == 0.0;
    let free = free && !model.hinges.iter().any(Hinge::is_free);
    let [left, right] =
        existence.static_reactions.map(|force| print::words(&units.write(Kind::Force, force)));
    if free {
        let words = "A beam without supports has exactly one equilibrium if, and only if, both static \
                     reactions of its loads are positive, that is, if the resultant acts downward and inside the beam:";
        blocks.push(Block::Text { words: words.to_owned() });
        blocks.push(equations::static_reactions());
    }
    let sum = print::words(&units.write(Kind::Force, existence.resultant()));
    let place = existence.resultant_position(model.beam.length);
    let place = place.map_or_else(
        || "undefined".to_owned(),
        |x| {
            let share = units.ratio(x / model.beam.length);
            format!("x = {} = {share} l", units.position(x))
        },
    );
    let words = format!(
        "Here R₀ = {left} and R_l = {right}. The resultant is {sum}; its position is {}.",
        print::words(&place)
    );
    blocks.push(Block::Text { words });
    if model.hinges.iter().any(Hinge::is_free) {
        let each: Vec<String> = groundbeam::existence::static_reactions(model)
            .into_iter()
            .map(|(x, force)| {
                let words = format!("{} at {}", units.write(Kind::Force, force), units.position(x));
                print::words(&words)
            })
            .collect();
        let words = "Static reactions of the parts between free hinges, with each part supported at its ends:";
        blocks.push(Block::Text { words: format!("{words} {}.", each.join(", ")) });
    }
    blocks.extend(facts(|sheet| text::factors::rows(sheet, context)));
    Section::new("Equilibrium", blocks)
}
