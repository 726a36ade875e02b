//! Formats the results of a model file in every form: text, document, table, picture, calculation report.

use crate::calculation::{self, Report, Source};
use crate::checked::{Verdict, rows_of, verdicts};
use crate::context::Context;
use crate::svg::{self, Picture};
use crate::{csv, json, text};
use groundbeam_run::{Answer, Answers, Asked, Found};

/// The results of a model file, with the other data that a report needs, such as the title and the units.
#[derive(Debug, Clone, Copy)]
pub struct Results<'a> {
    answers: &'a Answers,
    context: Context<'a>,
}

impl<'a> Results<'a> {
    /// Combines results with the other data of a report. The results replace ground, load factors and combination of
    /// `context`. A measured duration of a single model also replaces `seconds`.
    pub fn new(answers: &'a Answers, context: Context<'a>) -> Self {
        let (ground, factors) = match (answers.asked, answers.list.first()) {
            (Asked::One, Some(one)) => (one.ground.as_ref(), one.factors.as_ref()),
            (Asked::Trains, _) => (answers.ground.as_ref(), None),
            _ => (None, None),
        };
        let one = answers.list.first().filter(|_| answers.asked == Asked::One);
        let combination = one.map(|one| &*one.label.combination).filter(|one| !one.name.is_empty());
        let seconds = one.map(|one| one.seconds).filter(|seconds| seconds.is_finite());
        let seconds = seconds.or(context.seconds);
        let context = Context { ground, factors, seconds, combination, ..context };
        Results { answers, context }
    }

    /// The results of all models, combinations or train positions.
    pub fn answers(&self) -> &'a Answers {
        self.answers
    }

    /// The other data of the report, with the ground and the load factors of the results.
    pub fn context(&self) -> &Context<'a> {
        &self.context
    }

    /// The result, if a single model was requested.
    pub fn one(&self) -> Option<&'a Answer> {
        self.answers.list.first().filter(|_| self.answers.asked == Asked::One)
    }

    /// Whether a model is solved, so that there are fields to draw and to list.
    pub fn has_fields(&self) -> bool {
        self.answers.solved().next().is_some()
    }

    /// Verdicts on each check in each of its limit states.
    fn verdicts(&self) -> Vec<Verdict> {
        verdicts(self.context.limits, &rows_of(self.answers, &self.context))
    }

    /// Labels and sentences of all verdicts on checks, for pages with their own layout.
    pub fn check_rows(&self) -> Vec<(String, String)> {
        text::check_rows(&rows_of(self.answers, &self.context), &self.context)
    }

    /// Whether a check is undecided because its limit lies within the error bound of its value.
    pub fn has_undecided_check(&self) -> bool {
        self.verdicts().iter().any(Verdict::is_undecided)
    }

    /// Whether a requested check fails or is not judged.
    pub fn has_failed_check(&self) -> bool {
        self.verdicts().iter().any(|verdict| verdict.passes() != Some(true))
    }

    /// Returns the result document.
    pub fn json(&self, stations: Option<&[f64]>) -> String {
        let (answers, context) = (self.answers, &self.context);
        let Some(one) = self.one() else {
            return match answers.asked {
                Asked::Trains if answers.list.is_empty() => {
                    json::checked_trains(&answers.passages(), context)
                }
                Asked::Trains => json::trains(&answers.passages(), stations, context),
                Asked::Methods => json::comparison(answers, context),
                _ => json::combinations(answers, stations, context),
            };
        };
        match &one.found {
            Found::Equilibrium(solution) => {
                let own = || json::default_stations(solution);
                let stations = stations.map_or_else(own, <[f64]>::to_vec);
                json::solved(solution, &stations, context)
            }
            Found::Exists(existence) | Found::NoEquilibrium(existence) => {
                json::existence(&one.label.model(), existence, context)
            }
            Found::NotConverged(reached) => json::not_converged(reached, context),
            Found::Unsolved(_) => String::new(),
        }
    }

    /// Returns the report for a terminal, followed by the proven statements if a proof is requested.
    pub fn text(&self, colour: bool) -> String {
        let report = self.report(colour);
        let units = self.context.units;
        match (self.context.proofs, self.one()) {
            ([], _) => report,
            ([named, ..], Some(_)) => report + "\n" + &text::proof(named, units, colour),
            (proofs, None) => {
                let solutions = self.answers.list.iter().map(Answer::solution);
                report + "\n" + &text::proofs(solutions.zip(proofs), units, colour)
            }
        }
    }

    fn report(&self, colour: bool) -> String {
        let (answers, context) = (self.answers, &self.context);
        let Some(one) = self.one() else {
            return match answers.asked {
                Asked::Trains if answers.list.is_empty() => {
                    text::checked_trains(&answers.passages(), context, colour)
                }
                Asked::Trains => text::trains(&answers.passages(), context, colour),
                Asked::Methods => text::comparison(answers, context, colour),
                _ => text::combinations(answers, context, colour),
            };
        };
        match &one.found {
            Found::Equilibrium(solution) => text::solved(solution, context, colour),
            Found::Exists(existence) | Found::NoEquilibrium(existence) => {
                text::existence(&one.label.model(), existence, context, colour)
            }
            Found::NotConverged(reached) => {
                text::not_converged(reached, colour) + &text::load_factors(context, colour)
            }
            Found::Unsolved(error) => error.to_string(),
        }
    }

    /// Returns the calculation report.
    pub fn calculation(&self, source: &Source) -> Report {
        calculation::report(self.answers, &self.context, source)
    }

    /// Returns the CSV table of the fields; empty if no model is solved.
    pub fn csv(&self, stations: Option<&[f64]>) -> String {
        let (answers, units) = (self.answers, self.context.units);
        let or = |default: &dyn Fn() -> Vec<f64>| stations.map_or_else(default, <[f64]>::to_vec);
        let Some(one) = self.one() else {
            return match answers.asked {
                Asked::Trains => {
                    let passages = answers.passages();
                    csv::trains(&passages, &or(&|| passages.default_stations()), units)
                }
                _ => {
                    let stations = or(&|| json::envelope_stations(answers));
                    csv::envelope(answers, &stations, &self.context)
                }
            };
        };
        one.solution().map_or_else(String::new, |solution| {
            csv::table(solution, &or(&|| json::default_stations(solution)), &self.context)
        })
    }

    /// Returns the picture of the results; `None` if a single model was requested and is not solved.
    pub fn picture(&self) -> Option<Picture> {
        let (answers, context) = (self.answers, &self.context);
        match (self.one(), answers.asked) {
            (Some(one), _) => one.solution().map(|solution| svg::picture(solution, context)),
            (None, Asked::Trains) => Some(svg::trains(&answers.passages(), context)),
            (None, _) => Some(svg::combinations(answers, context)),
        }
    }
}
