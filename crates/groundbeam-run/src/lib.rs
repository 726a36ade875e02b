//! Solves all models that a model file defines.
//!
//! A [`Run`] contains one model, all combinations, or trains that move over the beam under them. [`Run::solve`] returns
//! [`Answers`]. [`Run::check`] only decides whether an equilibrium exists. [`Run::compare`] solves one model with every
//! method.
//!
//! The [`Host`] provides threads, a clock and a display of progress. The answers do not depend on the host.
//!
//! ```
//! use groundbeam_run::{OneThread, Run};
//!
//! let text = "[beam]\nlength = 12\nEI = 1.2e9\n[foundation]\nk = 40e6\n
//!     [[load]]\npoint = 6e5\nat = 4\ncase = 'G'\n
//!     [[load]]\npoint = 6e5\nat = 8\ncase = 'Q'\n
//!     [[combination]]\nname = 'both'\nfactors = { G = 1.35, Q = 1.5 }\n
//!     [[combination]]\nname = 'G alone'\nfactors = { G = 1 }\n";
//! let document = groundbeam_file::parse(text)?;
//! let answers = Run::of(&document).solve(&OneThread).unwrap();
//! let names: Vec<&str> = answers.list.iter().map(|answer| answer.name()).collect();
//! assert_eq!(names, ["both", "G alone"]);
//! assert_eq!(answers.solved().count(), 2);
//! # Ok::<(), groundbeam_file::Diagnostics>(())
//! ```

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod answer;
mod answers;
mod band;
mod comparison;
mod growing;
mod host;
mod run;
mod single;
mod trains;

pub use answer::{Answer, Found, Ground, Label, Overall, Placed};
pub use answers::{Alone, Answers, Asked, InPassage, Passages};
pub use band::{BEST, Banded};
pub use comparison::{Compare, Errors};
pub use growing::{Factors, Growing};
pub use host::{Failed, Host, OneThread};
pub use run::Run;
pub use trains::{FreeSpans, Located, Opened, Passage, Reach, Uplift};
