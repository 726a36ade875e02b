//! Typesets a report with typst from a page template, a data file, and fonts.

use crate::Error;
use groundbeam_report::calculation::{Paper, Report};
use groundbeam_report::fonts;
use serde_json::json;
use std::fmt::Display;
use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};
use typst_layout::PagedDocument;
use typst_pdf::PdfOptions;

/// Layout of the pages.
const TEMPLATE: &str = include_str!("../templates/report.typ");

/// Typesets a report as a PDF file.
pub(crate) fn pdf(report: &Report, paper: Paper) -> Result<Vec<u8>, Error> {
    let options = PdfOptions {
        ident: Smart::Custom(report.digest.clone()),
        creator: Smart::Custom(Some(format!("groundbeam {}", report.version))),
        ..PdfOptions::default()
    };
    typst_pdf::pdf(&set(report, paper)?, &options).map_err(|found| failed(&found))
}

/// Typesets the pages of a report.
fn set(report: &Report, paper: Paper) -> Result<PagedDocument, Error> {
    let pages = Pages::of(report, paper)?;
    typst::compile(&pages).output.map_err(|found| failed(&found))
}

fn failed(found: &[SourceDiagnostic]) -> Error {
    let all: Vec<&str> = found.iter().map(|one| one.message.as_str()).collect();
    wrong(all.join("; "))
}

fn wrong(what: impl Display) -> Error {
    Error(format!("the report could not be typeset: {what}"))
}

/// The template, the data and the fonts that typst reads.
struct Pages {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
    template: Source,
    /// Identifier and content of the file `report.json`.
    data: (FileId, Bytes),
}

impl Pages {
    fn of(report: &Report, paper: Paper) -> Result<Self, Error> {
        let paper = match paper {
            Paper::A4 => "a4",
            Paper::Letter => "us-letter",
        };
        let data = json!({ "report": report, "paper": paper });
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

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam_report::calculation::{Block, Column, Section, Source, Table};
    use groundbeam_report::{Context, Results};
    use groundbeam_run::{OneThread, Run};
    use typst::layout::{Frame, FrameItem};

    /// Returns the calculation report of a model file.
    fn report(text: &str) -> Report {
        let document = groundbeam_file::parse(text).unwrap();
        let answers = Run::of(&document).solve(&OneThread).unwrap();
        let source = Source::of(&document, "model.toml", text);
        Results::new(&answers, Context::of(&document)).calculation(&source)
    }

    const FOOTING: &str = include_str!("../../../docs/strip-footing.toml");

    /// Returns the text of each page, without spaces.
    fn pages(report: &Report, paper: Paper) -> Vec<String> {
        let mut written = Vec::new();
        for page in set(report, paper).unwrap().pages() {
            let mut words = String::new();
            collect(&page.frame, &mut words);
            written.push(bare(&words));
        }
        written
    }

    fn collect(frame: &Frame, words: &mut String) {
        for (_, item) in frame.items() {
            match item {
                FrameItem::Group(group) => collect(&group.frame, words),
                FrameItem::Text(text) => words.push_str(&text.text),
                _ => {}
            }
        }
    }

    fn bare(words: &str) -> String {
        words.chars().filter(|c| !c.is_whitespace()).collect::<String>().replace("_l", "l")
    }

    /// Returns all texts of a report, except formulas and words in pictures.
    fn said(report: &Report) -> Vec<String> {
        let mut all = vec![report.title.clone(), report.subject.to_owned()];
        all.extend(report.verdicts.iter().flat_map(|v| [v.head.clone(), v.words.clone()]));
        all.extend(report.key.iter().flat_map(|k| [k.value.clone(), k.note.clone()]));
        for section in &report.sections {
            all.push(section.title.to_owned());
            for block in &section.blocks {
                match block {
                    Block::Text { words } => all.push(words.clone()),
                    Block::List { items } => all.extend(items.clone()),
                    Block::Facts { facts } => {
                        let each = facts.iter();
                        all.extend(each.flat_map(|f| {
                            [&f.label, &f.inner, &f.head, &f.words].map(String::clone)
                        }));
                    }
                    Block::Table(table) => {
                        all.extend([table.caption.clone(), table.note.clone()]);
                        all.extend(table.columns.iter().map(|c| c.head.clone() + &c.unit));
                        all.extend(table.rows.concat());
                    }
                    Block::Figure { caption, .. } => all.push(caption.clone()),
                    Block::Equations { lines } => {
                        all.extend(lines.iter().map(|l| l.words.to_owned() + l.number));
                    }
                    Block::Code { lines } => all.extend(lines.clone()),
                }
            }
        }
        all
    }

    #[test]
    fn everything_that_is_said_is_on_the_pages() {
        let tipping = include_str!("../../../docs/tipping.toml");
        for (text, paper) in [(FOOTING, Paper::A4), (tipping, Paper::Letter)] {
            let report = report(text);
            let written = pages(&report, paper).concat();
            for words in said(&report) {
                // Only the first 60 characters are compared, because a long paragraph may continue on the next
                // page.
                let beginning: String = bare(&words).chars().take(60).collect();
                assert!(written.contains(&beginning), "{words}");
            }
        }
    }

    #[test]
    fn paper_is_as_large_as_it_is() {
        let report = report(FOOTING);
        for (paper, [width, height]) in
            [(Paper::A4, [210.0, 297.0]), (Paper::Letter, [215.9, 279.4])]
        {
            for page in set(&report, paper).unwrap().pages() {
                let size = page.frame.size();
                assert!(
                    (size.x.to_mm() - width).abs() < 0.01 && (size.y.to_mm() - height).abs() < 0.01
                );
            }
        }
    }

    #[test]
    fn every_page_says_what_it_belongs_to() {
        let report = report(FOOTING);
        let written = pages(&report, Paper::A4);
        for (i, page) in written.iter().enumerate() {
            assert!(page.contains(&bare(&report.title)) && page.contains(&report.digest[..16]));
            assert!(page.contains(&format!("{}/{}", i + 1, written.len())), "{page}");
        }
    }

    #[test]
    fn long_tables_go_on_under_their_heads() {
        let column = |head: &str, number| Column { head: head.into(), unit: String::new(), number };
        let table = Table {
            caption: "A long table".into(),
            columns: vec![column("counted", true), column("in words", false)],
            rows: (0..150).map(|i| vec![format!("<{i}>"), "*no markup* #here".into()]).collect(),
            note: String::new(),
        };
        let mut report = report(FOOTING);
        report.sections = vec![Section { title: "Rows", blocks: vec![Block::Table(table)] }];
        let written = pages(&report, Paper::A4);
        assert!(written.len() > 2);
        for page in written.iter().filter(|page| page.contains('<')) {
            assert_eq!(page.matches("countedinwords").count(), 1, "{page}");
        }
        let rows: usize = written.iter().map(|page| page.matches("*nomarkup*#here").count()).sum();
        assert_eq!(rows, 150);
    }

    /// A heading or the caption of a table is never the last line of a page.
    #[test]
    fn no_heading_is_left_alone() {
        let short = |title| Section {
            title,
            blocks: vec![Block::Text { words: "One line below its heading.".into() }],
        };
        let mut report = report(FOOTING);
        for lines in 0..30 {
            let filler = Block::Code { lines: vec!["x".into(); 40 + lines] };
            report.sections =
                vec![Section { title: "Filler", blocks: vec![filler] }, short("Alone")];
            let written = pages(&report, Paper::A4);
            let heading = written.iter().position(|page| page.contains("Alone")).unwrap();
            assert!(written[heading].contains("Onelinebelowitsheading."), "{lines}");
        }
    }
}
