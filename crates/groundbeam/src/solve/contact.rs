//! Finds the contact set of a convex problem by the chosen method, from the model and its verdict on existence.

use crate::cancel::Cancel;
use crate::contact::edges::Judge;
use crate::contact::intervals::Interval;
use crate::contact::state::{ContactState, Unconverged};
use crate::contact::uzawa::{self, Relaxation};
use crate::contact::{exact, nodes, point_contact, unloaded_ends};
use crate::equilibrium::size;
use crate::error::{Error, Stopped};
use crate::existence::existence;
use crate::existence::verdict::{Existence, Verdict};
use crate::model::Model;
use crate::nodal::grid::{Grid, Ground};
use crate::options::{Method, Options, Start};
use crate::supported::{self, Way};

/// Finds the deflection and the contact set by the chosen method. `judge` computes the relative energy gap of a
/// trial contact.
pub(super) fn find(
    model: &Model,
    options: &Options,
    existence: Existence,
    likely: Option<&[Interval]>,
    mut judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Error> {
    let Options { method, cancel, .. } = options;
    let method = *method;
    supported::check(model, Way::of(options), false)?;
    let elements = options.elements.max(1);
    let stalled = |stalled: Unconverged| not_converged(method, stalled);
    match method {
        Method::Exact => {
            find_exactly(model, existence, likely, cancel, &mut judge).map_err(stalled)
        }
        Method::ActiveSet => {
            let solved = nodes::solve(model, elements, cancel).map_err(stalled)?;
            size::check_cells(solved.cells(), options)?;
            Ok(solved.state())
        }
        Method::Psor | Method::Uzawa => {
            let relaxation = match method {
                Method::Psor => Relaxation::Diagonal,
                _ => Relaxation::Uniform,
            };
            let from_bilateral = options.start == Start::Bilateral;
            let grid = Grid::new(model, elements, Ground::Nodal);
            uzawa::solve(model, &grid, relaxation, from_bilateral, options.most_sweeps, cancel)
                .map_err(stalled)
        }
    }
}

/// Finds the deflection and the contact set by the exact method. If the beam can rotate without resistance, the
/// result is one of several equilibria.
fn find_exactly(
    model: &Model,
    existence: Existence,
    likely: Option<&[Interval]>,
    cancel: &Cancel,
    judge: Judge,
) -> Result<ContactState, Unconverged> {
    let Verdict::NotUnique(motion) = existence.verdict else {
        return exact::solve(model, likely, cancel, judge);
    };
    if let Some(stretch) = unloaded_ends::loaded_stretch(model) {
        let solve = |part: &Model| {
            find_exactly(part, existence::existence(part), None, cancel, &mut |_| 0.0)
        };
        return unloaded_ends::solve_stretch(model, stretch, cancel, solve, judge);
    }
    if stands_on_an_end(model, existence) {
        let over_left = motion.left == 0.0;
        let resultant = existence.resultant();
        return point_contact::solve_over_an_end(model, resultant, over_left, cancel, judge);
    }
    exact::solve(model, likely, cancel, judge)
}

/// Returns the [`Error`] which reports that a method stopped without converging.
pub(super) fn not_converged(method: Method, stalled: Unconverged) -> Error {
    let Unconverged { iterations, why } = stalled;
    Error::NotConverged(Stopped { method, iterations, why })
}

/// Whether a beam whose equilibrium is not unique stands on one of its ends. The resultant of the loads then acts
/// downward exactly at this end.
fn stands_on_an_end(model: &Model, existence: Existence) -> bool {
    let free = model.supports.is_empty() && model.beam.axial_force == 0.0;
    let one_piece = model.hinges.iter().all(|hinge| !hinge.is_free());
    free && one_piece && existence.resultant() > 0.0
}
