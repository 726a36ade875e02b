//! Writes contact, forces and extremes of one solution as text, rounded or with error bounds.

use super::sheet::Sheet;
use super::{free_spans, listed};
use crate::numbers::Numbers;
use crate::quantity::{Kind, Units};
use groundbeam::{
    Field, Solution, SupportKind,
    model::Acts,
    solution::{ContactZone, Extreme, Reaction},
};
use groundbeam_file::print::DIGITS;

/// Adds rows on contact, forces and extremes of a solution.
pub(crate) fn results(sheet: &mut Sheet, solution: &Solution, numbers: &Numbers) {
    contact(sheet, solution, numbers);
    forces(sheet, solution, numbers);
    sheet.blank();
    match numbers.have_bounds() {
        true => bounded_extremes(sheet, solution, numbers),
        false => extremes(sheet, solution, numbers),
    }
}

pub(super) fn contact(sheet: &mut Sheet, solution: &Solution, numbers: &Numbers) {
    let regions: Vec<_> = solution.contact().iter().enumerate().collect();
    let l = solution.model().beam.length;
    if regions.is_empty() {
        sheet.row("Contact", "nowhere");
    }
    listed(sheet, "Contact", &regions, |(i, region)| {
        let ContactZone { from, to } = **region;
        let written = [numbers.edge(*i, 0, from), numbers.edge(*i, 1, to)];
        match numbers.have_bounds() {
            _ if from == to => format!("at the point x = {}", written[0]),
            _ if from == 0.0 && to == l => "the whole beam".to_owned(),
            true => format!("from {} to {}", written[0], written[1]),
            false => between(numbers.units, numbers.sizes().position(from), to),
        }
    });
    let undecided: Vec<_> = solution.undecided().collect();
    listed(sheet, "Undecided", &undecided, |zone| {
        let position = numbers.sizes().position(zone.from);
        format!(
            "{}: rounding errors are too large to decide whether there is contact",
            between(numbers.units, position, zone.to)
        )
    });
    lift_off(sheet, solution, numbers);
}

fn lift_off(sheet: &mut Sheet, solution: &Solution, numbers: &Numbers) {
    let (lifted, units) = (solution.lift_off(), numbers.units);
    if lifted.is_empty() {
        sheet.row("Lift-off", "none");
    }
    if lifted.len() > 1 && !numbers.have_bounds() {
        return free_spans::table(sheet, &lifted, units, numbers.sizes());
    }
    let edge = |x: f64| {
        let mut regions = solution.contact().iter().enumerate();
        let ends = regions.find_map(|(i, region)| match x {
            _ if x == region.from => Some((i, 0)),
            _ if x == region.to => Some((i, 1)),
            _ => None,
        });
        ends.map_or_else(|| numbers.place(x), |(i, end)| numbers.edge(i, end, x))
    };
    listed(sheet, "Lift-off", &lifted, |stretch| {
        let largest = numbers.extreme(Field::Gap, stretch.largest_gap);
        let gap = numbers.field(Field::Gap, largest.value, None);
        let place = match numbers.have_bounds() {
            true => format!("from {} to {}", edge(stretch.from), edge(stretch.to)),
            false => between(units, numbers.sizes().position(stretch.from), stretch.to),
        };
        format!("{place}, up to {gap} at x = {}", numbers.place_of_gap(largest.x))
    });
}

/// Text of a range, such as `from 0 to 10.2 m`. The ends of the range have enough digits to differ.
pub(super) fn between(units: Units, from: f64, to: f64) -> String {
    let asked = units.unit(Kind::Position, to);
    let mut all = (asked.digits..=*DIGITS.end()).map(|digits| asked.with_digits(digits));
    let unit = all.find(|unit| unit.number(from) != unit.number(to)).unwrap_or(asked);
    format!("from {} to {}", unit.number(from), unit.write(to))
}

pub(crate) fn forces(sheet: &mut Sheet, solution: &Solution, numbers: &Numbers) {
    let (units, sizes) = (numbers.units.of_input(), numbers.sizes());
    let ends = solution.end_forces();
    let [left, right] = [numbers.end_force(0, ends.left), numbers.end_force(1, ends.right)];
    sheet.row("End forces", &format!("left {left}, right {right}"));
    let inside = solution.concentrated_forces().iter().enumerate();
    let inside: Vec<_> = inside.filter(|(_, force)| sizes.force(force.force) != 0.0).collect();
    listed(sheet, "Forces", &inside, |(i, force)| {
        let size = numbers.inner_force(*i, force.force);
        format!("{size} at x = {}, exerted by the ground", units.position(force.at))
    });
    let supports = solution.model().supports.iter();
    let reactions: Vec<_> = solution.reactions().iter().zip(supports).enumerate().collect();
    listed(sheet, "Supports", &reactions, |(i, (reaction, support))| {
        let Reaction { at, force, moment } = **reaction;
        let kind = match support.kind {
            SupportKind::Pinned => "pinned",
            SupportKind::Fixed => "fixed",
            SupportKind::Spring { .. } => "spring",
        };
        let settled = match support.settlement {
            0.0 => String::new(),
            by => format!(", settled by {},", units.write(Kind::Deflection, by)),
        };
        let one_way = match support.acts {
            Acts::Both => "",
            Acts::Up => ", acting up alone,",
            Acts::Down => ", holding down alone,",
        };
        if support.is_one_way() && force == 0.0 {
            let left = if support.acts == Acts::Up {
                "the beam has lifted from it"
            } else {
                "it is slack"
            };
            return format!("{kind}{one_way} at x = {}{settled}: {left}", units.position(at));
        }
        let sense = if sizes.force(force) < 0.0 { "holds down with" } else { "carries" };
        let size = numbers.reaction(*i, force.abs());
        let place = units.position(at);
        let mut words = format!("{kind}{one_way} at x = {place}{settled} {sense} {size}");
        let turns = match support.kind {
            SupportKind::Pinned => false,
            SupportKind::Fixed => true,
            SupportKind::Spring { rotational_spring, .. } => rotational_spring > 0.0,
        };
        if turns {
            words += &format!(", moment {}", numbers.reaction_moment(*i, moment));
        }
        words
    });
    let hinges: Vec<_> = solution.hinges().into_iter().enumerate().collect();
    listed(sheet, "Hinges", &hinges, |(i, hinge)| {
        let [angle, moment] = numbers.hinge(*i, hinge.rotation, hinge.moment);
        let mut words = format!("at x = {} turns by {angle}", units.position(hinge.at));
        if hinge.moment != 0.0 {
            words += &format!(", moment {moment}");
        }
        words
    });
}

fn extremes(sheet: &mut Sheet, solution: &Solution, numbers: &Numbers) {
    let (units, sizes) = (numbers.units, numbers.sizes());
    sheet.heading(&format!("{:<13}{:>17}{:>31}", "", "smallest", "largest"));
    for field in Field::of(&solution.model().beam) {
        let range = solution.range(field);
        let (min, max) = (sizes.extreme(field, range.min), sizes.extreme(field, range.max));
        let unit = units.unit(Kind::of(field), min.value.abs().max(max.value.abs()));
        let cell = |extreme: Extreme| {
            let place = if min.value == max.value {
                "everywhere".to_owned()
            } else {
                format!("at {}", units.position(extreme.x))
            };
            format!("{:>17} {place:<12} ", unit.write(extreme.value))
        };
        sheet.row(field.label(), &format!("{}{}", cell(min), cell(max)));
    }
}

/// Adds one row for each extreme, with its error bound.
fn bounded_extremes(sheet: &mut Sheet, solution: &Solution, numbers: &Numbers) {
    sheet.heading("Smallest and largest values");
    for field in Field::of(&solution.model().beam) {
        let range = solution.range(field);
        let largest = range.min.value.abs().max(range.max.value.abs());
        let unit = numbers.units.unit(Kind::of(field), largest);
        let words = |extreme: Extreme, is_max: bool| {
            let value = numbers.field(field, extreme.value, Some(unit));
            format!("{value} at {}", numbers.place_of(field, is_max, extreme.x))
        };
        if range.min.value == range.max.value {
            let value = numbers.field(field, range.min.value, Some(unit));
            sheet.row(field.label(), &format!("{value} everywhere"));
            continue;
        }
        sheet.row(field.label(), &words(range.min, false));
        sheet.row("", &words(range.max, true));
    }
}
