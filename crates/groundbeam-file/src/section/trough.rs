//! Reads `[[gap_trough]]`, and computes the polygon that replaces settlement troughs.

use super::chords::Spacing;
use crate::keys::{ALSO_AT, ALSO_WIDTH, Table, quantity};
use crate::quantity::{CLEARANCE, GROUND_POSITION, WIDTH};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::{Model, model::GapPoint};

pub(super) static TABLE: Table = Table {
    name: "[[gap_trough]]",
    keys: &[
        quantity("at", &GROUND_POSITION, "The position x₀ of the middle of the trough.")
            .needed()
            .also(ALSO_AT),
        quantity("settlement", &CLEARANCE, "The largest settlement S, positive downward.").needed(),
        quantity("width", &WIDTH, "The distance i from the middle to the point of inflection.")
            .needed()
            .also(ALSO_WIDTH),
    ],
};

/// Maximum number of points that the settlement troughs may add to the polygon of the initial gap.
pub(super) const MOST_CHORDS: usize = 10_000;
/// Step of the integration of the number of chords per length over a settlement trough, as a fraction of its width.
const STEP: f64 = 1.0 / 16.0;
/// Range of the integration on each side of the middle, in trough widths. At its end, the settlement is less than 2e-14
/// of its maximum.
const REACH: f64 = 8.0;

/// Smallest magnitude of a nonzero gap, which is the smallest nonzero number that a model may have.
const LEAST: f64 = 1e-60;

/// A settlement trough, such as above a tunnel, with the shape S exp(−(x − x₀)²/(2i²)), Peck (1969).
#[derive(Debug, Clone, Copy)]
pub(super) struct Trough {
    pub at: f64,
    /// Largest settlement S, positive downward.
    pub settlement: f64,
    /// Distance i from the middle to the point of inflection.
    pub width: f64,
}

impl Trough {
    pub fn read(reader: &mut Reader, table: &Section) -> Self {
        let at = reader.required(table, "at").value;
        let settlement = reader.required(table, "settlement").value;
        let width = reader.required(table, "width");
        let width = reader.positive("width", width).value;
        Trough { at, settlement, width }
    }

    pub fn is_readable(&self) -> bool {
        (self.at + self.settlement + self.width).is_finite()
    }

    /// Returns an upper bound of the absolute curvature of the settlement trough at a distance of t trough widths from
    /// its middle. The argument is `t2` = t².
    pub fn largest_curvature(&self, t2: f64) -> f64 {
        let size = (self.settlement / (self.width * self.width)).abs();
        size * (t2 * t2 - t2 + 1.0).sqrt() * (-0.5 * t2).exp()
    }

    fn depth(&self, x: f64) -> f64 {
        let t = (x - self.at) / self.width;
        self.settlement * (-0.5 * t * t).exp()
    }

    /// Returns the ends of the steps of the numerical integration over the settlement trough. They are positions along
    /// the beam, symmetric about the middle of the trough.
    fn grid(&self) -> impl Iterator<Item = f64> {
        let steps = (REACH / STEP) as i32;
        let Trough { at, width, .. } = *self;
        (-steps..=steps).map(move |i| at + f64::from(i) * STEP * width)
    }
}

/// Returns the polygon for the initial gap plus the settlement troughs. If it needs more than [`MOST_CHORDS`]
/// additional points, their number is the error.
pub(super) fn sunk(
    model: &Model,
    troughs: &[Trough],
    spacing: &Spacing,
) -> Result<Vec<GapPoint>, f64> {
    let length = model.beam.length;
    let depth = |x: f64| troughs.iter().map(|trough| trough.depth(x)).sum::<f64>();
    let own = model.gap.iter().map(|corner| corner.at);
    let kept = sorted(own.chain([0.0, length]), length);
    let grid = sorted(kept.iter().copied().chain(troughs.iter().flat_map(Trough::grid)), length);
    let mut places = vec![0.0];
    let mut stretch = Vec::new();
    let mut chords = 0.0;
    let mut next = 1;
    for pair in grid.windows(2) {
        let density = spacing.chords_per_length(0.5 * (pair[0] + pair[1]));
        stretch.push((pair[0], pair[1], density));
        if pair[1] >= kept[next] {
            chords += divide(&stretch, &mut places);
            stretch.clear();
            next += 1;
        }
    }
    if chords > MOST_CHORDS as f64 {
        return Err(chords);
    }
    let corner = |at: f64| {
        let value = base(&model.gap, at) + depth(at);
        GapPoint { at, value: if value.abs() < LEAST { 0.0 } else { value } }
    };
    Ok(places.into_iter().map(corner).collect())
}

/// Divides a stretch into chords with equal integrals of the number of chords per length. Appends their right ends to
/// `places`, and returns the number of points between them.
fn divide(stretch: &[(f64, f64, f64)], places: &mut Vec<f64>) -> f64 {
    let whole: f64 = stretch.iter().map(|(from, to, density)| (to - from) * density).sum();
    let parts = whole.ceil().max(1.0);
    if parts + places.len() as f64 <= 4.0 * MOST_CHORDS as f64 {
        let (mut done, mut part) = (0.0, 1.0);
        for (from, to, density) in stretch {
            let step = (to - from) * density;
            while part < parts && whole * (part / parts) <= done + step {
                places.push(from + (whole * (part / parts) - done) / density);
                part += 1.0;
            }
            done += step;
        }
    }
    places.extend(stretch.last().map(|(_, to, _)| *to));
    parts - 1.0
}

/// Returns the initial gap at the position `x` without the settlement troughs.
fn base(gap: &[GapPoint], x: f64) -> f64 {
    let right = gap.partition_point(|corner| corner.at < x);
    match (right.checked_sub(1).map(|i| gap[i]), gap.get(right)) {
        (Some(a), Some(b)) => (a.value * (b.at - x) + b.value * (x - a.at)) / (b.at - a.at),
        (Some(only), None) => only.value,
        (None, Some(only)) => only.value,
        (None, None) => 0.0,
    }
}

/// Sorts the positions on the beam from left to right, and merges positions that differ only by rounding
/// errors.
fn sorted(places: impl Iterator<Item = f64>, length: f64) -> Vec<f64> {
    let mut places: Vec<f64> = places.filter(|x| (0.0..=length).contains(x)).collect();
    places.sort_by(f64::total_cmp);
    places.dedup_by(|next, last| {
        let same = *next - *last <= 1e-9 * length;
        if same && *next == length {
            *last = length;
        }
        same
    });
    places
}
