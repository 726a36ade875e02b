//! Combines the load cases of a file according to the rules of a code of practice.
//!
//! Superposition is not valid with lift-off. So every subset of the variable cases is combined with every leading
//! action and every factor of the permanent cases.

use super::codes::{Action, Code, Formula, Micro, Set, UNIT};
use super::{asce, eurocode};

static CODES: [&Code; 6] = [
    &eurocode::BUILDINGS,
    &eurocode::BRITISH_BUILDINGS,
    &eurocode::BRIDGES,
    &eurocode::BRITISH_BRIDGES,
    &asce::OF_2016,
    &asce::OF_2022,
];

pub(crate) const TOO_MANY: &str = "the file defines more than 1000 combinations";

/// A load case and its action.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Acting<'a> {
    pub name: &'a str,
    pub action: &'a str,
    /// Group of the load case. At most one case of a group is present at a time.
    pub group: Option<&'a str>,
    /// Source of the load case. Permanent cases from the same source have the same factor.
    pub source: Option<&'a str>,
}

/// A combination from a set: its name, and the index and the decimal factor of each load case.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Made {
    pub name: String,
    pub factors: Vec<(usize, String)>,
}

/// Returns the combinations of load cases that a set defines, without duplicates. If the file has loads without a case
/// (`has_caseless`), a combination may consist of them alone.
pub(crate) fn expand(
    name: &str,
    cases: &[Acting],
    has_caseless: bool,
    most: usize,
) -> Result<Vec<Made>, String> {
    let (code, set) = find(name).ok_or("unknown set of combinations")?;
    for case in cases {
        let action = code.actions.iter().find(|action| action.name == case.action);
        let action =
            action.ok_or("a load case has an action that this code of practice does not define")?;
        if set.formulas.iter().any(|formula| lacks(action, formula)) {
            return Err(format!(
                "the code of practice gives no partial factor for the action `{}` in this set of combinations",
                action.name
            ));
        }
    }
    let (made, chosen, rows) = (Vec::new(), Vec::new(), Vec::new());
    let mut found = Expansion { cases, has_caseless, most, made, chosen, rows };
    for formula in set.formulas {
        let always: Vec<Vec<Micro>> =
            cases.iter().map(|case| always(code, formula, case.action)).collect();
        for (must_act, terms) in variable_terms(formula, code.actions, cases) {
            found.permanent(formula, &always, &terms, must_act, 0)?;
        }
    }
    if found.made.is_empty() {
        return Err("the set makes no combination".to_owned());
    }
    let name = |(label, factors): (&str, Vec<(usize, Micro)>)| {
        let term = |(case, factor): &(usize, Micro)| match *factor {
            UNIT => cases[*case].name.to_owned(),
            factor => format!("{} {}", decimal(factor), cases[*case].name),
        };
        let mut sum: Vec<String> = factors.iter().map(term).collect();
        if sum.is_empty() {
            sum.push("loads without a case".to_owned());
        }
        let factors = factors.into_iter().map(|(case, factor)| (case, decimal(factor))).collect();
        let sum = sum.join(" + ").replace("+ -1 ", "- ").replace("+ -", "- ");
        Made { name: format!("{label}: {sum}"), factors }
    };
    Ok(found.made.into_iter().map(name).collect())
}

fn find(name: &str) -> Option<(&'static Code, &'static Set)> {
    let all = CODES.into_iter().flat_map(|code| code.sets.iter().map(move |set| (code, set)));
    all.into_iter().find(|(_, set)| set.names.contains(&name))
}

/// Whether an expression needs a partial factor of an action for which the code gives none.
fn lacks(action: &Action, formula: &Formula) -> bool {
    let needs = action.is_permanent || action.psi.is_some();
    needs && formula.letter.is_some() && gammas(action, formula).is_none()
}

/// The partial factors of an action in an expression.
fn gammas(action: &Action, formula: &Formula) -> Option<&'static [Micro]> {
    let of_letter = |(letter, _): &&(&str, &[Micro])| Some(*letter) == formula.letter;
    action.gammas.iter().find(of_letter).map(|(_, factors)| *factors)
}

/// The factors to be tried for an action that always acts; an empty list for every other action.
fn always(code: &Code, formula: &Formula, action: &str) -> Vec<Micro> {
    if let Some((_, factors)) = formula.always.iter().find(|(named, _)| *named == action) {
        return factors.to_vec();
    }
    let known = code.actions.iter().find(|known| known.is_permanent && known.name == action);
    let Some(known) = known else { return Vec::new() };
    let mut factors = gammas(known, formula).unwrap_or(&[UNIT]).to_vec();
    if let Some(unfavourable) = factors.first_mut() {
        *unfavourable = *unfavourable * formula.xi / UNIT;
    }
    factors
}

/// A factor as a decimal without superfluous zeros.
fn decimal(factor: Micro) -> String {
    let sign = if factor < 0 { "-" } else { "" };
    let (whole, part) = (factor.abs() / UNIT, factor.abs() % UNIT);
    match format!("{part:06}").trim_end_matches('0') {
        "" => format!("{sign}{whole}"),
        part => format!("{sign}{whole}.{part}"),
    }
}

/// The terms of an expression. Each term lists its possible actions with their factors.
type Lists = [Vec<(&'static str, Micro)>];

/// Returns lists of terms of an expression: one for each leading action, and one without a leading action. A
/// combination contains at most one action of each term. If the flag of a list is true, an action of its first term
/// must act.
fn variable_terms(
    formula: &Formula,
    actions: &'static [Action],
    cases: &[Acting],
) -> Vec<(bool, Vec<Vec<(&'static str, Micro)>>)> {
    let share = |which: Option<Option<usize>>, action: &'static Action| {
        let (which, psi) = (which?, action.psi?);
        let psi = which.map_or(UNIT, |i| psi.get(i).copied().unwrap_or(UNIT));
        let gamma = gammas(action, formula).and_then(|factors| factors.first()).unwrap_or(&UNIT);
        Some(vec![(action.name, gamma * psi / UNIT)])
    };
    let is_given = |action: &&Action| cases.iter().any(|case| case.action == action.name);
    let variable: Vec<&'static Action> =
        actions.iter().filter(|action| action.psi.is_some()).filter(is_given).collect();
    let written: Vec<Vec<_>> = formula.terms.iter().map(|term| term.to_vec()).collect();
    let others = |leader: Option<&str>| {
        let others = variable.iter().filter(|action| Some(action.name) != leader);
        let shares = others.filter_map(|action| share(formula.accompanying, action));
        written.iter().cloned().chain(shares).collect::<Vec<_>>()
    };
    if formula.leading.is_none() {
        return vec![(formula.needs_first, others(None))];
    }
    let leads = |action: &&'static Action| {
        let leader = share(formula.leading, action);
        (true, leader.into_iter().chain(others(Some(action.name))).collect())
    };
    variable.iter().map(leads).chain([(false, written.clone())]).collect()
}

struct Expansion<'a> {
    cases: &'a [Acting<'a>],
    has_caseless: bool,
    most: usize,
    made: Vec<(&'static str, Vec<(usize, Micro)>)>,
    chosen: Vec<(usize, Micro)>,
    /// For each permanent load case: the source of its load, such as "own weight", and the index of the partial factor
    /// in use.
    rows: Vec<(Option<&'a str>, usize)>,
}

impl Expansion<'_> {
    /// Tries each factor of each permanent case, starting at the load case with the index `case`.
    fn permanent(
        &mut self,
        formula: &Formula,
        always: &[Vec<Micro>],
        terms: &Lists,
        must_act: bool,
        case: usize,
    ) -> Result<(), &'static str> {
        let (Some(acting), Some(factors)) = (self.cases.get(case), always.get(case)) else {
            return self.variable(formula.label, terms, must_act);
        };
        if factors.is_empty() {
            return self.permanent(formula, always, terms, must_act, case + 1);
        }
        let source = acting.source;
        let same = self.rows.iter().find(|(other, _)| source.is_some() && *other == source);
        let bound = same.filter(|_| !formula.by_parts).map(|(_, row)| *row);
        let last = factors.len().saturating_sub(1);
        for (row, factor) in factors.iter().enumerate() {
            if bound.is_some_and(|bound| row != bound.min(last)) {
                continue;
            }
            let before = self.chosen.len();
            self.chosen.extend((*factor != 0).then_some((case, *factor)));
            self.rows.push((source, row));
            self.permanent(formula, always, terms, must_act, case + 1)?;
            self.rows.pop();
            self.chosen.truncate(before);
        }
        Ok(())
    }

    /// Completes the combination in all possible ways with at most one action of each term in `terms`. If `must_act` is
    /// true, an action of the first term must act.
    fn variable(
        &mut self,
        label: &'static str,
        terms: &Lists,
        must_act: bool,
    ) -> Result<(), &'static str> {
        let Some((term, rest)) = terms.split_first() else { return self.keep(label) };
        for (action, factor) in term.iter().filter(|(_, factor)| *factor != 0) {
            let acts = |i: &usize| self.cases[*i].action == *action;
            let of_it: Vec<usize> = (0..self.cases.len()).filter(acts).collect();
            self.subsets(label, &of_it, *factor, rest, self.chosen.len())?;
        }
        if must_act { Ok(()) } else { self.variable(label, rest, false) }
    }

    /// Tries each non-empty subset of the load cases of an action.
    fn subsets(
        &mut self,
        label: &'static str,
        of_it: &[usize],
        factor: Micro,
        rest: &Lists,
        before: usize,
    ) -> Result<(), &'static str> {
        let Some((case, others)) = of_it.split_first() else {
            let is_empty = self.chosen.len() == before;
            return if is_empty { Ok(()) } else { self.variable(label, rest, false) };
        };
        let group = self.cases[*case].group;
        let is_taken = |(other, _): &(usize, Micro)| self.cases[*other].group == group;
        if group.is_none() || !self.chosen.iter().any(is_taken) {
            self.chosen.push((*case, factor));
            self.subsets(label, others, factor, rest, before)?;
            self.chosen.pop();
        }
        self.subsets(label, others, factor, rest, before)
    }

    /// Stores the current combination unless it is a duplicate.
    fn keep(&mut self, label: &'static str) -> Result<(), &'static str> {
        let mut sorted = self.chosen.clone();
        sorted.sort_unstable();
        let is_same = |(_, other): &(&str, Vec<(usize, Micro)>)| {
            other.len() == sorted.len() && sorted.iter().all(|entry| other.contains(entry))
        };
        if (sorted.is_empty() && !self.has_caseless) || self.made.iter().any(is_same) {
            return Ok(());
        }
        if self.made.len() == self.most {
            return Err(TOO_MANY);
        }
        self.made.push((label, self.chosen.clone()));
        Ok(())
    }
}
