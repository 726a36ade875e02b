//! Writes the origin of the ground's constants in the result document.

use groundbeam::Model;
use groundbeam::soil::SoilModel;
use groundbeam_run as run;
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Ground {
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<&'static str>,
    width: f64,
    k: f64,
    mu: f64,
    /// Spring constant per area of the ground, k divided by `width`.
    #[serde(rename = "C1")]
    area_spring: f64,
    #[serde(rename = "C2")]
    area_shear: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    gamma: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rounds: Option<usize>,
    warnings: Vec<String>,
}

impl Ground {
    pub fn of(ground: &run::Ground, model: &Model) -> Self {
        let (width, constants) = (ground.width, ground.constants);
        let gamma = ground.rounds.and_then(|soil| soil.gamma);
        Ground {
            source: ground.soil.as_ref().map(SoilModel::source),
            width,
            k: constants.subgrade,
            mu: constants.shear_layer,
            area_spring: constants.subgrade / width,
            area_shear: constants.shear_layer / width,
            gamma,
            rounds: gamma.and(ground.rounds).map(|soil| soil.rounds),
            warnings: ground.soil.as_ref().map(|soil| soil.doubts(&model.beam)).unwrap_or_default(),
        }
    }
}
