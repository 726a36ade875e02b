//! Computes the imposed curvature from temperature, shrinkage and camber, with the depth of the beam's section.

use super::beam::OwnLoad;
use crate::code;
use crate::fault::Fault;
use crate::profile::{Along, left_out};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::Load;

/// Depth of the beam's section on a stretch, if known.
pub(super) struct Depth {
    pub from: f64,
    pub to: f64,
    pub depth: Option<Along>,
}

/// Data of the beam for curvature from temperature and shrinkage.
#[derive(Default)]
pub(super) struct Curls {
    pub depths: Vec<Depth>,
    /// Coefficient of thermal expansion \[1/K\] of the beam, if the whole beam has one material.
    pub expansion: Option<f64>,
}

/// Returns the depths along the whole beam: the depths of its segments, and outside the segments the depth
/// `base` of the beam's own section.
pub(super) fn all(length: f64, base: Option<Along>, mut segments: Vec<Depth>) -> Vec<Depth> {
    for [from, to] in left_out(length, segments.iter().map(|s| (s.from, s.to))) {
        let depth = base.as_ref().map(|base| base.between([from / length, to / length]));
        segments.push(Depth { from, to, depth });
    }
    segments
}

/// Returns the curvature per unit of the load: 1 for a curvature, α/h for a temperature difference and −1/h for a
/// shrinkage difference (top minus bottom). α is the thermal expansion, h the depth.
pub(super) fn curvature_per(
    reader: &mut Reader,
    table: &Section,
    kind: &str,
    stretch: [f64; 2],
    curls: &Curls,
) -> f64 {
    if kind == "curvature" {
        return 1.0;
    }
    let depth = depth(reader, table, stretch, &curls.depths);
    if kind == "shrinkage_difference" {
        return -1.0 / depth;
    }
    if let (None, Some(expansion)) = (table.value("expansion"), curls.expansion) {
        return expansion / depth;
    }
    let expansion = reader.required(table, "expansion");
    reader.positive("expansion", expansion).value / depth
}

/// Returns the depth that the load gives, or otherwise the depth of the section, which must be constant
/// along the load.
fn depth(reader: &mut Reader, table: &Section, [from, to]: [f64; 2], depths: &[Depth]) -> f64 {
    if let Some(depth) = reader.quantity(table, "depth") {
        return reader.positive("depth", depth).value;
    }
    let under = depths.iter().filter(|d| d.from < to && from < d.to);
    let known: Option<Vec<&Along>> = under.map(|d| d.depth.as_ref()).collect();
    let Some(known) = known.filter(|known| !known.is_empty()) else {
        let depth = reader.line(table.keys, "depth");
        let message = "the depth of the beam's section is not known along the whole load";
        let hint = format!("add {depth} to the load, or give the beam a `section`");
        let fault = Fault::new(code::INCOMPLETE, table.span.clone(), message, "", hint);
        // A load with unreadable or reversed ends has been reported already.
        if from < to {
            reader.report(fault);
        }
        return f64::NAN;
    };
    let first = known[0].profile;
    if !first.is_constant() || known.iter().any(|depth| depth.profile != first) {
        if known.iter().all(|depth| depth.is_readable()) {
            let message = "the depth of the beam's section varies along this load";
            let hint = "give a separate [[load]] with its `depth` for each part of the beam, or give a `curvature`";
            reader.report(Fault::new(code::INCOMPLETE, table.span.clone(), message, "", hint));
        }
        return f64::NAN;
    }
    first.start()
}

/// Returns the imposed curvature of a camber c. The shape of the unloaded beam is the parabola w = −4 c x
/// (l − x)/l², which has the rise c at mid-length.
pub(super) fn camber(reader: &mut Reader, table: &Section, length: f64) -> Option<OwnLoad> {
    let Field { value: camber, span } = reader.quantity(table, "camber")?;
    let known = !camber.is_nan() && length > 0.0;
    let load = || Load::uniform_curvature(0.0, length, 8.0 * camber / (length * length));
    known.then(|| OwnLoad { load: load(), case: None, span })
}
