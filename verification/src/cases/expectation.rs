//! Reads an expectation from a line `#: quantity = value tolerance`, and compares a result with the expected value.

use super::quantity::Quantity;
use super::scale::{Kind, scale};
use groundbeam::{Verdict, envelope::Envelope, solution::Side};
use groundbeam_file::{Document, UnitSystem};
use groundbeam_run::{Found, Passages};
use serde_json::Value as Json;

/// The expected value of a quantity, read from one line of a model file.
#[derive(Debug, Clone)]
pub struct Expectation {
    /// Number of the line in the file, counted from 1.
    pub line: usize,
    /// The result from which the computed value of the quantity is taken.
    pub of: Of,
    /// The text of the quantity.
    pub name: String,
    /// Text of the expected value, with its unit.
    pub value: String,
    /// The tolerance.
    pub tolerance: Tolerance,
    /// Reason for a wide tolerance. It may be empty if the tolerance allows for rounding errors only.
    pub why: String,
    quantity: Quantity,
    /// The expected value in the model's units.
    wanted: Wanted,
    /// Factor from the written unit to the model's unit.
    pub(super) scale: f64,
}

/// The result from which the computed value of an expected quantity is taken.
#[derive(Debug, Clone, PartialEq)]
pub enum Of {
    /// The result of a file without combinations.
    File,
    /// The result of one combination, as in `[ULS 1] max(moment)`.
    Combination(String),
    /// The envelope of all results, as in `[envelope] max(moment)`.
    Envelope,
}

/// The tolerance of an expectation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// No tolerance: the computed and the expected value must be equal.
    Same,
    /// An absolute tolerance, in the unit of the value.
    Absolute(f64),
    /// A tolerance relative to the largest of the values expected in the same line of the file.
    Relative(f64),
}

/// A computed value that can be compared with an expectation.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A verdict, or the name of a combination.
    Word(String),
    /// One number, or the ends of regions, in the unit of the expected value.
    Numbers(Vec<f64>),
}

#[derive(Debug, Clone, PartialEq)]
enum Wanted {
    Word(String),
    Numbers(Vec<f64>),
}

/// A relative tolerance up to this value allows for rounding errors only, and needs no reason.
const ROUNDING: f64 = 1e-9;

impl Expectation {
    /// Reads an expectation from the text after `#:`.
    ///
    /// # Errors
    ///
    /// Returns a description of the part of the text that is invalid.
    pub fn read(text: &str, line: usize, units: UnitSystem) -> Result<Expectation, String> {
        let (said, why) = text.split_once('#').unwrap_or((text, ""));
        let (of, said) = match said.trim_start().strip_prefix('[').and_then(|s| s.split_once(']')) {
            None => (Of::File, said),
            Some(("envelope", said)) => (Of::Envelope, said),
            Some((name, said)) => (Of::Combination(name.to_owned()), said),
        };
        let (name, rest) = said.split_once('=').ok_or("`=` is missing")?;
        let (name, rest, why) = (name.trim(), rest.trim(), why.trim());
        let quantity = Quantity::read(name, units)?;
        let (value, tolerance) = match rest.rfind(" abs ").or_else(|| rest.rfind(" rel ")) {
            Some(at) => {
                let size: f64 =
                    rest[at + 5..].trim().parse().map_err(|_| "the tolerance is not a number")?;
                let relative = rest[at..].starts_with(" rel");
                let tolerance =
                    if relative { Tolerance::Relative(size) } else { Tolerance::Absolute(size) };
                (rest[..at].trim(), tolerance)
            }
            None => (rest, Tolerance::Same),
        };
        let kind = quantity.kind();
        let (wanted, scale) = match kind {
            None => (Wanted::Word(value.to_owned()), 1.0),
            Some(kind) => numbers(value, kind, units)?,
        };
        let expectation = Expectation {
            line,
            of,
            name: name.to_owned(),
            value: value.to_owned(),
            tolerance,
            why: why.to_owned(),
            quantity,
            wanted,
            scale,
        };
        expectation.check()?;
        Ok(expectation)
    }

    fn check(&self) -> Result<(), String> {
        let wide = match (&self.wanted, self.tolerance) {
            (Wanted::Word(word), Tolerance::Same) => {
                let known = matches!(self.quantity, Quantity::Governs { .. })
                    || ["passes", "fails", "not judged"].contains(&word.as_str())
                    || ["unique", "not-unique", "none", "local"].contains(&word.as_str());
                return if known { Ok(()) } else { Err(format!("`{word}` is not a verdict")) };
            }
            (Wanted::Word(_), _) => return Err("a verdict has no tolerance".into()),
            (Wanted::Numbers(list), Tolerance::Same) => {
                let exact = list.is_empty() || self.quantity == Quantity::FailingMotion;
                return if exact { Ok(()) } else { Err("a number needs `abs` or `rel`".into()) };
            }
            (Wanted::Numbers(list), Tolerance::Absolute(size)) => {
                size * self.scale > ROUNDING * largest(list).max(self.scale)
            }
            (_, Tolerance::Relative(size)) => size > ROUNDING,
        };
        if wide && self.why.is_empty() {
            return Err(
                "the tolerance is wider than rounding errors: write a reason after `#`".into()
            );
        }
        Ok(())
    }

    /// Returns the value of the quantity in a result. Load factors are computed from the document alone.
    ///
    /// # Errors
    ///
    /// The result does not contain the quantity.
    pub fn found(&self, document: &Document, found: &Found) -> Result<Value, String> {
        let existence = found.existence().ok_or("there is no certified answer")?;
        let numbers = match (self.quantity, found) {
            (Quantity::Growth(growth), _) => growth.of(&self.name, document)?,
            (Quantity::Verdict, _) => {
                return Ok(Value::Word(word(existence.verdict).to_owned()));
            }
            (Quantity::StaticReaction(side), _) => {
                let [left, right] = existence.static_reactions;
                vec![if side == Side::Left { left } else { right }]
            }
            (Quantity::FailingMotion | Quantity::FailingWork, _) => match existence.verdict {
                Verdict::None(motion) | Verdict::NotUnique(motion) => {
                    if self.quantity == Quantity::FailingWork {
                        vec![motion.work]
                    } else {
                        vec![motion.left, motion.right]
                    }
                }
                Verdict::Buckles(mode) if self.quantity == Quantity::FailingWork => {
                    vec![mode.work]
                }
                Verdict::Buckles(mode) => vec![mode.left, mode.right],
                Verdict::Unique | Verdict::Local(_) => return Err("no motion fails".into()),
            },
            (Quantity::CriticalCompression, _) => match existence.verdict {
                Verdict::Local(local) => vec![local.critical_compression],
                Verdict::Buckles(mode) => vec![mode.critical_compression],
                _ => return Err("the beam is stable without the ground".into()),
            },
            (Quantity::StabilityMargin, _) => match existence.verdict {
                Verdict::Local(local) => vec![local.stability_margin],
                _ => return Err("the equilibrium is not local".into()),
            },
            (Quantity::Used(what, None), Found::Equilibrium(solution)) => {
                let checks = document.limits.check(solution);
                let check = checks.iter().find(|check| check.what == what);
                vec![check.ok_or("the file does not request this check")?.utilisation()]
            }
            (quantity, Found::Equilibrium(solution)) => quantity.of(solution)?,
            _ => return Err("there is no equilibrium".into()),
        };
        Ok(Value::Numbers(numbers.into_iter().map(|number| number / self.scale).collect()))
    }

    /// Returns the value of the quantity in an envelope of named solutions.
    ///
    /// # Errors
    ///
    /// The envelope does not contain the quantity.
    pub fn found_in_envelope(&self, envelope: &Envelope, names: &[&str]) -> Result<Value, String> {
        let of = |field, largest| {
            let range = envelope.range(field);
            if largest { range.max } else { range.min }
        };
        match self.quantity {
            Quantity::Extreme { field, largest, position } => {
                let extreme = of(field, largest).extreme;
                let number = if position { extreme.x } else { extreme.value };
                Ok(Value::Numbers(vec![number / self.scale]))
            }
            Quantity::Governs { field, largest } => {
                let name = names.get(of(field, largest).by);
                name.map(|name| Value::Word((*name).to_owned()))
                    .ok_or_else(|| "nothing was solved".to_owned())
            }
            _ => Err("an envelope contains only extreme values and the names of their governing solutions".to_owned()),
        }
    }

    /// Returns the verdict or the utilisation of a check from the result document; `None` for any other quantity.
    ///
    /// # Errors
    ///
    /// The result document does not contain the check.
    pub fn found_in_verdicts(&self, json: impl Fn() -> String) -> Option<Result<Value, String>> {
        let (Quantity::Used(what, state) | Quantity::Judged(what, state)) = self.quantity else {
            return None;
        };
        let document: serde_json::Value = serde_json::from_str(&json()).unwrap_or_default();
        let is_it = |check: &&serde_json::Value| {
            let of_state = check["limit_state"] == state.map_or(Json::Null, |s| s.name().into());
            check["name"] == what.name() && (of_state || check["passes"].is_null())
        };
        let found = document["checks"].as_array().and_then(|checks| checks.iter().find(is_it));
        let Some(check) = found else { return Some(Err("there is no such verdict".to_owned())) };
        Some(match (self.quantity, check["passes"].as_bool()) {
            (Quantity::Judged(..), passes) => Ok(Value::Word(
                match passes {
                    Some(true) => "passes",
                    Some(false) => "fails",
                    None => "not judged",
                }
                .to_owned(),
            )),
            _ => match check["utilisation"].as_f64() {
                Some(used) => Ok(Value::Numbers(vec![used])),
                None => Err("the check is not judged".to_owned()),
            },
        })
    }

    /// Returns the value of the quantity in the envelope of the passages of trains.
    ///
    /// # Errors
    ///
    /// The envelope of the passages does not contain the quantity.
    pub fn found_in_passages(&self, passages: &Passages) -> Result<Value, String> {
        let Quantity::Extreme { field, largest, position } = self.quantity else {
            return Err(
                "the envelope of a train contains only smallest and largest values".to_owned()
            );
        };
        let range = passages.range(field).ok_or("nothing was solved")?;
        let most = range[usize::from(largest)].located;
        let number = if position { most.x } else { most.value };
        Ok(Value::Numbers(vec![number / self.scale]))
    }

    /// Returns the difference from the expected value, in its unit and relative to the largest expected number.
    ///
    /// # Errors
    ///
    /// The two values have different texts or different numbers of regions.
    pub fn distance(&self, found: &Value) -> Result<(f64, f64), String> {
        match (&self.wanted, found) {
            (Wanted::Word(wanted), Value::Word(found)) if wanted == found => Ok((0.0, 0.0)),
            (Wanted::Numbers(wanted), Value::Numbers(found)) if wanted.len() == found.len() => {
                let size = largest(wanted) / self.scale;
                let pairs = wanted.iter().zip(found);
                let error = pairs.map(|(w, f)| (w / self.scale - f).abs()).fold(0.0, worse);
                Ok((error, if error == 0.0 { 0.0 } else { error / size }))
            }
            _ => Err(format!("{} is {}, not {}", self.name, shown(found), self.value)),
        }
    }

    /// Checks that a computed value agrees with the expected value within the tolerance.
    ///
    /// # Errors
    ///
    /// Returns a description of the difference between the two values.
    pub fn judge(&self, found: &Value) -> Result<(), String> {
        let (absolute, relative) = self.distance(found)?;
        let near = match self.tolerance {
            Tolerance::Same => absolute == 0.0,
            Tolerance::Absolute(size) => absolute <= size,
            Tolerance::Relative(size) => relative <= size,
        };
        if near {
            return Ok(());
        }
        Err(format!(
            "{} is {}, not {} (absolute difference {absolute:.1e}, relative difference {relative:.1e})",
            self.name,
            shown(found),
            self.value
        ))
    }
}

fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

fn largest(list: &[f64]) -> f64 {
    list.iter().fold(0.0, |size, number| number.abs().max(size))
}

fn shown(value: &Value) -> String {
    match value {
        Value::Word(word) => word.clone(),
        Value::Numbers(list) => format!("{list:?}"),
    }
}

fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Unique => "unique",
        Verdict::NotUnique(_) => "not-unique",
        Verdict::None(_) | Verdict::Buckles(_) => "none",
        Verdict::Local(_) => "local",
    }
}

/// Reads expected numbers such as `1.5 kN`, `[0, 1.5] m`, `[0, 1], [2, 3] m` or `none`. Returns the numbers and the
/// factor of their unit.
fn numbers(text: &str, kind: Kind, units: UnitSystem) -> Result<(Wanted, f64), String> {
    if text == "none" {
        return Ok((Wanted::Numbers(Vec::new()), 1.0));
    }
    let (list, unit) = match text.rfind(']') {
        Some(end) => (&text[..=end], text[end + 1..].trim()),
        None => match text.split_once(char::is_whitespace) {
            Some((number, unit)) => (number, unit.trim()),
            None => (text, ""),
        },
    };
    let scale = scale(kind, unit, units)?;
    let number = |word: &str| -> Result<f64, String> {
        let word = word.trim_matches(|c: char| c.is_whitespace() || c == '[' || c == ']');
        let value: f64 = word.parse().map_err(|_| format!("`{word}` is not a number"))?;
        Ok(value * scale)
    };
    let list = list.split(',').map(number).collect::<Result<_, _>>()?;
    Ok((Wanted::Numbers(list), scale))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Expectation, String> {
        Expectation::read(text, 1, UnitSystem::Si)
    }

    #[test]
    fn lines_are_read() {
        let line = read(" max(moment) = 17698 kip in abs 0.5 # printed without decimals").unwrap();
        assert_eq!((line.name.as_str(), line.value.as_str()), ("max(moment)", "17698 kip in"));
        assert_eq!(line.tolerance, Tolerance::Absolute(0.5));
        assert_eq!(line.why, "printed without decimals");
        let two = read("contact = [0, 1], [250, 300] cm abs 1e-12").unwrap();
        assert_eq!(two.wanted, Wanted::Numbers(vec![0.0, 0.01, 2.5, 3.0]));
        assert!(read("verdict = none").is_ok());
        assert!(read("moment(left of 6 m) = -1 kN m rel 1e-12").is_ok());
    }

    #[test]
    fn what_cannot_be_meant_is_refused() {
        for text in [
            "deflection(1 m) = 2 mm",
            "deflection(1 m) = 2 mm rel 1e-3",
            "deflection(1) = 2 mm rel 1e-12",
            "deflection(1 m) = 2 rel 1e-12",
            "deflection(1 m) = 2 kN rel 1e-12",
            "deflexion(1 m) = 2 mm rel 1e-12",
            "end_force(middle) = 2 N rel 1e-12",
            "verdict = perhaps",
            "verdict = none rel 1e-3",
            "contact",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
