//! The second reader of model files: TOML, units and sections read into exact numbers or balls.
//!
//! This reader shares only the tables of rolled sections with the reader of the solver. It refuses modified Vlasov
//! soil, gap troughs, gap surveys and trains with [`Reason::NotRead`]. It ignores `title`, `[checks]` and limit states.
//! Reading ends at the first fault.

mod asce;
mod band;
mod beam;
mod case;
mod check;
mod codes;
mod combination;
mod course;
mod error;
mod eurocode;
mod feet;
mod fields;
mod ground;
mod load;
mod material;
mod number;
mod place;
mod product;
mod rolled;
mod section;
mod sets;
mod shapes;
mod shear;
mod soil;
mod support;
mod symbols;
mod text;
mod toml;
mod unit;
mod units;

pub use error::{ReadError, Reason};

use crate::{Model, Scalar};
use error::{Fault, Read};
use fields::{Fields, Section};

const KEYS: &[&str] = &[
    "title",
    "beam",
    "foundation",
    "load",
    "ground_load",
    "support",
    "hinge",
    "gap",
    "case",
    "combination",
    "checks",
];
const FOREIGN: &[&str] = &["gap_survey", "gap_trough", "train"];

/// Reads a model file. Returns the model under the loads of a combination, or under all loads with their
/// values in the file.
pub(crate) fn read_model<S: Scalar>(
    text: &str,
    combination: Option<&str>,
) -> Result<Model<S>, ReadError> {
    read(text, combination).map_err(|fault: Fault| fault.placed(text))
}

fn read<S: Scalar>(text: &str, combination: Option<&str>) -> Read<Model<S>> {
    let table = toml::read(text)?;
    let root = Section { table: &table, at: 0 };
    root.only(&[KEYS], FOREIGN)?;
    let mut fields = Fields::default();
    let beam::ReadBeam { beam, loads: own, depths, expansion } = beam::read(&mut fields, root)?;
    let length = beam.length;
    let ground = ground::read(&mut fields, root, &beam)?;
    let grounds = band::read(&mut fields, root, &ground)?;
    let curls = load::Curls { depths: &depths, expansion };
    let mut loads = load::read(&mut fields, root, length, &curls)?;
    loads.extend(own);
    loads.extend(load::read_on_ground(&mut fields, root)?);
    let supports = support::supports(&mut fields, root, length)?;
    let hinges = support::hinges(&mut fields, root, length)?;
    let gap = support::gap(&mut fields, root, length)?;
    let (loads, on) = combination::select(root, loads, &grounds, combination)?;
    let ground = on.map_or_else(|| ground.clone(), |on| on.applied(ground.clone()));
    let model = Model { beam, ground, loads, supports, hinges, gap };
    check::check(&model)?;
    Ok(model)
}
