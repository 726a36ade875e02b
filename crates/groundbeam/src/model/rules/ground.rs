//! The rules for the ground under the beam and outside it.

use super::places::Places;
use super::positions::{check_order, overlaps};
use crate::model::problem::{Part, Problem, describe, in_range, positive_along, remedy};
use crate::model::{Foundation, FoundationSegment, GroundEnd, Model, Profile};

impl Model {
    pub(super) fn check_foundation(&self, found: &mut Vec<Problem>) {
        let mut constants = |part, spring: &Profile, shear: &Profile| {
            positive_along(found, "GB201", part, "subgrade", spring, "the spring constant k");
            check_shear(found, part, shear);
            for (field, constant) in [("subgrade", spring), ("shear_layer", shear)] {
                if constant.control_values().len() > Foundation::MOST_CONTROL_VALUES {
                    let message =
                        "this profile has more than three control values (Bernstein coefficients)";
                    let hint = "split the segment into two segments, or make the profile linear";
                    found.push(Problem::new("GB204", part, field, message, hint));
                }
            }
        };
        let ground = &self.foundation;
        constants(Part::Foundation, &ground.subgrade.into(), &ground.shear_layer.into());
        for (i, s) in ground.segments.iter().enumerate() {
            constants(Part::FoundationSegment(i), &s.subgrade, &s.shear_layer);
        }
        for (i, s) in ground.segments.iter().enumerate() {
            let part = Part::FoundationSegment(i);
            check_order(found, part, s.from, s.to);
            let beside = s.to <= 0.0 || s.from >= self.beam.length;
            if beside && !(s.subgrade.is_constant() && s.shear_layer.is_constant()) {
                let message = "ground outside the beam cannot vary along a segment";
                let hint = "divide the segment into several segments with constant k and mu; the beam is {0} long";
                let problem = Problem::new("GB203", part, "from", message, hint);
                found.push(problem.with_numbers(&[self.beam.length]));
            }
        }
        let endless = ground.ends.iter().all(|end| *end == GroundEnd::Endless);
        if ground.soil.is_some() && !(ground.segments.is_empty() && endless) {
            let message = "ground defined by soil data is uniform and infinite";
            let hint = "remove the ground segments and the definitions of the ground's ends, \
                        or give k and mu in place of the soil data";
            found.push(Problem::new("GB212", Part::Foundation, "soil", message, hint));
        }
        self.check_ground_ends(found);
        let spans: Vec<_> = ground.segments.iter().map(|s| (s.from, s.to)).collect();
        overlaps(found, &spans, Part::FoundationSegment);
    }

    pub(crate) fn check_ground_ends(&self, found: &mut Vec<Problem>) {
        let l = self.beam.length;
        let sides = [("left", -1.0, 0.0), ("right", 1.0, l)];
        for ((field, outward, end), ground) in sides.into_iter().zip(self.foundation.ends) {
            let Some(at) = ground.at() else { continue };
            let beyond = outward * (at - end);
            let (right, hint) = match ground {
                GroundEnd::Held { .. } => {
                    (beyond > 0.0, "the wall must lie beyond the beam's end at {1}")
                }
                _ => (
                    beyond >= 0.0,
                    "the ground must not end inside the beam: \
                     it must reach at least the beam's end at {1}",
                ),
            };
            if !(right && in_range(at) && in_range(beyond)) {
                let message = "the ground cannot end at {0}";
                let problem = Problem::new("GB207", Part::Foundation, field, message, hint);
                found.push(problem.with_numbers(&[at, end]));
            }
        }
    }

    pub(crate) fn varying_ground(&self) -> Option<Part> {
        let varies =
            |s: &FoundationSegment| !(s.subgrade.is_constant() && s.shear_layer.is_constant());
        self.foundation.segments.iter().position(varies).map(Part::FoundationSegment)
    }

    /// Positions at which segments of the ground begin, with the indices of the segments.
    pub(crate) fn ground_begins(&self) -> Places {
        let mut begins = Places::default();
        for (i, segment) in self.foundation.segments.iter().enumerate() {
            begins.add(segment.from, i);
        }
        begins
    }

    /// Whether the ground under the beam has no shear layer at a position and immediately to the left of this
    /// position.
    pub(crate) fn ground_has_no_layer(&self, begins: &Places, at: f64) -> bool {
        let ground = &self.foundation;
        let shear = |x: f64| {
            let segment = begins.last_up_to(x).map(|i| &ground.segments[i]);
            let segment = segment.filter(|s| s.from <= x && x < s.to);
            segment.map_or(ground.shear_layer, |s| s.shear_layer.at_position([s.from, s.to], x))
        };
        let on_beam = at >= 0.0 && at <= self.beam.length;
        on_beam && [at, at - f64::EPSILON * self.beam.length].into_iter().all(|x| shear(x) == 0.0)
    }

    /// Requires that a load on the ground lies between the ends of the ground.
    pub(crate) fn check_on_ground(
        &self,
        found: &mut Vec<Problem>,
        part: Part,
        field: &'static str,
        [from, to]: [f64; 2],
    ) {
        let [left, right] = self.foundation.ends;
        let off = left.at().is_some_and(|end| from < end) || right.at().is_some_and(|end| to > end);
        if off {
            let message = "this load extends beyond an end of the ground";
            let hint = "move the load, or extend the ground with `left` or `right` in [foundation]";
            found.push(Problem::new("GB208", part, field, message, hint));
        }
    }
}

/// Requires that μ is zero everywhere or positive everywhere. A shear layer whose μ decreases to zero has no
/// defined end.
fn check_shear(found: &mut Vec<Problem>, part: Part, shear: &Profile) {
    let values = shear.control_values();
    let wrong = values.iter().find(|value| !(in_range(**value) && **value >= 0.0));
    if let Some(&value) = wrong {
        let message = format!("the shear constant mu is {}", describe(value));
        let hint = remedy(value, "it must be zero (Winkler) or positive");
        found.push(Problem::new("GB202", part, "shear_layer", message, hint));
    } else if !shear.is_constant() && values.contains(&0.0) {
        let message = "the shear constant mu varies and falls to zero";
        let hint = "where mu varies it must stay positive; end this segment at a small positive value of mu \
                    where the shear layer ends, and add a segment with mu = 0 beside it";
        found.push(Problem::new("GB205", part, "shear_layer", message, hint));
    }
}
