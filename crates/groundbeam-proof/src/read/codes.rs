//! The parts of a code of practice: actions with their factors γ and ψ, and the expressions of its sets of combinations.

/// A factor in millionths, so that the product of two decimals with three places is an integer.
pub(crate) type Micro = i64;
pub(crate) const UNIT: Micro = 1_000_000;

/// A code of practice: its actions and its sets of combinations.
pub(crate) struct Code {
    pub actions: &'static [Action],
    pub sets: &'static [Set],
}

/// Partial factors γ, by the letter of their table in the code of practice. The unfavourable factor comes first, then
/// the favourable factor if it differs.
pub(crate) type Gammas = &'static [(&'static str, &'static [Micro])];

/// A kind of action.
pub(crate) struct Action {
    pub name: &'static str,
    /// Combination factors ψ₀, ψ₁, ψ₂ of a variable action.
    pub psi: Option<[Micro; 3]>,
    pub gammas: Gammas,
    pub is_permanent: bool,
}

/// A set of combinations: the names by which a model file refers to the set, and the expressions that define its
/// combinations.
pub(crate) struct Set {
    pub names: &'static [&'static str],
    pub formulas: &'static [Formula],
}

/// Alternative actions in an expression for combinations of actions, each with its factor. A combination contains at
/// most one of these alternatives.
pub(crate) type Term = &'static [(&'static str, Micro)];

/// The index of a combination factor ψ; `None` for the factor 1.
pub(crate) type Psi = Option<usize>;

/// An expression of a code of practice for combinations of actions, such as (6.10) of EN 1990: the actions in it and
/// their factors.
pub(crate) struct Formula {
    pub label: &'static str,
    /// Actions that always act, each with the factors to be tried. These factors replace the partial factors of
    /// permanent actions.
    pub always: &'static [(&'static str, &'static [Micro])],
    pub terms: &'static [Term],
    /// Whether every combination contains an action of the first element of `terms`.
    pub needs_first: bool,
    /// Letter of the table of partial factors in the code of practice, such as `B`; `None` if all partial factors are
    /// 1.
    pub letter: Option<&'static str>,
    /// Reduction factor ξ of the unfavourable factors of permanent actions.
    pub xi: Micro,
    /// Combination factor ψ of the leading action; `None` if the expression has no leading action.
    pub leading: Option<Psi>,
    /// Combination factor ψ of the accompanying actions; `None` if the expression has no accompanying actions.
    pub accompanying: Option<Psi>,
    /// Whether permanent cases from the same source may have different factors, as in the limit state EQU.
    pub by_parts: bool,
}

/// Converts a factor from thousandths to millionths.
pub(crate) const fn m(thousandths: Micro) -> Micro {
    thousandths * 1000
}

/// An action without the factors γ and ψ. Each expression that contains the action gives its factors.
pub(crate) const fn other(name: &'static str) -> Action {
    Action { name, psi: None, gammas: &[], is_permanent: false }
}

/// The empty expression: it has no actions, and all its factors are 1. Every other expression is defined by its
/// differences from this one.
pub(crate) const PLAIN: Formula = Formula {
    label: "",
    always: &[],
    terms: &[],
    needs_first: false,
    letter: None,
    xi: UNIT,
    leading: None,
    accompanying: None,
    by_parts: false,
};
