//! Tests faulty command lines and files, and outputs that cannot be written.

use crate::common::{Done, Folder, LIFTS};
use std::io::Read;
use std::process::Stdio;

#[test]
fn invalid_command_lines_are_refused() {
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
    folder.run(&["solve", "model.toml", "--plot", "p.jpg"]).fails(2, "must end in .svg or .png");
    assert_eq!(folder.names(), ["model.toml"]);
}

/// A model with a separate table of levels.
const SURVEYED: &str = "\
[beam]
length = 1
EI = 1
[foundation]
k = 1
[gap_survey]
file = \"levels.csv\"
[[load]]
point = 1
at = 0.5
";

/// Checks that a run is refused before it writes, and that the message names the file that would be lost.
#[track_caller]
fn loses(folder: &Folder, options: &[&str], parts: &[&str]) {
    let before = folder.names();
    let done = folder.run(&[&["solve", "model.toml"], options].concat());
    for part in parts {
        done.fails(2, part);
    }
    assert_eq!(folder.names(), before);
}

#[test]
fn no_output_replaces_another_output() {
    let folder = Folder::with(LIFTS);
    let same = |option: &str, other: &str| {
        format!(
            "error: {option}: this is the same file as {other}, and would replace it; name another file"
        )
    };
    loses(
        &folder,
        &["--csv", "a.csv", "--history", "./a.csv"],
        &[&same("--history ./a.csv", "--csv a.csv")],
    );
    loses(&folder, &["--csv", "a.svg", "--plot", "a.svg"], &[&same("--plot a.svg", "--csv a.svg")]);
    // All faults are reported together.
    let three = ["--csv", "a.html", "--report", "a.html", "--history", "./a.html"];
    let faults =
        [same("--report a.html", "--csv a.html"), same("--history ./a.html", "--csv a.html")];
    loses(&folder, &three, &[&faults[0], &faults[1]]);
    // The same if the file exists.
    folder.write("a.csv", b"old");
    std::fs::create_dir(folder.path("sub")).unwrap();
    loses(
        &folder,
        &["--csv", "a.csv", "--history", "sub/../a.csv"],
        &[&same("--history sub/../a.csv", "--csv a.csv")],
    );
    folder.run(&["solve", "model.toml", "--csv", "a.csv", "--history", "sub/a.csv"]).is_clean(0);
}

#[test]
fn no_output_replaces_a_file_of_the_input() {
    let folder = Folder::with(SURVEYED);
    folder.write("levels.csv", b"x,level\n0,0\n1,0.1\n");
    folder.run(&["solve", "model.toml"]).is_clean(0);
    let same = |option: &str, input: &str| {
        format!("error: {option}: this is the same file as the input {input}, and would replace it")
    };
    loses(&folder, &["--csv", "model.toml"], &[&same("--csv model.toml", "model.toml")]);
    loses(&folder, &["--csv", "./levels.csv"], &[&same("--csv ./levels.csv", "levels.csv")]);
    assert_eq!(folder.read("model.toml"), SURVEYED);
    folder.write("study.toml", b"model = \"model.toml\"\nsamples = 16\n[[random]]\nwhat = \"load[0]\"\ndistribution = \"normal\"\ncov = 0.1\n");
    let before = folder.names();
    for out in ["study.toml", "./model.toml", "levels.csv"] {
        for more in [&[][..], &["--restart"]] {
            let done = folder.run(&[&["study", "study.toml", "--out", out], more].concat());
            done.fails(2, &format!("error: --out {out}: this is the same file as the input "));
        }
    }
    let done = folder.run(&["study", "study.toml", "--out", "a.svg", "--plot", "./a.svg"]);
    done.fails(2, "error: --plot ./a.svg: this is the same file as --out a.svg");
    assert_eq!(folder.names(), before);
}

#[cfg(unix)]
#[test]
fn outputs_to_the_same_file_through_links_and_redirections_are_detected() {
    use std::fs::{File, hard_link};
    use std::os::unix::fs::symlink;
    let folder = Folder::with(LIFTS);
    symlink("a.csv", folder.path("dangling")).unwrap();
    symlink("dangling", folder.path("chain")).unwrap();
    hard_link(folder.path("model.toml"), folder.path("hard")).unwrap();
    symlink("loop", folder.path("loop")).unwrap();
    let is_same = "this is the same file as ";
    loses(&folder, &["--csv", "a.csv", "--history", "dangling"], &[is_same, "--csv a.csv"]);
    loses(&folder, &["--csv", "chain", "--history", "a.csv"], &[is_same, "--csv chain"]);
    loses(&folder, &["--csv", "hard"], &[is_same, "the input model.toml"]);
    loses(&folder, &["--csv", "loop"], &["error: --csv loop: the links form a loop"]);
    loses(&folder, &["--csv", "."], &["error: --csv .: this is a folder, not a file"]);
    let mut onto_itself = folder.command(&["solve", "-", "--csv", "model.toml"]);
    onto_itself.stdin(File::open(folder.path("model.toml")).unwrap());
    Done::from(onto_itself.output().unwrap()).fails(2, is_same);
    let mut redirected = folder.command(&["solve", "model.toml", "--csv", "out"]);
    redirected.stdout(File::create(folder.path("out")).unwrap());
    let said = redirected.output().unwrap();
    assert_eq!(said.status.code(), Some(2));
    assert!(String::from_utf8(said.stderr).unwrap().contains("the same file as standard output"));
    assert_eq!(folder.read("model.toml"), LIFTS);
}

#[cfg(unix)]
#[test]
fn outputs_are_written_through_links_and_to_devices() {
    use std::os::unix::fs::symlink;
    let folder = Folder::with(LIFTS);
    symlink("t.csv", folder.path("link")).unwrap();
    folder.run(&["solve", "model.toml", "--csv", "link"]).is_clean(0);
    assert!(folder.path("link").is_symlink());
    let table = folder.read("t.csv");
    assert!(table.starts_with("x,deflection,slope,"));
    folder
        .run(&["solve", "model.toml", "--csv", "/dev/null", "--history", "/dev/null"])
        .is_clean(0);
    // Standard output contains the table and then the report, both as a pipe and as a file.
    let is_both = |text: &str| {
        let report = text.strip_prefix(&table).unwrap();
        serde_json::from_str::<serde_json::Value>(report).unwrap();
    };
    let arguments = ["solve", "model.toml", "--json", "--csv", "/dev/stdout"];
    let piped = folder.run(&arguments);
    piped.is_clean(0);
    is_both(&piped.stdout);
    let mut redirected = folder.command(&arguments);
    redirected.stdout(std::fs::File::create(folder.path("all")).unwrap());
    assert!(redirected.status().unwrap().success());
    is_both(&folder.read("all"));
    assert_eq!(folder.names(), ["all", "link", "model.toml", "t.csv"]);
}

#[test]
fn unreadable_files_are_reported() {
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
fn unwritable_files_are_reported() {
    let folder = Folder::with(LIFTS);
    std::fs::create_dir(folder.path("folder.svg")).unwrap();
    for option in ["--csv", "--plot", "--history"] {
        let out = "nowhere/out.svg";
        folder.run(&["solve", "model.toml", option, out]).fails(2, "error: nowhere/out.svg: ");
        let done = folder.run(&["solve", "model.toml", option, "folder.svg"]);
        done.fails(2, &format!("error: {option} folder.svg: this is a folder, not a file"));
    }
    assert_eq!(folder.names(), ["folder.svg", "model.toml"]);
}

#[cfg(unix)]
#[test]
fn writing_to_a_link_replaces_its_target() {
    let folder = Folder::with(LIFTS);
    folder.write("real.csv", b"old");
    std::os::unix::fs::symlink("real.csv", folder.path("link.csv")).unwrap();
    folder.run(&["solve", "model.toml", "--csv", "link.csv"]).is_clean(0);
    assert!(folder.path("link.csv").symlink_metadata().unwrap().is_symlink());
    assert!(folder.read("real.csv").starts_with("x,"));
    // A device is written to and not replaced.
    folder.run(&["solve", "model.toml", "--csv", "/dev/null"]).is_clean(0);
}

#[test]
fn a_closed_pipe_ends_the_command_without_error() {
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
fn a_full_disk_is_reported() {
    let folder = Folder::with(LIFTS);
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let done = folder.command(&["solve", "model.toml"]).stdout(full).output().unwrap();
    assert_eq!(done.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&done.stderr).contains("standard output: "));
}

#[test]
fn output_is_not_coloured_without_a_terminal() {
    let folder = Folder::with(&LIFTS.replace("EI = 1", "EI = 0"));
    let mut command = folder.command(&["solve", "model.toml"]);
    let done = command.env_remove("NO_COLOR").env("TERM", "xterm-256color").output().unwrap();
    assert!(!done.stderr.contains(&0x1b) && done.stdout.is_empty());
}

/// Only regular files and standard input up to 64 MB are read. Endless files and pipes are refused.
#[cfg(target_os = "linux")]
#[test]
fn only_regular_files_and_standard_input_are_read() {
    let folder = Folder::new();
    let pipe = folder.path("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let survey = |file: &str| {
        let model =
            "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0\n";
        format!("{model}[gap_survey]\nfile = \"{file}\"\n")
    };
    let said = "this is a pipe or a device, not a file";
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
        (Some(2), "error: <stdin>: the file is longer than 64 MB\n")
    );
}
