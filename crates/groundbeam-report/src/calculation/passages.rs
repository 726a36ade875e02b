//! Writes the calculation report of moving trains, with the envelope over all train positions.

use super::content::{Block, Key, Report, Section, Table, Verdict, facts};
use super::several::{all_of, table_of};
use super::single::{certified, checked, overview, place};
use super::{Source, given, print, proof};
use crate::checked::verdicts;
use crate::context::{Context, clean};
use crate::extremes::of_passages;
use crate::quantity::{Kind, Units};
use crate::svg::figures;
use crate::text::{self, train};
use groundbeam::{Field, Method};
use groundbeam_run::{Ground, Overall, Passage, Passages};

/// Returns the report of all passages.
pub(super) fn trains(passages: &Passages, context: &Context, source: &Source) -> Report {
    let all = &passages.all[..];
    let first = all.iter().find_map(|passage| passage.solved().next());
    let model = first.map_or(source.model, |(_, solution)| solution.model());
    let existence = first.map(|(_, solution)| *solution.existence());
    let existence = existence.or_else(|| groundbeam::exists(source.model).ok());
    let follows = context.ground.is_some_and(Ground::follows_solution) && first.is_some();
    let models = if follows { text::used_by_trains(all) } else { vec![model] };
    let ground = context.ground.filter(|_| !follows);
    let of_input = Context { ground, ..*context };
    let mut given = given::section(&models, existence.as_ref(), None, &of_input, source);
    if follows {
        given.blocks.extend(facts(|sheet| {
            text::ground_of_each(sheet, "position", context.ground, &models, context.units);
        }));
    }
    given.blocks.extend(facts(|sheet| {
        all.iter().for_each(|passage| train::head(sheet, passage, context.units));
        train::places(sheet, all);
    }));
    let method = first.map_or(Method::Exact, |(_, solution)| solution.method());
    let mut sections = Vec::new();
    let mut drawn = diagrams(passages, context);
    if first.is_some() && !drawn.blocks.is_empty() {
        let checks = facts(|sheet| train::limits(sheet, all, context));
        sections.push(overview(checks, drawn.blocks.remove(0)));
    }
    sections.extend([given, given::assumptions(model, method), ways(all, context)]);
    let mut said = vec![overall(passages)];
    let mut key = Vec::new();
    if first.is_some() {
        let solved = || all.iter().flat_map(Passage::solved);
        let positions = train::positions_of(all, context);
        said.extend(checked(&verdicts(context.limits, &positions)));
        let gaps = solved().map(|(_, solution)| solution.certificate().relative_gap());
        said.push(certified(gaps.fold(0.0, f64::max)));
        key = keys(passages, context.units);
        sections.push(envelope(passages, context.units));
        sections.push(drawn);
        let untimed = Context { seconds: None, ..*context };
        sections.push(proof::certificates(|sheet| train::proof(sheet, all, &untimed)));
    }
    sections.extend(proof::provenance(context, source));
    Report {
        subject: "Beam on ground under moving trains",
        verdicts: said,
        key,
        sections,
        ..Report::default()
    }
}

fn overall(passages: &Passages) -> Verdict {
    let count: usize = passages.all.iter().map(|passage| passage.solved().count()).sum();
    let solved = format!("at each of the {count} train positions for which the model was solved");
    let (tone, head, words) = match passages.overall() {
        Overall::NoEquilibrium => {
            ("bad", "No equilibrium", "at some positions of a train".to_owned())
        }
        Overall::NotConverged => {
            ("bad", "Not solved", "some positions have no certified result".to_owned())
        }
        Overall::Solved => ("good", "In equilibrium", solved),
    };
    Verdict { tone, head: head.to_owned(), words }
}

/// Returns the section on the train positions with a solution and those without equilibrium.
fn ways(all: &[Passage], context: &Context) -> Section {
    let blocks = facts(|sheet| {
        for (i, passage) in all.iter().enumerate() {
            if all.len() > 1 {
                sheet.row("Passage", &format!("#{}, {}", i + 1, clean(&passage.label())));
            }
            train::positions(sheet, passage);
            train::failures(sheet, passage, "", context.units);
        }
    });
    Section::new("Positions and equilibrium", blocks.into_iter().collect())
}

/// Returns the section with the extremes over all passages and the extremes for each limit state.
fn envelope(passages: &Passages, units: Units) -> Section {
    let caption =
        "Envelope over all train positions, with the position of the first axle for each value";
    let mut blocks = vec![Block::Table(extremes(caption, passages, units))];
    for state in passages.limit_states().iter() {
        if passages.all.iter().all(|passage| passage.limit_states().contains(state)) {
            blocks.push(all_of(state));
            continue;
        }
        let caption = format!("Envelope of the limit state {}", state.name());
        let of_state = passages.of_limit_state(state);
        blocks.push(Block::Table(extremes(&caption, &of_state, units)));
    }
    blocks.extend(facts(|sheet| {
        for (i, passage) in passages.all.iter().enumerate() {
            if passages.all.len() > 1 {
                sheet.row("Passage", &format!("#{}", i + 1));
            }
            train::uplift(sheet, passage, units);
        }
        text::free_spans::of_trains(sheet, &passages.all, units);
    }));
    Section::new("Envelope", blocks)
}

/// Returns a table of the extremes, each with its position, the position of the first axle, and the passage.
fn extremes(caption: &str, passages: &Passages, units: Units) -> Table {
    let length = passages.all.first().map_or(1.0, |passage| passage.model().beam.length);
    table_of(caption, &of_passages(passages, units), units.unit(Kind::Position, length))
}

fn keys(passages: &Passages, units: Units) -> Vec<Key> {
    let all = of_passages(passages, units);
    let largest = |field: Field| {
        let most = all.iter().find(|extremes| extremes.field == field)?.largest();
        let axle = place(units, most.first_axle?);
        let note = format!("at x = {}, first axle at {axle}", place(units, most.x));
        let value = print::words(&units.write(Kind::of(field), most.value));
        Some(Key::largest(field, value, print::words(&note)))
    };
    Key::FIELDS.into_iter().filter_map(largest).collect()
}

/// Returns the section with the envelopes, and with a picture of the train position that causes the largest
/// moment.
fn diagrams(passages: &Passages, context: &Context) -> Section {
    let units = context.units;
    let governing = passages.largest_moment().and_then(|most| {
        let passage = passages.all.get(most.passage)?;
        let (first_axle, solution) = passage.nearest(most.located.first_axle)?;
        let at = units.position(first_axle);
        let caption = format!(
            "{} at the train position with the largest moment, first axle at {}",
            clean(&passage.label()),
            print::words(&at)
        );
        Some(Block::Figure { svg: figures::bent(solution, context), caption })
    });
    let captions = ["Deflection", "Contact pressure", "Bending moment", "Shear force"];
    let envelopes = figures::trains(passages, units).into_iter().zip(captions);
    let envelopes = envelopes.map(|(svg, field)| Block::Figure {
        svg,
        caption: format!("{field}: envelope of all positions"),
    });
    let blocks = governing.into_iter().chain(envelopes).collect();
    Section::new("Diagrams", blocks)
}
