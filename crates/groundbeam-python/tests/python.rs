//! Tests the Python package: builds it as a wheel, installs it into a virtual environment, and runs its
//! Python tests.
//!
//! The test needs Python 3.10 or later and packages from its index. Without them it reports that it was
//! skipped, or fails if `GROUNDBEAM_DEMAND` names `python`.

use groundbeam_testing::{environment, succeed, tools_or_skip};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

/// Packages that the tests need.
const NEEDS: [&str; 10] = [
    "maturin>=1.9,<2",
    "numpy",
    "pytest",
    "pytest-xdist",
    "mypy",
    "pandas",
    "pandas-stubs",
    "matplotlib",
    "pyarrow",
    "distributed",
];

#[test]
fn the_tests_of_the_python_package_pass() {
    let python = environment(&workplace(), &NEEDS);
    let Some(python) = tools_or_skip(python, "python", "the Python package") else { return };
    install(&python);
    let package = folder();
    let [tests, examples] = ["tests", "examples"].map(|name| spelled(package.join(name)));
    let configuration = spelled(package.join("pyproject.toml"));
    let strictly = ["-m", "mypy", "--strict", "--config-file", &configuration];
    // Types are checked while the tests run on all processors.
    thread::scope(|scope| {
        scope.spawn(|| {
            run(&python, &[&strictly[..], &["-p", "groundbeam"]].concat());
            run(&python, &[&strictly[..], &[&tests, &examples]].concat());
            run(&python, &["-m", "mypy.stubtest", "groundbeam"]);
        });
        run(&python, &["-m", "pytest", "-p", "no:cacheprovider", "-q", "-n", "auto", &tests]);
    });
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn spelled(path: PathBuf) -> String {
    path.to_str().expect("a path that is text").to_owned()
}

/// Folder for temporary results.
fn workplace() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("python")
}

/// Builds the wheel and installs it.
fn install(python: &Path) {
    let wheels = workplace().join("wheels");
    let _ = std::fs::remove_dir_all(&wheels);
    let mut build = Command::new(python);
    build.current_dir(folder()).args(["-m", "maturin", "build", "--quiet", "--locked"]);
    build.args(["--auditwheel", "skip", "--interpreter"]).arg(python).arg("--out").arg(&wheels);
    build.env("CARGO_TARGET_DIR", target()).env("PIP_DISABLE_PIP_VERSION_CHECK", "1");
    if cfg!(debug_assertions) {
        build.args(["--profile", "dev"]);
    } else {
        build.arg("--release");
    }
    succeed(&mut build);
    let made =
        std::fs::read_dir(&wheels).expect("wheels").map(|entry| entry.expect("a file").path());
    let wheels: Vec<PathBuf> = made.collect();
    let [wheel] = &wheels[..] else { panic!("one wheel, not {wheels:?}") };
    let name = spelled(wheel.clone());
    assert!(name.contains("-cp310-abi3-"), "one wheel for every Python from 3.10 on: {name}");
    let install = ["-m", "pip", "install", "--quiet", "--no-deps", "--force-reinstall", &name];
    run(python, &install);
}

/// Folder of the compiled files: this test is in `target/debug/deps`.
fn target() -> PathBuf {
    let own = std::env::current_exe().expect("this test is a file");
    own.ancestors().nth(3).expect("target/debug/deps").to_owned()
}

/// Runs Python outside the sources, so that it imports the installed package.
fn run(python: &Path, arguments: &[&str]) {
    succeed(Command::new(python).current_dir(workplace()).args(arguments));
}
