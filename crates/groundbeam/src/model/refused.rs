//! Reasons why a method refuses a valid model. The table of methods and features is in `supported.rs`.

use super::{Part, Problem};
use crate::model::problem::Bytes;

/// The reason why a method refuses a feature.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub code: &'static str,
    message: &'static str,
    hint: &'static str,
}

pub(crate) const NODAL_ON_ONE_WAY_SUPPORTS: Refusal = Refusal {
    code: "GB604",
    message: "the nodal method does not solve beams on supports that act in one direction only",
    hint: "use the method `exact` or `active-set`",
};

pub(crate) const NODAL_ON_ITERATED_GROUND: Refusal = Refusal {
    code: "GB605",
    message: "the nodal method does not solve the modified Vlasov model, whose ground constants depend on the solution",
    hint: "use the method `exact` or `active-set`, or give k and mu",
};

pub(crate) const LOCAL_BY_ANOTHER_METHOD: Refusal = Refusal {
    code: "GB611",
    message: "this compression exceeds the buckling load of the beam without ground; only the method `exact` supports it",
    hint: "use the method `exact`",
};

pub(crate) const FACTORS_OF_A_LOCAL_EQUILIBRIUM: Refusal = Refusal {
    code: "GB612",
    message: "this compression exceeds the buckling load of the beam without ground, so load factors cannot be computed",
    hint: "omit the load factors; the result then contains the critical compression, at which the beam buckles",
};

impl Problem {
    /// Creates the refusal of a feature that a method does not support.
    pub(crate) fn refused(why: &Refusal, part: Part, field: &'static str) -> Self {
        Problem::new(why.code, part, field, why.message, why.hint)
    }

    /// Creates the refusal of a model whose deflection has such short waves that the mesh would
    /// need too many elements.
    pub(crate) fn too_fine(part: Part, needed: usize) -> Self {
        let field = match part {
            Part::FoundationSegment(_) => "shear_layer",
            _ => "bending_stiffness",
        };
        let needed = needed as f64;
        Problem::new(
            "GB616",
            part,
            field,
            format!(
                "where the beam or the ground varies, or the beam has shear deformation, the shortest waves \
                 would need {needed:.0e} elements"
            ),
            "the bending stiffness is very small compared with the shear layer, the springs or the tension: \
             increase it, or give constant stiffnesses and no shear stiffness",
        )
    }

    /// Creates the refusal of a model whose elements need more memory than the limit.
    pub(crate) fn too_large(method: &str, elements: usize, [needed, limit]: [Bytes; 2]) -> Self {
        let message = format!(
            "the method `{method}` would need about {needed} of memory for {elements} elements, more than the limit \
             of {limit}"
        );
        let hint = match method {
            "exact" => {
                "the beam is very long compared with its waves, or has very many parts: shorten it, or raise the \
                 limit, as in --memory-limit \"8 GB\""
            }
            _ => "use fewer elements, or raise the limit, as in --memory-limit \"8 GB\"",
        };
        Problem::new("GB617", Part::Beam, "length", message, hint)
    }
}
