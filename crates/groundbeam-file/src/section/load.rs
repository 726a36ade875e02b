//! Reads the tables `[[load]]` (loads on the beam) and `[[ground_load]]` (loads on the ground).

use super::curl;
use super::curl::Curls;
use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_AT, ALSO_FROM, ALSO_TO, Key, Table, Value, along, quantity, text};
use crate::quantity::{
    CURVATURE, DEPTH, EXPANSION, FORCE, GROUND_POSITION, LOAD_PER_LENGTH, MOMENT,
    MOMENT_PER_LENGTH, POSITION, STRAIN, TEMPERATURE,
};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{
    Load,
    model::{Action, Extent},
};
use toml::Spanned;
use toml::de::DeValue;

/// A kind of load. Its key, such as `point`, gives the physical quantity and the action: force, moment or curvature.
pub(crate) struct LoadKind {
    pub key: Key,
    /// SI unit of the quantity under this key.
    pub unit: &'static str,
    action: Action,
}

/// All kinds of load, in the order in which messages list them. If several kinds describe one load of the
/// model, a written file contains the first of these kinds.
static KINDS: [LoadKind; 7] = [
    LoadKind { key: POINT, unit: "N", action: Action::Force },
    LoadKind { key: MOMENT_AT, unit: "N m", action: Action::Moment },
    LoadKind { key: DISTRIBUTED, unit: "N/m", action: Action::Force },
    LoadKind { key: DISTRIBUTED_MOMENT, unit: "N m/m", action: Action::Moment },
    LoadKind { key: IMPOSED, unit: "1/m", action: Action::Curvature },
    LoadKind { key: WARMER, unit: "K", action: Action::Curvature },
    LoadKind { key: SHRUNK, unit: "", action: Action::Curvature },
];

const POINT: Key = quantity("point", &FORCE, "A force at a point, positive downward.").also(&[
    "f",
    "p",
    "force",
    "value",
    "point_load",
    "magnitude",
]);
const MOMENT_AT: Key = quantity(
    "moment",
    &MOMENT,
    "A moment at a point, positive if it turns the right side of the beam downward.",
)
.also(&["m", "couple"]);
const DISTRIBUTED: Key =
    along("distributed", &LOAD_PER_LENGTH, 2, "A distributed force, positive downward.").also(&[
        "q",
        "w",
        "uniform",
        "line",
        "distributed_load",
    ]);
const DISTRIBUTED_MOMENT: Key =
    along("distributed_moment", &MOMENT_PER_LENGTH, 2, "A distributed moment.")
        .also(&["line_moment"]);
const IMPOSED: Key = along(
    "curvature",
    &CURVATURE,
    2,
    "An imposed curvature κ₀; a positive one bends the ends down.",
);
const WARMER: Key = along(
    "temperature_difference",
    &TEMPERATURE,
    2,
    "The temperature of the top minus the temperature of the bottom; it causes the curvature κ₀ \
     = expansion × difference / depth.",
);
const SHRUNK: Key = along(
    "shrinkage_difference",
    &STRAIN,
    2,
    "The shrinkage of the top minus the shrinkage of the bottom; it causes the curvature κ₀ = \
     −difference / depth.",
);

impl LoadKind {
    fn is_distributed(&self) -> bool {
        matches!(self.key.value, Value::Along(..))
    }
}

const CASE: Key =
    text("case", "Q", "The name of the load case to which the load belongs.").also(&["load_case"]);

pub(super) static TABLE: Table = Table {
    name: "[[load]]",
    keys: &[
        POINT,
        MOMENT_AT,
        DISTRIBUTED,
        DISTRIBUTED_MOMENT,
        IMPOSED,
        WARMER,
        SHRUNK,
        quantity(
            "expansion",
            &EXPANSION,
            "The coefficient of thermal expansion; default: that of the `material`.",
        ),
        quantity("depth", &DEPTH, "The depth of the beam; default: that of its `section`."),
        quantity("at", &POSITION, "The position of a point load.").also(ALSO_AT),
        quantity("from", &POSITION, "The start of a distributed load; default: 0.").also(ALSO_FROM),
        quantity(
            "to",
            &POSITION,
            "The end of a distributed load; default: the length of the beam.",
        )
        .also(ALSO_TO),
        CASE,
    ],
};

pub(super) static ON_GROUND: Table = Table {
    name: "[[ground_load]]",
    keys: &[
        POINT,
        DISTRIBUTED,
        quantity("at", &GROUND_POSITION, "The position of a point force.").also(ALSO_AT),
        quantity("from", &GROUND_POSITION, "The start of a distributed force.").also(ALSO_FROM),
        quantity("to", &GROUND_POSITION, "The end of a distributed force.").also(ALSO_TO),
        CASE,
    ],
};

/// Returns the kind under which `load` is written to a file: the first entry of [`KINDS`] that can describe `load`.
pub(crate) fn kind_of(load: &Load) -> &'static LoadKind {
    let is_distributed = load.extent().is_distributed();
    let same =
        |kind: &&LoadKind| kind.action == load.action() && kind.is_distributed() == is_distributed;
    KINDS.iter().find(same).unwrap_or(&KINDS[0])
}

/// Reads the loads on the beam, and the load case of each load.
pub(super) fn read(
    reader: &mut Reader,
    root: &Section,
    beam_length: f64,
    curls: &Curls,
) -> (Vec<Load>, Vec<Option<String>>) {
    let tables = reader.parts(root, "load", Part::Load);
    let mut loads = Vec::new();
    let mut cases = Vec::new();
    for table in &tables {
        loads.push(read_one(reader, table, beam_length, curls));
        cases.push(case(reader, table, "case"));
    }
    (loads, cases)
}

/// Reads the name of a load case under `key`, without surrounding spaces.
pub(super) fn case(reader: &mut Reader, table: &Section, key: &str) -> Option<String> {
    let (name, span) = reader.text(table, key)?;
    let name = name.trim();
    if name.is_empty() {
        let message = "the load case has no name";
        let hint =
            format!("write the name of the load case, as in {key} = \"Q\", or leave the key out");
        reader.report(Fault::new(code::EMPTY_NAME, span, message, "", hint));
    }
    Some(name.to_owned())
}

/// Reads the loads on the ground, each with its load case. `first` is the number of loads that precede them
/// in the model.
pub(super) fn read_on_ground(
    reader: &mut Reader,
    root: &Section,
    first: usize,
) -> Vec<(Load, Option<String>)> {
    let tables = reader.parts(root, "ground_load", |i| Part::Load(first + i));
    let mut loads = Vec::new();
    for table in &tables {
        let load = read_one(reader, table, f64::NAN, &Curls::default());
        loads.push((load, case(reader, table, "case")));
    }
    loads
}

fn read_one(reader: &mut Reader, table: &Section, beam_length: f64, curls: &Curls) -> Load {
    let on_ground = std::ptr::eq(table.keys, &ON_GROUND);
    let keys = table.keys.names();
    let kinds = || KINDS.iter().filter(|kind| keys.contains(&kind.key.name));
    let names: Vec<&str> = kinds().map(|kind| kind.key.name).collect();
    let mut given: Vec<(&LoadKind, &Spanned<DeValue>)> =
        kinds().filter_map(|kind| Some((kind, table.value(kind.key.name)?))).collect();
    given.sort_by_key(|(_, value)| value.span().start);
    let Some(&(kind, value)) = given.first() else {
        let (none, example) = match on_ground {
            true => ("force", names.join(" or ")),
            false => ("force, moment or curvature", format!("one of {}", names.join(", "))),
        };
        reader.missing(table, &names, none, &example);
        return nothing(reader, table);
    };
    for (other, other_value) in &given[1..] {
        let hint = format!("write a separate {} for each load", table.name());
        reader.exclusive(
            (kind.key.name, &value.span()),
            (other.key.name, &other_value.span()),
            &hint,
        );
    }
    if !on_ground {
        refuse_keys_of_curvatures(reader, table, kind.key.name);
    }
    let extent = if kind.is_distributed() {
        let [from, to] = stretch(reader, table, kind, on_ground, beam_length);
        let (start, end) = intensity(reader, table, kind, value);
        // The curvature per unit of the load is NaN if the depth or the thermal expansion is unreadable. The
        // unreadable value has been reported.
        let per = match kind.action {
            Action::Curvature => {
                curl::curvature_per(reader, table, kind.key.name, [from, to], curls)
            }
            _ => 1.0,
        };
        let [start, end] = [start, end].map(|value| if per.is_nan() { 0.0 } else { per * value });
        Extent::Distributed { from, to, start, end }
    } else {
        misplaced(reader, table, kind.key.name, &["from", "to"], "a load at a point needs `at`");
        let at = reader.required(table, "at");
        let size = reader.field(kind.key.name, value, kind.key.kind());
        let name = if kind.action == Action::Moment { "moment" } else { "force" };
        reader.place(table, name, &size);
        Extent::Point { at: at.value, size: size.value }
    };
    // Every kind of load that a table allows gives a valid load, so the placeholder is never used.
    Load::new(kind.action, extent, on_ground).unwrap_or_else(|| nothing(reader, table))
}

/// Placeholder for a load of unknown kind, so that later loads keep their numbers.
fn nothing(reader: &mut Reader, table: &Section) -> Load {
    let unreadable = Field::unreadable(table.span.clone());
    reader.place(table, "at", &unreadable);
    reader.place(table, "force", &unreadable);
    Load::point_force(f64::NAN, f64::NAN)
}

/// Reads the ends `from` and `to` of a distributed load. By default, a load on the beam covers the whole
/// beam.
fn stretch(
    reader: &mut Reader,
    table: &Section,
    kind: &LoadKind,
    on_ground: bool,
    beam_length: f64,
) -> [f64; 2] {
    let advice = match on_ground {
        true => "a distributed load has `from` and `to`",
        false => {
            "a distributed load has `from` and `to`; the defaults are 0 and the length of the beam"
        }
    };
    misplaced(reader, table, kind.key.name, &["at"], advice);
    [("from", 0.0), ("to", beam_length)].map(|(key, default)| {
        if on_ground {
            return reader.required(table, key).value;
        }
        let field = reader.quantity(table, key).unwrap_or_else(|| {
            // If the length of the beam is unreadable, the default of `to` is also unreadable.
            let whole = Field::new(default, table.span.clone());
            reader.place(table, key, &whole);
            whole
        });
        field.value
    })
}

/// Reads the values of a distributed load at `from` and at `to`. A single number describes a uniform load.
fn intensity(
    reader: &mut Reader,
    table: &Section,
    kind: &LoadKind,
    value: &Spanned<DeValue>,
) -> (f64, f64) {
    let (kind, wanted) = (kind.key.name, kind.key.kind());
    let (start, end) = match value.get_ref() {
        DeValue::Array(array) => match &array[..] {
            [start, end] => (reader.field(kind, start, wanted), reader.field(kind, end, wanted)),
            other => {
                let message = format!("`{kind}` has {} values", other.len());
                let example = reader.pair(wanted);
                let hint = format!(
                    "give one value for a uniform load, or two for one that varies from `from` to \
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
    reader.place(table, "start", &start);
    reader.place(table, "end", &end);
    (start.value, end.value)
}

/// Refuses `expansion` and `depth` for loads that do not use them.
fn refuse_keys_of_curvatures(reader: &mut Reader, table: &Section, kind: &str) {
    if kind != "temperature_difference" {
        let advice = "`expansion` is allowed only together with `temperature_difference`";
        misplaced(reader, table, kind, &["expansion"], advice);
    }
    let advice = match kind {
        "temperature_difference" | "shrinkage_difference" => return,
        "curvature" => "a curvature needs no depth",
        _ => {
            "`depth` is allowed only together with `temperature_difference` or `shrinkage_difference`"
        }
    };
    misplaced(reader, table, kind, &["depth"], advice);
}

fn misplaced(reader: &mut Reader, table: &Section, kind: &str, keys: &[&str], advice: &str) {
    for key in keys {
        if let Some((name, _)) = table.table.get_key_value(*key) {
            let message = format!("`{key}` cannot be combined with `{kind}`");
            reader.report(Fault::new(code::MISPLACED, name.span(), message, "", advice));
        }
    }
}
