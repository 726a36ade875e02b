//! Writes tables: fields along the beam, the envelope of combinations, and the history of the iteration.

use crate::bound::bound_alone;
use crate::combinations::{Numbered, bounds_at, numbered, of_limit_state};
use crate::context::Context;
use crate::curve::Jumps;
use crate::quantity::{Kind, Unit, Units};
use ::csv::{Writer, WriterBuilder};
use groundbeam::{
    Field, Solution,
    envelope::{Bounds, Envelope},
};
use groundbeam_file::printable;
use groundbeam_run::{Answers, InPassage, Passage, Passages};

/// All fields at the given positions, in base SI units or in the US units of the file:
/// `x_m, deflection_m, …`. For plain numbers the header has no units. If a proof is requested, a column with
/// the error bound follows each field: `deflection_bound_m`.
///
/// Where a field jumps (at point loads, supports and contact edges) the position has two rows: first the
/// values just to the left, then those just to the right. Numbers have enough digits to read back the same
/// bits.
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
    let jumps = Jumps::of(solution);
    for &x in positions {
        let (left, right) = jumps.rows(solution, x);
        for fields in left.iter().chain([&right]) {
            let cells = listed.clone().flat_map(|field| {
                let unit = units.column(Kind::of(field));
                let bound = proof.map(|named| bound_alone(unit.upper(named.error_at(field, x))));
                [number(fields.get(field), unit)].into_iter().chain(bound)
            });
            rows.push(std::iter::once(number(x, place)).chain(cells));
        }
    }
    rows.finish()
}

/// The envelope of all combinations at the given positions:
/// `x_m, deflection_min_m, deflection_max_m, deflection_governs_min, deflection_governs_max, …`. If proofs
/// are requested, the error bounds follow the values: `deflection_min_bound_m, deflection_max_bound_m`.
///
/// Where a field jumps, both sides count. If combinations have limit states, the last column names the limit
/// state of the row: the rows of `all` combinations come first, then those of each limit state.
pub fn envelope(answers: &Answers, positions: &[f64], context: &Context) -> String {
    let mut rows = Rows::new();
    let (units, solved) = (context.units, numbered(answers, context));
    let states = answers.limit_states();
    let place = units.column(Kind::Position);
    let have_bounds = !context.proofs.is_empty();
    let ends = || ["min", "max"].into_iter();
    let envelope = answers.envelope();
    let names = envelope.fields().flat_map(|field| {
        let (name, unit) = (field.name(), units.column(Kind::of(field)));
        let values = ends().map(move |end| column(&format!("{name}_{end}"), unit));
        let bounds = ends().map(move |end| column(&format!("{name}_{end}_bound"), unit));
        let governs = ends().map(move |end| format!("{name}_governs_{end}"));
        values.chain(bounds.filter(move |_| have_bounds)).chain(governs)
    });
    let last = (!states.is_empty()).then(|| "limit_state".to_owned());
    rows.push(std::iter::once(column("x", place)).chain(names).chain(last));
    let all = (!states.is_empty()).then_some("all");
    let shown = |last| (positions, last, units);
    enveloped(&mut rows, answers, &envelope, &solved, shown(all));
    for state in states.iter() {
        let of_state = of_limit_state(answers, &solved, state);
        let envelope = Envelope::of(of_state.iter().map(|row| row.solution));
        enveloped(&mut rows, answers, &envelope, &of_state, shown(Some(state.name())));
    }
    rows.finish()
}

/// Rows of an envelope over some of the answers.
fn enveloped(
    rows: &mut Rows,
    answers: &Answers,
    envelope: &Envelope,
    solved: &[Numbered],
    (positions, last, units): (&[f64], Option<&str>, Units),
) {
    let have_bounds = solved.iter().any(|row| row.proof.is_some());
    let place = units.column(Kind::Position);
    for &x in positions {
        let bounds = envelope.all_at(x);
        let cells = envelope.fields().flat_map(|field| {
            let Bounds { min, max } = bounds[field.index()];
            let values = [min, max].map(|governing| governing.extreme.value);
            let bounds = have_bounds.then(|| bounds_at(solved, field, x, values));
            let unit = units.column(Kind::of(field));
            let bounds =
                bounds.into_iter().flatten().map(move |bound| bound_alone(unit.upper(bound)));
            let name = |by: usize| {
                solved.get(by).map_or("", |row| answers.list[row.number - 1].name()).to_owned()
            };
            let values = values.map(|value| number(value, unit));
            values.into_iter().chain(bounds).chain([name(min.by), name(max.by)])
        });
        let last = last.map(str::to_owned);
        rows.push(std::iter::once(number(x, place)).chain(cells).chain(last));
    }
}

/// The envelope of passages at the given sections, as [`envelope`]. The governing columns contain the
/// position of the first axle; with several passages also the passage,
/// `deflection_in_min, deflection_in_max`.
pub fn trains(passages: &Passages, sections: &[f64], units: Units) -> String {
    let mut rows = Rows::new();
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
    let states = passages.limit_states();
    let last = (!states.is_empty()).then(|| "limit_state".to_owned());
    rows.push(std::iter::once(column("x", place)).chain(names).chain(last));
    let of_all = std::iter::once((passages.clone(), "all"));
    let of_each = states.iter().map(|state| (passages.of_limit_state(state), state.name()));
    let each: Vec<(Passages, &str)> = of_all.chain(of_each).collect();
    for (x, (passages, state)) in
        each.iter().flat_map(|each| sections.iter().map(move |&x| (x, each)))
    {
        let bounds = passages.at(x);
        let cells = passages.fields().filter_map(|field| Some((field, bounds?[field.index()])));
        let cells = cells.flat_map(|(field, [min, max])| {
            let [a, b] = [min.located, max.located];
            let unit = units.column(Kind::of(field));
            let values = [a, b].map(|located| number(located.value, unit));
            let places = [a, b].map(|located| number(located.first_axle, place));
            let numbers = values.into_iter().chain(places);
            let which = [min, max].map(|InPassage { passage, .. }| labels[passage].clone());
            numbers.chain(which.into_iter().filter(|_| several))
        });
        let last = (!states.is_empty()).then(|| (*state).to_owned());
        rows.push(std::iter::once(number(x, place)).chain(cells).chain(last));
    }
    rows.finish()
}

/// All steps of the iteration: `step, zones, part, decrement`.
///
/// `zones` is the number of contact zones. `part` is the fraction of the Newton step (for Uzawa's iteration
/// its parameter). `decrement` is the energy minus its minimum, relative to the strain energy (for Uzawa's
/// iteration the relative change of the pressure).
pub fn history(solution: &Solution) -> String {
    let mut rows = Rows::new();
    rows.push(["step", "zones", "part", "decrement"].map(str::to_owned));
    for (i, step) in solution.history().iter().enumerate() {
        let zones = step.zones.to_string();
        rows.push([(i + 1).to_string(), zones, ratio(step.step), ratio(step.decrement)]);
    }
    rows.finish()
}

/// The shortest text that reads back as the same bits.
fn number(value: f64, unit: Unit) -> String {
    match unit.size {
        1.0 => ratio(value),
        // The last bits of a quotient are rounding: 0.12192 m are 0.4 ft.
        size => ratio(format!("{:.14e}", value / size).parse().unwrap_or(f64::NAN)),
    }
}

/// A plain number.
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

/// Rows in memory, where writing cannot fail.
struct Rows(Writer<Vec<u8>>);

impl Rows {
    fn new() -> Self {
        Rows(WriterBuilder::new().from_writer(Vec::new()))
    }

    /// Names from the file are escaped, because a table may be shown on a terminal.
    fn push(&mut self, cells: impl IntoIterator<Item = String>) {
        let _ = self.0.write_record(cells.into_iter().map(|cell| printable(&cell).into_owned()));
    }

    fn finish(self) -> String {
        let bytes = self.0.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }
}
