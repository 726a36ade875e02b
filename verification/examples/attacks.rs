//! Compares the errors of wrong answers with the proven bounds of these errors.
//!
//! `… --example attacks -- 10000 FIRST` compares 10000 random models, from number FIRST on, with the answers of the
//! solver. `… --example attacks -- exact 10` compares ten wrong answers for each model of `reference/answers` with the
//! answers in 60 digits.

use groundbeam_verification::attack::{KINDS, Target, random};
use groundbeam_verification::exact_attack::judge;
use groundbeam_verification::reference::Answer;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Number of wrong answers for each random model.
const EACH: u64 = 8;

/// A wrong answer and its comparison with the true solution.
struct Case {
    name: String,
    kind: String,
    change: &'static str,
    /// Comparison with the true solution; `None` if nothing is proven about the wrong answer.
    found: Option<Found>,
}

struct Found {
    proven: bool,
    ratios: Vec<(&'static str, f64)>,
    fault: Option<String>,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| words.get(i).and_then(|n| n.parse::<u64>().ok());
    let cases = match words.first().map(String::as_str) {
        Some("exact") => exact(number(1).unwrap_or(8)),
        _ => of_random_models(number(0).unwrap_or(500), number(1).unwrap_or(0)),
    };
    let mut faults = 0;
    for case in &cases {
        let Some(found) = &case.found else { continue };
        let broken = found.ratios.iter().find(|(_, ratio)| *ratio > 1.0);
        let broken = broken.map(|(quantity, ratio)| format!("{quantity} {ratio:.3}"));
        if let Some(fault) = found.fault.clone().or(broken) {
            faults += 1;
            println!("{}, {}: {fault}", case.name, case.change);
        }
    }
    documents(&cases, "change", |case| case.change.to_owned());
    documents(&cases, "kind", |case| case.kind.clone());
    quantities(&cases);
    println!("{} documents, {faults} false statements", cases.len());
}

fn of_random_models(count: u64, first: u64) -> Vec<Case> {
    let of_model = |i: u64| {
        let (name, model) = random(i % KINDS, 1_000_000 + i);
        let target = Target::of(&model);
        (0..EACH).filter_map(move |j| {
            let target = target.as_ref()?;
            let attack = target.attack(EACH * i + j);
            let found = target.judge(&attack).map(|verdict| Found {
                proven: verdict.proven,
                ratios: verdict.ratios,
                fault: verdict.fault,
            });
            let kind = name.split(' ').next().unwrap_or_default().to_owned();
            Some(Case { name: format!("{name}, attack {j}"), kind, change: attack.change, found })
        })
    };
    (first..first + count).into_par_iter().flat_map_iter(of_model).collect()
}

fn exact(each: u64) -> Vec<Case> {
    let of_model = |(i, answer): (usize, Answer)| {
        let target = Target::of(&answer.parsed());
        (0..each).filter_map(move |j| {
            let target = target.as_ref()?;
            let attack = target.attack(each * i as u64 + j);
            let found = judge(target, &attack, &answer).map(|judged| Found {
                proven: judged.proven,
                ratios: judged.ratios,
                fault: judged.fault,
            });
            let (name, kind) = (format!("{}, attack {j}", answer.name), answer.family.clone());
            Some(Case { name, kind, change: attack.change, found })
        })
    };
    Answer::all().into_par_iter().enumerate().flat_map_iter(of_model).collect()
}

/// Prints one row for each name: the numbers of wrong answers, of those with error bounds and of proven ones, and the
/// largest ratio of error to bound.
fn documents(cases: &[Case], title: &str, name: impl Fn(&Case) -> String) {
    let mut table: BTreeMap<String, (usize, usize, usize, f64)> = BTreeMap::new();
    for case in cases {
        let row = table.entry(name(case)).or_default();
        row.0 += 1;
        let Some(found) = &case.found else { continue };
        row.1 += 1;
        row.2 += usize::from(found.proven);
        row.3 = found.ratios.iter().fold(row.3, |most, (_, ratio)| most.max(*ratio));
    }
    println!("{title:28} documents with bounds  proven error over bound");
    for (name, (all, bounded, proven, ratio)) in table {
        println!("{name:28} {all:9} {bounded:11} {proven:7} {ratio:16.3}");
    }
}

/// Prints the largest ratio of error to bound for each quantity, and the number of comparisons.
fn quantities(cases: &[Case]) {
    let mut table: BTreeMap<&str, (usize, f64)> = BTreeMap::new();
    for (quantity, ratio) in cases.iter().flat_map(|case| &case.found).flat_map(|f| &f.ratios) {
        let row = table.entry(quantity).or_default();
        *row = (row.0 + 1, row.1.max(*ratio));
    }
    println!("{:28} {:>9} {:>16}", "quantity", "compared", "error over bound");
    for (quantity, (count, ratio)) in table {
        println!("{quantity:28} {count:9} {ratio:16.3}");
    }
}
