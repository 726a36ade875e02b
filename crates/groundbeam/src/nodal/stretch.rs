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

/// Coefficients with which back-substitution computes e = gain·y + constant in an element: two columns of the
/// matrix `gain`, then the constant. The variables y and e are defined in [`form`](super::form).
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
    /// Energy of the first element as a function of its displacements (y₁, y₂) and deformations (e₁, e₂), which
    /// [`form`](super::form) defines. `None` if the stretch is a row of equal elements whose first node has no
    /// support.
    pub(super) first: Option<Quadratic<4>>,
    /// Array [a, b, c] if the first node has a hinge with the deflection w. The rotation just before the hinge, in
    /// the direction of the elimination, is a w + b θ + c with the rotation θ just after the hinge.
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

/// Matrix that transforms the variables (y₁, y₂, e₁, e₂) of [`form`](super::form) to (w, Lθ, d₁, L d₂). Here w and θ
/// are the deflection and the rotation of the left end of an element, d₁ and d₂ are the deformations of the element,
/// and L is its length.
const LEFT_AND_DEFORMATION: [[f64; 4]; 4] =
    [[1.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]];

impl Quadratic<4> {
    /// Returns the energy of one element, the first of the equal elements that `form` describes. It is a function of
    /// the displacements (y₁, y₂) and the deformations (e₁, e₂), which [`form`](super::form) defines. The two ground
    /// springs under the ends of this element (`Form::shunt`) are not included.
    fn of(form: &Form) -> Self {
        let [yy, y1, y2] = form.m;
        let [e11, e12, e22] = form.e;
        let [a, b, c, d, ..] = form.q;
        let h = [[0.0; 4], [0.0, yy, y1, y2], [0.0, y1, e11, e12], [0.0, y2, e12, e22]];
        Quadratic { h, g: [a, b, c, d] }
    }
}

/// Consecutive elements of equal stiffness that the elimination processes in one call. `first` is the index of the
/// first element in its stretch; `gains` is memory for the back-substitution coefficients of the elements.
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
    /// For each stretch, the deflection and the rotation of its first node, and the deformation (d₁, d₂) of its first
    /// element. The deformation is the deflection and the rotation of the far end relative to a rigid motion with the
    /// first node.
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

    /// Calls `each` for every element, from the node where the eliminations from both ends of the beam meet to the
    /// end of the beam. The meeting node has the deflection `w` and the rotation `theta`.
    ///
    /// The first two values for `each` are the deflection and the rotation of the element's outer node, which is
    /// nearer to the end of the beam. The last two values are the deflection and the rotation of the inner node
    /// relative to a rigid motion with the outer node. To the right of the meeting node, all rotations have the
    /// opposite sign.
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
