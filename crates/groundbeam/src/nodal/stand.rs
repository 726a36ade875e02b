//! What stands at a node: loads, supports, a hinge, and the springs of the ground beyond an end of the beam.

use super::grid::Grid;

/// What acts on and holds the beam at one node.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Stand {
    pub force: f64,
    pub moment: f64,
    /// Springs of the ground beyond an end and of a tether, and their sum times where they rest.
    pub spring: f64,
    pub push: f64,
    /// Springs of a support against w and against the rotation.
    pub support: f64,
    pub turning: f64,
    /// Where the support has settled.
    pub settlement: f64,
    pub pinned: bool,
    pub clamped: bool,
    /// The rotation may jump, against this spring.
    pub hinge: Option<f64>,
}

impl Stand {
    /// At a node of a grid, seen from the left or in a mirror; without the ground.
    pub fn at(grid: &Grid, node: usize, mirrored: bool, tether: Option<&Tether>) -> Self {
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
        if let Some(tether) = tether
            && tether.holds(grid, node)
        {
            stand.spring = tether.spring;
            stand.push = tether.spring * tether.at[node];
        }
        stand
    }

    /// The same on the ground.
    pub fn on_ground(grid: &Grid, node: usize, mirrored: bool, tether: Option<&Tether>) -> Self {
        let mut stand = Self::at(grid, node, mirrored, tether);
        let beyond = |end: usize, side: usize| if node == end { grid.outside[side] } else { 0.0 };
        let spring = beyond(0, 0) + beyond(grid.last(), 1);
        if spring != 0.0 {
            stand.spring += spring;
            stand.push += spring * grid.gap(node);
        }
        stand
    }

    /// All forces that do not depend on the motion.
    pub fn load(&self) -> f64 {
        self.force + self.push + self.support * self.settlement
    }

    /// Whether a support stands here.
    pub fn holds(&self) -> bool {
        self.pinned || self.clamped || self.support != 0.0 || self.turning != 0.0
    }

    /// Whether a support, a hinge or a tether stands here.
    pub fn is_joint(&self) -> bool {
        self.holds() || self.hinge.is_some() || self.spring != 0.0
    }
}

/// Springs at both ends of every hinged piece of the beam, at rest at some deflection: what the ground does not hold.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tether<'a> {
    pub spring: f64,
    /// w at all nodes.
    pub at: &'a [f64],
}

impl Tether<'_> {
    /// Whether there is a spring at a node.
    fn holds(&self, grid: &Grid, node: usize) -> bool {
        node == 0
            || node == grid.last()
            || grid.place(node).is_some_and(|place| place.hinge.is_some())
    }

    /// The springs' forces on the beam with another deflection, up positive.
    pub fn forces<'a>(
        &'a self,
        grid: &'a Grid,
        deflection: &'a [f64],
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let held = grid.firsts().filter(|node| self.holds(grid, *node));
        held.map(|node| (node, self.spring * (deflection[node] - self.at[node])))
    }
}
