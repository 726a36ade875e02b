//! Writes the document of a study.

use super::text;
use crate::context::Context;
use crate::study::Study;
use serde::Serialize;

#[derive(Serialize)]
struct Document<'a> {
    status: &'static str,
    units: &'static str,
    #[serde(flatten)]
    study: &'a Study,
    #[serde(skip_serializing_if = "Option::is_none")]
    seconds: Option<f64>,
}

/// Returns the document of a study, with probabilities, means and quantiles.
pub fn study(study: &Study, context: &Context) -> String {
    let units = context.units.name();
    text(&Document { status: "done", units, study, seconds: context.seconds })
}
