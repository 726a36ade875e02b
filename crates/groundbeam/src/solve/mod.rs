//! Solves a model: checks the rules, decides on existence, finds the contact zones and certifies the solution.

mod contact;
mod judged;

use crate::contact::exact;
use crate::contact::intervals::Interval;
use crate::equilibrium::branch::PathPoint;
use crate::equilibrium::buckling::convexity;
use crate::equilibrium::local;
use crate::equilibrium::local::Assessment;
use crate::equilibrium::one_way;
use crate::equilibrium::size;
use crate::equilibrium::soil;
use crate::error::{Error, NotConverged, Stopped};
use crate::existence::existence;
use crate::existence::verdict::Existence;
use crate::model::Model;
use crate::numeric::tolerance::GAP;
use crate::options::{Method, Options};
use crate::outcome::Outcome;
use crate::solution::candidate::Workspace;
use crate::solution::certificate::Certificate;
use crate::solution::solution::Solution;
use crate::solve::contact::{find, not_converged};
use crate::solve::judged::Judged;
use crate::supported::{self, Way};

/// Solves the unilateral contact problem, (2.3) and (2.10)–(2.13) of Kikuchi's paper, by the exact method.
///
/// # Errors
///
/// [`Error::Invalid`] for a model that breaks a rule, [`Error::TooLarge`] for one that needs more memory than
/// [`Options::memory_limit`], and [`Error::NotConverged`] if no solution could be certified.
pub fn solve(model: &Model) -> Result<Outcome, Error> {
    solve_with(model, &Options::default())
}

/// Solves a model by the method and the options.
///
/// # Errors
///
/// The errors of [`solve`], and [`Error::Unsupported`] for a feature that the method does not
/// [support](crate::supported).
pub fn solve_with(model: &Model, options: &Options) -> Result<Outcome, Error> {
    solve_near(model, options, None)
}

/// Solves a model. The exact method starts from the contact zones of `near`, the solution of a similar model, and needs
/// fewer steps. The last digits may differ from those of [`solve_with`].
///
/// # Errors
///
/// The errors of [`solve_with`].
pub fn solve_near(
    model: &Model,
    options: &Options,
    near: Option<&Solution>,
) -> Result<Outcome, Error> {
    let likely = near.map(|solution| solution.candidate().contact_positions());
    solve_in(model, options, likely.as_deref(), &mut Workspace::default())
}

/// Solves a model in the memory of a workspace. The exact method starts from the contact zones `likely`, if
/// given.
pub(crate) fn solve_in(
    model: &Model,
    options: &Options,
    likely: Option<&[Interval]>,
    workspace: &mut Workspace,
) -> Result<Outcome, Error> {
    let outcome = match &model.foundation.soil {
        None => uncancelled(model, options, likely, workspace),
        Some(soil) => {
            refuse_invalid(model)?;
            let on_given = |model: &Model| solve_in(model, options, likely, workspace);
            soil::solve(soil, model, options.method, on_given)
        }
    };
    // The result of a cancelled solve may come from unfinished steps, so it is discarded.
    if options.cancel.is_cancelled() { Err(Error::Cancelled) } else { outcome }
}

/// Maximum number of times that a method with a mesh halves the length of its elements.
const MOST_HALVINGS: usize = 12;

/// Solves a model by the chosen method. A method with a mesh halves its elements under the conditions of *How accurate a
/// mesh is* in docs/methods.md.
fn uncancelled(
    model: &Model,
    options: &Options,
    likely: Option<&[Interval]>,
    workspace: &mut Workspace,
) -> Result<Outcome, Error> {
    let mut outcome = solve_once(model, options, likely, workspace);
    if options.method == Method::Exact {
        return outcome;
    }
    let mut options = options.clone();
    // Number of sweeps times elements that remains for `psor` and `uzawa`.
    let mut work = options.most_sweeps.saturating_mul(options.elements);
    for _ in 0..MOST_HALVINGS {
        let (is_coarse, sweeps) = match &outcome {
            Ok(Outcome::Equilibrium(solution)) => {
                let mut pieces = solution.candidate().pieces.iter();
                let is_coarse = pieces.any(|piece| piece.cell.shear_layer == 0.0)
                    && solution.certificate().relative_gap() > 1.0;
                (is_coarse, solution.iterations())
            }
            Err(Error::NotConverged(stopped)) => {
                let by_supports = stopped.why == NotConverged::Supports;
                let is_coarse = matches!(stopped.why, NotConverged::Gap(_))
                    || by_supports && options.method == Method::ActiveSet;
                (is_coarse, stopped.iterations)
            }
            _ => break,
        };
        if !is_coarse {
            break;
        }
        work = work.saturating_sub(sweeps.saturating_mul(options.elements));
        options.elements = options.elements.max(1).saturating_mul(2);
        options.most_sweeps = work / options.elements;
        // If the solve with smaller elements fails, the solution on the coarse mesh remains the result.
        let finer = solve_once(model, &options, likely, workspace);
        if finer.is_err() && outcome.is_ok() {
            break;
        }
        outcome = finer;
    }
    outcome
}

/// Solves a model by one method on one mesh.
fn solve_once(
    model: &Model,
    options: &Options,
    likely: Option<&[Interval]>,
    workspace: &mut Workspace,
) -> Result<Outcome, Error> {
    let checked = check(model, options)?;
    if !checked.existence.verdict.stands() {
        return Ok(Outcome::NoEquilibrium(checked.existence));
    }
    let solution = if let Some(state) = &checked.local {
        solve_local(model, options, &checked, state, workspace)?
    } else {
        size::check(model, options)?;
        if model.has_one_way_supports() {
            solve_one_way(model, options, &checked, workspace)?
        } else {
            solve_convex(model, options, &checked, likely, workspace)?
        }
    };
    certified(&solution, options)?;
    Ok(Outcome::Equilibrium(Box::new(solution)))
}

/// Computes the equilibrium of a model with convex energy and two-way supports.
fn solve_convex(
    model: &Model,
    options: &Options,
    checked: &Assessment,
    likely: Option<&[Interval]>,
    workspace: &mut Workspace,
) -> Result<Solution, Error> {
    let Assessment { existence, stability, .. } = *checked;
    let mut judged = Judged::new(model, stability, workspace);
    let found = find(model, options, existence, likely, |found| judged.judge(found))?;
    let (candidate, certificate) = judged.last(&found);
    Ok(Solution::new(candidate, certificate, existence, options.method, found.history))
}

/// Computes the equilibrium of a model with convex energy and one-way supports.
fn solve_one_way(
    model: &Model,
    options: &Options,
    checked: &Assessment,
    workspace: &mut Workspace,
) -> Result<Solution, Error> {
    let solve = |model: &Model| solve_once(model, options, None, workspace);
    let ended = one_way::solve(model, solve)?;
    let Some((solution, acts)) = ended.found else {
        let (method, iterations) = (options.method, ended.solves);
        return Err(Error::NotConverged(Stopped {
            method,
            iterations,
            why: NotConverged::Supports,
        }));
    };
    let (candidate, history) = solution.into_parts();
    let candidate = candidate.on_one_way_supports(model, &acts);
    let certificate = Certificate::of(&candidate, checked.stability);
    Ok(Solution::new(candidate, certificate, checked.existence, options.method, history))
}

/// Computes the local equilibrium to full accuracy. The initial guess `state` was found by following the path of
/// equilibria under increasing compression.
fn solve_local(
    model: &Model,
    options: &Options,
    checked: &Assessment,
    state: &PathPoint,
    workspace: &mut Workspace,
) -> Result<Solution, Error> {
    let Assessment { existence, stability, .. } = *checked;
    let method = options.method;
    supported::check(model, Way::of(options), true)?;
    // The path of equilibria has determined which one-way supports are active. Inactive supports are removed.
    let held = state.on_active_supports(model);
    let mut judged = Judged::new(&held, stability, workspace);
    let found =
        exact::from_stable(&held, &state.contact, &options.cancel, |found| judged.judge(found))
            .map_err(|stalled| not_converged(method, stalled))?;
    let (mut candidate, mut certificate) = judged.last(&found);
    if model.has_one_way_supports() {
        candidate = candidate.on_one_way_supports(model, &state.active);
        certificate = Certificate::of(&candidate, stability);
    }
    Ok(Solution::new(candidate, certificate, existence, method, found.history))
}

/// Decides whether an equilibrium exists. It solves the model only if axial compression makes the energy non-convex.
///
/// # Errors
///
/// The errors of [`solve`]. [`Error::NotConverged`] occurs only for a beam that is unstable under compression without
/// the ground.
pub fn exists(model: &Model) -> Result<Existence, Error> {
    Ok(check(model, &Options::default())?.existence)
}

/// Returns an error for an invalid model, otherwise the results of the checks before the solve: whether an
/// equilibrium exists, and how stable it is.
pub(crate) fn check(model: &Model, options: &Options) -> Result<Assessment, Error> {
    refuse_invalid(model)?;
    let model = &*model.on_given_ground();
    match convexity(model, &options.cancel) {
        Some(stability) => {
            Ok(Assessment { existence: existence::existence(model), stability, local: None })
        }
        None => {
            let exact = Options {
                memory_limit: options.memory_limit,
                cancel: options.cancel.clone(),
                ..Options::default()
            };
            size::check(model, &exact)?;
            local::check(model, &options.cancel, |model| solve_with(model, &exact))
        }
    }
}

/// Refuses a model that breaks a rule.
pub(crate) fn refuse_invalid(model: &Model) -> Result<(), Error> {
    let problems = model.problems();
    if problems.is_empty() { Ok(()) } else { Err(Error::Invalid(problems)) }
}

/// Refuses a solution whose certificate does not hold.
fn certified(solution: &Solution, options: &Options) -> Result<(), Error> {
    let certificate = solution.certificate();
    let not = |why| {
        let iterations = solution.iterations();
        Err(Error::NotConverged(Stopped { method: options.method, iterations, why }))
    };
    let gap = certificate.relative_gap();
    // The energy gap of a method with a mesh depends on the mesh, so the gap is limited only for the exact method.
    let limit = if options.method == Method::Exact { GAP } else { f64::MAX };
    if gap <= limit {
        Ok(())
    } else if certificate.is_rounding_of_loads(solution.model()) {
        not(NotConverged::CancellingLoads(gap))
    } else {
        not(NotConverged::Gap(gap))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cancel::Cancel;
    use crate::contact::nodes;
    use crate::contact::uzawa::{self, Relaxation};
    use crate::equilibrium::branch;
    use crate::equilibrium::buckling::bonded_buckling_load;
    use crate::model::{Acts, Beam, Foundation, Load, Support};
    use crate::nodal::grid::{Grid, Ground};
    use crate::solution::field::Field;
    use crate::{Solver, load_factors::load_factors_with, nodal};

    /// A long beam with lift-off between its loads.
    fn long() -> Model {
        Model::new(Beam::uniform(60.0, 1.0), Foundation::pasternak(1.0, 0.1))
            .with_load(Load::point_force(10.0, 1.0))
            .with_load(Load::point_force(45.0, 2.0))
    }

    fn on_one_way_supports() -> Model {
        long().with_support(Support::pinned(30.0).acting(Acts::Up))
    }

    fn compressed() -> Model {
        let mut model = long().with_load(Load::uniform_force(0.0, 60.0, 1.0));
        model.beam.axial_force = -0.1;
        model
    }

    fn cancelled() -> Cancel {
        let cancel = Cancel::new();
        cancel.cancel();
        cancel
    }

    #[test]
    fn a_cancelled_solve_returns_no_solution() {
        for method in Method::ALL {
            let options = Options { method, cancel: cancelled(), ..Options::default() };
            assert_eq!(solve_with(&long(), &options).err(), Some(Error::Cancelled), "{method:?}");
        }
        let options = Options { cancel: cancelled(), ..Options::default() };
        for model in [long(), on_one_way_supports(), compressed()] {
            assert!(solve(&model).is_ok());
            assert_eq!(solve_with(&model, &options).err(), Some(Error::Cancelled));
            let mut solver = Solver::with_options(options.clone());
            assert_eq!(solver.solve(&model).err(), Some(Error::Cancelled));
            assert!(solver.take().is_none());
        }
        let factors = load_factors_with(&long(), &options, |load| load == 1);
        assert_eq!(factors.err(), Some(Error::Cancelled));
    }

    #[test]
    fn a_flag_that_is_not_set_changes_no_bit() {
        for model in [long(), on_one_way_supports(), compressed()] {
            let options = Options { cancel: Cancel::new(), ..Options::default() };
            let Ok(Outcome::Equilibrium(with)) = solve_with(&model, &options) else { panic!() };
            let Ok(Outcome::Equilibrium(without)) = solve(&model) else { panic!() };
            let bits = |solution: &Solution| {
                solution.certificate().figures().map(|(_, figure)| figure.to_bits())
            };
            assert_eq!(bits(&with), bits(&without));
            assert_eq!(with.history(), without.history());
        }
    }

    /// After a cancellation, each loop stops within one step, long before the end of the solve.
    #[test]
    fn every_loop_checks_the_flag() {
        let (model, never, now) = (long(), Cancel::default(), cancelled());
        let grid = Grid::new(&model, 100, Ground::Nodal);
        let sweeps = |cancel| uzawa::solve(&model, &grid, Relaxation::Diagonal, true, 3, cancel);
        assert_eq!(sweeps(&never).map_err(|stalled| stalled.iterations).err(), Some(3));
        assert_eq!(sweeps(&now).map_err(|stalled| stalled.iterations).err(), Some(0));
        let on_mesh = |cancel| nodes::solve(&model, 100, cancel);
        assert!(on_mesh(&never).is_ok());
        assert_eq!(on_mesh(&now).map_err(|stalled| stalled.iterations).err(), Some(0));
        let at_nodes = |cancel| nodal::edges::edges(&model, cancel);
        assert!(at_nodes(&never).is_some() && at_nodes(&now).is_none());
        let mut judgements = 0;
        let exactly = exact::solve(&model, None, &now, |_| {
            judgements += 1;
            0.0
        });
        assert!(exactly.is_err() && judgements == 0);
        let begin = PathPoint { compression: 0.0, contact: vec![[0.0, 60.0]], active: vec![] };
        let path = |cancel| branch::follow(&compressed(), begin.clone(), cancel);
        assert!(path(&never).wanted.is_some() && path(&now).wanted.is_none());
        assert_eq!(path(&now).last.compression, 0.0);
        let contact = [[0.0, 60.0]];
        let buckling = |cancel| bonded_buckling_load(&model, &contact, cancel);
        assert!(buckling(&never) > 0.0 && buckling(&now) == 0.0);
    }

    /// A beam clamped at both ends is lifted off the ground, so that the pressure is zero at every node.
    #[test]
    fn sweeps_converge_to_zero_pressure() {
        let model = Model::new(Beam::uniform(20.0, 1.0), Foundation::pasternak(4.0, 0.01))
            .with_support(Support::fixed(0.0))
            .with_support(Support::fixed(20.0))
            .with_load(Load::point_force(10.0, -1.0));
        for method in [Method::Psor, Method::Uzawa, Method::ActiveSet, Method::Exact] {
            let options = Options { method, ..Options::default() };
            let solution = solve_with(&model, &options);
            let Ok(Outcome::Equilibrium(solution)) = solution else {
                panic!("{method:?}: {solution:?}")
            };
            assert_eq!(solution.range(Field::Pressure).max.value, 0.0, "{method:?}");
        }
    }

    #[test]
    fn another_thread_stops_a_solve() {
        let cancel = Cancel::new();
        let (method, cancel_too) = (Method::Uzawa, cancel.clone());
        let (elements, most_sweeps) = (3000, usize::MAX);
        let options =
            Options { method, elements, most_sweeps, cancel: cancel_too, ..Options::default() };
        let solve = std::thread::spawn(move || solve_with(&long(), &options));
        std::thread::sleep(std::time::Duration::from_millis(50));
        assert!(!solve.is_finished(), "the solve takes minutes");
        cancel.cancel();
        assert_eq!(solve.join().expect("no panic").err(), Some(Error::Cancelled));
    }
}
