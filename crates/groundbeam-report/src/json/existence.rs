//! Writes the verdict on existence in the result document.

use crate::context::Context;
use crate::verdict::{sentence, wording};
use groundbeam::{
    Existence, Model, Verdict,
    existence::{Buckling, RigidMotion},
};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Proven {
    verdict: &'static str,
    /// Static reactions: the support forces of a chain of rigid beams that is supported only at its two ends
    /// and at its free hinges.
    static_reactions: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failing_motion: Option<Motion>,
    #[serde(skip_serializing_if = "Option::is_none")]
    undetermined_motion: Option<Motion>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stability_margin: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    critical_compression: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    buckles_at: Option<f64>,
    sentence: String,
}

impl Proven {
    pub fn new(model: &Model, existence: &Existence, context: &Context) -> Self {
        let mut proven = Proven {
            verdict: wording(existence.verdict).name,
            static_reactions: groundbeam::existence::static_reactions(model)
                .iter()
                .map(|r| r.1)
                .collect(),
            failing_motion: None,
            undetermined_motion: None,
            stability_margin: None,
            critical_compression: None,
            buckles_at: None,
            sentence: sentence(model, existence, context.units),
        };
        match existence.verdict {
            Verdict::Unique => {}
            Verdict::NotUnique(motion) => {
                proven.undetermined_motion = Some(Motion::of(Some(model), motion));
            }
            Verdict::None(motion) => {
                proven.failing_motion = Some(Motion::of(Some(model), motion));
            }
            Verdict::Local(local) => {
                proven.stability_margin = Some(local.stability_margin);
                proven.critical_compression = Some(local.critical_compression);
            }
            Verdict::Buckles(mode) => {
                let Buckling { critical_compression, at, left, right, work } = mode;
                let motion = RigidMotion { left, right, work, lifted: None };
                proven.failing_motion = Some(Motion { motion, hinges: Vec::new() });
                proven.critical_compression = Some(critical_compression);
                proven.buckles_at = Some(at);
            }
        }
        proven
    }
}

#[derive(Serialize)]
pub(super) struct Motion {
    #[serde(flatten)]
    motion: RigidMotion,
    /// Displacement of the rigid motion at each hinge, in the order of the model's hinges.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    hinges: Vec<f64>,
}

impl Motion {
    pub fn of(model: Option<&Model>, motion: RigidMotion) -> Self {
        let at = |model: &Model, x: f64| motion.at(model, x);
        let all = |model: &Model| model.hinges.iter().map(|hinge| at(model, hinge.at)).collect();
        Motion { motion, hinges: model.map_or(Vec::new(), all) }
    }
}
