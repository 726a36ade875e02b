//! Reads `[gap_survey]`: the initial gap from a table of levels or clearances in a separate file.

use crate::beside::{Row, Table};
use crate::code;
use crate::fault::Fault;
use crate::keys::{Table as Keys, along, quantity, text};
use crate::number::Decimal;
use crate::quantity::{self, OFFSET};
use crate::reader::Reader;
use crate::suggest;
use crate::table::Section;
use crate::unit::{Dimension, Scale, Unit};
use groundbeam::model::{GapPoint, Profile};
use std::ops::Range;

pub(super) static TABLE: Keys = Keys {
    name: "[gap_survey]",
    keys: &[
        text(
            "file",
            "seabed.csv",
            "The file with the table; its name is relative to the folder of the model file.",
        )
        .needed(),
        text("x", "KP", "The column of positions; default: the first."),
        text("level", "z", "The column of levels, positive up; default: the second."),
        text("clearance", "gap", "The column of clearances, in place of `level`."),
        along(
            "datum",
            &OFFSET,
            2,
            "The level of the straight underside of the beam, or the levels of its two ends; \
             default: the highest level under the beam.",
        ),
        quantity(
            "start",
            &OFFSET,
            "The position of the beam's left end in the survey; default: 0.",
        ),
    ],
};

/// Reads the survey's points, clipped to the beam.
pub(super) fn read(reader: &mut Reader, table: &Section, length: f64) -> Vec<GapPoint> {
    let start = reader.quantity(table, "start").map_or(0.0, |start| start.value);
    let datum = reader.along(table, "datum");
    let [x, level, clearance] = ["x", "level", "clearance"].map(|key| reader.text(table, key));
    let Some((file, span)) = reader.text(table, "file") else { return Vec::new() };
    if let (Some((_, level)), Some((_, clearance))) = (&level, &clearance) {
        let hint = "give either a column of levels (positive up) or a column of clearances (positive for an open gap)";
        reader.exclusive(("level", level), ("clearance", clearance), hint);
    }
    if let (Some((_, clearance)), Some(datum)) = (&clearance, &datum) {
        let hint = "clearances are measured from the beam; only levels have a datum";
        reader.exclusive(("clearance", clearance), ("datum", &datum.span), hint);
    }
    let Some(beside) = reader.beside else {
        let message =
            "the model is given as text without a folder, so it cannot refer to other files";
        let hint = "write the points in the model as [[gap]], or solve the model from a file";
        reader.report(Fault::new(code::FILE, span, message, "", hint));
        return Vec::new();
    };
    let survey = match Table::read(beside, file) {
        Ok(survey) => survey,
        Err(error) => {
            let message = format!("`{file}` cannot be read: {error}");
            let hint = "the file name is relative to the folder of the model file";
            reader.report(Fault::new(code::FILE, span, message, "", hint));
            return Vec::new();
        }
    };
    reader.others.push(survey.file.clone());
    let is_level = clearance.is_none();
    let heights = level.or(clearance);
    let mut columns = Columns { reader, survey: &survey, wrong: false };
    let x = columns.find(x, 0, "the positions");
    let heights = columns.find(heights, 1, "the levels or clearances");
    let ([Some(x), Some(heights)], false) = ([x, heights], columns.wrong) else {
        return Vec::new();
    };
    let points = columns.points(&x, &heights);
    let unreadable = start.is_nan() || datum.as_ref().is_some_and(|datum| !datum.is_readable());
    // Faults in the columns, in `start` and in `datum` have been reported already.
    if columns.wrong || unreadable {
        return Vec::new();
    }
    let mut corners = on_the_beam(&points, start, length);
    if is_level {
        let highest = corners.iter().map(|c| c.value).fold(f64::NEG_INFINITY, f64::max);
        let datum = datum.map_or(Profile::constant(highest), |datum| datum.profile);
        for corner in &mut corners {
            corner.value = datum.at(corner.at / length) - corner.value;
        }
    }
    corners
}

/// A column of the table: its index, and the factor of its unit.
struct Column {
    index: usize,
    scale: Option<Scale>,
}

struct Columns<'r, 's, 't> {
    reader: &'r mut Reader<'s>,
    survey: &'t Table,
    wrong: bool,
}

impl Columns<'_, '_, '_> {
    fn report(&mut self, fault: Fault) {
        self.wrong = true;
        self.reader.report_in(&self.survey.source, &self.survey.file, fault);
    }

    /// Finds the column that the model file names, or otherwise the column with the index `place`.
    fn find(
        &mut self,
        named: Option<(&str, Range<usize>)>,
        place: usize,
        what: &str,
    ) -> Option<Column> {
        let header = &self.survey.header;
        let names: Vec<&str> = header.cells.iter().map(|cell| split(cell).0).collect();
        let index = match named {
            None => place,
            Some((name, span)) => {
                let same = |other: &&str| other.eq_ignore_ascii_case(name.trim());
                let Some(index) = names.iter().position(same) else {
                    let message = format!("{} has no column `{name}`", self.survey.file.name);
                    let hint = suggest::advice(name, &names, "its columns: {}");
                    self.wrong = true;
                    self.reader.report(Fault::new(code::COLUMN, span, message, "", hint));
                    return None;
                };
                index
            }
        };
        let Some(cell) = header.cells.get(index) else {
            let message = format!("the table has no column {} for {what}", index + 1);
            let hint = "separate the cells by `;`, tabs or commas, as in the first row";
            self.report(Fault::new(code::COLUMN, header.span.clone(), message, "", hint));
            return None;
        };
        let at = header.cell(index);
        if Decimal::read(cell).is_some_and(|(_, length)| length == cell.len()) {
            let message = "the first row must name the columns";
            let hint = "write a header, as in `x [m]; level [m]`";
            self.report(Fault::new(code::COLUMN, at, message, "a number", hint));
            return None;
        }
        let scale = match split(cell) {
            (_, None) if self.reader.is_plain() => None,
            (name, None) => {
                let message = format!("the column `{name}` has no unit");
                let hint = format!("write the unit after the name, as in `{name} [m]`");
                self.report(Fault::new(code::MIXED, at, message, "", hint));
                return None;
            }
            (_, Some(_)) if self.reader.is_plain() => {
                let message = "this column has a unit, but the model has no units";
                let hint = "either all quantities of a file have a unit or none has";
                self.report(Fault::new(code::MIXED, at, message, "a unit here", hint));
                return None;
            }
            (_, Some(unit)) => match Unit::read(unit) {
                Ok(found) if found.dimension == Dimension::LENGTH => Some(found.scale),
                Ok(_) => {
                    let message = format!("`{unit}` is not a unit of length");
                    self.report(Fault::new(code::WRONG_UNIT, at, message, "", "as in [m], [mm]"));
                    return None;
                }
                Err(fault) => {
                    self.report(Fault { at, ..fault });
                    return None;
                }
            },
        };
        Some(Column { index, scale })
    }

    /// Reads the rows as pairs of position and height, and reports rows that are not in ascending order of
    /// position.
    fn points(&mut self, x: &Column, heights: &Column) -> Vec<[f64; 2]> {
        let survey = self.survey;
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(survey.rows.len());
        for row in &survey.rows {
            let spare =
                row.cells.iter().skip(survey.header.cells.len()).position(|cell| !cell.is_empty());
            if let Some(spare) = spare {
                let at = row.cell(survey.header.cells.len() + spare);
                let message = "this row has more cells than the header";
                let hint = "write decimal points in place of decimal commas, or name each column in the header";
                self.report(Fault::new(code::COLUMN, at, message, "", hint));
                continue;
            }
            let [at, height] = [x, heights].map(|column| self.number(row, column));
            let (Some(at), Some(height)) = (at, height) else { continue };
            if let Some([before, _]) = points.last()
                && at <= *before
            {
                let message =
                    "the position in this row is not larger than the position in the previous row";
                let hint = "sort the rows by position; no two rows may share a position";
                self.report(Fault::new("GB501", row.cell(x.index), message, "", hint));
                continue;
            }
            points.push([at, height]);
        }
        if points.is_empty() && !self.wrong {
            let message = "the table has no rows";
            let at = survey.header.span.clone();
            self.report(Fault::new(code::FILE, at, message, "", "one row for each point"));
        }
        points
    }

    fn number(&mut self, row: &Row, column: &Column) -> Option<f64> {
        let at = row.cell(column.index);
        let text = row.cells.get(column.index).map_or("", |cell| cell.trim());
        let lower = text.trim_start_matches(['+', '-']).to_lowercase();
        if ["nan", "inf", "infinity"].contains(&&*lower) {
            self.report(Fault {
                hint: "delete rows without a value".into(),
                ..quantity::not_finite(&lower, at)
            });
            return None;
        }
        match Decimal::read(text) {
            Some((number, length)) if length == text.len() => {
                let value = column.scale.map_or(number.to_f64(), |scale| number.times(&scale));
                if quantity::is_within_reach(value) && (value != 0.0 || number.is_zero()) {
                    return Some(value);
                }
                self.report(quantity::out_of_reach(value, at));
            }
            found => {
                let message = if text.is_empty() {
                    "a number is missing here".to_owned()
                } else {
                    format!("`{text}` is not a number")
                };
                let comma = found.is_some_and(|(_, length)| text[length..].starts_with(','));
                let hint = if comma {
                    format!("write a decimal point: {}", text.replacen(',', ".", 1))
                } else {
                    "write one number in each cell; units belong in the header".to_owned()
                };
                self.report(Fault::new(code::NUMBER, at, message, "", hint));
            }
        }
        None
    }
}

/// Splits `KP [km]` or `KP (km)` into the name and the unit.
fn split(cell: &str) -> (&str, Option<&str>) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some(rest) = cell.strip_suffix(close)
            && let Some((name, unit)) = rest.rsplit_once(open)
        {
            return (name.trim(), Some(unit.trim()));
        }
    }
    (cell.trim(), None)
}

/// Clips the points to a beam that begins at `start`. Both ends of the beam are points of the result.
/// Outside the survey, the height is the height of the nearest point.
fn on_the_beam(points: &[[f64; 2]], start: f64, length: f64) -> Vec<GapPoint> {
    let at = |x: f64| {
        let right = points.partition_point(|point| point[0] < x);
        match (right.checked_sub(1).map(|i| points[i]), points.get(right)) {
            (Some([a, low]), Some([b, high])) => (low * (b - x) + high * (x - a)) / (b - a),
            (Some([_, only]), None) | (None, Some(&[_, only])) => only,
            (None, None) => 0.0,
        }
    };
    let first = [GapPoint { at: 0.0, value: at(start) }];
    let last = [GapPoint { at: length, value: at(start + length) }];
    let inside = points.iter().map(|[x, value]| GapPoint { at: x - start, value: *value });
    let inside = inside.filter(|corner| corner.at > 0.0 && corner.at < length);
    first.into_iter().chain(inside).chain(last).collect()
}
