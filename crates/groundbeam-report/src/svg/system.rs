//! Draws the first panel: the deflected beam, the surface of the ground, loads and supports.

use super::axis;
use super::canvas::{Anchor, Canvas, printed};
use super::frame::{Frame, LEFT};
use super::ground::{self, GroundLoads};
use super::labels::{Labels, Rect};
use super::loads::Loads;
use super::paint::{Colour, Fill, Stroke};
use super::samples::{Samples, simplified};
use super::style::{LABEL, NOTE, PANEL_TITLE};
use super::supports;
use crate::font::Metrics;
use crate::number::significant;
use crate::quantity::{Kind, Units};
use groundbeam::{
    Field, Model, Solution, SupportKind,
    model::Acts,
    solution::{Fields, Side},
};

/// Maximum drawn height between the highest and the lowest point of beam and ground.
const DEPTH: f64 = 92.0;
/// Drawn thickness of the beam.
pub(super) const THICKNESS: f64 = 8.0;
/// Height of the ground drawn below the lowest point of its surface.
pub(super) const BELOW: f64 = 40.0;
/// Width of a picture below which labels are shortened.
const PHONE: f64 = 520.0;
/// Maximum number of lift-off zones whose gap is labelled.
const MOST_GAPS: usize = 8;
/// Allowed leading digits of the magnification of deflections.
const LEADS: [f64; 9] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 8.0];

/// Draws the deflected beam on the ground. The beam's unloaded underside is at y = 0.
pub(super) fn draw(
    solution: &Solution,
    units: Units,
    frame: &Frame,
    samples: &Samples,
    metrics: &Metrics,
) -> Canvas {
    let scale = vertical_scale(solution, frame, samples);
    let mut picture = Picture {
        solution,
        units,
        frame,
        samples,
        scale,
        canvas: Canvas::new(),
        labels: Labels::new(
            metrics,
            Rect {
                left: 8.0,
                top: f64::NEG_INFINITY,
                right: frame.width - 4.0,
                bottom: f64::INFINITY,
            },
        ),
        surface: Vec::new(),
        floor: 0.0,
    };
    picture.ground();
    picture.lift_off();
    picture.beam();
    picture.contact();
    picture.supports();
    picture.hinges();
    picture.loads();
    picture.words();
    picture.with_title()
}

/// Page units per unit of deflection, such that deflections are magnified by a round number; 0 without
/// deflections.
pub(super) fn vertical_scale(solution: &Solution, frame: &Frame, samples: &Samples) -> f64 {
    let largest = |field| {
        let range = solution.range(field);
        [range.min, range.max].map(|extreme| samples.sizes.extreme(field, extreme).value)
    };
    let mut range = [0.0_f64, 0.0_f64];
    let surface = samples.all(surface);
    let surface = surface.iter().map(|point| point.1);
    let corners = solution.model().gap.iter().map(|corner| corner.value);
    for value in largest(Field::Deflection).into_iter().chain(surface).chain(corners) {
        range = [range[0].min(value), range[1].max(value)];
    }
    let size = range[1] - range[0];
    if size == 0.0 {
        return 0.0;
    }
    let exaggeration = DEPTH / size / frame.scale();
    axis::round_down_to(exaggeration, &LEADS, false) * frame.scale()
}

/// The y coordinate of the ground's surface on the page, at a position x under the beam or outside the beam.
pub(super) fn level(solution: &Solution, scale: f64, x: f64) -> f64 {
    let length = solution.model().beam.length;
    if (0.0..=length).contains(&x) {
        scale * surface(&solution.at(x, Side::Right))
    } else {
        scale * (solution.settlement(x) + initial_gap_at_end(solution.model(), x > length))
    }
}

/// Drawn thickness of the beam just to the right of the position x.
pub(super) fn thickness(frame: &Frame, x: f64) -> f64 {
    THICKNESS * frame.depth(x, Side::Right)
}

/// Position of the ground's surface, measured downward from the underside of the unloaded beam. It is the sum
/// of the ground displacement u and the initial gap g₀.
fn surface(fields: &Fields) -> f64 {
    fields.deflection + fields.gap
}

/// Initial gap g₀ outside the beam, equal to the initial gap at the end of the beam.
fn initial_gap_at_end(model: &Model, right: bool) -> f64 {
    let corner = if right { model.gap.last() } else { model.gap.first() };
    corner.map_or(0.0, |corner| corner.value)
}

struct Picture<'a> {
    solution: &'a Solution,
    units: Units,
    frame: &'a Frame<'a>,
    samples: &'a Samples,
    scale: f64,
    canvas: Canvas,
    labels: Labels<'a>,
    /// Points of the ground's surface on the page, from left to right.
    surface: Vec<[f64; 2]>,
    /// The y coordinate of the lowest point of the ground's surface on the page.
    floor: f64,
}

impl Picture<'_> {
    fn points(&self, values: &[(f64, f64)]) -> Vec<[f64; 2]> {
        let points: Vec<_> =
            values.iter().map(|&(x, value)| [self.frame.x(x), self.scale * value]).collect();
        simplified(&points)
    }

    fn ground(&mut self) {
        let (model, frame) = (self.solution.model(), self.frame);
        let margins = ground::margins(model, frame);
        let beyond = |t: f64, right: bool| {
            let away = margins[usize::from(right)] * t;
            let x = if right { frame.length + away } else { -away };
            (x, self.solution.settlement(x) + initial_gap_at_end(model, right))
        };
        const STEPS: u32 = 60;
        let mut values: Vec<_> =
            (1..=STEPS).rev().map(|i| beyond(f64::from(i) / f64::from(STEPS), false)).collect();
        // On Winkler ground the surface of the ground has a step at the end of the beam.
        if let (x, value) = beyond(f64::EPSILON, false)
            && x < 0.0
        {
            values.push((0.0, value));
        }
        values.extend(self.samples.all(surface));
        values.push((frame.length, beyond(f64::EPSILON, true).1));
        values.extend((1..=STEPS).map(|i| beyond(f64::from(i) / f64::from(STEPS), true)));

        let line = self.points(&values);
        self.floor = line.iter().fold(0.0_f64, |floor, point| floor.max(point[1]));
        let bottom = self.floor + BELOW;
        let [left, right] = [frame.x(-margins[0]), frame.x(frame.length + margins[1])];
        ground::draw(&mut self.canvas, model, frame, &line, bottom);
        self.labels.avoid_line(&line);
        self.labels.avoid(Rect::around([0.0, bottom], [frame.width, bottom + 1e3], 0.0));
        // A dashed line marks the beam's underside before loading.
        let dashes = Stroke::new(Colour::FaintInk, 0.8).dashed(5.0, 4.0);
        self.canvas.line([left, 0.0], [right, 0.0], dashes);
        self.labels.avoid_line(&[[left, 0.0], [right, 0.0]]);
        self.surface = line;
    }

    fn lift_off(&mut self) {
        for stretch in self.solution.lift_off() {
            let (from, to) = (stretch.from, stretch.to);
            let upper = self.points(&self.samples.between(from, to, |f| f.deflection));
            let mut lower = self.points(&self.samples.between(from, to, surface));
            lower.reverse();
            let area = [upper, lower].concat();
            self.canvas.polyline(&area, true, Fill::new(Colour::Gap));
        }
    }

    fn beam(&mut self) {
        let under = self.points(&self.samples.all(|f| f.deflection));
        let over = match self.frame.has_depths() {
            false => under.iter().rev().map(|&[x, y]| [x, y - THICKNESS]).collect(),
            true => self.upper_side(),
        };
        self.labels.avoid_line(&under);
        self.labels.avoid_line(&over);
        let outline = [under, over].concat();
        self.canvas.polyline(&outline, true, Fill::new(Colour::Beam));
    }

    /// Points of the upper side of a beam with variable depth, from right to left.
    fn upper_side(&self) -> Vec<[f64; 2]> {
        let mut line = Vec::new();
        for (x, deflection) in self.samples.all(|f| f.deflection) {
            line.extend([Side::Left, Side::Right].map(|side| {
                let thickness = THICKNESS * self.frame.depth(x, side);
                [self.frame.x(x), self.scale * deflection - thickness]
            }));
        }
        line.reverse();
        simplified(&line)
    }

    /// Draws a line along each contact zone, and a dot at each point contact.
    fn contact(&mut self) {
        for region in self.solution.contact() {
            let points =
                self.points(&self.samples.between(region.from, region.to, |f| f.deflection));
            if region.from == region.to {
                let at = points.first().copied().unwrap_or([self.frame.x(region.from), 0.0]);
                self.canvas.dot(at, 3.5, Fill::new(Colour::Pressure));
            } else {
                let look = Fill::NONE.and(Stroke::new(Colour::Pressure, 3.0).cut());
                self.canvas.polyline(&points, false, look);
            }
        }
    }

    fn underside(&self, x: f64) -> f64 {
        self.scale * self.solution.at(x, Side::Right).deflection
    }

    fn supports(&mut self) {
        let model = self.solution.model();
        for (support, reaction) in model.supports.iter().zip(self.solution.reactions()) {
            // An inactive support is drawn at its initial position.
            let left = support.is_one_way() && reaction.force == 0.0;
            let y = if left { 0.0 } else { self.underside(support.at) };
            let at = [self.frame.x(support.at), y];
            let outward = match support.at {
                0.0 => -1.0,
                x if x == model.beam.length => 1.0,
                _ => 0.0,
            };
            supports::draw(&mut self.canvas, at, support, outward);
            let [x, y] = at;
            self.labels.avoid(Rect::around([x - 12.0, y], [x + 12.0, y + supports::HEIGHT], 0.0));
            let mut words = match support.acts {
                Acts::Up if left => "lifted".to_owned(),
                Acts::Down if left => "slack".to_owned(),
                _ => self.reaction(support.kind, reaction.force, reaction.moment),
            };
            if support.settlement != 0.0 {
                let by = self.units.write(Kind::Deflection, support.settlement);
                words += &printed(&format!(", settled {by}"));
            }
            let below = [x, y + supports::HEIGHT - 2.0];
            if let Some(place) = self.labels.around(below, &words, LABEL.size) {
                self.canvas.text([place.x, place.baseline], Anchor::Start, LABEL, &words);
            }
        }
    }

    /// Label of a reaction, such as `↑ 120 kN, 5 kN m`.
    fn reaction(&self, kind: SupportKind, force: f64, moment: f64) -> String {
        let force = self.samples.sizes.force(force);
        let moment = self.samples.sizes.moment(moment);
        let sense = if force < 0.0 { "↓" } else { "↑" };
        let mut words = format!("{sense} {}", self.units.write(Kind::Force, force.abs()));
        if kind != SupportKind::Pinned && moment != 0.0 {
            words += &format!(", {}", self.units.write(Kind::Moment, moment));
        }
        printed(&words)
    }

    /// Draws each hinge as a small circle, filled if the hinge has a rotational spring.
    fn hinges(&mut self) {
        for hinge in &self.solution.model().hinges {
            let at = [
                self.frame.x(hinge.at),
                self.underside(hinge.at) - 0.5 * thickness(self.frame, hinge.at),
            ];
            supports::hinge(&mut self.canvas, at, hinge.is_free());
        }
    }

    fn loads(&mut self) {
        let solution = self.solution;
        let (scale, frame) = (self.scale, self.frame);
        let top = |x: f64| scale * solution.at(x, Side::Right).deflection - thickness(frame, x);
        let loads = Loads { units: self.units, frame: self.frame, top: &top };
        loads.draw(&mut self.canvas, &solution.model().loads, &mut self.labels);
        let loads = GroundLoads { units: self.units, frame: self.frame, line: &self.surface };
        loads.draw(&mut self.canvas, &solution.model().loads, &mut self.labels);
    }

    /// Labels the largest deflection and the largest gaps.
    fn words(&mut self) {
        let sizes = self.samples.sizes;
        let deepest = sizes.extreme(Field::Deflection, self.solution.range(Field::Deflection).max);
        if deepest.value > 0.0 {
            let at = [self.frame.x(deepest.x), self.scale * deepest.value];
            let words = self.units.write(Kind::Deflection, deepest.value);
            self.word(at, &format!("{words} deep at {}", self.position(deepest.x)));
        }
        let mut gaps = self.solution.lift_off();
        gaps.sort_by(|a, b| b.largest_gap.value.total_cmp(&a.largest_gap.value));
        for stretch in gaps.iter().take(MOST_GAPS) {
            let gap = sizes.extreme(Field::Gap, stretch.largest_gap);
            if gap.value > 0.0 {
                let fields = self.solution.at(gap.x, Side::Right);
                let at = [self.frame.x(gap.x), self.scale * surface(&fields)];
                let words = self.units.write(Kind::Deflection, gap.value);
                // The label of a free span between two contact zones also states the length of the span.
                let over = match stretch.reaches {
                    [false, false] => format!(" over {}", self.position(stretch.length())),
                    _ => String::new(),
                };
                self.word(at, &format!("gap {words}{over}"));
            }
        }
    }

    /// Writes text in the ground below the point (x, y).
    fn word(&mut self, [x, y]: [f64; 2], words: &str) {
        let words = printed(words);
        if let Some(place) = self.labels.below([x, y + 4.0], &words, LABEL.size) {
            self.canvas.text([place.x, place.baseline], Anchor::Start, LABEL, &words);
        }
    }

    fn position(&self, x: f64) -> String {
        self.units.unit(Kind::Position, x).write(x)
    }

    fn with_title(mut self) -> Canvas {
        let [top, _] = self.canvas.reach();
        let mut notes = Vec::new();
        if self.scale > 0.0 {
            let times = printed(&significant(self.scale / self.frame.scale(), 2));
            // A narrow picture has room for fewer words.
            let as_large = if self.frame.width < PHONE { "" } else { " as large as lengths" };
            notes.push(format!("deflections drawn {times} times{as_large}"));
        }
        let left_out = self.labels.left_out();
        if left_out > 0 {
            let labels = if left_out == 1 { "label" } else { "labels" };
            notes.push(format!("{left_out} {labels} left out for lack of room"));
        }
        let x = LEFT + 1.06 * self.labels.width("Beam and ground", PANEL_TITLE.size) + 12.0;
        let note = notes.join("; ");
        let end = x + self.labels.width(&note, NOTE.size) + 24.0;
        let legend = self.legend();
        let width: f64 = legend.iter().map(|(_, _, words)| self.entry_width(words)).sum();
        // On a narrow page the legend has its own line.
        let has_room = end + width <= self.frame.right() + 18.0;
        let (y, place) = if has_room {
            (top - 16.0, [end, top - 16.0])
        } else {
            (top - 34.0, [LEFT, top - 16.0])
        };
        self.canvas.text([LEFT, y], Anchor::Start, PANEL_TITLE, "Beam and ground");
        self.canvas.text([x, y], Anchor::Start, NOTE, &note);
        let [mut x, y] = place;
        for (colour, height, words) in legend {
            self.canvas.rect([x, y - 4.0 - 0.5 * height], [18.0, height], Fill::new(colour));
            self.canvas.text([x + 23.0, y], Anchor::Start, NOTE, words);
            x += self.entry_width(words);
        }
        self.canvas
    }

    fn entry_width(&self, words: &str) -> f64 {
        23.0 + self.labels.width(words, NOTE.size) + 18.0
    }

    /// Colour, drawn height of the colour sample, and text of each entry of the legend.
    fn legend(&self) -> Vec<(Colour, f64, &'static str)> {
        let contact =
            (!self.solution.contact().is_empty()).then_some((Colour::Pressure, 3.0, "contact"));
        let lift_off =
            (!self.solution.lift_off().is_empty()).then_some((Colour::Gap, 9.0, "lift-off"));
        contact.into_iter().chain(lift_off).collect()
    }
}
