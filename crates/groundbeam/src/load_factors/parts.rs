//! Splits the loads into constant and increasing loads, and computes the load factor at which equilibrium is lost.

use crate::existence::existence::existence;
use crate::existence::verdict::{RigidMotion, Verdict};
use crate::existence::work::rays;
use crate::model::{Load, Model};

/// The factor at which a beam in contact along its whole length first lifts off.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(tag = "when", rename_all = "kebab-case"))]
pub enum FirstLiftOff {
    /// A part of the beam is out of contact at every factor, however small. Without constant loads and without a gap,
    /// only this variant and [`Self::Never`] are possible.
    AtOnce,
    /// The beam is in contact along its whole length up to `factor`. At larger factors a part of the beam is
    /// out of contact.
    #[cfg_attr(feature = "serde", serde(rename = "at-factor"))]
    At {
        /// The load factor λ > 0.
        factor: f64,
        /// The position at which the pressure or a concentrated force is zero at this factor \[m\].
        x: f64,
    },
    /// The beam is in contact along its whole length at every factor.
    Never,
}

/// Model whose loads are split into constant and increasing loads. The gap and the settlements of supports belong to
/// the constant loads. The models of both groups have the same required nodes.
pub(crate) struct Parts<'a> {
    pub model: &'a Model,
    pub grows: Vec<bool>,
}

impl<'a> Parts<'a> {
    pub fn of(model: &'a Model, grows: impl Fn(usize) -> bool) -> Self {
        Parts { model, grows: (0..model.loads.len()).map(grows).collect() }
    }

    /// The whole model, with the increasing loads multiplied by a factor.
    pub fn at(&self, factor: f64) -> Model {
        let mut model = self.model.clone();
        model.loads = self.loads(|grows| if grows { factor } else { 1.0 });
        model
    }

    /// Returns the model with the constant loads only.
    pub fn staying(&self) -> Model {
        self.at(0.0)
    }

    /// Returns the model with the increasing loads only, at factor 1.
    pub fn growing(&self) -> Model {
        let mut model = self.model.clone();
        model.loads = self.loads(|grows| if grows { 1.0 } else { 0.0 });
        for corner in &mut model.gap {
            corner.value = 0.0;
        }
        for support in &mut model.supports {
            support.settlement = 0.0;
        }
        model
    }

    pub fn loads(&self, factor: impl Fn(bool) -> f64) -> Vec<Load> {
        let each = self.model.loads.iter().zip(&self.grows);
        each.map(|(load, &grows)| load.scaled(factor(grows))).collect()
    }

    pub fn loss_of_equilibrium(&self) -> LossOfEquilibrium {
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
        // If neither group of loads does work in some rigid motion, concentrated contact forces of a shear layer or a
        // support decide whether an equilibrium exists. A check at one load factor below `least` is sufficient.
        let within = if least.is_finite() { 0.5 * least } else { 1.0 };
        match existence(&self.at(within)).verdict {
            Verdict::None(motion) if undecided => LossOfEquilibrium::AtOnce(motion),
            _ => first,
        }
    }
}

/// The factor beyond which no equilibrium exists.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LossOfEquilibrium {
    /// No equilibrium exists at any load factor. In this rigid motion, the beam presses nowhere on the ground, and one
    /// of three cases applies:
    ///
    /// * The constant loads do positive work.
    /// * The constant loads do no work, and the increasing loads do positive work.
    /// * Both groups of loads do no work, and one load needs a concentrated contact force that the ground cannot exert.
    AtOnce(RigidMotion),
    /// An equilibrium exists for every factor below `factor`, but for no factor slightly above it.
    At {
        /// The load factor λ > 0.
        factor: f64,
        /// The rigid motion in which the loads do positive work if the load factor exceeds `factor`. At `factor`
        /// itself, their work in this motion is zero.
        motion: RigidMotion,
    },
    /// An equilibrium exists for every factor.
    Never,
}
