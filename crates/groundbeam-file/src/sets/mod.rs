//! Sets of combinations that codes of practice ask for: the data files in `sets/`, and what they make of a file's cases.

mod expand;

pub(crate) use expand::{Acting, Made, TooMany, expand};

use crate::catalogue::{self, Entry};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A code of practice: the actions it knows and the sets of combinations it asks for.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Practice {
    /// `EN 1990`.
    pub code: String,
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
    /// ψ₀, ψ₁, ψ₂; none for an action that is always there, and in codes without them.
    psi: Option<[f64; 3]>,
}

/// A set of combinations.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Set {
    /// As a model file asks for it.
    pub name: String,
    /// Other names by which it can be asked for.
    #[serde(default)]
    also: Vec<String>,
    /// Clause and table.
    pub source: String,
    #[serde(rename = "formula")]
    formulas: Vec<Formula>,
}

/// One expression of a code. Of its variable actions any may be absent.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Formula {
    /// How its combinations' names begin.
    label: String,
    /// Actions that are there in every combination, each with the factors that it takes in turn.
    always: BTreeMap<String, Vec<f64>>,
    /// Of each of these one action at a time, or none.
    #[serde(default)]
    terms: Vec<BTreeMap<String, f64>>,
    /// Of every action with ψ, which leads in turn.
    leading: Option<Share>,
    /// Of the actions with ψ that do not lead.
    accompanying: Option<Share>,
}

/// A factor, or its product with one of the ψ.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Share {
    factor: f64,
    psi: Option<usize>,
}

static PRACTICES: LazyLock<Vec<Practice>> = LazyLock::new(|| {
    catalogue::files(&[
        include_str!("../../sets/en-1990.toml"),
        include_str!("../../sets/asce-7-16.toml"),
    ])
});

/// The set of a name, and the code it belongs to.
pub(crate) fn find(name: &str) -> Option<(&'static Practice, &'static Set)> {
    let mut all = PRACTICES.iter().flat_map(|p| p.sets.iter().map(move |set| (p, set)));
    all.find(|(_, set)| set.is_called(name))
}

/// All names of all sets.
pub(crate) fn spellings() -> Vec<&'static str> {
    catalogue::spellings(PRACTICES.iter().flat_map(|practice| &practice.sets))
}

impl Entry for Set {
    fn name(&self) -> &str {
        &self.name
    }

    fn also(&self) -> &[String] {
        &self.also
    }
}

/// The names of all sets.
pub(crate) fn names() -> Vec<&'static str> {
    PRACTICES.iter().flat_map(|p| &p.sets).map(|set| set.name.as_str()).collect()
}

/// The names of all actions, each once.
pub(crate) fn actions() -> Vec<&'static str> {
    let mut names: Vec<&str> = PRACTICES.iter().flat_map(Practice::actions).collect();
    let mut seen = std::collections::BTreeSet::new();
    names.retain(|name| seen.insert(*name));
    names
}

impl Practice {
    /// The names of its actions.
    pub fn actions(&self) -> impl Iterator<Item = &str> {
        self.actions.iter().map(|action| action.name.as_str())
    }
}

/// A set of combinations that a model file can ask for, with `[[combination]] set = "…"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CombinationSet {
    /// Its name.
    pub name: &'static str,
    /// The code of practice.
    pub code: &'static str,
    /// Clause and table of the code.
    pub source: &'static str,
}

/// Every set of combinations that a model file can ask for.
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
                let shares = [formula.leading, formula.accompanying];
                assert!(shares.into_iter().flatten().all(|share| share.psi.unwrap_or(0) < 3));
            }
        }
    }

    #[test]
    fn a_set_is_found_by_its_name() {
        assert!(find("EN 1990 6.10").is_some() && find("EN 1990 6.11").is_none());
    }
}
