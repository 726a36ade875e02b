//! A stiffness that is given as one number or as the product of two factors.

use super::error::{Read, Reason, fault};
use super::fields::{Along, Section};
use crate::Scalar;

/// A stiffness in a table: one number, or its two factors.
#[derive(Debug, Clone)]
pub(crate) struct Given<S> {
    pub whole: Option<Along<S>>,
    pub factors: [Option<Along<S>>; 2],
}

/// The stiffness that follows from the keys of a table.
pub(crate) enum Found<S> {
    Known(Along<S>),
    /// The table has no key of the stiffness or of its factors.
    Nothing,
    /// One factor of the stiffness is missing; the value is the key of this factor.
    Half(&'static str),
}

impl<S: Scalar> Given<S> {
    pub fn nothing() -> Self {
        Given { whole: None, factors: [None, None] }
    }

    pub fn is_nothing(&self) -> bool {
        self.whole.is_none() && self.factors.iter().all(Option::is_none)
    }

    /// Restricts the stiffness, or its two factors, to a part of the stretch of the beam to which it applies. The part
    /// begins and ends at the fractions `way` of the length of the stretch.
    pub fn between(&self, way: [S; 2]) -> Self {
        let part = |along: &Option<Along<S>>| along.as_ref().map(|along| along.between(way));
        Given {
            whole: part(&self.whole),
            factors: [part(&self.factors[0]), part(&self.factors[1])],
        }
    }

    /// Computes the stiffness. If a table has only one factor, the other factor is taken from `parent`. `names` are
    /// the keys of the stiffness and of its factors.
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
    /// Returns the stiffness, or an error if a key is missing. `name` is the key of the stiffness.
    pub fn known(self, section: Section, name: &'static str) -> Read<Along<S>> {
        match self {
            Found::Known(along) => Ok(along),
            Found::Nothing => section.missing(name),
            Found::Half(other) => section.missing(other),
        }
    }
}
