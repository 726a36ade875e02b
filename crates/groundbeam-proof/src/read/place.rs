//! Compares positions, reads stretches of the beam, and finds the parts of the beam that no stretch covers.

use super::error::{Read, wrong};
use super::fields::{Fields, POSITION, Quantity, Section};
use crate::Scalar;

/// Whether a < b is certain.
pub(crate) fn is_left<S: Scalar>(a: S, b: S) -> bool {
    (b - a).low() > 0.0
}

/// Returns the parts of the beam from 0 to `length` that no stretch covers, from left to right. The ends of each part
/// are positions, then fractions of `length`.
pub(crate) fn left_out<S: Scalar>(length: S, stretches: &[[S; 2]]) -> Vec<([S; 2], [S; 2])> {
    if stretches.is_empty() {
        return vec![([S::zero(), length], [S::zero(), S::one()])];
    }
    let mut stretches = stretches.to_vec();
    stretches.sort_by(|a, b| a[0].middle().total_cmp(&b[0].middle()));
    let mut rest = Vec::new();
    let mut reached = S::zero();
    for [from, to] in stretches {
        let stop = if is_left(length, from) { length } else { from };
        if is_left(reached, stop) {
            rest.push([reached, stop]);
        }
        if is_left(reached, to) {
            reached = to;
        }
    }
    if is_left(reached, length) {
        rest.push([reached, length]);
    }
    rest.into_iter().map(|ends| (ends, ends.map(|x| x.div(length)))).collect()
}

/// Whether the stretches together cover the beam from 0 to `length`.
pub(crate) fn covers<S: Scalar>(length: S, stretches: &[[S; 2]]) -> bool {
    left_out(length, stretches).is_empty()
}

/// The index of a stretch that certainly overlaps the stretch to its left; `None` if no stretches certainly overlap.
pub(crate) fn overlapping<S: Scalar>(stretches: &[[S; 2]]) -> Option<usize> {
    let mut order: Vec<usize> = (0..stretches.len()).collect();
    order.sort_by(|a, b| stretches[*a][0].middle().total_cmp(&stretches[*b][0].middle()));
    order
        .windows(2)
        .find(|pair| is_left(stretches[pair[1]][0], stretches[pair[0]][1]))
        .map(|p| p[1])
}

/// Reads `from` and `to` of a stretch, which must lie on the beam.
pub(crate) fn stretch<S: Scalar>(fields: &mut Fields, table: Section, length: S) -> Read<[S; 2]> {
    let from: Quantity<S> = fields.required(table, "from", POSITION)?;
    let to: Quantity<S> = fields.required(table, "to", POSITION)?;
    on_beam(from.value, length, from.at)?;
    on_beam(to.value, length, to.at)?;
    ordered([from.value, to.value], to.at)
}

/// Checks that a position is on the beam.
pub(crate) fn on_beam<S: Scalar>(x: S, length: S, at: usize) -> Read<()> {
    if is_left(x, S::zero()) || is_left(length, x) {
        return wrong(at, "the position is outside the beam");
    }
    Ok(())
}

/// Checks that a stretch has a positive length.
pub(crate) fn ordered<S: Scalar>([from, to]: [S; 2], at: usize) -> Read<[S; 2]> {
    if !is_left(from, to) {
        return wrong(at, "`to` must be to the right of `from`");
    }
    Ok([from, to])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_outside_the_stretches() {
        let rest = |stretches: &[[f64; 2]]| -> Vec<[f64; 2]> {
            left_out(10.0, stretches).into_iter().map(|(ends, _)| ends).collect()
        };
        assert_eq!(left_out(10.0, &[[2.0, 10.0]]), [([0.0, 2.0], [0.0, 0.2])]);
        assert_eq!(rest(&[]), [[0.0, 10.0]]);
        assert_eq!(rest(&[[4.0, 12.0], [-1.0, 2.0]]), [[2.0, 4.0]]);
        assert_eq!(rest(&[[3.0, 5.0], [5.0, 6.0]]), [[0.0, 3.0], [6.0, 10.0]]);
        assert_eq!(rest(&[[11.0, 12.0]]), [[0.0, 10.0]]);
        assert!(covers(10.0, &[[0.0, 10.0]]));
        assert_eq!(overlapping(&[[4.0, 6.0], [0.0, 5.0], [6.0, 7.0]]), Some(0));
        assert_eq!(overlapping(&[[4.0, 6.0], [0.0, 4.0]]), None);
    }
}
