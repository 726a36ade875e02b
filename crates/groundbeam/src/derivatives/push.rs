//! Right-hand sides of the linearised problem: dual loads of outputs, changes by parameters.

/// A load on beam and ground glued together.
#[derive(Debug, Clone, Default)]
pub(super) struct Push {
    /// What does work on the four of an element.
    pub loads: Vec<(usize, [f64; 4])>,
    /// An element whose own four are less by these: kinks and jumps at its ends, as of an imposed strain.
    pub jumps: Vec<(usize, [f64; 4])>,
    /// A joint of open ground whose ends lie lower than the beam by less.
    pub parted: Vec<(usize, [f64; 2])>,
    /// A force on open ground, at the start of a strip of a joint.
    pub on_ground: Vec<(usize, usize, f64)>,
    /// A node whose support settles.
    pub settled: Vec<(usize, f64)>,
}

impl Push {
    /// The forces on a joint's strips.
    pub fn on_joint(&self, joint: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let own = self.on_ground.iter().filter(move |(j, ..)| *j == joint);
        own.map(|(_, strip, force)| (*strip, *force))
    }

    pub fn is_empty(&self) -> bool {
        self.loads.is_empty()
            && self.jumps.is_empty()
            && self.parted.is_empty()
            && self.on_ground.is_empty()
            && self.settled.is_empty()
    }
}
