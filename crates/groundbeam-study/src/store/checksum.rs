//! Computes and verifies the SHA-256 checksums of a results file, which are stored in the metadata of the file.
//!
//! A block is a group of rows, or the tail with page index, metadata and footer. Each block is verified before it is
//! decoded. *Checksums* in docs/studies.md defines the format.

use super::StoreError;
use parquet::file::metadata::KeyValue;
use sha2::{Digest, Sha256};
use std::cell::RefCell;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The key of the checksums in the metadata.
pub const KEY: &str = "groundbeam.checksum";
/// Name of the hash method. The text that lists all checksums of a file begins with this name.
const METHOD: &str = "sha-256";
/// Characters of a digest.
const DIGITS: usize = 64;
/// The last four bytes of a Parquet file. The length of the metadata in four bytes precedes them.
const MAGIC: &[u8; 4] = b"PAR1";
/// Number of bytes that are read at once.
const AT_ONCE: usize = 1 << 16;

/// A sink that computes the checksums of the written bytes.
pub struct Sealed<W> {
    sink: W,
    digest: Sha256,
    written: u64,
    /// The text that lists, for each finished block, the position of its end in the file and its checksum. The
    /// checksum of the tail, the last block of the file, is not in this text.
    stated: String,
    /// Bytes of the tail, the last block of the file; `None` before the tail begins. They are stored until
    /// their digest is known.
    tail: Option<Vec<u8>>,
}

impl<W: Write> Sealed<W> {
    pub fn new(sink: W) -> Self {
        let stated = METHOD.to_owned();
        Sealed { sink, digest: Sha256::new(), written: 0, stated, tail: None }
    }

    /// Ends a block.
    pub fn end_block(&mut self) {
        let digest = hex(std::mem::take(&mut self.digest));
        // Writing to a string does not fail.
        let _ = write!(self.stated, " {} {digest}", self.written);
    }

    /// Begins the tail, the last block of the file, which contains the metadata. Returns the checksums for the
    /// metadata, with zeros in place of the digest of the tail.
    pub fn begin_tail(&mut self) -> KeyValue {
        self.tail = Some(Vec::new());
        KeyValue::new(KEY.to_owned(), format!("{} {}", self.stated, "0".repeat(DIGITS)))
    }

    /// Inserts the digest of the tail, the last block of the file, into the metadata and writes the tail.
    pub fn finish(mut self) -> io::Result<W> {
        let mut tail = self.tail.take().unwrap_or_default();
        let place = stated_in(&tail);
        let place = place.ok_or_else(|| io::Error::other("the metadata contain no checksums"))?;
        let digits = place.end - DIGITS..place.end;
        self.digest.update(&tail);
        tail[digits].copy_from_slice(hex(self.digest).as_bytes());
        self.sink.write_all(&tail)?;
        Ok(self.sink)
    }
}

impl<W: Write> Write for Sealed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Some(tail) = &mut self.tail {
            return tail.write(bytes);
        }
        let count = self.sink.write(bytes)?;
        self.digest.update(&bytes[..count]);
        self.written += count as u64;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

/// The checksums of a file of results. The last block of the file, which contains the metadata, has been
/// verified.
pub struct Checksums {
    path: PathBuf,
    file: File,
    blocks: Vec<Block>,
    /// Whether each block has been verified.
    verified: RefCell<Vec<bool>>,
}

struct Block {
    bytes: Range<u64>,
    digest: String,
}

impl Checksums {
    /// Reads the checksums of a file, and verifies its last block, which contains the metadata.
    pub fn open(path: &Path, file: File) -> Result<Self, StoreError> {
        let wrong = |error: io::Error| StoreError::io(path, &error);
        let length = file.metadata().map_err(wrong)?.len();
        let last = metadata_of(&file, length).map_err(wrong)?.ok_or_else(|| unknown(path))?;
        let place = stated_in(&last).ok_or_else(|| unknown(path))?;
        let (blocks, digest) = blocks(&last[place.clone()]).ok_or_else(|| damaged_tail(path))?;
        let first = length - last.len() as u64;
        let tail = blocks.last().map_or(0, |block| block.bytes.end);
        if tail > first {
            return Err(damaged_tail(path));
        }
        let digits = first + (place.end - DIGITS) as u64;
        let mut found = Sha256::new();
        digest_on(&mut found, &file, tail..digits).map_err(wrong)?;
        found.update([b'0'; DIGITS]);
        digest_on(&mut found, &file, digits + DIGITS as u64..length).map_err(wrong)?;
        if hex(found) != digest {
            return Err(damaged_tail(path));
        }
        let verified = RefCell::new(vec![false; blocks.len()]);
        Ok(Checksums { path: path.to_owned(), file, blocks, verified })
    }

    /// Whether the contents of a block match its checksum. A block that matched once is not read again.
    pub fn is_sound(&self, block: usize) -> Result<bool, StoreError> {
        let Some(Block { bytes, digest }) = self.blocks.get(block) else { return Ok(false) };
        if self.verified.borrow()[block] {
            return Ok(true);
        }
        let mut found = Sha256::new();
        digest_on(&mut found, &self.file, bytes.clone())
            .map_err(|error| StoreError::io(&self.path, &error))?;
        let is_sound = hex(found) == *digest;
        self.verified.borrow_mut()[block] = is_sound;
        Ok(is_sound)
    }
}

/// The error for a file that is not a file of results, or is too damaged to be recognised.
fn unknown(path: &Path) -> StoreError {
    StoreError::Unlike(format!(
        "{}: this is not a file of results, or its metadata are damaged; if the study wrote it, delete it and run the \
         study again, which computes its samples again",
        path.display()
    ))
}

fn damaged_tail(path: &Path) -> StoreError {
    StoreError::Damaged(path.to_owned(), "its metadata".to_owned())
}

/// Reads the metadata of a file and the eight bytes after the metadata. Returns `None` if the file is not a Parquet file.
fn metadata_of(mut file: &File, length: u64) -> io::Result<Option<Vec<u8>>> {
    let Some(end) = length.checked_sub(8) else { return Ok(None) };
    let mut last = [0; 8];
    file.seek(SeekFrom::Start(end))?;
    file.read_exact(&mut last)?;
    let [a, b, c, d, magic @ ..] = last;
    let Some(start) = end.checked_sub(u32::from_le_bytes([a, b, c, d]).into()) else {
        return Ok(None);
    };
    if &magic != MAGIC {
        return Ok(None);
    }
    let mut all = Vec::new();
    file.seek(SeekFrom::Start(start))?;
    file.take(length - start).read_to_end(&mut all)?;
    Ok(Some(all))
}

/// Byte range of the checksums in the metadata, after 0x18 and their length in groups of seven bits, lowest first
/// (Thrift's compact protocol). The last key counts, because the texts of model and study before it may contain any
/// bytes.
fn stated_in(metadata: &[u8]) -> Option<Range<usize>> {
    let key = metadata.windows(KEY.len()).rposition(|bytes| bytes == KEY.as_bytes())?;
    let mut place = key + KEY.len();
    if metadata.get(place) != Some(&0x18) {
        return None;
    }
    let (mut length, mut shift) = (0, 0);
    loop {
        place += 1;
        let byte = *metadata.get(place)?;
        length |= usize::from(byte & 0x7f).checked_shl(shift)?;
        shift += 7;
        if byte & 0x80 == 0 {
            break;
        }
    }
    let end = (place + 1).checked_add(length)?;
    (length > DIGITS && end <= metadata.len()).then_some(place + 1..end)
}

/// Parses the checksums. Returns the blocks before the last one, and the digest of the last block of the file.
fn blocks(stated: &[u8]) -> Option<(Vec<Block>, &str)> {
    let mut words =
        std::str::from_utf8(stated).ok()?.strip_prefix(METHOD)?.strip_prefix(' ')?.split(' ');
    let tail = words.next_back().filter(|digest| digest.len() == DIGITS)?;
    let mut blocks = Vec::new();
    let mut start = 0;
    while let Some(end) = words.next() {
        let end = end.parse().ok().filter(|end| *end >= start)?;
        blocks.push(Block { bytes: start..end, digest: words.next()?.to_owned() });
        start = end;
    }
    Some((blocks, tail))
}

/// Adds the bytes of a part of a file to a digest.
fn digest_on(digest: &mut Sha256, mut file: &File, bytes: Range<u64>) -> io::Result<()> {
    file.seek(SeekFrom::Start(bytes.start))?;
    let mut buffer = vec![0; AT_ONCE];
    let mut rest = file.take(bytes.end - bytes.start);
    loop {
        match rest.read(&mut buffer)? {
            0 => return Ok(()),
            count => digest.update(&buffer[..count]),
        }
    }
}

/// The hexadecimal digits of a digest.
pub fn hex(digest: Sha256) -> String {
    digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
