//! Writes the report's sections on the certificate, the proof and the origin of the results.

use super::content::{Block, Section, facts};
use super::{Source, equations};
use crate::context::{Context, clean};
use crate::digest::digest;
use crate::text;
use groundbeam::Solution;

/// Returns the section on the certificate of one solution.
pub(super) fn certificate(solution: &Solution) -> Section {
    let (certificate, verdict) = (solution.certificate(), solution.existence().verdict);
    let mut blocks = explained();
    blocks.extend(facts(|sheet| text::certificate::rows(sheet, certificate, verdict)));
    Section::new("Certificate", blocks)
}

/// Returns the section on the certificates of several solutions; `say` writes the text of the terminal
/// report.
pub(super) fn certificates(say: impl FnOnce(&mut text::sheet::Sheet)) -> Section {
    let mut blocks = explained();
    blocks.extend(facts(say));
    Section::new("Certificate", blocks)
}

fn explained() -> Vec<Block> {
    let words = "Independent code checks this result. From the model and the computed fields it constructs a \
                 deflection without penetration and a nonnegative pressure in equilibrium with the loads. \
                 It computes their energy gap";
    let after = "which is at least half the squared distance of the deflections from the exact solution (w*, u*) in the \
                 energy norm, for every method and mesh (Prager and Synge). Here it is an estimate: the sums have \
                 rounding errors. groundbeam solve FILE --proven computes it with arithmetic that encloses all rounding errors, and \
                 bounds the errors of the printed numbers. The exact method gives no result if the gap is above 1e-9.";
    let text = |words: &str| Block::Text { words: words.to_owned() };
    vec![text(words), equations::energy_gap(), text(after)]
}

/// Returns the section with the proven statements and the quantities without a bound; `None` if no proof is
/// requested.
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
         from the printed value by at most the bound. No bound is printed for the numbers in the sections on input \
         and equilibrium, which depend on the input only, or for the numbers in figures, which are rounded."
    );
    blocks.push(Block::Text { words });
    Some(Section::new("Proof", blocks))
}

/// Returns two sections: the origin of the report (program, digest of the input, command that makes the
/// report) and the input file.
pub(super) fn provenance(context: &Context, source: &Source) -> [Section; 2] {
    let name = clean(source.name);
    let units = match context.units.is_plain() {
        false => "all quantities of the file have units; the program calculates in m, N and rad",
        true => "the file has no units; all numbers are in one consistent system of units",
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
            "The result depends only on the input below. Saved as a file, the input has the digest above."
        }
        _ => {
            "The result depends only on the model file and its tables, which are printed below. Each of these texts, \
             saved as a file, has the digest given above."
        }
    };
    let words = format!(
        "{what} The same version of the program gives the same bits. For results that other programs can read, use \
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
    [Section::new("Origin of this report", blocks), Section::new("Input file", texts)]
}

/// Returns the model file and the tables that it names, each with a label, its file name and its text.
fn inputs<'a>(source: &Source<'a>) -> Vec<(&'static str, String, &'a str)> {
    let last = |name: &str| clean(name.rsplit(['/', '\\']).next().unwrap_or(name));
    let tables = source.files.iter().map(|file| ("Table", last(&file.name), file.text.as_str()));
    [("Input", clean(source.name), source.text)].into_iter().chain(tables).collect()
}
