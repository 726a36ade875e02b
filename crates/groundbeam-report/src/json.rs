//! Writes the result document as one JSON object, in SI units or in the consistent system of units of the file.
//!
//! Numbers are read back as the same bits. Infinite numbers and NaN are written as `null`.
//!
//! Where a field jumps, `stations` contains the value just right of the position (at x = l just left). The table of
//! [`csv`](crate::csv) contains both sides.

mod bounds;
mod checks;
mod combinations;
mod comparison;
mod enveloped;
mod existence;
mod factors;
mod ground;
mod pieces;
mod study;
mod train;
mod verified;

use crate::characteristics::Characteristics;
use crate::checked::Row;
use crate::context::Context;
pub use combinations::{combinations, envelope_stations};
pub use comparison::comparison;
use existence::Proven;
use factors::Grown;
use ground::Ground;
use groundbeam::{
    Certificate, Existence, Field, Method, Model, Solution, Stopped, Support,
    model::Acts,
    solution::{
        ConcentratedForce, ContactZone, EndForces, Fields, HingeTurn, LiftOff, Range, Reaction,
        Side,
    },
};
use groundbeam_file::is_unprintable;
use pieces::Claimed;
use serde::{Serialize, Serializer};
pub use study::study;
pub use train::{checked_trains, trains};
pub use verified::verified;

/// Number of equal steps of the grid in [`default_stations`].
const EVEN_STEPS: usize = 100;

/// Returns the default positions: an equidistant grid, all loads, supports, hinges and contact edges, and all
/// extremes.
pub fn default_stations(solution: &Solution) -> Vec<f64> {
    solution.stations(EVEN_STEPS)
}

/// Returns the result document of an equilibrium, with the fields at the positions `stations`.
pub fn solved(solution: &Solution, stations: &[f64], context: &Context) -> String {
    text(&Solved::of(solution, stations, context))
}

/// The document of a model without equilibrium, or of an existence check. Its `status` is
/// `equilibrium-exists` or `no-equilibrium`.
pub fn existence(model: &Model, existence: &Existence, context: &Context) -> String {
    let stands = existence.verdict.stands();
    let status = if stands { "equilibrium-exists" } else { "no-equilibrium" };
    text(&Checked::of(status, model, existence, context))
}

/// Returns the JSON document for a solution method that did not reach its tolerance.
pub fn not_converged(reached: &Stopped, context: &Context) -> String {
    text(&Unsolved::of(reached, context))
}

/// Serializes a document as JSON, which cannot fail for plain structs. Control characters for terminals are
/// written as escapes, which a JSON reader converts back.
fn text(document: &impl Serialize) -> String {
    let written = serde_json::to_string_pretty(document).unwrap_or_default() + "\n";
    if written.chars().all(|c| c == '\n' || !is_unprintable(c)) {
        return written;
    }
    let mut escaped = String::with_capacity(written.len());
    for c in written.chars() {
        match c == '\n' || !is_unprintable(c) {
            true => escaped.push(c),
            false => escaped += &format!("\\u{:04x}", u32::from(c)),
        }
    }
    escaped
}

#[derive(Serialize)]
struct Solved<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    method: &'static str,
    elements: usize,
    existence: Proven,
    characteristics: Characteristics,
    #[serde(skip_serializing_if = "Option::is_none")]
    ground: Option<Ground>,
    contact: &'a [ContactZone],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    undecided: Vec<ContactZone>,
    lift_off: Vec<LiftOff>,
    free_spans: Vec<FreeSpan>,
    end_forces: EndForces,
    concentrated_forces: &'a [ConcentratedForce],
    reactions: Vec<Held>,
    #[serde(flatten)]
    claimed: Option<Claimed>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    hinges: Vec<HingeTurn>,
    stations: Along<Vec<f64>>,
    extremes: ByName<Range>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<checks::Checked>,
    #[serde(serialize_with = "figures")]
    certificate: &'a Certificate,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factors: Option<Grown<'a>>,
    iterations: usize,
    seconds: Option<f64>,
}

impl<'a> Solved<'a> {
    fn of(solution: &'a Solution, stations: &[f64], context: &Context<'a>) -> Self {
        let model = solution.model();
        let supports = solution.reactions().iter().zip(&model.supports);
        Solved {
            head: Head::new("solved", context),
            method: solution.method().name(),
            elements: solution.elements(),
            existence: Proven::new(model, solution.existence(), context),
            characteristics: Characteristics::of(model, solution.existence()),
            ground: context.ground.map(|ground| Ground::of(ground, model)),
            contact: solution.contact(),
            undecided: solution.undecided().collect(),
            lift_off: solution.lift_off(),
            free_spans: solution.lift_off().into_iter().map(FreeSpan::of).collect(),
            end_forces: solution.end_forces(),
            concentrated_forces: solution.concentrated_forces(),
            reactions: supports.enumerate().map(Held::of).collect(),
            claimed: context.pieces.then(|| Claimed::of(solution, stations, context)),
            hinges: solution.hinges(),
            stations: Along::stations(solution, stations),
            extremes: ByName::of(Field::of(&model.beam), |field| solution.range(field)),
            checks: checks::of(&[Row::alone(solution, context)], context),
            certificate: solution.certificate(),
            load_factors: context.factors.map(|factors| Grown::of(factors, Some(model))),
            iterations: solution.iterations(),
            seconds: context.seconds,
        }
    }
}

/// Serializes the numbers of a certificate by name, in a fixed order.
fn figures<S: Serializer>(proof: &Certificate, to: S) -> Result<S::Ok, S::Error> {
    to.collect_map(proof.figures())
}

#[derive(Serialize)]
struct Checked<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    existence: Proven,
    characteristics: Characteristics,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factors: Option<Grown<'a>>,
    seconds: Option<f64>,
}

impl<'a> Checked<'a> {
    fn of(
        status: &'static str,
        model: &Model,
        existence: &Existence,
        context: &Context<'a>,
    ) -> Self {
        Checked {
            head: Head::new(status, context),
            existence: Proven::new(model, existence, context),
            characteristics: Characteristics::of(model, existence),
            load_factors: context.factors.map(|factors| Grown::of(factors, Some(model))),
            seconds: context.seconds,
        }
    }
}

#[derive(Serialize)]
struct Unsolved<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    method: &'static str,
    what: &'static str,
    tolerance: Option<f64>,
    reached: Option<f64>,
    iterations: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factors: Option<Grown<'a>>,
    seconds: Option<f64>,
}

impl<'a> Unsolved<'a> {
    fn of(reached: &Stopped, context: &Context<'a>) -> Self {
        Unsolved {
            head: Head::new("not-converged", context),
            method: Method::name(reached.method),
            what: reached.why.what(),
            tolerance: reached.why.tolerance(),
            reached: reached.why.reached(),
            iterations: reached.iterations,
            load_factors: context.factors.map(|factors| Grown::of(factors, None)),
            seconds: context.seconds,
        }
    }
}

/// First keys of a document.
#[derive(Serialize)]
struct Head<'a> {
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    units: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    trough_chords: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    model_digest: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<&'a str>,
}

impl<'a> Head<'a> {
    fn new(status: &'static str, context: &Context<'a>) -> Self {
        Head {
            status,
            title: context.title,
            units: context.units.name(),
            trough_chords: context.chords,
            model_digest: context.digest,
            combination: context.combination.map(|one| &*one.name),
        }
    }
}

#[derive(Serialize)]
struct FreeSpan {
    #[serde(flatten)]
    open: LiftOff,
    length: f64,
    /// Ends of the beam that the free span reaches: `left`, `right`, `both` or `null`.
    reaches_end: Option<&'static str>,
}

impl FreeSpan {
    fn of(open: LiftOff) -> Self {
        let reaches_end = match open.reaches {
            [true, true] => Some("both"),
            [true, false] => Some("left"),
            [false, true] => Some("right"),
            [false, false] => None,
        };
        FreeSpan { length: open.length(), open, reaches_end }
    }
}

#[derive(Serialize)]
struct Held {
    /// Index of the support in the model's list of supports.
    support: usize,
    #[serde(flatten)]
    reaction: Reaction,
    /// State of a support that acts in one direction only.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<&'static str>,
}

impl Held {
    fn of((support, (reaction, of)): (usize, (&Reaction, &Support))) -> Self {
        Held { support, reaction: *reaction, state: state(of, reaction.force) }
    }
}

/// State of a one-way support; `None` for a support that acts in both directions.
fn state(support: &Support, force: f64) -> Option<&'static str> {
    match support.acts {
        Acts::Both => None,
        _ if force != 0.0 => Some("acting"),
        Acts::Up => Some("lifted"),
        Acts::Down => Some("slack"),
    }
}

/// Values by field. In the document, the key of each value is the name of the field.
struct ByName<T>(Vec<(Field, T)>);

impl<T> ByName<T> {
    fn of(fields: impl Iterator<Item = Field>, of: impl Fn(Field) -> T) -> Self {
        ByName(fields.map(|field| (field, of(field))).collect())
    }

    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Serialize> Serialize for ByName<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(field, of)| (field.name(), of)))
    }
}

/// Values of each field at positions along the beam.
#[derive(Serialize)]
struct Along<T> {
    x: Vec<f64>,
    #[serde(flatten)]
    fields: ByName<T>,
}

impl Along<Vec<f64>> {
    fn stations(solution: &Solution, positions: &[f64]) -> Self {
        let fields = positions.iter().map(|&x| solution.at(x, Side::Right)).collect();
        Along::fields_at(solution, positions.to_vec(), fields)
    }

    fn fields_at(solution: &Solution, x: Vec<f64>, fields: Vec<Fields>) -> Self {
        let column = |field| fields.iter().map(|f| f.get(field)).collect();
        Along { x, fields: ByName::of(Field::of(&solution.model().beam), column) }
    }

    fn is_empty(&self) -> bool {
        self.x.is_empty()
    }
}

/// Smallest and largest values of a field at positions along the beam, with the governing results.
#[derive(Serialize)]
struct Lines<G> {
    min: Vec<f64>,
    max: Vec<f64>,
    governs_min: Vec<G>,
    governs_max: Vec<G>,
    /// Index of the train passage with the smallest value, for each position along the beam; omitted for a
    /// single passage and for load combinations.
    #[serde(skip_serializing_if = "Option::is_none")]
    passage_min: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    passage_max: Option<Vec<usize>>,
}

/// Entries for the smallest and for the largest value of a field.
#[derive(Serialize)]
struct Extremes<T> {
    min: T,
    max: T,
}

impl<T> Extremes<T> {
    fn of([min, max]: [T; 2]) -> Self {
        Extremes { min, max }
    }
}
