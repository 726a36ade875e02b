//! Finds external programs for tests, creates Python environments, and skips tests whose programs are missing.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Environment variable with the required tools (`python`, `browser`, `wasm`, separated by commas, or `all`). Tests
/// fail if a required tool is missing.
const DEMAND: &str = "GROUNDBEAM_DEMAND";

/// Returns a Python interpreter with the needed packages. Its virtual environment is created in the folder
/// `place` and reused by later runs.
pub fn environment(place: &Path, needs: &[&str]) -> Result<PathBuf, String> {
    std::fs::create_dir_all(place).map_err(|error| error.to_string())?;
    let home = place.join("environment");
    let (programs, name) =
        if cfg!(windows) { ("Scripts", "python.exe") } else { ("bin", "python") };
    let python = home.join(programs).join(name);
    let (stamp, list) = (place.join("needs"), needs.join("\n"));
    if python.exists() && std::fs::read_to_string(&stamp).is_ok_and(|made| made == list) {
        return Ok(python);
    }
    let system = if cfg!(windows) { "python" } else { "python3" };
    let version = "import sys; sys.exit(sys.version_info < (3, 10))";
    quietly(Command::new(system).args(["-c", version]), "Python 3.10 or newer is not installed")?;
    let mut make = Command::new(system);
    make.args(["-m", "venv", "--clear"]).arg(&home);
    quietly(&mut make, "Python cannot create a virtual environment")?;
    let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    let done = Command::new(&python).args(install).args(needs).output();
    let done = done.map_err(|error| error.to_string())?;
    if !done.status.success() {
        let last = String::from_utf8_lossy(&done.stderr);
        let last = last.lines().last().unwrap_or_default();
        return Err(format!("pip cannot install {}: {last}", needs.join(", ")));
    }
    std::fs::write(&stamp, list).map_err(|error| error.to_string())?;
    Ok(python)
}

fn quietly(command: &mut Command, otherwise: &str) -> Result<(), String> {
    match command.output() {
        Ok(done) if done.status.success() => Ok(()),
        _ => Err(otherwise.to_owned()),
    }
}

/// Runs a command to its end.
///
/// # Panics
///
/// Panics if the command fails, with the output of the command.
#[track_caller]
pub fn succeed(command: &mut Command) {
    let done = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let [shown, told] = [&done.stdout, &done.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    assert!(done.status.success(), "{shown}\n{told}");
}

/// Returns the tools of a test. If they are missing, a line on standard error reports that the test was skipped.
///
/// # Panics
///
/// Panics if `GROUNDBEAM_DEMAND` names the missing tools.
pub fn tools_or_skip<T>(tools: Result<T, String>, name: &str, subject: &str) -> Option<T> {
    let why = match tools {
        Ok(tools) => return Some(tools),
        Err(why) => why,
    };
    let demanded = std::env::var(DEMAND).unwrap_or_default();
    let is_demanded = demanded.split(',').any(|one| one == "all" || one == name);
    assert!(
        !is_demanded,
        "{DEMAND}={demanded} demands a test of {subject}, which is not possible: {why}"
    );
    let words = format!("\n*** SKIPPED: {subject} was NOT tested: {why}\n\n");
    // `eprintln!` is not used, because its output is hidden for a passing test.
    std::io::stderr().write_all(words.as_bytes()).expect("standard error");
    None
}
