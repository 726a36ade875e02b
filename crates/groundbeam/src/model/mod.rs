//! Model of a beam on ground: beam, foundation, loads, supports, hinges, gap (section 2, Remarks 1 and 2 of Kikuchi's paper).
//!
//! All numbers of a model must belong to one coherent system of units, such as m, N and rad.

mod beam;
mod foundation;
mod gap;
mod hinge;
mod load;
pub(crate) mod outside;
mod part;
pub(crate) mod problem;
mod profile;
pub(crate) mod refused;
pub(crate) mod rules;
pub(crate) mod soil;
pub(crate) mod support;
mod train;

use self::soil::GroundConstants;
use std::borrow::Cow;

pub use crate::model::foundation::GroundEnd;
pub use crate::model::problem::{Part, Problem};
pub use beam::{Beam, BeamSegment};
pub use foundation::{Foundation, FoundationSegment};
pub use gap::GapPoint;
pub use hinge::Hinge;
pub(crate) use load::triangles;
pub use load::{Action, Extent, Load};
pub(crate) use outside::GroundOutside;
pub(crate) use profile::CellPolynomial;
pub use profile::Profile;
pub use support::{Acts, Support, SupportKind};
pub use train::{Axle, Train, UniformPart};

/// Beam, the ground under it, and the loads on both. Positions `x` are measured from the beam's left end. Deflections
/// and forces are positive down. [`Model::problems`] lists every violation of the rules.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// The beam: its length, bending stiffness and axial force.
    pub beam: Beam,
    /// The ground: its spring and shear constants.
    pub foundation: Foundation,
    /// Loads on the beam, as in equation (4.7) of Kikuchi's paper, and loads on the ground. Empty if the model has no
    /// loads.
    pub loads: Vec<Load>,
    /// Supports of the beam besides the ground. Empty if the beam has no supports.
    pub supports: Vec<Support>,
    /// Hinges inside the beam. Empty if the beam has no hinges.
    pub hinges: Vec<Hinge>,
    /// Corners of the initial clearance between beam and ground. The clearance is linear between neighbouring corners.
    /// Empty if the clearance is zero.
    pub gap: Vec<GapPoint>,
}

impl Model {
    /// Creates a model of a beam on a foundation, without loads, supports or hinges, and without an initial gap.
    pub fn new(beam: Beam, foundation: Foundation) -> Self {
        Model {
            beam,
            foundation,
            loads: Vec::new(),
            supports: Vec::new(),
            hinges: Vec::new(),
            gap: Vec::new(),
        }
    }

    /// Returns the model with one more load.
    pub fn with_load(mut self, load: Load) -> Self {
        self.loads.push(load);
        self
    }

    /// Returns the model with one more support.
    pub fn with_support(mut self, support: Support) -> Self {
        self.supports.push(support);
        self
    }

    /// Returns the model with one more hinge.
    pub fn with_hinge(mut self, hinge: Hinge) -> Self {
        self.hinges.push(hinge);
        self
    }

    /// Returns the model with one more corner of the initial gap.
    pub fn with_gap(mut self, at: f64, value: f64) -> Self {
        self.gap.push(GapPoint { at, value });
        self
    }

    /// Returns the model with every load multiplied by `factor`.
    pub fn with_loads_scaled(mut self, factor: f64) -> Self {
        for load in &mut self.loads {
            *load = load.scaled(factor);
        }
        self
    }

    /// The loads on the beam.
    pub fn beam_loads(&self) -> impl Iterator<Item = &Load> {
        self.loads.iter().filter(|load| !load.on_ground)
    }

    /// The loads on the ground.
    pub fn ground_loads(&self) -> impl Iterator<Item = &Load> {
        self.loads.iter().filter(|load| load.on_ground)
    }

    /// Whether the model has loads on the ground.
    pub(crate) fn has_ground_loads(&self) -> bool {
        self.loads.iter().any(Load::is_on_ground)
    }

    /// First segment along which a stiffness of the beam or the ground varies; `None` if no segment varies.
    pub(crate) fn varying_part(&self) -> Option<Part> {
        let ground = &self.foundation.segments;
        let varies = |s: &BeamSegment| {
            let sheared = s.shear_stiffness.is_some_and(|shear| !shear.is_constant());
            sheared || !s.bending_stiffness.is_constant()
        };
        let beam = self.beam.segments.iter().position(varies);
        let below =
            ground.iter().position(|s| !(s.subgrade.is_constant() && s.shear_layer.is_constant()));
        beam.map(Part::BeamSegment).or(below.map(Part::FoundationSegment))
    }

    /// Returns the model on uniform ground with the given k and μ.
    pub(crate) fn on_ground(&self, ground: GroundConstants) -> Self {
        let foundation = Foundation::pasternak(ground.subgrade, ground.shear_layer);
        Model { foundation, ..self.clone() }
    }

    /// Returns the model with k and μ computed from its soil data alone, without a solution of the beam. Returns the
    /// model unchanged if its k and μ are given.
    pub(crate) fn on_given_ground(&self) -> Cow<'_, Model> {
        match &self.foundation.soil {
            None => Cow::Borrowed(self),
            Some(soil) => Cow::Owned(self.on_ground(soil.subgrade(&self.beam))),
        }
    }

    /// Whether the model has one-way supports.
    pub(crate) fn has_one_way_supports(&self) -> bool {
        self.supports.iter().any(Support::is_one_way)
    }

    /// Returns the model with only those supports that `keeps` selects. All of them become two-way supports.
    pub(crate) fn with_supports_that(&self, keeps: impl Fn(usize, &Support) -> bool) -> Self {
        let kept = self.supports.iter().enumerate().filter(|(i, support)| keeps(*i, support));
        let supports = kept.map(|(_, support)| support.acting(Acts::Both)).collect();
        Model { supports, ..self.clone() }
    }

    /// Copies another model into this model and reuses the allocated memory.
    pub(crate) fn copy_from(&mut self, other: &Model) {
        let mut segments = std::mem::take(&mut self.beam.segments);
        segments.clone_from(&other.beam.segments);
        self.beam = Beam { segments, ..other.beam };
        let mut segments = std::mem::take(&mut self.foundation.segments);
        segments.clone_from(&other.foundation.segments);
        let soil = other.foundation.soil.clone();
        self.foundation = Foundation { segments, soil, ..other.foundation };
        self.loads.clone_from(&other.loads);
        self.supports.clone_from(&other.supports);
        self.hinges.clone_from(&other.hinges);
        self.gap.clone_from(&other.gap);
    }

    /// Returns the mirrored model, in which x becomes l − x.
    pub fn mirrored(&self) -> Self {
        let l = self.beam.length;
        let mut gap: Vec<GapPoint> =
            self.gap.iter().map(|g| GapPoint { at: l - g.at, value: g.value }).collect();
        gap.reverse();
        Model {
            beam: self.beam.mirrored(),
            foundation: self.foundation.mirrored(l),
            loads: self.loads.iter().map(|load| load.mirrored(l)).collect(),
            supports: self.supports.iter().map(|s| Support { at: l - s.at, ..*s }).collect(),
            hinges: self.hinges.iter().map(|h| Hinge { at: l - h.at, ..*h }).collect(),
            gap,
        }
    }
}

/// Returns the model under another axial compression \[N\].
pub(crate) fn compressed(model: &Model, compression: f64) -> Model {
    let mut model = model.clone();
    model.beam.axial_force = -compression;
    model
}
