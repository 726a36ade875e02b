//! Compares the computed energies of claimed solutions with numerical integrals.

#![cfg(test)]

use super::{Energies, Series};
use crate::answer::Answer;
use crate::fields::Fields;
use crate::given::frame;
use crate::model::{Course, Model};
use crate::polynomial::{HIGHEST_COURSE, Polynomial};
use crate::random::numbers;
use crate::read::read_model;
use serde_json::{Value, json};

/// Integrates a function over −1 ≤ t ≤ 1 by the midpoint rule.
fn integral(of: impl Fn(f64) -> f64) -> f64 {
    (0..20_000).map(|i| of(-1.0 + (f64::from(i) + 0.5) / 10_000.0) / 10_000.0).sum()
}

#[test]
fn products_are_integrated_and_differentiated() {
    let mut random = numbers();
    let mut polynomial =
        |degree: usize| <Polynomial<f64>>::from_coefficients((0..=degree).map(|_| random()));
    for degrees in [[0, 0], [3, 4], [7, 2], [12, 12], [25, 25]] {
        let [f, g] = degrees.map(&mut polynomial);
        let course = polynomial(HIGHEST_COURSE);
        let [a, b] = [&f, &g].map(Series::of);
        let product = integral(|t| f.value(t) * g.value(t));
        assert!((a.times(&b) - product).abs() < 1e-6, "{degrees:?}");
        let weighted = integral(|t| course.value(t) * f.value(t) * g.value(t));
        assert!((a.product(&course).times(&b) - weighted).abs() < 1e-6, "{degrees:?}");
        let slope = Series::of(&f.derivative_times(2.0));
        assert!(slope.less(&a.derivative(0.5)).times(&slope).abs() < 1e-10, "{degrees:?}");
        assert!(a.less(&a).times(&a).abs() < 1e-15);
    }
}

/// Integrates a function from a to b by Simpson's rule.
fn along([a, b]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let h = (b - a) / 2000.0;
    let part = |i: u32| {
        let x = a + 2.0 * h * f64::from(i);
        h / 3.0 * (of(x) + 4.0 * of(x + h) + of(x + 2.0 * h))
    };
    (0..1000).map(part).sum()
}

/// Returns a model in which k and μ vary linearly along the segments of the ground. A file cannot contain a load on
/// such ground.
fn model(text: &str, ground: [[f64; 2]; 2]) -> Model<f64> {
    let mut model = read_model::<f64>(text, None).expect("a model");
    for segment in &mut model.ground.segments {
        let [spring, shear] = ground.map(|ends| Course::Varying(ends.to_vec()));
        (segment.spring, segment.shear) = (spring, shear);
    }
    model
}

/// Checks the energies of a document. `strain` is twice the elastic energy, `curled` is ∫EIκ₀², `axial` is ∫Pw′², and
/// `work` is the work of the loads.
fn agree(model: &Model<f64>, document: &Value, [strain, curled, axial, work]: [f64; 4]) {
    let answer = Answer::from_json(&document.to_string()).expect("an answer");
    let frame = frame(model, &answer, Some(0.5), &[]).expect("a frame");
    let found = Energies::of(&Fields::of(&frame).expect("fields"));
    for (found, exact) in [
        (found.strain, 0.5 * (strain + curled + f64::abs(axial))),
        (found.potential, 0.5 * (strain + axial) - work),
    ] {
        let found = frame.units.restored(found, 1, 1);
        assert!((found / exact - 1.0).abs() < 1e-10, "{found} {exact}");
    }
}

/// Checks a beam that touches ground with a shear layer along its whole length, with every kind of load and support.
#[test]
fn the_energies_of_a_beam_in_contact_are_integrals() {
    let text = "[beam]\nlength = 2\nEI = 3\naxial_force = 0.5\n[[beam.segment]]\nfrom = 1\nto = 2\nEI = [2, 4]\n\
        [foundation]\nk = 2\nmu = 1.5\nright = { ends = 2, as = 'free' }\n\
        [[foundation.segment]]\nfrom = 1\nto = 2\nk = 1\n\
        [[gap]]\nat = 0\nvalue = 0.1\n[[gap]]\nat = 2\nvalue = 0.3\n\
        [[load]]\ndistributed = [3, 1]\n[[load]]\ndistributed_moment = [0.5, 2]\n\
        [[load]]\ncurvature = 0.25\nfrom = 0\nto = 1\n[[load]]\npoint = 5\nat = 1\n[[load]]\nmoment = 2\nat = 2\n\
        [[ground_load]]\ndistributed = [0.2, 0.6]\nfrom = 0\nto = 2\n[[ground_load]]\npoint = 0.75\nat = 1\n\
        [[ground_load]]\ndistributed = [0.3, 0.9]\nfrom = 0\nto = 2\n\
        [[ground_load]]\npoint = 3\nat = -1\n[[hinge]]\nat = 1\nrotational_spring = 2\n\
        [[support]]\nat = 0\nspring = 4\nrotational_spring = 3\nsettlement = 0.05\n\
        [[support]]\nat = 2\nspring = 6\nacts = 'up'\nsettlement = 0.2\n";
    // The deflection is w = 1 + 0.3x − 0.2x² on the left of the hinge, and w = 1.1 − 0.4(x − 1) + 0.2(x − 1)³ on
    // its right.
    let document = json!({
        "pieces": [
            {"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1.1, 0.05, -0.05]},
            {"x": [1, 2], "half": 0.5, "touches": true, "deflection": [0.925, -0.125, 0.075, 0.025]},
        ],
        "reactions": [{"support": 0, "force": 0}, {"support": 1, "force": 1}],
    });
    let right = |x: f64| x >= 1.0;
    let w = |x: f64| match right(x) {
        false => 1.0 + 0.3 * x - 0.2 * x * x,
        true => 1.1 - 0.4 * (x - 1.0) + 0.2 * (x - 1.0).powi(3),
    };
    let slope = |x: f64| if right(x) { -0.4 + 0.6 * (x - 1.0).powi(2) } else { 0.3 - 0.4 * x };
    let bent = |x: f64| if right(x) { 1.2 * (x - 1.0) } else { -0.4 - 0.25 };
    let (u, turned) = (|x: f64| w(x) - 0.1 - 0.1 * x, |x: f64| slope(x) - 0.1);
    let linear = |x: f64, [a, b]: [f64; 2]| a + (b - a) * (x - 1.0);
    let bending = |x: f64| if right(x) { linear(x, [2.0, 4.0]) } else { 3.0 };
    let spring = |x: f64| if right(x) { linear(x, [1.0, 3.0]) } else { 2.0 };
    let shear = |x: f64| if right(x) { linear(x, [2.0, 1.0]) } else { 1.5 };
    let both = |of: &dyn Fn(f64) -> f64| along([0.0, 1.0 - 1e-15], of) + along([1.0, 2.0], of);
    let stored = |x: f64| {
        bending(x) * bent(x).powi(2) + spring(x) * u(x).powi(2) + shear(x) * turned(x).powi(2)
    };
    // The ground on the left of the beam has the stiffness K₀ = √(kμ) and the decay rate √(k/μ).
    let outside = 3.0_f64.sqrt() * u(0.0).powi(2);
    let pushed = 3.0 * (-(2.0_f64 / 1.5).sqrt()).exp();
    let springs = 4.0 * (w(0.0) - 0.05).powi(2) + 6.0 * (w(2.0) - 0.2).powi(2);
    let turning = 3.0 * 0.3 * 0.3 + 2.0 * (-0.4 - (0.3 - 0.4_f64)).powi(2);
    let strain = both(&stored) + springs + turning + outside;
    let loads = |x: f64| (3.0 - x) * w(x) + (0.5 + 0.75 * x) * slope(x) + (0.5 + 0.5 * x) * u(x);
    let work = both(&loads) + 5.0 * w(1.0) + 2.0 * slope(2.0) + 0.75 * u(1.0) + pushed * u(0.0);
    let axial = 0.5 * both(&|x| slope(x).powi(2));
    agree(
        &model(text, [[1.0, 3.0], [2.0, 1.0]]),
        &document,
        [strain, 3.0 * 0.25 * 0.25, axial, work],
    );
}

/// Checks the energies with contact up to x = 1. The ground ends at x = 2 and carries a distributed load and a point
/// force at x = 1.5.
#[test]
fn the_energies_of_open_ground_are_integrals() {
    let text = "[beam]\nlength = 2\nEI = 3\n[foundation]\nk = 2\nmu = 1.5\n\
        left = { ends = 0, as = 'free' }\nright = { ends = 2, as = 'free' }\n\
        [[gap]]\nat = 1\nvalue = 0\n[[gap]]\nat = 2\nvalue = 100\n\
        [[ground_load]]\ndistributed = [0.5, 1.5]\nfrom = 0\nto = 2\n[[ground_load]]\npoint = 0.75\nat = 1.5\n";
    let piece = |x: [f64; 2], touches: bool| {
        let half = 0.5 * (x[1] - x[0]);
        json!({"x": x, "half": half, "touches": touches, "deflection": [0.75]})
    };
    let document = json!({"pieces": [piece([0.0, 1.0], true), piece([1.0, 1.5], false), piece([1.5, 2.0], false)]});
    let (k, mu, force, b) = (2.0, 1.5, 0.75, (2.0_f64 / 1.5).sqrt());
    let (sinh, cosh) = ((0.5 * b).sinh(), (0.5 * b).cosh());
    let (free, rise) = (|x: f64| (0.5 + 0.5 * x) / k, 0.5 / k);
    // Out of contact, u = q/k + v, where q/k has the slope `rise`. v = a cosh b(x − 1) + d sinh b(x − 1) for x ≤ 1.5,
    // and v = c cosh b(2 − x) + (`rise`/b) sinh b(2 − x) for x ≥ 1.5.
    let a = 0.75 - free(1.0);
    let equations = [rise / b * sinh - a * cosh, force / (mu * b) - a * sinh - rise / b * cosh];
    let whole = sinh * sinh + cosh * cosh;
    let c = (sinh * equations[1] - cosh * equations[0]) / whole;
    let d = (sinh * equations[0] + cosh * equations[1]) / whole;
    let u = |x: f64| match x {
        _ if x <= 1.0 => [0.75, 0.0],
        _ if x <= 1.5 => {
            let (s, c) = ((b * (x - 1.0)).sinh(), (b * (x - 1.0)).cosh());
            [free(x) + a * c + d * s, rise + b * (a * s + d * c)]
        }
        _ => {
            let (s, h) = ((b * (2.0 - x)).sinh(), (b * (2.0 - x)).cosh());
            [free(x) + c * h + rise / b * s, rise - b * c * s - rise * h]
        }
    };
    let parts = [[0.0, 1.0], [1.0 + 1e-15, 1.5], [1.5 + 1e-15, 2.0]];
    let all = |of: &dyn Fn(f64) -> f64| parts.map(|part| along(part, of)).iter().sum::<f64>();
    let strain = all(&|x| k * u(x)[0].powi(2) + mu * u(x)[1].powi(2));
    let work = all(&|x| (0.5 + 0.5 * x) * u(x)[0]) + force * u(1.5)[0];
    agree(&model(text, [[1.0; 2]; 2]), &document, [strain, 0.0, 0.0, work]);
}

/// Checks the energies of loaded ground without contact: Winkler ground with u = q/k, and a shear layer with varying μ
/// and u = 1 + x under the load q = ku − μ′.
#[test]
fn the_energies_of_loaded_ground_apart_from_the_beam_are_integrals() {
    let beam = "[beam]\nlength = 2\nEI = 3\n[[gap]]\nat = 0\nvalue = 100\n";
    let flat = json!({"x": [0, 2], "half": 1, "touches": false, "deflection": [0], "open": [1, 3], "settlement": [2, 1]});
    let load = "[[ground_load]]\ndistributed = [0.5, 1.5]\nfrom = 0\nto = 2\n";
    let mut document = json!({"pieces": [flat]});
    let work = along([0.0, 2.0], |x| (0.5 + 0.5 * x).powi(2) / 2.0);
    agree(
        &model(&format!("{beam}{load}[foundation]\nk = 2\n"), [[1.0; 2], [1.0, 3.0]]),
        &document,
        [work, 0.0, 0.0, work],
    );
    let load = "[[ground_load]]\ndistributed = [0, 2]\nfrom = 0\nto = 2\n";
    let layer = "[foundation]\nk = 1\nmu = 1\n[[foundation.segment]]\nfrom = 0\nto = 2\nk = 1\n";
    let outside = 1.0 + 3.0_f64.sqrt() * 9.0;
    let strain = along([0.0, 2.0], |x| (1.0 + x).powi(2) + (1.0 + x)) + outside;
    let work = along([0.0, 2.0], |x| x * (1.0 + x));
    agree(
        &model(&format!("{beam}{load}{layer}"), [[1.0; 2], [1.0, 3.0]]),
        &document,
        [strain, 0.0, 0.0, work],
    );
    // With bending and shear deformation, the beam has the deflection w = 1 − x², the rotation φ = −x, the shear
    // stiffness S = 4 and the axial force P = −0.5 (compression).
    document["pieces"][0]["deflection"] = json!([0, -2, -1]);
    document["pieces"][0]["rotation"] = json!([-1, -1]);
    let beam = beam.replace("EI = 3", "EI = 3\nshear_stiffness = 4\naxial_force = -0.5");
    let bent = 3.0 * 2.0 + 4.0 * along([0.0, 2.0], |x| (x - 2.0 * x).powi(2));
    let axial = -0.5 * along([0.0, 2.0], |x| 4.0 * x * x);
    let moment = "[[load]]\ndistributed_moment = 3\n";
    let work = work + 3.0 * along([0.0, 2.0], |x| -x);
    agree(
        &model(&format!("{beam}{load}{layer}{moment}"), [[1.0; 2], [1.0, 3.0]]),
        &document,
        [strain + bent, 0.0, axial, work],
    );
}

/// Checks the energies of Winkler ground up to x = 1 and a loaded shear layer from 1 to 5. The beam touches the ground
/// up to 2, from 3 to 3.5 and at 4.5. A point force acts on the ground at 2.5.
#[test]
fn the_energies_of_a_layer_that_begins_under_the_beam_are_integrals() {
    let (k, mu, b) = (2.0, 0.5, 2.0_f64);
    let text = "[beam]\nlength = 5\nEI = 3\n[foundation]\nk = 2\nmu = 0.5\nright = { ends = 5, as = 'free' }\n\
        [[foundation.segment]]\nfrom = 0\nto = 1\nk = 2\nmu = 0\n\
        [[ground_load]]\ndistributed = [0.5, 0.9]\nfrom = 1\nto = 5\n[[ground_load]]\npoint = 0.75\nat = 2.5\n";
    let nodes = [0.0, 1.0, 2.0, 2.5, 3.0, 3.5, 4.5, 5.0];
    let touches = [true, true, false, false, true, false, false];
    let piece = |i: usize| {
        let x = [nodes[i], nodes[i + 1]];
        json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": touches[i], "deflection": [0.75]})
    };
    let pieces: Vec<Value> = (0..7).map(piece).collect();
    let document = json!({"pieces": pieces, "forces": [{"x": 4.5, "force": 1}]});
    let load = |x: f64| 0.5 + 0.1 * (x - 1.0);
    let rise = 0.1 / k;
    // `between` returns u and u′ at x on a stretch with given values of u at its ends.
    let between = |ends: [f64; 2], u: [f64; 2], x: f64| {
        let [left, right] = [u[0] - load(ends[0]) / k, u[1] - load(ends[1]) / k];
        let (far, near, whole) =
            (b * (ends[1] - x), b * (x - ends[0]), (b * (ends[1] - ends[0])).sinh());
        let slope = b * (right * near.cosh() - left * far.cosh()) / whole;
        [load(x) / k + (left * far.sinh() + right * near.sinh()) / whole, rise + slope]
    };
    // The force μu′ in the shear layer decreases by the point force on the ground at x = 2.5, and is zero at the
    // free end of the layer.
    let jump = |u: f64| {
        mu * (between([2.0, 2.5], [0.75, u], 2.5)[1] - between([2.5, 3.0], [u, 0.75], 2.5)[1])
    };
    let middle = (0.75 - jump(0.0)) / (jump(1.0) - jump(0.0));
    let flux = |u: f64| between([4.5, 5.0], [0.75, u], 5.0)[1];
    let last = -flux(0.0) / (flux(1.0) - flux(0.0));
    let mut strain = k * 0.75 * 0.75 * (1.0 + 1.0 + 0.5);
    let mut work = 0.75 * middle;
    for touched in [[1.0, 2.0], [3.0, 3.5]] {
        work += along(touched, |x| load(x) * 0.75);
    }
    for (ends, u) in [
        ([2.0, 2.5], [0.75, middle]),
        ([2.5, 3.0], [middle, 0.75]),
        ([3.5, 4.5], [0.75, 0.75]),
        ([4.5, 5.0], [0.75, last]),
    ] {
        let at = |x: f64| between(ends, u, x);
        strain += along(ends, |x| k * at(x)[0].powi(2) + mu * at(x)[1].powi(2));
        work += along(ends, |x| load(x) * at(x)[0]);
    }
    agree(&model(text, [[2.0; 2], [0.0; 2]]), &document, [strain, 0.0, 0.0, work]);
}

/// Checks the energies of a shear layer without contact, with loads below and beside the beam. The displacement at the
/// left end follows from the equilibrium of the right end.
#[test]
fn the_energies_of_a_loaded_layer_without_contact_are_integrals() {
    let text = "[beam]\nlength = 2\nEI = 3\n[foundation]\nk = 2\nmu = 0.5\n\
        [[gap]]\nat = 0\nvalue = 100\n[[ground_load]]\ndistributed = [0.5, 1.5]\nfrom = 0\nto = 2\n\
        [[ground_load]]\npoint = 0.75\nat = 1\n[[ground_load]]\npoint = 3\nat = -1\n\
        [[ground_load]]\npoint = 0.25\nat = 2\n[[ground_load]]\npoint = 2\nat = 2.5\n";
    let piece = |from: f64| json!({"x": [from, from + 1.0], "half": 0.5, "touches": false, "deflection": [0]});
    let document = json!({"pieces": [piece(0.0), piece(1.0)]});
    let (k, mu, b, outside) = (2.0, 0.5, 2.0_f64, 1.0);
    let pushed = [3.0 * (-b).exp(), 2.0 * (-0.5 * b).exp() + 0.25];
    let (load, rise) = (|x: f64| 0.5 + 0.5 * x, 0.5 / k);
    let onward = |from: f64, [u, slope]: [f64; 2], x: f64| {
        let (v, turn, z) = (u - load(from) / k, slope - rise, b * (x - from));
        [
            load(x) / k + v * z.cosh() + turn / b * z.sinh(),
            rise + v * b * z.sinh() + turn * z.cosh(),
        ]
    };
    let at = |left: f64, x: f64| {
        let first = [left, (outside * left - pushed[0]) / mu];
        if x <= 1.0 {
            return onward(0.0, first, x);
        }
        let [u, slope] = onward(0.0, first, 1.0);
        onward(1.0, [u, slope - 0.75 / mu], x)
    };
    let end = |left: f64| mu * at(left, 2.0)[1] + outside * at(left, 2.0)[0] - pushed[1];
    let left = -end(0.0) / (end(1.0) - end(0.0));
    let right = at(left, 2.0)[0];
    let both = |of: &dyn Fn(f64) -> f64| along([0.0, 1.0], of) + along([1.0 + 1e-15, 2.0], of);
    let strain = both(&|x| k * at(left, x)[0].powi(2) + mu * at(left, x)[1].powi(2));
    let work = both(&|x| load(x) * at(left, x)[0]) + 0.75 * at(left, 1.0)[0];
    let work = work + pushed[0] * left + pushed[1] * right;
    let strain = strain + outside * (left * left + right * right);
    agree(&model(text, [[0.0; 2]; 2]), &document, [strain, 0.0, 0.0, work]);
}

/// Checks the energies of two pieces out of contact with given ground displacements at their ends. On the second piece,
/// μ varies, and the displacement is the stored polynomial.
#[test]
fn the_energies_of_a_stored_surface_are_integrals() {
    let text = "[beam]\nlength = 2\nEI = 3\n[foundation]\nk = 2\nmu = 0.5\nleft = { ends = 0, as = 'free' }\n\
        right = { ends = 2, as = 'free' }\n[[foundation.segment]]\nfrom = 1\nto = 2\nk = 2\nmu = 0.5\n\
        [[gap]]\nat = 0\nvalue = 100\n[[ground_load]]\ndistributed = [0.5, 0.9]\nfrom = 0\nto = 2\n";
    let document = json!({"pieces": [
        {"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0], "open": [0.3, 0.4]},
        {"x": [1, 2], "half": 0.5, "touches": false, "deflection": [0], "open": [0.4, 0.5], "settlement": [0.45, 0.05]},
    ]});
    let (k, mu, b) = (2.0, 0.5, 2.0_f64);
    let load = |x: f64| 0.5 + 0.2 * x;
    let [left, right] = [0.3 - load(0.0) / k, 0.4 - load(1.0) / k];
    let u =
        |x: f64| load(x) / k + (left * (b * (1.0 - x)).sinh() + right * (b * x).sinh()) / b.sinh();
    let slope =
        |x: f64| 0.2 / k + b * (right * (b * x).cosh() - left * (b * (1.0 - x)).cosh()) / b.sinh();
    let stored = |x: f64| 0.4 + 0.1 * (x - 1.0);
    let even = along([0.0, 1.0], |x| k * u(x).powi(2) + mu * slope(x).powi(2));
    let [first, second] =
        [along([0.0, 1.0], |x| load(x) * u(x)), along([1.0, 2.0], |x| load(x) * stored(x))];
    let strain = even + (1.0 * 0.1 * 0.5 - 0.5 * 0.1 * 0.4) + second;
    agree(&model(text, [[2.0; 2], [0.5, 1.0]]), &document, [strain, 0.0, 0.0, first + second]);
}

/// Checks the bounds of the flexibility g of a shear layer of length L with free ends. With b = √(k/μ), g is largest at
/// the ends, where 1/g = √(kμ) tanh(bL).
#[test]
fn the_flexibility_of_a_free_layer_is_that_of_its_end() {
    let text = "[beam]\nlength = 2\nEI = 3\n[foundation]\nk = 2\nmu = 0.5\nright = { ends = 2, as = 'free' }\n\
        [[foundation.segment]]\nfrom = 0\nto = 0.75\nk = 2\nmu = 0\n";
    let model = read_model::<f64>(text, None).expect("a model");
    let nodes = [0.0, 0.75, 1.0, 1.25, 1.5, 2.0];
    let piece = |i: usize| {
        let x = [nodes[i], nodes[i + 1]];
        json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": false, "deflection": [0]})
    };
    let document = json!({"pieces": (0..5).map(piece).collect::<Vec<_>>()});
    let answer = Answer::from_json(&document.to_string()).expect("an answer");
    let frame = frame(&model, &answer, None, &[]).expect("a frame");
    let fields = Fields::of(&frame).expect("fields");
    assert_eq!(fields.surface.pieces[0].flexibility.value(), f64::INFINITY);
    let least = f64::tanh(2.0 * 1.25);
    for piece in &fields.surface.pieces[1..] {
        let stiffness = frame.units.restored(piece.flexibility.value().powi(-2), 1, -1);
        assert!((least * (1.0 - 1e-12)..1.6 * least).contains(&stiffness), "{stiffness} {least}");
    }
    let at_ends = [1, 4].map(|i| fields.surface.pieces[i].flexibility.value().powi(-2));
    let at_ends = at_ends.map(|stiffness| frame.units.restored(stiffness, 1, -1));
    assert!(at_ends.iter().all(|stiffness| stiffness / least < 1.0 + 1e-9), "{at_ends:?} {least}");
}
