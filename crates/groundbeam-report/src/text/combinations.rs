//! The report of all combinations: a table of them, the envelope, and every load case by itself.

use super::sheet::{Sheet, Tone};
use super::{COLUMNS, certificate, checks, extreme_of, structure, title};
use crate::characteristics::Characteristics;
use crate::combinations::{Numbered, noun, numbered};
use crate::context::{Context, clean};
use crate::number::significant;
use crate::quantity::{Kind, Unit, Units, duration};
use crate::verdict::{self, falls, wording};
use groundbeam::{Envelope, Extreme, Governing, Verdict};
use groundbeam_run::{Answer, Answers, Banded, Found, Ground};

/// The report of all combinations, solved or only checked; with `colour`, with escape codes for a terminal.
pub fn combinations(answers: &Answers, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    title(&mut sheet, context);
    let known = |answer: &Answer| {
        let existence = *answer.existence()?;
        Some(Characteristics::of(answer.model(), &existence))
    };
    let first = answers.list.iter().find_map(|answer| Some((answer, known(answer)?)));
    if let Some((answer, found)) = first {
        let ground = answer.ground.as_ref().filter(|ground| !ground.follows_solution());
        structure(&mut sheet, answer.model(), &found, &Context { ground, ..*context });
        let follows = |a: &Answer| a.ground.as_ref().is_some_and(Ground::follows_solution);
        if answers.list.iter().any(follows) {
            let words = "k and mu of each combination are those that its own solution makes of it; \
                         above stands the ground before anything is solved";
            sheet.row("Soil", words);
        }
        sheet.blank();
    }
    let solved: Vec<Numbered> = numbered(answers);
    if solved.is_empty() {
        verdicts(&mut sheet, answers, context.units);
    } else {
        names(&mut sheet, answers);
        sheet.blank();
        table(&mut sheet, answers, &solved, context.units);
    }
    failures(&mut sheet, answers, context.units);
    alone(&mut sheet, answers, context.units);
    if !solved.is_empty() {
        sheet.blank();
        envelope(&mut sheet, &answers.envelope(), &solved, context.units);
        sheet.blank();
        band(&mut sheet, answers, context.units);
        let named = |row: &Numbered<'_>| answers.list[row.number - 1].name();
        let all: Vec<_> = solved.iter().map(|row| (named(row), row.solution)).collect();
        checks::worst_rows(&mut sheet, &all, context);
        proof(&mut sheet, &solved);
        method(&mut sheet, answers, &solved, context);
    }
    sheet.finish()
}

/// Numbers and names.
fn names(sheet: &mut Sheet, answers: &Answers) {
    for (i, answer) in answers.list.iter().enumerate() {
        let name = format!("{:>4}  {}", i + 1, clean(answer.name()));
        sheet.row(if i == 0 { noun(answers) } else { "" }, &name);
    }
}

/// What the engineer judges by, on the best ground and between which bounds on all of them.
fn band(sheet: &mut Sheet, answers: &Answers, units: Units) {
    let Some(bands) = answers.bands() else { return };
    let heading = format!("{:<31}{:>14}{:>18}", "Band of grounds", "best ground", "all of them");
    sheet.heading(&heading);
    for (field, largest) in COLUMNS {
        let Banded { best, low, high } = bands[field.index()][usize::from(largest)];
        let unit = units.unit(Kind::of(field), low.abs().max(high.abs()));
        let name = extreme_of(field, largest);
        let best = unit.write(best, 6);
        let range = format!("{} to {}", unit.number(low, 6), unit.write(high, 6));
        sheet.line(&format!("{name:<31}{best:>14}    {range}"));
    }
    sheet.row("", "of the grounds that were solved; nothing is proven of those between them");
    sheet.blank();
}

/// Numbers, verdicts and names, where there is nothing else to tell.
fn verdicts(sheet: &mut Sheet, answers: &Answers, units: Units) {
    sheet.heading("   #  equilibrium  combination");
    for (i, answer) in answers.list.iter().enumerate() {
        let outcome = outcome(answer, units);
        let verdict = outcome.split(':').next().unwrap_or_default();
        sheet.line(&format!("{:>4}  {verdict:<13}{}", i + 1, clean(answer.name())));
    }
}

/// Verdict, contact and extremes, a line each.
fn table(sheet: &mut Sheet, answers: &Answers, solved: &[Numbered], units: Units) {
    let extremes = |row: &Numbered| {
        COLUMNS.map(|(field, largest)| {
            let range = row.solution.range(field);
            row.sizes.extreme(field, if largest { range.max } else { range.min }).value
        })
    };
    let values: Vec<[f64; 4]> = solved.iter().map(extremes).collect();
    // Both columns of a field are in one unit.
    let units_of_columns: [Unit; 4] = COLUMNS.map(|(field, _)| {
        let same = (0..4).filter(|&column| COLUMNS[column].0 == field);
        let sizes = same.flat_map(|column| values.iter().map(move |row| row[column].abs()));
        units.unit(Kind::of(field), sizes.fold(0.0, f64::max))
    });
    let line = |first: &str, cells: [String; 4]| {
        let cells: String = cells.iter().map(|cell| format!("{cell:>11}")).collect();
        format!("{first:<35}{cells}")
    };
    let fields = COLUMNS.map(|(field, _)| field.label().to_lowercase());
    sheet.heading(&line("   #  equilibrium  zones of  lifted", fields));
    let words = COLUMNS.map(|(_, largest)| if largest { "largest" } else { "smallest" }.to_owned());
    sheet.heading(&line("                    contact   share", words));
    if units == Units::Si {
        sheet.heading(&line("", units_of_columns.map(|unit| unit.name.to_owned())));
    }
    let mut rows = solved.iter().zip(&values).peekable();
    for (i, answer) in answers.list.iter().enumerate() {
        let words = outcome(answer, units);
        let Some((row, values)) = rows.next_if(|(row, _)| row.number == i + 1) else {
            sheet.line(&format!("{:>4}  {words}", i + 1));
            continue;
        };
        let zones = row.solution.contact().len();
        let share = format!("{} %", significant(100.0 * row.solution.lifted_share(), 3));
        let first = format!("{:>4}  {words:<11}{zones:>10}{share:>8}", i + 1);
        let cells = [0, 1, 2, 3].map(|i| units_of_columns[i].number(values[i], 5));
        sheet.line(&line(&first, cells));
    }
}

/// `one`, `many`, `none: it tips about its left end`.
fn outcome(answer: &Answer, units: Units) -> String {
    match answer.existence().map(|existence| existence.verdict) {
        Some(verdict @ Verdict::None(motion)) => wording(verdict).with(&falls(motion, units)),
        Some(verdict) => wording(verdict).short.to_owned(),
        None => "not solved".to_owned(),
    }
}

/// Why combinations have no answer, or more than one.
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

/// Whether each load case could stand by itself.
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

/// The extremes of all, each with the number of the combination that has it.
fn envelope(sheet: &mut Sheet, envelope: &Envelope, solved: &[Numbered], units: Units) {
    sheet.heading(&format!("{:<13}{:>14}{:>33}", "Envelope", "smallest", "largest"));
    for field in envelope.fields() {
        let range = envelope.range(field);
        let known = |Governing { extreme, by }: Governing| {
            let row = solved.get(by);
            let extreme = row.map_or(extreme, |row| row.sizes.extreme(field, extreme));
            (extreme, row.map_or(0, |row| row.number))
        };
        let [min, max] = [range.min, range.max].map(known);
        let unit = units.unit(Kind::of(field), min.0.value.abs().max(max.0.value.abs()));
        if min.0.value == max.0.value {
            let value = unit.write(min.0.value, 6);
            sheet.row(field.label(), &format!("{value:>14} everywhere, in every combination"));
            continue;
        }
        let cell = |(Extreme { x, value }, number): (Extreme, usize)| {
            let place = format!("at {}", units.position(x));
            format!("{:>14} {place:<13}{:<5}", unit.write(value, 6), format!("#{number}"))
        };
        sheet.row(field.label(), &format!("{}{}", cell(min), cell(max)));
    }
    for (name, force) in [
        ("left end", (|row| row.solution.end_forces().left) as fn(&Numbered) -> f64),
        ("right end", |row| row.solution.end_forces().right),
    ] {
        let mut most: Option<(usize, f64)> = None;
        for row in solved {
            let force = row.sizes.force(force(row));
            if most.is_none_or(|(_, other)| force > other) {
                most = Some((row.number, force));
            }
        }
        let Some((number, force)) = most else { continue };
        let words = match units.write(Kind::Force, force, 6) {
            nothing if force == 0.0 => format!("{name} {nothing} in every combination"),
            largest => format!("{name} up to {largest}, #{number}"),
        };
        sheet.row(if name == "left end" { "End forces" } else { "" }, &words);
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
