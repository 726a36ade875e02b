//! What is proven of a result document, in words.

use super::sheet::{Sheet, Tone};
use crate::number::{above, significant};
use crate::quantity::Units;
use crate::verified::{ModelOf, Named, Verified};
use groundbeam::proof::{Bound, NotProven, Verification};

/// The report of `groundbeam verify`.
pub fn verified(verified: &Verified, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    if let Some(why) = &verified.other_model {
        sheet.toned_row("Not proven", why, Tone::Bad);
        sheet.row("", "The rest holds for the numbers alone, read in the units of the model file.");
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

/// What is proven of the answers of a report.
pub fn proofs(proofs: &[Named], units: Units, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    for (i, named) in proofs.iter().enumerate() {
        if i > 0 {
            sheet.blank();
        }
        match &named.combination {
            Some(name) => sheet.heading(&format!("Proof: {name}")),
            None => sheet.heading("Proof"),
        }
        match &named.found {
            Err(why) => sheet.toned_row("Not proven", &reason(why), Tone::Bad),
            Ok(found) => {
                verdict(&mut sheet, named, found);
                proven_parts(&mut sheet, named, found);
                bounds(&mut sheet, found, units);
            }
        }
    }
    sheet.finish()
}

/// Existence, uniqueness and contact set, and every bound that is not small.
fn proven_parts(sheet: &mut Sheet, named: &Named, found: &Verification) {
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
                1 => "exactly one region or point, as printed".to_owned(),
                n => format!("exactly {n} regions and points, as printed"),
            };
            sheet.row("Contact", &words);
        }
        Err(why) => sheet.row("Contact", &format!("not proven: {}", reason(why))),
    }
    let large = found.named().into_iter().filter(|(_, bound)| !bound.is_small());
    let large: Vec<&str> = large.map(|(name, _)| label(name)).collect();
    if !named.is_proven() && !large.is_empty() {
        let words = format!("not within a millionth of its scale: {}", large.join(", "));
        sheet.row("Not small", &words);
    }
}

fn result(sheet: &mut Sheet, named: &Named, units: Units) {
    match &named.found {
        Err(why) => {
            sheet.toned_row("Not proven", &reason(why), Tone::Bad);
        }
        Ok(found) => {
            verdict(sheet, named, found);
            bounds(sheet, found, units);
            checked(sheet, found);
        }
    }
}

/// A reason in words that end with its place.
pub(crate) fn reason(why: &NotProven) -> String {
    match why.at {
        Some(at) => format!("{} (at x = {})", why.what, significant(at, 6)),
        None => why.what.clone(),
    }
}

fn verdict(sheet: &mut Sheet, named: &Named, found: &Verification) {
    match (&found.shortfall, named.model) {
        (Some(why), _) => {
            sheet.toned_row("Not proven", &reason(why), Tone::Bad);
            sheet.row("", "The bounds below are proven. An infinite one proves nothing.");
        }
        (None, ModelOf::File) => {
            let words = "there is exactly one equilibrium, and the errors are at most these";
            sheet.toned_row("Proven", words, Tone::Good);
        }
        (None, ModelOf::Document) => {
            let words = "for the model as the solver read it alone: the second reader does not \
                         know a key of the model file";
            sheet.toned_row("Proven", words, Tone::Doubtful);
        }
    }
}

/// Each bound with the scale with which it is compared.
pub(crate) fn bounds(sheet: &mut Sheet, found: &Verification, units: Units) {
    let written = |Bound { error, scale }: Bound, unit: &str| {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        format!("± {}{unit}, scale {}{unit}", above(error), significant(scale, 3))
    };
    let proof = &found.proof;
    let energy = units_of(units, "energy");
    let words = format!(
        "at most {} {energy}, strain energy {} {energy}",
        above(proof.energy),
        significant(proof.strain_energy, 3)
    );
    sheet.row("Energy", &words.replace(" ,", ","));
    for (name, bound) in found.named() {
        sheet.row(label(name), &written(bound, units_of(units, name)));
    }
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

/// The unit of a bound; empty in a system of its own.
fn units_of(units: Units, name: &str) -> &'static str {
    match (units, name) {
        (Units::Plain, _) => "",
        (_, "deflection" | "settlement" | "gap" | "edges") => "m",
        (_, "slope" | "rotation") => "rad",
        (_, "moment" | "reaction_moments" | "energy") => "N m",
        (_, "pressure") => "N/m",
        _ => "N",
    }
}

/// How much was compared, and what was not.
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
        let words = "at edges of contact: compared with zero and the values beside them";
        sheet.row("", &format!("{what} {words}"));
    }
    if checked.bounds > 0 {
        let what = count(checked.bounds, "bound", "bounds");
        sheet.row("", &format!("{what} that the document itself claims"));
    }
    if !found.not_covered.is_empty() {
        let keys: Vec<&str> = found.not_covered.iter().map(String::as_str).collect();
        sheet.row("Not covered", &keys.join(", "));
    }
}
