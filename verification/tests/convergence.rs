//! Fits the orders of convergence for edges of contact inside an element. `docs/methods.md` derives them.

use groundbeam_testing::expect_by;
use groundbeam_verification::convergence::{ELEMENTS, Quantity, errors, kikuchi, order};
use std::fmt::Write;

/// Smaller errors are rounding.
const FLOOR: f64 = 1e-11;
const CASES: [(&str, f64); 2] = [("III", 0.4), ("IV", 0.49)];

fn slope(moment: f64, quantity: Quantity) -> f64 {
    order(&errors(&kikuchi(moment), quantity), FLOOR).expect("errors above rounding")
}

#[test]
fn nodal_pressures_converge_with_order_one_in_forces_and_two_in_deflections() {
    for (case, moment) in [("I", 0.1), ("II", 0.3), ("III", 0.4), ("IV", 0.49)] {
        for (quantity, expected) in
            [(Quantity::EndForce, 1.0), (Quantity::Shear, 1.0), (Quantity::Gap, 2.0)]
        {
            let found = slope(moment, quantity);
            let name = quantity.name();
            assert!((found - expected).abs() < 0.1, "case {case}, {name}: order {found}");
        }
    }
    let found = slope(0.1, Quantity::Deflection);
    assert!((found - 2.0).abs() < 0.1, "w in full contact: order {found}");
    // With an edge inside an element, the error of w also depends on the distance of the edge from the nodes.
    for (case, moment) in CASES {
        let model = kikuchi(moment);
        let w = errors(&model, Quantity::Deflection);
        let edge = errors(&model, Quantity::Edge);
        for i in 0..ELEMENTS.len() {
            let h = 1.0 / ELEMENTS[i] as f64;
            assert!(edge[i] <= h, "case {case}: the edge is a node next to it");
            let bound = 0.05 * h * h + 4.0 * edge[i] * edge[i];
            assert!(w[i] <= bound, "case {case}, {} elements: {:e}", ELEMENTS[i], w[i]);
        }
    }
}

#[test]
fn the_convergence_tables_in_the_documents_are_up_to_date() {
    expect_by("docs/methods.md", "convergence-dirac", &table(), alike);
}

fn table() -> String {
    let mut text = String::from("| case | error of |");
    ELEMENTS.iter().for_each(|n| write!(text, " N = {n} |").expect("text"));
    text.push_str(" order |\n|---|---|");
    text.push_str(&"---|".repeat(ELEMENTS.len() + 1));
    for (case, moment) in CASES {
        for quantity in Quantity::ALL {
            let errors = errors(&kikuchi(moment), quantity);
            write!(text, "\n| {case} | {} |", quantity.name()).expect("text");
            errors.iter().for_each(|e| write!(text, " {e:.1e} |").expect("text"));
            match order(&errors, FLOOR) {
                Some(order) => write!(text, " {order:.1} |").expect("text"),
                None => text.push_str(" |"),
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
