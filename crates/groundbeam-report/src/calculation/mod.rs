//! The calculation report before it is set in type: one content for HTML and for PDF.
//!
//! It says what was given, what is assumed, why there is an equilibrium, what came out, and how anyone can check it. The
//! words are those of [`text`](crate::text), the figures those of [`svg`](crate::svg).

mod content;
mod equations;
mod formulas;
mod given;
mod passages;
mod print;
mod proof;
mod several;
mod single;

use crate::context::{Context, clean};
pub use content::{Block, Column, Equation, Fact, Key, Report, Section, Table, Verdict};
use groundbeam::Model;
use groundbeam_file::{Document, OtherFile};
use groundbeam_run::{Answers, Asked, Found};
use std::sync::Arc;

/// Where a report's model comes from.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// What the file is called.
    pub name: &'a str,
    /// All of the file: the report holds it and its digest.
    pub text: &'a str,
    /// The model under all of its loads as they are written.
    pub model: &'a Model,
    /// The load case of each of its loads, in their order; none for a load to which the file gives none.
    pub cases: &'a [Option<String>],
    /// The tables that the file names: surveys and data of the soil.
    pub files: &'a [Arc<OtherFile>],
}

impl<'a> Source<'a> {
    /// A model file with what it is called.
    pub fn of(document: &'a Document, name: &'a str, text: &'a str) -> Self {
        let (model, cases, files) = (&document.model, &document.cases, &document.files);
        Source { name, text, model, cases, files }
    }
}

/// The paper on which a report is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// 210 mm × 297 mm.
    A4,
    /// 8.5 in × 11 in.
    Letter,
}

/// The report of the answers to a file. Equal results give equal reports, but for the time a context brings along.
pub fn report(answers: &Answers, context: &Context, source: &Source) -> Report {
    let report = match (answers.asked, answers.list.first()) {
        (Asked::One, Some(one)) => {
            let model = one.label.model();
            match &one.found {
                Found::Equilibrium(solution) => single::solved(solution, context, source),
                Found::Exists(existence) | Found::NoEquilibrium(existence) => {
                    single::no_equilibrium(&model, existence, context, source)
                }
                Found::NotConverged(reached) => {
                    single::not_converged(&model, reached, context, source)
                }
                Found::Unsolved(_) => Report::default(),
            }
        }
        (Asked::Trains, _) => passages::trains(&answers.passages(), context, source),
        _ => several::combinations(answers, context, source),
    };
    let digest = match context.digest {
        Some(whole) => whole.replace("sha256:", ""),
        None => crate::digest::digest(source.text),
    };
    Report {
        title: context.clean_title().unwrap_or_else(|| clean(source.name)),
        version: env!("CARGO_PKG_VERSION"),
        digest,
        sections: long_tables_last(report.sections),
        ..report
    }
}

/// The most rows of a table that stands where it belongs.
const LONGEST: usize = 24;

/// The sections with their long tables in a section of their own behind all others.
fn long_tables_last(mut sections: Vec<Section>) -> Vec<Section> {
    let mut tables = Vec::new();
    for block in sections.iter_mut().flat_map(|section| &mut section.blocks) {
        let Block::Table(table) = block else { continue };
        if table.rows.len() > LONGEST {
            let words =
                format!("{}: {} rows, in the last section.", table.caption, table.rows.len());
            tables.push(std::mem::replace(block, Block::Text { words }));
        }
    }
    if !tables.is_empty() {
        sections.push(Section::new("Long tables", tables));
    }
    sections
}
