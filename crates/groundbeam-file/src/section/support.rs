//! Reads `[[support]]`.

use crate::keys::{ALSO_AT, Table, Words, quantity, word};
use crate::quantity::{CLEARANCE, POSITION, ROTATIONAL_SPRING, SPRING};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Support, SupportKind, model::Acts};

static TYPES: Words = Words {
    all: || vec!["pinned", "fixed"],
    also: &[
        ("pinned", &["hinged", "simple", "hinge", "pin", "roller"]),
        ("fixed", &["clamped", "built-in", "encastre", "rigid"]),
    ],
    message: "`{}` is not a support type",
    hint: "`pinned` prevents deflection, and `fixed` prevents deflection and rotation",
};

static DIRECTIONS: Words = Words {
    all: || vec!["up", "down", "both"],
    also: &[
        ("up", &["compression", "press", "push", "upward", "upwards"]),
        ("down", &["tension", "pull", "hold-down", "downward", "downwards"]),
    ],
    message: "`{}` is not a support direction",
    hint: "`up` only pushes the beam up, `down` only holds it down, and `both` acts in both directions",
};

pub(super) static TABLE: Table = Table {
    name: "[[support]]",
    keys: &[
        quantity("at", &POSITION, "The position on the beam.").needed().also(ALSO_AT),
        word(
            "type",
            &TYPES,
            "The type of a rigid support: `pinned` requires w = 0, and `fixed` requires w = 0 \
             and w′ = 0.",
        )
        .also(&["kind"]),
        quantity("spring", &SPRING, "The spring of an elastic support, as a force per deflection.")
            .also(&["k", "stiffness", "spring_constant"]),
        quantity(
            "rotational_spring",
            &ROTATIONAL_SPRING,
            "The rotational spring of an elastic support, as a moment per angle.",
        )
        .also(&["k_r", "kr", "rotation", "rotational"]),
        quantity(
            "settlement",
            &CLEARANCE,
            "The settlement of the support, positive downward; default: 0.",
        ),
        word(
            "acts",
            &DIRECTIONS,
            "The direction of the reaction: `up` only pushes the beam up, `down` only holds it \
             down; default: `both`.",
        )
        .also(&["direction", "one_way", "only"]),
    ],
};

pub(super) fn read(reader: &mut Reader, root: &Section) -> Vec<Support> {
    let tables = reader.parts(root, "support", Part::Support);
    tables.iter().map(|table| read_one(reader, table)).collect()
}

fn read_one(reader: &mut Reader, table: &Section) -> Support {
    let at = reader.required(table, "at").value;
    let acts = acts(reader, table);
    let [spring, rotational_spring, settlement] =
        ["spring", "rotational_spring", "settlement"].map(|key| reader.quantity(table, key));
    let value = |field: &Option<Field>| field.as_ref().map_or(0.0, |field| field.value);
    let settlement = value(&settlement);
    if let Some(word) = table.value("type") {
        let springs = [("spring", &spring), ("rotational_spring", &rotational_spring)];
        for (key, field) in springs {
            if let Some(field) = field {
                let hint = "a rigid support has `type`, and an elastic support has springs";
                reader.exclusive(("type", &word.span()), (key, &field.span), hint);
            }
        }
        let kind = match reader.word(table, "type") {
            Some("fixed") => SupportKind::Fixed,
            _ => SupportKind::Pinned,
        };
        return Support { at, kind, settlement, acts };
    }
    if spring.is_none() && rotational_spring.is_none() {
        let spring = reader.line(&TABLE, "spring");
        let example = format!("type = \"pinned\", type = \"fixed\" or {spring}");
        let keys = ["type", "spring", "rotational_spring"];
        reader.missing(table, &keys, "`type` and no spring", &example);
    }
    let kind = SupportKind::Spring {
        spring: value(&spring),
        rotational_spring: value(&rotational_spring),
    };
    Support { at, kind, settlement, acts }
}

/// Reads the directions in which the support acts; the default is both directions.
fn acts(reader: &mut Reader, table: &Section) -> Acts {
    if let Some(value) = table.value("acts") {
        reader.place(table, "acts", &Field::new(0.0, value.span()));
    }
    match reader.word(table, "acts") {
        Some("up") => Acts::Up,
        Some("down") => Acts::Down,
        _ => Acts::Both,
    }
}
