//! Measures how the time to read and check a model grows with the number of its parts, such as loads or supports.
//!
//! The check decides on existence and estimates the memory. `… --example many_parts -- 10000 100000` measures 10000 and
//! 100000 parts.

use groundbeam::{Options, exists, memory_estimate};
use groundbeam_file::{UnitSystem, parse, write_toml};
use groundbeam_verification::many::{KINDS, model};
use std::time::Instant;

fn main() {
    let number = |i: usize| std::env::args().nth(i).and_then(|n| n.parse::<usize>().ok());
    let counts = [number(1).unwrap_or(10_000), number(2).unwrap_or(100_000)];
    println!("{:<14}{:>12}{:>12}{:>8}", "many", counts[0], counts[1], "ratio");
    for kind in KINDS {
        let [few, many] = counts.map(|count| {
            let text = write_toml(&model(kind, count), None, UnitSystem::Si);
            let once = |_| {
                let began = Instant::now();
                let model = parse(&text).expect("a model").model;
                exists(&model).expect("a verdict");
                memory_estimate(&model, &Options::default());
                began.elapsed().as_secs_f64()
            };
            (0..3).map(once).fold(f64::INFINITY, f64::min)
        });
        println!("{:<14}{few:>10.3} s{many:>10.3} s{:>8.1}", format!("{kind:?}"), many / few);
    }
}
