//! Load factors as text.

use super::sheet::Sheet;
use crate::bound::not_proven;
use crate::context::{Context, clean};
use crate::quantity::Units;
use crate::verdict::falls;
use groundbeam::load_factors::{FirstLiftOff, LossOfEquilibrium};
use groundbeam_run::Factors;

/// Adds the rows with load factors if they are requested.
pub(crate) fn rows(sheet: &mut Sheet, context: &Context) {
    let Some(factors) = context.factors else { return };
    let loads = Grows::of(factors);
    // Load factors come from a search that the proof does not cover.
    let mark = |words: String| if context.proofs.is_empty() { words } else { not_proven(&words) };
    let lift_off = lift_off(factors.found.first_lift_off, &loads, context.units);
    sheet.row("Load factors", &mark(lift_off));
    sheet.row("", &mark(loss(factors.found.loss_of_equilibrium, &loads, context.units)));
}

/// Phrases that name the loads multiplied by a load factor: `times` without a verb (`all loads`), and `are`
/// with a verb (`the loads are`).
struct Grows {
    times: String,
    are: String,
}

impl Grows {
    fn of(factors: &Factors) -> Self {
        let names: Vec<String> = factors.cases.iter().map(|case| clean(case)).collect();
        let times = match names.as_slice() {
            [] => return Grows { times: "all loads".into(), are: "the loads are".into() },
            [one] => format!("the loads of case {one}"),
            [many @ .., last] => format!("the loads of cases {} and {last}", many.join(", ")),
        };
        Grows { are: format!("{times} are"), times }
    }
}

fn lift_off(found: FirstLiftOff, loads: &Grows, units: Units) -> String {
    let Grows { times, are } = loads;
    match found {
        FirstLiftOff::AtOnce => {
            format!("a part of the beam is lifted off, however small {are}")
        }
        FirstLiftOff::At { factor, x } => {
            let (factor, x) = (units.ratio(factor), units.position(x));
            format!("first lift-off at {factor} times {times}, at x = {x}")
        }
        FirstLiftOff::Never => {
            format!("the beam is on the ground along its whole length, however large {are}")
        }
    }
}

fn loss(found: LossOfEquilibrium, loads: &Grows, units: Units) -> String {
    let Grows { times, are } = loads;
    match found {
        LossOfEquilibrium::AtOnce(motion) => {
            format!("no equilibrium, however small {are}: {}", falls(motion, units))
        }
        LossOfEquilibrium::At { factor, motion } => {
            let factor = units.ratio(factor);
            format!("no equilibrium beyond {factor} times {times}: {}", falls(motion, units))
        }
        LossOfEquilibrium::Never => format!("the beam is in equilibrium, however large {are}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::{existence::RigidMotion, load_factors::LoadFactors};

    fn said(first_lift_off: FirstLiftOff, loss: LossOfEquilibrium, cases: &[&str]) -> String {
        let found = LoadFactors { first_lift_off, loss_of_equilibrium: loss };
        let factors = Factors { found, cases: cases.iter().map(|&case| case.into()).collect() };
        let mut sheet = Sheet::new(false);
        rows(&mut sheet, &Context::new(Units::SI).with_factors(&factors));
        sheet.finish()
    }

    #[test]
    fn every_result_of_load_factors_has_its_sentence() {
        let tips = RigidMotion { left: -1.0, right: 0.0, work: 0.0, lifted: None };
        let lift_off = FirstLiftOff::At { factor: 0.25, x: 1.5 };
        let loss = LossOfEquilibrium::At { factor: 2.0 / 3.0, motion: tips };
        assert_eq!(
            said(lift_off, loss, &["Q"]),
            "Load factors first lift-off at 0.25 times the loads of case Q, at x = 1.5 m\n             \
             no equilibrium beyond 0.6667 times the loads of case Q: the beam\n             \
             tips about its right end\n"
        );
        let cases = [
            (FirstLiftOff::Never, LossOfEquilibrium::Never, vec![], "however large the loads are"),
            (
                FirstLiftOff::AtOnce,
                LossOfEquilibrium::AtOnce(RigidMotion { right: -1.0, ..tips }),
                vec!["G", "Q", "W\u{1b}[31m"],
                r"G, Q and W\u{1b}[31m",
            ),
            (
                FirstLiftOff::AtOnce,
                LossOfEquilibrium::AtOnce(RigidMotion { left: 0.0, right: -1.0, ..tips }),
                vec![],
                "no equilibrium, however small the loads are: the beam tips",
            ),
        ];
        for (lift_off, loss, names, part) in cases {
            let said = said(lift_off, loss, &names);
            assert!(said.contains(part), "{said}");
            assert!(said.lines().all(|line| line.chars().count() <= 80), "{said}");
        }
    }
}
