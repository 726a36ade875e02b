//! Models with many parts: the time to read, check and cut them into cells is proportional to their number.

use groundbeam::{Options, exists, memory_estimate};
use groundbeam_file::{UnitSystem, parse, write_toml};
use groundbeam_report::Characteristics;
use groundbeam_verification::many::{KINDS, model};
use std::time::Instant;

/// The smallest time of a few runs.
fn seconds(runs: usize, mut job: impl FnMut()) -> f64 {
    let once = |_| {
        let began = Instant::now();
        job();
        began.elapsed().as_secs_f64()
    };
    (0..runs).map(once).fold(f64::INFINITY, f64::min)
}

/// Ten times as many parts take 10 times as long if the time is proportional, 100 times if all pairs are compared.
#[test]
fn the_time_to_read_is_proportional_to_the_size() {
    for kind in KINDS {
        let [few, many] = [(3_000, 5), (30_000, 2)].map(|(count, runs)| {
            let text = write_toml(&model(kind, count), None, UnitSystem::Si);
            seconds(runs, || drop(parse(&text).expect("a model")))
        });
        assert!(many < 40.0 * few, "{kind:?}: {few} s and {many} s");
    }
}

/// Sixteen times as many parts take 16 times as long if the time is proportional, up to three times that beyond the
/// processor's caches, and 256 times if all pairs are compared.
#[test]
fn the_time_of_checks_and_cells_is_proportional_to_the_size() {
    for kind in KINDS {
        let [few, many] = [20_000, 320_000].map(|count| {
            let model = model(kind, count);
            seconds(3, || {
                let existence = exists(&model).expect("a valid model");
                assert!(existence.verdict.stands());
                assert!(Characteristics::of(&model, &existence).beta_length > 0.0);
                assert!(memory_estimate(&model, &Options::default()) > 0);
            })
        });
        assert!(many < 100.0 * few, "{kind:?}: {few} s and {many} s");
    }
}
