//! Writes numbers, colours, fills and strokes as SVG attributes, and the colours of a dark page as a style sheet.

use std::fmt::{self, Display, Formatter};

/// Writes a number for a picture, rounded to hundredths of a unit.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The value rounded to hundredths, as [`number`] writes it.
#[cfg(feature = "png")]
pub(crate) fn rounded(value: f64) -> f64 {
    number(value).parse().unwrap_or(value)
}

/// A colour of the pictures. The colours of fields and loads can be distinguished with any kind of colour
/// vision (Okabe and Ito).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Colour {
    Paper,
    Ink,
    FaintInk,
    Rule,
    /// Colour of the lines behind a diagram.
    FaintRule,
    Beam,
    Ground,
    GroundLine,
    Gap,
    Load,
    Pressure,
    Moment,
    Shear,
    /// Colour of the point contact forces in the diagram of the pressure.
    Force,
}

/// For each colour, its value on white paper and its value on a dark page.
const SHADES: [(Colour, &str, &str); 14] = [
    (Colour::Paper, "#ffffff", "#171b20"),
    (Colour::Ink, "#1f2328", "#e4e8ec"),
    (Colour::FaintInk, "#646c75", "#a2abb5"),
    (Colour::Rule, "#d5d9de", "#3f4751"),
    (Colour::FaintRule, "#eceef1", "#262c33"),
    (Colour::Beam, "#3d444d", "#c3cad2"),
    (Colour::Ground, "#efe6d8", "#3a3226"),
    (Colour::GroundLine, "#8a7453", "#b59a72"),
    (Colour::Gap, "#b9dff5", "#1e4a66"),
    (Colour::Load, "#b34700", "#ff9a57"),
    (Colour::Pressure, "#0072b2", "#56b4e9"),
    (Colour::Moment, "#d55e00", "#f08a3c"),
    (Colour::Shear, "#00805e", "#35c39a"),
    (Colour::Force, "#00395c", "#9ed4f5"),
];

impl Display for Colour {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(SHADES[*self as usize].1)
    }
}

/// Style sheet that gives the pictures inside an element the colours of a dark page. `within` is the CSS
/// selector of this element.
pub fn dark_style(within: &str) -> String {
    let rule = |(_, light, dark): &(Colour, &str, &str)| {
        ["fill", "stroke"]
            .map(|paint| format!("{within} [{paint}=\"{light}\"] {{ {paint}: {dark}; }}\n"))
    };
    SHADES.iter().flat_map(rule).collect()
}

/// The fill of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fill {
    colour: Option<Colour>,
    opacity: f64,
}

impl Fill {
    pub const NONE: Fill = Fill { colour: None, opacity: 1.0 };

    pub const fn new(colour: Colour) -> Self {
        Fill { colour: Some(colour), opacity: 1.0 }
    }

    pub const fn with_opacity(self, opacity: f64) -> Self {
        Fill { opacity, ..self }
    }

    /// The fill with an outline.
    pub const fn and(self, stroke: Stroke) -> Paint {
        Paint { fill: Some(self), stroke: Some(stroke) }
    }
}

impl Display for Fill {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write_colour(f, "fill", self.colour)?;
        write_opacity(f, "fill-opacity", self.opacity)
    }
}

/// A line or an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    colour: Option<Colour>,
    width: f64,
    /// Lengths of a dash and of the space after it.
    dashes: Option<[f64; 2]>,
    opacity: f64,
    /// Whether the line states explicitly that its ends are butt ends, which are the default of SVG.
    is_cut: bool,
}

impl Stroke {
    pub const NONE: Stroke =
        Stroke { colour: None, width: 0.0, dashes: None, opacity: 1.0, is_cut: false };

    pub const fn new(colour: Colour, width: f64) -> Self {
        Stroke { colour: Some(colour), width, ..Stroke::NONE }
    }

    pub const fn dashed(self, dash: f64, space: f64) -> Self {
        Stroke { dashes: Some([dash, space]), ..self }
    }

    pub const fn with_opacity(self, opacity: f64) -> Self {
        Stroke { opacity, ..self }
    }

    pub const fn cut(self) -> Self {
        Stroke { is_cut: true, ..self }
    }
}

impl Display for Stroke {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write_colour(f, "stroke", self.colour)?;
        if self.colour.is_none() {
            return Ok(());
        }
        write!(f, " stroke-width=\"{}\"", number(self.width))?;
        if let Some([dash, space]) = self.dashes {
            write!(f, " stroke-dasharray=\"{dash} {space}\"")?;
        }
        write_opacity(f, "stroke-opacity", self.opacity)?;
        f.write_str(if self.is_cut { " stroke-linecap=\"butt\"" } else { "" })
    }
}

fn write_colour(f: &mut Formatter<'_>, name: &str, colour: Option<Colour>) -> fmt::Result {
    match colour {
        Some(colour) => write!(f, "{name}=\"{colour}\""),
        None => write!(f, "{name}=\"none\""),
    }
}

fn write_opacity(f: &mut Formatter<'_>, name: &str, value: f64) -> fmt::Result {
    if value == 1.0 { Ok(()) } else { write!(f, " {name}=\"{value}\"") }
}

/// Fill and outline of a shape. If the fill or the outline is `None`, the default of SVG applies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Paint {
    fill: Option<Fill>,
    stroke: Option<Stroke>,
}

impl From<Fill> for Paint {
    fn from(fill: Fill) -> Self {
        Paint { fill: Some(fill), stroke: None }
    }
}

impl From<Stroke> for Paint {
    fn from(stroke: Stroke) -> Self {
        Paint { fill: None, stroke: Some(stroke) }
    }
}

impl Display for Paint {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match (self.fill, self.stroke) {
            (Some(fill), Some(stroke)) => write!(f, "{fill} {stroke}"),
            (Some(fill), None) => fill.fmt(f),
            (None, Some(stroke)) => stroke.fmt(f),
            (None, None) => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_at_most_two_decimals() {
        assert_eq!(number(-0.001), "0");
        assert_eq!(number(12.50), "12.5");
        assert_eq!(number(100.0), "100");
        assert_eq!(number(1.0 / 3.0), "0.33");
    }

    #[test]
    fn fill_and_stroke_are_written_as_svg_attributes() {
        let dashes = Stroke::new(Colour::Load, 1.4).dashed(4.0, 3.0);
        assert_eq!(
            Fill::NONE.and(dashes).to_string(),
            "fill=\"none\" stroke=\"#b34700\" stroke-width=\"1.4\" stroke-dasharray=\"4 3\""
        );
        let area = Fill::new(Colour::Pressure).with_opacity(0.14).and(Stroke::NONE);
        assert_eq!(area.to_string(), "fill=\"#0072b2\" fill-opacity=\"0.14\" stroke=\"none\"");
    }

    #[test]
    fn every_colour_has_its_own_light_and_dark_shade() {
        for (i, (colour, light, dark)) in SHADES.iter().enumerate() {
            assert_eq!(*colour as usize, i);
            let others = SHADES.iter().skip(i + 1);
            assert!(others.into_iter().all(|(_, l, d)| l != light && d != dark), "{colour:?}");
        }
        let style = dark_style("#drawing");
        assert!(style.contains("#drawing [stroke=\"#00805e\"] { stroke: #35c39a; }\n"));
    }
}
