//! External programs that some tests need: finds them, creates virtual environments of Python, skips tests without them.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The environment variable that names the tools without which a test fails instead of being skipped: some of
/// `python`, `browser` and `wasm`, with commas, or `all`.
const DEMAND: &str = "GROUNDBEAM_DEMAND";

/// An interpreter with the needed packages. The environment is created in a folder and reused by later runs.
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
    quietly(Command::new(system).args(["-c", version]), "there is no Python from 3.10 on")?;
    let mut make = Command::new(system);
    make.args(["-m", "venv", "--clear"]).arg(&home);
    quietly(&mut make, "no virtual environment can be made")?;
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
/// If it fails, with what it printed.
#[track_caller]
pub fn succeed(command: &mut Command) {
    let done = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let [shown, told] = [&done.stdout, &done.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    assert!(done.status.success(), "{shown}\n{told}");
}

/// The tools of a test. Without them a line on standard error reports that the test was skipped.
///
/// # Panics
///
/// If they are missing and `GROUNDBEAM_DEMAND` names them.
pub fn tools_or_skip<T>(tools: Result<T, String>, name: &str, subject: &str) -> Option<T> {
    let why = match tools {
        Ok(tools) => return Some(tools),
        Err(why) => why,
    };
    let demanded = std::env::var(DEMAND).unwrap_or_default();
    let is_demanded = demanded.split(',').any(|one| one == "all" || one == name);
    assert!(!is_demanded, "{subject} cannot be tested here ({DEMAND}={demanded}): {why}");
    let words = format!("\n*** SKIPPED: {subject} was NOT tested: {why}\n\n");
    // Not `eprintln!`, whose output is hidden for a passing test.
    std::io::stderr().write_all(words.as_bytes()).expect("standard error");
    None
}
