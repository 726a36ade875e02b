//! Claims wrong answers for random models and compares every proven bound with the truth:
//! `… --example attacks -- 10000`. Behind the number of models may stand the number of the first.

use groundbeam_verification::attack::{KINDS, Target, random};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Wrong answers for each model.
const EACH: u64 = 8;

fn main() {
    let number = |i: usize| std::env::args().nth(i).and_then(|n| n.parse::<u64>().ok());
    let (count, first) = (number(1).unwrap_or(500), number(2).unwrap_or(0));
    let judged: Vec<_> = (first..first + count)
        .into_par_iter()
        .flat_map_iter(|i| {
            let (name, model) = random(i % KINDS, 1_000_000 + i);
            let target = Target::of(&model);
            (0..EACH).filter_map(move |j| {
                let target = target.as_ref()?;
                let attack = target.attack(EACH * i + j);
                Some((format!("{name}, attack {j}"), attack.change, target.judge(&attack)))
            })
        })
        .collect();
    // Documents, with bounds, proven, largest error over bound.
    let mut table: BTreeMap<&str, (usize, usize, usize, f64)> = BTreeMap::new();
    let mut faults = 0;
    for (name, change, verdict) in &judged {
        let row = table.entry(change).or_default();
        row.0 += 1;
        let Some(verdict) = verdict else { continue };
        row.1 += 1;
        row.2 += usize::from(verdict.proven);
        row.3 = row.3.max(verdict.ratio);
        if let Some(fault) = &verdict.fault {
            faults += 1;
            println!("{name}, {change}: {fault}");
        }
    }
    println!(
        "{:28} {:>9} {:>11} {:>7} {:>16}",
        "change", "documents", "with bounds", "proven", "error over bound"
    );
    for (change, (all, bounded, proven, ratio)) in table {
        println!("{change:28} {all:9} {bounded:11} {proven:7} {ratio:16.3}");
    }
    println!("{} documents, {faults} false statements", judged.len());
}
