//! Assigns each position of the model, such as that of a load or a support, to one node of the claimed solution.

use crate::answer::Answer;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::units::Units;

/// Maximum distance of a position of the model from its node, as a fraction of the beam's length.
const NEAR: f64 = 16.0 * f64::EPSILON;
/// Minimum distance between two positions of the model, as a fraction of the beam's length.
const APART: f64 = 32.0 * f64::EPSILON;
/// Minimum length of a piece, as a fraction of the beam's length.
const SHORTEST: f64 = 1e-20;

/// The nodes, which are the ends of the pieces of the claimed solution. `given` holds the exact position of each node
/// that is at a position of the model.
#[derive(Debug)]
pub(crate) struct Positions<S> {
    /// Stored positions of the nodes, in the scaled unit of length.
    stored: Vec<S>,
    given: Vec<Option<S>>,
    length: S,
    units: Units,
}

/// Whether two positions on a beam differ at most by rounding error.
pub(crate) fn is_near<S: Scalar>(a: S, b: S, length: S) -> bool {
    (a - b).size() <= NEAR * length.low()
}

impl<S: Scalar> Positions<S> {
    pub fn of(answer: &Answer, length: S, units: Units) -> Result<Self, NotProven> {
        let first =
            answer.pieces.first().ok_or_else(|| NotProven::new("the answer has no pieces"))?;
        let mut stored = Vec::with_capacity(answer.pieces.len() + 1);
        stored.push(units.metres(S::of(first.x[0])));
        let mut end = first.x[0];
        for piece in &answer.pieces {
            if !(piece.x[0] == end && piece.x[0] < piece.x[1]) {
                let what = "the pieces are not in order from left to right";
                return Err(NotProven::new(what).at(piece.x[0]));
            }
            end = piece.x[1];
            stored.push(units.metres(S::of(end)));
        }
        let given = vec![None; stored.len()];
        let mut positions = Positions { stored, given, length, units };
        let last = positions.last();
        if positions.find(S::zero())? != 0 || positions.find(length)? != last {
            return Err(NotProven::new("the pieces do not cover the beam"));
        }
        Ok(positions)
    }

    /// The index of the last node.
    pub fn last(&self) -> usize {
        self.stored.len() - 1
    }

    /// The node nearest to a position.
    fn nearest(&self, at: S) -> usize {
        let after = self.stored.partition_point(|node| node.middle() < at.middle());
        let distance = |i: usize| (at - self.stored[i]).size();
        match after {
            0 => 0,
            _ if after > self.last() => self.last(),
            _ if distance(after - 1) <= distance(after) => after - 1,
            _ => after,
        }
    }

    fn reached(&self, node: usize, at: S) -> bool {
        is_near(at, self.stored[node], self.length)
    }

    /// Returns the node at a position of the model, and gives the node this exact position. In plain doubles, positions
    /// that differ by rounding error share a node, which keeps the first of these positions.
    pub fn find(&mut self, at: S) -> Result<usize, NotProven> {
        let node = self.nearest(at);
        let place = self.units.restored(at.middle(), 0, 1);
        if !self.reached(node, at) {
            return Err(NotProven::new(
                "a load, support, hinge, gap corner or end of a segment is not at an end of a piece",
            )
            .at(place));
        }
        match self.given[node] {
            Some(other) if other != at && S::ENCLOSES => {
                Err(NotProven::new("two positions of the model are too close to tell apart")
                    .at(place))
            }
            given => {
                self.given[node] = given.or(Some(at));
                Ok(node)
            }
        }
    }

    /// Whether a position is outside the beam.
    pub fn is_beside(&self, at: S) -> bool {
        at.high() < 0.0 || (at - self.length).low() > 0.0
    }

    /// Finds the node at an end of a stretch, as [`Self::find`] does. For a position outside the beam, returns the
    /// node at the beam's end.
    pub fn find_clipped(&mut self, at: S) -> Result<usize, NotProven> {
        if at.high() < 0.0 {
            Ok(0)
        } else if (at - self.length).low() > 0.0 {
            Ok(self.last())
        } else {
            self.find(at)
        }
    }

    /// The node at the position `x` of a claimed force; `None` if no node is at this position.
    pub fn of_force(&self, x: f64) -> Option<usize> {
        let at = self.units.metres(S::of(x));
        let node = self.nearest(at);
        self.reached(node, at).then_some(node)
    }

    /// Returns the exact positions of the nodes, after a check that they increase from left to right.
    pub fn exact(self) -> Result<Vec<S>, NotProven> {
        let stored = self.stored.iter().zip(&self.given);
        let exact: Vec<S> = stored.map(|(stored, given)| given.unwrap_or(*stored)).collect();
        let place = |x: S| self.units.restored(x.middle(), 0, 1);
        for ends in exact.windows(2) {
            if !((ends[1] - ends[0]).low() >= SHORTEST * self.length.high()) {
                return Err(
                    NotProven::new("the ends of a piece are too close together").at(place(ends[0]))
                );
            }
        }
        if !S::ENCLOSES {
            return Ok(exact);
        }
        let given: Vec<S> = self.given.iter().flatten().copied().collect();
        for pair in given.windows(2) {
            if !((pair[1] - pair[0]).low() > APART * self.length.high()) {
                let what = "two positions of the model are too close to tell apart";
                return Err(NotProven::new(what).at(place(pair[0])));
            }
        }
        Ok(exact)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Piece;
    use crate::wide::Wide;

    fn covers(ends: &[f64]) -> bool {
        let piece = |x: &[f64]| Piece { x: [x[0], x[1]], ..Piece::default() };
        let answer = Answer { pieces: ends.windows(2).map(piece).collect(), ..Answer::default() };
        let units = Units { length: 0, force: 0 };
        Positions::of(&answer, Wide::of(1.0), units).is_ok()
    }

    #[test]
    fn the_pieces_begin_and_end_with_the_beam() {
        for (ends, covered) in [
            (&[0.0, 1.0][..], true),
            (&[0.0, 0.5, 1.0], true),
            (&[1e-15, 1.0 - 1e-15], true),
            (&[-0.5, 0.0, 1.0], false),
            (&[0.0, 1.0, 1.5], false),
            (&[-0.5, 0.0, 1.0, 1.5], false),
            (&[0.0, 0.5], false),
            (&[0.5, 1.0], false),
            (&[0.0, 0.6, 0.5, 1.0], false),
            (&[0.0, 0.5, 0.5, 1.0], false),
        ] {
            assert_eq!(covers(ends), covered, "{ends:?}");
        }
    }

    /// Whether the pieces of a beam of length 1.5 are accepted as long enough. The first three nodes are at 0,
    /// `second` and `third`, and the last node is at 1.5.
    fn is_long_enough(second: f64, third: f64) -> bool {
        let ends = [0.0, second, third, 1.5];
        let piece = |x: &[f64]| Piece { x: [x[0], x[1]], ..Piece::default() };
        let answer = Answer { pieces: ends.windows(2).map(piece).collect(), ..Answer::default() };
        let units = Units { length: 0, force: 0 };
        let positions = Positions::of(&answer, Wide::of(1.5), units).expect("positions");
        positions.exact().is_ok()
    }

    /// The beam is 1.5 long, so each piece must be at least 1.5·10⁻²⁰ long: 10⁻²⁰ times the length of the beam.
    #[test]
    fn a_piece_has_a_least_length() {
        for (second, third, long) in [
            (1.6e-20, 1.0, true),
            (1.4e-20, 1.0, false),
            (0.8e-20, 1.0, false),
            (2e-20, 3.6e-20, true),
            (2e-20, 3.4e-20, false),
            (2e-20, 2.5e-20, false),
        ] {
            assert_eq!(is_long_enough(second, third), long, "{second} {third}");
        }
    }
}
