//! Parses and checks the query of a web address.

use crate::reply::Reply;
use groundbeam::Cancel;
use groundbeam_file::{Document, print};
use serde_json::json;

/// The requested part of a file; an empty query requests all of it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Asked {
    /// Name of the requested combination.
    pub combination: Option<String>,
    /// Requested trains of the file.
    pub train: Option<Trains>,
    /// Position of the first axle of the requested train \[m\].
    pub first_axle: Option<f64>,
    /// Width of the picture.
    pub width: Option<f64>,
    /// Units of the results in texts and pictures.
    pub units: print::Asked,
    /// Number of significant digits of results.
    pub digits: Option<usize>,
    /// Signal that cancels the solve after the client has disconnected.
    pub cancel: Cancel,
}

/// The requested trains.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trains {
    /// All trains of the file, at all positions.
    All,
    /// The train with this index in the file, at one position.
    One(usize),
}

/// Keys of a query for a result document, which is always in SI units.
pub const SOLVE: &[&str] = &["combination", "train", "first_axle"];
/// Keys of a query for a downloaded file.
pub const FILE: &[&str] = &["combination", "train", "first_axle", "units", "digits"];
/// Keys of a query for a calculation report.
pub const REPORT: &[&str] = &["combination", "units", "digits"];
/// Keys of a query for the data that the page shows.
pub const VIEW: &[&str] = &["combination", "train", "first_axle", "units", "digits", "width"];

/// Error of an invalid query, with the key and the value that are refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrongQuery {
    key: String,
    value: String,
    message: String,
}

impl WrongQuery {
    /// Returns the error for a value that its key does not allow. `allowed` says what the value must be.
    fn value(key: &str, value: &str, allowed: &str) -> Self {
        let message = format!("`{key}={value}` in the query is refused: `{key}` must be {allowed}");
        WrongQuery { key: key.to_owned(), value: value.to_owned(), message }
    }

    fn key(key: &str, value: &str, keys: &[&str]) -> Self {
        let allowed = match keys {
            [] => "this address has no query".to_owned(),
            keys => format!("this address allows only the query keys {}", keys.join(", ")),
        };
        let message = format!("`{key}={value}` in the query is refused: {allowed}");
        WrongQuery { key: key.to_owned(), value: value.to_owned(), message }
    }
}

impl From<WrongQuery> for Reply {
    fn from(wrong: WrongQuery) -> Self {
        let WrongQuery { key, value, message } = wrong;
        let query = json!({ "key": key, "value": value });
        let text = json!({ "status": "refused", "message": message, "query": query }).to_string();
        Reply::document(400, text + "\n")
    }
}

impl Asked {
    /// Reads the values of the allowed `keys` from the pairs of a query.
    ///
    /// # Errors
    ///
    /// Returns an error if a key is unknown or repeated, or if a value is invalid for every model file.
    pub fn read(pairs: &[(String, String)], keys: &[&str]) -> Result<Asked, WrongQuery> {
        let mut asked = Asked::default();
        for (i, (key, value)) in pairs.iter().enumerate() {
            if !keys.contains(&key.as_str()) {
                return Err(WrongQuery::key(key, value, keys));
            }
            if pairs[..i].iter().any(|(earlier, _)| earlier == key) {
                return Err(WrongQuery::value(key, value, "given only once"));
            }
            let refused = |allowed: &str| WrongQuery::value(key, value, allowed);
            match key.as_str() {
                "combination" => asked.combination = Some(value.clone()),
                "train" => {
                    let allowed = "the index of a train in the file, counted from 0, or `all`";
                    asked.train = Some(trains(value).ok_or_else(|| refused(allowed))?);
                }
                "first_axle" => {
                    let at = number(value).ok_or_else(|| refused("a finite number"))?;
                    asked.first_axle = Some(at);
                }
                "units" => {
                    asked.units = print::Asked::named(value)
                        .ok_or_else(|| refused("`file`, `si` or `us`"))?;
                }
                "digits" => {
                    let digits = value.parse().ok().filter(|digits| print::DIGITS.contains(digits));
                    let (least, most) = (print::DIGITS.start(), print::DIGITS.end());
                    let allowed = format!("a whole number from {least} to {most}");
                    asked.digits = Some(digits.ok_or_else(|| refused(&allowed))?);
                }
                _ => {
                    let width = number(value).filter(|width| *width > 0.0);
                    asked.width = Some(width.ok_or_else(|| refused("a positive number"))?);
                }
            }
        }
        Ok(asked)
    }
}

fn trains(value: &str) -> Option<Trains> {
    if value == "all" { Some(Trains::All) } else { value.parse().ok().map(Trains::One) }
}

fn number(value: &str) -> Option<f64> {
    value.parse().ok().filter(|number: &f64| number.is_finite())
}

impl Asked {
    /// Returns the units and the number of digits of printed results; `None` if the query requests units for a
    /// file without units.
    pub(crate) fn printed(&self, file: &Document) -> Option<print::Units> {
        let units = file.printed.in_system(self.units)?;
        Some(units.with_digits(self.digits.unwrap_or(print::RESULT_DIGITS)))
    }

    /// Checks that the values of the query are valid for this file.
    pub(crate) fn check(&self, file: &Document) -> Result<(), WrongQuery> {
        if self.printed(file).is_none() {
            let asked = if self.units == print::Asked::Us { "us" } else { "si" };
            let allowed = "`file`, because the model file has no units";
            return Err(WrongQuery::value("units", asked, allowed));
        }
        if let Some(name) = &self.combination {
            let names = file.combination_names();
            if !names.iter().any(|known| known == name) {
                let allowed = match names.as_slice() {
                    [] => "left out, because this file has no combinations".to_owned(),
                    names => format!("one of the combinations {}", names.join(", ")),
                };
                return Err(WrongQuery::value("combination", name, &allowed));
            }
        }
        let count = file.trains.len();
        let wrong = |value: &str| {
            let allowed = match count {
                0 => "left out, because this file has no trains".to_owned(),
                1 => "0 or `all`, because this file has one train".to_owned(),
                _ => format!("0 to {} or `all`, because this file has {count} trains", count - 1),
            };
            Err(WrongQuery::value("train", value, &allowed))
        };
        match self.train {
            Some(Trains::All) if count == 0 => return wrong("all"),
            Some(Trains::One(i)) if i >= count => return wrong(&i.to_string()),
            _ => {}
        }
        let Some(at) = self.first_axle else { return Ok(()) };
        let Some(Trains::One(i)) = self.train else {
            let allowed = "left out unless `train` is the index of a train";
            return Err(WrongQuery::value("first_axle", &at.to_string(), allowed));
        };
        let [from, to] = file.trains[i].range;
        if at < from || at > to {
            let allowed = format!("a position from {from} to {to} for this train");
            return Err(WrongQuery::value("first_axle", &at.to_string(), &allowed));
        }
        Ok(())
    }
}
