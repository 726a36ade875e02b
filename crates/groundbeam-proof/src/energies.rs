//! Computes the strain energy and the potential energy of beam and ground in a claimed solution, in double precision.
//!
//! The energies have rounding errors, so they are not bounds. The bound of the error energy is compared with them.

use crate::coefficient::Coefficient;
use crate::deflection::Deflection;
use crate::fields::Fields;
use crate::frame::{Frame, Span};
use crate::model::Acts;
use crate::polynomial::{CAPACITY, Polynomial};
use crate::scalar::Scalar;

/// Energies of a claimed solution, in the units of force and length of the proof.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Energies {
    /// Strain energy of beam, ground, springs and elastic hinges, plus ½∫EIκ₀² for the imposed curvature κ₀ and
    /// ½∫|P|w′² for the axial force P. The error energy is compared with it.
    pub strain: f64,
    /// Potential energy J: the strain energy of beam, ground, springs and elastic hinges, plus ½∫Pw′² for the axial
    /// force P (positive in tension), minus the work of the loads.
    pub potential: f64,
}

impl Energies {
    pub fn of<S: Scalar>(fields: &Fields<S>) -> Self {
        let mut sums = Sums::default();
        for i in 0..fields.frame.spans.len() {
            let span = &fields.frame.spans[i];
            let deflection = Series::of(&span.deflection);
            let slope = deflection.derivative(span.half.middle());
            sums.beam(fields.frame, span, &deflection, &slope);
            sums.ground(fields, i, deflection, slope);
        }
        for i in 0..fields.frame.nodes.len() {
            sums.node(fields, i);
        }
        for side in [0, 1] {
            sums.beside(fields, side);
        }
        let Sums { strain, curled, axial, work } = sums;
        let inner = 0.5 * strain;
        Energies {
            strain: inner + 0.5 * (curled + axial.abs()),
            potential: inner + 0.5 * axial - work,
        }
    }
}

/// Sums over the pieces and nodes, from which the energies are computed.
#[derive(Default)]
struct Sums {
    /// Twice the energy of bending, shear deformation, ground, springs and elastic hinges.
    strain: f64,
    /// ∫EIκ₀² dx, with the imposed curvature κ₀ of the beam.
    curled: f64,
    /// ∫Pw′² dx, with the axial force P and the deflection w of the beam.
    axial: f64,
    /// Work of the loads on beam and ground.
    work: f64,
}

impl Sums {
    fn beam<S: Scalar>(
        &mut self,
        frame: &Frame<S>,
        span: &Span<S>,
        deflection: &Series,
        slope: &Series,
    ) {
        let half = span.half.middle();
        let own = span.rotation.as_deref().map(Series::of);
        let rotation = own.as_ref().unwrap_or(slope);
        let curvature = Series::of(&span.curvature);
        let bent = rotation.derivative(half).less(&curvature);
        self.strain += half * weighted(&span.bending, &bent, &bent);
        self.curled += half * weighted(&span.bending, &curvature, &curvature);
        if let Some(stiffness) = &span.stiffness {
            let sheared = slope.less(rotation);
            self.strain += half * weighted(stiffness, &sheared, &sheared);
        }
        if let Some(force) = frame.axial_force() {
            self.axial += half * force.middle() * slope.times(slope);
        }
        self.work += half * Series::of(&span.force).times(deflection);
        self.work += half * Series::of(&span.moment).times(rotation);
    }

    /// Adds ∫(ku² + μu′²) on one piece to `strain`, and the work ∫qu of the load q on the ground to `work`. On a shear
    /// layer out of contact, the first integral is ∫qu plus the increase of μu′u, by parts.
    fn ground<S: Scalar>(
        &mut self,
        fields: &Fields<S>,
        i: usize,
        deflection: Series,
        slope: Series,
    ) {
        let span = &fields.frame.spans[i];
        let half = span.half.middle();
        let load = span.ground_load.as_ref().map(Series::of);
        if span.touches {
            let gap = Series::of(&span.gap);
            let (u, slope) = (deflection.less(&gap), slope.less(&gap.derivative(half)));
            let springs = weighted(&span.spring, &u, &u);
            self.strain += half * (springs + weighted(&span.shear, &slope, &slope));
            self.work += load.map_or(0.0, |load| half * load.times(&u));
        } else if let Some(ends) = fields.surface.pieces[i].open {
            let [left, right] = ends.map(S::middle);
            let flux = fields.surface.pieces[i].flux.map(S::middle);
            let along = fields.surface.pieces[i].along.as_deref().map(Series::of);
            let pushed = load.map_or(0.0, |load| match along {
                Some(u) => half * load.times(&u),
                None => pushed(span, &load, [left, right], flux),
            });
            self.strain += flux[1] * right - flux[0] * left + pushed;
            self.work += pushed;
        } else if let Some(load) = load {
            let pushed = half * load.times(&load) / span.spring.middle();
            self.strain += pushed;
            self.work += pushed;
        }
    }

    fn node<S: Scalar>(&mut self, fields: &Fields<S>, i: usize) {
        let (node, deflection) = (&fields.frame.nodes[i], &fields.deflection);
        let [w, slope] = deflection.at_support(i).map(S::middle);
        self.work += node.force.middle() * w + node.moment.middle() * slope;
        if node.ground_force != S::zero() {
            self.work += node.ground_force.middle() * settlement(fields, i);
        }
        if let Some([spring, settled]) = node.spring.map(|both| both.map(S::middle)) {
            let force = match node.acts {
                Acts::Both => spring * w - settled,
                _ => fields.residual.pushing[i].middle(),
            };
            self.strain += force * force / spring;
        }
        self.strain += node.turning.map_or(0.0, |turning| turning.middle() * slope * slope);
        if let Some(spring) = node.hinge {
            let turn = turn(deflection, i);
            self.strain += spring.middle() * turn * turn;
        }
    }

    fn beside<S: Scalar>(&mut self, fields: &Fields<S>, side: usize) {
        let frame = fields.frame;
        let (stiffness, pushed) = (frame.outside[side].middle(), frame.pushed[side].middle());
        if stiffness == 0.0 {
            return;
        }
        let u = settlement(fields, [0, frame.spans.len()][side]);
        self.strain += stiffness * u * u;
        self.work += pushed * u;
    }
}

/// Returns ∫qu = ∫q²/k + (μ/k)\[qv′ − q′v\] on an open piece with constant k and μ. The settlement is u = q/k + v
/// with μv″ = kv.
fn pushed<S: Scalar>(span: &Span<S>, load: &Series<2>, ends: [f64; 2], flux: [f64; 2]) -> f64 {
    let half = span.half.middle();
    let [k, mu] = [&span.spring, &span.shear].map(Coefficient::middle);
    let [middle, rise] = [load.a[0], load.a[1]];
    let slope = rise / half;
    let at = |side: usize| {
        let q = middle + [-rise, rise][side];
        q * (flux[side] - mu * slope / k) - mu * slope * (ends[side] - q / k)
    };
    half * load.times(load) / k + (at(1) - at(0)) / k
}

/// Returns the ground displacement ū at a node of a shear layer.
fn settlement<S: Scalar>(fields: &Fields<S>, node: usize) -> f64 {
    if fields.surface.touches[node] {
        return fields.surface.nodes[node].settlement.middle();
    }
    let open =
        |i: usize, side: usize| fields.surface.pieces.get(i)?.open.map(|ends| ends[side].middle());
    let left = node.checked_sub(1).and_then(|i| open(i, 1));
    left.or_else(|| open(node, 0)).unwrap_or(0.0)
}

/// Returns the jump of the rotation φ at a hinge, from left to right.
fn turn<S: Scalar>(deflection: &Deflection<S>, node: usize) -> f64 {
    let [left, right] = [(node - 1, 1), (node, 0)]
        .map(|(i, side): (usize, usize)| deflection.claimed[i].rotation[side]);
    (right - left).middle()
}

/// Returns ∫cab dt over −1 ≤ t ≤ 1 for a coefficient c and two fields a and b.
fn weighted<S: Scalar, const N: usize>(c: &Coefficient<S>, a: &Series<N>, b: &Series<N>) -> f64 {
    match c.along() {
        None => c.middle() * a.times(b),
        Some(along) => a.product(along).times(b),
    }
}

/// A field in double precision, as a series Σ aₖPₖ(t) of the Legendre polynomials, which are orthogonal on −1 ≤ t ≤ 1.
#[derive(Clone, Copy)]
struct Series<const N: usize = CAPACITY> {
    len: usize,
    /// Coefficients of the series; zero from the index `len` on.
    a: [f64; N],
}

impl<const N: usize> Series<N> {
    const ZERO: Self = Series { len: 0, a: [0.0; N] };

    fn of<S: Scalar>(p: &Polynomial<S, N>) -> Self {
        let mut series = Self::ZERO;
        for (c, power) in p.coefficients().iter().zip(&POWERS) {
            let c = c.middle();
            series.len += 1;
            // The loop adds the Legendre coefficients of c·tʲ to the series in groups of four. The last group may
            // contain indices above j, where these coefficients are zero.
            let fours = series.a.chunks_mut(4).zip(power.chunks(4));
            for (a, part) in fours.take(series.len.div_ceil(4)) {
                a.iter_mut().zip(part).for_each(|(a, part)| *a += c * part);
            }
        }
        series
    }

    /// Returns the derivative with respect to x of this series of Legendre polynomials Pₖ(t), by P′ₖ₊₁ = (2k + 1)Pₖ +
    /// P′ₖ₋₁. `half` is dx/dt.
    fn derivative(&self, half: f64) -> Self {
        let mut derived = Series { len: self.len.saturating_sub(1), ..Self::ZERO };
        let mut above = [0.0; 2];
        for k in (0..derived.len).rev() {
            above[k % 2] += self.a[k + 1];
            derived.a[k] = (2 * k + 1) as f64 / half * above[k % 2];
        }
        derived
    }

    fn less<const M: usize>(mut self, other: &Series<M>) -> Self {
        // This constant compiles only if N ≥ M.
        let _ = const { N - M };
        self.len = self.len.max(other.len);
        for (a, less) in self.a.iter_mut().zip(&other.a[..other.len]) {
            *a -= less;
        }
        self
    }

    /// Returns the integral of the product of two series over −1 ≤ t ≤ 1.
    fn times<const M: usize>(&self, other: &Series<M>) -> f64 {
        let both = self.a[..self.len].iter().zip(&other.a[..other.len]);
        both.zip(&SQUARES).map(|((a, b), square)| a * b * square).sum()
    }

    fn product<S: Scalar>(&self, other: &Polynomial<S>) -> Series {
        let mut product = Series::ZERO;
        for c in other.coefficients().iter().rev() {
            product = product.raised();
            for (a, more) in product.a.iter_mut().zip(&self.a) {
                *a += c.middle() * more;
            }
            product.len = product.len.max(self.len);
        }
        product
    }
}

impl Series {
    /// Returns the Legendre series multiplied by t, from the recurrence tPₖ = ((k + 1)Pₖ₊₁ + kPₖ₋₁)/(2k + 1) of
    /// the Legendre polynomials Pₖ.
    fn raised(&self) -> Self {
        let mut raised = Series { len: self.len + 1, ..Self::ZERO };
        for k in 0..self.len {
            let part = self.a[k] / (2 * k + 1) as f64;
            raised.a[k + 1] += (k + 1) as f64 * part;
            if k > 0 {
                raised.a[k - 1] += k as f64 * part;
            }
        }
        raised
    }
}

/// Integrals ∫Pₖ² = 2/(2k + 1) of the squared Legendre polynomials over −1 ≤ t ≤ 1.
const SQUARES: [f64; CAPACITY] = {
    let mut squares = [0.0; CAPACITY];
    let mut k = 0;
    while k < CAPACITY {
        squares[k] = 2.0 / (2 * k + 1) as f64;
        k += 1;
    }
    squares
};

/// Legendre coefficients of the powers tʲ. All are nonnegative, and the coefficients of each power have the sum 1.
static POWERS: [[f64; CAPACITY]; CAPACITY] = {
    let mut powers = [[0.0; CAPACITY]; CAPACITY];
    powers[0][0] = 1.0;
    let mut j = 1;
    while j < CAPACITY {
        let mut k = 0;
        while k < j {
            let part = powers[j - 1][k] / (2 * k + 1) as f64;
            powers[j][k + 1] += (k + 1) as f64 * part;
            if k > 0 {
                powers[j][k - 1] += k as f64 * part;
            }
            k += 1;
        }
        j += 1;
    }
    powers
};

mod tests;
