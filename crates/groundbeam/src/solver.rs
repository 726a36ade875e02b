//! Solver for a series of models, which share one workspace.

use crate::error::Error;
use crate::existence::verdict::Existence;
use crate::model::Model;
use crate::options::Options;
use crate::outcome::Outcome;
use crate::solution::candidate::{Candidate, Workspace};
use crate::solution::solution::Solution;
use crate::solve::solve_in;

/// Solves a series of models in the same memory, by default with the exact method.
///
/// ```
/// use groundbeam::{Answer, Beam, Foundation, Load, Model, Solver};
///
/// // A wheel that rolls along a beam: how deep the beam sinks at most, and where.
/// let beam = Model::new(Beam::uniform(6.0, 1.0), Foundation::pasternak(1.0, 0.2));
/// let mut solver = Solver::new();
/// let mut deepest = (0.0, 0.0);
/// for i in 0..=40 {
///     let at = 1.0 + 0.1 * f64::from(i);
///     let model = beam.clone().with_load(Load::point_force(at, 1.0));
///     if let Answer::Equilibrium(solution) = solver.solve_next(&model)? {
///         let end = solution.settlement(0.0);
///         if end > deepest.1 {
///             deepest = (at, end);
///         }
///     }
/// }
/// assert_eq!(deepest.0, 1.0);
/// # Ok::<(), groundbeam::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Solver {
    /// Solution of the last model; `None` if the last model has no equilibrium.
    last: Option<Box<Solution>>,
    workspace: Workspace,
    options: Options,
}

/// The outcome of a solve, borrowed from the [`Solver`].
#[derive(Debug, Clone, Copy)]
pub enum Answer<'a> {
    /// An equilibrium with its certificate.
    Equilibrium(&'a Solution),
    /// No equilibrium exists. The [`Existence`] contains the rigid-body motion or the buckling mode that proves
    /// this verdict.
    NoEquilibrium(Existence),
}

impl Solver {
    /// Creates a solver without a previous solution.
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a solver with the given options.
    pub fn with_options(options: Options) -> Self {
        Solver { options, ..Self::default() }
    }

    /// Solves a model. The solution has the same bits as that of [`solve_with`](crate::solve_with) with the same
    /// options.
    ///
    /// # Errors
    ///
    /// The errors of [`solve`](crate::solve()).
    pub fn solve(&mut self, model: &Model) -> Result<Answer<'_>, Error> {
        self.solve_from(model, false)
    }

    /// Solves a model, starting from the contact of the previous, similar model. This takes fewer steps than
    /// [`Solver::solve`], and the last digits may differ.
    ///
    /// # Errors
    ///
    /// The errors of [`solve`](crate::solve()).
    pub fn solve_next(&mut self, model: &Model) -> Result<Answer<'_>, Error> {
        self.solve_from(model, true)
    }

    /// Removes and returns the solution of the last model; `None` if the last model has no equilibrium.
    pub fn take(&mut self) -> Option<Box<Solution>> {
        self.last.take()
    }

    fn solve_from(&mut self, model: &Model, next: bool) -> Result<Answer<'_>, Error> {
        let last = self.last.take().map(|solution| solution.into_parts().0);
        let likely = last.as_ref().filter(|_| next).map(Candidate::contact_positions);
        if let Some(last) = last {
            self.workspace.recycle(last);
        }
        match solve_in(model, &self.options, likely.as_deref(), &mut self.workspace)? {
            Outcome::Equilibrium(solution) => Ok(Answer::Equilibrium(self.last.insert(solution))),
            Outcome::NoEquilibrium(existence) => Ok(Answer::NoEquilibrium(existence)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};
    use crate::solve;

    fn footing(moment: f64) -> Model {
        Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, moment))
    }

    fn bits(solution: &Solution) -> Vec<u64> {
        let ends = solution.contact().iter().flat_map(|c| [c.from, c.to]);
        let forces = solution.end_forces();
        let all = ends.chain([forces.left, forces.right, solution.certificate().gap()]);
        all.map(f64::to_bits).collect()
    }

    #[test]
    fn previous_solves_change_no_bit() {
        let mut solver = Solver::new();
        for moment in [0.49, 0.1, 0.45, 0.49, 0.3] {
            let Ok(Outcome::Equilibrium(alone)) = solve(&footing(moment)) else { panic!() };
            let Ok(Answer::Equilibrium(here)) = solver.solve(&footing(moment)) else { panic!() };
            assert_eq!(bits(&alone), bits(here));
            assert_eq!(here.model(), &footing(moment));
        }
        assert!(matches!(solver.solve(&footing(0.6)), Ok(Answer::NoEquilibrium(_))));
        assert!(solver.take().is_none());
    }

    #[test]
    fn the_next_answer_is_as_good_and_takes_fewer_steps() {
        let mut solver = Solver::new();
        let [mut anew, mut next] = [0; 2];
        // The moment first decreases until the beam is in full contact, and then increases again.
        for i in (0..40).chain((0..40).rev()) {
            let model = footing(0.49 - 0.005 * f64::from(i));
            let Ok(Outcome::Equilibrium(alone)) = solve(&model) else { panic!() };
            let Ok(Answer::Equilibrium(here)) = solver.solve_next(&model) else { panic!() };
            assert_eq!(alone.contact().len(), here.contact().len());
            for (a, b) in alone.contact().iter().zip(here.contact()) {
                assert!((a.from - b.from).abs() < 1e-12 && (a.to - b.to).abs() < 1e-12);
            }
            assert!(here.certificate().relative_gap() < 1e-22, "{:?}", here.certificate());
            anew += alone.iterations();
            next += here.iterations();
        }
        assert!(next < anew, "{next} {anew}");
    }
}
