//! Reads `[[event]]`: conditions whose probability a study estimates.

use super::keep::field;
use crate::code;
use crate::fault::Fault;
use crate::keys::{Table, Value, key, text};
use crate::quantity::{CLEARANCE, FORCE, Kind, LOAD_PER_LENGTH, MOMENT, RATIO};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::{Field, solution::Dimension};

pub(super) static TABLE: Table = Table {
    name: "[[event]]",
    keys: &[
        text("name", "bearing", "The name of the event.").needed(),
        text(
            "quantity",
            "pressure.max",
            "The result: `lifted_share`, `left`, `right`, or a field with `.min`, `.max` or `.range`.",
        )
        .needed(),
        key("above", Value::Depends, "The event occurs if the result is above this limit."),
        key("below", Value::Depends, "The event occurs if the result is below this limit."),
    ],
};

/// Names of the events that every study has.
pub const BUILT_IN: [&str; 2] = ["no equilibrium", "some of the beam lifts off"];

/// An event whose probability is estimated.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Name of the event.
    pub name: String,
    /// Result that decides whether the event occurs.
    pub of: Judged,
    /// Side of the limit on which the event occurs.
    pub side: Exceeds,
    /// Limit for the result in SI units; in a file without units, in the units of the file.
    pub limit: f64,
}

/// Side of a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exceeds {
    /// `above`: the event occurs if the result is larger than the limit.
    Above,
    /// `below`: the event occurs if the result is smaller than the limit.
    Below,
}

/// A scalar result of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judged {
    /// `lifted_share`: fraction of the beam length that is not in contact with the ground, from 0 to 1.
    LiftedShare,
    /// `left` or `right`: concentrated contact force under the left (0) or the right (1) end of the beam.
    EndForce(usize),
    /// Smallest value of a field along the beam, such as `moment.min`.
    Smallest(Field),
    /// Largest value of a field along the beam, such as `moment.max`.
    Largest(Field),
    /// Largest value of a field minus its smallest value, such as `deflection.range`.
    Difference(Field),
}

impl Judged {
    /// Parses the name of a result. The error message lists the allowed names.
    fn parse(name: &str) -> Result<Self, String> {
        let all =
            "lifted_share, left, right, or a field with .min, .max or .range, as in pressure.max";
        Ok(match name.trim() {
            "lifted_share" => Judged::LiftedShare,
            "left" => Judged::EndForce(0),
            "right" => Judged::EndForce(1),
            other => {
                let (name, part) =
                    other.split_once('.').ok_or_else(|| format!("allowed here: {all}"))?;
                let field = field(name)?;
                match part {
                    "min" => Judged::Smallest(field),
                    "max" => Judged::Largest(field),
                    "range" => Judged::Difference(field),
                    _ => return Err(format!("allowed here: {all}")),
                }
            }
        })
    }

    /// Returns the field whose extreme values decide whether the event occurs; `None` if the result is not a field.
    pub fn field(self) -> Option<Field> {
        match self {
            Judged::Smallest(field) | Judged::Largest(field) | Judged::Difference(field) => {
                Some(field)
            }
            _ => None,
        }
    }

    fn kind(self) -> &'static Kind {
        match self {
            Judged::LiftedShare => &RATIO,
            Judged::EndForce(_) => &FORCE,
            Judged::Smallest(field) | Judged::Largest(field) | Judged::Difference(field) => {
                match field.dimension() {
                    Dimension::Length => &CLEARANCE,
                    Dimension::Angle => &RATIO,
                    Dimension::Moment => &MOMENT,
                    Dimension::Force => &FORCE,
                    Dimension::ForcePerLength => &LOAD_PER_LENGTH,
                }
            }
        }
    }
}

pub(super) fn read(reader: &mut Reader, root: &Section) -> Vec<Event> {
    let mut events: Vec<Event> = Vec::new();
    for table in reader.tables(root, "event") {
        let of = judged(reader, &table);
        let kind = of.map_or(&RATIO, Judged::kind);
        let [above, below] = ["above", "below"].map(|key| reader.quantity_of(&table, key, kind));
        let limit = match (above, below) {
            (Some(above), Some(below)) => {
                let hint = "write one [[event]] for each limit";
                reader.exclusive(("above", &above.span), ("below", &below.span), hint);
                continue;
            }
            (Some(above), None) => (Exceeds::Above, above.value),
            (None, Some(below)) => (Exceeds::Below, below.value),
            (None, None) => {
                let example = kind.line("above", reader.is_plain());
                reader.missing(&table, &["above", "below"], "limit", &example);
                continue;
            }
        };
        let Some((name, span)) = reader.text(&table, "name") else { continue };
        let name = name.trim().to_owned();
        let fault = match () {
            () if name.is_empty() => Some((code::EMPTY_NAME, "the event's name is empty")),
            () if BUILT_IN.contains(&&*name) => {
                Some((code::REPEATED, "this name is reserved: every study has this event"))
            }
            () if events.iter().any(|event| event.name == name) => {
                Some((code::REPEATED, "another event has this name"))
            }
            () => None,
        };
        if let Some((code, message)) = fault {
            reader.report(Fault::new(code, span, message, "", "give each event a name of its own"));
            continue;
        }
        if let Some(of) = of {
            events.push(Event { name, of, side: limit.0, limit: limit.1 });
        }
    }
    events
}

fn judged(reader: &mut Reader, table: &Section) -> Option<Judged> {
    let (name, span) = reader.text(table, "quantity")?;
    match Judged::parse(name) {
        Ok(judged) => Some(judged),
        Err(hint) => {
            let message = format!("`{name}` is not a result of a solve");
            reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
            None
        }
    }
}
