//! How far loads may grow before the beam first lifts off, and before no equilibrium is left.
//!
//! Some loads stay as they are, D; the others grow, λG. Both questions have closed answers.
//!
//! * *First lift-off.* As long as the beam touches along its whole length the problem is linear: pressure
//!   and concentrated forces are p_D + λ p_G, with the initial gap in p_D ([`bonded`]). The beam touches all
//!   along exactly while none of them is negative: they then are the multiplier of the contact problem, which
//!   has no other solution. The least of p_D + λ p_G over the beam is a concave function of λ, so the factors
//!   at which all of them push are an interval, and Newton's method from above goes down to its upper end
//!   without ever passing it ([`Watched`]).
//! * *Loss of equilibrium.* Each free rigid motion must cost work ([`existence`](crate::existence)), and
//!   the work of the loads is linear in λ: the first root of a few linear functions.

mod bonded;

use crate::assemble::assemble;
use crate::certificate::Certificate;
use crate::existence::{RigidMotion, Verdict, existence, rays};
use crate::model::{Load, Model};
use crate::solve::{Checked, Error, Method, NotConverged, check};
use bonded::{Watched, glued_all_along, watched};

/// What becomes of a model whose loads grow. See [`load_factors`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadFactors {
    /// When the beam first leaves the ground.
    pub first_lift_off: FirstLiftOff,
    /// When no equilibrium is left.
    pub loss_of_equilibrium: LossOfEquilibrium,
}

/// The factor at which a beam that touches along its whole length first leaves the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FirstLiftOff {
    /// However small the factor, the beam does not touch along its whole length. Without loads that stay
    /// and without a gap the fields are proportional to the factor, so it is this or [`Self::Never`].
    AtOnce,
    /// The beam touches along its whole length up to this factor, and beyond it no more.
    At {
        /// λ > 0.
        factor: f64,
        /// Where the ground's pressure, or the concentrated force, is then zero \[m\].
        x: f64,
    },
    /// The beam touches along its whole length however large the factor.
    Never,
}

/// The factor beyond which no equilibrium exists.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LossOfEquilibrium {
    /// However small the factor, there is no equilibrium: the motion never presses on the ground and the
    /// loads gain work in it. The work is that of the loads that stay or, where these do none, of those
    /// that grow, at factor 1.
    AtOnce(RigidMotion),
    /// An equilibrium exists for every smaller factor, and for none a little larger.
    At {
        /// λ > 0.
        factor: f64,
        /// The motion in which the loads gain work beyond the factor. At the factor itself they do none.
        motion: RigidMotion,
    },
    /// An equilibrium exists for every factor.
    Never,
}

/// The factors λ > 0 of the loads for which `grows` says so, by their place in [`Model::loads`], at which
/// the beam first lifts off and at which equilibrium is lost. The other loads, the gap, the supports and the
/// axial force stay as they are.
///
/// ```
/// use groundbeam::{Beam, FirstLiftOff, Foundation, Load, LossOfEquilibrium, Model, load_factors};
///
/// // Kikuchi's example: a force that stays, and a moment that grows.
/// let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
///     .with_load(Load::point(1.0, 0.5))
///     .with_load(Load::moment(1.0, 0.5));
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
/// As [`solve`](crate::solve()). The factor of first lift-off is returned only if the certificate of the
/// fields at that factor holds.
pub fn load_factors(model: &Model, grows: impl Fn(usize) -> bool) -> Result<LoadFactors, Error> {
    let Checked { stability, .. } = check(model)?;
    let parts = Parts::of(model, grows);
    let loss_of_equilibrium = parts.loss_of_equilibrium();
    let first_lift_off = match loss_of_equilibrium {
        LossOfEquilibrium::AtOnce(_) => FirstLiftOff::AtOnce,
        LossOfEquilibrium::At { factor, .. } => parts.first_lift_off(factor, stability)?,
        LossOfEquilibrium::Never => parts.first_lift_off(f64::INFINITY, stability)?,
    };
    Ok(LoadFactors { first_lift_off, loss_of_equilibrium })
}

/// A model under the loads that stay, and under those that grow. Both have all positions of the whole model,
/// and so the same cells; the gap acts with the loads that stay.
struct Parts<'a> {
    model: &'a Model,
    grows: Vec<bool>,
}

impl<'a> Parts<'a> {
    fn of(model: &'a Model, grows: impl Fn(usize) -> bool) -> Self {
        Parts { model, grows: (0..model.loads.len()).map(grows).collect() }
    }

    /// The whole model with the loads that grow at a factor.
    fn at(&self, factor: f64) -> Model {
        let mut model = self.model.clone();
        model.loads = self.loads(|grows| if grows { factor } else { 1.0 });
        model
    }

    /// What stays alone.
    fn staying(&self) -> Model {
        self.at(0.0)
    }

    /// What grows alone, at factor 1.
    fn growing(&self) -> Model {
        let mut model = self.model.clone();
        model.loads = self.loads(|grows| if grows { 1.0 } else { 0.0 });
        for corner in &mut model.gap {
            corner.value = 0.0;
        }
        model
    }

    fn loads(&self, factor: impl Fn(bool) -> f64) -> Vec<Load> {
        let each = self.model.loads.iter().zip(&self.grows);
        each.map(|(load, &grows)| load.scaled(factor(grows))).collect()
    }

    fn loss_of_equilibrium(&self) -> LossOfEquilibrium {
        let mut first = LossOfEquilibrium::Never;
        let mut least = f64::INFINITY;
        let mut undecided = false;
        let staying = rays(&self.staying());
        for ((stays, motion), (grows, growing)) in staying.into_iter().zip(rays(&self.growing())) {
            if stays.is_negative() || (stays.is_zero() && grows.is_negative()) {
                let work = if stays.is_negative() { motion.work } else { growing.work };
                return LossOfEquilibrium::AtOnce(RigidMotion { work, ..motion });
            }
            undecided |= stays.is_zero() && grows.is_zero();
            let factor = stays.sum / -grows.sum;
            if grows.is_negative() && factor < least {
                least = factor;
                first =
                    LossOfEquilibrium::At { factor, motion: RigidMotion { work: 0.0, ..motion } };
            }
        }
        // A motion that never costs anything leaves the question to what stands under an end.
        let within = if least.is_finite() { 0.5 * least } else { 1.0 };
        match existence(&self.at(within)).verdict {
            Verdict::None(motion) if undecided => LossOfEquilibrium::AtOnce(motion),
            _ => first,
        }
    }

    fn first_lift_off(&self, loss: f64, stability: f64) -> Result<FirstLiftOff, Error> {
        let staying = glued_all_along(&self.staying()).map_err(|_| not_found(f64::NAN))?;
        let growing = glued_all_along(&self.growing()).map_err(|_| not_found(f64::NAN))?;
        let all = watched(&staying, &growing);
        if all.iter().any(Watched::pulls_at_first) {
            return Ok(FirstLiftOff::AtOnce);
        }
        let mut least = f64::INFINITY;
        let mut found = FirstLiftOff::Never;
        for place in &all {
            let Some((factor, x)) = place.first_pull_below(least) else { continue };
            if place.is_nothing(factor) {
                return Ok(FirstLiftOff::AtOnce);
            }
            least = factor;
            // A beam in equilibrium under a pressure has one: rounding alone can say otherwise.
            found = FirstLiftOff::At { factor: factor.min(loss), x };
        }
        if least.is_finite() {
            self.prove(least.min(loss), stability)?;
        }
        Ok(found)
    }

    /// The fields at the factor hold their certificate: the beam touches all along up to there.
    fn prove(&self, factor: f64, stability: f64) -> Result<(), Error> {
        let model = self.at(factor);
        let found = glued_all_along(&model).map_err(|_| not_found(f64::NAN))?;
        let solution = assemble(&model, Method::Exact, existence(&model), stability, found);
        let certificate = solution.certificate();
        if certificate.holds() { Ok(()) } else { Err(not_found(certificate.violation())) }
    }
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

#[cfg(test)]
mod tests;
