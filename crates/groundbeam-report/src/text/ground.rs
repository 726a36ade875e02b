//! The origin of the ground's constants as text.

use super::sheet::{Sheet, Tone};
use crate::context::Context;
use crate::quantity::Kind;
use groundbeam::Model;
use groundbeam::soil::SoilRounds;

/// The method, the values per area, and warnings.
pub fn rows(sheet: &mut Sheet, model: &Model, context: &Context) {
    let Some(ground) = context.ground else { return };
    let units = context.units;
    let (width, constants) = (ground.width, ground.constants);
    if let Some(soil) = &ground.soil {
        let mut words = format!("by {}", soil.source());
        if let Some(SoilRounds { gamma: Some(gamma), rounds }) = ground.rounds {
            words += &format!(", γ = {}", units.ratio(gamma));
            if rounds > 1 {
                words += &format!(", the solution's own after {rounds} of them");
            }
        }
        sheet.row("Soil", &words);
    }
    let area = units.write(Kind::AreaSpring, constants.subgrade / width);
    let mut values =
        format!("on a width of {}: C1 = k/b = {area}", units.of_input().position(width));
    if constants.shear_layer > 0.0 {
        let shear = units.write(Kind::AreaShear, constants.shear_layer / width);
        values += &format!(", C2 = mu/b = {shear}");
    }
    sheet.row("", &values);
    for doubt in ground.soil.as_ref().map(|soil| soil.doubts(&model.beam)).unwrap_or_default() {
        sheet.toned_row("Caution", &doubt, Tone::Doubtful);
    }
}
