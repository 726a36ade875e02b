//! The rules for the beam.

use super::positions::overlaps;
use crate::model::Model;
use crate::model::problem::{Part, Problem, describe, in_range, positive, positive_along, remedy};

impl Model {
    pub(super) fn check_beam(&self, found: &mut Vec<Problem>) {
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
                remedy(beam.axial_force, "give a finite axial force, tension positive, or omit it"),
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
}
