//! The name of each kind of load, for reports and the page.

use groundbeam::Load;

/// The name of a load's kind.
pub fn load_name(load: &Load) -> &'static str {
    match load {
        Load::PointForce { .. } => "force",
        Load::PointMoment { .. } => "moment",
        Load::Distributed { .. } => "distributed load",
        Load::DistributedMoment { .. } => "distributed moment",
        Load::GroundForce { .. } => "force on the ground",
        Load::GroundDistributed { .. } => "distributed load on the ground",
        Load::Curvature { .. } => "imposed curvature",
    }
}
