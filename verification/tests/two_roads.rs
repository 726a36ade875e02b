//! The paper's discrete problem by four methods: the active set, the paper's iteration, brute force over all contact
//! sets, and an interior-point solver for quadratic programs.
//!
//! Claims: `docs/equations.md`.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use groundbeam::{
    Beam, Error, Field, Foundation, Hinge, Load, Method, Model, Options, Outcome, Solution,
    Support, Verdict, exists,
    model::{Action, Extent},
    solve_with,
};
use groundbeam_verification::dense::Dense;
use groundbeam_verification::random::{self, Family};
use groundbeam_verification::solved::solved_by;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A beam with loads at the nodes of a uniform mesh.
fn model(rng: &mut ChaCha8Rng, elements: usize) -> Model {
    loop {
        let l = 10_f64.powf(rng.random_range(-0.5..1.0));
        let k = 10_f64.powf(rng.random_range(-1.0..1.0));
        let ei = 0.25 * k * (l / 10_f64.powf(rng.random_range(-0.5..0.6))).powi(4);
        let mu = k * (l * 10_f64.powf(rng.random_range(-1.0..0.5))).powi(2);
        let mut beam = Beam::uniform(l, ei);
        if rng.random_bool(0.3) {
            // An element longer than √(EI/P) is cut.
            let most = 0.9 * (elements * elements) as f64;
            beam.axial_force = ei / (l * l) * rng.random_range(0.1..10.0_f64).min(most);
        }
        let mut model = Model::new(beam, Foundation::pasternak(k, mu));
        for _ in 0..rng.random_range(1..4) {
            let at = l * (rng.random_range(0..=elements) as f64 / elements as f64);
            model.loads.push(Load::point_force(at, rng.random_range(-0.3..1.0)));
        }
        if rng.random_bool(0.5) {
            let at = l * (rng.random_range(0..=elements) as f64 / elements as f64);
            model.loads.push(Load::point_moment(at, l * rng.random_range(-0.3..0.3)));
        }
        if rng.random_bool(0.3) {
            model.loads.push(Load::uniform_force(0.0, l, rng.random_range(0.0..1.0) / l));
        }
        if rng.random_bool(0.3) {
            model.loads.push(Load::uniform_curvature(0.0, l, rng.random_range(-0.5..0.5) * l / ei));
        }
        if exists(&model).is_ok_and(|e| e.verdict == Verdict::Unique) {
            return model;
        }
    }
}

fn solved(model: &Model, method: Method, elements: usize) -> Solution {
    let options = Options { method, elements, ..Options::default() };
    solved_by(model, &options)
}

/// w and p at the nodes.
fn nodal(solution: &Solution, elements: usize) -> (Vec<f64>, Vec<f64>) {
    let l = solution.model().beam.length;
    let x = |i: usize| l * (i as f64 / elements as f64);
    let w = (0..=elements).map(|i| solution.value(Field::Deflection, x(i))).collect();
    let mut p = vec![0.0; elements + 1];
    for force in solution.concentrated_forces() {
        p[(force.at / l * elements as f64).round() as usize] += force.force;
    }
    p[0] = solution.end_forces().left;
    p[elements] = solution.end_forces().right;
    (w, p)
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

#[test]
fn the_active_set_agrees_with_brute_force_over_all_contact_sets() {
    let mut rng = ChaCha8Rng::seed_from_u64(1980);
    for number in 0..400 {
        let elements = rng.random_range(2..9);
        let model = model(&mut rng, elements);
        let (w, p) = Dense::new(&model, elements).by_exhaustion().expect("one set satisfies all");
        let (found_w, found_p) = nodal(&solved(&model, Method::ActiveSet, elements), elements);
        let (dw, dp) = (distance(&found_w, &w), distance(&found_p, &p));
        assert!(dw < 1e-7 && dp < 1e-7, "{number}: {dw:e} {dp:e} {model:?}");
    }
}

#[test]
fn the_active_set_agrees_with_the_iteration_of_the_paper() {
    let mut rng = ChaCha8Rng::seed_from_u64(517);
    for number in 0..200 {
        let elements = rng.random_range(2..12);
        let model = model(&mut rng, elements);
        let found = solved(&model, Method::ActiveSet, elements);
        let (w, p) = nodal(&found, elements);
        // A beam that curls up from the single node that carries it may rotate there, so only its forces are compared.
        let most = p.iter().copied().fold(0.0, f64::max);
        let turns = p.iter().filter(|force| **force > 1e-9 * most).count() < 2;
        for method in [Method::Uzawa, Method::Psor] {
            let (found_w, found_p) = nodal(&solved(&model, method, elements), elements);
            let (dw, dp) = (distance(&found_w, &w), distance(&found_p, &p));
            let same = (turns || dw < 1e-6) && dp < 1e-6;
            assert!(same, "{number} {method:?}: {dw:e} {dp:e} {model:?}");
        }
    }
}

/// The iteration of the paper also solves beams with shear deformation, Winkler ground, loads on the ground, hinges and
/// supports.
#[test]
fn the_iteration_of_the_paper_has_the_features_of_the_active_set() {
    let beam = Beam::uniform(4.0, 1.0);
    let ground = Foundation::pasternak(1.0, 0.3);
    let loaded = |beam: &Beam, ground: &Foundation| {
        Model::new(beam.clone(), ground.clone())
            .with_load(Load::uniform_force(0.0, 4.0, 0.1))
            .with_load(Load::point_force(1.0, 1.0))
            .with_load(Load::point_moment(3.0, 0.5))
            .with_gap(0.0, 0.01)
            .with_gap(4.0, 0.05)
    };
    let hinged = |places: &[f64]| {
        let model = loaded(&beam, &ground).with_load(Load::point_force(3.5, 1.0));
        places.iter().fold(model, |model, x| model.with_hinge(Hinge::free(*x)))
    };
    let mut pulled = hinged(&[1.2, 2.5]);
    pulled.beam.axial_force = 0.5;
    let models = [
        loaded(&beam.clone().with_shear_stiffness(2.0), &ground),
        loaded(&beam, &Foundation::winkler(1.0)),
        loaded(&beam, &ground.clone().with_segment(1.0, 2.0, 3.0, 0.0)),
        loaded(&beam, &ground).with_load(Load::distributed_ground_force(2.0, 5.0, 0.4, 0.1)),
        hinged(&[2.0]),
        hinged(&[1.2, 2.5]),
        hinged(&[0.3, 1.4, 2.5]),
        hinged(&[]).with_hinge(Hinge::elastic(2.0, 0.3)),
        hinged(&[2.5]).with_hinge(Hinge::elastic(1.2, 0.3)),
        hinged(&[2.0]).with_support(Support::pinned(3.2)),
        hinged(&[2.0]).with_support(Support::pinned(2.0).settled(0.1)),
        hinged(&[1.2, 2.5]).with_support(Support::fixed(0.0)),
        hinged(&[1.2, 2.5]).with_support(Support::spring(2.0, 0.5, 0.2)),
        hinged(&[1.2, 2.5]).with_support(Support::pinned(0.7)).with_support(Support::pinned(1.5)),
        pulled,
    ];
    for (number, model) in models.iter().enumerate() {
        let expected = solved(model, Method::ActiveSet, 12);
        for method in [Method::Uzawa, Method::Psor] {
            let found = solved(model, method, 12);
            for field in [Field::Deflection, Field::Rotation, Field::Settlement] {
                for i in 0..=12 {
                    let x = f64::from(i) / 3.0;
                    let [a, b] = [&found, &expected].map(|solution| solution.value(field, x));
                    assert!((a - b).abs() < 1e-8, "{number} {method:?} {field:?} {x}: {a} {b}");
                }
            }
        }
    }
}

/// Random beams with hinges. Some of them are so much softer than the ground that the iteration needs more sweeps than
/// this test allows.
#[test]
fn the_iteration_of_the_paper_agrees_with_the_active_set_on_beams_with_hinges() {
    let mut converged = 0;
    for number in 0..40 {
        let model = random::model(Family::Hinged, number);
        let options = Options {
            method: Method::Psor,
            elements: 12,
            most_sweeps: 100_000,
            ..Options::default()
        };
        let found = match solve_with(&model, &options) {
            Ok(Outcome::Equilibrium(found)) => found,
            Err(Error::NotConverged(_)) => continue,
            other => panic!("{number}: {other:?}"),
        };
        converged += 1;
        let expected = solved(&model, Method::ActiveSet, 12);
        // On Winkler ground, the active set balances the moments at a free hinge of a stiff beam to seven digits only.
        let tolerance = if model.foundation.shear_layer == 0.0 { 1e-5 } else { 1e-8 };
        for field in [Field::Deflection, Field::Settlement] {
            let values = |solution: &Solution| -> Vec<f64> {
                let x = |i| model.beam.length * f64::from(i) / 50.0;
                (0..=50).map(|i| solution.value(field, x(i))).collect()
            };
            let error = distance(&values(&found), &values(&expected));
            assert!(error < tolerance, "{number} {field:?}: {error:e} {model:?}");
        }
    }
    assert!(converged >= 30, "{converged} of 40 converged");
}

#[test]
fn the_active_set_agrees_with_an_interior_point_solver() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut compared = 0;
    for number in 0..100 {
        let elements = rng.random_range(10..25);
        let model = model(&mut rng, elements);
        let Some(w) = by_clarabel(&Dense::new(&dimensionless(&model, elements), elements)) else {
            continue;
        };
        compared += 1;
        let (found, _) = nodal(&solved(&model, Method::ActiveSet, elements), elements);
        let h = model.beam.length / elements as f64;
        let unit = h.powi(3) / model.beam.bending_stiffness;
        let w: Vec<f64> = w.iter().map(|w| w * unit).collect();
        let dw = distance(&found, &w);
        // The solver's own residuals are 1e-12, and the condition number of the stiffness is n⁴, and more near tipping.
        assert!(dw < 1e-4, "{number}: {dw:e} {model:?}");
    }
    assert!(compared > 50, "{compared} of 100 solved by the other solver");
}

/// The same model with h = EI = 1, and deflections in h³/EI, a scaling that suits an interior-point solver.
fn dimensionless(model: &Model, elements: usize) -> Model {
    let h = model.beam.length / elements as f64;
    let ei = model.beam.bending_stiffness;
    let mut scaled = model.clone();
    scaled.beam =
        Beam::uniform(elements as f64, 1.0).with_axial_force(model.beam.axial_force * h * h / ei);
    let ground = &model.foundation;
    scaled.foundation =
        Foundation::pasternak(ground.subgrade * h.powi(4) / ei, ground.shear_layer * h * h / ei);
    for load in &mut scaled.loads {
        if load.is_on_ground() {
            continue;
        }
        *load = match (load.action(), load.extent()) {
            (Action::Force, Extent::Point { at, size }) => Load::point_force(at / h, size),
            (Action::Moment, Extent::Point { at, size }) => Load::point_moment(at / h, size / h),
            (Action::Force, Extent::Distributed { from, to, start, end }) => {
                Load::distributed_force(from / h, to / h, start * h, end * h)
            }
            (Action::Curvature, Extent::Distributed { from, to, start, end }) => {
                let [start, end] = [start, end].map(|curvature| curvature * ei / h);
                Load::distributed_curvature(from / h, to / h, start, end)
            }
            _ => *load,
        };
    }
    scaled
}

/// Over p ≥ 0 and W: minimise ½pᵀGp + ½WᵀKW subject to K W + p = F, the reciprocal form (3.9).
fn by_clarabel(dense: &Dense) -> Option<Vec<f64>> {
    let (n, m) = (dense.nodes, 2 * dense.nodes);
    let size = m + n;
    let upper = |a: &[Vec<f64>], shift: usize, out: &mut Vec<(usize, usize, f64)>| {
        for (i, row) in a.iter().enumerate() {
            for (j, &value) in row.iter().enumerate().skip(i) {
                out.push((shift + i, shift + j, value));
            }
        }
    };
    let mut hessian = Vec::new();
    upper(&dense.stiffness, 0, &mut hessian);
    upper(&dense.flexibility, m, &mut hessian);
    let mut rows = Vec::new();
    for i in 0..m {
        for j in 0..m {
            if dense.stiffness[i][j] != 0.0 {
                rows.push((i, j, dense.stiffness[i][j]));
            }
        }
        if i % 2 == 0 {
            rows.push((i, m + i / 2, 1.0));
        }
    }
    for i in 0..n {
        rows.push((m + i, m + i, -1.0));
    }
    let csc = |rows: usize, entries: &[(usize, usize, f64)]| {
        let i = entries.iter().map(|e| e.0).collect();
        let j = entries.iter().map(|e| e.1).collect();
        CscMatrix::new_from_triplets(rows, size, i, j, entries.iter().map(|e| e.2).collect())
    };
    let mut right = dense.load.clone();
    right.extend(vec![0.0; n]);
    let cones = [SupportedConeT::ZeroConeT(m), SupportedConeT::NonnegativeConeT(n)];
    let settings = DefaultSettings {
        verbose: false,
        tol_gap_abs: 1e-12,
        tol_gap_rel: 1e-12,
        tol_feas: 1e-12,
        ..DefaultSettings::default()
    };
    let (p, a) = (csc(size, &hessian), csc(m + n, &rows));
    let mut solver = DefaultSolver::new(&p, &vec![0.0; size], &a, &right, &cones, settings).ok()?;
    solver.solve();
    if solver.solution.status != SolverStatus::Solved {
        return None;
    }
    // The multiplier of K W + p = F is the deflection, including the rigid motion.
    Some((0..n).map(|i| -solver.solution.z[2 * i]).collect())
}
