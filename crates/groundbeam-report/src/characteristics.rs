//! Computes characteristic numbers of a beam on ground, such as βl, from EI, k, μ and the loads.

use groundbeam::{Existence, Model};
use serde::Serialize;

/// Characteristic numbers of a beam on ground: β, βl, the shear length √(μ/k), and the resultant of the
/// loads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Characteristics {
    /// Smallest and largest value of β = (k/(4EI))^¼ \[1/m\] along the beam.
    pub beta: [f64; 2],
    /// Product βl of β and the beam length, or ∫β dx if β varies. Below π/4 the beam is nearly rigid. Above π
    /// the ends of the beam do not influence each other (Hetényi).
    pub beta_length: f64,
    /// Smallest and largest value of the shear length √(μ/k) \[m\] along the beam. It is the decay length of
    /// the ground displacement outside the beam.
    pub shear_length: [f64; 2],
    /// Resultant of the loads.
    pub resultant: Resultant,
}

/// The resultant of the loads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Resultant {
    /// Resultant force \[N\], positive downward.
    pub force: f64,
    /// The position of the resultant \[m\]; `None` if the force is zero.
    pub at: Option<f64>,
}

impl Characteristics {
    /// The characteristics of a valid model.
    pub fn of(model: &Model, existence: &Existence) -> Self {
        let mut beta = [f64::INFINITY, 0.0_f64];
        let mut shear_length = [f64::INFINITY, 0.0_f64];
        let mut beta_length = 0.0;
        let (beam, ground) = (&model.beam, &model.foundation);
        let beam_segments = Ordered::new(&beam.segments, |s| [s.from, s.to]);
        let ground_segments = Ordered::new(&ground.segments, |s| [s.from, s.to]);
        let at = |x: f64| {
            let segment = beam_segments.at(x);
            let stiffness = segment.map_or(beam.bending_stiffness, |s| s.bending_stiffness_at(x));
            let segment = ground_segments.at(x);
            let (spring, shear) =
                segment.map_or((ground.subgrade, ground.shear_layer), |s| s.constants_at(x));
            ((spring / (4.0 * stiffness)).sqrt().sqrt(), (shear / spring).sqrt())
        };
        let steps = if varies(model) { STEPS } else { 1 };
        for [from, to] in stretches(model) {
            for i in 0..steps {
                let middle = from + (to - from) * ((i as f64 + 0.5) / steps as f64);
                let (here, layer) = at(middle);
                beta_length += here * (to - from) / steps as f64;
                beta = widened(beta, here);
                shear_length = widened(shear_length, layer);
            }
        }
        let resultant = Resultant {
            force: existence.resultant(),
            at: existence.resultant_position(model.beam.length),
        };
        Characteristics { beta, beta_length, shear_length, resultant }
    }

    /// Computes the characteristic numbers of several valid models with the same resultant of the loads. β and the
    /// shear length are ranges over all models. βl is that of the first model.
    pub(crate) fn of_all(models: &[&Model], existence: &Existence) -> Option<Self> {
        let each = models.iter().map(|model| Characteristics::of(model, existence));
        each.reduce(|all, other| {
            let joined = |[a, b]: [f64; 2], [low, high]: [f64; 2]| [a.min(low), b.max(high)];
            Characteristics {
                beta: joined(all.beta, other.beta),
                shear_length: joined(all.shear_length, other.shear_length),
                ..all
            }
        })
    }

    /// Class of the beam by its βl (Hetényi): short, medium or long.
    pub(crate) fn class(&self) -> &'static str {
        use std::f64::consts::PI;
        if self.beta_length < 0.25 * PI {
            "a short, nearly rigid beam"
        } else if self.beta_length < PI {
            "a beam of medium length"
        } else {
            "a long beam"
        }
    }
}

/// Non-overlapping segments, sorted from left to right. Bisection finds the segment at a position.
struct Ordered<'a, S> {
    segments: Vec<&'a S>,
    ends: fn(&S) -> [f64; 2],
}

impl<'a, S> Ordered<'a, S> {
    fn new(segments: &'a [S], ends: fn(&S) -> [f64; 2]) -> Self {
        let mut segments: Vec<&S> = segments.iter().collect();
        segments.sort_by(|a, b| ends(a)[0].total_cmp(&ends(b)[0]));
        Ordered { segments, ends }
    }

    fn at(&self, x: f64) -> Option<&'a S> {
        let after = self.segments.partition_point(|s| (self.ends)(s)[0] <= x);
        let last = self.segments[..after].last().copied();
        last.filter(|s| x < (self.ends)(s)[1])
    }
}

fn widened([low, high]: [f64; 2], value: f64) -> [f64; 2] {
    [low.min(value), high.max(value)]
}

/// Number of integration steps on each stretch of the beam, if the stiffness of the beam or of the ground varies.
const STEPS: usize = 256;

/// Whether the stiffness of the beam or of the ground varies along any segment.
fn varies(model: &Model) -> bool {
    let beam = model.beam.segments.iter().map(|s| &s.bending_stiffness);
    let ground = model.foundation.segments.iter().flat_map(|s| [&s.subgrade, &s.shear_layer]);
    beam.chain(ground).any(|profile| !profile.is_constant())
}

/// Returns the stretches of the beam between adjacent ends of beam and ground segments.
fn stretches(model: &Model) -> Vec<[f64; 2]> {
    let l = model.beam.length;
    let beam = model.beam.segments.iter().flat_map(|s| [s.from, s.to]);
    let ground = model.foundation.segments.iter().flat_map(|s| [s.from, s.to]);
    let mut joints: Vec<f64> = beam.chain(ground).filter(|x| *x > 0.0 && *x < l).collect();
    joints.extend([0.0, l]);
    joints.sort_by(f64::total_cmp);
    joints.dedup();
    joints.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::{Beam, Foundation, Load};

    #[test]
    fn characteristics_of_a_varying_beam() {
        let beam = Beam::uniform(4.0, 0.25).with_segment(1.0, 3.0, 4.0);
        let model = Model::new(beam, Foundation::pasternak(1.0, 4.0))
            .with_load(Load::point_force(3.0, 2.0));
        let existence = groundbeam::exists(&model).unwrap();
        let found = Characteristics::of(&model, &existence);
        assert_eq!(found.beta, [0.5, 1.0]);
        assert_eq!(found.beta_length, 3.0);
        assert_eq!(found.shear_length, [2.0, 2.0]);
        assert_eq!(found.resultant, Resultant { force: 2.0, at: Some(3.0) });
    }
}
