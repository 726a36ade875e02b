//! Reads `[[train]]`.

use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_FROM, ALSO_TO, Table, Value, key, quantity, tables, text};
use crate::moving::{MovingTrain, Spread};
use crate::quantity::{self, BEHIND, FORCE, LOAD_PER_LENGTH, OFFSET, RATIO, REACH};
use crate::reader::Reader;
use crate::table::Section;
use crate::trains::{self, TrainSet};
use crate::units::Seen;
use groundbeam::model::{Axle, Train, UniformPart};
use std::ops::Range;

static AXLE: Table = Table {
    name: "an axle",
    keys: &[
        quantity("at", &BEHIND, "The distance behind the first axle.").needed(),
        quantity("force", &FORCE, "The axle load, downward.").needed(),
    ],
};

static UNIFORM: Table = Table {
    name: "a distributed load",
    keys: &[
        quantity(
            "from",
            &OFFSET,
            "The distance from the first axle back to the front end of the load; default: the load extends \
             forward without limit.",
        ),
        quantity(
            "to",
            &OFFSET,
            "The distance from the first axle back to the rear end of the load; default: the load extends \
             backward without limit.",
        ),
        quantity("load", &LOAD_PER_LENGTH, "The force per length, downward.").needed(),
    ],
};

pub(super) static TABLE: Table = Table {
    name: "[[train]]",
    keys: &[
        text("name", "LM71", "The name of the train; default: that of its set."),
        key(
            "set",
            Value::Name("LM71", trains::spellings),
            "The name of a train of a code of practice, in place of `axles` and `uniform`.",
        )
        .also(&["code", "standard"]),
        tables("axles", &AXLE, "The axles, from the front to the rear.")
            .also(&["axle", "wheels", "forces"]),
        tables("uniform", &UNIFORM, "Distributed loads that move with the axles."),
        quantity(
            "from",
            &OFFSET,
            "The start position of the first axle; default: the first axle, or the front end of the foremost finite \
             distributed load, reaches the beam.",
        )
        .also(ALSO_FROM),
        quantity(
            "to",
            &OFFSET,
            "The final position of the first axle; default: the last axle and the rear end of the last finite \
             distributed load leave the beam.",
        )
        .also(ALSO_TO),
        quantity("factor", &RATIO, "A factor on all loads; default: 1."),
        quantity("dynamic", &RATIO, "An additional factor on the axle loads; default: 1.").also(&[
            "impact",
            "dynamic_factor",
            "IM",
        ]),
        text(
            "case",
            "T",
            "The load case. Without one, the train belongs to every combination, with the factor 1.",
        )
        .also(&["load_case"]),
    ],
};

/// Reads the trains of the file. The trains pass over the beam one at a time.
pub(super) fn read(reader: &mut Reader, root: &Section, beam_length: f64) -> Vec<MovingTrain> {
    let tables = reader.tables(root, "train");
    let mut trains: Vec<MovingTrain> = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        let train = read_one(reader, table, beam_length);
        let is_read = train.train != Train::default();
        let first = trains.iter().position(|other| other.name == train.name);
        if let Some(first) = first.filter(|_| is_read) {
            let place = |table: &Section| {
                let key = table.value("name").or(table.value("set"));
                key.map_or(table.span.clone(), |key| key.span())
            };
            let message = format!("two trains have the name `{}`", train.name);
            let hint = "give each a `name` of its own";
            let fault = Fault::new(code::REPEATED, place(&tables[i]), message, "", hint);
            reader.report_with(fault, place(&tables[first]), "the first of them");
        }
        trains.push(train);
    }
    trains
}

fn read_one(reader: &mut Reader, table: &Section, beam_length: f64) -> MovingTrain {
    let name = reader.text(table, "name").filter(|(name, span)| {
        let is_empty = name.trim().is_empty();
        if is_empty {
            let message = "the train has no name";
            let hint = "write the name of the train, as in name = \"LM71\", or leave the key out";
            reader.report(Fault::new(code::EMPTY_NAME, span.clone(), message, "", hint));
        }
        !is_empty
    });
    let (set, mut train) = parts(reader, table);
    let case = super::load::case(reader, table, "case");
    let dynamic = reader.quantity(table, "dynamic").map_or(1.0, |dynamic| dynamic.value);
    train.axles.iter_mut().for_each(|axle| axle.force *= dynamic);
    let factor = match reader.quantity(table, "factor") {
        Some(factor) => {
            let scaled = train.clone().scaled(factor.value);
            if factor.value.is_finite() && is_finite(&train) && !is_within_reach(&scaled) {
                let message = "with this factor a load of the train is too large or too small";
                reader.report(Fault::new(code::NOT_FINITE, factor.span, message, "", REACH));
            }
            factor.value
        }
        None => 1.0,
    };
    let range = range(reader, table, &train, beam_length);
    let name = match (name, set) {
        (Some((name, _)), _) => name.trim().to_owned(),
        (None, Some(set)) => set.name.clone(),
        (None, None) => "train".to_owned(),
    };
    let set = set.map(|set| set.name.clone());
    let (train, spread) = (train.scaled(factor), Spread::default());
    MovingTrain { name, set, case, factor, dynamic, spread, train, range }
}

/// Reads the axles and the distributed loads of a train, either from the built-in train set that the table names, or
/// from the lists in the table.
fn parts(reader: &mut Reader, table: &Section) -> (Option<&'static TrainSet>, Train) {
    let mut train = Train::default();
    let Some(set) = table.value("set") else {
        let lists = (table.value("axles").is_some(), table.value("uniform").is_some());
        if lists.0 {
            train.axles = axles(reader, table);
        } else if !lists.1 {
            let force = reader.line(&AXLE, "force");
            let at = reader.line(&AXLE, "at");
            let example = format!("set = \"LM71\", or axles = [{{ {at}, {force} }}, …]");
            reader.missing(table, &["set", "axles"], "axles", &example);
        }
        if lists.1 {
            train.uniform = uniform(reader, table);
            if !lists.0 && table.empty_list("uniform").is_some() {
                let example = "at least one to `uniform`";
                reader.missing(table, &["set"], "distributed load", example);
            }
        }
        return (None, train);
    };
    for key in ["axles", "uniform"] {
        if let Some(other) = table.value(key) {
            let hint =
                "`set` defines the loads of the train: give either `set`, or `axles` and `uniform`";
            reader.exclusive(("set", &set.span()), (key, &other.span()), hint);
        }
    }
    let Some((written, span)) = reader.text(table, "set") else { return (None, train) };
    reader.quantities.push(Seen::of_built_in("set", &FORCE, span.clone()));
    let found = trains::find(written.trim());
    match found {
        Some(set) => train = set.train.clone(),
        None => {
            let message = "there is no train `{}`";
            reader.unknown_word((written, span), message, &trains::names(), "the trains: {}");
        }
    }
    (found, train)
}

/// Reads `axles = [{ at = "0 m", force = "250 kN" }, …]`.
fn axles(reader: &mut Reader, table: &Section) -> Vec<Axle> {
    let mut axles = Vec::new();
    let mut first: Option<(f64, Range<usize>)> = None;
    let list = reader.tables(table, "axles");
    for axle in &list {
        let at = reader.required(axle, "at");
        let force = reader.required(axle, "force");
        if first.as_ref().is_none_or(|(least, _)| at.value < *least || at.value.is_nan()) {
            first = Some((at.value, at.span));
        }
        axles.push(Axle { behind: at.value, force: force.value });
    }
    match first {
        Some((at, span)) if !at.is_nan() && at != 0.0 => {
            let message = "the first axle of a train must be at 0";
            let hint =
                "give the distances of the other axles behind the first axle, as positive numbers";
            reader.report(Fault::new(code::FIRST_AXLE, span, message, "", hint));
        }
        None if table.empty_list("axles").is_some() => {
            reader.missing(table, &["set"], "axle", "at least one to `axles`");
        }
        _ => {}
    }
    axles
}

/// Reads `uniform = [{ from = "5.6 m", load = "80 kN/m" }, …]`. A missing end is at infinity.
fn uniform(reader: &mut Reader, table: &Section) -> Vec<UniformPart> {
    let mut parts = Vec::new();
    for part in reader.tables(table, "uniform") {
        let from = reader.quantity(&part, "from");
        let to = reader.quantity(&part, "to");
        let load = reader.required(&part, "load");
        if let (Some(from), Some(to)) = (&from, &to)
            && to.value <= from.value
        {
            let hint = "`from` and `to` are distances behind the first axle; `to` must be larger than `from`";
            backward(reader, "a distributed load of the train has no length", &to.span, hint);
        }
        parts.push(UniformPart {
            from: from.map_or(f64::NEG_INFINITY, |from| from.value),
            to: to.map_or(f64::INFINITY, |to| to.value),
            intensity: load.value,
        });
    }
    parts
}

/// Reads the range of positions of the first axle. The default range extends from the arrival of the train
/// until the train has left the beam.
fn range(reader: &mut Reader, table: &Section, train: &Train, beam_length: f64) -> [f64; 2] {
    let [start, end] = train.passage(beam_length);
    let from = reader.quantity(table, "from");
    let to = reader.quantity(table, "to");
    let place = to.as_ref().or(from.as_ref()).map(|field| field.span.clone());
    let range = [from.map_or(start, |from| from.value), to.map_or(end, |to| to.value)];
    if let Some(span) = place
        && range[1] <= range[0]
    {
        let hint = "`from` and `to` are positions of the first axle, which moves to the right";
        backward(reader, "the train does not move", &span, hint);
    }
    range
}

fn backward(reader: &mut Reader, message: &str, span: &Range<usize>, hint: &str) {
    reader.report(Fault::new(code::STRETCH, span.clone(), message, "", hint));
}

fn is_finite(train: &Train) -> bool {
    sizes(train).all(f64::is_finite)
}

fn is_within_reach(train: &Train) -> bool {
    sizes(train).all(quantity::is_within_reach)
}

fn sizes(train: &Train) -> impl Iterator<Item = f64> {
    let axles = train.axles.iter().map(|axle| axle.force);
    axles.chain(train.uniform.iter().map(|part| part.intensity))
}
