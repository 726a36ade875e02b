//! The result document: one JSON object, in SI units or in the file's own consistent system.
//!
//! Numbers are written with as many digits as it takes to read back the same bits; what is infinite or not
//! a number is `null`. Keys stand in a fixed order.
//!
//! `stations` holds every position once, with the values just to the right of it (at x = l just to the
//! left) where a field jumps. Both sides of a jump are in the table of [`csv`](crate::csv).

mod bounds;
mod certificate;
mod checks;
mod combinations;
mod comparison;
mod existence;
mod factors;
mod ground;
mod pieces;
mod study;
mod train;
mod verified;

use crate::characteristics::Characteristics;
use crate::context::Context;
pub use combinations::{combinations, envelope_stations};
pub use comparison::comparison;
use existence::Proven;
use factors::Grown;
use ground::Ground;
use groundbeam::{
    Acts, Certificate, Existence, Extreme, Field, Fields, LiftOff, Method, Model, Side, Solution,
    Stopped, Support,
};
use groundbeam_file::is_unprintable;
use pieces::Claimed;
use serde::{Serialize, Serializer};
pub use study::study;
pub use train::{checked_trains, trains};
pub use verified::verified;

/// Equal steps of the grid that [`default_stations`] is made of.
const EVEN_STEPS: usize = 100;

/// Where the fields are listed if nobody says: an even grid, every load, support, joint and edge of
/// contact, and every extreme.
pub fn default_stations(solution: &Solution) -> Vec<f64> {
    solution.stations(EVEN_STEPS)
}

/// The document of an equilibrium, with the fields at the given positions of the beam.
pub fn solved(solution: &Solution, stations: &[f64], context: &Context) -> String {
    text(&Solved::of(solution, stations, context))
}

/// The document of a model that has no equilibrium, or was checked but not solved: its `status` is
/// `equilibrium-exists` or `no-equilibrium`.
pub fn existence(model: &Model, existence: &Existence, context: &Context) -> String {
    let stands = existence.verdict.stands();
    let status = if stands { "equilibrium-exists" } else { "no-equilibrium" };
    text(&Checked::of(status, model, existence, context))
}

/// The document of a method that did not reach its tolerance.
pub fn not_converged(reached: &Stopped, context: &Context) -> String {
    text(&Unsolved::of(reached, context))
}

/// Plain structs of numbers and words can always be written. Characters of words that would steer a terminal are
/// written as escapes, which a reader of the document turns back.
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
struct Solved {
    #[serde(flatten)]
    head: Head,
    method: &'static str,
    elements: usize,
    existence: Proven,
    characteristics: Judged,
    #[serde(skip_serializing_if = "Option::is_none")]
    ground: Option<Ground>,
    contact: Vec<Stretch>,
    lift_off: Vec<Lifted>,
    free_spans: Vec<FreeSpan>,
    end_forces: Ends,
    concentrated_forces: Vec<Force>,
    reactions: Vec<Held>,
    #[serde(flatten)]
    claimed: Option<Claimed>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    hinges: Vec<Turned>,
    stations: Stations,
    extremes: ByName<Range>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<checks::Checked>,
    #[serde(serialize_with = "certificate::figures")]
    certificate: Certificate,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factors: Option<Grown>,
    iterations: usize,
    seconds: Option<f64>,
}

impl Solved {
    fn of(solution: &Solution, stations: &[f64], context: &Context) -> Self {
        let model = solution.model();
        Solved {
            head: Head::new("solved", context),
            method: solution.method().name(),
            elements: solution.elements(),
            existence: Proven::new(model, solution.existence(), context),
            characteristics: Judged::new(model, solution.existence()),
            ground: context.ground.map(|ground| Ground::of(ground, model)),
            contact: solution
                .contact()
                .iter()
                .map(|c| Stretch { from: c.from, to: c.to })
                .collect(),
            lift_off: solution
                .lift_off()
                .iter()
                .map(|l| Lifted { from: l.from, to: l.to, largest_gap: l.largest_gap.into() })
                .collect(),
            free_spans: solution.lift_off().iter().map(FreeSpan::of).collect(),
            end_forces: Ends {
                left: solution.end_forces().left,
                right: solution.end_forces().right,
            },
            concentrated_forces: solution
                .concentrated_forces()
                .iter()
                .map(|force| Force { at: force.at, force: force.force })
                .collect(),
            reactions: solution
                .reactions()
                .iter()
                .zip(&model.supports)
                .enumerate()
                .map(|(i, (r, support))| Held {
                    support: i,
                    at: r.at,
                    force: r.force,
                    moment: r.moment,
                    state: state(support, r.force),
                })
                .collect(),
            claimed: context.pieces.then(|| Claimed::of(solution, stations, context)),
            hinges: solution
                .hinges()
                .iter()
                .map(|h| Turned { at: h.at, rotation: h.rotation, moment: h.moment })
                .collect(),
            stations: Stations::of(solution, stations),
            extremes: ByName::of(Field::of(&model.beam), |field| solution.range(field).into()),
            checks: checks::of(context.limits, solution),
            certificate: *solution.certificate(),
            load_factors: context.factors.map(|factors| Grown::of(factors, Some(model))),
            iterations: solution.iterations(),
            seconds: context.seconds,
        }
    }
}

#[derive(Serialize)]
struct Checked {
    #[serde(flatten)]
    head: Head,
    existence: Proven,
    characteristics: Judged,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factors: Option<Grown>,
    seconds: Option<f64>,
}

impl Checked {
    fn of(status: &'static str, model: &Model, existence: &Existence, context: &Context) -> Self {
        Checked {
            head: Head::new(status, context),
            existence: Proven::new(model, existence, context),
            characteristics: Judged::new(model, existence),
            load_factors: context.factors.map(|factors| Grown::of(factors, Some(model))),
            seconds: context.seconds,
        }
    }
}

#[derive(Serialize)]
struct Unsolved {
    #[serde(flatten)]
    head: Head,
    method: &'static str,
    what: &'static str,
    tolerance: Option<f64>,
    reached: Option<f64>,
    iterations: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factors: Option<Grown>,
    seconds: Option<f64>,
}

impl Unsolved {
    fn of(reached: &Stopped, context: &Context) -> Self {
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

#[derive(Serialize)]
struct Head {
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    units: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    trough_chords: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    model_digest: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<String>,
}

impl Head {
    fn new(status: &'static str, context: &Context) -> Self {
        Head {
            status,
            title: context.title.map(str::to_owned),
            units: context.units.name(),
            trough_chords: context.chords,
            model_digest: context.digest.map(str::to_owned),
            combination: context.combination.map(str::to_owned),
        }
    }
}

#[derive(Serialize)]
struct Judged {
    /// Smallest and largest.
    beta: [f64; 2],
    beta_length: f64,
    /// Smallest and largest.
    shear_length: [f64; 2],
    resultant: Resultant,
}

#[derive(Serialize)]
struct Resultant {
    force: f64,
    at: Option<f64>,
}

impl Judged {
    fn new(model: &Model, existence: &Existence) -> Self {
        let Characteristics { beta, beta_length, shear_length, resultant } =
            Characteristics::of(model, existence);
        let resultant = Resultant { force: resultant.force, at: resultant.at };
        Judged { beta, beta_length, shear_length, resultant }
    }
}

#[derive(Serialize)]
struct Stretch {
    from: f64,
    to: f64,
}

#[derive(Serialize)]
struct Lifted {
    from: f64,
    to: f64,
    largest_gap: Point,
}

#[derive(Serialize)]
struct FreeSpan {
    from: f64,
    to: f64,
    length: f64,
    largest_gap: Point,
    /// `left`, `right`, `both` or `null`.
    reaches_end: Option<&'static str>,
}

impl FreeSpan {
    fn of(open: &LiftOff) -> Self {
        let reaches_end = match open.reaches {
            [true, true] => Some("both"),
            [true, false] => Some("left"),
            [false, true] => Some("right"),
            [false, false] => None,
        };
        let LiftOff { from, to, largest_gap, .. } = *open;
        FreeSpan { from, to, length: open.length(), largest_gap: largest_gap.into(), reaches_end }
    }
}

#[derive(Serialize)]
struct Ends {
    left: f64,
    right: f64,
}

#[derive(Serialize)]
struct Force {
    at: f64,
    force: f64,
}

#[derive(Serialize)]
struct Held {
    /// Its index in the model's list of supports.
    support: usize,
    at: f64,
    force: f64,
    moment: f64,
    /// Of a support that acts in one direction alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<&'static str>,
}

/// Whether a support that acts in one direction alone does.
fn state(support: &Support, force: f64) -> Option<&'static str> {
    match support.acts {
        Acts::Both => None,
        _ if force != 0.0 => Some("acting"),
        Acts::Up => Some("lifted"),
        Acts::Down => Some("slack"),
    }
}

/// A hinge: the jump of the slope, and the moment it hands on.
#[derive(Serialize)]
struct Turned {
    at: f64,
    rotation: f64,
    moment: f64,
}

/// Something of each field, by its name.
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

#[derive(Serialize)]
struct Stations {
    x: Vec<f64>,
    #[serde(flatten)]
    fields: ByName<Vec<f64>>,
}

impl Stations {
    fn of(solution: &Solution, positions: &[f64]) -> Self {
        let fields = positions.iter().map(|&x| solution.at(x, Side::Right)).collect();
        Stations::new(solution, positions.to_vec(), fields)
    }

    fn new(solution: &Solution, x: Vec<f64>, fields: Vec<Fields>) -> Self {
        let column = |field| fields.iter().map(|f| f.get(field)).collect();
        Stations { x, fields: ByName::of(Field::of(&solution.model().beam), column) }
    }

    fn is_empty(&self) -> bool {
        self.x.is_empty()
    }
}

#[derive(Serialize)]
struct Range {
    min: Point,
    max: Point,
}

#[derive(Serialize)]
struct Point {
    x: f64,
    value: f64,
}

impl From<Extreme> for Point {
    fn from(extreme: Extreme) -> Self {
        Point { x: extreme.x, value: extreme.value }
    }
}

impl From<groundbeam::Range> for Range {
    fn from(range: groundbeam::Range) -> Self {
        Range { min: range.min.into(), max: range.max.into() }
    }
}
