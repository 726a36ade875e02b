//! Writes as text how the ground constants k and μ were obtained, and their values per unit area.

use super::range;
use super::sheet::{Sheet, Tone};
use crate::context::Context;
use crate::quantity::{Kind, Units};
use groundbeam::Model;
use groundbeam::soil::SoilRounds;
use groundbeam_run::Ground;

/// Adds rows on the ground constants k and μ: the method of computation, the values of k and μ divided by the
/// bearing width, and warnings.
pub fn rows(sheet: &mut Sheet, model: &Model, context: &Context) {
    let Some(ground) = context.ground else { return };
    let units = context.units;
    let (width, constants) = (ground.width, ground.constants);
    if let Some(soil) = &ground.soil {
        let mut words = format!("by {}", soil.source());
        if let Some(SoilRounds { gamma: Some(gamma), rounds }) = ground.rounds {
            words += &format!(", γ = {}", units.ratio(gamma));
            if rounds > 1 {
                words += &format!(", computed from the solution in {rounds} iterations");
            }
        }
        sheet.row("Soil", &words);
    }
    sheet.row("", &areas(width, [constants.subgrade; 2], [constants.shear_layer; 2], units));
    for doubt in ground.soil.as_ref().map(|soil| soil.doubts(&model.beam)).unwrap_or_default() {
        sheet.toned_row("Caution", &doubt, Tone::Doubtful);
    }
}

/// Text with the ranges of k and μ, divided by the bearing width.
fn areas(width: f64, subgrade: [f64; 2], shear_layer: [f64; 2], units: Units) -> String {
    let [area, shear] = [(Kind::AreaSpring, subgrade), (Kind::AreaShear, shear_layer)]
        .map(|(kind, ends)| range(units, kind, ends.map(|value| value / width)));
    let mut words =
        format!("bearing width b = {}: C1 = k/b = {area}", units.of_input().position(width));
    if shear_layer[1] > 0.0 {
        words += &format!(", C2 = mu/b = {shear}");
    }
    words
}

/// Adds the ground constants of several models, each with its own k and μ. `models` is empty if there is no
/// solution. `what` is the noun for one solution.
pub(crate) fn of_each(
    sheet: &mut Sheet,
    what: &str,
    ground: Option<&Ground>,
    models: &[&Model],
    units: Units,
) {
    let words = match models {
        [] => "above: before the solution",
        _ => "above: those of all",
    };
    let source = ground.and_then(|ground| ground.soil.as_ref()).map(|soil| soil.source());
    let by = source.map_or_else(String::new, |source| format!(" by {source}"));
    let words = format!("k and mu of each {what} depend on its own solution{by}; {words}");
    sheet.row("Soil", &words);
    let ends = |value: fn(&Model) -> f64| {
        models.iter().map(|model| value(model)).fold([f64::INFINITY, 0.0], |[low, high], value| {
            [low.min(value), f64::max(high, value)]
        })
    };
    if let (Some(ground), false) = (ground, models.is_empty()) {
        let [springs, shears] =
            [ends(|of| of.foundation.subgrade), ends(|of| of.foundation.shear_layer)];
        sheet.row("", &areas(ground.width, springs, shears, units));
    }
}
