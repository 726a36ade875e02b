//! Imposed curvature: curling slabs against closed forms, point moments in its place, and a dense method.

use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, Profile, Side, Solution, Support, solve};

fn solved(model: &Model) -> Solution {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} {b}: off by {:e}", (a - b).abs());
}

/// An even curvature is a pair of moments EI κ₀ at the ends of its stretch: the same deflection, and EI κ₀ more
/// of moment between them.
#[test]
fn a_curvature_is_a_pair_of_moments() {
    let foundations = [Foundation::pasternak(1.0, 0.3), Foundation::winkler(2.0)];
    for foundation in foundations {
        let plain = Model::new(Beam::uniform(6.0, 1.5), foundation)
            .with_load(Load::point(1.0, 2.0))
            .with_load(Load::uniform(0.4, 0.0, 6.0));
        let curled = solved(&plain.clone().with_load(Load::curvature(0.2, 1.0, 4.5)));
        let moments = plain.with_load(Load::moment(-0.3, 1.0)).with_load(Load::moment(0.3, 4.5));
        let bent = solved(&moments);
        for i in 0..=60 {
            let x = 0.1 * f64::from(i) + 1e-3;
            let [a, b] = [&curled, &bent].map(|s| s.at(x.min(6.0), Side::Right));
            for field in [Field::Deflection, Field::Slope, Field::Settlement, Field::ShearForce] {
                close(a.get(field), b.get(field), 1e-13);
            }
            let more = if (1.0..4.5).contains(&x) { 0.3 } else { 0.0 };
            close(a.moment, b.moment + more, 1e-13);
        }
        println!("{:?}", curled.certificate());
    }
    let _ = (Profile::constant(1.0), Support::pinned(0.0));
}
