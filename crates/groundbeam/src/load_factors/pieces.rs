//! First lift-off, piece by piece of the factors over which the same supports act.
//!
//! A beam that touches along its whole length is a linear problem but for supports that act in one direction alone: on
//! the supports that act, what each pushes with and how far the beam is from the others are linear in λ. Together they
//! are a linear complementarity problem with a positive definite matrix, for the ground alone holds the beam, and so the
//! supports that act just beyond a factor are found by Murty's principal pivoting: the first support that breaks its
//! condition, at the factor or else by its rate, changes (K. G. Murty, *Note on a Bard-type scheme for solving the
//! complementarity problem*, Opsearch 11 (1974) 123–130). They stay until the first of these numbers is zero, and there
//! the next piece begins.

use super::bonded::{Watched, glued_all_along, watched};
use crate::certificate::Certificate;
use crate::contact::state::Found;
use crate::equilibrium::one_way;
use crate::error::{Error, NotConverged};
use crate::existence::existence::{Existence, existence, size_of_loads};
use crate::load_factors::parts::{FirstLiftOff, Parts};
use crate::model::{Model, Support};
use crate::options::Method;
use crate::solution::assemble::{self, assemble};

/// Pieces, and changes of the supports at the beginning of one, that end the search.
const MOST_PIECES: usize = 200;
const MOST_CHANGES: usize = 2000;
/// A force, relative to all of them and the loads, and a clearance, relative to the deflections, that are zero: what the factor at
/// which a piece begins is known to.
const ZERO: f64 = 1e-11;

/// Factors from one on, over which the same supports act.
struct Piece {
    /// The model at the factor on which it begins, and the fields there and per factor, on the supports that act.
    staying: Found,
    growing: Found,
    /// How much the factor may grow, and the support whose condition then is at its end.
    growth: f64,
    ends: Option<usize>,
}

/// The factor of first lift-off, which is not beyond that at which equilibrium is lost.
pub(super) fn first_lift_off(
    parts: &Parts,
    loss: f64,
    stability: f64,
) -> Result<FirstLiftOff, Error> {
    let mut acts = vec![true; parts.model.supports.len()];
    let mut from = 0.0;
    let mut ended = None;
    for _ in 0..MOST_PIECES {
        let piece = Piece::beginning(parts, from, ended, &mut acts)?;
        let all = watched(&piece.staying, &piece.growing);
        if from == 0.0 && all.iter().any(Watched::pulls_at_first) {
            return Ok(FirstLiftOff::AtOnce);
        }
        let mut least = piece.growth;
        let mut found = None;
        for place in &all {
            let Some((growth, x)) = place.first_pull_below(least) else { continue };
            if from == 0.0 && place.is_nothing(growth) {
                return Ok(FirstLiftOff::AtOnce);
            }
            (least, found) = (growth, Some(x));
        }
        if let Some(x) = found {
            // A beam in equilibrium under a pressure has one: rounding alone can say otherwise.
            let factor = (from + least).min(loss);
            prove(parts, factor, &acts, stability)?;
            return Ok(FirstLiftOff::At { factor, x });
        }
        if piece.growth == f64::INFINITY {
            return Ok(FirstLiftOff::Never);
        }
        from += piece.growth;
        ended = piece.ends;
    }
    Err(not_found(f64::NAN))
}

impl Piece {
    /// The piece that begins at a factor, from the supports that act before it to those that act on it.
    /// The support whose condition `ended` the piece before has nothing left of it, whatever rounding says.
    fn beginning(
        parts: &Parts,
        factor: f64,
        ended: Option<usize>,
        acts: &mut [bool],
    ) -> Result<Self, Error> {
        let one_way: Vec<bool> = parts.model.supports.iter().map(Support::is_one_way).collect();
        let [stays, grows] = [parts.at(factor), parts.growing()];
        for _ in 0..MOST_CHANGES {
            let [staying, growing] = [&stays, &grows]
                .map(|model| glued_all_along(&model.with_supports_that(|i, _| acts[i])));
            let staying = staying.map_err(|_| not_found(f64::NAN))?;
            let growing = growing.map_err(|_| not_found(f64::NAN))?;
            if !one_way.contains(&true) {
                return Ok(Piece { staying, growing, growth: f64::INFINITY, ends: None });
            }
            let mut now = Room::of(&stays, &staying, acts);
            ended.into_iter().for_each(|i| now.zero[i] = f64::INFINITY);
            let rate = Room::of(&grows, &growing, acts);
            let wrong =
                |i: &usize| now.is_negative(*i) || (now.is_zero(*i) && rate.is_negative(*i));
            let all = || (0..acts.len()).filter(|i| one_way[*i]);
            if let Some(first) = all().find(wrong) {
                acts[first] = !acts[first];
                continue;
            }
            let falling = all().filter(|i| !now.is_zero(*i) && rate.is_negative(*i));
            let ends = falling.map(|i| (now.left[i] / -rate.left[i], i));
            let first = ends.min_by(|a, b| a.0.total_cmp(&b.0));
            let growth = first.map_or(f64::INFINITY, |(growth, _)| growth);
            return Ok(Piece { staying, growing, growth, ends: first.map(|(_, i)| i) });
        }
        Err(not_found(f64::NAN))
    }
}

/// What is left of each support's condition: the force of one that acts, the clearance of one that does not.
struct Room {
    left: Vec<f64>,
    zero: Vec<f64>,
}

impl Room {
    fn of(model: &Model, found: &Found, acts: &[bool]) -> Self {
        let held = model.with_supports_that(|i, _| acts[i]);
        let solution = assemble(&held, Method::Exact, Existence::default(), 1.0, found, None);
        let (forces, all) = one_way::forces(model, acts, &solution);
        let (clear, size) = one_way::clearances(model, &solution);
        let each = || 0..acts.len();
        let left = each().map(|i| if acts[i] { forces[i] } else { clear[i] });
        let all = all + size_of_loads(model);
        let zero = each().map(|i| ZERO * if acts[i] { all } else { size });
        Room { left: left.collect(), zero: zero.collect() }
    }

    fn is_zero(&self, i: usize) -> bool {
        self.left[i].abs() <= self.zero[i]
    }

    fn is_negative(&self, i: usize) -> bool {
        self.left[i] < -self.zero[i]
    }
}

/// The fields at the factor hold their certificate: the beam touches all along up to there.
fn prove(parts: &Parts, factor: f64, acts: &[bool], stability: f64) -> Result<(), Error> {
    let model = parts.at(factor);
    let held = model.with_supports_that(|i, _| acts[i]);
    let found = glued_all_along(&held).map_err(|_| not_found(f64::NAN))?;
    let stands = existence(&model);
    let mut solution = assemble(&held, Method::Exact, stands, stability, &found, None);
    if model.has_one_way_supports() {
        assemble::on_one_way_supports(&mut solution, &model, acts, stands, stability);
    }
    let certificate = solution.certificate();
    if certificate.holds() { Ok(()) } else { Err(not_found(certificate.violation())) }
}

fn not_found(reached: f64) -> Error {
    Error::NotConverged(NotConverged {
        method: Method::Exact,
        iterations: 0,
        tolerance: Certificate::TOLERANCE,
        reached,
        what: "at the factor of first lift-off, the certificate's largest violation",
    })
}
