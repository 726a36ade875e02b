//! Prints how much the results of random models differ if n or 2n chords (straight segments) replace the settlement troughs.
//!
//! `… --example random_troughs -- 1000 FIRST` tests 1000 models from number FIRST on. `… -- show NUMBER` prints the
//! file of one model.

use groundbeam_verification::troughs::{Result, drawn, result};

fn main() {
    let arguments: Vec<u64> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    if std::env::args().nth(1).is_some_and(|word| word == "show") {
        let number = arguments.first().copied().unwrap_or(0);
        return print!("{}", drawn(number).text);
    }
    let count = arguments.first().copied().unwrap_or(100);
    let first = arguments.get(1).copied().unwrap_or(0);
    let mut counts = [0; 5];
    let mut worst = [0.0_f64; 4];
    let (mut most, mut all, mut slowest) = (0, 0, 0.0_f64);
    for number in first..first + count {
        match result(number) {
            Result::Refused(_) => counts[0] += 1,
            Result::NoEquilibrium => counts[1] += 1,
            Result::Failed(error) => {
                counts[2] += 1;
                println!("{number}: {error}");
            }
            Result::Solved { chords, zones, changed, seconds } => {
                counts[3] += 1;
                (most, all) = (most.max(chords), all + chords);
                slowest = slowest.max(seconds);
                let [w, m, p] = changed.fields;
                let figures = [w, m, p, changed.edges];
                for (worst, figure) in worst.iter_mut().zip(figures) {
                    *worst = worst.max(figure);
                }
                if figures.iter().any(|figure| *figure >= 1e-3) {
                    counts[4] += 1;
                    println!(
                        "{number}: w {w:.1e}, M {m:.1e}, p {p:.1e}, edges {:.1e}; {chords} chords, {zones:?} zones, {seconds:.2} s",
                        changed.edges
                    );
                }
            }
        }
    }
    let [refused, none, failed, solved, beyond] = counts;
    println!(
        "{solved} solved, {beyond} changed by a thousandth or more, {refused} refused, {none} without equilibrium, {failed} failed; \
         largest changes w {:.1e}, M {:.1e}, p {:.1e}, edges {:.1e}; {} chords on average, at most {most}, at most {slowest:.2} s",
        worst[0],
        worst[1],
        worst[2],
        worst[3],
        all / solved.max(1)
    );
}
