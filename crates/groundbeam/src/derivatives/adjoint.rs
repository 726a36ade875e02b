//! Computes the adjoint displacements of outputs from the derivatives of each output with respect to the unknowns.

use super::equilibrium::{Equilibrium, Loads, Span};
use super::linear::Linear;
use super::output::{Follows, Read, Reading};
use crate::contact::short_span::MOST_CELLS;
use crate::mesh::deflection::BeamPoint;
use crate::numeric::dual::Dual;
use std::collections::BTreeSet;

impl Equilibrium<'_> {
    /// Returns the elements whose unknowns occur in the formula of an output.
    fn reads(&self, of: &Read) -> BTreeSet<usize> {
        let (frame, mut read) = (self.frame, BTreeSet::new());
        let cells = &frame.mesh.cells;
        let mut add = |x: f64| {
            let cell = frame.mesh.cell_at(x);
            read.extend([cell - usize::from(cell > 0 && x <= cells[cell].x[0]), cell]);
        };
        let end_of = |zone, side| frame.position(frame.end_of(zone, side));
        match *of {
            Read::Constant | Read::Energy => return read,
            Read::Field { x, follows, .. } => {
                add(x);
                if let Follows::Edge { zone, side, .. } = follows {
                    add(end_of(zone, side));
                }
            }
            Read::Beside { x } => add(x.clamp(0.0, frame.model.beam.length)),
            Read::Edge { zone, side } | Read::EdgeForce { zone, side } => add(end_of(zone, side)),
            Read::Support { number, .. } => add(frame.model.supports[number].at),
        }
        // Open ground depends on the deflection at the adjacent edges. In a short span, the edge forces depend on it
        // between the edges too.
        for Span { ends, .. } in &self.spans {
            let at = |end: BeamPoint| cells[end.cell].global(end.s);
            let from = ends[0].map_or(f64::NEG_INFINITY, at);
            let to = ends[1].map_or(f64::INFINITY, at);
            if !read.iter().any(|i| cells[*i].x[0] <= to && cells[*i].x[1] >= from) {
                continue;
            }
            for end in ends.iter().flatten() {
                read.extend(end.cell.saturating_sub(1)..(end.cell + 2).min(cells.len()));
            }
            if let [Some(from), Some(to)] = ends
                && to.cell <= from.cell + MOST_CELLS
            {
                read.extend(from.cell..=to.cell);
            }
        }
        read
    }

    /// Returns the elements whose unknowns occur in the formula of at least one output.
    pub fn read_by(&self, readings: &[Reading]) -> BTreeSet<usize> {
        readings.iter().flat_map(|reading| self.reads(&reading.of)).collect()
    }

    /// Computes the adjoint displacements, for which the loads are the derivatives of an output with respect to the
    /// unknowns.
    pub fn adjoints(&self, readings: &[Reading]) -> Option<Vec<Vec<[f64; 4]>>> {
        let mut linear = Linear::<4>::new(self);
        linear.vary(Vec::new());
        let reads: Vec<BTreeSet<usize>> = readings.iter().map(|own| self.reads(&own.of)).collect();
        let mut loads: Vec<Loads<f64>> = vec![Vec::new(); readings.len()];
        for cell in self.read_by(readings) {
            linear.shapes[cell].iter_mut().enumerate().for_each(|(j, v)| v.by[j] = 1.0);
            linear.refresh([cell].into_iter());
            for ((load, read), reading) in loads.iter_mut().zip(&reads).zip(readings) {
                if read.contains(&cell) {
                    load.push((cell, linear.read(reading)));
                }
            }
            linear.shapes[cell] = self.shapes[cell].map(Dual::from);
            linear.unfold(cell);
        }
        self.displaced(loads.into_iter())
    }
}
