//! Output files that are written completely or not at all.
//!
//! An [`Output`] writes to a temporary file beside its target, and renames this file. Symbolic links are followed.
//! Devices, pipes and standard streams are written directly.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Maximum number of symbolic links that are followed from one path; Linux has the same limit.
const MOST_LINKS: usize = 40;

/// An output that is being written. If it is dropped before [`Output::finish`], an existing file remains
/// unchanged.
pub struct Output {
    sink: Sink,
}

enum Sink {
    /// A standard stream, a device or a pipe, to which the output is written directly.
    Direct(Box<dyn Write + Send>),
    Replacement(Replacement),
}

/// Temporary file that replaces the target when the output is finished.
struct Replacement {
    /// The temporary file. This process locks the file until the output is finished or dropped.
    file: File,
    unfinished: PathBuf,
    target: PathBuf,
    is_finished: bool,
}

/// Writes `bytes` to a file. The file is written completely or not at all.
///
/// # Errors
///
/// Returns the errors of [`Output::create`] and [`Output::finish`].
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut output = Output::create(path)?;
    output.write_all(bytes)?;
    output.finish()
}

impl Output {
    /// Opens an output. An existing file keeps its permissions.
    ///
    /// # Errors
    ///
    /// The path cannot be written, its symbolic links form a loop, or another process is writing the file.
    pub fn create(path: &Path) -> io::Result<Self> {
        let sink = match Target::of(path)? {
            Target::StandardOutput => Sink::Direct(Box::new(io::stdout())),
            Target::StandardError => Sink::Direct(Box::new(io::stderr())),
            Target::Direct(path) => {
                Sink::Direct(Box::new(OpenOptions::new().append(true).open(path)?))
            }
            Target::File(target) => Sink::Replacement(Replacement::of(target)?),
        };
        Ok(Output { sink })
    }

    /// Completes the output: syncs the temporary file and renames it to the target, or flushes a direct output.
    ///
    /// # Errors
    ///
    /// Returns an error of the file system. If syncing or renaming fails, an existing target remains unchanged.
    pub fn finish(self) -> io::Result<()> {
        match self.sink {
            Sink::Direct(mut sink) => sink.flush(),
            Sink::Replacement(replacement) => replacement.finish(),
        }
    }

    fn sink(&mut self) -> &mut dyn Write {
        match &mut self.sink {
            Sink::Direct(sink) => sink,
            Sink::Replacement(replacement) => &mut replacement.file,
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.sink().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink().flush()
    }
}

impl Replacement {
    fn of(target: PathBuf) -> io::Result<Self> {
        // Opening an existing target for writing shows whether the target is writable.
        let permissions = match OpenOptions::new().write(true).open(&target) {
            Ok(old) => Some(old.metadata()?.permissions()),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let unfinished = beside(&target)?;
        let file = locked(&unfinished)?;
        let replacement = Replacement { file, unfinished, target, is_finished: false };
        if let Some(permissions) = permissions {
            replacement.file.set_permissions(permissions)?;
        }
        Ok(replacement)
    }

    fn finish(mut self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.unfinished, &self.target)?;
        self.is_finished = true;
        sync(folder(&self.target))
    }
}

impl Drop for Replacement {
    fn drop(&mut self) {
        if !self.is_finished {
            // The caller reports the first error, so an error while removing the file is ignored.
            let _ = fs::remove_file(&self.unfinished);
        }
    }
}

/// Returns the path of the temporary file. The file lies in the folder of the target, so that renaming
/// stays within one file system.
fn beside(target: &Path) -> io::Result<PathBuf> {
    let name = target.file_name().ok_or_else(|| {
        io::Error::new(ErrorKind::InvalidInput, "the path does not end with the name of a file")
    })?;
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(".unfinished");
    Ok(target.with_file_name(hidden))
}

/// Opens an empty file and locks it for this process. A file that a killed process has left behind is
/// reused.
fn locked(path: &Path) -> io::Result<File> {
    loop {
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path)?;
        match file.try_lock() {
            // Some file systems do not support locks; the file is then used without a lock.
            Ok(()) | Err(TryLockError::Error(_)) => {}
            Err(TryLockError::WouldBlock) => {
                let message = "another process is writing this file";
                return Err(io::Error::new(ErrorKind::WouldBlock, message));
            }
        }
        // Another process may have renamed the file between opening and locking.
        if is_at(&file, path) {
            file.set_len(0)?;
            return Ok(file);
        }
    }
}

#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |found: &fs::Metadata| (found.dev(), found.ino());
    matches!((file.metadata(), fs::metadata(path)), (Ok(a), Ok(b)) if place(&a) == place(&b))
}

#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}

/// Syncs the entries of a folder to disk, on systems that can open a folder.
fn sync(folder: &Path) -> io::Result<()> {
    if !cfg!(unix) {
        return Ok(());
    }
    match File::open(folder).and_then(|folder| folder.sync_all()) {
        // Some file systems cannot sync a folder.
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => {
            Ok(())
        }
        synced => synced,
    }
}

/// The folder of a path.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Destination of an output after following all links.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Target {
    /// The standard output stream of this process.
    StandardOutput,
    /// The standard error stream of this process.
    StandardError,
    /// The given path of a device, of a pipe or of an open file of this process.
    Direct(PathBuf),
    /// The path of a regular file that exists or can be created.
    File(PathBuf),
}

impl Target {
    /// Follows the symbolic links of a path. The last link may point to a file that does not exist.
    ///
    /// # Errors
    ///
    /// The links form a loop, or the path leads to a folder or cannot be read.
    pub fn of(path: &Path) -> io::Result<Self> {
        let mut target = path.to_owned();
        for _ in 0..=MOST_LINKS {
            match descriptor(&target) {
                Some(1) => return Ok(Target::StandardOutput),
                Some(2) => return Ok(Target::StandardError),
                Some(_) => return Ok(Target::Direct(path.to_owned())),
                None => {}
            }
            let found = match fs::symlink_metadata(&target) {
                Ok(found) => found,
                Err(error) if error.kind() == ErrorKind::NotFound => {
                    return Ok(Target::File(target));
                }
                Err(error) => return Err(error),
            };
            if found.is_symlink() {
                target = folder(&target).join(fs::read_link(&target)?);
            } else if found.is_file() {
                return Ok(Target::File(target));
            } else if found.is_dir() {
                return Err(io::Error::new(
                    ErrorKind::IsADirectory,
                    "this is a folder, not a file",
                ));
            } else {
                return Ok(Target::Direct(path.to_owned()));
            }
        }
        Err(io::Error::other("the links form a loop"))
    }
}

/// Returns the file descriptor that a path such as `/dev/fd/1` names; `None` for other paths.
fn descriptor(path: &Path) -> Option<u32> {
    let number = path.file_name()?.to_str()?.parse().ok()?;
    let folder = folder(path).canonicalize().ok()?;
    let names = ["/dev/fd", "/proc/self/fd"].map(|name| Path::new(name).canonicalize().ok());
    names.contains(&Some(folder)).then_some(number)
}

/// Identity of a regular file. All paths and symbolic links to one file have equal identities. On Unix, all
/// hard links to one file also have equal identities.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Identity(Key);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Key {
    #[cfg(unix)]
    Number(u64, u64),
    Path(PathBuf),
}

impl Identity {
    /// Returns the identity of an existing or future output file; `None` for a device or a pipe.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`Target::of`], or an error if the path cannot be resolved.
    pub fn of(path: &Path) -> io::Result<Option<Self>> {
        match fs::metadata(path) {
            Ok(found) if found.is_file() => {
                return Ok(Some(Identity(Key::of_existing(path, &found)?)));
            }
            Ok(_) => return Target::of(path).map(|_| None),
            Err(_) => {}
        }
        let Target::File(target) = Target::of(path)? else { return Ok(None) };
        let Some(name) = target.file_name() else { return Ok(None) };
        // If the folder is missing, creating the file fails later.
        let folder = folder(&target);
        let folder = folder.canonicalize().or_else(|_| std::path::absolute(folder))?;
        let ignores_case = cfg!(any(windows, target_os = "macos"));
        let name = if ignores_case { name.to_ascii_lowercase() } else { name.to_owned() };
        Ok(Some(Identity(Key::Path(folder.join(name)))))
    }
}

impl Key {
    #[cfg(unix)]
    #[expect(clippy::unnecessary_wraps, reason = "elsewhere it can fail")]
    fn of_existing(_: &Path, found: &fs::Metadata) -> io::Result<Self> {
        use std::os::unix::fs::MetadataExt;
        Ok(Key::Number(found.dev(), found.ino()))
    }

    #[cfg(not(unix))]
    fn of_existing(path: &Path, _: &fs::Metadata) -> io::Result<Self> {
        path.canonicalize().map(Key::Path)
    }
}
