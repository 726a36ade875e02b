//! Writes the terminal report of one train's passage: the train, the envelope, and uplift near the axles.

use super::sheet::{COLUMN, Sheet, Tone};
use super::{certificate, checks, free_spans};
use crate::checked::Row;
use crate::context::{Context, clean};
use crate::extremes::{Extremes, cleaned, of_passage};
use crate::number::{order, significant};
use crate::quantity::{Kind, Units, duration};
use groundbeam::Field;
use groundbeam_file::{MovingTrain, Spread};
use groundbeam_run::Passage;

/// Maximum number of listed ranges of train positions without equilibrium. The report states how many further
/// ranges it omits.
const MOST_RANGES: usize = 8;

/// Adds the report of one passage. The rows on beam and ground precede this report.
pub(crate) fn train(sheet: &mut Sheet, passage: &Passage, context: &Context) {
    head(sheet, passage, context.units);
    if let Some(combination) = passage.combination() {
        sheet.row("", &format!("under the combination {}", clean(combination)));
    }
    positions(sheet, passage);
    failures(sheet, passage, "", context.units);
    if passage.solved().next().is_some() {
        sheet.blank();
        envelope(sheet, "Envelope", &of_passage(passage, context.units), context.units);
        sheet.blank();
        uplift(sheet, passage, context.units);
        free_spans::of_trains(sheet, std::slice::from_ref(passage), context.units);
        sheet.blank();
        limits(sheet, std::slice::from_ref(passage), context);
        proof(sheet, std::slice::from_ref(passage), context);
    }
}

/// Adds a row which says how the loads of unlimited length were placed, if a train has such loads.
pub(crate) fn places(sheet: &mut Sheet, all: &[Passage]) {
    if all.iter().any(|passage| passage.moving().spread != Spread::Everywhere) {
        let words = "unbounded loads were placed as listed, and the worst result counts; other placements \
                     were not tried: with lift-off there are no influence lines";
        sheet.row("Spread loads", words);
    }
}

/// Adds a row for each design check, with its largest utilization over all train positions.
pub(crate) fn limits(sheet: &mut Sheet, all: &[Passage], context: &Context) {
    checks::all_rows(sheet, &positions_of(all, context), context);
}

/// All positions of all passages, as input of the checks.
pub(crate) fn positions_of<'a>(all: &[Passage<'a>], context: &Context<'a>) -> Vec<Row<'a>> {
    let answers = all.iter().flat_map(|passage| passage.answers());
    answers.map(|answer| Row::of(answer, None, context.units)).collect()
}

/// Adds rows with the name and axles of the train, and its range of positions.
pub(crate) fn head(sheet: &mut Sheet, passage: &Passage, units: Units) {
    let MovingTrain { name, set, factor, dynamic, spread, train, range, .. } = passage.moving();
    let name = clean(name);
    if passage.is_without_train() {
        sheet.row("Train", &name);
        return;
    }
    let mut words = match set {
        Some(set) if *set != name => format!("{name}, set {set}"),
        _ => name,
    };
    if *factor != 1.0 {
        words += &format!(", factor {}", significant(*factor, 6));
    }
    if *dynamic != 1.0 {
        words += &format!(", axles also times {}", significant(*dynamic, 6));
    }
    if *spread != Spread::Everywhere {
        words += &format!(", spread load {}", spread.name());
    }
    let force: f64 = train.axles.iter().map(|axle| axle.force).sum();
    let given = units.of_input();
    let force = given.write(Kind::Force, force);
    words += &match train.axles.len() {
        0 => String::new(),
        1 => format!(": one axle of {force}"),
        count => {
            let length = given.position(train.length());
            format!(": {count} axles, {force} in total, over a length of {length}")
        }
    };
    for part in &train.uniform {
        words += &format!(", {}", given.write(Kind::Pressure, part.intensity));
        if part.from.is_finite() {
            words += &format!(" from {}", given.position(part.from));
        }
        if part.to.is_finite() {
            words += &format!(" to {}", given.position(part.to));
        }
    }
    sheet.row("Train", &words);
    let [from, to] = range.map(|x| given.position(x));
    sheet.row("", &format!("the first axle moves from {from} to {to}"));
}

pub(crate) fn positions(sheet: &mut Sheet, passage: &Passage) {
    let reach = passage.reach();
    let count = passage.solved().count();
    let (met, missed): (Vec<Field>, Vec<Field>) =
        passage.fields().partition(|&field| reach.of(field) <= reach.asked);
    let reached = met.into_iter().map(|field| reach.of(field)).fold(0.0, f64::max);
    let mut words = format!(
        "{count} solved; error of the envelope relative to each field's largest value: {} (requested: {})",
        order(reached),
        order(reach.asked)
    );
    for field in missed {
        let name = field.label().to_lowercase();
        words += &format!("; for the {name}: {}", order(reach.of(field)));
    }
    sheet.row("Positions", &words);
}

/// Adds rows with the ranges of train positions without equilibrium.
pub(crate) fn ranges(sheet: &mut Sheet, none: &[[f64; 2]], whose: &str, units: Units) {
    for (i, [from, to]) in none.iter().take(MOST_RANGES).enumerate() {
        let [from, to] = [from, to].map(|x| units.position(*x));
        let words = format!("{whose}no equilibrium: first axle from {from} to {to}");
        sheet.toned_row(if i == 0 { "Tips" } else { "" }, &words, Tone::Bad);
    }
    if let Some(more @ 1..) = none.len().checked_sub(MOST_RANGES) {
        sheet.row("", &format!("{whose}and {more} more ranges"));
    }
}

/// Adds rows with the ranges without equilibrium, and with the positions without a certified result.
pub(crate) fn failures(sheet: &mut Sheet, passage: &Passage, whose: &str, units: Units) {
    ranges(sheet, passage.without_equilibrium(), whose, units);
    let failed: Vec<f64> = passage.not_converged().collect();
    if let Some(first) = failed.first() {
        let first = units.position(*first);
        let words = format!("{whose}not solved: {} positions, the first at {first}", failed.len());
        sheet.toned_row("Not solved", &words, Tone::Bad);
    }
}

/// Adds a table of the extremes with their positions, the positions of the first axle and, for several passages, the
/// numbers of the passages.
pub(crate) fn envelope(sheet: &mut Sheet, heading: &str, all: &[Extremes], units: Units) {
    let numbers = all.iter().flat_map(|of| of.ends).filter_map(|end| end.number);
    let digits = numbers.max().map(|most| most.to_string().len());
    // The columns must hold wide values such as `−65570 lbf-ft`, which has 13 characters.
    let (label, value, place) = match digits {
        None => (13, 12, 9),
        Some(digits) => (12, 15 - digits.max(2), 8),
    };
    let line = |first: &str, ends: [[String; 4]; 2]| {
        let cell = |[number, x, train, which]: [String; 4]| {
            let cell = format!(" {number:>value$} {x:>place$} {train:>place$}");
            match digits {
                Some(digits) => format!("{cell} {which:>digits$}"),
                None => cell,
            }
        };
        format!("{first:<label$}{}", ends.map(cell).concat())
    };
    let train = if digits.is_some() { "train" } else { "train at" };
    let words = ["smallest", "largest"].map(|word| [word, "at", train, "#"].map(str::to_owned));
    let first = if heading.len() <= label { heading } else { "" };
    if first.is_empty() {
        sheet.heading(heading);
    }
    sheet.heading(&line(first, words));
    for extremes in all {
        let (name, unit) = (extremes.field.label(), extremes.unit);
        if let Some(same) = extremes.everywhere() {
            let (same, width) = (unit.write(same), label + 1 + value - COLUMN);
            sheet.row(
                name,
                &format!("{same:>width$} along the whole beam at every position of the train"),
            );
            continue;
        }
        let cells = extremes.ends.map(|end| {
            let first_axle = end.first_axle.map_or_else(String::new, |at| units.position(at));
            let number = end.number.map_or_else(String::new, |number| number.to_string());
            [unit.write(end.value), units.position(end.x), first_axle, number]
        });
        sheet.line(&line(name, cells));
    }
}

pub(crate) fn uplift(sheet: &mut Sheet, passage: &Passage, units: Units) {
    let uplift = passage.uplift();
    let rows = [
        ("ahead of the axles", uplift.ahead),
        ("between them", uplift.between),
        ("behind them", uplift.behind),
    ];
    for (i, (place, gap)) in rows.into_iter().enumerate() {
        let words = match gap.map(|gap| cleaned(passage, Field::Gap, gap)) {
            Some(gap) if gap.value != 0.0 => {
                let [x, at] = [gap.x, gap.first_axle].map(|x| units.write(Kind::Position, x));
                let value = units.write(Kind::Deflection, gap.value);
                format!("{place} up to {value}, at {x} with the first axle at {at}")
            }
            _ => format!("{place} none"),
        };
        sheet.row(if i == 0 { "Uplift" } else { "" }, &words);
    }
}

pub(crate) fn proof(sheet: &mut Sheet, all: &[Passage], context: &Context) {
    let solved = || all.iter().flat_map(Passage::solved);
    let gaps = solved().map(|(_, solution)| solution.certificate().relative_gap());
    certificate::of_several(sheet, "for each position", gaps.fold(0.0, f64::max));
    let method = solved().next().map_or("", |(_, solution)| solution.method().name());
    let mut words = method.to_owned();
    if let Some(seconds) = context.seconds {
        words += &format!(", {}", duration(seconds));
    }
    sheet.row("Method", &words);
}
