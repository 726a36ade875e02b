//! Command lines and files that are wrong, and outputs that cannot be written.

#[allow(dead_code)]
mod common;

use common::{Folder, LIFTS};
use std::io::Read;
use std::process::Stdio;

#[test]
fn wrong_command_lines() {
    let folder = Folder::with(LIFTS);
    let wrong: [&[&str]; 10] = [
        &[],
        &["sovle"],
        &["solve"],
        &["solve", "model.toml", "--metod", "exact"],
        &["solve", "model.toml", "--method", "newton"],
        &["solve", "model.toml", "--elements", "0"],
        &["solve", "model.toml", "--elements", "many"],
        &["solve", "model.toml", "--plot", "picture.jpg"],
        &["solve", "model.toml", "--plot", "picture"],
        &["completions", "cmd"],
    ];
    for arguments in wrong {
        folder.run(arguments).fails(2, "");
    }
    folder.run(&["solve", "model.toml", "--plot", "p.jpg"]).fails(2, "ends in .svg or .png");
    assert_eq!(folder.names(), ["model.toml"]);
}

#[test]
fn no_output_replaces_the_model_or_another_output() {
    let folder = Folder::with(LIFTS);
    folder.run(&["solve", "model.toml", "--csv", "model.toml"]).fails(2, "is the model itself");
    let twice = ["solve", "model.toml", "--csv", "out", "--history", "out"];
    folder.run(&twice).fails(2, "is given for two outputs");
    assert_eq!(folder.read("model.toml"), LIFTS);
}

#[test]
fn files_that_cannot_be_read() {
    let folder = Folder::new();
    folder.write("latin.toml", b"title = \"Gr\xfcndung\"\n");
    folder.write("empty.toml", b"");
    for command in ["solve", "check"] {
        folder.run(&[command, "missing.toml"]).fails(2, "error: missing.toml: ");
        folder.run(&[command, "."]).fails(2, "error: .: ");
        folder.run(&[command, "latin.toml"]).fails(2, "--> latin.toml:1:12");
        folder.run(&[command, "empty.toml"]).fails(2, "error[GB018]");
    }
}

#[test]
fn files_that_cannot_be_written() {
    let folder = Folder::with(LIFTS);
    std::fs::create_dir(folder.path("folder.svg")).unwrap();
    for option in ["--csv", "--plot", "--history"] {
        let out = "nowhere/out.svg";
        folder.run(&["solve", "model.toml", option, out]).fails(2, "error: nowhere/out.svg: ");
        let done = folder.run(&["solve", "model.toml", option, "folder.svg"]);
        done.fails(2, "error: folder.svg: ");
    }
    assert_eq!(folder.names(), ["folder.svg", "model.toml"]);
}

#[cfg(unix)]
#[test]
fn what_a_link_leads_to_is_replaced() {
    let folder = Folder::with(LIFTS);
    folder.write("real.csv", b"old");
    std::os::unix::fs::symlink("real.csv", folder.path("link.csv")).unwrap();
    folder.run(&["solve", "model.toml", "--csv", "link.csv"]).is_clean(0);
    assert!(folder.path("link.csv").symlink_metadata().unwrap().is_symlink());
    assert!(folder.read("real.csv").starts_with("x,"));
    // A device is written to, not replaced.
    folder.run(&["solve", "model.toml", "--csv", "/dev/null"]).is_clean(0);
}

#[test]
fn a_reader_that_has_seen_enough() {
    let folder = Folder::with(LIFTS);
    let commands: [&[&str]; 5] = [
        &["solve", "model.toml", "--json"],
        &["check", "model.toml"],
        &["completions", "bash"],
        &["man"],
        &["--help"],
    ];
    for arguments in commands {
        let mut command = folder.command(arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let status = child.wait().unwrap();
        let mut said = String::new();
        child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        assert_eq!((status.code(), said.as_str()), (Some(0), ""), "{arguments:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = Folder::with(LIFTS);
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let done = folder.command(&["solve", "model.toml"]).stdout(full).output().unwrap();
    assert_eq!(done.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&done.stderr).contains("standard output: "));
}

#[test]
fn nothing_is_coloured_without_a_terminal() {
    let folder = Folder::with(&LIFTS.replace("EI = 1", "EI = 0"));
    let mut command = folder.command(&["solve", "model.toml"]);
    let done = command.env_remove("NO_COLOR").env("TERM", "xterm-256color").output().unwrap();
    assert!(!done.stderr.contains(&0x1b) && done.stdout.is_empty());
}

/// Nothing that never ends is read, and no pipe is waited for: only regular files, and standard input up to 64 MB.
#[cfg(target_os = "linux")]
#[test]
fn only_files_are_read() {
    let folder = Folder::new();
    let pipe = folder.path("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let survey = |file: &str| {
        let model =
            "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0\n";
        format!("{model}[gap_survey]\nfile = \"{file}\"\n")
    };
    let said = "it is a pipe or a device, not a file";
    for file in ["/dev/zero", "pipe"] {
        for command in ["solve", "check", "compare", "serve"] {
            folder.run(&[command, file]).fails(2, said);
        }
        folder.run(&["study", file, "--out", "out"]).fails(2, said);
        folder.run(&["merge", file, "--out", "out"]).fails(2, said);
        folder.write("survey.toml", survey(file).as_bytes());
        folder.run(&["solve", "survey.toml"]).fails(2, said);
        folder.write("study.toml", format!("model = \"{file}\"\n").as_bytes());
        folder.run(&["study", "study.toml", "--out", "out"]).fails(2, said);
    }
    let endless = std::fs::File::open("/dev/zero").unwrap();
    let done = folder.command(&["solve", "-"]).stdin(endless).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(
        (done.status.code(), &*said),
        (Some(2), "error: <stdin>: it is longer than 64 MB\n")
    );
}
