//! Energy of an element and its ground, in the variables (y, e) of a sweep.
//!
//! The motion of the left end is x = (w, Lθ), L being the length of the element. That of the right end is x' = T x + d,
//! T = \[\[1, 1\], \[0, 1\]\], where d is the deformation. y = T⁻¹x' = (w' − Lθ', Lθ') is the motion that the left end
//! would have if the element were rigid, and e = y − x is the effect of the deformation. Hence w = y₁ − e₁, Lθ = y₂ −
//! e₂ and w' − w = y₂ + e₁.

use crate::element::element::Element;
use crate::ground::link::TwoPort;

/// Energy ½(y₂, e)ᵗ M (y₂, e) − q·(y₁, y₂, e₁, e₂) of an element, and the shunt springs of the ground under its ends.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Form {
    /// Length L.
    pub length: f64,
    /// Entries of M: `m` has y₂y₂, y₂e₁ and y₂e₂; `e` has e₁e₁, e₁e₂ and e₂e₂.
    pub m: [f64; 3],
    pub e: [f64; 3],
    /// q of the first element of a run, and its increment from one element to the next. The fifth and the sixth entry
    /// are stiffness times gap of the shunt springs under the left and the right end.
    pub q: [f64; 6],
    pub dq: [f64; 6],
    /// Stiffness of the shunt springs under the left and the right end.
    pub shunt: [f64; 2],
    /// Stiffness of the series spring between the ends, and its product with the rise of the gap from left to right.
    pub series: f64,
    pub rise: f64,
}

impl Form {
    /// A beam without ground, from its length, its K for (Lθ, d₁, L d₂) and its q for (w, Lθ, d₁, L d₂).
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

    /// As [`Form::beam`], from an element that has no stiffness against rigid translation.
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

    /// Adds ground that is out of contact between the two ends, at which g₀ + u₀ is `gap`.
    pub fn on(mut self, link: TwoPort, gap: [f64; 2]) -> Self {
        // ½ c (w' − w − rise)².
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

    /// The form of a run of `count` elements, of which `self` is the first and `last` the last.
    pub fn towards(mut self, last: &Form, count: usize) -> Self {
        if count > 1 {
            let steps = (count - 1) as f64;
            self.dq = std::array::from_fn(|i| (last.q[i] - self.q[i]) / steps);
        }
        self
    }

    /// The form of the run that begins `elements` elements later.
    pub fn after(mut self, elements: usize) -> Self {
        if elements > 0 && !self.is_even() {
            self.q = self.load(elements as f64);
        }
        self
    }

    /// Whether all elements of the run have the same load.
    pub fn is_even(&self) -> bool {
        self.dq == [0.0; 6]
    }

    /// q of element i.
    pub fn load(&self, i: f64) -> [f64; 6] {
        std::array::from_fn(|j| self.q[j] + i * self.dq[j])
    }
}
