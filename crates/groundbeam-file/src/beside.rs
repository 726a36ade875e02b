//! Reads the files that a model file names, and the tables of numbers in these files.

use crate::files::read_file;
use crate::source::Source;
use csv::{ReaderBuilder, StringRecord, Trim};
use std::io::{self, ErrorKind};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file that the model file names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OtherFile {
    /// Path of the file, relative to the working directory.
    pub name: String,
    /// Text of the file. U+FFFD replaces bytes that are not UTF-8.
    pub text: String,
}

/// Source of the files that a model file names: a folder on the disk, or files in memory.
#[derive(Debug, Clone, Copy)]
pub struct Beside<'a> {
    folder: &'a Path,
    held: Option<&'a [OtherFile]>,
}

impl<'a> Beside<'a> {
    /// Uses files in memory that were read from this folder earlier, perhaps on another machine. No other file is
    /// read.
    pub fn held(folder: &'a Path, files: &'a [OtherFile]) -> Self {
        Beside { folder, held: Some(files) }
    }

    /// Returns this source with file names relative to another folder.
    pub(crate) fn from(self, folder: &'a Path) -> Self {
        Beside { folder, ..self }
    }

    /// Reads the file with this name, relative to the folder of `self`. Returns the path and the bytes of the file.
    pub(crate) fn read(&self, name: &str) -> (PathBuf, io::Result<Vec<u8>>) {
        let path = self.folder.join(name);
        let bytes = self.read_path(&path);
        (path, bytes)
    }

    /// Returns the bytes of the file with this path.
    pub(crate) fn read_path(&self, path: &Path) -> io::Result<Vec<u8>> {
        let Some(files) = self.held else { return read_file(path) };
        let name = path.display().to_string();
        let file = files.iter().find(|file| file.name == name);
        file.map(|file| file.text.clone().into_bytes()).ok_or(ErrorKind::NotFound.into())
    }
}

impl<'a, P: AsRef<Path> + ?Sized> From<&'a P> for Beside<'a> {
    /// The files of a folder on the disk.
    fn from(folder: &'a P) -> Self {
        Beside { folder: folder.as_ref(), held: None }
    }
}

/// Table in a file: its header, its rows, and the location of each cell in the text.
pub(crate) struct Table {
    pub file: Arc<OtherFile>,
    pub source: Source,
    pub header: Row,
    pub rows: Vec<Row>,
}

/// Cells of one row of a table, with their locations in the text.
pub(crate) struct Row {
    pub cells: Vec<String>,
    /// Byte range of the row in the text.
    pub span: Range<usize>,
    spans: Vec<Range<usize>>,
}

impl Row {
    /// Returns the byte range of a cell. A missing cell has the empty range at the end of the row.
    pub fn cell(&self, i: usize) -> Range<usize> {
        self.spans.get(i).cloned().unwrap_or(self.span.end..self.span.end)
    }
}

impl Table {
    /// Reads a file of values. The first row decides whether semicolons, tabs or commas separate the values. The
    /// character `#` begins a comment.
    pub fn read(beside: Beside, file: &str) -> Result<Table, String> {
        let (path, bytes) = beside.read(file);
        let bytes = bytes.map_err(|error| error.to_string())?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let source = Source::new(&text);
        let start = text.len() - text.trim_start_matches('\u{feff}').len();
        let first = text[start..].lines().find(|line| !line.starts_with('#') && !line.is_empty());
        let first = first.ok_or("the file is empty")?;
        let separator = [';', '\t'].into_iter().find(|c| first.contains(*c)).unwrap_or(',');
        let mut reader = ReaderBuilder::new()
            .delimiter(separator as u8)
            .comment(Some(b'#'))
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(&text.as_bytes()[start..]);
        let mut rows = Vec::new();
        let mut record = StringRecord::new();
        while reader.read_record(&mut record).map_err(|error| error.to_string())? {
            let from = record.position().map_or(0, |at| at.byte() as usize) + start;
            let end = reader.position().byte() as usize + start;
            rows.push(Row::of(&text, from..end, &record, separator));
        }
        let mut rows = rows.into_iter();
        let header = rows.next().ok_or("the file is empty")?;
        let file = Arc::new(OtherFile { name: path.display().to_string(), text });
        Ok(Table { file, source, header, rows: rows.collect() })
    }
}

impl Row {
    fn of(text: &str, span: Range<usize>, record: &StringRecord, separator: char) -> Self {
        // The byte range of a table row may begin with comments and empty lines, which are skipped.
        let mut from = span.start;
        while let Some(line) = text[from..span.end].split_inclusive('\n').next()
            && (line.starts_with('#') || line.trim().is_empty())
        {
            from += line.len();
        }
        let row = text[from..span.end].trim_end();
        let (mut spans, mut start, mut quoted) = (Vec::new(), 0, false);
        for (i, c) in row.char_indices().chain([(row.len(), separator)]) {
            if c == '"' {
                quoted = !quoted;
            }
            if i == row.len() || (c == separator && !quoted) {
                let cell = &row[start..i];
                let lead = cell.len() - cell.trim_start().len();
                let begin = from + start + lead;
                spans.push(begin..begin + cell.trim().len());
                start = i + c.len_utf8().min(row.len() - i);
            }
        }
        let cells = record.iter().map(str::to_owned).collect();
        Row { cells, span: from..from + row.len(), spans }
    }
}
