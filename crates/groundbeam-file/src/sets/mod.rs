//! Reads the sets of load combinations of codes of practice from the data files in `sets/`, and finds a set by its name.

mod expand;

pub(crate) use expand::{Acting, Made, TooMany, expand};

use crate::catalogue::{self, Entry};
use groundbeam::design::{LimitState, LimitStates};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A code of practice: its actions and its sets of combinations.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Practice {
    /// Name of the code, such as `EN 1990`.
    pub code: String,
    /// Whether the code belongs to the Eurocodes.
    #[serde(default)]
    pub eurocode: bool,
    #[serde(rename = "action")]
    actions: Vec<Action>,
    #[serde(rename = "set")]
    sets: Vec<Set>,
}

/// A kind of action.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Action {
    name: String,
    /// Combination factors ψ₀, ψ₁ and ψ₂ of a variable action; `None` for other actions and in codes without
    /// such factors.
    psi: Option<[f64; 3]>,
    /// Partial factors of the action by the letter of their table, such as A in EN 1990: the unfavourable factor, then
    /// the favourable factor if it differs.
    #[serde(default)]
    gamma: BTreeMap<String, Vec<f64>>,
    /// Whether the action is permanent.
    #[serde(default)]
    permanent: bool,
}

/// A set of combinations.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Set {
    /// Name of the set in a model file.
    pub name: String,
    /// Alternative names.
    #[serde(default)]
    also: Vec<String>,
    /// Ambiguous names: they also fit other editions of the design code, or other sets of combinations. A file that
    /// uses one of them is refused.
    #[serde(default)]
    ambiguous: Vec<String>,
    /// Clause and table of the code of practice that define this set of load combinations.
    pub source: String,
    /// The remark `one source` if a value of the set is not confirmed by a second source.
    remark: Option<String>,
    /// Limit states to which the combinations of the set belong.
    limit_states: Vec<String>,
    #[serde(rename = "formula")]
    formulas: Vec<Formula>,
}

/// One combination expression of a design code. A combination may omit variable actions of the expression. If
/// `needs_first` is true, it has at least one action of the first term.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Formula {
    /// Prefix of the names of all combinations that this combination expression generates.
    label: String,
    /// Limit states of the combinations of this combination expression, in addition to the limit states of the whole
    /// set of load combinations.
    #[serde(default)]
    also_limit_states: Vec<String>,
    /// Actions that act in every combination in addition to the permanent actions of the code. Each action has
    /// a list of alternative factors.
    #[serde(default)]
    always: BTreeMap<String, Vec<f64>>,
    /// Terms of the expression. Each term lists alternative actions with their factors. At most one action of
    /// each term acts in a combination.
    #[serde(default)]
    terms: Vec<BTreeMap<String, f64>>,
    /// Whether every combination must contain one of the actions that the first term in `terms` lists.
    #[serde(default)]
    needs_first: bool,
    /// Letter of the table that contains the partial factors. Without a letter, all partial factors are 1.
    gamma: Option<String>,
    /// Reduction factor ξ of unfavourable permanent actions.
    xi: Option<f64>,
    /// Factor of the leading action. Each action with factors ψ is the leading action in some combinations.
    leading: Option<Share>,
    /// Factor of the accompanying actions: all actions with factors ψ except the leading action.
    accompanying: Option<Share>,
    /// Whether parts of one permanent action may have different factors, as in checks of static equilibrium.
    #[serde(default)]
    by_parts: bool,
}

/// Factor of a variable action: the partial factor, or the product of the partial factor and ψ₀, ψ₁ or ψ₂.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Share {
    psi: Option<usize>,
}

static PRACTICES: LazyLock<Vec<Practice>> = LazyLock::new(|| {
    catalogue::files(&[
        include_str!("../../sets/en-1990.toml"),
        include_str!("../../sets/en-1990-uk.toml"),
        include_str!("../../sets/en-1990-bridges.toml"),
        include_str!("../../sets/en-1990-bridges-uk.toml"),
        include_str!("../../sets/asce-7-16.toml"),
        include_str!("../../sets/asce-7-22.toml"),
    ])
});

/// Finds a set of load combinations by its name. Returns the set and the code of practice that contains it.
pub(crate) fn find(name: &str) -> Option<(&'static Practice, &'static Set)> {
    let mut all = PRACTICES.iter().flat_map(|p| p.sets.iter().map(move |set| (p, set)));
    all.find(|(_, set)| set.is_called(name))
}

/// Returns the names of all sets of load combinations for which `name` is an ambiguous name.
pub(crate) fn meant(name: &str) -> Vec<&'static str> {
    let all = PRACTICES.iter().flat_map(|p| &p.sets);
    let claims = |set: &&Set| set.ambiguous.iter().any(|ambiguous| ambiguous == name);
    all.filter(claims).map(|set| &*set.name).collect()
}

/// Returns the names and alternative names of all sets of load combinations.
pub(crate) fn spellings() -> Vec<&'static str> {
    catalogue::spellings(PRACTICES.iter().flat_map(|practice| &practice.sets))
}

impl Set {
    /// If an expression of the set has `needs_first`, returns an action of the first term of this expression. Returns
    /// `None` if no expression has `needs_first`.
    pub fn needed(&self) -> Option<&str> {
        let formula = self.formulas.iter().find(|formula| formula.needs_first)?;
        formula.terms.first()?.keys().next().map(String::as_str)
    }
}

impl Entry for Set {
    fn name(&self) -> &str {
        &self.name
    }

    fn also(&self) -> &[String] {
        &self.also
    }
}

/// Returns the names of all sets of load combinations, without alternative names.
pub(crate) fn names() -> Vec<&'static str> {
    PRACTICES.iter().flat_map(|p| &p.sets).map(|set| set.name.as_str()).collect()
}

/// Returns the names of all actions, each name once.
pub(crate) fn actions() -> Vec<&'static str> {
    let mut names: Vec<&str> = PRACTICES.iter().flat_map(Practice::actions).collect();
    let mut seen = std::collections::BTreeSet::new();
    names.retain(|name| seen.insert(*name));
    names
}

/// Returns the limit states with these names. A test ensures that all names are known.
fn states(names: &[String]) -> LimitStates {
    let states: Vec<LimitState> = names.iter().filter_map(|name| LimitState::named(name)).collect();
    LimitStates::of(&states)
}

impl Practice {
    /// Returns the letter of the first table of partial factors that an expression of the set uses but that has no
    /// factors for the action. Returns `None` if there is no such table.
    pub fn lacks<'s>(&self, set: &'s Set, action: &str) -> Option<&'s str> {
        let action = self.actions.iter().find(|known| known.name == action)?;
        let letters = set.formulas.iter().filter_map(|formula| formula.gamma.as_deref());
        let has_factors = action.permanent || action.psi.is_some();
        letters.filter(|_| has_factors).find(|letter| !action.gamma.contains_key(*letter))
    }

    /// Returns the names of all actions that the code of practice defines.
    pub fn actions(&self) -> impl Iterator<Item = &str> {
        self.actions.iter().map(|action| action.name.as_str())
    }
}

/// A built-in set of combinations, which a model file selects with `[[combination]] set = "…"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CombinationSet {
    /// Name of the set.
    pub name: &'static str,
    /// The code of practice.
    pub code: &'static str,
    /// Clause and table of the code of practice that define this set of load combinations.
    pub source: &'static str,
    /// The remark `one source` if a value of the set is not confirmed by a second source.
    pub remark: Option<&'static str>,
    /// Limit states to which the combinations of the set belong.
    pub limit_states: LimitStates,
}

/// Returns all built-in sets of combinations.
///
/// ```
/// let sets = groundbeam_file::combination_sets();
/// let found = sets.iter().find(|set| set.name == "EN 1990 EQU").unwrap();
/// assert!(found.source.contains("Table A1.2(A)"));
/// ```
pub fn combination_sets() -> Vec<CombinationSet> {
    let of = |p: &'static Practice| {
        let each = |set: &'static Set| CombinationSet {
            name: &set.name,
            code: &p.code,
            source: &set.source,
            remark: set.remark.as_deref(),
            limit_states: states(&set.limit_states),
        };
        p.sets.iter().map(each)
    };
    PRACTICES.iter().flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_action_that_a_formula_names_is_known() {
        for practice in PRACTICES.iter() {
            let known: Vec<&str> = practice.actions().collect();
            for formula in practice.sets.iter().flat_map(|set| &set.formulas) {
                let terms = formula.terms.iter().flat_map(|term| term.keys());
                for name in formula.always.keys().chain(terms) {
                    assert!(known.contains(&name.as_str()), "{}: {name}", formula.label);
                }
                assert!(!formula.needs_first || !formula.terms.is_empty());
                let shares = [formula.leading, formula.accompanying];
                assert!(shares.into_iter().flatten().all(|share| share.psi.unwrap_or(0) < 3));
            }
        }
    }

    #[test]
    fn every_set_has_limit_states_and_every_permanent_action_its_factors() {
        for practice in PRACTICES.iter() {
            for set in &practice.sets {
                let named =
                    |names: &[String]| names.iter().all(|name| LimitState::named(name).is_some());
                assert!(!set.limit_states.is_empty() && named(&set.limit_states), "{}", set.name);
                assert!(set.formulas.iter().all(|formula| named(&formula.also_limit_states)));
                for letter in set.formulas.iter().filter_map(|formula| formula.gamma.as_ref()) {
                    let has = |action: &Action| action.gamma.contains_key(letter);
                    let mut permanent = practice.actions.iter().filter(|action| action.permanent);
                    assert!(permanent.all(has), "{}: {letter}", set.name);
                }
            }
        }
    }

    #[test]
    fn ambiguous_names_of_sets_are_refused() {
        assert_eq!(meant("ASCE 7 LRFD"), ["ASCE 7-16 LRFD", "ASCE 7-22 LRFD"]);
        assert_eq!(meant("EN 1990 GEO"), ["EN 1990 STR/GEO B", "EN 1990 STR/GEO C"]);
        assert!(find("ASCE 7 LRFD").is_none() && find("EN 1990 GEO").is_none());
    }

    #[test]
    fn a_set_is_found_by_its_name() {
        assert!(find("EN 1990 6.10").is_some() && find("EN 1990 6.11").is_none());
    }
}
