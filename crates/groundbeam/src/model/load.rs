//! The loads in equation (4.7) of Kikuchi's paper, each with its type, position and size.

/// The type of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Action {
    /// Force \[N\], or distributed force \[N/m\]; positive down. On the beam it is fᵢ or f(x) in (4.7) of Kikuchi's
    /// paper. It may also act on the ground's surface.
    Force,
    /// Moment \[N·m\], or distributed moment \[N·m/m\]: gᵢ or g(x) in (4.7) of Kikuchi's paper. A positive moment turns
    /// the beam clockwise, so that its right end moves down.
    Moment,
    /// Imposed curvature κ₀ \[1/m\] due to temperature, shrinkage or camber, with M = −EI (w″ − κ₀). It is positive if
    /// it bends the ends of the beam down.
    Curvature,
}

impl Action {
    /// Order of the derivative of w on which the load does work: 0 for a force, 1 for a moment, 2 for an imposed
    /// curvature.
    pub(crate) fn derivative(self) -> usize {
        match self {
            Action::Force => 0,
            Action::Moment => 1,
            Action::Curvature => 2,
        }
    }
}

/// Position and size of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// Load at a point.
    Point {
        /// Position \[m\].
        at: f64,
        /// Size.
        size: f64,
    },
    /// Distributed load along a stretch, linear between the ends of the stretch.
    Distributed {
        /// Left end \[m\].
        from: f64,
        /// Right end \[m\].
        to: f64,
        /// Size at the left end.
        start: f64,
        /// Size at the right end.
        end: f64,
    },
}

/// Load on the beam or on the ground, with its type, position and size.
///
/// ```
/// use groundbeam::{Load, model::Action};
///
/// let load = Load::distributed_force(0.0, 6.0, 20e3, 35e3);
/// assert_eq!(load.action(), Action::Force);
/// assert_eq!(load.extent().ends(), [0.0, 6.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    pub(crate) action: Action,
    pub(crate) extent: Extent,
    pub(crate) on_ground: bool,
}

impl Extent {
    /// Positions of the left and the right end of the load \[m\]; the two positions of a point load are equal.
    pub fn ends(&self) -> [f64; 2] {
        match *self {
            Extent::Point { at, .. } => [at; 2],
            Extent::Distributed { from, to, .. } => [from, to],
        }
    }

    /// Sizes of the load at its left and its right end; the two sizes of a point load are equal.
    pub fn sizes(&self) -> [f64; 2] {
        match *self {
            Extent::Point { size, .. } => [size; 2],
            Extent::Distributed { start, end, .. } => [start, end],
        }
    }

    /// Larger absolute value of the sizes at the two ends of the load.
    pub fn largest(&self) -> f64 {
        let [start, end] = self.sizes();
        start.abs().max(end.abs())
    }

    /// Absolute value of the integral of the load over its stretch. The value is valid only if the load does not
    /// change its sign.
    pub fn total(&self) -> f64 {
        match *self {
            Extent::Point { size, .. } => size.abs(),
            Extent::Distributed { from, to, start, end } => {
                0.5 * (start.abs() + end.abs()) * (to - from)
            }
        }
    }

    /// Size of the load at the position x, extrapolated beyond the ends of the load.
    pub(crate) fn at(&self, x: f64) -> f64 {
        match *self {
            Extent::Point { size, .. } => size,
            Extent::Distributed { start, end, .. } if start == end => start,
            // The formula is symmetric in both ends, so that a mirrored load has bitwise equal values.
            Extent::Distributed { from, to, start, end } => {
                (start * (to - x) + end * (x - from)) / (to - from)
            }
        }
    }

    /// Adds the values of the distributed load at both ends of the interval `x` to `sum`.
    pub(crate) fn add_to(&self, sum: &mut [f64; 2], x: [f64; 2]) {
        for (sum, x) in sum.iter_mut().zip(x) {
            *sum += self.at(x);
        }
    }

    /// Whether the load acts along a stretch.
    pub fn is_distributed(&self) -> bool {
        matches!(self, Extent::Distributed { .. })
    }
}

/// Resultants of the two triangles into which a linear load is divided, each with its position.
pub(crate) fn triangles([from, to]: [f64; 2], [start, end]: [f64; 2]) -> [(f64, f64); 2] {
    let length = to - from;
    [(0.5 * start * length, from + length / 3.0), (0.5 * end * length, to - length / 3.0)]
}

impl Load {
    /// Creates a load. Returns `None` for a curvature at a point, for a curvature on the ground and for a moment on
    /// the ground.
    pub fn new(action: Action, extent: Extent, on_ground: bool) -> Option<Self> {
        let exists = match action {
            Action::Force => true,
            Action::Moment => !on_ground,
            Action::Curvature => !on_ground && extent.is_distributed(),
        };
        exists.then_some(Load { action, extent, on_ground })
    }

    fn point(action: Action, at: f64, size: f64) -> Self {
        Load { action, extent: Extent::Point { at, size }, on_ground: false }
    }

    fn distributed(action: Action, [from, to]: [f64; 2], [start, end]: [f64; 2]) -> Self {
        Load { action, extent: Extent::Distributed { from, to, start, end }, on_ground: false }
    }

    /// Creates a point force \[N\] at a position \[m\]. It is fᵢ in equation (4.7) of Kikuchi's paper.
    pub fn point_force(at: f64, force: f64) -> Self {
        Self::point(Action::Force, at, force)
    }

    /// Creates a point moment \[N·m\] at a position \[m\]. It is gᵢ in equation (4.7) of Kikuchi's paper.
    pub fn point_moment(at: f64, moment: f64) -> Self {
        Self::point(Action::Moment, at, moment)
    }

    /// Creates a force \[N/m\] along a stretch \[m\], linear between the ends of the stretch. It is f(x) in equation
    /// (4.7) of Kikuchi's paper.
    pub fn distributed_force(from: f64, to: f64, start: f64, end: f64) -> Self {
        Self::distributed(Action::Force, [from, to], [start, end])
    }

    /// Creates a uniform force \[N/m\] along a stretch \[m\].
    pub fn uniform_force(from: f64, to: f64, force: f64) -> Self {
        Self::distributed_force(from, to, force, force)
    }

    /// Creates a moment \[N·m/m\] along a stretch \[m\], linear between the ends of the stretch. It is g(x) in equation
    /// (4.7) of Kikuchi's paper.
    pub fn distributed_moment(from: f64, to: f64, start: f64, end: f64) -> Self {
        Self::distributed(Action::Moment, [from, to], [start, end])
    }

    /// Creates an imposed curvature κ₀ \[1/m\] along a stretch \[m\], linear between the ends of the stretch.
    pub fn distributed_curvature(from: f64, to: f64, start: f64, end: f64) -> Self {
        Self::distributed(Action::Curvature, [from, to], [start, end])
    }

    /// Creates a uniform imposed curvature κ₀ \[1/m\] along a stretch \[m\].
    pub fn uniform_curvature(from: f64, to: f64, curvature: f64) -> Self {
        Self::distributed_curvature(from, to, curvature, curvature)
    }

    /// Creates a force \[N\] on the ground's surface at a point \[m\] under the beam or outside it. The ground needs
    /// a shear layer at this point.
    pub fn ground_force(at: f64, force: f64) -> Self {
        Load { on_ground: true, ..Self::point_force(at, force) }
    }

    /// Creates a force \[N/m\] on the ground's surface along a stretch \[m\], linear between the ends of the stretch.
    /// It is q in −(μu′)′ + ku = p + q.
    pub fn distributed_ground_force(from: f64, to: f64, start: f64, end: f64) -> Self {
        Load { on_ground: true, ..Self::distributed_force(from, to, start, end) }
    }

    /// The type of the load.
    pub fn action(&self) -> Action {
        self.action
    }

    /// The position and size of the load.
    pub fn extent(&self) -> Extent {
        self.extent
    }

    /// Whether the load acts on the ground instead of the beam.
    pub fn is_on_ground(&self) -> bool {
        self.on_ground
    }

    /// Position and size of a point load of the type `action` on the beam; `None` if the load is of another type, is
    /// distributed or acts on the ground.
    pub fn at_point(&self, action: Action) -> Option<(f64, f64)> {
        match self.extent {
            Extent::Point { at, size } if self.action == action && !self.on_ground => {
                Some((at, size))
            }
            _ => None,
        }
    }

    /// Absolute size of the load as a force \[N\]. A moment is divided by `length`. The result is zero for a
    /// curvature, which does no work in rigid-body displacements.
    pub fn as_force(&self, length: f64) -> f64 {
        match self.action.derivative() {
            0 => self.extent.total(),
            1 => self.extent.total() / length,
            _ => 0.0,
        }
    }

    /// Returns the load with its size multiplied by `factor`.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        self.with_sizes(|[start, end]| [start * factor, end * factor])
    }

    fn with_sizes(mut self, change: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        match &mut self.extent {
            Extent::Point { size, .. } => [*size, _] = change([*size; 2]),
            Extent::Distributed { start, end, .. } => [*start, *end] = change([*start, *end]),
        }
        self
    }

    pub(super) fn mirrored(self, l: f64) -> Self {
        let sign = if self.action == Action::Moment { -1.0 } else { 1.0 };
        let mut mirrored = self.with_sizes(|[start, end]| [sign * end, sign * start]);
        match &mut mirrored.extent {
            Extent::Point { at, .. } => *at = l - *at,
            Extent::Distributed { from, to, .. } => [*from, *to] = [l - *to, l - *from],
        }
        mirrored
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_existing_types_of_load_are_constructed() {
        let point = Extent::Point { at: 1.0, size: 2.0 };
        let stretch = Extent::Distributed { from: 0.0, to: 1.0, start: 2.0, end: 3.0 };
        assert_eq!(Load::new(Action::Force, point, true), Some(Load::ground_force(1.0, 2.0)));
        let curved = Some(Load::distributed_curvature(0.0, 1.0, 2.0, 3.0));
        assert_eq!(Load::new(Action::Curvature, stretch, false), curved);
        assert_eq!(Load::new(Action::Curvature, point, false), None);
        assert_eq!(Load::new(Action::Curvature, stretch, true), None);
        assert_eq!(Load::new(Action::Moment, point, true), None);
    }

    #[test]
    fn a_mirrored_moment_has_the_opposite_sign() {
        let spread = Load::distributed_moment(1.0, 2.0, 3.0, 4.0).mirrored(10.0);
        assert_eq!(spread, Load::distributed_moment(8.0, 9.0, -4.0, -3.0));
        assert_eq!(Load::point_force(1.0, 3.0).mirrored(10.0), Load::point_force(9.0, 3.0));
        let curved = Load::distributed_curvature(1.0, 2.0, 3.0, 4.0).mirrored(10.0);
        assert_eq!(curved, Load::distributed_curvature(8.0, 9.0, 4.0, 3.0));
    }
}
