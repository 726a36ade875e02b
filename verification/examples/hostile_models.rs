//! Applies every function of the library to hostile models and model files, and lists those that cause a panic.
//!
//! `… --example hostile_models -- 10000 FIRST` tests 10000 models and 10000 files from number FIRST on.

use groundbeam_verification::hostile::{exercise, exercise_text, model, mutated, panics, texts};
use std::time::{Duration, Instant};

fn main() {
    let number = |i: usize| std::env::args().nth(i).and_then(|n| n.parse::<u64>().ok());
    let count = number(1).unwrap_or(1000);
    let first = number(2).unwrap_or(0);
    let texts = texts();
    let mut failed = 0;
    let mut slowest = (Duration::ZERO, String::new());
    let mut run = |name: String, exercise: &dyn Fn()| {
        let start = Instant::now();
        if let Some(panic) = panics(exercise) {
            failed += 1;
            println!("{name}: {panic}");
        }
        let time = start.elapsed();
        if time > Duration::from_secs(5) {
            println!("{name}: {:.1} s", time.as_secs_f64());
        }
        slowest = std::mem::take(&mut slowest).max((time, name));
    };
    for number in first..first + count {
        run(format!("model {number}"), &|| exercise(&model(number)));
        let text = &texts[number as usize % texts.len()];
        run(format!("text {number}"), &|| exercise_text(&mutated(text, number)));
    }
    println!(
        "{failed} of {} models and files caused a panic; the slowest was {} with {:.1} s",
        2 * count,
        slowest.1,
        slowest.0.as_secs_f64()
    );
}
