//! Scales for the comparison of error bounds: proven lower bounds of the largest deflection, slope, forces and pressure.

use crate::fields::Fields;
use crate::patches::FIELDS;
use crate::pointwise::PieceBounds;
use crate::polynomial::{Line, Polynomial};
use crate::scalar::Scalar;
use crate::size::Size;

/// Magnitudes with which error bounds are compared, in the units of the proof. Each number is a lower bound of the
/// magnitude that its comment describes.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct FieldScales {
    /// Scale U of deflection and settlement: the larger of max|w| and max|u|.
    pub deflection: f64,
    /// Scale of the slope: the larger of max|w′| and U/Λ, with the scale U of the deflection and the characteristic
    /// length Λ.
    pub slope: f64,
    /// Scale of the bending moment: the largest of max|M|, Λ² max p and F₀Λ, with the characteristic length Λ, the
    /// pressure p and the largest load or reaction F₀.
    pub moment: f64,
    /// Scale of the shear force: the largest of max|V|, Λ max p and F₀, with the shear force V, the contact pressure p,
    /// the largest load or reaction F₀ and the characteristic length Λ.
    pub shear_force: f64,
    /// Scale of the pressure: the maximum contact pressure, or the maximum subgrade modulus times the scale of the
    /// deflection if this product is larger.
    pub pressure: f64,
    /// Scale of the forces: the sum of all loads, or the largest single load or reaction if it is larger. Moments are
    /// divided by the characteristic length Λ.
    pub force: f64,
    /// Scale of the moments of supports: `force` times the characteristic length Λ.
    pub turning: f64,
}

/// Lower bounds of the largest absolute values of the exact fields: the largest claimed values at the nodes and
/// the middles of the pieces, minus the error bounds.
#[derive(Default)]
struct Largest {
    deflection: f64,
    slope: f64,
    moment: f64,
    shear_force: f64,
    settlement: f64,
    pressure: f64,
}

impl FieldScales {
    /// Computes the scales of all fields from the claimed solution, its error bounds and the loads.
    pub fn of<S: Scalar>(fields: &Fields<S>, bounds: &[PieceBounds]) -> Self {
        let most = Largest::of(fields, bounds);
        let wave = wave(fields);
        let (largest_load, sum) = loads(fields, wave);
        let spans = &fields.frame.spans;
        let stiffest = spans.iter().map(|span| span.spring.low()).fold(0.0, larger);
        let deflection = larger(most.deflection, most.settlement);
        let pressed = most.pressure;
        FieldScales {
            deflection,
            slope: larger(most.slope, slightly_less(deflection / wave)),
            moment: larger(most.moment, slightly_less(larger(pressed * wave, largest_load) * wave)),
            shear_force: larger(
                most.shear_force,
                slightly_less(larger(pressed * wave, largest_load)),
            ),
            pressure: larger(pressed, slightly_less(stiffest * deflection)),
            force: larger(sum, largest_load),
            turning: slightly_less(larger(sum, largest_load) * wave),
        }
    }
}

/// Returns the largest absolute values of the claimed fields at the nodes and the middles of the pieces. The value for
/// the gap is the sum of those for deflection and settlement.
pub(crate) fn claimed<S: Scalar>(fields: &Fields<S>) -> [f64; 8] {
    let exact = vec![PieceBounds::EXACT; fields.frame.spans.len()];
    let most = Largest::of(fields, &exact);
    FIELDS.map(|(name, ..)| match name {
        "deflection" => most.deflection,
        "slope" | "rotation" => most.slope,
        "moment" => most.moment,
        "shear_force" => most.shear_force,
        "settlement" => most.settlement,
        "gap" => most.deflection + most.settlement,
        _ => most.pressure,
    })
}

impl Largest {
    fn of<S: Scalar>(fields: &Fields<S>, bounds: &[PieceBounds]) -> Self {
        let mut most = Largest::default();
        for (i, (span, error)) in fields.frame.spans.iter().zip(bounds).enumerate() {
            let slope = span.derivative(&span.deflection);
            let moment = span.bending_moment(span.rotation.as_deref().unwrap_or(&slope));
            let shear = span.derivative(&moment);
            let places = [span.t[0], S::zero(), span.t[1]];
            let on = |field: &Polynomial<S>, error: Size| {
                let field = field.coarse();
                let value = |t: &S| shown(field.value(t.coarse()), error);
                places.iter().map(value).fold(0.0, larger)
            };
            let raise = |most: &mut f64, value: f64| *most = larger(*most, value);
            raise(&mut most.deflection, on(&span.deflection, error.deflection));
            raise(&mut most.slope, on(&slope, error.slope));
            raise(&mut most.moment, on(&moment, error.moment));
            raise(&mut most.shear_force, on(&shear, error.shear_force));
            if span.touches {
                raise(&mut most.settlement, on(&span.obstacle(), error.settlement));
                raise(&mut most.pressure, on(&fields.pressures[i].field, error.pressure));
            }
            for u in fields.surface.pieces[i].open.iter().flatten() {
                raise(&mut most.settlement, shown(*u, error.settlement));
            }
        }
        most
    }
}

/// A lower bound of the absolute value of an exact number, from the claimed number and its error bound.
fn shown<S: Scalar>(claimed: S, error: Size) -> f64 {
    let value = if claimed.low() > 0.0 { claimed.low() } else { (-claimed).low() };
    (value - error.value()).next_down()
}

/// Lower bound of the characteristic length Λ, which is the smaller of the length of the beam and the largest
/// (4EI/k)^¼.
fn wave<S: Scalar>(fields: &Fields<S>) -> f64 {
    let spans = fields.frame.spans.iter();
    let waves = spans.map(|span| (4.0 * span.bending.low() / span.spring.high()).sqrt().sqrt());
    let (wave, length) = (waves.fold(0.0, larger), fields.frame.length.low());
    slightly_less(if wave < length { wave } else { length })
}

/// Returns the largest load or reaction F₀ and the sum of all loads, both as forces (section 8 of `docs/proof.md`).
/// `wave` is the characteristic length Λ.
fn loads<S: Scalar>(fields: &Fields<S>, wave: f64) -> (f64, f64) {
    let (mut most, mut sum) = (0.0, 0.0);
    for span in &fields.frame.spans {
        let at_ends = |field: &Line<S>| {
            span.t.iter().map(|t| shown(field.value(*t), Size::ZERO)).fold(0.0, larger)
        };
        let (force, couple) = (at_ends(&span.force), at_ends(&span.moment));
        let curled = span.bending.low() * at_ends(&span.curvature) / wave;
        most = larger(larger(most, larger(force * wave, couple)), curled);
        // For a linear function y, the mean of |y| is at least √2 − 1 times the largest |y|. This factor is rounded
        // down to 0.4.
        sum += 0.4 * (force + couple / wave) * span.h.low();
    }
    for (i, node) in fields.frame.nodes.iter().enumerate() {
        let force = shown(node.force, Size::ZERO);
        let couple = shown(node.moment, Size::ZERO) / wave;
        let [w, _] = fields.deflection.at_support(i);
        let elastic =
            node.spring.map_or(0.0, |[spring, settled]| shown(spring * w - settled, Size::ZERO));
        let reaction = larger(shown(node.reaction[0], Size::ZERO), elastic);
        most = larger(larger(most, larger(force, couple)), reaction);
        sum += larger(force, 0.0) + larger(couple, 0.0);
    }
    (slightly_less(most), slightly_less(larger(sum, most)))
}

fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Reduces a number by more than the rounding error of a few operations.
fn slightly_less(x: f64) -> f64 {
    x * (1.0 - 1e-12)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::given_claim::with_fields;
    use serde_json::json;

    /// With t = 2x − 1, w = 1 + 2t + 3t² + 4t³ has the largest value 10, and its derivatives have 2·20, 4·30 and 8·24.
    /// The settlement is w − ¼, and the pressure 2(w − ¼).
    #[test]
    fn listed_numbers_are_compared_with_the_largest_values() {
        let model =
            "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 2\n[[gap]]\nat = 0\nvalue = 0.25\n";
        let piece = json!({"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1, 2, 3, 4]});
        with_fields(model, &json!({"pieces": [piece]}), |fields| {
            let found = claimed(fields);
            for ((name, ..), found) in FIELDS.iter().zip(found) {
                let exact = match *name {
                    "deflection" => 10.0,
                    "slope" | "rotation" => 40.0,
                    "moment" => 120.0,
                    "shear_force" => 192.0,
                    "settlement" => 9.75,
                    "pressure" => 19.5,
                    _ => 19.75,
                };
                assert!(
                    (found / exact - 1.0).abs() < 1e-12 && found <= exact,
                    "{name}: {found} {exact}"
                );
            }
        });
        assert!(slightly_less(1.0) < 1.0 && slightly_less(1.0) > 1.0 - 1e-11);
    }
}
