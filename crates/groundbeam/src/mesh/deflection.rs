//! A deflection as a polynomial in each cell; points and zones of a mesh; ψ = w − g₀ − u₀ and the pressure at
//! a point.

use crate::mesh::cell::Cell;
use crate::mesh::cell::{gap_at, initial, initial_gap_at};
use crate::mesh::mesh::Mesh;
use crate::mesh::varying;
use crate::numeric::polynomial::{Coefficients, TERMS, jet, value, with_slope};
use crate::numeric::real::Real;
use crate::numeric::tolerance::SUM_ROUNDING;

/// A point of the beam: a cell and its coordinate s ∈ \[−1, 1\].
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct BeamPoint {
    pub cell: usize,
    pub s: f64,
}

/// A contact zone from one point to another; equal points are a point contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeshZone {
    pub from: BeamPoint,
    pub to: BeamPoint,
}

/// w on a mesh, as polynomials of [`TERMS`] coefficients in each cell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Deflection<'a, R = f64> {
    pub mesh: &'a Mesh<R>,
    pub coefficients: &'a [R],
}

impl<R: Real> Deflection<'_, R> {
    pub fn cell(&self, i: usize) -> &[R] {
        &self.coefficients[i * TERMS..(i + 1) * TERMS]
    }

    /// The coefficients of ψ in cell i.
    pub fn obstacle(&self, i: usize) -> Coefficients<R> {
        self.mesh.cells[i].obstacle(self.cell(i))
    }

    /// ψ at a point.
    pub fn obstacle_at(&self, point: BeamPoint) -> R {
        value(self.cell(point.cell), point.s) - gap_at(&self.mesh.cells[point.cell], point.s)
    }

    /// ψ, ψ' and π = kψ − (μψ')' at a point.
    pub fn obstacle_and_pressure(&self, point: BeamPoint) -> [R; 3] {
        let cell = &self.mesh.cells[point.cell];
        let [f, d1, d2, _] = jet(self.cell(point.cell), point.s);
        let [settled, sinks] = cell.free_field_at(point.s);
        // π of w − g₀ − u₀ is π of w − g₀ minus the ground load q, because −(μu₀′)′ + ku₀ = q.
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

    /// μψ' at a point.
    pub fn flux(&self, point: BeamPoint) -> R {
        let cell = &self.mesh.cells[point.cell];
        let slope = jet(self.cell(point.cell), point.s)[1] * 2.0 / cell.length() - cell.gap_slope;
        cell.ground_at(point.s)[1] * (slope - cell.free_field_at(point.s)[1])
    }

    /// −\[μψ'\] at the node to the left of cell i: positive where a corner is pressed into the ground.
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
        let slope = jet(self.cell(i), -1.0)[1] * 2.0 / b.length();
        (before - after) * slope - (before * a.gap_slope - after * b.gap_slope) - b.ground_force
    }

    /// The coefficients of π = kψ − (μψ')' in cell i.
    pub fn pressure(&self, i: usize) -> Coefficients<R> {
        let cell = &self.mesh.cells[i];
        pressure_of(cell, 0.5 * cell.length(), &self.obstacle(i))
    }
}

impl Deflection<'_> {
    /// Whether a zone is one point at which a rigid support holds the beam on the ground. The support carries
    /// the load there, so a rounding error of the ground's force must not count as contact.
    pub fn is_held(&self, zone: &MeshZone) -> bool {
        let BeamPoint { cell, s } = zone.from;
        zone.from == zone.to && s.abs() == 1.0 && self.held_zeros(cell)[usize::from(s > 0.0)] > 0
    }

    /// The order of the zero of ψ that a rigid support makes at each end of a cell: 2 at a clamp on the
    /// ground's surface (ψ = ψ' = 0 except for rounding), 1 at a pin, otherwise 0.
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

/// The coefficients of kψ − (μψ')' from those of ψ on a stretch of half length `half`.
pub(crate) fn pressure_of<R: Real>(cell: &Cell<R>, half: f64, obstacle: &[R]) -> Coefficients<R> {
    if cell.ground_varies() {
        return varying::pressure(cell, half, obstacle);
    }
    let factor = cell.shear_layer / (half * half);
    let mut pressure = Coefficients::from(obstacle);
    for c in pressure.iter_mut() {
        *c *= cell.subgrade;
    }
    for (j, (pressure, c)) in pressure.iter_mut().zip(obstacle.iter().skip(2)).enumerate() {
        *pressure -= factor * ((j + 2) * (j + 1)) as f64 * *c;
    }
    pressure
}

/// The coefficients of the pressure k(w − g₀) − (μ(w − g₀)')' − q in contact, from those of w on a stretch of
/// half length `half`.
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
