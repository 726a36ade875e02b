//! Compares the power series of an element with its differential equations and with closed forms.

#![cfg(test)]

use super::*;
use crate::element::ExactElement;
use crate::element::operator::Operator;
use crate::mesh::ground_stretch::GROUND;
use crate::model::Profile;
use crate::numeric::polynomial::{derivative, jet, product as times, value};

/// Returns the polynomials of an element whose beam and ground data vary; `shear` is the shear stiffness S of
/// the beam.
fn varying(shear: Option<[f64; Profile::MOST]>) -> Polynomials {
    Polynomials {
        stiffness: [1.0, 0.08, 0.005, 0.0002, 0.0, 0.0],
        shear,
        tension: [0.7, 0.3, 0.1],
        spring: [0.9, -0.4, 0.05],
        load: [1.0, -2.0, 0.3, 0.1],
        slope_load: [0.5, 0.1, 0.2],
        moment_load: [0.3, -0.2],
        curvature: [0.4, 0.7],
    }
}

const SHEAR: [f64; Profile::MOST] = [3.0, 0.2, 0.01, 0.0, 0.0, 0.0];

/// Returns the polynomials of an unloaded element with constant data.
fn uniform(stiffness: f64, tension: f64, spring: f64) -> Polynomials {
    Polynomials {
        stiffness: [stiffness, 0.0, 0.0, 0.0, 0.0, 0.0],
        shear: None,
        tension: [tension, 0.0, 0.0],
        spring: [spring, 0.0, 0.0],
        load: [0.0; GROUND + 1],
        slope_load: [0.0; GROUND],
        moment_load: [0.0; 2],
        curvature: [0.0; 2],
    }
}

#[test]
fn constant_data_give_the_uniform_element() {
    for (n, k) in [(0.0, 0.0), (2.0, 1.0), (-0.5, 0.3), (0.1, 2.0)] {
        let operator = Operator {
            stiffness: 1.5,
            tension: n,
            subgrade: k,
            load: [1.0, -2.0],
            moment_load: [0.5, 0.1],
            imposed_moments: [0.6, -0.3],
            polynomials: None,
        };
        let closed = ExactElement::new(&operator, 1.3);
        let all = Polynomials {
            load: [-0.5, -1.5, 0.0, 0.0],
            moment_load: [0.3, -0.2],
            curvature: [0.1, -0.3],
            ..uniform(1.5, n, k)
        };
        let (element, series) = Series::new(&all, 1.3);
        for i in 0..4 {
            let scale = closed.element.stiffness[i][i];
            assert!((element.load[i] - closed.element.load[i]).abs() < 1e-14);
            for j in 0..4 {
                let difference = element.stiffness[i][j] - closed.element.stiffness[i][j];
                assert!(difference.abs() <= 4e-15 * (scale + 1.0), "{n} {k} {i}{j}");
            }
        }
        let v = [0.3, -0.2, 0.1, 0.4];
        for (a, b) in series.deflection(&v).iter().zip(closed.unfold(&v).0) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}

/// Returns the coefficients of the shear force Q = S (w′ − φ) with the rotation φ. Without shear deformation, Q
/// is −m′ − g with the moment m and the moment load g.
fn shear_force(of: &Polynomials, slope: &[f64], rotation: &[f64], rise: &[f64]) -> Vec<f64> {
    if let Some(shear) = &of.shear {
        let strain: Vec<f64> = slope.iter().zip(rotation).map(|(d, turned)| d - turned).collect();
        return times(shear, &strain).to_vec();
    }
    let mut force: Vec<f64> = rise.iter().map(|rise| -rise).collect();
    for (force, turning) in force.iter_mut().zip(of.moment_load) {
        *force -= turning;
    }
    force
}

#[test]
fn the_series_solve_the_equations_and_take_their_end_values() {
    let (h, a) = (1.4, 0.7);
    for all in [varying(None), varying(Some(SHEAR))] {
        let (element, series) = Series::new(&all, h);
        let v = [0.3, -0.2, 0.1, 0.4];
        let w = series.deflection(&v);
        let by = |c: &[f64]| -> Vec<f64> { derivative(c).iter().map(|c| c / a).collect() };
        let slope = by(&w);
        let rotation = series.rotation(&v).map_or(slope.clone(), |own| own.to_vec());
        assert!((value(&w, -1.0) - 0.3).abs() < 1e-15);
        assert!((value(&rotation, -1.0) + 0.2).abs() < 1e-14);
        assert!((value(&w, 1.0) - (0.3 - 0.2 * h + 0.1)).abs() < 1e-15);
        assert!((value(&rotation, 1.0) - 0.2).abs() < 1e-14);
        // The moment is EI (φ′ − κ₀), with the rotation φ and the imposed curvature κ₀.
        let mut bend = by(&rotation);
        bend[0] -= all.curvature[0];
        bend[1] -= all.curvature[1];
        let moment = times(&all.stiffness, &bend);
        let shear_force = shear_force(&all, &slope, &rotation, &by(&moment));
        let from_axial = times(&all.tension, &slope);
        // The vertical force is the shear force plus N w′, minus the moment load of the shear layer.
        let total =
            |s: f64| value(&shear_force, s) + value(&from_axial, s) - value(&all.slope_load, s);
        for s in [-0.9, -0.3, 0.2, 0.8] {
            let rising = |c: &[f64]| jet(c, s)[1] / a;
            let turns = rising(&moment) + value(&shear_force, s) + value(&all.moment_load, s);
            assert!(turns.abs() < 1e-12, "{s}: {turns:e}");
            let carried = rising(&shear_force) + rising(&from_axial) - rising(&all.slope_load);
            let sinks = carried - value(&all.spring, s) * value(&w, s) + value(&all.load, s);
            assert!(sinks.abs() < 1e-11, "{s}: {sinks:e}");
        }
        let forces = element.forces(&v);
        assert!((forces[2] - total(1.0)).abs() < 1e-12, "{forces:?} {}", total(1.0));
        assert!((forces[0] - (total(1.0) - total(-1.0))).abs() < 1e-11);
        assert!((forces[3] - value(&moment, 1.0)).abs() < 1e-12);
        let turned = forces[1] - h * total(1.0) - value(&moment, 1.0) + value(&moment, -1.0);
        assert!(turned.abs() < 1e-11, "{turned:e}");
    }
}

/// The stiffness matrix is symmetric by the reciprocal theorem, but its computation does not use the symmetry.
/// So the difference from its transpose shows the rounding error.
#[test]
fn the_stiffness_is_symmetric_to_rounding() {
    for all in [varying(None), varying(Some(SHEAR))] {
        for h in [1e-3, 0.1, 0.7] {
            let solutions = Solutions::new(&all, 0.5 * h);
            let (ends, forces) = (solutions.ends(0.5 * h), solutions.forces(0.5 * h));
            let ([free @ .., _], [forces @ .., _]) = (&ends, &forces);
            let column = |i: usize| {
                let unit = std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
                combined(forces, &amplitudes(free, unit))
            };
            let k = [0, 1, 2, 3].map(column);
            for i in 0..4 {
                for j in 0..4 {
                    let scale = (k[i][i] * k[j][j]).sqrt();
                    let difference = (k[i][j] - k[j][i]).abs();
                    assert!(difference <= 1e-15 * scale, "{h} {i}{j}: {k:?}");
                }
            }
        }
    }
}

/// Compares the stiffness of the right end without ground and tension with Przemieniecki (1968), Theory of Matrix
/// Structural Analysis, (5.116). His Φ is 12 EI/(S h²) for the length h.
#[test]
fn without_ground_the_stiffness_is_that_of_przemieniecki() {
    for shear in [1e-6, 0.5, 40.0, 1e9] {
        let all =
            Polynomials { shear: Some([shear, 0.0, 0.0, 0.0, 0.0, 0.0]), ..uniform(3.0, 0.0, 0.0) };
        let h = 1.7;
        let k = Series::new(&all, h).0.stiffness;
        let phi = 12.0 * 3.0 / (shear * h * h);
        let unit = 3.0 / ((1.0 + phi) * h * h * h);
        let book = [[12.0, -6.0 * h], [-6.0 * h, (4.0 + phi) * h * h]];
        for i in 0..2 {
            for j in 0..2 {
                let [own, book] = [k[2 + i][2 + j], unit * book[i][j]];
                assert!((own / book - 1.0).abs() < 1e-13, "{shear:?} {own} {book}");
                assert_eq!(k[i][j], 0.0);
            }
        }
    }
}

/// A beam with a very large S behaves as a beam without shear deformation.
#[test]
fn a_large_shear_stiffness_leaves_bending_only() {
    let stiff = varying(Some([1e18, 0.0, 0.0, 0.0, 0.0, 0.0]));
    let [(element, shears), (other, bends)] =
        [stiff, varying(None)].map(|all| Series::new(&all, 1.3));
    for i in 0..4 {
        assert!((element.load[i] - other.load[i]).abs() < 1e-14, "{i}");
        for j in 0..4 {
            let difference = element.stiffness[i][j] - other.stiffness[i][j];
            assert!(difference.abs() < 1e-14 * element.stiffness[i][i], "{i}{j}");
        }
    }
    let v = [0.3, -0.2, 0.1, 0.4];
    for (a, b) in shears.deflection(&v).iter().zip(bends.deflection(&v)) {
        assert!((a - b).abs() < 1e-15, "{a} {b}");
    }
}
