//! Reads `[foundation.band]`: lower and upper factors on k and μ.

use crate::band::Band;
use crate::code;
use crate::fault::Fault;
use crate::keys::{Table, Value, key};
use crate::quantity::RATIO;
use crate::reader::Reader;
use crate::table::Section;
use toml::de::DeValue;

const MULTIPLES: Value = Value::List(&Value::Quantity(&RATIO), [2, 2]);

pub(super) static TABLE: Table = Table {
    name: "[foundation.band]",
    keys: &[
        key("k", MULTIPLES, "Lower and upper factor on k; default: [1, 1]."),
        key("mu", MULTIPLES, "Lower and upper factor on mu; default: [1, 1]."),
    ],
};

/// Reads the factors on k and μ, if the file gives any. `shears` is true if the ground has a shear layer.
/// Without a shear layer, the table must not contain `mu`.
pub(super) fn read(reader: &mut Reader, foundation: &Section, shears: bool) -> Option<Band> {
    let table = reader.table(foundation, "band")?;
    if TABLE.names().iter().all(|key| table.value(key).is_none()) {
        reader.missing(
            &table,
            &TABLE.names(),
            "`k` and no `mu`",
            "k = [0.5, 2]: lower and upper factor on k",
        );
    }
    if let (Some(value), false) = (table.value("mu"), shears) {
        let message = "`[foundation.band]` has factors for `mu`, but the ground has no shear layer";
        let hint = "give the ground a `mu`, or leave the band of `mu` out";
        reader.report(Fault::new(code::FACTOR, value.span(), message, "", hint));
    }
    let [spring, shear] = ["k", "mu"].map(|key| multiples(reader, &table, key));
    Some(Band { spring: spring?, shear: shear? })
}

/// Reads the lower factor (at most 1) and the upper factor (at least 1) under `key`. The default is [1, 1].
fn multiples(reader: &mut Reader, table: &Section, key: &'static str) -> Option<[f64; 2]> {
    let Some(value) = table.value(key) else { return Some([1.0, 1.0]) };
    let values = match value.get_ref() {
        DeValue::Array(values) if values.len() == 2 => values,
        _ => {
            let message = format!("the band of `{key}` must be a list of two factors");
            reader.wrong_type(value, message, format!("write for example {key} = [0.5, 2]"));
            return None;
        }
    };
    let read: Vec<f64> = values.iter().map(|v| reader.field(key, v, &RATIO).value).collect();
    let [low, high] = read[..] else { return None };
    if low.is_nan() || high.is_nan() {
        return None;
    }
    let least = if key == "mu" { low >= 0.0 } else { low > 0.0 };
    if !(least && low <= 1.0 && high >= 1.0) {
        let message = format!("the band of `{key}` must include the factor 1");
        let hint = "give a positive factor of at most 1 and a factor of at least 1, as in [0.5, 2]";
        reader.report(Fault::new(code::FACTOR, value.span(), message, "", hint));
        return None;
    }
    Some([low, high])
}
