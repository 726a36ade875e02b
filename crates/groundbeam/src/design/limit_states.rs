//! Defines the limit states of combinations of actions, and sets of limit states to which a design check applies.

/// The limit state for which a combination of actions is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LimitState {
    /// Strength of the structure or of the ground: EN 1990 STR and GEO, strength combinations of ASCE 7 and AASHTO.
    StrGeo,
    /// Loss of static equilibrium.
    Equ,
    /// Accidental design situation.
    Accidental,
    /// Seismic design situation.
    Seismic,
    /// Serviceability, characteristic combination.
    Characteristic,
    /// Serviceability, frequent combination.
    Frequent,
    /// Serviceability, quasi-permanent combination.
    QuasiPermanent,
    /// Allowable stress design.
    AllowableStress,
}

impl LimitState {
    /// All limit states, in the order in which reports list them.
    pub const ALL: [LimitState; 8] = [
        LimitState::StrGeo,
        LimitState::Equ,
        LimitState::Accidental,
        LimitState::Seismic,
        LimitState::Characteristic,
        LimitState::Frequent,
        LimitState::QuasiPermanent,
        LimitState::AllowableStress,
    ];

    /// Returns whether the limit state is an ultimate limit state, which has design values of actions and
    /// resistances.
    pub fn is_ultimate(self) -> bool {
        use LimitState::{Accidental, Equ, Seismic, StrGeo};
        matches!(self, StrGeo | Equ | Accidental | Seismic)
    }

    /// Returns the name of the limit state in files and results.
    pub fn name(self) -> &'static str {
        match self {
            LimitState::StrGeo => "STR/GEO",
            LimitState::Equ => "EQU",
            LimitState::Accidental => "accidental",
            LimitState::Seismic => "seismic",
            LimitState::Characteristic => "SLS characteristic",
            LimitState::Frequent => "SLS frequent",
            LimitState::QuasiPermanent => "SLS quasi-permanent",
            LimitState::AllowableStress => "allowable stress",
        }
    }

    /// Returns the limit state with the given name, or `None` if no limit state has this name.
    pub fn named(name: &str) -> Option<Self> {
        LimitState::ALL.into_iter().find(|state| state.name() == name)
    }
}

/// A set of limit states.
///
/// ```
/// use groundbeam::design::{LimitState, LimitStates};
///
/// let states = LimitStates::of(&[LimitState::Equ, LimitState::StrGeo]);
/// assert!(states.contains(LimitState::Equ) && !states.contains(LimitState::Seismic));
/// assert_eq!(states.names(), "STR/GEO or EQU");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LimitStates(u8);

impl LimitStates {
    /// No limit state.
    pub const NONE: LimitStates = LimitStates(0);

    /// The set of the limit states in a list.
    pub const fn of(states: &[LimitState]) -> Self {
        let mut bits = 0;
        let mut i = 0;
        while i < states.len() {
            bits |= 1 << states[i] as u8;
            i += 1;
        }
        LimitStates(bits)
    }

    /// Whether the set is empty.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether a limit state belongs to the set.
    pub fn contains(self, state: LimitState) -> bool {
        self.0 & (1 << state as u8) != 0
    }

    /// Returns the union of this set with another set of limit states.
    pub const fn and(self, others: LimitStates) -> Self {
        LimitStates(self.0 | others.0)
    }

    /// The limit states of the set, in the order of [`LimitState::ALL`].
    pub fn iter(self) -> impl Iterator<Item = LimitState> {
        LimitState::ALL.into_iter().filter(move |state| self.contains(*state))
    }

    /// Returns the names of the limit states as text, such as `SLS frequent, SLS characteristic or EQU`.
    pub fn names(self) -> String {
        let names: Vec<&str> = self.iter().map(LimitState::name).collect();
        match names.split_last() {
            None => String::new(),
            Some((last, [])) => (*last).to_owned(),
            Some((last, others)) => format!("{} or {last}", others.join(", ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_states_are_found_by_their_names() {
        for state in LimitState::ALL {
            assert_eq!(LimitState::named(state.name()), Some(state));
            assert_eq!(LimitStates::of(&[state]).iter().collect::<Vec<_>>(), [state]);
        }
        assert_eq!(LimitStates::of(&LimitState::ALL).iter().count(), LimitState::ALL.len());
        assert!(LimitStates::NONE.is_empty());
    }
}
