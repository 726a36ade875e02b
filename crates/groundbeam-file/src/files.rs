//! Reads regular files of at most 64 MB.

use std::fs::{File, Metadata, metadata};
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// Maximum size of a file \[bytes\]. This size allows about a million loads, or three million rows of a survey.
const MOST: u64 = 64_000_000;

/// Opens a regular file for reading.
///
/// # Errors
///
/// Returns the errors of [`File::open`], and an error for folders, pipes, devices and links to them.
pub fn open_file(path: &Path) -> Result<File> {
    // Opening a pipe without a writer would block, so the path is checked before the file is opened.
    regular(&metadata(path)?)?;
    let file = File::open(path)?;
    regular(&file.metadata()?)?;
    Ok(file)
}

/// Reads a regular file of at most 64 MB.
///
/// # Errors
///
/// Returns the errors of [`open_file`], and an error if the file is longer than 64 MB.
pub fn read_file(path: &Path) -> Result<Vec<u8>> {
    read_bounded(open_file(path)?)
}

/// Reads a stream of at most 64 MB to its end.
///
/// # Errors
///
/// Returns the errors of the stream, and [`ErrorKind::FileTooLarge`] if the stream is longer than 64 MB.
pub fn read_bounded(stream: impl Read) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    stream.take(MOST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST {
        return Err(Error::new(ErrorKind::FileTooLarge, "the file is longer than 64 MB"));
    }
    Ok(bytes)
}

fn regular(found: &Metadata) -> Result<()> {
    if found.is_file() {
        return Ok(());
    }
    let what = if found.is_dir() { "a folder" } else { "a pipe or a device" };
    Err(Error::new(ErrorKind::InvalidInput, format!("this is {what}, not a file")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_endless_stream_is_refused() {
        let error = read_bounded(std::io::repeat(b'#')).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::FileTooLarge);
        let most = read_bounded(std::io::repeat(b'#').take(MOST)).unwrap();
        assert_eq!(most.len() as u64, MOST);
    }

    #[test]
    fn only_regular_files_are_read() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        assert!(read_file(&folder.join("Cargo.toml")).is_ok());
        assert_eq!(read_file(folder).unwrap_err().to_string(), "this is a folder, not a file");
        #[cfg(unix)]
        for device in ["/dev/zero", "/dev/null"] {
            let error = read_file(Path::new(device)).unwrap_err();
            assert_eq!(error.to_string(), "this is a pipe or a device, not a file");
        }
    }
}
