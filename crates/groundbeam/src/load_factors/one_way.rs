//! Computes the load factor of first lift-off with one-way supports, by ranges of the factor with the same active supports.
//!
//! For fixed active supports and full contact, the force of each active support and the clearance of each inactive
//! support are linear in the load factor. A range of the factor ends where the first of them becomes zero. The supports
//! that are active just beyond the start of a range follow from a linear complementarity problem. Its matrix is
//! positive definite, because the ground alone supports the beam. By Murty's pivoting, the first support whose force or
//! clearance is negative, or is zero and decreases, changes between active and inactive (K. G. Murty, *Note on a
//! Bard-type scheme for solving the complementarity problem*, Opsearch 11 (1974) 123–130).

use crate::cancel::Cancel;
use crate::contact::state::ContactState;
use crate::equilibrium::one_way;
use crate::error::{Error, NotConverged, Stopped};
use crate::existence::work::size_of_loads;
use crate::load_factors::bonded::{bonded_everywhere, lift_off_candidates};
use crate::load_factors::lift_off_candidate::LiftOffCandidate;
use crate::load_factors::parts::{FirstLiftOff, Parts};
use crate::model::{Model, Support};
use crate::numeric::tolerance::GAP;
use crate::options::Method;
use crate::solution::candidate::{Candidate, Workspace};
use crate::solution::certificate::Certificate;

/// Maximum number of ranges of the load factor, and maximum number of changes of the active supports at the
/// beginning of a range.
const MOST_PIECES: usize = 200;
const MOST_CHANGES: usize = 2000;
/// Tolerance for zero forces, relative to the sum of all reactions and loads, and for zero clearances, relative to the
/// largest deflection. The load factor at the start of a range has about this accuracy.
const ZERO_FORCE: f64 = 1e-11;

/// At the load factor at which equilibrium is lost, no certificate exists. The fields are therefore computed at no more
/// than `BEFORE_LOSS` times this load factor.
const BEFORE_LOSS: f64 = 1.0 - 1e-6;

/// A range of factors with the same active supports.
struct FactorRange {
    /// Deflection of the beam on its active supports at the smallest load factor of the range.
    staying: ContactState,
    /// Increase of the deflection of the beam on its active supports, per unit of the load factor.
    growing: ContactState,
    /// Length of the range of load factors.
    growth: f64,
    /// Index of the support whose force or clearance becomes zero at the largest load factor of the range;
    /// `None` if the range is unbounded.
    ends: Option<usize>,
}

/// Computes the factor of first lift-off. It is at most `loss`, the factor of the loss of equilibrium.
pub(crate) fn first_lift_off(
    parts: &Parts,
    loss: f64,
    stability: f64,
    cancel: &Cancel,
) -> Result<FirstLiftOff, Error> {
    let mut acts = vec![true; parts.model.supports.len()];
    let mut from = 0.0;
    let mut ended = None;
    for _ in 0..MOST_PIECES {
        let piece = FactorRange::beginning(parts, from, ended, &mut acts, cancel)?;
        let all = lift_off_candidates(&piece.staying, &piece.growing);
        if from == 0.0 && all.iter().any(LiftOffCandidate::is_tensile_at_zero) {
            return Ok(FirstLiftOff::AtOnce);
        }
        let mut least = piece.growth;
        let mut found = None;
        for place in &all {
            let Some((growth, x)) = place.first_tension_below(least) else { continue };
            if from == 0.0 && place.is_nothing(growth) {
                return Ok(FirstLiftOff::AtOnce);
            }
            (least, found) = (growth, Some(x));
        }
        if let Some(x) = found {
            // First lift-off cannot occur above the load factor at which equilibrium is lost, except by rounding error.
            let factor = (from + least).min(loss);
            prove(parts, factor.min(BEFORE_LOSS * loss), &acts, stability, cancel)?;
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

impl FactorRange {
    /// Returns the range that begins at `factor`. The search starts from the active supports `acts` of the previous
    /// range. The force or clearance of the support `ended`, which ended the previous range, counts as zero.
    fn beginning(
        parts: &Parts,
        factor: f64,
        ended: Option<usize>,
        acts: &mut [bool],
        cancel: &Cancel,
    ) -> Result<Self, Error> {
        let one_way: Vec<bool> = parts.model.supports.iter().map(Support::is_one_way).collect();
        let [stays, grows] = [parts.at(factor), parts.growing()];
        for _ in 0..MOST_CHANGES {
            let [staying, growing] = [&stays, &grows]
                .map(|model| bonded_everywhere(&model.with_supports_that(|i, _| acts[i]), cancel));
            let staying = staying.map_err(|_| not_found(f64::NAN))?;
            let growing = growing.map_err(|_| not_found(f64::NAN))?;
            if !one_way.contains(&true) {
                return Ok(FactorRange { staying, growing, growth: f64::INFINITY, ends: None });
            }
            let mut now = Margins::of(&stays, &staying, acts);
            ended.into_iter().for_each(|i| now.zero[i] = f64::INFINITY);
            let rate = Margins::of(&grows, &growing, acts);
            let wrong =
                |i: &usize| now.is_negative(*i) || (now.is_zero(*i) && rate.is_negative(*i));
            let all = || (0..acts.len()).filter(|i| one_way[*i]);
            if let Some(first) = all().find(wrong) {
                acts[first] = !acts[first];
                continue;
            }
            let falling = all().filter(|i| !now.is_zero(*i) && rate.is_negative(*i));
            let ends = falling.map(|i| (now.margin[i] / -rate.margin[i], i));
            let first = ends.min_by(|a, b| a.0.total_cmp(&b.0));
            let growth = first.map_or(f64::INFINITY, |(growth, _)| growth);
            return Ok(FactorRange { staying, growing, growth, ends: first.map(|(_, i)| i) });
        }
        Err(not_found(f64::NAN))
    }
}

/// Margin of the condition of each support. It is the force of an active support and the clearance of an
/// inactive support.
struct Margins {
    margin: Vec<f64>,
    zero: Vec<f64>,
}

impl Margins {
    fn of(model: &Model, found: &ContactState, acts: &[bool]) -> Self {
        let held = model.with_supports_that(|i, _| acts[i]);
        let candidate = Candidate::of(&held, found, &mut Workspace::default());
        let (forces, all) = one_way::forces(model, acts, &candidate);
        let (clear, size) = one_way::clearances(model, &candidate);
        let each = || 0..acts.len();
        let margin = each().map(|i| if acts[i] { forces[i] } else { clear[i] });
        let all = all + size_of_loads(model);
        let zero = each().map(|i| ZERO_FORCE * if acts[i] { all } else { size });
        Margins { margin: margin.collect(), zero: zero.collect() }
    }

    fn is_zero(&self, i: usize) -> bool {
        self.margin[i].abs() <= self.zero[i]
    }

    fn is_negative(&self, i: usize) -> bool {
        self.margin[i] < -self.zero[i]
    }
}

/// Checks the certificate of the fields at `factor`. The certificate shows that the beam is in contact along its
/// whole length up to this factor.
fn prove(
    parts: &Parts,
    factor: f64,
    acts: &[bool],
    stability: f64,
    cancel: &Cancel,
) -> Result<(), Error> {
    let model = parts.at(factor);
    let held = model.with_supports_that(|i, _| acts[i]);
    let found = bonded_everywhere(&held, cancel).map_err(|_| not_found(f64::NAN))?;
    let mut candidate = Candidate::of(&held, &found, &mut Workspace::default());
    if model.has_one_way_supports() {
        candidate = candidate.on_one_way_supports(&model, acts);
    }
    let gap = Certificate::of(&candidate, stability).relative_gap();
    if gap <= GAP { Ok(()) } else { Err(not_found(gap)) }
}

fn not_found(gap: f64) -> Error {
    let why = NotConverged::LiftOff(gap);
    Error::NotConverged(Stopped { method: Method::Exact, iterations: 0, why })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load_factors::{load_factors, parts::LossOfEquilibrium};
    use crate::model::{Acts, Beam, Foundation, Load};

    const LENGTH: f64 = 2.0;
    const WEIGHT: f64 = 6.0;
    /// Bending stiffness with which the formulas for a rigid beam hold to 10⁻⁶.
    const RIGID: f64 = 1e8;

    /// Returns a beam of length 2 on Winkler ground with k = 5. Its deflection under the load q = 3 is w = 0.6.
    fn weighted(stiffness: f64) -> Model {
        Model::new(Beam::uniform(LENGTH, stiffness), Foundation::winkler(5.0))
            .with_load(Load::uniform_force(0.0, LENGTH, 3.0))
    }

    fn bearing(at: f64, down: f64) -> Support {
        Support::pinned(at).settled(down).acting(Acts::Up)
    }

    fn hold_down(at: f64, down: f64) -> Support {
        Support::pinned(at).settled(down).acting(Acts::Down)
    }

    /// First lift-off under an increasing force at the right end.
    fn lift_off(stiffness: f64, supports: &[Support]) -> FirstLiftOff {
        let mut model = weighted(stiffness).with_load(Load::point_force(LENGTH, 1.0));
        model.supports = supports.to_vec();
        let found = load_factors(&model, |load| load == 1).expect("factors");
        assert_eq!(found.loss_of_equilibrium, LossOfEquilibrium::Never);
        // The mirrored model has the mirrored result.
        let mirrored = load_factors(&model.mirrored(), |load| load == 1).expect("factors");
        match (found.first_lift_off, mirrored.first_lift_off) {
            (FirstLiftOff::At { factor, x }, FirstLiftOff::At { factor: other, x: y }) => {
                near(other, factor);
                assert_eq!(x, LENGTH - y);
            }
            (found, mirrored) => assert_eq!(found, mirrored),
        }
        found.first_lift_off
    }

    #[track_caller]
    fn near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() <= 1e-6 * wanted.abs(), "{found} {wanted}");
    }

    #[track_caller]
    fn leaves_the_left_end(found: FirstLiftOff, at: f64) {
        let FirstLiftOff::At { factor, x } = found else { panic!("{found:?}") };
        near(factor, at);
        assert_eq!(x, 0.0);
    }

    /// Under a force F at the right end, the left end lifts off at F = ql/2. The beam leaves a bearing at the depth δ
    /// under this end earlier, at F = (q − kδ) l/2.
    #[test]
    fn a_bearing_that_the_beam_leaves_does_not_change_the_factor() {
        for supports in [
            vec![],
            vec![bearing(0.0, 0.4)],
            vec![bearing(0.0, 0.4), hold_down(LENGTH, 0.3)],
            // When the force at the right end is half the total load ql, the right end is at the depth 1.8. So it does
            // not touch a bearing at the depth 1.9.
            vec![bearing(LENGTH, 1.9)],
            vec![bearing(0.0, 0.55), bearing(LENGTH, 1.9)],
        ] {
            leaves_the_left_end(lift_off(RIGID, &supports), 0.5 * WEIGHT);
        }
    }

    /// A force at the right end raises the left end and lowers the right end. A hold-down restrains the left end. A
    /// bearing at the right end carries all further force.
    #[test]
    fn a_support_that_the_beam_meets_may_prevent_lift_off() {
        for supports in [
            vec![hold_down(0.0, 0.4)],
            vec![bearing(LENGTH, 0.8)],
            vec![bearing(LENGTH, 0.55)],
            vec![hold_down(0.0, 0.1), bearing(LENGTH, 1.7)],
            vec![hold_down(0.0, 0.5), bearing(LENGTH, 1.7)],
        ] {
            assert_eq!(lift_off(RIGID, &supports), FirstLiftOff::Never, "{supports:?}");
        }
    }

    /// For a support that the beam just touches at the load factor 0, the derivative of its force or clearance decides
    /// whether the support acts.
    #[test]
    fn a_support_that_just_touches_acts_by_its_rate() {
        let free = lift_off(1e3, &[]);
        assert!(matches!(free, FirstLiftOff::At { x: 0.0, .. }));
        for left in [bearing(0.0, 0.6), hold_down(LENGTH, 0.6)] {
            assert_eq!(lift_off(1e3, &[left]), free, "{left:?}");
        }
        for pressed in [hold_down(0.0, 0.6), bearing(LENGTH, 0.6)] {
            assert_eq!(lift_off(1e3, &[pressed]), FirstLiftOff::Never, "{pressed:?}");
        }
    }

    /// A rigid beam of length l on springs k carries the load q and a force F at the right end. At F = kδl − ql, the
    /// beam meets a bearing under the middle at the depth δ. The left end then lifts off at F = kδl/3.
    #[test]
    fn a_support_that_the_beam_meets_may_cause_earlier_lift_off() {
        for (down, at) in [(0.7, 7.0 / 3.0), (0.8, 8.0 / 3.0), (0.85, 8.5 / 3.0)] {
            let middle = bearing(0.5 * LENGTH, down);
            leaves_the_left_end(lift_off(RIGID, &[middle]), at);
            // The beam leaves a bearing under the left end at the depth 0.58 when the force at the right end is 0.1. It
            // meets the bearing under the middle later.
            leaves_the_left_end(lift_off(RIGID, &[bearing(0.0, 0.58), middle]), at);
            leaves_the_left_end(lift_off(RIGID, &[middle, bearing(0.0, 0.58)]), at);
        }
        // The beam lifts off when the force at the right end reaches ql/2 = 3. It would meet a bearing under the middle
        // at the depth 0.91 only when this force reaches 3.1.
        leaves_the_left_end(lift_off(RIGID, &[bearing(0.5 * LENGTH, 0.91)]), 0.5 * WEIGHT);
    }

    /// The supports lift a part of the beam off the ground, even at the load factor 0.
    #[test]
    fn a_bearing_above_the_ground_lifts_the_beam_off_at_once() {
        assert_eq!(lift_off(RIGID, &[bearing(0.0, -0.1)]), FirstLiftOff::AtOnce);
        assert_eq!(lift_off(RIGID, &[bearing(0.5 * LENGTH, -0.1)]), FirstLiftOff::AtOnce);
        assert_eq!(lift_off(RIGID, &[hold_down(0.0, 2.0)]), FirstLiftOff::AtOnce);
    }

    /// On a bearing under the left end at the depth δ = 0.4, the bearing force is (q − kδ) l/4 = 1/2. The right end is
    /// at the depth δ + 3(q − kδ)/(2k) = 0.7, which is 0.2 below the hold-down.
    #[test]
    fn margins_of_a_force_and_of_a_clearance() {
        let model = weighted(RIGID)
            .with_support(bearing(0.0, 0.4))
            .with_support(hold_down(LENGTH, 0.5))
            .with_support(Support::spring(1.0, 1e-12, 0.0));
        let acts = [true, false, true];
        let held = model.with_supports_that(|i, _| acts[i]);
        let found = bonded_everywhere(&held, &Cancel::default()).expect("bonded");
        let Margins { margin, zero } = Margins::of(&model, &found, &acts);
        near(margin[0], 0.5);
        near(margin[1], 0.2);
        // The tolerance of a force is relative to the reactions and the loads. The tolerance of a clearance is
        // relative to the largest deflection.
        near(zero[0], ZERO_FORCE * (0.5 + WEIGHT));
        near(zero[1], ZERO_FORCE * 0.7);
    }

    #[test]
    fn a_margin_within_rounding_error_is_zero() {
        let margins = Margins { margin: vec![-3.0, -2.0, -1.0, 0.0, 2.0, 3.0], zero: vec![2.0; 6] };
        let each = |is: &dyn Fn(usize) -> bool| (0..6).map(is).collect::<Vec<_>>();
        assert_eq!(each(&|i| margins.is_zero(i)), [false, true, true, true, true, false]);
        assert_eq!(each(&|i| margins.is_negative(i)), [true, false, false, false, false, false]);
    }

    /// The certificate for a load factor is accepted if the contact pressure is nowhere tensile, and rejected
    /// otherwise.
    #[test]
    fn a_factor_that_is_too_large_is_refused() {
        let model = weighted(RIGID)
            .with_support(bearing(0.0, 0.4))
            .with_load(Load::point_force(LENGTH, 1.0));
        let parts = Parts::of(&model, |load| load == 1);
        let proves =
            |factor: f64, acts: bool| prove(&parts, factor, &[acts], 1.0, &Cancel::default());
        assert_eq!(proves(0.4 * WEIGHT, false), Ok(()));
        let Err(Error::NotConverged(found)) = proves(0.6 * WEIGHT, false) else {
            panic!("tension")
        };
        assert!(found.why.reached() > found.why.tolerance());
        // If the force at the right end is less than 1, the bearing pushes the beam up. If this force exceeds 1, the
        // bearing would have to pull the beam down.
        assert_eq!(proves(0.9, true), Ok(()));
        assert!(proves(0.9, false).is_err() && proves(1.1, true).is_err());
    }
}
