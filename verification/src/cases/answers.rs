//! The answers to a file: one, or one for each of its combinations with their envelope.

use super::expectation::{Expectation, Of, Value};
use groundbeam::train::{Passage, Sweep};
use groundbeam::{Envelope, Error, Options, Outcome, Solution};
use groundbeam_file::Document;

/// What comes out of a file.
pub struct Answers {
    /// With the names of combinations; a file without has one answer, without a name.
    outcomes: Vec<(Option<String>, Outcome)>,
    /// Of each train under each combination.
    passages: Vec<Passage>,
}

/// The error of envelopes of trains, relative to each field's largest value.
const ERROR: f64 = 1e-3;

impl Answers {
    /// Solves all there is to solve.
    ///
    /// # Errors
    ///
    /// The first that cannot be solved.
    pub fn of(document: &Document) -> Result<Answers, Error> {
        let options = Options::default();
        let mut outcomes = Vec::new();
        let mut passages = Vec::new();
        if !document.trains.is_empty() {
            for combination in &document.wanted() {
                for train in &document.trains {
                    let sweep = Sweep::new(&combination.model, &train.train, train.range, ERROR);
                    passages.push(
                        sweep.run(|model, near| combination.solve_near(model, &options, near))?,
                    );
                }
            }
            return Ok(Answers { outcomes, passages });
        }
        for combination in document.combinations() {
            let outcome = combination.solve(&options)?;
            outcomes.push((Some(combination.name), outcome));
        }
        if !document.has_combinations() {
            outcomes.push((None, document.solve(&options)?));
        }
        Ok(Answers { outcomes, passages })
    }

    /// The equilibria there are.
    pub fn solutions(&self) -> Vec<&Solution> {
        let single = self.named().into_iter().map(|(_, solution)| solution);
        let moving = self.passages.iter().flat_map(Passage::solved).map(|(_, solution)| solution);
        single.chain(moving).collect()
    }

    fn named(&self) -> Vec<(&str, &Solution)> {
        let named = self.outcomes.iter().filter_map(|(name, outcome)| match outcome {
            Outcome::Equilibrium(solution) => {
                Some((name.as_deref().unwrap_or_default(), &**solution))
            }
            Outcome::NoEquilibrium(_) => None,
        });
        named.collect()
    }

    /// What is found where something is expected.
    ///
    /// # Errors
    ///
    /// If the answer has no such quantity, or the file no such combination.
    pub fn found(&self, expectation: &Expectation, document: &Document) -> Result<Value, String> {
        let name = match &expectation.of {
            Of::Envelope if !self.passages.is_empty() => {
                return expectation.found_in_passages(&self.passages);
            }
            Of::Envelope => {
                let (names, solutions): (Vec<&str>, Vec<&Solution>) =
                    self.named().into_iter().unzip();
                return expectation.found_in_envelope(&Envelope::of(solutions), &names);
            }
            Of::File => None,
            Of::Combination(name) => Some(name.as_str()),
        };
        let outcome = self.outcomes.iter().find(|(other, _)| other.as_deref() == name);
        match outcome {
            Some((_, outcome)) => expectation.found(document, outcome),
            None => Err(match name {
                Some(name) => format!("the file has no combination `{name}`"),
                None => "the file has combinations: say which, as in [ULS 1]".to_owned(),
            }),
        }
    }

    /// Whether the answer is as expected.
    ///
    /// # Errors
    ///
    /// How it is not.
    pub fn judge(&self, expectation: &Expectation, document: &Document) -> Result<(), String> {
        let found = self.found(expectation, document);
        expectation.judge(&found.map_err(|what| format!("{}: {what}", expectation.name))?)
    }
}
