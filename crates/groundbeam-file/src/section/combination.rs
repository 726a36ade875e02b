//! Reads `[[case]]` and `[[combination]]`.

use crate::case_names::{self, NO_LOAD};
use crate::code;
use crate::combination::{MOST, Recipe};
use crate::fault::Fault;
use crate::keys::{Table, Value, Words, key, text, words};
use crate::moving::MovingTrain;
use crate::number::Decimal;
use crate::quantity::{self, REACH};
use crate::reader::Reader;
use crate::sets::{self, Acting, Made, Practice, Set};
use crate::table::Section;
use groundbeam::{
    Load,
    design::{LimitState, LimitStates},
};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

pub(super) static LIMIT_STATES: Words = Words {
    all: || LimitState::ALL.map(LimitState::name).to_vec(),
    also: &[
        ("STR/GEO", &["str", "geo", "uls", "ultimate", "strength", "lrfd"]),
        ("EQU", &["equilibrium", "stability", "overturning"]),
        ("SLS characteristic", &["characteristic", "sls", "serviceability", "rare"]),
        ("SLS frequent", &["frequent"]),
        ("SLS quasi-permanent", &["quasi-permanent", "quasi permanent", "long term"]),
        ("allowable stress", &["asd", "allowable", "service"]),
    ],
    message: "`{}` is not a limit state",
    hint: "the limit states: {}",
};

/// Reads the limit states under `key`.
pub(super) fn limit_states(reader: &mut Reader, table: &Section, key: &str) -> Option<LimitStates> {
    let states = reader.words(table, key)?;
    let states: Vec<LimitState> = states.into_iter().filter_map(LimitState::named).collect();
    Some(LimitStates::of(&states))
}

pub(super) static CASE: Table = Table {
    name: "[[case]]",
    keys: &[
        text("name", "Q", "The name of the load case, as in the key `case` of its loads.").needed(),
        key(
            "action",
            Value::Name("imposed B", sets::actions),
            "The type of action, in the terms of the code of practice.",
        )
        .also(&["type", "kind", "category", "nature"]),
        text("group", "wind", "Cases of one group never act together.")
            .also(&["exclusive", "alternative"]),
        text(
            "source",
            "own weight",
            "Permanent cases of one source share one partial factor; default: each case has its own factor.",
        )
        .also(&["origin"]),
    ],
};

pub(super) static TABLE: Table = Table {
    name: "[[combination]]",
    keys: &[
        text("name", "ULS 1", "The name of the combination; it must not be given with `set`."),
        key("factors", Value::Factors, "The factors of the load cases; default of each factor: 0.")
            .also(&["factor", "coefficients"]),
        key(
            "set",
            Value::Name("EN 1990 6.10", sets::spellings),
            "A set of combinations of a code of practice.",
        )
        .also(&["code", "standard"]),
        words(
            "limit_state",
            &LIMIT_STATES,
            "The limit state; default: the limit state of the set. Without a limit state, all checks are carried out.",
        )
        .also(&["limit_states", "design_situation", "state"]),
    ],
};

/// Data of `[[case]]`.
struct Described<'a> {
    name: &'a str,
    action: Option<(&'a str, Range<usize>)>,
    group: Option<&'a str>,
    source: Option<&'a str>,
}

/// Reads the combinations of the file in order, and replaces each set by its combinations. Each combination
/// will be solved with `grounds` pairs of factors on k and μ.
pub(super) fn read(
    reader: &mut Reader,
    root: &Section,
    loads: &[Load],
    cases: &[Option<String>],
    trains: &[MovingTrain],
    grounds: usize,
) -> Vec<Recipe> {
    let mut names = case_names::names(cases);
    for case in trains.iter().filter_map(|train| train.case.as_deref()) {
        if !names.contains(&case) {
            names.push(case);
        }
    }
    names.retain(|name| !name.is_empty());
    let described = describe(reader, root, &names);
    let has_others =
        cases.iter().chain(trains.iter().map(|train| &train.case)).any(Option::is_none);
    let (wanting, made) = (Vec::new(), Vec::new());
    let mut file = File { loads, cases, names, has_others, described, grounds, wanting, made };
    let mut recipes: Vec<Recipe> = Vec::new();
    let mut taken: Vec<(String, Range<usize>)> = Vec::new();
    for table in reader.tables(root, "combination") {
        let name = named(reader, &table, &mut taken);
        let states = limit_states(reader, &table, "limit_state");
        match (table.value("set"), table.value("factors")) {
            (Some(set), None) => {
                if let Some((_, span)) = &name {
                    let hint = "a set gives names to its combinations: leave `name` out";
                    reader.exclusive(("name", span), ("set", &set.span()), hint);
                }
                file.make(reader, &table, states, &mut recipes);
            }
            (Some(set), Some(factors)) => {
                let hint = "give `set` and `factors` in separate [[combination]] tables";
                reader.exclusive(("set", &set.span()), ("factors", &factors.span()), hint);
            }
            (None, factors) => {
                if table.value("name").is_none() {
                    reader.missing(&table, &["name", "set"], "name", "name = \"ULS 1\"");
                }
                let factors = match factors {
                    Some(factors) => file.factors(reader, factors),
                    None => {
                        let example = "factors = { G = 1.35, Q = 1.5 }";
                        reader.missing(&table, &["factors", "set"], "factors", example);
                        Vec::new()
                    }
                };
                if recipes.len() == file.most() {
                    let hint = "write the other combinations in another file";
                    file.too_many(reader, table.span.clone(), hint);
                    break;
                }
                let name = name.map_or_else(String::new, |(name, _)| name.to_owned());
                let limit_states = states.unwrap_or_default();
                let (set, eurocode) = (None, false);
                recipes.push(Recipe { name, factors, limit_states, set, eurocode });
            }
        }
    }
    for (name, span) in taken {
        if file.made.contains(&name) {
            let message = format!("a combination of a set already has the name `{name}`");
            let hint = "give each combination a name of its own";
            reader.report(Fault::new(code::REPEATED, span, message, "", hint));
        }
    }
    recipes
}

/// Reads the tables `[[case]]`, and reports each case without a load.
fn describe<'a>(reader: &mut Reader, root: &Section<'a>, names: &[&str]) -> Vec<Described<'a>> {
    let mut described = Vec::new();
    let mut taken = Vec::new();
    let actions = sets::actions();
    for table in reader.tables(root, "case") {
        let name = named(reader, &table, &mut taken);
        let action = reader.text(&table, "action");
        if let Some(word @ (action, _)) = &action
            && !actions.contains(action)
        {
            let message = "`{}` is not an action of any code of practice";
            reader.unknown_word(word.clone(), message, &actions, "the actions: {}");
        }
        let group = reader.text(&table, "group").map(|(group, _)| group.trim());
        let source = reader.text(&table, "source").map(|(source, _)| source.trim());
        let Some((name, span)) = name else { continue };
        if !names.contains(&name) {
            unknown_case(reader, name, span, names);
        }
        described.push(Described { name, action, group, source });
    }
    described
}

/// Reads the `name` of a table, and reports a name that another table of this kind already has. Returns
/// `None` if the name is absent or empty.
fn named<'a>(
    reader: &mut Reader,
    table: &Section<'a>,
    taken: &mut Vec<(String, Range<usize>)>,
) -> Option<(&'a str, Range<usize>)> {
    let (name, span) = reader.text(table, "name")?;
    let name = name.trim();
    if name.is_empty() {
        let message = format!("the name of {} is empty", table.name());
        let hint = format!("write a name, as in {}", reader.line(table.keys, "name"));
        reader.report(Fault::new(code::EMPTY_NAME, span, message, "", hint));
        return None;
    }
    match taken.iter().find(|(other, _)| other == name) {
        Some((_, first)) => {
            let message = format!("two {} have the name `{name}`", table.name());
            let hint = "give each a name of its own";
            let fault = Fault::new(code::REPEATED, span.clone(), message, "", hint);
            reader.report_with(fault, first.clone(), "the first of them");
        }
        None => taken.push((name.to_owned(), span.clone())),
    }
    Some((name, span))
}

fn unknown_case(reader: &mut Reader, name: &str, span: Range<usize>, names: &[&str]) {
    reader.unknown_word((name, span), NO_LOAD, names, case_names::otherwise(names));
}

/// Loads and load cases of a model file, from which its load combinations are made.
struct File<'a> {
    loads: &'a [Load],
    cases: &'a [Option<String>],
    /// Names of the cases, each once, in the order of the loads.
    names: Vec<&'a str>,
    /// Whether at least one load or train has no case.
    has_others: bool,
    described: Vec<Described<'a>>,
    /// Number of pairs of factors on k and μ with which every combination is solved.
    grounds: usize,
    /// Load cases whose missing or unsuitable action has been reported.
    wanting: Vec<&'a str>,
    /// Names of the combinations that come from sets.
    made: Vec<String>,
}

impl<'a> File<'a> {
    /// Reads a table of factors, `factors = { G = 1.35, Q = 1.5 }`.
    fn factors(&self, reader: &mut Reader, value: &Spanned<DeValue>) -> Vec<(String, f64)> {
        let DeValue::Table(table) = value.get_ref() else {
            let message = "`factors` must be a table of load cases and their factors".to_owned();
            let hint = "write for example factors = { G = 1.35, Q = 1.5 }".to_owned();
            reader.wrong_type(value, message, hint);
            return Vec::new();
        };
        in_order(table).into_iter().filter_map(|entry| self.factor(reader, entry)).collect()
    }

    fn factor(
        &self,
        reader: &mut Reader,
        (name, at, value): (&str, Range<usize>, &Spanned<DeValue>),
    ) -> Option<(String, f64)> {
        if !self.names.contains(&name) {
            unknown_case(reader, name, at, &self.names);
        }
        let factor = number(reader, name, value)?;
        let of_it = self.cases.iter().zip(self.loads);
        let mut of_it = of_it.filter(|(case, _)| case.as_deref() == Some(name));
        if of_it.any(|(_, load)| is_finite(load) && !is_within_reach(&load.scaled(factor))) {
            let message =
                format!("with this factor a load of the case `{name}` is too large or too small");
            reader.report(Fault::new(code::NOT_FINITE, value.span(), message, "", REACH));
        }
        Some((name.to_owned(), factor))
    }

    /// Adds the combinations of a set to `recipes`. The limit states `states` of the file, if given,
    /// replace the limit states of the set.
    fn make(
        &mut self,
        reader: &mut Reader,
        table: &Section,
        states: Option<LimitStates>,
        recipes: &mut Vec<Recipe>,
    ) {
        let Some((written, span)) = reader.text(table, "set") else { return };
        let Some((practice, set)) = sets::find(written.trim()) else {
            if let [first, others @ ..] = &sets::meant(written.trim())[..] {
                let message = format!("`{}` may mean several sets of combinations", written.trim());
                let others: String = others.iter().map(|name| format!(" or `{name}`")).collect();
                let hint = format!("write `{first}`{others}");
                reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
                return;
            }
            let message = "there is no set of combinations `{}`";
            reader.unknown_word((written, span), message, &sets::names(), "the sets: {}");
            return;
        };
        let Some(acting) = self.acting(reader, practice, set, &span) else { return };
        let most = self.most().saturating_sub(recipes.len());
        match sets::expand(practice, set, &acting, self.has_others, most) {
            Ok(made) if made.is_empty() => {
                let message =
                    format!("the set `{}` has no combination for these load cases", set.name);
                let hint = match set.needed() {
                    Some(action) => {
                        format!(
                            "add the loads of a case with action = \"{action}\", or leave out this set of combinations"
                        )
                    }
                    None => {
                        "the set gives every load the factor 0: leave out this set of combinations"
                            .to_owned()
                    }
                };
                reader.report(Fault::new(code::MISSING, span, message, "", hint));
            }
            Ok(made) => {
                if let Some(again) = made.iter().find(|made| self.made.contains(&made.name)) {
                    let message =
                        format!("an earlier `set` contains the combination `{}`", again.name);
                    let hint = "write each set only once";
                    reader.report(Fault::new(code::REPEATED, span, message, "", hint));
                }
                for Made { name, factors, limit_states } in made {
                    let factors = factors.iter().map(|&(i, f)| (acting[i].case.to_owned(), f));
                    let factors = factors.collect();
                    let limit_states = states.unwrap_or(limit_states);
                    self.made.push(name.clone());
                    let (set, eurocode) = (Some(&*set.name), practice.eurocode);
                    recipes.push(Recipe { name, factors, limit_states, set, eurocode });
                }
            }
            Err(sets::TooMany) => {
                let hint = "give cases that never act together, as winds from two sides, one \
                            `group`, or write the combinations that matter with `factors`";
                self.too_many(reader, span, hint);
            }
        }
    }

    /// Maximum number of combinations in the file, if each is solved with all pairs of factors on k and μ.
    fn most(&self) -> usize {
        MOST / self.grounds
    }

    fn too_many(&self, reader: &mut Reader, span: Range<usize>, hint: &str) {
        let each = match self.grounds {
            1 => String::new(),
            grounds => format!(" for each of {grounds} pairs of factors on k and mu"),
        };
        let message = format!("the file has more than {} combinations{each}", self.most());
        reader.report(Fault::new(code::TOO_MANY, span, message, "", hint));
    }

    /// Returns the load cases with their types of action. Returns `None` if a load case has no type of
    /// action, or one that the design code of `set` does not define.
    fn acting(
        &mut self,
        reader: &mut Reader,
        practice: &Practice,
        set: &Set,
        span: &Range<usize>,
    ) -> Option<Vec<Acting<'a>>> {
        let mut acting = Vec::new();
        for &case in &self.names {
            let described = self.described.iter().find(|described| described.name == case);
            let action = described.and_then(|described| described.action.clone());
            let known = action.as_ref().is_some_and(|(a, _)| practice.actions().any(|b| b == *a));
            if let (true, Some((action, _))) = (known, &action) {
                let group = described.and_then(|described| described.group);
                let source = described.and_then(|described| described.source);
                if let Some(letter) = practice.lacks(set, action) {
                    let message = format!(
                        "`{}` cannot be used: no partial factor of set {letter} is known for `{action}`",
                        set.name
                    );
                    let hint = "no public source confirms this partial factor; write the combinations with `factors`";
                    reader.report(Fault::new(code::MISSING, span.clone(), message, "", hint));
                }
                acting.push(Acting { case, action, group, source });
            } else if !self.wanting.contains(&case) {
                self.wanting.push(case);
                wanting(reader, (practice, set, span), case, action);
            }
        }
        (acting.len() == self.names.len()).then_some(acting)
    }
}

/// Reports a load case without a type of action, or with a type of action that the design code of `set` does not define.
fn wanting(
    reader: &mut Reader,
    (practice, set, span): (&Practice, &Set, &Range<usize>),
    case: &str,
    action: Option<(&str, Range<usize>)>,
) {
    let known: Vec<&str> = practice.actions().collect();
    let all = format!("the actions of {}: {}", practice.code, known.join(", "));
    match action {
        None => {
            let set = &set.name;
            let message = format!("`{set}` needs the type of action of the case `{case}`");
            let hint = format!("add a [[case]] with name = \"{case}\" and its `action`; {all}");
            reader.report(Fault::new(code::MISSING, span.clone(), message, "", hint));
        }
        // An action that belongs to no code of practice has been reported already.
        Some((action, _)) if !sets::actions().contains(&action) => {}
        Some((action, at)) => {
            let message = format!("`{action}` is not an action of {}", practice.code);
            let fault = Fault::new(code::UNKNOWN_WORD, at, message, "", all);
            reader.report_with(fault, span.clone(), "a set of this code");
        }
    }
}

/// Returns the entries of a table in the order in which the file lists them.
fn in_order<'t>(table: &'t DeTable) -> Vec<(&'t str, Range<usize>, &'t Spanned<DeValue<'t>>)> {
    let mut entries: Vec<_> =
        table.iter().map(|(key, value)| (key.get_ref().as_ref(), key.span(), value)).collect();
    entries.sort_by_key(|(_, span, _)| span.start);
    entries
}

/// Reads the factor of the case `name`, a finite number without a unit.
fn number(reader: &mut Reader, name: &str, value: &Spanned<DeValue>) -> Option<f64> {
    let number = match value.get_ref() {
        DeValue::Integer(integer) if integer.radix() == 10 => Decimal::read(integer.as_str()),
        DeValue::Float(float) => Decimal::read(float.as_str()),
        _ => {
            let message = format!("the factor of `{name}` must be a number");
            let hint =
                format!("write the factor without quotes and without a unit, as in {name} = 1.5");
            reader.wrong_type(value, message, hint);
            return None;
        }
    };
    match number.map(|(number, _)| number.to_f64()) {
        Some(number) if number.is_finite() => Some(number),
        _ => {
            let message = format!("the factor of `{name}` is not a finite number");
            let hint = format!("write for example {name} = 1.5");
            reader.report(Fault::new(code::NOT_FINITE, value.span(), message, "", hint));
            None
        }
    }
}

fn is_finite(load: &Load) -> bool {
    load.extent().sizes().into_iter().all(f64::is_finite)
}

fn is_within_reach(load: &Load) -> bool {
    load.extent().sizes().into_iter().all(quantity::is_within_reach)
}
