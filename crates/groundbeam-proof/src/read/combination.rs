//! Reads `[[combination]]`: factors of load cases, given in the file or by a set of combinations of a code of practice.

use super::band::Factored;
use super::case::Cased;
use super::error::{Read, Reason, fault, out_of_range, wrong};
use super::fields::Section;
use super::number::Decimal;
use super::sets::{self, Acting};
use super::toml::Value;
use crate::{Extent, Load, Scalar};
use std::collections::{BTreeMap, BTreeSet};

/// Maximum number of combinations of a file. A combination counts once for each variant of the ground.
const MOST: usize = 1000;

/// A combination: its name, and the decimal factor of each load case in it.
struct Recipe {
    name: String,
    factors: BTreeMap<String, String>,
}

/// Returns the loads of a combination, without loads that have the factor 0, and its variant of the ground. If
/// `combination` is `None`, returns all loads with their values in the file.
pub(crate) fn select<'g, S: Scalar>(
    root: Section,
    loads: Vec<Cased<S>>,
    grounds: &'g [Factored<S>],
    combination: Option<&str>,
) -> Read<(Vec<Load<S>>, Option<&'g Factored<S>>)> {
    let all = |loads: Vec<Cased<S>>| loads.into_iter().map(|cased| cased.load).collect();
    let Some(wanted) = combination else { return Ok((all(loads), None)) };
    let mut seen = BTreeSet::new();
    let mut names: Vec<&str> = loads.iter().filter_map(|cased| cased.case.as_deref()).collect();
    names.retain(|case| seen.insert(*case));
    let has_caseless = loads.iter().any(|cased| cased.case.is_none());
    let recipes = recipes(root, &names, has_caseless, MOST / grounds.len().max(1))?;
    let mut found = on_grounds(&recipes, grounds).filter(|(name, ..)| name == wanted.trim());
    let (found, again) = (found.next(), found.next());
    let Some((name, recipe, ground)) = found else {
        return fault(root.at, Reason::NoCombination(wanted.to_owned()));
    };
    if again.is_some() {
        return fault(root.at, Reason::Twice(name));
    }
    match recipe {
        Some(recipe) => Ok((factored(loads, recipe)?, ground)),
        None => Ok((all(loads), ground)),
    }
}

/// Name, factors and ground variant of a combination. `None` stands for loads with their values in the file, or for
/// ground without `[foundation.band]`.
type OnGround<'r, 'g, S> = (String, Option<&'r Recipe>, Option<&'g Factored<S>>);

/// Returns every combination of the file on every variant of the ground.
fn on_grounds<'r, 'g, S: Scalar>(
    recipes: &'r [Recipe],
    grounds: &'g [Factored<S>],
) -> impl Iterator<Item = OnGround<'r, 'g, S>> {
    let alone = (recipes.is_empty() && !grounds.is_empty()).then_some(None);
    let combinations = alone.into_iter().chain(recipes.iter().map(Some));
    let on = |recipe: Option<&'r Recipe>| {
        let bare = recipe.filter(|_| grounds.is_empty()).map(|one| (one.name.clone(), None));
        let each = grounds.iter().map(move |ground| {
            let name = recipe.map_or_else(
                || ground.name.clone(),
                |recipe| format!("{}; {}", recipe.name, ground.name),
            );
            (name, Some(ground))
        });
        bare.into_iter().chain(each).map(move |(name, ground)| (name, recipe, ground))
    };
    combinations.flat_map(on)
}

/// Multiplies the loads by the factors of their cases. Omits loads with the factor 0.
fn factored<S: Scalar>(loads: Vec<Cased<S>>, recipe: &Recipe) -> Read<Vec<Load<S>>> {
    let mut combined = Vec::new();
    for Cased { load, case, at } in loads {
        let Some(case) = case else {
            combined.push(load);
            continue;
        };
        let factor = recipe.factors.get(&case).map_or("0", String::as_str);
        if Decimal::whole(factor).is_some_and(|factor| factor.is_zero()) {
            continue;
        }
        let Some(factor) = S::decimal(factor) else {
            return out_of_range(at, "the factor of this load's case is out of range");
        };
        combined.push(scaled(load, factor));
    }
    Ok(combined)
}

fn scaled<S: Scalar>(load: Load<S>, factor: S) -> Load<S> {
    let extent = match load.extent {
        Extent::Point { at, size } => Extent::Point { at, size: size * factor },
        Extent::Distributed { from, to, start, end } => {
            Extent::Distributed { from, to, start: start * factor, end: end * factor }
        }
    };
    Load { extent, ..load }
}

/// Reads every combination of the file. Fails if the file has more than `most` combinations.
fn recipes(root: Section, names: &[&str], has_caseless: bool, most: usize) -> Read<Vec<Recipe>> {
    let known: BTreeSet<&str> = names.iter().copied().collect();
    let mut recipes = Vec::new();
    for table in root.tables("combination")? {
        table.only(&[&["name", "factors", "set", "limit_state"]], &[])?;
        table.exclusive("set", "factors")?;
        table.exclusive("set", "name")?;
        if let Some((set, at)) = table.words("set")? {
            let acting = acting(root, names, at)?;
            let left = most.saturating_sub(recipes.len());
            match sets::expand(set.trim(), &acting, has_caseless, left) {
                Ok(made) => recipes.extend(made.into_iter().map(|made| {
                    let factor = |(case, factor): (usize, String)| (names[case].to_owned(), factor);
                    let factors = made.factors.into_iter().map(factor).collect();
                    Recipe { name: made.name, factors }
                })),
                Err(what) => return wrong(at, what),
            }
            continue;
        }
        let Some((name, _)) = table.words("name")? else { return table.missing("name") };
        let Some(factors) = table.table("factors")? else { return table.missing("factors") };
        let mut written = BTreeMap::new();
        for (case, at, node) in factors.table.entries() {
            let Value::Number(factor) = &node.value else {
                return wrong(node.at, format!("the factor of `{case}` must be a number"));
            };
            if !known.contains(case) {
                return wrong(at, format!("no load belongs to the load case `{case}`"));
            }
            written.insert(case.to_owned(), factor.clone());
        }
        if recipes.len() == most {
            return wrong(table.at, sets::TOO_MANY);
        }
        recipes.push(Recipe { name: name.trim().to_owned(), factors: written });
    }
    Ok(recipes)
}

/// Reads the action of each load case in `names`, for a set of combinations of a code of practice.
fn acting<'t>(root: Section<'t>, names: &[&str], at: usize) -> Read<Vec<Acting<'t>>> {
    let mut described: BTreeMap<&str, Acting> = BTreeMap::new();
    for table in root.tables("case")? {
        table.only(&[&["name", "action", "group", "source"]], &[])?;
        let Some((name, place)) = table.words("name")? else { return table.missing("name") };
        let name = name.trim();
        if described.contains_key(name) {
            return fault(place, Reason::Twice(name.to_owned()));
        }
        let action = table.words("action")?.map_or("", |(action, _)| action);
        let group = table.words("group")?.map(|(group, _)| group.trim());
        let source = table.words("source")?.map(|(source, _)| source.trim());
        described.insert(name, Acting { name, action, group, source });
    }
    let of = |case: &&str| match described.get(*case) {
        Some(acting) => Ok(*acting),
        None => wrong(at, format!("no [[case]] gives the action of load case `{case}`")),
    };
    names.iter().map(of).collect()
}
