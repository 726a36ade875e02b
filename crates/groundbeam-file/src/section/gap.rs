//! `[[gap]]` and `[[gap_trough]]`.

use super::survey;
use crate::quantity::{CLEARANCE, GROUND_POSITION, POSITION, WIDTH};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::GapPoint;
use groundbeam::model::Part;

const KEYS: &[&str] = &["at", "value"];
const TROUGH_KEYS: &[&str] = &["at", "settlement", "width"];

/// The corners of the initial gap: those given, or those of a survey, and the troughs added to them.
pub(super) fn read(reader: &mut Reader, root: &Section, length: f64) -> Vec<GapPoint> {
    let mut gap = corners(reader, root);
    if let Some(table) = reader.table(root, "gap_survey", "[gap_survey]") {
        if let Some((name, _)) = root.table.get_key_value("gap") {
            let hint = "give the gap's corners, or the survey from which they follow";
            reader.exclusive(("gap", &name.span()), ("gap_survey", &table.span), hint);
        }
        gap = survey::read(reader, &table, length);
        place_all(reader, gap.len(), &table);
    }
    let tables = reader.tables(root, "gap_trough", "[[gap_trough]]");
    let troughs: Vec<Trough> = tables.iter().map(|table| Trough::read(reader, table)).collect();
    let readable = |trough: &Trough| !(trough.at + trough.settlement + trough.width).is_nan();
    if let Some(first) = tables.first()
        && troughs.iter().all(readable)
        && length > 0.0
        && gap.iter().all(|corner| corner.at.is_finite() && corner.value.is_finite())
    {
        gap = sunk(&gap, &troughs, length);
        place_all(reader, gap.len(), first);
    }
    gap
}

fn corners(reader: &mut Reader, root: &Section) -> Vec<GapPoint> {
    let tables = reader.tables(root, "gap", "[[gap]]");
    let mut gap = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        reader.refuse_unknown(table, KEYS);
        reader.places.part(Part::Gap(i), &table.span);
        let at = reader.required(table, "at", &POSITION);
        let value = reader.required(table, "value", &CLEARANCE);
        reader.places.field(Part::Gap(i), "at", &at);
        reader.places.field(Part::Gap(i), "value", &value);
        gap.push(GapPoint { at: at.value, value: value.value });
    }
    gap
}

/// What is wrong with a corner that the file does not list stands where it was made.
fn place_all(reader: &mut Reader, corners: usize, table: &Section) {
    for i in 0..corners {
        reader.places.part(Part::Gap(i), &table.span);
        reader.places.field(Part::Gap(i), "at", &Field::new(0.0, table.span.clone()));
    }
}

/// A settlement trough as over a tunnel: S exp(−(x − x₀)²/2i²), Peck (1969).
struct Trough {
    at: f64,
    /// S, down.
    settlement: f64,
    /// i, from the middle to the point of inflection.
    width: f64,
}

impl Trough {
    fn read(reader: &mut Reader, table: &Section) -> Self {
        reader.refuse_unknown(table, TROUGH_KEYS);
        let at = reader.required(table, "at", &GROUND_POSITION).value;
        let settlement = reader.required(table, "settlement", &CLEARANCE).value;
        let width = reader.required(table, "width", &WIDTH);
        let width = reader.positive("width", width).value;
        Trough { at, settlement, width }
    }

    fn depth(&self, x: f64) -> f64 {
        let t = (x - self.at) / self.width;
        self.settlement * (-0.5 * t * t).exp()
    }

    /// Corners between which a straight line is nowhere off by more than S/1000: |S″| is at most S/i², so a
    /// step h is off by at most S h²/8i². Beyond 4i less than S/2000 is left.
    fn places(&self) -> impl Iterator<Item = f64> {
        const STEPS: i32 = 45;
        const REACH: f64 = 4.0;
        let step = REACH * self.width / f64::from(STEPS);
        let at = self.at;
        (-STEPS..=STEPS).map(move |i| at + f64::from(i) * step)
    }
}

/// The gap with the troughs added, linear between the corners of both.
fn sunk(gap: &[GapPoint], troughs: &[Trough], length: f64) -> Vec<GapPoint> {
    let base = |x: f64| {
        let right = gap.partition_point(|corner| corner.at < x);
        match (right.checked_sub(1).map(|i| gap[i]), gap.get(right)) {
            (Some(a), Some(b)) => (a.value * (b.at - x) + b.value * (x - a.at)) / (b.at - a.at),
            (Some(only), None) => only.value,
            (None, Some(only)) => only.value,
            (None, None) => 0.0,
        }
    };
    let own = gap.iter().map(|corner| corner.at);
    let mut places: Vec<f64> =
        own.chain([0.0, length]).chain(troughs.iter().flat_map(Trough::places)).collect();
    places.retain(|x| (0.0..=length).contains(x));
    places.sort_by(f64::total_cmp);
    // Corners closer than rounding would be slopes of nothing.
    places.dedup_by(|next, last| {
        let same = *next - *last <= 1e-9 * length;
        if same && *next == length {
            *last = length;
        }
        same
    });
    let depth = |x: f64| troughs.iter().map(|trough| trough.depth(x)).sum::<f64>();
    places.into_iter().map(|at| GapPoint { at, value: base(at) + depth(at) }).collect()
}
