//! `[[support]]`.

use crate::code;
use crate::fault::Fault;
use crate::lists;
use crate::quantity::{CLEARANCE, POSITION, ROTATIONAL_SPRING, SPRING};
use crate::reader::{Field, Reader};
use crate::suggest::nearest;
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Acts, Support, SupportKind};

const KEYS: &[&str] = &["at", "type", "spring", "rotational_spring", "settlement", "acts"];

pub(super) fn read(reader: &mut Reader, root: &Section) -> Vec<Support> {
    let tables = reader.tables(root, &lists::SUPPORT);
    let mut supports = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        supports.push(read_one(reader, table, Part::Support(i)));
    }
    supports
}

fn read_one(reader: &mut Reader, table: &Section, part: Part) -> Support {
    reader.refuse_unknown(table, KEYS);
    reader.places.part(part, &table.span);
    let at = reader.required(table, "at", &POSITION);
    reader.places.field(part, "at", &at);
    let acts = acts(reader, table, part);
    let spring = reader.quantity(table, "spring", &SPRING);
    let rotational_spring = reader.quantity(table, "rotational_spring", &ROTATIONAL_SPRING);
    let settlement = reader.quantity(table, "settlement", &CLEARANCE);
    let settlement = settlement.unwrap_or_else(|| Field::new(0.0, table.span.clone()));
    reader.places.field(part, "settlement", &settlement);
    let settlement = settlement.value;

    if let Some(word) = table.value("type") {
        let springs = [("spring", &spring), ("rotational_spring", &rotational_spring)];
        for (key, field) in springs {
            if let Some(field) = field {
                let hint = "a support is rigid, with `type`, or elastic, with springs";
                reader.exclusive(("type", &word.span()), (key, &field.span), hint);
            }
        }
        return Support { at: at.value, kind: rigid(reader, table), settlement, acts };
    }
    if spring.is_none() && rotational_spring.is_none() {
        let spring = reader.line("spring", &SPRING);
        let example = format!("type = \"pinned\" or type = \"fixed\"; or {spring}");
        let keys = ["type", "spring", "rotational_spring"];
        reader.missing(table, &keys, "`type` and no spring", &example);
    }
    let mut constant = |key: &'static str, field: Option<Field>| {
        let field = field.unwrap_or_else(|| Field::new(0.0, table.span.clone()));
        reader.places.field(part, key, &field);
        field.value
    };
    let spring = constant("spring", spring);
    let rotational_spring = constant("rotational_spring", rotational_spring);
    let kind = SupportKind::Spring { spring, rotational_spring };
    Support { at: at.value, kind, settlement, acts }
}

/// In which directions it acts: both, if nothing is said.
fn acts(reader: &mut Reader, table: &Section, part: Part) -> Acts {
    let Some((word, span)) = reader.words(table, "acts", "up") else { return Acts::Both };
    reader.places.field(part, "acts", &Field::new(0.0, span.clone()));
    match word {
        "up" => Acts::Up,
        "down" => Acts::Down,
        "both" => Acts::Both,
        other => {
            let meant = match other.to_lowercase().as_str() {
                "compression" | "press" | "push" | "upward" | "upwards" => Some("up"),
                "tension" | "pull" | "hold-down" | "downward" | "downwards" => Some("down"),
                _ => nearest(other, ["up", "down", "both"]),
            };
            let choice =
                "`up` only pushes the beam up, `down` only holds it down, `both` does either";
            let hint = match meant {
                Some(word) => format!("did you mean \"{word}\"? {choice}"),
                None => choice.to_owned(),
            };
            let message = format!("`{other}` is no direction in which a support acts");
            reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
            Acts::Both
        }
    }
}

fn rigid(reader: &mut Reader, table: &Section) -> SupportKind {
    let words = ["pinned", "fixed"];
    match reader.words(table, "type", "pinned") {
        Some(("fixed", _)) => SupportKind::Fixed,
        Some(("pinned", _)) | None => SupportKind::Pinned,
        Some((other, span)) => {
            let meant = match other.to_lowercase().as_str() {
                "hinged" | "simple" | "hinge" | "pin" | "roller" => Some("pinned"),
                "clamped" | "built-in" | "encastre" | "rigid" => Some("fixed"),
                _ => nearest(other, words),
            };
            let choice = "`pinned` holds the deflection, `fixed` also the rotation";
            let hint = match meant {
                Some(word) => format!("did you mean \"{word}\"? {choice}"),
                None => choice.to_owned(),
            };
            let message = format!("`{other}` is no type of support");
            reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
            SupportKind::Pinned
        }
    }
}
