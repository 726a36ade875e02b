//! The numbers that a document lists besides its answer, compared with the fields of the answer.

use crate::contact_set::ContactSet;
use crate::document::{Document, Extreme};
use crate::fields::Fields;
use crate::patches::{FIELDS, PRESSURE, Patches, field_named};
use crate::polynomial::{Budget, Polynomial, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// Places are told apart if they are farther from one another than this, as a part of the length.
const NEAR: f64 = 16.0 * f64::EPSILON;

/// How many listed numbers were compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Checked {
    /// Places at which the fields are listed.
    pub stations: usize,
    /// Values at all stations.
    pub values: usize,
    /// Pressures within the interval of an edge, where nothing is shown.
    pub at_edges: usize,
    /// Extremes.
    pub extremes: usize,
    /// Regions and points of contact.
    pub regions: usize,
    /// Concentrated forces, the forces under the ends among them.
    pub forces: usize,
    /// Bounds of errors that the document claims.
    pub bounds: usize,
}

/// By how much listed numbers differ from what the answer's pieces give, at most.
#[derive(Debug, Default)]
pub(crate) struct Differences {
    /// Of each field, in the order of [`FIELDS`].
    pub fields: [f64; 8],
    /// Of the edges of contact from the exact ones.
    pub edges: f64,
    /// Of concentrated forces from the exact ones.
    pub forces: f64,
    pub checked: Checked,
    /// Listed fields that are not known.
    pub unknown: Vec<String>,
    /// The first listed number that does not fit the answer at all.
    pub failed: Option<NotProven>,
}

/// Compares stations, extremes, contact and forces.
pub(crate) fn differences<S: Scalar>(
    document: &Document,
    fields: &Fields<S>,
    contact: Option<&ContactSet>,
) -> Differences {
    let comparison = Comparison { document, fields, patches: Patches::of(fields) };
    let mut found = Differences::default();
    let extremes = || document.extremes.iter();
    let mut failed = comparison.stations(contact, &mut found).err();
    for extreme in extremes() {
        failed = failed.or(comparison.extreme(extreme, &mut found).err());
    }
    if let Some(contact) = contact {
        match edges(document, contact) {
            Ok(edges) => found.edges = edges,
            Err(why) => failed = failed.or(Some(why)),
        }
        comparison.forces(contact, &mut found);
    }
    comparison.idle_pressures(&mut found);
    found.checked.regions = document.contact.as_ref().map_or(0, Vec::len);
    found.checked.extremes = extremes().filter(|e| field_named(&e.field).is_some()).count();
    found.failed = failed;
    found
}

struct Comparison<'a, S> {
    document: &'a Document,
    fields: &'a Fields<'a, S>,
    patches: Patches<S>,
}

impl<S: Scalar> Comparison<'_, S> {
    fn length(&self) -> f64 {
        self.document.answer.pieces.last().map_or(0.0, |piece| piece.x[1])
    }

    /// Piece and t of a place, by the stored ends of the pieces; of a node those on its right, at the right end of the beam
    /// on its left.
    fn place(&self, x: f64) -> Result<(usize, S), NotProven> {
        let (pieces, near) = (&self.document.answer.pieces, NEAR * self.length());
        if !(-near <= x && x <= self.length() + near) {
            return Err(NotProven::new("a listed number stands off the beam").at(x));
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

    /// |listed − field| in the units of the model.
    fn difference(&self, field: usize, listed: f64, (piece, t): (usize, S)) -> f64 {
        let ((_, force, length), units) = (FIELDS[field], self.fields.frame.units);
        let off = units.scaled(S::of(listed), force, length) - self.patches.value(field, piece, t);
        units.restored(off.size(), force, length)
    }

    fn stations(
        &self,
        contact: Option<&ContactSet>,
        found: &mut Differences,
    ) -> Result<(), NotProven> {
        let places: Vec<_> =
            self.document.stations.iter().map(|x| self.place(*x)).collect::<Result<_, _>>()?;
        found.checked.stations = places.len();
        for (name, values) in &self.document.fields {
            let Some(field) = field_named(name) else {
                found.unknown.push(format!("stations.{name}"));
                continue;
            };
            for ((x, place), value) in self.document.stations.iter().zip(&places).zip(values) {
                let at_edge = contact.is_some_and(|contact| self.is_at_edge(*x, contact));
                if field == PRESSURE && at_edge {
                    found.checked.at_edges += 1;
                    enlarge(&mut found.fields[field], self.off_an_edge(*value, *place));
                    continue;
                }
                found.checked.values += 1;
                enlarge(&mut found.fields[field], self.difference(field, *value, *place));
            }
        }
        Ok(())
    }

    /// By how much a pressure at an edge lies outside of zero and the pressures of the pieces on both sides.
    fn off_an_edge(&self, listed: f64, (piece, t): (usize, S)) -> f64 {
        let units = self.fields.frame.units;
        let listed = units.scaled(S::of(listed), 1, -1);
        let [mut low, mut high] = [0.0; 2];
        let neighbours = [piece.checked_sub(1), Some(piece), Some(piece + 1)];
        let spans = &self.fields.frame.spans;
        for i in neighbours.into_iter().flatten().filter(|i| *i < spans.len()) {
            let t = if i < piece {
                spans[i].t[1]
            } else if i > piece {
                spans[i].t[0]
            } else {
                t
            };
            let value = self.patches.value(PRESSURE, i, t);
            low = if value.low() < low { value.low() } else { low };
            high = if value.high() > high { value.high() } else { high };
        }
        let off =
            Size::below_zero(listed.low() - low).worst(Size::below_zero(high - listed.high()));
        units.restored(off.value(), 1, -1)
    }

    /// Whether a place may be the exact edge of a region, inside the beam.
    fn is_at_edge(&self, x: f64, contact: &ContactSet) -> bool {
        let (near, end) = (NEAR * self.length(), self.length());
        let holds = |[low, high]: [f64; 2]| low - near <= x && x <= high + near;
        let any = contact.regions.iter().any(|region| holds(region.from) || holds(region.to));
        any && near < x && x < end - near
    }

    /// |listed − the largest value of the field|, and of the field at the listed place, whichever is more.
    ///
    /// The largest value is at least the one at the place, on either side, and exceeds the listed one by at most the
    /// depth of listed − field below zero.
    fn extreme(&self, extreme: &Extreme, found: &mut Differences) -> Result<(), NotProven> {
        let Some(field) = field_named(&extreme.field) else {
            found.unknown.push(format!("extremes.{}", extreme.field));
            return Ok(());
        };
        let place = self.place(extreme.x)?;
        let mut off = self.difference(field, extreme.value, place);
        let (i, t) = place;
        if i > 0 && t == self.fields.frame.spans[i].t[0] {
            let left = (i - 1, self.fields.frame.spans[i - 1].t[1]);
            let on_left = self.difference(field, extreme.value, left);
            off = if on_left < off { on_left } else { off };
        }
        enlarge(&mut found.fields[field], off);
        enlarge(&mut found.fields[field], self.beyond(field, extreme));
        Ok(())
    }

    /// By how much a field exceeds its listed extreme anywhere.
    fn beyond(&self, field: usize, extreme: &Extreme) -> f64 {
        let ((_, force, length), units) = (FIELDS[field], self.fields.frame.units);
        let listed = units.scaled(S::of(extreme.value), force, length);
        let negligible = Size::of(f64::EPSILON * listed.size());
        let level = Polynomial::from_coefficients([listed]);
        let all = || self.patches.pieces.iter().flatten();
        let mut budget = Budget::new(all().count());
        let deepest = all().map(|patch| {
            let inside = match extreme.is_max {
                true => &level - &patch.fields[field],
                false => &patch.fields[field] - &level,
            };
            below(&inside.coarse(), Size::ZERO, negligible, patch.interval, &mut budget).depth
        });
        let deepest = deepest.fold(Size::ZERO, Size::worst);
        units.restored(deepest.value(), force, length)
    }

    /// Stored pressures of open pieces, where the pressure is zero.
    fn idle_pressures(&self, found: &mut Differences) {
        let units = self.fields.frame.units;
        for (piece, span) in self.document.answer.pieces.iter().zip(&self.fields.frame.spans) {
            if !span.touches {
                let stored = piece.pressure.iter().map(|c| units.scaled(S::of(*c), 1, -1));
                let size = Polynomial::from_coefficients(stored).size(span.tau);
                enlarge(&mut found.fields[PRESSURE], units.restored(size.value(), 1, -1));
            }
        }
    }

    /// Listed concentrated forces against the exact ones. A force that is not listed is zero.
    fn forces(&self, contact: &ContactSet, found: &mut Differences) {
        let near = NEAR * self.length();
        let mut listed: Vec<[f64; 2]> =
            self.document.answer.forces.iter().map(|force| [force.x, force.force]).collect();
        if let Some([left, right]) = self.document.end_forces {
            listed.extend([[0.0, left], [self.length(), right]]);
        }
        let exact_at = |x: f64| contact.forces.iter().find(|force| (force.x - x).abs() <= near);
        for [x, force] in &listed {
            let exact = exact_at(*x).map_or([0.0; 2], |exact| exact.force);
            enlarge(&mut found.forces, farthest(*force, exact));
        }
        for exact in &contact.forces {
            if !listed.iter().any(|[x, _]| (exact.x - x).abs() <= near) {
                enlarge(&mut found.forces, farthest(0.0, exact.force));
            }
        }
        found.checked.forces = listed.len();
    }
}

/// The larger one; NaN counts as infinite.
fn enlarge(most: &mut f64, value: f64) {
    *most = Size::of(*most).worst(Size::of(value)).value();
}

/// The largest distance of a number from those of an interval, rounded up.
fn farthest(x: f64, [low, high]: [f64; 2]) -> f64 {
    let [below, above] = [x - low, high - x].map(|d| if d == 0.0 { 0.0 } else { d.next_up() });
    if below >= above { below } else { above }
}

/// The largest distance of listed edges from the exact ones.
fn edges(document: &Document, contact: &ContactSet) -> Result<f64, NotProven> {
    let mut shown: Vec<[[f64; 2]; 2]> = Vec::new();
    for region in &contact.regions {
        match shown.last_mut() {
            // A region that goes on beyond the end of a layer is listed as one.
            Some(last) if last[1] == region.from => last[1] = region.to,
            _ => shown.push([region.from, region.to]),
        }
    }
    let Some(listed) = &document.contact else {
        // The edges of the pieces lie within the shown intervals.
        let widths = shown.iter().flatten().map(|[low, high]| (high - low).next_up());
        return Ok(widths.fold(0.0, |most, width| if width > most { width } else { most }));
    };
    if listed.len() != shown.len() {
        let [listed, shown] = [listed.len(), shown.len()];
        let what = format!("{listed} contact regions are listed, {shown} are shown");
        return Err(NotProven::new(what));
    }
    let mut most = 0.0;
    for (listed, shown) in listed.iter().zip(&shown) {
        for (x, interval) in listed.iter().zip(shown) {
            enlarge(&mut most, farthest(*x, *interval));
        }
    }
    Ok(most)
}
