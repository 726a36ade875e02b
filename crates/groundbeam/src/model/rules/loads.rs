//! The rules for loads on the beam and on the ground.

use super::positions::check_order;
use crate::model::problem::{Part, Problem, down, finite};
use crate::model::{Action, Extent, Load, Model};

impl Model {
    pub(super) fn check_loads(&self, found: &mut Vec<Problem>) {
        let begins = self.ground_begins();
        for (i, load) in self.loads.iter().enumerate() {
            let part = Part::Load(i);
            match load.extent {
                Extent::Point { at, size } if load.on_ground => {
                    finite(found, part, "at", at);
                    self.check_on_ground(found, part, "at", [at, at]);
                    down(found, part, "force", size);
                    if self.ground_has_no_layer(&begins, at) {
                        let message = "a force at a point of the ground needs a shear layer";
                        let hint = "distribute the force: give `distributed`, `from` and `to`";
                        found.push(Problem::new("GB209", part, "at", message, hint));
                    }
                }
                Extent::Distributed { from, to, start, end } if load.on_ground => {
                    check_order(found, part, from, to);
                    self.check_on_ground(found, part, "from", [from, to]);
                    down(found, part, "start", start);
                    down(found, part, "end", end);
                }
                Extent::Point { at, size } => {
                    self.check_position(found, part, at);
                    let field = if load.action == Action::Moment { "moment" } else { "force" };
                    finite(found, part, field, size);
                }
                Extent::Distributed { from, to, start, end } => {
                    self.check_stretch(found, part, from, to);
                    finite(found, part, "start", start);
                    finite(found, part, "end", end);
                }
            }
        }
        if let (Some(load), Some(Part::FoundationSegment(i))) =
            (self.loads.iter().position(Load::is_on_ground), self.varying_ground())
        {
            let message = "loads on the ground require constant k and mu in each ground segment";
            let hint = format!(
                "k or mu varies along segment {}: divide this segment into several segments with constant k and mu",
                i + 1
            );
            found.push(Problem::new("GB210", Part::Load(load), "at", message, hint));
        }
    }
}
