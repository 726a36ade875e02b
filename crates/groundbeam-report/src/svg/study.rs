//! Draws the picture of a study: probabilities of events, and histograms of random numbers and results.

use super::axis;
use super::canvas::{Anchor, Canvas, Picture, Style, printed};
use super::frame::{LEFT, WIDTH};
use super::paint::{Colour, Fill, Stroke};
use super::style::{LABEL, NOTE, PANEL_TITLE, TICK};
use super::{header, stacked};
use crate::context::{Context, clean};
use crate::font::Metrics;
use crate::number::significant;
use crate::quantity::{Unit, Units};
use crate::study::{Estimate, Limit, Spread, Study};

/// Right end of the panels.
const RIGHT: f64 = WIDTH - 24.0;
/// Number of panels per row.
const COLUMNS: usize = 3;
/// Horizontal distance between two panels.
const BETWEEN: f64 = 28.0;
/// Height of the bars.
const BARS: f64 = 84.0;
/// Distance between the title of a panel and its bars.
const TOP: f64 = 24.0;
/// Vertical distance between the rows of two events.
const ROW: f64 = 24.0;
/// Coordinates of the left and right ends of the probability scale.
const SCALE: [f64; 2] = [LEFT + 270.0, RIGHT - 200.0];

/// Draws the probabilities of events with their confidence intervals, and histograms of random numbers and
/// results.
pub fn study(study: &Study, context: &Context) -> Picture {
    let metrics = Metrics::new();
    let mut page = Canvas::new();
    let title = study.title.as_deref().map(clean).filter(|title| !title.is_empty());
    let mut words = format!("{} samples, {}, seed {}", study.samples, study.sampling, study.seed);
    words += &format!("; {} solved and certified", study.solved);
    let key = "Bars: samples. Dot: median; thick line: from 5 % to 95 %. Orange: beyond a limit.";
    let mut y = header(&mut page, title.as_deref(), &[&words, key]);
    y = stacked(&mut page, events(study, &metrics), y);
    for row in study.spreads.chunks(COLUMNS) {
        let mut panels = Canvas::new();
        for (i, spread) in row.iter().enumerate() {
            let limits = study.events.iter().filter_map(|event| event.limit.as_ref());
            let limits: Vec<&Limit> =
                limits.filter(|limit| limit.quantity == spread.name).collect();
            Panel::new(i, spread, &limits, context.units).draw(&mut panels, &metrics);
        }
        y = stacked(&mut page, panels, y);
    }
    page.finish(WIDTH, y, title.as_deref().unwrap_or("A study"))
}

/// Draws one row for each event, with its probability and the confidence interval on a logarithmic scale.
fn events(study: &Study, metrics: &Metrics) -> Canvas {
    let mut canvas = Canvas::new();
    canvas.text([LEFT, 0.0], Anchor::Start, PANEL_TITLE, "How probable events are");
    let positive = study
        .events
        .iter()
        .flat_map(|e| [e.probability, e.interval.bounds[0], e.interval.bounds[1]]);
    let least = positive.filter(|p| *p > 0.0).fold(0.1, f64::min).log10().floor().max(-12.0);
    let [left, right] = SCALE;
    let x = |p: f64| {
        if p > 0.0 { (right + (right - left) * p.log10() / -least).max(left) } else { left }
    };
    let bottom = 10.0 + ROW * study.events.len() as f64;
    let decades = (least as i32)..=0;
    let every = 1 + decades.clone().count() / 7;
    for power in decades.rev().step_by(every) {
        let at = x(10.0_f64.powi(power));
        canvas.line([at, 10.0], [at, bottom], Stroke::new(Colour::Rule, 1.0));
        canvas.text([at, bottom + 15.0], Anchor::Middle, TICK, &percent(10.0_f64.powi(power), 1));
    }
    for (i, event) in study.events.iter().enumerate() {
        let y = 10.0 + ROW * (i as f64 + 0.5);
        let Estimate { probability, interval, .. } = event;
        let name = fitting(&clean(&event.name), left - LEFT - 14.0, LABEL, metrics);
        canvas.text([LEFT, y + 4.0], Anchor::Start, LABEL, &name);
        let stroke = |width: f64| Stroke::new(Colour::Load, width);
        let [low, high] = interval.bounds.map(x);
        canvas.line([low, y], [high, y], stroke(2.0));
        for (end, bound) in [(low, interval.bounds[0]), (high, interval.bounds[1])] {
            if bound > 0.0 {
                canvas.line([end, y - 4.0], [end, y + 4.0], stroke(1.4));
            }
        }
        if *probability > 0.0 {
            let dot = Fill::new(Colour::Load).and(Stroke::new(Colour::Paper, 1.0));
            canvas.dot([x(*probability), y], 3.6, dot);
        }
        // Probabilities with more than four digits do not fit beside the scale.
        let digits = interval.digits().min(4);
        let [low, high] = interval.bounds.map(|bound| significant(100.0 * bound, digits));
        let words = format!("{} ({low} to {high})", percent(*probability, digits));
        canvas.text([right + 12.0, y + 4.0], Anchor::Start, LABEL, &words);
    }
    canvas.reserve(bottom + 20.0);
    canvas
}

/// Histogram of one quantity, with its position on the page.
struct Panel<'a> {
    spread: &'a Spread,
    limits: &'a [&'a Limit],
    unit: Unit,
    left: f64,
    width: f64,
    /// Range of values on the horizontal axis.
    range: [f64; 2],
}

impl<'a> Panel<'a> {
    fn new(column: usize, spread: &'a Spread, limits: &'a [&'a Limit], units: Units) -> Self {
        let width = (RIGHT - LEFT - (COLUMNS - 1) as f64 * BETWEEN) / COLUMNS as f64;
        let left = LEFT + column as f64 * (width + BETWEEN);
        let [least, .., most] = spread.quantiles;
        let size = most - least;
        // A limit is shown if its distance from the samples is less than the range of the samples.
        let near = limits.iter().map(|limit| limit.limit);
        let near = near.filter(|limit| *limit > least - size && *limit < most + size);
        let [mut from, mut to] =
            near.fold([least, most], |[a, b], limit| [a.min(limit), b.max(limit)]);
        if from == to {
            let margin = if from == 0.0 { 1.0 } else { 0.5 * from.abs() };
            (from, to) = (from - margin, to + margin);
        }
        let beside = 0.03 * (to - from);
        let unit = match spread.kind {
            Some(kind) => units.unit(kind, spread.largest()),
            None => units.plain(""),
        };
        Panel { spread, limits, unit, left, width, range: [from - beside, to + beside] }
    }

    fn x(&self, value: f64) -> f64 {
        self.left + self.width * (value - self.range[0]) / (self.range[1] - self.range[0])
    }

    fn draw(&self, canvas: &mut Canvas, metrics: &Metrics) {
        let title = self.spread.label() + &self.unit.bracketed();
        let title = fitting(&title, 0.94 * self.width, PANEL_TITLE, metrics);
        canvas.text([self.left, 0.0], Anchor::Start, PANEL_TITLE, &title);
        let zero = TOP + BARS;
        self.bars(canvas, zero);
        let axis = Stroke::new(Colour::FaintInk, 1.0);
        let end = self.left + self.width;
        canvas.line([self.left, zero], [end, zero], axis);
        let shown = [0, 1].map(|i| self.range[i] / self.unit.size);
        let mut free = self.left - 20.0;
        for value in axis::ticks(shown, 3) {
            let at = self.x(value * self.unit.size);
            let words = printed(&significant(value, 6));
            let half = 0.5 * metrics.width(&words, TICK.size);
            canvas.line([at, zero], [at, zero + 4.0], axis);
            if at - half > free {
                canvas.text([at, zero + 19.0], Anchor::Middle, TICK, &words);
                free = at + half + 8.0;
            }
        }
        let [_, low, middle, high, _] = self.spread.quantiles.map(|value| self.x(value));
        canvas.line([low, zero], [high, zero], Stroke::new(Colour::Ink, 3.5));
        let dot = Fill::new(Colour::Ink).and(Stroke::new(Colour::Paper, 1.2));
        canvas.dot([middle, zero], 3.8, dot);
        self.limits(canvas, zero, metrics);
        canvas.reserve(zero + 24.0);
    }

    /// Draws the bars. The parts of bars beyond a limit have the colour of the limit.
    fn bars(&self, canvas: &mut Canvas, zero: f64) {
        let counts = &self.spread.histogram;
        let [least, .., most] = self.spread.quantiles;
        let highest = counts.iter().copied().max().unwrap_or(1).max(1) as f64;
        let part = (most - least) / counts.len() as f64;
        for (i, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            let height = (BARS * count as f64 / highest).max(0.7);
            let bar = [0, 1].map(|side| least + (i + side) as f64 * part);
            let bar = if part > 0.0 {
                bar
            } else {
                let half = 0.02 * (self.range[1] - self.range[0]);
                [least - half, least + half]
            };
            for ([from, to], colour) in self.pieces(bar) {
                let (left, right) = (self.x(from), self.x(to));
                let fill = Fill::new(colour).with_opacity(0.75);
                let width = (right - left - if to == bar[1] { 0.8 } else { 0.0 }).max(0.3);
                canvas.rect([left, zero - height], [width, height], fill);
            }
        }
    }

    /// Divides a bar at the limits. Returns the range and the colour of each part.
    fn pieces(&self, [from, to]: [f64; 2]) -> Vec<([f64; 2], Colour)> {
        let mut cuts: Vec<f64> = self.limits.iter().map(|limit| limit.limit).collect();
        cuts.retain(|cut| from < *cut && *cut < to);
        cuts.extend([from, to]);
        cuts.sort_by(f64::total_cmp);
        let colour = |middle: f64| {
            let beyond = |limit: &&Limit| {
                if limit.above { middle > limit.limit } else { middle < limit.limit }
            };
            if self.limits.iter().any(beyond) { Colour::Load } else { Colour::Pressure }
        };
        cuts.windows(2)
            .map(|pair| ([pair[0], pair[1]], colour(0.5 * (pair[0] + pair[1]))))
            .collect()
    }

    fn limits(&self, canvas: &mut Canvas, zero: f64, metrics: &Metrics) {
        let [from, to] = self.range;
        for limit in self.limits.iter().filter(|limit| from < limit.limit && limit.limit < to) {
            let x = self.x(limit.limit);
            let dashes = Stroke::new(Colour::Load, 1.4).dashed(4.0, 3.0);
            canvas.line([x, TOP - 6.0], [x, zero], dashes);
            let side = if limit.above { ">" } else { "<" };
            let words = printed(&format!("{side} {}", self.unit.write(limit.limit)));
            let half = 0.5 * metrics.width(&words, NOTE.size);
            let middle = x.clamp(self.left + half, self.left + self.width - half);
            let style = Style { colour: Colour::Load, ..NOTE };
            canvas.text([middle, TOP - 9.0], Anchor::Middle, style, &words);
        }
    }
}

/// The text, shortened and ended by `…` if it is wider than `room`.
fn fitting(words: &str, room: f64, style: Style, metrics: &Metrics) -> String {
    if metrics.width(words, style.size) <= room {
        return words.to_owned();
    }
    let mut shortened: String = words.to_owned();
    while !shortened.is_empty() && metrics.width(&shortened, style.size) + style.size > room {
        shortened.pop();
    }
    shortened.trim_end().to_owned() + "…"
}

fn percent(part: f64, digits: usize) -> String {
    format!("{} %", significant(100.0 * part, digits))
}
