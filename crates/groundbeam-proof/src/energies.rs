//! The energies of a claimed deflection with its ground: strain energy and potential energy, in doubles.
//!
//! These are figures to compare E with, no bounds: they carry the rounding error of the sums.

use crate::coefficient::Coefficient;
use crate::deflection::Deflection;
use crate::fields::Fields;
use crate::frame::{Frame, Span};
use crate::model::Acts;
use crate::polynomial::{HIGHEST, HIGHEST_COURSE, Polynomial};
use crate::scalar::Scalar;

/// The energies of an answer \[N·m\], in the units of the proof.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Energies {
    /// ½∫EI(φ′ − κ₀)² + ½∫EIκ₀² + ½∫S(w′ − φ)² + ½∫|P|w′² + ½b(u, u) and the energy of springs and elastic hinges.
    pub strain: f64,
    /// J = ½∫EI(φ′ − κ₀)² + ½∫S(w′ − φ)² + ½∫Pw′² + ½b(u, u) and the energy of springs and hinges, less the work of the loads.
    pub potential: f64,
}

impl Energies {
    pub fn of<S: Scalar>(fields: &Fields<S>) -> Self {
        let mut sums = Sums::default();
        for i in 0..fields.frame.spans.len() {
            sums.beam(fields.frame, i);
            sums.ground(fields, i);
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

/// Twice the strain energy without axial force, ∫EIκ₀², ∫Pw′², and the work of the loads.
#[derive(Default)]
struct Sums {
    strain: f64,
    curled: f64,
    axial: f64,
    work: f64,
}

impl Sums {
    fn beam<S: Scalar>(&mut self, frame: &Frame<S>, i: usize) {
        let span = &frame.spans[i];
        let half = span.half.middle();
        let slope = Field::of(&span.deflection).derivative(half);
        let rotation = span.rotation.as_deref().map_or(slope, Field::of);
        let curvature = Field::of(&span.curvature);
        let bent = rotation.derivative(half).less(&curvature);
        self.strain += half * weighted(&span.bending, &bent, &bent);
        self.curled += half * weighted(&span.bending, &curvature, &curvature);
        if let Some(stiffness) = &span.stiffness {
            let sheared = slope.less(&rotation);
            self.strain += half * weighted(stiffness, &sheared, &sheared);
        }
        if let Some(force) = frame.axial_force() {
            self.axial += half * force.middle() * slope.times(&slope);
        }
        self.work += half * Field::of(&span.force).times(&Field::of(&span.deflection));
        self.work += half * Field::of(&span.moment).times(&rotation);
    }

    /// ∫(ku² + μu′²) and ∫qu. On open ground of a layer the former is the flux times u at both ends and ∫qu.
    fn ground<S: Scalar>(&mut self, fields: &Fields<S>, i: usize) {
        let span = &fields.frame.spans[i];
        let half = span.half.middle();
        let load = span.ground_load.as_deref().map(Field::of);
        if span.touches {
            let u = Field::of(&span.deflection).less(&Field::of(&span.gap));
            let slope = u.derivative(half);
            let springs = weighted(&span.spring, &u, &u);
            self.strain += half * (springs + weighted(&span.shear, &slope, &slope));
            self.work += load.map_or(0.0, |load| half * load.times(&u));
        } else if let Some(ends) = fields.surface.open[i] {
            let [left, right] = ends.map(S::middle);
            let flux = fields.surface.flux[i].map(S::middle);
            let along = fields.surface.along[i].as_deref().map(Field::of);
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

/// ∫qu on an open piece, u = q/k + v with v″ = b²v: ∫q²/k + (μ/k)\[qv′ − q′v\].
fn pushed<S: Scalar>(span: &Span<S>, load: &Field, ends: [f64; 2], flux: [f64; 2]) -> f64 {
    let half = span.half.middle();
    let [k, mu] = [&span.spring, &span.shear].map(Coefficient::middle);
    let slope = load.derivative(half).value(0.0);
    let at = |side: usize| {
        let q = load.value([-1.0, 1.0][side]);
        q * (flux[side] - mu * slope / k) - mu * slope * (ends[side] - q / k)
    };
    half * load.times(load) / k + (at(1) - at(0)) / k
}

/// ū at a node of a layer.
fn settlement<S: Scalar>(fields: &Fields<S>, node: usize) -> f64 {
    if fields.surface.touches[node] {
        return fields.surface.settlement[node].middle();
    }
    let open = |i: usize, side: usize| fields.surface.open.get(i)?.map(|ends| ends[side].middle());
    let left = node.checked_sub(1).and_then(|i| open(i, 1));
    left.or_else(|| open(node, 0)).unwrap_or(0.0)
}

/// \[φ\] at a hinge.
fn turn<S: Scalar>(deflection: &Deflection<S>, node: usize) -> f64 {
    deflection.rotations[node][0].middle() - deflection.rotations[node - 1][1].middle()
}

/// ∫cab over −1 ≤ t ≤ 1.
fn weighted<S: Scalar>(c: &Coefficient<S>, a: &Field, b: &Field) -> f64 {
    match c.along() {
        None => c.middle() * a.times(b),
        Some(along) => a.product(&Field::of(along)).times(b),
    }
}

/// A field in doubles on −1 ≤ t ≤ 1: the coefficients of even and of odd powers of t apart.
#[derive(Clone, Copy)]
struct Field {
    len: usize,
    parts: [[f64; HALF]; 2],
}

impl Field {
    const ZERO: Field = Field { len: 0, parts: [[0.0; HALF]; 2] };

    fn of<S: Scalar>(p: &Polynomial<S>) -> Self {
        let mut field = Self::ZERO;
        for (j, c) in p.coefficients().iter().enumerate() {
            field.parts[j % 2][j / 2] = c.middle();
        }
        field.len = p.coefficients().len();
        field
    }

    /// The coefficients of the powers of one parity.
    fn part(&self, parity: usize) -> &[f64] {
        &self.parts[parity][..(self.len + 1 - parity) / 2]
    }

    fn coefficient(&self, j: usize) -> f64 {
        self.parts[j % 2][j / 2]
    }

    /// The derivative by x.
    fn derivative(&self, half: f64) -> Self {
        let mut derived = Field { len: self.len.saturating_sub(1), ..Self::ZERO };
        for j in 0..derived.len {
            derived.parts[j % 2][j / 2] = self.coefficient(j + 1) * (j + 1) as f64 / half;
        }
        derived
    }

    fn less(mut self, other: &Field) -> Self {
        self.len = self.len.max(other.len);
        for parity in [0, 1] {
            for (c, less) in self.parts[parity].iter_mut().zip(other.part(parity)) {
                *c -= less;
            }
        }
        self
    }

    fn product(&self, other: &Field) -> Self {
        let mut product = Field { len: (self.len + other.len).saturating_sub(1), ..Self::ZERO };
        for i in 0..self.len {
            for j in 0..other.len {
                product.parts[(i + j) % 2][(i + j) / 2] +=
                    self.coefficient(i) * other.coefficient(j);
            }
        }
        product
    }

    fn value(&self, t: f64) -> f64 {
        (0..self.len).rev().fold(0.0, |sum, j| sum * t + self.coefficient(j))
    }

    /// ∫ of the product over −1 ≤ t ≤ 1.
    fn times(&self, other: &Field) -> f64 {
        let mut sum = 0.0;
        for parity in [0, 1] {
            let others = other.part(parity);
            for (i, a) in self.part(parity).iter().enumerate() {
                let powers = &POWERS[i + parity..];
                let inner: f64 = others.iter().zip(powers).map(|(b, power)| b * power).sum();
                sum += a * inner;
            }
        }
        sum
    }
}

/// Room for the even or the odd powers of a field times a course.
const HALF: usize = (HIGHEST + HIGHEST_COURSE) / 2 + 1;

/// ∫t²ʲ over −1 ≤ t ≤ 1.
const POWERS: [f64; 2 * HALF] = {
    let mut powers = [0.0; 2 * HALF];
    let mut j = 0;
    while j < powers.len() {
        powers[j] = 2.0 / (2 * j + 1) as f64;
        j += 1;
    }
    powers
};

#[cfg(test)]
mod tests {
    use super::Field;
    use crate::polynomial::Polynomial;
    use crate::random::numbers;

    /// ∫fg over −1 ≤ t ≤ 1 by the midpoint rule.
    fn integral(f: &Field, g: &Field) -> f64 {
        let t = |i: usize| -1.0 + (i as f64 + 0.5) / 10_000.0;
        (0..20_000).map(|i| f.value(t(i)) * g.value(t(i)) / 10_000.0).sum()
    }

    #[test]
    fn products_are_integrated_and_derived() {
        let mut random = numbers();
        for degrees in [[0, 0], [3, 4], [7, 2], [12, 12]] {
            let [f, g] = degrees.map(|degree| {
                Field::of(&Polynomial::from_coefficients((0..=degree).map(|_| random())))
            });
            assert!((f.times(&g) - integral(&f, &g)).abs() < 1e-6, "{degrees:?}");
            let one = Field::of(&Polynomial::from_coefficients([1.0]));
            assert!((f.product(&g).times(&one) - f.times(&g)).abs() < 1e-14);
            let rise = f.value(1.0) - f.value(-1.0);
            assert!((0.5 * f.derivative(0.5).times(&one) - rise).abs() < 1e-12);
            assert!(f.less(&f).times(&f).abs() < 1e-15);
        }
    }
}
