//! Cuts a part out of a model: the beam between two positions, on the unchanged ground of the whole model.

use super::foundation::GroundEnd;
use super::{Extent, FoundationSegment, GapPoint, Hinge, Load, Model, Support};
use crate::model::beam::BeamSegment;

impl Model {
    /// Returns the part of the model between `from` and `to`, with x measured from `from`. The ground remains whole. No
    /// support and no load on the beam may lie outside the part.
    pub(crate) fn part(&self, [from, to]: [f64; 2]) -> Model {
        let shift = |x: f64| x - from;
        let mut part = self.clone();
        part.beam.length = to - from;
        for BeamSegment { from, to, .. } in &mut part.beam.segments {
            (*from, *to) = (shift(*from), shift(*to));
        }
        for FoundationSegment { from, to, .. } in &mut part.foundation.segments {
            (*from, *to) = (shift(*from), shift(*to));
        }
        for end in &mut part.foundation.ends {
            match end {
                GroundEnd::Endless => {}
                GroundEnd::Free { at } | GroundEnd::Held { at } => *at = shift(*at),
            }
        }
        for Load { extent, .. } in &mut part.loads {
            match extent {
                Extent::Point { at, .. } => *at = shift(*at),
                Extent::Distributed { from, to, .. } => (*from, *to) = (shift(*from), shift(*to)),
            }
        }
        part.hinges.retain(|hinge| from < hinge.at && hinge.at < to);
        part.hinges.iter_mut().for_each(|Hinge { at, .. }| *at = shift(*at));
        part.supports.iter_mut().for_each(|Support { at, .. }| *at = shift(*at));
        part.gap.iter_mut().for_each(|GapPoint { at, .. }| *at = shift(*at));
        part
    }
}
