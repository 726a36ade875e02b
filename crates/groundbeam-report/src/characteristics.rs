//! Computes characteristic numbers of a beam on ground, such as βl, from EI, k, μ and the loads.

use groundbeam::{Existence, Model};
use serde::Serialize;

/// β, βl, the shear length and the resultant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Characteristics {
    /// β = (k/4EI)^¼ \[1/m\]: smallest and largest value along the beam.
    pub beta: [f64; 2],
    /// βl; ∫β dx if β varies. Below π/4 the beam is nearly rigid. Above π its ends do not influence each
    /// other (Hetényi).
    pub beta_length: f64,
    /// √(μ/k) \[m\], the decay length of the ground's surface outside the beam: smallest and largest value.
    pub shear_length: [f64; 2],
    /// Resultant of the loads.
    pub resultant: Resultant,
}

/// The resultant of the loads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Resultant {
    /// The force \[N\], positive downward.
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

    /// The characteristics of several valid models with one resultant: the first model, with the ranges over
    /// all models.
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

    /// Hetényi's class of the beam.
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

/// Non-overlapping segments from left to right; a position is found by bisection.
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

/// Number of integration steps along a varying segment.
const STEPS: usize = 256;

/// Whether any segment varies.
fn varies(model: &Model) -> bool {
    let beam = model.beam.segments.iter().map(|s| &s.bending_stiffness);
    let ground = model.foundation.segments.iter().flat_map(|s| [&s.subgrade, &s.shear_layer]);
    beam.chain(ground).any(|profile| !profile.is_constant())
}

/// Parts of the beam on which neither beam nor ground changes segment.
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
