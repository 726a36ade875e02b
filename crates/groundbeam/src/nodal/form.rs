//! Energy of a beam element and its ground, as a function of the displacements of one end and the deformations of the element.
//!
//! A [sweep](super::sweep) eliminates the elements one after another. The left and the right end of an element of
//! length L have the displacements x₁ = (w₁, Lθ₁) and x₂ = (w₂, Lθ₂), with the deflections w and the rotations θ. A
//! rigid element has x₂ = T x₁ with T = \[\[1, 1\], \[0, 1\]\].
//!
//! The energy depends on y = T⁻¹x₂ and e = y − x₁. y contains the left displacements that x₂ would cause in a rigid
//! element, and e is the deformation. Hence w₁ = y₁ − e₁, Lθ₁ = y₂ − e₂ and w₂ − w₁ = y₂ + e₁.

use crate::element::element::Element;
use crate::ground::link::TwoPort;

/// Energy of an element in the [variables](self) y and e: ½(y₂, e)ᵗ M (y₂, e) − q·(y₁, y₂, e₁, e₂). The springs from
/// the two ends to the rigid base are stored separately.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Form {
    /// Length L.
    pub length: f64,
    /// Entries y₂y₂, y₂e₁ and y₂e₂ of the stiffness matrix for the [variables](self) (y₂, e₁, e₂): the rotation y₂
    /// and the deformations e₁ and e₂.
    pub m: [f64; 3],
    /// Entries e₁e₁, e₁e₂ and e₂e₂ of the stiffness matrix for the deformations e₁ and e₂.
    pub e: [f64; 3],
    /// Load vector q of the first element of a run of equal elements. Its last two entries are stiffness times gap for
    /// the springs from both ends to the rigid base.
    pub q: [f64; 6],
    /// Increment of the load vector q from one element of a run of equal elements to the next.
    pub dq: [f64; 6],
    /// Stiffness of the ground springs from the left and the right end of the element to the rigid base.
    pub shunt: [f64; 2],
    /// Stiffness of the ground spring between the left and the right end of the element.
    pub series: f64,
    /// Product of `series` and the increase of the gap from the left to the right end of the element.
    pub rise: f64,
}

impl Form {
    /// Returns the energy of a beam element of length L without ground, from its stiffness matrix for (Lθ, d₁, L d₂)
    /// and its load vector for (w, Lθ, d₁, L d₂). w, θ, d₁ and d₂ are the unknowns of [`Element`].
    pub fn beam(length: f64, stiffness: [f64; 6], load: [f64; 4]) -> Self {
        let [tt, t1, t2, d11, d12, d22] = stiffness;
        let [qw, qt, q1, q2] = load;
        Form {
            length,
            m: [tt, t1, t1 + t2 - tt],
            e: [d11, d11 + d12 - t1, d11 + 2.0 * d12 + d22 - 2.0 * (t1 + t2) + tt],
            q: [qw, qt, q1 - qw, q1 + q2 - qt, 0.0, 0.0],
            ..Form::default()
        }
    }

    /// Returns the energy of a beam element without ground. The [`Element`] must have no stiffness against rigid
    /// translation.
    pub fn of(element: &Element) -> Self {
        let Element { length, stiffness: k, load: [qw, qt, q1, q2], .. } = element;
        let per = 1.0 / length;
        let mean = |i: usize, j: usize| 0.5 * (k[i][j] + k[j][i]);
        let stiffness = [
            k[1][1] * per * per,
            mean(1, 2) * per,
            mean(1, 3) * per * per,
            k[2][2],
            mean(2, 3) * per,
            k[3][3] * per * per,
        ];
        Form::beam(*length, stiffness, [*qw, qt * per, *q1, q2 * per])
    }

    /// Adds ground that is out of contact between the two ends of the element. For each end, `gap` contains the sum
    /// of the initial gap and the free-field settlement.
    pub fn on(mut self, link: TwoPort, gap: [f64; 2]) -> Self {
        // The elongation of the series spring is the difference of the end deflections minus the rise of the gap.
        let (c, rise) = (link.series, gap[1] - gap[0]);
        self.m[0] += c;
        self.m[1] += c;
        self.e[0] += c;
        self.q[1] += c * rise;
        self.q[2] += c * rise;
        (self.series, self.rise) = (c, c * rise);
        self.shunt = [link.shunt_left, link.shunt_right];
        (self.q[4], self.q[5]) = (link.shunt_left * gap[0], link.shunt_right * gap[1]);
        self
    }

    /// Returns the energy of a run of `count` equal elements with linearly varying loads. `self` and `last` are the
    /// energies of the first and the last element.
    pub fn towards(mut self, last: &Form, count: usize) -> Self {
        if count > 1 {
            let steps = (count - 1) as f64;
            self.dq = std::array::from_fn(|i| (last.q[i] - self.q[i]) / steps);
        }
        self
    }

    /// Returns the energy of a run of equal elements without its first `elements` elements.
    pub fn after(mut self, elements: usize) -> Self {
        if elements > 0 && !self.is_even() {
            self.q = self.load(elements as f64);
        }
        self
    }

    /// Whether all elements of the row of equal elements have the same load vector.
    pub fn is_even(&self) -> bool {
        self.dq == [0.0; 6]
    }

    /// Load vector q of element i of the run.
    pub fn load(&self, i: f64) -> [f64; 6] {
        std::array::from_fn(|j| self.q[j] + i * self.dq[j])
    }
}
