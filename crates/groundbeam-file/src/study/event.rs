//! `[[event]]`: conditions whose probability is asked for.

use super::keep::field;
use crate::code;
use crate::fault::Fault;
use crate::keys::{Table, Value, key, text};
use crate::quantity::{CLEARANCE, FORCE, Kind, LOAD_PER_LENGTH, MOMENT, RATIO};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::{Dimension, Field};

pub(super) static TABLE: Table = Table {
    name: "[[event]]",
    keys: &[
        text("name", "bearing", "The name of the event.").needed(),
        text(
            "quantity",
            "pressure.max",
            "`lifted_share`, `left`, `right`, or a field's `.min`, `.max`, `.range`.",
        )
        .needed(),
        key("above", Value::Depends, "The event is that the number is above this limit."),
        key("below", Value::Depends, "The event is that it is below this limit."),
    ],
};

/// Something that may happen.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Its name.
    pub name: String,
    /// What of an answer it is judged by.
    pub of: Judged,
    /// On which side of the limit it has happened.
    pub side: Exceeds,
    /// The limit, in SI units or the file's own.
    pub limit: f64,
}

/// On which side of a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exceeds {
    /// `above`: more than the limit.
    Above,
    /// `below`: less than the limit.
    Below,
}

/// A number of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judged {
    /// `lifted_share`: how much of the beam does not touch, from 0 to 1.
    LiftedShare,
    /// `left` and `right`: the concentrated force under an end.
    EndForce(usize),
    /// `moment.min`: the smallest value of a field.
    Smallest(Field),
    /// `moment.max`: its largest value.
    Largest(Field),
    /// `deflection.range`: the difference of both.
    Difference(Field),
}

impl Judged {
    /// The number of a name.
    fn parse(name: &str) -> Result<Self, String> {
        let all = "lifted_share, left, right, and of a field its .min, .max or .range, as in pressure.max";
        Ok(match name.trim() {
            "lifted_share" => Judged::LiftedShare,
            "left" => Judged::EndForce(0),
            "right" => Judged::EndForce(1),
            other => {
                let (name, part) =
                    other.split_once('.').ok_or_else(|| format!("what can stand here: {all}"))?;
                let field = field(name)?;
                match part {
                    "min" => Judged::Smallest(field),
                    "max" => Judged::Largest(field),
                    "range" => Judged::Difference(field),
                    _ => return Err(format!("what can stand here: {all}")),
                }
            }
        })
    }

    /// The field of which extremes are needed.
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
                let hint = "of two limits make two events";
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
            () if events.iter().any(|event| event.name == name) => {
                Some((code::REPEATED, "another event has this name"))
            }
            () => None,
        };
        if let Some((code, message)) = fault {
            reader.report(Fault::new(
                code,
                span,
                message,
                "",
                "give every event a name of its own",
            ));
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
            let message = format!("`{name}` is no number of an answer");
            reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
            None
        }
    }
}
