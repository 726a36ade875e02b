//! Runs the real binary in a temporary folder.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// An eccentric unit load: the left end lifts off.
pub const LIFTS: &str = "\
title = \"Kikuchi 1980, case IV\"
[beam]
length = 1
EI = 1
[foundation]
k = 1
mu = 1
[[load]]
point = 1
at = 0.5
[[load]]
moment = 0.49
at = 0.5
";

/// The same with a larger moment, so that it tips about its right end.
pub fn tips() -> String {
    LIFTS.replace("0.49", "0.6")
}

/// [`LIFTS`] in two combinations.
pub fn combined() -> String {
    format!(
        "{LIFTS}case = 'Q'\n[[combination]]\nname = 'one'\nfactors = {{ Q = 1.0 }}\n\
         [[combination]]\nname = 'two'\nfactors = {{ Q = 0.5 }}\n"
    )
}

/// A footing with units.
pub const FOOTING: &str = "\
[beam]
length = \"12 m\"
EI = \"1.2e6 kN m^2\"
[foundation]
k = \"40 MN/m^2\"
[[load]]
point = \"600 kN\"
at = \"5 m\"
";

/// A folder with model files.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Self {
        Folder(tempfile::tempdir().unwrap())
    }

    pub fn with(text: &str) -> Self {
        let folder = Folder::new();
        folder.write("model.toml", text.as_bytes());
        folder
    }

    pub fn write(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self.path(name), bytes).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.root().join(name)
    }

    pub fn root(&self) -> &Path {
        self.0.path()
    }

    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.root()).unwrap();
        let name = |entry: std::io::Result<std::fs::DirEntry>| {
            entry.unwrap().file_name().into_string().unwrap()
        };
        let mut names: Vec<String> = entries.map(name).collect();
        names.sort();
        names
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_groundbeam"));
        command.args(arguments).current_dir(self.root()).stdin(Stdio::null());
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Done {
        Done::from(self.command(arguments).output().unwrap())
    }

    pub fn run_with_input(&self, arguments: &[&str], input: &[u8]) -> Done {
        let mut command = self.command(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        child.stdin.take().unwrap().write_all(input).unwrap();
        Done::from(child.wait_with_output().unwrap())
    }
}

/// Output of a run.
#[derive(Debug)]
pub struct Done {
    pub status: i32,
    pub stdout: String,
    pub stderr: String,
}

impl From<Output> for Done {
    fn from(output: Output) -> Self {
        Done {
            status: output.status.code().unwrap(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Done {
    /// Checks the exit status, that standard error is empty, and that there are no escape codes.
    #[track_caller]
    pub fn is_clean(&self, status: i32) {
        assert_eq!((self.status, self.stderr.as_str()), (status, ""));
        assert!(!self.stdout.contains('\u{1b}'));
    }

    /// Checks the exit status, that standard output is empty, and that standard error contains this text.
    #[track_caller]
    pub fn fails(&self, status: i32, part: &str) {
        assert_eq!((self.status, self.stdout.as_str()), (status, ""), "{}", self.stderr);
        assert!(self.stderr.contains(part), "{}", self.stderr);
        assert!(!self.stderr.contains('\u{1b}') && !self.stderr.contains("panicked"));
    }

    pub fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.stdout).unwrap()
    }
}
