//! The beam between two nodes that touch: any number of pieces off the ground as one element.

use super::beam::{Beam, TERMS};
use super::grid::{Grid, mirrored};

/// An element in (w, θ, d₁, d₂): K of the last three and q of all.
#[derive(Debug, Clone, Copy, Default)]
struct Whole {
    length: f64,
    stiffness: [[f64; 3]; 3],
    load: [f64; 4],
}

/// A piece of the beam, and how all up to its left end follows from all up to its right end.
#[derive(Debug, Clone, Copy)]
struct Piece {
    beam: Beam,
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
    pub mirrored: bool,
    pieces: Vec<Piece>,
    whole: Whole,
}

impl Span {
    /// Makes it the beam between two nodes; in a mirror for the sweep from the right.
    pub fn set(&mut self, grid: &Grid, from: usize, to: usize, mirrored: bool) {
        (self.from, self.to, self.mirrored) = (from, to, mirrored);
        self.pieces.clear();
        let (first, last) = (grid.run_at(from), grid.run_at(to - 1));
        for i in first..=last {
            let run = if mirrored { last - (i - first) } else { i };
            let (a, b) = (grid.runs[run].first.max(from), grid.runs[run].end().min(to));
            self.add_run(grid, run, a, b);
        }
    }

    /// A part of a run, cut into pieces that a short series describes.
    fn add_run(&mut self, grid: &Grid, run: usize, from: usize, to: usize) {
        let own = &grid.runs[run];
        let count = to - from;
        let wanted = grid.pieces(&own.cell, own.h * count as f64).min(count);
        let at = |i: usize| count * i / wanted;
        for i in 0..wanted {
            let (a, b) = if self.mirrored {
                (to - at(i + 1), to - at(i))
            } else {
                (from + at(i), from + at(i + 1))
            };
            let part = own.part(a, b);
            let cell = if self.mirrored { mirrored(&part) } else { part };
            let beam = Beam::new(&cell, grid.axial_force, own.h * (b - a) as f64);
            let load = grid.load(if self.mirrored { b } else { a }, self.mirrored);
            self.add(beam, b - a, load);
        }
    }

    /// Adds a piece at the end, with a force and a moment at the node before it.
    fn add(&mut self, beam: Beam, count: usize, load: [f64; 2]) {
        let next = Whole::of(&beam);
        let mut piece = Piece { beam, count, gain: [[0.0; 3]; 2], constant: [0.0; 2] };
        if self.pieces.is_empty() {
            self.whole = next;
        } else {
            self.whole = self.whole.then(&next, load, &mut piece);
        }
        self.pieces.push(piece);
    }

    /// K for (Lθ, d₁, L d₂), its entries θθ, θ1, θ2, 11, 12, 22, and q for (w, Lθ, d₁, L d₂).
    pub fn scaled(&self) -> (f64, [f64; 6], [f64; 4]) {
        let (l, k, q) = (self.whole.length, &self.whole.stiffness, self.whole.load);
        let per = 1.0 / l;
        let stiffness = [
            k[0][0] * per * per,
            k[0][1] * per,
            k[0][2] * per * per,
            k[1][1],
            k[1][2] * per,
            k[2][2] * per * per,
        ];
        (l, stiffness, [q[0], q[1] * per, q[2], q[3] * per])
    }

    /// The series of each piece for w and θ at the span's beginning and its deformation, with the piece's
    /// first and last node in the grid and its length. In a mirror s runs from the last to the first.
    pub fn unfold(&self, v: &[f64; 4], mut each: impl FnMut([usize; 2], f64, &[f64; TERMS])) {
        let [w, theta, mut d1, mut d2] = *v;
        let mut length = self.whole.length;
        let mut passed = 0;
        for (i, piece) in self.pieces.iter().enumerate().rev() {
            let l = piece.beam.length;
            length -= l;
            let mut own = [w, theta, d1, d2];
            if i > 0 {
                let [b1, b2] = std::array::from_fn(|r| {
                    let [g0, g1, g2] = piece.gain[r];
                    g0 * theta + g1 * d1 + g2 * d2 + piece.constant[r]
                });
                own = [w + length * theta + b1, theta + b2, d1 - b1 - l * b2, d2 - b2];
                (d1, d2) = (b1, b2);
            }
            let nodes = if self.mirrored {
                [self.from + passed, self.from + passed + piece.count]
            } else {
                [self.to - passed - piece.count, self.to - passed]
            };
            passed += piece.count;
            each(nodes, l, &piece.beam.unfold(own));
        }
    }
}

impl Whole {
    fn of(beam: &Beam) -> Self {
        let h = beam.length;
        let [tt, t1, t2, k11, k12, k22] = beam.stiffness();
        let [qw, qt, q1, q2] = beam.load();
        Whole {
            length: h,
            stiffness: [
                [tt * h * h, t1 * h, t2 * h * h],
                [t1 * h, k11, k12 * h],
                [t2 * h * h, k12 * h, k22 * h * h],
            ],
            load: [qw, qt * h, q1, q2 * h],
        }
    }

    /// This one, a force and a moment, and the next one; what is between them goes into `piece`.
    fn then(&self, next: &Whole, load: [f64; 2], piece: &mut Piece) -> Whole {
        let (h, l) = (self.length, next.length);
        // In (θ, D₁, D₂ | d₁, d₂): this one has (θ, d₁, d₂), the next one (θ + d₂, D₁ − d₁ − l d₂, D₂ − d₂).
        const THIS: [[f64; 5]; 3] =
            [[1.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0]];
        let that =
            [[1.0, 0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, -1.0, -l], [0.0, 0.0, 1.0, 0.0, -1.0]];
        let mut k = [[0.0; 5]; 5];
        let mut q = [0.0; 5];
        for (element, rows) in [(self, &THIS), (next, &that)] {
            for i in 0..3 {
                let mut row = [0.0; 5];
                for j in 0..3 {
                    for b in 0..5 {
                        row[b] += element.stiffness[i][j] * rows[j][b];
                    }
                }
                for a in 0..5 {
                    q[a] += rows[i][a] * element.load[i + 1];
                    for b in 0..5 {
                        k[a][b] += rows[i][a] * row[b];
                    }
                }
            }
        }
        // Forces at the node between and on the next one's left end move with w + hθ + d₁.
        let through = next.load[0] + load[0];
        q[0] += h * through + load[1];
        q[3] += through;
        q[4] += load[1];
        let [a, b, c] = [k[3][3], k[3][4], k[4][4]];
        let determinant = a * c - b * b;
        let solve = |x: f64, y: f64| [(c * x - b * y) / determinant, (a * y - b * x) / determinant];
        let columns = [0, 1, 2].map(|j| solve(-k[3][j], -k[4][j]));
        piece.gain = [0, 1].map(|i| columns.map(|column| column[i]));
        piece.constant = solve(q[3], q[4]);
        let mut whole = Whole { length: h + l, ..Whole::default() };
        whole.load[0] = self.load[0] + through;
        for i in 0..3 {
            let [first, second] = piece.constant;
            whole.load[i + 1] = q[i] - k[i][3] * first - k[i][4] * second;
            for j in 0..3 {
                let [first, second] = columns[j];
                whole.stiffness[i][j] = k[i][j] + k[i][3] * first + k[i][4] * second;
            }
        }
        whole
    }
}
