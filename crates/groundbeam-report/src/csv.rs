//! Writes CSV tables: fields along the beam, the envelope of combinations, and the history of the iteration.

use crate::bound::bound_alone;
use crate::combinations::{bounds_at, numbered, of_limit_state};
use crate::context::Context;
use crate::curve::Jumps;
use crate::extremes::Rounding;
use crate::quantity::{Kind, Unit, Units};
use crate::size::Sizes;
use ::csv::{Writer, WriterBuilder};
use groundbeam::{
    Field, Solution,
    design::{LimitState, LimitStates},
    envelope::{Bounds, Envelope},
};
use groundbeam_file::printable;
use groundbeam_run::{Answers, InPassage, Passage, Passages};

/// Returns a CSV table of all fields at the given positions, with the header `x_m, deflection_m, …`. If a proof is
/// requested, a column such as `deflection_bound_m` follows each field.
///
/// Where a field jumps, the position has two rows: the values just left of it, then those just right of it. In SI
/// units, numbers are read back as the same bits. Without a proof, a value that is only rounding error is written as 0.
pub fn table(solution: &Solution, positions: &[f64], context: &Context) -> String {
    let mut rows = Rows::new();
    let (units, proof) = (context.units, context.proofs.first());
    let place = units.column(Kind::Position);
    let listed = Field::of(&solution.model().beam);
    let names = listed.clone().flat_map(|field| {
        let unit = units.column(Kind::of(field));
        let bound = || column(&format!("{}_bound", field.name()), unit);
        [column(field.name(), unit)].into_iter().chain(proof.map(|_| bound()))
    });
    rows.push(std::iter::once(column("x", place)).chain(names));
    let (jumps, sizes) = (Jumps::of(solution), Sizes::of(solution));
    for &x in positions {
        let (left, right) = jumps.rows(solution, x);
        for fields in left.iter().chain([&right]) {
            let cells = listed.clone().flat_map(|field| {
                let unit = units.column(Kind::of(field));
                let bound = proof.map(|named| bound_alone(unit.upper(named.error_at(field, x))));
                let value = match proof {
                    None => sizes.value(field, fields.get(field)),
                    Some(_) => fields.get(field),
                };
                [number(value, unit)].into_iter().chain(bound)
            });
            rows.push(std::iter::once(number(x, place)).chain(cells));
        }
    }
    rows.finish()
}

/// Returns a CSV table of the envelope of all combinations, with columns such as `deflection_min_m` and
/// `deflection_governs_min`. With proofs, columns such as `deflection_min_bound_m` are added.
///
/// The values on both sides of a jump count. If combinations have limit states, the rows for each limit state follow
/// the rows for `all` combinations, and the last column contains the limit state.
pub fn envelope(answers: &Answers, positions: &[f64], context: &Context) -> String {
    let (units, solved) = (context.units, numbered(answers, context));
    let have_bounds = !context.proofs.is_empty();
    let ends = || ["min", "max"].into_iter();
    let names = answers.envelope().fields().flat_map(|field| {
        let (name, unit) = (field.name(), units.column(Kind::of(field)));
        let values = ends().map(move |end| column(&format!("{name}_{end}"), unit));
        let bounds = ends().map(move |end| column(&format!("{name}_{end}_bound"), unit));
        let governs = ends().map(move |end| format!("{name}_governs_{end}"));
        values.chain(bounds.filter(move |_| have_bounds)).chain(governs)
    });
    let of_state = |state: Option<LimitState>| {
        let rows = match state {
            None => solved.clone(),
            Some(state) => of_limit_state(answers, &solved, state),
        };
        let envelope = Envelope::of(rows.iter().map(|row| row.solution));
        move |x: f64| {
            let all = envelope.all_at(x);
            let cells = envelope.fields().flat_map(|field| {
                let Bounds { min, max } = all[field.index()];
                let unit = units.column(Kind::of(field));
                let values = [min, max].map(|governing| governing.extreme.value);
                let bounds = have_bounds.then(|| bounds_at(&rows, field, x, values));
                let bounds = bounds.into_iter().flatten();
                let bounds = bounds.map(move |bound| bound_alone(unit.upper(bound)));
                let cleaned = [min, max].map(|governing| match rows.get(governing.by) {
                    Some(row) if !have_bounds => row.sizes.value(field, governing.extreme.value),
                    _ => governing.extreme.value,
                });
                let name = |by: usize| match rows.get(by) {
                    Some(row) => answers.list[row.number - 1].name().to_owned(),
                    None => String::new(),
                };
                let values = cleaned.map(|value| number(value, unit));
                values.into_iter().chain(bounds).chain([name(min.by), name(max.by)])
            });
            Some(cells.collect())
        }
    };
    enveloped(names, answers.limit_states(), of_state, positions, units)
}

/// Returns a CSV table of the envelope of passages, with rows as in [`envelope`]. Columns such as
/// `deflection_governs_min_m` contain the position of the first axle. With several passages, columns such as
/// `deflection_in_min` contain the label of the passage.
pub fn trains(passages: &Passages, sections: &[f64], units: Units) -> String {
    let place = units.column(Kind::Position);
    let labels: Vec<String> = passages.all.iter().map(Passage::label).collect();
    let several = labels.len() > 1;
    let names = passages.fields().flat_map(|field| {
        let unit = units.column(Kind::of(field));
        let bound = |bound| column(&format!("{}_{bound}", field.name()), unit);
        let governs = |bound| column(&format!("{}_governs_{bound}", field.name()), place);
        let which = ["min", "max"].map(|bound| format!("{}_in_{bound}", field.name()));
        let which = which.into_iter().filter(move |_| several);
        [bound("min"), bound("max"), governs("min"), governs("max")].into_iter().chain(which)
    });
    let labels = &labels;
    let of_state = |state: Option<LimitState>| {
        let of_state =
            state.map_or_else(|| passages.clone(), |state| passages.of_limit_state(state));
        let mut rounding = Rounding::new(passages);
        move |x: f64| {
            let mut cells = Vec::new();
            let bounds = of_state.at(x)?;
            for field in of_state.fields() {
                let both = bounds[field.index()];
                let unit = units.column(Kind::of(field));
                let value = |found: &InPassage| number(rounding.value(field, found), unit);
                cells.extend(both.iter().map(value));
                cells.extend(both.iter().map(|found| number(found.located.first_axle, place)));
                let which = both.iter().map(|found| labels[found.passage].clone());
                cells.extend(which.filter(|_| several));
            }
            Some(cells)
        }
    };
    enveloped(names, passages.limit_states(), of_state, sections, units)
}

/// Returns the CSV table of an envelope: the rows over all results, then those of each limit state. The function that
/// `of_state` returns gives the cells of the row at a position, or `None` to omit the row.
fn enveloped<R: FnMut(f64) -> Option<Vec<String>>>(
    names: impl Iterator<Item = String>,
    states: LimitStates,
    of_state: impl Fn(Option<LimitState>) -> R,
    positions: &[f64],
    units: Units,
) -> String {
    let mut rows = Rows::new();
    let place = units.column(Kind::Position);
    let has_states = !states.is_empty();
    let last = has_states.then(|| "limit_state".to_owned());
    rows.push(std::iter::once(column("x", place)).chain(names).chain(last));
    for state in std::iter::once(None).chain(states.iter().map(Some)) {
        let mut cells = of_state(state);
        let name = state.map_or("all", LimitState::name);
        for &x in positions {
            let Some(cells) = cells(x) else { continue };
            let last = has_states.then(|| name.to_owned());
            rows.push(std::iter::once(number(x, place)).chain(cells).chain(last));
        }
    }
    rows.finish()
}

/// Returns a CSV table of all steps of the iteration, with the header `step, zones, part, decrement`.
///
/// `zones` counts the contact zones. `part` is the accepted fraction of the Newton step, or Uzawa's step parameter ρ.
/// [`groundbeam::Step`] defines `decrement`.
pub fn history(solution: &Solution) -> String {
    let mut rows = Rows::new();
    rows.push(["step", "zones", "part", "decrement"].map(str::to_owned));
    for (i, step) in solution.history().iter().enumerate() {
        let zones = step.zones.to_string();
        rows.push([(i + 1).to_string(), zones, ratio(step.step), ratio(step.decrement)]);
    }
    rows.finish()
}

/// Formats a number in a unit as the shortest text that is read back as the same bits.
fn number(value: f64, unit: Unit) -> String {
    match unit.size {
        1.0 => ratio(value),
        // The last bits of the quotient are rounding error. They are dropped, so that 0.12192 m is written as
        // 0.4 ft.
        size => ratio(format!("{:.14e}", value / size).parse().unwrap_or(f64::NAN)),
    }
}

/// Formats a plain number.
fn ratio(value: f64) -> String {
    // −0 is written as 0.
    format!("{:?}", value + 0.0)
}

fn column(name: &str, unit: Unit) -> String {
    match unit.name {
        "" => name.to_owned(),
        unit => format!("{name}_{}", unit.replace(' ', "").replace('-', "_").replace('/', "_per_")),
    }
}

/// Writes CSV rows of equal length to memory, which cannot fail.
struct Rows(Writer<Vec<u8>>);

impl Rows {
    fn new() -> Self {
        Rows(WriterBuilder::new().from_writer(Vec::new()))
    }

    /// Adds a row. Control characters in names from the file are escaped, because a terminal may show the
    /// table.
    fn push(&mut self, cells: impl IntoIterator<Item = String>) {
        let cells = cells.into_iter().map(|cell| printable(&cell).into_owned());
        let written = self.0.write_record(cells);
        debug_assert!(written.is_ok(), "{written:?}");
    }

    fn finish(self) -> String {
        let bytes = self.0.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }
}
