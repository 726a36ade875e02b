//! Computes the numbers and headings that all reports of several combinations use.

use crate::bound::Around;
use crate::context::Context;
use crate::numbers::Numbers;
use crate::quantity::Units;
use crate::size::Sizes;
use crate::verified::Named;
use groundbeam::{
    Field, Solution,
    design::LimitState,
    envelope::Governing,
    solution::{Extreme, Side},
};
use groundbeam_run::{Answers, BEST, Banded};

/// A solution with the number of its combination, from 1.
#[derive(Clone, Copy)]
pub(crate) struct Numbered<'a> {
    pub number: usize,
    pub solution: &'a Solution,
    pub sizes: Sizes,
    /// Factors on k and μ of the ground; `None` if the file gives no range of ground stiffness.
    pub ground: Option<[f64; 2]>,
    /// The proof of the solution; `None` if no proof is requested.
    pub proof: Option<&'a Named>,
}

impl Numbered<'_> {
    /// Formats the numbers of the solution.
    pub fn numbers(&self, units: Units) -> Numbers<'_> {
        Numbers::plain(self.solution, units).with_proof(self.proof)
    }

    fn extreme(&self, field: Field, is_max: bool) -> Extreme {
        let range = self.solution.range(field);
        if is_max { range.max } else { range.min }
    }

    /// Interval that contains the difference between the exact extreme of a field and the printed value.
    fn around(&self, printed: f64, field: Field, is_max: bool) -> Around {
        let error = self.proof.map_or(f64::INFINITY, |named| named.error_of(field));
        Around::of(printed, self.extreme(field, is_max).value, error)
    }
}

/// The solved combinations with their numbers and their proofs.
pub(crate) fn numbered<'a>(answers: &'a Answers, context: &Context<'a>) -> Vec<Numbered<'a>> {
    let each = answers.list.iter().enumerate().filter_map(|(i, answer)| {
        let solution = answer.solution()?;
        Some(Numbered {
            number: i + 1,
            solution,
            sizes: Sizes::of(solution),
            ground: answer.label.combination.ground,
            proof: context.proofs.get(i),
        })
    });
    each.collect()
}

/// Returns the solved combinations that belong to a limit state.
pub(crate) fn of_limit_state<'a>(
    answers: &Answers,
    solved: &[Numbered<'a>],
    state: LimitState,
) -> Vec<Numbered<'a>> {
    let is_of = |row: &&Numbered| answers.list[row.number - 1].is_of(state);
    solved.iter().filter(is_of).copied().collect()
}

/// Error bound of the extreme of a field over all combinations, and whether the governing combination is
/// proven to govern.
pub(crate) fn bound_of_extreme(
    solved: &[Numbered],
    field: Field,
    is_max: bool,
    governing: Governing,
) -> (f64, bool) {
    let printed = governing.extreme.value;
    let all: Vec<Around> = solved.iter().map(|row| row.around(printed, field, is_max)).collect();
    let error = Around::extreme(all.iter().copied(), is_max).map_or(f64::INFINITY, Around::error);
    let others = all.iter().enumerate().filter(|(i, _)| *i != governing.by);
    let leads = all
        .get(governing.by)
        .is_some_and(|first| others.into_iter().all(|(_, other)| first.leads(*other, is_max)));
    (error, leads)
}

/// Returns the error bounds of `printed`, the smallest and the largest value of a field at `x` over all combinations.
/// The values on both sides of `x` count.
pub(crate) fn bounds_at(solved: &[Numbered], field: Field, x: f64, printed: [f64; 2]) -> [f64; 2] {
    [false, true].map(|is_max| {
        let sides = solved.iter().flat_map(|row| {
            let error = row.proof.map_or(f64::INFINITY, |named| named.error_at(field, x));
            [Side::Left, Side::Right].map(|side| (row.solution.at(x, side).get(field), error))
        });
        let printed = printed[usize::from(is_max)];
        let all = sides.map(|(value, error)| Around::of(printed, value, error));
        Around::extreme(all, is_max).map_or(f64::INFINITY, Around::error)
    })
}

/// Returns the largest force under an end of the beam over all combinations, as combination, force and error
/// bound. `end` is 0 for the left end and 1 for the right end.
pub(crate) fn largest_end_force<'s, 'a>(
    solved: &'s [Numbered<'a>],
    end: usize,
) -> Option<(&'s Numbered<'a>, f64, f64)> {
    let force = |row: &Numbered| {
        let ends = row.solution.end_forces();
        [ends.left, ends.right][end]
    };
    let mut each = solved.iter().map(|row| (row, row.sizes.force(force(row))));
    let first = each.next()?;
    let (row, most) = each.fold(first, |most, other| if other.1 > most.1 { other } else { most });
    let all = solved.iter().map(|row| {
        let error = row.proof.map_or(f64::INFINITY, |named| named.error_of_end_force(end));
        Around::of(most, force(row), error)
    });
    Some((row, most, Around::extreme(all, true)?.error()))
}

/// Returns the error bounds of an extreme for the best estimates of k and μ, and of its smallest and largest value over
/// all pairs (k, μ).
pub(crate) fn bounds_of_band(
    solved: &[Numbered],
    field: Field,
    is_max: bool,
    banded: &Banded,
) -> [f64; 3] {
    let mut grounds: Vec<[f64; 2]> = Vec::new();
    for ground in solved.iter().filter_map(|row| row.ground) {
        if !grounds.contains(&ground) {
            grounds.push(ground);
        }
    }
    let on = |ground: &[f64; 2], printed: f64| {
        let here = solved.iter().filter(|row| row.ground == Some(*ground));
        Around::extreme(here.map(|row| row.around(printed, field, is_max)), is_max)
    };
    let over = |printed: f64, largest: bool| {
        let each = grounds.iter().filter_map(|ground| on(ground, printed));
        Around::extreme(each, largest).map_or(f64::INFINITY, Around::error)
    };
    let best = on(&BEST, banded.best).map_or(f64::INFINITY, Around::error);
    [best, over(banded.low, false), over(banded.high, true)]
}

/// Heading of the list of combinations. It is `Grounds` if only the ground stiffness varies between the
/// combinations.
pub(crate) fn noun(answers: &Answers) -> &'static str {
    let all = || answers.list.iter().map(|answer| &answer.label.combination);
    let on_grounds = all().any(|combination| combination.ground.is_some());
    match on_grounds && all().all(|combination| combination.as_written) {
        true => "Grounds",
        false => "Combinations",
    }
}
