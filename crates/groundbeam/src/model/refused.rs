//! What is right but not solved, or not by every method.

use super::{Part, Problem};

impl Problem {
    /// Compression on a beam whose supports leave it free to move as a rigid body.
    pub(crate) fn unheld_compression() -> Self {
        Problem::new(
            "GB601",
            Part::Beam,
            "axial_force",
            "compression on a beam that its supports leave free to turn or to rise",
            "existence is not assured then, however small the force: fix one end or hold the beam \
             at two places (Kikuchi 1980, the end of section 4)",
        )
    }

    /// Compression beyond the beam's own buckling load.
    pub(crate) fn beyond_buckling(times: f64) -> Self {
        Problem::new(
            "GB602",
            Part::Beam,
            "axial_force",
            format!("the compression is {times:.4} times the beam's own buckling load"),
            "below that load there is exactly one equilibrium, whether the ground is lost or not; \
             beyond it the problem is not convex",
        )
    }

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

    /// Load factors of loads on the ground.
    pub(crate) fn no_factors(load: usize) -> Self {
        Problem::new(
            "GB610",
            Part::Load(load),
            "at",
            "load factors are for loads on the beam alone",
            "leave the loads on the ground out, or solve combinations with factors of your own",
        )
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
