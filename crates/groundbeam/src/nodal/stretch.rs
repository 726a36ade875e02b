//! Stretches of the beam that a sweep crosses: rows of bonded elements, and spans off the ground condensed to one
//! element.

use super::form::Form;
use super::quadratic::Quadratic;
use super::stand::Stand;
use crate::element::element::Element;

/// Progress of a sweep.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reached {
    pub stretch: usize,
    /// Number of elements crossed in this stretch, and in all.
    pub within: usize,
    pub elements: usize,
}

/// Coefficients of e = gain·y + constant: the columns of the gain, then the constant.
pub(super) type Gain = [f64; 6];

/// A row of elements of one form, in the direction of the sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub form: Form,
    pub count: usize,
    /// First node in the direction of the sweep.
    pub node: usize,
    /// Loads, supports, hinge and springs at the first node.
    pub stand: Stand,
    /// Energy of the first element in (y₁, y₂, e₁, e₂), for a span and for a row whose first node has a support.
    pub(super) first: Option<Quadratic<4>>,
    /// Rotation behind a hinge at the first node: its coefficients of w and of the rotation ahead, and its constant.
    pub(super) turned: Option<[f64; 3]>,
    is_span: bool,
}

impl Stretch {
    /// A row of equal elements.
    pub fn row(form: Form, count: usize, node: usize, stand: Stand) -> Self {
        let first = stand.holds().then(|| Quadratic::of(&form));
        Stretch { form, count, node, stand, first, turned: None, is_span: false }
    }

    /// One element off the ground; `form` is the ground under it.
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

    /// Whether the stretch is one element off the ground.
    pub fn is_span(&self) -> bool {
        self.is_span
    }
}

/// Matrix that gives (w, Lθ, d₁, L d₂) of an element from (y₁, y₂, e₁, e₂).
const LEFT_AND_DEFORMATION: [[f64; 4]; 4] =
    [[1.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]];

impl Quadratic<4> {
    /// Energy of the first element of a form, without the shunt springs under its ends.
    fn of(form: &Form) -> Self {
        let [yy, y1, y2] = form.m;
        let [e11, e12, e22] = form.e;
        let [a, b, c, d, ..] = form.q;
        let h = [[0.0; 4], [0.0, yy, y1, y2], [0.0, y1, e11, e12], [0.0, y2, e12, e22]];
        Quadratic { h, g: [a, b, c, d] }
    }
}

/// Elements of one form that are crossed together: index of the first, and memory for their gains.
pub(super) struct Elements<'a> {
    pub form: &'a Form,
    pub first: usize,
    pub gains: &'a mut [Gain],
}

/// All stretches on one side of the meeting node.
#[derive(Debug, Clone, Default)]
pub(crate) struct Side {
    pub stretches: Vec<Stretch>,
    pub(super) gains: Vec<Gain>,
    /// For each stretch, (w, θ) at its first node and the deformation (d₁, d₂) of its first element.
    pub shapes: Vec<[f64; 4]>,
}

impl Side {
    pub fn clear(&mut self) {
        self.stretches.clear();
        self.shapes.clear();
    }

    /// The next `steps` elements to cross.
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

    /// Calls `each` with the motion (w, θ, d₁, d₂) of every element, in the coordinates of the sweep. Begins at the
    /// meeting node, where w and the rotation are given.
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
