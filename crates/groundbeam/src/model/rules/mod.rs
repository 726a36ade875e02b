//! Checks a model against all rules and lists every violation with its remedy.

mod beam;
mod ground;
mod loads;
pub(crate) mod places;
mod positions;
mod supports;

use crate::model::Model;
use crate::model::problem::{Part, Problem, finite};

impl Model {
    /// Lists every violation of the rules. The list is empty if the model can be solved. The rules also refuse numbers
    /// whose products overflow in later steps.
    pub fn problems(&self) -> Vec<Problem> {
        let mut found = Vec::new();
        self.check_beam(&mut found);
        self.check_foundation(&mut found);
        self.check_loads(&mut found);
        self.check_supports(&mut found);
        self.check_hinges(&mut found);
        self.check_one_way(&mut found);
        self.check_gap(&mut found);
        found
    }

    fn check_gap(&self, found: &mut Vec<Problem>) {
        for (i, corner) in self.gap.iter().enumerate() {
            self.check_position(found, Part::Gap(i), corner.at);
            finite(found, Part::Gap(i), "value", corner.value);
            if i > 0 && corner.at <= self.gap[i - 1].at {
                let hint =
                    "list the gap's corners from left to right, each at a different position";
                let message = "this corner at {0} does not lie to the right of the previous corner";
                let problem = Problem::new("GB501", Part::Gap(i), "at", message, hint);
                found.push(problem.with_numbers(&[corner.at]));
            }
        }
    }
}
