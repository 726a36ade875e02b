//! Files beside the model file: where they are read, and the tables of numbers in them.

use crate::files::read_file;
use crate::source::Source;
use csv::{ReaderBuilder, StringRecord, Trim};
use std::io::{self, ErrorKind};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file that a model file names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OtherFile {
    /// Its name, as it can be opened from where the program runs.
    pub name: String,
    /// Its text, with U+FFFD for what is not UTF-8.
    pub text: String,
}

/// Where the files are that a file names.
#[derive(Debug, Clone, Copy)]
pub struct Beside<'a> {
    folder: &'a Path,
    held: Option<&'a [OtherFile]>,
}

impl<'a> Beside<'a> {
    /// In memory: files that were read in this folder before, here or on another machine. No other file is read.
    pub fn held(folder: &'a Path, files: &'a [OtherFile]) -> Self {
        Beside { folder, held: Some(files) }
    }

    /// The same files, named from another folder.
    pub(crate) fn from(self, folder: &'a Path) -> Self {
        Beside { folder, ..self }
    }

    /// The path of a file that is named from the folder, and its bytes if it can be read.
    pub(crate) fn read(&self, name: &str) -> (PathBuf, io::Result<Vec<u8>>) {
        let path = self.folder.join(name);
        let bytes = self.read_path(&path);
        (path, bytes)
    }

    /// The bytes of a file.
    pub(crate) fn read_path(&self, path: &Path) -> io::Result<Vec<u8>> {
        let Some(files) = self.held else { return read_file(path) };
        let name = path.display().to_string();
        let file = files.iter().find(|file| file.name == name);
        file.map(|file| file.text.clone().into_bytes()).ok_or(ErrorKind::NotFound.into())
    }
}

impl<'a, P: AsRef<Path> + ?Sized> From<&'a P> for Beside<'a> {
    /// On the disk, in a folder.
    fn from(folder: &'a P) -> Self {
        Beside { folder: folder.as_ref(), held: None }
    }
}

/// A table: its header and its rows, every cell with its place.
pub(crate) struct Table {
    pub file: Arc<OtherFile>,
    pub source: Source,
    pub header: Row,
    pub rows: Vec<Row>,
}

/// The cells of one row.
pub(crate) struct Row {
    pub cells: Vec<String>,
    /// The bytes of the row in the text.
    pub span: Range<usize>,
    spans: Vec<Range<usize>>,
}

impl Row {
    /// The bytes of a cell; of one that is missing, the end of the row.
    pub fn cell(&self, i: usize) -> Range<usize> {
        self.spans.get(i).cloned().unwrap_or(self.span.end..self.span.end)
    }
}

impl Table {
    /// Reads a file of values separated by semicolons, tabs or commas, whichever its first row has, with `#`
    /// before comments.
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
        // A record's position may lie before comments and empty lines.
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
