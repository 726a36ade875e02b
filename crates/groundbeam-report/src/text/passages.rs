//! Writes the terminal report of moving trains: one passage alone, or several passages with their joint envelope.

use super::columns::Columns;
use super::combinations::all_of;
use super::sheet::Sheet;
use super::train::{envelope, failures, limits, places, proof, ranges, train};
use super::{COLUMNS, free_spans, ground, structure, title};
use crate::characteristics::Characteristics;
use crate::context::{Context, clean};
use crate::extremes::{cleaned, of_passages};
use crate::quantity::{Kind, Units};
use groundbeam::{Field, Model};
use groundbeam_run::{Ground, Overall, Passage, Passages};

/// Returns the report on the passages of trains. `colour` adds escape codes for a terminal.
pub fn trains(passages: &Passages, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    title(&mut sheet, context);
    let all = &passages.all[..];
    let first = all.iter().find_map(|passage| {
        let (_, solution) = passage.solved().next()?;
        Some((passage.model(), solution))
    });
    if let Some((model, solution)) = first {
        let follows = context.ground.is_some_and(Ground::follows_solution);
        let models = if follows { used_models(all) } else { vec![model] };
        if let Some(found) = Characteristics::of_all(&models, solution.existence()) {
            let ground = context.ground.filter(|_| !follows);
            structure(&mut sheet, &models, &found, &Context { ground, ..*context });
        }
        if follows {
            ground::of_each(&mut sheet, "position", context.ground, &models, context.units);
        }
    }
    if let [passage] = all {
        train(&mut sheet, passage, context);
        return sheet.finish();
    }
    sheet.blank();
    for (i, passage) in all.iter().enumerate() {
        let name = format!("{:>4}  {}", i + 1, clean(&passage.label()));
        sheet.row(if i == 0 { "Passages" } else { "" }, &name);
    }
    places(&mut sheet, all);
    sheet.blank();
    table(&mut sheet, all, context.units);
    if passages.overall() != Overall::Solved {
        sheet.blank();
    }
    for (i, passage) in all.iter().enumerate() {
        failures(&mut sheet, passage, &format!("#{}, ", i + 1), context.units);
    }
    if first.is_some() {
        sheet.blank();
        envelope(&mut sheet, "Envelope", &of_passages(passages, context.units), context.units);
        sheet.blank();
        of_limit_states(&mut sheet, passages, context.units);
        uplift(&mut sheet, all, context.units);
        free_spans::of_trains(&mut sheet, all, context.units);
        sheet.blank();
        limits(&mut sheet, all, context);
        proof(&mut sheet, all, context);
    }
    sheet.finish()
}

/// Returns the models of all train positions with a solution.
pub(crate) fn used_models<'a>(all: &'a [Passage<'a>]) -> Vec<&'a Model> {
    all.iter().flat_map(Passage::solved).map(|(_, solution)| solution.model()).collect()
}

/// Returns the report on whether an equilibrium exists at every position of each train. `colour` adds escape
/// codes for a terminal.
pub fn checked_trains(passages: &Passages, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    title(&mut sheet, context);
    for passage in &passages.all {
        let mut words = clean(&passage.moving().placed_name());
        if let Some(combination) = passage.combination() {
            words = format!("{words} under the combination {}", clean(combination));
        }
        let [from, to] = passage.moving().range.map(|x| context.units.position(x));
        words += &format!(": first axle from {from} to {to}");
        if passage.without_equilibrium().is_empty() {
            words += ", an equilibrium at every checked position";
        }
        sheet.row("Train", &words);
        ranges(&mut sheet, passage.without_equilibrium(), "", context.units);
    }
    sheet.finish()
}

/// Adds a table with the extremes of each passage.
fn table(sheet: &mut Sheet, all: &[Passage], units: Units) {
    let extremes = |passage: &Passage| {
        let of = |(field, largest): (Field, bool)| {
            let range = passage.range(field)?;
            Some(cleaned(passage, field, range[usize::from(largest)]).value)
        };
        COLUMNS.map(of)
    };
    let values: Vec<[Option<f64>; 4]> = all.iter().map(extremes).collect();
    let columns = Columns::headed(sheet, ["   #   positions", ""], [24, 12], &values, units);
    for (i, (passage, values)) in all.iter().zip(&values).enumerate() {
        let count = passage.solved().count();
        let first = format!("{:>4}{count:>12}", i + 1);
        sheet.line(&columns.row(&first, values));
    }
}

/// Adds the envelopes of the limit states. A sentence replaces an envelope that equals the joint envelope.
fn of_limit_states(sheet: &mut Sheet, passages: &Passages, units: Units) {
    for state in passages.limit_states().iter() {
        if passages.all.iter().all(|passage| passage.limit_states().contains(state)) {
            sheet.row("", &all_of(state));
        } else {
            let of_state = of_passages(&passages.of_limit_state(state), units);
            envelope(sheet, state.name(), &of_state, units);
        }
        sheet.blank();
    }
}

/// Adds the largest gaps over all passages, ahead of, between and behind the axles.
fn uplift(sheet: &mut Sheet, all: &[Passage], units: Units) {
    let places = ["ahead of the axles", "between them", "behind them"];
    for (i, place) in places.into_iter().enumerate() {
        let each = all.iter().enumerate().filter_map(|(number, passage)| {
            let uplift = passage.uplift();
            let gap = [uplift.ahead, uplift.between, uplift.behind][i]?;
            Some((number, cleaned(passage, Field::Gap, gap)))
        });
        // The first of several equal values is kept.
        let most =
            each.reduce(|most, other| if other.1.value > most.1.value { other } else { most });
        let words = match most {
            Some((number, gap)) if gap.value != 0.0 => {
                let [x, at] = [gap.x, gap.first_axle].map(|x| units.write(Kind::Position, x));
                let value = units.write(Kind::Deflection, gap.value);
                format!(
                    "{place} up to {value}, at {x} with the first axle at {at} in passage #{}",
                    number + 1
                )
            }
            _ => format!("{place} none"),
        };
        sheet.row(if i == 0 { "Uplift" } else { "" }, &words);
    }
}
