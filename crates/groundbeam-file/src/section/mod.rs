//! Reads the tables of a model file; each table has its own source file.

mod band;
mod beam;
mod checks;
mod chords;
mod combination;
mod curl;
mod foundation;
mod gap;
mod hinge;
pub(crate) mod load;
mod material;
mod segments;
mod shape;
mod shear;
pub(crate) mod soil;
mod support;
mod survey;
mod train;
mod trough;
mod weight;

use crate::combination::Recipe;
use crate::document::Depth;
use crate::keys::{Table, table, tables, text};
use crate::moving::MovingTrain;
use crate::reader::{Field, Reader};
use crate::table::Section;
use curl::Curls;
use groundbeam::model::Part;
use groundbeam::{Model, design::Limits};

/// Tables of a model file.
pub(crate) static MODEL: Table = Table {
    name: "the file",
    keys: &[
        text("title", "Strip footing", "The title of reports and pictures."),
        table("beam", &beam::TABLE, "The beam.").needed().also(&["bar", "girder", "member"]),
        table("foundation", &foundation::TABLE, "The ground under the beam.")
            .needed()
            .also(&["ground", "soil", "subgrade", "bed"]),
        tables("load", &load::TABLE, "A load on the beam.").also(&["force", "forces", "action"]),
        tables("ground_load", &load::ON_GROUND, "A load on the ground."),
        tables("support", &support::TABLE, "A support of the beam.")
            .also(&["bearing", "constraint"]),
        tables("hinge", &hinge::TABLE, "A hinge inside the beam.").also(&[
            "joint",
            "internal_hinge",
            "release",
        ]),
        tables("gap", &gap::TABLE, "A point of the initial gap.")
            .also(&["clearance", "initial_gap"]),
        table("gap_survey", &survey::TABLE, "The initial gap from a table in a file."),
        tables("gap_trough", &trough::TABLE, "A settlement trough of the ground."),
        tables("case", &combination::CASE, "A load case, for sets of combinations.")
            .also(&["load_case"]),
        tables("combination", &combination::TABLE, "A combination of load cases.").also(&[
            "load_combination",
            "combinations",
            "combo",
        ]),
        tables("train", &train::TABLE, "A train that moves along the beam.").also(&[
            "moving_load",
            "vehicle",
            "trains",
            "axle_train",
        ]),
        table("checks", &checks::TABLE, "The limits of a design."),
    ],
};

/// Contents of a model file.
pub(crate) struct Contents {
    pub title: Option<String>,
    pub model: Model,
    /// Number of chords that replace settlement troughs; `None` without troughs.
    pub chords: Option<usize>,
    pub ground: Ground,
    pub limits: Limits,
    /// Load case of each load of the model.
    pub cases: Vec<Option<String>>,
    pub recipes: Vec<Recipe>,
    pub trains: Vec<MovingTrain>,
    /// Greatest depth of the beam's sections, if known.
    pub height: Option<f64>,
    /// Depth of the beam's section along the beam; empty if the depth of any part of the beam is unknown.
    pub depths: Vec<Depth>,
}

pub(crate) use foundation::Ground;

/// Reads the whole file.
pub(crate) fn read(reader: &mut Reader, root: &Section) -> Contents {
    reader.refuse_unknown(root);
    let title = reader.text(root, "title").map(|(title, _)| title.to_owned());
    let beam::Read { beam, loads: own, depths, expansion } = beam::read(reader, root);
    let ground = foundation::read(reader, root, &beam);
    let heights = depths.iter().filter_map(|depth| Some(depth.depth.as_ref()?.profile.largest()));
    let height = heights.reduce(f64::max);
    let known = depths.iter().map(|&curl::Depth { from, to, ref depth }| {
        Some(Depth { from, to, depth: depth.as_ref()?.profile })
    });
    let known = known.collect::<Option<Vec<Depth>>>().unwrap_or_default();
    let curls = Curls { depths, expansion };
    let (mut loads, mut cases) = load::read(reader, root, beam.length, &curls);
    for beam::OwnLoad { load, case, span } in own {
        let part = Part::Load(loads.len());
        reader.places.part(part, &span);
        reader.places.field(part, "start", &Field::new(0.0, span.clone()));
        // Faults of `from` and `to` are reported at the tables of the beam's segments.
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
    let foundation = ground.foundation.clone();
    let mut model = Model { beam, foundation, loads, supports, hinges, gap: Vec::new() };
    let mut limits = checks::read(reader, root, &ground);
    let grounds = ground.band.map_or(1, |band| band.grounds().len());
    let trains = train::read(reader, root, model.beam.length);
    let recipes = combination::read(reader, root, &model.loads, &cases, &trains, grounds);
    checks::judge_resistance(&mut limits, &recipes);
    let pressures = mean_loads(&model, &cases, &recipes);
    let chords = gap::read(reader, root, &mut model, ground.band, pressures.into_iter());
    Contents { title, model, chords, ground, limits, cases, recipes, trains, height, depths: known }
}

/// Computes the mean load per length \[N/m\] for each combination of the file, or for all loads if the file
/// has no combinations.
fn mean_loads(model: &Model, cases: &[Option<String>], recipes: &[Recipe]) -> Vec<f64> {
    let mean =
        |factor: &dyn Fn(usize) -> f64| chords::mean_load(&model.loads, model.beam.length, factor);
    if recipes.is_empty() {
        return vec![mean(&|_| 1.0)];
    }
    let of = |recipe: &Recipe| mean(&|load| recipe.factor(cases[load].as_deref()));
    recipes.iter().map(of).collect()
}
