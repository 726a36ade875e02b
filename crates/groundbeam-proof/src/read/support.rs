//! Reads `[[support]]`, `[[hinge]]` and `[[gap]]`.

use super::error::{Read, Reason, fault, wrong};
use super::fields::{DEFLECTION, Fields, POSITION, Quantity, ROTATIONAL_SPRING, SPRING, Section};
use super::place::{is_left, on_beam};
use crate::{Acts, GapCorner, Hinge, Scalar, Support, SupportKind};

const KEYS: &[&str] = &["at", "type", "spring", "rotational_spring", "settlement", "acts"];

/// The supports.
pub(crate) fn supports<S: Scalar>(
    fields: &mut Fields,
    root: Section,
    length: S,
) -> Read<Vec<Support<S>>> {
    let mut supports = Vec::new();
    for table in root.tables("support")? {
        table.only(&[KEYS], &[])?;
        let at = position(fields, table, length)?;
        let spring: Option<Quantity<S>> = fields.quantity(table, "spring", SPRING)?;
        let turning: Option<Quantity<S>> =
            fields.quantity(table, "rotational_spring", ROTATIONAL_SPRING)?;
        let settlement: Option<Quantity<S>> = fields.quantity(table, "settlement", DEFLECTION)?;
        let kind = match (table.words("type")?, &spring, &turning) {
            (Some((_, at)), Some(_), _) => return fault(at, Reason::Together("type", "spring")),
            (Some((_, at)), _, Some(_)) => {
                return fault(at, Reason::Together("type", "rotational_spring"));
            }
            (Some(("pinned", _)), ..) => SupportKind::Pinned,
            (Some(("fixed", _)), ..) => SupportKind::Fixed,
            (Some((_, at)), ..) => return wrong(at, "`type` must be \"pinned\" or \"fixed\""),
            (None, None, None) => return table.missing("type"),
            (None, spring, turning) => {
                let value =
                    |given: &Option<Quantity<S>>| given.as_ref().map_or(S::zero(), |q| q.value);
                SupportKind::Spring { spring: value(spring), rotational_spring: value(turning) }
            }
        };
        let acts = match table.words("acts")? {
            None | Some(("both", _)) => Acts::Both,
            Some(("up", _)) => Acts::Up,
            Some(("down", _)) => Acts::Down,
            Some((_, at)) => {
                return wrong(at, "`acts` of a support must be \"up\", \"down\" or \"both\"");
            }
        };
        let holds_slope = match &kind {
            SupportKind::Pinned => false,
            SupportKind::Fixed => true,
            SupportKind::Spring { .. } => turning.is_some_and(|turning| !turning.exact.is_zero()),
        };
        if holds_slope && acts != Acts::Both {
            return wrong(
                table.at,
                "a support that restrains the slope must act in both directions",
            );
        }
        let settlement = settlement.map_or(S::zero(), |settlement| settlement.value);
        supports.push(Support { at, kind, settlement, acts });
    }
    Ok(supports)
}

/// The hinges.
pub(crate) fn hinges<S: Scalar>(
    fields: &mut Fields,
    root: Section,
    length: S,
) -> Read<Vec<Hinge<S>>> {
    let mut hinges = Vec::new();
    for table in root.tables("hinge")? {
        table.only(&[&["at", "rotational_spring"]], &[])?;
        let at = position(fields, table, length)?;
        if !(is_left(S::zero(), at) && is_left(at, length)) {
            return wrong(table.at, "a hinge must lie between the beam's ends");
        }
        let spring: Option<Quantity<S>> =
            fields.quantity(table, "rotational_spring", ROTATIONAL_SPRING)?;
        let rotational_spring = spring.map_or(S::zero(), |spring| spring.value);
        hinges.push(Hinge { at, rotational_spring });
    }
    Ok(hinges)
}

/// Reads the points (position, value) between which the initial gap is linear.
pub(crate) fn gap<S: Scalar>(
    fields: &mut Fields,
    root: Section,
    length: S,
) -> Read<Vec<GapCorner<S>>> {
    let mut gap: Vec<GapCorner<S>> = Vec::new();
    for table in root.tables("gap")? {
        table.only(&[&["at", "value"]], &[])?;
        let at = position(fields, table, length)?;
        if gap.last().is_some_and(|last| !is_left(last.at, at)) {
            return wrong(
                table.at,
                "the corners of the initial gap must be in order from left to right",
            );
        }
        let value = fields.required::<S>(table, "value", DEFLECTION)?.value;
        gap.push(GapCorner { at, value });
    }
    Ok(gap)
}

fn position<S: Scalar>(fields: &mut Fields, table: Section, length: S) -> Read<S> {
    let Quantity { value, at, .. } = fields.required(table, "at", POSITION)?;
    on_beam(value, length, at)?;
    Ok(value)
}
