//! What is right but not solved, or not by every method.

use super::{Beam, Part, Problem};
use crate::model::problem::Bytes;

impl Problem {
    /// Nodal pressures where nothing spreads them.
    pub(crate) fn nodal_forces_on_springs(part: Part) -> Self {
        Problem::new(
            "GB603",
            part,
            "shear",
            "the paper's concentrated pressures (5.5) need a shear layer (4.9), and mu is zero here",
            "use the method `exact`, or `active-set` with its own pressure",
        )
    }

    /// Values at nodes are for beams that the ground alone holds.
    pub(crate) fn nodal_with_supports() -> Self {
        Problem::new(
            "GB604",
            Part::Support(0),
            "at",
            "a beam solved for its nodes alone cannot have supports",
            "use the method `exact` or `active-set`",
        )
    }

    /// Loads on the ground bend its surface between nodes.
    pub(crate) fn only_exactly(load: usize) -> Self {
        Problem::new(
            "GB609",
            Part::Load(load),
            "at",
            "loads on the ground are solved by the exact method alone",
            "use the method `exact`",
        )
    }

    /// A local equilibrium is followed from edge to edge.
    pub(crate) fn local_by_another_method() -> Self {
        Problem::new(
            "GB611",
            Part::Beam,
            "axial_force",
            "the ground must help to bear this compression: the equilibrium is a local one, which a mesh \
             does not follow",
            "use the method `exact`",
        )
    }

    /// Load factors rest on statics or on a convex energy.
    pub(crate) fn factors_of_a_local_equilibrium() -> Self {
        Problem::new(
            "GB612",
            Part::Beam,
            "axial_force",
            "the ground must help to bear this compression: how far loads may grow is not known from \
             statics",
            "without load factors the result tells the critical compression, as far as which the axial force \
             may grow",
        )
    }

    /// Only the exact element shears.
    pub(crate) fn shear_by_another_method(beam: &Beam) -> Self {
        let segment = beam.segments.iter().position(|segment| segment.shear_stiffness.is_some());
        let part = if beam.shear_stiffness.is_some() { None } else { segment };
        Problem::new(
            "GB614",
            part.map_or(Part::Beam, Part::BeamSegment),
            "shear_stiffness",
            "a beam that shears is solved by the exact method alone",
            "use the method `exact`, or leave the shear stiffness out",
        )
    }

    /// Series about as long as a wave are too many.
    pub(crate) fn too_fine(part: Part, needed: usize) -> Self {
        let field = match part {
            Part::FoundationSegment(_) => "shear",
            _ => "bending_stiffness",
        };
        let needed = needed as f64;
        Problem::new(
            "GB616",
            part,
            field,
            format!(
                "where beam or ground vary, or the beam shears, its shortest waves would need {needed:.0e} \
                 elements"
            ),
            "the bending stiffness is very small beside the shear layer, the springs or the tension: make it larger, \
             or leave out what varies or shears",
        )
    }

    /// More elements than fit into the memory that may be used.
    pub(crate) fn too_large(method: &str, elements: usize, [needed, limit]: [Bytes; 2]) -> Self {
        let message = format!(
            "the method `{method}` would need about {needed} of memory for {elements} elements, more than the limit \
             of {limit}"
        );
        let hint = match method {
            "exact" => {
                "the beam is very long beside its waves, or has very many parts: shorten it, or raise the limit, as in \
                 --memory-limit \"8 GB\""
            }
            _ => "use fewer elements, or raise the limit, as in --memory-limit \"8 GB\"",
        };
        Problem::new("GB617", Part::Beam, "length", message, hint)
    }

    /// Rows of equal elements need one stiffness and one ground each.
    pub(crate) fn nodal_where_it_varies(part: Part) -> Self {
        let field = match part {
            Part::BeamSegment(_) => "bending_stiffness",
            _ => "spring",
        };
        Problem::new(
            "GB605",
            part,
            field,
            "a beam solved for its nodes alone cannot vary along a segment",
            "use the method `exact` or `active-set`, or many segments with a constant each",
        )
    }
}
