//! Flags that record the unit systems in a quantity. They determine the units of printed results.

/// A set of flags.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Marks(u8);

impl Marks {
    pub const NONE: Marks = Marks(0);
    pub const METRE: Marks = Marks(1);
    pub const NEWTON: Marks = Marks(2);
    /// The kilogram-force and the tonne-force.
    pub const TECHNICAL: Marks = Marks(4);
    pub const INCH: Marks = Marks(8);
    pub const FOOT: Marks = Marks(16);
    pub const POUND: Marks = Marks(32);
    pub const KIP: Marks = Marks(64);
    /// All US units.
    pub const US: Marks = Marks(8 | 16 | 32 | 64);

    /// Union of both sets.
    pub const fn with(self, other: Marks) -> Marks {
        Marks(self.0 | other.0)
    }

    /// Whether one of these flags is set.
    pub fn has_any(self, marks: Marks) -> bool {
        self.0 & marks.0 != 0
    }
}
