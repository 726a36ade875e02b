//! Tests beams on supports above a gap that they do not close, in closed form: the bounds of reactions and fields cover the
//! errors of bent and shifted claims, and wrong claims about supports are refused.

use crate::one_document;
use groundbeam_proof::{Model, NotProven, Scalar, Verification, Wide, read_model, verify};
use serde_json::{Value, json};

/// A beam with EI = 1 above a gap of 100.
struct Case {
    name: &'static str,
    /// Length, loads, supports and hinges as the text of a model file.
    model: &'static str,
    /// The ends of the pieces.
    nodes: &'static [f64],
    /// The exact deflection on each piece, as coefficients of powers of x.
    exact: &'static [[f64; 5]],
    /// Force and moment of each support.
    reactions: &'static [[f64; 2]],
    /// An admissible change of the deflection: zero at rigid supports, without slope at clamps, smooth between hinges.
    change: &'static [[f64; 5]],
}

const TURNING: &str = "cantilever on a spring that resists force and rotation";
const ONE_WAY: &str = "beam on a one-way support and a one-way spring";

const CASES: [Case; 12] = [
    Case {
        name: "cantilever under a force",
        model: "length = 2\n[[load]]\npoint = 3\nat = 2\n[[support]]\nat = 0\ntype = 'fixed'\n",
        nodes: &[0.0, 2.0],
        exact: &[[0.0, 0.0, 3.0, -0.5, 0.0]],
        reactions: &[[3.0, -6.0]],
        change: &[[0.0, 0.0, 1.0, 0.25, 0.0]],
    },
    Case {
        name: "cantilever held at the right end",
        model: "length = 2\n[[load]]\ndistributed = 24\n[[support]]\nat = 2\ntype = 'fixed'\n",
        nodes: &[0.0, 2.0],
        exact: &[[48.0, -32.0, 0.0, 0.0, 1.0]],
        reactions: &[[48.0, 48.0]],
        change: &[[4.0, -4.0, 1.0, 0.0, 0.0]],
    },
    Case {
        name: "simple beam under end moments",
        model: "length = 1\n[[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 1\n\
                [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n",
        nodes: &[0.0, 1.0],
        exact: &[[0.0, 1.0, -1.0, 0.0, 0.0]],
        reactions: &[[0.0, 0.0], [0.0, 0.0]],
        change: &[[0.0, 1.0, 1.0, -2.0, 0.0]],
    },
    Case {
        // M = 2 and V = 0. The distributed load balances the axial force, f = −Pw″.
        name: "simple beam under end moments and tension",
        model: "length = 1\naxial_force = 3\n[[load]]\ndistributed = 6\n[[load]]\nmoment = 2\nat = 0\n\
                [[load]]\nmoment = -2\nat = 1\n\
                [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n",
        nodes: &[0.0, 1.0],
        exact: &[[0.0, 1.0, -1.0, 0.0, 0.0]],
        reactions: &[[3.0, 0.0], [3.0, 0.0]],
        change: &[[0.0, 1.0, 1.0, -2.0, 0.0]],
    },
    Case {
        name: "simple beam with shear deformation under end moments and compression",
        model: "length = 1\nshear_stiffness = 4\naxial_force = -1\n[[load]]\ndistributed = -2\n\
                [[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 1\n\
                [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n",
        nodes: &[0.0, 1.0],
        exact: &[[0.0, 1.0, -1.0, 0.0, 0.0]],
        reactions: &[[-1.0, 0.0], [-1.0, 0.0]],
        change: &[[0.0, 1.0, 1.0, -2.0, 0.0]],
    },
    Case {
        name: "beam clamped at both ends under a distributed load",
        model: "length = 1\n[[load]]\ndistributed = 24\n\
                [[support]]\nat = 0\ntype = 'fixed'\n[[support]]\nat = 1\ntype = 'fixed'\n",
        nodes: &[0.0, 1.0],
        exact: &[[0.0, 0.0, 1.0, -2.0, 1.0]],
        reactions: &[[12.0, -2.0], [12.0, 2.0]],
        change: &[[0.0, 0.0, 2.0, -4.0, 2.0]],
    },
    Case {
        name: "beam with an overhang",
        model: "length = 2\n[[load]]\npoint = 6\nat = 2\n\
                [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n",
        nodes: &[0.0, 1.0, 2.0],
        exact: &[[0.0, -1.0, 0.0, 1.0, 0.0], [2.0, -7.0, 6.0, -1.0, 0.0]],
        reactions: &[[-6.0, 0.0], [12.0, 0.0]],
        change: &[[0.0, -1.0, 1.0, 0.0, 0.0], [0.0, -1.0, 1.0, 0.0, 0.0]],
    },
    Case {
        name: "beam on two springs",
        model: "length = 2\n[[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 2\n[[load]]\npoint = 4\nat = 0\n\
                [[load]]\npoint = 2\nat = 2\n[[support]]\nat = 0\nspring = 4\n[[support]]\nat = 2\nspring = 1\n",
        nodes: &[0.0, 2.0],
        exact: &[[1.0, 2.5, -1.0, 0.0, 0.0]],
        reactions: &[[4.0, 0.0], [2.0, 0.0]],
        change: &[[1.0, -2.0, 0.5, 0.25, 0.0]],
    },
    Case {
        name: TURNING,
        model: "length = 1\n[[load]]\nmoment = 2\nat = 1\n[[load]]\npoint = 4\nat = 0\n\
                [[support]]\nat = 0\nspring = 4\nrotational_spring = 4\n",
        nodes: &[0.0, 1.0],
        exact: &[[1.0, 0.5, 1.0, 0.0, 0.0]],
        reactions: &[[4.0, -2.0]],
        change: &[[0.5, 1.0, -0.5, 1.0, 0.0]],
    },
    Case {
        name: "beam with an elastic hinge under end moments",
        model: "length = 2\n[[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 2\n[[hinge]]\nat = 1\n\
                rotational_spring = 4\n[[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 2\ntype = 'pinned'\n",
        nodes: &[0.0, 1.0, 2.0],
        exact: &[[0.0, 2.25, -1.0, 0.0, 0.0], [0.5, 1.75, -1.0, 0.0, 0.0]],
        reactions: &[[0.0, 0.0], [0.0, 0.0]],
        change: &[[0.0, 1.0, 1.0, 0.0, 0.0], [2.0, 1.0, -1.0, 0.0, 0.0]],
    },
    Case {
        name: "beam with a free hinge under a force",
        model: "length = 2\n[[load]]\npoint = 12\nat = 1\n[[hinge]]\nat = 1\n\
                [[support]]\nat = 0\ntype = 'fixed'\n[[support]]\nat = 2\ntype = 'pinned'\n",
        nodes: &[0.0, 1.0, 2.0],
        exact: &[[0.0, 0.0, 6.0, -2.0, 0.0], [8.0, -4.0, 0.0, 0.0, 0.0]],
        reactions: &[[12.0, -12.0], [0.0, 0.0]],
        change: &[[0.0, 0.0, 1.0, 0.0, 0.0], [0.0, 2.0, -1.0, 0.0, 0.0]],
    },
    Case {
        name: ONE_WAY,
        model: "length = 2\n[[load]]\npoint = 12\nat = 1\n[[support]]\nat = 0\ntype = 'pinned'\nacts = 'up'\n\
                [[support]]\nat = 2\nspring = 6\nacts = 'up'\n",
        nodes: &[0.0, 1.0, 2.0],
        exact: &[[0.0, 3.5, 0.0, -1.0, 0.0], [-2.0, 9.5, -6.0, 1.0, 0.0]],
        reactions: &[[6.0, 0.0], [6.0, 0.0]],
        change: &[[0.0, 1.0, -0.5, 0.0, 0.0], [0.0, 1.0, -0.5, 0.0, 0.0]],
    },
];

/// A derivative of a polynomial in x.
fn value(c: &[f64; 5], order: usize, x: f64) -> f64 {
    let factor = |j: usize| (j + 1 - order..=j).map(|n| n as f64).product::<f64>();
    (order..5).map(|j| factor(j) * c[j] * x.powi((j - order) as i32)).sum()
}

/// The coefficients in t of a polynomial in x.
fn in_t(c: &[f64; 5], [from, to]: [f64; 2]) -> Vec<f64> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let factorial = |n: usize| (1..=n).map(|j| j as f64).product::<f64>();
    (0..5).map(|n| value(c, n, middle) * half.powi(n as i32) / factorial(n)).collect()
}

fn verified(model: &Model<Wide>, document: &Value) -> Result<Verification, NotProven> {
    verify(model, &one_document::document(&document.to_string()))
}

impl Case {
    fn document(&self, epsilon: f64) -> Value {
        let pieces = self.nodes.windows(2).zip(self.exact).zip(self.change);
        let piece = |((ends, exact), change): ((&[f64], &[f64; 5]), &[f64; 5])| {
            let (ends, w) =
                ([ends[0], ends[1]], [0, 1, 2, 3, 4].map(|j| exact[j] + epsilon * change[j]));
            let half = 0.5 * (ends[1] - ends[0]);
            let mut piece =
                json!({"x": ends, "half": half, "touches": false, "deflection": in_t(&w, ends)});
            if self.model.contains("shear_stiffness") {
                let slope = [w[1], 2.0 * w[2], 3.0 * w[3], 4.0 * w[4], 0.0];
                piece["rotation"] = json!(in_t(&slope, ends));
            }
            piece
        };
        let reactions = self.reactions.iter().enumerate();
        let reaction = |(i, [force, moment]): (usize, &[f64; 2])| json!({"support": i, "force": force, "moment": moment});
        json!({
            "pieces": pieces.map(piece).collect::<Vec<_>>(),
            "forces": [],
            "contact": [],
            "reactions": reactions.map(reaction).collect::<Vec<_>>(),
        })
    }

    fn model(&self) -> Model<Wide> {
        let ground = "[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n";
        let text = format!("{ground}[beam]\nEI = 1\n{}", self.model);
        read_model(&text, None).unwrap_or_else(|why| panic!("{}: {why:?}", self.name))
    }

    fn verified(&self, document: &Value) -> Verification {
        verified(&self.model(), document).unwrap_or_else(|why| panic!("{}: {why}", self.name))
    }

    /// The largest absolute value of a derivative of the change.
    fn largest(&self, order: usize) -> f64 {
        let on = |(ends, c): (&[f64], &[f64; 5])| {
            let at = |n: u32| {
                value(c, order, ends[0] + (ends[1] - ends[0]) * f64::from(n) / 1000.0).abs()
            };
            (0..=1000).map(at).fold(0.0, f64::max)
        };
        self.nodes.windows(2).zip(self.change).map(on).fold(0.0, f64::max)
    }
}

#[test]
fn exact_answers_of_beams_on_supports_are_proven() {
    for case in &CASES {
        let found = case.verified(&case.document(0.0));
        assert_eq!(found.shortfall, None, "{}", case.name);
    }
}

#[test]
fn the_bounds_of_a_bent_beam_on_supports_cover_its_errors() {
    for case in &CASES {
        for epsilon in [1e-3, -1e-3] {
            let found = case.verified(&case.document(epsilon));
            let bounds = &found.proof.bounds;
            for (order, name, bound) in [
                (0, "deflection", bounds.deflection.error),
                (1, "slope", bounds.slope.error),
                (1, "rotation", bounds.rotation.error),
                (2, "moment", bounds.moment.error),
                (3, "shear force", bounds.shear_force.error),
            ] {
                let error = epsilon.abs() * case.largest(order);
                let most = if case.model.contains("axial_force") { 100.0 } else { 15.0 };
                let sharp = error == 0.0 || bound <= most * error;
                let what = format!("{}: {name} {error:e} {bound:e}", case.name);
                assert!(bound >= error * (1.0 - 1e-9) && sharp, "{what}");
            }
        }
    }
}

/// The energy of the error is ½∫(εz″)² + ½Σκ(εz)² + ½Σκ_θ(εz′)² + ½k_φ(ε[z′])².
#[test]
fn e_is_the_energy_of_the_error_of_a_beam_on_supports() {
    for case in &CASES {
        let epsilon = 1e-3;
        let found = case.verified(&case.document(epsilon));
        let pieces = case.nodes.windows(2).zip(case.change);
        let bent = |(ends, c): (&[f64], &[f64; 5])| {
            // Boole's rule is exact: z″ is at most quadratic.
            let h = 0.25 * (ends[1] - ends[0]);
            let square = |n: i32| value(c, 2, ends[0] + h * f64::from(n)).powi(2);
            let outer = 7.0 * (square(0) + square(4)) + 32.0 * (square(1) + square(3));
            2.0 * h / 45.0 * (outer + 12.0 * square(2))
        };
        let z = |order: usize, x: f64| {
            let piece = if x < case.nodes[1] { 0 } else { case.change.len() - 1 };
            value(&case.change[piece], order, x)
        };
        let springs = match case.name {
            "beam on two springs" => 4.0 * z(0, 0.0).powi(2) + z(0, 2.0).powi(2),
            TURNING => 4.0 * (z(0, 0.0).powi(2) + z(1, 0.0).powi(2)),
            "beam with an elastic hinge under end moments" => {
                4.0 * (value(&case.change[1], 1, 1.0) - value(&case.change[0], 1, 1.0)).powi(2)
            }
            ONE_WAY => 6.0 * z(0, 2.0).powi(2),
            _ => 0.0,
        };
        let exact = 0.5 * epsilon * epsilon * (pieces.map(bent).sum::<f64>() + springs);
        let ratio = found.proof.energy / exact;
        // The couple of the rotational spring has another lever in the balance, and E contains bounds of the work of the
        // axial force, so it is larger.
        let most = match case.name {
            TURNING => 5.0,
            _ if case.model.contains("axial_force") => 20.0,
            _ => 1.0 + 1e-9,
        };
        assert!((1.0 - 1e-9..most).contains(&ratio), "{}: {ratio}", case.name);
    }
}

/// A force or moment of a support is changed.
#[test]
fn the_bound_of_a_wrong_reaction_covers_its_error() {
    for case in &CASES {
        for (i, [_, moment]) in case.reactions.iter().enumerate() {
            for key in
                ["force", "moment"].into_iter().filter(|key| *key == "force" || *moment != 0.0)
            {
                for change in [1e-3, -1e-3] {
                    let mut document = case.document(0.0);
                    let place = &mut document["reactions"][i][key];
                    *place = json!(place.as_f64().expect("a reaction") + change);
                    let found = case.verified(&document);
                    let reaction = found.proof.reactions[i];
                    let bound = if key == "force" { reaction.force } else { reaction.moment };
                    let ratio = bound.error / change.abs();
                    let what = format!("{} {i} {key}: {ratio}", case.name);
                    let covered = (1.0 - 1e-9..5.0).contains(&ratio);
                    let name = if key == "force" { "reactions" } else { "reaction_moments" };
                    assert!(found.error_of(name) >= bound.error, "{what}: {name}");
                    assert!(found.shortfall.is_some() && covered, "{what}");
                }
            }
        }
    }
}

/// The reason why a document has no bounds.
fn refused(model: &Model<Wide>, document: &Value) -> String {
    verified(model, document).expect_err("no bounds").what
}

/// The one-way support carries 6. A claim R is multiplied by 1 + λ = 6/R, and |λ| must be less than ½: 4 < R < 12.
#[test]
fn a_one_way_support_must_keep_half_of_its_claimed_reaction() {
    let case = CASES.iter().find(|case| case.name == ONE_WAY).expect("a case");
    for (force, kept) in [(3.9, false), (4.1, true), (11.9, true), (12.1, false)] {
        let mut document = case.document(0.0);
        document["reactions"][0]["force"] = json!(force);
        match verified(&case.model(), &document) {
            Err(why) => assert!(!kept && why.what.contains("cannot balance"), "{force}: {why}"),
            Ok(found) => {
                let bound = found.proof.reactions[0].force.error;
                assert!(kept && bound >= f64::abs(force - 6.0) * (1.0 - 1e-9), "{force}: {bound}");
            }
        }
    }
    let mut pulled = case.document(0.0);
    pulled["reactions"][0]["force"] = json!(-6);
    assert!(refused(&case.model(), &pulled).contains("wrong direction"));
}

/// How two rigid supports at one position share their force is not determined.
#[test]
fn two_rigid_supports_at_one_position_have_no_bound_of_their_reactions() {
    let case = &CASES[6];
    let (mut model, mut document) = (case.model(), case.document(0.0));
    model.supports.push(model.supports[1]);
    document["reactions"][1]["force"] = json!(8);
    document["reactions"]
        .as_array_mut()
        .expect("reactions")
        .push(json!({"support": 2, "force": 4}));
    let found = verified(&model, &document).expect("bounds");
    let errors: Vec<f64> =
        found.proof.reactions.iter().map(|reaction| reaction.force.error).collect();
    assert!(
        found.shortfall.is_some() && errors[0] < 1e-9 && errors[1..] == [f64::INFINITY; 2],
        "{errors:?}"
    );
    model.supports[2].settlement = Wide::of(1e-3);
    assert!(refused(&model, &document).contains("same position"));
}

#[test]
fn a_hinge_at_an_end_of_the_beam_is_refused() {
    let case = CASES.iter().find(|case| !case.model().hinges.is_empty()).expect("a hinge");
    for at in [0.0, 2.0] {
        let mut model = case.model();
        model.hinges[0].at = Wide::of(at);
        assert!(refused(&model, &case.document(0.0)).contains("at an end of the beam"), "{at}");
    }
}

/// With the change ε the energy of the error is E = ε². A spring κ = 6 that carries 6 is certain to act if √(2κE) < 6.
/// Otherwise only the one-way support at the other end holds the beam for certain, and it may rotate about it.
#[test]
fn a_one_way_spring_holds_the_beam_only_if_it_acts_for_certain() {
    let case = CASES.iter().find(|case| case.name == ONE_WAY).expect("a case");
    for (epsilon, holds) in [(0.1, true), (1.7, true), (1.8, false), (4.0, false)] {
        let found = case.verified(&case.document(epsilon));
        assert_eq!(found.proof.bounds.deflection.error < f64::INFINITY, holds, "{epsilon}");
        assert!(epsilon < 1.0 || found.proof.unique.is_err(), "{epsilon}");
    }
}

/// The reactions of two springs follow from a wrong deflection, κ(w + εz): they are wrong by κεz, 4ε at one end and ε at the
/// other.
#[test]
fn the_bound_of_a_spring_covers_the_error_of_the_deflection() {
    let case = CASES.iter().find(|case| case.name == "beam on two springs").expect("a case");
    for epsilon in [1e-3, 1.0, 1e3, -1e3] {
        let mut document = case.document(epsilon);
        for (i, [at, spring]) in [[0.0, 4.0], [2.0, 1.0]].into_iter().enumerate() {
            let w = value(&case.exact[0], 0, at) + epsilon * value(&case.change[0], 0, at);
            document["reactions"][i]["force"] = json!(spring * w);
        }
        let found = case.verified(&document);
        for (i, [at, spring]) in [[0.0, 4.0], [2.0, 1.0]].into_iter().enumerate() {
            let error = (spring * epsilon * value(&case.change[0], 0, at)).abs();
            let bound = found.proof.reactions[i].force.error;
            assert!(bound >= error * (1.0 - 1e-9), "{epsilon} {i}: {bound} {error}");
        }
    }
}

/// Claims with jumps: the right answer, moved and turned rigidly on the first or on the last half of its first or last piece,
/// so that it breaks there. The bounds cover the errors of deflection and slope, which are those of the rigid motion.
#[test]
fn the_bounds_of_a_broken_claim_cover_its_errors() {
    for (case, last) in CASES.iter().flat_map(|case| [(case, false), (case, true)]) {
        let piece = if last { case.exact.len() - 1 } else { 0 };
        let (from, to) = (case.nodes[piece], case.nodes[piece + 1]);
        let middle = 0.5 * (from + to);
        for [moved, turned] in [[1e-3, 0.0], [0.0, 1e-3], [1e-3, -2e-3], [-1e-6, 1e-6]] {
            let mut document = case.document(0.0);
            let pieces = document["pieces"].as_array_mut().expect("pieces");
            let mut half = pieces.remove(piece);
            let exact = case.exact[piece];
            let mut broken = exact;
            broken[0] += moved - turned * middle;
            broken[1] += turned;
            let halves = if last { [exact, broken] } else { [broken, exact] };
            for (i, (ends, w)) in [[from, middle], [middle, to]].into_iter().zip(halves).enumerate()
            {
                half["x"] = json!(ends);
                half["half"] = json!(0.5 * (ends[1] - ends[0]));
                half["deflection"] = json!(in_t(&w, ends));
                if case.model.contains("shear_stiffness") {
                    half["rotation"] =
                        json!(in_t(&[w[1], 2.0 * w[2], 3.0 * w[3], 4.0 * w[4], 0.0], ends));
                }
                pieces.insert(piece + i, half.clone());
            }
            let found = case.verified(&document);
            let bounds = &found.proof.bounds;
            let end = moved + turned * if last { to - middle } else { from - middle };
            let off = f64::max(moved.abs(), end.abs());
            let what = format!("{} {last} {moved} {turned}", case.name);
            for (name, bound, error) in [
                ("deflection", bounds.deflection.error, off),
                ("slope", bounds.slope.error, turned.abs()),
                ("rotation", bounds.rotation.error, turned.abs()),
            ] {
                assert!(bound >= error * (1.0 - 1e-9), "{what}: {name} {bound} {error}");
                assert!(bound <= 1000.0 * (moved.abs() + turned.abs()), "{what}: {name} {bound}");
            }
            assert!(found.shortfall.is_some() || off < 1e-5, "{what}");
        }
    }
}
