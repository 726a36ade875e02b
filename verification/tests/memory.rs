//! Compares the estimated memory of a solve with the measured memory; each solve runs in a separate process.
//!
//! Claims: `docs/methods.md`.
#![cfg(target_os = "linux")]

use groundbeam::{
    Beam, Foundation, Load, Method, Model, Options, Support, memory_estimate, model::Profile,
    solve_with,
};
use std::process::Command;

/// The environment variable that tells a process which case to solve.
const CASE: &str = "GROUNDBEAM_MEMORY_CASE";

/// Loads so close that no stretch is quiet.
fn long(length: f64, shear: f64) -> Model {
    let mut model = Model::new(Beam::uniform(length, 1.0), Foundation::pasternak(4.0, shear))
        .with_load(Load::uniform_force(0.0, length, 1.0))
        .with_load(Load::point_force(0.3 * length, 0.01 * length))
        .with_load(Load::point_force(0.6 * length, -2.0));
    for i in 1..(0.02 * length) as u32 {
        model = model.with_load(Load::point_force(50.0 * f64::from(i) + 1.0, 0.01));
    }
    model
}

fn cases() -> Vec<(&'static str, Model, Options)> {
    let mut many = Model::new(Beam::uniform(10.0, 1e3), Foundation::pasternak(4.0, 1.0))
        .with_support(Support::pinned(5.0));
    for i in 0..10_000 {
        many.loads.push(Load::point_force(1e-3 * (f64::from(i) + 0.5), 1.0));
    }
    let mut shears = long(8e3, 1.0);
    shears.beam.shear_stiffness = Some(10.0);
    let mut varies = long(8e3, 1.0);
    varies.beam = varies.beam.with_varying_segment(0.0, 8e3, Profile::linear(1.0, 2.0));
    let loaded = Load::distributed_ground_force(0.0, 4e3, 1.0, 2.0);
    let exact = || Options { memory_limit: u64::MAX, ..Options::default() };
    let mesh = |method| Options { method, elements: 40_000, most_sweeps: 2, ..exact() };
    vec![
        ("long", long(1e4, 1.0), exact()),
        ("springs alone", long(5e3, 0.0), exact()),
        ("many loads", many, exact()),
        ("shears", shears, exact()),
        ("varies", varies, exact()),
        ("loaded ground", long(4e3, 1.0).with_load(loaded), exact()),
        ("active-set", long(100.0, 1.0), mesh(Method::ActiveSet)),
        ("psor", long(100.0, 1.0), mesh(Method::Psor)),
        ("uzawa", long(100.0, 1.0), mesh(Method::Uzawa)),
    ]
}

/// A value that the system reports about this process \[bytes\].
fn memory(name: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("a status");
    let line = status.lines().find(|line| line.starts_with(name)).expect("a line");
    let kilobytes: f64 =
        line.split_whitespace().nth(1).and_then(|n| n.parse().ok()).expect("a number");
    1024.0 * kilobytes
}

/// Solves one case if another process requests it, and prints its memory.
#[test]
fn solve_one() {
    let Ok(name) = std::env::var(CASE) else { return };
    let cases = cases();
    let (_, model, options) = cases.iter().find(|(own, ..)| *own == name).expect("a case");
    let before = memory("VmRSS:");
    let outcome = solve_with(model, options);
    println!("peak {} {}", memory("VmHWM:") - before, outcome.is_ok());
}

#[test]
fn the_memory_estimate_is_slightly_above_the_memory_used() {
    for (name, model, options) in cases() {
        let this = std::env::current_exe().expect("a path");
        let arguments = ["--exact", "memory::solve_one", "--nocapture"];
        let done = Command::new(this).args(arguments).env(CASE, name).output().expect("it runs");
        let printed = String::from_utf8_lossy(&done.stdout);
        let peak = printed.split_once("peak ").and_then(|(_, rest)| rest.split_whitespace().next());
        let peak: f64 =
            peak.and_then(|peak| peak.parse().ok()).unwrap_or_else(|| panic!("{printed}"));
        let estimate = memory_estimate(&model, &options) as f64;
        println!("{name}: {:.1} of {:.1} MB", 1e-6 * peak, 1e-6 * estimate);
        assert!(peak <= estimate, "{name}: {peak} bytes, {estimate} estimated");
        assert!(estimate <= 8.0 * peak, "{name}: {peak} bytes, {estimate} estimated");
    }
}
