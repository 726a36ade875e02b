//! Deflection as a polynomial in each cell of a mesh, and from it the ground reaction at points of the beam.

use crate::mesh::cell::Cell;
use crate::mesh::cell::{gap_at, initial, initial_gap_at};
use crate::mesh::mesh::Mesh;
use crate::mesh::varying;
use crate::numeric::polynomial::{Coefficients, TERMS, jet, value, with_slope};
use crate::numeric::real::Real;
use crate::numeric::tolerance::SUM_ROUNDING;

/// Point of the beam, given by the index of a cell and the coordinate s ∈ \[−1, 1\] in this cell.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct BeamPoint {
    pub cell: usize,
    pub s: f64,
}

/// Contact zone between two points. If the two points are equal, the zone is a point contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeshZone {
    pub from: BeamPoint,
    pub to: BeamPoint,
}

/// Deflection w on a mesh, as a polynomial with [`TERMS`] coefficients in each cell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Deflection<'a, R = f64> {
    pub mesh: &'a Mesh<R>,
    pub coefficients: &'a [R],
}

impl<R: Real> Deflection<'_, R> {
    pub fn cell(&self, i: usize) -> &[R] {
        &self.coefficients[i * TERMS..(i + 1) * TERMS]
    }

    /// Coefficients in cell i of ψ = w − g₀ − u₀, which is the deflection minus the initial gap and the free-field
    /// settlement.
    pub fn obstacle(&self, i: usize) -> Coefficients<R> {
        self.mesh.cells[i].obstacle(self.cell(i))
    }

    /// Returns the value of ψ at a point. ψ is the deflection minus the initial gap and the free-field settlement.
    pub fn obstacle_at(&self, point: BeamPoint) -> R {
        value(self.cell(point.cell), point.s) - gap_at(&self.mesh.cells[point.cell], point.s)
    }

    /// Returns ψ, ψ' and the ground pressure kψ − (μψ')' at a point, where ψ is the deflection minus the initial gap
    /// and the free-field settlement.
    pub fn obstacle_and_pressure(&self, point: BeamPoint) -> [R; 3] {
        let cell = &self.mesh.cells[point.cell];
        let [f, d1, d2, _] = jet(self.cell(point.cell), point.s);
        let [settled, sinks] = cell.free_field_at(point.s);
        // The terms of the pressure with the free-field settlement u₀ are −ku₀ + (μu₀′)′. They sum to −q, so the load
        // q on the ground is subtracted in place of these terms.
        let psi = f - initial_gap_at(cell, point.s);
        let per_length = 2.0 / cell.length();
        let slope = d1 * per_length - cell.gap_slope;
        let [k, mu, rise] = cell.ground_rising_at(point.s);
        let load = initial(cell.ground_load, point.s);
        let pressure =
            k * psi - mu * d2 * per_length * per_length - rise * per_length * slope - load;
        [psi - settled, slope - sinks, pressure]
    }

    /// The position of a point.
    pub fn position(&self, point: BeamPoint) -> f64 {
        self.mesh.cells[point.cell].global(point.s)
    }

    /// Returns the value of μψ' at a point, with the stiffness μ of the shear layer. ψ is the deflection minus the
    /// initial gap and the free-field settlement.
    pub fn flux(&self, point: BeamPoint) -> R {
        let cell = &self.mesh.cells[point.cell];
        let [_, per_s] = with_slope(self.cell(point.cell), point.s);
        let slope = per_s * 2.0 / cell.length() - cell.gap_slope;
        cell.ground_at(point.s)[1] * (slope - cell.free_field_at(point.s)[1])
    }

    /// Returns the point force of the ground at the left node of cell i, which is [`Self::flux`] on the left minus
    /// [`Self::flux`] on the right. It is positive where a corner of the beam is pressed into the ground.
    pub fn corner(&self, i: usize) -> R {
        let [a, b] = [&self.mesh.cells[i - 1], &self.mesh.cells[i]];
        let ([_, before], [after, _]) = (a.shear_layer_ends(), b.shear_layer_ends());
        if self.mesh.nodes[i].hinge.is_some() || self.mesh.nodes[i].kinked {
            let [left, right] = [BeamPoint { cell: i - 1, s: 1.0 }, BeamPoint { cell: i, s: -1.0 }];
            return self.flux(left) - self.flux(right);
        }
        if before == after && a.gap_slope == b.gap_slope {
            return -b.ground_force;
        }
        let slope = with_slope(self.cell(i), -1.0)[1] * 2.0 / b.length();
        (before - after) * slope - (before * a.gap_slope - after * b.gap_slope) - b.ground_force
    }

    /// Coefficients of the contact pressure in cell i, for contact along the whole cell.
    pub fn pressure(&self, i: usize) -> Coefficients<R> {
        let cell = &self.mesh.cells[i];
        pressure_of(cell, 0.5 * cell.length(), &self.obstacle(i))
    }
}

impl Deflection<'_> {
    /// Whether a zone is a single point that a rigid support holds at the surface of the ground. The ground reaction of
    /// this point is only a rounding error.
    pub fn is_held(&self, zone: &MeshZone) -> bool {
        let BeamPoint { cell, s } = zone.from;
        zone.from == zone.to && s.abs() == 1.0 && self.held_zeros(cell)[usize::from(s > 0.0)] > 0
    }

    /// Returns the order of the zero of ψ ([`Self::obstacle`]) that a rigid support causes at each end of a cell. The
    /// order is 2 if ψ' is also zero up to rounding error, and 0 without a zero.
    pub fn held_zeros(&self, cell: usize) -> [usize; 2] {
        let coefficients = self.cell(cell);
        let is_rounding = |value: f64, size: f64| value.abs() <= SUM_ROUNDING * size;
        [-1.0, 1.0].map(|s| {
            let node = &self.mesh.nodes[cell + usize::from(s > 0.0)];
            if !(node.pinned || node.clamped) {
                return 0;
            }
            let size: f64 = coefficients.iter().map(|c| c.abs()).sum();
            if !is_rounding(self.obstacle_at(BeamPoint { cell, s }), size) {
                return 0;
            }
            let slopes = coefficients.iter().zip(0_u8..).map(|(c, j)| f64::from(j) * c.abs());
            let [_, slope] = with_slope(&self.obstacle(cell), s);
            1 + usize::from(node.clamped && is_rounding(slope, slopes.sum()))
        })
    }
}

/// Computes the coefficients of the pressure kψ − (μψ')' under a ground settlement ψ, from the coefficients of ψ on a
/// stretch of half length `half`.
pub(crate) fn pressure_of<R: Real>(cell: &Cell<R>, half: f64, obstacle: &[R]) -> Coefficients<R> {
    if cell.ground_varies() {
        return varying::pressure(cell, half, obstacle);
    }
    let factor = cell.shear_layer / (half * half);
    let mut pressure = Coefficients::zeros(obstacle.len());
    for (j, (pressure, c)) in pressure.iter_mut().zip(obstacle).enumerate() {
        *pressure = cell.subgrade * *c;
        if let Some(c) = obstacle.get(j + 2) {
            *pressure -= factor * ((j + 2) * (j + 1)) as f64 * *c;
        }
    }
    pressure
}

/// Computes the coefficients of the contact pressure, including the effects of the initial gap and of the loads on the
/// ground, from those of the deflection on a stretch of half length `half`.
pub(crate) fn pressure_under<R: Real>(
    cell: &Cell<R>,
    half: f64,
    deflection: &Coefficients<R>,
) -> Coefficients<R> {
    let mut obstacle = *deflection;
    obstacle[0] -= (cell.gap[0] + cell.gap[1]) * 0.5;
    obstacle[1] -= cell.gap_slope * half;
    let mut pressure = pressure_of(cell, half, &obstacle);
    let [left, right] = cell.ground_load;
    pressure[0] -= (left + right) * 0.5;
    pressure[1] -= (right - left) * 0.5;
    pressure
}
