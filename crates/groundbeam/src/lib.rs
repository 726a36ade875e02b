//! groundbeam: beams on ground that can only push back.
pub mod model;
pub use model::{
    Beam, BeamSegment, Foundation, FoundationSegment, GapPoint, Load, Model, Support, SupportKind,
};
mod chain;
mod contact;
mod elements;
mod ground;
mod mesh;
mod polynomial;
