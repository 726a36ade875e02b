//! Computes the coefficients of the beam equation on a cell, with or without contact: stiffness, tension, subgrade and loads.

use crate::element::element::MOST_COMPRESSION;
use crate::mesh::cell::Cell;
use crate::mesh::ground_stretch::GROUND;
use crate::model::Profile;
use crate::numeric::polynomial::value;
use crate::numeric::real::Real;

/// Whether the beam is in contact with the ground along a whole cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ZoneKind {
    /// Contact along the whole cell: the ground displacement u equals the deflection w minus the initial gap g₀.
    Contact,
    /// No contact anywhere on the cell: the ground does not occur in the beam equation.
    Open,
}

/// The coefficients of the beam equation (EI w″)″ − (N w')' + κ w = F − G' on a cell, with or without contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Operator<R = f64> {
    /// Bending stiffness EI.
    pub stiffness: R,
    /// Tension N: the axial force P, plus μ in contact.
    pub tension: R,
    /// Subgrade modulus κ in the beam equation: k in contact, 0 out of contact.
    pub subgrade: R,
    /// Load F at both ends of the cell: the load f on the beam. In contact, F also contains the load on the ground and
    /// k g₀, with the subgrade modulus k and the initial gap g₀.
    pub load: [R; 2],
    /// Moment load G at both ends of the cell. In contact, it includes μ g₀′ of the shear layer under the slope g₀′ of
    /// the initial gap.
    pub moment_load: [R; 2],
    /// Moment EI κ₀ of an imposed curvature κ₀ at both ends of the cell.
    pub imposed_moments: [R; 2],
    /// All coefficients as polynomials, if EI, N or κ varies or the beam has shear deformation. The other fields then
    /// contain the values at the middle and the ends of the cell.
    pub polynomials: Option<Polynomials<R>>,
}

impl<R: Real> Operator<R> {
    pub fn of(cell: &Cell<R>, axial_force: R, touch: ZoneKind) -> Self {
        let off = Operator {
            stiffness: cell.stiffness,
            tension: axial_force,
            subgrade: R::ZERO,
            load: cell.load,
            moment_load: cell.moment_load,
            imposed_moments: cell.curvature.map(|curvature| cell.stiffness * curvature),
            polynomials: Polynomials::of(cell, axial_force, touch),
        };
        if touch == ZoneKind::Open {
            return off;
        }
        Operator {
            tension: axial_force + cell.shear_layer,
            subgrade: cell.subgrade,
            load: [0, 1].map(|i| cell.load[i] + cell.subgrade * cell.gap[i] + cell.ground_load[i]),
            moment_load: cell.moment_load.map(|g| g + cell.shear_layer * cell.gap_slope),
            ..off
        }
    }

    /// Whether the derivatives of all coefficients with respect to the parameters are zero.
    pub fn is_still(&self) -> bool {
        let Operator { stiffness, tension, subgrade, load, moment_load, .. } = *self;
        let pairs = [load, moment_load, self.imposed_moments];
        let mut all = [stiffness, tension, subgrade].into_iter().chain(pairs.into_iter().flatten());
        all.all(|c| c == c.value()) && self.polynomials.as_ref().is_none_or(Polynomials::is_still)
    }

    /// Whether the shear stiffness plus the tension is positive and the waves are long enough for elements. If the sum
    /// is not positive, the beam buckles in arbitrarily short waves.
    pub fn bears_shear(&self, length: f64) -> bool {
        let shears = self.polynomials.as_ref().filter(|all| all.shear.is_some());
        let shortest = MOST_COMPRESSION.sqrt();
        shears.is_none_or(|all| all.resists_shear() && self.wave_number() * length <= shortest)
    }

    /// Upper bound of |r| \[1/m\] for all roots r of EI r⁴ − N r² + κ = 0 or, with shear deformation, of (3) in
    /// `docs/shear.md`. Variable coefficients are evaluated at the ends and in the middle.
    pub fn wave_number(&self) -> f64 {
        let [stiffness, tension, spring] = match &self.polynomials {
            None => [self.stiffness.value(), self.tension.value().abs(), self.subgrade.value()],
            Some(all) => all.extremes(),
        };
        wave_number(stiffness, tension, spring)
    }
}

/// Upper bound of |r| \[1/m\] for all roots r of the characteristic equation EI r⁴ − N r² + κ = 0. The arguments are
/// EI, the magnitude of the tension N, and the subgrade κ.
pub(crate) fn wave_number(stiffness: f64, tension: f64, spring: f64) -> f64 {
    let n = tension / stiffness;
    let k = spring / stiffness;
    (0.5 * (n + (n * n + 4.0 * k).sqrt())).sqrt()
}

/// The coefficients of the beam equation on a cell, with or without contact, as polynomials in the local coordinate s ∈
/// \[−1, 1\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Polynomials<R = f64> {
    /// Bending stiffness EI.
    pub stiffness: [R; Profile::MOST],
    /// Shear stiffness S, if the beam has shear deformation.
    pub shear: Option<[R; Profile::MOST]>,
    /// Tension N: the axial force P, plus μ in contact.
    pub tension: [R; GROUND],
    /// Subgrade modulus κ in the beam equation: k in contact, 0 out of contact.
    pub spring: [R; GROUND],
    /// Load that does work on the deflection w: the load f on the beam. In contact, it also contains the load on the
    /// ground and k g₀, with the subgrade modulus k and the initial gap g₀.
    pub load: [R; GROUND + 1],
    /// Moment load that does work on the slope w′: μ g₀′ in contact, 0 out of contact, with the stiffness μ of the
    /// shear layer and the slope g₀′ of the initial gap.
    pub slope_load: [R; GROUND],
    /// Distributed moment load g, which does work on the rotation φ of the cross-sections.
    pub moment_load: [R; 2],
    /// Imposed curvature κ₀.
    pub curvature: [R; 2],
}

impl<R: Real> Polynomials<R> {
    /// Computes the coefficients as polynomials. Returns `None` for a uniform beam without shear deformation, out of
    /// contact or on uniform ground.
    pub fn of(cell: &Cell<R>, axial_force: R, touch: ZoneKind) -> Option<Self> {
        let ground_varies = touch == ZoneKind::Contact && cell.ground_varies();
        let needed = cell.beam_shear.is_some() || cell.beam_varies() || ground_varies;
        needed.then(|| Self::along(cell, axial_force, touch))
    }

    fn along(cell: &Cell<R>, axial_force: R, touch: ZoneKind) -> Self {
        let linear = |v: [R; 2]| [(v[0] + v[1]) * 0.5, (v[1] - v[0]) * 0.5];
        let mut all = Polynomials {
            stiffness: cell.stiffness_along(),
            shear: cell.beam_shear,
            tension: [R::ZERO; GROUND],
            spring: [R::ZERO; GROUND],
            load: [R::ZERO; GROUND + 1],
            slope_load: [R::ZERO; GROUND],
            moment_load: linear(cell.moment_load),
            curvature: linear(cell.curvature),
        };
        all.tension[0] = axial_force;
        all.load[..2].copy_from_slice(&linear(cell.load));
        if touch == ZoneKind::Contact {
            all.spring = cell.subgrade_along();
            let gap = linear(cell.gap);
            for (load, q) in all.load.iter_mut().zip(linear(cell.ground_load)) {
                *load += q;
            }
            for (i, mu) in cell.shear_layer_along().into_iter().enumerate() {
                all.tension[i] += mu;
                all.slope_load[i] = mu * cell.gap_slope;
            }
            for (i, k) in all.spring.iter().enumerate() {
                all.load[i] += *k * gap[0];
                all.load[i + 1] += *k * gap[1];
            }
        }
        all
    }

    fn is_still(&self) -> bool {
        let courses = [&self.stiffness[..], &self.tension, &self.spring, &self.load];
        let others = [&self.slope_load[..], &self.moment_load, &self.curvature];
        let shear = self.shear.iter().flatten();
        courses.into_iter().chain(others).flatten().chain(shear).all(|c| *c == c.value())
    }

    /// Returns whether the sum of the shear stiffness and the tension is positive at the ends and in the middle of the
    /// cell. Returns `true` if the beam has no shear deformation.
    fn resists_shear(&self) -> bool {
        self.shear.as_ref().is_none_or(|shear| {
            let both = |s| value(shear, s) + value(&self.tension, s);
            ENDS_AND_MIDDLE.into_iter().all(|s| both(s).value() > 0.0)
        })
    }

    /// Returns the bending stiffness, tension and subgrade modulus of a uniform cell without shear deformation. Its
    /// wave number bounds those at the ends and in the middle of the given cell.
    fn extremes(&self) -> [f64; 3] {
        let at = |c: &[R]| ENDS_AND_MIDDLE.map(|s| value(c, s).value());
        let largest = |c: [f64; 3]| c.into_iter().map(f64::abs).fold(0.0, f64::max);
        let [stiffness, tension, spring] =
            [&self.stiffness[..], &self.tension, &self.spring].map(at);
        let Some(shear) = &self.shear else {
            let least = stiffness.into_iter().fold(f64::INFINITY, f64::min);
            return [least, largest(tension), largest(spring)];
        };
        let shear = at(shear);
        let [mut axial, mut elastic] = [[0.0; 3]; 2];
        for i in 0..3 {
            let part = 1.0 + tension[i] / shear[i];
            axial[i] = (tension[i] / stiffness[i] + spring[i] / shear[i]) / part;
            elastic[i] = spring[i] / stiffness[i] / part;
        }
        [1.0, largest(axial), largest(elastic)]
    }
}

const ENDS_AND_MIDDLE: [f64; 3] = [-1.0, 0.0, 1.0];
