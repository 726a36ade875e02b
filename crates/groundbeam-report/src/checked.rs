//! Design checks with the bounds of the values that they compare with their limits.

use crate::bound::Around;
use crate::verified::Named;
use groundbeam::{Check, Checked, Field, Limits, Solution};

/// A check, and what is known of its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Judged {
    pub check: Check,
    /// The bound of the error of the value, infinite if there is none; `None` if no proof is asked for.
    pub error: Option<f64>,
}

/// Whether a limit is kept to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Judgement {
    /// By the computed value alone.
    Passes(bool),
    /// All values within the bound lie on one side of the limit.
    Proven(bool),
    /// The limit lies within the bound.
    Undecided,
}

impl Judgement {
    /// The name that results use.
    pub fn name(self) -> &'static str {
        match self {
            Judgement::Passes(true) => "passes",
            Judgement::Passes(false) => "fails",
            Judgement::Proven(true) => "proven-to-pass",
            Judgement::Proven(false) => "proven-to-fail",
            Judgement::Undecided => "undecided",
        }
    }
}

/// The checks that are asked for, of a solution.
pub(crate) fn judged(
    limits: Option<&Limits>,
    solution: &Solution,
    proof: Option<&Named>,
) -> Vec<Judged> {
    let checks = limits.map(|limits| limits.check(solution)).unwrap_or_default();
    let of = |check: Check| Judged {
        check,
        error: proof.map(|named| error(&check, solution, named, limits)),
    };
    checks.into_iter().map(of).collect()
}

/// The bound of the error of a value. Eccentricity and overturning follow from the loads alone; no proof bounds them.
fn error(check: &Check, solution: &Solution, named: &Named, limits: Option<&Limits>) -> f64 {
    match check.what {
        Checked::BearingPressure => {
            let width = limits.and_then(|limits| limits.bearing_pressure).map_or(0.0, |(_, b)| b);
            // The width is rounded once, and so is the quotient.
            let rounding = 4.0 * f64::EPSILON * check.found.abs();
            let error = named.error_of(Field::Pressure) / width * (1.0 + 4.0 * f64::EPSILON);
            (error + rounding).next_up()
        }
        Checked::Settlement => named.error_of(Field::Deflection),
        Checked::LiftedShare => named.error_of_lifted_share(solution),
        Checked::Eccentricity | Checked::Overturning => f64::INFINITY,
    }
}

/// Of each check the one of several solutions that comes nearest to its limit, or passes it farthest, with its index. Its
/// error is that of the largest value of all.
pub(crate) fn worst(all: &[Vec<Judged>]) -> Vec<(usize, Judged)> {
    let Some(first) = all.first() else { return Vec::new() };
    let of_kind = |kind: Checked| {
        let each = all.iter().enumerate();
        each.filter_map(move |(i, judged)| {
            Some((i, *judged.iter().find(|j| j.check.what == kind)?))
        })
    };
    let worst = |judged: &Judged| {
        let kind = judged.check.what;
        // Of equals the first.
        let found: Vec<(usize, Judged)> = of_kind(kind).collect();
        let most = |a: &&(usize, Judged), b: &&(usize, Judged)| {
            used(&a.1.check).total_cmp(&used(&b.1.check))
        };
        let (i, worst) = *found.iter().rev().max_by(most)?;
        let around = |(_, judged): &(usize, Judged)| {
            let error = judged.error.unwrap_or(f64::INFINITY);
            Around::of(worst.check.found, judged.check.found, error)
        };
        let largest = Around::extreme(found.iter().map(around), true).map(Around::error);
        Some((i, Judged { error: worst.error.and(largest), ..worst }))
    };
    first.iter().filter_map(worst).collect()
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

impl Judged {
    pub fn judgement(&self) -> Judgement {
        let Check { found, limit, .. } = self.check;
        let Some(error) = self.error.filter(|error| error.is_finite()) else {
            return Judgement::Passes(self.check.passes());
        };
        // The limit is rounded once, unless it is zero.
        let [least, most] =
            if limit == 0.0 { [0.0; 2] } else { [limit.next_down(), limit.next_up()] };
        let [low, high] = match error {
            0.0 => [found; 2],
            _ => [(found - error).next_down(), (found + error).next_up()],
        };
        if high <= least {
            Judgement::Proven(true)
        } else if low > most {
            Judgement::Proven(false)
        } else {
            Judgement::Undecided
        }
    }

    /// Whether a value that has a bound may lie on either side of its limit.
    pub fn is_undecided(&self) -> bool {
        self.judgement() == Judgement::Undecided
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settles(found: f64, error: Option<f64>) -> Judged {
        let check = Check { what: Checked::Settlement, found, limit: 0.5, at: None };
        Judged { check, error }
    }

    #[test]
    fn a_check_is_proven_if_the_interval_lies_on_one_side_of_the_limit() {
        for (found, error, expected) in [
            (0.25, None, Judgement::Passes(true)),
            (0.75, None, Judgement::Passes(false)),
            (0.25, Some(f64::INFINITY), Judgement::Passes(true)),
            (0.25, Some(0.125), Judgement::Proven(true)),
            (0.75, Some(0.125), Judgement::Proven(false)),
            (0.25, Some(0.25), Judgement::Undecided),
            (0.75, Some(0.25), Judgement::Undecided),
            // The limit itself is a rounded number.
            (0.5, Some(0.0), Judgement::Undecided),
        ] {
            assert_eq!(settles(found, error).judgement(), expected, "{found} {error:?}");
        }
        let check = Check { what: Checked::LiftedShare, found: 0.0, limit: 0.0, at: None };
        assert_eq!(Judged { check, error: Some(0.0) }.judgement(), Judgement::Proven(true));
    }

    /// A combination that does not govern by its value may govern by its bound.
    #[test]
    fn the_worst_of_several_has_the_bound_of_the_largest_interval() {
        let all = [vec![settles(0.375, Some(0.0))], vec![settles(0.25, Some(0.5))]];
        let (i, found) = worst(&all)[0];
        assert_eq!((i, found.check.found), (0, 0.375));
        assert!((found.error.unwrap() - 0.375).abs() < 1e-15, "{found:?}");
        assert!(found.is_undecided() && !all[0][0].is_undecided());
        assert_eq!(worst(&[vec![settles(0.25, None)]]), [(0, settles(0.25, None))]);
    }

    #[test]
    fn nothing_of_a_limit_of_nothing_is_the_least_used() {
        let lifted = |found| Check { what: Checked::LiftedShare, found, limit: 0.0, at: None };
        assert!(used(&lifted(0.0)) < used(&lifted(1e-9)));
        assert!(!lifted(1e-9).passes());
    }
}
