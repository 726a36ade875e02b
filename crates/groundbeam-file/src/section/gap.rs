//! Reads `[[gap]]` and `[[gap_trough]]`.

use super::chords::Spacing;
use super::survey;
use super::trough::{MOST_CHORDS, Trough, sunk};
use crate::band::Band;
use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_AT, Table, quantity};
use crate::quantity::{CLEARANCE, POSITION};
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Model, model::GapPoint};

pub(super) static TABLE: Table = Table {
    name: "[[gap]]",
    keys: &[
        quantity("at", &POSITION, "The position of a point of the gap.").needed().also(ALSO_AT),
        quantity("value", &CLEARANCE, "The initial gap at this point, positive if open.")
            .needed()
            .also(&["gap", "clearance", "size"]),
    ],
};

/// Sets the initial gap: the given points, plus settlement troughs as polygons. Returns the number of straight pieces
/// if there are troughs. `pressures` are the mean loads per length of all combinations.
pub(super) fn read(
    reader: &mut Reader,
    root: &Section,
    model: &mut Model,
    band: Option<Band>,
    pressures: impl Iterator<Item = f64>,
) -> Option<usize> {
    model.gap = given(reader, root, model.beam.length);
    let tables = reader.tables(root, "gap_trough");
    let troughs: Vec<Trough> = tables.iter().map(|table| Trough::read(reader, table)).collect();
    let first = tables.first()?;
    if !troughs.iter().all(Trough::is_readable) || !model.problems().is_empty() {
        return None;
    }
    let multiples = band.map_or([[1.0; 2]; 2], |band| [band.spring, band.shear]);
    let pressure = pressures.filter(|pressure| *pressure > 0.0).fold(f64::INFINITY, f64::min);
    let spacing = Spacing::new(model, multiples, pressure, &troughs);
    match sunk(model, &troughs, &spacing) {
        Ok(gap) => {
            place_all(reader, gap.len(), first);
            let chords = gap.len() - 1;
            model.gap = gap;
            Some(chords)
        }
        Err(chords) => {
            let message = format!(
                "the settlement troughs need {chords:.0} chords; at most {MOST_CHORDS} are allowed"
            );
            let hint = "check `settlement`, the loads, EI, k and mu: the chords are short under a light load or a flexible beam \
                        on stiff ground; or give the points yourself as [[gap]]";
            reader.report(Fault::new(code::CHORDS, first.span.clone(), message, "", hint));
            None
        }
    }
}

fn given(reader: &mut Reader, root: &Section, length: f64) -> Vec<GapPoint> {
    let gap = corners(reader, root);
    let Some(table) = reader.table(root, "gap_survey") else { return gap };
    if let Some((name, _)) = root.table.get_key_value("gap") {
        let hint = "give either the points of the gap or a survey";
        reader.exclusive(("gap", &name.span()), ("gap_survey", &table.span), hint);
    }
    let gap = survey::read(reader, &table, length);
    place_all(reader, gap.len(), &table);
    gap
}

fn corners(reader: &mut Reader, root: &Section) -> Vec<GapPoint> {
    let tables = reader.parts(root, "gap", Part::Gap);
    let mut number = |table, key| reader.required(table, key).value;
    let corner = |table| GapPoint { at: number(table, "at"), value: number(table, "value") };
    tables.iter().map(corner).collect()
}

/// Sets the location of the generated points to `table`, so that faults of these points are reported there.
fn place_all(reader: &mut Reader, corners: usize, table: &Section) {
    for i in 0..corners {
        reader.places.part(Part::Gap(i), &table.span);
        reader.places.field(Part::Gap(i), "at", &Field::new(0.0, table.span.clone()));
    }
}
