//! Chooses the positions of trains that move over a beam, and computes the envelope of the results over all positions.

mod edges;
mod free_spans;
mod interval;
mod passage;
mod position;
mod sweep;

pub(crate) use edges::checked;
pub use free_spans::{FreeSpans, Opened};
pub(crate) use passage::Swept;
pub use passage::{Located, Passage, Reach, Uplift};
pub(crate) use sweep::{ERROR, Sweep};
