//! Compares compression that the ground helps to carry with closed forms and with a mesh by brute force.
//!
//! Claims: `docs/existence.md`.

use groundbeam::{
    Beam, Field, Foundation, Load, Model, Outcome, Solution, Support, Verdict, existence::Local,
    exists, own_buckling_load, solution::Side, solve,
};
use groundbeam_verification::random::{self, Family};
use groundbeam_verification::upheaval::Meshed;

pub fn compressed(model: &Model, compression: f64) -> Model {
    let mut model = model.clone();
    model.beam.axial_force = -compression;
    model
}

/// The compression at which the path that starts without compression ends.
pub fn critical(model: &Model) -> f64 {
    match exists(model).expect("a verdict").verdict {
        Verdict::Local(local) => local.critical_compression,
        Verdict::Buckles(mode) => mode.critical_compression,
        other => panic!("{other:?}"),
    }
}

pub fn local(model: &Model) -> (Solution, Local) {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => match solution.existence().verdict {
            Verdict::Local(local) => (*solution, local),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    }
}

#[track_caller]
pub fn near(found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() <= tolerance, "{found} {wanted}");
}

/// The smallest positive root of a continuous function that first changes its sign there.
fn first_root(f: impl Fn(f64) -> f64, step: f64) -> f64 {
    let mut low = step;
    while f(low) * f(low + step) > 0.0 {
        low += step;
    }
    let mut high = low + step;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(low) * f(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

/// A heavy beam between pins, supported by the ground at the same height: w = 0. Timoshenko and Gere, Theory of Elastic
/// Stability (1961), section 2.10: P = min (m²π²EI/l² + k l²/(m²π²)), and the shear layer's μ beside it.
#[test]
fn pinned_beams_buckle_at_the_load_of_timoshenko() {
    let (ei, k, q) = (2.0, 3.0, 0.7);
    for (l, mu) in [(2.0, 0.0), (3.0, 0.4), (6.0, 0.0), (11.0, 5.0), (30.0, 0.1)] {
        let mut model = Model::new(Beam::uniform(l, ei), Foundation::pasternak(k, mu))
            .with_load(Load::uniform_force(0.0, l, q))
            .with_support(Support::pinned(0.0))
            .with_support(Support::pinned(l))
            .with_gap(0.0, -q / k)
            .with_gap(l, -q / k);
        let wave = |m: u32| {
            let r = (f64::from(m) * std::f64::consts::PI / l).powi(2);
            ei * r + k / r + mu
        };
        let wanted = (1..50).map(wave).fold(f64::INFINITY, f64::min);
        let own = own_buckling_load(&model);
        assert!(own < wanted);
        near(critical(&compressed(&model, 1.01 * own)), wanted, 1e-9);
        near(critical(&compressed(&model, 3.0 * wanted)), wanted, 1e-9);
        let (solution, found) = local(&compressed(&model, 0.5 * (own + wanted)));
        near(found.stability_margin, 0.5 - 0.5 * own / wanted, 1e-9);
        assert!(solution.range(Field::Deflection).max.value < 1e-9 * q / k);
        // The limit for an infinite beam: 2√(kEI) + μ.
        if l == 30.0 {
            near(wanted, 2.0 * (k * ei).sqrt() + mu, 4e-3);
        }
        // Below its own buckling load the beam has a unique equilibrium.
        model.beam.axial_force = -0.99 * own;
        assert_eq!(exists(&model).expect("a verdict").verdict, Verdict::Unique);
    }
}

/// Free beams under their weight on Winkler ground: with w = cosh αx cos βx and sinh αx sin βx for the even modes, cosh
/// αx sin βx and sinh αx cos βx for the odd ones, where α² = √(k/4EI) − P/4EI and β² = √(k/4EI) + P/4EI, and w″ = 0, EI
/// w‴ + P w′ = 0 at both ends (Hetényi, Beams on Elastic Foundation, 1946, chapter 7).
#[test]
fn free_beams_buckle_at_the_load_of_hetenyi() {
    let (ei, k) = (2.0, 3.0_f64);
    for l in [0.5, 2.0, 4.0, 7.0, 15.0] {
        let a = 0.5 * l;
        let determinant = |p: f64, odd: bool| {
            let root = (k / (4.0 * ei)).sqrt();
            let (alpha, beta) = ((root - 0.25 * p / ei).sqrt(), (root + 0.25 * p / ei).sqrt());
            // The real and imaginary parts of cosh or sinh of (α + iβ)x, differentiated in the complex plane.
            let (ca, sa) = ((alpha * a).cosh(), (alpha * a).sinh());
            let (cb, sb) = ((beta * a).cos(), (beta * a).sin());
            let cosh = [ca * cb, sa * sb];
            let sinh = [sa * cb, ca * sb];
            let times = |z: [f64; 2]| [alpha * z[0] - beta * z[1], alpha * z[1] + beta * z[0]];
            let [even, uneven] = if odd { [sinh, cosh] } else { [cosh, sinh] };
            let first = times(uneven);
            let second = times(times(even));
            let third = times(times(times(uneven)));
            let force = [0, 1].map(|i| ei * third[i] + p * first[i]);
            (second[0] * force[1] - second[1] * force[0]) / (ca * ca)
        };
        let most = 2.0 * (k * ei).sqrt();
        let root = |odd: bool| first_root(|p| determinant(p, odd), most / 4096.0);
        let wanted = root(true).min(root(false));
        let model = Model::new(Beam::uniform(l, ei), Foundation::winkler(k))
            .with_load(Load::uniform_force(0.0, l, 0.7));
        near(critical(&compressed(&model, 0.1 * wanted)), wanted, 1e-8);
        let (solution, found) = local(&compressed(&model, 0.75 * wanted));
        near(found.stability_margin, 0.25, 1e-8);
        near(solution.value(Field::Deflection, 0.3 * l), 0.7 / k, 1e-11);
        // A stiff beam rotates as a whole: k l²/12. A long one buckles at its end: √(kEI).
        if l == 0.5 {
            near(wanted, k * l * l / 12.0, 1e-3);
        }
        if l == 15.0 {
            near(wanted, (k * ei).sqrt(), 1e-3);
        }
    }
}

/// Hobbs, In-service buckling of heated pipelines, Journal of Transportation Engineering 110 (1984): a heavy beam
/// lifted off a rigid bed over L has tan(nL/2) = nL/2 with n² = P/EI, so PL²/EI = 80.76, and the height 2.408·10⁻³
/// qL⁴/EI. A prop of this height under the beam just loses its contact force. Then nothing restrains the beam any more,
/// and P = 3.962 √(qEI/h) is the largest compression of a propped beam.
#[test]
fn upheaval_over_a_prop_agrees_with_hobbs() {
    let half = first_root(|z| z * z.cos() - z.sin(), 1.0);
    let parameter = 4.0 * half * half;
    assert!((parameter - 80.76).abs() < 5e-3, "{parameter}");
    let height = half * half / 2.0 + 1.0 - half.cos() - half * half.sin();
    assert!((height / (parameter * parameter) - 2.408e-3).abs() < 2e-6);
    let (ei, q, h) = (2.0, 3.0_f64, 0.5);
    let wanted = (height * q * ei / h).sqrt();
    let lifted = (parameter * ei / wanted).sqrt();
    let l = 4.0 * lifted;
    let prop = 1e-3 * lifted;
    let mut errors = Vec::new();
    for stiffness in [1e2, 1e3, 1e4, 1e5, 1e6] {
        let model = Model::new(Beam::uniform(l, ei), Foundation::winkler(stiffness * q / h))
            .with_load(Load::uniform_force(0.0, l, q))
            .with_gap(0.5 * l - prop, 0.0)
            .with_gap(0.5 * l, -h)
            .with_gap(0.5 * l + prop, 0.0);
        let found = critical(&compressed(&model, 0.8 * wanted));
        errors.push((found / wanted - 1.0).abs());
        if stiffness == 1e6 {
            let (solution, _) = local(&compressed(&model, 0.999_999 * found));
            let lift: f64 = solution.lift_off().iter().map(|lift| lift.to - lift.from).sum();
            near(lift, lifted, 2e-2);
            near(-solution.value(Field::Deflection, 0.5 * l), h, 1e-3);
        }
    }
    assert!(errors.windows(2).all(|pair| pair[1] < 0.6 * pair[0]), "{errors:?}");
    assert!(errors[3] < 2e-3, "{errors:?}");
}

fn with_lift_off() -> Vec<Model> {
    let beam = |l: f64| Model::new(Beam::uniform(l, 1.0), Foundation::winkler(1.0));
    vec![
        beam(5.0)
            .with_load(Load::uniform_force(0.0, 5.0, 1.0))
            .with_load(Load::point_force(2.0, 3.0)),
        beam(10.0)
            .with_load(Load::uniform_force(0.0, 10.0, 1.0))
            .with_load(Load::point_moment(3.0, 2.0)),
        beam(12.0)
            .with_load(Load::uniform_force(0.0, 12.0, 0.3))
            .with_load(Load::point_force(6.0, 1.0)),
        beam(12.0)
            .with_load(Load::uniform_force(0.0, 12.0, 0.3))
            .with_gap(0.0, 0.0)
            .with_gap(5.0, 0.0)
            .with_gap(6.0, -0.2)
            .with_gap(7.5, 0.0),
        beam(8.0)
            .with_load(Load::point_force(2.0, 1.0))
            .with_load(Load::point_force(6.0, 1.0))
            .with_load(Load::point_force(4.0, -0.2)),
    ]
}

/// Compares with a mesh by brute force: its path, its deflections, and its second variation with the computed contact.
#[test]
fn a_mesh_follows_the_same_path_under_compression() {
    for model in with_lift_off() {
        let wanted = critical(&compressed(&model, 0.1));
        let (coarse, fine) = (Meshed::new(&model, 480), Meshed::new(&model, 960));
        let step = 0.01 * wanted;
        let [a, b] =
            [&coarse, &fine].map(|mesh| mesh.critical_compression(step).expect("a branch"));
        near(b, wanted, 3e-3);
        near(b + (b - a) / 3.0, wanted, 3e-4);
        for part in [0.3, 0.7, 0.95] {
            let compression = part * wanted;
            let (solution, found) = local(&compressed(&model, compression));
            near(found.critical_compression, wanted, 1e-8);
            let touches = |x: f64| solution.contact().iter().any(|c| c.from <= x && x <= c.to);
            let buckling = compression / (1.0 - found.stability_margin);
            assert!(fine.is_stable(0.997 * buckling, touches, |_| false), "{buckling}");
            assert!(!fine.is_stable(1.003 * buckling, touches, |_| false), "{buckling}");
            let w = fine.branch(compression, 50).expect("a state");
            let largest = w.iter().step_by(2).fold(0.0, |m: f64, w| m.max(w.abs()));
            for (i, w) in w.iter().step_by(2).enumerate() {
                let x = model.beam.length * i as f64 / 960.0;
                let here = solution.value(Field::Deflection, x);
                assert!((here - w).abs() < 3e-3 * largest, "{part} {x}: {here} {w}");
            }
        }
    }
}

/// Along the path the energy changes by ½∫w′² times the change of P, because the state is in equilibrium.
#[test]
fn the_energy_changes_with_the_shortening_along_the_path() {
    for model in with_lift_off() {
        let wanted = critical(&compressed(&model, 0.1));
        for part in [0.2, 0.6, 0.9] {
            let energy = |compression: f64| {
                let (solution, _) = local(&compressed(&model, compression));
                solution.certificate().primal_energy()
            };
            let (p, step) = (part * wanted, 1e-4 * wanted);
            let found = (energy(p - step) - energy(p + step)) / (2.0 * step);
            let (solution, _) = local(&compressed(&model, p));
            let (n, l) = (4000, model.beam.length);
            // Simpson's rule, from either side.
            let slope = |i: usize, side| solution.at(l * i as f64 / n as f64, side).slope.powi(2);
            let all: f64 = (0..n / 2)
                .map(|i| {
                    let i = 2 * i;
                    slope(i, Side::Right)
                        + 4.0 * slope(i + 1, Side::Left)
                        + slope(i + 2, Side::Left)
                })
                .sum();
            near(found, 0.5 * all * l / (3.0 * n as f64), 1e-4);
        }
    }
}

#[test]
fn unrestrained_beams_buckle_under_any_compression() {
    let beam = Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0));
    let over_the_end = beam.clone().with_load(Load::point_force(0.0, 1.0));
    let unloaded = beam.clone();
    for model in [over_the_end, unloaded] {
        let Verdict::Buckles(mode) = exists(&compressed(&model, 1e-3)).expect("a verdict").verdict
        else {
            panic!("it stands")
        };
        assert_eq!(mode.critical_compression, 0.0);
    }
    let tips = beam.with_load(Load::point_force(3.0, 1.0)).with_load(Load::point_moment(1.0, 2.0));
    let found = exists(&compressed(&tips, 1e-3)).expect("a verdict").verdict;
    assert!(matches!(found, Verdict::None(motion) if motion.left == -1.0), "{found:?}");
}

/// The largest difference of two beams' deflections, relative to the largest deflection.
fn apart(a: &Solution, b: &Solution, place: impl Fn(f64) -> f64) -> f64 {
    let l = a.model().beam.length;
    let size = |s: &Solution| {
        let range = s.range(Field::Deflection);
        range.min.value.abs().max(range.max.value.abs())
    };
    let difference = |i: u32| {
        let x = l * f64::from(i) / 64.0;
        (a.value(Field::Deflection, x) - b.value(Field::Deflection, place(x))).abs()
    };
    (0..=64).map(difference).fold(0.0, f64::max) / size(a)
}

/// For two hundred models: the solution is a stable equilibrium of its path, the mirrored and the scaled
/// model give the same result, a slightly larger compression gives a neighbouring solution, and an existence
/// check beyond the end of the path finds the same end.
#[test]
fn random_models_under_compression_are_stable_along_their_path() {
    for number in 0..200_u64 {
        let model = random::model(Family::Compressed, number);
        let compression = -model.beam.axial_force;
        let Ok(Outcome::Equilibrium(solution)) = solve(&model) else { panic!("{number}") };
        let Verdict::Local(found) = solution.existence().verdict else { panic!("{number}") };
        let Local { stability_margin: margin, critical_compression: end } = found;
        assert!(margin > 0.0 && margin <= 1.0 && end > compression, "{number}: {found:?}");
        assert!(solution.certificate().relative_gap() <= 1e-9, "{number}");
        // The other checks cost more than the solve.
        if number % 8 > 0 {
            continue;
        }
        let rounding = 1e-9 / (margin * margin);
        let l = model.beam.length;
        let (mirrored, seen) = local(&model.mirrored());
        assert!(
            (seen.critical_compression / end - 1.0).abs() < 1e-6,
            "{number}: {found:?} {seen:?}"
        );
        assert!(apart(&solution, &mirrored, |x| l - x) < rounding, "{number} {margin}");
        if model.gap.is_empty() {
            let mut larger = model.clone();
            larger.loads.iter_mut().for_each(|load| *load = load.scaled(8.0));
            let (larger, same) = local(&larger);
            assert_eq!(same, found, "{number}");
            for i in 0..=16 {
                let x = l * f64::from(i) / 16.0;
                let [a, b] = [&solution, &larger].map(|s| s.value(Field::Deflection, x));
                assert_eq!((8.0 * a).to_bits(), b.to_bits(), "{number}");
            }
        }
        let more = (1e-7 * compression).min(1e-3 * (end - compression));
        let (next, _) = local(&compressed(&model, compression + more));
        // dw/dP is at most 1/margin times the effect of the compression on the undisturbed beam.
        let moved = apart(&solution, &next, |x| x);
        let relative = more / compression;
        assert!(moved <= 10.0 * relative / margin + rounding, "{number} {moved} {margin}");
        let beyond = match exists(&compressed(&model, 1.001 * end)).expect("a verdict").verdict {
            Verdict::Buckles(mode) => mode.critical_compression,
            other => panic!("{number}: {other:?}"),
        };
        assert!((beyond / end - 1.0).abs() < 1e-6, "{number}: {beyond} {end}");
    }
}
