//! The beam between two nodes that touch: any number of pieces off the ground as one element.

use super::beam::{Beam, TERMS};
use super::grid::Grid;

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
pub(crate) struct Span {
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
        let wanted = own.pieces(grid.axial_force, own.h * count as f64).min(count);
        let at = |i: usize| count * i / wanted;
        for i in 0..wanted {
            let (a, b) = if self.mirrored {
                (to - at(i + 1), to - at(i))
            } else {
                (from + at(i), from + at(i + 1))
            };
            let part = own.part(a, b);
            let given = if self.mirrored { part.mirrored() } else { part };
            let length = own.h * (b - a) as f64;
            let beam = Beam::new(own.stiffness, &given, grid.axial_force, length);
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
    pub fn unfold(
        &self,
        v: &[f64; 4],
        mut each: impl FnMut([usize; 2], f64, &[f64; TERMS], usize),
    ) {
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
            let (series, terms) = piece.beam.unfold(own);
            each(nodes, l, &series, terms);
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
        let ([k, n], [q, r]) = ([self.stiffness, next.stiffness], [self.load, next.load]);
        // This one has (θ, d₁, d₂), the next one (θ + d₂, D₁ − d₁ − l d₂, D₂ − d₂): what it demands of d₂ is
        let turn = [0, 1, 2].map(|j| n[0][j] - l * n[1][j] - n[2][j]);
        let [a, b, c] =
            [k[1][1] + n[1][1], k[1][2] - turn[1], k[2][2] + (turn[0] - l * turn[1] - turn[2])];
        // (θ, D₁, D₂) by (d₁, d₂), and with themselves.
        let across =
            [[k[0][1] - n[0][1], k[0][2] + turn[0]], [-n[1][1], turn[1]], [-n[1][2], turn[2]]];
        let mut outer = n;
        outer[0][0] += k[0][0];
        // Forces at the node between and on the next one's left end move with w + hθ + d₁.
        let through = r[0] + load[0];
        let [q1, q2] = [q[2] - r[2] + through, q[3] + (r[1] - l * r[2] - r[3]) + load[1]];
        let ends = [q[1] + r[1] + h * through + load[1], r[2], r[3]];
        let determinant = a * c - b * b;
        let inverse = 1.0 / determinant;
        let solve = |x: f64, y: f64| [(c * x - b * y) * inverse, (a * y - b * x) * inverse];
        let columns = across.map(|[x, y]| solve(-x, -y));
        piece.gain = [0, 1].map(|i| columns.map(|column| column[i]));
        piece.constant = solve(q1, q2);
        let mut whole = Whole { length: h + l, ..Whole::default() };
        whole.load[0] = q[0] + through;
        for i in 0..3 {
            let [x, y] = across[i];
            whole.load[i + 1] = ends[i] - x * piece.constant[0] - y * piece.constant[1];
            for j in 0..3 {
                whole.stiffness[i][j] = outer[i][j] + x * columns[j][0] + y * columns[j][1];
            }
        }
        whole
    }
}
