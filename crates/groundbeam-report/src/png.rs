//! Renders pictures as PNG.

use crate::outline::outlined;
use crate::svg::Picture;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::fmt;

/// Pixels per unit of the SVG picture.
const PIXELS: f32 = 2.0;

/// Reason why a picture cannot be rendered.
#[derive(Debug)]
pub struct Error(String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the picture could not be drawn: {}", self.0)
    }
}

impl std::error::Error for Error {}

impl Picture {
    /// Returns the picture as the bytes of a PNG file, with two pixels for one unit of length of the SVG file.
    ///
    /// # Errors
    ///
    /// Returns an error if there is not enough memory.
    pub fn png(&self) -> Result<Vec<u8>, Error> {
        let tree = Tree::from_str(&outlined(self), &Options::default());
        let tree = tree.map_err(|error| Error(error.to_string()))?;
        let size = tree.size();
        let [width, height] =
            [size.width(), size.height()].map(|side| (side * PIXELS).ceil() as u32);
        let lacking = || Error(format!("{width} × {height} pixels"));
        let mut pixels = Pixmap::new(width, height).ok_or_else(lacking)?;
        resvg::render(&tree, Transform::from_scale(PIXELS, PIXELS), &mut pixels.as_mut());
        pixels.encode_png().map_err(|error| Error(error.to_string()))
    }
}
