//! Converts text to outlines, for renderers without fonts.

use crate::font;
use crate::svg::{Anchor, Picture, Text, rounded};
use std::fmt::Write as _;
use ttf_parser::gpos::{PairAdjustment, PositioningSubtable};
use ttf_parser::opentype_layout::Lookup;
use ttf_parser::{Face, GlyphId, OutlineBuilder, Tag};

/// Returns a picture as an SVG file in which each line of text is drawn as outlines.
pub(crate) fn outlined(picture: &Picture) -> String {
    let faces = [font::REGULAR, font::SEMI_BOLD].map(|bytes| Face::parse(bytes, 0).ok());
    let [Some(regular), Some(bold)] = faces else { return picture.to_string() };
    let [regular, bold] = [regular, bold].map(Letters::of);
    picture.written(&|text, svg| if text.style.bold { &bold } else { &regular }.write(text, svg))
}

/// The glyphs of a font face, and their kerning.
struct Letters {
    face: Face<'static>,
    /// Tables of the font with the kerning of pairs of glyphs.
    kerning: Vec<Lookup<'static>>,
}

impl Letters {
    fn of(face: Face<'static>) -> Self {
        let mut kerning = Vec::new();
        if let Some(table) = face.tables().gpos {
            let kern = |index: &u16| {
                let features = table.features.into_iter();
                let mut kern = features.filter(|feature| feature.tag == Tag::from_bytes(b"kern"));
                kern.any(|feature| feature.lookup_indices.into_iter().any(|of| of == *index))
            };
            let which = (0..table.lookups.len()).filter(kern);
            kerning.extend(which.filter_map(|index| table.lookups.get(index)));
        }
        Letters { face, kerning }
    }

    /// Writes a line of text as one shape.
    fn write(&self, text: &Text, out: &mut String) {
        let Text { at, anchor, style, words } = text;
        let [x, y, size] = [at[0], at[1], style.size].map(rounded);
        let scale = size / f64::from(self.face.units_per_em());
        let glyphs: Vec<GlyphId> =
            words.chars().map(|c| self.face.glyph_index(c).unwrap_or(GlyphId(0))).collect();
        let mut places = Vec::with_capacity(glyphs.len());
        let mut width = 0.0;
        for (i, glyph) in glyphs.iter().enumerate() {
            places.push(width);
            width += f64::from(self.face.glyph_hor_advance(*glyph).unwrap_or(0));
            width += glyphs.get(i + 1).map_or(0.0, |next| self.between(*glyph, *next));
        }
        let before = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * width,
            Anchor::End => width,
        };
        out.push_str("<path d=\"");
        for (glyph, place) in glyphs.iter().zip(places) {
            let mut pen = Pen { x: x + scale * (place - before), y, scale, out };
            self.face.outline_glyph(*glyph, &mut pen);
        }
        let _ = write!(out, "\" {style}/>");
    }

    /// Kerning between two adjacent glyphs, which is added to the width of the left glyph.
    fn between(&self, left: GlyphId, right: GlyphId) -> f64 {
        let pair = |subtable: PositioningSubtable| {
            let PositioningSubtable::Pair(pairs) = subtable else { return None };
            let covered = pairs.coverage().get(left)?;
            let (record, _) = match pairs {
                PairAdjustment::Format1 { sets, .. } => sets.get(covered)?.get(right)?,
                PairAdjustment::Format2 { classes, matrix, .. } => {
                    matrix.get((classes.0.get(left), classes.1.get(right)))?
                }
            };
            Some(f64::from(record.x_advance))
        };
        let first = |lookup: &Lookup<'static>| {
            lookup.subtables.into_iter::<PositioningSubtable>().find_map(pair)
        };
        self.kerning.iter().filter_map(first).sum()
    }
}

/// Writes the outline of a glyph as an SVG path.
struct Pen<'a> {
    x: f64,
    y: f64,
    scale: f64,
    out: &'a mut String,
}

impl Pen<'_> {
    fn draw(&mut self, letter: char, points: &[(f32, f32)]) {
        self.out.push(letter);
        for &(x, y) in points {
            let [x, y] = [self.x + self.scale * f64::from(x), self.y - self.scale * f64::from(y)];
            let _ = write!(self.out, "{x:.3} {y:.3} ");
        }
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.draw('M', &[(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.draw('L', &[(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.draw('Q', &[(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.draw('C', &[(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.out.push('Z');
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::test_card;
    use resvg::tiny_skia::{Pixmap, Transform};
    use resvg::usvg::{Options, Tree};

    fn drawn(picture: &str) -> Pixmap {
        let mut options = Options { font_family: "Inter".to_owned(), ..Options::default() };
        for bytes in [font::REGULAR, font::SEMI_BOLD] {
            options.fontdb_mut().load_font_data(bytes.to_vec());
        }
        let tree = Tree::from_str(picture, &options).unwrap();
        let mut pixels = Pixmap::new(600, 240).unwrap();
        resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
        pixels
    }

    /// A renderer with fonts draws the same pixels from text and from outlines. The test covers widths,
    /// anchors, weights, escaped characters and kerning.
    #[test]
    fn outlines_and_rendered_text_have_the_same_pixels() {
        let card = test_card();
        let (words, shapes) = (card.to_string(), outlined(&card));
        assert!(!shapes.contains("<text") && shapes.matches("<path").count() == 4);
        let (words, shapes) = (drawn(&words), drawn(&shapes));
        let apart = words.data().iter().zip(shapes.data()).map(|(a, b)| a.abs_diff(*b));
        let (most, dark) = (apart.max().unwrap(), words.data().iter().min().unwrap());
        assert!(*dark < 60, "nothing is drawn");
        // The coverage of an edge pixel has sixteen steps; a difference of two steps is allowed.
        assert!(most <= 32, "{most} of 255 apart");
    }
}
