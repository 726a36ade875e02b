//! The content of the calculation report, used for HTML and PDF.
//!
//! The report uses the sentences of [`text`](crate::text) and the figures of [`svg`](crate::svg).

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

/// Origin of a report's model.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// Name of the file.
    pub name: &'a str,
    /// Text of the model file. The report contains this text and its digest.
    pub text: &'a str,
    /// Model in the file, with all of its loads and without load factors.
    pub model: &'a Model,
    /// Load case of each load, in order; `None` for a load without a case.
    pub cases: &'a [Option<String>],
    /// Files of tables, such as surveys, to which the model file refers.
    pub files: &'a [Arc<OtherFile>],
}

impl<'a> Source<'a> {
    /// Returns the source of a report whose model comes from a model file.
    pub fn of(document: &'a Document, name: &'a str, text: &'a str) -> Self {
        let (model, cases, files) = (&document.model, &document.cases, &document.files);
        Source { name, text, model, cases, files }
    }
}

/// Paper size of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// 210 mm × 297 mm.
    A4,
    /// 8.5 in × 11 in.
    Letter,
}

/// Returns the calculation report for the results of a model file. Equal results give equal reports, except
/// for the duration in the context.
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

/// Maximum number of rows of a table that stays in its section. Longer tables are moved to the last section.
const LONGEST: usize = 24;

/// Moves long tables to a new last section and returns all sections.
fn long_tables_last(mut sections: Vec<Section>) -> Vec<Section> {
    let mut tables = Vec::new();
    for block in sections.iter_mut().flat_map(|section| &mut section.blocks) {
        let Block::Table(table) = block else { continue };
        if table.rows.len() > LONGEST {
            let words = format!(
                "{}: this table has {} rows and is in the last section.",
                table.caption,
                table.rows.len()
            );
            tables.push(std::mem::replace(block, Block::Text { words }));
        }
    }
    if !tables.is_empty() {
        sections.push(Section::new("Long tables", tables));
    }
    sections
}
