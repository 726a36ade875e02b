//! Computes approximate contact edges from a solution with contact at mesh nodes, as an initial guess for the exact edges.

use crate::cancel::Cancel;
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::cell::Cell;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::nodal::grid::{Grid, Ground};
use crate::nodal::newton::Workspace;
use crate::nodal::{levels, newton};

/// Computes approximate contact edges on a mesh that resolves the waves of the deflection. Returns `None` with
/// supports, hinges or varying segments, with too many waves, and without convergence.
pub(crate) fn edges(model: &Model, cancel: &Cancel) -> Option<Vec<[f64; 2]>> {
    let held = !(model.supports.is_empty() && model.hinges.is_empty());
    if held || model.varying_part().is_some() {
        return None;
    }
    // The initial guess neglects shear deformation, which would take ten times as long and need more memory.
    let model = &Model { beam: model.beam.clone().without_shear(), ..model.clone() };
    if Grid::fewest(model) as f64 > PER_WAVE * MOST_WAVES {
        return None;
    }
    let waves = Grid::new(model, 1, Ground::Spread).wave_number() * model.beam.length;
    if waves.is_nan() || waves > MOST_WAVES {
        return None;
    }
    let mut grids = Vec::new();
    levels::grids(model, (PER_WAVE * waves) as usize, Ground::Spread, &mut grids);
    let mut workspace = Workspace::default();
    workspace.cancel.clone_from(cancel);
    workspace.contact(&grids, newton::START).ok()?;
    grids.last().map(|grid| workspace.edges(grid))
}

/// A solved grid and its contact edges.
pub(crate) struct Coarse {
    pub grid: Grid,
    pub workspace: Workspace,
    pub edges: Vec<[f64; 2]>,
}

/// Computes the contact zones on a mesh with `per_wave` elements per length 1/λ, where λ is the wave number of the beam
/// on its ground. Returns `None` if the contact iteration does not converge.
pub(crate) fn coarse(model: &Model, per_wave: f64, cancel: &Cancel) -> Option<Coarse> {
    let axial_force = model.beam.axial_force;
    let wanted = |cell: &Cell| {
        let wave = Operator::of(cell, axial_force, ZoneKind::Contact).wave_number();
        (wave * cell.length() * per_wave).ceil().clamp(2.0, MOST_COARSE * per_wave) as usize
    };
    let most = Mesh::build(model, &[], |_| 1).cells.iter().map(wanted).max().unwrap_or(2);
    let levels = 1..=most.next_power_of_two().trailing_zeros();
    let grid = |level: u32| {
        Grid::cut(model, Ground::Spread, |cell| {
            let count = wanted(cell).min(1 << level);
            (count, cell.length() / count as f64)
        })
    };
    let mut grids: Vec<Grid> = levels.map(grid).collect();
    let mut workspace = Workspace { cancel: cancel.clone(), ..Workspace::default() };
    workspace.contact(&grids, newton::START).ok()?;
    let grid = grids.pop()?;
    let edges = workspace.edges(&grid);
    Some(Coarse { grid, workspace, edges })
}

/// Length of an interval between required nodes beyond which its number of elements no longer increases. The unit is
/// 1/λ, with the wave number λ of the beam on its ground.
const MOST_COARSE: f64 = 64.0;

/// Number of elements per length 1/λ, with the wave number λ of the beam on its ground, on a mesh whose contact edges
/// serve as the initial guess of the exact method.
pub(crate) const PER_WAVE: f64 = 4.0;

/// Maximum length of a beam for which a mesh provides the initial guess. The unit of the length is 1/λ, with the wave
/// number λ of the beam on its ground.
pub(crate) const MOST_WAVES: f64 = 1e5;
