//! Makes models with many parts of one kind.

use groundbeam::{Beam, Foundation, Hinge, Load, Model, Support};

/// The kind of the parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Forces at points.
    Points,
    /// Distributed loads on adjacent stretches of the beam.
    Spread,
    /// Segments of the beam.
    Beam,
    /// Segments of the ground.
    Ground,
    /// Forces on the ground.
    GroundForces,
    /// Distributed loads on adjacent stretches of the ground.
    GroundSpread,
    /// Pins.
    Supports,
    /// Elastic hinges.
    Hinges,
}

/// All kinds.
pub const KINDS: [Kind; 8] = [
    Kind::Points,
    Kind::Spread,
    Kind::Beam,
    Kind::Ground,
    Kind::GroundForces,
    Kind::GroundSpread,
    Kind::Supports,
    Kind::Hinges,
];

/// Returns a model of a beam of 1 km with `count` parts of a kind.
pub fn model(kind: Kind, count: usize) -> Model {
    let length = 1000.0;
    let beam = Beam::uniform(length, 1e12);
    let mut model = Model::new(beam, Foundation::pasternak(40e6, 9e6))
        .with_load(Load::uniform_force(0.0, length, 5e3));
    for i in 0..count {
        let at = |part: f64| length * (i as f64 + part) / count as f64;
        let (from, at, to, size) = (at(0.0), at(0.5), at(1.0), (10 + i % 7) as f64);
        let (start, end) = (1e3 * size, 1e3 * size);
        match kind {
            Kind::Points => model.loads.push(Load::point_force(at, start)),
            Kind::Spread => model.loads.push(Load::distributed_force(from, to, start, end)),
            Kind::Beam => model.beam = model.beam.with_segment(from, to, 1e11 * size),
            Kind::Ground => {
                model.foundation = model.foundation.with_segment(from, to, 4e6 * size, 9e6);
            }
            Kind::GroundForces => model.loads.push(Load::ground_force(at, start)),
            Kind::GroundSpread => {
                model.loads.push(Load::distributed_ground_force(from, to, start, end));
            }
            Kind::Supports => model.supports.push(Support::pinned(at)),
            Kind::Hinges => model.hinges.push(Hinge::elastic(at, 1e6 * size)),
        }
    }
    model
}
