//! Measures time, memory and error of solving case B on a mesh, for the bonded beam and for the beam that can lift off.

use crate::clock::{peak_memory, side_by_side};
use crate::models::long_beam;
use crate::reference::{self, Reference};
use crate::table::{Table, short};
use groundbeam::{NodalSolution, NodalSolver};
use std::process::Command;

const AXIAL_FORCES: [f64; 2] = [0.0, 0.5];
const ELEMENTS: [usize; 4] = [1_000, 10_000, 100_000, 1_000_000];

/// Returns a table of solve times, memory and errors. Errors are computed only for meshes with at most `most` elements.
pub fn table(most: usize) -> String {
    let columns = [
        "P",
        "n",
        "contact / bonded",
        "bonded ns/node",
        "contact ns/node",
        "steps on the mesh",
        "solves in all",
        "elements swept / n",
        "bytes/element",
        "errw",
        "errp",
        "contact set",
    ];
    let mut table = Table::new("One long beam (case B), one thread", &columns);
    let mut solver = NodalSolver::new();
    let (mut all_bonded, mut found) = (NodalSolution::default(), NodalSolution::default());
    for axial_force in AXIAL_FORCES {
        let model = long_beam(axial_force);
        for n in ELEMENTS {
            let (mut first, mut second) = (solver.clone(), solver.clone());
            let runs = (4_000_000 / n).clamp(7, 301);
            let [one, two] = side_by_side(
                runs,
                [
                    &mut || first.bonded_into(&model, n, &mut all_bonded).expect("a bonded beam"),
                    &mut || {
                        second.solve_into(&model, n, &mut found).expect("a beam in contact");
                    },
                ],
            );
            solver = second;
            let proven = (n <= most).then(|| {
                let right = reference::solve(&model, &found.rows(), &found.contact);
                let errors = errors(&found, &right);
                let set = right.smallest_force >= 0.0 && right.deepest <= 1e-20;
                [
                    short(errors[0]),
                    short(errors[1]),
                    if set { "proven" } else { "WRONG" }.to_owned(),
                ]
            });
            let [errw, errp, set] = proven.unwrap_or_else(|| ["-", "-", "-"].map(str::to_owned));
            let work = found.work;
            let bytes = memory(axial_force, n).map_or("-".to_owned(), |b| format!("{b:.0}"));
            table.row(&[
                short(axial_force),
                n.to_string(),
                format!("**{:.2}** (median {:.2})", two.least / one.least, two.median / one.median),
                short(1e9 * one.least / n as f64),
                short(1e9 * two.least / n as f64),
                work.fine_solves.to_string(),
                work.solves.to_string(),
                short(work.elements as f64 / n as f64),
                bytes,
                errw,
                errp,
                set,
            ]);
        }
    }
    table.finish(
        "* Bonded: the same beam bonded to the ground at every node, one sweep from each end.\n\
         * Times: the least of 7 to 301 runs; contact and bonded runs alternate.\n\
         * errw, errp: largest difference from a reference solve, divided by the largest value.\n  \
           Another code makes the reference solve, with stiffnesses and in double-double arithmetic.\n\
         * Contact set proven: the reference solve with this set has no tension and no node of the beam below the ground.\n\
         * Bytes: peak memory of a separate process minus that of one with 1000 elements.",
    )
}

fn errors(found: &NodalSolution, right: &Reference) -> [f64; 2] {
    let error = |a: &[f64], b: &[f64]| {
        let largest = b.iter().fold(0.0_f64, |most, b| most.max(b.abs()));
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
    };
    [error(&found.deflection, &right.deflection), error(&found.force, &right.force)]
}

/// Returns the peak memory per element \[bytes\], measured in a separate process.
fn memory(axial_force: f64, n: usize) -> Option<f64> {
    if n < 100_000 {
        return None;
    }
    let peak = |n: usize| -> Option<f64> {
        let program = std::env::current_exe().ok()?;
        let arguments = ["peak".to_owned(), axial_force.to_string(), n.to_string()];
        let output = Command::new(program).args(arguments).output().ok()?;
        String::from_utf8_lossy(&output.stdout).trim().parse().ok()
    };
    Some((peak(n)? - peak(1000)?) / n as f64)
}

/// Solves the long beam on a mesh and prints the peak memory of this process \[bytes\].
pub fn peak(axial_force: f64, n: usize) {
    let mut found = NodalSolution::default();
    NodalSolver::new().solve_into(&long_beam(axial_force), n, &mut found).expect("a beam");
    println!("{}", peak_memory().unwrap_or(f64::NAN));
}

/// Writes benchmark case B on a mesh of `n` elements and its double-double solutions to `file`, for other programs.
/// Prints the number of nodes, and the smallest solve times \[s\] of the bonded beam and of the beam with lift-off.
pub fn problem(n: usize, file: &std::path::Path) {
    let model = long_beam(0.0);
    let mut solver = NodalSolver::new();
    let mut other = NodalSolver::new();
    let (mut all_bonded, mut found) = (NodalSolution::default(), NodalSolution::default());
    let runs = (1_000_000 / n).clamp(5, 101);
    let [one, two] = side_by_side(
        runs,
        [&mut || solver.bonded_into(&model, n, &mut all_bonded).expect("a beam"), &mut || {
            other.solve_into(&model, n, &mut found).expect("a beam");
        }],
    );
    let rows = found.rows();
    let right = reference::solve(&model, &rows, &found.contact);
    let bonded = reference::solve(&model, &rows, &all_bonded.contact);
    let nodes = found.deflection.len();
    let x: Vec<f64> = (0..nodes).map(|i| found.position(i)).collect();
    let [forces, moments] = reference::nodal_loads(&model, &rows);
    let arrays = [x, forces, moments, right.deflection, right.force, bonded.deflection];
    let bytes: Vec<u8> = arrays.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    std::fs::write(file, bytes).expect("a file to write to");
    println!("{nodes} {} {}", one.least, two.least);
}
