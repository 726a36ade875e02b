//! Combinations, from a set and the cases of a file.
//!
//! Lift-off makes superposition false, so no action can be left out because it seems favourable: every subset of
//! the variable cases is made, with every leading action and every factor of the permanent ones.

use super::{Formula, Practice, Set, Share};
use std::collections::BTreeMap;

/// A load case and what acts in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Acting<'a> {
    pub case: &'a str,
    pub action: &'a str,
    /// Of the cases of one group at most one is there at a time.
    pub group: Option<&'a str>,
}

/// More combinations than are solved.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct TooMany;

/// A combination as a set makes it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Made {
    /// `6.10: 1.35 G + 1.5 Q + 0.9 W`
    pub name: String,
    /// Cases by their number, in the order of the name, none with the factor 0.
    pub factors: Vec<(usize, f64)>,
}

/// The combinations of a set, each once, at most `most` of them.
pub(crate) fn expand(
    practice: &Practice,
    set: &Set,
    cases: &[Acting],
    most: usize,
) -> Result<Vec<Made>, TooMany> {
    let mut made = Vec::new();
    let mut seen = BTreeMap::new();
    for formula in &set.formulas {
        for (leads, terms) in formula.terms(practice, cases) {
            let label = &formula.label;
            let mut found = Expansion { cases, most, label, leads, made, seen };
            found.permanent(formula, &terms, 0, &mut Vec::new())?;
            (made, seen) = (found.made, found.seen);
        }
    }
    Ok(made)
}

/// Of each term one action at a time, with its factor, or none.
type Terms<'a> = Vec<Vec<(&'a str, f64)>>;

impl Formula {
    /// The formula's terms: once, or once for each action that leads, which then must be there, and once with none.
    fn terms<'a>(&'a self, practice: &'a Practice, cases: &[Acting]) -> Vec<(bool, Terms<'a>)> {
        let written: Terms = self
            .terms
            .iter()
            .map(|term| term.iter().map(|(action, factor)| (action.as_str(), *factor)).collect())
            .collect();
        let variable: Vec<(&str, [f64; 3])> = practice
            .actions
            .iter()
            .filter(|action| cases.iter().any(|case| case.action == action.name))
            .filter_map(|action| Some((action.name.as_str(), action.psi?)))
            .collect();
        let term = |share: Option<Share>, (action, psi): (&'a str, [f64; 3])| {
            share.map(|share| vec![(action, share.of(psi))])
        };
        if self.leading.is_none() {
            let others = variable.iter().filter_map(|action| term(self.accompanying, *action));
            return vec![(false, written.into_iter().chain(others).collect())];
        }
        let leads = |leader: &(&'a str, [f64; 3])| {
            let others = variable.iter().filter(|other| other.0 != leader.0);
            let others = others.filter_map(|action| term(self.accompanying, *action));
            (true, term(self.leading, *leader).into_iter().chain(others).collect())
        };
        variable.iter().map(leads).chain([(false, Vec::new())]).collect()
    }
}

impl Share {
    /// A product of decimals, without what binary numbers add to it.
    fn of(self, psi: [f64; 3]) -> f64 {
        let product = self.factor * self.psi.and_then(|i| psi.get(i)).unwrap_or(&1.0);
        (product * 1e9).round() / 1e9
    }
}

struct Expansion<'a> {
    cases: &'a [Acting<'a>],
    most: usize,
    label: &'a str,
    /// Whether the first term must be there.
    leads: bool,
    made: Vec<Made>,
    /// The factors of all cases of what was made, by their bits.
    seen: BTreeMap<Vec<u64>, ()>,
}

impl Expansion<'_> {
    /// Every factor of every permanent case, one case after the other.
    fn permanent(
        &mut self,
        formula: &Formula,
        terms: &Terms,
        case: usize,
        chosen: &mut Vec<(usize, f64)>,
    ) -> Result<(), TooMany> {
        let Some(acting) = self.cases.get(case) else {
            return self.variable(terms, self.leads, chosen);
        };
        let Some(factors) = formula.always.get(acting.action) else {
            return self.permanent(formula, terms, case + 1, chosen);
        };
        for &factor in factors {
            chosen.push((case, factor));
            self.permanent(formula, terms, case + 1, chosen)?;
            chosen.pop();
        }
        Ok(())
    }

    /// Of the first term each action, or none unless it must be there; then the others.
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

    /// Every subset of an action's cases that is not empty: an action may be spread over several.
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
        let mut key = vec![0; self.cases.len()];
        for (case, factor) in chosen {
            key[*case] = factor.to_bits();
        }
        if chosen.is_empty() || self.seen.insert(key, ()).is_some() {
            return Ok(());
        }
        if self.made.len() == self.most {
            return Err(TooMany);
        }
        let term = |(case, factor): &(usize, f64)| {
            let case = self.cases[*case].case;
            if *factor == 1.0 { case.to_owned() } else { format!("{factor} {case}") }
        };
        let sum: Vec<String> = chosen.iter().map(term).collect();
        let name = format!("{}: {}", self.label, sum.join(" + "));
        self.made.push(Made { name, factors: chosen.to_vec() });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::find;
    use super::*;

    fn case<'a>(case: &'a str, action: &'a str) -> Acting<'a> {
        Acting { case, action, group: None }
    }

    fn made(set: &str, cases: &[Acting]) -> Vec<String> {
        let (practice, set) = find(set).unwrap();
        let made = expand(practice, set, cases, 1000).unwrap();
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
        // With each of two factors of G: Q or W alone, either with the other, none.
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
    fn too_many_are_refused_early() {
        let (practice, set) = find("EN 1990 6.10").unwrap();
        let cases = vec![case("Q", "imposed B"); 60];
        assert_eq!(expand(practice, set, &cases, 1000), Err(TooMany));
    }
}
