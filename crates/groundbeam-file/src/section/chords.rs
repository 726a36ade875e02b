//! Computes the length of the chords that replace settlement troughs, from EI, S, P, k, μ and the loads.

use super::trough::Trough;
use groundbeam::{Beam, Load, Model};

/// Allowed change of a field by the chords, relative to its largest magnitude.
const TOLERANCE: f64 = 1e-3;

/// Chords per width of a trough for the deflection and the moment, to the same number of widths on both sides
/// of its middle.
const PER_WIDTH: f64 = 24.0;
const NEAR: f64 = 5.0;
/// Chords per length of the beam where slope jumps of the gap move the contact edges.
const PER_LENGTH: f64 = 600.0;

/// Density of chords along the beam. docs/ground.md, *Settlement troughs*, derives the rules:
///
/// * deflection: h ≤ i/24, and less for a beam beside the trough;
/// * moment: 3.3 T(2π/h) ≤ ε T(1/i), where T(q) is the moment of a bonded beam on ground with the gap cos qx;
/// * pressure: h² (k + μ²/EI)|g″|/12 ≤ ε p̄, where p̄ is the load per length;
/// * contact edges: μ h|g″| ≤ ε p̄ l or h ≤ l/600.
pub(super) struct Spacing<'a> {
    troughs: &'a [Trough],
    /// The chords that deflection and moment need, for each trough.
    even: Vec<Even>,
    /// 1/h² of the chords that the pressure needs, divided by |g″|.
    by_curvature: f64,
    /// 1/h of the chords that the contact edges need, divided by |g″|.
    by_corner: f64,
    /// Upper limit of 1/h of the chords that the contact edges need.
    most_for_corners: f64,
}

/// Chords of equal length near a trough, for the deflection and the moment.
struct Even {
    /// 1/h².
    density: f64,
    /// Square of the distance from the trough up to which these chords are needed, in widths of the trough.
    reach: f64,
}

impl<'a> Spacing<'a> {
    /// For a model whose k and μ may have factors between two `multiples`, under the mean load `pressure`. An infinite
    /// `pressure` stands for a model without loads: then the pressure and the contact edges need no chords.
    pub fn new(
        model: &Model,
        multiples: [[f64; 2]; 2],
        pressure: f64,
        troughs: &'a [Trough],
    ) -> Self {
        let ranges = Ranges::of(model, multiples);
        let l = model.beam.length;
        let even = troughs.iter().map(|trough| {
            let of_field = PER_WIDTH / trough.width;
            let of_moment = ranges.bonded().map(|bonded| 1.0 / bonded.longest(trough.width));
            // A beam beside the trough rests on its tail, which decays over a length of i/t at t widths from the middle.
            let away = ((trough.at.clamp(0.0, l) - trough.at) / trough.width).powi(2);
            Even {
                density: of_moment.fold(of_field, f64::max).powi(2) * (1.0 + away),
                reach: NEAR * NEAR + away,
            }
        });
        let (k, mu) = (ranges.spring[1], ranges.shear[1]);
        let allowed = TOLERANCE * pressure;
        Spacing {
            even: even.collect(),
            by_curvature: (k + mu * (mu / ranges.bending[0])) / 12.0 / allowed,
            by_corner: mu / l / allowed,
            most_for_corners: PER_LENGTH / l,
            troughs,
        }
    }

    /// 1/h.
    pub fn chords_per_length(&self, x: f64) -> f64 {
        let (mut density, mut curvature) = (0.0, 0.0);
        for (trough, even) in self.troughs.iter().zip(&self.even) {
            let t2 = ((x - trough.at) / trough.width).powi(2);
            if t2 <= even.reach {
                density += even.density;
            }
            curvature += trough.largest_curvature(t2);
        }
        let corners = (self.by_corner * curvature).min(self.most_for_corners);
        (density + self.by_curvature * curvature + corners * corners).sqrt()
    }
}

/// Estimated mean pressure under the beam: forces and moments divided by the length. Each load has its factor
/// from `factors`.
pub(super) fn mean_load(loads: &[Load], l: f64, factors: impl Fn(usize) -> f64) -> f64 {
    let sizes = loads.iter().enumerate().map(|(i, load)| factors(i).abs() * load.as_force(l));
    sizes.sum::<f64>() / l
}

/// Ranges of the constants along the beam.
struct Ranges {
    /// EI.
    bending: [f64; 2],
    /// The smallest S; `None` without shear deformation.
    shearing: Option<f64>,
    /// P; 0 under compression.
    tension: f64,
    /// k.
    spring: [f64; 2],
    /// μ.
    shear: [f64; 2],
}

impl Ranges {
    fn of(model: &Model, multiples: [[f64; 2]; 2]) -> Self {
        let Beam { length, axial_force, .. } = model.beam;
        let range = |base: f64, others: &mut dyn Iterator<Item = [f64; 2]>| {
            others.fold([base; 2], |[low, high], [least, most]| [low.min(least), high.max(most)])
        };
        let beam = &model.beam.segments;
        let ground = || model.foundation.segments.iter().filter(|s| s.from < length && s.to > 0.0);
        let ends = |profile: groundbeam::model::Profile| [profile.smallest(), profile.largest()];
        let times = |[low, high]: [f64; 2], [a, b]: [f64; 2]| [low * a, high * b];
        let shears = beam.iter().filter_map(|s| s.shear_stiffness).map(|s| s.smallest());
        Ranges {
            bending: range(
                model.beam.bending_stiffness,
                &mut beam.iter().map(|s| ends(s.bending_stiffness)),
            ),
            shearing: shears.chain(model.beam.shear_stiffness).reduce(f64::min),
            tension: axial_force.max(0.0),
            spring: times(
                range(model.foundation.subgrade, &mut ground().map(|s| ends(s.subgrade))),
                multiples[0],
            ),
            shear: times(
                range(model.foundation.shear_layer, &mut ground().map(|s| ends(s.shear_layer))),
                multiples[1],
            ),
        }
    }

    /// Bonded beams with all combinations of the smallest and the largest constants.
    fn bonded(&self) -> impl Iterator<Item = Bonded> {
        (0..8).map(|i| Bonded {
            bending: self.bending[i & 1],
            spring: self.spring[i >> 1 & 1],
            shear: self.shear[i >> 2],
            shearing: self.shearing,
            tension: self.tension,
        })
    }
}

/// An infinite bonded beam.
struct Bonded {
    bending: f64,
    shearing: Option<f64>,
    tension: f64,
    spring: f64,
    shear: f64,
}

impl Bonded {
    /// M/g″ on ground with the gap g = cos qx.
    fn moment(&self, q: f64) -> f64 {
        let q2 = q * q;
        let bending = self.bending / (1.0 + self.shearing.map_or(0.0, |s| self.bending * q2 / s));
        let ground = self.spring + self.shear * q2;
        bending * (ground / (ground + q2 * (self.tension + bending * q2)))
    }

    /// The longest chord for which the moment differs by less than the tolerance.
    fn longest(&self, width: f64) -> f64 {
        // The gap between curve and chords is a periodic row of parabolas. Its first harmonic has the wave length of
        // a chord; the factor π²/6 accounts for the higher harmonics.
        let few = TOLERANCE * self.moment(1.0 / width) / 3.3;
        let (mut short, mut long) = (0.0, width);
        for _ in 0..60 {
            let h = 0.5 * (short + long);
            if self.moment(std::f64::consts::TAU / h) <= few { short = h } else { long = h }
        }
        long
    }
}
