//! Computes the load factors of the first lift-off and of the loss of equilibrium.
//!
//! The loads D are constant, and the loads λG increase with the factor λ. No solution at a trial value of λ is needed.
//!
//! * *First lift-off.* In full contact, pressure and concentrated forces are p_D + λ p_G (`bonded.rs`). Their minimum
//!   over the beam is a concave function of λ. So Newton's method from above decreases to the largest λ without tension
//!   (`lift_off_candidate.rs`). With one-way supports the problem is piecewise linear (`one_way.rs`).
//! * *Loss of equilibrium.* The loads must do negative work in each free rigid motion
//!   ([`existence`](crate::existence)). This work is linear in λ, so the factor is the first root of a few linear
//!   functions.

mod bonded;
mod lift_off_candidate;
pub(crate) mod one_way;
pub(crate) mod parts;

use crate::equilibrium::buckling::convexity;
use crate::equilibrium::size;
use crate::error::Error;
use crate::load_factors::parts::Parts;
use crate::model::Model;
use crate::options::{Method, Options};
use crate::solve::refuse_invalid;
use crate::supported::{self, Way};

pub use parts::{FirstLiftOff, LossOfEquilibrium};

/// The load factors of a model. See [`load_factors`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadFactors {
    /// The first lift-off of the beam.
    pub first_lift_off: FirstLiftOff,
    /// The loss of equilibrium.
    pub loss_of_equilibrium: LossOfEquilibrium,
}

/// Computes the load factors λ > 0 of first lift-off and of the loss of equilibrium. λ multiplies the loads that
/// `grows` selects by their index in [`Model::loads`]. All other data of the model are constant.
///
/// ```
/// use groundbeam::{Beam, Foundation, Load, Model, load_factors, load_factors::{FirstLiftOff, LossOfEquilibrium}};
///
/// // Kikuchi's example: a constant force, and a moment that increases.
/// let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
///     .with_load(Load::point_force(0.5, 1.0))
///     .with_load(Load::point_moment(0.5, 1.0));
/// let found = load_factors(&model, |load| load == 1)?;
/// let FirstLiftOff::At { factor, x } = found.first_lift_off else { panic!() };
/// assert_eq!((format!("{factor:.12}"), x), ("0.316105124527".to_owned(), 0.0));
/// let LossOfEquilibrium::At { factor, motion } = found.loss_of_equilibrium else { panic!() };
/// assert_eq!((factor, motion.left, motion.right), (0.5, -1.0, 0.0));
/// # Ok::<(), groundbeam::Error>(())
/// ```
///
/// # Errors
///
/// Returns the errors of [`solve`](crate::solve()), [`Error::Unsupported`] for compression that the ground must help to
/// bear, and [`Error::NotConverged`] if the certificate of the fields at first lift-off fails.
pub fn load_factors(model: &Model, grows: impl Fn(usize) -> bool) -> Result<LoadFactors, Error> {
    load_factors_with(model, &Options::default(), grows)
}

/// Computes the [`load_factors`] within the memory limit of the options. The [`Cancel`](crate::Cancel) of the options
/// can stop the computation.
///
/// # Errors
///
/// Returns the errors of [`load_factors`], and [`Error::Cancelled`] after a cancellation.
pub fn load_factors_with(
    model: &Model,
    options: &Options,
    grows: impl Fn(usize) -> bool,
) -> Result<LoadFactors, Error> {
    let found = factors(model, options, grows);
    if options.cancel.is_cancelled() { Err(Error::Cancelled) } else { found }
}

fn factors(
    model: &Model,
    options: &Options,
    grows: impl Fn(usize) -> bool,
) -> Result<LoadFactors, Error> {
    refuse_invalid(model)?;
    let model = &*model.on_given_ground();
    let convexity = convexity(model, &options.cancel);
    supported::check(model, Way::LoadFactors, convexity.is_none())?;
    // The check above refuses a model whose energy is not convex. If it did not, a stability of 0 would make the
    // certificate of this model fail.
    let stability = convexity.unwrap_or(0.0);
    let exact = Options { method: Method::Exact, ..options.clone() };
    size::check(model, &exact)?;
    let parts = Parts::of(model, grows);
    // With only its constant or only its increasing loads, a model may need more elements than with all loads.
    for part in [parts.staying(), parts.growing()] {
        size::check(&part, &exact)?;
    }
    let loss_of_equilibrium = parts.loss_of_equilibrium();
    let first_lift_off = match loss_of_equilibrium {
        LossOfEquilibrium::AtOnce(_) => FirstLiftOff::AtOnce,
        LossOfEquilibrium::At { factor, .. } => {
            one_way::first_lift_off(&parts, factor, stability, &options.cancel)?
        }
        LossOfEquilibrium::Never => {
            one_way::first_lift_off(&parts, f64::INFINITY, stability, &options.cancel)?
        }
    };
    Ok(LoadFactors { first_lift_off, loss_of_equilibrium })
}

#[cfg(test)]
mod tests {
    use super::bonded::bonded_everywhere;
    use super::*;
    use crate::cancel::Cancel;
    use crate::existence::verdict::RigidMotion;
    use crate::model::Load;
    use crate::model::{Beam, Foundation, Support};
    use crate::numeric::elementary::exp;

    fn unit() -> Model {
        Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
    }

    fn rigid(ground: Foundation) -> Model {
        Model::new(Beam::uniform(1.0, 1e9), ground)
    }

    fn all(model: &Model) -> LoadFactors {
        load_factors(model, |_| true).expect("factors")
    }

    /// Returns the load factors if the last load increases and all other loads are constant.
    fn last(model: &Model) -> LoadFactors {
        let last = model.loads.len() - 1;
        load_factors(model, |load| load == last).expect("factors")
    }

    fn lift_off(found: LoadFactors) -> (f64, f64) {
        match found.first_lift_off {
            FirstLiftOff::At { factor, x } => (factor, x),
            other => panic!("{other:?}"),
        }
    }

    fn loss(found: LoadFactors) -> f64 {
        match found.loss_of_equilibrium {
            LossOfEquilibrium::At { factor, .. } => factor,
            other => panic!("{other:?}"),
        }
    }

    #[track_caller]
    fn near(found: f64, wanted: f64, relative: f64) {
        assert!((found - wanted).abs() <= relative * wanted.abs(), "{found} {wanted}");
    }

    #[test]
    fn kikuchi() {
        // With contact along the whole length, the contact force p₀ under the left end is linear in the moment
        // M₀. Its values for M₀ = 0.1 and 0.3 were computed with 60 digits.
        let model =
            unit().with_load(Load::point_force(0.5, 1.0)).with_load(Load::point_moment(0.5, 1.0));
        let [p1, p3] = [0.195_935_998_890_952, 0.014_602_030_694_165];
        let (factor, x) = lift_off(last(&model));
        near(factor, 0.1 + 0.2 * p1 / (p1 - p3), 1e-14);
        assert_eq!(x, 0.0);
        let LossOfEquilibrium::At { factor, motion } = last(&model).loss_of_equilibrium else {
            panic!()
        };
        assert_eq!(
            (factor, motion),
            (0.5, RigidMotion { left: -1.0, right: 0.0, work: 0.0, lifted: None })
        );
        // The mirrored model lifts off at the right end.
        let (factor, x) = lift_off(last(&model.mirrored()));
        near(factor, 0.1 + 0.2 * p1 / (p1 - p3), 1e-14);
        assert_eq!(x, 1.0);
    }

    #[test]
    fn rigid_footings() {
        // A rigid footing of length l under a central force F lifts off at the moment M = F l/6 on Winkler ground, and
        // at M = (1/2 − 4/27) F l on Pasternak ground with μ = k l².
        let footing = |ground| {
            rigid(ground)
                .with_load(Load::point_force(0.5, 2.0))
                .with_load(Load::point_moment(0.3, 1.0))
        };
        let springs = last(&footing(Foundation::winkler(1.0)));
        near(lift_off(springs).0, 2.0 / 6.0, 1e-8);
        near(loss(springs), 1.0, 1e-15);
        let layer = last(&footing(Foundation::pasternak(1.0, 1.0)));
        near(lift_off(layer).0, 2.0 * (0.5 - 4.0 / 27.0), 1e-8);
        // The more flexible the beam, the more the pressure concentrates under the force, and the smaller the
        // load factor of first lift-off.
        let mut before = 0.0;
        for stiffness in [1e-2, 1e-1, 1.0, 10.0] {
            let mut model = footing(Foundation::winkler(1.0));
            model.beam.bending_stiffness = stiffness;
            let (factor, _) = lift_off(last(&model));
            assert!(before < factor && factor < 2.0 / 6.0, "{stiffness}: {factor}");
            before = factor;
        }
    }

    #[test]
    fn a_heavy_infinite_beam_under_a_force() {
        // By Weitsman (1970), an infinite beam of weight q per length first lifts off at the distance π/β from a
        // downward force F = 2 e^π q/β, with β⁴ = k/(4 EI).
        let model = Model::new(Beam::uniform(60.0, 1.0), Foundation::winkler(4.0))
            .with_load(Load::uniform_force(0.0, 60.0, 3.0))
            .with_load(Load::point_force(30.0, 1.0));
        let (factor, x) = lift_off(last(&model));
        near(factor, 6.0 * exp(std::f64::consts::PI), 1e-12);
        near((x - 30.0).abs(), std::f64::consts::PI, 1e-7);
        assert_eq!(last(&model).loss_of_equilibrium, LossOfEquilibrium::Never);
    }

    #[test]
    fn a_weightless_beam_lifts_off_at_once_or_never() {
        // By Lovtsov (2025), a beam of length l under downward forces at its ends lifts off in the middle if αl > π,
        // with α⁴ = k/(4 EI).
        for (l, wanted) in [(3.1, FirstLiftOff::Never), (3.2, FirstLiftOff::AtOnce)] {
            let model = Model::new(Beam::uniform(l, 1.0), Foundation::winkler(4.0))
                .with_load(Load::point_force(0.0, 1.0))
                .with_load(Load::point_force(l, 1.0));
            let found = all(&model);
            assert_eq!(found.first_lift_off, wanted, "{l}");
            assert_eq!(found.loss_of_equilibrium, LossOfEquilibrium::Never);
        }
        // A weightless beam under a moment alone has no equilibrium.
        let tips = all(&unit().with_load(Load::point_moment(0.2, 1.0)));
        assert_eq!(tips.first_lift_off, FirstLiftOff::AtOnce);
        let motion = RigidMotion { left: -1.0, right: 0.0, work: 1.0, lifted: None };
        assert_eq!(tips.loss_of_equilibrium, LossOfEquilibrium::AtOnce(motion));
    }

    #[test]
    fn a_zero_pressure_at_an_end_is_not_tensile() {
        // On Winkler ground a triangular load causes a triangular pressure, which is zero at one end.
        for (start, end) in [(0.0, 2.0), (2.0, 0.0)] {
            for (l, ei) in [(1.0, 1.0), (7.3, 1e-3), (0.1, 1e6)] {
                let triangle = Load::distributed_force(0.0, l, start, end);
                let model =
                    Model::new(Beam::uniform(l, ei), Foundation::winkler(3.0)).with_load(triangle);
                assert_eq!(all(&model).first_lift_off, FirstLiftOff::Never, "{l} {ei}");
                // The increasing load is −1/4 of the constant load. At the factor 4 the two loads cancel, and
                // the whole beam lifts off.
                let less = model.clone().with_load(triangle.scaled(-0.25));
                near(lift_off(last(&less)).0, 4.0, 1e-12);
                near(loss(last(&less)), 4.0, 1e-14);
                // The pressure is zero at one end of the beam, so any upward load lifts this end off the ground.
                let pulled = model.with_load(Load::uniform_force(0.0, l, -1e-3));
                assert_eq!(last(&pulled).first_lift_off, FirstLiftOff::AtOnce);
            }
        }
    }

    #[test]
    fn next_to_a_pin_the_slope_of_the_pressure_decides() {
        // On Winkler ground the pressure p = k w is zero at a pin. First lift-off occurs when the beam's slope
        // at the pin becomes zero.
        let model = Model::new(Beam::uniform(2.0, 1.0), Foundation::winkler(1.0))
            .with_support(Support::pinned(0.0))
            .with_support(Support::pinned(2.0))
            .with_load(Load::uniform_force(0.0, 2.0, 1.0))
            .with_load(Load::point_moment(0.0, -1.0));
        let (factor, x) = lift_off(last(&model));
        assert_eq!(x, 0.0);
        let slope = |factor: f64| {
            let parts = Parts::of(&model, |load| load == 1);
            let found = bonded_everywhere(&parts.at(factor), &Cancel::default()).expect("bonded");
            crate::numeric::polynomial::jet(found.deflection().cell(0), -1.0)[1]
        };
        assert!(slope(factor).abs() < 1e-14 * slope(0.0).abs(), "{:e}", slope(factor));
        assert_eq!(last(&model).loss_of_equilibrium, LossOfEquilibrium::Never);
        // At a clamp on Winkler ground, the pressure and its slope are zero. So the curvature of the pressure decides
        // whether the beam lifts off beside the clamp.
        let mut clamped = model.clone();
        clamped.supports[0] = Support::fixed(0.0);
        clamped.loads[1] = Load::point_force(0.5, -1.0);
        let (factor, x) = lift_off(last(&clamped));
        assert!(factor > 0.0 && x < 1.0);
    }

    #[test]
    fn constant_loads_may_lift_the_beam_off() {
        let outside =
            unit().with_load(Load::point_force(0.5, 1.0)).with_load(Load::point_moment(0.5, 0.6));
        let held = outside.with_load(Load::point_force(0.0, 1.0));
        let found = last(&held);
        let LossOfEquilibrium::AtOnce(motion) = found.loss_of_equilibrium else {
            panic!("{found:?}")
        };
        assert_eq!((motion.left, motion.right), (-1.0, 0.0));
        near(motion.work, 0.1, 1e-14);
        assert_eq!(found.first_lift_off, FirstLiftOff::AtOnce);
        // The tension force resists rotation, so an equilibrium exists for every moment. If the moment exceeds
        // the moment of first lift-off, only a part of the beam is in contact.
        let mut tied = held;
        tied.beam.axial_force = 2.0;
        assert_eq!(last(&tied).loss_of_equilibrium, LossOfEquilibrium::Never);
        assert_eq!(last(&tied).first_lift_off, FirstLiftOff::Never);
        tied.loads[1] = Load::point_moment(0.5, 1.5);
        assert_eq!(last(&tied).first_lift_off, FirstLiftOff::AtOnce);
    }

    #[test]
    fn a_force_over_an_end_needs_a_shear_layer() {
        let over_the_end = |ground| {
            Model::new(Beam::uniform(1.0, 1.0), ground).with_load(Load::point_force(0.0, 1.0))
        };
        let springs = all(&over_the_end(Foundation::winkler(1.0)));
        assert!(matches!(springs.loss_of_equilibrium, LossOfEquilibrium::AtOnce(_)));
        let layer = all(&over_the_end(Foundation::pasternak(1.0, 1.0)));
        assert_eq!(layer.loss_of_equilibrium, LossOfEquilibrium::Never);
        assert_eq!(layer.first_lift_off, FirstLiftOff::AtOnce);
    }

    #[test]
    fn the_gap_acts_with_the_constant_loads() {
        // A rigid beam of length l under a uniform load with the resultant F lifts off at the moment F l/6 about its
        // middle. A constant initial gap does not change the pressure.
        let ground = Foundation::winkler(1.0);
        let footing = rigid(ground)
            .with_load(Load::uniform_force(0.0, 1.0, 1.0))
            .with_load(Load::point_moment(0.5, 1.0))
            .with_gap(0.0, 0.1)
            .with_gap(1.0, 0.1);
        near(lift_off(last(&footing)).0, 1.0 / 6.0, 1e-8);
        let mut deep = footing.clone();
        deep.loads[0] = Load::point_force(0.5, 1.0);
        deep.gap = vec![];
        let deep = deep.with_gap(0.0, 3.0).with_gap(0.5, 0.0).with_gap(1.0, 3.0);
        assert_eq!(last(&deep).first_lift_off, FirstLiftOff::AtOnce);
        // If all loads increase from zero, the gap is open at small factors.
        assert_eq!(all(&footing).first_lift_off, FirstLiftOff::AtOnce);
    }

    #[test]
    fn a_long_part_without_loads_is_refused_by_its_size() {
        let model = Model::new(Beam::uniform(1e16, 1.0), Foundation::winkler(4.0))
            .with_load(Load::uniform_force(0.0, 1e16, 1.0));
        assert!(matches!(load_factors(&model, |_| true), Err(Error::TooLarge(_))));
    }

    #[test]
    fn constant_loads_and_invalid_models() {
        let model = unit().with_load(Load::point_force(0.5, 1.0));
        let found = load_factors(&model, |_| false).expect("factors");
        assert_eq!(found.first_lift_off, FirstLiftOff::Never);
        assert_eq!(found.loss_of_equilibrium, LossOfEquilibrium::Never);
        let mut wrong = model.clone();
        wrong.beam.length = -1.0;
        assert!(matches!(load_factors(&wrong, |_| true), Err(Error::Invalid(_))));
        let mut pushed = model;
        pushed.beam.axial_force = -1.0;
        assert!(matches!(load_factors(&pushed, |_| true), Err(Error::Unsupported(_))));
    }

    /// Under forces at the middle, the static reactions at both ends vanish at the same load factor. The result names
    /// the motion that lifts the left end.
    #[test]
    fn of_two_simultaneous_motions_the_first_is_named() {
        let model =
            unit().with_load(Load::point_force(0.5, 2.0)).with_load(Load::point_force(0.5, -1.0));
        let LossOfEquilibrium::At { factor, motion } = last(&model).loss_of_equilibrium else {
            panic!()
        };
        assert_eq!((factor, motion.left, motion.right), (2.0, -1.0, 0.0));
        assert_eq!(motion.work.to_bits(), 0);
    }

    /// A hinge divides the beam of length l in the middle. The left half carries the load q and an upward force λ at
    /// its left end. Equilibrium is lost if λ exceeds ql/4, the reaction to q at this end.
    #[test]
    fn an_unloaded_piece_does_not_decide() {
        for q in [0.125, 1.0, 8.0, 64.0] {
            let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::winkler(1.0))
                .with_hinge(crate::model::Hinge::free(0.5))
                .with_load(Load::uniform_force(0.0, 0.5, q))
                .with_load(Load::point_force(0.0, -1.0));
            near(loss(last(&model)), 0.25 * q, 1e-15);
        }
    }
}
