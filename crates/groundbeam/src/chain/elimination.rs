//! Solves the linear system: eliminates the unknowns of beam and ground from both ends of the beam to a node between them.
//!
//! The unknowns of a node are the deflection and the rotation of the beam and, out of contact, an unknown of the ground
//! surface. No stiffness is a small difference of large numbers. See section 6 of `docs/methods.md`.

use crate::chain::hinge::HingeRotation;
use crate::chain::links::{add_open_ground, counted};
use crate::chain::node::{ChainCell, ChainNode, CondensedStiffness, NotDefinite, THETA, Tie, U, W};
use crate::element::element::{Basis, Element, mirror_shape};
use crate::numeric::real::sum;

#[derive(Debug, Clone, Default)]
pub(crate) struct Chain {
    pub nodes: Vec<ChainNode>,
    pub cells: Vec<ChainCell>,
    /// The node at which the elimination from the left end of the beam and the elimination from the right end
    /// meet. The solution is most accurate if this node is well supported.
    pub meeting: usize,
}

/// Back-substitution across a cell, which computes the unknowns of the left node from those of the right node. In a
/// sweep from the right, the cell is mirrored.
#[derive(Debug, Clone, Copy, Default)]
struct BackSubstitution {
    /// The three eliminated unknowns, two of the beam and one of the ground surface, equal `constant` minus
    /// `gain` times the three unknowns of the right node.
    gain: [[f64; 3]; 3],
    constant: [f64; 3],
    /// For the deflection and for the rotation: whether the value at the left node is eliminated instead of the
    /// deformation of the element.
    by_left: [bool; 2],
    /// Whether the eliminated unknown of the ground surface is the surface unknown of the right node minus that
    /// of the left node. Otherwise it is the surface unknown of the left node.
    rise: bool,
    /// Coefficients a, b and c of the surface unknown c − a w − b θ at a left node with deflection w and rotation θ,
    /// where ground out of contact ends.
    ended: [f64; 3],
    /// Back-substitution across the hinge at the left node.
    turned: Option<HingeRotation>,
}

impl Chain {
    /// Solves the linear system. Returns the four unknowns of every element.
    pub fn solve(&self) -> Result<Vec<[f64; 4]>, NotDefinite> {
        let last = self.nodes.len() - 1;
        let meet = self.meeting.min(last);
        let (left, back_left) = self.sweep::<false>(0, meet)?;
        let (right, back_right) = self.sweep::<true>(last, meet)?;
        let mut both = left;
        let turned = HingeRotation::condense(&self.nodes[meet], &mut both)?;
        // In the sweep from the right, rotations have the opposite sign.
        let sign = [1.0, -1.0, 1.0];
        for i in 0..3 {
            both.r[i] += right.r[i] * sign[i];
            for j in 0..3 {
                both.s[i][j] += right.s[i][j] * (sign[i] * sign[j]);
            }
        }
        let node = &self.nodes[meet];
        apply(node, &mut both, 1.0);
        let at_meeting = solve_node(node, &both)?;
        let mut shapes = vec![[0.0; 4]; self.cells.len()];
        let mut y = HingeRotation::beyond_hinge(turned, at_meeting);
        for (i, back) in (0..meet).zip(&back_left).rev() {
            let Element { length, basis, .. } = self.cells[i].element;
            y = back.cross(length, basis, y, &mut shapes[i]);
            y = HingeRotation::beyond_hinge(back.turned, back.end(&self.nodes[i], y, true));
        }
        let mut y = at_meeting;
        y[THETA] = -y[THETA];
        for (i, back) in (meet..last).rev().zip(&back_right).rev() {
            let Element { length, basis, .. } = self.cells[i].element;
            let mut v = [0.0; 4];
            y = back.cross(length, basis, y, &mut v);
            shapes[i] = mirror_shape(&v, length, basis);
            y = HingeRotation::beyond_hinge(back.turned, back.end(&self.nodes[i + 1], y, false));
        }
        Ok(shapes)
    }

    /// Condenses all cells from one end of the beam to the node at which the two sweeps meet, without the loads
    /// and supports of this node.
    fn sweep<const MIRRORED: bool>(
        &self,
        start: usize,
        meet: usize,
    ) -> Result<(CondensedStiffness, Vec<BackSubstitution>), NotDefinite> {
        let count = start.abs_diff(meet);
        let mut returns = Vec::with_capacity(count);
        let mut state = CondensedStiffness::default();
        for step in 0..count {
            let [here, ahead] =
                if MIRRORED { [start - step, start - step - 1] } else { [step, step + 1] };
            let [node, next] = [&self.nodes[here], &self.nodes[ahead]];
            apply(node, &mut state, if MIRRORED { -1.0 } else { 1.0 });
            let turned = HingeRotation::condense(node, &mut state)?;
            let mut back = BackSubstitution { turned, ..BackSubstitution::default() };
            let sides = if MIRRORED { [1, 0] } else { [0, 1] };
            if node.surface[sides[0]] && !node.surface[sides[1]] {
                back.ended = end_surface(&mut state)?;
            }
            let cell = &self.cells[here.min(ahead)];
            let cell = if MIRRORED { cell.mirrored() } else { *cell };
            state = cross(&cell, [node, next], &state, &mut back)?;
            returns.push(back);
        }
        Ok((state, returns))
    }
}

/// Adds the loads and supports of one node. `sign` is −1 in a sweep from the right, in which rotations and moments have
/// the opposite sign.
fn apply(node: &ChainNode, state: &mut CondensedStiffness, sign: f64) {
    state.s[W][W] += node.spring + node.ground_spring;
    state.s[THETA][THETA] += node.rotational_spring;
    state.s[U][U] += node.surface_spring;
    state.r[W] += node.force + node.ground_spring * node.gap + node.spring * node.settlement;
    state.r[THETA] += node.moment * sign;
    if node.from_beam {
        // Here the surface unknown is the settlement relative to the beam, but the surface spring acts on the
        // settlement itself.
        state.s[U][W] += node.surface_spring;
        state.s[W][U] += node.surface_spring;
        state.s[W][W] += node.surface_spring;
        state.r[W] += node.surface_spring * node.gap;
        state.r[U] += node.surface_spring * node.gap;
    }
}

/// Eliminates the settlement of the surface at a node where the free surface ends.
fn end_surface(state: &mut CondensedStiffness) -> Result<[f64; 3], NotDefinite> {
    let pivot = state.s[U][U];
    if pivot <= 0.0 {
        return Err(NotDefinite);
    }
    let gain = [state.s[U][W] / pivot, state.s[U][THETA] / pivot, state.r[U] / pivot];
    for i in [W, THETA] {
        let across = state.s[i][U];
        for j in [W, THETA] {
            state.s[i][j] -= across * gain[j];
        }
        state.r[i] -= across * gain[2];
    }
    for i in 0..3 {
        (state.s[i][U], state.s[U][i]) = (0.0, 0.0);
    }
    state.r[U] = 0.0;
    Ok(gain)
}

/// Returns the matrix that computes the unknowns of an element from the deflection and rotation of the right node and
/// the two eliminated unknowns (see [`BackSubstitution::by_left`]).
fn transform(h: f64, basis: Basis, by_left: [bool; 2]) -> [[f64; 4]; 4] {
    if basis == Basis::Ends {
        return [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
        ];
    }
    let [w_known, theta_known] = by_left;
    let theta = if theta_known { [0.0, 0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0, -1.0] };
    let d2 = if theta_known { [0.0, 1.0, 0.0, -1.0] } else { [0.0, 0.0, 0.0, 1.0] };
    let other: [f64; 4] = std::array::from_fn(|i| [1.0, 0.0, -1.0, 0.0][i] - h * theta[i]);
    let own = [0.0, 0.0, 1.0, 0.0];
    if w_known { [own, theta, other, d2] } else { [other, theta, own, d2] }
}

/// New positions of the unknowns, those of the right node first. Old order: deflection and rotation of the right node,
/// two eliminated beam unknowns, surface unknowns of the left and the right node.
const ORDER: [usize; 6] = [0, 1, 3, 4, 5, 2];

/// Transforms the coefficients of four element and two surface unknowns by the matrix `c` of [`transform`], and sorts
/// them by [`ORDER`].
fn in_order(row: &[f64; 6], c: &[[f64; 4]; 4]) -> [f64; 6] {
    let mut ordered = [0.0; 6];
    for j in 0..4 {
        ordered[ORDER[j]] = sum::<f64, 4>(|n| row[n] * c[n][j]);
    }
    for j in [4, 5] {
        ordered[ORDER[j]] = row[j];
    }
    ordered
}

fn cross(
    ChainCell { element, open }: &ChainCell,
    [node, next]: [&ChainNode; 2],
    state: &CondensedStiffness,
    back: &mut BackSubstitution,
) -> Result<CondensedStiffness, NotDefinite> {
    // If open ground is stiffer than the ground behind it, the difference of the surface unknowns replaces the left
    // one. Rounding errors of the large stiffness then do not mask the small one.
    back.rise = open
        .is_some_and(|open| open.ties == [Tie::Surface; 2] && open.two_port.series > state.s[U][U]);
    let surface_left =
        if back.rise { [0.0, 0.0, 0.0, 0.0, -1.0, 1.0] } else { [0.0, 0.0, 0.0, 0.0, 1.0, 0.0] };
    let beam = [false, true].map(|right| element.end_row(right));
    let surfaces = [
        counted(surface_left, node, beam[0]),
        counted([0.0, 0.0, 0.0, 0.0, 0.0, 1.0], next, beam[1]),
    ];
    // Stiffness and load of the element and of all cells behind it, for the element unknowns and the surface unknowns.
    let mut k = [[0.0; 6]; 6];
    let mut q = [0.0; 6];
    for i in 0..4 {
        k[i][..4].copy_from_slice(&element.stiffness[i]);
        q[i] = element.load[i];
    }
    for i in [W, THETA] {
        q[i] += state.r[i];
        for j in [W, THETA] {
            k[i][j] += state.s[i][j];
        }
        for j in [4, 5] {
            k[i][j] += state.s[i][U] * surface_left[j];
            k[j][i] += state.s[i][U] * surface_left[j];
        }
    }
    for i in [4, 5] {
        q[i] += state.r[U] * surface_left[i];
        for j in [4, 5] {
            k[i][j] += state.s[U][U] * surface_left[i] * surface_left[j];
        }
    }

    back.by_left = [
        node.pinned || state.s[W][W] > element.stiffness[2][2],
        node.clamped || state.s[THETA][THETA] > element.stiffness[3][3],
    ];
    let c = transform(element.length, element.basis, back.by_left);
    // Transforms the stiffness matrix and the load vector to the new unknowns, sorted by `ORDER`.
    let mut half = [[0.0; 4]; 6];
    for i in 0..6 {
        for j in 0..4 {
            half[i][j] = sum::<f64, 4>(|m| k[i][m] * c[m][j]);
        }
    }
    let mut m = [[0.0; 6]; 6];
    let mut f = [0.0; 6];
    for i in 0..4 {
        let a = ORDER[i];
        f[a] = sum::<f64, 4>(|n| q[n] * c[n][i]);
        for j in 0..4 {
            m[a][ORDER[j]] = sum::<f64, 4>(|n| half[n][j] * c[n][i]);
        }
        for surface in [4, 5] {
            let at = ORDER[surface];
            m[a][at] = half[surface][i];
            m[at][a] = half[surface][i];
        }
    }
    for i in [4, 5] {
        f[ORDER[i]] = q[i];
        for j in [4, 5] {
            m[ORDER[i]][ORDER[j]] = k[i][j];
        }
    }
    // Open ground is added after the transformation. Otherwise, rounding errors of its stiffness would restrain the
    // rotation of a free beam.
    if let Some(open) = open {
        add_open_ground(open, surfaces, beam, |row| in_order(row, &c), &mut m, &mut f);
    }
    let free = [!node.pinned, !node.clamped, node.surface[0] || node.surface[1]];
    condense(&m, &f, free, node.settlement, back)
}

/// Eliminates the last three of six unknowns. Those that are not `free` equal `settlement` (the first one) or zero.
fn condense(
    m: &[[f64; 6]; 6],
    f: &[f64; 6],
    free: [bool; 3],
    settlement: f64,
    back: &mut BackSubstitution,
) -> Result<CondensedStiffness, NotDefinite> {
    // Solves for the eliminated unknowns by LDLᵀ factorisation, with four right-hand sides: the columns of the
    // three remaining unknowns, and the load vector.
    let mut a = [[0.0; 3]; 3];
    let mut b = [[0.0; 4]; 3];
    for i in 0..3 {
        for j in 0..3 {
            a[i][j] = m[3 + i][3 + j];
            b[i][j] = m[3 + i][j];
        }
        b[i][3] = f[3 + i];
    }
    let given = if free[0] { 0.0 } else { settlement };
    if given != 0.0 {
        for i in 1..3 {
            b[i][3] -= a[i][0] * given;
        }
    }
    for i in 0..3 {
        if !free[i] || (i == 2 && a[2][2] == 0.0 && m[5].iter().all(|&x| x == 0.0)) {
            a[i] = [0.0; 3];
            for row in &mut a {
                row[i] = 0.0;
            }
            a[i][i] = 1.0;
            b[i] = [0.0; 4];
        }
    }
    b[0][3] += given;
    let size = [0, 1, 2].map(|i| a[i][i].abs());
    for p in 0..3 {
        let pivot = a[p][p];
        if pivot.is_nan() || pivot <= 1e-15 * size[p] {
            return Err(NotDefinite);
        }
        for i in p + 1..3 {
            let factor = a[i][p] / pivot;
            for j in p + 1..3 {
                let less = factor * a[p][j];
                a[i][j] -= less;
            }
            for j in 0..4 {
                let less = factor * b[p][j];
                b[i][j] -= less;
            }
        }
    }
    for p in (0..3).rev() {
        for j in 0..4 {
            let mut known = 0.0;
            for i in p + 1..3 {
                known += a[p][i] * b[i][j];
            }
            b[p][j] = (b[p][j] - known) / a[p][p];
        }
    }
    for i in 0..3 {
        back.gain[i].copy_from_slice(&b[i][..3]);
        back.constant[i] = b[i][3];
    }
    let mut ahead = CondensedStiffness::default();
    for i in 0..3 {
        ahead.r[i] = f[i] - sum::<f64, 3>(|e| m[3 + e][i] * b[e][3]);
        for j in i..3 {
            ahead.s[i][j] = m[i][j] - sum::<f64, 3>(|e| m[3 + e][i] * b[e][j]);
            ahead.s[j][i] = ahead.s[i][j];
        }
    }
    Ok(ahead)
}

/// Computes the three unknowns of the node at which the eliminations from both ends of the beam meet, from its
/// condensed stiffness and force.
fn solve_node(node: &ChainNode, both: &CondensedStiffness) -> Result<[f64; 3], NotDefinite> {
    let mut m = [[0.0; 6]; 6];
    let mut f = [0.0; 6];
    for i in 0..3 {
        f[3 + i] = both.r[i];
        for j in 0..3 {
            m[3 + i][3 + j] = both.s[i][j];
        }
    }
    let free = [!node.pinned, !node.clamped, node.surface[0] || node.surface[1]];
    let mut back = BackSubstitution::default();
    condense(&m, &f, free, node.settlement, &mut back)?;
    Ok(back.constant)
}

impl BackSubstitution {
    /// Computes the three unknowns of the left node and the unknowns `v` of the element from the three unknowns `y`
    /// of the right node.
    fn cross(&self, h: f64, basis: Basis, y: [f64; 3], v: &mut [f64; 4]) -> [f64; 3] {
        let e: [f64; 3] =
            std::array::from_fn(|i| self.constant[i] - sum::<f64, 3>(|j| self.gain[i][j] * y[j]));
        let c = transform(h, basis, self.by_left);
        let z = [y[W], y[THETA], e[0], e[1]];
        *v = std::array::from_fn(|i| sum::<f64, 4>(|j| z[j] * c[i][j]));
        [v[0], v[1], if self.rise { y[U] - e[2] } else { e[2] }]
    }

    /// Sets the surface unknown in `y` if open ground ends at the node: on its left if `forward` is true, otherwise on
    /// its right.
    fn end(&self, node: &ChainNode, mut y: [f64; 3], forward: bool) -> [f64; 3] {
        let [behind, ahead] = if forward { [0, 1] } else { [1, 0] };
        if node.surface[behind] && !node.surface[ahead] {
            let [by_w, by_theta, constant] = self.ended;
            y[U] = constant - by_w * y[W] - by_theta * y[THETA];
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::node::OpenGround;
    use crate::element::ExactElement;
    use crate::element::operator::{Operator, ZoneKind};
    use crate::ground::link::TwoPort;
    use crate::mesh::mesh::Mesh;
    use crate::model::{Beam, Foundation, Load, Model};

    /// Rounding error must not restrain the rotation of a free end, which may rise by a million times the ground
    /// settlement.
    #[test]
    fn a_free_beam_has_zero_rotational_stiffness() {
        for i in 1..200 {
            let length = 0.614 + 1e-3 * f64::from(i);
            let model = Model::new(Beam::uniform(length, 1e-10), Foundation::pasternak(7.0, 0.02))
                .with_load(Load::uniform_force(0.0, length, 1.0));
            let cell = Mesh::build(&model, &[], |_| 1).cells[0];
            let element =
                ExactElement::new(&Operator::of(&cell, 0.0, ZoneKind::Open), length).element;
            let open = OpenGround {
                two_port: TwoPort::uniform(cell.subgrade, cell.shear_layer, length),
                ties: [Tie::Surface, Tie::Beam { gap: 0.0 }],
            };
            let cell = ChainCell { element, open: Some(open) };
            let free = ChainNode { surface: [true; 2], surface_spring: 0.3, ..Default::default() };
            let mut behind = CondensedStiffness::default();
            apply(&free, &mut behind, 1.0);
            let nodes = [&free, &ChainNode::default()];
            let ahead = cross(&cell, nodes, &behind, &mut BackSubstitution::default());
            let s = ahead.expect("a free end").s;
            assert!(s[W][W] > 0.3 && s[W][THETA] == 0.0 && s[THETA][THETA] == 0.0, "{s:?}");
        }
    }
}
