//! Measures solve times of random beams, footings and rails, on meshes and by the exact method.

use crate::clock::side_by_side;
use crate::models::{footings, rail, random_beams};
use crate::table::{Table, short};
use groundbeam::{
    Answer, Load, Model, NodalSolution, NodalSolver, Outcome, Solution, Solver, solve,
};
use std::time::Instant;

fn solved(model: &Model) -> Box<Solution> {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => solution,
        other => panic!("a model in equilibrium: {other:?}"),
    }
}

/// Returns the bit patterns of three results of each model: the computed contact edges, the contact force under the
/// left end of the beam, and the primal energy.
fn bits(models: &[Model]) -> Vec<u64> {
    let of = |model: &Model| {
        let solution = solved(model);
        let ends = solution.contact().iter().flat_map(|c| [c.from, c.to]);
        let all = ends.chain([solution.end_forces().left, solution.certificate().primal_energy()]);
        all.map(f64::to_bits).collect::<Vec<_>>()
    };
    models.iter().flat_map(of).collect()
}

/// Measures the time to solve 1000 random beams with 100 elements each, once bonded to the ground and once with one-way
/// contact.
pub fn meshes() -> String {
    let models = random_beams(1000);
    let mut solver = NodalSolver::new();
    let (mut all_bonded, mut found) = (NodalSolution::default(), NodalSolution::default());
    let mut other = NodalSolver::new();
    let (mut solves, mut failed) = (0, 0);
    let [one, two] = side_by_side(
        9,
        [
            &mut || {
                for model in &models {
                    solver.bonded_into(model, 100, &mut all_bonded).expect("a bonded beam");
                }
            },
            &mut || {
                (solves, failed) = (0, 0);
                for model in &models {
                    match other.solve_into(model, 100, &mut found) {
                        Ok(_) => solves += found.work.solves,
                        Err(_) => failed += 1,
                    }
                }
            },
        ],
    );
    let mut table = Table::new(
        "1000 random beams of 100 elements (case C), one thread",
        &["contact / bonded", "bonded µs", "contact µs", "solves a case", "failed"],
    );
    table.row(&[
        format!("**{:.2}**", two.least / one.least),
        short(1e3 * one.least),
        short(1e3 * two.least),
        short(solves as f64 / 1000.0),
        failed.to_string(),
    ]);
    table.finish("")
}

/// Times the exact method on random footings and on random beams of 50 m length (case C), on one and two threads.
pub fn exact() -> String {
    let mut table = Table::new(
        "Exact, solved and certified",
        &[
            "models",
            "two threads / one",
            "same bits",
            "per second and thread",
            "µs each",
            "steps",
            "zones 0, 1, 2, …",
        ],
    );
    for (name, models) in [("footings", footings(2000)), ("case C", random_beams(300))] {
        let half = models.len() / 2;
        let [one, two] = side_by_side(
            5,
            [
                &mut || models.iter().for_each(|model| drop(std::hint::black_box(solved(model)))),
                &mut || {
                    std::thread::scope(|scope| {
                        for part in [&models[..half], &models[half..]] {
                            scope.spawn(move || {
                                part.iter().for_each(|m| drop(std::hint::black_box(solved(m))));
                            });
                        }
                    });
                },
            ],
        );
        let alone = bits(&models);
        let (first, second) = models.split_at(half);
        let together = std::thread::scope(|scope| {
            let parts = [first, second].map(|part| scope.spawn(move || bits(part)));
            parts.map(|part| part.join().expect("a thread")).concat()
        });
        let mut zones = vec![0; 16];
        let mut steps = 0;
        for model in &models {
            let solution = solved(model);
            zones[solution.contact().len().min(15)] += 1;
            steps += solution.iterations();
        }
        while zones.last() == Some(&0) {
            zones.pop();
        }
        let each = one.least / models.len() as f64;
        table.row(&[
            name.to_owned(),
            format!("**{:.2}**", one.least / two.least),
            if alone == together { "yes" } else { "NO" }.to_owned(),
            format!("{:.0}", 1.0 / each),
            short(1e6 * each),
            short(steps as f64 / models.len() as f64),
            format!("{zones:?}"),
        ]);
    }
    table.finish("") + &followed()
}

/// Returns the model with its first load increased by 2 %.
fn neighbour(model: &Model) -> Model {
    let mut model = model.clone();
    if let Some(load) = model.loads.first_mut() {
        *load = Load::scaled(*load, 1.02);
    }
    model
}

/// Compares two solve times after a 2 % increase of the first load: from scratch, and from the previous contact zones.
fn followed() -> String {
    let mut table = Table::new(
        "A neighbouring model, its first load 2 % larger: from the contact of the previous model, or from scratch",
        &["models", "anew / followed", "µs anew", "µs followed", "steps anew", "steps followed"],
    );
    for (name, models) in [("footings", footings(2000)), ("case C", random_beams(300))] {
        let neighbours: Vec<Model> = models.iter().map(neighbour).collect();
        let mut solver = Solver::new();
        // The measured time excludes the solve before the load increase.
        let mut timed = |followed: bool| {
            let (mut seconds, mut steps) = (0.0, 0);
            for (model, neighbour) in models.iter().zip(&neighbours) {
                solver.solve(model).expect("a model in equilibrium");
                let began = Instant::now();
                let answer =
                    if followed { solver.solve_next(neighbour) } else { solver.solve(neighbour) };
                seconds += began.elapsed().as_secs_f64();
                if let Ok(Answer::Equilibrium(solution)) = answer {
                    steps += solution.iterations();
                }
            }
            (1e6 * seconds / models.len() as f64, steps as f64 / models.len() as f64)
        };
        let runs: Vec<_> = (0..5).map(|_| [timed(false), timed(true)]).collect();
        let least = |i: usize| runs.iter().map(|run| run[i].0).fold(f64::INFINITY, f64::min);
        table.row(&[
            name.to_owned(),
            format!("**{:.2}**", least(0) / least(1)),
            short(least(0)),
            short(least(1)),
            short(runs[0][0].1),
            short(runs[0][1].1),
        ]);
    }
    table.finish("")
}

/// Times the exact method on rails of increasing length.
pub fn rails() -> String {
    let mut table = Table::new(
        "A rail by the exact method, certified: cost by loads and zones",
        &["km", "axles", "zones", "ms", "µs an axle", "steps", "relative gap"],
    );
    let mut points = Vec::new();
    for length in [1250.0, 2500.0, 5000.0, 10_000.0] {
        let model = rail(length, 1);
        let mut least = f64::INFINITY;
        let mut last = None;
        for _ in 0..5 {
            let began = Instant::now();
            last = Some(solved(&model));
            least = least.min(began.elapsed().as_secs_f64());
        }
        let Some(solution) = last else { continue };
        let axles = (model.loads.len() - 1) as f64;
        points.push((axles.ln(), least.ln()));
        table.row(&[
            short(length / 1000.0),
            short(axles),
            solution.contact().len().to_string(),
            short(1e3 * least),
            short(1e6 * least / axles),
            solution.iterations().to_string(),
            format!("{:.0e}", solution.certificate().relative_gap()),
        ]);
    }
    let n = points.len() as f64;
    let mean = points.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let slope = points.iter().map(|p| (p.0 - mean.0) * (p.1 - mean.1)).sum::<f64>()
        / points.iter().map(|p| (p.0 - mean.0).powi(2)).sum::<f64>();
    table.finish(&format!("Time grows as the number of axles to the power **{slope:.2}**."))
}
