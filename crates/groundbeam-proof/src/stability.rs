//! Computes a number σ > 0 such that the work of an axial compression is at most (1 − σ) times the strain energy of the beam.
//!
//! One method applies to spans between rigid supports and to a beam whose only rigid support is a clamp at an end. A
//! second method divides a beam without shear deformation into elements. See *Critical load* in section 3 of
//! `docs/proof.md`.

use crate::frame::{Frame, Node};
use crate::model::Acts;
use crate::scalar::Scalar;
use crate::size::Size;

/// Lower bounds of π² and 4π².
const PI_SQUARED: f64 = 9.869_604;
const FOUR_PI_SQUARED: f64 = 39.478_417;
/// Numbers of elements along the whole beam, in the order in which they are tried. On a stiff beam, fewer elements
/// have smaller rounding errors.
const ELEMENTS: [f64; 3] = [16.0, 4.0, 1.0];
/// The largest ratio N₁/N that is tried, with the compression N and a compression N₁ under which the beam is stable.
const MOST: f64 = 64.0;

/// Returns σ > 0 such that the work of the compression is at most (1 − σ) times the strain energy of the beam and its
/// two-way supports; `None` if no such number is found.
pub(crate) fn margin<S: Scalar>(frame: &Frame<S>, compression: S) -> Option<f64> {
    let by_spans = of_spans(frame, compression);
    if by_spans.is_some_and(|margin| margin > 0.5) || frame.shears() {
        return by_spans;
    }
    let by_elements = ELEMENTS.into_iter().find_map(|count| {
        let few_digits = of_elements(frame, compression, count, |x: S| x.coarse());
        few_digits.or_else(|| of_elements(frame, compression, count, |x: S| x))
    });
    match (by_spans, by_elements) {
        (Some(a), Some(b)) => Some(if a >= b { a } else { b }),
        (a, b) => a.or(b),
    }
}

fn is_rigid<S: Scalar>(node: &Node<S>) -> bool {
    node.rigid.is_some() && node.acts == Acts::Both
}

/// Computes the number σ of [`margin`] for a beam with rigid supports at both ends, or with a clamp at one end as its
/// only rigid support. Returns `None` for other beams and for beams with hinges.
fn of_spans<S: Scalar>(frame: &Frame<S>, compression: S) -> Option<f64> {
    let nodes = &frame.nodes;
    let last = nodes.len() - 1;
    if nodes.iter().any(Node::is_hinged) {
        return None;
    }
    let rigid: Vec<usize> = (0..=last).filter(|i| is_rigid(&nodes[*i])).collect();
    // `flexibility` computes an upper bound of L²/(π²EI) + 1/S for a stretch of the beam with the length L and the
    // shear stiffness S.
    let flexibility = |from: usize, to: usize, length: f64| {
        let mut most = Size::ZERO;
        let mut sheared = Size::ZERO;
        for span in &frame.spans[from..to] {
            most = most.worst(Size::of(1.0).over(span.bending.low()));
            let own = span.stiffness.as_ref().map(|stiffness| Size::of(1.0).over(stiffness.low()));
            sheared = sheared.worst(own.unwrap_or(Size::ZERO));
        }
        (Size::of(length).square() * most).over(PI_SQUARED) + sheared
    };
    let largest = if rigid.first() == Some(&0) && rigid.last() == Some(&last) {
        let spans = rigid.windows(2).map(|ends| {
            let length = (nodes[ends[1]].x - nodes[ends[0]].x).high();
            flexibility(ends[0], ends[1], length)
        });
        spans.fold(Size::ZERO, Size::worst)
    } else {
        let clamped = [0, last].into_iter().any(|end| nodes[end].clamped);
        if !(clamped && rigid.len() == 1) || frame.shears() {
            return None;
        }
        flexibility(0, last, (2.0 * frame.length.high()).next_up())
    };
    let lost = Size::of(compression.high()) * largest;
    let left = (1.0 - lost.value()).next_down();
    (left > 0.0).then_some(left)
}

/// Computes σ = 1 − N/N₁ from the compression N and the largest compression N₁ found for which the stiffness matrix of
/// the elements is positive definite.
fn of_elements<S: Scalar, C: Scalar>(
    frame: &Frame<S>,
    compression: S,
    count: f64,
    to: impl Fn(S) -> C,
) -> Option<f64> {
    let (first, elements) = (Joint::of(&frame.nodes[0], &to), elements(frame, count, &to));
    let stable = |ratio: f64| {
        let load = to(compression) * C::of(ratio);
        is_stable(&first, &elements, load).is_some()
    };
    let (mut low, mut high) = (1.0, MOST);
    if stable(high) {
        low = high;
    }
    // N₁ is a compression under which the beam is stable, and N the actual compression. The bisection of the ratio N₁/N
    // ends when σ = 1 − N/N₁ is accurate to ten percent.
    while high - low > 0.1 * (low - 1.0) && high - 1.0 > 1e-3 {
        let (mean, least) = (f64::sqrt((high - 1.0) * (low - 1.0)), 0.125 * (high - 1.0));
        let middle = 1.0 + if mean >= least { mean } else { least };
        if stable(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let left = (1.0 - (1.0 / low).next_up()).next_down();
    (left > 0.0).then_some(left)
}

/// The two-way supports of a node.
struct Joint<C> {
    spring: C,
    turning: C,
    hinge: Option<C>,
    /// Whether a support at the node fixes the deflection, and whether it fixes the slope. A support that fixes the
    /// slope also fixes the deflection.
    held: [bool; 2],
}

impl<C: Scalar> Joint<C> {
    fn of<S: Scalar>(node: &Node<S>, to: &impl Fn(S) -> C) -> Self {
        let spring = node.spring.filter(|_| node.acts == Acts::Both);
        Joint {
            spring: spring.map_or_else(C::zero, |[spring, _]| to(spring)),
            turning: node.turning.map_or_else(C::zero, to),
            hinge: node.hinge.map(to),
            held: [is_rigid(node), node.clamped],
        }
    }
}

/// An element of the beam, with the joint at its right end if a node lies at this end.
struct Element<C> {
    length: C,
    bending: C,
    end: Option<Joint<C>>,
}

/// Divides the beam into elements of at most its length over `count`. Elements end at supports, hinges, jumps of EI,
/// and all nodes where EI varies.
fn elements<S: Scalar, C: Scalar>(
    frame: &Frame<S>,
    count: f64,
    to: &impl Fn(S) -> C,
) -> Vec<Element<C>> {
    let mut elements = Vec::new();
    let mut first = 0;
    for i in 1..frame.nodes.len() {
        let node = &frame.nodes[i];
        let bare = !is_rigid(node)
            && node.spring.is_none()
            && node.turning.is_none()
            && !node.is_hinged()
            && i < frame.spans.len()
            && frame.spans[i].bending.even().is_some()
            && frame.spans[i].bending == frame.spans[first].bending;
        if bare {
            continue;
        }
        let length = frame.nodes[i].x - frame.nodes[first].x;
        let parts = (count * length.middle() / frame.length.middle()).ceil().max(1.0);
        let part = to(length.div(S::of(parts)));
        for j in 0..parts as usize {
            let end = (j + 1 == parts as usize).then(|| Joint::of(node, to));
            elements.push(Element {
                length: part,
                bending: to(frame.spans[first].bending.least()),
                end,
            });
        }
        first = i;
    }
    elements
}

/// Stiffness of the part of the beam to the left of a position, condensed to the deflection and the slope at
/// this position.
#[derive(Clone, Copy)]
struct Left<C> {
    /// Entries (z, z), (z, z′) and (z′, z′) of the stiffness matrix, where z is the deflection and z′ the slope at the
    /// position.
    stiffness: [C; 3],
    /// Whether a support at the position fixes the deflection, and whether it fixes the slope.
    held: [bool; 2],
}

impl<C: Scalar> Left<C> {
    /// Adds the support stiffnesses of a node and eliminates the slope to the left of its hinge. Returns `None` unless
    /// the rotational stiffness at the hinge is proven to be positive.
    fn at(self, joint: &Joint<C>) -> Option<Left<C>> {
        let [mut a, mut b, mut c] = self.stiffness;
        (a, c) = (a + joint.spring, c + joint.turning);
        if let Some(spring) = joint.hinge {
            let pivot = c + spring;
            if !(pivot.low() > 0.0) {
                return None;
            }
            a = a - (b * b).div(pivot);
            (b, c) = ((b * spring).div(pivot), (c * spring).div(pivot));
        }
        Some(Left { stiffness: [a, b, c], held: joint.held })
    }

    /// Whether the stiffness matrix is proven to be positive definite. A deflection or slope that a support fixes is
    /// left out of the matrix.
    fn is_positive(&self) -> bool {
        let [a, b, c] = self.stiffness;
        match self.held {
            [true, true] => true,
            [true, false] => c.low() > 0.0,
            [false, _] => a.low() > 0.0 && (c - (b * b).div(a)).low() > 0.0,
        }
    }

    /// Computes the condensed stiffness at the right end of an element under the compression `load`; `None` if the
    /// stiffness at the left end is not proven to be positive definite.
    fn across(self, element: &Element<C>, load: C) -> Option<Left<C>> {
        let h = element.length;
        let waves = (load * h * h).div(element.bending * C::of(FOUR_PI_SQUARED));
        let share = C::one() - waves;
        if !(share.low() > 0.0) {
            return None;
        }
        let geometric = load.div(share * C::of(30.0) * h);
        let bending = element.bending.div(h * h * h);
        let entry = |bent: f64, drawn: f64| bending * C::of(bent) - geometric * C::of(drawn);
        let (h1, h2) = (h, h * h);
        let own = entry(12.0, 36.0);
        let turned = entry(6.0, 3.0) * h1;
        let steep = entry(4.0, 4.0) * h2;
        let across = entry(2.0, -1.0) * h2;
        // `joined` is the stiffness at the left end of the element: that of the beam to the left plus that of the
        // element. `coupling` couples both ends of the element.
        let [a, b, c] = self.stiffness;
        let joined = Left { stiffness: [a + own, b + turned, c + steep], held: self.held };
        if !joined.is_positive() {
            return None;
        }
        let [a, b, c] = joined.stiffness;
        let coupling = [[-own, turned], [-turned, across]];
        let zero = C::zero();
        // `inverse` is the inverse of the matrix `joined`. A deflection or slope that a support fixes is left out of
        // the inversion, and its entries in `inverse` are zero.
        let inverse = match self.held {
            [true, true] => [zero; 3],
            [true, false] => [zero, zero, C::one().div(c)],
            [false, _] => {
                let determinant = a * c - b * b;
                [c.div(determinant), -b.div(determinant), a.div(determinant)]
            }
        };
        let condensed = |i: usize, j: usize| {
            let [p, q] = [coupling[0][j], coupling[1][j]];
            coupling[0][i] * (inverse[0] * p + inverse[1] * q)
                + coupling[1][i] * (inverse[1] * p + inverse[2] * q)
        };
        let stiffness = [own - condensed(0, 0), -turned - condensed(0, 1), steep - condensed(1, 1)];
        Some(Left { stiffness, held: [false; 2] })
    }
}

/// Returns `Some(())` if the stiffness matrix of all elements is proven to be positive definite.
fn is_stable<C: Scalar>(first: &Joint<C>, elements: &[Element<C>], load: C) -> Option<()> {
    let nothing = Left { stiffness: [C::zero(); 3], held: [false; 2] };
    let mut left = nothing.at(first)?;
    for element in elements {
        left = left.across(element, load)?;
        if let Some(joint) = &element.end {
            left = left.at(joint)?;
        }
    }
    left.is_positive().then_some(())
}

#[cfg(test)]
mod tests {
    use super::{elements, of_elements};
    use crate::given_claim::with_fields;
    use crate::scalar::Scalar;
    use crate::wide::Wide;
    use serde_json::json;

    /// A beam with the length 1.5 and a pin at 0.375 is divided at the pin into equal elements, at least one on each side.
    #[test]
    fn elements_have_nearly_equal_lengths() {
        let text = "[beam]\nlength = 1.5\nEI = 1\n[foundation]\nk = 1\n[[support]]\nat = 0.375\ntype = 'pinned'\n";
        let piece = |x: [f64; 2]| json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": true, "deflection": [0]});
        let pieces = [piece([0.0, 0.375]), piece([0.375, 0.75]), piece([0.75, 1.5])];
        with_fields(text, &json!({"pieces": pieces, "reactions": [{"force": 0}]}), |fields| {
            for (count, [left, right]) in
                [(16.0, [4, 12]), (10.0, [3, 8]), (4.0, [1, 3]), (1.0, [1, 1])]
            {
                let found = elements(fields.frame, count, &|x: Wide| x);
                let joints: Vec<usize> =
                    (0..found.len()).filter(|i| found[*i].end.is_some()).map(|i| i + 1).collect();
                assert_eq!(joints, [left, left + right], "{count}");
                let whole: f64 = found.iter().map(|element| element.length.middle()).sum();
                assert!((whole - 1.5).abs() < 1e-12, "{count}: {whole}");
            }
        });
    }

    /// The critical load of a beam on two pins is π²EI/l². The bound by four elements is at most 2 percent smaller. The
    /// search ends when the ratio of bound to compression, minus 1, is accurate to ten percent.
    #[test]
    fn the_search_for_the_critical_load_is_accurate() {
        let pin = |at: u32| format!("[[support]]\nat = {at}\ntype = 'pinned'\n");
        let text = ["[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n", &pin(0), &pin(1)].concat();
        let piece = json!({"x": [0, 1], "half": 0.5, "touches": true, "deflection": [0]});
        let reactions = json!([{"force": 0}, {"force": 0}]);
        with_fields(&text, &json!({"pieces": [piece], "reactions": reactions}), |fields| {
            let critical = std::f64::consts::PI.powi(2);
            for ratio in [1.1, 1.15, 1.25, 1.5, 2.0, 5.0, 20.0, 60.0, 0.999, 0.5, 0.01] {
                let load = fields.frame.units.scaled(Wide::of(critical / ratio), 1, 0);
                let found = of_elements(fields.frame, load, 4.0, |x: Wide| x);
                let found = found.map_or(0.0, |margin| 1.0 / (1.0 - margin));
                let least = if ratio > 1.0 { 1.0 + 0.9 * (0.98 * ratio - 1.0) } else { 0.0 };
                assert!(least <= found && found <= ratio, "{ratio}: {found} {least}");
            }
        });
    }
}
