//! Writes the calculation report of one model: its equilibrium, or the reason why it has no result.

use super::content::{Block, Key, Report, Section, Table, Verdict, facts, numbers, wording};
use super::{Source, given, print, proof};
use crate::checked::{Row, Verdict as Judged, verdicts};
use crate::context::Context;
use crate::numbers::Numbers;
use crate::quantity::{Kind, Units};
use crate::size::Sizes;
use crate::svg::figures;
use crate::text;
use crate::verdict;
use crate::verified::Named;
use groundbeam::{
    Existence, Field, Model, Solution, Stopped, Verdict as Stands, solution::Extreme,
};

/// The report of an equilibrium.
pub(super) fn solved(solution: &Solution, context: &Context, source: &Source) -> Report {
    let (model, existence) = (solution.model(), solution.existence());
    let all = verdicts(context.limits, &[Row::alone(solution, context)]);
    let mut said = vec![stands(model, existence, context.units)];
    said.extend(checked(&all));
    said.push(certified(solution.certificate().relative_gap()));
    said.extend(proven(context.proofs));
    let numbers = Numbers::plain(solution, context.units).with_proof(context.proofs.first());
    let checks = facts(|sheet| text::checks::rows(sheet, solution, context));
    let mut sections = vec![
        overview(checks, bent(solution, context)),
        given::section(&[model], Some(existence), None, context, source),
        given::assumptions(model, solution.method()),
        given::statics(model, existence, context),
    ];
    match numbers.have_bounds() {
        true => {
            let results = facts(|sheet| text::results(sheet, solution, &numbers));
            sections.push(Section::new("Results with their bounds", results.into_iter().collect()));
            sections.push(diagrams(solution, context.units));
        }
        false => {
            sections.push(contact(solution, &numbers));
            sections.push(diagrams(solution, context.units));
            sections.push(extremes(solution, context.units));
        }
    }
    sections.push(proof::certificate(solution));
    sections.extend(proof::proof(context));
    sections.extend(proof::provenance(context, source));
    let key = key(solution, &numbers);
    Report {
        subject: "Beam on tensionless ground",
        verdicts: said,
        key,
        sections,
        ..Report::default()
    }
}

/// Returns the first section of the report, with the design checks and one picture.
pub(super) fn overview(checks: Option<Block>, picture: Block) -> Section {
    Section::new("Checks and picture", checks.into_iter().chain([picture]).collect())
}

fn bent(solution: &Solution, context: &Context) -> Block {
    let caption = "The deflected beam on the ground".to_owned();
    Block::Figure { svg: figures::bent(solution, context), caption }
}

/// The report of a model that has no equilibrium.
pub(super) fn no_equilibrium(
    model: &Model,
    existence: &Existence,
    context: &Context,
    source: &Source,
) -> Report {
    let motion = match existence.verdict {
        Stands::None(motion) => Some(motion),
        _ => None,
    };
    let mut sections = vec![
        given::section(&[model], Some(existence), motion, context, source),
        given::assumptions(model, groundbeam::Method::Exact),
        given::statics(model, existence, context),
    ];
    sections.extend(proof::provenance(context, source));
    let verdicts = vec![stands(model, existence, context.units)];
    Report { subject: "Beam without an equilibrium", verdicts, sections, ..Report::default() }
}

/// The report of a model without a certified result.
pub(super) fn not_converged(
    model: &Model,
    reached: &Stopped,
    context: &Context,
    source: &Source,
) -> Report {
    let existence = groundbeam::exists(model).ok();
    let mut sections = vec![
        given::section(&[model], existence.as_ref(), None, context, source),
        given::assumptions(model, reached.method),
    ];
    sections.extend(existence.map(|existence| given::statics(model, &existence, context)));
    sections.extend(proof::provenance(context, source));
    let words = format!("{reached}; no result is given, since none could be certified");
    let refused = Verdict { tone: "bad", head: "Not solved".into(), words: print::words(&words) };
    Report {
        subject: "Beam without a certified result",
        verdicts: vec![refused],
        sections,
        ..Report::default()
    }
}

/// Verdict on the existence of an equilibrium.
pub(super) fn stands(model: &Model, existence: &Existence, units: Units) -> Verdict {
    let wording = verdict::wording(existence.verdict);
    let words = print::words(&verdict::sentence(model, existence, units));
    Verdict { tone: wording.tone.name(), head: wording.head.to_owned(), words }
}

/// Verdict that states how many design checks pass or fail; `None` if no check is requested.
pub(super) fn checked(checks: &[Judged]) -> Option<Verdict> {
    let undecided = checks.iter().filter(|judged| judged.is_undecided()).count();
    let failed = checks.iter().filter(|judged| judged.passes() == Some(false)).count();
    let unjudged = checks.iter().filter(|judged| judged.passes().is_none()).count();
    let mut words = match (checks.len(), failed) {
        (0, _) => return None,
        (all, 0) if unjudged > 0 => format!("{} of {all} pass", all - unjudged),
        (1, 0) => "the requested check passes".to_owned(),
        (all, 0) => format!("all {all} pass"),
        (all, failed) => format!("{failed} of {all} fail"),
    };
    if undecided > 0 {
        words += &format!("; {undecided} undecided, because the limit is within the error bound");
    }
    if unjudged > 0 {
        words += &format!("; {unjudged} not judged");
    }
    let tone = match (failed, undecided + unjudged) {
        (0, 0) => "good",
        (0, _) => "doubtful",
        _ => "bad",
    };
    Some(Verdict { tone, head: "Checks".to_owned(), words })
}

/// Verdict that states the energy gap of the certificate, which is an estimate of the error.
pub(super) fn certified(gap: f64) -> Verdict {
    let gap = print::cell(&crate::number::order(gap));
    let words = format!("{}, an estimate of the error", text::certificate::energy_gap(&gap));
    Verdict { tone: "good", head: "Certified".to_owned(), words }
}

/// Verdict that states whether all results are proven; `None` if no proof is requested.
pub(super) fn proven(proofs: &[Named]) -> Option<Verdict> {
    let first = proofs.first()?;
    let missing = proofs.iter().filter(|named| !named.is_proven()).count();
    let (tone, head, words) = match (missing, proofs.len()) {
        (0, 1) => ("good", "Proven", "there is exactly one equilibrium".to_owned()),
        (0, all) => ("good", "Proven", format!("each of {all} combinations")),
        (_, 1) => {
            ("bad", "Not proven", first.shortfall().map(text::proof::reason).unwrap_or_default())
        }
        (missing, all) => ("bad", "Not proven", format!("{missing} of {all} combinations")),
    };
    let words = match missing {
        0 => format!("{words}; the error of every result is at most its bound"),
        _ => print::words(&words),
    };
    Some(Verdict { tone, head: head.to_owned(), words })
}

fn key(solution: &Solution, numbers: &Numbers) -> Vec<Key> {
    let largest = |field: Field| {
        let range = solution.range(field);
        let is_max = -range.min.value <= range.max.value;
        let extreme = if is_max { range.max } else { range.min };
        let [value, place] = numbers.key_of(field, is_max, extreme);
        Key::largest(field, print::words(&value), print::words(&format!("at x = {place}")))
    };
    let lifted = Key {
        label: "Lifted off".to_owned(),
        value: print::words(&numbers.lifted_share(solution)),
        note: "of the beam's length".to_owned(),
    };
    let ends = solution.end_forces();
    let [left, right] = [numbers.key_of_end(0, ends.left), numbers.key_of_end(1, ends.right)];
    let end = Key {
        label: "End forces".to_owned(),
        value: print::words(&left),
        note: print::words(&format!("left; right {right}")),
    };
    Key::FIELDS.map(largest).into_iter().chain([lifted, end]).collect()
}

pub(super) fn place(units: Units, x: f64) -> String {
    units.write(Kind::Position, x)
}

/// Returns the section with the contact zones, the lift-off zones and all point forces.
fn contact(solution: &Solution, written: &Numbers) -> Section {
    let (units, sizes) = (written.units, written.sizes());
    let mut zones: Vec<(f64, f64, Option<Extreme>)> =
        solution.contact().iter().map(|region| (region.from, region.to, None)).collect();
    zones.extend(solution.lift_off().iter().map(|stretch| {
        (stretch.from, stretch.to, Some(sizes.extreme(Field::Gap, stretch.largest_gap)))
    }));
    zones.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let gaps =
        zones.iter().filter_map(|zone| zone.2).fold(0.0, |most: f64, gap| most.max(gap.value));
    let x = units.unit(Kind::Position, solution.model().beam.length);
    let depth = units.unit(Kind::Deflection, gaps);
    let columns = vec![
        wording("zone"),
        numbers("from", x.name),
        numbers("to", x.name),
        numbers("length", x.name),
        numbers("largest gap", depth.name),
        numbers("at x", x.name),
    ];
    let mut table =
        Table::new("Contact and lift-off zones from the left end to the right end", columns);
    for (from, to, gap) in zones {
        let kind = match gap {
            Some(_) => "lifted off",
            None if from == to => "touches at a point",
            None => "touches",
        };
        let gap = gap.map_or([String::new(), String::new()], |gap| {
            [depth.number(gap.value), x.number(gap.x)]
        });
        let [from, to] = [from, to].map(|at| sizes.position(at));
        let ends = [from, to, to - from].map(|at| x.number(at));
        table.push([kind.to_owned()].into_iter().chain(ends).chain(gap));
    }
    let mut blocks = vec![Block::Table(table)];
    blocks.extend(facts(|sheet| text::forces(sheet, solution, written)));
    Section::new("Contact and forces", blocks)
}

fn diagrams(solution: &Solution, units: Units) -> Section {
    let figure =
        |(svg, caption): (String, &str)| Block::Figure { svg, caption: caption.to_owned() };
    let captions = [
        "Deflection of the beam and of the ground's surface under it",
        "Gap between beam and ground",
        "Contact pressure, and point contact forces as arrows",
        "Bending moment, drawn on the tension side",
        "Shear force",
    ];
    let fields = figures::fields(solution, units).into_iter().zip(captions);
    Section::new("Diagrams", fields.map(figure).collect())
}

fn extremes(solution: &Solution, units: Units) -> Section {
    let sizes = Sizes::of(solution);
    let x = units.unit(Kind::Position, solution.model().beam.length);
    let columns = vec![
        wording("quantity"),
        numbers("smallest", ""),
        numbers("at x", x.name),
        numbers("largest", ""),
        numbers("at x", x.name),
        wording("unit"),
    ];
    let mut table = Table::new("Smallest and largest values along the beam", columns);
    for field in Field::of(&solution.model().beam) {
        let range = solution.range(field);
        let both = [range.min, range.max].map(|extreme| sizes.extreme(field, extreme));
        let unit = units.unit(Kind::of(field), both[0].value.abs().max(both[1].value.abs()));
        let [min, max] = both.map(|extreme| [unit.number(extreme.value), x.number(extreme.x)]);
        let name = [field.label().to_owned()];
        table.push(name.into_iter().chain(min).chain(max).chain([unit.name.to_owned()]));
    }
    Section::new("Extremes", vec![Block::Table(table)])
}
