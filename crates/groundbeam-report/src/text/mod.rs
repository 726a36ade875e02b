//! Writes the report for a terminal, at most 80 columns wide.

pub(crate) mod certificate;
pub(crate) mod checks;
mod columns;
mod combinations;
mod comparison;
mod drawing;
pub(crate) mod factors;
pub(crate) mod free_spans;
mod ground;
mod passages;
pub(crate) mod proof;
mod results;
pub(crate) mod sheet;
mod study;
pub(crate) mod train;

use crate::characteristics::Characteristics;
use crate::checked::Row;
use crate::context::{Context, clean};
use crate::load::load_kind;
use crate::numbers::Numbers;
use crate::quantity::{Kind, Units, duration};
use crate::verdict::{self, wording};
pub use combinations::combinations;
pub(crate) use combinations::{
    all_of, bounded_band, bounded_envelope, of_limit_states, used_models,
};
pub use comparison::comparison;
pub use drawing::drawing;
pub(crate) use ground::of_each as ground_of_each;
use groundbeam::{
    Existence, Field, Load, Model, Solution, Stopped, Verdict,
    model::{Extent, GroundEnd, Profile},
};
pub(crate) use passages::used_models as used_by_trains;
pub use passages::{checked_trains, trains};
pub use proof::{proof, proofs, verified};
use results::{between, contact};
pub(crate) use results::{forces, results};
use sheet::{Sheet, Tone};
pub use study::study;

/// Maximum number of listed rows of one kind. The report states how many rows were omitted.
const MOST_ROWS: usize = 20;

/// The report of an equilibrium. `colour` adds escape codes for a terminal.
pub fn solved(solution: &Solution, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    let units = context.units;
    let numbers = Numbers::plain(solution, units).with_proof(context.proofs.first());
    problem(&mut sheet, solution.model(), solution.existence(), context);
    verdict_row(&mut sheet, solution.model(), solution.existence(), units);
    factors::rows(&mut sheet, context);
    sheet.blank();
    results(&mut sheet, solution, &numbers);
    sheet.blank();
    checks::rows(&mut sheet, solution, context);
    let verdict = solution.existence().verdict;
    certificate::rows(&mut sheet, solution.certificate(), verdict);
    sheet.blank();
    method(&mut sheet, solution, context);
    sheet.finish()
}

/// Rows beside the picture of a web page, each with a label and a text. The rows describe contact, forces,
/// extremes and checks. An empty label continues the previous row.
pub fn summary(solution: &Solution, context: &Context) -> Vec<(String, String)> {
    let mut sheet = Sheet::new(false);
    let numbers = Numbers::plain(solution, context.units);
    let (units, sizes) = (context.units, numbers.sizes());
    for warning in context.warnings {
        sheet.row("Caution", &clean(&warning.message));
    }
    contact(&mut sheet, solution, &numbers);
    forces(&mut sheet, solution, &numbers);
    for field in Field::of(&solution.model().beam) {
        let range = solution.range(field);
        let (min, max) = (sizes.extreme(field, range.min), sizes.extreme(field, range.max));
        let unit = units.unit(Kind::of(field), min.value.abs().max(max.value.abs()));
        let [low, high] = [min, max].map(|extreme| {
            format!("{} at {}", unit.write(extreme.value), units.position(extreme.x))
        });
        let words = if min.value == max.value {
            format!("{} everywhere", unit.write(max.value))
        } else {
            format!("from {low} to {high}")
        };
        sheet.row(field.label(), &words);
    }
    checks::rows(&mut sheet, solution, context);
    sheet.into_rows()
}

/// Labels and text of the verdicts on checks.
pub(crate) fn check_rows(rows: &[Row], context: &Context) -> Vec<(String, String)> {
    let mut sheet = Sheet::new(false);
    checks::all_rows(&mut sheet, rows, context);
    sheet.into_rows()
}

/// Labels and texts on the motion of a model without equilibrium, and on the force that would restore
/// equilibrium.
pub fn failing(model: &Model, existence: &Existence, context: &Context) -> Vec<(String, String)> {
    let Verdict::None(motion) = existence.verdict else { return Vec::new() };
    let row = |label: &str, words: String| (label.to_owned(), words);
    let remedy = verdict::remedy(motion, context.units).map(|words| row("Remedy", words));
    let motion = row("Motion", verdict::motion(model, motion, context.units));
    [motion].into_iter().chain(remedy).collect()
}

/// The report of an existence check. The report contains the verdict, but no fields of a solution.
pub fn existence(model: &Model, existence: &Existence, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    problem(&mut sheet, model, existence, context);
    verdict_row(&mut sheet, model, existence, context.units);
    factors::rows(&mut sheet, context);
    sheet.finish()
}

/// The report of a method that did not reach its tolerance.
pub fn not_converged(reached: &Stopped, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    sheet.toned_row("Not solved", &format!("no result: {reached}"), Tone::Bad);
    sheet.row("", "no result is given, since none could be certified");
    sheet.finish()
}

/// The load factors as a separate report; empty if they are not requested.
pub fn load_factors(context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    factors::rows(&mut sheet, context);
    sheet.finish()
}

/// Adds rows on title, beam, ground and loads.
fn problem(sheet: &mut Sheet, model: &Model, existence: &Existence, context: &Context) {
    let units = context.units;
    title(sheet, context);
    let found = Characteristics::of(model, existence);
    structure(sheet, &[model], &found, context);
    let force = found.resultant.force;
    let loads = match found.resultant.at {
        Some(x) => {
            let sense = if force > 0.0 { "down" } else { "up" };
            let share = units.ratio(x / model.beam.length);
            let size = units.write(Kind::Force, force.abs());
            format!("resultant {size} {sense} at x = {} ({share} l)", units.position(x))
        }
        None if model.loads.iter().all(Load::is_on_ground) => "none".to_owned(),
        None => "resultant zero".to_owned(),
    };
    sheet.row("Loads", &loads);
    let neighbours: Vec<&Load> = model.ground_loads().collect();
    listed(sheet, "On ground", &neighbours, |load| match load.extent() {
        Extent::Distributed { from, to, start, end } => {
            let size = range(units.of_input(), load_kind(load), [start, end]);
            format!("{size} {}", between(units.of_input(), from, to))
        }
        Extent::Point { at, size } => {
            let given = units.of_input();
            format!("{} at x = {}", given.write(load_kind(load), size), given.position(at))
        }
    });
    sheet.blank();
}

fn title(sheet: &mut Sheet, context: &Context) {
    if let Some(title) = context.clean_title() {
        sheet.heading(&title);
        sheet.blank();
    }
}

/// Adds the rows that describe the beam and the ground. For several models, which must have the same beam, the
/// rows give the range of each value.
pub(crate) fn structure(
    sheet: &mut Sheet,
    models: &[&Model],
    found: &Characteristics,
    context: &Context,
) {
    let (units, given) = (context.units, context.units.of_input());
    let [model, ..] = models else { return };
    let stiffnesses = ends(model.beam.segments.iter().map(|s| s.bending_stiffness));
    let stiffness =
        spread(given, Kind::BendingStiffness, model.beam.bending_stiffness, stiffnesses);
    let mut beam = format!("l = {}, EI = {stiffness}", given.position(model.beam.length));
    if model.beam.axial_force != 0.0 {
        let sense = if model.beam.axial_force > 0.0 { "tension" } else { "compression" };
        let force = given.write(Kind::Constant, model.beam.axial_force.abs());
        beam += &format!(", {sense} {force}");
    }
    sheet.row("Beam", &beam);
    if let Some(shear) = shear(model, units) {
        sheet.row("", &shear);
    }

    let grounds = || models.iter().map(|model| &model.foundation);
    let springs = ends(grounds().flat_map(|ground| &ground.segments).map(|s| s.subgrade));
    let shears = ends(grounds().flat_map(|ground| &ground.segments).map(|s| s.shear_layer));
    let springs = springs.chain(grounds().map(|ground| ground.subgrade));
    let shears = shears.chain(grounds().map(|ground| ground.shear_layer));
    let spring = spread(given, Kind::Spring, model.foundation.subgrade, springs);
    let shear = spread(given, Kind::Constant, model.foundation.shear_layer, shears);
    let is_winkler = found.shear_length[1] == 0.0;
    let constants = if is_winkler {
        format!("k = {spring}, no shear layer (Winkler)")
    } else {
        let length = range(units, Kind::Position, found.shear_length);
        format!("k = {spring}, mu = {shear}, shear length √(mu/k) = {length}")
    };
    sheet.row("Ground", &constants);
    ground::rows(sheet, model, context);
    for (side, end) in ["on the left", "on the right"].into_iter().zip(model.foundation.ends) {
        let words = match end {
            GroundEnd::Endless => continue,
            GroundEnd::Free { at } => format!("free at x = {}", given.position(at)),
            GroundEnd::Held { at } => format!("held at x = {}", given.position(at)),
        };
        sheet.row("", &format!("{side} it ends, {words}"));
    }

    if let Some(chords) = context.chords {
        let words =
            format!("the curve is replaced by {chords} chords; results are for this polygon");
        sheet.row("Trough", &words);
    }
    for warning in context.warnings {
        sheet.toned_row("Caution", &clean(&warning.message), Tone::Doubtful);
    }
    let beta = range(units, Kind::PerLength, found.beta);
    let beta_length = units.ratio(found.beta_length);
    sheet.row("Stiffness", &format!("β = {beta}, βl = {beta_length}: {}", found.class()));
}

/// Text with the shear stiffness of the beam and the ratio EI/(GA l²); `None` without shear deformation.
pub(crate) fn shear(model: &Model, units: Units) -> Option<String> {
    let beam = &model.beam;
    let segments: Vec<Profile> = beam.segments.iter().filter_map(|s| s.shear_stiffness).collect();
    let all: Vec<f64> =
        beam.shear_stiffness.into_iter().chain(ends(segments.into_iter())).collect();
    let first = *all.first()?;
    let stiffness = spread(units.of_input(), Kind::Constant, first, all.iter().copied());
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let number = beam.bending_stiffness / least / (beam.length * beam.length);
    let part = if beam.shear_stiffness.is_none() { ", in segments" } else { "" };
    Some(format!("shear: GA = {stiffness}{part}, EI/(GA l²) = {}", units.ratio(number)))
}

/// Text of a quantity that may vary, such as `2 MN` or `1 to 3 MN`.
fn spread(units: Units, kind: Kind, base: f64, others: impl Iterator<Item = f64>) -> String {
    let mut all = [base, base];
    for value in others {
        all = [all[0].min(value), all[1].max(value)];
    }
    range(units, kind, all)
}

/// The values at both ends of every segment.
fn ends(profiles: impl Iterator<Item = Profile>) -> impl Iterator<Item = f64> {
    profiles.flat_map(|profile| [profile.start(), profile.end()])
}

fn range(units: Units, kind: Kind, [low, high]: [f64; 2]) -> String {
    let unit = units.unit(kind, high);
    let [from, to] = [low, high].map(|value| unit.number(value));
    if from == to { unit.write(high) } else { format!("{from} to {}", unit.write(high)) }
}

pub(crate) fn verdict_row(sheet: &mut Sheet, model: &Model, existence: &Existence, units: Units) {
    let sentence = verdict::sentence(model, existence, units);
    let wording = wording(existence.verdict);
    sheet.toned_row("Equilibrium", &wording.with(&sentence), wording.tone);
    if let Verdict::None(motion) = existence.verdict {
        sheet.row("Motion", &verdict::motion(model, motion, units));
        if let Some(remedy) = verdict::remedy(motion, units) {
            sheet.row("Remedy", &remedy);
        }
    }
}

/// Adds one row for each item, or only the first rows if there are many items.
fn listed<T>(sheet: &mut Sheet, label: &str, items: &[T], write: impl Fn(&T) -> String) {
    for (i, item) in items.iter().take(MOST_ROWS).enumerate() {
        sheet.row(if i == 0 { label } else { "" }, &write(item));
    }
    if items.len() > MOST_ROWS {
        sheet.row("", &format!("and {} more", items.len() - MOST_ROWS));
    }
}

/// Columns of tables with several solutions. Each column has a field, and `true` for the largest value or
/// `false` for the smallest value.
pub(crate) const COLUMNS: [(Field, bool); 4] = [
    (Field::Deflection, true),
    (Field::Moment, false),
    (Field::Moment, true),
    (Field::Pressure, true),
];

/// Name of an extreme, such as `largest moment`.
pub(crate) fn extreme_of(field: Field, largest: bool) -> String {
    let which = if largest { "largest" } else { "smallest" };
    format!("{which} {}", field.label().to_lowercase())
}

fn method(sheet: &mut Sheet, solution: &Solution, context: &Context) {
    let counted = |count: usize, one: &str, many: &str| {
        format!("{count} {}", if count == 1 { one } else { many })
    };
    let steps = counted(solution.iterations(), "step", "steps");
    let pieces = match solution.method() {
        groundbeam::Method::Exact => counted(solution.elements(), "closed form", "closed forms"),
        _ => counted(solution.elements(), "element", "elements"),
    };
    let mut words = format!("{}, {pieces}, {steps}", solution.method().name());
    if let Some(seconds) = context.seconds {
        words += &format!(", {}", duration(seconds));
    }
    sheet.row("Method", &words);
}
