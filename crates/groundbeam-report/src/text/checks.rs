//! Design checks, one line each.

use super::sheet::{Sheet, Tone};
use crate::bound::{not_proven, with_bound};
use crate::checked::{Judged, Judgement, judged, worst};
use crate::context::{Context, clean};
use crate::numbers::{Numbers, PERCENT};
use crate::quantity::{Kind, Unit};
use crate::verified::Named;
use groundbeam::{Checked, Field, Solution};

/// The checks of one solution, and a blank line if there are any.
pub(crate) fn rows(sheet: &mut Sheet, solution: &Solution, context: &Context) {
    let proof = context.proofs.first();
    let checks = judged(context.limits, solution, proof);
    let numbers = Numbers::plain(solution, context.units).with_proof(proof);
    for (i, check) in checks.iter().enumerate() {
        row(sheet, i == 0, check, None, &numbers);
    }
    if !checks.is_empty() {
        sheet.blank();
    }
}

/// A solution with its name and what is proven of it.
pub(crate) type OfName<'a> = (&'a str, &'a Solution, Option<&'a Named>);

/// Of every check the solution that comes nearest to its limit, or passes it farthest.
pub(crate) fn worst_rows(sheet: &mut Sheet, solved: &[OfName], context: &Context) {
    let each = solved.iter().map(|(_, solution, proof)| judged(context.limits, solution, *proof));
    let worst = worst(&each.collect::<Vec<_>>());
    for (i, (by, check)) in worst.iter().enumerate() {
        let (name, solution, proof) = solved[*by];
        let numbers = Numbers::plain(solution, context.units).with_proof(proof);
        row(sheet, i == 0, check, Some(name), &numbers);
    }
    if !worst.is_empty() {
        sheet.blank();
    }
}

/// Digits of a value and of a limit.
const DIGITS: usize = 4;

fn row(sheet: &mut Sheet, first: bool, judged: &Judged, of: Option<&str>, numbers: &Numbers) {
    let check = &judged.check;
    let (what, sign, field) = match check.what {
        Checked::BearingPressure => ("bearing pressure", "<=", Some(Field::Pressure)),
        Checked::Settlement => ("deflection", "<=", Some(Field::Deflection)),
        Checked::LiftedShare => ("lifted off", "<=", None),
        Checked::Eccentricity => ("eccentricity", "<=", None),
        Checked::Overturning => ("overturning margin", ">=", None),
    };
    let unit = |value: f64| match check.what {
        Checked::BearingPressure => numbers.units.unit(Kind::Stress, value),
        Checked::Settlement => numbers.units.unit(Kind::Deflection, value),
        Checked::LiftedShare => PERCENT,
        Checked::Eccentricity => Unit { name: "l", size: 1.0 },
        Checked::Overturning => Unit { name: "", size: 1.0 },
    };
    let write = |value: f64| match value.is_infinite() {
        true => "without end".to_owned(),
        false => unit(value).write(value, DIGITS),
    };
    let found = match judged.error {
        None => write(check.found),
        Some(error) if error.is_finite() => with_bound(check.found, error, unit(check.found)),
        Some(_) => not_proven(&write(check.found)),
    };
    let (verdict, tone) = match judged.judgement() {
        Judgement::Passes(true) => ("passes", Tone::Good),
        Judgement::Passes(false) => ("FAILS", Tone::Bad),
        Judgement::Proven(true) => ("proven to pass", Tone::Good),
        Judgement::Proven(false) => ("proven to FAIL", Tone::Bad),
        Judgement::Undecided => ("undecided within the bound", Tone::Doubtful),
    };
    let verdict = format!("{verdict}:");
    let mut words = format!("{verdict:<7} {what} {found} {sign} {}", write(check.limit));
    if let Some(x) = check.at {
        let place = match field {
            Some(field) => numbers.place_of(field, true, x),
            None => numbers.place_without_bound(x),
        };
        words += &format!(" at x = {place}");
    }
    if let Some(name) = of {
        words += &format!(", {}", clean(name));
    }
    if let Some(clause) = check.what.clause() {
        words += &format!(" ({clause})");
    }
    sheet.toned_row(if first { "Checks" } else { "" }, &words, tone);
}
