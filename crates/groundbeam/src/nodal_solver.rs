//! Solver for long beams: computes the solution at the nodes of meshes of up to millions of elements.

use crate::equilibrium::size;
use crate::error::{Error, NotConverged, Stopped};
use crate::existence::verdict::{Existence, Verdict};
use crate::model::Model;
use crate::nodal::grid::{Grid, Ground};
use crate::nodal::newton::Work;
use crate::nodal::newton::Workspace;
use crate::nodal::quadratic::NotSolved;
use crate::nodal::solution::NodalSolution;
use crate::nodal::{check, levels, newton, open, reactions};
use crate::options::{Method, Options};
use crate::solve::exists;
use crate::supported::{self, Way};

/// Solver for models on meshes. It reuses its memory in the next solve.
#[derive(Debug, Clone, Default)]
pub struct NodalSolver {
    workspace: Workspace,
    grids: Vec<Grid>,
}

impl NodalSolver {
    /// Creates a solver without a previous solution.
    pub fn new() -> Self {
        Self::default()
    }

    /// Solves the contact problem on about `elements` elements. If no equilibrium exists, `into` is unchanged. After an
    /// error, the content of `into` is undefined.
    ///
    /// # Errors
    ///
    /// The errors of [`solve`](crate::solve()), and [`Error::Unsupported`] for a feature that the nodal method
    /// does not [support](crate::supported).
    pub fn solve_into(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<Existence, Error> {
        let existence = checked(model, elements)?;
        if existence.verdict.stands() {
            self.search(&model.on_given_ground(), elements, into)?;
        }
        Ok(existence)
    }

    /// Solves the model on coarse grids first and on the required grid last.
    fn search(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<(), Error> {
        levels::grids(model, elements.max(1), Ground::Nodal, &mut self.grids);
        let (workspace, grids) = (&mut self.workspace, &self.grids);
        // The solves on coarse grids use the arrays of the workspace, so `into` is not resized for each grid.
        let found = workspace.approach(grids, newton::ANSWER);
        found.map_err(|NotSolved| stalled(workspace.work.solves))?;
        self.finish(model, into)
    }

    /// Solves a model, starting from the solution of a similar model in `into`. Coarser grids are needed if the number
    /// of nodes differs or the iteration does not converge.
    ///
    /// # Errors
    ///
    /// The errors of [`NodalSolver::solve_into`].
    pub fn solve_near_into(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<Existence, Error> {
        let existence = checked(model, elements)?;
        if existence.verdict.stands() {
            self.search_near(&model.on_given_ground(), elements, into)?;
        }
        Ok(existence)
    }

    /// Solves the model from the contact zones in `into`, or from coarse grids if this is impossible or does not
    /// converge.
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
        self.workspace.history.clear();
        self.workspace.zones.clone_from(&into.contact);
        self.finish(model, into).or_else(|_| self.search(model, elements, into))
    }

    /// Solves the model on the last grid from an initial guess of the contact zones, and checks the solution.
    fn finish(&mut self, model: &Model, into: &mut NodalSolution) -> Result<(), Error> {
        let workspace = &mut self.workspace;
        let swapped = |workspace: &mut Workspace, into: &mut NodalSolution| {
            std::mem::swap(&mut workspace.deflection, &mut into.deflection);
            std::mem::swap(&mut workspace.slope, &mut into.rotation);
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
        into.reactions = reactions::reactions(model, &grid, workspace);
        swapped(workspace, into);
        into.contact.clone_from(&workspace.zones);
        into.work = workspace.work;
        let NodalSolution { deflection, settlement, contact, .. } = into;
        open::settlement(&grid, deflection, contact, settlement);
        into.grid = Some(grid);
        let check = check::check(model, into);
        into.check = Some(check);
        if let Some(grid) = &into.grid {
            open::add_free_field(grid, &mut into.settlement);
        }
        if check.holds() { Ok(()) } else { Err(stalled(into.work.solves)) }
    }

    /// Solves the problem of a beam bonded to the ground at every node, also in tension. `settlement` is not written,
    /// because the ground follows the beam.
    ///
    /// # Errors
    ///
    /// The errors of [`NodalSolver::solve_into`].
    pub fn bonded_into(
        &mut self,
        model: &Model,
        elements: usize,
        into: &mut NodalSolution,
    ) -> Result<(), Error> {
        checked(model, elements)?;
        let model = &*model.on_given_ground();
        let grid = Grid::new(model, elements.max(1), Ground::Nodal);
        let workspace = &mut self.workspace;
        workspace.bond(&grid);
        workspace.resize(&grid);
        workspace.work = Work { grids: 1, ..Work::default() };
        workspace.solve_bonded(&grid, None).map_err(|_| stalled(1))?;
        into.reactions = reactions::reactions(model, &grid, workspace);
        std::mem::swap(&mut workspace.deflection, &mut into.deflection);
        std::mem::swap(&mut workspace.slope, &mut into.rotation);
        std::mem::swap(&mut workspace.force, &mut into.force);
        into.contact.clone_from(&workspace.zones);
        into.work = workspace.work;
        into.check = None;
        into.grid = Some(grid);
        Ok(())
    }
}

pub(crate) fn stalled(iterations: usize) -> Error {
    let why = NotConverged::Nodes;
    Error::NotConverged(Stopped { method: Method::ActiveSet, iterations, why })
}

pub(crate) fn checked(model: &Model, elements: usize) -> Result<Existence, Error> {
    let existence = exists(model)?;
    let is_local = matches!(existence.verdict, Verdict::Local(_));
    supported::check(model, Way::Nodes, is_local)?;
    size::check_nodes(&model.on_given_ground(), elements, Options::default().memory_limit)?;
    Ok(existence)
}
