//! Reads `section = { … }`: computes area, second moment and shear area of a cross-section from its dimensions.
//!
//! The shear area is A/F with the form factor F of Young, Budynas and Sadegh, *Roark's Formulas for Stress and Strain*,
//! 8th ed., section 8.10. For a box, an I or a T, it is the area of the webs between the flanges.

use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_WIDTH, Table, Value, Words, key, text, word};
use crate::profile::Along;
use crate::profiles::{self, RolledSection};
use crate::quantity::{SECOND_MOMENT_OF_AREA, WIDTH};
use crate::reader::Reader;
use crate::table::Section;
use crate::units::Seen;
use groundbeam::model::Profile;
use std::f64::consts::PI;
use std::ops::Range;

static SHAPES: Words = Words {
    all: || KINDS.iter().map(|kind| kind.name).chain(["rectangle"]).collect(),
    also: &[],
    message: "`{}` is not a section shape",
    hint: "shapes: {}",
};

const SIDE: Value = Value::Along(&WIDTH, 2);

/// Keys of all shapes.
pub(super) static TABLE: Table = Table {
    name: "section",
    keys: &[
        word("shape", &SHAPES, "The shape; default: a rectangle of `width` and `height`."),
        key("width", SIDE, "The width of a rectangle, box, I-section or T-section.")
            .also(ALSO_WIDTH),
        key("height", SIDE, "The height of a rectangle, box, I-section or T-section.")
            .also(&["h", "d", "depth"]),
        key("diameter", SIDE, "The diameter of a circle or tube."),
        key("wall", SIDE, "The wall thickness of a tube or box."),
        key("flange", SIDE, "The flange thickness of an I-section or a T-section."),
        key("web", SIDE, "The web thickness of an I-section or a T-section."),
        key(
            "fillet",
            SIDE,
            "The fillet radius between web and flanges of an I-section; default: 0.",
        ),
        text("name", "IPE 300", "A rolled section: IPE, HEA, HEB, HEM, UB, UC, W, CHS, SHS, RHS.")
            .also(&["profile", "designation"]),
        text("rail", "60E1", "A rolled rail: `60E1`, `UIC60`, `136RE` and others."),
    ],
};

/// Properties of a cross-section.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    pub inertia: Along,
    pub area: Along,
    /// Shear area, if known.
    pub shear_area: Option<Along>,
    /// Distance from the lower to the upper face, if known.
    pub depth: Option<Along>,
}

impl Shape {
    fn constant([area, inertia, shear_area]: [f64; 3], span: Range<usize>) -> Self {
        let along = |value| Along { profile: Profile::constant(value), span: span.clone() };
        let shear_area = Some(along(shear_area));
        Shape { inertia: along(inertia), area: along(area), shear_area, depth: None }
    }

    fn unreadable(span: Range<usize>) -> Self {
        let unknown = Some(Along::unreadable(span.clone()));
        Shape { depth: unknown, ..Shape::constant([f64::NAN; 3], span) }
    }

    /// Returns the section properties on the part of their stretch between two fractions of the stretch's length.
    pub fn between(&self, way: [f64; 2]) -> Self {
        Shape {
            inertia: self.inertia.between(way),
            area: self.area.between(way),
            shear_area: self.shear_area.as_ref().map(|area| area.between(way)),
            depth: self.depth.as_ref().map(|depth| depth.between(way)),
        }
    }
}

/// A shape of a section. `measure` computes \[A, I, shear area\] from the dimensions, or returns the
/// dimension that is too large for the other dimensions.
struct Kind {
    name: &'static str,
    sides: &'static [&'static str],
    measure: fn(&[f64]) -> Result<[f64; 3], &'static str>,
    /// Whether the areas are polynomials of degree 2 in the dimensions, and the second moment of area I a polynomial of degree 4.
    is_polynomial: bool,
}

const KINDS: [Kind; 5] = [
    Kind {
        name: "circle",
        sides: &["diameter"],
        measure: |d| {
            let area = PI * d[0].powi(2) / 4.0;
            Ok([area, PI * d[0].powi(4) / 64.0, 0.9 * area])
        },
        is_polynomial: true,
    },
    Kind {
        name: "tube",
        sides: &["diameter", "wall"],
        measure: |s| {
            let [outer, inner] = [s[0], s[0] - 2.0 * s[1]];
            let ring = |power| outer.powi(power) - inner.powi(power);
            let area = PI * ring(2) / 4.0;
            fits(inner, "wall").map(|()| [area, PI * ring(4) / 64.0, 0.5 * area])
        },
        is_polynomial: true,
    },
    Kind {
        name: "box",
        sides: &["width", "height", "wall"],
        measure: |s| {
            let [b, h] = [s[0] - 2.0 * s[2], s[1] - 2.0 * s[2]];
            let inertia = (s[0] * s[1].powi(3) - b * h.powi(3)) / 12.0;
            fits(b.min(h), "wall").map(|()| [s[0] * s[1] - b * h, inertia, 2.0 * s[2] * h])
        },
        is_polynomial: true,
    },
    Kind {
        name: "I",
        sides: &["width", "height", "flange", "web"],
        measure: |s| {
            let [width, height, web] = [s[0], s[1], s[3]];
            let between = height - 2.0 * s[2];
            fits(between, "flange")?;
            fits(width - web, "web")?;
            let fillet = s.get(4).copied().unwrap_or(0.0);
            if fillet > 0.0 {
                fits((0.5 * between).min(0.5 * (width - web)) - fillet, "fillet")?;
            }
            let [corners, steiner] = profiles::fillets(fillet, 0.5 * between, -1.0);
            let area = width * height - (width - web) * between + corners;
            let inertia = (width * height.powi(3) - (width - web) * between.powi(3)) / 12.0;
            Ok([area, inertia + steiner, web * between])
        },
        is_polynomial: true,
    },
    Kind {
        name: "T",
        sides: &["width", "height", "flange", "web"],
        measure: |s| {
            let [width, height, flange, web] = [s[0], s[1], s[2], s[3]];
            let stem = height - flange;
            fits(stem, "flange")?;
            fits(width - web, "web")?;
            let (plate, leg) = (width * flange, web * stem);
            // Distance between the centroids of flange and stem: half the height.
            let apart = 0.5 * height;
            let own = (width * flange.powi(3) + web * stem.powi(3)) / 12.0;
            let inertia = own + plate * leg / (plate + leg) * apart * apart;
            Ok([plate + leg, inertia, leg])
        },
        is_polynomial: false,
    },
];

fn fits(room: f64, side: &'static str) -> Result<(), &'static str> {
    if room <= 0.0 { Err(side) } else { Ok(()) }
}

/// Reads the cross-section that `table` gives, if any.
pub(super) fn read(reader: &mut Reader, table: &Section) -> Option<Shape> {
    let Some(section) = reader.open(table, "section") else {
        // If `section` is not a table, this error has been reported already. A placeholder for the cross-section is
        // returned, so that I is not reported as missing too.
        return table.value("section").map(|value| Shape::unreadable(value.span()));
    };
    if section.value("rail").is_some() {
        return Some(named(reader, &section, "rail", profiles::find_rail));
    }
    if section.value("name").is_some() {
        return Some(named(reader, &section, "name", profiles::find));
    }
    let Some(name) = reader.word(&section, "shape") else {
        return Some(match section.value("shape") {
            Some(_) => Shape::unreadable(section.span),
            None => rectangle(reader, &section),
        });
    };
    Some(match KINDS.iter().find(|kind| kind.name == name) {
        Some(kind) => by_sides(reader, &section, kind),
        None => rectangle(reader, &section),
    })
}

/// Computes the area b h and the second moment of area b h³/12 of a rectangle with the width b and the height h. Both
/// dimensions may vary linearly.
fn rectangle(reader: &mut Reader, section: &Section) -> Shape {
    reader.refuse_all_but(section, &["shape", "width", "height"]);
    let [width, height] = ["width", "height"].map(|key| side(reader, section, key));
    let span = section.span.clone();
    if width.profile.is_constant() && height.profile.is_constant() {
        let [b, h] = [width.profile.start(), height.profile.start()];
        let shape = Shape::constant([b * h, b * h.powi(3) / 12.0, b * h / 1.2], span);
        return Shape { depth: Some(height), ..shape };
    }
    let area = width.times(&height, &span);
    let cubed = [&height; 3].into_iter().fold(width, |a, b| a.times(b, &span));
    let inertia = Along { profile: cubed.profile.scaled(1.0 / 12.0), span: span.clone() };
    let shear_area = Some(Along { profile: area.profile.scaled(1.0 / 1.2), span });
    Shape { inertia, area, shear_area, depth: Some(height) }
}

/// Computes a shape from its dimensions, each of which may vary linearly.
fn by_sides(reader: &mut Reader, section: &Section, kind: &Kind) -> Shape {
    let fillet = (kind.name == "I").then_some("fillet");
    let keys = ["shape"].into_iter().chain(kind.sides.iter().copied()).chain(fillet);
    reader.refuse_all_but(section, &keys.collect::<Vec<&str>>());
    let side = |key: &&'static str| side(reader, section, key);
    let mut sides: Vec<Along> = kind.sides.iter().map(side).collect();
    if let Some(given) = fillet.and_then(|key| reader.along(section, key)) {
        // A fillet radius of zero, which is the default, means no fillet.
        if given.profile != Profile::constant(0.0) {
            sides.push(reader.positive_along("fillet", given));
        }
    }
    let span = section.span.clone();
    if let Some(varies) = sides.iter().find(|side| !side.profile.is_constant())
        && !kind.is_polynomial
    {
        let message =
            format!("the dimensions of the shape `{}` cannot vary along a segment", kind.name);
        let hint = "its I is not a polynomial of them: give a [[beam.segment]] for each of several parts, \
                    or the control values of `EI`";
        reader.report(Fault::new(code::MISPLACED, varies.span.clone(), message, "", hint));
        return Shape::unreadable(span);
    }
    let at = |t: f64| {
        let sides: Vec<f64> = sides.iter().map(|side| side.profile.at(t)).collect();
        (kind.measure)(&sides)
    };
    let measures: Result<Vec<[f64; 3]>, &str> = QUARTERS.into_iter().map(at).collect();
    let measures = match measures {
        Ok(measures) => measures,
        Err(side) => {
            let at = section.value(side).map_or(span.clone(), |value| value.span());
            let message = format!("`{side}` is too large for this section");
            let hint = format!("the dimensions of the shape `{}` are outer dimensions", kind.name);
            reader.report(Fault::new(code::FACTOR, at, message, "", hint));
            return Shape::unreadable(span);
        }
    };
    let high = kind.sides.iter().position(|key| ["height", "diameter"].contains(key));
    let depth = high.map(|i| sides[i].clone());
    if sides.iter().all(|side| side.profile.is_constant()) {
        return Shape { depth, ..Shape::constant(measures[0], span) };
    }
    let [area, inertia, shear] = [0, 1, 2].map(|i| [0, 1, 2, 3, 4].map(|t| measures[t][i]));
    let along = |profile| Along { profile, span: span.clone() };
    let shear_area = Some(along(square(shear)));
    Shape { inertia: along(quartic(inertia)), area: along(square(area)), shear_area, depth }
}

/// Reads a required positive dimension: one value, or a list of two values.
fn side(reader: &mut Reader, section: &Section, key: &'static str) -> Along {
    let given = reader.along(section, key);
    let given = given.map(|given| reader.positive_along(key, given));
    given.unwrap_or_else(|| {
        let missing = reader.required(section, key);
        Along::unreadable(missing.span)
    })
}

/// Fractions of the length of a stretch at which a polynomial of degree 4 is sampled.
const QUARTERS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Returns the polynomial of degree 4 with the given values at the fractions [`QUARTERS`].
fn quartic([a, b, c, d, e]: [f64; 5]) -> Profile {
    let beside = |a, b, c, d, e| (-13.0 * a + 48.0 * b - 36.0 * c + 16.0 * d - 3.0 * e) / 12.0;
    let middle = (13.0 * (a + e) - 64.0 * (b + d) + 120.0 * c) / 18.0;
    let values = [a, beside(a, b, c, d, e), middle, beside(e, d, c, b, a), e];
    Profile::by_control_values(&values).unwrap_or(Profile::constant(f64::NAN))
}

/// Returns the parabola through the first, middle and last value, or a line if its curvature is only rounding error.
fn square([a, _, c, _, e]: [f64; 5]) -> Profile {
    let bend = 2.0 * c - (a + e);
    if bend.abs() <= 16.0 * f64::EPSILON * (a + e) {
        return Profile::linear(a, e);
    }
    let values = [a, 0.5 * (a + e) + bend, e];
    Profile::by_control_values(&values).unwrap_or(Profile::constant(f64::NAN))
}

/// Finds the tabulated section whose name is given under `key`.
fn named(
    reader: &mut Reader,
    section: &Section,
    key: &str,
    find: fn(&str) -> Result<&'static RolledSection, String>,
) -> Shape {
    let span = section.span.clone();
    reader.refuse_all_but(section, &[key]);
    let Some((name, at)) = reader.text(section, key) else {
        return Shape::unreadable(span);
    };
    reader.quantities.push(Seen::of_built_in(key, &SECOND_MOMENT_OF_AREA, span.clone()));
    match find(name) {
        Ok(found) => {
            let along = |value| Along { profile: Profile::constant(value), span: span.clone() };
            let (shear_area, depth) = (found.shear_area.map(along), found.height.map(along));
            let shape = Shape::constant([found.area, found.inertia, f64::NAN], span.clone());
            Shape { shear_area, depth, ..shape }
        }
        Err(hint) => {
            let what = if key == "rail" { "rail" } else { "section" };
            let message = format!("the {what} `{name}` is not known");
            reader.report(Fault::new(code::UNKNOWN_WORD, at, message, "", hint));
            Shape::unreadable(span)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(name: &str, sides: &[f64]) -> Result<[f64; 2], &'static str> {
        let kind = KINDS.iter().find(|kind| kind.name == name).unwrap();
        (kind.measure)(sides).map(|[area, inertia, _]| [area, inertia])
    }

    #[track_caller]
    fn close(found: [f64; 2], wanted: [f64; 2]) {
        for (a, b) in found.iter().zip(wanted) {
            assert!((a / b - 1.0).abs() < 1e-12, "{found:?} {wanted:?}");
        }
    }

    /// Compares area and second moment of area with sums over parts: outer minus inner shape, flange plus stem of a T.
    #[test]
    fn sections_agree_with_the_sums_over_their_parts() {
        let circle = |d: f64| [PI * d * d / 4.0, PI * d.powi(4) / 64.0];
        close(measured("circle", &[0.5]).unwrap(), circle(0.5));
        let [outer, inner] = [circle(0.5), circle(0.46)];
        let ring = [outer[0] - inner[0], outer[1] - inner[1]];
        close(measured("tube", &[0.5, 0.02]).unwrap(), ring);
        let rectangle = |b: f64, h: f64| [b * h, b * h.powi(3) / 12.0];
        let [outer, inner] = [rectangle(2.0, 1.0), rectangle(1.6, 0.6)];
        let hollow = [outer[0] - inner[0], outer[1] - inner[1]];
        close(measured("box", &[2.0, 1.0, 0.2]).unwrap(), hollow);
        // The T has a flange of 2 × 0.25 over a stem of 0.5 × 0.75.
        let (flange, stem) = (rectangle(2.0, 0.25), rectangle(0.5, 0.75));
        let centre = (flange[0] * 0.125 + stem[0] * 0.625) / (flange[0] + stem[0]);
        let steiner = |part: [f64; 2], at: f64| part[1] + part[0] * (at - centre).powi(2);
        let inertia = steiner(flange, 0.125) + steiner(stem, 0.625);
        close(measured("T", &[2.0, 1.0, 0.25, 0.5]).unwrap(), [flange[0] + stem[0], inertia]);
        // An IPE 300 without fillets has A = 5188 mm² and I = 7999 cm⁴.
        let [area, inertia] = measured("I", &[150.0, 300.0, 10.7, 7.1]).unwrap();
        assert!((area - 5188.0).abs() < 1.0 && (inertia / 1e4 - 7999.0).abs() < 1.0);
        // An IPE 300 with fillets of 15 mm has A = 5381 mm² and I = 8356 cm⁴.
        let [area, inertia] = measured("I", &[150.0, 300.0, 10.7, 7.1, 15.0]).unwrap();
        assert!((area - 5381.0).abs() < 1.0 && (inertia / 1e4 - 8356.0).abs() < 1.0);
    }

    /// Compares the interpolating polynomials with the sampled functions at other fractions of the length.
    #[test]
    fn dimensions_that_vary_along_the_beam() {
        let powers = |t: f64| (3.0 - 2.0 * t, (3.0 - 2.0 * t).powi(4), (3.0 - 2.0 * t).powi(2));
        let [fourth, second] =
            [0, 1].map(|i| QUARTERS.map(|t| if i == 0 { powers(t).1 } else { powers(t).2 }));
        let (inertia, area) = (quartic(fourth), square(second));
        let linear = square(QUARTERS.map(|t| powers(t).0));
        assert_eq!((area.control_values().len(), linear.control_values()), (3, &[3.0, 1.0][..]));
        for t in [0.1, 0.3, 0.6, 0.9] {
            let (_, fourth, second) = powers(t);
            assert!((inertia.at(t) / fourth - 1.0).abs() < 1e-14);
            assert!((area.at(t) / second - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn dimensions_that_leave_no_room_are_refused() {
        assert_eq!(measured("tube", &[0.5, 0.25]), Err("wall"));
        assert_eq!(measured("I", &[0.3, 0.5, 0.25, 0.1]), Err("flange"));
        assert_eq!(measured("T", &[0.3, 0.5, 0.2, 0.3]), Err("web"));
    }
}
