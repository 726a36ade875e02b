//! The beam between two nodes, off the ground: any number of pieces as one element.

use super::grid::{Grid, mirrored};
use crate::elements::Element;
use crate::elements::exact::{ExactElement, TERMS};

/// A piece of the beam, and how all up to its left end follows from all up to its right end.
#[derive(Debug, Clone, Copy)]
struct Piece {
    exact: ExactElement,
    /// Elements of the grid.
    count: usize,
    /// d of everything before this piece = gain·(θ, D₁, D₂) + constant, with D that of everything up to
    /// its end.
    gain: [[f64; 3]; 2],
    constant: [f64; 2],
}

/// The beam from one node to another, in the direction of its sweep.
#[derive(Debug, Clone, Default)]
pub(super) struct Span {
    pub from: usize,
    pub to: usize,
    mirrored: bool,
    pieces: Vec<Piece>,
    /// All of it.
    pub element: Element,
}

impl Span {
    /// Makes it the beam between two nodes, seen in a mirror for the sweep from the right.
    pub fn set(&mut self, grid: &Grid, from: usize, to: usize, as_mirrored: bool) {
        (self.from, self.to, self.mirrored) = (from, to, as_mirrored);
        self.pieces.clear();
        self.element = Element::default();
        if as_mirrored {
            let first = grid.run_at(from);
            let last = grid.run_at(to - 1);
            for run in (first..=last).rev() {
                let (a, b) = (grid.runs[run].first.max(from), grid.runs[run].end().min(to));
                self.add_run(grid, run, a, b);
            }
        } else {
            for (run, a, b) in grid.parts(from, to) {
                self.add_run(grid, run, a, b);
            }
        }
    }

    /// A part of a run, cut into pieces that a short series describes.
    fn add_run(&mut self, grid: &Grid, run: usize, from: usize, to: usize) {
        let run_cells = &grid.runs[run];
        let count = to - from;
        let wanted = grid.pieces(&run_cells.part(from, to)).min(count);
        for i in 0..wanted {
            let at = |i: usize| count * i / wanted;
            let (a, b) = if self.mirrored {
                (to - at(i + 1), to - at(i))
            } else {
                (from + at(i), from + at(i + 1))
            };
            let mut cell = run_cells.part(a, b);
            if self.mirrored {
                cell = mirrored(&cell);
            }
            let exact = grid.beam(&cell, run_cells.h * (b - a) as f64);
            // What stands at the node before it, if that is within the span.
            let (node, place) = if self.mirrored {
                (b, (run_cells.end() == b).then_some(run + 1))
            } else {
                (a, (run_cells.first == a).then_some(run))
            };
            let inner = node != if self.mirrored { self.to } else { self.from };
            let load = place.filter(|_| inner).map_or([0.0; 2], |place| {
                let node = &grid.nodes[place];
                [node.force, if self.mirrored { -node.moment } else { node.moment }]
            });
            self.add(exact, b - a, load);
        }
    }

    /// Adds a piece at the end, with a force and a moment at the node before it.
    fn add(&mut self, exact: ExactElement, count: usize, load: [f64; 2]) {
        let next = exact.element;
        if self.pieces.is_empty() {
            self.element = next;
            let nothing = Piece { exact, count, gain: [[0.0; 3]; 2], constant: [0.0; 2] };
            self.pieces.push(nothing);
            return;
        }
        let before = self.element;
        let (h, l) = (before.length, next.length);
        // Unknowns (θ, D₁, D₂ | d₁, d₂). The element before has (θ, d₁, d₂), the next one (θ + d₂,
        // D₁ − d₁ − l d₂, D₂ − d₂).
        let first = [[1.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0]];
        let second =
            [[1.0, 0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, -1.0, -l], [0.0, 0.0, 1.0, 0.0, -1.0]];
        let mut k = [[0.0; 5]; 5];
        let mut q = [0.0; 5];
        for (element, rows) in [(&before, &first), (&next, &second)] {
            for (i, row) in rows.iter().enumerate() {
                for a in 0..5 {
                    q[a] += row[a] * element.load[i + 1];
                    for (j, other) in rows.iter().enumerate() {
                        for b in 0..5 {
                            k[a][b] += row[a] * element.stiffness[i + 1][j + 1] * other[b];
                        }
                    }
                }
            }
        }
        // The next one's w_left = w + hθ + d₁, and the loads at the node between.
        let through = next.load[0] + load[0];
        q[0] += h * through + load[1];
        q[3] += through;
        q[4] += load[1];
        let [a, b, c] = [k[3][3], k[3][4], k[4][4]];
        let determinant = a * c - b * b;
        let solve = |x: f64, y: f64| [(c * x - b * y) / determinant, (a * y - b * x) / determinant];
        let columns = [0, 1, 2].map(|j| solve(-k[3][j], -k[4][j]));
        let constant = solve(q[3], q[4]);
        let mut whole = Element { length: h + l, ..Element::default() };
        whole.load[0] = before.load[0] + through;
        for i in 0..3 {
            whole.load[i + 1] = q[i] - k[i][3] * constant[0] - k[i][4] * constant[1];
            for j in 0..3 {
                whole.stiffness[i + 1][j + 1] =
                    k[i][j] + k[i][3] * columns[j][0] + k[i][4] * columns[j][1];
            }
        }
        self.element = whole;
        let gain = [0, 1].map(|i| columns.map(|column| column[i]));
        self.pieces.push(Piece { exact, count, gain, constant });
    }

    /// The series of each piece, from the last to the first, for w and θ at the span's beginning and its
    /// deformation: the nodes they reach from and to in the grid, and the coefficients from left to right.
    pub fn unfold(&self, v: &[f64; 4], mut each: impl FnMut(usize, usize, &[f64; TERMS])) {
        let [w, theta, mut d1, mut d2] = *v;
        let mut length = self.element.length;
        let mut passed = 0;
        for (i, piece) in self.pieces.iter().enumerate().rev() {
            let l = piece.exact.element.length;
            length -= l;
            let own = if i == 0 {
                [w, theta, d1, d2]
            } else {
                let before: [f64; 2] = std::array::from_fn(|r| {
                    let [g0, g1, g2] = piece.gain[r];
                    g0 * theta + g1 * d1 + g2 * d2 + piece.constant[r]
                });
                let own =
                    [w + length * theta + before[0], theta + before[1], d1 - before[0] - l * before[1], d2 - before[1]];
                [d1, d2] = before;
                own
            };
            let (mut series, _) = piece.exact.unfold(&own);
            if self.mirrored {
                series.iter_mut().skip(1).step_by(2).for_each(|c| *c = -*c);
            }
            let (from, to) = if self.mirrored {
                (self.from + passed, self.from + passed + piece.count)
            } else {
                (self.to - passed - piece.count, self.to - passed)
            };
            passed += piece.count;
            each(from, to, &series);
        }
    }
}
