//! Contains the font of the pictures, and computes the width of text in this font.

use ttf_parser::Face;

/// Inter Regular as a TrueType file; SIL Open Font License 1.1, see `fonts/README.md`.
pub const REGULAR: &[u8] = include_bytes!("../fonts/Inter-Regular.ttf");
/// Inter SemiBold, for headings.
pub const SEMI_BOLD: &[u8] = include_bytes!("../fonts/Inter-SemiBold.ttf");
/// List of font families in the SVG files. A viewer without the font Inter uses a later font of the list.
pub(crate) const FAMILY: &str = "Inter, 'Helvetica Neue', Arial, sans-serif";

/// Assumed width of characters that the font lacks, in ems.
const UNKNOWN: f64 = 1.0;

/// Computes the width of text in the regular weight.
pub(crate) struct Metrics {
    face: Option<Face<'static>>,
}

impl Metrics {
    pub fn new() -> Self {
        Metrics { face: Face::parse(REGULAR, 0).ok() }
    }

    /// Width of a line of text at the given font size.
    pub fn width(&self, text: &str, size: f64) -> f64 {
        size * text.chars().map(|c| self.advance(c)).sum::<f64>()
    }

    fn advance(&self, c: char) -> f64 {
        let known = self.face.as_ref().and_then(|face| {
            let advance = face.glyph_hor_advance(face.glyph_index(c)?)?;
            Some(f64::from(advance) / f64::from(face.units_per_em()))
        });
        known.unwrap_or(UNKNOWN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_contains_the_symbols_of_mechanics() {
        for bytes in [REGULAR, SEMI_BOLD] {
            let face = Face::parse(bytes, 0).unwrap();
            for c in "0123456789.,−-+×·±²³⁴₀√βμµλθ→↑↓≤≥äéñß’–…[]()".chars()
            {
                assert!(face.glyph_index(c).is_some(), "{c}");
            }
        }
        let metrics = Metrics::new();
        let width = metrics.width("600 kN", 12.0);
        assert!(width > 36.0 && width < 46.0, "{width}");
    }
}
