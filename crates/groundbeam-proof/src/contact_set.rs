//! The exact contact set, and the fields and bounds from which it is proven.

use crate::fields::Fields;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The exact contact set, with an interval for each edge and each concentrated force.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSet {
    /// The regions and points of exact contact, from left to right; the list is complete. A region is cut where a shear
    /// layer ends under the beam.
    pub regions: Vec<ContactRegion>,
    /// Intervals that contain the exact concentrated contact forces; the list is complete.
    pub forces: Vec<ContactForce>,
}

/// One region or point of exact contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactRegion {
    /// An interval that contains the exact left end \[m\].
    pub from: [f64; 2],
    /// An interval that contains the exact right end \[m\]; for a point equal to `from`.
    pub to: [f64; 2],
}

/// A concentrated contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce {
    /// Position \[m\], a node of the answer.
    pub x: f64,
    /// An interval that contains the exact force \[N\], positive where it pushes the beam up.
    pub force: [f64; 2],
}

/// Bounds of the distance between the ends of a claimed and an exact region.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EdgeShift {
    pub node: usize,
    /// 0: the left end of the region, 1: its right end.
    pub side: usize,
    /// θ, outward.
    pub outside: Size,
    /// θ′, inward.
    pub inside: Size,
    /// Φ₀ outside and inside: the bound of the jump of the flux for an exact slope.
    pub beyond: [Size; 2],
}

/// The neighbourhood of an edge on one piece of Winkler ground, or of a support on the surface of open
/// ground: its length, and the end of the piece at which it lies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Zone {
    pub piece: usize,
    pub side: usize,
    pub theta: Size,
}

/// One iteration for a beam with shear deformation: the bounds on the pieces, and the edges that follow from
/// them.
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

/// The proven regions, forces and edges, and the steps that fail.
#[derive(Debug)]
pub(crate) struct Shown {
    pub set: ContactSet,
    /// The ends of the regions of all layers.
    pub edges: Vec<EdgeShift>,
    /// ε_a at the touching nodes of layers.
    pub tolerances: Vec<Size>,
    /// Whether the exact contact force at a node is proven to be positive.
    pub pressed: Vec<bool>,
    /// Lengths on which w* − g₀ is monotone: next to an edge on each piece of Winkler ground, and next to a
    /// support on the surface of open ground.
    pub zones: Vec<Zone>,
    /// All iterations for a beam with shear deformation, including the last one.
    pub rounds: Vec<Round>,
    /// The first step that fails in a layer, and the first that fails on Winkler ground.
    pub failed: [Option<NotProven>; 2],
}

impl Shown {
    /// An empty contact set for this number of nodes.
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

    /// The contact set, or the first step that fails.
    pub fn result(self) -> Result<ContactSet, NotProven> {
        let [layer, springs] = self.failed;
        match layer.or(springs) {
            Some(why) => Err(why),
            None => Ok(self.set),
        }
    }
}

/// Input of the proof of the contact set.
pub(crate) struct Contact<'a, S> {
    pub fields: &'a Fields<'a, S>,
    pub bounds: &'a [PieceBounds],
}

/// Number of iterations between contact set and slope for a beam with shear deformation.
const ROUNDS: usize = 3;

impl<S: Scalar> Pointwise<'_, S> {
    /// Proves the contact set, and with it the bounds of the shear force.
    ///
    /// On a beam with shear deformation, the contact set needs the slope, and the slope needs the shear
    /// force. The iteration starts with the contact that is proven without a slope.
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

    /// An interval about a node, in the units of the model, clipped to the beam.
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

/// A size that is strictly larger than a given one.
pub(crate) fn more(size: Size) -> Size {
    1.0001 * size + Size::of(1e-250)
}
