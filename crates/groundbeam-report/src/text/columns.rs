//! Writes extremes of fields in four columns, one row for each combination or train passage.

use super::COLUMNS;
use super::sheet::Sheet;
use crate::quantity::{Kind, Unit, Units};

/// Layout of a table with a first column of text, followed by the columns of [`COLUMNS`].
pub(super) struct Columns {
    units: [Unit; 4],
    first: usize,
    cell: usize,
}

impl Columns {
    /// Writes the heading. `first` contains the two lines above the first column. `widths` contains the width
    /// of the first column and the width of every other column.
    pub fn headed(
        sheet: &mut Sheet,
        first: [&str; 2],
        widths: [usize; 2],
        values: &[[Option<f64>; 4]],
        units: Units,
    ) -> Self {
        // The smallest and the largest value of a field have the same unit.
        let units_of_columns = COLUMNS.map(|(field, _)| {
            let same = (0..4).filter(|&column| COLUMNS[column].0 == field);
            let sizes = same.flat_map(|column| values.iter().filter_map(move |row| row[column]));
            units.unit(Kind::of(field), sizes.fold(0.0, |most: f64, size| most.max(size.abs())))
        });
        let columns = Columns { units: units_of_columns, first: widths[0], cell: widths[1] };
        let [upper, lower] = first;
        sheet.heading(&columns.join(upper, COLUMNS.map(|(field, _)| field.label().to_lowercase())));
        let ends = COLUMNS.map(|(_, largest)| if largest { "largest" } else { "smallest" });
        sheet.heading(&columns.join(lower, ends.map(str::to_owned)));
        if !units.is_plain() {
            sheet.heading(&columns.join("", units_of_columns.map(|unit| unit.name.to_owned())));
        }
        columns
    }

    /// Returns the row with the extremes of one combination or train passage.
    pub fn row(&self, first: &str, values: &[Option<f64>; 4]) -> String {
        let cell = |column: usize| match values[column] {
            Some(value) => self.units[column].number(value),
            None => "none".to_owned(),
        };
        self.join(first, [0, 1, 2, 3].map(cell))
    }

    fn join(&self, first: &str, cells: [String; 4]) -> String {
        let width = self.cell;
        let cells: String = cells.iter().map(|cell| format!(" {cell:>width$}")).collect();
        format!("{first:<width$}{cells}", width = self.first)
    }
}
