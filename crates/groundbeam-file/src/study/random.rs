//! Reads `[[random]]` and `[[correlated]]`: random parameters of the model and their correlations.

use crate::code;
use crate::document::Document;
use crate::fault::Fault;
use crate::keys::{
    ALSO_FROM, ALSO_TO, Table, Value, WHAT_CAN_STAND_HERE, Words, key, quantity, text, word,
};
use crate::quantity::{Kind, RATIO};
use crate::reader::{Field, Reader};
use crate::table::Section;
use crate::target;
use groundbeam::derivatives::Parameter;
use std::ops::Range;
use toml::Spanned;
use toml::de::DeValue;

/// A random parameter of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct Random {
    /// Name of the random parameter in the study file, such as `load[0]`.
    pub name: String,
    /// Parameter of the model whose value is random.
    pub target: Parameter,
    /// Probability distribution of the random parameter.
    pub distribution: Distribution,
}

/// Probability distribution of a random parameter in SI units; in a file without units, in the units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// `normal`.
    Normal {
        /// Mean of the random parameter.
        mean: f64,
        /// Standard deviation of the random parameter, positive.
        deviation: f64,
    },
    /// `lognormal`: the logarithm of the random parameter is normally distributed.
    Lognormal {
        /// Mean of the random parameter, positive.
        mean: f64,
        /// Standard deviation of the random parameter, positive.
        deviation: f64,
    },
    /// `gumbel`: the type I extreme value distribution of largest values.
    Gumbel {
        /// Mean of the random parameter.
        mean: f64,
        /// Standard deviation of the random parameter, positive.
        deviation: f64,
    },
    /// `uniform`: all values between two numbers are equally probable.
    Uniform {
        /// Smallest value of the random parameter.
        from: f64,
        /// Largest value of the random parameter.
        to: f64,
    },
    /// `triangular`: a piecewise linear density between two numbers, with its peak at the mode.
    Triangular {
        /// Smallest value of the random parameter.
        from: f64,
        /// Most probable value of the random parameter.
        mode: f64,
        /// Largest value of the random parameter.
        to: f64,
    },
}

/// Correlation of two random parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joined {
    /// Zero-based indices of the two correlated random parameters.
    pub of: [usize; 2],
    /// Correlation coefficient of the normal scores of the two random parameters.
    pub rho: f64,
}

static DISTRIBUTIONS: Words = Words {
    all: || vec!["normal", "lognormal", "gumbel", "uniform", "triangular"],
    also: &[],
    message: "`{}` is not a value of `distribution`",
    hint: WHAT_CAN_STAND_HERE,
};

pub(super) static TABLE: Table = Table {
    name: "[[random]]",
    keys: &[
        text("what", "k_factor", "The name of the random parameter, such as `load[0]`.").needed(),
        word(
            "distribution",
            &DISTRIBUTIONS,
            "The probability distribution of the random parameter.",
        )
        .needed(),
        key(
            "mean",
            Value::Depends,
            "The mean of `normal`, `lognormal`, `gumbel`; default: the model's value.",
        ),
        quantity(
            "cov",
            &RATIO,
            "The coefficient of variation of `normal`, `lognormal`, `gumbel`: the standard deviation divided by the mean.",
        ),
        key(
            "deviation",
            Value::Depends,
            "The standard deviation of `normal`, `lognormal`, `gumbel`.",
        ),
        key("from", Value::Depends, "`uniform`, `triangular`: the smallest value.").also(ALSO_FROM),
        key("to", Value::Depends, "`uniform`, `triangular`: the largest value.").also(ALSO_TO),
        key("mode", Value::Depends, "`triangular`: the most probable value."),
    ],
};

pub(super) static CORRELATED: Table = Table {
    name: "[[correlated]]",
    keys: &[
        key(
            "what",
            Value::List(&Value::Text("load[0]"), [2, 2]),
            "The names of two random parameters.",
        )
        .needed(),
        quantity(
            "rho",
            &RATIO,
            "The correlation of the normal scores of the two random parameters.",
        )
        .needed(),
    ],
};

pub(super) fn read(reader: &mut Reader, root: &Section, document: &Document) -> Vec<Random> {
    let mut all: Vec<Random> = Vec::new();
    for table in reader.tables(root, "random") {
        let what = target(reader, &table, document);
        let kind =
            what.as_ref().map_or(&RATIO, |(_, target, _)| target::kind(*target, &document.model));
        let distribution = distribution(reader, &table, kind, what.as_ref(), document);
        let Some((name, target, span)) = what else { continue };
        let same = |other: &&Random| target::set_the_same_number(other.target, target);
        if let Some(other) = all.iter().find(same) {
            let message = match other.target == target {
                true => format!("`{name}` is already random"),
                false => format!("`{}` and `{name}` set the same number", other.name),
            };
            let hint = "give each number one distribution";
            reader.report(Fault::new(code::REPEATED, span, message, "", hint));
            continue;
        }
        if let Some(distribution) = distribution {
            if target::must_be_positive(target) && !distribution.is_positive() {
                let message = format!(
                    "`{name}` must be positive, but the distribution contains negative values or zero"
                );
                let hint = "use `lognormal`, or `uniform` or `triangular` with a positive `from`";
                reader.report(Fault::new(code::RANGE, span, message, "", hint));
                continue;
            }
            all.push(Random { name, target, distribution });
        }
    }
    all
}

/// Reads the key `what`, which names a parameter of the model. Returns the name, the parameter, and the location of the
/// name in the file.
fn target(
    reader: &mut Reader,
    table: &Section,
    document: &Document,
) -> Option<(String, Parameter, Range<usize>)> {
    let (name, span) = reader.text(table, "what")?;
    let name = name.trim();
    let Some(target) = Parameter::named(name) else {
        let message = format!("`{name}` is not the name of a number in the model");
        let hint = format!("allowed here: {}", Parameter::NAMES);
        reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
        return None;
    };
    if let Some(problem) = target::problem(target, name, document) {
        let message = format!("`{name}` cannot be random in this study");
        reader.report(Fault::new(code::EXCLUSIVE, span, message, "", problem));
        return None;
    }
    Some((name.to_owned(), target, span))
}

fn distribution(
    reader: &mut Reader,
    table: &Section,
    kind: &'static Kind,
    what: Option<&(String, Parameter, Range<usize>)>,
    document: &Document,
) -> Option<Distribution> {
    let which = reader.word(table, "distribution")?;
    let by_ends = matches!(which, "uniform" | "triangular");
    let foreign: &[&str] = match which {
        "uniform" => &["mean", "cov", "deviation", "mode"],
        "triangular" => &["mean", "cov", "deviation"],
        _ => &["from", "to", "mode"],
    };
    for key in foreign {
        if let Some(value) = table.value(key) {
            let message = format!("`{key}` is not a parameter of `{which}`");
            let hint = match by_ends {
                true => "give `from` and `to`, and for `triangular` also `mode`",
                false => "give `mean`, and `cov` or `deviation`",
            };
            reader.report(Fault::new(code::MISPLACED, value.span(), message, "", hint));
        }
    }
    if by_ends {
        let from = reader.required_of(table, "from", kind);
        let to = reader.required_of(table, "to", kind);
        if to.value <= from.value {
            let hint = "`to` is the largest value and `from` is the smallest value";
            out_of_range(reader, &to, "`to` must be larger than `from`", hint);
            return None;
        }
        let mode = (which == "triangular").then(|| reader.required_of(table, "mode", kind));
        let (from, to) = (from.value, to.value);
        return match mode {
            None => Some(Distribution::Uniform { from, to }),
            Some(mode) if mode.value < from || mode.value > to => {
                let hint = "it is the most probable value";
                out_of_range(reader, &mode, "`mode` must lie between `from` and `to`", hint);
                None
            }
            Some(mode) => Some(Distribution::Triangular { from, mode: mode.value, to }),
        };
    }
    let own = what.and_then(|(_, target, _)| target.value(&document.model));
    let mean = reader.quantity_of(table, "mean", kind);
    let (mean, span) = match (mean, own) {
        (Some(mean), _) => (mean.value, mean.span),
        (None, Some(own)) => (own, table.span.clone()),
        (None, None) => (f64::NAN, table.span.clone()),
    };
    let deviation = spread(reader, table, kind, mean)?;
    if which == "lognormal" && mean <= 0.0 {
        let hint =
            "a lognormal number is always positive; use `normal` for a number that may be negative";
        out_of_range(reader, &Field::new(mean, span), "its mean must be positive", hint);
        return None;
    }
    match which {
        "normal" => Some(Distribution::Normal { mean, deviation }),
        "lognormal" => Some(Distribution::Lognormal { mean, deviation }),
        "gumbel" => Some(Distribution::Gumbel { mean, deviation }),
        _ => None,
    }
}

/// Reads the standard deviation, which is given directly or as a fraction of the mean.
pub(super) fn spread(
    reader: &mut Reader,
    table: &Section,
    kind: &'static Kind,
    mean: f64,
) -> Option<f64> {
    let cov = reader.quantity(table, "cov");
    let deviation = reader.quantity_of(table, "deviation", kind);
    let given = match (cov, deviation) {
        (Some(cov), Some(deviation)) => {
            let hint = "`deviation` is the mean times `cov`; give only one of the two keys";
            reader.exclusive(("cov", &cov.span), ("deviation", &deviation.span), hint);
            return None;
        }
        (Some(cov), None) => {
            if mean == 0.0 {
                let hint = "give its `deviation`";
                out_of_range(reader, &cov, "`cov` needs a mean other than 0", hint);
                return None;
            }
            Field::new(cov.value * mean.abs(), cov.span)
        }
        (None, Some(deviation)) => deviation,
        (None, None) => {
            let keys = ["cov", "deviation"];
            reader.missing(table, &keys, "`cov` or `deviation`", "cov = 0.3");
            return None;
        }
    };
    if given.value <= 0.0 {
        out_of_range(
            reader,
            &given,
            "it must be positive",
            "a random number needs a positive standard deviation",
        );
        return None;
    }
    Some(given.value).filter(|value| value.is_finite())
}

pub(super) fn out_of_range(reader: &mut Reader, field: &Field, message: &str, hint: &str) {
    reader.report(Fault::new(code::RANGE, field.span.clone(), message, "", hint));
}

impl Distribution {
    /// Whether all values of the distribution are positive.
    fn is_positive(&self) -> bool {
        match *self {
            Distribution::Normal { .. } | Distribution::Gumbel { .. } => false,
            Distribution::Lognormal { .. } => true,
            Distribution::Uniform { from, .. } | Distribution::Triangular { from, .. } => {
                from > 0.0
            }
        }
    }
}

pub(super) fn read_joined(reader: &mut Reader, root: &Section, random: &[Random]) -> Vec<Joined> {
    let mut all: Vec<Joined> = Vec::new();
    let written = root.value("random").and_then(|value| value.get_ref().as_array());
    let what = |value: &'_ Spanned<DeValue<'_>>| {
        Some(value.get_ref().as_table()?.get("what")?.get_ref().as_str()?.trim().to_owned())
    };
    let written: Vec<String> =
        written.into_iter().flat_map(|tables| tables.iter()).filter_map(what).collect();
    for table in reader.tables(root, "correlated") {
        let rho = reader.required(&table, "rho");
        if rho.value.abs() >= 1.0 {
            let hint = "the value 0 means independent numbers; replace two fully correlated numbers by one number";
            out_of_range(reader, &rho, "a correlation lies between -1 and 1", hint);
        }
        let Some(of) = pair(reader, &table, random, &written) else { continue };
        let span = table.span.clone();
        if all.iter().any(|other| other.of == of) {
            let message = "the correlation of these two random parameters has already been given";
            let hint = "give it once";
            reader.report(Fault::new(code::REPEATED, span, message, "", hint));
            continue;
        }
        all.push(Joined { of, rho: rho.value });
    }
    all
}

/// Returns the indices of the two random parameters that the list `what` names, in ascending order. A name whose
/// `[[random]]` table has already been refused causes no second message.
fn pair(
    reader: &mut Reader,
    table: &Section,
    random: &[Random],
    written: &[String],
) -> Option<[usize; 2]> {
    let example = "what = [\"load[0]\", \"load[1]\"]";
    let Some(value) = table.value("what") else {
        reader.missing(table, &["what"], "`what`", example);
        return None;
    };
    let names: Option<Vec<&str>> = match value.get_ref() {
        DeValue::Array(list) => list.iter().map(|name| name.get_ref().as_str()).collect(),
        _ => None,
    };
    let Some([a, b]) = names.as_deref() else {
        let message = "`what` must be a list of two names".to_owned();
        reader.wrong_type(value, message, format!("as in {example}"));
        return None;
    };
    let mut found = [0; 2];
    for (slot, name) in found.iter_mut().zip([a, b]) {
        let Some(index) = random.iter().position(|random| random.name == name.trim()) else {
            if written.iter().any(|what| what == name.trim()) {
                return None;
            }
            let message = format!("no [[random]] has the name `{name}`");
            let hint = "only random parameters can be correlated";
            reader.report(Fault::new(code::UNKNOWN_WORD, value.span(), message, "", hint));
            return None;
        };
        *slot = index;
    }
    if found[0] == found[1] {
        let message = "a number cannot be correlated with itself";
        let hint = "name two different ones";
        reader.report(Fault::new(code::REPEATED, value.span(), message, "", hint));
        return None;
    }
    found.sort_unstable();
    Some(found)
}
