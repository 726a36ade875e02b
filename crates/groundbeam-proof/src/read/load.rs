//! Reads `[[load]]` and `[[ground_load]]`: forces, moments and imposed curvatures, each with its load case.

use super::beam::Depth;
use super::case::{Cased, case};
use super::error::{Read, Reason, fault, wrong};
use super::fields::{
    CURVATURE, EXPANSION, FORCE, FORCE_PER_LENGTH, Fields, Kind, LENGTH, MOMENT, NUMBER, POSITION,
    Quantity, Section, TEMPERATURE,
};
use super::place::{is_left, on_beam, ordered};
use super::toml::Node;
use crate::{Action, Extent, Load, Scalar};

/// Data of the beam for the imposed curvature from temperature and shrinkage.
pub(crate) struct Curls<'a, S> {
    pub depths: &'a [Depth<S>],
    pub expansion: Option<S>,
}

const ON_BEAM: [(&str, Kind, Action); 7] = [
    ("point", FORCE, Action::Force),
    ("moment", MOMENT, Action::Moment),
    ("distributed", FORCE_PER_LENGTH, Action::Force),
    ("distributed_moment", FORCE, Action::Moment),
    ("curvature", CURVATURE, Action::Curvature),
    ("temperature_difference", TEMPERATURE, Action::Curvature),
    ("shrinkage_difference", NUMBER, Action::Curvature),
];
const ON_GROUND: [&str; 2] = ["point", "distributed"];
const PLACES: &[&str] = &["at", "from", "to", "case"];

/// The loads on the beam.
pub(crate) fn read<S: Scalar>(
    fields: &mut Fields,
    root: Section,
    length: S,
    curls: &Curls<S>,
) -> Read<Vec<Cased<S>>> {
    let keys = ON_BEAM.map(|(key, ..)| key);
    let mut loads = Vec::new();
    for table in root.tables("load")? {
        table.only(&[&keys, &["expansion", "depth"], PLACES], &[])?;
        let (key, kind, action, node) = kind_of(table, &keys)?;
        let extent = if matches!(key, "point" | "moment") {
            let Quantity { value, at, .. } = place(fields, table)?;
            on_beam(value, length, at)?;
            Extent::Point { at: value, size: fields.one(node, key, kind)?.value }
        } else {
            table.without("at", key)?;
            let from: Option<Quantity<S>> = fields.quantity(table, "from", POSITION)?;
            let to: Option<Quantity<S>> = fields.quantity(table, "to", POSITION)?;
            for end in [&from, &to].into_iter().flatten() {
                on_beam(end.value, length, end.at)?;
            }
            let from = from.map_or(S::zero(), |from| from.value);
            let to = to.map_or(length, |to| to.value);
            let [from, to] = ordered([from, to], table.at)?;
            let sizes = fields.pair(node, key, kind)?;
            let per = curvature_per(fields, table, key, [from, to], curls)?;
            let [start, end] = sizes.map(|size: S| per.map_or(size, |per| size * per));
            Extent::Distributed { from, to, start, end }
        };
        if matches!(key, "point" | "moment" | "distributed" | "distributed_moment" | "curvature") {
            table.without("depth", key)?;
        }
        if key != "temperature_difference" {
            table.without("expansion", key)?;
        }
        let load = Load { action, extent, on_ground: false };
        loads.push(Cased { load, case: case(table, "case")?, at: node.at });
    }
    Ok(loads)
}

/// Reads the loads on the ground, which must act downward.
pub(crate) fn read_on_ground<S: Scalar>(fields: &mut Fields, root: Section) -> Read<Vec<Cased<S>>> {
    let mut loads = Vec::new();
    for table in root.tables("ground_load")? {
        table.only(&[&ON_GROUND, PLACES], &[])?;
        let (key, kind, action, node) = kind_of(table, &ON_GROUND)?;
        let (extent, sizes): (Extent<S>, [S; 2]) = if key == "point" {
            let at = place(fields, table)?.value;
            let size = fields.one(node, key, kind)?.value;
            (Extent::Point { at, size }, [size; 2])
        } else {
            table.without("at", key)?;
            let from: Quantity<S> = fields.required(table, "from", POSITION)?;
            let to: Quantity<S> = fields.required(table, "to", POSITION)?;
            let [from, to] = ordered([from.value, to.value], to.at)?;
            let [start, end] = fields.pair(node, key, kind)?;
            (Extent::Distributed { from, to, start, end }, [start, end])
        };
        if sizes.iter().any(|size| size.high() < 0.0) {
            return wrong(node.at, "a load on the ground must act downward");
        }
        let load = Load { action, extent, on_ground: true };
        loads.push(Cased { load, case: case(table, "case")?, at: node.at });
    }
    Ok(loads)
}

/// Returns the kind of load that a table gives. Fails unless the table gives exactly one kind.
fn kind_of<'t>(
    table: Section<'t>,
    keys: &[&'static str],
) -> Read<(&'static str, Kind, Action, &'t Node)> {
    let given = |(key, kind, action): (&'static str, Kind, Action)| {
        let node = table.table.get(key).filter(|_| keys.contains(&key))?;
        Some((key, kind, action, node))
    };
    let mut given = ON_BEAM.into_iter().filter_map(given);
    match (given.next(), given.next()) {
        (None, _) => table.missing("point"),
        (Some(one), None) => Ok(one),
        (Some(one), Some(other)) => fault(other.3.at, Reason::Together(one.0, other.0)),
    }
}

/// `at` of a point load.
fn place<S: Scalar>(fields: &mut Fields, table: Section) -> Read<Quantity<S>> {
    table.without("from", "at")?;
    table.without("to", "at")?;
    fields.required(table, "at", POSITION)
}

/// Returns the curvature per unit difference of temperature or shrinkage between top and bottom; `None` for other
/// loads. A warmer top bends the ends of the beam down, which is a positive curvature.
fn curvature_per<S: Scalar>(
    fields: &mut Fields,
    table: Section,
    key: &'static str,
    stretch: [S; 2],
    curls: &Curls<S>,
) -> Read<Option<S>> {
    let expansion = match key {
        "temperature_difference" => match fields.quantity::<S>(table, "expansion", EXPANSION)? {
            Some(given) => given.value,
            None => match curls.expansion {
                Some(expansion) => expansion,
                None => return table.missing("expansion"),
            },
        },
        "shrinkage_difference" => S::of(-1.0),
        _ => return Ok(None),
    };
    let depth = match fields.quantity::<S>(table, "depth", LENGTH)? {
        Some(given) => given.value,
        None => depth(table, stretch, curls.depths)?,
    };
    Ok(Some(expansion.div(depth)))
}

/// The depth of the cross section along a stretch. Fails if the depth is not constant along the stretch.
fn depth<S: Scalar>(table: Section, [from, to]: [S; 2], depths: &[Depth<S>]) -> Read<S> {
    let first = depths.partition_point(|depth| !is_left(from, depth.ends[1]));
    let under = |i: usize| depths.get(i).filter(|depth| is_left(depth.ends[0], to));
    match (under(first), under(first + 1)) {
        (Some(Depth { of: Some((_, depth)), .. }), None) => Ok(*depth),
        _ => table.missing("depth"),
    }
}
