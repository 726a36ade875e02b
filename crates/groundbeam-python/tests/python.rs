//! Tests the Python package: copies it into a virtual environment with the library that Cargo has compiled, checks its
//! types, and runs its Python tests.
//!
//! `.ci/run` builds the wheel and installs it as users do.
//!
//! The test needs Python 3.10 or later and packages from its index. Without them it reports that it was
//! skipped, or fails if `GROUNDBEAM_DEMAND` names `python`.

use groundbeam_testing::{environment, succeed, tools_or_skip};
use std::env::consts;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

/// Packages that the tests need.
const NEEDS: [&str; 9] = [
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

/// Copies the package and its compiled library into the environment.
fn install(python: &Path) {
    let ask = ["-c", "import sysconfig; print(sysconfig.get_path('platlib'), end='')"];
    let answer = Command::new(python).args(ask).output().expect("Python");
    let place = String::from_utf8(answer.stdout).expect("a path that is text");
    let package = Path::new(&place).join("groundbeam");
    let _ = fs::remove_dir_all(&package);
    fs::create_dir_all(&package).expect("a folder in the environment");
    for entry in fs::read_dir(folder().join("python/groundbeam")).expect("the package") {
        let file = entry.expect("a file of the package").path();
        if file.is_file() {
            fs::copy(&file, package.join(file.file_name().expect("a name"))).expect("copied");
        }
    }
    let module = if cfg!(windows) { "_native.pyd" } else { "_native.abi3.so" };
    fs::copy(library(), package.join(module)).expect("the compiled library");
}

/// The library that Cargo compiles beside this test.
fn library() -> PathBuf {
    let own = std::env::current_exe().expect("this test is a file");
    let name = format!("{}groundbeam_native{}", consts::DLL_PREFIX, consts::DLL_SUFFIX);
    own.parent().expect("the folder of this test").join(name)
}

/// Runs Python outside the sources, so that it imports the installed package.
fn run(python: &Path, arguments: &[&str]) {
    succeed(Command::new(python).current_dir(workplace()).args(arguments));
}
