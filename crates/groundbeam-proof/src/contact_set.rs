//! The exact contact set, and the fields and bounds from which it is shown.

use crate::fields::Fields;
use crate::pointwise::PieceBounds;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The exact contact set, with an interval for each edge and each concentrated force.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSet {
    /// The regions and points of exact contact, from left to right, and no others. A region is cut where a shear layer
    /// ends under the beam.
    pub regions: Vec<ContactRegion>,
    /// Intervals that hold the exact concentrated contact forces. There is no other concentrated force.
    pub forces: Vec<ContactForce>,
}

/// One region or point of exact contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactRegion {
    /// An interval that holds the exact left end \[m\].
    pub from: [f64; 2],
    /// An interval that holds the exact right end \[m\]; of a point the same.
    pub to: [f64; 2],
}

/// A concentrated contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce {
    /// Position, that of a node of the answer \[m\].
    pub x: f64,
    /// An interval that holds the exact force \[N\], positive where it pushes the beam up.
    pub force: [f64; 2],
}

/// What the contact set is shown from.
pub(crate) struct Contact<'a, S> {
    pub fields: &'a Fields<'a, S>,
    pub bounds: &'a [PieceBounds],
}

impl<S: Scalar> Contact<'_, S> {
    pub fn failed(&self, what: &str, node: usize) -> NotProven {
        NotProven::new(format!("the contact set is not shown: {what}"))
            .at(self.fields.frame.place(node))
    }

    /// ε_p = kε_u + με_w″.
    pub fn pressure_error(&self, i: usize) -> Size {
        let (span, bounds) = (&self.fields.frame.spans[i], &self.bounds[i]);
        let bent = bounds.moment.over(span.bending.low());
        Size::of(span.spring.high()) * bounds.settlement + Size::of(span.shear.size()) * bent
    }

    /// Whether μ is the same on both sides of a node inside a layer, and no hinge is there.
    pub fn even(&self, node: usize) -> bool {
        let frame = self.fields.frame;
        frame.layered(node) == [true; 2]
            && frame.spans[node - 1].shear == frame.spans[node].shear
            && !frame.nodes[node].is_hinged()
    }

    /// Whether a node lies inside the layer and has no hinge, no corner of g₀, no step of μ.
    pub fn smooth(&self, node: usize) -> bool {
        self.even(node) && !self.fields.frame.nodes[node].corner
    }

    /// An interval about a node, in the units of the model, within the beam.
    pub fn interval(&self, node: usize, [before, after]: [Size; 2]) -> [f64; 2] {
        let frame = self.fields.frame;
        let x = frame.nodes[node].x;
        let low = (x.low() - before.value()).next_down();
        let low = if low > 0.0 { frame.units.restored(low, 0, 1) } else { 0.0 };
        let low = if low > 1e-280 { low } else { 0.0 };
        let high = (x.high() + after.value()).next_up();
        [low, frame.units.restored(if high > 0.0 { high } else { 0.0 }, 0, 1)]
    }
}

/// A size that is strictly larger.
pub(crate) fn more(size: Size) -> Size {
    1.0001 * size + Size::of(1e-250)
}
