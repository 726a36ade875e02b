//! A table of the stretches that have lifted off.

use super::MOST_ROWS;
use super::sheet::Sheet;
use crate::quantity::{Kind, Units};
use crate::size::Sizes;
use groundbeam::{Field, LiftOff};

/// A line for each; of very many the longest.
pub(super) fn table(sheet: &mut Sheet, lifted: &[LiftOff], units: Units, sizes: &Sizes) {
    let count = lifted.len();
    let by_length = |a: &&LiftOff, b: &&LiftOff| b.length().total_cmp(&a.length());
    let mut shown: Vec<&LiftOff> = lifted.iter().collect();
    shown.sort_by(by_length);
    shown.truncate(MOST_ROWS);
    shown.sort_by(|a, b| a.from.total_cmp(&b.from));
    let longest = shown.iter().fold(0.0_f64, |most, open| most.max(open.length()));
    let longest = units.position(longest);
    sheet.row("Lift-off", &format!("{count} free spans, the longest {longest} long"));
    let place = units.unit(Kind::Position, shown.iter().fold(0.0, |far, open| open.to.max(far)));
    let largest = |open: &LiftOff| sizes.extreme(Field::Gap, open.largest_gap);
    let most = shown.iter().fold(0.0_f64, |most, open| most.max(largest(open).value));
    let height = units.unit(Kind::Deflection, most);
    sheet.heading(&format!(
        "{:<13}{:>10}{:>10}{:>10}{:>13} {:<10} reaches",
        "", "from", "to", "length", "largest gap", "at"
    ));
    for open in &shown {
        let largest = largest(open);
        let x = |x: f64| place.write(sizes.position(x), 5);
        let ends = match open.reaches {
            [true, true] => "both ends",
            [true, false] => "left end",
            [false, true] => "right end",
            [false, false] => "",
        };
        sheet.line(&format!(
            "{:<13}{:>10}{:>10}{:>10}{:>13} {:<10} {ends}",
            "",
            x(open.from),
            x(open.to),
            x(open.length()),
            height.write(largest.value, 5),
            x(largest.x)
        ));
    }
    if count > MOST_ROWS {
        sheet.row("", &format!("and {} shorter ones", count - MOST_ROWS));
    }
}
