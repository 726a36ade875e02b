//! Computes the beam's self-weight: `unit_weight` times the area of its sections.

use super::beam::OwnLoad;
use crate::code;
use crate::fault::Fault;
use crate::materials::Material;
use crate::profile::{Along, left_out};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::Load;

/// Area of the beam's section on a stretch, if known.
pub(super) struct Area {
    pub from: f64,
    pub to: f64,
    pub area: Option<Along>,
}

/// Reads `unit_weight`: a quantity, or "material" for the unit weight of the beam's material.
fn unit_weight(reader: &mut Reader, table: &Section, material: Option<&Material>) -> Option<Field> {
    let value = table.value("unit_weight")?;
    if value.get_ref().as_str().is_none_or(|text| text.trim() != "material") {
        return reader.quantity(table, "unit_weight");
    }
    if let Some(weight) = material.and_then(|material| material.unit_weight) {
        return Some(Field::new(weight, value.span()));
    }
    let message = match material {
        Some(material) => format!("the unit weight of the material {} is not known", material.name),
        None => "the beam does not have one `material` along its whole length".to_owned(),
    };
    let hint = format!("give {}", reader.line(table.keys, "unit_weight"));
    reader.report(Fault::new(code::INCOMPLETE, value.span(), message, "", hint));
    Some(Field::unreadable(value.span()))
}

/// Computes the loads from self-weight, each with its load case. Returns no load if `table` gives no unit
/// weight.
pub(super) fn read(
    reader: &mut Reader,
    table: &Section,
    length: f64,
    material: Option<&Material>,
    base: Option<Along>,
    mut areas: Vec<Area>,
) -> Vec<OwnLoad> {
    let case = super::load::case(reader, table, "weight_case");
    let Some(weight) = unit_weight(reader, table, material) else {
        if let Some((key, _)) = table.table.get_key_value("weight_case") {
            let message = "`weight_case` is given without `unit_weight`";
            let hint = "unit_weight = \"25 kN/m^3\" adds the beam's self-weight as a load";
            reader.report(Fault::new(code::INCOMPLETE, key.span(), message, "", hint));
        }
        return Vec::new();
    };
    let weight = reader.positive("unit_weight", weight);
    for [from, to] in left_out(length, areas.iter().map(|area| (area.from, area.to))) {
        let area = base.as_ref().map(|base| base.between([from / length, to / length]));
        areas.push(Area { from, to, area });
    }
    areas.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut loads = Vec::new();
    for Area { from, to, area } in areas {
        let (message, hint) = match area {
            None => (
                "the area of the beam's section is not known everywhere",
                "give `section` instead of `EI` or `I`; or give the weight as a distributed load",
            ),
            Some(area) if area.profile.control_values().len() > 2 => (
                "the area of the beam's section does not vary linearly",
                "give the weight as distributed loads, or let only one dimension of the section vary",
            ),
            Some(area) => {
                let [start, end] =
                    [area.profile.start(), area.profile.end()].map(|a| a * weight.value);
                // A stretch of zero length and an unreadable stretch have been reported already.
                let known = area.is_readable() && !weight.value.is_nan();
                if known && from < to {
                    let load = Load::distributed_force(from, to, start, end);
                    let (case, span) = (case.clone(), weight.span.clone());
                    loads.push(OwnLoad { load, case, span });
                }
                continue;
            }
        };
        reader.report(Fault::new(code::INCOMPLETE, weight.span.clone(), message, "", hint));
        break;
    }
    loads
}
