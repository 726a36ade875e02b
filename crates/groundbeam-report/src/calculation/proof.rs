//! The certificate in words, and the origin of the results.

use super::content::{Block, Section, facts};
use super::{Source, equations};
use crate::context::{Context, clean};
use crate::digest::digest;
use crate::text;
use groundbeam::Solution;

/// The certificate of one solution.
pub(super) fn certificate(solution: &Solution) -> Section {
    let (certificate, verdict) = (solution.certificate(), solution.existence().verdict);
    let mut blocks = explained();
    blocks.extend(facts(|sheet| text::certificate::rows(sheet, certificate, verdict)));
    Section::new("Certificate", blocks)
}

/// The certificates of several, in the words that the report for a terminal has for them.
pub(super) fn certificates(say: impl FnOnce(&mut text::sheet::Sheet)) -> Section {
    let mut blocks = explained();
    blocks.extend(facts(say));
    Section::new("Certificate", blocks)
}

fn explained() -> Vec<Block> {
    let words = "Code that shares nothing with the method checks this answer. From the model and the claimed fields it makes a \
                 deflection that enters the ground nowhere and a pressure that pulls nowhere and is in balance with the loads. \
                 It forms their energy gap";
    let after = "which is at least half the squared distance of the deflections from the exact solution (w*, u*) in the \
                 energy norm, whatever method or mesh found them (Prager and Synge). Here it is an estimate: the sums carry \
                 rounding error. groundbeam solve FILE --proven computes it in numbers that enclose all rounding error, and \
                 bounds the errors of the printed numbers. An exact answer with a gap above 1e-9 is not printed.";
    let text = |words: &str| Block::Text { words: words.to_owned() };
    vec![text(words), equations::energy_gap(), text(after)]
}

/// What is proven of the answers, and what has no bound; nothing if no proof is asked for.
pub(super) fn proof(context: &Context) -> Option<Section> {
    let first = context.proofs.first()?;
    let mut blocks = Vec::new();
    for named in context.proofs {
        if let Some(name) = &named.combination {
            blocks.push(Block::Text { words: clean(name) });
        }
        blocks.extend(facts(|sheet| text::proof::proven(sheet, named, context.units)));
    }
    let results =
        if first.combination.is_none() { "results" } else { "results of each combination" };
    let words = format!(
        "The {results}, the key figures and the checks are printed as value ± bound: the exact solution of the model differs \
         from the printed value by at most the bound. Numbers of the sections on input and equilibrium follow from the \
         input alone, those in figures are rounded; they have no bound."
    );
    blocks.push(Block::Text { words });
    Some(Section::new("Proof", blocks))
}

/// Program, input and its digest, and how to make the report again.
pub(super) fn provenance(context: &Context, source: &Source) -> [Section; 2] {
    let name = clean(source.name);
    let units = match context.units.is_plain() {
        false => "the file gives every quantity a unit; calculated in m, N and rad",
        true => "the file gives no units: all numbers are in its own consistent system",
    };
    let proven = if context.proofs.is_empty() { "" } else { " --proven" };
    let program = format!("groundbeam {}", env!("CARGO_PKG_VERSION"));
    let mut rows = vec![("Program", program)];
    for (what, name, text) in inputs(source) {
        rows.push((what, format!("{name}, {} bytes", text.len())));
        rows.push(("SHA-256", digest(text)));
    }
    if let (Some(whole), [_, ..]) = (context.digest, source.files) {
        rows.push(("Together", whole.replace("sha256:", "SHA-256 ")));
    }
    rows.push(("Units", units.to_owned()));
    rows.push(("Recompute", format!("groundbeam solve {name} --report report.html{proven}")));
    let list = facts(|sheet| rows.iter().for_each(|(label, words)| sheet.row(label, words)));
    let what = match source.files {
        [] => {
            "The input below is all that the answer depends on: saved as a file it has the digest above"
        }
        _ => {
            "The model file and the tables below are all that the answer depends on: saved as files they have the digests above"
        }
    };
    let words = format!(
        "{what}, and the same version of the program gives the same bits. Results of every section for other programs: \
         groundbeam solve FILE --json."
    );
    let mut blocks: Vec<Block> = list.into_iter().collect();
    blocks.push(Block::Text { words });
    let mut texts = Vec::new();
    for (_, name, text) in inputs(source) {
        if !source.files.is_empty() {
            texts.push(Block::Text { words: format!("{name}:") });
        }
        texts.push(Block::Code { lines: text.lines().map(str::to_owned).collect() });
    }
    [Section::new("Where this comes from", blocks), Section::new("Input file", texts)]
}

/// The texts on which the answer depends: the model file, and the tables that it names, each with its name.
fn inputs<'a>(source: &Source<'a>) -> Vec<(&'static str, String, &'a str)> {
    let last = |name: &str| clean(name.rsplit(['/', '\\']).next().unwrap_or(name));
    let tables = source.files.iter().map(|file| ("Table", last(&file.name), file.text.as_str()));
    [("Input", clean(source.name), source.text)].into_iter().chain(tables).collect()
}
