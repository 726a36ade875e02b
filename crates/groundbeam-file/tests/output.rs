//! Tests of output files: complete replacement, links, devices and pipes.

use groundbeam_file::output::{Identity, Output, write};
use std::fs;
use std::io::Write;
use std::path::Path;

/// Sorted names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    let names = fs::read_dir(folder).unwrap().map(name);
    let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn an_unfinished_output_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    write(&path, b"old").unwrap();
    let mut output = Output::create(&path).unwrap();
    output.write_all(b"half").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"old");
    drop(output);
    assert_eq!(
        (fs::read(&path).unwrap(), names(folder.path())),
        (b"old".to_vec(), vec!["a.csv".to_owned()])
    );
    write(&path, b"new").unwrap();
    assert_eq!(
        (fs::read(&path).unwrap(), names(folder.path())),
        (b"new".to_vec(), vec!["a.csv".to_owned()])
    );
}

#[test]
fn one_process_writes_a_file_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    let mut first = Output::create(&path).unwrap();
    let second = Output::create(&path).err().unwrap();
    assert_eq!(second.to_string(), "another process is writing this file");
    first.write_all(b"first").unwrap();
    first.finish().unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"first");
}

#[test]
fn the_temporary_file_of_a_killed_process_is_reused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    let mut killed = Output::create(&path).unwrap();
    killed.write_all(b"longer than the new text").unwrap();
    let left = names(folder.path()).remove(0);
    drop(killed);
    fs::write(folder.path().join(left), b"longer than the new text").unwrap();
    write(&path, b"new").unwrap();
    assert_eq!(
        (fs::read(&path).unwrap(), names(folder.path())),
        (b"new".to_vec(), vec!["a.csv".to_owned()])
    );
}

#[test]
fn concurrent_writes_leave_the_complete_text_of_one_thread() {
    let folder = tempfile::tempdir().unwrap();
    let path = &folder.path().join("a.csv");
    let text = |i: u8| vec![i; 100_000];
    std::thread::scope(|scope| {
        for i in 0..4 {
            scope.spawn(move || {
                for _ in 0..50 {
                    // A thread fails if another one is writing.
                    let _ = write(path, &text(i));
                    let seen = fs::read(path).unwrap_or_else(|_| text(0));
                    assert!(seen.len() == 100_000 && seen.iter().all(|byte| *byte == seen[0]));
                }
            });
        }
    });
    assert_eq!(names(folder.path()), ["a.csv"]);
}

#[test]
fn paths_that_cannot_be_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |path: &Path| write(path, b"text").unwrap_err().to_string();
    assert_eq!(refused(folder.path()), "this is a folder, not a file");
    assert_eq!(refused(Path::new("")), "the path does not end with the name of a file");
    assert!(refused(&folder.path().join("none/a.csv")).contains("No such file"));
}

#[test]
fn different_spellings_of_a_path_identify_one_file() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("b")).unwrap();
    let identity = |name: &str| Identity::of(&folder.path().join(name)).unwrap().unwrap();
    for _ in 0..2 {
        assert_eq!(identity("a.csv"), identity("./a.csv"));
        assert_eq!(identity("a.csv"), identity("b/../a.csv"));
        assert_ne!(identity("a.csv"), identity("b/a.csv"));
        assert_ne!(identity("a.csv"), identity("c.csv"));
        // The same again for files that exist.
        for name in ["a.csv", "b/a.csv", "c.csv"] {
            fs::write(folder.path().join(name), name).unwrap();
        }
    }
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::{Command, Stdio};

    #[test]
    fn links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("data")).unwrap();
        fs::write(path("data/there"), "old").unwrap();
        symlink("data/there", path("to-there")).unwrap();
        symlink("data/dangling", path("dangling")).unwrap();
        symlink("../dangling", path("data/chain")).unwrap();
        symlink(path("data/chain"), path("long-chain")).unwrap();
        for (link, target) in
            [("to-there", "there"), ("dangling", "dangling"), ("long-chain", "dangling")]
        {
            write(&path(link), link.as_bytes()).unwrap();
            assert!(path(link).is_symlink(), "{link}");
            assert_eq!(fs::read_to_string(path("data").join(target)).unwrap(), link);
        }
        assert_eq!(names(&path("data")), ["chain", "dangling", "there"]);
        assert_eq!(names(folder.path()), ["dangling", "data", "long-chain", "to-there"]);
    }

    #[test]
    fn a_loop_of_links_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        symlink("b", path("a")).unwrap();
        symlink("a", path("b")).unwrap();
        let error = write(&path("a"), b"text").unwrap_err();
        assert_eq!(error.to_string(), "the links form a loop");
        assert_eq!(Identity::of(&path("a")).unwrap_err().to_string(), "the links form a loop");
        assert!(path("a").is_symlink() && path("b").is_symlink());
    }

    #[test]
    fn permissions_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        for mode in [0o600, 0o664, 0o755] {
            fs::write(&path, "old").unwrap();
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            write(&path, b"new").unwrap();
            assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o7777, mode);
        }
    }

    #[test]
    fn devices_and_pipes_are_written_directly() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        symlink("pipe", folder.path().join("link")).unwrap();
        for name in ["pipe", "link"] {
            let reader = Command::new("cat").arg(&pipe).stdout(Stdio::piped()).spawn().unwrap();
            write(&folder.path().join(name), name.as_bytes()).unwrap();
            assert_eq!(reader.wait_with_output().unwrap().stdout, name.as_bytes());
        }
        write(Path::new("/dev/null"), b"text").unwrap();
        assert_eq!(names(folder.path()), ["link", "pipe"]);
        assert_eq!(Identity::of(&pipe).unwrap(), None);
        assert_eq!(Identity::of(Path::new("/dev/null")).unwrap(), None);
    }

    #[test]
    fn links_and_hard_links_identify_their_target() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let identity = |name: &str| Identity::of(&path(name)).unwrap().unwrap();
        symlink("a", path("dangling")).unwrap();
        symlink(".", path("here")).unwrap();
        assert_eq!(identity("a"), identity("dangling"));
        assert_eq!(identity("a"), identity("here/a"));
        fs::write(path("a"), "text").unwrap();
        fs::hard_link(path("a"), path("hard")).unwrap();
        for other in ["dangling", "here/a", "hard"] {
            assert_eq!(identity("a"), identity(other), "{other}");
        }
    }
}
