//! Draws the ground outside the beam: trenches, walls, segments, and loads on its surface.

use super::canvas::Style;
use super::canvas::{Anchor, Canvas, printed};
use super::diagram::arrow;
use super::frame::Frame;
use super::labels::{Labels, Place, Rect};
use super::paint::{Colour, Fill, Stroke};
use super::style::{DISTRIBUTED, LABEL, NOTE};
use crate::quantity::{Kind, Units};
use groundbeam::{
    Load, Model,
    model::{Extent, FoundationSegment, GroundEnd, Profile},
};

/// Drawn height of the largest point force on the ground.
const FORCE: f64 = 34.0;
/// Drawn height of the largest distributed load on the ground.
const SPREAD: f64 = 18.0;
/// Drawn height of a wall above the ground.
const WALL: f64 = 30.0;

/// Widths of the drawn ground beyond the left and the right end of the beam. A width is smaller if the ground
/// ends within the picture.
pub(super) fn margins(model: &Model, frame: &Frame) -> [f64; 2] {
    [false, true].map(|right| {
        let end = model.foundation.ends[usize::from(right)].at();
        let outward = |x: f64| if right { x - frame.length } else { -x };
        end.map_or(frame.margin, |at| outward(at).clamp(0.0, frame.margin))
    })
}

/// Draws the ground below its surface `line` (on the page, from left to right), and its ends. Outside the beam,
/// segments are darker if they are stiffer than under the adjacent end of the beam, and paler if they are softer.
pub(super) fn draw(
    canvas: &mut Canvas,
    model: &Model,
    frame: &Frame,
    line: &[[f64; 2]],
    bottom: f64,
) {
    canvas.polyline(&below(line, bottom), true, Fill::new(Colour::Ground));
    for segment in &model.foundation.segments {
        let sides =
            [(segment.from, segment.to.min(0.0)), (segment.from.max(frame.length), segment.to)];
        for ((from, to), right) in sides.into_iter().zip([false, true]) {
            let part = between(line, frame.x(from), frame.x(to));
            let tint = match is_stiffer(segment, model, right) {
                Some(true) => Fill::new(Colour::GroundLine).with_opacity(0.28),
                Some(false) => Fill::new(Colour::Paper).with_opacity(0.5),
                None => continue,
            };
            if from < to && !part.is_empty() {
                canvas.polyline(&below(&part, bottom), true, tint);
            }
        }
    }
    let edge = Stroke::new(Colour::GroundLine, 1.4);
    canvas.polyline(line, false, Fill::NONE.and(edge));
    let corners = [line.first(), line.last()];
    for (corner, end) in corners.into_iter().zip(model.foundation.ends) {
        // An end of the ground outside the picture is not drawn.
        let is_here = |corner: &[f64; 2]| {
            end.at().is_some_and(|at| (frame.x(at) - corner[0]).abs() < 1e-6 * frame.width)
        };
        let Some(&[x, y]) = corner.filter(|corner| is_here(corner)) else { continue };
        match end {
            GroundEnd::Endless => {}
            GroundEnd::Free { .. } => canvas.line([x, y], [x, bottom], edge),
            GroundEnd::Held { .. } => {
                canvas.line([x, y - WALL], [x, bottom], Stroke::new(Colour::Beam, 3.0));
            }
        }
    }
}

/// Whether a segment is stiffer than the ground under an end of the beam; `None` if the stiffnesses are
/// equal.
fn is_stiffer(segment: &FoundationSegment, model: &Model, right: bool) -> Option<bool> {
    let middle = |profile: &Profile| 0.5 * (profile.start() + profile.end());
    let end = if right { model.beam.length * (1.0 - f64::EPSILON) } else { 0.0 };
    let (spring, shear) = model.foundation.constants_at(end);
    let own = [middle(&segment.subgrade), middle(&segment.shear_layer)];
    let apart = own.into_iter().zip([spring, shear]).find(|(own, end)| own != end);
    apart.map(|(own, end)| own > end)
}

/// Writes the constants k and μ of segments outside the beam into the drawn segments, if there is room.
pub(super) fn constants(
    canvas: &mut Canvas,
    model: &Model,
    units: Units,
    frame: &Frame,
    labels: &mut Labels,
    bottom: f64,
) {
    let [left, right] = margins(model, frame);
    for segment in &model.foundation.segments {
        let is_beside = segment.to <= 0.0 || segment.from >= frame.length;
        let clip = |x: f64| frame.x(x.clamp(-left, frame.length + right));
        let (from, to) = (clip(segment.from), clip(segment.to));
        let (spring, shear) = (&segment.subgrade, &segment.shear_layer);
        if !is_beside || to <= from || !(spring.is_constant() && shear.is_constant()) {
            continue;
        }
        let lines = [
            format!("k = {}", units.write(Kind::Spring, spring.start())),
            format!("μ = {}", units.write(Kind::Constant, shear.start())),
        ];
        for (words, up) in lines.map(|words| printed(&words)).iter().zip([20.0, 6.0]) {
            let width = labels.width(words, NOTE.size);
            if width + 6.0 < to - from {
                let x = 0.5 * (from + to) - 0.5 * width;
                canvas.text([x, bottom - up], Anchor::Start, NOTE, words);
                let top = [x, bottom - up - NOTE.size];
                labels.avoid(Rect::around(top, [x + width, bottom - up], 0.0));
            }
        }
    }
}

/// Returns the outline of the area between a polyline and the bottom of the ground.
fn below(line: &[[f64; 2]], bottom: f64) -> Vec<[f64; 2]> {
    let ends = [line.first(), line.last()].map(|point| point.map_or(0.0, |p| p[0]));
    let mut area = vec![[ends[0], bottom]];
    area.extend(line);
    area.push([ends[1], bottom]);
    area
}

/// The part of a polyline between the horizontal page coordinates `from` and `to`.
fn between(line: &[[f64; 2]], from: f64, to: f64) -> Vec<[f64; 2]> {
    let inside = line.iter().copied().filter(|p| from < p[0] && p[0] < to);
    let ends = [line.first(), line.last()].map(|point| point.map_or(0.0, |p| p[0]));
    let (from, to) = (from.max(ends[0]), to.min(ends[1]));
    if to <= from {
        return Vec::new();
    }
    let mut part = vec![[from, height(line, from)]];
    part.extend(inside);
    part.push([to, height(line, to)]);
    part
}

/// Interpolates the vertical page coordinate of a polyline at a horizontal page coordinate.
pub(super) fn height(line: &[[f64; 2]], x: f64) -> f64 {
    let ends = [line.first(), line.last()].map(|point| point.map_or(0.0, |p| p[1]));
    let next = line.partition_point(|point| point[0] < x);
    match (next.checked_sub(1).map(|i| line[i]), line.get(next)) {
        (Some([x1, y1]), Some([x2, y2])) => y1 + (y2 - y1) * (x - x1) / (x2 - x1),
        (None, _) => ends[0],
        (_, None) => ends[1],
    }
}

/// The label of a load.
struct Word {
    /// Point on the page beside which the label is placed. For a load outside the drawn ground, the first number is its
    /// position in the model.
    at: [f64; 2],
    words: String,
    /// Whether the load lies within the drawn ground.
    is_here: bool,
}

/// Draws loads on the ground. Outside the beam, arrows point down to the ground's surface. Under the beam,
/// they start at this surface and point down.
pub(super) struct GroundLoads<'a> {
    pub units: Units,
    pub frame: &'a Frame<'a>,
    /// The ground's surface on the page, from left to right.
    pub line: &'a [[f64; 2]],
}

impl GroundLoads<'_> {
    pub fn draw(&self, canvas: &mut Canvas, loads: &[Load], labels: &mut Labels) {
        let loads: Vec<&Load> = loads.iter().filter(|load| load.is_on_ground()).collect();
        let largest = |distributed: bool| {
            let same = loads.iter().filter(|load| load.extent().is_distributed() == distributed);
            same.map(|load| load.extent().largest()).fold(0.0, f64::max)
        };
        let [force, intensity] = [false, true].map(largest);
        let mut words = Vec::new();
        for load in &loads {
            words.push(match load.extent() {
                Extent::Point { at, size } if size != 0.0 => {
                    self.force(canvas, at, size, size.abs() / force, labels)
                }
                Extent::Distributed { from, to, start, end } if intensity > 0.0 => {
                    self.area(canvas, [from, to], [start, end], intensity, labels)
                }
                _ => continue,
            });
        }
        // All arrows are drawn before the first label is placed, so that labels avoid all arrows.
        for Word { at, words, is_here } in words {
            match is_here {
                true => self.beside(canvas, at, &words, labels),
                false => self.at_the_edge(canvas, at[0], &words, labels),
            }
        }
    }

    /// Page coordinates of the left and the right end of the drawn ground.
    fn ends(&self) -> [f64; 2] {
        [self.line.first(), self.line.last()].map(|point| point.map_or(0.0, |p| p[0]))
    }

    fn is_beside(&self, x: f64) -> bool {
        x < 0.0 || x > self.frame.length
    }

    fn force(
        &self,
        canvas: &mut Canvas,
        at: f64,
        value: f64,
        share: f64,
        labels: &mut Labels,
    ) -> Word {
        let words = printed(&self.units.write(Kind::Force, value));
        let x = self.frame.x(at);
        let [left, right] = self.ends();
        if x < left - 1e-6 || x > right + 1e-6 {
            return Word { at: [at, 0.0], words, is_here: false };
        }
        let surface = height(self.line, x);
        let length = 14.0 + (FORCE - 14.0) * share;
        let (tail, tip) = if self.is_beside(at) {
            (surface - length, surface - 1.0)
        } else {
            (surface + 1.0, surface + length)
        };
        arrow(canvas, [x, tail], [x, tip], Colour::Load, 2.0);
        labels.avoid(Rect::around([x, tail], [x, tip], 3.0));
        let end = if self.is_beside(at) { tail } else { tip };
        Word { at: [x, end], words, is_here: true }
    }

    /// Draws a distributed load, divided at the ends of the beam, and returns its label.
    fn area(
        &self,
        canvas: &mut Canvas,
        [from, to]: [f64; 2],
        [start, end]: [f64; 2],
        largest: f64,
        labels: &mut Labels,
    ) -> Word {
        let unit = self.units.unit(Kind::Pressure, start.abs().max(end.abs()));
        let words = printed(&match start == end {
            true => unit.write(start),
            false => format!("{} … {}", unit.number(start), unit.write(end)),
        });
        let [left, right] = self.ends();
        if self.frame.x(to) < left || self.frame.x(from) > right {
            return Word { at: [0.5 * (from + to), 0.0], words, is_here: false };
        }
        let mut cuts = vec![from, to];
        cuts.extend([0.0, self.frame.length].into_iter().filter(|x| from < *x && *x < to));
        cuts.sort_by(f64::total_cmp);
        let share = |x: f64| (start + (end - start) * (x - from) / (to - from)) / largest;
        for pair in cuts.windows(2) {
            let upward = if self.is_beside(0.5 * (pair[0] + pair[1])) { -1.0 } else { 1.0 };
            let edge = |x: f64| {
                let page = self.frame.x(x).clamp(left, right);
                [page, height(self.line, page)]
            };
            let part = between(self.line, edge(pair[0])[0], edge(pair[1])[0]);
            let across = |page: f64| {
                let x = pair[0] + (page - self.frame.x(pair[0])) / self.frame.scale();
                upward * SPREAD * share(x).abs()
            };
            let far: Vec<[f64; 2]> = part.iter().rev().map(|&[x, y]| [x, y + across(x)]).collect();
            let width = edge(pair[1])[0] - edge(pair[0])[0];
            canvas.polyline(&[part.clone(), far].concat(), true, DISTRIBUTED);
            let arrows = (width / 14.0).floor().clamp(1.0, 60.0) as usize;
            for i in 0..=arrows {
                let x = edge(pair[0])[0] + width * i as f64 / arrows as f64;
                let y = height(self.line, x);
                let reach = across(x);
                if reach.abs() > 6.0 {
                    arrow(canvas, [x, y.min(y + reach)], [x, y.max(y + reach)], Colour::Load, 0.9);
                }
            }
            let level = part.iter().map(|p| p[1] + across(p[0]));
            let level =
                level.fold(part[0][1], |far, y| if upward < 0.0 { far.min(y) } else { far.max(y) });
            let [first, last] = [part[0], part[part.len() - 1]];
            labels.avoid(Rect::around([first[0], first[1]], [last[0], level], 1.0));
        }
        let widest = cuts.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        let middle = widest.map_or(from, |pair| 0.5 * (pair[0] + pair[1]));
        let x = self.frame.x(middle).clamp(left, right);
        let away = if self.is_beside(middle) { -SPREAD } else { SPREAD };
        let at = [x, height(self.line, x) + away * share(middle).abs()];
        Word { at, words, is_here: true }
    }

    fn beside(&self, canvas: &mut Canvas, at: [f64; 2], words: &str, labels: &mut Labels) {
        if let Some(place) = labels.around(at, words, LABEL.size) {
            let style = Style { colour: Colour::Load, ..LABEL };
            canvas.text([place.x, place.baseline], Anchor::Start, style, words);
        }
    }

    /// Draws a label at the left or right edge of the picture for a load that lies beyond this edge.
    fn at_the_edge(&self, canvas: &mut Canvas, at: f64, words: &str, labels: &mut Labels) {
        let unit = self.units.unit(Kind::Position, at);
        let words = printed(&match at < 0.0 {
            true => format!("← {words} at {}", unit.write(at)),
            false => format!("{words} at {} →", unit.write(at)),
        });
        let [left, right] = self.ends();
        let width = labels.width(&words, LABEL.size);
        let x = if at < 0.0 { left } else { right - width };
        let surface = if at < 0.0 { left } else { right };
        let level = height(self.line, surface);
        let places = [8.0, 22.0, 36.0].map(|rise| Place { x, baseline: level - rise });
        if let Some(place) = labels.at(&places, &words, LABEL.size) {
            let style = Style { colour: Colour::Load, ..LABEL };
            canvas.text([place.x, place.baseline], Anchor::Start, style, &words);
        }
    }
}

/// Largest distance \[m\] between the beam and an object on the ground outside the beam. Objects that
/// are farther away than `within` are ignored.
pub(super) fn farthest(model: &Model, within: f64) -> f64 {
    let l = model.beam.length;
    let away = |x: f64| (-x).max(x - l);
    let ends = model.foundation.ends.into_iter().filter_map(GroundEnd::at);
    let stretches = model.foundation.segments.iter().flat_map(|s| [s.from, s.to]);
    let loads = model.ground_loads().flat_map(|load| load.extent().ends());
    let all = ends.chain(stretches).chain(loads).map(away);
    all.filter(|away| *away <= within).fold(0.0, f64::max)
}
