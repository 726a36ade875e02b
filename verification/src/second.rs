//! Compares the models that two independent file readers make of one file, number by number.

use groundbeam::{
    Foundation, Model, SupportKind,
    model::{Acts, Extent, GroundEnd, Profile},
};
use groundbeam_proof as proof;
use groundbeam_proof::{Course, Scalar, Wide};

/// The result of the comparison of two models.
#[derive(Debug, Default)]
pub struct Comparison {
    /// Number of values that were compared.
    pub numbers: usize,
    /// The largest relative difference between corresponding values of the two models, in units of 2⁻⁵².
    pub largest: f64,
    /// Descriptions of the differences that exceed the tolerance.
    pub faults: Vec<String>,
    allowed: f64,
}

impl Comparison {
    /// Compares two models. Relative differences of their numbers are accepted up to `allowed` · 2⁻⁵².
    pub fn of(first: &Model, second: &proof::Model<Wide>, allowed: f64) -> Self {
        let mut comparison = Comparison { allowed, ..Comparison::default() };
        comparison.beam(first, second);
        comparison.ground(first, second);
        comparison.loads(first, second);
        comparison.held(first, second);
        comparison
    }

    fn number(&mut self, name: &str, first: f64, second: Wide) {
        self.number_beside(name, first, second, first);
    }

    /// Compares a number with its enclosure in the second model. The accepted width is relative to `largest`, the
    /// largest number from which it is computed.
    fn number_beside(&mut self, name: &str, first: f64, second: Wide, largest: f64) {
        self.numbers += 1;
        let difference = (first - second.middle()).abs();
        let ulps = if difference == 0.0 { 0.0 } else { difference / first.abs() / f64::EPSILON };
        self.largest = self.largest.max(ulps);
        // The second model stores each value as an interval. `rest` is an upper bound on the half-width of this
        // interval. It must not exceed the rounding error of a double.
        let rest = (second - Wide::of(second.middle())).size();
        let is_sharp = rest <= f64::EPSILON * (first.abs() + 1e-12 * largest.abs()) + 1e-280;
        if !(ulps <= self.allowed && is_sharp) {
            self.faults.push(format!("{name}: {first:e}, {second:?}"));
        }
    }

    fn count(&mut self, name: &str, first: usize, second: usize) {
        if first != second {
            self.faults
                .push(format!("{name}: the first model has {first}, the second has {second}"));
        }
    }

    fn same(&mut self, name: &str, is_same: bool) {
        if !is_same {
            self.faults.push(format!("{name} differs"));
        }
    }

    /// Compares two polynomials by their values at six positions.
    fn course(&mut self, name: &str, first: &Profile, second: &Course<Wide>) {
        if let Course::Constant(second) = second {
            self.same(name, first.is_constant());
            return self.number(name, first.start(), *second);
        }
        for i in 0..6 {
            let t = f64::from(i) / 5.0;
            let second = at(second, Wide::of(f64::from(i)).div(Wide::of(5.0)));
            self.number_beside(&format!("{name} at {t}"), first.at(t), second, first.largest());
        }
    }

    fn beam(&mut self, first: &Model, second: &proof::Model<Wide>) {
        let (first, second) = (&first.beam, &second.beam);
        self.number("length", first.length, second.length);
        self.number("EI", first.bending_stiffness, second.bending_stiffness);
        self.number("axial force", first.axial_force, second.axial_force);
        self.same("shear", first.shear_stiffness.is_some() == second.shear_stiffness.is_some());
        if let (Some(first), Some(second)) = (first.shear_stiffness, second.shear_stiffness) {
            self.number("shear stiffness", first, second);
        }
        self.count("beam segments", first.segments.len(), second.segments.len());
        for (i, (first, second)) in first.segments.iter().zip(&second.segments).enumerate() {
            let name = |of: &str| format!("beam segment {i}: {of}");
            self.number(&name("from"), first.from, second.from);
            self.number(&name("to"), first.to, second.to);
            self.course(&name("EI"), &first.bending_stiffness, &second.bending_stiffness);
            let shears = (&first.shear_stiffness, &second.shear_stiffness);
            match shears {
                (Some(first), Some(second)) => self.course(&name("shear"), first, second),
                (first, second) => self.same(&name("shear"), first.is_none() && second.is_none()),
            }
        }
    }

    fn ground(&mut self, first: &Model, second: &proof::Model<Wide>) {
        let (Foundation { subgrade, shear_layer, segments, ends, .. }, second) =
            (&first.foundation, &second.ground);
        self.number("k", *subgrade, second.spring);
        self.number("mu", *shear_layer, second.shear);
        self.count("ground segments", segments.len(), second.segments.len());
        for (i, (first, second)) in segments.iter().zip(&second.segments).enumerate() {
            let name = |of: &str| format!("ground segment {i}: {of}");
            self.number(&name("from"), first.from, second.from);
            self.number(&name("to"), first.to, second.to);
            self.course(&name("k"), &first.subgrade, &second.spring);
            self.course(&name("mu"), &first.shear_layer, &second.shear);
        }
        for (first, second) in ends.iter().zip(second.ends) {
            match (first, second) {
                (GroundEnd::Endless, proof::GroundEnd::Endless) => {}
                (GroundEnd::Free { at }, proof::GroundEnd::Free(second))
                | (GroundEnd::Held { at }, proof::GroundEnd::Held(second)) => {
                    self.number("end of the ground", *at, second);
                }
                _ => self.same("end of the ground", false),
            }
        }
    }

    fn loads(&mut self, first: &Model, second: &proof::Model<Wide>) {
        self.count("loads", first.loads.len(), second.loads.len());
        for (i, (first, second)) in first.loads.iter().zip(&second.loads).enumerate() {
            let name = |of: &str| format!("load {i}: {of}");
            let action = format!("{:?}", first.action()) == format!("{:?}", second.action);
            self.same(&name("kind"), action && first.is_on_ground() == second.on_ground);
            match (first.extent(), second.extent) {
                (Extent::Point { at, size }, proof::Extent::Point { at: place, size: force }) => {
                    self.number(&name("at"), at, place);
                    self.number(&name("size"), size, force);
                }
                (
                    Extent::Distributed { from, to, start, end },
                    proof::Extent::Distributed { from: a, to: b, start: s, end: e },
                ) => {
                    for (of, first, second) in
                        [("from", from, a), ("to", to, b), ("start", start, s), ("end", end, e)]
                    {
                        self.number(&name(of), first, second);
                    }
                }
                _ => self.same(&name("extent"), false),
            }
        }
    }

    fn held(&mut self, first: &Model, second: &proof::Model<Wide>) {
        self.count("supports", first.supports.len(), second.supports.len());
        for (i, (first, second)) in first.supports.iter().zip(&second.supports).enumerate() {
            let name = |of: &str| format!("support {i}: {of}");
            self.number(&name("at"), first.at, second.at);
            self.number(&name("settlement"), first.settlement, second.settlement);
            let acts = match first.acts {
                Acts::Both => proof::Acts::Both,
                Acts::Up => proof::Acts::Up,
                Acts::Down => proof::Acts::Down,
            };
            self.same(&name("acts"), acts == second.acts);
            match (first.kind, second.kind) {
                (SupportKind::Pinned, proof::SupportKind::Pinned)
                | (SupportKind::Fixed, proof::SupportKind::Fixed) => {}
                (
                    SupportKind::Spring { spring, rotational_spring },
                    proof::SupportKind::Spring { spring: k, rotational_spring: turning },
                ) => {
                    self.number(&name("spring"), spring, k);
                    self.number(&name("rotational spring"), rotational_spring, turning);
                }
                _ => self.same(&name("kind"), false),
            }
        }
        self.count("hinges", first.hinges.len(), second.hinges.len());
        for (first, second) in first.hinges.iter().zip(&second.hinges) {
            self.number("hinge", first.at, second.at);
            self.number("hinge's spring", first.rotational_spring, second.rotational_spring);
        }
        self.count("corners", first.gap.len(), second.gap.len());
        for (first, second) in first.gap.iter().zip(&second.gap) {
            self.number("corner", first.at, second.at);
            self.number("gap", first.value, second.value);
        }
    }
}

/// Returns the value of a polynomial at t from its Bernstein coefficients, by de Casteljau's algorithm. t runs from 0
/// to 1 along the segment.
fn at(course: &Course<Wide>, t: Wide) -> Wide {
    let mut values = match course {
        Course::Constant(value) => vec![*value],
        Course::Varying(values) => values.clone(),
    };
    while values.len() > 1 {
        values = values.windows(2).map(|v| (Wide::of(1.0) - t) * v[0] + t * v[1]).collect();
    }
    values[0]
}
