//! Solves the models of a case, and computes the quantities for which the case gives expected values.

use super::expectation::{Expectation, Of, Value};
use groundbeam::{Error, Solution};
use groundbeam_file::Document;
use groundbeam_report::{Context, Results};
use groundbeam_run::{self as run, Asked, Failed, Found, OneThread, Run};

/// The results for a file.
pub struct Answers(run::Answers);

impl Answers {
    /// Solves everything that the file requests.
    ///
    /// # Errors
    ///
    /// Returns the error of the first model that cannot be solved. A position of a train without a certified solution
    /// is not an error.
    pub fn of(document: &Document) -> Result<Answers, Error> {
        let answers = Run::of(document).solve(&OneThread).map_err(Failed::refusal)?;
        let stopped = answers.list.iter().find_map(|answer| match &answer.found {
            Found::NotConverged(reached) => Some(Error::NotConverged(reached.clone())),
            _ => None,
        });
        match stopped.filter(|_| answers.asked != Asked::Trains) {
            Some(error) => Err(error),
            None => Ok(Answers(answers)),
        }
    }

    /// Returns the solutions of all models that have an equilibrium.
    pub fn solutions(&self) -> Vec<&Solution> {
        self.0.solved().map(|(_, solution)| solution).collect()
    }

    /// Returns the computed value of an expected quantity.
    ///
    /// # Errors
    ///
    /// The result does not contain the quantity, or the file does not contain the combination.
    pub fn found(&self, expectation: &Expectation, document: &Document) -> Result<Value, String> {
        let Answers(answers) = self;
        if expectation.of == Of::Envelope {
            let results = Results::new(answers, Context::of(document));
            if let Some(found) = expectation.found_in_verdicts(|| results.json(Some(&[]))) {
                return found;
            }
        }
        let name = match (&expectation.of, answers.asked) {
            (Of::Envelope, Asked::Trains) => {
                return expectation.found_in_passages(&answers.passages());
            }
            (Of::Envelope, _) => {
                let names: Vec<&str> = answers.solved().map(|(answer, _)| answer.name()).collect();
                return expectation.found_in_envelope(&answers.envelope(), &names);
            }
            (Of::File, _) => "",
            (Of::Combination(name), _) => name,
        };
        let mut all = answers.list.iter().filter(|_| answers.asked != Asked::Trains);
        match all.find(|answer| answer.name() == name) {
            Some(answer) => expectation.found(document, &answer.found),
            None if name.is_empty() => {
                Err("the file has combinations: write the name of one before the quantity, as in [ULS 1]".to_owned())
            }
            None => Err(format!("the file has no combination `{name}`")),
        }
    }

    /// Checks that the computed value of a quantity agrees with the expected value.
    ///
    /// # Errors
    ///
    /// Returns a description of the difference between the two values.
    pub fn judge(&self, expectation: &Expectation, document: &Document) -> Result<(), String> {
        let found = self.found(expectation, document);
        expectation.judge(&found.map_err(|what| format!("{}: {what}", expectation.name))?)
    }
}
