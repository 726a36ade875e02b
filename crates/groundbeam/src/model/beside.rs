//! The rules for ground beside the beam, and for what acts on the ground.

use super::places::Places;
use super::{FoundationSegment, GroundEnd, Model, Part, Problem};
use crate::model::problem::in_range;

impl Model {
    pub(super) fn check_ground_ends(&self, found: &mut Vec<Problem>) {
        let l = self.beam.length;
        let sides = [("left", -1.0, 0.0), ("right", 1.0, l)];
        for ((field, outward, end), ground) in sides.into_iter().zip(self.foundation.ends) {
            let Some(at) = ground.at() else { continue };
            let beyond = outward * (at - end);
            let (right, hint) = match ground {
                GroundEnd::Held { .. } => {
                    (beyond > 0.0, "a wall stands beyond the beam's end, which is at {1}")
                }
                _ => (beyond >= 0.0, "the ground ends at the beam's end or beyond it, at {1}"),
            };
            if !(right && in_range(at) && in_range(beyond)) {
                let message = "the ground cannot end at {0}";
                let problem = Problem::new("GB207", Part::Foundation, field, message, hint);
                found.push(problem.with_numbers(&[at, end]));
            }
        }
    }

    pub(super) fn varying_ground(&self) -> Option<Part> {
        let varies =
            |s: &FoundationSegment| !(s.subgrade.is_constant() && s.shear_layer.is_constant());
        self.foundation.segments.iter().position(varies).map(Part::FoundationSegment)
    }

    /// Where segments of the ground begin.
    pub(super) fn ground_begins(&self) -> Places {
        let mut begins = Places::default();
        for (i, segment) in self.foundation.segments.iter().enumerate() {
            begins.add(segment.from, i);
        }
        begins
    }

    /// Whether the ground at and left of a place under the beam has no shear layer.
    pub(super) fn ground_has_no_layer(&self, begins: &Places, at: f64) -> bool {
        let ground = &self.foundation;
        let shear = |x: f64| {
            let segment = begins.last_up_to(x).map(|i| &ground.segments[i]);
            let segment = segment.filter(|s| s.from <= x && x < s.to);
            segment.map_or(ground.shear_layer, |s| s.shear_layer.at_position([s.from, s.to], x))
        };
        let on_beam = at >= 0.0 && at <= self.beam.length;
        on_beam && [at, at - f64::EPSILON * self.beam.length].into_iter().all(|x| shear(x) == 0.0)
    }

    /// A load on the ground must stand where there is ground.
    pub(super) fn check_on_ground(
        &self,
        found: &mut Vec<Problem>,
        part: Part,
        field: &'static str,
        [from, to]: [f64; 2],
    ) {
        let [left, right] = self.foundation.ends;
        let off = left.at().is_some_and(|end| from < end) || right.at().is_some_and(|end| to > end);
        if off {
            let message = "the ground does not reach as far as this load";
            let hint = "it ends where `left` and `right` say";
            found.push(Problem::new("GB208", part, field, message, hint));
        }
    }
}
