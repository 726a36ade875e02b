//! `[[load]]`.

use super::curl;
use super::curl::Curls;
use crate::code;
use crate::fault::Fault;
use crate::lists;
use crate::quantity::{
    CURVATURE, FORCE, GROUND_POSITION, Kind, LOAD_PER_LENGTH, MOMENT, MOMENT_PER_LENGTH, POSITION,
    STRAIN, TEMPERATURE,
};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Action, Extent, Load};
use toml::Spanned;
use toml::de::DeValue;

/// A kind of load: its key, the quantity of its size, and the load of the model that it makes.
pub(crate) struct LoadKind {
    pub key: &'static str,
    pub wanted: &'static Kind,
    /// The SI unit in which it is written.
    pub unit: &'static str,
    action: Action,
    is_distributed: bool,
    /// Whether it may act on the ground as well.
    on_ground: bool,
}

const fn point(
    key: &'static str,
    wanted: &'static Kind,
    unit: &'static str,
    action: Action,
) -> LoadKind {
    LoadKind { key, wanted, unit, action, is_distributed: false, on_ground: false }
}

const fn distributed(
    key: &'static str,
    wanted: &'static Kind,
    unit: &'static str,
    action: Action,
) -> LoadKind {
    LoadKind { is_distributed: true, ..point(key, wanted, unit, action) }
}

/// Every kind, in the order in which messages list them. Of kinds with the same action and extent the first one is written.
static KINDS: [LoadKind; 7] = [
    LoadKind { on_ground: true, ..point("point", &FORCE, "N", Action::Force) },
    point("moment", &MOMENT, "N m", Action::Moment),
    LoadKind {
        on_ground: true,
        ..distributed("distributed", &LOAD_PER_LENGTH, "N/m", Action::Force)
    },
    distributed("distributed_moment", &MOMENT_PER_LENGTH, "N m/m", Action::Moment),
    distributed("curvature", &CURVATURE, "1/m", Action::Curvature),
    distributed("temperature_difference", &TEMPERATURE, "K", Action::Curvature),
    distributed("shrinkage_difference", &STRAIN, "", Action::Curvature),
];

/// The kind of a load of the model.
pub(crate) fn kind_of(load: &Load) -> &'static LoadKind {
    let is_distributed = load.extent().is_distributed();
    let same =
        |kind: &&LoadKind| kind.action == load.action() && kind.is_distributed == is_distributed;
    KINDS.iter().find(same).unwrap_or(&KINDS[0])
}

/// What is special to a list of loads.
struct List {
    title: &'static str,
    on_ground: bool,
    /// The quantity of a position.
    position: &'static Kind,
    /// Keys besides those of kinds and places.
    others: &'static [&'static str],
    /// What is said where a load has no kind.
    none: &'static str,
}

const ON_BEAM: List = List {
    title: "[[load]]",
    on_ground: false,
    position: &POSITION,
    others: &["expansion", "depth"],
    none: "force, moment or curvature",
};
const ON_GROUND: List = List {
    title: "[[ground_load]]",
    on_ground: true,
    position: &GROUND_POSITION,
    others: &[],
    none: "force",
};

const PLACES: [&str; 4] = ["at", "from", "to", "case"];

/// The loads, and beside each the load case it belongs to.
pub(super) fn read(
    reader: &mut Reader,
    root: &Section,
    beam_length: f64,
    curls: &Curls,
) -> (Vec<Load>, Vec<Option<String>>) {
    let tables = reader.tables(root, &lists::LOAD);
    let mut loads = Vec::new();
    let mut cases = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        loads.push(read_one(reader, table, &ON_BEAM, Part::Load(i), beam_length, curls));
        cases.push(case(reader, table));
    }
    (loads, cases)
}

/// The name of a load case, without the spaces around it.
fn case(reader: &mut Reader, table: &Section) -> Option<String> {
    let (name, span) = reader.words(table, "case", "Q")?;
    let name = name.trim();
    if name.is_empty() {
        let message = "the load case has no name";
        let hint = "write its name, as in case = \"Q\", or leave the key out";
        reader.report(Fault::new(code::EMPTY_NAME, span, message, "", hint));
    }
    Some(name.to_owned())
}

/// The loads on the ground, and beside each its load case; `first` loads stand before them.
pub(super) fn read_on_ground(
    reader: &mut Reader,
    root: &Section,
    first: usize,
) -> Vec<(Load, Option<String>)> {
    let tables = reader.tables(root, &lists::GROUND_LOAD);
    let mut loads = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        let part = Part::Load(first + i);
        let load = read_one(reader, table, &ON_GROUND, part, f64::NAN, &Curls::default());
        loads.push((load, case(reader, table)));
    }
    loads
}

fn read_one(
    reader: &mut Reader,
    table: &Section,
    list: &List,
    part: Part,
    beam_length: f64,
    curls: &Curls,
) -> Load {
    let kinds = || KINDS.iter().filter(|kind| kind.on_ground || !list.on_ground);
    let names: Vec<&str> = kinds().map(|kind| kind.key).collect();
    reader.refuse_unknown(table, &[&names[..], list.others, &PLACES].concat());
    reader.places.part(part, &table.span);
    let mut given: Vec<(&LoadKind, &Spanned<DeValue>)> =
        kinds().filter_map(|kind| Some((kind, table.value(kind.key)?))).collect();
    given.sort_by_key(|(_, value)| value.span().start);
    let Some(&(kind, value)) = given.first() else {
        let example = match list.on_ground {
            true => names.join(" or "),
            false => format!("one of {}", names.join(", ")),
        };
        reader.missing(table, &names, list.none, &example);
        return nothing(reader, part, table);
    };
    for (other, other_value) in &given[1..] {
        let hint = format!("give each load a {} of its own", list.title);
        reader.exclusive((kind.key, &value.span()), (other.key, &other_value.span()), &hint);
    }
    if !list.on_ground {
        refuse_keys_of_curvatures(reader, table, kind.key);
    }
    let extent = if kind.is_distributed {
        let [from, to] = stretch(reader, table, part, kind, list, beam_length);
        let (start, end) = intensity(reader, part, kind.key, value, kind.wanted);
        // What is missing has been reported.
        let per = match kind.action {
            Action::Curvature => curl::curvature_per(reader, table, kind.key, [from, to], curls),
            _ => 1.0,
        };
        let [start, end] = [start, end].map(|value| if per.is_nan() { 0.0 } else { per * value });
        Extent::Distributed { from, to, start, end }
    } else {
        misplaced(reader, table, kind.key, &["from", "to"], "a load at a point has `at`");
        let at = reader.required(table, "at", list.position);
        reader.places.field(part, "at", &at);
        let size = reader.field(kind.key, value, kind.wanted);
        let name = if kind.action == Action::Moment { "moment" } else { "force" };
        reader.places.field(part, name, &size);
        Extent::Point { at: at.value, size: size.value }
    };
    // Every kind of the table is a load.
    Load::new(kind.action, extent, list.on_ground).unwrap_or_else(|| nothing(reader, part, table))
}

/// Keeps the place of a load of unknown kind in the list, so that those after it keep theirs.
fn nothing(reader: &mut Reader, part: Part, table: &Section) -> Load {
    let unreadable = Field::unreadable(table.span.clone());
    reader.places.field(part, "at", &unreadable);
    reader.places.field(part, "force", &unreadable);
    Load::point_force(f64::NAN, f64::NAN)
}

/// `from` and `to`. A load on the beam that leaves them out covers the whole beam.
fn stretch(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    kind: &LoadKind,
    list: &List,
    beam_length: f64,
) -> [f64; 2] {
    let advice = match list.on_ground {
        true => "a distributed load has `from` and `to`",
        false => {
            "a distributed load has `from` and `to`, or neither: then it covers the whole beam"
        }
    };
    misplaced(reader, table, kind.key, &["at"], advice);
    [("from", 0.0), ("to", beam_length)].map(|(key, default)| {
        let field = if list.on_ground {
            reader.required(table, key, list.position)
        } else {
            let field = reader.quantity(table, key, list.position);
            field.unwrap_or_else(|| Field::new(default, table.span.clone()))
        };
        reader.places.field(part, key, &field);
        field.value
    })
}

/// One number for an even load, or a list of two: at `from` and at `to`.
fn intensity(
    reader: &mut Reader,
    part: Part,
    kind: &str,
    value: &Spanned<DeValue>,
    wanted: &'static Kind,
) -> (f64, f64) {
    let (start, end) = match value.get_ref() {
        DeValue::Array(array) => match &array[..] {
            [start, end] => (reader.field(kind, start, wanted), reader.field(kind, end, wanted)),
            other => {
                let message = format!("`{kind}` has {} values", other.len());
                let example = reader.pair(wanted);
                let hint = format!(
                    "give one value for an even load, or two for one that varies from `from` to \
                     `to`, as in {kind} = {example}"
                );
                reader.report(Fault::new(code::WRONG_TYPE, value.span(), message, "", hint));
                let unreadable = Field::unreadable(value.span());
                (unreadable.clone(), unreadable)
            }
        },
        _ => {
            let even = reader.field(kind, value, wanted);
            (even.clone(), even)
        }
    };
    reader.places.field(part, "start", &start);
    reader.places.field(part, "end", &end);
    (start.value, end.value)
}

/// Refuses `expansion` and `depth` beside a load that has no use for them.
fn refuse_keys_of_curvatures(reader: &mut Reader, table: &Section, kind: &str) {
    if kind != "temperature_difference" {
        let advice = "`expansion` belongs to a `temperature_difference`";
        misplaced(reader, table, kind, &["expansion"], advice);
    }
    let advice = match kind {
        "temperature_difference" | "shrinkage_difference" => return,
        "curvature" => "a curvature needs no depth",
        _ => "`depth` belongs to a difference between top and bottom",
    };
    misplaced(reader, table, kind, &["depth"], advice);
}

fn misplaced(reader: &mut Reader, table: &Section, kind: &str, keys: &[&str], advice: &str) {
    for key in keys {
        if let Some((name, _)) = table.table.get_key_value(*key) {
            let message = format!("`{key}` does not go with `{kind}`");
            reader.report(Fault::new(code::MISPLACED, name.span(), message, "", advice));
        }
    }
}
