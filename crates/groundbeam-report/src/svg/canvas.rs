//! Collects the shapes and the lines of text of a drawing, and writes the drawing as SVG.

use super::paint::{Colour, Fill, Paint, number};
use crate::font;
use std::fmt::{self, Display, Formatter, Write};

/// Alignment of a line of text relative to its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// Size, weight and colour of text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Style {
    pub size: f64,
    pub bold: bool,
    pub(super) colour: Colour,
    /// Whether the letters have a pale outline, so that text on top of drawn lines is readable.
    pub(super) rim: bool,
}

impl Style {
    pub(super) const fn new(size: f64, bold: bool, colour: Colour) -> Self {
        Style { size, bold, colour, rim: false }
    }
}

/// Writes the outline and the fill colour of the letters as SVG attributes.
impl Display for Style {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.rim {
            write!(f, "paint-order=\"stroke\" stroke=\"{}\" ", Colour::Paper)?;
            f.write_str("stroke-opacity=\"0.8\" stroke-width=\"2.5\" ")?;
        }
        Fill::new(self.colour).fmt(f)
    }
}

/// A line of text; `at` is a point of its baseline.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Text {
    pub at: [f64; 2],
    pub anchor: Anchor,
    pub style: Style,
    pub words: String,
}

/// Writes the text as an SVG text element, for a renderer with fonts.
impl Display for Text {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [x, y] = self.at.map(number);
        let size = number(self.style.size);
        let weight = if self.style.bold { " font-weight=\"600\"" } else { "" };
        let anchor = match self.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        write!(f, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{weight}{anchor} ")?;
        write!(f, "{}>{}</text>", self.style, escaped(&self.words))
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Line([[f64; 2]; 2]),
    Rect { corner: [f64; 2], size: [f64; 2] },
    Circle { centre: [f64; 2], radius: f64 },
    Polyline { points: Vec<[f64; 2]>, closed: bool },
    Arc { ends: [[f64; 2]; 2], radius: f64, clockwise: bool },
}

/// Writes the name of the SVG element and its coordinates.
impl Display for Shape {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Shape::Line([from, to]) => {
                let ([x1, y1], [x2, y2]) = (from.map(number), to.map(number));
                write!(f, "line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"")
            }
            Shape::Rect { corner, size } => {
                let ([x, y], [width, height]) = (corner.map(number), size.map(number));
                write!(f, "rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"")
            }
            Shape::Circle { centre, radius } => {
                let ([x, y], radius) = (centre.map(number), number(*radius));
                write!(f, "circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"")
            }
            Shape::Polyline { points, closed } => {
                f.write_str("path d=\"")?;
                for (i, point) in points.iter().enumerate() {
                    let [x, y] = point.map(number);
                    write!(f, "{}{x} {y}", if i == 0 { "M" } else { "L" })?;
                }
                f.write_str(if *closed { "Z\"" } else { "\"" })
            }
            Shape::Arc { ends: [from, to], radius, clockwise } => {
                let ([x1, y1], [x2, y2]) = (from.map(number), to.map(number));
                let (r, sweep) = (number(*radius), u8::from(*clockwise));
                write!(f, "path d=\"M{x1} {y1}A{r} {r} 0 0 {sweep} {x2} {y2}\"")
            }
        }
    }
}

/// Attributes of a group of elements.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Group {
    /// The group is shifted downward by this distance.
    Down(f64),
    Ground,
    /// A beam that a web page can animate, with the SVG transform of the beam to its unloaded position. `None` for
    /// a beam with hinges.
    Moves(Option<String>),
}

impl Display for Group {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Group::Down(dy) => write!(f, "transform=\"translate(0 {})\"", number(*dy)),
            Group::Ground => f.write_str("class=\"ground\""),
            Group::Moves(None) => f.write_str("class=\"moves\""),
            Group::Moves(Some(still)) => write!(f, "class=\"moves\" data-still=\"{still}\""),
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Element {
    Shape(Shape, Paint),
    Text(Text),
    Group(Group, Vec<Element>),
}

/// A drawing in its own coordinates.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    elements: Vec<Element>,
    /// The y coordinates of the highest and the lowest point of the drawing.
    reach: Option<[f64; 2]>,
}

impl Canvas {
    pub fn new() -> Self {
        Canvas::default()
    }

    /// The y coordinates of the highest and the lowest point of the drawing.
    pub fn reach(&self) -> [f64; 2] {
        self.reach.unwrap_or([0.0, 0.0])
    }

    /// Extends the drawing to the coordinate `y` without drawing anything.
    pub fn reserve(&mut self, y: f64) {
        let [top, bottom] = self.reach.unwrap_or([y, y]);
        self.reach = Some([top.min(y), bottom.max(y)]);
    }

    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], paint: impl Into<Paint>) {
        self.reserve(from[1]);
        self.reserve(to[1]);
        self.shape(Shape::Line([from, to]), paint);
    }

    pub fn rect(&mut self, corner: [f64; 2], size: [f64; 2], paint: impl Into<Paint>) {
        self.reserve(corner[1]);
        self.reserve(corner[1] + size[1]);
        self.shape(Shape::Rect { corner, size }, paint);
    }

    pub fn dot(&mut self, centre: [f64; 2], radius: f64, paint: impl Into<Paint>) {
        self.reserve(centre[1]);
        self.shape(Shape::Circle { centre, radius }, paint);
    }

    /// Draws straight lines between points.
    pub fn polyline(&mut self, points: &[[f64; 2]], closed: bool, paint: impl Into<Paint>) {
        points.iter().for_each(|point| self.reserve(point[1]));
        self.shape(Shape::Polyline { points: points.to_vec(), closed }, paint);
    }

    /// Draws the shorter arc of a circle between two points. The extent of the drawing does not include the
    /// arc.
    pub fn arc(
        &mut self,
        ends: [[f64; 2]; 2],
        radius: f64,
        clockwise: bool,
        paint: impl Into<Paint>,
    ) {
        self.shape(Shape::Arc { ends, radius, clockwise }, paint);
    }

    fn shape(&mut self, shape: Shape, paint: impl Into<Paint>) {
        self.elements.push(Element::Shape(shape, paint.into()));
    }

    /// Adds a line of text; `at` is a point of its baseline.
    pub fn text(&mut self, at: [f64; 2], anchor: Anchor, style: Style, words: &str) {
        if words.is_empty() {
            return;
        }
        self.reserve(at[1] - style.size);
        self.reserve(at[1] + 0.3 * style.size);
        self.elements.push(Element::Text(Text { at, anchor, style, words: words.to_owned() }));
    }

    /// Adds another drawing, shifted downward by `dy`.
    pub fn place(&mut self, other: Canvas, dy: f64) {
        self.add(other, Group::Down(dy), dy);
    }

    /// Adds another drawing as a group with its own attributes.
    pub fn group(&mut self, other: Canvas, group: Group) {
        self.add(other, group, 0.0);
    }

    fn add(&mut self, other: Canvas, group: Group, dy: f64) {
        let [top, bottom] = other.reach();
        self.reserve(top + dy);
        self.reserve(bottom + dy);
        self.elements.push(Element::Group(group, other.elements));
    }

    /// Returns the complete picture, whose upper edge is at y = 0.
    pub fn finish(self, width: f64, height: f64, title: &str) -> Picture {
        Picture { elements: self.elements, size: [width, height], title: title.to_owned() }
    }
}

/// A finished picture. Its `Display` is an SVG file with text elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    elements: Vec<Element>,
    size: [f64; 2],
    title: String,
}

impl Picture {
    /// Returns the picture as an SVG file; the function `text` writes each line of text.
    pub(crate) fn written(&self, text: &dyn Fn(&Text, &mut String)) -> String {
        let [width, height] = self.size.map(number);
        let mut svg = format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="{family}" stroke-linejoin="round">
<title>{title}</title>
<rect width="{width}" height="{height}" {paper}/>
"##,
            family = font::FAMILY,
            title = escaped(&self.title),
            paper = Fill::new(Colour::Paper),
        );
        write_all(&self.elements, text, &mut svg);
        svg + "</svg>\n"
    }
}

impl Display for Picture {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written(&|text, svg| {
            let _ = write!(svg, "{text}");
        }))
    }
}

// Writes elements as SVG. Writing to a `String` cannot fail.
fn write_all(elements: &[Element], text: &dyn Fn(&Text, &mut String), svg: &mut String) {
    for element in elements {
        match element {
            Element::Shape(shape, paint) => {
                let _ = write!(svg, "<{shape} {paint}/>");
            }
            Element::Text(line) => text(line, svg),
            Element::Group(group, elements) => {
                let _ = writeln!(svg, "<g {group}>");
                write_all(elements, text, svg);
                svg.push_str("</g>");
            }
        }
        svg.push('\n');
    }
}

/// Escapes text for XML.
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

/// Replaces every hyphen before a digit by a true minus sign. Other hyphens, as in the unit kip-ft, remain.
pub(super) fn printed(words: &str) -> String {
    let mut printed = String::with_capacity(words.len());
    let mut letters = words.chars().peekable();
    while let Some(letter) = letters.next() {
        let is_minus = letter == '-' && letters.peek().is_some_and(char::is_ascii_digit);
        printed.push(if is_minus { '\u{2212}' } else { letter });
    }
    printed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_for_xml() {
        assert_eq!(escaped("a < b & c"), "a &lt; b &amp; c");
        assert_eq!(printed("-1.5e-3 kip-ft"), "−1.5e−3 kip-ft");
    }
}
