//! Scratch.
use groundbeam::{Outcome, solve};
use groundbeam_verification::random::{Family, model};
use std::time::Instant;
fn main() {
    let a: Vec<String> = std::env::args().skip(1).collect();
    let first: u64 = a[0].parse().unwrap();
    let count: u64 = a[1].parse().unwrap();
    let all = [
        Family::ALL.as_slice(),
        &[Family::Shearing, Family::Compressed, Family::CompressedToo, Family::Extreme],
    ]
    .concat();
    let mut seen = std::collections::BTreeSet::new();
    for family in all {
        let name = format!("{family:?}");
        if !seen.insert(name.clone()) {
            continue;
        }
        if a.len() > 2 && !a[2..].contains(&name) {
            continue;
        }
        let count = match name.as_str() {
            "Extreme" => count.min(120),
            "CompressedToo" => count.min(43),
            "Compressed" => count.min(100),
            _ => count,
        };
        let (mut failed, mut total, mut worst, mut its) = (0, 0.0, (0.0, 0), 0);
        for n in first..first + count {
            let m = model(family, n);
            let start = Instant::now();
            let out = solve(&m);
            let t = start.elapsed().as_secs_f64();
            total += t;
            if t > worst.0 {
                worst = (t, n);
            }
            match out {
                Ok(Outcome::Equilibrium(s)) => {
                    its += s.iterations();
                    let c: Vec<String> = s
                        .contact()
                        .iter()
                        .map(|r| format!("{:.14e} {:.14e}", r.from, r.to))
                        .collect();
                    println!(
                        "{name} {n} {:.1e} {:.2e} | {} | {}",
                        t,
                        s.certificate().relative_gap(),
                        s.model().beam.length,
                        c.join(" , ")
                    );
                }
                Ok(_) => println!("{name} {n} {t:.1e} none"),
                Err(e) => {
                    failed += 1;
                    println!(
                        "{name} {n} {t:.1e} failed {}",
                        e.to_string().lines().next().unwrap_or("")
                    );
                }
            }
        }
        eprintln!(
            "{name:14} {count} failed {failed} total {:.2} s worst {:.3} s ({}) iterations {its}",
            total, worst.0, worst.1
        );
    }
}
