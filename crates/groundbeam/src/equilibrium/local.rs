//! Finds the stable equilibrium next to the unloaded state, under compression that the beam bears only with the ground's help.
//!
//! The energy is not convex. The result is the equilibrium on the path that starts without compression
//! ([`branch`](crate::equilibrium::branch)). See *Compression* in `docs/existence.md`.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::intervals::Interval;
use crate::equilibrium::branch::{EquilibriumPath, PathEnd, PathPoint, follow};
use crate::equilibrium::buckling::{bonded_buckling_load, is_stable_bonded};
use crate::equilibrium::one_way;
use crate::error::{Error, NotConverged, Stopped};
use crate::existence::existence::existence;
use crate::existence::verdict::{Buckling, Existence, Local, RigidMotion, Verdict};
use crate::mesh::energy::work_of_loads;
use crate::mesh::mesh::Mesh;
use crate::model::compressed;
use crate::model::{Load, Model};
use crate::numeric::polynomial::{jet, value};
use crate::numeric::tolerance::BRANCH;
use crate::options::Method;
use crate::outcome::Outcome;

/// The buckling mode is computed at a compression that is lower than the buckling load by this fraction of the buckling
/// load.
const BELOW_BUCKLING: f64 = 1e-12;
/// Number of points per cell at which a mode is evaluated.
const MODE_POINTS: usize = 16;

/// Returns the verdict on a model in compression whose energy is not convex. If the path from zero compression reaches
/// the model's compression, the local equilibrium is returned too.
pub(crate) fn check(
    model: &Model,
    cancel: &Cancel,
    solve: impl FnOnce(&Model) -> Result<Outcome, Error>,
) -> Result<Assessment, Error> {
    let without = compressed(model, 0.0);
    let statics = existence(&without);
    let known = |verdict| Assessment {
        existence: Existence { verdict, ..statics },
        stability: 1.0,
        local: None,
    };
    // A beam with a free rigid motion at zero compression is unstable under any compression.
    let buckles = |motion: RigidMotion| Verdict::Buckles(Buckling::at_once(model, motion));
    let solution = match statics.verdict {
        Verdict::NotUnique(motion) => return Ok(known(buckles(motion))),
        Verdict::Unique => match solve(&without)? {
            Outcome::Equilibrium(solution) => solution,
            Outcome::NoEquilibrium(existence) => return Ok(known(existence.verdict)),
        },
        verdict => return Ok(known(verdict)),
    };
    if let Verdict::NotUnique(motion) = solution.existence().verdict {
        return Ok(known(buckles(motion)));
    }
    let contact = solution.contact().iter().map(|region| [region.from, region.to]).collect();
    let acts = one_way::acting(model, solution.candidate());
    let EquilibriumPath { wanted, last, end } =
        follow(model, PathPoint { compression: 0.0, contact, active: acts }, cancel);
    // The stability margin is zero at a limit point. If Newton's method fails while the margin is still
    // clearly positive, the end of the equilibrium path has not been found.
    let held = last.on_active_supports(model);
    let beyond = last.compression / (1.0 - BRANCH);
    if end == PathEnd::NotConverged && is_stable_bonded(&held, &last.contact, beyond, cancel) {
        let margin = 1.0 - last.compression / bonded_buckling_load(&held, &last.contact, cancel);
        let why = NotConverged::Branch(margin);
        return Err(Error::NotConverged(Stopped { method: Method::Exact, iterations: 0, why }));
    }
    let Some(state) = wanted else {
        return Ok(known(Verdict::Buckles(buckling(model, last, end, cancel))));
    };
    let buckles = bonded_buckling_load(&state.on_active_supports(model), &state.contact, cancel);
    let stability_margin = 1.0 - state.compression / buckles;
    let critical_compression = last.compression;
    let verdict = Verdict::Local(Local { stability_margin, critical_compression });
    Ok(Assessment { local: Some(state), stability: stability_margin, ..known(verdict) })
}

impl Buckling {
    /// Returns the buckling result of a beam that has a free rigid motion. Such a beam is unstable under any
    /// compression.
    fn at_once(model: &Model, motion: RigidMotion) -> Self {
        let RigidMotion { left, right, work, lifted } = motion;
        let end = if right.abs() > left.abs() { model.beam.length } else { 0.0 };
        let at = lifted.map_or(end, |[first, _]| first);
        Buckling { critical_compression: 0.0, at, left, right, work }
    }
}

/// Returns the compression at the end of the equilibrium path, and the buckling mode of the beam on the supports that
/// are active at this compression.
fn buckling(model: &Model, last: PathPoint, end: PathEnd, cancel: &Cancel) -> Buckling {
    let critical_compression = last.compression;
    let acts = if let PathEnd::NotStable(acts) = end { acts } else { last.active };
    let last = PathPoint { active: acts, ..last };
    let (at, [left, right], work) =
        mode(&last.on_active_supports(model), &last.contact, cancel).unwrap_or_default();
    Buckling { critical_compression, at, left, right, work }
}

/// Returns the position of the largest value of the buckling mode, its values at both ends of the beam, and the work of
/// the loads in it. The largest value is scaled to −1 (upward).
fn mode(model: &Model, contact: &[Interval], cancel: &Cancel) -> Option<(f64, [f64; 2], f64)> {
    let load = bonded_buckling_load(model, contact, cancel);
    // Close to its buckling load, a beam deflects in its buckling mode under any load that is not orthogonal to the
    // mode.
    let mut nearly = compressed(model, load * (1.0 - BELOW_BUCKLING));
    for corner in &mut nearly.gap {
        corner.value = 0.0;
    }
    for load in &mut nearly.loads {
        *load = load.scaled(0.0);
    }
    for support in &mut nearly.supports {
        support.settlement = 0.0;
    }
    let l = model.beam.length;
    // The load has no symmetry, because a symmetric load would not excite antisymmetric modes.
    nearly.loads.push(Load::distributed_force(0.0, 0.618 * l, 1.0, -0.37));
    let found = Bonded::new(&nearly, cancel).solve_on(contact).ok()?;
    let w = found.deflection();
    let mut largest = (0.0, 0.0_f64);
    for (i, cell) in found.mesh.cells.iter().enumerate() {
        for point in 0..=MODE_POINTS {
            let s = 2.0 * point as f64 / MODE_POINTS as f64 - 1.0;
            let here = value(w.cell(i), s);
            if here.abs() > largest.1.abs() {
                largest = (cell.global(s), here);
            }
        }
    }
    let (at, size) = largest;
    let [left, ..] = jet(w.cell(0), -1.0);
    let [right, ..] = jet(w.cell(found.mesh.cells.len() - 1), 1.0);
    let x: Vec<f64> = found.mesh.nodes.iter().map(|node| node.x).collect();
    let mesh = Mesh::build(model, &x, |_| 1);
    let same = mesh.cells.len() == found.mesh.cells.len();
    let work = same.then(|| work_of_loads(&mesh, found.motion()))?;
    // The mode is scaled to −1 at the position of its largest absolute value. Adding zero turns −0 into 0.
    Some((at, [left, right].map(|w| -w / size + 0.0), -work / size + 0.0))
}

/// The result of the checks before the solve.
pub(crate) struct Assessment {
    pub existence: Existence,
    /// Lower bound of the second variation of the energy, relative to that without compression. The ground is included
    /// only for a local equilibrium.
    pub stability: f64,
    /// The contact and the active supports of a local equilibrium.
    pub local: Option<PathPoint>,
}
