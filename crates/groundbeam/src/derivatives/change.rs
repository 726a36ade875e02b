//! The change of the equations by a parameter, ∂ of a(y, z) − F(z).

use super::linearised::Linearised;
use super::parameter::{Domain, LoadNumber, Parameter, Property, SupportNumber, of_load};
use crate::derivatives::piece::Piece;
use crate::model::Extent;
use crate::model::{Action, BeamSegment, Foundation, Load, Model, Profile};

/// By how much everything that may change does, for a unit of the parameter.
#[derive(Debug, Clone, Default)]
pub(super) struct Change {
    /// EI, S, k and μ of every element, relative to their own; nothing where none changes.
    stiffness: Vec<f64>,
    shear_stiffness: Vec<f64>,
    spring: Vec<f64>,
    shear: Vec<f64>,
    /// k and μ of the layers beyond the left and the right end, in the same way.
    pub beyond: [Vec<[f64; 2]>; 2],
    /// P.
    pub axial: f64,
    spreads: Vec<Spread>,
    pub points: Vec<PointChange>,
    /// A point of the gap's profile.
    pub gap: Option<usize>,
    pub support: Option<(usize, SupportNumber)>,
    pub hinge: Option<usize>,
    /// The position that moves.
    pub moves: Option<f64>,
}

/// What a distributed load is conjugate to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Force,
    Moment,
    Curvature,
    Ground,
}

impl Kind {
    fn of(load: &Load) -> Self {
        match load.action {
            Action::Force if load.on_ground => Kind::Ground,
            Action::Force => Kind::Force,
            Action::Moment => Kind::Moment,
            Action::Curvature => Kind::Curvature,
        }
    }
}

/// A distributed load, linear between its ends.
#[derive(Debug, Clone, Copy)]
struct Spread {
    kind: Kind,
    x: [f64; 2],
    values: [f64; 2],
}

/// What a change at one point does its work on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Against {
    /// w.
    Deflection,
    /// φ, which is w' where the beam does not shear.
    Rotation,
    /// w', of a force that moves: from the side to which it does.
    SlopeBeside,
    /// φ, of the end of a distributed moment that moves, in the same way.
    RotationBeside,
    /// φ', in the same way.
    BendBeside,
    /// EI φ', in the same way.
    CurlBeside,
    /// u.
    Settlement,
}

impl Against {
    /// Of the size of a load at a point.
    fn at_point(load: &Load) -> Self {
        match load.action {
            _ if load.on_ground => Against::Settlement,
            Action::Moment => Against::Rotation,
            _ => Against::Deflection,
        }
    }
}

/// A change at one point.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointChange {
    pub x: f64,
    pub against: Against,
    pub weight: f64,
}

/// What changes at one place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Rates {
    /// EI, S, k and μ, relative to their own.
    pub stiffness: f64,
    pub shear_stiffness: f64,
    pub spring: f64,
    pub shear: f64,
    /// P \[N\].
    pub axial: f64,
    /// f, g, κ₀ and the load on the ground.
    pub force: f64,
    pub moment: f64,
    pub curvature: f64,
    pub ground: f64,
    /// g₀ and g₀'.
    pub gap: f64,
    pub gap_slope: f64,
}

impl Change {
    /// What a parameter that the model has changes.
    pub fn of(lin: &Linearised, parameter: Parameter) -> Self {
        let model = &lin.model;
        let mut change = Change::default();
        match parameter {
            Parameter::Value(property, domain) => {
                let value = parameter.value(model).unwrap_or(1.0);
                change.scale(lin, property, domain, 1.0 / value);
            }
            Parameter::Factor(property, domain) => change.scale(lin, property, domain, 1.0),
            Parameter::AxialForce => change.axial = 1.0,
            Parameter::LoadFactor => {
                for load in &model.loads {
                    change.grow(load);
                }
            }
            Parameter::Load(i, number) => {
                if let Some(load) = model.loads.get(i) {
                    change.load(load, number);
                }
            }
            Parameter::Support(i, number) => change.support = Some((i, number)),
            Parameter::HingeSpring(i) => change.hinge = Some(i),
            Parameter::Gap(i) => change.gap = Some(i),
        }
        change
    }

    /// Whether any of k and μ changes.
    pub fn is_of_ground(&self) -> bool {
        !self.spring.is_empty() || !self.shear.is_empty()
    }

    fn scale(&mut self, lin: &Linearised, property: Property, domain: Domain, rate: f64) {
        let (model, cells) = (&lin.model, &lin.mesh.cells);
        let beam = matches!(property, Property::BendingStiffness | Property::ShearStiffness);
        let ground = &model.foundation;
        let holding = |x: f64| {
            let held = |from: f64, to: f64| from <= x && x < to;
            if beam {
                // A segment that says nothing of S has that of the beam.
                let says = |s: &BeamSegment| {
                    property == Property::BendingStiffness || s.shear_stiffness.is_some()
                };
                model.beam.segments.iter().position(|s| held(s.from, s.to) && says(s))
            } else {
                ground.segments.iter().position(|s| held(s.from, s.to))
            }
        };
        let rate_of = |segment: Option<usize>| match domain {
            Domain::Whole => rate,
            Domain::OutsideSegments if segment.is_none() => rate,
            Domain::Segment(i) if segment == Some(i) => rate,
            _ => 0.0,
        };
        let own: Vec<Option<usize>> =
            cells.iter().map(|cell| holding(0.5 * (cell.x[0] + cell.x[1]))).collect();
        let rates = own.iter().map(|segment| rate_of(*segment)).collect();
        match property {
            Property::BendingStiffness => self.stiffness = rates,
            Property::ShearStiffness => self.shear_stiffness = rates,
            Property::Spring => self.spring = rates,
            Property::Shear => self.shear = rates,
        }
        if beam {
            return;
        }
        for right in [false, true] {
            let (at_end, s) = if right { (cells.len() - 1, 1.0) } else { (0, -1.0) };
            let shear = cells[at_end].ground_at(s)[1];
            let layers = segments_beyond(ground, model.beam.length, right, own[at_end], shear);
            self.beyond[usize::from(right)] = layers
                .into_iter()
                .map(|segment| {
                    let rate = rate_of(segment);
                    if property == Property::Spring { [rate, 0.0] } else { [0.0, rate] }
                })
                .collect();
        }
    }

    /// All of a load grows.
    fn grow(&mut self, load: &Load) {
        match load.extent {
            Extent::Point { at, size } => self.point(at, Against::at_point(load), size),
            Extent::Distributed { from, to, start, end } => {
                let (x, values) = ([from, to], [start, end]);
                self.spreads.push(Spread { kind: Kind::of(load), x, values });
            }
        }
    }

    fn point(&mut self, x: f64, against: Against, weight: f64) {
        self.points.push(PointChange { x, against, weight });
    }

    fn load(&mut self, load: &Load, number: LoadNumber) {
        if matches!(number, LoadNumber::At | LoadNumber::From | LoadNumber::To) {
            self.moves = of_load(load, number);
        }
        let (from, to, start, end) = match load.extent {
            Extent::Distributed { from, to, start, end } => (from, to, start, end),
            Extent::Point { at, size } if number == LoadNumber::At => {
                return match load.action {
                    Action::Moment => self.point(at, Against::BendBeside, size),
                    _ => self.point(at, Against::SlopeBeside, size),
                };
            }
            Extent::Point { at, .. } => return self.point(at, Against::at_point(load), 1.0),
        };
        let kind = Kind::of(load);
        let rise = (end - start) / (to - from);
        let beside = match kind {
            Kind::Moment => Against::RotationBeside,
            Kind::Curvature => Against::CurlBeside,
            _ => Against::Deflection,
        };
        let values = match number {
            LoadNumber::Start => [1.0, 0.0],
            LoadNumber::End => [0.0, 1.0],
            // (x − from)/(to − from) at a fixed x falls as `from` moves, and as `to` does.
            LoadNumber::From => {
                self.point(from, beside, -start);
                [-rise, 0.0]
            }
            LoadNumber::To => {
                self.point(to, beside, end);
                [0.0, -rise]
            }
            LoadNumber::Size | LoadNumber::At => [1.0; 2],
        };
        self.spreads.push(Spread { kind, x: [from, to], values });
    }

    /// What changes at s of a piece.
    pub fn at(&self, model: &Model, piece: &Piece, s: f64) -> Rates {
        let of = |rates: &[f64]| rates.get(piece.element).copied().unwrap_or(0.0);
        let mut rates = Rates {
            stiffness: of(&self.stiffness),
            shear_stiffness: of(&self.shear_stiffness),
            spring: of(&self.spring),
            shear: of(&self.shear),
            axial: self.axial,
            ..Rates::default()
        };
        if self.spreads.is_empty() && self.gap.is_none() {
            return rates;
        }
        let x = piece.cell.global(s);
        let middle = 0.5 * (piece.cell.x[0] + piece.cell.x[1]);
        for spread in &self.spreads {
            let [from, to] = spread.x;
            if from <= middle && middle < to {
                let into = match spread.kind {
                    Kind::Force => &mut rates.force,
                    Kind::Moment => &mut rates.moment,
                    Kind::Curvature => &mut rates.curvature,
                    Kind::Ground => &mut rates.ground,
                };
                *into += spread.at(x);
            }
        }
        if let Some(i) = self.gap {
            [rates.gap, rates.gap_slope] = hat(model, i, x, middle);
        }
        rates
    }

    /// The loads spread on the ground that change: ends and values at them.
    pub fn on_ground(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
        let ground = self.spreads.iter().filter(|spread| spread.kind == Kind::Ground);
        ground.map(|spread| (spread.x, spread.values))
    }

    /// The forces on the ground that change: where, and by how much.
    pub fn forces_on_ground(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let own = self.points.iter().filter(|point| point.against == Against::Settlement);
        own.map(|point| (point.x, point.weight))
    }

    /// By how much g₀ at x changes.
    pub fn gap_at(&self, model: &Model, x: f64) -> f64 {
        self.gap.map_or(0.0, |i| hat(model, i, x, x)[0])
    }
}

impl Spread {
    fn at(&self, x: f64) -> f64 {
        let [from, to] = self.x;
        (self.values[0] * (to - x) + self.values[1] * (x - from)) / (to - from)
    }
}

/// By how much g₀ at x and g₀' near it change with one point of the profile.
fn hat(model: &Model, i: usize, x: f64, near: f64) -> [f64; 2] {
    let at = |i: usize| model.gap[i].at;
    let (before, after) = (i.checked_sub(1).map(at), model.gap.get(i + 1).map(|next| next.at));
    let own = at(i);
    if near < own {
        before.map_or([1.0, 0.0], |left| {
            if near <= left { [0.0; 2] } else { [(x - left) / (own - left), 1.0 / (own - left)] }
        })
    } else {
        after.map_or([1.0, 0.0], |right| {
            if near >= right {
                [0.0; 2]
            } else {
                [(right - x) / (right - own), -1.0 / (right - own)]
            }
        })
    }
}

/// The segments of which the layers beyond an end are, from there outward.
fn segments_beyond(
    ground: &Foundation,
    length: f64,
    right: bool,
    at_end: Option<usize>,
    shear: f64,
) -> Vec<Option<usize>> {
    // The layers of ground whose spring constants are the segments' numbers.
    let number = |segment: Option<usize>| segment.map_or(1.0, |i| (i + 2) as f64);
    let mut numbered = ground.clone();
    for (i, segment) in numbered.segments.iter_mut().enumerate() {
        segment.subgrade = Profile::constant(number(Some(i)));
    }
    let beyond = numbered.beyond(right, length, [number(at_end), shear]);
    let segment = |number: f64| (number >= 2.0).then(|| number as usize - 2);
    beyond.layers.iter().map(|layer| segment(layer.subgrade)).collect()
}
