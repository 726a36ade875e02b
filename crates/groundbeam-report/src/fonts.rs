//! The fonts of the pictures, for pages that show pictures.

pub use crate::font::{REGULAR, SEMI_BOLD};
