//! Reads `[checks]`: the limits of a design.

use super::Ground;
use super::combination::{LIMIT_STATES, limit_states};
use crate::code;
use crate::combination::Recipe;
use crate::fault::Fault;
use crate::keys::{ALSO_WIDTH, Key, Table, quantity, table, words};
use crate::quantity::{RATIO, SETTLEMENT_LIMIT, STRESS_LIMIT, WIDTH, is_within_reach};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::design::{Checked, LimitState, LimitStates, Limits};

pub(super) static TABLE: Table = Table {
    name: "[checks]",
    keys: &[
        quantity(
            "bearing_pressure",
            &STRESS_LIMIT,
            "The allowable peak of the elastic pressure; point contact forces under the ends are printed separately.",
        ),
        quantity(
            "bearing_resistance",
            &STRESS_LIMIT,
            "The design resistance r_d per effective area B′ L′ in the check V_d ≤ r_d B′ L′ \
             (EN 1997-1, 6.5.2); in allowable stress design, the allowable pressure on the \
             effective area.",
        ),
        quantity(
            "width",
            &WIDTH,
            "The bearing width for `bearing_pressure` and `bearing_resistance`; default: the \
             `width` of `[foundation]`.",
        )
        .also(ALSO_WIDTH),
        quantity(
            "settlement",
            &SETTLEMENT_LIMIT,
            "The largest allowed downward deflection (EN 1997-1, 6.6).",
        ),
        quantity(
            "lifted_share",
            &RATIO,
            "The largest fraction of the beam length that may lift off, from 0 to 1.",
        ),
        quantity(
            "eccentricity",
            &RATIO,
            "The largest allowed distance of the resultant from the middle of the beam, as a \
             fraction of the beam length such as 0.25 or `\"l/6\"`.",
        ),
        quantity("overturning", &RATIO, "The smallest allowed load factor at which the beam tips."),
        table(
            "limit_states",
            &JUDGED_IN,
            "The limit states in which checks are judged, in place of the defaults.",
        ),
    ],
};

const fn judged_in(name: &'static str) -> Key {
    words(name, &LIMIT_STATES, "The limit states in which this check is carried out.")
}

static JUDGED_IN: Table = Table {
    name: "[checks.limit_states]",
    keys: &[
        judged_in("bearing_pressure"),
        judged_in("bearing_resistance"),
        judged_in("settlement"),
        judged_in("lifted_share"),
        judged_in("eccentricity"),
        judged_in("overturning"),
    ],
};

/// Reads the limits of the design checks. The bearing width is the width of the ground unless the file
/// gives another width.
pub(super) fn read(reader: &mut Reader, root: &Section, ground: &Ground) -> Limits {
    let Some(table) = reader.table(root, "checks") else { return Limits::default() };
    let mut positive = |key| {
        let field = reader.quantity(&table, key)?;
        Some(reader.positive(key, field))
    };
    let own_width = positive("width");
    let mut limit = |key| positive(key).map(|field| field.value);
    let pressure = limit("bearing_pressure");
    let resistance = limit("bearing_resistance");
    let settlement = limit("settlement");
    let overturning = limit("overturning");
    let lifted_share = lifted_share(reader, &table);
    let eccentricity = eccentricity(reader, &table);
    let width = own_width.as_ref().map(|width| width.value).or(ground.width);
    if pressure.is_some() || resistance.is_some() {
        if width.is_none() {
            let example = "the bearing `width` to [checks] or to [foundation]";
            reader.missing(&table, &["width"], "`width`", example);
        }
        refuse_other_widths(reader, own_width.as_ref(), ground);
    }
    let bearing_pressure = pressure.zip(width);
    let bearing_resistance = resistance.zip(width);
    let mut judged_in = [None; Checked::ALL.len()];
    if let Some(states) = reader.table(&table, "limit_states") {
        for (what, judged_in) in Checked::ALL.into_iter().zip(&mut judged_in) {
            let key = what.name().replace('-', "_");
            *judged_in = limit_states(reader, &states, &key);
            refuse_empty(reader, &states, &key);
        }
    }
    Limits {
        bearing_pressure,
        bearing_resistance,
        settlement,
        lifted_share,
        eccentricity,
        overturning,
        judged_in,
    }
}

/// Reports widths with which the bearing checks are unsafe: a `width` in `[checks]` above a local width of the ground,
/// or, without it, different local widths.
fn refuse_other_widths(reader: &mut Reader, own: Option<&Field>, ground: &Ground) {
    let mut widths = ground.local_widths.iter().filter(|width| width.is_readable());
    if let Some(own) = own {
        if let Some(narrow) = widths.find(|width| width.profile.smallest() < own.value) {
            let message = "the `width` of [checks] is larger than the smallest width of the ground";
            let hint = "write the smallest width of the ground, which is on the safe side";
            let fault = Fault::new(code::FACTOR, own.span.clone(), message, "", hint);
            reader.report_with(fault, narrow.span.clone(), "a smaller width");
        }
        return;
    }
    let Some(common) = ground.width else { return };
    let is_common = |value: &f64| *value == common;
    if let Some(other) = widths.find(|width| !width.profile.control_values().iter().all(is_common))
    {
        let message = "this width differs from the `width` of [foundation], but the bearing checks need a single width";
        let hint = "add `width` to [checks]: the smallest width of the ground is on the safe side";
        reader.report(Fault::new(code::INCOMPLETE, other.span.clone(), message, "", hint));
    }
}

/// Reports an empty list of limit states, because the check would then never be carried out.
fn refuse_empty(reader: &mut Reader, states: &Section, key: &str) {
    let Some(value) = states.empty_list(key) else { return };
    let message = format!("`{key}` names no limit state");
    let hint = "write a limit state, such as \"STR/GEO\", or leave the key out for the default";
    reader.report(Fault::new(code::EMPTY_NAME, value.span(), message, "", hint));
}

/// Makes allowable stress the default limit state of `bearing_resistance` if the combinations include allowable stress
/// but not STR/GEO.
pub(super) fn judge_resistance(limits: &mut Limits, recipes: &[Recipe]) {
    let any = |state| recipes.iter().any(|recipe| recipe.limit_states.contains(state));
    if any(LimitState::AllowableStress) && !any(LimitState::StrGeo) {
        let allowable = LimitStates::of(&[LimitState::AllowableStress]);
        limits.judged_in[Checked::BearingResistance.index()].get_or_insert(allowable);
    }
}

/// Reads the largest fraction of the beam length that may lift off, between 0 and 1.
fn lifted_share(reader: &mut Reader, table: &Section) -> Option<f64> {
    let share = reader.quantity(table, "lifted_share")?;
    if share.value < 0.0 || share.value > 1.0 {
        let message = "`lifted_share` must be a fraction of the beam's length, from 0 to 1";
        let hint = "write lifted_share = 0 for a beam that must not lift off";
        reader.report(Fault::new(code::FACTOR, share.span, message, "", hint));
    }
    Some(share.value)
}

/// Reads the largest allowed eccentricity, as a fraction of the beam length such as `0.25` or `"l/6"`.
fn eccentricity(reader: &mut Reader, table: &Section) -> Option<f64> {
    let value = table.value("eccentricity")?;
    let hint = "write \"l/6\" for the kern, or \"l/3\" for the limit of EN 1997-1, 6.5.4";
    let of_length =
        value.get_ref().as_str().map(str::trim).filter(|text| text.starts_with(['l', 'L']));
    let field = match of_length {
        Some(text) => {
            let parts = text[1..].trim_start().strip_prefix('/').map(str::trim);
            let parts = parts.and_then(|parts| parts.parse::<f64>().ok());
            let Some(parts) = parts.filter(|parts| is_within_reach(*parts)) else {
                let message = format!("`{text}` is not a fraction of the length");
                reader.report(Fault::new(code::NUMBER, value.span(), message, "", hint));
                return None;
            };
            Field::new(1.0 / parts, value.span())
        }
        None => reader.field("eccentricity", value, &RATIO),
    };
    if field.value <= 0.0 || field.value > 0.5 {
        let message = "`eccentricity` must be positive and at most half the beam length";
        reader.report(Fault::new(code::FACTOR, value.span(), message, "", hint));
    }
    Some(field.value)
}
