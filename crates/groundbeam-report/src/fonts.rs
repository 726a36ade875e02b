//! Exports the fonts of the pictures to web pages that show pictures.

pub use crate::font::{REGULAR, SEMI_BOLD};
