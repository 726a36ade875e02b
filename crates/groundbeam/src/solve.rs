//! The road from a model to a certified answer, on one page.

use crate::contact::state::{Found, Stalled};
use crate::contact::stopping::Proof;
use crate::contact::stretches::Stretch;
use crate::contact::uzawa::{self, Relaxation};
use crate::contact::{balanced, exact, nested};
use crate::equilibrium::buckling::convexity;
use crate::equilibrium::local;
use crate::equilibrium::local::Checked;
use crate::equilibrium::one_way;
use crate::equilibrium::size;
use crate::error::{Error, NotConverged, Stopped};
use crate::existence::existence::{Existence, Verdict, existence};
use crate::mesh::mesh::Mesh;
use crate::model::{Load, Model, Part, Problem};
use crate::numeric::tolerance::GAP;
use crate::options::Pressure;
use crate::options::{Method, Options, Start};
use crate::outcome::Outcome;
use crate::solution::assemble::{self, assemble};
use crate::solution::solution::Solution;
use std::borrow::Cow;

/// Solves the unilateral contact problem (2.3), (2.10)–(2.13) exactly.
///
/// # Errors
///
/// [`Error::Invalid`] for a model that breaks a rule, [`Error::TooLarge`] for one that needs more memory than
/// [`Options::memory_limit`] and [`Error::NotConverged`] if no certified answer was reached.
pub fn solve(model: &Model) -> Result<Outcome, Error> {
    solve_with(model, &Options::default())
}

/// Solves with a chosen method.
///
/// # Errors
///
/// As [`solve`]; and [`Error::Unsupported`] for the paper's pressures (5.5) on ground without a shear layer,
/// and for its iteration on a beam with hinges; where the equilibrium is a local one and for a beam that shears, for any method but
/// [`Method::Exact`].
pub fn solve_with(model: &Model, options: &Options) -> Result<Outcome, Error> {
    solve_near(model, options, None)
}

/// Solves a model of which a near one's solution is known: a load was moved or grew, the ground changed. The exact
/// method begins at the contact found for that one, and takes fewer steps. The same is proven of the answer, whose last
/// digits may be others.
///
/// # Errors
///
/// As [`solve_with`].
pub fn solve_near(
    model: &Model,
    options: &Options,
    near: Option<&Solution>,
) -> Result<Outcome, Error> {
    let mut kept = None;
    let likely = near.map(Solution::contact_positions);
    let existence = solve_in(model, options, likely.as_deref(), &mut kept)?;
    Ok(match kept {
        Some(solution) => Outcome::Equilibrium(solution),
        None => Outcome::NoEquilibrium(existence),
    })
}

/// Solves in the memory of a solution that is no longer needed; the exact method from the contact that is
/// likely. What is kept is nothing if no equilibrium exists, and no solution if there is an error.
pub(crate) fn solve_in(
    model: &Model,
    options: &Options,
    likely: Option<&[Stretch]>,
    kept: &mut Option<Box<Solution>>,
) -> Result<Existence, Error> {
    let Checked { existence, stability, local } = check(model, options)?;
    if !existence.verdict.stands() {
        *kept = None;
        return Ok(existence);
    }
    if local.is_none() {
        size::check(model, options)?;
    }
    if local.is_none() && model.has_one_way_supports() {
        let solve = |model: &Model, kept: &mut _| solve_in(model, options, None, kept);
        let steps = one_way::solve(model, existence, stability, kept, solve)?;
        if let Some(solution) = kept {
            certified(solution, options)?;
            return Ok(existence);
        }
        let (method, why) = (options.method, NotConverged::Supports);
        return Err(Error::NotConverged(Stopped { method, iterations: steps, why }));
    }
    if local.is_some() && options.method != Method::Exact {
        return Err(Error::Unsupported(Problem::local_by_another_method()));
    }
    // What holds a local equilibrium is known.
    let held = local.as_ref().map_or(Cow::Borrowed(model), |state| state.held(model));
    let mut assembled = |found: &Found| {
        let memory = kept.take();
        let solution = assemble(&held, options.method, existence, stability, found, memory);
        let certificate = kept.insert(solution).certificate();
        Proof { gap: certificate.relative_gap, violation: certificate.violation() }
    };
    let found = match &local {
        Some(state) => exact::from_stable(&held, &state.contact, &mut assembled)
            .map_err(|stalled| not_converged(options.method, stalled))?,
        None => find(model, options, existence, likely, &mut assembled)?,
    };
    // The exact method has had its answer judged.
    if options.method != Method::Exact {
        assembled(&found);
    }
    if let Some(solution) = kept {
        solution.history = found.history;
        if let Some(state) = local
            && model.has_one_way_supports()
        {
            assemble::on_one_way_supports(solution, model, &state.acts, existence, stability);
        }
        certified(solution, options)?;
    }
    Ok(existence)
}

/// Tells whether an equilibrium exists, without solving but where compression makes it a local one.
///
/// # Errors
///
/// As [`solve`], but [`Error::NotConverged`] only for compression that the ground must help to bear.
pub fn exists(model: &Model) -> Result<Existence, Error> {
    Ok(check(model, &Options::default())?.existence)
}

/// Refuses a model that is wrong, and tells what its equilibrium is like.
pub(crate) fn check(model: &Model, options: &Options) -> Result<Checked, Error> {
    let problems = model.problems();
    if !problems.is_empty() {
        return Err(Error::Invalid(problems));
    }
    match convexity(model) {
        Some(stability) => Ok(Checked { existence: existence(model), stability, local: None }),
        None => {
            let exact = Options { memory_limit: options.memory_limit, ..Options::default() };
            size::check(model, &exact)?;
            local::check(model, |model| solve_with(model, &exact))
        }
    }
}

fn find(
    model: &Model,
    options: &Options,
    existence: Existence,
    likely: Option<&[Stretch]>,
    judge: impl FnMut(&Found) -> Proof,
) -> Result<Found, Error> {
    let method = options.method;
    let nodal =
        options.pressure == Pressure::Dirac || matches!(method, Method::Psor | Method::Uzawa);
    if method != Method::Exact
        && nodal
        && let Some(part) = without_shear_layer(model)
    {
        return Err(Error::Unsupported(Problem::nodal_forces_on_springs(part)));
    }
    if method != Method::Exact && model.beam.shears() {
        return Err(Error::Unsupported(Problem::shear_by_another_method(&model.beam)));
    }
    let elements = options.elements.max(1);
    let stalled = |stalled: Stalled| not_converged(method, stalled);
    if method != Method::Exact
        && let Some(load) = model.loads.iter().position(Load::is_on_ground)
    {
        return Err(Error::Unsupported(Problem::only_exactly(load)));
    }
    match method {
        Method::Exact => match existence.verdict {
            Verdict::NotUnique(motion) if stands_on_an_end(model, existence) => {
                let over_left = motion.left == 0.0;
                balanced::solve_over_an_end(model, existence.resultant(), over_left, judge)
            }
            _ => exact::solve(model, likely, judge),
        }
        .map_err(stalled),
        Method::ActiveSet => {
            let mesh = Mesh::uniform(model, elements);
            nested::solve_on(model, mesh, options.pressure).map_err(stalled)
        }
        Method::Psor | Method::Uzawa if !model.hinges.is_empty() => {
            Err(Error::Unsupported(Problem::iteration_with_hinges()))
        }
        Method::Psor | Method::Uzawa => {
            let relaxation = match method {
                Method::Psor => Relaxation::Diagonal,
                _ => Relaxation::Uniform,
            };
            let from_bilateral = options.start == Start::Bilateral;
            let mesh = Mesh::uniform(model, elements);
            uzawa::solve(mesh, relaxation, from_bilateral, options.most_sweeps).map_err(stalled)
        }
    }
}

fn not_converged(method: Method, stalled: Stalled) -> Error {
    let Stalled { iterations, why } = stalled;
    Error::NotConverged(Stopped { method, iterations, why })
}

/// Whether a free beam's resultant is exactly over one end and pushes down.
fn stands_on_an_end(model: &Model, existence: Existence) -> bool {
    let free = model.supports.is_empty() && model.beam.axial_force == 0.0;
    let one_piece = model.hinges.iter().all(|hinge| !hinge.is_free());
    free && one_piece && existence.resultant() > 0.0
}

/// The part of the model that gives ground without a shear layer under the beam.
pub(crate) fn without_shear_layer(model: &Model) -> Option<Part> {
    let ground = &model.foundation;
    let mesh = Mesh::build(model, &[], |_| 1);
    let cell = mesh.cells.iter().find(|cell| cell.shear == 0.0)?;
    let middle = 0.5 * (cell.x[0] + cell.x[1]);
    let segment = ground.segments.iter().position(|s| s.from <= middle && middle < s.to);
    Some(segment.map_or(Part::Foundation, Part::FoundationSegment))
}

/// A solution leaves the library only with a certificate that holds.
fn certified(solution: &Solution, options: &Options) -> Result<(), Error> {
    let certificate = solution.certificate();
    let not = |why| {
        let iterations = solution.iterations();
        Err(Error::NotConverged(Stopped { method: options.method, iterations, why }))
    };
    if !certificate.holds() {
        return not(NotConverged::Certificate(certificate.violation()));
    }
    if options.method == Method::Exact && certificate.relative_gap > GAP {
        return not(NotConverged::Gap(certificate.relative_gap));
    }
    Ok(())
}
