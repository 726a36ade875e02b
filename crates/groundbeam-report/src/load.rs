//! Gives the name, the physical quantity and the formatted size of a load, for reports, pictures and web pages.

use crate::quantity::{Kind, Units};
use groundbeam::{Load, model::Action};

/// Name of the kind of a load.
pub fn load_name(load: &Load) -> &'static str {
    match (load.action(), load.extent().is_distributed(), load.is_on_ground()) {
        (Action::Force, false, false) => "force",
        (Action::Force, false, true) => "force on the ground",
        (Action::Force, true, false) => "distributed load",
        (Action::Force, true, true) => "distributed load on the ground",
        (Action::Moment, false, _) => "moment",
        (Action::Moment, true, _) => "distributed moment",
        (Action::Curvature, ..) => "imposed curvature",
    }
}

/// Returns the kind of physical quantity that measures a load, such as a force per length.
pub fn load_kind(load: &Load) -> Kind {
    match (load.action(), load.extent().is_distributed()) {
        (Action::Force, false) => Kind::Force,
        (Action::Force, true) => Kind::Pressure,
        (Action::Moment, false) => Kind::Moment,
        // A moment per length has the unit of a force.
        (Action::Moment, true) => Kind::Force,
        (Action::Curvature, _) => Kind::PerLength,
    }
}

/// Whether the load is a moment per length in a file with units. Its unit is then that of a force.
pub(crate) fn is_moment_per_length(load: &Load, units: Units) -> bool {
    !units.is_plain() && load.action() == Action::Moment && load.extent().is_distributed()
}

/// Formats the size of a load with its unit. For a varying load, the text `to` separates the values at both
/// ends.
pub(crate) fn load_size(load: &Load, units: Units, to: &str) -> String {
    let unit = units.of_input().unit(load_kind(load), load.extent().largest());
    let [start, end] = load.extent().sizes();
    if start == end {
        return unit.write(start);
    }
    format!("{}{to}{}", unit.number(start), unit.write(end))
}
