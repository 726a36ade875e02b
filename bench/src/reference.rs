//! Solves the beam in contact on a mesh, in double-double arithmetic, for a given set of contact nodes.
//!
//! The caller checks that no contact force is tensile and no node lies below the ground surface. These signs prove the
//! contact set, because the contact problem is convex.

use crate::quad::Quad;
use groundbeam::{
    Model,
    model::{Action, Extent},
};

/// Result of a solve in double-double arithmetic.
pub struct Reference {
    pub deflection: Vec<f64>,
    pub force: Vec<f64>,
    /// Smallest contact force (negative in tension) divided by the largest one; 0 without tension.
    pub smallest_force: f64,
    /// Largest penetration w − u divided by the largest deflection w.
    pub deepest: f64,
}

/// Consecutive equal elements: position and number of their first node, number of elements, and element length.
pub type Row = (f64, usize, usize, f64);

type Block = [[Quad; 3]; 3];

/// Solves a model with constant EI, k and μ under point and uniform loads. `contact` lists the ranges of nodes in
/// contact; a bonded beam has all its nodes in contact.
pub fn solve(model: &Model, rows: &[Row], contact: &[[usize; 2]]) -> Reference {
    let last = rows.last().map_or(0, |row| row.1 + row.2);
    let loads = all_loads(model, rows);
    let touches = {
        let mut touches = vec![false; last + 1];
        contact.iter().for_each(|&[a, b]| touches[a..=b].fill(true));
        touches
    };
    // The unknowns of node i are the deflection w, the rotation θ and the ground displacement u.
    // At a contact node u = w, so the third unknown is omitted.
    let mut diagonal = vec![[[Quad::default(); 3]; 3]; last + 1];
    let mut beside = vec![[[Quad::default(); 3]; 3]; last];
    let outside =
        root(Quad::from(model.foundation.subgrade) * Quad::from(model.foundation.shear_layer));
    let mut ground: Vec<[Quad; 2]> = Vec::with_capacity(last);
    for &(_, first, count, h) in rows {
        let h = Quad::from(h);
        let (near, far, links) = element(model, h);
        for i in first..first + count {
            let to = |k: &mut Block, from: &[[Quad; 2]; 2]| {
                for a in 0..2 {
                    for b in 0..2 {
                        k[a][b] = k[a][b] + from[a][b];
                    }
                }
            };
            to(&mut diagonal[i], &near);
            to(&mut diagonal[i + 1], &mirror(&near));
            to(&mut beside[i], &far);
            ground.push(links);
        }
    }
    // Index of the unknown that compresses the ground at node i: the deflection w at a contact node, the ground
    // displacement u at any other node.
    let which = |i: usize| if touches[i] { 0 } else { 2 };
    let add = |to: &mut Quad, x: Quad| *to = *to + x;
    for i in 0..last {
        let [leak, coupling] = ground[i];
        for j in [i, i + 1] {
            add(&mut diagonal[j][which(j)][which(j)], leak + coupling);
        }
        add(&mut beside[i][which(i)][which(i + 1)], -coupling);
    }
    for i in [0, last] {
        add(&mut diagonal[i][which(i)][which(i)], outside);
    }
    let one = Quad::from(1.0);
    for (i, touches) in touches.iter().enumerate() {
        if *touches {
            diagonal[i][2][2] = one;
        }
    }
    let x = eliminate(&mut diagonal, &beside, &loads);
    let u = |i: usize| x[i][which(i)];
    let force = |i: usize| {
        let mut p = Quad::default();
        if i > 0 {
            let [leak, coupling] = ground[i - 1];
            p = p + leak * u(i) + coupling * (u(i) - u(i - 1));
        }
        if i < last {
            let [leak, coupling] = ground[i];
            p = p + leak * u(i) + coupling * (u(i) - u(i + 1));
        }
        if i == 0 || i == last { p + outside * u(i) } else { p }
    };
    let all: Vec<f64> =
        (0..=last).map(|i| if touches[i] { force(i).double() } else { 0.0 }).collect();
    let w: Vec<f64> = x.iter().map(|x| x[0].double()).collect();
    let largest = |v: &[f64]| v.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let smallest = all.iter().copied().fold(0.0, f64::min) / largest(&all);
    let deepest = x.iter().enumerate().filter(|(i, _)| !touches[*i]);
    let deepest = deepest.map(|(_, x)| (x[0] - x[2]).double()).fold(0.0, f64::max) / largest(&w);
    Reference { smallest_force: smallest, deepest, deflection: w, force: all }
}

/// Solves the block tridiagonal system by block LDLᵗ elimination from left to right, with blocks of size three.
fn eliminate(diagonal: &mut [Block], beside: &[Block], loads: &[[Quad; 2]]) -> Vec<[Quad; 3]> {
    let zero = Quad::default();
    let n = diagonal.len();
    let mut x: Vec<[Quad; 3]> = loads.iter().map(|l| [l[0], l[1], zero]).collect();
    for i in 1..n {
        // Eliminates the unknowns of node i − 1 from the equations of node i.
        let solved = solve_block(&diagonal[i - 1], &beside[i - 1], &x[i - 1]);
        for a in 0..3 {
            for m in 0..3 {
                let b = beside[i - 1][m][a];
                for c in 0..3 {
                    diagonal[i][a][c] = diagonal[i][a][c] - b * solved[m][c];
                }
                x[i][a] = x[i][a] - b * solved[m][3];
            }
        }
    }
    let nothing = [[zero; 3]; 3];
    for i in (0..n).rev() {
        let mut rhs = x[i];
        if i + 1 < n {
            for a in 0..3 {
                for m in 0..3 {
                    rhs[a] = rhs[a] - beside[i][a][m] * x[i + 1][m];
                }
            }
        }
        let solved = solve_block(&diagonal[i], &nothing, &rhs);
        x[i] = [solved[0][3], solved[1][3], solved[2][3]];
    }
    x
}

/// Returns the solution of a 3 × 3 system with the matrix `d`, for the three columns of `b` and for the column `r`.
fn solve_block(d: &Block, b: &Block, r: &[Quad; 3]) -> [[Quad; 4]; 3] {
    let mut a = *d;
    let mut x: [[Quad; 4]; 3] = std::array::from_fn(|i| [b[i][0], b[i][1], b[i][2], r[i]]);
    for p in 0..3 {
        for i in p + 1..3 {
            let factor = a[i][p] / a[p][p];
            for j in p..3 {
                a[i][j] = a[i][j] - factor * a[p][j];
            }
            for j in 0..4 {
                x[i][j] = x[i][j] - factor * x[p][j];
            }
        }
    }
    for p in (0..3).rev() {
        for j in 0..4 {
            let mut sum = x[p][j];
            for i in p + 1..3 {
                sum = sum - a[p][i] * x[i][j];
            }
            x[p][j] = sum / a[p][p];
        }
    }
    x
}

/// Returns the stiffness of an element of length `h`: of the beam at the left end, of the beam between both ends, and
/// of the ground springs under each end and between the ends.
fn element(model: &Model, h: Quad) -> ([[Quad; 2]; 2], [[Quad; 2]; 2], [Quad; 2]) {
    let q = Quad::from;
    let ei = q(model.beam.bending_stiffness);
    // The Stumpff functions of t are valid for tension (positive axial force), compression and no axial force.
    let t = q(model.beam.axial_force) * h * h / ei;
    let (c1, c2, c3) = (stumpff(t, 1), stumpff(t, 2), stumpff(t, 3));
    let d = c2 * c2 - c1 * c3;
    let (h2, h3) = (h * h, h * h * h);
    let kww = ei / h3 * (c1 / d);
    let kwt = ei / h2 * (c2 / d);
    let ktt = ei / h * ((c2 - c3) / d);
    // The coupling between the rotations of the two ends follows from the moment equilibrium of the element under a
    // unit rotation of its left end.
    let across = kwt * h - ktt;
    let near = [[kww, kwt], [kwt, ktt]];
    let far = [[-kww, kwt], [-kwt, across]];
    let (k, mu) = (q(model.foundation.subgrade), q(model.foundation.shear_layer));
    let z2 = k * h * h / mu;
    // Ground springs with z = h √(k/μ): √(kμ) tanh(z/2) under each end, and √(kμ)/sinh z between the ends.
    let (s1, s2) = (stumpff(z2, 1), stumpff(z2, 2));
    (near, far, [k * h * s2 / s1, mu / h / s1])
}

/// Returns the Stumpff function cₙ(t), the sum of tⁱ / (2i + n)! over all i ≥ 0.
fn stumpff(t: Quad, n: u32) -> Quad {
    let mut term = Quad::from(1.0);
    for i in 1..=n {
        term = term / Quad::from(f64::from(i));
    }
    let mut sum = term;
    for i in 1..30 {
        let m = f64::from(2 * i + n);
        term = term * t / Quad::from(m * (m - 1.0));
        sum = sum + term;
    }
    sum
}

fn mirror(k: &[[Quad; 2]; 2]) -> [[Quad; 2]; 2] {
    [[k[0][0], -k[0][1]], [-k[1][0], k[1][1]]]
}

/// Returns the nodal forces and moments that are equivalent to all loads.
fn all_loads(model: &Model, rows: &[Row]) -> Vec<[Quad; 2]> {
    let last = rows.last().map_or(0, |row| row.1 + row.2);
    let (mut at_nodes, even) = loads(model, rows, last);
    for &(_, first, count, h) in rows {
        let [w, m] = even_load(model, even, Quad::from(h));
        for i in first..first + count {
            at_nodes[i] = [at_nodes[i][0] + w, at_nodes[i][1] + m];
            at_nodes[i + 1] = [at_nodes[i + 1][0] + w, at_nodes[i + 1][1] - m];
        }
    }
    at_nodes
}

/// Returns the equivalent nodal forces and moments as doubles.
pub fn nodal_loads(model: &Model, rows: &[Row]) -> [Vec<f64>; 2] {
    let all = all_loads(model, rows);
    [0, 1].map(|i| all.iter().map(|load| load[i].double()).collect())
}

/// Returns the point forces and moments at the nodes, and the uniform load along the whole beam.
fn loads(model: &Model, rows: &[Row], last: usize) -> (Vec<[Quad; 2]>, f64) {
    let mut at_nodes = vec![[Quad::default(); 2]; last + 1];
    let mut even = 0.0;
    let node = |x: f64| rows.iter().find(|row| row.0 >= x * (1.0 - 1e-12)).map_or(last, |r| r.1);
    for load in &model.loads {
        match (load.action(), load.extent()) {
            (Action::Force, Extent::Point { at, size: force }) => {
                at_nodes[node(at)][0] = at_nodes[node(at)][0] + Quad::from(force);
            }
            (Action::Moment, Extent::Point { at, size: moment }) => {
                at_nodes[node(at)][1] = at_nodes[node(at)][1] + Quad::from(moment);
            }
            (Action::Force, Extent::Distributed { start, .. }) => even += start,
            _ => {}
        }
    }
    (at_nodes, even)
}

/// Returns the fixed-end force and moment at the left end of an element under the uniform load `f`.
fn even_load(model: &Model, f: f64, h: Quad) -> [Quad; 2] {
    let q = Quad::from;
    let t = q(model.beam.axial_force) * h * h / q(model.beam.bending_stiffness);
    let (c1, c2, c3, c4) = (stumpff(t, 1), stumpff(t, 2), stumpff(t, 3), stumpff(t, 4));
    let d = c2 * c2 - c1 * c3;
    let moment = q(f) * h * h * ((c2 * c4 - c3 * c3) / d);
    [q(f) * h * q(0.5), -moment]
}

fn root(x: Quad) -> Quad {
    let guess = Quad::from(x.double().sqrt());
    let better = (guess + x / guess) * Quad::from(0.5);
    (better + x / better) * Quad::from(0.5)
}
