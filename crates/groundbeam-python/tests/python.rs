//! Tests the Python package: builds it as a wheel, installs it into a virtual environment, and runs its
//! Python tests.
//!
//! The test needs Python 3.10 or later and packages from its index. Without them it reports that it was
//! skipped, or fails if the variable `GROUNDBEAM_DEMAND_PYTHON` is set.

mod environment;

use environment::{environment, tools_or_skip};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Packages that the tests need.
const NEEDS: [&str; 9] = [
    "maturin>=1.9,<2",
    "numpy",
    "pytest",
    "mypy",
    "pandas",
    "pandas-stubs",
    "matplotlib",
    "pyarrow",
    "distributed",
];

#[test]
fn the_package_does_what_its_tests_say() {
    let python = environment(&workplace(), &NEEDS);
    let (variable, subject) = ("GROUNDBEAM_DEMAND_PYTHON", "the Python package");
    let Some(python) = tools_or_skip(python, variable, subject) else { return };
    install(&python);
    let package = folder();
    // The tests run outside the sources, so that they import the installed package.
    let tests = [package.join("tests"), package.join("python")].map(spelled);
    succeed(in_folder(&python, &["-m", "pytest", "-p", "no:cacheprovider", "-q", &tests[0]]));
    let configuration = spelled(package.join("pyproject.toml"));
    let strictly = ["-m", "mypy", "--strict", "--config-file", &configuration];
    let packages = [&strictly[..], &["-p", "groundbeam"]].concat();
    succeed(in_folder(&python, &packages));
    let examples = spelled(package.join("examples"));
    succeed(in_folder(&python, &[&strictly[..], &[&tests[0], &examples]].concat()));
    succeed(in_folder(&python, &["-m", "mypy.stubtest", "groundbeam"]));
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

/// Builds the wheel from the crates that `cargo test` has compiled, and installs it.
fn install(python: &Path) {
    let wheels = workplace().join("wheels");
    let _ = std::fs::remove_dir_all(&wheels);
    let mut build = Command::new(python);
    build.current_dir(folder()).args(["-m", "maturin", "build", "--quiet", "--locked"]);
    build.args(["--auditwheel", "skip", "--interpreter"]).arg(python).arg("--out").arg(&wheels);
    build.env("CARGO_TARGET_DIR", target()).env("PIP_DISABLE_PIP_VERSION_CHECK", "1");
    if cfg!(debug_assertions) {
        // Dependencies have the settings of the test profile.
        build.args(["--profile", "dev"]).env("CARGO_PROFILE_DEV_OPT_LEVEL", "2");
    } else {
        build.arg("--release");
    }
    succeed(build.output().expect("maturin runs"));
    let made =
        std::fs::read_dir(&wheels).expect("wheels").map(|entry| entry.expect("a file").path());
    let wheels: Vec<PathBuf> = made.collect();
    let [wheel] = &wheels[..] else { panic!("one wheel, not {wheels:?}") };
    let name = spelled(wheel.clone());
    assert!(name.contains("-cp310-abi3-"), "one wheel for every Python from 3.10 on: {name}");
    let install = ["-m", "pip", "install", "--quiet", "--no-deps", "--force-reinstall", &name];
    succeed(in_folder(python, &install));
}

/// Folder of the compiled files: this test is in `target/debug/deps`.
fn target() -> PathBuf {
    let own = std::env::current_exe().expect("this test is a file");
    own.ancestors().nth(3).expect("target/debug/deps").to_owned()
}

fn in_folder(python: &Path, arguments: &[&str]) -> Output {
    let run = Command::new(python).current_dir(workplace()).args(arguments).output();
    run.expect("Python runs")
}

fn succeed(done: Output) {
    let [shown, told] = [&done.stdout, &done.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    assert!(done.status.success(), "{shown}\n{told}");
}
