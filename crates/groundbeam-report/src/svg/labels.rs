//! Places labels without overlap.

use crate::font::Metrics;
use std::ops::RangeInclusive;

/// A rectangle on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Rect {
    /// Returns the rectangle with two given opposite corners, enlarged by `margin` on all sides.
    pub fn around([x1, y1]: [f64; 2], [x2, y2]: [f64; 2], margin: f64) -> Self {
        Rect {
            left: x1.min(x2) - margin,
            top: y1.min(y2) - margin,
            right: x1.max(x2) + margin,
            bottom: y1.max(y2) + margin,
        }
    }

    fn overlaps(&self, other: &Rect) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    /// Whether a straight line crosses the rectangle, by clipping (Liang and Barsky).
    fn is_crossed_by(&self, [a, b]: [[f64; 2]; 2]) -> bool {
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        let sides = [
            (-dx, a[0] - self.left),
            (dx, self.right - a[0]),
            (-dy, a[1] - self.top),
            (dy, self.bottom - a[1]),
        ];
        for (speed, room) in sides {
            if speed == 0.0 {
                if room < 0.0 {
                    return false;
                }
            } else if speed < 0.0 {
                enters = enters.max(room / speed);
            } else {
                leaves = leaves.min(room / speed);
            }
        }
        enters <= leaves
    }
}

/// A position for a line of text: the left end of its baseline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub x: f64,
    pub baseline: f64,
}

/// The labels placed so far, and the objects that they must not cover.
pub(super) struct Labels<'m> {
    metrics: &'m Metrics,
    page: Rect,
    solid: Columns<Rect>,
    lines: Columns<[[f64; 2]; 2]>,
    left_out: usize,
}

/// Objects on the page, sorted into vertical strips. A search visits only the objects of a few strips, so
/// labels are placed fast even for thousands of loads.
struct Columns<T> {
    left: f64,
    width: f64,
    /// For each strip, the objects that overlap the strip. Each object is stored with the index of the
    /// leftmost strip that the object overlaps.
    strips: Vec<Vec<(usize, T)>>,
}

impl<T: Copy> Columns<T> {
    const COUNT: usize = 64;

    fn of(page: &Rect) -> Self {
        let width = (page.right - page.left) / Self::COUNT as f64;
        Columns { left: page.left, width, strips: vec![Vec::new(); Self::COUNT] }
    }

    /// Returns the indices of the vertical strips between two horizontal positions on the page. The outermost
    /// strips extend beyond the page.
    fn between(&self, left: f64, right: f64) -> RangeInclusive<usize> {
        let strip = |x: f64| (((x - self.left) / self.width) as usize).min(Self::COUNT - 1);
        strip(left)..=strip(right)
    }

    fn add(&mut self, left: f64, right: f64, thing: T) {
        let strips = self.between(left, right);
        let first = *strips.start();
        self.strips[strips].iter_mut().for_each(|strip| strip.push((first, thing)));
    }

    /// Returns all objects that may lie between two horizontal positions on the page. Each object is returned
    /// once.
    fn near(&self, left: f64, right: f64) -> impl Iterator<Item = &T> {
        let strips = self.between(left, right);
        let start = *strips.start();
        strips.flat_map(move |i| {
            let here = self.strips[i].iter().filter(move |(first, _)| start.max(*first) == i);
            here.map(|(_, thing)| thing)
        })
    }
}

/// Margin around a label.
const MARGIN: f64 = 2.0;

impl<'m> Labels<'m> {
    pub fn new(metrics: &'m Metrics, page: Rect) -> Self {
        let (solid, lines) = (Columns::of(&page), Columns::of(&page));
        Labels { metrics, page, solid, lines, left_out: 0 }
    }

    /// Prevents labels from overlapping this rectangle.
    pub fn avoid(&mut self, solid: Rect) {
        self.solid.add(solid.left, solid.right, solid);
    }

    /// Makes labels avoid this line if another position is free.
    pub fn avoid_line(&mut self, points: &[[f64; 2]]) {
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            self.lines.add(a[0].min(b[0]), a[0].max(b[0]), [a, b]);
        }
    }

    /// Number of labels without a free position.
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// Reserves and returns the best free position for a label around a point; `None` if no position is free.
    pub fn around(&mut self, at: [f64; 2], words: &str, size: f64) -> Option<Place> {
        self.near(at, words, size, true)
    }

    /// Reserves and returns the best free position for a label below or beside a point; `None` if no position is
    /// free.
    pub fn below(&mut self, at: [f64; 2], words: &str, size: f64) -> Option<Place> {
        self.near(at, words, size, false)
    }

    fn near(&mut self, [x, y]: [f64; 2], words: &str, size: f64, above: bool) -> Option<Place> {
        let width = self.metrics.width(words, size);
        let mut candidates = Vec::new();
        for distance in [8.0, 14.0, 22.0, 32.0, 44.0, 58.0, 74.0] {
            let below = y + distance + 0.75 * size;
            for baseline in above.then_some(y - distance).into_iter().chain([below]) {
                for left in [x - 0.5 * width, x + 4.0, x - width - 4.0] {
                    candidates.push(Place { x: left, baseline });
                }
            }
            let level = y + 0.35 * size;
            candidates.push(Place { x: x + distance + 2.0, baseline: level });
            candidates.push(Place { x: x - distance - 2.0 - width, baseline: level });
        }
        self.best(&candidates, width, size)
    }

    /// Reserves and returns the best free position among several candidates; `None` if no candidate is free.
    pub fn at(&mut self, candidates: &[Place], words: &str, size: f64) -> Option<Place> {
        let width = self.metrics.width(words, size);
        self.best(candidates, width, size)
    }

    pub fn width(&self, words: &str, size: f64) -> f64 {
        self.metrics.width(words, size)
    }

    fn best(&mut self, candidates: &[Place], width: f64, size: f64) -> Option<Place> {
        let around = |place: &Place| Rect {
            left: place.x - MARGIN,
            top: place.baseline - 0.78 * size - MARGIN,
            right: place.x + width + MARGIN,
            bottom: place.baseline + 0.22 * size + MARGIN,
        };
        let is_possible = |place: &&Place| {
            let label = around(place);
            let page = &self.page;
            let is_inside = label.left >= page.left
                && label.right <= page.right
                && label.top >= page.top
                && label.bottom <= page.bottom;
            is_inside
                && !self.solid.near(label.left, label.right).any(|solid| label.overlaps(solid))
        };
        // The cost of a candidate is its index in the list, plus 8 for each crossed line. At most four crossed
        // lines are counted.
        let cost = |(i, place): &(usize, &Place)| {
            let label = around(place);
            let lines = self.lines.near(label.left, label.right);
            i + 8 * lines.filter(|line| label.is_crossed_by(**line)).take(4).count()
        };
        let possible = candidates.iter().enumerate().filter(|(_, place)| is_possible(place));
        let best = possible.min_by_key(cost).map(|(_, place)| *place);
        match best {
            Some(place) => self.avoid(around(&place)),
            None => self.left_out += 1,
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_never_overlap() {
        let metrics = Metrics::new();
        let page = Rect { left: 0.0, top: 0.0, right: 300.0, bottom: 100.0 };
        let mut labels = Labels::new(&metrics, page);
        let placed: Vec<_> = (0..40)
            .filter_map(|i| labels.around([150.0 + i as f64, 50.0], "600 kN", 12.0))
            .collect();
        assert!(placed.len() > 5 && labels.left_out() == 40 - placed.len());
        for (i, a) in placed.iter().enumerate() {
            for b in &placed[..i] {
                assert!((a.x - b.x).abs() > 36.0 || (a.baseline - b.baseline).abs() > 12.0);
            }
        }
    }

    #[test]
    fn a_search_between_two_positions_finds_each_object_once() {
        let page = Rect { left: -5.0, top: 0.0, right: 300.0, bottom: 100.0 };
        let mut columns = Columns::of(&page);
        let things: Vec<[f64; 2]> = (0..400)
            .map(|i| f64::from(i * 37 % 401) - 50.0)
            .map(|x| [x, x + x.abs() % 90.0])
            .collect();
        things.iter().enumerate().for_each(|(i, [from, to])| columns.add(*from, *to, i));
        for [left, right] in
            [[-40.0, -20.0], [0.0, 30.0], [12.0, 12.0], [100.0, 290.0], [299.0, 400.0]]
        {
            let mut found: Vec<usize> = columns.near(left, right).copied().collect();
            let count = found.len();
            found.sort_unstable();
            found.dedup();
            assert_eq!(found.len(), count);
            let inside =
                (0..things.len()).filter(|&i| things[i][0] <= right && left <= things[i][1]);
            assert!(inside.into_iter().all(|i| found.contains(&i)));
        }
    }

    #[test]
    fn lines_that_cross_a_rectangle_are_detected() {
        let solid = Rect { left: 0.0, top: 0.0, right: 2.0, bottom: 2.0 };
        assert!(solid.is_crossed_by([[-1.0, 1.0], [3.0, 1.0]]));
        assert!(solid.is_crossed_by([[1.0, -5.0], [1.0, 5.0]]));
        assert!(!solid.is_crossed_by([[-1.0, 2.5], [3.0, 2.5]]));
        assert!(!solid.is_crossed_by([[3.0, 0.0], [5.0, 2.0]]));
    }
}
