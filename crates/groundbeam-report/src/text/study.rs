//! Writes the report of a study, with probabilities and their confidence intervals, means and quantiles.

use super::sheet::{Sheet, columns};
use super::{certificate, title};
use crate::context::{Context, clean};
use crate::number::significant;
use crate::quantity::{Units, duration};
use crate::study::{Estimate, Spread, Study, Way};

/// The terminal report of a study. `colour` adds escape codes.
pub fn study(study: &Study, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    title(&mut sheet, &Context { title: study.title.as_deref(), ..*context });
    let mut words = format!("{}, {}, seed {}", study.samples, study.sampling, study.seed);
    if study.replicates > 1 {
        words += &format!(", {} replicates", study.replicates);
    }
    sheet.row("Samples", &words);
    let mut words = format!("{} independent random numbers per sample", study.dimensions);
    if let Some(variance) = study.variance {
        words += &format!(
            "; the terms of the random fields contain {} % of the variance",
            significant(100.0 * variance, 4)
        );
    }
    sheet.row("Random", &words);
    let mut words = format!("{} certified", study.solved);
    for (count, what) in [
        (study.without_equilibrium, "without equilibrium"),
        (study.not_converged, "not converged"),
        (study.wrong, "refused (see the column `message` of the results)"),
    ] {
        if count > 0 {
            words += &format!(", {count} {what}");
        }
    }
    sheet.row("Solved", &words);
    sheet.blank();
    sheet.heading(&format!(
        "{:<33} {:>10} {:>11} {:>22}",
        "Event", "samples", "probability", "95 % interval"
    ));
    for Estimate { name, count, probability, interval, .. } in &study.events {
        let digits = interval.digits();
        let [low, high] = interval.bounds.map(|bound| significant(bound, digits));
        let name = cell(&clean(name), 33);
        let probability = significant(*probability, digits.max(4));
        sheet.line(&format!(
            "{name} {count:>10} {probability:>11} {:>22}",
            format!("{low} to {high}")
        ));
    }
    sheet.blank();
    sheet.heading(&format!(
        "{:<25} {:>10} {:>10} {:>10} {:>9} {:>9}",
        "", "mean", "deviation", "5 %", "50 %", "95 %"
    ));
    for spread in &study.spreads {
        sheet.line(&line(spread, context.units));
    }
    sheet.blank();
    let of = format!("for each of the {} solved", study.solved);
    certificate::of_several(&mut sheet, &of, study.largest_gap);
    let mut ways: Vec<Way> = Vec::new();
    for event in &study.events {
        if !ways.contains(&event.interval.by) {
            ways.push(event.interval.by);
        }
    }
    for (i, way) in ways.iter().enumerate() {
        let is_of_rare = ways.len() > 1 && *way == Way::Counts;
        let rare = if is_of_rare { " where an event occurred in few samples" } else { "" };
        let words = format!("{}{rare}", way.words());
        sheet.row(if i == 0 { "Intervals" } else { "" }, &words);
    }
    if let Some(seconds) = context.seconds {
        let rate = study.samples as f64 / seconds.max(1e-9);
        let words = format!("{}, {} samples a second", duration(seconds), significant(rate, 3));
        sheet.row("Time", &words);
    }
    sheet.finish()
}

fn line(spread: &Spread, units: Units) -> String {
    let (kind, largest) = (spread.kind, spread.largest());
    let number = |value: f64| match kind {
        Some(kind) => units.unit(kind, largest).number(value),
        None => units.ratio(value),
    };
    let unit = kind.map_or(String::new(), |kind| units.unit(kind, largest).bracketed());
    let label = cell(&(spread.label() + &unit), 25);
    let [mean, deviation, low, middle, high] = [
        spread.mean,
        spread.deviation,
        spread.quantiles[1],
        spread.quantiles[2],
        spread.quantiles[3],
    ]
    .map(number);
    format!("{label} {mean:>10} {deviation:>10} {low:>10} {middle:>9} {high:>9}")
}

/// The text, shortened or filled with spaces to `width` columns of the terminal.
fn cell(text: &str, width: usize) -> String {
    let mut cell = text.to_owned();
    if columns(&cell) > width {
        while columns(&cell) >= width {
            cell.pop();
        }
        cell.push('…');
    }
    let gap = width - columns(&cell);
    cell + &" ".repeat(gap)
}
