//! Draws the diagram of a field along the beam, with its zero line, its curve and its labelled extremes.

use super::axis;
use super::canvas::{Anchor, Canvas, printed};
use super::frame::{Frame, LEFT};
use super::labels::{Labels, Rect};
use super::paint::{Colour, Fill, Stroke};
use super::samples::simplified;
use super::style::{NOTE, PANEL_TITLE, RIMMED, TICK};
use crate::font::Metrics;
use crate::quantity::{Kind, Unit, Units};
use groundbeam::{Field, solution::Extreme};

/// Distance from the baseline of the title to the top of the diagram.
const TOP: f64 = 9.0;
/// Height of a diagram without its title.
const HEIGHT: f64 = 136.0;
/// Height of an empty diagram.
const EMPTY: f64 = 30.0;
/// Fraction of the diagram's height for the values; the rest of the height is for labels.
const FILLED: f64 = 0.68;
/// Length of the longest arrow of a point force.
const LONGEST_ARROW: f64 = 50.0;

/// Content of a diagram.
pub(super) struct Diagram<'a> {
    pub title: &'a str,
    pub note: &'a str,
    pub kind: Kind,
    pub units: Units,
    pub colour: Colour,
    /// Whether positive values are drawn downward.
    pub downward: bool,
    pub values: Vec<(f64, f64)>,
    /// Lower line of an envelope whose upper line is `values`; empty for a single line.
    pub lower: Vec<(f64, f64)>,
    /// Points of the thin lines. The thin lines show either the individual solutions of an envelope or a second
    /// field.
    pub thin: Vec<Vec<(f64, f64)>>,
    pub extremes: Vec<Extreme>,
    /// Point forces that push the beam up, with their labels.
    pub forces: Vec<(f64, f64, String)>,
    /// Positions of contact edges.
    pub edges: &'a [f64],
}

impl Diagram<'static> {
    /// An empty diagram of a field.
    pub fn of(field: Field, units: Units) -> Self {
        let (note, colour) = match field {
            Field::Pressure => (field.positive(), Colour::Pressure),
            Field::Moment => ("drawn on the tension side", Colour::Moment),
            Field::ShearForce => (field.positive(), Colour::Shear),
            Field::Gap => ("between beam and ground", Colour::GroundLine),
            _ => (field.positive(), Colour::Beam),
        };
        Diagram {
            title: field.title(),
            note,
            kind: Kind::of(field),
            units,
            colour,
            downward: field.drawn_down(),
            values: Vec::new(),
            lower: Vec::new(),
            thin: Vec::new(),
            extremes: Vec::new(),
            forces: Vec::new(),
            edges: &[],
        }
    }
}

/// Extremes to be labelled. For the contact pressure only the largest value is labelled, because the smallest
/// is zero or irrelevant.
pub(super) fn worth_naming(field: Field, mut extremes: Vec<Extreme>) -> Vec<Extreme> {
    if field == Field::Pressure {
        extremes.truncate(1);
    }
    extremes
}

/// Fields whose envelopes are drawn, from top to bottom.
pub(crate) const OF_ENVELOPES: [Field; 4] =
    [Field::Deflection, Field::Pressure, Field::Moment, Field::ShearForce];

impl Diagram<'_> {
    pub fn draw(&self, frame: &Frame, metrics: &Metrics) -> Canvas {
        let mut canvas = Canvas::new();
        let [low, high] = self.range();
        let unit = self.units.unit(self.kind, low.abs().max(high.abs()));
        self.title(&mut canvas, frame, unit, metrics);
        let is_empty = low == high && self.forces.is_empty();
        let height = if is_empty { EMPTY } else { HEIGHT };
        let (left, right) = (LEFT + 2.0, frame.width - 4.0);
        let page = Rect { left, top: TOP, right, bottom: TOP + height };
        let mut labels = Labels::new(metrics, page);

        let scale = Scale::new([low, high], self.downward, height);
        let zero = scale.y(0.0);
        labels.avoid_line(&[[frame.x(0.0), zero], [frame.x(frame.length), zero]]);
        self.grid(&mut canvas, frame, &scale, unit, height);
        self.curve(&mut canvas, frame, &scale, &mut labels);
        self.arrows(&mut canvas, frame, &scale, &mut labels);
        self.extremes(&mut canvas, frame, &scale, &mut labels, unit);
        canvas.reserve(page.bottom);
        canvas
    }

    fn area(&self) -> Fill {
        Fill::new(self.colour).with_opacity(0.14)
    }

    fn line(&self) -> Stroke {
        Stroke::new(self.colour, 1.7)
    }

    fn range(&self) -> [f64; 2] {
        let all = self.values.iter().chain(&self.lower).chain(self.thin.iter().flatten());
        all.fold([0.0, 0.0], |[low, high], &(_, v)| [low.min(v), high.max(v)])
    }

    fn title(&self, canvas: &mut Canvas, frame: &Frame, unit: Unit, metrics: &Metrics) {
        let title = format!("{}{}", self.title, unit.bracketed());
        canvas.text([LEFT, 0.0], Anchor::Start, PANEL_TITLE, &title);
        // The title is semi-bold, so it is slightly wider than measured.
        let x = LEFT + 1.06 * metrics.width(&title, PANEL_TITLE.size) + 12.0;
        let is_empty = self.range() == [0.0, 0.0] && self.forces.is_empty();
        let note = if is_empty { "zero everywhere" } else { self.note };
        // On a narrow page the note is shortened to the available width.
        let first = note.split(';').next().unwrap_or_default();
        let fits = |words: &&str| x + metrics.width(words, NOTE.size) <= frame.width - 4.0;
        let note = [note, first].into_iter().find(fits).unwrap_or_default();
        canvas.text([x, 0.0], Anchor::Start, NOTE, note);
    }

    fn grid(&self, canvas: &mut Canvas, frame: &Frame, scale: &Scale, unit: Unit, height: f64) {
        let [top, bottom] = [TOP, TOP + height];
        let rule = Stroke::new(Colour::Rule, 1.0);
        for &x in self.edges {
            let x = frame.x(x);
            canvas.line([x, top], [x, bottom], rule.dashed(3.0, 3.0));
        }
        for x in [0.0, frame.length] {
            let x = frame.x(x);
            canvas.line([x, top], [x, bottom], rule);
        }
        for value in axis::ticks_in(unit, scale.range, 3) {
            let y = scale.y(value);
            if value != 0.0 {
                let faint = Stroke::new(Colour::FaintRule, 1.0);
                canvas.line([LEFT, y], [frame.right(), y], faint);
            }
            let words = printed(&unit.of_input().number(value));
            canvas.text([LEFT - 8.0, y + 3.7], Anchor::End, TICK, &words);
        }
        let zero = scale.y(0.0);
        canvas.line(
            [frame.x(0.0), zero],
            [frame.x(frame.length), zero],
            Stroke::new(Colour::Ink, 1.0),
        );
    }

    fn curve(&self, canvas: &mut Canvas, frame: &Frame, scale: &Scale, labels: &mut Labels) {
        let [low, high] = scale.range;
        if low == high {
            return;
        }
        if !self.lower.is_empty() {
            return self.band(canvas, frame, scale, labels);
        }
        self.thin(canvas, frame, scale);
        let points = on_page(&self.values, frame, scale);
        let zero = scale.y(0.0);
        // Vertical lines at the ends of the beam connect the curve with the zero line.
        let mut closed = vec![[frame.x(0.0), zero]];
        closed.extend(points);
        closed.push([frame.x(frame.length), zero]);
        let closed = simplified(&closed);
        canvas.polyline(&closed, true, self.area().and(Stroke::NONE));
        canvas.polyline(&closed, false, Fill::NONE.and(self.line()));
        labels.avoid_line(&closed);
    }

    /// Fills the area between the two curves of an envelope, and draws the curve of each single solution as a
    /// thin line.
    fn band(&self, canvas: &mut Canvas, frame: &Frame, scale: &Scale, labels: &mut Labels) {
        let [upper, lower] =
            [&self.values, &self.lower].map(|line| simplified(&on_page(line, frame, scale)));
        let mut area = upper.clone();
        area.extend(lower.iter().rev());
        canvas.polyline(&area, true, self.area());
        self.thin(canvas, frame, scale);
        for line in [upper, lower] {
            canvas.polyline(&line, false, Fill::NONE.and(self.line()));
            labels.avoid_line(&line);
        }
    }

    fn thin(&self, canvas: &mut Canvas, frame: &Frame, scale: &Scale) {
        for line in &self.thin {
            let line = simplified(&on_page(line, frame, scale));
            let stroke = Stroke::new(self.colour, 0.7).with_opacity(0.55);
            canvas.polyline(&line, false, Fill::NONE.and(stroke));
        }
    }

    /// Draws the concentrated forces as arrows. Each arrow is directed upward and ends at the zero line.
    fn arrows(&self, canvas: &mut Canvas, frame: &Frame, scale: &Scale, labels: &mut Labels) {
        let largest = self.forces.iter().fold(0.0_f64, |most, force| most.max(force.1.abs()));
        let zero = scale.y(0.0);
        let room = (TOP + HEIGHT - zero).clamp(24.0, LONGEST_ARROW);
        let mut tails = Vec::new();
        for (x, force, _) in &self.forces {
            let x = frame.x(*x);
            let length = (room * force.abs() / largest).max(14.0);
            arrow(canvas, [x, zero + length], [x, zero + 1.0], Colour::Force, 2.6);
            labels.avoid(Rect::around([x, zero], [x, zero + length], 4.0));
            tails.push([x, zero + 0.5 * length]);
        }
        let mut order: Vec<usize> = (0..tails.len()).collect();
        order.sort_by(|&a, &b| self.forces[b].1.total_cmp(&self.forces[a].1));
        for i in order {
            let words = printed(&self.forces[i].2);
            if let Some(place) = labels.around(tails[i], &words, RIMMED.size) {
                canvas.text([place.x, place.baseline], Anchor::Start, RIMMED, &words);
            }
        }
    }

    fn extremes(
        &self,
        canvas: &mut Canvas,
        frame: &Frame,
        scale: &Scale,
        labels: &mut Labels,
        unit: Unit,
    ) {
        for extreme in self.extremes.iter().filter(|extreme| extreme.value != 0.0) {
            let at = [frame.x(extreme.x), scale.y(extreme.value)];
            let dot = Fill::new(self.colour).and(Stroke::new(Colour::Paper, 1.0));
            let x = self.units.unit(Kind::Position, extreme.x).write(extreme.x);
            let words = printed(&format!("{} at {x}", unit.write(extreme.value)));
            canvas.dot(at, 3.2, dot);
            labels.avoid(Rect::around(at, at, 3.0));
            if let Some(place) = labels.around(at, &words, RIMMED.size) {
                canvas.text([place.x, place.baseline], Anchor::Start, RIMMED, &words);
            }
        }
    }
}

/// Converts a line from beam coordinates to page coordinates.
fn on_page(line: &[(f64, f64)], frame: &Frame, scale: &Scale) -> Vec<[f64; 2]> {
    line.iter().map(|&(x, value)| [frame.x(x), scale.y(value)]).collect()
}

/// Scale from values to heights on the page.
struct Scale {
    range: [f64; 2],
    per_value: f64,
    zero: f64,
}

impl Scale {
    fn new([low, high]: [f64; 2], downward: bool, height: f64) -> Self {
        let top = TOP + 0.5 * (1.0 - FILLED) * height;
        let per_value = if high > low { FILLED * height / (high - low) } else { 0.0 };
        let (per_value, first) = if downward { (per_value, low) } else { (-per_value, high) };
        let zero = if per_value == 0.0 { TOP + 0.5 * height } else { top - per_value * first };
        Scale { range: [low, high], per_value, zero }
    }

    fn y(&self, value: f64) -> f64 {
        self.zero + self.per_value * value
    }
}

/// Draws a straight arrow, up or down, with its head at the second point.
pub(super) fn arrow(
    canvas: &mut Canvas,
    [x, from]: [f64; 2],
    [_, to]: [f64; 2],
    colour: Colour,
    width: f64,
) {
    let up = if to < from { 1.0 } else { -1.0 };
    let size = (2.0 + 2.2 * width).min(0.8 * (from - to).abs());
    let neck = to + up * size;
    canvas.line([x, from], [x, neck], Stroke::new(colour, width));
    let half = 0.42 * size;
    let head = [[x, to], [x - half, neck], [x + half, neck]];
    canvas.polyline(&head, true, Fill::new(colour));
}
