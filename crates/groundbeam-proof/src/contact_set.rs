//! The exact contact set, and the fields and bounds from which it is proven.

use crate::fields::Fields;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The exact contact set, with an interval for each edge and each concentrated force.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSet {
    /// The contact regions and contact points of the exact solution, from left to right. The list is complete. A
    /// region is split where a shear layer ends under the beam.
    pub regions: Vec<ContactRegion>,
    /// Intervals that contain the exact concentrated contact forces. The list is complete.
    pub forces: Vec<ContactForce>,
}

/// One contact region or contact point of the exact solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactRegion {
    /// An interval that contains the left end of the exact contact region \[m\].
    pub from: [f64; 2],
    /// An interval that contains the right end of the exact contact region \[m\]. For a contact point it equals
    /// `from`.
    pub to: [f64; 2],
}

/// A concentrated contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce {
    /// Position of the contact force \[m\], at an end of a piece of the claimed solution.
    pub x: f64,
    /// An interval that contains the exact force \[N\], positive where it pushes the beam up.
    pub force: [f64; 2],
}

/// Bounds of the distance between an end of the exact contact region and the corresponding end of the claimed region.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EdgeShift {
    pub node: usize,
    /// Which end of the contact region this is: 0 for the left end, 1 for the right end.
    pub side: usize,
    /// Upper bound θ of the distance between the exact and the claimed end of the contact region, if the exact end
    /// lies outside the claimed region.
    pub outside: Size,
    /// Upper bound θ′ of the distance between the exact and the claimed end of the contact region, if the exact end
    /// lies inside the claimed region.
    pub inside: Size,
    /// Upper bounds Φ₀ of the jump of the shear-layer force μu′ at the exact edge, without the effect of the slope
    /// error: if the edge lies outside the claimed region, and if it lies inside.
    pub beyond: [Size; 2],
}

/// An interval next to a contact edge on Winkler ground, or next to a rigid support at the ground surface. On the
/// interval, the exact w − g₀ − q/k is monotone; on a shear layer, w − g₀ is monotone.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Zone {
    pub piece: usize,
    pub side: usize,
    pub theta: Size,
}

/// One iteration of the proof for a beam with shear deformation: the error bounds of the claimed solution on each
/// piece, and the contact edges that are proven with these error bounds.
#[derive(Debug)]
pub(crate) struct Round {
    pub shown: bool,
    pub bounds: Vec<PieceBounds>,
    pub edges: Vec<EdgeShift>,
}

impl Round {
    fn of(shown: &Shown, bounds: &[PieceBounds]) -> Self {
        let (bounds, edges) = (bounds.to_vec(), shown.edges.clone());
        Round { shown: shown.failed[0].is_none(), bounds, edges }
    }
}

/// The proven contact regions, contact forces and edges, and the steps of the proof that fail.
#[derive(Debug)]
pub(crate) struct Shown {
    pub set: ContactSet,
    /// The ends of the contact regions on ground with a shear layer.
    pub edges: Vec<EdgeShift>,
    /// ε_a, the error bound of the concentrated force at each node; zero at nodes where no layer touches the beam.
    pub tolerances: Vec<Size>,
    /// For each node, whether the exact contact force is proven to be positive.
    pub pressed: Vec<bool>,
    /// Intervals next to contact edges on Winkler ground, and next to rigid supports at the ground surface.
    pub zones: Vec<Zone>,
    /// The iterations of the proof on a beam with shear deformation, from the first to the last. The list is empty
    /// without shear deformation.
    pub rounds: Vec<Round>,
    /// The first failed step of the proof on ground with a shear layer, and the first failed step on Winkler ground;
    /// `None` if no step fails.
    pub failed: [Option<NotProven>; 2],
}

impl Shown {
    /// Returns an empty contact set for a beam with this number of nodes.
    pub fn nothing(nodes: usize) -> Self {
        Shown {
            set: ContactSet { regions: Vec::new(), forces: Vec::new() },
            edges: Vec::new(),
            tolerances: vec![Size::ZERO; nodes],
            pressed: vec![false; nodes],
            zones: Vec::new(),
            rounds: Vec::new(),
            failed: [None, None],
        }
    }

    /// Returns the contact set, or the first step of the proof that fails.
    pub fn result(self) -> Result<ContactSet, NotProven> {
        let [layer, springs] = self.failed;
        match layer.or(springs) {
            Some(why) => Err(why),
            None => Ok(self.set),
        }
    }
}

/// Input of the proof of the contact set: the fields of the claimed solution, and their error bounds on each piece.
pub(crate) struct Contact<'a, S> {
    pub fields: &'a Fields<'a, S>,
    pub bounds: &'a [PieceBounds],
}

/// Number of iterations for a beam with shear deformation on a shear layer. Each iteration first proves the contact
/// set and then bounds the errors of the shear force and the slope.
const ROUNDS: usize = 3;

impl<S: Scalar> Pointwise<'_, S> {
    /// Proves the contact set, and tightens the bounds of the shear force in `pieces`.
    ///
    /// With shear deformation, each depends on the other. The iteration starts with bounds of the contact edges that
    /// need no slope.
    pub fn contact(&self, pieces: &mut [PieceBounds]) -> Shown {
        let (fields, frame) = (self.fields, self.fields.frame);
        let (mut rounds, mut past) = (1, Vec::new());
        if frame.shears() {
            self.first_slopes(pieces);
            let rough = Contact { fields, bounds: pieces }.roughly();
            past.push(Round::of(&rough, pieces));
            self.shear_forces(&rough, pieces);
            rounds = if frame.spans.iter().any(|span| span.layered) { ROUNDS } else { 1 };
        }
        loop {
            self.lower_pressures(pieces);
            let mut shown = Contact { fields, bounds: pieces }.shown();
            if frame.shears() {
                past.push(Round::of(&shown, pieces));
            }
            self.shear_forces(&shown, pieces);
            rounds -= 1;
            if rounds == 0 || shown.failed[0].is_some() {
                shown.rounds = past;
                return shown;
            }
        }
    }
}

impl<S: Scalar> Contact<'_, S> {
    pub fn failed(&self, what: &str, node: usize) -> NotProven {
        NotProven::new(format!("the contact set is not proven: {what}"))
            .at(self.fields.frame.place(node))
    }

    /// Returns an interval around a node in the units of the model, clipped to the beam. `before` and `after` are
    /// its lengths on the left and on the right of the node.
    pub fn interval(&self, node: usize, [before, after]: [Size; 2]) -> [f64; 2] {
        let frame = self.fields.frame;
        let x = frame.nodes[node].x;
        let low = (x.low() - before.value()).next_down();
        let low = frame.units.restored(low.max(0.0), 0, 1);
        let low = if low > 1e-280 { low } else { 0.0 };
        // The position of the left end of the beam is exactly zero.
        let high =
            if x == S::zero() { after.value() } else { (x.high() + after.value()).next_up() };
        [low, frame.units.restored(high.max(0.0), 0, 1)]
    }
}

/// Returns a size that is strictly larger than `size`.
pub(crate) fn more(size: Size) -> Size {
    1.0001 * size + Size::of(1e-250)
}
