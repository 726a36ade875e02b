//! Writes the proven statements about a result document as text.

use super::sheet::{Sheet, Tone};
use crate::number::{above, significant};
use crate::numbers::Numbers;
use crate::quantity::{Kind, Unit, Units};
use crate::verified::{LeftOut, ModelOf, Named, Verified};
use groundbeam::Solution;
use groundbeam::proof::{Bound, NotProven, Verification};

/// Maximum number of listed names. The report states how many names were omitted.
const MOST_NAMES: usize = 10;

/// The report of `groundbeam verify`.
pub fn verified(verified: &Verified, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    if let Some(why) = &verified.other_model {
        sheet.toned_row("Not proven", why, Tone::Bad);
        sheet.row(
            "",
            "The statements below compare the numbers of the document, in the units of the model file, with the solution of \
             this model.",
        );
    }
    if let Some(LeftOut { all, names }) = &verified.left_out {
        let shown: Vec<&str> = names.iter().take(MOST_NAMES).map(String::as_str).collect();
        let more = match names.len() - shown.len() {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let words = format!(
            "{} of {all} combinations of the file; left out: {}{more}",
            all - names.len(),
            shown.join(", ")
        );
        sheet.toned_row("Document", &words, Tone::Doubtful);
    }
    for named in &verified.results {
        if let Some(name) = &named.combination {
            sheet.heading(name);
        }
        result(&mut sheet, named, verified.units);
        sheet.blank();
    }
    sheet.finish()
}

/// The proven statements about a result, without the error bounds. The report of the result contains the bounds.
pub fn proof(named: &Named, units: Units, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    sheet.heading("Proof");
    proven(&mut sheet, named, units);
    sheet.finish()
}

/// The values of several results with their error bounds, and the proven statements about each result.
pub fn proofs<'a>(
    answers: impl Iterator<Item = (Option<&'a Solution>, &'a Named)>,
    units: Units,
    colour: bool,
) -> String {
    let mut sheet = Sheet::new(colour);
    for (i, (solution, named)) in answers.enumerate() {
        if i > 0 {
            sheet.blank();
        }
        sheet.heading(&format!("Proof: {}", named.combination.as_deref().unwrap_or_default()));
        if let Some(solution) = solution {
            let numbers = Numbers::plain(solution, units).with_proof(Some(named));
            super::results(&mut sheet, solution, &numbers);
            sheet.blank();
        }
        proven(&mut sheet, named, units);
    }
    sheet.finish()
}

/// Adds the proven statements on existence, uniqueness, contact set and energy, and lists the quantities
/// without an error bound or with a large error bound.
pub(crate) fn proven(sheet: &mut Sheet, named: &Named, units: Units) {
    let found = match &named.found {
        Err(why) => return sheet.toned_row("Not proven", &reason(why), Tone::Bad),
        Ok(found) => found,
    };
    verdict(sheet, named, found, "the errors are at most the printed bounds");
    let proof = &found.proof;
    let exists = match proof.bounds.deflection.error.is_finite() {
        true => "an equilibrium exists",
        false => "existence is not proven",
    };
    let unique = match &proof.unique {
        Ok(()) => "it is the only one".to_owned(),
        Err(why) => format!("uniqueness is not proven: {}", reason(why)),
    };
    sheet.row("Equilibrium", &format!("{exists}; {unique}"));
    match &proof.contact {
        Ok(set) => {
            let words = match set.regions.len() {
                1 => {
                    "exactly one contact region or point: the one listed in the results".to_owned()
                }
                n => format!("exactly {n} contact regions and points: those listed in the results"),
            };
            sheet.row("Contact", &words);
        }
        Err(why) => sheet.row("Contact", &format!("not proven: {}", reason(why))),
    }
    energy(sheet, found, units);
    let names = |of: &dyn Fn(Bound) -> bool| {
        let named = found.named().into_iter().filter(|(_, bound)| of(*bound));
        let labels: Vec<String> = named.map(|(name, _)| label(name).to_lowercase()).collect();
        (!labels.is_empty()).then(|| labels.join(", "))
    };
    if let Some(names) = names(&|bound| !bound.error.is_finite()) {
        let why = found.without_bound().map_or(String::new(), |why| format!(": {}", reason(why)));
        sheet.row("No bound", &format!("{names}{why}"));
    }
    if let Some(names) = names(&|bound| bound.error.is_finite() && !bound.is_small()) {
        sheet.row(
            "Not small",
            &format!("error bounds above a millionth of the scale of the quantity: {names}"),
        );
    }
}

fn result(sheet: &mut Sheet, named: &Named, units: Units) {
    match &named.found {
        Err(why) => {
            sheet.toned_row("Not proven", &reason(why), Tone::Bad);
        }
        Ok(found) => {
            verdict(sheet, named, found, "the errors are at most the bounds below");
            bounds(sheet, found, units);
            checked(sheet, found);
        }
    }
}

/// The reason why a statement is not proven, with the position of the failure if there is one.
pub(crate) fn reason(why: &NotProven) -> String {
    match why.at {
        Some(at) => format!("{} (at x = {})", why.what, significant(at, 6)),
        None => why.what.clone(),
    }
}

fn verdict(sheet: &mut Sheet, named: &Named, found: &Verification, errors: &str) {
    match (&found.shortfall, named.model) {
        (Some(why), _) => {
            sheet.toned_row("Not proven", &reason(why), Tone::Bad);
            sheet.row("", "Every finite error bound is proven. A quantity with an infinite bound is not proven.");
        }
        (None, ModelOf::File) => {
            let words = format!("there is exactly one equilibrium, and {errors}");
            sheet.toned_row("Proven", &words, Tone::Good);
        }
        (None, ModelOf::Document) => {
            let words = "only for the model as the solver read it: the second reader does not \
                         know a key of the model file";
            sheet.toned_row("Proven", words, Tone::Doubtful);
        }
    }
}

/// Adds the error bound of each quantity, and the reference value with which the error bound is compared.
fn bounds(sheet: &mut Sheet, found: &Verification, units: Units) {
    let written = |Bound { error, scale }: Bound, unit: Unit| {
        format!("± {}, scale {}", bound_in(unit, error), unit.with_digits(3).write(scale))
    };
    energy(sheet, found, units);
    for (name, bound) in found.named() {
        sheet.row(label(name), &written(bound, unit_of(units, name)));
    }
}

/// Adds a row with the bound of the error energy and the strain energy.
fn energy(sheet: &mut Sheet, found: &Verification, units: Units) {
    let (proof, unit) = (&found.proof, units.column(Kind::Moment));
    let strain = unit.with_digits(3).write(proof.strain_energy);
    let words =
        format!("error energy at most {}, strain energy {strain}", bound_in(unit, proof.energy));
    sheet.row("Energy", &words);
}

fn label(name: &str) -> &'static str {
    match name {
        "deflection" => "Deflection",
        "slope" => "Slope",
        "rotation" => "Rotation",
        "moment" => "Moment",
        "shear_force" => "Shear force",
        "settlement" => "Settlement",
        "pressure" => "Pressure",
        "gap" => "Gap",
        "edges" => "Edges",
        "forces" => "Forces",
        "reactions" => "Reactions",
        _ => "Their moment",
    }
}

/// The unit of the error bound of a quantity.
fn unit_of(units: Units, name: &str) -> Unit {
    units.column(match name {
        "deflection" | "settlement" | "gap" => Kind::Deflection,
        "edges" => Kind::Position,
        "slope" | "rotation" => Kind::Slope,
        "moment" | "reaction_moments" => Kind::Moment,
        "pressure" => Kind::Pressure,
        _ => Kind::Force,
    })
}

/// Text of an error bound in the given unit, rounded up.
fn bound_in(unit: Unit, error: f64) -> String {
    let number = above(unit.upper(error));
    format!("{number} {}", unit.name).trim_end().to_owned()
}

/// Adds rows that state how many values were compared, and which keys of the document were not compared.
fn checked(sheet: &mut Sheet, found: &Verification) {
    let checked = &found.checked;
    let count = |n: usize, one: &str, many: &str| match n {
        1 => format!("1 {one}"),
        n => format!("{n} {many}"),
    };
    let parts = [
        count(checked.values, "value", "values"),
        format!("at {}", count(checked.stations, "station,", "stations,")),
        count(checked.extremes, "extreme,", "extremes,"),
        count(checked.regions, "region of contact,", "regions of contact,"),
        count(checked.forces, "force,", "forces,"),
        count(found.proof.reactions.len(), "reaction", "reactions"),
    ];
    sheet.row("Checked", &parts.join(" "));
    if checked.at_edges > 0 {
        let what = count(checked.at_edges, "pressure", "pressures");
        sheet.row(
            "",
            &format!(
                "{what} at contact edges, each compared with the range from zero to the largest pressure near the edge"
            ),
        );
    }
    if checked.bounds > 0 {
        let what = count(checked.bounds, "bound", "bounds");
        sheet.row("", &format!("{what} given in the document"));
    }
    if !found.not_covered.is_empty() {
        let keys: Vec<&str> = found.not_covered.iter().map(String::as_str).collect();
        sheet.row("Not covered", &keys.join(", "));
    }
}
