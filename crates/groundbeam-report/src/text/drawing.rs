//! Draws beam, ground and contact with characters on a terminal, at most 80 columns wide.

use crate::quantity::{Kind, Units};
use crate::size::Sizes;
use groundbeam::{
    Solution,
    model::{Action, Extent},
    solution::Side,
};

/// Number of text columns of the drawing.
const WIDTH: usize = 78;
/// Number of text columns of ground beyond each end of the beam.
const BEYOND: usize = 5;
/// Number of text rows for the deflections of beam and ground.
const DEPTH: usize = 7;
/// Number of text rows of ground below the lowest point of its surface.
const BELOW: usize = 1;

const LOAD: &str = "33";
const CONTACT: &str = "34";
const GROUND: &str = "2";

/// Draws the deflected beam on the ground with its contact zones, not to scale. `colour` adds escape codes for
/// a terminal.
pub fn drawing(solution: &Solution, units: Units, colour: bool) -> String {
    let picture = Picture { solution, length: solution.model().beam.length };
    let mut rows = vec![painted(&picture.loads(), LOAD, colour)];
    rows.extend(picture.bent().iter().map(|row| {
        // The ground has a faint colour, so that the beam is prominent.
        match row.find('░') {
            Some(_) if colour => row.replace('░', &format!("\u{1b}[{GROUND}m░\u{1b}[0m")),
            _ => row.clone(),
        }
    }));
    rows.push(painted(&picture.contact(), CONTACT, colour));
    rows.push(picture.positions(units));
    rows.iter().map(|row| row.trim_end().to_owned() + "\n").collect()
}

fn painted(words: &str, code: &str, colour: bool) -> String {
    if colour { format!("\u{1b}[{code}m{}\u{1b}[0m", words.trim_end()) } else { words.to_owned() }
}

struct Picture<'a> {
    solution: &'a Solution,
    length: f64,
}

impl Picture<'_> {
    /// Text column of a position on the beam.
    fn column(&self, x: f64) -> usize {
        let last = (WIDTH - 2 * BEYOND - 1) as f64;
        BEYOND + (last * (x / self.length).clamp(0.0, 1.0)).round() as usize
    }

    /// Position of a text column along the beam, also for columns beyond the ends of the beam.
    fn position(&self, column: usize) -> f64 {
        let last = (WIDTH - 2 * BEYOND - 1) as f64;
        self.length * ((column as f64 - BEYOND as f64) / last)
    }

    fn is_on_beam(column: usize) -> bool {
        (BEYOND..WIDTH - BEYOND).contains(&column)
    }

    /// Draws the row of loads, with forces as arrows, moments as rotation arrows, and distributed loads as
    /// marks.
    fn loads(&self) -> String {
        let mut row = vec![' '; WIDTH];
        let model = self.solution.model();
        for load in model.beam_loads().filter(|load| load.extent().is_distributed()) {
            let [from, to] = load.extent().ends();
            row[self.column(from)..=self.column(to)].fill('┬');
        }
        for load in model.beam_loads() {
            if let Extent::Point { at, size } = load.extent() {
                let turns = load.action() == Action::Moment;
                let [up, down] = if turns { ['↺', '↻'] } else { ['↑', '↓'] };
                row[self.column(at)] = if size < 0.0 { up } else { down };
            }
        }
        row.into_iter().collect()
    }

    /// The rows of the drawing that show beam and ground.
    fn bent(&self) -> Vec<String> {
        let solution = self.solution;
        let beam: Vec<Option<f64>> = (0..WIDTH)
            .map(|column| {
                let x = self.position(column);
                Self::is_on_beam(column).then(|| solution.at(x, Side::Right).deflection)
            })
            .collect();
        let surface: Vec<f64> = (0..WIDTH)
            .map(|column| {
                let x = self.position(column);
                let inside = x.clamp(0.0, self.length);
                let fields = solution.at(inside, Side::Right);
                // Beyond an end of the beam the initial gap has its value at this end.
                let initial = fields.deflection + fields.gap - fields.settlement;
                solution.settlement(x) + initial
            })
            .collect();
        let all = || beam.iter().flatten().chain(&surface);
        let low = all().fold(0.0_f64, |low, &value| low.min(value));
        let high = all().fold(0.0_f64, |high, &value| high.max(value));
        let row_of = |value: f64| {
            let share = if high > low { (value - low) / (high - low) } else { 0.5 };
            (share * (DEPTH - 1) as f64).round() as usize
        };
        let mut rows = vec![vec![' '; WIDTH]; DEPTH + BELOW];
        let mut before = None;
        for column in 0..WIDTH {
            let ground = row_of(surface[column]);
            for row in rows.iter_mut().skip(ground + usize::from(beam[column].is_some())) {
                row[column] = '░';
            }
            if let Some(deflection) = beam[column] {
                let row = row_of(deflection);
                rows[row][column] = '━';
                // If the beam crosses several rows between two columns, diagonal strokes fill the rows between.
                let last = before.replace(row).unwrap_or(row);
                let sign = if last < row { '╲' } else { '╱' };
                for between in rows.iter_mut().take(last.max(row)).skip(last.min(row) + 1) {
                    between[column] = sign;
                }
            }
        }
        rows.into_iter().map(|row| row.into_iter().collect()).collect()
    }

    /// Draws the row of contact, with a bar at each contact zone and a triangle at each point contact.
    fn contact(&self) -> String {
        let mut row = vec![' '; WIDTH];
        for region in self.solution.contact() {
            let (from, to) = (self.column(region.from), self.column(region.to));
            row[from..=to].fill('▔');
            if from == to {
                row[from] = '▲';
            }
        }
        row.into_iter().collect()
    }

    /// Row with the positions of the ends of the beam, and of the contact edges for which there is room.
    fn positions(&self, units: Units) -> String {
        let sizes = Sizes::of(self.solution);
        let mut row = vec![' '; WIDTH];
        let edges = self.solution.contact().iter().flat_map(|region| [region.from, region.to]);
        // The ends of the beam come first because they are always labelled.
        for x in [0.0, self.length].into_iter().chain(edges) {
            let words = units.write(Kind::Position, sizes.position(x));
            let count = words.chars().count();
            let from = self.column(x).saturating_sub(count / 2).min(WIDTH - count.min(WIDTH));
            let room = from.saturating_sub(1)..(from + count + 1).min(WIDTH);
            if row[room].iter().all(|&sign| sign == ' ') {
                row.iter_mut()
                    .skip(from)
                    .zip(words.chars())
                    .for_each(|(place, sign)| *place = sign);
            }
        }
        row.into_iter().collect()
    }
}
