//! Wrong answers for random models: every proven bound holds, and every proven contact set is right. `--example
//! attacks` tests more of them.

use groundbeam_verification::attack::{KINDS, Target, random};
use rayon::prelude::*;

#[test]
fn bounds_of_wrong_answers_hold() {
    let judged: Vec<_> = (0..180_u64)
        .into_par_iter()
        .flat_map_iter(|i| {
            let (name, model) = random(i % KINDS, i);
            let target = Target::of(&model);
            (0..8).filter_map(move |j| {
                let target = target.as_ref()?;
                let attack = target.attack(8 * i + j);
                let verdict = target.judge(&attack)?;
                Some((format!("{name}, {}", attack.change), verdict))
            })
        })
        .collect();
    for (name, verdict) in &judged {
        assert!(verdict.fault.is_none(), "{name}: {:?}", verdict.fault);
    }
    let most = judged.iter().map(|(_, verdict)| verdict.ratio).fold(0.0, f64::max);
    let proven = judged.iter().filter(|(_, verdict)| verdict.proven).count();
    println!("{} documents, {proven} proven, error over bound {most:.3}", judged.len());
    // If no error came near its bound, the test would measure nothing.
    assert!(judged.len() > 700 && most > 0.5, "{} {most}", judged.len());
}
