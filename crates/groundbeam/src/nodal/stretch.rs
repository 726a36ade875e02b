//! Stretches of the beam between nodes that touch: rows of equal elements, and single elements off the ground.

use super::form::Form;
use super::quadratic::Quadratic;
use super::stand::Stand;
use crate::element::element::Element;

/// How far a sweep has come.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reached {
    pub stretch: usize,
    /// Elements crossed of this stretch, and in all.
    pub within: usize,
    pub elements: usize,
}

/// e = gain·y + constant: gain by columns, then the constant.
pub(super) type Gain = [f64; 6];

/// Elements of one form in a row, in the direction of their sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub form: Form,
    pub count: usize,
    /// The first node.
    pub node: usize,
    /// What stands there.
    pub stand: Stand,
    /// The energy of the first element, in (y₁, y₂, e₁, e₂), where its form does not tell all or its first node is held.
    pub(super) first: Option<Quadratic<4>>,
    /// The rotation behind a hinge at the first node, from w and the rotation ahead of it.
    pub(super) turned: Option<[f64; 3]>,
    is_span: bool,
}

impl Stretch {
    /// A row of equal elements.
    pub fn row(form: Form, count: usize, node: usize, stand: Stand) -> Self {
        let first = stand.holds().then(|| Quadratic::of(&form));
        Stretch { form, count, node, stand, first, turned: None, is_span: false }
    }

    /// One element off the ground; `form` is the ground beside it.
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

    /// Whether it is one element off the ground.
    pub fn is_span(&self) -> bool {
        self.is_span
    }
}

/// (w, Lθ, d₁, L d₂) of an element from (y₁, y₂, e₁, e₂).
const LEFT_AND_DEFORMATION: [[f64; 4]; 4] =
    [[1.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]];

impl Quadratic<4> {
    /// The energy of the first element of a form, but for the springs under its ends.
    fn of(form: &Form) -> Self {
        let [yy, y1, y2] = form.m;
        let [e11, e12, e22] = form.e;
        let [a, b, c, d, ..] = form.q;
        let h = [[0.0; 4], [0.0, yy, y1, y2], [0.0, y1, e11, e12], [0.0, y2, e12, e22]];
        Quadratic { h, g: [a, b, c, d] }
    }
}

/// Elements of one form that are crossed in one go: the number of the first, and where their gains go.
pub(super) struct Elements<'a> {
    pub form: &'a Form,
    pub first: usize,
    pub gains: &'a mut [Gain],
}

/// All that is behind the meeting node on one side.
#[derive(Debug, Clone, Default)]
pub(crate) struct Side {
    pub stretches: Vec<Stretch>,
    pub(super) gains: Vec<Gain>,
    /// (w, θ) at the first node of each stretch and its deformation (d₁, d₂): of the last of its elements.
    pub shapes: Vec<[f64; 4]>,
}

impl Side {
    pub fn clear(&mut self) {
        self.stretches.clear();
        self.shapes.clear();
    }

    /// The next elements to cross.
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

    /// The motion (w, θ, d₁, d₂) of each element in the direction of the sweep, from the meeting node on, where w and the
    /// rotation are given.
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
