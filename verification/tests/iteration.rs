//! The contact iteration on single models: each fails or changes without one particular line of the iteration.

use groundbeam::{
    Beam, Foundation, Load, Method, Model, Options, Outcome, Solution, Support, Verdict, solve_with,
};
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::solved::solved;

/// The zones as fractions of the length.
fn zones(solution: &Solution) -> Vec<[f64; 2]> {
    let l = solution.model().beam.length;
    solution.contact().iter().map(|zone| [zone.from / l, zone.to / l]).collect()
}

#[test]
fn a_contact_zone_with_pressure_of_rounding_size_is_removed() {
    // A zone 0.65 l long reproduces itself in doubles. Its force is rounding error.
    let solution = solved(&model(Family::Supported, 973));
    let zones = zones(&solution);
    assert_eq!(zones.len(), 1, "{zones:?}");
    assert!((zones[0][0] - 0.057_137).abs() < 1e-5, "{zones:?}");
    assert_eq!(solution.undecided().len(), 1);
}

#[test]
fn a_beam_on_one_corner_touches_at_a_point() {
    for (family, number) in [(Family::Gap, 738), (Family::Shearing, 361)] {
        let solution = solved(&model(family, number));
        let zones = zones(&solution);
        assert!(
            matches!(solution.existence().verdict, Verdict::NotUnique(_)),
            "{family:?} {number}"
        );
        assert!(matches!(zones[..], [[from, to]] if from == to), "{family:?} {number}: {zones:?}");
    }
}

#[test]
fn a_mechanism_on_its_trial_contact_is_restrained() {
    for (family, number) in [(Family::Gap, 30), (Family::Hinged, 46), (Family::OneWay, 301)] {
        solved(&model(family, number));
    }
}

#[test]
fn small_deformations_of_a_beam_that_translates_far_keep_their_digits() {
    for (family, number) in [(Family::Settled, 5867), (Family::Extreme, 1502)] {
        solved(&model(family, number));
    }
}

#[test]
fn a_translated_beam_with_loads_on_the_ground_keeps_its_mesh() {
    // √(k/μ) times the distance between two nodes is a whole number, so rounding decides how the ground is divided.
    let ground = Foundation::pasternak(1.0, 0.25);
    let mut model = Model::new(Beam::uniform(10.0, 245_233_289.956_632_85), ground)
        .with_load(Load::point_force(3.0, 1.259_612_115_328_629_5))
        .with_load(Load::point_force(6.4, 4.632_093_744_694_606))
        .with_load(Load::point_force(4.0, 1.599_570_426_634_704))
        .with_load(Load::uniform_force(0.0, 10.0, 2.547_552_553_338_967))
        .with_load(Load::point_moment(4.780_963_635_455_136, 0.356_812_732_979_315_9))
        .with_load(Load::ground_force(11.0, 0.888_718_582_716_236_3))
        .with_support(Support::fixed(4.781).settled(12.414_167_152_609_808));
    let spring = Support::spring(4.781_804_217_989_291, 0.111_463_574_051_870_35, 0.0);
    model.supports.push(spring.settled(213.026_966_434_393_13));
    let model = model
        .with_gap(4.773_857_187_882_419, 0.069_986_788_595_739_97)
        .with_gap(4.781_009_509_131_411, 0.012_476_959_007_258_835);
    solved(&model);
}

#[test]
fn an_unloaded_beam_beyond_a_settled_clamp_rests_on_the_ground() {
    // Beyond the clamp, beam and ground surface have the same height, 0.05 m. Rounding errors of this height would open
    // thousands of gaps.
    let settled = |height: f64| {
        let model = Model::new(Beam::uniform(100.0, 1e7), Foundation::winkler(5e7))
            .with_load(Load::point_force(10.0, 1e5))
            .with_support(Support::fixed(100.0 / 3.0).settled(height))
            .with_gap(0.0, height);
        zones(&solved(&model))
    };
    let (low, high) = (settled(0.05), settled(0.0));
    assert_eq!(low.len(), high.len());
    for (low, high) in low.as_flattened().iter().zip(high.as_flattened()) {
        assert!((low - high).abs() < 1e-12, "{low} {high}");
    }
}

#[test]
fn a_long_beam_on_two_settled_clamps_has_few_contact_zones() {
    // Between the clamps the beam lies on sloping ground, and beyond them on level ground, without pressure except near
    // the load and the clamps. Rounding errors would divide it into thousands of contact zones.
    for (length, bending_stiffness) in [(60.0, 1e6), (100.0, 1e7), (200.0, 1e6)] {
        for (subgrade, shear_layer) in [(1e6, 0.0), (5e8, 0.0), (5e7, 1e3), (5e8, 1e6)] {
            let ground = Foundation::pasternak(subgrade, shear_layer);
            let model = Model::new(Beam::uniform(length, bending_stiffness), ground)
                .with_load(Load::point_force(0.1 * length, 1e5))
                .with_support(Support::fixed(0.3 * length).settled(0.05))
                .with_support(Support::fixed(0.6 * length).settled(0.07))
                .with_gap(0.3 * length, 0.05)
                .with_gap(0.6 * length, 0.07);
            assert!(solved(&model).contact().len() <= 3);
        }
    }
}

#[test]
fn a_contact_zone_of_rounding_size_beside_a_clamp_is_left_out() {
    // The clamp at 65 m settles by one rounding error more than the initial gap. Bonded, a zone of 10⁻¹¹ m beside it has
    // a false force that exceeds the loads.
    let mut beam = Beam::uniform(200.0, 4.173e5);
    beam.axial_force = 3.369e4;
    let mut model = Model::new(beam, Foundation::pasternak(5.809e8, 1.041e4))
        .with_load(Load::point_force(187.96, 1.147e5))
        .with_load(Load::point_force(140.66, 9.206e4));
    for (at, settlement) in [(65.0, 0.060_000_000_000_000_01), (110.0, 0.05), (180.0, 0.05)] {
        model = model.with_support(Support::fixed(at).settled(settlement));
    }
    for (at, gap) in [
        (10.0, 0.060_000_000_000_000_005),
        (70.0, 0.060_000_000_000_000_005),
        (100.0, 0.04),
        (110.0, 0.05),
    ] {
        model = model.with_gap(at, gap);
    }
    solved(&model);
}

#[test]
fn gaps_of_rounding_size_on_winkler_ground_are_closed() {
    // Between the supports the beam lies on the ground, and its deformation decays to rounding error within each cell.
    let mut beam = Beam::uniform(200.0, 2.203e5);
    beam.shear_stiffness = Some(3.062e8);
    let model = Model::new(beam, Foundation::winkler(6.967e7))
        .with_load(Load::point_force(173.81, 6.834e5))
        .with_load(Load::point_force(125.58, 1.571e5))
        .with_support(Support::fixed(30.0).settled(0.05))
        .with_support(Support::pinned(115.0).settled(0.05))
        .with_gap(10.0, 0.07)
        .with_gap(30.0, 0.05)
        .with_gap(50.0, 0.05);
    assert_eq!(solved(&model).contact().len(), 3);
}

#[test]
fn intervals_on_which_rounding_error_decides_are_undecided() {
    // Beside the clamp, the distance between beam and ground decays to zero. Beam and ground have the height 0.05 m
    // there, and its rounding error exceeds the distance.
    let model = Model::new(Beam::uniform(60.0, 5.041e7), Foundation::pasternak(1.253e7, 1.794e5))
        .with_load(Load::point_force(1.58, 5837.0))
        .with_support(Support::fixed(46.4).settled(0.05))
        .with_gap(0.0, 0.05);
    assert!(solved(&model).undecided().len() > 0);
}

#[test]
fn edges_that_move_by_rounding_errors_are_accepted() {
    solved(&model(Family::Hard, 774));
}

#[test]
fn the_continuation_starts_from_a_stiff_beam_and_takes_small_steps() {
    solved(&model(Family::Extreme, 230));
    assert_eq!(zones(&solved(&model(Family::Hard, 6164))).len(), 5);
}

#[test]
fn a_point_contact_at_the_end_of_a_layer_beside_springs_is_found() {
    solved(&model(Family::Varying, 7426));
    solved(&model(Family::Settled, 7576));
}

#[test]
fn a_mechanism_without_load_stays_at_rest() {
    for number in [9833, 10_240, 10_637] {
        solved(&model(Family::Hinged, number));
    }
}

#[test]
fn slits_that_close_slowly_under_the_line_search_are_closed() {
    solved(&model(Family::Shearing, 7839));
    solved(&model(Family::Shearing, 10_351));
    solved(&model(Family::Hinged, 1100));
    solved(&model(Family::Extreme, 1641));
}

/// The bonded beam is a mechanism on its contact set, or nearly one. Steps without stabilising springs do not stiffen them.
#[test]
fn stabilising_springs_hold_mechanisms_until_their_forces_are_rounding_error() {
    for (family, number) in [(Family::Shearing, 7824), (Family::Hinged, 8306), (Family::Hard, 2829)]
    {
        let gap = solved(&model(family, number)).certificate().relative_gap();
        assert!(gap < 1e-18, "{family:?} {number}: {gap:e}");
    }
    solved(&model(Family::Extreme, 482));
}

#[test]
fn an_open_beam_between_clamps_has_an_estimate_of_rounding_size() {
    let solution = solved(&model(Family::Settled, 8817));
    assert!(solution.contact().is_empty());
    assert!(solution.certificate().relative_gap() < 1e-24);
}

#[test]
fn contact_nodes_of_soft_beams_settle_after_many_shortened_steps() {
    let models = [(53, 333), (94, 1000), (189, 333), (263, 10_000), (303, 10_000), (333, 333)];
    for (number, elements) in models {
        let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
        let outcome = solve_with(&model(Family::Hard, number), &options);
        assert!(matches!(outcome, Ok(Outcome::Equilibrium(_))), "Hard {number}: {outcome:?}");
    }
}

#[test]
fn a_direction_without_decrease_of_energy_is_scanned_again() {
    assert_eq!(zones(&solved(&model(Family::Shearing, 439))).len(), 4);
}

#[test]
fn the_edge_force_of_a_beam_with_shear_deformation_includes_its_kink() {
    // Zones separated by short open spans on a shear layer hundreds of times stiffer in shear than the beam.
    for number in [229, 434, 439, 678] {
        let gap = solved(&model(Family::Shearing, number)).certificate().relative_gap();
        assert!(gap < 1e-22, "Shearing {number}: {gap:e}");
    }
}

#[test]
fn formerly_slow_or_failing_models_are_solved() {
    for (family, number, count) in [
        (Family::Extreme, 19, None),
        (Family::Hard, 7371, Some(2)),
        (Family::Settled, 2606, Some(3)),
    ] {
        let zones = zones(&solved(&model(family, number)));
        assert!(count.is_none_or(|count| zones.len() == count), "{family:?} {number}: {zones:?}");
    }
}
