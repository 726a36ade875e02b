//! Writes the lift-off zones of one solution, or the governing free spans under moving trains, as text.

use super::MOST_ROWS;
use super::sheet::Sheet;
use crate::quantity::{Kind, Units};
use crate::size::Sizes;
use groundbeam::{Field, solution::LiftOff};
use groundbeam_run::{Opened, Passage};

/// Adds a table with one row for each lift-off zone. If there are many zones, the table contains only the
/// longest ones.
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
    let row = |open: &&LiftOff| {
        let largest = largest(open);
        let x = |x: f64| place.write(sizes.position(x));
        let gap = height.write(largest.value);
        [x(open.from), x(open.to), x(open.length()), gap, x(largest.x), ends(open).to_owned()]
    };
    let rows: Vec<[String; 6]> = shown.iter().map(row).collect();
    let heads = ["from", "to", "length", "largest gap", "at", "reaches"].map(str::to_owned);
    // Each column is as wide as its content.
    let width = |column: usize, least: usize| {
        let longest = rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        least.max(longest + 1)
    };
    let [from, to, length, gap, at] =
        [width(0, 10), width(1, 10), width(2, 10), width(3, 13), width(4, 11)];
    let written = |[a, b, c, d, e, f]: &[String; 6]| {
        format!("{:13}{a:>from$}{b:>to$}{c:>length$}{d:>gap$} {e:<at$}{f}", "")
    };
    sheet.heading(&written(&heads));
    for row in &rows {
        sheet.line(&written(row));
    }
    if count > MOST_ROWS {
        sheet.row("", &format!("and {} shorter ones", count - MOST_ROWS));
    }
}

/// Names the ends of the beam that a lift-off zone reaches.
fn ends(open: &LiftOff) -> &'static str {
    match open.reaches {
        [true, true] => "both ends",
        [true, false] => "left end",
        [false, true] => "right end",
        [false, false] => "",
    }
}

/// Adds the longest free span and the largest clearance over all positions of trains. If there are several
/// passages, the text also states the number of the governing passage.
pub(crate) fn of_trains(sheet: &mut Sheet, all: &[Passage], units: Units) {
    let each = || {
        all.iter().enumerate().filter_map(|(i, passage)| {
            let found = passage.free_spans()?;
            let cleaned = |opened: Opened| clean(passage, opened);
            // A gap that is only rounding error is not a clearance.
            let highest = cleaned(found.highest);
            let is_open = highest.stretch.largest_gap.value > 0.0;
            is_open.then(|| (i + 1, cleaned(found.longest), highest))
        })
    };
    // The first of several equal values is kept.
    let longest = each().map(|(number, longest, _)| (number, longest)).reduce(|most, other| {
        if other.1.stretch.length() > most.1.stretch.length() { other } else { most }
    });
    let highest = each().map(|(number, _, highest)| (number, highest)).reduce(|most, other| {
        let gap = |opened: &Opened| opened.stretch.largest_gap.value;
        if gap(&other.1) > gap(&most.1) { other } else { most }
    });
    let (Some((of_longest, longest)), Some((of_highest, highest))) = (longest, highest) else {
        sheet.row(
            "Free spans",
            "none: the beam touches the ground along its whole length at every solved position",
        );
        return;
    };
    let place = |x: f64| units.write(Kind::Position, x);
    let when = |opened: &Opened, number: usize| {
        let which = if all.len() > 1 { format!(", #{number}") } else { String::new() };
        format!("with the first axle at {}{which}", place(opened.first_axle))
    };
    let LiftOff { from, to, .. } = longest.stretch;
    let end = match ends(&longest.stretch) {
        "" => String::new(),
        ends => format!(", in the air at its {ends}"),
    };
    let when_longest = when(&longest, of_longest);
    let words = format!(
        "the longest {}, from {} to {}{end}, {when_longest}",
        place(longest.stretch.length()),
        place(from),
        place(to)
    );
    sheet.row("Free spans", &words);
    let gap = highest.stretch.largest_gap;
    let value = units.write(Kind::Deflection, gap.value);
    let when_highest = when(&highest, of_highest);
    sheet.row("", &format!("the largest clearance {value}, at {}, {when_highest}", place(gap.x)));
}

/// Sets rounding errors in the positions and the gap of a free span to zero.
fn clean(passage: &Passage, opened: Opened) -> Opened {
    let Some((_, solution)) = passage.nearest(opened.first_axle) else { return opened };
    let sizes = Sizes::of(solution);
    let LiftOff { from, to, largest_gap, reaches } = opened.stretch;
    let [from, to] = [from, to].map(|x| sizes.position(x));
    let largest_gap = sizes.extreme(Field::Gap, largest_gap);
    Opened { stretch: LiftOff { from, to, largest_gap, reaches }, ..opened }
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::{Beam, Foundation, Load, Model, Outcome, solution::Extreme, solve};

    #[test]
    fn columns_of_free_spans_fit_their_numbers() {
        let l = 12_345_678.25;
        let model = Model::new(Beam::uniform(l, 1e28), Foundation::winkler(1.0))
            .with_load(Load::uniform_force(0.0, l, 1.0));
        let Ok(Outcome::Equilibrium(solution)) = solve(&model) else { panic!("it stands") };
        let open = |from: f64| LiftOff {
            from,
            to: from + 1.234_567_8e-7,
            largest_gap: Extreme { x: from, value: 1.234_567_8e-9 },
            reaches: [false, true],
        };
        let mut sheet = Sheet::new(false);
        table(&mut sheet, &[open(0.123e-5), open(0.9e7)], Units::PLAIN, &Sizes::of(&solution));
        let text = sheet.finish();
        let rows: Vec<Vec<&str>> =
            text.lines().skip(2).map(|line| line.split_whitespace().collect()).collect();
        assert!(rows.len() == 2 && rows.iter().all(|row| row.len() == 7), "{text}");
    }
}
