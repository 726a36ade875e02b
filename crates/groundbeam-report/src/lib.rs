//! Formats results of [`groundbeam`] for users and programs: pure functions from a result to text.
//!
//! | module | writes |
//! |---|---|
//! | [`text`] | a report for the terminal, at most 80 columns wide |
//! | [`json`] | the result document |
//! | [`csv`] | a table of all fields along the beam, and the history of the iteration |
//! | [`calculation`] | the content of the calculation report; [`html`] writes it as one file |
//! | [`svg`] | one picture of a solution, as SVG or as [PNG](svg::Picture::png) |
//!
//! ```
//! use groundbeam::{Beam, Foundation, Load, Model, Outcome};
//! use groundbeam_report::{Context, Units, text};
//!
//! let model = Model::new(Beam::uniform(12.0, 1.2e9), Foundation::pasternak(40e6, 9e6))
//!     .with_load(Load::point_force(1.0, 600e3))
//!     .with_load(Load::point_force(9.0, 600e3));
//! let Outcome::Equilibrium(solution) = groundbeam::solve(&model)? else { unreachable!() };
//! let context = Context::new(Units::SI).with_title("Strip footing");
//! let report = text::solved(&solution, &context, false);
//! assert!(report.contains("exactly one: the resultant, 1200 kN at x = 5 m, acts"));
//! # Ok::<(), groundbeam::Error>(())
//! ```
//!
//! [`Results`] writes all of these texts from the [`Answers`](groundbeam_run::Answers) to a model file. Functions named
//! `combinations` write envelopes of load combinations. Functions named `trains` write envelopes of
//! [`Passages`](groundbeam_run::Passages).
//!
//! This crate reads no clock, no file and no environment variable. Equal results give equal bytes.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

use groundbeam_file::print::{self as quantity, number};

mod bound;
mod characteristics;
mod checked;
mod combinations;
mod context;
mod curve;
mod digest;
mod extremes;
mod font;
mod load;
mod numbers;
#[cfg(feature = "png")]
mod outline;
mod results;
mod size;
mod study;
mod tone;
mod verdict;
mod verified;

pub mod calculation;
pub mod csv;
pub mod fonts;
#[cfg(feature = "html")]
pub mod html;
pub mod json;
#[cfg(feature = "png")]
pub mod png;
pub mod svg;
pub mod text;

pub use characteristics::{Characteristics, Resultant};
pub use context::Context;
pub use digest::{digest_of_text, model_digest};
pub use groundbeam_file::print::{Kind, RESULT_DIGITS, Units};
pub use load::{load_kind, load_name};
pub use results::Results;
pub use study::{Estimate, Interval, Limit, Spread, Study, Way};
pub use verdict::{sentence, verdict_name};
pub use verified::{LeftOut, ModelOf, Named, Verified};
