//! Solves beams with shear deformation by elements in which deflection w, rotation φ and settlement u are linear.
//!
//! The shear strain is evaluated at one point of each element (Hughes, Taylor and Kanoknukulchai 1977). The contact set
//! is found by trial.

use groundbeam::{
    Model, SupportKind,
    model::{Action, Extent},
};

/// Deflection and rotation of a beam at equally spaced nodes.
#[derive(Debug, Clone)]
pub struct Linear {
    /// Deflection w at the nodes \[m\].
    pub w: Vec<f64>,
    /// Rotation φ at the nodes \[rad\].
    pub rotation: Vec<f64>,
    touching: Vec<bool>,
}

/// Deflection w, rotation φ and settlement u of a node.
type Node = [f64; 3];
type Block = [[f64; 3]; 3];

const W: usize = 0;
const TURN: usize = 1;
const U: usize = 2;

/// Maximum number of changes of the contact set on one mesh.
const MOST_SWEEPS: usize = 4000;

impl Linear {
    /// Solves a uniform beam on uniform ground with loads and supports at nodes. If the model has an initial gap, its
    /// values at both ends of the beam must be given.
    pub fn solve(model: &Model, elements: usize) -> Self {
        let coarse = elements / 4;
        let start = if coarse.is_multiple_of(40) && coarse > 40 {
            let coarse = Self::solve(model, coarse);
            (0..=elements).map(|i| coarse.touching[(i + 2) / 4]).collect()
        } else {
            vec![true; elements + 1]
        };
        Mesh::new(model, elements).solve(start)
    }
}

struct Mesh {
    h: f64,
    gap: Vec<f64>,
    /// Stiffnesses of the springs at each node that act on the deflection w and the rotation φ.
    springs: Vec<[f64; 2]>,
    loads: Vec<[f64; 2]>,
    held: Vec<[bool; 2]>,
    /// Bending stiffness EI, shear stiffness S, axial force P, subgrade k and shear layer μ.
    constants: [f64; 5],
}

impl Mesh {
    fn new(model: &Model, elements: usize) -> Self {
        let l = model.beam.length;
        let h = l / elements as f64;
        let count = elements + 1;
        let node = |x: f64| (x / h).round() as usize;
        let gap = |i: usize| {
            let x = h * i as f64;
            let after = model.gap.iter().position(|corner| corner.at >= x - 1e-9 * l);
            let [a, b] = match after {
                None => return 0.0,
                Some(0) => return model.gap[0].value,
                Some(i) => [model.gap[i - 1], model.gap[i]],
            };
            a.value + (b.value - a.value) * (x - a.at) / (b.at - a.at)
        };
        let mut mesh = Mesh {
            h,
            gap: (0..count).map(gap).collect(),
            springs: vec![[0.0; 2]; count],
            loads: vec![[0.0; 2]; count],
            held: vec![[false; 2]; count],
            constants: [
                model.beam.bending_stiffness,
                model.beam.shear_stiffness.expect("a beam with shear deformation"),
                model.beam.axial_force,
                model.foundation.subgrade,
                model.foundation.shear_layer,
            ],
        };
        for load in &model.loads {
            match (load.action(), load.extent()) {
                (Action::Force, Extent::Point { at, size: force }) => {
                    mesh.loads[node(at)][W] += force
                }
                (Action::Moment, Extent::Point { at, size: moment }) => {
                    mesh.loads[node(at)][TURN] += moment
                }
                (Action::Force, Extent::Distributed { start, .. }) => {
                    for (i, loads) in mesh.loads.iter_mut().enumerate() {
                        let part = if i == 0 || i == elements { 0.5 } else { 1.0 };
                        loads[W] += part * h * start;
                    }
                }
                _ => panic!("{load:?}"),
            }
        }
        for support in &model.supports {
            let i = node(support.at);
            match support.kind {
                SupportKind::Pinned => mesh.held[i] = [true, false],
                SupportKind::Fixed => mesh.held[i] = [true, true],
                SupportKind::Spring { spring, rotational_spring } => {
                    mesh.springs[i] = [spring, rotational_spring];
                }
            }
        }
        mesh
    }

    fn solve(&self, mut touching: Vec<bool>) -> Linear {
        for _ in 0..MOST_SWEEPS {
            let found = self.bonded(&touching);
            let next: Vec<bool> = (0..found.len())
                .map(|i| {
                    let [w, _, u] = found[i];
                    if touching[i] { self.ground(&found, i) >= 0.0 } else { u < w - self.gap[i] }
                })
                .collect();
            if next == touching {
                let w = found.iter().map(|node| node[W]).collect();
                let rotation = found.iter().map(|node| node[TURN]).collect();
                return Linear { w, rotation, touching };
            }
            touching = next;
        }
        panic!("the contact does not converge");
    }

    /// Returns the contact force of the ground at a node.
    fn ground(&self, found: &[Node], i: usize) -> f64 {
        let around = [i.checked_sub(1), Some(i), Some(i + 1).filter(|next| *next < found.len())];
        let row = self.ground_row(i);
        around.iter().zip(row).map(|(at, k)| at.map_or(0.0, |at| k * found[at][U])).sum()
    }

    /// Returns a row of the stiffness matrix of the ground, with the entries for the previous node, the node itself
    /// and the next node.
    fn ground_row(&self, i: usize) -> [f64; 3] {
        let [.., k, mu] = self.constants;
        let h = self.h;
        let sides = usize::from(i > 0) + usize::from(i + 1 < self.gap.len());
        let end = if sides == 1 { (k * mu).sqrt() } else { 0.0 };
        let beside = k * h / 6.0 - mu / h;
        [beside, sides as f64 * (k * h / 3.0 + mu / h) + end, beside]
    }

    /// Solves the beam that is bonded to the ground at the nodes in contact. The block rows are eliminated from left
    /// to right.
    fn bonded(&self, touching: &[bool]) -> Vec<Node> {
        let count = touching.len();
        let [ei, shear, axial, ..] = self.constants;
        let h = self.h;
        // `element` is the stiffness matrix of an element for the unknowns (w_left, φ_left, w_right, φ_right).
        let element = |a: usize, b: usize| {
            let strain = [-1.0 / h, -0.5, 1.0 / h, -0.5];
            let bend = [0.0, -1.0 / h, 0.0, 1.0 / h];
            let slope = [-1.0 / h, 0.0, 1.0 / h, 0.0];
            h * (shear * strain[a] * strain[b]
                + ei * bend[a] * bend[b]
                + axial * slope[a] * slope[b])
        };
        let mut passed: Vec<(Block, Node)> = Vec::with_capacity(count);
        for i in 0..count {
            let mut rows = [[[0.0; 3]; 3]; 3];
            let mut right = [self.loads[i][W], self.loads[i][TURN], 0.0];
            for a in [W, TURN] {
                for b in [W, TURN] {
                    if i > 0 {
                        rows[0][a][b] = element(2 + a, b);
                        rows[1][a][b] += element(2 + a, 2 + b);
                    }
                    if i + 1 < count {
                        rows[2][a][b] = element(a, 2 + b);
                        rows[1][a][b] += element(a, b);
                    }
                }
                rows[1][a][a] += self.springs[i][a];
            }
            let ground = self.ground_row(i);
            if touching[i] {
                for (row, ground) in rows.iter_mut().zip(ground) {
                    row[W][U] = ground;
                }
                (rows[1][U][U], rows[1][U][W], right[U]) = (1.0, -1.0, -self.gap[i]);
            } else {
                for (row, ground) in rows.iter_mut().zip(ground) {
                    row[U][U] = ground;
                }
            }
            for a in [W, TURN] {
                if self.held[i][a] {
                    for row in &mut rows {
                        row[a] = [0.0; 3];
                    }
                    (rows[1][a][a], right[a]) = (1.0, 0.0);
                }
            }
            if let Some((upper, constant)) = passed.last() {
                for a in 0..3 {
                    for m in 0..3 {
                        let by = rows[0][a][m];
                        right[a] -= by * constant[m];
                        for b in 0..3 {
                            rows[1][a][b] -= by * upper[m][b];
                        }
                    }
                }
            }
            passed.push(solve_block(rows[1], rows[2], right));
        }
        let mut found = vec![[0.0; 3]; count];
        let mut next = [0.0; 3];
        for i in (0..count).rev() {
            let (upper, constant) = &passed[i];
            next = std::array::from_fn(|a| {
                constant[a] - (0..3).map(|b| upper[a][b] * next[b]).sum::<f64>()
            });
            found[i] = next;
        }
        found
    }
}

/// Returns M⁻¹ A and M⁻¹ r by Gaussian elimination with pivoting.
fn solve_block(mut m: Block, mut a: Block, mut r: Node) -> (Block, Node) {
    for p in 0..3 {
        let best = (p..3).max_by(|&i, &j| m[i][p].abs().total_cmp(&m[j][p].abs())).unwrap_or(p);
        m.swap(p, best);
        a.swap(p, best);
        r.swap(p, best);
        for i in (0..3).filter(|i| *i != p) {
            let factor = m[i][p] / m[p][p];
            for j in 0..3 {
                m[i][j] -= factor * m[p][j];
                a[i][j] -= factor * a[p][j];
            }
            r[i] -= factor * r[p];
        }
    }
    for p in 0..3 {
        a[p] = a[p].map(|x| x / m[p][p]);
        r[p] /= m[p][p];
    }
    (a, r)
}
