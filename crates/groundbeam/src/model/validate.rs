//! Every rule a model must obey, each with what would be right.

use super::places;
use super::{Action, Extent, Foundation, GroundEnd, Load, Model, Profile, SupportKind};
use crate::model::problem::down;
use crate::model::problem::{
    Part, Problem, describe, finite, in_range, positive, positive_along, remedy,
};
use crate::numeric::tolerance::same_place;

impl Model {
    /// Everything that is wrong with the model; empty when it can be solved.
    ///
    /// A beam so soft or ground so stiff that the products of the given numbers leave the range of
    /// a 64-bit number is refused here too, so that no later step meets an infinity.
    pub fn problems(&self) -> Vec<Problem> {
        let mut found = Vec::new();
        self.check_beam(&mut found);
        self.check_foundation(&mut found);
        self.check_loads(&mut found);
        self.check_supports(&mut found);
        self.check_hinges(&mut found);
        self.check_one_way(&mut found);
        self.check_gap(&mut found);
        found
    }

    fn check_beam(&self, found: &mut Vec<Problem>) {
        let beam = &self.beam;
        positive(found, "GB101", Part::Beam, "length", beam.length, "the beam's length");
        let ei = "the bending stiffness EI";
        positive(found, "GB102", Part::Beam, "bending_stiffness", beam.bending_stiffness, ei);
        if !in_range(beam.axial_force) {
            found.push(Problem::new(
                "GB103",
                Part::Beam,
                "axial_force",
                format!("the axial force is {}", describe(beam.axial_force)),
                remedy(beam.axial_force, "give a finite force, tension positive; or leave it out"),
            ));
        }
        let ga = "the shear stiffness";
        if let Some(stiffness) = beam.shear_stiffness {
            positive(found, "GB104", Part::Beam, "shear_stiffness", stiffness, ga);
        }
        let spans: Vec<_> = beam.segments.iter().map(|s| (s.from, s.to)).collect();
        for (i, segment) in beam.segments.iter().enumerate() {
            let part = Part::BeamSegment(i);
            positive_along(
                found,
                "GB102",
                part,
                "bending_stiffness",
                &segment.bending_stiffness,
                ei,
            );
            if let Some(stiffness) = &segment.shear_stiffness {
                positive_along(found, "GB104", part, "shear_stiffness", stiffness, ga);
            }
            self.check_stretch(found, part, segment.from, segment.to);
        }
        overlaps(found, &spans, Part::BeamSegment);
    }

    fn check_foundation(&self, found: &mut Vec<Problem>) {
        let mut constants = |part, spring: &Profile, shear: &Profile| {
            positive_along(found, "GB201", part, "subgrade", spring, "the spring constant k");
            check_shear(found, part, shear);
            for (field, constant) in [("subgrade", spring), ("shear_layer", shear)] {
                if constant.control_values().len() > Foundation::MOST_CONTROL_VALUES {
                    let message = "this curve has more than three control values";
                    let hint = "split the segment in two, or let it run linearly";
                    found.push(Problem::new("GB204", part, field, message, hint));
                }
            }
        };
        let ground = &self.foundation;
        constants(Part::Foundation, &ground.subgrade.into(), &ground.shear_layer.into());
        for (i, s) in ground.segments.iter().enumerate() {
            constants(Part::FoundationSegment(i), &s.subgrade, &s.shear_layer);
        }
        for (i, s) in ground.segments.iter().enumerate() {
            let part = Part::FoundationSegment(i);
            check_order(found, part, s.from, s.to);
            let beside = s.to <= 0.0 || s.from >= self.beam.length;
            if beside && !(s.subgrade.is_constant() && s.shear_layer.is_constant()) {
                let message = "ground beside the beam cannot vary along a segment";
                let hint = "give it in segments with a constant each; the beam is {0} long";
                let problem = Problem::new("GB203", part, "from", message, hint);
                found.push(problem.with_numbers(&[self.beam.length]));
            }
        }
        let endless = ground.ends.iter().all(|end| *end == GroundEnd::Endless);
        if ground.soil.is_some() && !(ground.segments.is_empty() && endless) {
            let message = "ground made of soil is uniform and endless";
            let hint = "leave out the segments and the ends of the ground, or give its constants";
            found.push(Problem::new("GB212", Part::Foundation, "soil", message, hint));
        }
        self.check_ground_ends(found);
        let spans: Vec<_> = ground.segments.iter().map(|s| (s.from, s.to)).collect();
        overlaps(found, &spans, Part::FoundationSegment);
    }

    fn check_loads(&self, found: &mut Vec<Problem>) {
        let begins = self.ground_begins();
        for (i, load) in self.loads.iter().enumerate() {
            let part = Part::Load(i);
            match load.extent {
                Extent::Point { at, size } if load.on_ground => {
                    finite(found, part, "at", at);
                    self.check_on_ground(found, part, "at", [at, at]);
                    down(found, part, "force", size);
                    if self.ground_has_no_layer(&begins, at) {
                        let message = "a force at a point of the ground needs a shear layer";
                        let hint = "spread it: distributed with from and to";
                        found.push(Problem::new("GB209", part, "at", message, hint));
                    }
                }
                Extent::Distributed { from, to, start, end } if load.on_ground => {
                    check_order(found, part, from, to);
                    self.check_on_ground(found, part, "from", [from, to]);
                    down(found, part, "start", start);
                    down(found, part, "end", end);
                }
                Extent::Point { at, size } => {
                    self.check_position(found, part, at);
                    let field = if load.action == Action::Moment { "moment" } else { "force" };
                    finite(found, part, field, size);
                }
                Extent::Distributed { from, to, start, end } => {
                    self.check_stretch(found, part, from, to);
                    finite(found, part, "start", start);
                    finite(found, part, "end", end);
                }
            }
        }
        if let (Some(load), Some(Part::FoundationSegment(i))) =
            (self.loads.iter().position(Load::is_on_ground), self.varying_ground())
        {
            let message = "loads on the ground need ground that is even along each segment";
            let hint = format!("segment {} varies: give it in several with a constant each", i + 1);
            found.push(Problem::new("GB210", Part::Load(load), "at", message, hint));
        }
    }

    fn check_supports(&self, found: &mut Vec<Problem>) {
        let positions = self.supports.iter().map(|support| support.at);
        let repeated = places::repeated(positions, same_place(self.beam.length));
        for ((i, support), other) in self.supports.iter().enumerate().zip(repeated) {
            let part = Part::Support(i);
            self.check_position(found, part, support.at);
            finite(found, part, "settlement", support.settlement);
            if let SupportKind::Spring { spring, rotational_spring } = support.kind {
                let mut constant = |field, value: f64| {
                    if !(in_range(value) && value >= 0.0) {
                        found.push(Problem::new(
                            "GB402",
                            part,
                            field,
                            format!("the spring constant is {}", describe(value)),
                            remedy(value, "it must be zero or positive"),
                        ));
                    }
                };
                constant("spring", spring);
                constant("rotational_spring", rotational_spring);
            }
            if let Some(other) = other {
                let message = format!("there is a support at {{0}} already (number {})", other + 1);
                let hint = "say in one support all that it holds";
                let problem = Problem::new("GB403", part, "at", message, hint);
                found.push(problem.with_numbers(&[support.at]));
            }
        }
    }

    fn check_gap(&self, found: &mut Vec<Problem>) {
        for (i, corner) in self.gap.iter().enumerate() {
            self.check_position(found, Part::Gap(i), corner.at);
            finite(found, Part::Gap(i), "value", corner.value);
            if i > 0 && corner.at <= self.gap[i - 1].at {
                let hint = "list the gap's corners from left to right, each at a place of its own";
                let message = "this corner at {0} does not lie to the right of the one before";
                let problem = Problem::new("GB501", Part::Gap(i), "at", message, hint);
                found.push(problem.with_numbers(&[corner.at]));
            }
        }
    }

    /// A position must be a number on the beam.
    pub(super) fn check_position(&self, found: &mut Vec<Problem>, part: Part, at: f64) {
        self.check_on_beam(found, part, "at", at);
    }

    fn check_on_beam(&self, found: &mut Vec<Problem>, part: Part, field: &'static str, x: f64) {
        // A length that is wrong itself says nothing about positions.
        let length_is_right = in_range(self.beam.length) && self.beam.length > 0.0;
        if length_is_right && !(x >= 0.0 && x <= self.beam.length) {
            let (message, hint) = if x.is_finite() {
                ("{0} lies off the beam", "the beam goes from 0 to {1}, measured from its left end")
            } else {
                ("the position is not a finite number", "the beam goes from 0 to {1}")
            };
            let problem = Problem::new("GB301", part, field, message, hint);
            found.push(problem.with_numbers(&[x, self.beam.length]));
        }
    }

    fn check_stretch(&self, found: &mut Vec<Problem>, part: Part, from: f64, to: f64) {
        self.check_on_beam(found, part, "from", from);
        self.check_on_beam(found, part, "to", to);
        check_order(found, part, from, to);
    }
}

/// Zero all along, or positive all along: a shear layer that thins out to nothing has no end of its own.
fn check_shear(found: &mut Vec<Problem>, part: Part, shear: &Profile) {
    let values = shear.control_values();
    let wrong = values.iter().find(|value| !(in_range(**value) && **value >= 0.0));
    if let Some(&value) = wrong {
        let message = format!("the shear constant mu is {}", describe(value));
        let hint = remedy(value, "it must be zero (Winkler) or positive");
        found.push(Problem::new("GB202", part, "shear_layer", message, hint));
    } else if !shear.is_constant() && values.contains(&0.0) {
        let message = "the shear constant mu varies and falls to zero";
        let hint = "where mu varies it must stay positive; end the segment where the shear layer \
                    ends, at a small value of mu, and let one with mu = 0 follow";
        found.push(Problem::new("GB205", part, "shear_layer", message, hint));
    }
}

pub(super) fn check_order(found: &mut Vec<Problem>, part: Part, from: f64, to: f64) {
    if from >= to {
        let message = "the stretch from {0} to {1} has no length";
        let hint = "`to` must lie to the right of `from`";
        found.push(Problem::new("GB303", part, "to", message, hint).with_numbers(&[from, to]));
    } else if !(from.is_finite() && to.is_finite()) {
        let field = if from.is_finite() { "to" } else { "from" };
        let message = "an end of the stretch is not a finite number";
        found.push(Problem::new("GB303", part, field, message, "give both ends as numbers"));
    }
}

fn overlaps(found: &mut Vec<Problem>, spans: &[(f64, f64)], part: impl Fn(usize) -> Part) {
    for (i, j) in places::overlapping(spans) {
        let ((from, to), (other_from, other_to)) = (spans[i], spans[j]);
        let message =
            format!("this segment, {{0}} to {{1}}, overlaps segment {}, {{2}} to {{3}}", j + 1);
        let hint = "segments may touch but not overlap";
        let problem = Problem::new("GB304", part(i), "from", message, hint);
        found.push(problem.with_numbers(&[from, to, other_from, other_to]));
    }
}
