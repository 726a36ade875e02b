//! Collects the loads, supports, hinge and springs at a node of the grid.

use super::grid::Grid;

/// Loads, supports, hinge and springs at a node.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Stand {
    pub force: f64,
    pub moment: f64,
    /// Sum of the stiffnesses of the ground outside an end of the beam and of a stabilising spring.
    pub spring: f64,
    /// Force on the node at zero deflection, from the ground outside the end of the beam and from a stabilising
    /// spring, positive downwards.
    pub push: f64,
    /// Translational stiffness of the support.
    pub support: f64,
    /// Rotational stiffness of the support.
    pub turning: f64,
    /// Settlement of the support.
    pub settlement: f64,
    pub pinned: bool,
    pub clamped: bool,
    /// Rotational stiffness of the hinge; `None` without a hinge.
    pub hinge: Option<f64>,
}

impl Stand {
    /// Collects the loads, support, hinge and stabilising spring at a node. If `mirrored`, the sign of the moment is
    /// reversed.
    pub fn at(
        grid: &Grid,
        node: usize,
        mirrored: bool,
        springs: Option<&StabilisingSprings>,
    ) -> Self {
        let Some(place) = grid.place(node) else { return Stand::default() };
        let mut stand = Stand {
            force: place.force,
            moment: if mirrored { -place.moment } else { place.moment },
            support: place.spring,
            turning: place.rotational_spring,
            settlement: place.settlement,
            pinned: place.pinned,
            clamped: place.clamped,
            hinge: place.hinge,
            ..Stand::default()
        };
        if let Some(springs) = springs
            && springs.holds(grid, node)
        {
            stand.spring = springs.stiffness;
            stand.push = springs.stiffness * springs.rest[node];
        }
        stand
    }

    /// Returns the result of [`Stand::at`], with the ground outside the ends of the beam added.
    pub fn on_ground(
        grid: &Grid,
        node: usize,
        mirrored: bool,
        springs: Option<&StabilisingSprings>,
    ) -> Self {
        let mut stand = Self::at(grid, node, mirrored, springs);
        let beyond = |end: usize, side: usize| if node == end { grid.outside[side] } else { 0.0 };
        let spring = beyond(0, 0) + beyond(grid.last(), 1);
        if spring != 0.0 {
            stand.spring += spring;
            stand.push += spring * grid.gap(node);
        }
        stand
    }

    /// Sum of the forces at the node that do not depend on the deflection w.
    pub fn load(&self) -> f64 {
        self.force + self.push + self.support * self.settlement
    }

    /// Whether the node has a support.
    pub fn holds(&self) -> bool {
        self.pinned || self.clamped || self.support != 0.0 || self.turning != 0.0
    }

    /// Whether the node has a support, a hinge or a spring.
    pub fn is_joint(&self) -> bool {
        self.holds() || self.hinge.is_some() || self.spring != 0.0
    }
}

/// Stabilising springs at both ends of the beam and at its hinges, for a beam that the contact does not support.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StabilisingSprings<'a> {
    pub stiffness: f64,
    /// Rest position of the springs: one deflection for each node.
    pub rest: &'a [f64],
}

impl StabilisingSprings<'_> {
    /// Whether a node has a stabilising spring.
    fn holds(&self, grid: &Grid, node: usize) -> bool {
        node == 0
            || node == grid.last()
            || grid.place(node).is_some_and(|place| place.hinge.is_some())
    }

    /// Forces of the springs on the beam for the given deflection, positive upwards, with their nodes.
    pub fn forces<'a>(
        &'a self,
        grid: &'a Grid,
        deflection: &'a [f64],
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let held = grid.firsts().filter(|node| self.holds(grid, *node));
        held.map(|node| (node, self.stiffness * (deflection[node] - self.rest[node])))
    }
}
