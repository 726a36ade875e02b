//! Very long beams: answers at the nodes of meshes of up to millions of elements.
//!
//! The ground presses on the nodes alone, as in the paper's (5.5), and the beam between them is solved
//! exactly, so that what is solved is the discrete problem (5.10)–(5.11) with the beam's own flexibility
//! in place of (5.2). Rows of equal elements are crossed by [sweeps](sweep) in deformation variables,
//! stretches off the ground are [one element](span) each, and the contact is found by Newton's method
//! on [coarse meshes first](newton). Memory is a few numbers a node.

mod beam;
mod check;
mod form;
mod grid;
mod hull;
mod lanes;
mod layer;
mod layout;
mod levels;
mod newton;
mod open;
mod search;
mod span;
mod sweep;

pub use check::NodalCheck;
pub use newton::Work;

use crate::existence::{Existence, Verdict};
use crate::model::{Load, Model, Problem};
use crate::size;
use crate::solve::{Error, Method, NotConverged, Options, exists};
use grid::{Grid, Ground};
use hull::Hull;
use newton::Workspace;
use sweep::Loose;

/// A beam whose ground presses at nodes alone: values at every node.
#[derive(Debug, Clone, Default)]
pub struct NodalSolution {
    /// w at every node \[m\].
    pub deflection: Vec<f64>,
    /// w' at every node \[rad\].
    pub slope: Vec<f64>,
    /// u at every node \[m\].
    pub settlement: Vec<f64>,
    /// What the ground presses at every node, up positive \[N\].
    pub force: Vec<f64>,
    /// The nodes that touch: the first and the last of each row.
    pub contact: Vec<[usize; 2]>,
    /// What was done to find it.
    pub work: Work,
    /// What holds of it at the nodes.
    pub check: NodalCheck,
    grid: Option<Grid>,
}

impl NodalSolution {
    /// The position of a node \[m\].
    pub fn position(&self, node: usize) -> f64 {
        self.grid.as_ref().map_or(0.0, |grid| grid.x(node))
    }

    /// Rows of equal elements: position of the first node, its number, elements, their length.
    pub fn rows(&self) -> Vec<(f64, usize, usize, f64)> {
        let runs = self.grid.iter().flat_map(|grid| &grid.runs);
        runs.map(|run| (run.x[0], run.first, run.count, run.h)).collect()
    }
}

/// Solves on meshes, again and again in the same memory.
#[derive(Debug, Clone, Default)]
pub struct NodalSolver {
    workspace: Workspace,
    grids: Vec<Grid>,
}

impl NodalSolver {
    /// One that has not solved anything yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Solves the contact problem on about `elements` elements, equal between any two places of the
    /// model. Nothing is written if the verdict is that there is no equilibrium; what is written beside an error
    /// is no answer.
    ///
    /// # Errors
    ///
    /// As [`solve`](crate::solve()); and [`Error::Unsupported`] for supports and hinges, for ground without a shear
    /// layer, and where stiffness or ground varies along a segment.
    pub fn solve_into(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<Existence, Error> {
        self.where_it_stands(model, elements, |solver| solver.search(model, elements, into))
    }

    /// Solves if there is an equilibrium.
    fn where_it_stands(
        &mut self,
        model: &Model,
        elements: usize,
        solve: impl FnOnce(&mut Self) -> Result<(), Error>,
    ) -> Result<Existence, Error> {
        let existence = checked(model, elements)?;
        if existence.verdict.stands() {
            solve(self)?;
        }
        Ok(existence)
    }

    /// From coarse grids to the one that is wanted.
    fn search(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<(), Error> {
        levels::grids(model, elements.max(1), Ground::Nodal, &mut self.grids);
        let (workspace, grids) = (&mut self.workspace, &self.grids);
        // Coarse grids in memory of their own: that of the answer keeps its length.
        let found = workspace.approach(grids, newton::ANSWER);
        found.map_err(|Loose| stalled(workspace.work.solves))?;
        self.finish(model, into)
    }

    /// The same from a neighbour: `into` holds the answer for a model not far from this one. On as many nodes,
    /// its contact is where the search begins, and no coarser grid is needed.
    ///
    /// # Errors
    ///
    /// As [`NodalSolver::solve_into`].
    pub fn solve_near_into(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<Existence, Error> {
        self.where_it_stands(model, elements, |solver| solver.search_near(model, elements, into))
    }

    /// From the contact of the answer that `into` holds, or else from coarse grids.
    fn search_near(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<(), Error> {
        let grid = Grid::new(model, elements.max(1), Ground::Nodal);
        if into.contact.is_empty() || into.deflection.len() != grid.last() + 1 {
            return self.search(model, elements, into);
        }
        self.grids.clear();
        self.grids.push(grid);
        self.workspace.work = Work::default();
        self.workspace.zones.clone_from(&into.contact);
        self.finish(model, into).or_else(|_| self.search(model, elements, into))
    }

    /// The answer on the last grid, from a guess at its contact.
    fn finish(&mut self, model: &Model, into: &mut NodalSolution) -> Result<(), Error> {
        let workspace = &mut self.workspace;
        let swapped = |workspace: &mut Workspace, into: &mut NodalSolution| {
            std::mem::swap(&mut workspace.deflection, &mut into.deflection);
            std::mem::swap(&mut workspace.slope, &mut into.slope);
            std::mem::swap(&mut workspace.force, &mut into.force);
        };
        let Some(grid) = self.grids.pop() else { return Err(stalled(0)) };
        swapped(workspace, into);
        if workspace.level(&grid, newton::ANSWER).is_err() {
            swapped(workspace, into);
            return Err(stalled(workspace.work.solves));
        }
        workspace.fill(&grid, true);
        workspace.clear_open(&grid);
        swapped(workspace, into);
        into.contact.clone_from(&workspace.zones);
        into.work = workspace.work;
        settle_ground(&grid, into);
        into.grid = Some(grid);
        into.check = check::check(model, into);
        if into.check.holds() { Ok(()) } else { Err(stalled(into.work.solves)) }
    }

    /// The beam bonded to the ground at every node, pulls and all: one sweep from each end. What the ground
    /// pulls is not checked, and the settlement is that of the beam.
    ///
    /// # Errors
    ///
    /// As [`NodalSolver::solve_into`].
    pub fn bonded_into(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<(), Error> {
        checked(model, elements)?;
        let grid = Grid::new(model, elements.max(1), Ground::Nodal);
        let workspace = &mut self.workspace;
        workspace.bond(&grid);
        workspace.room(&grid);
        workspace.work = Work { grids: 1, ..Work::default() };
        workspace.glue(&grid, None).map_err(|_| stalled(1))?;
        std::mem::swap(&mut workspace.deflection, &mut into.deflection);
        std::mem::swap(&mut workspace.slope, &mut into.slope);
        std::mem::swap(&mut workspace.force, &mut into.force);
        into.contact.clone_from(&workspace.zones);
        into.work = workspace.work;
        into.grid = Some(grid);
        Ok(())
    }
}

/// Where a free beam touches, to the accuracy of a mesh fine enough for its waves; none if it has supports or
/// hinges, is too long and soft for a mesh, or anything varies along a segment.
pub(crate) fn edges(model: &Model) -> Option<Vec<[f64; 2]>> {
    let held = !(model.supports.is_empty() && model.hinges.is_empty());
    if held || model.varying_part().is_some() {
        return None;
    }
    let grid = Grid::of(model, Ground::Spread);
    let waves = grid.wave_number() * model.beam.length;
    if waves.is_nan() || waves > MOST_WAVES || grid.fewest() as f64 > PER_WAVE * MOST_WAVES {
        return None;
    }
    let mut grids = Vec::new();
    levels::grids(model, (PER_WAVE * waves) as usize, Ground::Spread, &mut grids);
    let mut workspace = Workspace::default();
    workspace.contact(&grids, newton::START).ok()?;
    grids.last().map(|grid| workspace.edges(grid))
}

/// Elements per 1/wave number of a mesh whose edges are a start for the exact ones.
const PER_WAVE: f64 = 4.0;
/// The most 1/wave numbers of a beam that starts from a mesh.
const MOST_WAVES: f64 = 1e5;

fn stalled(iterations: usize) -> Error {
    Error::NotConverged(NotConverged {
        method: Method::ActiveSet,
        iterations,
        tolerance: 0.0,
        reached: f64::NAN,
        what: "the change of contact at the nodes",
    })
}

fn checked(model: &Model, elements: usize) -> Result<Existence, Error> {
    let existence = exists(model)?;
    if let Verdict::Local(_) = existence.verdict {
        return Err(Error::Unsupported(Problem::local_by_another_method()));
    }
    if !model.supports.is_empty() {
        return Err(Error::Unsupported(Problem::nodal_with_supports()));
    }
    if !model.hinges.is_empty() {
        return Err(Error::Unsupported(Problem::nodal_with_hinges()));
    }
    if model.beam.shears() {
        return Err(Error::Unsupported(Problem::shear_by_another_method(&model.beam)));
    }
    if let Some(load) = model.loads.iter().position(Load::is_on_ground) {
        return Err(Error::Unsupported(Problem::only_exactly(load)));
    }
    if let Some(part) = model.varying_part() {
        return Err(Error::Unsupported(Problem::nodal_where_it_varies(part)));
    }
    if let Some(part) = crate::solve::without_shear_layer(model) {
        return Err(Error::Unsupported(Problem::nodal_forces_on_springs(part)));
    }
    let fewest = Grid::of(model, Ground::Nodal).fewest();
    size::check_nodes(fewest.saturating_add(elements), Options::default().memory_limit)?;
    Ok(existence)
}

/// u at every node: ψ where the beam touches, the open ground's own elsewhere.
fn settle_ground(grid: &Grid, into: &mut NodalSolution) {
    let NodalSolution { deflection, settlement, contact, .. } = into;
    settlement.resize(grid.last() + 1, 0.0);
    let hull = Hull { grid, deflection, near: &[] };
    let mut before: Option<(usize, f64)> = None;
    for &[from, to] in contact.iter() {
        if grid.flat {
            settlement[from..=to].copy_from_slice(&deflection[from..=to]);
        } else {
            (from..=to).for_each(|node| settlement[node] = hull.psi(node));
        }
        let ends = [before.map(|b| b.1), Some(settlement[from])];
        open::ground(grid, [before.map_or(0, |b| b.0), from], ends, settlement);
        before = Some((to, settlement[to]));
    }
    if let Some((to, psi)) = before
        && to < grid.last()
    {
        open::ground(grid, [to, grid.last()], [Some(psi), None], settlement);
    }
}
