//! SVG, written by hand: shapes and words, and how far up and down they reach.

use crate::font;
use std::fmt::Write;

/// How a line of text stands to its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Size, weight and colour of text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Style {
    pub size: f64,
    pub bold: bool,
    pub colour: &'static str,
    /// Whether the words keep a pale rim, to be read across lines.
    pub rim: bool,
}

/// Drawn under the letters.
const RIM: &str =
    r##" paint-order="stroke" stroke="#ffffff" stroke-opacity="0.8" stroke-width="2.5""##;

/// A drawing in coordinates of its own.
#[derive(Debug, Clone, Default)]
pub(super) struct Canvas {
    body: String,
    /// The highest and the lowest point of what was drawn.
    reach: Option<[f64; 2]>,
}

impl Canvas {
    pub fn new() -> Self {
        Canvas::default()
    }

    /// How far up and down the drawing reaches.
    pub fn reach(&self) -> [f64; 2] {
        self.reach.unwrap_or([0.0, 0.0])
    }

    /// Makes room that nothing is drawn in.
    pub fn reserve(&mut self, y: f64) {
        let [top, bottom] = self.reach.unwrap_or([y, y]);
        self.reach = Some([top.min(y), bottom.max(y)]);
    }

    pub fn line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], attributes: &str) {
        self.reserve(y1);
        self.reserve(y2);
        let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(number);
        self.element(&format!(r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" {attributes}/>"#));
    }

    pub fn rect(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], attributes: &str) {
        self.reserve(y);
        self.reserve(y + height);
        let [x, y, width, height] = [x, y, width, height].map(number);
        self.element(&format!(
            r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" {attributes}/>"#
        ));
    }

    pub fn dot(&mut self, [x, y]: [f64; 2], radius: f64, attributes: &str) {
        self.reserve(y);
        let [x, y, radius] = [x, y, radius].map(number);
        self.element(&format!(r#"<circle cx="{x}" cy="{y}" r="{radius}" {attributes}/>"#));
    }

    /// Straight lines from point to point.
    pub fn polyline(&mut self, points: &[[f64; 2]], closed: bool, attributes: &str) {
        let mut path = String::new();
        for (i, &[x, y]) in points.iter().enumerate() {
            self.reserve(y);
            // Writing to a String cannot fail.
            let _ = write!(path, "{}{} {}", if i == 0 { "M" } else { "L" }, number(x), number(y));
        }
        if closed {
            path.push('Z');
        }
        self.path(&path, attributes);
    }

    /// A path in SVG's own letters, whose reach is not looked at.
    pub fn path(&mut self, path: &str, attributes: &str) {
        self.element(&format!(r#"<path d="{path}" {attributes}/>"#));
    }

    /// A line of text on the baseline y.
    pub fn text(&mut self, [x, y]: [f64; 2], anchor: Anchor, style: Style, words: &str) {
        if words.is_empty() {
            return;
        }
        self.reserve(y - style.size);
        self.reserve(y + 0.3 * style.size);
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let weight = if style.bold { r#" font-weight="600""# } else { "" };
        let rim = if style.rim { RIM } else { "" };
        let (size, colour) = (number(style.size), style.colour);
        let ([x, y], words) = ([x, y].map(number), escaped(words));
        self.element(&format!(
            r#"<text x="{x}" y="{y}" font-size="{size}"{weight}{anchor}{rim} fill="{colour}">{words}</text>"#
        ));
    }

    /// Another drawing, moved down by `dy`.
    pub fn place(&mut self, other: &Canvas, dy: f64) {
        let [top, bottom] = other.reach();
        self.reserve(top + dy);
        self.reserve(bottom + dy);
        let _ = writeln!(self.body, r#"<g transform="translate(0 {})">"#, number(dy));
        self.body.push_str(&other.body);
        self.body.push_str("</g>\n");
    }

    /// Another drawing as one group that has attributes of its own.
    pub fn group(&mut self, other: &Canvas, attributes: &str) {
        let [top, bottom] = other.reach();
        self.reserve(top);
        self.reserve(bottom);
        let _ = writeln!(self.body, "<g {attributes}>");
        self.body.push_str(&other.body);
        self.body.push_str("</g>\n");
    }

    /// The whole file, from y = 0.
    pub fn finish(self, width: f64, height: f64, title: &str) -> String {
        let [width, height] = [width, height].map(number);
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="{family}" stroke-linejoin="round">
<title>{title}</title>
<rect width="{width}" height="{height}" fill="#ffffff"/>
{body}</svg>
"##,
            family = font::FAMILY,
            title = escaped(title),
            body = self.body
        )
    }

    fn element(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }
}

/// Hundredths of a unit are finer than any screen.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Text within XML, with the minus sign that print has.
fn escaped(words: &str) -> String {
    let mut escaped = String::with_capacity(words.len());
    for c in words.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            c => escaped.push(c),
        }
    }
    escaped
}

/// A number as print has it, with a true minus sign.
pub(super) fn printed(number: &str) -> String {
    number.replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_words() {
        assert_eq!(number(-0.001), "0");
        assert_eq!(number(12.50), "12.5");
        assert_eq!(number(100.0), "100");
        assert_eq!(escaped("a < b & c"), "a &lt; b &amp; c");
        assert_eq!(printed("-1.5e-3"), "−1.5e−3");
    }
}
