//! The tables of a model file, one file each, in the order of [`groundbeam::Model`].

mod band;
mod beam;
mod checks;
mod combination;
mod curl;
mod foundation;
mod gap;
mod hinge;
mod load;
mod material;
mod shape;
mod shear;
mod soil;
mod support;
mod survey;
mod train;
mod weight;

use crate::combination::Recipe;
use crate::document::MovingTrain;
use crate::reader::{Field, Reader};
use crate::table::Section;
use curl::Curls;
use groundbeam::model::Part;
use groundbeam::{Limits, Model};

const TABLES: &[&str] = &[
    "title",
    "beam",
    "foundation",
    "load",
    "ground_load",
    "support",
    "hinge",
    "gap",
    "gap_survey",
    "gap_trough",
    "case",
    "combination",
    "train",
    "checks",
];

/// The whole file, as far as it could be read.
pub(crate) struct Contents {
    pub title: Option<String>,
    pub model: Model,
    pub ground: Ground,
    pub limits: Limits,
    /// The load case of each of the model's loads.
    pub cases: Vec<Option<String>>,
    pub recipes: Vec<Recipe>,
    pub trains: Vec<MovingTrain>,
}

pub(crate) use foundation::Ground;

/// Reads the whole file.
pub(crate) fn read(reader: &mut Reader, root: &Section) -> Contents {
    reader.refuse_unknown(root, TABLES);
    let title = reader.words(root, "title", "Strip footing").map(|(title, _)| title.to_owned());
    let beam::Read { beam, loads: own, depths, expansion } = beam::read(reader, root);
    let ground = foundation::read(reader, root, &beam);
    let curls = Curls { depths, expansion };
    let (mut loads, mut cases) = load::read(reader, root, beam.length, &curls);
    for beam::OwnLoad { load, case, span } in own {
        let part = Part::Load(loads.len());
        reader.places.part(part, &span);
        reader.places.field(part, "start", &Field::new(0.0, span.clone()));
        // Where it begins and ends the segments say, and what is wrong there is told of them.
        for end in ["from", "to"] {
            reader.places.field(part, end, &Field::unreadable(span.clone()));
        }
        loads.push(load);
        cases.push(case);
    }
    for (load, case) in load::read_on_ground(reader, root, loads.len()) {
        loads.push(load);
        cases.push(case);
    }
    let supports = support::read(reader, root);
    let hinges = hinge::read(reader, root);
    let gap = gap::read(reader, root, beam.length);
    let limits = checks::read(reader, root, ground.width);
    let grounds = ground.band.map_or(1, |band| band.grounds().len());
    let recipes = combination::read(reader, root, &loads, &cases, grounds);
    let trains = train::read(reader, root, beam.length);
    let foundation = ground.foundation.clone();
    let model = Model { beam, foundation, loads, supports, hinges, gap };
    Contents { title, model, ground, limits, cases, recipes, trains }
}
