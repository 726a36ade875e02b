//! Contact edges of a free beam from its nodal problem: an initial guess for the exact edges.

use crate::cancel::Cancel;
use crate::model::Model;
use crate::nodal::grid::{Grid, Ground};
use crate::nodal::newton::Workspace;
use crate::nodal::{levels, newton};

/// Where a free beam touches, to the accuracy of a mesh fine enough for its waves; none if it has supports or
/// hinges, is too long and soft for a mesh, or anything varies along a segment.
pub(crate) fn edges(model: &Model, cancel: &Cancel) -> Option<Vec<[f64; 2]>> {
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
    workspace.cancel.clone_from(cancel);
    workspace.contact(&grids, newton::START).ok()?;
    grids.last().map(|grid| workspace.edges(grid))
}

/// Elements per 1/wave number of a mesh whose edges are a start for the exact ones.
pub(crate) const PER_WAVE: f64 = 4.0;

/// The most 1/wave numbers of a beam that starts from a mesh.
pub(crate) const MOST_WAVES: f64 = 1e5;
