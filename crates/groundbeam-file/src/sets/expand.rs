//! Generates load combinations from the load cases of a file and a set of combination rules of a code of practice.
//!
//! Superposition is invalid with lift-off, so no action is left out as favourable. All subsets of the variable cases
//! are combined with all leading actions and all permanent factors.

use super::{Action, Formula, Practice, Set, Share, states};
use groundbeam::design::LimitStates;
use std::collections::BTreeMap;

/// A load case and its action.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Acting<'a> {
    pub case: &'a str,
    pub action: &'a str,
    /// Group of the case. Cases of one group never act together.
    pub group: Option<&'a str>,
    /// Source of a permanent case. Permanent cases from one source have one partial factor.
    pub source: Option<&'a str>,
}

/// Text in the name of a combination that contains only loads without a case.
const ALONE: &str = "loads without a case";

/// Error: the number of combinations exceeds the limit.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct TooMany;

/// A combination generated from a set.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Made {
    /// Name of the combination, such as `6.10: 1.35 G + 1.5 Q + 0.9 W`.
    pub name: String,
    /// Indices of the load cases with a nonzero factor, each with its factor. They have the order of the load cases
    /// in the name of the combination.
    pub factors: Vec<(usize, f64)>,
    pub limit_states: LimitStates,
}

/// Generates the combinations of a set, each once; more than `most` are an error. With `has_others`, the loads without
/// a case alone are also a combination.
pub(crate) fn expand(
    practice: &Practice,
    set: &Set,
    cases: &[Acting],
    has_others: bool,
    most: usize,
) -> Result<Vec<Made>, TooMany> {
    let mut made = Vec::new();
    let mut seen = BTreeMap::new();
    for formula in &set.formulas {
        let limit_states = states(&set.limit_states).and(states(&formula.also_limit_states));
        let always: Vec<Vec<f64>> =
            cases.iter().map(|case| formula.always_of(practice, case.action)).collect();
        let (always, label, by_parts) = (&*always, &*formula.label, formula.by_parts);
        for (leads, terms) in formula.terms(practice, cases) {
            let mut found = Expansion {
                cases,
                always,
                by_parts,
                has_others,
                most,
                label,
                limit_states,
                leads,
                made,
                seen,
            };
            found.permanent(&terms, 0, &mut Vec::new(), &mut Vec::new())?;
            (made, seen) = (found.made, found.seen);
        }
    }
    Ok(made)
}

/// Terms of a formula. Each term lists alternative actions with their factors. At most one action of a term
/// acts.
type Terms<'a> = Vec<Vec<(&'a str, f64)>>;

impl Formula {
    /// Returns one list of terms for each leading action, and one without. The flag is true if each combination must
    /// contain an action of the first term.
    fn terms<'a>(&'a self, practice: &'a Practice, cases: &[Acting]) -> Vec<(bool, Terms<'a>)> {
        let written: Terms = self
            .terms
            .iter()
            .map(|term| term.iter().map(|(action, factor)| (action.as_str(), *factor)).collect())
            .collect();
        let variable: Vec<(&Action, [f64; 3])> = practice
            .actions
            .iter()
            .filter(|action| cases.iter().any(|case| case.action == action.name))
            .filter_map(|action| Some((action, action.psi?)))
            .collect();
        let term = |share: Option<Share>, (action, psi): (&'a Action, [f64; 3])| {
            let gamma = self.gamma_of(action).first().copied().unwrap_or(1.0);
            share.map(|share| vec![(&*action.name, share.of(gamma, psi))])
        };
        if self.leading.is_none() {
            let others = variable.iter().filter_map(|action| term(self.accompanying, *action));
            return vec![(self.needs_first, written.into_iter().chain(others).collect())];
        }
        let leads = |leader: &(&'a Action, [f64; 3])| {
            let others = variable.iter().filter(|other| other.0.name != leader.0.name);
            let others = others.filter_map(|action| term(self.accompanying, *action));
            let others = written.iter().cloned().chain(others);
            (true, term(self.leading, *leader).into_iter().chain(others).collect())
        };
        variable.iter().map(leads).chain([(false, written.clone())]).collect()
    }

    /// Returns the partial factors of an action; 1 if the formula has no partial factors.
    fn gamma_of<'a>(&self, action: &'a Action) -> &'a [f64] {
        let letter = self.gamma.as_ref();
        letter.and_then(|letter| action.gamma.get(letter)).map_or(&[1.0], Vec::as_slice)
    }

    /// Returns the alternative factors of a permanent action. These are γ_sup, multiplied by the reduction
    /// factor ξ if the formula has ξ, and γ_inf.
    fn always_of(&self, practice: &Practice, action: &str) -> Vec<f64> {
        if let Some(factors) = self.always.get(action) {
            return factors.clone();
        }
        let action = practice.actions.iter().find(|known| known.permanent && known.name == action);
        let mut factors = action.map_or_else(Vec::new, |action| self.gamma_of(action).to_vec());
        if let (Some(xi), Some(unfavourable)) = (self.xi, factors.first_mut()) {
            *unfavourable = rounded(*unfavourable * xi);
        }
        factors
    }
}

impl Share {
    fn of(self, gamma: f64, psi: [f64; 3]) -> f64 {
        rounded(gamma * self.psi.and_then(|i| psi.get(i)).unwrap_or(&1.0))
    }
}

/// Rounds a product of decimals to nine decimal places, which removes binary rounding errors.
fn rounded(product: f64) -> f64 {
    (product * 1e9).round() / 1e9
}

struct Expansion<'a> {
    cases: &'a [Acting<'a>],
    /// Alternative factors of each case; empty for a case that is not permanent.
    always: &'a [Vec<f64>],
    /// Whether permanent cases from the same source have independent factors.
    by_parts: bool,
    has_others: bool,
    most: usize,
    label: &'a str,
    limit_states: LimitStates,
    /// Whether every combination must contain one of the actions that the first term of the formula lists.
    leads: bool,
    made: Vec<Made>,
    /// Index in `made` of each generated combination. The key consists of the bits of the factors of all
    /// cases.
    seen: BTreeMap<Vec<u64>, usize>,
}

impl Expansion<'_> {
    /// Generates the combinations for every choice of one factor for each permanent load case, by recursion over the
    /// cases. `rows` records the index of the chosen factor of each case.
    fn permanent(
        &mut self,
        terms: &Terms,
        case: usize,
        chosen: &mut Vec<(usize, f64)>,
        rows: &mut Vec<(usize, usize)>,
    ) -> Result<(), TooMany> {
        let Some(acting) = self.cases.get(case) else {
            return self.variable(terms, self.leads, chosen);
        };
        let factors = self.always[case].clone();
        let same = |(other, _): &&(usize, usize)| {
            acting.source.is_some() && self.cases[*other].source == acting.source
        };
        let bound = rows.iter().find(same).map(|(_, row)| *row).filter(|_| !self.by_parts);
        for (row, &factor) in factors.iter().enumerate() {
            if bound.is_some_and(|bound| row != bound.min(factors.len() - 1)) {
                continue;
            }
            let before = chosen.len();
            if factor != 0.0 {
                chosen.push((case, factor));
            }
            rows.push((case, row));
            self.permanent(terms, case + 1, chosen, rows)?;
            rows.pop();
            chosen.truncate(before);
        }
        if factors.is_empty() { self.permanent(terms, case + 1, chosen, rows) } else { Ok(()) }
    }

    /// Generates the combinations of variable actions. Each term contributes one action or none; with `must`, the first
    /// term contributes one.
    fn variable(
        &mut self,
        terms: &[Vec<(&str, f64)>],
        must: bool,
        chosen: &mut Vec<(usize, f64)>,
    ) -> Result<(), TooMany> {
        let Some((term, others)) = terms.split_first() else { return self.push(chosen) };
        for &(action, factor) in term.iter().filter(|(_, factor)| *factor != 0.0) {
            let cases = self.cases.iter().enumerate();
            let of_it: Vec<usize> =
                cases.filter(|(_, case)| case.action == action).map(|(i, _)| i).collect();
            self.subsets(&of_it, factor, others, chosen, chosen.len())?;
        }
        if must { Ok(()) } else { self.variable(others, false, chosen) }
    }

    /// Generates combinations for each non-empty subset of the load cases of an action. Two cases of one group never
    /// act together.
    fn subsets(
        &mut self,
        cases: &[usize],
        factor: f64,
        others: &[Vec<(&str, f64)>],
        chosen: &mut Vec<(usize, f64)>,
        before: usize,
    ) -> Result<(), TooMany> {
        let Some((&case, rest)) = cases.split_first() else {
            return if chosen.len() > before {
                self.variable(others, false, chosen)
            } else {
                Ok(())
            };
        };
        let group = self.cases[case].group;
        let is_taken = |(other, _): &(usize, f64)| self.cases[*other].group == group;
        if group.is_none() || !chosen.iter().any(is_taken) {
            chosen.push((case, factor));
            self.subsets(rest, factor, others, chosen, before)?;
            chosen.pop();
        }
        self.subsets(rest, factor, others, chosen, before)
    }

    fn push(&mut self, chosen: &[(usize, f64)]) -> Result<(), TooMany> {
        if chosen.is_empty() && !self.has_others {
            return Ok(());
        }
        let mut key = vec![0; self.cases.len()];
        for (case, factor) in chosen {
            key[*case] = factor.to_bits();
        }
        if let Some(&same) = self.seen.get(&key) {
            // One combination may belong to several expressions of a code.
            self.made[same].limit_states = self.made[same].limit_states.and(self.limit_states);
            return Ok(());
        }
        if self.made.len() == self.most {
            return Err(TooMany);
        }
        self.seen.insert(key, self.made.len());
        let term = |(case, factor): &(usize, f64)| {
            let case = self.cases[*case].case;
            if *factor == 1.0 { case.to_owned() } else { format!("{factor} {case}") }
        };
        let sum = match chosen {
            [] => ALONE.to_owned(),
            _ => chosen.iter().map(term).collect::<Vec<String>>().join(" + "),
        };
        let name = format!("{}: {sum}", self.label).replace("+ -1 ", "- ").replace("+ -", "- ");
        let factors = chosen.to_vec();
        self.made.push(Made { name, factors, limit_states: self.limit_states });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::find;
    use super::*;

    fn case<'a>(case: &'a str, action: &'a str) -> Acting<'a> {
        Acting { case, action, group: None, source: None }
    }

    fn made(set: &str, cases: &[Acting]) -> Vec<String> {
        let (practice, set) = find(set).unwrap();
        let made = expand(practice, set, cases, false, 1000).unwrap();
        made.into_iter().map(|made| made.name).collect()
    }

    #[test]
    fn one_variable_action() {
        let cases = [case("G", "permanent"), case("Q", "imposed B")];
        let expected = ["6.10: 1.35 G + 1.5 Q", "6.10: G + 1.5 Q", "6.10: 1.35 G", "6.10: G"];
        assert_eq!(made("EN 1990 6.10", &cases), expected);
        let expected = [
            "6.10a: 1.35 G + 1.05 Q",
            "6.10a: 1.35 G",
            "6.10a: G + 1.05 Q",
            "6.10a: G",
            "6.10b: 1.1475 G + 1.5 Q",
            "6.10b: G + 1.5 Q",
            "6.10b: 1.1475 G",
        ];
        assert_eq!(made("EN 1990 6.10a/b", &cases), expected);
        let expected = ["EQU: 1.1 G + 1.5 Q", "EQU: 0.9 G + 1.5 Q", "EQU: 1.1 G", "EQU: 0.9 G"];
        assert_eq!(made("EN 1990 EQU", &cases), expected);
    }

    #[test]
    fn each_action_leads_in_turn() {
        let cases = [case("G", "permanent"), case("Q", "imposed B"), case("W", "wind")];
        let found = made("EN 1990 6.10", &cases);
        for name in [
            "6.10: 1.35 G + 1.5 Q + 0.9 W",
            "6.10: 1.35 G + 1.5 W + 1.05 Q",
            "6.10: G + 1.5 W",
            "6.10: G",
        ] {
            assert!(found.iter().any(|found| found == name), "{name} in {found:?}");
        }
        // Each of the two factors of G has five combinations: Q alone, W alone, Q leading with W, W leading
        // with Q, and neither Q nor W.
        assert_eq!(found.len(), 2 * 5);
        let found = made("EN 1990 frequent", &cases);
        assert!(found.contains(&"frequent: G + 0.2 W + 0.3 Q".to_owned()), "{found:?}");
        let found = made("EN 1990 quasi-permanent", &cases);
        assert_eq!(found, ["quasi-permanent: G + 0.3 Q", "quasi-permanent: G"]);
    }

    #[test]
    fn cases_of_one_action_lead_together_and_those_of_a_group_exclude_each_other() {
        let spans = [case("Q1", "imposed B"), case("Q2", "imposed B")];
        let found = made("EN 1990 6.10", &spans);
        assert_eq!(found, ["6.10: 1.5 Q1 + 1.5 Q2", "6.10: 1.5 Q1", "6.10: 1.5 Q2"]);
        let winds =
            ["W left", "W right"].map(|name| Acting { group: Some("W"), ..case(name, "wind") });
        assert_eq!(made("EN 1990 6.10", &winds), ["6.10: 1.5 W left", "6.10: 1.5 W right"]);
    }

    #[test]
    fn american_combinations() {
        let cases =
            [case("D", "dead"), case("L", "live"), case("S", "snow"), case("Lr", "roof live")];
        let found = made("ASCE 7-16 LRFD", &cases);
        for name in [
            "LRFD 1: 1.4 D",
            "LRFD 2: 1.2 D + 1.6 L + 0.5 S",
            "LRFD 2: 1.2 D + 1.6 L + 0.5 Lr",
            "LRFD 3: 1.2 D + 1.6 S + L",
            "LRFD 5: 0.9 D",
        ] {
            assert!(found.iter().any(|found| found == name), "{name} in {found:?}");
        }
        assert!(!found.iter().any(|name| name.contains("S") && name.contains("Lr")));
        let winds = [case("D", "dead"), case("L", "live"), case("W", "wind")];
        let found = made("ASCE 7-16 ASD", &winds);
        let expected = [
            "ASD 1: D",
            "ASD 2: D + L",
            "ASD 4: D + 0.75 L",
            "ASD 5: D + 0.6 W",
            "ASD 6: D + 0.75 L + 0.45 W",
            "ASD 6: D + 0.45 W",
            "ASD 7: 0.6 D + 0.6 W",
            "ASD 7: 0.6 D",
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn too_many_combinations_are_refused() {
        let (practice, set) = find("EN 1990 6.10").unwrap();
        let cases = vec![case("Q", "imposed B"); 60];
        assert_eq!(expand(practice, set, &cases, false, 1000), Err(TooMany));
    }
    /// EN 1990, table A1.2(B), note 3, requires one factor for all permanent actions of one source. In the
    /// check of static equilibrium, actions of one source may have different factors.
    #[test]
    fn permanent_cases_of_one_source_have_one_factor() {
        let of = |name| Acting { source: Some("own weight"), ..case(name, "permanent") };
        let cases = [of("slab"), of("wall"), case("earth", "permanent")];
        let found = made("EN 1990 6.10", &cases[..2]);
        assert_eq!(found, ["6.10: 1.35 slab + 1.35 wall", "6.10: slab + wall"]);
        assert_eq!(made("EN 1990 6.10", &cases).len(), 4);
        assert_eq!(made("EN 1990 EQU", &cases[..2]).len(), 4);
    }

    /// ASCE/SEI 7, 2.3.6: combination 7 is 0.9 D - Ev + Eh.
    #[test]
    fn the_vertical_earthquake_lifts_in_combination_7() {
        let cases = [
            case("D", "dead"),
            case("Eh", "earthquake horizontal"),
            case("Ev", "earthquake vertical"),
        ];
        let found = made("ASCE 7-22 LRFD", &cases);
        for name in ["LRFD 6: 1.2 D + Eh + Ev", "LRFD 7: 0.9 D + Eh - Ev"] {
            assert!(found.iter().any(|found| found == name), "{name} in {found:?}");
        }
    }

    /// Checks the limit states that `docs/combinations.md` lists. The combination LRFD 5 belongs to two
    /// limit states: strength and equilibrium.
    #[test]
    fn combinations_have_the_limit_states_of_their_set_and_formula() {
        let (practice, set) = find("ASCE 7-16 LRFD").unwrap();
        let cases = [case("D", "dead"), case("W", "wind")];
        let made = expand(practice, set, &cases, false, 1000).unwrap();
        let states =
            |name: &str| made.iter().find(|made| made.name == name).unwrap().limit_states.names();
        assert_eq!(states("LRFD 5: 0.9 D + W"), "STR/GEO or EQU");
        assert_eq!(states("LRFD 4: 1.2 D + W"), "STR/GEO");
    }

    /// EN 1990, annex A2: the partial factor is 1.35 for road traffic, 1.45 for rail traffic and 1.5 for
    /// wind. In set C, it is 1.15 for road traffic and 1.3 for wind.
    #[test]
    fn partial_factors_depend_on_the_action() {
        let cases =
            [case("G", "permanent"), case("T", "road gr1a TS"), case("W", "wind on a bridge")];
        let found = made("EN 1990 A2 STR/GEO B", &cases);
        for name in ["bridge B: 1.35 G + 1.35 T + 0.9 W", "bridge B: G + 1.5 W + 1.0125 T"] {
            assert!(found.iter().any(|found| found == name), "{name} in {found:?}");
        }
        let found = made("EN 1990 A2 STR/GEO C", &cases);
        assert!(found.iter().any(|name| name == "bridge C: G + 1.15 T + 0.78 W"), "{found:?}");
    }

    /// Checks combinations of EN 1990, expressions (6.11b) and (6.12b).
    #[test]
    fn accidental_and_seismic_combinations() {
        let cases = [case("G", "permanent"), case("Q", "imposed B"), case("A", "accidental")];
        let found = made("EN 1990 accidental psi1", &cases);
        assert!(found.contains(&"6.11b: G + 0.5 Q + A".to_owned()), "{found:?}");
        let found = made("EN 1990 accidental psi2", &cases);
        assert!(found.contains(&"6.11b: G + 0.3 Q + A".to_owned()), "{found:?}");
        let cases = [case("G", "permanent"), case("Q", "imposed B"), case("E", "seismic")];
        assert_eq!(made("EN 1990 seismic", &cases), ["6.12b: G + E + 0.3 Q", "6.12b: G + E"]);
    }
}
