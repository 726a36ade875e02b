//! Flags for the unit systems that occur in the unit of a quantity. They determine the units of printed results.

/// A set of flags.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Marks(u8);

impl Marks {
    pub const NONE: Marks = Marks(0);
    pub const METRE: Marks = Marks(1);
    pub const NEWTON: Marks = Marks(2);
    /// Flag for the kilogram-force and the tonne-force.
    pub const TECHNICAL: Marks = Marks(4);
    pub const INCH: Marks = Marks(8);
    pub const FOOT: Marks = Marks(16);
    pub const POUND: Marks = Marks(32);
    pub const KIP: Marks = Marks(64);
    /// Flags of all US units.
    pub const US: Marks = Marks(8 | 16 | 32 | 64);

    /// Returns the union of two sets of flags.
    pub const fn with(self, other: Marks) -> Marks {
        Marks(self.0 | other.0)
    }

    /// Whether the set contains at least one of the flags `marks`.
    pub fn has_any(self, marks: Marks) -> bool {
        self.0 & marks.0 != 0
    }
}
