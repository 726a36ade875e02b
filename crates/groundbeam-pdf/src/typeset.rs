//! typst's view of a report: one page description, one file of data, a few fonts, and no other world around them.

use crate::{Error, math};
use groundbeam_report::calculation::{Block, Paper, Report};
use groundbeam_report::fonts;
use serde_json::json;
use std::collections::BTreeMap;
use std::fmt::Display;
use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};
use typst_layout::PagedDocument;
use typst_pdf::PdfOptions;

/// How a report looks.
const TEMPLATE: &str = include_str!("../templates/report.typ");

/// A report as a PDF file.
pub(crate) fn pdf(report: &Report, paper: Paper) -> Result<Vec<u8>, Error> {
    let options = PdfOptions {
        ident: Smart::Custom(report.digest.clone()),
        creator: Smart::Custom(Some(format!("groundbeam {}", report.version))),
        ..PdfOptions::default()
    };
    typst_pdf::pdf(&set(report, paper)?, &options).map_err(|found| failed(&found))
}

/// A report as pages.
fn set(report: &Report, paper: Paper) -> Result<PagedDocument, Error> {
    let pages = Pages::of(report, paper)?;
    typst::compile(&pages).output.map_err(|found| failed(&found))
}

fn failed(found: &[SourceDiagnostic]) -> Error {
    let all: Vec<&str> = found.iter().map(|one| one.message.as_str()).collect();
    wrong(all.join("; "))
}

fn wrong(what: impl Display) -> Error {
    Error(format!("the report could not be set: {what}"))
}

/// All there is for typst.
struct Pages {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
    template: Source,
    /// `report.json`, and where it is.
    data: (FileId, Bytes),
}

impl Pages {
    fn of(report: &Report, paper: Paper) -> Result<Self, Error> {
        let blocks = report.sections.iter().flat_map(|section| &section.blocks);
        let lines = blocks.flat_map(|block| match block {
            Block::Equations { lines } => &lines[..],
            _ => &[],
        });
        let formulas: Result<BTreeMap<&str, String>, String> =
            lines.map(|line| Ok((line.latex.as_str(), math::formula(&line.latex)?))).collect();
        let paper = match paper {
            Paper::A4 => "a4",
            Paper::Letter => "us-letter",
        };
        let data = json!({
            "report": report, "formulas": formulas.map_err(wrong)?, "paper": paper
        });
        let own = [fonts::REGULAR, fonts::SEMI_BOLD];
        let fonts: Vec<Font> = own
            .into_iter()
            .chain(typst_assets::fonts())
            .flat_map(|bytes| Font::iter(Bytes::new(bytes)))
            .collect();
        Ok(Pages {
            library: LazyHash::new(Library::default()),
            book: LazyHash::new(FontBook::from_fonts(&fonts)),
            fonts,
            template: Source::new(file("report.typ")?, TEMPLATE.to_owned()),
            data: (file("report.json")?, Bytes::from_string(data.to_string())),
        })
    }
}

fn file(name: &str) -> Result<FileId, Error> {
    let path = VirtualPath::new(name).map_err(|_| wrong(name))?;
    Ok(FileId::new(RootedPath::new(VirtualRoot::Project, path)))
}

impl World for Pages {
    fn library(&self) -> &LazyHash<Library> {
        &self.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &self.book
    }

    fn main(&self) -> FileId {
        self.template.id()
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        match id == self.template.id() {
            true => Ok(self.template.clone()),
            false => Err(FileError::Other(None)),
        }
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        match id == self.data.0 {
            true => Ok(self.data.1.clone()),
            false => Err(FileError::Other(None)),
        }
    }

    fn font(&self, index: usize) -> Option<Font> {
        self.fonts.get(index).cloned()
    }

    /// A report has no date.
    fn today(&self, _offset: Option<Duration>) -> Option<Datetime> {
        None
    }
}
