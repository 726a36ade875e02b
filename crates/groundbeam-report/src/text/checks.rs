//! Design checks, one line each.

use super::sheet::{Sheet, Tone};
use crate::context::{Context, clean};
use crate::number::significant;
use crate::quantity::{Kind, Units};
use groundbeam::{Check, Checked, Solution};

/// The checks of one solution, and a blank line if there are any.
pub(crate) fn rows(sheet: &mut Sheet, solution: &Solution, context: &Context) {
    let checks = context.limits.map(|limits| limits.check(solution)).unwrap_or_default();
    for (i, check) in checks.iter().enumerate() {
        row(sheet, i == 0, check, None, context.units);
    }
    if !checks.is_empty() {
        sheet.blank();
    }
}

/// Of every check the solution that comes nearest to its limit, or passes it farthest.
pub(crate) fn worst_rows(sheet: &mut Sheet, solved: &[(&str, &Solution)], context: &Context) {
    let Some(limits) = context.limits else { return };
    let all: Vec<_> =
        solved.iter().map(|(name, solution)| (*name, limits.check(solution))).collect();
    let Some((_, first)) = all.first() else { return };
    for (i, check) in first.iter().enumerate() {
        let of_kind = |(name, checks): &(_, Vec<Check>)| {
            Some((*name, *checks.iter().find(|other| other.what == check.what)?))
        };
        // Of equals the first.
        let found = all.iter().rev().filter_map(of_kind);
        let worst = found.max_by(|a, b| used(&a.1).total_cmp(&used(&b.1)));
        if let Some((name, worst)) = worst {
            row(sheet, i == 0, &worst, Some(name), context.units);
        }
    }
    if !first.is_empty() {
        sheet.blank();
    }
}

/// How much of the limit is used.
fn used(check: &Check) -> f64 {
    match check.what {
        Checked::Overturning => check.limit / check.found,
        // Also where the limit is zero.
        _ if check.found == 0.0 => 0.0,
        _ => check.found / check.limit,
    }
}

fn row(sheet: &mut Sheet, first: bool, check: &Check, of: Option<&str>, units: Units) {
    let (what, sign) = match check.what {
        Checked::BearingPressure => ("bearing pressure", "<="),
        Checked::Settlement => ("deflection", "<="),
        Checked::LiftedShare => ("lifted off", "<="),
        Checked::Eccentricity => ("eccentricity", "<="),
        Checked::Overturning => ("overturning margin", ">="),
    };
    let write = |value: f64| match check.what {
        Checked::BearingPressure => units.write(Kind::Stress, value, 4),
        Checked::Settlement => units.write(Kind::Deflection, value, 4),
        Checked::LiftedShare => format!("{} %", significant(100.0 * value, 4)),
        Checked::Eccentricity => format!("{} l", significant(value, 4)),
        Checked::Overturning if value.is_infinite() => "without end".to_owned(),
        Checked::Overturning => significant(value, 4),
    };
    let mut words = format!(
        "{} {what} {} {sign} {}",
        if check.passes() { "passes:" } else { "FAILS: " },
        write(check.found),
        write(check.limit)
    );
    if let Some(x) = check.at {
        words += &format!(" at x = {}", units.position(x));
    }
    if let Some(name) = of {
        words += &format!(", {}", clean(name));
    }
    if let Some(clause) = check.what.clause() {
        words += &format!(" ({clause})");
    }
    let tone = if check.passes() { Tone::Good } else { Tone::Bad };
    sheet.toned_row(if first { "Checks" } else { "" }, &words, tone);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_a_limit_of_nothing_is_the_least_used() {
        let lifted = |found| Check { what: Checked::LiftedShare, found, limit: 0.0, at: None };
        assert!(used(&lifted(0.0)) < used(&lifted(1e-9)));
        assert!(!lifted(1e-9).passes());
    }
}
