//! Numbers and list heads that the reports of several combinations share.

use crate::size::Sizes;
use groundbeam::Solution;
use groundbeam_run::Answers;

/// A solution with the number its combination has in the report, counted from 1.
pub(crate) struct Numbered<'a> {
    pub number: usize,
    pub solution: &'a Solution,
    pub sizes: Sizes,
}

/// The solved combinations with their numbers.
pub(crate) fn numbered(answers: &Answers) -> Vec<Numbered<'_>> {
    let each = answers.list.iter().enumerate().filter_map(|(i, answer)| {
        let solution = answer.solution()?;
        Some(Numbered { number: i + 1, solution, sizes: Sizes::of(solution) })
    });
    each.collect()
}

/// The head of a list of combinations. A band of grounds need not have combinations of loads.
pub(crate) fn noun(answers: &Answers) -> &'static str {
    let all = || answers.list.iter().map(|answer| &answer.label.combination);
    let on_grounds = all().any(|combination| combination.ground.is_some());
    match on_grounds && all().all(|combination| combination.factors.is_empty()) {
        true => "Grounds",
        false => "Combinations",
    }
}
