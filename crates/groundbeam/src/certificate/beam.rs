//! The beam's part of the proof: how far w and φ are from the moment and the shear force of equilibrium.

use super::quadrature::{Seen, at_points, gauss, larger};
use super::statics::{Events, SpreadLoad};
use super::{Claim, ClaimedPiece};
use crate::model::{CellPolynomial, Extent, Model};
use crate::numeric::roots::is_free_of_zeros;

/// Energies and their parts, summed piece by piece.
#[derive(Debug, Default)]
pub(super) struct Sums {
    /// ∫EI (φ' − κ₀)², ∫P w'², ∫m²/EI, ∫(EI (φ' − κ₀) + m)²/EI, F(w), ∫1/EI, with ∫S (w' − φ)², ∫Q²/S and
    /// ∫(S (w' − φ) − Q)²/S where the beam shears, φ = w' where it does not.
    pub bending: f64,
    pub axial: f64,
    pub moment: f64,
    pub misfit: f64,
    pub work: f64,
    pub flexibility: f64,
    /// ∫1/S.
    pub shear_flexibility: f64,
    /// ∫EI κ₀² and ∫m κ₀.
    pub curling: f64,
    pub curled: f64,
    /// A piece is so long that 1/EI is no series on it that quadrature sees.
    pub too_long: bool,
    pub largest_deflection: f64,
    pub largest_slope: f64,
}

/// Where EI varies, how far from the middle of a piece, in half lengths, it must be free of zeros: then 1/EI is
/// analytic where |s| < 9, and quadrature misses less of it than 10⁻²⁸.
const FREE: f64 = 9.0;

/// The beam's part of a piece: m from equilibrium, its misfit to EI w″, the energies.
pub(super) fn beam_piece(
    model: &Model,
    piece: &ClaimedPiece,
    load: &SpreadLoad,
    seen: &Seen,
    events: &mut Events,
    sums: &mut Sums,
) {
    let half = piece.half;
    let course = model.beam.bending_stiffness_on(piece.x);
    let axial = model.beam.axial_force;
    let [shear_force, moment] = events.integrate(piece, load, axial);
    let moment = at_points(&moment);
    let mut stiffness = [course.at(0.0); Seen::POINTS];
    if course.is_constant() {
        sums.flexibility += 2.0 * half / course.at(0.0);
    } else {
        sums.too_long |= !is_free_of_zeros(&course.coefficients, FREE);
        stiffness = at_points(&course.coefficients);
        let flexibility = gauss().zip(stiffness).map(|((_, weight), stiffness)| weight / stiffness);
        sums.flexibility += half * flexibility.sum::<f64>();
    }
    let per_length = 1.0 / half;
    for (i, (s, weight)) in gauss().enumerate() {
        let dx = weight * half;
        let slope = seen.slope[i] * per_length;
        let curvature = load.curvature(s);
        let [turned, bend] = match seen.turned {
            Some([turned, bend]) => [turned[i], bend[i]],
            None => [seen.slope[i], seen.bend[i]],
        };
        let bend = stiffness[i] * (bend * per_length * per_length - curvature);
        let misfit = bend + moment[i];
        let soft = dx / stiffness[i];
        sums.bending += soft * bend * bend;
        sums.moment += soft * moment[i] * moment[i];
        sums.misfit += soft * misfit * misfit;
        sums.curling += dx * stiffness[i] * curvature * curvature;
        sums.curled += dx * moment[i] * curvature;
        sums.axial += dx * axial * slope * slope;
        let turned = turned * per_length;
        sums.work += dx * (load.force(s) * seen.deflection[i] + load.moment(s) * turned);
        sums.largest_slope = larger(sums.largest_slope, slope.abs());
    }
    if let Some(course) = model.beam.shear_stiffness_on(piece.x) {
        shear_piece(piece, load, seen, &course, &shear_force, sums);
    }
    let ends = seen.ends.map(|[w, _]| w);
    let deflections = seen.deflection.into_iter().chain(ends).map(f64::abs);
    sums.largest_deflection = deflections.fold(sums.largest_deflection, larger);
}

/// Where the beam shears: Q = V − g from equilibrium, its misfit to S (w' − φ), and what both take of the energies.
fn shear_piece(
    piece: &ClaimedPiece,
    load: &SpreadLoad,
    seen: &Seen,
    course: &CellPolynomial,
    shear_force: &[f64],
    sums: &mut Sums,
) {
    let half = piece.half;
    let shear_force = at_points(shear_force);
    let mut stiffness = [course.at(0.0); Seen::POINTS];
    if !course.is_constant() {
        sums.too_long |= !is_free_of_zeros(&course.coefficients, FREE);
        stiffness = at_points(&course.coefficients);
    }
    for (i, (s, weight)) in gauss().enumerate() {
        let strain = seen.turned.map_or(0.0, |[turned, _]| (seen.slope[i] - turned[i]) / half);
        let force = shear_force[i] - load.moment(s);
        let (bears, soft) = (stiffness[i] * strain, weight * half / stiffness[i]);
        let misfit = bears - force;
        sums.bending += soft * bears * bears;
        sums.moment += soft * force * force;
        sums.misfit += soft * misfit * misfit;
        sums.shear_flexibility += soft;
    }
}

/// The work of point loads.
pub(super) fn work_at_points(model: &Model, claim: &Claim, sums: &mut Sums) {
    for load in model.beam_loads() {
        if let Extent::Point { at, size } = load.extent() {
            let moved = claim.deflection(at).get(load.action().derivative()).copied();
            sums.work += size * moved.unwrap_or(0.0);
        }
    }
}
