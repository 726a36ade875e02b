//! Computes k and μ of the modified Vlasov model from r = ∫u'²/∫u², where u is the ground displacement of the solution.
//!
//! k and μ depend on r, and u depends on k and μ. So both are computed in turn, as by Vallabhan and Das (1991). See
//! *Layers* in `docs/soil.md`.

use crate::error::{Error, NotConverged, Stopped};
use crate::ground::link::{between, cut, slope_between};
use crate::model::soil::layers::squares;
use crate::model::soil::{LayeredSoil, Soil, SoilModel};
use crate::model::{Extent, Model};
use crate::numeric::polynomial::inner;
use crate::numeric::quadrature::gauss;
use crate::numeric::tolerance::SOIL;
use crate::options::Method;
use crate::outcome::Outcome;
use crate::solution::fields::SolutionPiece;
use crate::solution::solution::{SoilRounds, Solution};

const MOST_ROUNDS: usize = 100;

/// Solves a beam on a soil model. The argument `solve` solves a model whose k and μ are given.
pub(crate) fn solve(
    soil: &SoilModel,
    model: &Model,
    method: Method,
    mut solve: impl FnMut(&Model) -> Result<Outcome, Error>,
) -> Result<Outcome, Error> {
    if let Soil::ModifiedVlasov(layers) = &soil.soil {
        return iterate(soil, model, layers, method, solve);
    }
    let outcome = solve(&model.on_given_ground())?;
    Ok(on_soil(outcome, soil.gamma(), 1))
}

/// Adds the decay parameter γ of the soil displacement over the depth, and the number of rounds of the soil iteration,
/// to the solution.
fn on_soil(outcome: Outcome, gamma: Option<f64>, rounds: usize) -> Outcome {
    match outcome {
        Outcome::Equilibrium(solution) => {
            Outcome::Equilibrium(Box::new(solution.on_soil(SoilRounds { gamma, rounds })))
        }
        none @ Outcome::NoEquilibrium(_) => none,
    }
}

/// Iterates on r = ∫u'²/∫u² of the ground displacement u, until k and μ belong to the r of the solution. The initial r
/// belongs to the decay parameter γ = 1.
fn iterate(
    soil: &SoilModel,
    model: &Model,
    layers: &LayeredSoil,
    method: Method,
    mut solve: impl FnMut(&Model) -> Result<Outcome, Error>,
) -> Result<Outcome, Error> {
    let mut rate = layers.rate(1.0);
    let mut before: Option<[f64; 2]> = None;
    for rounds in 1..=MOST_ROUNDS {
        let subgrade = layers.subgrade(rate, soil.width).times(soil.factors);
        let outcome = solve(&model.on_ground(subgrade))?;
        let found = match &outcome {
            Outcome::Equilibrium(solution) => rate_of(solution),
            Outcome::NoEquilibrium(_) => None,
        };
        let found = found.filter(|found| (found - rate).abs() > SOIL * rate);
        let Some(found) = found else {
            return Ok(on_soil(outcome, Some(layers.gamma(rate)), rounds));
        };
        let next = accelerated(before, [rate, found]);
        before = Some([rate, found]);
        rate = next;
    }
    let reached = before.map_or(f64::NAN, |[rate, found]| (found / rate - 1.0).abs());
    Err(Error::NotConverged(Stopped {
        method,
        iterations: MOST_ROUNDS,
        why: NotConverged::Soil(reached),
    }))
}

/// Returns the next value of the ratio r by the secant method from the last two iterations. If the secant step is too
/// large, returns `found`.
fn accelerated(before: Option<[f64; 2]>, [rate, found]: [f64; 2]) -> f64 {
    let Some([rate_0, found_0]) = before else { return found };
    let slope = (found - found_0) / (rate - rate_0);
    let next = rate + (found - rate) / (1.0 - slope);
    let near = next > 0.25 * found.min(rate) && next < 4.0 * found.max(rate);
    if near { next } else { found }
}

/// Returns r = ∫u'²/∫u² over the whole ground; `None` if u = 0 everywhere.
fn rate_of(solution: &Solution) -> Option<f64> {
    let neighbours = solution.model().has_ground_loads();
    let mut sums = [0.0; 2];
    let mut add = |part: [f64; 2]| {
        sums = [sums[0] + part[0], sums[1] + part[1]];
    };
    for piece in solution.pieces() {
        let loaded = neighbours && piece.open.is_some();
        add(if loaded { on_loaded(piece) } else { on(piece) });
    }
    for right in [false, true] {
        add(beyond(solution, right));
    }
    (sums[0] > 0.0).then(|| sums[1] / sums[0])
}

/// Returns ∫u² and ∫u'² of the ground displacement u outside one end of the beam. Beyond the last load on the ground, u
/// decays exponentially.
fn beyond(solution: &Solution, right: bool) -> [f64; 2] {
    let piece = if right { solution.pieces().last() } else { solution.pieces().first() };
    let Some(piece) = piece else { return [0.0; 2] };
    let [spring, shear] = piece.cell.ground_at(if right { 1.0 } else { -1.0 });
    let b = (spring / shear).sqrt();
    let l = solution.model().beam.length;
    let place = |out: f64| if right { l + out } else { -out };
    let out = |x: f64| if right { x - l } else { -x };
    let loads = solution.model().ground_loads();
    let marks = loads.flat_map(|load| load.extent.ends()).map(out);
    let mut marks: Vec<f64> = marks.filter(|out| *out > 0.0).chain([0.0]).collect();
    marks.sort_by(f64::total_cmp);
    marks.dedup();
    let mut sums = [0.0; 2];
    // Between ends of loads, u is the load divided by k, plus two exponential functions.
    for part in marks.windows(2).map(|part| [part[0], part[1]]) {
        let middle = place(0.5 * (part[0] + part[1]));
        let pressed = part.map(|out| pressure(solution.model(), place(out), middle) / spring);
        let h = part[1] - part[0];
        let ends = [0, 1].map(|i| solution.settlement(place(part[i])) - pressed[i]);
        let u = |s: f64| {
            let t = 0.5 * (1.0 + s);
            let straight = (1.0 - t) * pressed[0] + t * pressed[1];
            let rises = (pressed[1] - pressed[0]) / h;
            let bends = between(ends[0], ends[1], b * h, t);
            [straight + bends, rises + b * slope_between(ends[0], ends[1], b * h, t)]
        };
        let part = quadrature(h, b, u);
        sums = [sums[0] + part[0], sums[1] + part[1]];
    }
    let last = solution.settlement(place(marks[marks.len() - 1]));
    [sums[0] + 0.5 * last * last / b, sums[1] + 0.5 * last * last * b]
}

/// Returns the distributed load on the ground at x \[N/m\]. If the load jumps at x, returns its limit from the side on
/// which the position `within` lies.
fn pressure(model: &Model, x: f64, within: f64) -> f64 {
    let each = model.ground_loads().map(|load| match load.extent {
        Extent::Distributed { from, to, start, end } if from <= within && within <= to => {
            (start * (to - x) + end * (x - from)) / (to - from)
        }
        _ => 0.0,
    });
    each.sum()
}

/// Returns ∫u² and ∫u'² of the ground displacement u on a piece out of contact, in a model with loads on the ground.
fn on_loaded(piece: &SolutionPiece) -> [f64; 2] {
    let b = (piece.cell.subgrade / piece.cell.shear_layer).sqrt();
    quadrature(2.0 * piece.half, b, |s| {
        let fields = piece.fields(s);
        piece.settlement(s, fields.deflection, fields.slope)
    })
}

/// Returns ∫u² dx and ∫u'² dx over a stretch of the given length by Gauss quadrature. `u` returns u and u' at s from −1
/// to 1. `b` is √(k/μ).
fn quadrature(length: f64, b: f64, u: impl Fn(f64) -> [f64; 2]) -> [f64; 2] {
    let mut cuts = vec![0.0, length];
    cut([0.0, length], 1.0 / b, &mut cuts);
    cuts.retain(|x| (0.0..=length).contains(x));
    cuts.sort_by(f64::total_cmp);
    let mut sums = [0.0; 2];
    for part in cuts.windows(2) {
        let (middle, half) = (0.5 * (part[0] + part[1]), 0.5 * (part[1] - part[0]));
        for (s, weight) in gauss() {
            let [u, slope] = u(2.0 * (middle + half * s) / length - 1.0);
            sums = [sums[0] + weight * half * u * u, sums[1] + weight * half * slope * slope];
        }
    }
    sums
}

/// Returns ∫u² and ∫u'² of the ground displacement u on a piece of the solution in contact, or on a piece without
/// contact and without loads on the ground.
fn on(piece: &SolutionPiece) -> [f64; 2] {
    let half = piece.half;
    let of = |u: &[f64]| [half * inner(u, u, 0), inner(u, u, 1) / half];
    match piece.open {
        None => of(&piece.cell.above_gap(&piece.deflection)),
        Some(_) if !piece.settlement.is_empty() => of(&piece.settlement),
        Some([left, right]) => {
            let length = 2.0 * half;
            let b = (piece.cell.subgrade / piece.cell.shear_layer).sqrt();
            let [u, slope] = squares(left, right, b * length);
            [u * length, slope / length]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Load;
    use crate::model::{Beam, Foundation};
    use crate::numeric::elementary::power;
    use crate::soil::SoilLayer;
    use crate::{Options, solve_with};

    /// Vallabhan and Das (1991) compute γ = 0.395 for a uniform load and 0.507 for a force at the middle, in feet and
    /// kips. Their ground can pull. Here the ends lift off, so the second γ is smaller.
    #[test]
    fn vallabhan_and_das() {
        let layer = SoilLayer { modulus: 144.0, poisson: 0.2, thickness: 25.0 };
        let soil = LayeredSoil { layers: vec![layer] };
        let soil = SoilModel::new(Soil::ModifiedVlasov(soil), 1.0);
        let beam = Beam::uniform(100.0, 432_000.0 * 2.25);
        let model = Model::new(beam.clone(), Foundation::on_soil(soil, &beam));
        let solved = |load: Load| {
            let found = solve_with(&model.clone().with_load(load), &Options::default()).unwrap();
            let Outcome::Equilibrium(solution) = found else { panic!("it stands") };
            let found = solution.soil().unwrap();
            assert!(found.rounds < 8, "{}", found.rounds);
            (found.gamma.unwrap(), solution.contact()[0].from)
        };
        let (gamma, from) = solved(Load::uniform_force(0.0, 100.0, 3.0));
        assert!((gamma - 0.394_598).abs() < 5e-7 && from == 0.0, "{gamma}");
        let (gamma, from) = solved(Load::point_force(50.0, 20.0));
        assert!(gamma < 0.507 && from > 13.0, "{gamma} {from}");
    }

    /// Compares r = ∫u'²/∫u² with that of a linear interpolation of u between many points, with and without loads on
    /// the ground.
    #[test]
    fn the_rate_agrees_with_linear_interpolation() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let neighbours = [
            Load::ground_force(1.7, 0.6),
            Load::ground_force(0.1, 0.02),
            Load::distributed_ground_force(0.9, 2.4, 0.1, 0.3),
            Load::distributed_ground_force(-9.0, -0.5, 0.2, 0.05),
        ];
        let beside = neighbours.into_iter().fold(model.clone(), Model::with_load);
        for model in [model, beside] {
            let found = solve_with(&model, &Options::default()).unwrap();
            let Outcome::Equilibrium(solution) = found else { panic!("it stands") };
            let (from, to, cuts) = (-30.0, 30.0, 120_000);
            let h = (to - from) / f64::from(cuts);
            let u = |i: i32| solution.settlement(from + h * f64::from(i));
            let mut sums = [0.0; 2];
            let mut a = u(0);
            for i in 0..cuts {
                let b = u(i + 1);
                sums = [sums[0] + h * (a * a + a * b + b * b) / 3.0, sums[1] + power(b - a, 2) / h];
                a = b;
            }
            let rate = rate_of(&solution).unwrap();
            assert!((rate / (sums[1] / sums[0]) - 1.0).abs() < 1e-6, "{rate} {sums:?}");
        }
    }
}
