//! Compares the values that a result document lists with the fields of the claimed solution in the same document.

use crate::contact_set::ContactSet;
use crate::document::{Document, Extreme, Stations};
use crate::extremes::{PlacedExtreme, placed};
use crate::fields::Fields;
use crate::patches::{FIELDS, PRESSURE, Patches, field_named};
use crate::polynomial::{Budget, Line, Polynomial, below};
use crate::proof::Proof;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Two positions are different if their distance exceeds this fraction of the length of the beam.
pub(crate) const NEAR: f64 = 16.0 * f64::EPSILON;

/// Numbers of listed values that were compared, by kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Checked {
    /// Number of positions at which the fields are listed.
    pub stations: usize,
    /// Number of compared field values at the stations, plus one largest gap for each listed stretch without contact.
    pub values: usize,
    /// Number of listed pressures in intervals that contain an edge of contact. These pressures have no proven bound.
    pub at_edges: usize,
    /// Number of extremes.
    pub extremes: usize,
    /// Number of listed contact regions and contact points.
    pub regions: usize,
    /// Number of listed concentrated forces, including the forces under the ends of the beam.
    pub forces: usize,
    /// Number of error bounds that the document claims.
    pub bounds: usize,
}

/// Error bounds of individual values that a document lists. The bounds of contact edges and forces are infinite if the
/// contact set is not proven.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ListedErrors {
    /// Bounds of the position errors of both ends of each contact region that the document lists \[m\]. If the
    /// document lists no regions, these are the bounds for the proven regions.
    pub edges: Vec<[f64; 2]>,
    /// Error bound of each of the listed `forces` \[N\].
    pub forces: Vec<f64>,
    /// Error bounds of the `end_forces` \[N\], left and right; `None` if no end forces are listed.
    pub end_forces: Option<[f64; 2]>,
    /// Upper bound of the magnitude of each exact concentrated contact force that the document does not list \[N\].
    pub unlisted: f64,
    /// Error bounds of rotation \[rad\] and moment \[N·m\] of each of the `hinges`.
    pub hinges: Vec<[f64; 2]>,
}

impl ListedErrors {
    /// Returns the largest error bound of an edge of contact \[m\].
    pub fn largest_edge(&self) -> f64 {
        largest(self.edges.iter().flatten())
    }

    /// Returns the largest error bound of a concentrated contact force \[N\].
    pub fn largest_force(&self) -> f64 {
        largest(self.forces.iter().chain(self.end_forces.iter().flatten()).chain([&self.unlisted]))
    }

    /// Returns an infinite error bound for each contact region and each concentrated force that a document lists.
    fn nothing(document: &Document) -> Self {
        let regions = document.contact.as_ref().map_or(1, |listed| listed.len().max(1));
        ListedErrors {
            edges: vec![[f64::INFINITY; 2]; regions],
            forces: vec![f64::INFINITY; document.answer.forces.len()],
            end_forces: document.end_forces.map(|_| [f64::INFINITY; 2]),
            unlisted: f64::INFINITY,
            hinges: Vec::new(),
        }
    }
}

/// Returns the largest of the errors; zero for an empty list.
pub(crate) fn largest<'a>(errors: impl Iterator<Item = &'a f64>) -> f64 {
    errors.map(|error| Size::of(*error)).fold(Size::ZERO, Size::worst).value()
}

/// Bounds of the differences between the values that a document lists and the claimed solution in the same document.
#[derive(Debug, Default)]
pub(crate) struct Differences {
    /// Largest difference between listed and computed values of each field, in the order of [`FIELDS`].
    pub fields: [f64; 8],
    /// Error bounds of the listed edges of contact and concentrated forces.
    pub contact: ListedErrors,
    /// Proven positions of the listed extremes in the exact solution.
    pub extremes: Vec<PlacedExtreme>,
    /// Intervals on which the pressure has no error bound \[m\].
    pub without_pressure: Vec<[f64; 2]>,
    pub checked: Checked,
    /// Listed fields with unknown names.
    pub unknown: Vec<String>,
    /// Why the listed numbers are rejected; the first reason found. `None` if they are accepted.
    pub failed: Option<NotProven>,
}

/// Compares the numbers that a document lists with the claimed fields and with the proven contact set. Also bounds the
/// positions of the exact extremes.
pub(crate) fn differences<S: Scalar>(
    document: &Document,
    fields: &Fields<S>,
    proof: &Proof,
) -> Differences {
    let contact = proof.contact.as_ref().ok();
    let comparison = Comparison { document, fields, patches: Patches::of(fields) };
    let place = |extreme| placed(extreme, fields, &comparison.patches, &proof.bounds);
    let mut found = Differences {
        extremes: document.extremes.iter().map(place).collect(),
        ..Differences::default()
    };
    let extremes = || document.extremes.iter();
    found.without_pressure = without_pressure(fields, proof);
    let mut failed = None;
    for (listed, on_left) in [(&document.stations, false), (&document.left_of_jumps, true)] {
        failed = failed.or(comparison.stations(listed, on_left, contact, &mut found).err());
    }
    for extreme in extremes() {
        failed = failed.or(comparison.extreme(extreme, &mut found).err());
    }
    found.contact = ListedErrors::nothing(document);
    for stretch in &document.lift_off {
        failed = failed.or(comparison.lift_off(stretch, &mut found).err());
    }
    for hinge in &document.hinges {
        failed = failed.or(comparison.hinge(hinge, &mut found).err());
    }
    failed = failed.or(comparison.listed_twice());
    if let Some(contact) = contact {
        match edges(document, contact) {
            Ok(edges) => found.contact.edges = edges,
            Err(why) => failed = failed.or(Some(why)),
        }
        comparison.forces(contact, &mut found.contact);
    }
    found.checked.forces =
        document.answer.forces.len() + 2 * usize::from(document.end_forces.is_some());
    comparison.idle_pressures(&mut found);
    found.checked.regions = document.contact.as_ref().map_or(0, Vec::len);
    found.checked.extremes = extremes().filter(|e| field_named(&e.field).is_some()).count();
    found.failed = failed;
    found
}

/// Returns the intervals \[m\] on which the pressure has no error bound. On a shear layer, the exact pressure jumps at
/// contact edges inside the beam.
fn without_pressure<S: Scalar>(fields: &Fields<S>, proof: &Proof) -> Vec<[f64; 2]> {
    let (frame, length) = (fields.frame, proof.scales.length);
    if !frame.spans.iter().any(|span| span.layered) {
        return Vec::new();
    }
    let Ok(contact) = &proof.contact else { return vec![[0.0, length]] };
    let near = NEAR * length;
    // At an end of the beam, contact is certain if the layer ends before it or exerts a force there.
    let layered = [0, frame.spans.len() - 1].map(|i| frame.spans[i].layered);
    let pressed =
        |x: f64| contact.forces.iter().any(|f| (f.x - x).abs() <= near && f.force[0] > 0.0);
    let certain = [!layered[0] || pressed(0.0), !layered[1] || pressed(length)];
    let edges = contact.regions.iter().flat_map(|region| [region.from, region.to]);
    let inside = edges.filter(|[low, high]| {
        !(certain[0] && *high <= near || certain[1] && length - near <= *low)
    });
    inside.map(|[low, high]| [low - near, high + near]).collect()
}

/// Whether a position lies in one of several intervals.
pub(crate) fn holds(intervals: &[[f64; 2]], x: f64) -> bool {
    intervals.iter().any(|[low, high]| *low <= x && x <= *high)
}

pub(crate) struct Comparison<'a, S> {
    pub document: &'a Document,
    pub fields: &'a Fields<'a, S>,
    pub patches: Patches<S>,
}

impl<S: Scalar> Comparison<'_, S> {
    pub fn length(&self) -> f64 {
        self.document.answer.pieces.last().map_or(0.0, |piece| piece.x[1])
    }

    /// Returns the index of the piece that contains a position, and the coordinate t of the position on this piece. A
    /// node belongs to the piece on its right.
    pub fn place(&self, x: f64) -> Result<(usize, S), NotProven> {
        let (pieces, near) = (&self.document.answer.pieces, NEAR * self.length());
        if !(-near <= x && x <= self.length() + near) {
            return Err(NotProven::new("a listed position is outside the beam").at(x));
        }
        let i = pieces.partition_point(|piece| piece.x[0] <= x).saturating_sub(1);
        let span = &self.fields.frame.spans[i];
        let t = if x <= pieces[i].x[0] {
            span.t[0]
        } else if x >= pieces[i].x[1] {
            span.t[1]
        } else {
            (self.fields.frame.units.metres(S::of(x)) - span.middle).div(span.half)
        };
        Ok((i, t))
    }

    /// Returns the absolute difference between `listed` and the value of a field at the coordinate t of a piece, in the
    /// units of the model.
    pub fn difference(&self, field: usize, listed: f64, (piece, t): (usize, S)) -> f64 {
        let ((_, force, length), units) = (FIELDS[field], self.fields.frame.units);
        let off = units.scaled(S::of(listed), force, length) - self.patches.value(field, piece, t);
        units.restored(off.size(), force, length)
    }

    /// Compares listed field values with the claimed solution immediately left of each station if `on_left`, otherwise
    /// immediately right of it.
    fn stations(
        &self,
        listed: &Stations,
        on_left: bool,
        contact: Option<&ContactSet>,
        found: &mut Differences,
    ) -> Result<(), NotProven> {
        let place = |x: &f64| {
            let (i, t) = self.place(*x)?;
            let spans = &self.fields.frame.spans;
            Ok(match on_left && i > 0 && t == spans[i].t[0] {
                true => (i - 1, spans[i - 1].t[1]),
                false => (i, t),
            })
        };
        let places: Vec<_> = listed.x.iter().map(place).collect::<Result<_, _>>()?;
        found.checked.stations += places.len();
        for (name, values) in &listed.fields {
            let Some(field) = field_named(name) else {
                found.unknown.push(format!("stations.{name}"));
                continue;
            };
            for ((x, place), value) in listed.x.iter().zip(&places).zip(values) {
                let edge = found.without_pressure.iter().find(|edge| holds(&[**edge], *x)).copied();
                if let Some(edge) = edge.filter(|_| field == PRESSURE && contact.is_some()) {
                    found.checked.at_edges += 1;
                    enlarge(&mut found.fields[field], self.off_an_edge(*value, *place, edge));
                    continue;
                }
                found.checked.values += 1;
                enlarge(&mut found.fields[field], self.difference(field, *value, *place));
            }
        }
        Ok(())
    }

    /// Returns the amount by which a pressure listed near a contact edge is below zero or above p. p is the largest
    /// claimed pressure at t on the piece, and on its neighbours at common nodes inside `edge`.
    fn off_an_edge(&self, listed: f64, (piece, t): (usize, S), edge: [f64; 2]) -> f64 {
        let units = self.fields.frame.units;
        let listed = units.scaled(S::of(listed), 1, -1);
        let mut high = 0.0;
        let spans = &self.fields.frame.spans;
        let [from, to] = self.document.answer.pieces[piece].x.map(|end| holds(&[edge], end));
        let first = if from { piece.saturating_sub(1) } else { piece };
        let last = if to { (piece + 1).min(spans.len() - 1) } else { piece };
        for i in first..=last {
            let t = if i < piece {
                spans[i].t[1]
            } else if i > piece {
                spans[i].t[0]
            } else {
                t
            };
            let value = self.patches.value(PRESSURE, i, t);
            high = f64::max(high, value.high());
        }
        let off = Size::below_zero(listed.low()).worst(Size::below_zero(high - listed.high()));
        units.restored(off.value(), 1, -1)
    }

    /// Compares a listed maximum with the claimed field: with its value at the listed position, and with its largest
    /// value. The larger difference bounds the error of the listed maximum. A minimum is treated in the same way.
    fn extreme(&self, extreme: &Extreme, found: &mut Differences) -> Result<(), NotProven> {
        let Some(field) = field_named(&extreme.field) else {
            found.unknown.push(format!("extremes.{}", extreme.field));
            return Ok(());
        };
        let off = self.nearest_difference(field, extreme.x, extreme.value)?;
        enlarge(&mut found.fields[field], off);
        enlarge(
            &mut found.fields[field],
            self.beyond(field, extreme, 0..self.patches.pieces.len()),
        );
        Ok(())
    }

    /// Returns the difference between `listed` and the value of a field at a position. At a node, the side with the smaller
    /// difference counts.
    pub fn nearest_difference(&self, field: usize, x: f64, listed: f64) -> Result<f64, NotProven> {
        let (i, t) = self.place(x)?;
        let here = self.difference(field, listed, (i, t));
        if i == 0 || t != self.fields.frame.spans[i].t[0] {
            return Ok(here);
        }
        let left = (i - 1, self.fields.frame.spans[i - 1].t[1]);
        let on_left = self.difference(field, listed, left);
        Ok(if on_left < here { on_left } else { here })
    }

    /// Returns the largest amount by which a field lies beyond its listed extreme on the given pieces: above a listed
    /// maximum, or below a listed minimum.
    pub fn beyond(&self, field: usize, extreme: &Extreme, pieces: Range<usize>) -> f64 {
        let ((_, force, length), units) = (FIELDS[field], self.fields.frame.units);
        let listed = units.scaled(S::of(extreme.value), force, length);
        let negligible = Size::of(f64::EPSILON * listed.size());
        let level = Line::from_coefficients([listed]);
        let all = || self.patches.pieces[pieces.clone()].iter().flatten();
        let mut budget = Budget::new(all().count());
        let deepest = all().map(|patch| {
            let inside = match extreme.is_max {
                true => patch.fields[field].times(-S::one()) + &level,
                false => patch.fields[field] - &level,
            };
            below(&inside.coarse(), Size::ZERO, negligible, patch.interval, &mut budget).depth
        });
        let deepest = deepest.fold(Size::ZERO, Size::worst);
        units.restored(deepest.value(), force, length)
    }

    /// Compares the stored pressures of open pieces with zero.
    fn idle_pressures(&self, found: &mut Differences) {
        let units = self.fields.frame.units;
        for (piece, span) in self.document.answer.pieces.iter().zip(&self.fields.frame.spans) {
            if !span.touches {
                let stored = piece.pressure.iter().map(|c| units.scaled(S::of(*c), 1, -1));
                let size = <Polynomial<_>>::from_coefficients(stored).size(span.tau);
                enlarge(&mut found.fields[PRESSURE], units.restored(size.value(), 1, -1));
            }
        }
    }
}

/// Replaces `most` by `value` if `value` is larger. NaN counts as infinite.
pub(crate) fn enlarge(most: &mut f64, value: f64) {
    *most = Size::of(*most).worst(Size::of(value)).value();
}

/// Returns the largest distance of a number from the numbers in an interval, rounded up.
pub(crate) fn farthest(x: f64, [low, high]: [f64; 2]) -> f64 {
    let [below, above] = [x - low, high - x].map(|d| if d == 0.0 { 0.0 } else { d.next_up() });
    Size::of(if below >= above { below } else { above }).value()
}

/// Returns the largest distances of both ends of each listed contact region from the exact ends.
fn edges(document: &Document, contact: &ContactSet) -> Result<Vec<[f64; 2]>, NotProven> {
    let mut shown: Vec<[[f64; 2]; 2]> = Vec::new();
    for region in &contact.regions {
        match shown.last_mut() {
            // Two proven contact regions that meet at the end of a shear layer are listed as one region.
            Some(last) if last[1] == region.from => last[1] = region.to,
            _ => shown.push([region.from, region.to]),
        }
    }
    let Some(listed) = &document.contact else {
        // The claimed edges lie within the proven intervals, so the width of an interval bounds the error of its edge.
        let width = |[low, high]: [f64; 2]| (high - low).next_up();
        return Ok(shown.into_iter().map(|ends| ends.map(width)).collect());
    };
    if listed.len() != shown.len() {
        let [listed, shown] = [listed.len(), shown.len()];
        let what = format!("{listed} contact regions are listed, {shown} are proven");
        return Err(NotProven::new(what));
    }
    let both = listed.iter().zip(&shown);
    Ok(both.map(|(x, exact)| [0, 1].map(|end| farthest(x[end], exact[end]))).collect())
}

mod tests;
