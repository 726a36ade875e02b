//! The rules for supports and hinges.

use crate::model::problem::{Part, Problem, describe, finite, in_range, remedy};
use crate::model::rules::places::{Places, repeated};
use crate::model::{Action, Model, SupportKind};
use crate::numeric::tolerance::same_place;

impl Model {
    pub(super) fn check_supports(&self, found: &mut Vec<Problem>) {
        let positions = self.supports.iter().map(|support| support.at);
        let repeated = repeated(positions, same_place(self.beam.length));
        for ((i, support), other) in self.supports.iter().enumerate().zip(repeated) {
            let part = Part::Support(i);
            self.check_position(found, part, support.at);
            finite(found, part, "settlement", support.settlement);
            if let SupportKind::Spring { spring, rotational_spring } = support.kind {
                let mut constant = |field, value: f64| {
                    if !(in_range(value) && value >= 0.0) {
                        found.push(Problem::new(
                            "GB402",
                            part,
                            field,
                            format!("the spring constant is {}", describe(value)),
                            remedy(value, "it must be zero or positive"),
                        ));
                    }
                };
                constant("spring", spring);
                constant("rotational_spring", rotational_spring);
            }
            if let Some(other) = other {
                let message =
                    format!("there is already a support at {{0}} (support {})", other + 1);
                let hint = "give all restraints at this position in one support";
                let problem = Problem::new("GB403", part, "at", message, hint);
                found.push(problem.with_numbers(&[support.at]));
            }
        }
    }

    pub(crate) fn check_hinges(&self, found: &mut Vec<Problem>) {
        let l = self.beam.length;
        let near = same_place(l);
        let turning = Turning::of(self);
        let repeated = repeated(self.hinges.iter().map(|hinge| hinge.at), near);
        for ((i, hinge), other) in self.hinges.iter().enumerate().zip(repeated) {
            let part = Part::Hinge(i);
            self.check_position(found, part, hinge.at);
            let mut report = |code, field, message: String, hint: String| {
                let problem = Problem::new(code, part, field, message, hint);
                found.push(problem.with_numbers(&[hinge.at, self.beam.length]));
            };
            if hinge.at.abs() <= near || (l - hinge.at).abs() <= near {
                let message = if hinge.at == 0.0 || hinge.at == l {
                    "the hinge at {0} is at an end of the beam, where it has no effect"
                } else {
                    "the hinge at {0} is too close to an end of the beam: the two positions are equal within rounding error"
                };
                let hint = "a hinge joins two parts of the beam: place it between 0 and {1}, or leave it out";
                report("GB404", "at", message.into(), hint.into());
            }
            let spring = hinge.rotational_spring;
            if !(in_range(spring) && spring >= 0.0) {
                let message = format!("the hinge's spring constant is {}", describe(spring));
                let hint = remedy(
                    spring,
                    "the spring constant must be positive, or zero for a free hinge",
                );
                report("GB405", "rotational_spring", message, hint);
            }
            if let Some(other) = other {
                let message = format!("there is already a hinge at {{0}} (hinge {})", other + 1);
                let hint =
                    "two hinges at one position act as one hinge: remove one of the two hinges";
                report("GB406", "at", message, hint.into());
            }
            if let Some(what) = turning.at(hinge.at, near) {
                let message = format!(
                    "{what} at {{0}} acts on the slope, which is discontinuous at the hinge"
                );
                let hint = "place the moment or support slightly to one side of the hinge";
                report("GB407", "at", message, hint.into());
            }
        }
    }

    /// Requires that a one-way support has no rotational restraint.
    pub(crate) fn check_one_way(&self, found: &mut Vec<Problem>) {
        for (i, support) in self.supports.iter().enumerate().filter(|(_, s)| s.is_one_way()) {
            let what = match support.kind {
                SupportKind::Fixed => "a fixed support",
                SupportKind::Spring { rotational_spring, .. } if rotational_spring != 0.0 => {
                    "a support with a rotational spring"
                }
                SupportKind::Pinned | SupportKind::Spring { .. } => continue,
            };
            let message =
                format!("{what} restrains the slope, so it cannot act in one direction only");
            let hint = "a one-way support is pinned or has a translational spring only; \
                        give the rotational restraint as a second support at another position";
            found.push(Problem::new("GB408", Part::Support(i), "acts", message, hint));
        }
    }
}

/// Positions and indices of the point moments, and of the supports that restrain the rotation of
/// the beam.
struct Turning {
    moments: Places,
    supports: Places,
}

impl Turning {
    fn of(model: &Model) -> Self {
        let mut moments = Places::default();
        for (i, load) in model.loads.iter().enumerate() {
            if let Some((at, moment)) = load.at_point(Action::Moment)
                && moment != 0.0
            {
                moments.add(at, i);
            }
        }
        let turns = |kind: SupportKind| match kind {
            SupportKind::Pinned => false,
            SupportKind::Fixed => true,
            SupportKind::Spring { rotational_spring, .. } => rotational_spring != 0.0,
        };
        let mut supports = Places::default();
        for (i, support) in model.supports.iter().enumerate().filter(|(_, s)| turns(s.kind)) {
            supports.add(support.at, i);
        }
        Turning { moments, supports }
    }

    fn at(&self, x: f64, near: f64) -> Option<String> {
        let moment =
            self.moments.first_at(x, near).map(|i| format!("the moment of load {}", i + 1));
        moment.or_else(|| self.supports.first_at(x, near).map(|i| format!("support {}", i + 1)))
    }
}
