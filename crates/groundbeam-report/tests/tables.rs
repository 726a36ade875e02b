//! Tests CSV tables.

use crate::common::{answers, context, document, solved};
use groundbeam::solution::Side;
use groundbeam_report::{Context, Units, csv};

#[test]
fn a_table_has_both_sides_of_a_jump() {
    let document = document("kikuchi-4");
    let solution = solved(&document);
    let table = csv::table(&solution, &[0.0, 0.5, 1.0], &Context::new(Units::PLAIN));
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    let names = "x,deflection,slope,moment,shear_force,settlement,gap,pressure";
    assert_eq!(table.lines().next(), Some(names));
    assert_eq!(
        rows.iter().map(|row| row[0]).collect::<Vec<_>>(),
        ["x", "0.0", "0.5", "0.5", "1.0"]
    );
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    for (row, side) in [(2, Side::Left), (3, Side::Right)] {
        let fields = solution.at(0.5, side);
        assert_eq!(number(row, 3).to_bits(), fields.moment.to_bits());
        assert_eq!(number(row, 4).to_bits(), fields.shear_force.to_bits());
    }
    assert!((number(3, 3) - number(2, 3) - 0.49).abs() < 1e-12);
}

#[test]
fn the_header_of_a_table_contains_the_units() {
    let document = document("footing");
    let solution = solved(&document);
    let table = csv::table(&solution, &[1.0], &context(&document));
    let names = "x_m,deflection_m,slope_rad,moment_Nm,shear_force_N,settlement_m,gap_m,\
                 pressure_N_per_m";
    assert_eq!(table.lines().next(), Some(names));
}

#[test]
fn the_history_has_a_row_for_every_step() {
    let solution = solved(&document("long-beam"));
    let history = csv::history(&solution);
    assert_eq!(history.lines().count(), solution.iterations() + 1);
    assert!(history.starts_with("step,zones,part,decrement\n1,"));
}

/// The moment at a free end is zero but for rounding errors.
#[test]
fn rounding_errors_are_written_as_zero() {
    let are_zero = |table: &str| {
        let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
        let moments = ["moment_Nm", "moment_min_Nm", "moment_max_Nm"];
        let columns: Vec<usize> =
            (0..rows[0].len()).filter(|&i| moments.contains(&rows[0][i])).collect();
        assert!(!columns.is_empty() && rows.len() > 2, "{table}");
        for row in &rows[1..] {
            assert!(columns.iter().all(|&i| row[i] == "0.0"), "{table}");
        }
    };
    let train = document("train");
    let found = answers(&train);
    are_zero(&csv::trains(&found.passages(), &[0.0, 12.0], Units::SI));
    let combined = document("combinations");
    let found = answers(&combined);
    let context = context(&combined);
    let l = combined.model.beam.length;
    are_zero(&csv::envelope(&found, &[0.0, l], &context));
    let footing = document("footing");
    let l = footing.model.beam.length;
    are_zero(&csv::table(&solved(&footing), &[0.0, l], &context));
}
