//! Compares the results of random models whose settlement troughs are replaced by n and by 2n chords (straight segments).

use groundbeam::{Field, Model, Outcome, Solution, model::GapPoint, solution::Range, solve};
use groundbeam_file::{Diagnostics, Document, parse};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fmt::Write;

/// A settlement trough S exp(−(x − x₀)²/2i²).
#[derive(Debug, Clone, Copy)]
pub struct Trough {
    /// Position x₀ of the largest settlement.
    pub at: f64,
    /// Largest settlement S.
    pub settlement: f64,
    /// Width i of the trough, the distance of its inflection points from its centre x₀.
    pub width: f64,
}

/// A model file and the settlement troughs of its ground.
#[derive(Debug)]
pub struct Drawn {
    /// The file.
    pub text: String,
    /// The settlement troughs that the file describes.
    pub troughs: Vec<Trough>,
}

/// Returns the random model with the given number. Even numbers have Winkler ground, odd numbers a shear layer. The
/// data vary more widely than in practice.
pub fn drawn(number: u64) -> Drawn {
    let mut random = ChaCha8Rng::seed_from_u64(number);
    let r = &mut random;
    let length = decades(r, 0.3, 3.3);
    let k = decades(r, 4.0, 9.0);
    let stiffness_length = length / decades(r, -0.5, 2.5);
    let bending = k * stiffness_length.powi(4);
    let layer = k * (length * decades(r, -3.0, 0.0)).powi(2);
    let mu = if number.is_multiple_of(2) { 0.0 } else { layer };
    let tension =
        if one_of(r, 3) { 2.0 * (k * bending).sqrt() * decades(r, -3.0, 1.5) } else { 0.0 };
    let mut text =
        format!("[beam]\nlength = {length:e}\nEI = {bending:e}\naxial_force = {tension:e}\n");
    if one_of(r, 6) {
        let _ = writeln!(
            text,
            "shear_stiffness = {:e}",
            bending / (length * decades(r, -2.0, 0.0)).powi(2)
        );
    }
    if one_of(r, 4) {
        let [from, to] = stretch(r, length);
        let factor = decades(r, -1.0, 1.0);
        let _ = writeln!(
            text,
            "[[beam.segment]]\nfrom = {from:e}\nto = {to:e}\nEI = {:e}",
            bending * factor
        );
    }
    let _ = writeln!(text, "[foundation]\nk = {k:e}\nmu = {mu:e}");
    if one_of(r, 4) {
        let [from, to] = stretch(r, length);
        let [of_k, of_mu] = [decades(r, -1.0, 1.0), decades(r, -1.0, 1.0)];
        let (k, mu) = (k * of_k, mu * of_mu);
        let _ = writeln!(
            text,
            "[[foundation.segment]]\nfrom = {from:e}\nto = {to:e}\nk = {k:e}\nmu = {mu:e}"
        );
    }
    let load = decades(r, 2.0, 6.0);
    loads(r, length, load, &mut text);
    if one_of(r, 5) {
        let _ = writeln!(text, "[[support]]\nat = 0\ntype = 'pinned'");
    }
    let mut troughs = Vec::new();
    for _ in 0..r.random_range(1..=3) {
        let sign = if one_of(r, 8) { -1.0 } else { 1.0 };
        let trough = Trough {
            at: length * r.random_range(-0.3..1.3),
            settlement: sign * load / k * decades(r, -2.0, 4.0),
            width: length * decades(r, -2.0, 0.7),
        };
        let Trough { at, settlement, width } = trough;
        let _ = writeln!(
            text,
            "[[gap_trough]]\nat = {at:e}\nsettlement = {settlement:e}\nwidth = {width:e}"
        );
        troughs.push(trough);
        if one_of(r, 2) {
            break;
        }
    }
    Drawn { text, troughs }
}

fn loads(r: &mut impl Rng, length: f64, load: f64, text: &mut String) {
    let uniform = !one_of(r, 4);
    if uniform {
        let _ = writeln!(text, "[[load]]\ndistributed = {load:e}");
    }
    for _ in 0..r.random_range(u32::from(!uniform)..4) {
        let at = length * r.random_range(0.05..0.95);
        let force = load * length * decades(r, -2.0, 0.0);
        let _ = writeln!(text, "[[load]]\npoint = {force:e}\nat = {at:e}");
    }
    if one_of(r, 4) {
        let at = length * r.random_range(0.05..0.95);
        let moment = load * length * length * decades(r, -3.0, -1.0);
        let _ = writeln!(text, "[[load]]\nmoment = {moment:e}\nat = {at:e}");
    }
}

fn stretch(r: &mut impl Rng, length: f64) -> [f64; 2] {
    let from = r.random_range(0.0..0.8);
    [from * length, r.random_range(from + 0.05..1.0) * length]
}

fn one_of(r: &mut impl Rng, many: u32) -> bool {
    r.random_range(0..many) == 0
}

fn decades(r: &mut impl Rng, from: f64, to: f64) -> f64 {
    10.0_f64.powf(r.random_range(from..to))
}

/// Returns the model with twice as many straight segments of the ground surface. Each new corner of the surface lies on
/// the exact curve of the settlement troughs.
pub fn doubled(model: &Model, troughs: &[Trough]) -> Model {
    let depth = |x: f64| {
        let of = |trough: &Trough| {
            let t = (x - trough.at) / trough.width;
            trough.settlement * (-0.5 * t * t).exp()
        };
        troughs.iter().map(of).sum::<f64>()
    };
    let mut gap = Vec::new();
    for pair in model.gap.windows(2) {
        let at = 0.5 * (pair[0].at + pair[1].at);
        let straight =
            0.5 * (pair[0].value - depth(pair[0].at) + pair[1].value - depth(pair[1].at));
        let value = straight + depth(at);
        // The solver does not accept magnitudes below 10⁻⁶⁰ except zero.
        let value = if value.abs() < 1e-60 { 0.0 } else { value };
        gap.extend([pair[0], GapPoint { at, value }]);
    }
    gap.extend(model.gap.last());
    Model { gap, ..model.clone() }
}

/// The relative differences between two solutions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Changed {
    /// Differences between the extremes of deflection, moment and pressure in the two solutions. Each difference is
    /// relative to the largest magnitude of the same quantity.
    pub fields: [f64; 3],
    /// The largest distance from a contact edge of one solution to the nearest contact edge of the other solution,
    /// relative to the beam length.
    pub edges: f64,
}

/// Returns the differences between two solutions.
pub fn changed(coarse: &Solution, fine: &Solution) -> Changed {
    let fields = [Field::Deflection, Field::Moment, Field::Pressure].map(|field| {
        let [a, b]: [Range; 2] = [coarse, fine].map(|solution| solution.range(field));
        let size = b.min.value.abs().max(b.max.value.abs());
        let change = (a.min.value - b.min.value).abs().max((a.max.value - b.max.value).abs());
        if change == 0.0 { 0.0 } else { change / size }
    });
    let [a, b] = [coarse, fine].map(edges);
    let edges = apart(&a, &b).max(apart(&b, &a));
    Changed { fields, edges: edges / fine.model().beam.length }
}

/// An end of a contact zone.
struct Edge {
    at: f64,
    /// Length of the part of the beam without contact that ends at the contact edge.
    opening: f64,
}

fn edges(solution: &Solution) -> Vec<Edge> {
    let length = solution.model().beam.length;
    let contact = solution.contact();
    let before = [0.0].into_iter().chain(contact.iter().map(|zone| zone.to));
    let after = contact.iter().map(|zone| zone.from).chain([length]);
    let openings = before.zip(after).filter(|(from, to)| to > from);
    let ends = |(from, to): (f64, f64)| [from, to].map(|at| Edge { at, opening: to - from });
    openings.flat_map(ends).collect()
}

/// Returns the largest distance from an edge in `from` to the nearest edge in `to`, at most half the adjacent opening.
/// On a shear layer, some openings at corners exist in only one of the two models.
fn apart(from: &[Edge], to: &[Edge]) -> f64 {
    let distance = |edge: &Edge| {
        to.iter().map(|other| (edge.at - other.at).abs()).fold(0.5 * edge.opening, f64::min)
    };
    from.iter().map(distance).fold(0.0, f64::max)
}

/// The result for a model.
#[derive(Debug)]
pub enum Result {
    /// The reader refuses the file.
    Refused(Diagnostics),
    /// No equilibrium exists, for any shape of the ground.
    NoEquilibrium,
    /// The method did not converge.
    Failed(String),
    /// The model is solved twice, with the settlement troughs replaced by the default number of chords and by twice
    /// as many chords.
    Solved {
        /// Default number of chords (straight segments) that replace the curve of the settlement troughs.
        chords: usize,
        /// Numbers of contact zones in two solutions: one with the default number of chords that replace the settlement
        /// troughs, the other with twice as many chords.
        zones: [usize; 2],
        /// Differences between two solutions: one with the default number of chords that replace the settlement
        /// troughs, the other with twice as many chords.
        changed: Changed,
        /// Time of the first solution in seconds.
        seconds: f64,
    },
}

/// Solves the random model `number` twice: with the curve of the settlement troughs replaced by the default number of
/// chords (straight segments), and by twice as many chords.
pub fn result(number: u64) -> Result {
    let Drawn { text, troughs } = drawn(number);
    let Document { model, chords, .. } = match parse(&text) {
        Ok(document) => document,
        Err(refused) => return Result::Refused(refused),
    };
    let fine = doubled(&model, &troughs);
    let start = std::time::Instant::now();
    let coarse = solve(&model);
    let seconds = start.elapsed().as_secs_f64();
    match (coarse, solve(&fine)) {
        (Ok(Outcome::Equilibrium(coarse)), Ok(Outcome::Equilibrium(fine))) => Result::Solved {
            chords: chords.unwrap_or(0),
            zones: [coarse.contact().len(), fine.contact().len()],
            changed: changed(&coarse, &fine),
            seconds,
        },
        (Err(error), _) | (_, Err(error)) => Result::Failed(error.to_string()),
        _ => Result::NoEquilibrium,
    }
}
