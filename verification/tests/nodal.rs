//! Compares nodal solutions with the paper, with the exact method for every feature and on random models; and counts their work.
//!
//! Claims: `docs/methods.md`.

use groundbeam::{
    Beam, Error, Field, Foundation, Hinge, Load, Method, Model, NodalSolution, NodalSolver,
    Options, Support, model::Acts, model::Part, model::Profile, solution::Reaction, solution::Side,
};
use groundbeam_verification::cases;
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::solved::{solved, solved_by};

fn nodal(model: &Model, elements: usize) -> NodalSolution {
    let mut found = NodalSolution::default();
    NodalSolver::new().solve_into(model, elements, &mut found).expect("an answer");
    found
}

fn kikuchi(moment: f64) -> Model {
    Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::point_force(0.5, 1.0))
        .with_load(Load::point_moment(0.5, moment))
}

fn long_beam(axial_force: f64) -> Model {
    let text = std::fs::read_to_string(cases::folder().join("long-beam.toml")).expect("a case");
    let mut model = groundbeam_file::parse(&text).expect("a model").model;
    model.beam.axial_force = axial_force;
    model
}

/// The paper's results for ten elements at the left end, 0.29882 and 0.01341.
#[test]
fn ten_elements_give_the_deflections_of_the_paper() {
    for (moment, printed) in [(0.1, 0.29882), (0.49, 0.01341)] {
        let w = nodal(&kikuchi(moment), 10).deflection[0];
        assert!((w - printed).abs() < 5.1e-6, "{w}");
    }
}

/// Supports, hinges, a gap, stiffness and ground that vary.
fn varied() -> Model {
    let beam = Beam::uniform(8.0, 2.0).with_segment(2.0, 3.0, 0.5).with_varying_segment(
        5.0,
        8.0,
        Profile::linear(2.0, 6.0),
    );
    let ground = Foundation::pasternak(1.0, 0.3)
        .with_segment(-1.0, 1.5, 4.0, 1.0)
        .with_varying_segment(6.0, 9.0, Profile::linear(0.5, 1.0), Profile::linear(2.0, 0.4));
    Model::new(beam, ground)
        .with_load(Load::distributed_force(1.0, 4.0, 0.2, 1.0))
        .with_load(Load::point_force(6.5, 2.0))
        .with_load(Load::point_force(3.9, -0.4))
        .with_load(Load::point_moment(2.5, 0.3))
        .with_load(Load::distributed_moment(5.5, 6.0, 0.1, -0.2))
        .with_gap(0.0, 0.0)
        .with_gap(3.0, 0.02)
        .with_gap(7.0, -0.01)
        .with_hinge(Hinge::free(4.7))
        .with_hinge(Hinge::elastic(7.3, 0.8))
        .with_support(Support::pinned(3.3).settled(0.05))
        .with_support(Support::spring(5.2, 1.5, 0.3))
        .with_support(Support::fixed(8.0))
}

/// Models that together have every feature which the nodal method supports, and their mirror images.
fn with_every_feature() -> Vec<Model> {
    let mut shearing = varied();
    shearing.beam.shear_stiffness = Some(4.0);
    let lifted = Model { loads: vec![Load::point_force(1.0, -3.0)], ..varied() };
    // Loads on the ground need ground that is uniform along each segment.
    let foundation = Foundation::pasternak(1.0, 0.3).with_segment(-1.0, 1.5, 4.0, 1.0);
    let neighbour = Load::distributed_ground_force(0.5, 2.0, 0.3, 0.1);
    let loaded = Model { foundation, ..varied() }.with_load(neighbour);
    let models = [varied(), shearing, lifted, loaded];
    models.iter().flat_map(|model| [model.clone(), model.mirrored()]).collect()
}

/// With every feature, by both sweeps, the discrete solutions converge to the exact one with order h².
#[test]
fn every_feature_converges_to_the_exact_answer() {
    for model in with_every_feature() {
        let exact = solved(&model);
        let error = |elements: usize| {
            let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
            let found = solved_by(&model, &options);
            let off = |i: usize| {
                let x = 8.0 * i as f64 / 100.0;
                (found.value(Field::Deflection, x) - exact.value(Field::Deflection, x)).abs()
            };
            let range = exact.range(Field::Deflection);
            let largest = range.max.value.abs().max(range.min.value.abs());
            (0..=100).map(off).fold(0.0, f64::max) / largest
        };
        let errors = [error(50), error(500), error(5000)];
        assert!(errors[0] < 2e-2 && errors[1] < 4e-4 && errors[2] < 6e-6, "{errors:?}");
    }
}

/// The solutions converge to the exact one under mesh refinement.
#[test]
fn meshes_converge_to_the_exact_answer() {
    let model = long_beam(0.5);
    let exact = solved(&model);
    let error = |elements: usize| {
        let found = nodal(&model, elements);
        let off = |i: usize| {
            (found.deflection[i] - exact.value(Field::Deflection, found.position(i))).abs()
        };
        (0..found.deflection.len()).map(off).fold(0.0, f64::max)
    };
    let errors = [error(1_000), error(10_000), error(100_000)];
    assert!(errors[0] < 2e-2 && errors[1] < 2e-4 && errors[2] < 2e-6, "{errors:?}");
}

/// The nodal solver and `active-set` solve the same discrete problem: node values, ground forces and reactions agree.
#[test]
fn the_nodal_solution_is_that_of_active_set() {
    let mut sprung = varied();
    sprung.foundation = Foundation::pasternak(1.0, 0.3).with_segment(2.5, 6.0, 3.0, 0.0);
    let more = [sprung.clone(), sprung.mirrored()];
    for model in with_every_feature().into_iter().chain(more) {
        for elements in [20, 200] {
            let found = nodal(&model, elements);
            let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
            let expected = solved_by(&model, &options);
            let scale = |field: Field| {
                let range = expected.range(field);
                range.max.value.abs().max(range.min.value.abs())
            };
            for node in 0..found.deflection.len() {
                let fields = expected.at(found.position(node), Side::Right);
                let off = |found: &[f64], expected: f64, field: Field| {
                    let off = (found[node] - expected).abs();
                    assert!(off < 1e-10 * scale(field), "{field:?} {node} of {elements}: {off:e}");
                };
                off(&found.deflection, fields.deflection, Field::Deflection);
                off(&found.rotation, fields.rotation, Field::Rotation);
                off(&found.settlement, fields.settlement, Field::Settlement);
            }
            assert_eq!(found.reactions.len(), model.supports.len());
            let [force, moment] = [Field::ShearForce, Field::Moment].map(scale);
            for (found, expected) in found.reactions.iter().zip(expected.reactions()) {
                assert_eq!(found.at, expected.at);
                assert!((found.force - expected.force).abs() < 1e-9 * force, "{found:?}");
                assert!((found.moment - expected.moment).abs() < 1e-9 * moment, "{found:?}");
            }
            // Where μ = 0, `active-set` replaces the forces at the nodes by a distributed pressure.
            if model.foundation.segments.iter().all(|segment| segment.shear_layer.smallest() > 0.0)
            {
                let upward: f64 = found.force.iter().sum();
                let forces = expected.concentrated_forces().iter().map(|force| force.force);
                let [left, right] = [expected.end_forces().left, expected.end_forces().right];
                let off = (upward - forces.sum::<f64>() - left - right).abs();
                assert!(off < 1e-9 * force, "{upward} {off}");
            }
        }
    }
}

#[test]
fn random_beams_satisfy_equilibrium_and_the_contact_conditions() {
    let families = Family::ALL.into_iter().chain([Family::Shearing]);
    let mut solver = NodalSolver::new();
    let mut found = NodalSolution::default();
    for family in families {
        for number in 0..40 {
            let model = model(family, number);
            let elements = [3, 30, 300, 3000][number as usize % 4];
            match solver.solve_into(&model, elements, &mut found) {
                Ok(existence) if existence.verdict.stands() => {}
                Ok(_) => continue,
                // Supports that act in one direction only, or axial compression.
                Err(Error::Unsupported(_)) => continue,
                Err(error) => panic!("{family:?} {number}, {elements}: {error}"),
            }
            let check = found.check.expect("a check");
            // The reaction of a rigid support has the rounding error of the deflection times the stiffness of an element.
            let limit = if model.supports.is_empty() { 1e-9 } else { 1e-7 };
            let good = check.force_balance < limit
                && check.moment_balance < limit
                && check.smallest_force > -1e-9
                && check.deepest_penetration < 1e-9;
            assert!(good, "{family:?} {number}, {elements}: {check:?} {:?}", found.contact);
        }
    }
}

/// With doubled loads all fields are doubled, bit for bit; reused memory does not change the result.
#[test]
fn scaled_loads_and_reused_memory_give_the_same_bits() {
    let model = long_beam(0.0);
    let mut solver = NodalSolver::new();
    let (mut once, mut again) = (NodalSolution::default(), NodalSolution::default());
    solver.solve_into(&model, 3000, &mut once).expect("an answer");
    solver.solve_into(&kikuchi(0.4), 50, &mut again).expect("an answer");
    solver.solve_into(&model.clone().with_loads_scaled(2.0), 3000, &mut again).expect("an answer");
    assert_eq!(once.contact, again.contact);
    for (a, b) in [(&once.deflection, &again.deflection), (&once.force, &again.force)] {
        assert!(a.iter().zip(b).all(|(a, b)| (2.0 * a).to_bits() == b.to_bits()));
    }
}

/// A cantilever whose support lifts it off the ground, solved in memory that holds another solution.
#[test]
fn a_lifted_cantilever_leaves_the_ground_level() {
    let lifted = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_support(Support::fixed(0.0).settled(-1.0))
        .with_load(Load::point_force(0.5, 0.1));
    let mut found = nodal(&kikuchi(0.1), 10);
    NodalSolver::new().solve_into(&lifted, 10, &mut found).expect("an answer");
    assert!(found.contact.is_empty());
    assert!(found.settlement.iter().all(|u| *u == 0.0));
    let [reaction] = found.reactions[..] else { panic!("{:?}", found.reactions) };
    assert!((reaction.force - 0.1).abs() < 1e-14 && (reaction.moment + 0.05).abs() < 1e-14);
    assert!((found.deflection[10] + 1.0 - 0.1 * (0.125 / 3.0 + 0.125 / 2.0)).abs() < 1e-14);
}

/// The force of a very stiff spring is that of a pin. It follows from equilibrium, because the rounding error of the
/// deflection times the stiffness is larger than the loads.
#[test]
fn a_very_stiff_spring_has_the_reaction_of_a_pin() {
    let at_nodes = |model: &Model| nodal(model, 1000).reactions[0];
    let exactly = |model: &Model| solved(model).reactions()[0];
    // With stiffer springs, the certificate of the exact solution is larger than its limit.
    let ways = [(&at_nodes as &dyn Fn(&Model) -> Reaction, 1e20), (&exactly, 1e12)];
    for (of, most) in ways {
        let on = |support: Support| of(&long_beam(0.5).with_support(support));
        let (pin, clamp) = (on(Support::pinned(20.0)), on(Support::fixed(20.0)));
        for stiffness in [1e10, 1e12, 1e16, 1e20].into_iter().filter(|k| *k <= most) {
            let spring = on(Support::spring(20.0, stiffness, 0.0));
            let clamped = on(Support::spring(20.0, stiffness, stiffness));
            let off = [
                spring.force / pin.force,
                clamped.force / clamp.force,
                clamped.moment / clamp.moment,
            ];
            assert!(off.iter().all(|ratio| (ratio - 1.0).abs() < 1e-9), "{stiffness}: {off:?}");
        }
    }
}

/// A nearly rigid beam on three settled springs, which carry a tenth of their settlement times their stiffness.
#[test]
fn springs_that_settle_with_a_rigid_beam_keep_their_reactions() {
    for bending in [1e3, 1e7, 1e9] {
        let model = Model::new(Beam::uniform(4.0, bending), Foundation::winkler(1e-3))
            .with_load(Load::point_force(1.0, 3.0))
            .with_support(Support::spring(0.0, 1.0, 0.0).settled(10.0))
            .with_support(Support::spring(2.0, 1.0, 0.0).settled(10.0))
            .with_support(Support::spring(4.0, 1.0, 0.0).settled(10.0));
        let found = solved(&model);
        for (reaction, support) in found.reactions().iter().zip(&model.supports) {
            let pressed = found.value(Field::Deflection, support.at) - support.settlement;
            assert!((reaction.force - pressed).abs() < 1e-13, "{bending}: {reaction:?} {pressed}");
        }
    }
}

#[test]
fn one_way_supports_are_refused() {
    let model = kikuchi(0.1).with_support(Support::pinned(0.3).acting(Acts::Up));
    let refused = NodalSolver::new().solve_into(&model, 10, &mut NodalSolution::default());
    let Err(Error::Unsupported(problem)) = refused else { panic!("{refused:?}") };
    assert_eq!((problem.code, problem.part), ("GB604", Part::Support(0)));
}

/// A check never holds without a solve.
#[test]
fn only_a_solution_has_a_check() {
    let (mut solver, mut found) = (NodalSolver::new(), NodalSolution::default());
    assert_eq!(found.check, None);
    solver.solve_into(&kikuchi(0.4), 50, &mut found).expect("an answer");
    assert!(found.check.is_some_and(|check| check.holds()));
    solver.bonded_into(&kikuchi(0.4), 50, &mut found).expect("a bonded beam");
    assert_eq!(found.check, None);
}

/// A start from the solution of a neighbouring model gives the same solution in fewer solves.
#[test]
fn a_start_from_a_neighbouring_model_needs_fewer_solves() {
    let mut solver = NodalSolver::new();
    let mut found = nodal(&long_beam(0.0), 3000);
    let mut heavier = long_beam(0.0);
    heavier.loads[0] = Load::point_force(4.645674871334563, 1.3);
    solver.solve_near_into(&heavier, 3000, &mut found).expect("an answer");
    let (work, expected) = (found.work, nodal(&heavier, 3000));
    assert_eq!(found.contact, expected.contact);
    assert!(found.deflection.iter().zip(&expected.deflection).all(|(a, b)| (a - b).abs() < 1e-13));
    assert!(work.grids == 1 && work.solves <= 4, "{work:?} {:?}", expected.work);
    // A useless start is ignored.
    solver.solve_near_into(&kikuchi(0.4), 3000, &mut found).expect("an answer");
    assert_eq!(found.contact, nodal(&kikuchi(0.4), 3000).contact);
}

/// Counts the work as a test of speed that needs no clock. A change that increases one of the numbers makes
/// the solve of every long beam slower in proportion.
#[test]
fn the_work_on_a_long_beam_stays_within_its_limits() {
    for axial_force in [0.0, 0.5] {
        let model = long_beam(axial_force);
        for (elements, solves, fine, swept) in
            [(1_000, 7, 2, 1.8), (10_000, 9, 2, 1.3), (100_000, 13, 2, 1.0), (300_000, 13, 1, 0.7)]
        {
            let work = nodal(&model, elements).work;
            assert!(work.fine_solves <= fine && work.solves <= solves, "{elements}: {work:?}");
            assert!(work.elements as f64 <= swept * elements as f64, "{elements}: {work:?}");
        }
    }
}

/// The same for the exact method: few steps, and a number of pieces proportional to the parts of the model.
#[test]
fn the_work_of_the_exact_method_stays_within_its_limits() {
    let steps = |model: &Model| solved(model).iterations();
    assert_eq!(steps(&kikuchi(0.1)), 1, "a beam pressed everywhere is solved once");
    assert!(steps(&kikuchi(0.49)) <= 9);
    assert!(steps(&long_beam(0.0)) <= 6);
    // Different wagons in a row on a rail: four times as many wagons need four times as many pieces.
    let rail = |wagons: usize| {
        let l = 30.0 * wagons as f64;
        let mut model = Model::new(Beam::uniform(l, 6.4e6), Foundation::pasternak(30e6, 2e6))
            .with_load(Load::uniform_force(0.0, l, 2500.0));
        for i in 0..wagons {
            for at in [8.0, 9.8, 17.0, 18.8] {
                let force = 8e4 + 1e3 * (i * 7 % 23) as f64;
                model.loads.push(Load::point_force(30.0 * i as f64 + at, force));
            }
        }
        solved(&model)
    };
    let [short, long] = [rail(20), rail(80)];
    let steps = [short.iterations(), long.iterations()];
    assert!(steps.iter().all(|steps| *steps <= 7), "{steps:?}");
    assert!(long.elements() <= 4 * short.elements() + 4);
}
