//! Compression that the ground helps to carry, on beams with shear deformation and with one-way supports.
//!
//! Claims: `docs/existence.md`.

use crate::compression::{compressed, critical, local, near};
use groundbeam::{
    Beam, Field, Foundation, Load, Model, Support, existence::Local, model::Acts, own_buckling_load,
};
use groundbeam_verification::linear::Linear;
use groundbeam_verification::random::{self, Family};
use groundbeam_verification::upheaval::Meshed;
use std::f64::consts::PI;

/// A beam on pins at its ends and on ground that lies higher by q/k. Under the uniform load q, the beam stays straight.
fn pinned(l: f64, ei: f64, shear: f64, k: f64, mu: f64, q: f64) -> Model {
    let beam = Beam::uniform(l, ei).with_shear_stiffness(shear);
    Model::new(beam, Foundation::pasternak(k, mu))
        .with_load(Load::uniform_force(0.0, l, q))
        .with_support(Support::pinned(0.0))
        .with_support(Support::pinned(l))
        .with_gap(0.0, -q / k)
        .with_gap(l, -q / k)
}

/// For w = sin mπx/l, bending and shear act in series, 1/(1/P_E + 1/S) with P_E = EI (mπ/l)² (Engesser 1891), and the
/// ground in parallel: P = min P_E/(1 + P_E/S) + k l²/(mπ)² + μ.
#[test]
fn pinned_beams_with_shear_deformation_buckle_at_the_load_of_engesser() {
    let (ei, k, q) = (2.0, 3.0, 0.7);
    for (l, mu, shear) in
        [(2.0, 0.0, 50.0), (3.0, 0.4, 9.0), (6.0, 0.0, 14.0), (11.0, 5.0, 25.0), (30.0, 0.1, 11.0)]
    {
        let model = pinned(l, ei, shear, k, mu, q);
        let wave = |m: u32| {
            let r = (f64::from(m) * PI / l).powi(2);
            ei * r / (1.0 + ei * r / shear) + k / r + mu
        };
        let wanted = (1..200).map(wave).fold(f64::INFINITY, f64::min);
        let own = own_buckling_load(&model);
        assert!(own < wanted);
        near(critical(&compressed(&model, 1.01 * own)), wanted, 1e-9);
        near(critical(&compressed(&model, 3.0 * wanted)), wanted, 1e-9);
        let (solution, found) = local(&compressed(&model, 0.5 * (own + wanted)));
        near(found.stability_margin, 0.5 - 0.5 * own / wanted, 1e-9);
        assert!(solution.range(Field::Deflection).max.value < 1e-9 * q / k);
        assert!(solution.certificate().relative_gap() < 1e-9);
    }
}

/// If k > S²/EI, the buckling load of short waves decreases to S + μ as the waves get shorter. The beam is stable until
/// it has lost its shear stiffness.
#[test]
fn a_pinned_beam_on_stiff_ground_is_stable_until_its_shear_stiffness_is_lost() {
    let (l, mu, shear, q) = (4.0, 0.2, 0.5, 0.7);
    for (ei, k) in [(2.0, 3.0), (1.0, 0.3)] {
        let model = pinned(l, ei, shear, k, mu, q);
        for compression in [0.9 * (shear + mu), (1.0 - 1e-9) * (shear + mu), 2.0 * (shear + mu)] {
            near(critical(&compressed(&model, compression)), shear + mu, 1e-9);
        }
    }
}

/// A beam so flexible in shear that its critical wave length tends to zero: it buckles at S + μ.
#[test]
fn a_beam_flexible_in_shear_buckles_at_its_ends() {
    let (k, mu, shear) = (3.0, 0.2, 0.5);
    let model = Model::new(
        Beam::uniform(4.0, 2.0).with_shear_stiffness(shear),
        Foundation::pasternak(k, mu),
    )
    .with_load(Load::uniform_force(0.0, 4.0, 1.0));
    let found = critical(&compressed(&model, 0.1));
    assert!(found < shear + mu, "{found}");
    // The end of an infinite beam buckles before its middle.
    let long = critical(&compressed(&model.with_gap(0.0, 0.0), 0.69));
    near(found, long, 1e-9);
}

/// A complex number x + iy.
type Complex = [f64; 2];

fn times(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn over(a: Complex, b: Complex) -> Complex {
    let size = b[0] * b[0] + b[1] * b[1];
    times(a, [b[0] / size, -b[1] / size])
}

fn root(z: Complex) -> Complex {
    let (size, angle) = (z[0].hypot(z[1]).sqrt(), 0.5 * z[1].atan2(z[0]));
    [size * angle.cos(), size * angle.sin()]
}

/// Free beams with shear deformation, under their weight on Winkler ground. With z = r² of EI (1 + N/S) z² −
/// (N + EI k/S) z + k = 0, N = −P, even modes are w = cosh rx, φ = ((S + N) r − k/r)/S sinh rx, and odd modes
/// have sinh and cosh exchanged; at both ends φ′ = 0 and S (w′ − φ) + N w′ = ∫k w = 0. The limit S → ∞ gives
/// Hetényi's modes.
#[test]
fn free_beams_with_shear_deformation_buckle_at_their_closed_form_load() {
    let (ei, k) = (2.0, 3.0_f64);
    for l in [0.5, 2.0, 4.0, 7.0] {
        for shear in [1.5, 6.0, 40.0, 1e4] {
            let a = 0.5 * l;
            let determinant = |p: f64, odd: bool| {
                let n = -p;
                let (lead, middle) = (ei * (1.0 + n / shear), n + ei * k / shear);
                let inside = root([middle * middle - 4.0 * lead * k, 0.0]);
                let z = [1.0, -1.0].map(|sign| {
                    [0, 1].map(|i| ([middle, 0.0][i] + sign * inside[i]) / (2.0 * lead))
                });
                // cosh ra and sinh(ra)/r, the same for both signs of r.
                let both = z.map(|z| {
                    let r = root(z);
                    let (x, y) = (r[0] * a, r[1] * a);
                    let cosh = [x.cosh() * y.cos(), x.sinh() * y.sin()];
                    let sinh = [x.sinh() * y.cos(), x.cosh() * y.sin()];
                    [cosh, over(sinh, r)]
                });
                let turned = |i: usize| {
                    let factor = [(shear + n) * z[i][0] - k, (shear + n) * z[i][1]];
                    times(factor, both[i][usize::from(odd)])
                };
                let pressed = |i: usize| {
                    if odd { over(both[i][0], z[i]) } else { both[i][1] }
                };
                let [x, y] = [times(turned(0), pressed(1)), times(turned(1), pressed(0))];
                let difference = [x[0] - y[0], x[1] - y[1]];
                let apart = [z[0][0] - z[1][0], z[0][1] - z[1][1]];
                over(difference, apart)[0]
            };
            let most = shear.min(2.0 * (k * ei).sqrt());
            let first = |odd: bool| {
                let f = |p: f64| determinant(p, odd);
                let step = most / 4096.0;
                let mut low = step;
                while low < most && f(low) * f(low + step) > 0.0 {
                    low += step;
                }
                let mut high = low + step;
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if f(low) * f(middle) > 0.0 { low = middle } else { high = middle }
                }
                low
            };
            let wanted = first(true).min(first(false));
            let beam = Beam::uniform(l, ei).with_shear_stiffness(shear);
            let model = Model::new(beam, Foundation::winkler(k))
                .with_load(Load::uniform_force(0.0, l, 0.7));
            near(critical(&compressed(&model, 0.1 * wanted)), wanted, 1e-8);
            let (solution, found) = local(&compressed(&model, 0.75 * wanted));
            near(found.stability_margin, 0.25, 1e-8);
            near(solution.value(Field::Deflection, 0.3 * l), 0.7 / k, 1e-11);
        }
    }
}

fn with_lift_off() -> Vec<Model> {
    let beam = |l: f64| Model::new(Beam::uniform(l, 1.0), Foundation::pasternak(1.0, 0.3));
    vec![
        beam(5.0)
            .with_load(Load::uniform_force(0.0, 5.0, 1.0))
            .with_load(Load::point_force(2.0, 3.0)),
        beam(10.0)
            .with_load(Load::uniform_force(0.0, 10.0, 1.0))
            .with_load(Load::point_moment(3.0, 2.0)),
        beam(12.0)
            .with_load(Load::uniform_force(0.0, 12.0, 0.3))
            .with_gap(0.0, 0.0)
            .with_gap(4.8, 0.0)
            .with_gap(6.0, -0.2)
            .with_gap(7.2, 0.0),
    ]
}

/// With increasing shear stiffness S the path approaches the path of the beam without shear deformation. The
/// error is proportional to 1/S.
#[test]
fn large_shear_stiffness_approaches_the_path_of_bending() {
    for model in with_lift_off() {
        let wanted = critical(&compressed(&model, 0.1));
        let (plain, margin) = local(&compressed(&model, 0.6 * wanted));
        let mut last = f64::INFINITY;
        for power in [3, 5, 7] {
            let mut stiff = compressed(&model, 0.6 * wanted);
            stiff.beam.shear_stiffness = Some(10_f64.powi(power));
            let (solution, found) = local(&stiff);
            let error = (found.critical_compression / wanted - 1.0).abs();
            assert!(error < 0.02 * last, "{error:e} {last:e}");
            last = error;
            let off = found.stability_margin - margin.stability_margin;
            assert!(off.abs() < 10.0 * 10_f64.powi(-power), "{off:e}");
            let x = 0.37 * model.beam.length;
            let [a, b] = [&solution, &plain].map(|s| s.value(Field::Deflection, x));
            assert!((a - b).abs() < 30.0 * 10_f64.powi(-power), "{a} {b}");
        }
    }
}

/// The simplest elements find the same local equilibria.
#[test]
fn linear_elements_find_the_same_local_equilibria() {
    for mut model in with_lift_off() {
        model.beam.shear_stiffness = Some(4.0);
        let wanted = critical(&compressed(&model, 0.1));
        for part in [0.3, 0.7, 0.9] {
            let pushed = compressed(&model, part * wanted);
            let (solution, _) = local(&pushed);
            let errors = [400, 1600].map(|elements| {
                let mesh = Linear::solve(&pushed, elements);
                let errors = mesh.w.iter().enumerate().map(|(i, w)| {
                    let x = model.beam.length * i as f64 / elements as f64;
                    (solution.value(Field::Deflection, x) - w).abs()
                });
                errors.fold(0.0, f64::max)
            });
            let [coarse, fine] = errors;
            assert!(fine < 2e-4 && fine < 0.3 * coarse + 1e-6, "{part}: {errors:?}");
        }
    }
}

/// Bearings and hold-downs along a heavy beam, rigid and elastic. Some lose contact, others gain it along the path.
fn on_bearings() -> Vec<Model> {
    let beam = |l: f64| {
        Model::new(Beam::uniform(l, 1.0), Foundation::winkler(1.0))
            .with_load(Load::uniform_force(0.0, l, 1.0))
    };
    vec![
        // A bearing that loses contact as the beam rises.
        beam(10.0)
            .with_load(Load::point_moment(3.0, 2.0))
            .with_support(Support::pinned(1.25).settled(0.65).acting(Acts::Up)),
        // A hold-down above the hump, reached along the path.
        beam(12.0)
            .with_gap(0.0, 0.0)
            .with_gap(5.0, 0.0)
            .with_gap(6.0, -0.4)
            .with_gap(7.5, 0.0)
            .with_support(Support::pinned(6.0).settled(0.81).acting(Acts::Down)),
        // The same with an elastic hold-down, and a bearing.
        beam(12.0)
            .with_gap(0.0, 0.0)
            .with_gap(5.0, 0.0)
            .with_gap(6.0, -0.4)
            .with_gap(7.5, 0.0)
            .with_support(Support::spring(6.0, 3.0, 0.0).settled(0.81).acting(Acts::Down))
            .with_support(Support::spring(3.0, 2.0, 0.0).settled(1.03).acting(Acts::Up)),
        // A pipe over a prop that only pushes up, and a pipe with a force that lifts its end off a bearing.
        beam(16.0).with_support(Support::pinned(8.0).settled(-0.6).acting(Acts::Up)),
        beam(8.0)
            .with_load(Load::point_force(6.0, 4.0))
            .with_support(Support::pinned(0.0).settled(1.0).acting(Acts::Up))
            .with_support(Support::pinned(8.0).settled(1.1).acting(Acts::Up)),
    ]
}

/// Compares with a mesh by brute force, with one-way springs as supports: its path, its states, and its second
/// variation with the active supports.
#[test]
fn a_mesh_follows_the_same_path_on_one_way_supports() {
    let mut changed = 0;
    for (number, model) in on_bearings().into_iter().enumerate() {
        let wanted = critical(&compressed(&model, 0.1));
        let (coarse, fine) = (Meshed::new(&model, 480), Meshed::new(&model, 960));
        let step = 0.01 * wanted;
        let [a, b] =
            [&coarse, &fine].map(|mesh| mesh.critical_compression(step).expect("a branch"));
        near(b, wanted, 3e-3);
        near(b + (b - a) / 3.0, wanted, 1e-3);
        let mut before: Option<Vec<bool>> = None;
        for part in [0.05, 0.3, 0.7, 0.95, 0.99] {
            let compression = part * wanted;
            let (solution, found) = local(&compressed(&model, compression));
            near(found.critical_compression, wanted, 1e-8);
            let touches = |x: f64| solution.contact().iter().any(|c| c.from <= x && x <= c.to);
            let acts: Vec<bool> = solution.reactions().iter().map(|r| r.force != 0.0).collect();
            changed += usize::from(before.is_some_and(|before| before != acts));
            let buckling = compression / (1.0 - found.stability_margin);
            let stable = |part: f64| fine.is_stable(part * buckling, touches, |i| acts[i]);
            assert!(stable(0.995) && !stable(1.005), "{number} {part}: {buckling}");
            let w = fine.branch(compression, 50).expect("a state");
            let largest = w.iter().step_by(2).fold(0.0, |m: f64, w| m.max(w.abs()));
            for (i, w) in w.iter().step_by(2).enumerate() {
                let x = model.beam.length * i as f64 / 960.0;
                let here = solution.value(Field::Deflection, x);
                assert!((here - w).abs() < 5e-3 * largest, "{number} {part} {x}: {here} {w}");
            }
            before = Some(acts);
        }
    }
    assert!(changed >= 2, "{changed}");
}

/// A beam on bearings without reaction behaves like a beam without them: a bearing does not prevent lifting.
#[test]
fn a_bearing_does_not_prevent_lifting_under_compression() {
    let column = Model::new(Beam::uniform(2.0, 3.0), Foundation::winkler(1.0))
        .with_gap(0.0, 1.0)
        .with_gap(2.0, 1.0)
        .with_support(Support::pinned(0.0))
        .with_support(Support::pinned(2.0))
        .with_load(Load::uniform_force(0.0, 2.0, 0.1));
    let euler = 3.0 * PI * PI / 4.0;
    near(own_buckling_load(&column), euler, 1e-11);
    // With a bearing at midspan that carries weight: the second mode, in which the beam keeps its contact there.
    let on_a_bearing = column.clone().with_support(Support::pinned(1.0).acting(Acts::Up));
    near(critical(&compressed(&on_a_bearing, 1.01 * euler)), 4.0 * euler, 1e-8);
    // A hold-down there is inactive, because the weight moves the beam away from it.
    let under_a_strap = column.with_support(Support::pinned(1.0).acting(Acts::Down));
    let found = critical(&compressed(&under_a_strap, 1.01 * euler));
    assert!(found < 1.2 * euler, "{found}");
}

/// Random beams with shear deformation, with one-way supports, hinges, loads on the ground and other
/// features.
#[test]
fn random_beams_with_shear_and_one_way_supports_are_stable_along_their_path() {
    let (mut sheared, mut borne) = (0, 0);
    for number in 0..24_u64 {
        let model = random::model(Family::CompressedToo, number);
        let compression = -model.beam.axial_force;
        let (solution, found) = local(&model);
        let Local { stability_margin: margin, critical_compression: end } = found;
        assert!(margin > 0.0 && margin <= 1.0 && end > compression, "{number}: {found:?}");
        assert!(solution.certificate().relative_gap() <= 1e-9, "{number}");
        sheared += usize::from(model.beam.shears());
        borne += usize::from(model.supports.iter().any(|support| support.acts != Acts::Both));
        if number % 8 > 0 {
            continue;
        }
        let (_, seen) = local(&model.mirrored());
        near(seen.critical_compression, end, 1e-6);
        near(critical(&compressed(&model, 1.001 * end)), end, 1e-6);
    }
    assert!(sheared > 8 && borne > 8, "{sheared} {borne}");
}
