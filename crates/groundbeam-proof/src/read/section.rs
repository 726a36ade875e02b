//! Reads `section = { … }`: a shape with its dimensions, a rolled section or a rail.

use super::error::{Read, wrong};
use super::fields::{Along, FILLET, Fields, LENGTH, Section, Values};
use super::rolled;
use super::shapes::{Shape, boxed, circle, filled, i_shape, rectangle, t_shape, tube};
use crate::{Course, Scalar};

/// Reads the cross section of a table; `None` if the table has no key `section`.
pub(crate) fn read<S: Scalar>(fields: &mut Fields, parent: Section) -> Read<Option<Shape<S>>> {
    let Some(section) = parent.table("section")? else { return Ok(None) };
    if let Some(shape) = rolled::read(fields, section)? {
        return Ok(Some(shape));
    }
    let (shape, at) = section.words("shape")?.unwrap_or(("rectangle", section.at));
    let keys: &[&'static str] = match shape {
        "rectangle" => &["width", "height"],
        "circle" => &["diameter"],
        "tube" => &["diameter", "wall"],
        "box" => &["width", "height", "wall"],
        "I" | "T" => &["width", "height", "flange", "web"],
        _ => return wrong(at, format!("the shape `{shape}` is not known")),
    };
    let optional: &[&'static str] = if shape == "I" { &["fillet"] } else { &[] };
    section.only(&[&["shape"], keys, optional], &[])?;
    let mut sides = Vec::new();
    for key in keys {
        let side = fields.along(section, key, LENGTH, Values::Linear)?;
        sides.push(side.map_or_else(|| section.missing(key), Ok)?);
    }
    let mut fillet = None;
    if shape == "I" {
        fillet = fields.along(section, "fillet", FILLET, Values::Linear)?;
    }
    let courses: Vec<&Course<S>> = sides.iter().map(|side| &side.course).collect();
    let measured = match (shape, &courses[..]) {
        ("rectangle", [b, h]) => Ok(rectangle(b, h)),
        ("circle", [d]) => circle(d),
        ("tube", [d, wall]) => tube(d, wall),
        ("box", [b, h, wall]) => boxed(b, h, wall),
        ("I", [b, h, flange, web]) => i_shape(b, h, flange, web).and_then(|sharp| match &fillet {
            None => Ok(sharp),
            Some(radius) => filled(sharp, [b, h, flange, web], &radius.course),
        }),
        ("T", [b, h, flange, web]) if sides.iter().all(Along::is_constant) => {
            t_shape(b, h, flange, web)
        }
        _ => Err("the dimensions of a T-section must not vary along a segment"),
    };
    let [area, second_moment, shear_area] = match measured {
        Ok(measures) => measures.map(|course| Along { course, exact: None, at: section.at }),
        Err(what) => return wrong(section.at, what),
    };
    let depth = keys.iter().position(|key| ["height", "diameter"].contains(key));
    let depth = depth.and_then(|i| sides.get(i)).cloned();
    Ok(Some(Shape { area, second_moment, shear_area: Some(shear_area), depth }))
}
