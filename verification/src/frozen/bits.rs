//! Compares two answers bit for bit, and counts the units in the last place between their numbers.

use super::Frozen;
use super::record::Record;
use std::fmt;

/// A quantity in which two answers differ.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Family and number of the model, such as `Hard 7371`.
    pub title: String,
    /// Key of the line and index of the number in the line.
    pub quantity: String,
    /// The frozen text.
    pub frozen: String,
    /// The present text.
    pub present: String,
    /// Size of the difference, with its unit; may be empty.
    pub size: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Difference { title, quantity, frozen, present, size } = self;
        write!(f, "{title}: {quantity}: {frozen} frozen, {present} now")?;
        if size.is_empty() { Ok(()) } else { write!(f, ", {size}") }
    }
}

/// Returns every value whose bits differ between a frozen answer and the present answer.
pub fn differences(frozen: &Frozen, present: &Frozen) -> Vec<Difference> {
    of_records(&frozen.answer, &present.answer)
}

fn of_records(frozen: &Record, present: &Record) -> Vec<Difference> {
    let mut keys: Vec<&str> = frozen.lines.iter().map(|line| line.key.as_str()).collect();
    let new = present.lines.iter().map(|line| line.key.as_str());
    keys.extend(new.filter(|key| frozen.line(key).is_none()));
    let words =
        |record: &Record, key: &str| record.line(key).map_or(Vec::new(), |line| line.words.clone());
    let mut found = Vec::new();
    for key in keys {
        let [old, new] = [words(frozen, key), words(present, key)];
        for i in 0..old.len().max(new.len()) {
            let [old, new] = [&old, &new].map(|words| words.get(i).map_or("-", String::as_str));
            if old != new {
                found.push(Difference {
                    title: frozen.title.clone(),
                    quantity: format!("{key}[{i}]"),
                    frozen: old.to_owned(),
                    present: new.to_owned(),
                    size: units_between(old, new).map_or_else(String::new, |n| format!("{n} ulp")),
                });
            }
        }
    }
    found
}

/// Returns the number of floating-point steps between two numbers, given as texts; `None` if a text is not a number.
fn units_between(a: &str, b: &str) -> Option<u64> {
    let place = |word: &str| {
        let bits = word.parse::<f64>().ok().filter(|value| !value.is_nan())?.to_bits() as i64;
        Some(if bits < 0 { i64::MIN.wrapping_sub(bits) } else { bits })
    };
    Some(place(a)?.abs_diff(place(b)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_in_the_last_place_are_counted() {
        assert_eq!(units_between("1.0", "1.0000000000000002"), Some(1));
        assert_eq!(units_between("-5e-324", "5e-324"), Some(2));
        assert_eq!(units_between("0.0", "-0.0"), Some(0));
        assert_eq!(units_between("unique", "1.0"), None);
    }

    #[test]
    fn every_kind_of_difference_is_found() {
        let record = |lines: &str| Record::new("Plain 0", lines);
        let frozen = record("verdict unique\ncontact 0.0 1.0\nhinges\n");
        assert_eq!(of_records(&frozen, &frozen), []);
        for other in [
            "verdict local\ncontact 0.0 1.0\nhinges\n",
            "verdict unique\ncontact -0.0 1.0\nhinges\n",
            "verdict unique\ncontact 0.0\nhinges\n",
            "verdict unique\ncontact 0.0 1.0\nhinges 1.0\n",
            "verdict unique\nhinges\ncontact 0.0 1.0 2.0\n",
            "verdict unique\ncontact 0.0 1.0\nhinges\nreactions 1.0\n",
        ] {
            assert_eq!(of_records(&frozen, &record(other)).len(), 1, "{other}");
        }
    }
}
