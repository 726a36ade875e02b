//! Measures the errors of the active-set method for several numbers of elements, and the orders of convergence.

use crate::solved::{solved, solved_by};
use groundbeam::{Beam, Field, Foundation, Load, Method, Model, Options, Solution, solution::Side};

/// Numbers of elements of the compared meshes.
pub const ELEMENTS: [usize; 6] = [10, 20, 40, 80, 160, 320];

/// Returns Kikuchi's example with l = EI = μ = k = 1, the force f₀ = 1 and the moment M₀ at mid-length.
pub fn kikuchi(moment: f64) -> Model {
    Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::point_force(0.5, 1.0))
        .with_load(Load::point_moment(0.5, moment))
}

/// The compared quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Deflection w at all stations, relative to the largest w.
    Deflection,
    /// Slope w′ at all stations, relative to the largest w′.
    Slope,
    /// Moment M at the nodes, relative to the largest M.
    MomentAtNodes,
    /// Moment M at all stations, relative to the largest M.
    Moment,
    /// Shear force V on both sides of the nodes, relative to the largest V.
    ShearAtNodes,
    /// Shear force V at all stations, relative to the largest V.
    Shear,
    /// Contact force p_l under the right end of the beam, relative to the resultant of the loads.
    EndForce,
    /// Position of the left contact edge, relative to the length l.
    Edge,
    /// Energy gap of the computed solution, relative to its strain energy. The gap is the primal energy minus the dual
    /// energy.
    Gap,
}

impl Quantity {
    /// All quantities, in the order of the rows of the convergence table.
    pub const ALL: [Quantity; 9] = [
        Quantity::Deflection,
        Quantity::Slope,
        Quantity::MomentAtNodes,
        Quantity::Moment,
        Quantity::ShearAtNodes,
        Quantity::Shear,
        Quantity::EndForce,
        Quantity::Edge,
        Quantity::Gap,
    ];

    /// Name of the quantity in the convergence table.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Deflection => "w",
            Quantity::Slope => "w′",
            Quantity::MomentAtNodes => "M at nodes",
            Quantity::Moment => "M",
            Quantity::ShearAtNodes => "V at nodes",
            Quantity::Shear => "V",
            Quantity::EndForce => "p_l",
            Quantity::Edge => "edge of contact",
            Quantity::Gap => "relative gap",
        }
    }
}

/// Errors of one quantity, one error for each number of elements in [`ELEMENTS`].
pub type Errors = [f64; ELEMENTS.len()];

/// Returns the errors of a quantity against the exact method, for each number of elements.
pub fn errors(model: &Model, quantity: Quantity) -> Errors {
    let exact = solved(model);
    ELEMENTS.map(|elements| {
        let method = Method::ActiveSet;
        let options = Options { method, elements, ..Options::default() };
        let found = solved_by(model, &options);
        error(&exact, &found, elements, quantity)
    })
}

/// Returns the order of convergence, by least squares. Errors up to `floor` are omitted as rounding errors; `None` if
/// fewer than three remain.
pub fn order(errors: &Errors, floor: f64) -> Option<f64> {
    let points: Vec<(f64, f64)> = ELEMENTS
        .iter()
        .zip(errors)
        .filter(|(_, e)| **e > floor)
        .map(|(n, e)| ((*n as f64).ln(), e.ln()))
        .collect();
    let count = points.len() as f64;
    if count < 3.0 {
        return None;
    }
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    Some(-covariance / variance)
}

fn error(exact: &Solution, found: &Solution, elements: usize, quantity: Quantity) -> f64 {
    // `nodes` are the positions of the nodes of a mesh of n elements on a beam of unit length.
    let nodes = |n: usize| (0..=n).map(move |i| i as f64 / n as f64);
    let largest = |field| {
        let range = exact.range(field);
        range.max.value.abs().max(range.min.value.abs())
    };
    let over = |stations: &mut dyn Iterator<Item = f64>, field| {
        let sides = |x: f64| {
            [Side::Left, Side::Right].map(|side| {
                let outer = if x == 0.0 { Side::Right } else { Side::Left };
                let side = if x == 0.0 || x == 1.0 { outer } else { side };
                (exact.at(x, side).get(field) - found.at(x, side).get(field)).abs()
            })
        };
        stations.flat_map(sides).fold(0.0, f64::max) / largest(field)
    };
    // The stations are the nodes of every mesh and three positions inside each element of the finest mesh.
    let everywhere = || nodes(4 * ELEMENTS[ELEMENTS.len() - 1]);
    match quantity {
        Quantity::Deflection => over(&mut everywhere(), Field::Deflection),
        Quantity::Slope => over(&mut everywhere(), Field::Slope),
        Quantity::MomentAtNodes => over(&mut nodes(elements), Field::Moment),
        Quantity::Moment => over(&mut everywhere(), Field::Moment),
        Quantity::ShearAtNodes => over(&mut nodes(elements), Field::ShearForce),
        Quantity::Shear => over(&mut everywhere(), Field::ShearForce),
        Quantity::EndForce => (exact.end_forces().right - found.end_forces().right).abs(),
        Quantity::Edge => {
            let edge = |s: &Solution| s.contact().first().map_or(f64::NAN, |c| c.from);
            (edge(exact) - edge(found)).abs()
        }
        Quantity::Gap => found.certificate().relative_gap(),
    }
}
