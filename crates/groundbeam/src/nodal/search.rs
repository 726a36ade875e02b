//! Line search on the energy along a step of Newton's method.

use super::grid::Grid;
use super::hull::Hull;
use super::newton::Workspace;
use crate::nodal::newton::Line;
use crate::numeric::line_search;

/// Initial slope of the energy along a step, relative to the work of the forces, below which the slope counts as
/// rounding error.
const ROUNDING_SLOPE: f64 = 1e-28;

impl Workspace {
    /// Shortens the last step by a line search on the energy. Returns the step fraction; `None` if the energy does not
    /// decrease.
    pub(crate) fn shorten(&mut self, grid: &Grid) -> Option<f64> {
        let Line { deflection: w0, force: f0, trial, arcs, zones } = &mut self.before;
        let (w1, f1) = (&self.deflection, &self.force);
        trial.resize(w1.len(), 0.0);
        // The slope of the energy is Σ (p − f) δ, with the step δ, the ground forces p at the trial deflection, and the
        // ground forces f with which the beam is in equilibrium.
        let mut slope = |t: f64| {
            for ((w, w0), w1) in trial.iter_mut().zip(&*w0).zip(w1) {
                *w = w0 + t * (w1 - w0);
            }
            let hull = Hull { grid, deflection: trial, near: &self.zones };
            hull.zones(arcs, zones);
            let mut sum = 0.0;
            for i in 0..w1.len() {
                sum -= (f0[i] + t * (f1[i] - f0[i])) * (w1[i] - w0[i]);
            }
            hull.forces(zones, |i, p| sum += p * (w1[i] - w0[i]));
            sum
        };
        let fall = -slope(0.0);
        let work: f64 = f1.iter().zip(w1).map(|(f, w)| (f * w).abs()).sum();
        if fall.is_nan() || fall <= ROUNDING_SLOPE * work {
            return None;
        }
        let slope = std::cell::RefCell::new(slope);
        let t = line_search::settle(fall, |t| (slope.borrow_mut())(t));
        if t != 1.0 {
            let Line { deflection: w0, force: f0, .. } = &self.before;
            for (now, before) in [(&mut self.deflection, w0), (&mut self.force, f0)] {
                for (now, before) in now.iter_mut().zip(before) {
                    *now = before + t * (*now - before);
                }
            }
            let hull = Hull { grid, deflection: &self.deflection, near: &self.zones };
            hull.zones(&mut self.arcs, &mut self.next);
        }
        Some(t)
    }
}
