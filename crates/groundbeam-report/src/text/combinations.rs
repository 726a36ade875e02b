//! Writes the terminal report of all combinations: a table, the envelope, and each load case alone.

use super::columns::Columns;
use super::sheet::{Sheet, Tone};
use super::{COLUMNS, certificate, checks, extreme_of, ground, structure, title};
use crate::bound::with_bound;
use crate::characteristics::Characteristics;
use crate::checked::rows_of;
use crate::combinations::{
    Numbered, bound_of_extreme, bounds_of_band, largest_end_force, noun, numbered, of_limit_state,
};
use crate::context::{Context, clean};
use crate::extremes::{End, of_combinations};
use crate::quantity::{Kind, Units, duration};
use crate::verdict::{self, falls, wording};
use groundbeam::{
    Model, Verdict,
    design::LimitState,
    envelope::{Envelope, Governing},
};
use groundbeam_run::{Answer, Answers, Banded, Found, Ground};

/// The report of all combinations, whether they are solved or only checked for equilibrium. `colour` adds
/// escape codes for a terminal.
pub fn combinations(answers: &Answers, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    title(&mut sheet, context);
    let first = answers.list.iter().find_map(|answer| Some((answer, *answer.existence()?)));
    if let Some((answer, existence)) = first {
        let ground = answer.ground.as_ref().filter(|ground| !ground.follows_solution());
        let used = used_models(answers);
        let models = used.clone().unwrap_or_else(|| vec![answer.model()]);
        if let Some(found) = Characteristics::of_all(&models, &existence) {
            structure(&mut sheet, &models, &found, &Context { ground, ..*context });
        }
        if answers.list.iter().any(follows_solution) {
            let (own, used) = (answer.ground.as_ref(), used.unwrap_or_default());
            ground::of_each(&mut sheet, "combination", own, &used, context.units);
        }
        sheet.blank();
    }
    let solved: Vec<Numbered> = numbered(answers, context);
    let have_bounds = !context.proofs.is_empty();
    if solved.is_empty() {
        verdicts(&mut sheet, answers, context.units);
    } else {
        names(&mut sheet, answers);
        sheet.blank();
        match have_bounds {
            true => bounded_table(&mut sheet, answers, &solved, context.units),
            false => table(&mut sheet, answers, &solved, context.units),
        }
    }
    failures(&mut sheet, answers, context.units);
    alone(&mut sheet, answers, context.units);
    if !solved.is_empty() {
        sheet.blank();
        match have_bounds {
            true => bounded_envelope(&mut sheet, &answers.envelope(), &solved, context.units),
            false => envelope(&mut sheet, "Envelope", &answers.envelope(), &solved, context.units),
        }
        sheet.blank();
        of_limit_states(&mut sheet, answers, &solved, context);
        match have_bounds {
            true => bounded_band(&mut sheet, answers, &solved, context.units),
            false => band(&mut sheet, answers, context.units),
        }
        checks::all_rows(&mut sheet, &rows_of(answers, context), context);
        proof(&mut sheet, &solved);
        method(&mut sheet, answers, &solved, context);
    }
    sheet.finish()
}

fn follows_solution(answer: &Answer) -> bool {
    answer.ground.as_ref().is_some_and(Ground::follows_solution)
}

/// The models of all solutions, if the ground constants depend on the solution; otherwise `None`.
pub(crate) fn used_models(answers: &Answers) -> Option<Vec<&Model>> {
    let models: Vec<&Model> = answers.solved().map(|(_, solution)| solution.model()).collect();
    (!models.is_empty() && answers.list.iter().any(follows_solution)).then_some(models)
}

/// Adds rows with the numbers and names of the combinations.
fn names(sheet: &mut Sheet, answers: &Answers) {
    for (i, answer) in answers.list.iter().enumerate() {
        let name = format!("{:>4}  {}", i + 1, clean(answer.name()));
        sheet.row(if i == 0 { noun(answers) } else { "" }, &name);
    }
}

/// Adds the governing quantities: their values for the best estimates of k and μ, and their ranges over all
/// pairs (k, μ) for which the model was solved.
fn band(sheet: &mut Sheet, answers: &Answers, units: Units) {
    let Some(bands) = answers.bands() else { return };
    let heading = format!("{:<31}{:>14}{:>18}", "Band of grounds", "best ground", "all grounds");
    sheet.heading(&heading);
    for (field, largest) in COLUMNS {
        let Banded { best, low, high } = bands[field.index()][usize::from(largest)];
        let unit = units.unit(Kind::of(field), low.abs().max(high.abs()));
        let name = extreme_of(field, largest);
        let best = unit.write(best);
        let range = format!("{} to {}", unit.number(low), unit.write(high));
        sheet.line(&format!("{name:<31}{best:>14}    {range}"));
    }
    sheet
        .row("", "the ranges cover only the k and mu for which the model was solved; nothing is proven for other values");
    sheet.blank();
}

/// Adds the governing quantities with error bounds: their values for the best estimates of k and μ, and their
/// ranges over all pairs (k, μ) for which the model was solved.
pub(crate) fn bounded_band(
    sheet: &mut Sheet,
    answers: &Answers,
    solved: &[Numbered],
    units: Units,
) {
    let Some(bands) = answers.bands() else { return };
    sheet.heading("Band of grounds");
    for (field, largest) in COLUMNS {
        let banded = bands[field.index()][usize::from(largest)];
        let Banded { best, low, high } = banded;
        let unit = units.unit(Kind::of(field), low.abs().max(high.abs()));
        let [of_best, of_low, of_high] = bounds_of_band(solved, field, largest, &banded);
        let best = with_bound(best, of_best, unit);
        let [low, high] = [(low, of_low), (high, of_high)].map(|(x, e)| with_bound(x, e, unit));
        let name = extreme_of(field, largest);
        sheet.row("", &format!("{name}: {best} with the best estimates of k and mu; {low} to {high} over all pairs of k and mu for which the model was solved"));
    }
    sheet
        .row("", "the ranges cover only the k and mu for which the model was solved; nothing is proven for other values");
    sheet.blank();
}

/// Adds a table with the numbers, verdicts and names of the combinations, for reports without solutions.
fn verdicts(sheet: &mut Sheet, answers: &Answers, units: Units) {
    sheet.heading("   #  equilibrium  combination");
    for (i, answer) in answers.list.iter().enumerate() {
        let outcome = outcome(answer, units);
        let verdict = outcome.split(':').next().unwrap_or_default();
        sheet.line(&format!("{:>4}  {verdict:<13}{}", i + 1, clean(answer.name())));
    }
}

/// Adds a table with the verdict, contact and extremes of each combination.
fn table(sheet: &mut Sheet, answers: &Answers, solved: &[Numbered], units: Units) {
    let extremes = |row: &Numbered| {
        COLUMNS.map(|(field, largest)| {
            let range = row.solution.range(field);
            let extreme = if largest { range.max } else { range.min };
            Some(row.sizes.extreme(field, extreme).value)
        })
    };
    let values: Vec<[Option<f64>; 4]> = solved.iter().map(extremes).collect();
    let first = ["   #  equilibrium  zones of  lifted", "                    contact   share"];
    let columns = Columns::headed(sheet, first, [35, 10], &values, units);
    let mut rows = solved.iter().zip(&values).peekable();
    for (i, answer) in answers.list.iter().enumerate() {
        let words = outcome(answer, units);
        let Some((row, values)) = rows.next_if(|(row, _)| row.number == i + 1) else {
            sheet.line(&format!("{:>4}  {words}", i + 1));
            continue;
        };
        let zones = row.solution.contact().len();
        let share = row.numbers(units).lifted_share(row.solution);
        let first = format!("{:>4}  {words:<11}{zones:>9} {share:>8}", i + 1);
        sheet.line(&columns.row(&first, values));
    }
}

/// Adds a table with the verdict, contact and proof of each combination. The extremes of each combination
/// follow further below, with their error bounds.
fn bounded_table(sheet: &mut Sheet, answers: &Answers, solved: &[Numbered], units: Units) {
    sheet.heading("   #  equilibrium  zones of contact  proof       lifted share");
    let mut rows = solved.iter().peekable();
    for (i, answer) in answers.list.iter().enumerate() {
        let words = outcome(answer, units);
        let Some(row) = rows.next_if(|row| row.number == i + 1) else {
            sheet.line(&format!("{:>4}  {words}", i + 1));
            continue;
        };
        let zones = row.solution.contact().len();
        let proven = row.proof.is_some_and(|named| named.is_proven());
        let proof = if proven { "proven" } else { "not proven" };
        let share = row.numbers(units).lifted_share(row.solution);
        sheet.line(&format!("{:>4}  {words:<11}{zones:>18}  {proof:<12}{share}", i + 1));
    }
}

/// Verdict on a combination, such as `one`, `not unique`, or `none: the beam tips about its left end`.
fn outcome(answer: &Answer, units: Units) -> String {
    match answer.existence().map(|existence| existence.verdict) {
        Some(verdict @ Verdict::None(motion)) => wording(verdict).with(&falls(motion, units)),
        Some(verdict) => wording(verdict).short.to_owned(),
        None => "not solved".to_owned(),
    }
}

/// Adds the reasons why combinations have no result or no unique equilibrium.
fn failures(sheet: &mut Sheet, answers: &Answers, units: Units) {
    let mut begun = false;
    for (i, answer) in answers.list.iter().enumerate() {
        let number = format!("{:>4}", i + 1);
        let said = match &answer.found {
            Found::NotConverged(reached) => Some((format!("not solved: {reached}"), Tone::Bad)),
            Found::Unsolved(error) => Some((format!("not solved: {error}"), Tone::Bad)),
            _ => answer.existence().and_then(|existence| {
                let mut reason = verdict::sentence(answer.model(), existence, units);
                if let Verdict::None(motion) = existence.verdict
                    && let Some(remedy) = verdict::remedy(motion, units)
                {
                    reason += &format!("; {remedy}");
                }
                let wording = wording(existence.verdict);
                (wording.tone != Tone::Good).then(|| (wording.with(&reason), wording.tone))
            }),
        };
        if let Some((words, tone)) = said {
            if !begun {
                sheet.blank();
            }
            begun = true;
            sheet.toned_row(&number, &words, tone);
        }
    }
}

/// Adds rows that state whether each load case alone has an equilibrium.
fn alone(sheet: &mut Sheet, answers: &Answers, units: Units) {
    for (i, case) in answers.alone.iter().enumerate() {
        if i == 0 {
            sheet.blank();
        }
        let sentence = verdict::sentence(&case.case.model, &case.existence, units);
        let state = if case.stands() { "stands by itself" } else { "not a physical state" };
        let words = format!("{}, {state}: {sentence}", clean(&case.case.name));
        sheet.row(if i == 0 { "Cases alone" } else { "" }, &words);
    }
}

/// A sentence that replaces the envelope of a limit state if this envelope equals the envelope of all
/// combinations.
pub(crate) fn all_of(state: LimitState) -> String {
    format!("all solved combinations belong to {}", state.name())
}

/// Adds the envelopes of the limit states. A sentence replaces an envelope that equals the envelope of all
/// combinations.
pub(crate) fn of_limit_states(
    sheet: &mut Sheet,
    answers: &Answers,
    solved: &[Numbered],
    context: &Context,
) {
    for state in answers.limit_states().iter() {
        let of_state = of_limit_state(answers, solved, state);
        if of_state.len() == solved.len() {
            sheet.row("", &all_of(state));
            sheet.blank();
            continue;
        }
        let all = Envelope::of(of_state.iter().map(|row| row.solution));
        match context.proofs.is_empty() {
            true => envelope(sheet, state.name(), &all, &of_state, context.units),
            false => {
                sheet.heading(&format!("Of the limit state {}:", state.name()));
                bounded_envelope(sheet, &all, &of_state, context.units);
            }
        }
        sheet.blank();
    }
}

/// Adds the smallest and the largest value of each field over all combinations, each with the number of the
/// governing combination.
fn envelope(
    sheet: &mut Sheet,
    heading: &str,
    envelope: &Envelope,
    solved: &[Numbered],
    units: Units,
) {
    sheet.heading(&format!("{heading:<18} {:>8}{:>33}", "smallest", "largest"));
    for extremes in of_combinations(envelope, solved, units) {
        let (label, unit) = (extremes.field.label(), extremes.unit);
        if let Some(value) = extremes.everywhere() {
            let value = unit.write(value);
            sheet.row(label, &format!("{value:>14} everywhere, in every combination"));
            continue;
        }
        let cell = |end: End| {
            let place = format!("at {}", units.position(end.x));
            let number = format!("#{}", end.number.unwrap_or_default());
            format!("{:>14} {place:<12} {number:<4} ", unit.write(end.value))
        };
        sheet.row(label, &extremes.ends.map(cell).concat());
    }
    end_forces(sheet, solved, units);
}

/// Adds the extremes of each field over all combinations, with error bounds and governing combinations. A position has
/// a bound only if the combination is proven to govern.
pub(crate) fn bounded_envelope(
    sheet: &mut Sheet,
    envelope: &Envelope,
    solved: &[Numbered],
    units: Units,
) {
    sheet.heading("Envelope: smallest and largest values");
    for field in envelope.fields() {
        let range = envelope.range(field);
        let values = [range.min, range.max].map(|governing| governing.extreme.value);
        let unit = units.unit(Kind::of(field), values[0].abs().max(values[1].abs()));
        for (is_max, governing) in [(false, range.min), (true, range.max)] {
            let Governing { extreme, by } = governing;
            let Some(row) = solved.get(by) else { continue };
            let (error, leads) = bound_of_extreme(solved, field, is_max, governing);
            let numbers = row.numbers(units);
            let (place, number) = match leads {
                true => (numbers.place_of(field, is_max, extreme.x), format!("#{}", row.number)),
                false => {
                    (numbers.place_without_bound(extreme.x), format!("#{} or another", row.number))
                }
            };
            let value = with_bound(extreme.value, error, unit);
            let label = if is_max { "" } else { field.label() };
            sheet.row(label, &format!("{value} at {place}, {number}"));
        }
    }
    end_forces(sheet, solved, units);
}

/// Adds rows with the largest force under each end of the beam over all combinations.
fn end_forces(sheet: &mut Sheet, solved: &[Numbered], units: Units) {
    for (end, name) in ["left end", "right end"].into_iter().enumerate() {
        let Some((row, force, error)) = largest_end_force(solved, end) else { continue };
        let unit = units.unit(Kind::Force, force);
        let largest = match row.proof {
            None => unit.write(force),
            Some(_) => with_bound(force, error, unit),
        };
        let words = match force {
            0.0 => format!("{name} {largest} in every combination"),
            _ => format!("{name} up to {largest}, #{}", row.number),
        };
        sheet.row(if end == 0 { "End forces" } else { "" }, &words);
    }
}

fn proof(sheet: &mut Sheet, solved: &[Numbered]) {
    let gap =
        solved.iter().map(|row| row.solution.certificate().relative_gap()).fold(0.0, f64::max);
    certificate::of_several(sheet, &format!("for each of the {} solved", solved.len()), gap);
}

fn method(sheet: &mut Sheet, answers: &Answers, solved: &[Numbered], context: &Context) {
    let all = answers.list.len();
    let name = solved.first().map_or("", |row| row.solution.method().name());
    let mut words = format!("{name}, {} of {all} combinations solved", solved.len());
    if let Some(seconds) = context.seconds {
        words += &format!(", {}", duration(seconds));
    }
    sheet.row("Method", &words);
}
