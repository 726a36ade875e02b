//! Rolled sections and rails by name: area, second moment and shear area from the listed dimensions.
//!
//! The tables of dimensions are the only data that both readers of model files share. The rails are transcribed in this
//! file.

use super::error::{Read, wrong};
use super::fields::{AREA, Along, Fields, LENGTH, Quantity, SECOND_MOMENT, Section, listed};
use super::shapes::{Measures, Shape, by, corners, filled, i_shape, less, rectangle, tube};
use crate::{Course, Scalar};

/// Rolled I-sections. Columns: name, height, width, web thickness, flange thickness and fillet radius in mm.
const ROLLED: &str = include_str!("../../../groundbeam-file/sections/rolled.tsv");
/// American W-sections. Columns: name, depth, width, web thickness and flange thickness in inches, area in in², second
/// moment of area in in⁴.
const AMERICAN: &str = include_str!("../../../groundbeam-file/sections/w.tsv");
/// Hollow sections. Columns: name, height (diameter of a tube), width (empty for a tube) and wall thickness in mm.
const HOLLOW: &str = include_str!("../../../groundbeam-file/sections/hollow.tsv");

/// Rolled rails: name, area and second moment of area about the horizontal axis. Sources: EN 13674-1, annex A (60E1,
/// 60E2, 54E1), UIC 860 V (UIC), AREMA's Manual, chapter 4 (RE), AS 1085.1 (AS).
const RAILS: [(&str, &str, &str); 11] = [
    ("60E1", "76.70 cm^2", "3038.3 cm^4"),
    ("60E2", "76.48 cm^2", "3021.5 cm^4"),
    ("54E1", "69.77 cm^2", "2337.9 cm^4"),
    ("UIC60", "76.86 cm^2", "3055 cm^4"),
    ("UIC54", "69.34 cm^2", "2346 cm^4"),
    ("115RE", "11.2171 in^2", "65.5 in^4"),
    ("119RE", "11.6378 in^2", "71.4 in^4"),
    ("132RE", "12.9124 in^2", "87.9 in^4"),
    ("136RE", "13.32 in^2", "94.9 in^4"),
    ("AS50", "64.51 cm^2", "2010 cm^4"),
    ("AS60", "77.25 cm^2", "2930 cm^4"),
];

/// The section under `rail` or `name`; `None` if the table gives neither.
pub(crate) fn read<S: Scalar>(fields: &mut Fields, section: Section) -> Read<Option<Shape<S>>> {
    for key in ["rail", "name"] {
        let Some((name, at)) = section.words(key)? else { continue };
        section.only(&[&[key]], &[])?;
        // The data of rolled sections and rails have units, so the quantities of the file must also have units.
        fields.note(at, true)?;
        let wanted = plain(name);
        let found = if key == "rail" { rail(&wanted, at) } else { rolled(&wanted, at) };
        return match found? {
            Some(shape) => Ok(Some(shape)),
            None => wrong(at, format!("the {key} `{name}` is not known")),
        };
    }
    Ok(None)
}

/// The name in capitals, without spaces and hyphens, and with X for ×.
fn plain(name: &str) -> String {
    name.to_uppercase().replace([' ', '-'], "").replace('×', "X")
}

fn rail<S: Scalar>(wanted: &str, at: usize) -> Read<Option<Shape<S>>> {
    let found = RAILS.iter().find(|(name, ..)| *name == wanted);
    let Some((_, area, moment)) = found else { return Ok(None) };
    let area = Along::constant(listed(area, AREA)?.value, at);
    let second_moment = Along::constant(listed(moment, SECOND_MOMENT)?.value, at);
    Ok(Some(Shape { area, second_moment, shear_area: None, depth: None }))
}

fn rolled<S: Scalar>(wanted: &str, at: usize) -> Read<Option<Shape<S>>> {
    for (table, unit) in [(ROLLED, "mm"), (AMERICAN, "in"), (HOLLOW, "mm")] {
        let lines = table.lines().filter(|line| !line.starts_with('#'));
        let mut lines = lines.map(|line| line.split('\t').collect::<Vec<_>>());
        let found = lines.find(|cells| cells.first().is_some_and(|name| plain(name) == wanted));
        let Some(cells) = found else { continue };
        let side = |cell: &&str| listed::<S>(&format!("{cell} {unit}"), LENGTH);
        let (measures, height): (_, Quantity<S>) = match (unit, &cells[1..]) {
            ("in", [d, _, web, flange, area, moment]) => {
                let height = side(d)?;
                let [web, flange] = [side(web)?.value, side(flange)?.value];
                let area = listed::<S>(&format!("{area} in^2"), AREA)?.value;
                let moment = listed::<S>(&format!("{moment} in^4"), SECOND_MOMENT)?.value;
                let shear = web * (height.value - S::of(2.0) * flange);
                (Ok([area, moment, shear].map(Course::Constant)), height)
            }
            (_, [h, "", wall, ..]) => {
                let height = side(h)?;
                let sides = [height.value, side(wall)?.value].map(Course::Constant);
                (tube(&sides[0], &sides[1]), height)
            }
            (_, [h, b, wall, _, _]) => {
                let height = side(h)?;
                (hollow(height.value, side(b)?.value, side(wall)?.value), height)
            }
            (_, [h, b, web, flange, fillet, ..]) => {
                let height = side(h)?;
                let [b, web, flange, fillet] = [b, web, flange, fillet].map(side);
                let sides = [height.value, b?.value, web?.value, flange?.value, fillet?.value];
                let [h, b, web, flange, fillet] = &sides.map(Course::Constant);
                let sharp = i_shape(b, h, flange, web);
                (sharp.and_then(|sharp| filled(sharp, [b, h, flange, web], fillet)), height)
            }
            _ => return wrong(at, "the list of sections has a line that cannot be read"),
        };
        let measures = measures.or_else(|what| wrong(at, what))?;
        let [area, second_moment, shear] = measures.map(|course| Along { course, exact: None, at });
        let course = Course::Constant(height.value);
        let depth = Along { course, exact: Some(height.exact), at };
        let (shear_area, depth) = (Some(shear), Some(depth));
        return Ok(Some(Shape { area, second_moment, shear_area, depth }));
    }
    Ok(None)
}

/// Area, second moment and shear area of a hollow rectangle with the wall thickness t. The outer corners have the
/// radius 1.5 t, the inner corners the radius t (EN 10210-2, annex B).
fn hollow<S: Scalar>(h: S, b: S, t: S) -> Measures<S> {
    let rounded = |h: S, b: S, radius: S| {
        let [h, b, radius] = [h, b, radius].map(Course::Constant);
        let [area, moment, _] = rectangle(&b, &h);
        let [lost, bent] = corners(&by(&h, 1.0, 2.0), &radius)?;
        Ok([less(&area, &lost), less(&moment, &bent)])
    };
    let twice = S::of(2.0) * t;
    let [area, moment] = rounded(h, b, S::of(1.5) * t)?;
    let [inner_area, inner_moment] = rounded(h - twice, b - twice, t)?;
    let shear = Course::Constant(twice * (h - twice));
    Ok([less(&area, &inner_area), less(&moment, &inner_moment), shear])
}

#[cfg(test)]
mod tests {
    use super::super::course::ends;
    use super::*;

    /// Compares areas and second moments with the printed values of EN 10365, AISC and EN 10210-2.
    #[test]
    fn sections_have_the_printed_values() {
        for (name, area, moment, figures) in [
            ("ipe300", 53.81e-4, 8356e-8, 1e-4),
            ("HEB 300", 149.1e-4, 25170e-8, 5e-4),
            ("W12×26", 7.65 * 0.0254 * 0.0254, 204.0 * 0.0254_f64.powi(4), 1e-15),
            ("CHS 48.3x5", 6.8e-4, 16.2e-8, 5e-3),
            ("RHS 200x100x8", 44.8e-4, 2234e-8, 5e-3),
        ] {
            let shape: Shape<f64> = rolled(&plain(name), 0).unwrap().unwrap();
            let [a, i] = [&shape.area, &shape.second_moment].map(|along| ends(&along.course)[0]);
            assert!((a / area - 1.0).abs() < figures, "{name}: {a}");
            assert!((i / moment - 1.0).abs() < figures, "{name}: {i}");
        }
        assert!(rolled::<f64>("IPE310", 0).unwrap().is_none());
        assert!(rail::<f64>("133RE", 0).unwrap().is_none());
    }
}
