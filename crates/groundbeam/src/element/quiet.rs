//! Computes the element of a long loaded stretch in contact, where w is a particular solution of the beam equation.
//!
//! The waves from the ends of the stretch have decayed to rounding error, so the two ends of this element are
//! decoupled. See *Long loaded stretches* in `docs/methods.md`.

use crate::element::element::{Basis, Element};
use crate::element::operator::Operator;
use crate::element::uniform::bend;
use crate::numeric::polynomial::TERMS;
use crate::numeric::real::{Real, sum as sum_of};

/// Length over which the waves from an end decay to rounding error, as a multiple of 1/λ for the decay rate λ.
const DEPTH: f64 = 50.0;

/// Smallest length of a stretch with a quiet element, as a multiple of the [`depth`] of the waves from its ends. The
/// limit exists because the error of a moment grows with the length of an element.
const SHORTEST: f64 = 40.0;

/// Computes the length over which the waves from the ends of a stretch decay. Returns `None` unless the stretch is
/// long, loaded, uniform and in contact.
pub(crate) fn depth<R: Real>(operator: &Operator<R>, length: f64) -> Option<f64> {
    let loads = particular(operator, length);
    let is_loaded = operator.subgrade.value() > 0.0 && (loads[0] * loads[1]).value() > 0.0;
    if operator.polynomials.is_some() || !is_loaded {
        return None;
    }
    let [sum, product] = roots(operator).map(R::value);
    let apart = sum * sum - 4.0 * product;
    // The decay rate is the smallest positive real part of a root. If the roots are real, this formula avoids
    // cancellation.
    let decay = if apart > 0.0 { 2.0 * product / (sum + apart.sqrt()) } else { 0.5 * sum };
    let depth = DEPTH / decay;
    (length > SHORTEST * depth).then_some(depth)
}

/// Computes the sum and the product of the two characteristic roots with positive real part.
fn roots<R: Real>(operator: &Operator<R>) -> [R; 2] {
    let product = (operator.subgrade / operator.stiffness).sqrt();
    let square = operator.tension / operator.stiffness + product * 2.0;
    [if square.value() > 0.0 { square.sqrt() } else { R::ZERO }, product]
}

/// Computes the particular solution (F − G′)/κ of the beam equation at both ends of the stretch, with the load F, the
/// distributed moment load G and the subgrade κ.
fn particular<R: Real>(operator: &Operator<R>, length: f64) -> [R; 2] {
    let [left, right] = operator.moment_load;
    let rise = (right - left) / length;
    operator.load.map(|load| (load - rise) / operator.subgrade)
}

/// Computes the quiet element, and the power series coefficients of its deflection, a particular solution of the beam
/// equation.
pub(crate) fn element<R: Real>(operator: &Operator<R>, length: f64) -> (Element<R>, [R; TERMS]) {
    let ends = particular(operator, length);
    let slope = (ends[1] - ends[0]) / length;
    let [sum, product] = roots(operator);
    let [ww, wt, tt] = [sum * product, product, sum].map(|k| operator.stiffness * k);
    let mut element = Element { length, basis: Basis::Ends, ..Element::default() };
    let zero = R::ZERO;
    element.stiffness =
        [[ww, wt, zero, zero], [wt, tt, zero, zero], [zero, zero, ww, -wt], [zero, zero, -wt, tt]];
    // For the tension N and the moment load G, the particular solution has the end force −N w′ + G on the left and N
    // w′ − G on the right.
    let [left, right] = operator.moment_load;
    let own = [left - operator.tension * slope, zero, operator.tension * slope - right, zero];
    let values = [ends[0], slope, ends[1], slope];
    element.load =
        std::array::from_fn(|i| sum_of::<R, 4>(|j| element.stiffness[i][j] * values[j]) - own[i]);
    bend(&mut element, operator.imposed_moments);
    let mut series = [R::ZERO; TERMS];
    (series[0], series[1]) = ((ends[0] + ends[1]) * 0.5, (ends[1] - ends[0]) * 0.5);
    (element, series)
}

#[cfg(test)]
mod tests {
    use crate::cancel::Cancel;
    use crate::contact::bonded::Bonded;
    use crate::contact::state::ContactState;
    use crate::model::{Beam, Foundation, Load, Model};
    use crate::numeric::polynomial::jet;

    /// Returns w and EI w″ at the position x.
    fn at(found: &ContactState, x: f64) -> [f64; 2] {
        let i = found.mesh.cell_at(x);
        let cell = &found.mesh.cells[i];
        let [w, _, bend, _] = jet(found.deflection().cell(i), cell.local(x));
        [w, bend * 4.0 / (cell.length() * cell.length())]
    }

    #[test]
    fn a_quiet_element_agrees_with_short_ones() {
        let never = Cancel::default();
        let l = 40_000.0;
        for (tension, layer) in [(0.0, 0.0), (0.0, 1.0), (3.0, 2.0), (-1.0, 0.5), (40.0, 0.0)] {
            let mut model = Model::new(Beam::uniform(l, 1.0), Foundation::pasternak(4.0, layer))
                .with_load(Load::distributed_force(0.0, l, 1.0, 3.0))
                .with_load(Load::distributed_moment(0.0, l, 0.3, -0.2))
                .with_load(Load::uniform_curvature(0.0, l, 0.1))
                .with_load(Load::point_force(0.3 * l, 5.0))
                .with_gap(0.0, 0.0)
                .with_gap(l, 0.7);
            model.beam.axial_force = tension;
            let contact = [[0.0, l]];
            let short = Bonded::fine(&model, &never).solve_on(&contact).expect("a solution");
            let quiet = Bonded::new(&model, &never).solve_on(&contact).expect("a solution");
            assert!(quiet.mesh.cells.len() < short.mesh.cells.len() / 5, "{tension} {layer}");
            for i in 0..=1000 {
                let x = l * f64::from(i) / 1000.0;
                let [fine, long] = [at(&short, x), at(&quiet, x)];
                let close = |j: usize| (fine[j] - long[j]).abs() < 1e-12;
                assert!(close(0) && close(1), "{tension} {layer} {x}: {fine:?} {long:?}");
            }
        }
    }
}
