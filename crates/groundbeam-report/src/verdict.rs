//! Writes the verdict on equilibrium as a sentence, with its reason from statics.

mod hinged;
mod wording;

use crate::number::significant;
use crate::quantity::{Kind, Units};
use groundbeam::{
    Existence, Hinge, Model, Verdict,
    existence::{Buckling, Local, RigidMotion},
};
pub(crate) use hinged::falls;
pub use wording::verdict_name;
pub(crate) use wording::wording;

/// The reason why there is exactly one equilibrium, more than one or none, as a sentence without a full stop.
///
/// ```
/// use groundbeam::{Beam, Foundation, Load, Model};
/// use groundbeam_report::{Units, sentence};
///
/// let model = Model::new(Beam::uniform(5.0, 1e8), Foundation::pasternak(40e6, 9e6))
///     .with_load(Load::point_force(5.0, 120e3))
///     .with_load(Load::point_moment(2.0, 36e3));
/// let existence = groundbeam::exists(&model)?;
/// assert_eq!(
///     sentence(&model, &existence, Units::SI),
///     "the resultant, 120 kN at x = 5.3 m, acts outside the beam [0, 5] m: the beam tips about its \
///      right end"
/// );
/// # Ok::<(), groundbeam::Error>(())
/// ```
pub fn sentence(model: &Model, existence: &Existence, units: Units) -> String {
    let say = Say { model, existence, units };
    match existence.verdict {
        Verdict::Local(local) => say.local(local),
        Verdict::Buckles(mode) => say.buckles(mode),
        _ if model.hinges.iter().any(Hinge::is_free) => hinged::sentence(model, existence, units),
        Verdict::Unique => say.unique(),
        Verdict::NotUnique(motion) => say.not_unique(motion),
        Verdict::None(motion) => say.none(motion),
    }
}

/// Sentence on the downward force that would restore equilibrium, without a full stop. `None` if the loads do
/// no work in the motion.
pub(crate) fn remedy(motion: RigidMotion, units: Units) -> Option<String> {
    (motion.work > 0.0).then(|| {
        let force = units.write(Kind::Force, motion.work);
        let place = match (motion.left < 0.0, motion.right < 0.0) {
            (true, false) => " at the left end".to_owned(),
            (false, true) => " at the right end".to_owned(),
            _ => match motion.lifted {
                Some([x, _]) => format!(" at x = {}", units.position(x)),
                None => String::new(),
            },
        };
        format!("equilibrium needs a downward force of more than {force}{place}")
    })
}

/// Text on a rigid motion of the beam and the work of the loads in this motion.
pub(crate) fn motion(model: &Model, motion: RigidMotion, units: Units) -> String {
    let moves = match (motion.left < 0.0, motion.right < 0.0) {
        _ if motion.lifted.is_some() => hinged::moves(model, motion, units),
        (true, false) => "the left end lifts off, the right end stays in place".to_owned(),
        (false, true) => "the right end lifts off, the left end stays in place".to_owned(),
        _ => "the beam lifts off as a whole".to_owned(),
    };
    let lift = units.column(Kind::Position);
    let work = units.write(Kind::Moment, motion.work * lift.size);
    let per = match lift.name {
        "m" => "metre",
        "ft" => "foot",
        "in" => "inch",
        _ => "unit",
    };
    format!(
        "{moves}; no part of the beam moves into the ground, and the loads do {work} of work per {per} of lift"
    )
}

struct Say<'a> {
    model: &'a Model,
    existence: &'a Existence,
    units: Units,
}

impl Say<'_> {
    fn is_free(&self) -> bool {
        self.model.supports.is_empty() && self.model.beam.axial_force == 0.0
    }

    fn force(&self, force: f64) -> String {
        self.units.write(Kind::Force, force)
    }

    /// Text on the resultant of the loads, such as `the resultant, 120 kN at x = 5.3 m,`.
    fn resultant(&self) -> String {
        let force = self.existence.resultant();
        let position = self.existence.resultant_position(self.model.beam.length);
        let size = self.force(force.abs());
        let upward = if force < 0.0 { "upward " } else { "" };
        match position {
            Some(x) => format!("the {upward}resultant, {size} at x = {},", self.units.position(x)),
            None => "the resultant, zero,".to_owned(),
        }
    }

    /// Range of positions on the beam, such as `[0, 5] m`.
    fn beam(&self) -> String {
        let unit = self.units.of_input().unit(Kind::Position, self.model.beam.length);
        let end = unit.number(self.model.beam.length);
        format!("[0, {end}] {}", unit.name).trim_end().to_owned()
    }

    fn unique(&self) -> String {
        if self.is_free() {
            return format!("{} acts inside the beam {}", self.resultant(), self.beam());
        }
        if self.model.supports.is_empty() {
            return format!(
                "{} acts downward, and the axial tension of the beam resists rotation",
                self.resultant()
            );
        }
        "the loads resist every motion that lifts the beam and is allowed by its supports"
            .to_owned()
    }

    fn not_unique(&self, motion: RigidMotion) -> String {
        if motion.right > 0.0 {
            let place = self.model.beam.length * (motion.left / (motion.left - motion.right));
            return format!(
                "the beam rests on the single point x = {}, directly under the resultant: its rotation \
                 is not determined, any equilibrium shown is one of many",
                self.units.position(place)
            );
        }
        let undetermined = match (motion.left < 0.0, motion.right < 0.0) {
            (true, false) => "the rotation of the beam about its right end is not determined",
            (false, true) => "the rotation of the beam about its left end is not determined",
            _ => "the vertical position of the beam is not determined",
        };
        let shown = "any equilibrium shown is one of many";
        let held = !self.model.supports.is_empty();
        if self.existence.resultant() == 0.0 && !held {
            let undetermined = "the position and rotation of the beam are not determined";
            return format!("the loads have no resultant: {undetermined}, {shown}");
        }
        if held {
            return format!(
                "the loads do not prevent a motion of the beam: {undetermined}, {shown}"
            );
        }
        let end = if motion.left < 0.0 { "right" } else { "left" };
        format!(
            "{} acts exactly at the {end} end of the beam: {undetermined}, {shown}",
            self.resultant()
        )
    }

    fn none(&self, motion: RigidMotion) -> String {
        let force = self.existence.resultant();
        let (lifting, pivot) = match (motion.left < 0.0, motion.right < 0.0) {
            (true, false) => ("left", Some("right")),
            (false, true) => ("right", Some("left")),
            _ => ("", None),
        };
        let held = self.model.supports.iter().any(|support| {
            let end = if pivot == Some("left") { 0.0 } else { self.model.beam.length };
            support.at == end
        });
        match pivot {
            Some(pivot) if held => format!(
                "the beam can rotate about the support at its {pivot} end: the \
                 loads lift its {lifting} end"
            ),
            Some(_) if force < 0.0 => format!("{} lifts the beam off the ground", self.resultant()),
            Some(pivot) if force == 0.0 => format!(
                "the loads have a moment but no resultant that could hold the beam down: the beam tips \
                 about its {pivot} end"
            ),
            Some(pivot) if motion.work == 0.0 => format!(
                "{} acts exactly at the {pivot} end of the beam, where Winkler ground (mu = 0) \
                 cannot carry a point force: the beam sinks and rotates without limit",
                self.resultant()
            ),
            Some(pivot) => format!(
                "{} acts outside the beam {}: the beam tips about its {pivot} end",
                self.resultant(),
                self.beam()
            ),
            None => format!("{} lifts the beam off the ground", self.resultant()),
        }
    }
}

impl Say<'_> {
    fn local(&self, local: Local) -> String {
        let Local { stability_margin, critical_compression } = local;
        let compression = -self.model.beam.axial_force;
        let margin = significant(stability_margin, 4);
        let bound = if critical_compression.is_finite() {
            let times = significant(critical_compression / compression, 4);
            let critical = self.force(critical_compression);
            format!(
                "equilibrium is lost at a compression of {critical}, {times} times the given compression"
            )
        } else {
            "equilibrium is not lost under any larger compression".to_owned()
        };
        format!(
            "next to the unloaded state the ground keeps the beam from buckling under {}; stability margin \
             {margin}; {bound}",
            self.force(compression)
        )
    }

    fn buckles(&self, mode: Buckling) -> String {
        let Buckling { critical_compression, at, .. } = mode;
        let (place, compression) =
            (self.units.position(at), self.force(-self.model.beam.axial_force));
        if critical_compression == 0.0 {
            return format!(
                "even the smallest compression makes the beam rotate or rise at x = {place}"
            );
        }
        let critical = self.force(critical_compression);
        format!(
            "the beam buckles upward at x = {place} under a compression of {critical}, before {compression} \
             is reached"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::{Beam, Foundation, Load, Support};

    fn said(model: &Model) -> String {
        sentence(model, &groundbeam::exists(model).unwrap(), Units::PLAIN)
    }

    #[test]
    fn every_verdict_has_its_sentence() {
        let beam = || Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0));
        let springs = Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(1.0));
        let outside = || {
            beam().with_load(Load::point_force(3.0, 1.0)).with_load(Load::point_moment(1.0, 2.0))
        };
        let cases = [
            (beam().with_load(Load::point_force(3.0, 1.0)), "acts inside the beam [0, 4]"),
            (
                outside(),
                "1 at x = 5, acts outside the beam [0, 4]: the beam tips about its right end",
            ),
            (
                beam().with_load(Load::point_force(3.0, -1.0)),
                "the upward resultant, 1 at x = 3, lifts the beam off the ground",
            ),
            (beam().with_load(Load::point_moment(3.0, 1.0)), "a moment but no resultant"),
            (beam().with_load(Load::point_force(4.0, 1.0)), "acts exactly at the right end"),
            (
                springs.with_load(Load::point_force(0.0, 1.0)),
                "at the left end of the beam, where Winkler ground",
            ),
            (beam(), "the loads have no resultant"),
            (outside().with_support(Support::pinned(4.0)), "the support at its right end: the"),
            (
                outside().with_support(Support::pinned(1.0)),
                "lifts the beam and is allowed by its supports",
            ),
        ];
        for (model, part) in cases {
            let said = said(&model);
            assert!(said.contains(part), "{said}");
        }
    }
}
