//! Checks every package that the workspace may need, with all features and on all systems: its licence, its origin, and
//! that none links a C library.
//!
//! Needs the descriptions of all packages, which cargo takes from its registry. Without them this test reports that it
//! was skipped, or fails if `GROUNDBEAM_DEMAND` names `registry`.

use groundbeam_testing::{repository, tools_or_skip};
use serde_json::Value;
use std::process::Command;

const LICENCES: [&str; 10] = [
    "MIT",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "Unicode-3.0",
    "Zlib",
    // No conditions at all.
    "0BSD",
    "CC0-1.0",
    // The fonts in groundbeam-report.
    "OFL-1.1",
];

/// Packages that link a C library.
const NEVER: [&str; 3] = ["openssl-sys", "blas-src", "lapack-src"];

const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// The packages of the lock file, as cargo describes them.
fn packages() -> Result<Vec<Value>, String> {
    let arguments = ["metadata", "--locked", "--all-features", "--format-version", "1"];
    let run = Command::new(env!("CARGO")).args(arguments).current_dir(repository()).output();
    let run = run.map_err(|error| error.to_string())?;
    if !run.status.success() {
        return Err(String::from_utf8_lossy(&run.stderr).trim().to_owned());
    }
    let mut metadata: Value = serde_json::from_slice(&run.stdout).expect("metadata");
    Ok(metadata["packages"].as_array_mut().map(std::mem::take).expect("packages"))
}

/// Whether a licence expression holds with the allowed licences: names, `WITH`, `AND`, `OR`, parentheses.
fn is_allowed(expression: &str) -> bool {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    either(&words, &mut at) && at == words.len()
}

fn either(words: &[&str], at: &mut usize) -> bool {
    let mut holds = both(words, at);
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        holds |= both(words, at);
    }
    holds
}

fn both(words: &[&str], at: &mut usize) -> bool {
    let mut holds = one(words, at);
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        holds &= one(words, at);
    }
    holds
}

fn one(words: &[&str], at: &mut usize) -> bool {
    let Some(word) = words.get(*at) else { return false };
    *at += 1;
    if *word == "(" {
        let holds = either(words, at);
        let closes = words.get(*at) == Some(&")");
        *at += 1;
        return holds && closes;
    }
    match words.get(*at..*at + 2) {
        Some(["WITH", exception]) => {
            *at += 2;
            LICENCES.contains(&format!("{word} WITH {exception}").as_str())
        }
        _ => LICENCES.contains(word),
    }
}

#[test]
fn packages_may_be_used_and_link_no_c_library() {
    let Some(packages) = tools_or_skip(packages(), "registry", "the licences of all packages")
    else {
        return;
    };
    let mut faults = Vec::new();
    for package in &packages {
        let text = |key: &str| package[key].as_str().unwrap_or_default();
        let name = format!("{} {}", text("name"), text("version"));
        if !is_allowed(text("license")) {
            faults.push(format!("{name} has the licence `{}`", text("license")));
        }
        if !["", REGISTRY].contains(&text("source")) {
            faults.push(format!("{name} comes from {}", text("source")));
        }
        if NEVER.contains(&text("name")) {
            faults.push(format!("{name} links a C library"));
        }
        // The versions that a package of the workspace needs are named.
        let needs = package["dependencies"].as_array().filter(|_| text("source").is_empty());
        for need in needs.into_iter().flatten() {
            if need["req"] == "*" && need["path"].is_null() {
                faults.push(format!("{name} needs any version of {}", need["name"]));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(packages.len() > 400, "{} packages", packages.len());
}

#[test]
fn licence_expressions_are_read() {
    for right in ["MIT", "MIT/GPL-3.0", "(MIT OR GPL-3.0) AND OFL-1.1", "GPL-3.0 OR MIT AND Zlib"] {
        assert!(is_allowed(right), "{right}");
    }
    for wrong in ["", "GPL-3.0", "MIT AND GPL-3.0", "(MIT", "MIT)", "MIT Zlib", "Zlib WITH it"] {
        assert!(!is_allowed(wrong), "{wrong}");
    }
}
