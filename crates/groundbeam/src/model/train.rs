//! Axle trains, which are loads at fixed distances that move along the beam together.

use crate::model::{Load, Model};
use crate::numeric::tolerance;

/// Axles and distributed loads at fixed distances, which move along the beam together.
///
/// The position of a train is that of its first axle, which is farthest to the right. Distances are measured backward
/// from this axle.
///
/// ```
/// use groundbeam::model::{Axle, Train};
/// use groundbeam::{Beam, Foundation, Load, Model};
///
/// let axle = |behind| Axle { behind, force: 250e3 };
/// let bogie = Train { axles: vec![axle(0.0), axle(1.8)], uniform: Vec::new() };
/// let rail = Model::new(Beam::uniform(12.0, 6.4e6), Foundation::winkler(40e6));
/// // The second axle is not on the beam yet.
/// assert_eq!(bogie.on(&rail, 1.5).loads, [Load::point_force(1.5, 250e3)]);
/// assert_eq!(bogie.passage(12.0), [0.0, 13.8]);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Train {
    /// Single forces.
    pub axles: Vec<Axle>,
    /// Distributed loads.
    pub uniform: Vec<UniformPart>,
}

/// One axle of a train.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Axle {
    /// Distance of the axle behind the first axle \[m\].
    #[cfg_attr(feature = "serde", serde(rename = "at"))]
    pub behind: f64,
    /// Force, down \[N\].
    pub force: f64,
}

/// A stretch of a train with a uniform load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct UniformPart {
    /// Distance \[m\] from the first axle back to the front end of the load. It is negative if the front end lies ahead
    /// of the first axle, and −∞ if the load extends forward without end.
    pub from: f64,
    /// Distance \[m\] from the first axle back to the rear end of the load; ∞ if the load extends backward without end.
    pub to: f64,
    /// Intensity, down \[N/m\].
    #[cfg_attr(feature = "serde", serde(rename = "load"))]
    pub intensity: f64,
}

impl Train {
    /// Distance \[m\] within which two positions count as equal, proportional to the length of the passage. An axle
    /// this close to a load, a support or an end of the beam is moved to that point.
    pub fn same_place(&self, beam_length: f64) -> f64 {
        let [from, to] = self.passage(beam_length);
        tolerance::same_place(to - from)
    }

    /// Distance from the first axle to the last \[m\].
    pub fn length(&self) -> f64 {
        self.axles.iter().fold(0.0, |length, axle| length.max(axle.behind))
    }

    /// First and last position of the first axle in a passage \[m\]. The passage begins when the first axle or finite
    /// load reaches the left end of the beam, and ends when the last one leaves the right end.
    pub fn passage(&self, beam_length: f64) -> [f64; 2] {
        let fronts = self.uniform.iter().map(|part| part.from).filter(|from| from.is_finite());
        let ends = self.uniform.iter().map(|part| part.to).filter(|to| to.is_finite());
        [fronts.fold(0.0, f64::min), beam_length + ends.fold(self.length(), f64::max)]
    }

    /// Returns the train with every load multiplied by `factor`.
    pub fn scaled(mut self, factor: f64) -> Self {
        for axle in &mut self.axles {
            axle.force *= factor;
        }
        for part in &mut self.uniform {
            part.intensity *= factor;
        }
        self
    }

    /// Returns the mirrored train, whose first axle is the last axle of the original train.
    pub fn mirrored(&self) -> Self {
        let length = self.length();
        let axle = |axle: &Axle| Axle { behind: length - axle.behind, ..*axle };
        let part = |part: &UniformPart| UniformPart {
            from: length - part.to,
            to: length - part.from,
            ..*part
        };
        Train {
            axles: self.axles.iter().rev().map(axle).collect(),
            uniform: self.uniform.iter().rev().map(part).collect(),
        }
    }

    /// Returns a model with the train on it and the first axle at `position`. Loads outside the beam are omitted.
    pub fn on(&self, model: &Model, position: f64) -> Model {
        let l = model.beam.length;
        let (marks, near) = (model.marks(), self.same_place(l));
        let mut loaded = model.clone();
        for axle in &self.axles {
            let at = snapped(position - axle.behind, &marks, near);
            if (0.0..=l).contains(&at) {
                loaded.loads.push(Load::point_force(at, axle.force));
            }
        }
        for part in &self.uniform {
            // `f64::clamp` is not used, because it panics if the length of the beam is invalid.
            let [from, to] = [part.to, part.from]
                .map(|behind| snapped((position - behind).max(0.0).min(l), &marks, near));
            if to > from {
                loaded.loads.push(Load::uniform_force(from, to, part.intensity));
            }
        }
        loaded
    }

    /// Position of an axle if the first axle is at `position`; `None` if the axle is outside the beam.
    pub fn axle_at(&self, axle: usize, position: f64, model: &Model) -> Option<f64> {
        let l = model.beam.length;
        let behind = self.axles.get(axle)?.behind;
        let at = snapped(position - behind, &model.marks(), self.same_place(l));
        (0.0..=l).contains(&at).then_some(at)
    }
}

impl Model {
    /// Positions at which fields of a solution have corners or jumps: the ends of the beam, loads, supports,
    /// hinges, corners of the gap, and ends of segments.
    pub fn marks(&self) -> Vec<f64> {
        let l = self.beam.length;
        let mut x = vec![0.0, l];
        x.extend(self.loads.iter().flat_map(|load| load.extent.ends()));
        x.extend(self.supports.iter().map(|support| support.at));
        x.extend(self.hinges.iter().map(|hinge| hinge.at));
        x.extend(self.gap.iter().map(|corner| corner.at));
        x.extend(self.beam.segments.iter().flat_map(|segment| [segment.from, segment.to]));
        x.extend(self.foundation.segments.iter().flat_map(|segment| [segment.from, segment.to]));
        x.retain(|x| (0.0..=l).contains(x));
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }
}

/// Returns the first of the positions `marks` within the distance `same_place` of x. If no such position exists,
/// returns x.
fn snapped(x: f64, marks: &[f64], same_place: f64) -> f64 {
    marks.iter().copied().find(|mark| (x - mark).abs() <= same_place).unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Beam, Foundation};

    #[test]
    fn loads_outside_the_beam_are_omitted() {
        let beam = Model::new(Beam::uniform(10.0, 1.0), Foundation::winkler(1.0));
        let train = Train {
            axles: vec![Axle { behind: 0.0, force: 2.0 }, Axle { behind: 3.0, force: 4.0 }],
            uniform: vec![UniformPart { from: 4.0, to: f64::INFINITY, intensity: 1.0 }],
        };
        assert_eq!(
            train.on(&beam, 3.0).loads,
            [Load::point_force(3.0, 2.0), Load::point_force(0.0, 4.0)]
        );
        let leaving = train.on(&beam, 11.0).loads;
        assert_eq!(leaving, [Load::point_force(8.0, 4.0), Load::uniform_force(0.0, 7.0, 1.0)]);
        assert_eq!(train.on(&beam, 20.0).loads, [Load::uniform_force(0.0, 10.0, 1.0)]);
        assert_eq!(train.passage(10.0), [0.0, 13.0]);
    }

    #[test]
    fn a_passage_begins_when_a_load_ahead_of_the_first_axle_reaches_the_beam() {
        let part = UniformPart { from: -10.0, to: -5.0, intensity: 1.0 };
        let train = Train { axles: vec![Axle { behind: 0.0, force: 2.0 }], uniform: vec![part] };
        assert_eq!(train.passage(20.0), [-10.0, 20.0]);
        assert_eq!(train.mirrored().passage(20.0), [0.0, 30.0]);
        let endless = UniformPart { from: f64::NEG_INFINITY, ..part };
        assert_eq!(Train { uniform: vec![endless], ..train }.passage(20.0), [0.0, 20.0]);
    }

    #[test]
    fn an_axle_within_rounding_of_a_mark_is_placed_at_the_mark() {
        let third = 1.0 / 3.0;
        let beam = Model::new(Beam::uniform(1.0, 1.0), Foundation::winkler(1.0))
            .with_load(Load::point_force(third, 1.0));
        let train = Train { axles: vec![Axle { behind: 0.1, force: 1.0 }], uniform: Vec::new() };
        assert_eq!(train.axle_at(0, third + 0.1, &beam), Some(third));
        assert_eq!(train.axle_at(0, 0.1 - 1e-8, &beam), None);
    }
}
