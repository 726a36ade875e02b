//! Compares the stretches without contact, the hinges and the concentrated forces that a document lists with the claimed fields.

use crate::contact_set::ContactSet;
use crate::document::Extreme;
use crate::listed::{Comparison, Differences, ListedErrors, NEAR, enlarge, farthest, largest};
use crate::patches::{GAP, MOMENT, ROTATION};
use crate::refusal::NotProven;
use crate::scalar::Scalar;

impl<S: Scalar> Comparison<'_, S> {
    /// Compares the largest gap that is listed for a lifted-off stretch with the claimed gap. The stretch must end at
    /// listed contact edges or at ends of the beam.
    pub fn lift_off(
        &self,
        [from, to, x, value]: &[f64; 4],
        found: &mut Differences,
    ) -> Result<(), NotProven> {
        let pieces = &self.document.answer.pieces;
        let edges = self.document.contact.iter().flatten().flatten();
        let ends: Vec<f64> = edges.copied().chain([0.0, self.length()]).collect();
        if !(ends.contains(from) && ends.contains(to) && from <= x && x <= to) {
            return Err(NotProven::new(
                "a stretch that is listed as out of contact does not end at a listed edge",
            )
            .at(*from));
        }
        let first = pieces.partition_point(|piece| piece.x[1] <= *from);
        let range = first..pieces.partition_point(|piece| piece.x[0] < *to).max(first);
        let near = NEAR * self.length();
        let reaches = |x: [f64; 2]| from + near < x[1] && x[0] < to - near;
        let touches = range.clone().any(|i| {
            let node = pieces[i].x[0];
            pieces[i].touches && reaches(pieces[i].x)
                || self.fields.surface.touches[i] && reaches([node; 2])
        });
        if range.is_empty() || touches || ends.iter().any(|edge| from < edge && edge < to) {
            return Err(NotProven::new("a stretch that is listed as out of contact is in contact")
                .at(*from));
        }
        let largest = Extreme { field: "gap".to_owned(), is_max: true, x: *x, value: *value };
        let off = self.nearest_difference(GAP, *x, *value)?;
        enlarge(&mut found.fields[GAP], off);
        enlarge(&mut found.fields[GAP], self.beyond(GAP, &largest, range));
        found.checked.values += 1;
        Ok(())
    }

    /// Compares the listed rotation and moment of a hinge with the computed values.
    pub fn hinge(
        &self,
        [at, rotation, moment]: &[f64; 3],
        found: &mut Differences,
    ) -> Result<(), NotProven> {
        let (i, t) = self.place(*at)?;
        let spans = &self.fields.frame.spans;
        if !(t == spans[i].t[0] && self.fields.frame.nodes[i].is_hinged()) {
            return Err(NotProven::new("a listed hinge is not a hinge of the model").at(*at));
        }
        let value = |field: usize, i: usize, t: S| self.patches.value(field, i, t);
        let turned = value(ROTATION, i, t) - value(ROTATION, i - 1, spans[i - 1].t[1]);
        enlarge(&mut found.fields[ROTATION], (S::of(*rotation) - turned).size());
        enlarge(&mut found.fields[MOMENT], self.difference(MOMENT, *moment, (i, t)));
        Ok(())
    }

    /// Refuses two listed forces or hinges at one position, and stretches that overlap. A reader of the document would add
    /// the forces, but the proof compares each force with the exact force.
    pub fn listed_twice(&self) -> Option<NotProven> {
        let near = NEAR * self.length();
        let repeated = |mut places: Vec<f64>| {
            places.sort_by(f64::total_cmp);
            places.windows(2).find(|pair| pair[1] - pair[0] <= near).map(|pair| pair[0])
        };
        let document = self.document;
        let forces = repeated(document.answer.forces.iter().map(|f| f.x).collect())
            .map(|x| NotProven::new("two concentrated forces are listed at one position").at(x));
        let hinges = || {
            repeated(document.hinges.iter().map(|hinge| hinge[0]).collect())
                .map(|x| NotProven::new("two hinges are listed at one position").at(x))
        };
        let stretches = document.lift_off.windows(2).find(|pair| !(pair[0][1] <= pair[1][0]));
        let stretches =
            || stretches.map(|pair| NotProven::new("two listed stretches overlap").at(pair[1][0]));
        forces.or_else(hinges).or_else(stretches)
    }

    /// Compares listed concentrated forces with the exact forces. A force that is not listed counts as zero.
    pub fn forces(&self, contact: &ContactSet, found: &mut ListedErrors) {
        let (near, length) = (NEAR * self.length(), self.length());
        let error = |x: f64, force: f64| {
            let exact = contact.forces.iter().find(|exact| (exact.x - x).abs() <= near);
            farthest(force, exact.map_or([0.0; 2], |exact| exact.force))
        };
        let listed = &self.document.answer.forces;
        found.forces = listed.iter().map(|force| error(force.x, force.force)).collect();
        let ends = self.document.end_forces;
        found.end_forces = ends.map(|[left, right]| [error(0.0, left), error(length, right)]);
        let mut places: Vec<f64> = listed.iter().map(|force| force.x).collect();
        places.extend(ends.iter().flat_map(|_| [0.0, length]));
        let unlisted = contact
            .forces
            .iter()
            .filter(|exact| !places.iter().any(|x| (exact.x - x).abs() <= near));
        let errors: Vec<f64> = unlisted.map(|exact| farthest(0.0, exact.force)).collect();
        found.unlisted = largest(errors.iter());
    }
}
