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
use groundbeam::Load;
use groundbeam::model::Part;
use toml::Spanned;
use toml::de::DeValue;

const KEYS: &[&str] = &[
    "point",
    "moment",
    "distributed",
    "distributed_moment",
    "curvature",
    "temperature_difference",
    "shrinkage_difference",
    "expansion",
    "depth",
    "at",
    "from",
    "to",
    "case",
];
const KINDS: [&str; 7] = [
    "point",
    "moment",
    "distributed",
    "distributed_moment",
    "curvature",
    "temperature_difference",
    "shrinkage_difference",
];
const GROUND_KEYS: &[&str] = &["point", "distributed", "at", "from", "to", "case"];

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
        loads.push(read_one(reader, table, Part::Load(i), beam_length, curls));
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
        let load = on_ground(reader, table, Part::Load(first + i));
        loads.push((load, case(reader, table)));
    }
    loads
}

fn on_ground(reader: &mut Reader, table: &Section, part: Part) -> Load {
    reader.refuse_unknown(table, GROUND_KEYS);
    reader.places.part(part, &table.span);
    let (point_force, spread) = (table.value("point"), table.value("distributed"));
    match (point_force, spread) {
        (Some(value), other) => {
            if let Some(other) = other {
                let hint = "give each load a [[ground_load]] of its own";
                reader.exclusive(("point", &value.span()), ("distributed", &other.span()), hint);
            }
            let (at, force) =
                point(reader, table, part, &GROUND_POSITION, ("point", value, &FORCE));
            reader.places.field(part, "force", &force);
            Load::GroundForce { at: at.value, force: force.value }
        }
        (None, Some(value)) => {
            misplaced(
                reader,
                table,
                "distributed",
                &["at"],
                "a distributed load has `from` and `to`",
            );
            let ends = ["from", "to"].map(|key| {
                let end = reader.required(table, key, &GROUND_POSITION);
                reader.places.field(part, key, &end);
                end.value
            });
            let (start, end) = intensity(reader, part, "distributed", value, &LOAD_PER_LENGTH);
            Load::GroundDistributed { from: ends[0], to: ends[1], start, end }
        }
        (None, None) => {
            reader.missing(table, &["point", "distributed"], "force", "point or distributed");
            nothing(reader, part, table)
        }
    }
}

fn read_one(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    beam_length: f64,
    curls: &Curls,
) -> Load {
    reader.refuse_unknown(table, KEYS);
    reader.places.part(part, &table.span);
    let mut kinds: Vec<(&str, &Spanned<DeValue>)> =
        KINDS.iter().filter_map(|&kind| Some((kind, table.value(kind)?))).collect();
    kinds.sort_by_key(|(_, value)| value.span().start);
    let Some(&(kind, value)) = kinds.first() else {
        let example = format!("one of {}", KINDS.join(", "));
        reader.missing(table, &KINDS, "force, moment or curvature", &example);
        return nothing(reader, part, table);
    };
    for (other, other_value) in &kinds[1..] {
        let hint = "give each load a [[load]] of its own";
        reader.exclusive((kind, &value.span()), (other, &other_value.span()), hint);
    }
    match kind {
        "point" => {
            let (at, force) = point(reader, table, part, &POSITION, (kind, value, &FORCE));
            reader.places.field(part, "force", &force);
            Load::PointForce { at: at.value, force: force.value }
        }
        "moment" => {
            let (at, moment) = point(reader, table, part, &POSITION, (kind, value, &MOMENT));
            reader.places.field(part, "moment", &moment);
            Load::PointMoment { at: at.value, moment: moment.value }
        }
        "distributed" => {
            let (from, to) = stretch(reader, table, part, kind, beam_length);
            let (start, end) = intensity(reader, part, kind, value, &LOAD_PER_LENGTH);
            Load::Distributed { from, to, start, end }
        }
        "distributed_moment" => {
            let (from, to) = stretch(reader, table, part, kind, beam_length);
            let (start, end) = intensity(reader, part, kind, value, &MOMENT_PER_LENGTH);
            Load::DistributedMoment { from, to, start, end }
        }
        _ => {
            let (from, to) = stretch(reader, table, part, kind, beam_length);
            let wanted = match kind {
                "curvature" => &CURVATURE,
                "temperature_difference" => &TEMPERATURE,
                _ => &STRAIN,
            };
            let (start, end) = intensity(reader, part, kind, value, wanted);
            // What is missing has been reported.
            let per = curl::curvature_per(reader, table, kind, [from, to], curls);
            let [start, end] =
                [start, end].map(|value| if per.is_nan() { 0.0 } else { per * value });
            Load::Curvature { from, to, start, end }
        }
    }
}

/// Keeps the place of a load of unknown kind in the list, so that those after it keep theirs.
fn nothing(reader: &mut Reader, part: Part, table: &Section) -> Load {
    let unreadable = Field::unreadable(table.span.clone());
    reader.places.field(part, "at", &unreadable);
    reader.places.field(part, "force", &unreadable);
    Load::point(f64::NAN, f64::NAN)
}

fn point(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    position: &'static Kind,
    (kind, value, wanted): (&str, &Spanned<DeValue>, &'static Kind),
) -> (Field, Field) {
    misplaced(reader, table, kind, &["from", "to"], "a load at a point has `at`");
    let at = reader.required(table, "at", position);
    reader.places.field(part, "at", &at);
    (at, reader.field(kind, value, wanted))
}

/// `from` and `to`; left out, the beam's ends.
fn stretch(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    kind: &str,
    beam_length: f64,
) -> (f64, f64) {
    let advice =
        "a distributed load has `from` and `to`, or neither: then it covers the whole beam";
    misplaced(reader, table, kind, &["at"], advice);
    let mut end = |key: &'static str, default: f64| {
        let field = reader.quantity(table, key, &POSITION);
        let field = field.unwrap_or_else(|| Field::new(default, table.span.clone()));
        reader.places.field(part, key, &field);
        field.value
    };
    (end("from", 0.0), end("to", beam_length))
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

fn misplaced(reader: &mut Reader, table: &Section, kind: &str, keys: &[&str], advice: &str) {
    for key in keys {
        if let Some((name, _)) = table.table.get_key_value(*key) {
            let message = format!("`{key}` does not go with `{kind}`");
            reader.report(Fault::new(code::MISPLACED, name.span(), message, "", advice));
        }
    }
}
