//! Stretches of the beam for the elimination from node to node: rows of equal elements in contact, and spans out of contact.

use super::form::Form;
use super::quadratic::Quadratic;
use super::stand::Stand;
use crate::element::element::Element;

/// Progress of the elimination from one end of the beam.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reached {
    pub stretch: usize,
    /// Number of elements in the current stretch that the elimination has already processed.
    pub within: usize,
    /// Number of elements in all stretches that the elimination has already processed.
    pub elements: usize,
}

/// Columns of the matrix A, then the vector c, of the back-substitution e = A y + c in an element.
/// [`form`](super::form) defines y and e.
pub(super) type Gain = [f64; 6];

/// A row of bonded elements of equal stiffness, or a span out of contact. The elimination passes through it from its
/// first node, either from left to right or from right to left.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub form: Form,
    pub count: usize,
    /// First node of the stretch in the direction of the elimination.
    pub node: usize,
    /// Loads, supports, hinge and springs at the first node of the stretch.
    pub stand: Stand,
    /// Energy of the first element in the variables (y₁, y₂, e₁, e₂) of [`form`](super::form). `None` for a row without
    /// a support at its first node.
    pub(super) first: Option<Quadratic<4>>,
    /// Coefficients a, b, c of the rotation a w + b θ + c just before a hinge at the first node. w is the deflection of
    /// the node, and θ the rotation just after the hinge.
    pub(super) turned: Option<[f64; 3]>,
    is_span: bool,
}

impl Stretch {
    /// A row of equal elements.
    pub fn row(form: Form, count: usize, node: usize, stand: Stand) -> Self {
        let first = stand.holds().then(|| Quadratic::of(&form));
        Stretch { form, count, node, stand, first, turned: None, is_span: false }
    }

    /// Creates a stretch from one element that is out of contact. `form` describes the ground under this
    /// element.
    pub fn span(element: &Element, form: Form, node: usize, stand: Stand) -> Self {
        let length = element.length;
        let ground = Form { length, ..form };
        let mut first = Quadratic::of(&ground);
        let row = |i: usize| LEFT_AND_DEFORMATION[i].map(|by| by * [1.0, 1.0 / length][i % 2]);
        let rows = [0, 1, 2, 3].map(row);
        first.add(&rows, &element.stiffness, &element.load);
        let first = Some(first);
        Stretch { form: ground, count: 1, node, stand, first, turned: None, is_span: true }
    }

    /// Whether the stretch is one element that is out of contact.
    pub fn is_span(&self) -> bool {
        self.is_span
    }
}

/// Converts (y₁, y₂, e₁, e₂) of [`form`](super::form) to (w, Lθ, d₁, L d₂): displacements of the left end and
/// deformations of an element of length L.
const LEFT_AND_DEFORMATION: [[f64; 4]; 4] =
    [[1.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]];

impl Quadratic<4> {
    /// Returns the energy of the first element of `form` in the variables (y₁, y₂, e₁, e₂). It excludes the ground
    /// springs under its ends (`Form::shunt`).
    fn of(form: &Form) -> Self {
        let [yy, y1, y2] = form.m;
        let [e11, e12, e22] = form.e;
        let [a, b, c, d, ..] = form.q;
        let h = [[0.0; 4], [0.0, yy, y1, y2], [0.0, y1, e11, e12], [0.0, y2, e12, e22]];
        Quadratic { h, g: [a, b, c, d] }
    }
}

/// Consecutive elements of one stretch for one call of the elimination. `first` is the index of the first one in the
/// stretch.
pub(super) struct Elements<'a> {
    pub form: &'a Form,
    pub first: usize,
    pub gains: &'a mut [Gain],
}

/// All stretches on one side of the node where the eliminations from both ends of the beam meet.
#[derive(Debug, Clone, Default)]
pub(crate) struct Side {
    pub stretches: Vec<Stretch>,
    pub(super) gains: Vec<Gain>,
    /// Deflection and rotation of the first node, and deformations (d₁, d₂) of the first element, for each stretch.
    pub shapes: Vec<[f64; 4]>,
}

impl Side {
    pub fn clear(&mut self) {
        self.stretches.clear();
        self.shapes.clear();
    }

    /// The next `steps` elements that the elimination processes.
    pub(super) fn next(&mut self, reached: Reached, steps: usize) -> Elements<'_> {
        Elements {
            form: &self.stretches[reached.stretch].form,
            first: reached.within,
            gains: &mut self.gains[reached.elements..][..steps],
        }
    }

    pub(super) fn elements(&self) -> usize {
        self.stretches.iter().map(|stretch| stretch.count).sum()
    }

    /// Calls `each` for every element, from the meeting node (`w`, `theta`) to the end of the beam.
    ///
    /// The values are the deflection and the rotation of the element's outer node, and its deformations. On the right
    /// side, rotations have the opposite sign.
    pub fn each_element(
        &self,
        mut w: f64,
        mut theta: f64,
        mut each: impl FnMut(&Stretch, [f64; 4]),
    ) {
        let mut gains = self.gains.iter().rev();
        for stretch in self.stretches.iter().rev() {
            let length = stretch.form.length;
            for gain in gains.by_ref().take(stretch.count) {
                let [k11, k21, k12, k22, c1, c2] = gain;
                let turn = length * theta;
                let y = w - turn;
                let e = [k11 * y + k12 * turn + c1, k21 * y + k22 * turn + c2];
                (w, theta) = (y - e[0], (turn - e[1]) / length);
                each(stretch, [w, theta, e[0] + e[1], e[1] / length]);
            }
            if stretch.stand.pinned {
                w = stretch.stand.settlement;
            }
            if let Some([by_w, by_theta, rest]) = stretch.turned {
                theta = by_w * w + by_theta * theta + rest;
            }
        }
    }
}
