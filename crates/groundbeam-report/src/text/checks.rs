//! Writes the verdict on each design check as a sentence.

use super::sheet::{Sheet, Tone};
use crate::bound::{not_proven, with_bound};
use crate::checked::{Governing, Judged, Judgement, Row, Verdict, verdicts};
use crate::context::{Context, clean};
use crate::numbers::Numbers;
use crate::quantity::{Kind, Unit};
use groundbeam::{
    Field, Solution,
    design::{Beside, Check, Checked, LimitState},
};

/// Adds the verdicts on the checks of one solution, followed by a blank line if there are checks.
pub(crate) fn rows(sheet: &mut Sheet, solution: &Solution, context: &Context) {
    all_rows(sheet, &[Row::alone(solution, context)], context);
}

/// Adds a row for each check in each of its limit states. The row states the result with the largest
/// utilization.
pub(crate) fn all_rows(sheet: &mut Sheet, rows: &[Row], context: &Context) {
    let verdicts = verdicts(context.limits, rows);
    for (i, verdict) in verdicts.iter().enumerate() {
        let (words, tone) = sentence(verdict, rows, context);
        sheet.toned_row(if i == 0 { "Checks" } else { "" }, &words, tone);
    }
    if verdicts.is_empty() {
        return;
    }
    if rows.iter().all(|row| row.as_given) {
        sheet.row("", "the file has no combinations: the checks use the loads as given");
    } else if let nameless @ 1.. = rows.iter().filter(|row| row.states.is_empty()).count() {
        let combinations = if nameless == 1 { "combination" } else { "combinations" };
        let words = format!(
            "every check also applies to {nameless} {combinations} without a `limit_state`"
        );
        sheet.row("", &words);
    }
    sheet.blank();
}

/// The verdict as a sentence, with the tone of this sentence.
pub(crate) fn sentence(verdict: &Verdict, rows: &[Row], context: &Context) -> (String, Tone) {
    let name = noun(verdict.what);
    let (mut words, tone) = match verdict.of {
        Governing::NoCombination(states) => {
            let combination = if context.selected { "selected combination" } else { "combination" };
            (
                format!(
                    "{name} not judged: no {combination} has the limit state {}",
                    states.names()
                ),
                Tone::Doubtful,
            )
        }
        Governing::Unsolved(_) => {
            (format!("{name} not judged: a combination is not solved"), Tone::Doubtful)
        }
        Governing::NoResultant(_) => {
            (format!("{name} not judged: the loads have no resultant"), Tone::Doubtful)
        }
        Governing::Falls(_) => (format!("{name} fails: no equilibrium"), Tone::Bad),
        Governing::Judged(by, judged) => match rows[by].solution {
            Some(solution) => {
                let numbers = Numbers::plain(solution, context.units).with_proof(rows[by].proof);
                judged_in_words(&judged, verdict.state, solution, &numbers)
            }
            None => return (String::new(), Tone::Plain),
        },
    };
    let state = verdict.state.map(|state| state.name().to_owned());
    let of = verdict.by().map(|by| clean(&rows[by].name)).filter(|name| !name.is_empty());
    let place: Vec<String> = state.into_iter().chain(of).collect();
    if !place.is_empty() {
        words += &format!("; {}", place.join(", "));
    }
    if let Some(clause) = verdict.clause(rows) {
        words += &format!(" ({clause})");
    }
    (words, tone)
}

/// Name of the checked quantity, as the subject of a sentence.
fn noun(what: Checked) -> &'static str {
    match what {
        Checked::BearingPressure => "peak pressure",
        Checked::BearingResistance => "bearing resistance",
        Checked::Settlement => "deflection",
        Checked::LiftedShare => "lifted share",
        Checked::Eccentricity => "eccentricity",
        Checked::Overturning => "overturning",
    }
}

/// Number of digits that distinguishes every double from its neighbours.
const ALL_DIGITS: usize = 17;

fn judged_in_words(
    judged: &Judged,
    state: Option<LimitState>,
    solution: &Solution,
    numbers: &Numbers,
) -> (String, Tone) {
    let check = &judged.check;
    let unit = |value: f64| match check.what {
        Checked::BearingPressure => numbers.units.unit(Kind::Stress, value),
        Checked::BearingResistance => numbers.units.unit(Kind::Force, value),
        Checked::Settlement => numbers.units.unit(Kind::Deflection, value),
        Checked::LiftedShare => numbers.units.percent(),
        Checked::Eccentricity => numbers.units.plain("l"),
        Checked::Overturning => numbers.units.plain(""),
    };
    let digits = digits(check, &unit, numbers.units.digits());
    let write = |value: f64| unit(value).with_digits(digits).write(value).trim_end().to_owned();
    let found = match judged.error {
        None => write(check.found),
        Some(error) if error.is_finite() => with_bound(check.found, error, unit(check.found)),
        Some(_) => not_proven(&write(check.found)),
    };
    let place = |field: Option<Field>| match (check.at, field) {
        (None, _) => String::new(),
        (Some(x), Some(field)) => format!(" at x = {}", numbers.place_of(field, true, x)),
        (Some(x), None) => format!(" at x = {}", numbers.place_without_bound(x)),
    };
    let limit = write(check.limit);
    let said = match check.what {
        Checked::BearingPressure => {
            format!("peak pressure {found}{}, {limit} allowed", place(Some(Field::Pressure)))
        }
        Checked::BearingResistance => {
            let used = numbers.units.percent().write(check.utilisation());
            // `bearing_resistance` is a design resistance for ultimate limit states, and an allowable pressure for
            // other limit states.
            match state.is_none_or(LimitState::is_ultimate) {
                true => {
                    format!(
                        "V_d = {found} on the effective area, resistance {limit}, utilisation {used}"
                    )
                }
                false => format!(
                    "V = {found} on the effective area, {limit} allowed, utilisation {used}"
                ),
            }
        }
        Checked::Settlement => {
            format!("deflection {found}{}, {limit} allowed", place(Some(Field::Deflection)))
        }
        Checked::LiftedShare => format!("{found} lifted off, {limit} allowed"),
        Checked::Eccentricity => format!("eccentricity {found}{}, {limit} allowed", place(None)),
        Checked::Overturning if check.found.is_infinite() => {
            format!("no overturning load; the required safety factor is {limit}")
        }
        Checked::Overturning => {
            format!(
                "the beam tips at {found} times the overturning loads; a factor of {limit} is required"
            )
        }
    };
    let (verdict, tone) = match judged.judgement() {
        Judgement::Passes(true) => ("passes", Tone::Good),
        Judgement::Passes(false) => ("fails", Tone::Bad),
        Judgement::Proven(true) => ("proven to pass", Tone::Good),
        Judgement::Proven(false) => ("proven to fail", Tone::Bad),
        Judgement::Undecided => {
            ("undecided, because the limit is within the error bound", Tone::Doubtful)
        }
    };
    (format!("{said}: {verdict}{}", beside(check, solution, numbers)), tone)
}

/// Smallest number of digits with which a value that exceeds a limit differs from this limit.
fn digits(check: &Check, unit: &impl Fn(f64) -> Unit, least: usize) -> usize {
    let same = |digits: &usize| {
        let [a, b] =
            [check.found, check.limit].map(|value| unit(value).with_digits(*digits).write(value));
        !check.passes() && a == b
    };
    (least..ALL_DIGITS).find(|digits| !same(digits)).unwrap_or(ALL_DIGITS)
}

/// Text on the point contact forces that a peak pressure does not include, or on the effective area of a
/// bearing resistance.
fn beside(check: &Check, solution: &Solution, numbers: &Numbers) -> String {
    let force = |force: f64| {
        let force = numbers.sizes().force(force);
        numbers.units.unit(Kind::Force, force).write(force)
    };
    let length = |length: f64| numbers.units.write(Kind::Position, length);
    match check.beside {
        Beside::EndForces(ends) => {
            let mut said = Vec::new();
            if ends.left != 0.0 || ends.right != 0.0 {
                let [left, right] = [force(ends.left), force(ends.right)];
                said.push(format!("end forces {left} (left) and {right} (right)"));
            }
            for inner in solution.concentrated_forces() {
                let place = numbers.place(inner.at);
                said.push(format!("force {} at x = {place}", force(inner.force)));
            }
            match said.is_empty() {
                true => String::new(),
                false => format!("; {} in addition", said.join(", ")),
            }
        }
        Beside::EffectiveArea { width, length: of } => {
            format!("; B' = {}, L' = {}", length(width), length(of))
        }
        Beside::Nothing => String::new(),
    }
}
