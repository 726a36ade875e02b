//! Fits the orders of convergence for edges of contact inside an element. `docs/methods.md` derives them.

use groundbeam::Pressure::{self, Dirac, Distributed};
use groundbeam_verification::convergence::{
    ELEMENTS, Errors, Quantity, errors, kikuchi, kikuchi_on_springs, order,
};
use groundbeam_verification::documents;
use std::fmt::Write;

/// Smaller errors are rounding.
const FLOOR: f64 = 1e-11;
/// Errors that depend on the position of an edge of contact in its element. They do not follow a straight line, but are
/// at most the last number times N to minus the second number.
const IRREGULAR: [(Quantity, i32, f64); 4] = [
    (Quantity::MomentAtNodes, 4, 5e-3),
    (Quantity::ShearAtNodes, 4, 1e-2),
    (Quantity::EndForce, 4, 1e-2),
    (Quantity::Edge, 3, 2e-2),
];
const CASES: [(&str, f64); 2] = [("III", 0.4), ("IV", 0.49)];

fn slope(moment: f64, pressure: Pressure, quantity: Quantity) -> f64 {
    order(&errors(&kikuchi(moment), pressure, quantity), FLOOR).expect("errors above rounding")
}

/// The largest error · Nʳ above rounding.
fn constant(errors: &Errors, r: i32) -> f64 {
    let above = ELEMENTS.iter().zip(errors).filter(|(_, e)| **e > FLOOR);
    let scaled = above.map(|(n, e)| e * (*n as f64).powi(r));
    scaled.fold(0.0, f64::max)
}

#[test]
fn spread_pressure_has_the_orders_of_cubics() {
    for (case, moment) in CASES {
        for (quantity, expected) in [
            (Quantity::Deflection, 4.0),
            (Quantity::Slope, 3.0),
            (Quantity::Moment, 4.0),
            (Quantity::Shear, 3.0),
            (Quantity::Pressure, 2.0),
            (Quantity::Gap, 4.0),
        ] {
            let found = slope(moment, Distributed, quantity);
            let name = quantity.name();
            assert!((found - expected).abs() < 0.2, "case {case}, {name}: order {found}");
        }
        for (quantity, r, bound) in IRREGULAR {
            let found = errors(&kikuchi(moment), Distributed, quantity);
            let name = quantity.name();
            let reached = constant(&found, r);
            assert!(reached < bound, "case {case}, {name}: {reached:e} N^-{r}, {found:?}");
        }
    }
}

#[test]
fn on_separate_springs_the_pressure_is_as_good_as_the_deflection() {
    let model = kikuchi_on_springs(0.4);
    for quantity in [Quantity::Deflection, Quantity::Pressure, Quantity::Gap] {
        let found = order(&errors(&model, Distributed, quantity), FLOOR).expect("errors");
        // The gap also contains terms of higher order.
        let most = if quantity == Quantity::Gap { 5.0 } else { 4.2 };
        assert!((3.8..most).contains(&found), "{}: order {found}", quantity.name());
    }
}

#[test]
fn the_papers_pressures_are_of_first_order_in_forces_and_second_in_deflections() {
    for (case, moment) in [("I", 0.1), ("II", 0.3), ("III", 0.4), ("IV", 0.49)] {
        for (quantity, expected) in
            [(Quantity::EndForce, 1.0), (Quantity::Shear, 1.0), (Quantity::Gap, 2.0)]
        {
            let found = slope(moment, Dirac, quantity);
            let name = quantity.name();
            assert!((found - expected).abs() < 0.1, "case {case}, {name}: order {found}");
        }
    }
    let found = slope(0.1, Dirac, Quantity::Deflection);
    assert!((found - 2.0).abs() < 0.1, "w in full contact: order {found}");
    // With an edge inside an element, the error of w also depends on the distance of the edge from the nodes.
    for (case, moment) in CASES {
        let model = kikuchi(moment);
        let w = errors(&model, Dirac, Quantity::Deflection);
        let edge = errors(&model, Dirac, Quantity::Edge);
        for i in 0..ELEMENTS.len() {
            let h = 1.0 / ELEMENTS[i] as f64;
            assert!(edge[i] <= h, "case {case}: the edge is a node next to it");
            let bound = 0.05 * h * h + 4.0 * edge[i] * edge[i];
            assert!(w[i] <= bound, "case {case}, {} elements: {:e}", ELEMENTS[i], w[i]);
        }
    }
}

#[test]
fn the_tables_in_the_methods_are_these() {
    for (name, pressure) in [("convergence-distributed", Distributed), ("convergence-dirac", Dirac)]
    {
        documents::expect_by("docs/methods.md", name, &table(pressure), alike);
    }
}

fn table(pressure: Pressure) -> String {
    let mut text = String::from("| case | error of |");
    ELEMENTS.iter().for_each(|n| write!(text, " N = {n} |").expect("text"));
    text.push_str(" order |\n|---|---|");
    text.push_str(&"---|".repeat(ELEMENTS.len() + 1));
    for (case, moment) in CASES {
        for quantity in Quantity::ALL {
            if quantity == Quantity::Pressure && pressure == Dirac {
                continue;
            }
            let errors = errors(&kikuchi(moment), pressure, quantity);
            write!(text, "\n| {case} | {} |", quantity.name()).expect("text");
            errors.iter().for_each(|e| write!(text, " {e:.1e} |").expect("text"));
            let irregular = IRREGULAR.iter().find(|(q, ..)| *q == quantity);
            match (irregular, order(&errors, FLOOR)) {
                (Some((_, r, _)), _) if pressure == Distributed => {
                    write!(text, " ≤ {:.1e} N^-{r} |", constant(&errors, *r)).expect("text");
                }
                (_, Some(order)) => write!(text, " {order:.1} |").expect("text"),
                (_, None) => text.push_str(" |"),
            }
        }
    }
    text + "\n"
}

/// Whether two texts have the same words, and numbers that agree to rounding.
fn alike(a: &str, b: &str) -> bool {
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let (a, b) = (words(a), words(b));
    a.len() == b.len()
        && a.iter().zip(&b).all(|(a, b)| match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(x), Ok(y)) => (x - y).abs() <= 0.15 * x.abs().max(y.abs()).max(1e-10),
            _ => a == b,
        })
}
