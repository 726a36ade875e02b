//! Results of [`groundbeam`] as a person or a program reads them: pure functions from a result to text.
//!
//! | module | makes |
//! |---|---|
//! | [`text`] | a report for the terminal, at most 80 columns wide |
//! | [`json`] | the result document |
//! | [`csv`] | a table of all fields along the beam, and the history of the iteration |
//! | [`calculation`] | the calculation report before it is set in type; [`html`] sets it as one file that prints well |
//! | [`svg`], [`png`] | one picture: the beam on its ground, pressure, moment, shear |
//!
//! ```
//! use groundbeam::{Beam, Foundation, Load, Model, Outcome};
//! use groundbeam_report::{Context, Units, text};
//!
//! let model = Model::new(Beam::uniform(12.0, 1.2e9), Foundation::pasternak(40e6, 9e6))
//!     .with_load(Load::point(600e3, 1.0))
//!     .with_load(Load::point(600e3, 9.0));
//! let Outcome::Equilibrium(solution) = groundbeam::solve(&model)? else { unreachable!() };
//! let context = Context::new(Units::Si).with_title("Strip footing");
//! let report = text::solved(&solution, &context, false);
//! assert!(report.contains("exactly one: the resultant, 1200 kN at x = 5 m, acts"));
//! # Ok::<(), groundbeam::Error>(())
//! ```
//!
//! Of the combinations of load cases, [`Combinations`], the functions named `combinations` make reports, documents and
//! pictures that show the envelope.
//! Of a train that passes, [`Moving`], those named `train` do; of several passages, [`Passages`], those named `trains`.
//!
//! Nothing here reads a clock, a file or the environment, and equal results give equal bytes.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod band;
mod characteristics;
mod combinations;
mod comparison;
mod context;
mod curve;
mod font;
mod found;
mod load;
mod number;
mod outline;
mod quantity;
mod size;
mod study;
mod trains;
mod verdict;

pub mod calculation;
pub mod csv;
pub mod fonts;
pub mod html;
pub mod json;
pub mod png;
pub mod svg;
pub mod text;

pub use band::Banded;
pub use characteristics::{Characteristics, Resultant};
pub use combinations::{Alone, Answer, Combinations, Combined, Overall};
pub use comparison::{Compared, Comparison, Errors};
pub use context::{Context, Factors, Ground};
pub use found::Found;
pub use load::load_name;
pub use quantity::{Kind, Units};
pub use study::{Estimate, Interval, Limit, Spread, Study, Way};
pub use trains::{CheckedTrain, InPassage, Moving, Passages};
pub use verdict::sentence;
