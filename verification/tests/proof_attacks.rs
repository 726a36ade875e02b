//! Wrong answers for random models: every bound that is proven of them holds, and no false contact set is shown.
//! `--example attacks` claims more of them.

use groundbeam_verification::attack::Target;
use groundbeam_verification::random::{Family, model};
use rayon::prelude::*;

#[test]
fn bounds_of_wrong_answers_hold() {
    let judged: Vec<_> = (0..160_u64)
        .into_par_iter()
        .flat_map_iter(|i| {
            let family = Family::ALL[i as usize % Family::ALL.len()];
            let target = Target::of(&model(family, i));
            (0..8).filter_map(move |j| {
                let target = target.as_ref()?;
                let attack = target.attack(8 * i + j);
                let verdict = target.judge(&attack)?;
                Some((format!("{family:?} {i}, {}", attack.change), verdict))
            })
        })
        .collect();
    for (name, verdict) in &judged {
        assert!(verdict.fault.is_none(), "{name}: {:?}", verdict.fault);
    }
    let most = judged.iter().map(|(_, verdict)| verdict.ratio).fold(0.0, f64::max);
    let proven = judged.iter().filter(|(_, verdict)| verdict.proven).count();
    println!("{} documents, {proven} proven, error over bound {most:.3}", judged.len());
    // Bounds that nothing comes near would be a sign of a test that measures nothing.
    assert!(judged.len() > 700 && most > 0.5, "{} {most}", judged.len());
}
