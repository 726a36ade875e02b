//! The modified Vlasov model: the rate at which the ground's surface varies is taken from the solution.
//!
//! k and μ of [layers](super::layers) depend on r = ∫u'²/∫u², and u depends on k and μ. Vallabhan and Das
//! (*Modified Vlasov model for beams on elastic foundations*, J. Geotech. Eng. 117(6), 1991) iterate
//! between the two; here every u is exact, on the whole line, beyond the beam and where it has lifted off.

use super::layers::{LayeredSoil, squares};
use super::{Bed, OnSoil};
use crate::contact::forms::inner;
use crate::model::Model;
use crate::solution::{Solution, Stretch};
use crate::solve::{Error, NotConverged, Options, Outcome, solve_with};

/// The relative change of r that ends the iteration.
const SETTLED: f64 = 1e-12;
const MOST_ROUNDS: usize = 100;

/// Solves a beam on a bed of layered soil, with k and μ from the solution itself.
pub(super) fn solve(
    model: &Model,
    layers: &LayeredSoil,
    bed: &Bed,
    options: &Options,
) -> Result<OnSoil, Error> {
    let mut rate = layers.rate(1.0);
    let mut before: Option<[f64; 2]> = None;
    for rounds in 1..=MOST_ROUNDS {
        let subgrade = layers.subgrade(rate, bed.width).times(bed.factors);
        let outcome = solve_with(&subgrade.under(model), options)?;
        let found = match &outcome {
            Outcome::Equilibrium(solution) => rate_of(solution),
            Outcome::NoEquilibrium(_) => None,
        };
        let found = found.filter(|found| (found - rate).abs() > SETTLED * rate);
        let Some(found) = found else {
            let gamma = Some(layers.gamma(rate));
            return Ok(OnSoil { outcome, subgrade, gamma, rounds });
        };
        let next = accelerated(before, [rate, found]);
        before = Some([rate, found]);
        rate = next;
    }
    let reached = before.map_or(f64::NAN, |[rate, found]| (found / rate - 1.0).abs());
    Err(Error::NotConverged(NotConverged {
        method: options.method,
        iterations: MOST_ROUNDS,
        tolerance: SETTLED,
        reached,
        what: "the relative change of the rate r = ∫u'²/∫u² from one solution to the next",
    }))
}

/// The secant through two rounds where it stays positive and near, else the plain iteration.
fn accelerated(before: Option<[f64; 2]>, [rate, found]: [f64; 2]) -> f64 {
    let Some([rate_0, found_0]) = before else { return found };
    let slope = (found - found_0) / (rate - rate_0);
    let next = rate + (found - rate) / (1.0 - slope);
    let near = next > 0.25 * found.min(rate) && next < 4.0 * found.max(rate);
    if near { next } else { found }
}

/// r = ∫u'²/∫u² over the whole line; none where the ground does not move.
fn rate_of(solution: &Solution) -> Option<f64> {
    let mut sums = [0.0; 2];
    let mut add = |part: [f64; 2]| {
        sums = [sums[0] + part[0], sums[1] + part[1]];
    };
    solution.stretches.iter().for_each(|stretch| add(on(stretch)));
    let ends = [(solution.stretches.first(), -1.0), (solution.stretches.last(), 1.0)];
    for (stretch, s) in ends {
        let Some(stretch) = stretch else { continue };
        // A ground made of soil is endless.
        let [spring, shear] = stretch.cell.ground_at(s);
        let u = stretch.fields(s).settlement;
        // u falls like e^(−bx).
        let b = (spring / shear).sqrt();
        add([0.5 * u * u / b, 0.5 * u * u * b]);
    }
    (sums[0] > 0.0).then(|| sums[1] / sums[0])
}

/// ∫u² and ∫u'² on a stretch.
fn on(stretch: &Stretch) -> [f64; 2] {
    let half = stretch.half;
    let of = |u: &[f64]| [half * inner(u, u, 0), inner(u, u, 1) / half];
    match stretch.open {
        None => of(&stretch.cell.obstacle(&stretch.deflection)),
        Some(_) if !stretch.settlement.is_empty() => of(&stretch.settlement),
        Some([left, right]) => {
            let length = 2.0 * half;
            let b = (stretch.cell.spring / stretch.cell.shear).sqrt();
            let [u, slope] = squares(left, right, b * length);
            [u * length, slope / length]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};
    use crate::soil::{Soil, SoilLayer};

    /// Vallabhan and Das (1991), feet and kips, a beam of 100 on soil 25 deep under an even load: γ = 0.395.
    /// (Their force at the middle, 0.507, holds for ground that pulls: here the ends lift off.)
    #[test]
    fn vallabhan_and_das() {
        let layer = SoilLayer { modulus: 144.0, poisson: 0.2, thickness: 25.0 };
        let soil = LayeredSoil { layers: vec![layer] };
        let bed = Bed::new(Soil::ModifiedVlasov(soil.clone()), 1.0);
        let beam = || Model::new(Beam::uniform(100.0, 432_000.0 * 2.25), Foundation::winkler(1.0));
        let solved = |load: Load| {
            let model = beam().with_load(load);
            let found = solve(&model, &soil, &bed, &Options::default()).unwrap();
            assert!(found.rounds < 8, "{}", found.rounds);
            let Outcome::Equilibrium(solution) = found.outcome else { panic!("it stands") };
            (found.gamma.unwrap(), solution.contact()[0].from)
        };
        let (gamma, from) = solved(Load::uniform(3.0, 0.0, 100.0));
        assert!((gamma - 0.394_598).abs() < 5e-7 && from == 0.0, "{gamma}");
        let (gamma, from) = solved(Load::point(20.0, 50.0));
        assert!(gamma < 0.507 && from > 13.0, "{gamma} {from}");
    }

    /// ∫u² and ∫u'² against the middle of a thousand cuts, in contact, off it and beyond the ends.
    #[test]
    fn the_rate_by_brute_force() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point(1.0, 0.5))
            .with_load(Load::moment(0.49, 0.5));
        let Outcome::Equilibrium(solution) = solve_with(&model, &Options::default()).unwrap()
        else {
            panic!("it stands")
        };
        let (from, to, cuts) = (-20.0, 21.0, 410_000);
        let h = (to - from) / f64::from(cuts);
        let u = |i: i32| solution.settlement(from + h * f64::from(i));
        let mut sums = [0.0; 2];
        for i in 0..cuts {
            let (a, b) = (u(i), u(i + 1));
            sums = [sums[0] + h * (a * a + a * b + b * b) / 3.0, sums[1] + (b - a).powi(2) / h];
        }
        let rate = rate_of(&solution).unwrap();
        assert!((rate / (sums[1] / sums[0]) - 1.0).abs() < 1e-7, "{rate} {sums:?}");
    }
}
