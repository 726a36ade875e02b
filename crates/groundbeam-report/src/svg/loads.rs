//! Draws the loads on the beam as arrows, rows of arrows, rotation arrows and curved lines, with labels.

use super::canvas::{Anchor, Canvas, Style, printed};
use super::diagram::arrow;
use super::frame::Frame;
use super::labels::{Labels, Place, Rect};
use super::paint::{Colour, Fill, Stroke};
use super::style::{DISTRIBUTED, LABEL};
use crate::load::{is_moment_per_length, load_kind, load_size};
use crate::quantity::Units;
use groundbeam::{
    Load,
    model::{Action, Extent},
};

/// Height of a lane: a horizontal strip above the beam for distributed loads.
const LANE: f64 = 22.0;
/// Height reserved above a lane for the labels of its loads.
const LANE_LABEL: f64 = 18.0;
/// Maximum number of lanes for distributed loads; further loads share the last lane.
const MOST_LANES: usize = 3;
/// Radius of a rotation arrow.
const RADIUS: f64 = 14.0;

/// Draws loads on the beam's upper side.
pub(super) struct Loads<'a> {
    pub units: Units,
    pub frame: &'a Frame<'a>,
    /// Function that returns the height of the beam's upper side on the page at a position along the beam.
    pub top: &'a dyn Fn(f64) -> f64,
}

/// A label to be placed, with its candidate positions.
struct Wanted {
    words: String,
    places: Vec<Place>,
    weight: f64,
}

impl Loads<'_> {
    pub fn draw(&self, canvas: &mut Canvas, loads: &[Load], labels: &mut Labels) {
        let mut wanted = Vec::new();
        let lanes = self.spread(canvas, loads, labels, &mut wanted);
        self.points(canvas, loads, labels, lanes, &mut wanted);
        // The labels of the largest loads are placed first, in the best positions.
        wanted.sort_by(|a, b| b.weight.total_cmp(&a.weight));
        for Wanted { words, places, .. } in wanted {
            let style = Style { colour: Colour::Load, ..LABEL };
            if let Some(place) = labels.at(&places, &words, style.size) {
                canvas.text([place.x, place.baseline], Anchor::Start, style, &words);
            }
        }
    }

    /// Draws distributed loads, in separate lanes if they overlap. Returns the number of lanes.
    fn spread(
        &self,
        canvas: &mut Canvas,
        loads: &[Load],
        labels: &mut Labels,
        wanted: &mut Vec<Wanted>,
    ) -> usize {
        let mut ends: Vec<Vec<[f64; 2]>> = Vec::new();
        let distributed = || {
            let on_beam = loads.iter().filter(|load| !load.is_on_ground());
            on_beam.filter(|load| load.extent().is_distributed())
        };
        let forces = distributed().filter(|load| load.action() == Action::Force);
        let force = forces.map(|load| load.extent().largest()).fold(0.0, f64::max);
        for load in distributed() {
            let [from, to] = load.extent().ends();
            let is_free = |lane: &Vec<[f64; 2]>| lane.iter().all(|o| to <= o[0] || o[1] <= from);
            let lane = match ends.iter().position(is_free) {
                Some(lane) => lane,
                None if ends.len() < MOST_LANES => {
                    ends.push(Vec::new());
                    ends.len() - 1
                }
                None => MOST_LANES - 1,
            };
            ends[lane].push([from, to]);
            let base = 4.0 + lane as f64 * (LANE + LANE_LABEL);
            let sizes = load.extent().sizes();
            let words = printed(&load_size(load, self.units, " … "));
            let (share, words) = match load.action() {
                Action::Force => {
                    let share = sizes.map(|value| value / force);
                    self.area(canvas, [from, to], share, base);
                    (share, words)
                }
                Action::Moment => {
                    self.turning_row(canvas, [from, to], sizes, base);
                    // A moment per length has the unit of a force. The text `m/m` shows that the load is a
                    // moment.
                    let per = if is_moment_per_length(load, self.units) { " m/m" } else { "" };
                    ([0.5; 2], words + per)
                }
                Action::Curvature => {
                    self.bent_line(canvas, [from, to], sizes, base + 0.4 * LANE);
                    ([0.8; 2], format!("curvature {words}"))
                }
            };
            wanted.push(self.beside_area([from, to], share, base, words, labels));
        }
        ends.len()
    }

    /// Draws a distributed force as an outline with arrows inside.
    fn area(&self, canvas: &mut Canvas, [from, to]: [f64; 2], share: [f64; 2], base: f64) {
        let height = |t: f64| LANE * (share[0] + (share[1] - share[0]) * t);
        let width = self.frame.x(to) - self.frame.x(from);
        let steps = (width / 12.0).ceil().clamp(1.0, 200.0) as usize;
        let at = |t: f64| {
            let x = from + (to - from) * t;
            [self.frame.x(x), (self.top)(x) - base]
        };
        let t = |i: usize| i as f64 / steps as f64;
        let lower: Vec<_> = (0..=steps).map(|i| at(t(i))).collect();
        let upper: Vec<_> =
            (0..=steps).rev().map(|i| [at(t(i))[0], at(t(i))[1] - height(t(i)).abs()]).collect();
        let outline = [lower, upper].concat();
        canvas.polyline(&outline, true, DISTRIBUTED);
        let arrows = (width / 16.0).floor().clamp(1.0, 60.0) as usize;
        for i in 0..=arrows {
            let t = i as f64 / arrows as f64;
            let [x, low] = at(t);
            let high = low - height(t).abs();
            if height(t) > 7.0 {
                arrow(canvas, [x, high], [x, low], Colour::Load, 0.9);
            } else if height(t) < -7.0 {
                arrow(canvas, [x, low], [x, high], Colour::Load, 0.9);
            }
        }
    }

    /// Draws an imposed curvature as the curve that a straight beam between two pins would take.
    fn bent_line(&self, canvas: &mut Canvas, [from, to]: [f64; 2], ends: [f64; 2], base: f64) {
        let [a, b] = [ends[0], ends[1] - ends[0]];
        let bend = |t: f64| 0.5 * a * t * (t - 1.0) + b / 6.0 * t * (t * t - 1.0);
        let t = |i: usize| i as f64 / 40.0;
        let largest = (0..=40).map(|i| bend(t(i)).abs()).fold(0.0, f64::max);
        if largest == 0.0 {
            return;
        }
        let point = |i: usize| {
            let x = from + (to - from) * t(i);
            let bent = 0.35 * LANE * bend(t(i)) / largest;
            [self.frame.x(x), (self.top)(x) - base + bent]
        };
        let line: Vec<_> = (0..=40).map(point).collect();
        let dashes = Stroke::new(Colour::Load, 1.6).dashed(9.0, 3.0);
        canvas.polyline(&line, false, Fill::NONE.and(dashes));
    }

    fn turning_row(&self, canvas: &mut Canvas, [from, to]: [f64; 2], ends: [f64; 2], base: f64) {
        let width = self.frame.x(to) - self.frame.x(from);
        let count = (width / 34.0).floor().clamp(1.0, 40.0) as usize;
        for i in 0..count {
            let t = (i as f64 + 0.5) / count as f64;
            let x = from + (to - from) * t;
            let moment = ends[0] + (ends[1] - ends[0]) * t;
            let centre = [self.frame.x(x), (self.top)(x) - base - 0.4 * LANE];
            turning_arrow(canvas, centre, 8.0, moment >= 0.0);
        }
    }

    fn beside_area(
        &self,
        [from, to]: [f64; 2],
        share: [f64; 2],
        base: f64,
        words: String,
        labels: &mut Labels,
    ) -> Wanted {
        let height = |t: f64| LANE * (share[0] + (share[1] - share[0]) * t).abs();
        let width = labels.width(&words, LABEL.size);
        let mut places = Vec::new();
        for rise in [5.0, 18.0, 31.0, 44.0] {
            for step in 0..40 {
                // The first position of the label is above the middle of the load. Further positions lie
                // alternately to the left and to the right.
                let side = if step % 2 == 0 { 0.5 } else { -0.5 };
                let t = 0.5 + side * f64::from(step) / 41.0;
                let x = from + (to - from) * t;
                let left = self.frame.x(x) - 0.5 * width;
                let top = (self.top)(x) - base - height(t).max(height(0.5));
                places.push(Place { x: left, baseline: top - rise });
            }
        }
        // The label positions that are tried last lie beside the ends of the load. They are used if arrows
        // occupy the space above the load.
        let level = |x: f64| (self.top)(x) - base - 4.0;
        places.push(Place { x: self.frame.x(to) + 6.0, baseline: level(to) });
        places.push(Place { x: self.frame.x(from) - 6.0 - width, baseline: level(from) });
        // No label may cover the drawn load. Narrow rectangles approximate its sloping upper edge.
        let slices = ((self.frame.x(to) - self.frame.x(from)) / 6.0).clamp(1.0, 200.0) as u32;
        for i in 0..slices {
            let [a, b] = [i, i + 1].map(|i| f64::from(i) / f64::from(slices));
            let x = [a, b].map(|t| from + (to - from) * t);
            let low = (self.top)(x[0]) - base;
            let corner = [self.frame.x(x[1]), low - height(a).max(height(b))];
            labels.avoid(Rect::around([self.frame.x(x[0]), low], corner, 0.0));
        }
        Wanted { words, places, weight: f64::INFINITY }
    }

    /// Draws point forces and moments. The arrows of point forces extend above all distributed loads.
    fn points(
        &self,
        canvas: &mut Canvas,
        loads: &[Load],
        labels: &mut Labels,
        lanes: usize,
        wanted: &mut Vec<Wanted>,
    ) {
        let above = lanes as f64 * (LANE + LANE_LABEL);
        let points = || {
            loads.iter().filter(|load| !load.is_on_ground()).filter_map(|load| {
                match load.extent() {
                    Extent::Point { at, size } if size != 0.0 => Some((load, at, size)),
                    _ => None,
                }
            })
        };
        let forces = points().filter(|(load, ..)| load.action() == Action::Force);
        let largest = forces.map(|(_, _, force)| force.abs()).fold(0.0, f64::max);
        for (load, at, size) in points() {
            let words = printed(&self.units.write(load_kind(load), size.abs()));
            if load.action() == Action::Moment {
                let centre = [self.frame.x(at), (self.top)(at) + 3.0];
                turning_arrow(canvas, centre, RADIUS, size > 0.0);
                let [x, y] = centre;
                let arc = Rect::around([x - RADIUS, y - RADIUS], [x + RADIUS, y], 3.0);
                labels.avoid(arc);
                wanted.push(self.beside([x, y - RADIUS - 2.0], words, 0.5, labels));
                continue;
            }
            let share = size.abs() / largest;
            let length = above + 18.0 + 26.0 * share;
            let [x, tip] = [self.frame.x(at), (self.top)(at) - 1.5];
            let (from, to) = if size > 0.0 { (tip - length, tip) } else { (tip, tip - length) };
            arrow(canvas, [x, from], [x, to], Colour::Load, 2.0);
            labels.avoid(Rect::around([x, tip], [x, tip - length], 3.0));
            wanted.push(self.beside([x, tip - length], words, share, labels));
        }
    }

    /// Returns a label with candidate positions above a point, beside the point, and below the beam.
    fn beside(&self, [x, y]: [f64; 2], words: String, weight: f64, labels: &Labels) -> Wanted {
        let width = labels.width(&words, LABEL.size);
        let mut places = vec![Place { x: x - 0.5 * width, baseline: y - 8.0 }];
        for drop in [8.0, 20.0] {
            places.push(Place { x: x + 8.0, baseline: y + drop });
            places.push(Place { x: x - 8.0 - width, baseline: y + drop });
        }
        for rise in [21.0, 34.0, 47.0] {
            places.push(Place { x: x - 0.5 * width, baseline: y - rise });
        }
        // The arrow of a moment is wider than that of a force, so its label needs a larger distance.
        places.push(Place { x: x + RADIUS + 8.0, baseline: y + 8.0 });
        places.push(Place { x: x - RADIUS - 8.0 - width, baseline: y + 8.0 });
        // The label positions that are tried last lie below the beam.
        for drop in [44.0, 58.0] {
            places.push(Place { x: x - 0.5 * width, baseline: y + drop });
        }
        Wanted { words, places, weight }
    }
}

/// Draws the rotation arrow of a moment as an arc. If `clockwise` is true, the moment turns the right side of
/// the beam down.
fn turning_arrow(canvas: &mut Canvas, [x, y]: [f64; 2], radius: f64, clockwise: bool) {
    let side = if clockwise { 1.0 } else { -1.0 };
    // The arc starts 20° below the horizontal on one side of its centre. It ends 22° above the horizontal on
    // the opposite side.
    let point = |degrees: f64, radius: f64| {
        let angle = degrees.to_radians();
        [x + side * radius * angle.cos(), y - radius * angle.sin()]
    };
    let ends = [point(200.0, radius), point(22.0, radius)];
    let width = if radius > 10.0 { 2.0 } else { 1.2 };
    // A pale line underneath makes the arc visible on arrows and on the beam.
    for stroke in [Stroke::new(Colour::Paper, 4.5), Stroke::new(Colour::Load, width)] {
        canvas.arc(ends, radius, clockwise, Fill::NONE.and(stroke));
    }
    canvas.reserve(y - radius);
    let half = 0.3 * radius;
    let tip = point(-4.0, radius);
    let head = [tip, point(24.0, radius - half), point(24.0, radius + half)];
    canvas.polyline(&head, true, Fill::new(Colour::Load));
}
