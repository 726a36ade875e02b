//! Writes the calculation report of all combinations: each result, and the envelope with the governing combination.

use super::content::{Block, Key, Report, Section, Table, Verdict, facts, numbers, wording};
use super::single::{certified, checked, overview, place, proven};
use super::{Source, given, print, proof};
use crate::bound::{not_proven, rounded_with_bound};
use crate::checked::rows_of;
use crate::checked::verdicts;
use crate::combinations::{Numbered, bound_of_extreme, noun, numbered, of_limit_state};
use crate::context::{Context, clean};
use crate::extremes::{Extremes, of_combinations};
use crate::number::significant;
use crate::quantity::{Kind, Unit, Units};
use crate::svg::figures;
use crate::text;
use crate::text::sheet::Tone;
use crate::verdict;
use groundbeam::{
    Existence, Field, Method,
    design::LimitState,
    envelope::{Envelope, Governing},
    solution::Extreme,
};
use groundbeam_file::Combination;
use groundbeam_run::{Answers, Found, Overall};

/// The report of all combinations.
pub(super) fn combinations(all: &Answers, context: &Context, source: &Source) -> Report {
    let Some(first) = all.list.first() else { return Report::default() };
    let existence = first.existence().copied();
    let existence = existence.or_else(|| groundbeam::exists(first.model()).ok());
    let ground = first.ground.as_ref().filter(|ground| !ground.follows_solution());
    let of_first = Context { ground, ..*context };
    let used = text::used_models(all);
    let models = used.clone().unwrap_or_else(|| vec![first.model()]);
    let mut given = given::section(&models, existence.as_ref(), None, &of_first, source);
    given.blocks.extend(used.and_then(|used| {
        let (ground, units) = (first.ground.as_ref(), context.units);
        facts(|sheet| text::ground_of_each(sheet, "combination", ground, &used, units))
    }));
    given.blocks.push(list(all));
    let solved: Vec<Numbered> = numbered(all, context);
    let have_bounds = !context.proofs.is_empty();
    let method = solved.first().map_or(Method::Exact, |row| row.solution.method());
    let rows = rows_of(all, context);
    let checks = facts(|sheet| text::checks::all_rows(sheet, &rows, context));
    let picture = governing(all, context);
    let mut sections: Vec<Section> =
        picture.map(|picture| overview(checks, picture)).into_iter().collect();
    let assumptions = given::assumptions(first.model(), method);
    sections.extend([given, assumptions, statics(all, context.units)]);
    let mut said = vec![overall(all)];
    let mut key = Vec::new();
    if !solved.is_empty() {
        said.extend(checked(&verdicts(context.limits, &rows)));
        let gaps = solved.iter().map(|row| row.solution.certificate().relative_gap());
        let gap = gaps.fold(0.0, f64::max);
        said.push(certified(gap));
        said.extend(proven(context.proofs));
        key = keys(all, &solved, context);
        sections.extend(match have_bounds {
            true => [bounded(all, &solved, context.units), bounded_envelope(all, &solved, context)],
            false => [each(all, &solved, context.units), envelope(all, &solved, context.units)],
        });
        sections.push(diagrams(all, context.units));
        sections.push(proof::certificates(|sheet| {
            let of = format!("for each of the {} solved", solved.len());
            text::certificate::of_several(sheet, &of, gap);
        }));
    }
    sections.extend(proof::proof(context));
    sections.extend(proof::provenance(context, source));
    Report {
        subject: "Beam on ground: combinations of load cases",
        verdicts: said,
        key,
        sections,
        ..Report::default()
    }
}

fn overall(all: &Answers) -> Verdict {
    let count = all.list.len();
    let (tone, head, words) = match all.overall() {
        Overall::Solved => ("good", "In equilibrium", format!("all {count} combinations")),
        Overall::NoEquilibrium => {
            let none = all.list.iter().filter(|c| matches!(c.found, Found::NoEquilibrium(_)));
            ("bad", "No equilibrium", format!("in {} of {count} combinations", none.count()))
        }
        Overall::NotConverged => {
            let none = all.list.iter().filter(|c| matches!(c.found, Found::NotConverged(_)));
            ("bad", "Not solved", format!("{} of {count} combinations", none.count()))
        }
    };
    Verdict { tone, head: head.to_owned(), words }
}

/// Returns the table of the names, factors and limit states of the combinations.
fn list(all: &Answers) -> Block {
    let has_states =
        all.list.iter().any(|answer| !answer.label.combination.limit_states.is_empty());
    let mut columns = vec![numbers("#", ""), wording("combination"), wording("load cases")];
    columns.extend(has_states.then(|| wording("limit state")));
    let mut table = Table::new(noun(all), columns);
    for (i, answer) in all.list.iter().enumerate() {
        let Combination { name, factors, ground, limit_states, .. } = &*answer.label.combination;
        let terms = factors.iter().filter(|(_, factor)| *factor != 0.0);
        let terms: Vec<String> = terms
            .map(|(case, factor)| format!("{} {}", significant(*factor, 6), clean(case)))
            .collect();
        let mut words = terms.join(" + ").replace("+ -", "− ");
        if let Some([spring, shear]) = ground {
            let [spring, shear] = [spring, shear].map(|factor| significant(*factor, 6));
            let ground = format!("ground {spring} k, {shear} μ");
            words = if words.is_empty() { ground } else { format!("{words}; {ground}") };
        }
        let states: Vec<&str> = limit_states.iter().map(LimitState::name).collect();
        let states = has_states.then(|| states.join(", "));
        table.push([(i + 1).to_string(), clean(name), words].into_iter().chain(states));
    }
    Block::Table(table)
}

/// Returns the section on the existence check of each combination and of each load case alone.
fn statics(all: &Answers, units: Units) -> Section {
    let heads = |what: &str| {
        vec![
            numbers("#", ""),
            wording(what),
            numbers("R₀", force_unit(all, units)),
            numbers("R_l", force_unit(all, units)),
            wording("equilibrium"),
        ]
    };
    let mut table =
        Table::new("Existence of an equilibrium for each combination", heads("combination"));
    let unit = units.unit(Kind::Force, largest_reaction(all));
    let row = |number: usize, name: &str, model, existence: &Existence| {
        let sentence = verdict::sentence(model, existence, units);
        let wording = verdict::wording(existence.verdict);
        let said = match wording.tone {
            Tone::Good => wording.words.to_owned(),
            _ => wording.with(&print::words(&sentence)),
        };
        let [left, right] = existence.static_reactions.map(|force| unit.number(force));
        [number.to_string(), clean(name), left, right, said]
    };
    for (i, answer) in all.list.iter().enumerate() {
        match answer.existence() {
            Some(existence) => table.push(row(i + 1, answer.name(), answer.model(), existence)),
            None => table.push([
                (i + 1).to_string(),
                clean(answer.name()),
                String::new(),
                String::new(),
                "not solved".to_owned(),
            ]),
        }
    }
    let mut blocks = vec![Block::Table(table)];
    if !all.alone.is_empty() {
        let mut alone = Table::new("Each load case alone", heads("case"));
        alone.note = "A load case without equilibrium is not a physical state. \
                      A combination that contains it may have an equilibrium."
            .into();
        for (i, case) in all.alone.iter().enumerate() {
            alone.push(row(i + 1, &case.case.name, &case.case.model, &case.existence));
        }
        blocks.push(Block::Table(alone));
    }
    Section::new("Equilibrium", blocks)
}

fn largest_reaction(all: &Answers) -> f64 {
    let each = all.list.iter().filter_map(|answer| answer.existence());
    each.flat_map(|existence| existence.static_reactions)
        .fold(0.0, |most, force| most.max(force.abs()))
}

fn force_unit(all: &Answers, units: Units) -> &'static str {
    units.unit(Kind::Force, largest_reaction(all)).name
}

/// Returns the section with a table of contact zones and extremes, with one row per combination.
fn each(all: &Answers, solved: &[Numbered], units: Units) -> Section {
    let value = |row: &Numbered, (field, largest): (Field, bool)| {
        let range = row.solution.range(field);
        row.sizes.extreme(field, if largest { range.max } else { range.min }).value
    };
    let extremes: Vec<_> = text::COLUMNS.into_iter().chain([(Field::Gap, true)]).collect();
    let most = |of: Field| {
        let same = extremes.iter().filter(move |column| column.0 == of);
        let sizes = same.flat_map(|&of| solved.iter().map(move |row| value(row, of).abs()));
        sizes.fold(0.0, f64::max)
    };
    let in_units = extremes.iter().map(|&(field, _)| units.unit(Kind::of(field), most(field)));
    let in_units: Vec<Unit> = in_units.collect();
    let forces = solved.iter().map(|row| row.solution.end_forces());
    let force = forces.fold(0.0_f64, |most, ends| most.max(ends.left).max(ends.right));
    let force = units.unit(Kind::Force, force);
    let mut columns = vec![numbers("#", ""), wording("touches"), numbers("lifted", "%")];
    let heads = extremes.iter().map(|&(field, largest)| text::extreme_of(field, largest));
    columns.extend(heads.zip(&in_units).map(|(head, unit)| numbers(&head, unit.name)));
    columns.extend([numbers("p₀", force.name), numbers("p_l", force.name)]);
    let mut table = Table::new("Contact and extremes of every combination", columns);
    let x = units.unit(Kind::Position, all.list.first().map_or(1.0, |c| c.model().beam.length));
    for row in solved {
        let zones: Vec<String> = row
            .solution
            .contact()
            .iter()
            .map(|zone| {
                let [from, to] = [zone.from, zone.to].map(|at| x.number(row.sizes.position(at)));
                if from == to { from } else { format!("{from} to {to}") }
            })
            .collect();
        let zones = match zones.len() {
            0..=3 => zones.join(", "),
            many => format!("{many} zones"),
        };
        let share = significant(100.0 * row.solution.lifted_share(), 3);
        let cells = extremes.iter().zip(&in_units);
        let cells = cells.map(|(&of, unit)| unit.number(value(row, of)));
        let ends = row.solution.end_forces();
        let ends = [ends.left, ends.right].map(|end| force.number(row.sizes.force(end)));
        table.push([row.number.to_string(), zones, share].into_iter().chain(cells).chain(ends));
    }
    Section::new("Every combination", vec![Block::Table(table)])
}

/// Returns the section with the contact zones, forces and extremes of every combination, with error bounds.
fn bounded(all: &Answers, solved: &[Numbered], units: Units) -> Section {
    let mut blocks = Vec::new();
    for row in solved {
        let name = clean(all.list[row.number - 1].name());
        blocks.push(Block::Text { words: format!("#{} {name}", row.number) });
        blocks.extend(facts(|sheet| text::results(sheet, row.solution, &row.numbers(units))));
    }
    Section::new("Every combination", blocks)
}

/// Returns the section with the extremes over all combinations and over the range of ground stiffness, with
/// error bounds.
fn bounded_envelope(all: &Answers, solved: &[Numbered], context: &Context) -> Section {
    let block = facts(|sheet| {
        text::bounded_envelope(sheet, &all.envelope(), solved, context.units);
        text::of_limit_states(sheet, all, solved, context);
        text::bounded_band(sheet, all, solved, context.units);
    });
    Section::new("Envelope", block.into_iter().collect())
}

/// Returns the section with the extremes over all combinations and for each limit state, with the governing
/// combination.
fn envelope(all: &Answers, solved: &[Numbered], units: Units) -> Section {
    let caption = "Envelope: smallest and largest values, and the governing combination";
    let mut blocks = vec![Block::Table(extremes(caption, all, solved, units))];
    for state in all.limit_states().iter() {
        let of_state = of_limit_state(all, solved, state);
        if of_state.len() == solved.len() {
            blocks.push(all_of(state));
            continue;
        }
        let caption = format!("Envelope of the limit state {}", state.name());
        blocks.push(Block::Table(extremes(&caption, all, &of_state, units)));
    }
    Section::new("Envelope", blocks)
}

/// A sentence that replaces the envelope of a limit state if this envelope equals the envelope of all
/// combinations.
pub(super) fn all_of(state: LimitState) -> Block {
    Block::Text { words: text::all_of(state) }
}

/// Returns the table of the extremes over the combinations in `solved`.
fn extremes(caption: &str, all: &Answers, solved: &[Numbered], units: Units) -> Table {
    let envelope = Envelope::of(solved.iter().map(|row| row.solution));
    let length = all.list.first().map_or(1.0, |answer| answer.model().beam.length);
    table_of(
        caption,
        &of_combinations(&envelope, solved, units),
        units.unit(Kind::Position, length),
    )
}

/// Returns a table of extremes with their positions, the positions of the first axle, and the numbers of the
/// governing combinations or passages.
pub(super) fn table_of(caption: &str, all: &[Extremes], x: Unit) -> Table {
    let ends = || all.iter().flat_map(|of| of.ends);
    let has_axle = ends().any(|end| end.first_axle.is_some());
    let has_number = ends().any(|end| end.number.is_some());
    let bound = |head: &str| {
        let mut columns = vec![numbers(head, ""), numbers("at x", x.name)];
        columns.extend(has_axle.then(|| numbers("axle at", x.name)));
        columns.extend(has_number.then(|| numbers("#", "")));
        columns
    };
    let (smallest, largest) = (bound("smallest"), bound("largest"));
    let mut columns = vec![wording("quantity")];
    columns.extend(smallest.into_iter().chain(largest));
    columns.push(wording("unit"));
    let mut table = Table::new(caption, columns);
    for Extremes { field, unit, ends } in all {
        let cells = ends.iter().flat_map(|end| {
            let axle = end.first_axle.map(|at| x.number(at));
            let number = end.number.map(|number| number.to_string());
            [unit.number(end.value), x.number(end.x)].into_iter().chain(axle).chain(number)
        });
        let name = [field.label().to_owned()];
        table.push(name.into_iter().chain(cells).chain([unit.name.to_owned()]));
    }
    table
}

/// Returns an extreme and the number of its combination. An extreme that is only rounding error is set to
/// zero.
fn known(governing: Governing, field: Field, solved: &[Numbered]) -> (Extreme, usize) {
    let Governing { extreme, by } = governing;
    match solved.get(by) {
        Some(row) => (row.sizes.extreme(field, extreme), row.number),
        None => (extreme, 0),
    }
}

fn keys(all: &Answers, solved: &[Numbered], context: &Context) -> Vec<Key> {
    let (envelope, units) = (all.envelope(), context.units);
    let largest = |field: Field| {
        let range = envelope.range(field);
        let [min, max] = [range.min, range.max].map(|governing| known(governing, field, solved));
        let is_max = -min.0.value <= max.0.value;
        let (extreme, number) = if is_max { max } else { min };
        let (value, at) = if context.proofs.is_empty() {
            (units.write(Kind::of(field), extreme.value), place(units, extreme.x))
        } else {
            let governing = if is_max { range.max } else { range.min };
            let Extreme { x, value } = governing.extreme;
            let (error, _) = bound_of_extreme(solved, field, is_max, governing);
            let value = rounded_with_bound(value, error, units.unit(Kind::of(field), value), 4);
            (value, not_proven(&place(units, x)))
        };
        let note = print::words(&format!("at x = {at}, #{number}"));
        Key::largest(field, print::words(&value), note)
    };
    Key::FIELDS.map(largest).into()
}

/// Returns the picture of the combination with the largest moment; `None` if no combination is solved.
fn governing(all: &Answers, context: &Context) -> Option<Block> {
    all.solved().next()?;
    let range = all.envelope().range(Field::Moment);
    let most =
        if -range.min.extreme.value > range.max.extreme.value { range.min } else { range.max };
    let (answer, solution) = all.solved().nth(most.by)?;
    Some(Block::Figure {
        svg: figures::bent(solution, context),
        caption: format!(
            "The beam under {}, the combination with the largest moment",
            clean(answer.name())
        ),
    })
}

/// Returns the section with the figures of the envelopes.
fn diagrams(all: &Answers, units: Units) -> Section {
    let drawn = figures::combinations(all, units).into_iter().zip(figures::OF_ENVELOPES);
    let figures = drawn.map(|(svg, field)| Block::Figure {
        svg,
        caption: format!("{}: envelope, and every combination as a thin line", field.title()),
    });
    Section::new("Diagrams", figures.collect())
}
