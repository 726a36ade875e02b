//! A stiffness as one number or as the product of two, and what segments leave of a whole.

use super::error::{Read, Reason, fault};
use super::fields::{Along, Section};
use crate::Scalar;

/// What a table says of a stiffness: itself, or its two factors.
#[derive(Debug, Clone)]
pub(crate) struct Given<S> {
    pub whole: Option<Along<S>>,
    pub factors: [Option<Along<S>>; 2],
}

/// What follows.
pub(crate) enum Found<S> {
    Known(Along<S>),
    /// Nothing is said.
    Nothing,
    /// One factor is not known: its key.
    Half(&'static str),
}

impl<S: Scalar> Given<S> {
    pub fn nothing() -> Self {
        Given { whole: None, factors: [None, None] }
    }

    pub fn is_nothing(&self) -> bool {
        self.whole.is_none() && self.factors.iter().all(Option::is_none)
    }

    /// On a part of the way.
    pub fn between(&self, way: [S; 2]) -> Self {
        let part = |along: &Option<Along<S>>| along.as_ref().map(|along| along.between(way));
        Given {
            whole: part(&self.whole),
            factors: [part(&self.factors[0]), part(&self.factors[1])],
        }
    }

    /// The stiffness. A table that gives one factor takes the other from `parent`. `names` are the keys of the
    /// whole and of the factors.
    pub fn resolve(&self, parent: &Given<S>, names: [&'static str; 3]) -> Read<Found<S>> {
        let own = self.factors.iter().position(Option::is_some);
        match (&self.whole, own) {
            (Some(whole), None) => return Ok(Found::Known(whole.clone())),
            (Some(whole), Some(i)) => {
                return fault(whole.at, Reason::Together(names[0], names[1 + i]));
            }
            (None, None) => return Ok(Found::Nothing),
            (None, Some(_)) => {}
        }
        let factor = |i: usize| self.factors[i].as_ref().or(parent.factors[i].as_ref());
        Ok(match (factor(0), factor(1)) {
            (Some(a), Some(b)) => Found::Known(a.times(b)),
            (None, _) => Found::Half(names[1]),
            (_, None) => Found::Half(names[2]),
        })
    }
}

impl<S> Found<S> {
    /// The stiffness that must be known; `name` is its key.
    pub fn known(self, section: Section, name: &'static str) -> Read<Along<S>> {
        match self {
            Found::Known(along) => Ok(along),
            Found::Nothing => section.missing(name),
            Found::Half(other) => section.missing(other),
        }
    }
}

/// Whether a < b is certain.
pub(crate) fn is_left<S: Scalar>(a: S, b: S) -> bool {
    (b - a).low() > 0.0
}

/// The stretches of 0 to `length` that others leave out, from left to right, and each as parts of the length. Where
/// nothing stands, the whole is left out, from 0 to 1 exactly.
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

/// Whether stretches leave nothing of 0 to `length`.
pub(crate) fn covers<S: Scalar>(length: S, stretches: &[[S; 2]]) -> bool {
    left_out(length, stretches).is_empty()
}

/// Whether two of the stretches certainly overlap: the index of one of them.
pub(crate) fn overlapping<S: Scalar>(stretches: &[[S; 2]]) -> Option<usize> {
    let mut order: Vec<usize> = (0..stretches.len()).collect();
    order.sort_by(|a, b| stretches[*a][0].middle().total_cmp(&stretches[*b][0].middle()));
    order
        .windows(2)
        .find(|pair| is_left(stretches[pair[1]][0], stretches[pair[0]][1]))
        .map(|p| p[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stretches_leave_out() {
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
