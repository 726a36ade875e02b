//! Reads the table `[field]`: random fields of k, μ and EI along the beam.

use super::random::{Random, out_of_range, spread};
use crate::code;
use crate::document::Document;
use crate::fault::Fault;
use crate::keys::{Key, Table, Value, WHAT_CAN_STAND_HERE, Words, key, quantity, table, word};
use crate::quantity::{LENGTH, RATIO};
use crate::reader::Reader;
use crate::table::Section;
use crate::target::{self, Course};
use groundbeam::derivatives::{Domain, Parameter, Property};

/// Lognormal random fields along the beam, with a common correlation function.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomField {
    /// Quantities that vary along the beam: k, μ or EI, each at most once.
    pub of: Vec<FieldOf>,
    /// Correlation function of the distance between two points.
    pub correlation: Correlation,
    /// The correlation length \[m\].
    pub length: f64,
    /// Number of equidistant points or of equal stretches for which the fields are sampled.
    pub points: usize,
    /// Interpolation of the fields between the points.
    pub course: Course,
    /// Method that computes the fields from independent standard normal random numbers.
    pub method: Method,
    /// Correlation of ln k and ln μ at the same point.
    pub rho: f64,
}

/// A property of beam or ground that is a random field along the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldOf {
    /// The property that is a random field: k, μ or EI.
    pub property: Property,
    /// Mean of the property k, μ or EI, positive.
    pub mean: f64,
    /// Standard deviation of the property k, μ or EI, positive.
    pub deviation: f64,
}

/// Correlation of the logarithms of a quantity at two points, as a function of the distance d and the
/// correlation length L.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Correlation {
    /// `exponential`: the correlation at the distance d is exp(−d/L), Matérn's function with ν = 1/2. L is the
    /// correlation length.
    Exponential,
    /// `matern-3/2`: the correlation at the distance d is (1 + a) exp(−a) with a = √3 d/L. L is the correlation
    /// length.
    Matern3,
    /// `matern-5/2`: the correlation at the distance d is (1 + a + a²/3) exp(−a) with a = √5 d/L. L is the
    /// correlation length.
    Matern5,
    /// `gaussian`: the correlation at the distance d is exp(−d²/(2L²)). L is the correlation length.
    Gaussian,
}

/// Method that computes a random field from independent standard normal random numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// `karhunen-loeve`: a truncated expansion in the eigenvectors of the covariance matrix.
    KarhunenLoeve(Share),
    /// `circulant`: exact sampling by circulant embedding of the covariance matrix.
    Circulant,
}

/// Truncation of a Karhunen–Loève expansion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Share {
    /// A given number of terms.
    Terms(usize),
    /// The smallest number of terms that represents this share of the variance.
    OfVariance(f64),
}

const QUANTITY: &[Key] = &[
    key("mean", Value::Depends, "The mean of the quantity; default: the model's value."),
    quantity(
        "cov",
        &RATIO,
        "The coefficient of variation: standard deviation divided by the mean.",
    ),
    key("deviation", Value::Depends, "The standard deviation."),
];
static K: Table = Table { name: "k of [field]", keys: QUANTITY };
static MU: Table = Table { name: "mu of [field]", keys: QUANTITY };
static EI: Table = Table { name: "EI of [field]", keys: QUANTITY };

static FUNCTIONS: Words = Words {
    all: || CORRELATIONS.map(|(name, _)| name).to_vec(),
    also: &[],
    message: "`{}` is not a value of `correlation`",
    hint: WHAT_CAN_STAND_HERE,
};
static COURSES: Words = Words {
    all: || vec!["lines", "steps"],
    also: &[],
    message: "`{}` is not a value of `between`",
    hint: WHAT_CAN_STAND_HERE,
};
static METHODS: Words = Words {
    all: || vec!["karhunen-loeve", "circulant"],
    also: &[],
    message: "`{}` is not a value of `method`",
    hint: WHAT_CAN_STAND_HERE,
};

pub(super) static TABLE: Table = Table {
    name: "[field]",
    keys: &[
        table("k", &K, "The field of k."),
        table("mu", &MU, "The field of mu."),
        table("EI", &EI, "The field of EI."),
        quantity("rho", &RATIO, "The correlation of ln k and ln mu; default: 0."),
        word("correlation", &FUNCTIONS, "The correlation function; default: `exponential`."),
        quantity("length", &LENGTH, "The correlation length L.").needed(),
        key(
            "points",
            Value::Count([2, MOST_POINTS]),
            "The number of points along the beam; default: 4 per correlation length, at least 8, at most 256.",
        ),
        word("between", &COURSES, "The interpolation between points; default: `lines`."),
        word("method", &METHODS, "The method that samples the fields; default: `karhunen-loeve`."),
        key("terms", Value::Count([1, MOST_POINTS]), "`karhunen-loeve`: the number of terms."),
        quantity(
            "variance",
            &RATIO,
            "`karhunen-loeve`: the share of the variance that the terms represent; default: 0.99.",
        ),
    ],
};
const CORRELATIONS: [(&str, Correlation); 4] = [
    ("exponential", Correlation::Exponential),
    ("matern-3/2", Correlation::Matern3),
    ("matern-5/2", Correlation::Matern5),
    ("gaussian", Correlation::Gaussian),
];
/// Maximum number of points of a field.
const MOST_POINTS: u64 = 1024;
/// Default number of points per correlation length.
const POINTS_PER_LENGTH: f64 = 4.0;
const FEWEST_POINTS: f64 = 8.0;
const VARIANCE: f64 = 0.99;

impl FieldOf {
    /// Returns the name of the quantity in files.
    pub fn name(&self) -> &'static str {
        match self.property {
            Property::Spring => "k",
            Property::Shear => "mu",
            Property::BendingStiffness => "EI",
            Property::ShearStiffness => "GA",
        }
    }
}

impl Correlation {
    /// Returns the name of the correlation function in files.
    pub fn name(self) -> &'static str {
        CORRELATIONS.iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name)
    }
}

pub(super) fn read(
    reader: &mut Reader,
    root: &Section,
    document: &Document,
    random: &[Random],
) -> Option<RandomField> {
    let table = reader.table(root, "field")?;
    let mut of = Vec::new();
    let mut is_there = false;
    for (property, name) in
        [(Property::Spring, "k"), (Property::Shear, "mu"), (Property::BendingStiffness, "EI")]
    {
        is_there |= table.value(name).is_some();
        let own = reader.table(&table, name);
        of.extend(own.and_then(|own| field_of(reader, &own, name, property, document, random)));
    }
    if !is_there {
        reader.missing(&table, &["k", "mu", "EI"], "field", "k = { cov = 0.3 }");
    }
    let word = reader.word(&table, "correlation");
    let correlation = CORRELATIONS.iter().find(|(name, _)| Some(*name) == word);
    let correlation = correlation.map_or(Correlation::Exponential, |(_, known)| *known);
    let length = reader.required(&table, "length");
    if length.value <= 0.0 {
        out_of_range(
            reader,
            &length,
            "a correlation length must be positive",
            "for example several metres",
        );
        return None;
    }
    let fitting = (POINTS_PER_LENGTH * document.model.beam.length / length.value).ceil();
    let fitting =
        if fitting.is_finite() { fitting.clamp(FEWEST_POINTS, 256.0) } else { FEWEST_POINTS };
    let points = reader.count(&table, "points").unwrap_or(fitting as u64);
    let between = reader.word(&table, "between");
    let rho = rho(reader, &table, &of);
    let method = method(reader, &table);
    Some(RandomField {
        of,
        correlation,
        length: length.value,
        points: usize::try_from(points).unwrap_or(usize::MAX),
        course: if between == Some("steps") { Course::Steps } else { Course::Lines },
        method: method?,
        rho: rho?,
    })
}

fn field_of(
    reader: &mut Reader,
    own: &Section,
    name: &'static str,
    property: Property,
    document: &Document,
    random: &[Random],
) -> Option<FieldOf> {
    let target = Parameter::Value(property, Domain::Whole);
    let kind = target::kind(target, &document.model);
    if let Some(problem) = target::problem(target, name, document) {
        let message = format!("`{name}` cannot be a random field in this study");
        reader.report(Fault::new(code::EXCLUSIVE, own.span.clone(), message, "", problem));
        return None;
    }
    if let Some(random) =
        random.iter().find(|random| target::set_the_same_number(random.target, target))
    {
        let message =
            format!("`{name}` is a random field and also the [[random]] number `{}`", random.name);
        let hint = format!("use the [[random]] number `{name}_factor`, which multiplies the field");
        reader.report(Fault::new(code::REPEATED, own.span.clone(), message, "", hint));
        return None;
    }
    let mean = reader.quantity_of(own, "mean", kind).map(|mean| mean.value);
    let mean = mean.or_else(|| target.value(&document.model)).unwrap_or(f64::NAN);
    if mean <= 0.0 {
        let message = format!("the mean of `{name}` must be positive");
        let hint = "the field is lognormal";
        reader.report(Fault::new(code::RANGE, own.span.clone(), message, "", hint));
        return None;
    }
    let deviation = spread(reader, own, kind, mean)?;
    Some(FieldOf { property, mean, deviation })
}

fn rho(reader: &mut Reader, table: &Section, of: &[FieldOf]) -> Option<f64> {
    let Some(rho) = reader.quantity(table, "rho") else { return Some(0.0) };
    let has = |property| of.iter().any(|field| field.property == property);
    if !(has(Property::Spring) && has(Property::Shear)) {
        let hint =
            "`rho` is the correlation of ln k and ln mu at one point; give both k and mu as fields";
        let message = "`rho` needs fields of both k and mu";
        reader.report(Fault::new(code::INCOMPLETE, rho.span, message, "", hint));
        return None;
    }
    if rho.value.abs() > 1.0 {
        out_of_range(reader, &rho, "a correlation lies between -1 and 1", "0 means independent");
        return None;
    }
    Some(rho.value)
}

fn method(reader: &mut Reader, table: &Section) -> Option<Method> {
    let circulant = reader.word(table, "method") == Some("circulant");
    let terms = reader.count(table, "terms");
    let variance = reader.quantity(table, "variance");
    let (a, b) = (table.value("terms"), &variance);
    if let (Some(a), Some(b)) = (a, b) {
        let hint =
            "the share `variance` determines the number of terms; give only one of the two keys";
        reader.exclusive(("terms", &a.span()), ("variance", &b.span), hint);
        return None;
    }
    if circulant {
        let place = a.map(|a| a.span()).or_else(|| variance.as_ref().map(|v| v.span.clone()));
        let Some(span) = place else { return Some(Method::Circulant) };
        let message = "the method `circulant` does not use `terms` or `variance`";
        let hint = "leave out `terms` and `variance`, or use method = \"karhunen-loeve\"";
        reader.report(Fault::new(code::MISPLACED, span, message, "", hint));
        return None;
    }
    let share = match (terms, variance) {
        (Some(terms), _) => Share::Terms(usize::try_from(terms).unwrap_or(usize::MAX)),
        (None, Some(variance)) if variance.value > 0.0 && variance.value <= 1.0 => {
            Share::OfVariance(variance.value)
        }
        (None, Some(variance)) => {
            let hint = "1 keeps all terms";
            out_of_range(
                reader,
                &variance,
                "a share of the variance must be greater than 0 and at most 1",
                hint,
            );
            return None;
        }
        (None, None) => Share::OfVariance(VARIANCE),
    };
    Some(Method::KarhunenLoeve(share))
}
