//! Computes the length of the chords that replace the curves of settlement troughs, from the stiffnesses and the loads.

use super::trough::Trough;
use groundbeam::{Beam, Load, Model};

/// Allowed error of a result if chords replace the curve of a settlement trough, relative to the largest magnitude of
/// this result along the beam.
const TOLERANCE: f64 = 1e-3;

/// Number of chords that replace a settlement trough, per trough width, for an accurate deflection. It applies up to
/// [`NEAR`] widths from the middle (docs/ground.md, rule 1).
const PER_WIDTH: f64 = 24.0;
const NEAR: f64 = 5.0;
/// Number of chords per beam length that is always sufficient for accurate contact edges. The chords replace the curve
/// of a settlement trough.
const PER_LENGTH: f64 = 600.0;

/// Required number of chords per unit length, 1/h. Chords of the length h replace the curve of the settlement troughs.
/// The section *Settlement troughs* of docs/ground.md derives these rules for a trough of the width i, the initial gap
/// g(x), the tolerance ε and the beam length l:
///
/// * deflection: h ≤ i/24, and less if the middle of the trough lies outside the beam;
/// * bending moment: 3.3 T(2π/h) ≤ ε T(1/i), where T(q) is the ratio |M/g″| for g = cos qx in an infinite beam that
///   does not lift off;
/// * pressure: h² (k + μ²/EI)|g″|/12 ≤ ε p̄, where p̄ is the mean load per length;
/// * contact edges: μ h|g″| ≤ ε p̄ l or h ≤ l/600.
pub(super) struct Spacing<'a> {
    troughs: &'a [Trough],
    /// For each settlement trough, the chords of equal length that replace its curve near its middle. They make the
    /// deflection and the bending moment of the beam accurate.
    even: Vec<Even>,
    /// Factor on the curvature |g″| of the initial gap g. The product is the value of 1/h² that an accurate pressure
    /// requires, where h is the chord length.
    by_curvature: f64,
    /// Factor on the curvature |g″| of the initial gap g. The product is the value of 1/h that accurate contact edges
    /// require, where h is the chord length.
    by_corner: f64,
    /// Number of chords per unit length that is always sufficient for accurate contact edges. The chords replace the
    /// curve of a settlement trough.
    most_for_corners: f64,
}

/// Chords of equal length that replace the curve of a settlement trough near its middle. They make the deflection and
/// the bending moment of the beam accurate.
struct Even {
    /// Required value of 1/h² near the settlement trough, where h is the length of the chords that replace its curve.
    density: f64,
    /// Square of d/i, where i is the width of the settlement trough. The chords of equal length are used up to the
    /// distance d from the middle of the trough.
    reach: f64,
}

impl<'a> Spacing<'a> {
    /// Computes the required number of chords per length. `multiples` are the lower and upper factors on k and on μ.
    /// `pressure` is the mean load \[N/m\], or infinite without loads.
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
            // A beam beside the trough rests on its tail. At t widths from the middle, the tail decays over 1/t widths.
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

    /// Returns the required number of chords per unit length at the position `x`.
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

/// Estimates the mean pressure \[N/m\] under a beam of length `l`: (∑|F| + ∑|M|/l)/l from all forces F and moments M.
/// `factors` returns the factor of each load.
pub(super) fn mean_load(loads: &[Load], l: f64, factors: impl Fn(usize) -> f64) -> f64 {
    let sizes = loads.iter().enumerate().map(|(i, load)| factors(i).abs() * load.as_force(l));
    sizes.sum::<f64>() / l
}

/// Smallest and largest values of the constants of beam and ground along the beam.
struct Ranges {
    /// Range of the bending stiffness EI.
    bending: [f64; 2],
    /// Smallest shear stiffness S of the beam; `None` without shear deformation.
    shearing: Option<f64>,
    /// Axial tension of the beam; 0 under compression.
    tension: f64,
    /// Range of the subgrade modulus k.
    spring: [f64; 2],
    /// Range of the stiffness μ of the shear layer.
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

    /// Iterates over the bonded beams with all combinations of the smallest and the largest EI, k and μ.
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
    /// Computes the ratio |M/g″| of the bending moment to the second derivative of the gap, for the gap
    /// g = cos qx.
    fn moment(&self, q: f64) -> f64 {
        let q2 = q * q;
        let bending = self.bending / (1.0 + self.shearing.map_or(0.0, |s| self.bending * q2 / s));
        let ground = self.spring + self.shear * q2;
        bending * (ground / (ground + q2 * (self.tension + bending * q2)))
    }

    /// Computes the length of the longest chord for which the error of the moment is within the tolerance,
    /// for a trough of this `width`.
    fn longest(&self, width: f64) -> f64 {
        // Rule 2 of *Settlement troughs* in docs/ground.md: 3.3 T(2π/h) ≤ ε T(1/`width`). T is `self.moment`, ε the
        // tolerance and h the chord length.
        let few = TOLERANCE * self.moment(1.0 / width) / 3.3;
        let (mut short, mut long) = (0.0, width);
        for _ in 0..60 {
            let h = 0.5 * (short + long);
            if self.moment(std::f64::consts::TAU / h) <= few { short = h } else { long = h }
        }
        long
    }
}
