//! Checks the rules of `ARCHITECTURE.md` about the code.
//!
//! Claims: `docs/code-map.md`.

use groundbeam_testing::{expect, read, repository};
use groundbeam_verification::architecture::{Source, crates, map, sources};
use groundbeam_verification::imports::Imports;

/// Allowed dependencies of each crate within the workspace.
const ARROWS: [(&str, &[&str]); 14] = [
    ("groundbeam-proof", &[]),
    ("groundbeam-testing", &[]),
    ("groundbeam-wasm", &["groundbeam", "groundbeam-file", "groundbeam-proof"]),
    ("groundbeam", &["groundbeam-proof"]),
    ("groundbeam-file", &["groundbeam"]),
    ("groundbeam-run", &["groundbeam", "groundbeam-file"]),
    ("groundbeam-report", &["groundbeam", "groundbeam-file", "groundbeam-run"]),
    ("groundbeam-page", &["groundbeam", "groundbeam-file", "groundbeam-report", "groundbeam-run"]),
    ("groundbeam-pdf", &["groundbeam-report"]),
    ("groundbeam-study", &["groundbeam", "groundbeam-file", "groundbeam-report", "groundbeam-run"]),
    (
        "groundbeam-cli",
        &[
            "groundbeam",
            "groundbeam-file",
            "groundbeam-page",
            "groundbeam-pdf",
            "groundbeam-report",
            "groundbeam-run",
            "groundbeam-study",
        ],
    ),
    (
        "groundbeam-python",
        &[
            "groundbeam",
            "groundbeam-file",
            "groundbeam-report",
            "groundbeam-run",
            "groundbeam-study",
        ],
    ),
    ("groundbeam-bench", &["groundbeam", "groundbeam-file", "groundbeam-study"]),
    (
        "groundbeam-verification",
        &[
            "groundbeam",
            "groundbeam-file",
            "groundbeam-proof",
            "groundbeam-report",
            "groundbeam-run",
            "groundbeam-testing",
        ],
    ),
];

/// The layers of the core, the highest first. A folder or file may import only from lower layers.
const LAYERS: [&[&str]; 15] = [
    &["lib"],
    &["load_factors", "nodal_solver", "soil"],
    &["solver"],
    &["solve"],
    &["equilibrium"],
    &["derivatives", "design", "envelope", "outcome"],
    &["solution"],
    &["contact"],
    &["chain", "nodal"],
    &["element", "supported"],
    &["mesh"],
    &["error", "existence", "ground"],
    &["model"],
    &["numeric", "options"],
    &["cancel"],
];

/// Top folders and files of the other crates that import each other in a cycle. This list may only shrink.
const CYCLES: [(&str, &[&str]); 2] = [
    ("groundbeam-file", &["combination", "document", "reader", "units"]),
    ("groundbeam-pdf", &["lib", "typeset", "without"]),
];

/// Maximum number of lines of a file, without the tests at its end.
const BUDGET: usize = 450;
/// Forbidden in the mathematical crates: input and output, clocks, environment, unordered maps, panics.
const NEVER_IN_THE_CORE: [&str; 22] = [
    "println!",
    "print!",
    "eprintln!",
    "eprint!",
    "dbg!",
    "std::fs",
    "std::io",
    "std::env",
    "std::net",
    "std::time",
    "std::thread",
    "std::process",
    "HashMap",
    "HashSet",
    "unsafe {",
    ".unwrap()",
    ".expect(",
    "panic!",
    "unreachable!",
    "todo!",
    "unimplemented!",
    "assert!(",
];

#[test]
fn the_code_map_is_up_to_date() {
    expect("docs/code-map.md", "code map", &map());
}

#[test]
fn crates_depend_on_each_other_one_way() {
    let crates = crates();
    for (name, (_, needs)) in &crates {
        let allowed = ARROWS.iter().find(|(crate_name, _)| crate_name == name);
        let (_, allowed) = allowed.unwrap_or_else(|| panic!("{name} is not in ARCHITECTURE.md"));
        for need in needs.iter().filter(|need| crates.contains_key(*need)) {
            assert!(allowed.contains(&need.as_str()), "{name} must not depend on {need}");
        }
    }
    let (_, needs) = &crates["groundbeam"];
    assert_eq!(
        needs,
        &["groundbeam-proof", "libm"],
        "the mathematics depends on its proof and libm"
    );
    let (_, needs) = &crates["groundbeam-proof"];
    assert!(needs.is_empty(), "the proof depends on nothing: {needs:?}");
    for (name, (_, needs)) in &crates {
        let knows_toml = needs.iter().any(|need| need.starts_with("toml"));
        assert!(
            !knows_toml || name == "groundbeam-file",
            "only groundbeam-file knows TOML: {name}"
        );
    }
}

#[test]
fn every_file_is_documented_and_short() {
    let mut faults = Vec::new();
    for source in all_sources() {
        if source.summary().is_none() {
            faults.push(format!("{} does not begin with its documentation", source.path));
        }
        let lines = source.code().lines().count();
        if lines > BUDGET {
            faults.push(format!("{} has {lines} lines, more than {BUDGET}", source.path));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Cargo runs only the tests that `tests/main.rs` or `Cargo.toml` names.
#[test]
fn every_test_file_is_run() {
    let mut count = 0;
    for (folder, _) in crates().into_values() {
        let tests = repository().join(&folder).join("tests");
        if !tests.join("main.rs").exists() {
            continue;
        }
        let named =
            read(&format!("{folder}/tests/main.rs")) + &read(&format!("{folder}/Cargo.toml"));
        for entry in std::fs::read_dir(tests).expect("the tests") {
            let path = entry.expect("a file").path();
            let is_code = path.extension().is_some_and(|extension| extension == "rs");
            let name = path.file_stem().expect("a name").to_string_lossy();
            if name == "main" || !is_code && !path.join("mod.rs").exists() {
                continue;
            }
            let lines = [format!("mod {name};\n"), format!("[[test]]\nname = \"{name}\"\n")];
            let is_named = lines.iter().any(|line| named.contains(line));
            assert!(is_named, "{folder}/tests/main.rs does not name {name}");
            count += 1;
        }
    }
    assert!(count > 60, "{count} files of tests");
}

#[test]
fn the_core_has_no_side_effects() {
    let mut faults = Vec::new();
    let proof = sources("crates/groundbeam-proof/src");
    for source in sources("crates/groundbeam/src").into_iter().chain(proof) {
        for (number, line) in source.code().lines().enumerate() {
            let code = line.split("//").next().unwrap_or_default();
            // Releases do not contain `debug_assert!`.
            let code = code.replace("debug_assert!(", "");
            for never in NEVER_IN_THE_CORE.iter().filter(|never| code.contains(**never)) {
                faults.push(format!("{}:{}: {never}", source.path, number + 1));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn files_of_the_core_have_no_cyclic_imports() {
    let cycles = Imports::of_crate("crates/groundbeam").cycles();
    assert!(cycles.is_empty(), "{cycles:#?}");
}

#[test]
fn folders_of_the_core_import_only_lower_layers() {
    let layer = |module: &str| {
        let layer = LAYERS.iter().position(|modules| modules.contains(&module));
        layer.unwrap_or_else(|| panic!("{module} has no layer"))
    };
    let imports = Imports::of_crate("crates/groundbeam").between_modules();
    let upward = imports.iter().filter(|(from, to, _)| layer(from) >= layer(to));
    let faults: Vec<&str> = upward.map(|(.., text)| text.as_str()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn folders_have_no_unlisted_cyclic_imports() {
    for (name, (folder, _)) in crates() {
        let known = CYCLES.iter().find(|(known, _)| *known == name);
        let known = known.map_or(&[][..], |(_, modules)| *modules);
        let cycles = Imports::of_crate(&folder).cycles_of_modules();
        let modules: Vec<&String> = cycles.iter().flatten().collect();
        let more: Vec<_> =
            modules.iter().filter(|module| !known.contains(&module.as_str())).collect();
        assert!(more.is_empty(), "{name}: {more:?} joined a cycle");
        let gone: Vec<_> =
            known.iter().filter(|module| !modules.iter().any(|r| r == *module)).collect();
        assert!(gone.is_empty(), "{name}: {gone:?} left the cycle: remove them from the list");
    }
}

fn all_sources() -> Vec<Source> {
    crates().values().flat_map(|(folder, _)| sources(&format!("{folder}/src"))).collect()
}
