//! The fonts that the pictures name, for pages that show pictures.

pub use crate::font::{REGULAR, SEMI_BOLD};
