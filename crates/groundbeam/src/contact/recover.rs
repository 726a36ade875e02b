//! Moments from equilibrium for the cubic elements.
//!
//! −EI w″ of a cubic is linear in each element and jumps between them. The forces the element demands of
//! its ends are far better (they are in equilibrium with loads and pressure to rounding), and between
//! the ends equilibrium itself gives shear and moment: T' = p − f, M' = T − P w' + g. An imposed curvature is in
//! what the element demands already.

use super::surface::SurfacePart;
use crate::contact::state::ContactState;
use crate::element::cubic;
use crate::mesh::deflection::pressure_of;
use crate::numeric::polynomial::{Coefficients, integral, rescale};

/// The coefficients of M(s) on each part, in the part's own coordinate.
pub(crate) fn moments(
    found: &ContactState,
    parts: &[SurfacePart],
    point_forces: &[(usize, f64, f64)],
) -> Vec<Coefficients> {
    let mesh = &found.mesh;
    let w = found.deflection();
    let mut moments = Vec::with_capacity(parts.len());
    let mut first = 0;
    for i in 0..mesh.cells.len() {
        let count = parts[first..].iter().take_while(|part| part.cell == i).count();
        let own = &parts[first..first + count];
        first += count;
        let cell = &mesh.cells[i];
        let h = cell.length();
        let spread = distributed(found) && own.iter().any(|part| part.open.is_none());
        let pressure = if spread {
            pressure_of(cell, 0.5 * h, &w.obstacle(i))
        } else {
            Coefficients::default()
        };
        let mut demand = cubic::element(cell, mesh.axial_force).forces(&found.shapes[i]);
        for part in own.iter().filter(|part| spread && part.open.is_none()) {
            cubic::add_work(&mut demand, h, part.s, &pressure);
        }
        let inside = point_forces.iter().filter(|(c, s, _)| *c == i && s.abs() < 1.0);
        for (_, s, force) in inside {
            let z = cubic::deflection(0.5 * (1.0 + s), h);
            for j in 0..4 {
                demand[j] += force * z[j];
            }
        }
        let mut shear = demand[2] - demand[0];
        let mut moment = demand[1] - h * demand[2] - demand[3];
        for part in own {
            let [from, to] = part.s;
            let (middle, quarter) = (0.5 * (from + to), 0.5 * (to - from));
            let half = 0.5 * h * quarter;
            let linear = |v: [f64; 2]| {
                let [mean, rise] = [0.5 * (v[0] + v[1]), 0.5 * (v[1] - v[0])];
                [mean + rise * middle, rise * quarter]
            };
            let touching = spread && part.open.is_none();
            let mut net =
                if touching { rescale(&pressure, middle, quarter) } else { Coefficients::zeros(2) };
            for (net, f) in net.iter_mut().zip(linear(cell.load)) {
                *net -= f;
            }
            let total = integral(&net, half, shear);
            let mut slope = total.at_least(4);
            let deflection = rescale(w.cell(i), middle, quarter);
            for (j, c) in deflection.iter().enumerate().skip(1) {
                slope[j - 1] -= mesh.axial_force * j as f64 * c / half;
            }
            for (slope, g) in slope.iter_mut().zip(linear(cell.moment_load)) {
                *slope += g;
            }
            let m = integral(&slope, half, moment);
            (shear, moment) = (total.iter().sum(), m.iter().sum());
            for (_, _, force) in
                point_forces.iter().filter(|(c, s, _)| *c == i && *s == to && to < 1.0)
            {
                shear += force;
            }
            moments.push(m);
        }
    }
    moments
}

fn distributed(found: &ContactState) -> bool {
    found.pressure == crate::options::Pressure::Distributed
}
