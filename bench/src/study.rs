//! Compares the time of a study with the time of its solves. The difference is the cost of drawing and writing samples.

use crate::clock::side_by_side;
use crate::table::{Table, short};
use groundbeam::{Field, Model, Solver};
use groundbeam_file::study::read_study;
use groundbeam_study::{Draws, Finished, Shard};
use std::ops::ControlFlow;
use std::path::Path;

/// Returns the study in `bench/study` with `samples` samples. If `kept` is given, the study stores only the extremes of
/// the fields in `kept`.
fn draws(samples: u64, kept: Option<&[Field]>) -> Draws {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/study/footings.toml"));
    let mut study = read_study(path).expect("a valid study");
    if let Some(kept) = kept {
        study.keep.extremes = kept.to_vec();
    }
    let plan = study.plan.with(Some(samples), None);
    Draws::new(study, plan).expect("a study that can be drawn")
}

/// Solves models that are drawn beforehand, without storing the results.
fn bare(models: &[Model], threads: usize) {
    let part = models.len().div_ceil(threads);
    std::thread::scope(|scope| {
        for models in models.chunks(part) {
            scope.spawn(move || {
                let mut solver = Solver::new();
                for model in models {
                    std::hint::black_box(solver.solve(model).is_ok());
                }
            });
        }
    });
}

/// Compares the time to draw, solve, certify and write samples with the time of the solves alone.
pub fn table(samples: u64) -> String {
    let (all, least) = (draws(samples, None), draws(samples, Some(&[Field::Pressure])));
    let models: Vec<Model> = (0..samples).map(|sample| all.model(&all.draw(sample))).collect();
    let out = std::env::temp_dir().join(format!("groundbeam-bench-{}.parquet", std::process::id()));
    let mut table = Table::new(
        &format!(
            "{samples} random footings: drawn, solved, certified and written (`groundbeam study`)"
        ),
        &[
            "extremes kept",
            "threads",
            "study / bare solver",
            "study, footings a second",
            "bare, footings a second",
        ],
    );
    let cases = [
        ("of pressure", &least, 1),
        ("of pressure", &least, 2),
        ("of four fields", &all, 1),
        ("of four fields", &all, 2),
    ];
    for (kept, draws, threads) in cases {
        let [study, alone] = side_by_side(
            5,
            [
                &mut || {
                    let never = &mut |_| ControlFlow::Continue(());
                    let done =
                        groundbeam_study::run(draws, &out, Shard::WHOLE, true, threads, never);
                    assert_eq!(done.expect("a file that can be written"), Finished::Whole(samples));
                },
                &mut || bare(&models, threads),
            ],
        );
        table.row(&[
            kept.to_owned(),
            threads.to_string(),
            format!("**{:.2}**", study.least / alone.least),
            short(samples as f64 / study.least),
            short(samples as f64 / alone.least),
        ]);
    }
    let size = std::fs::metadata(&out).map_or(0, |file| file.len());
    // A failure to remove the result file does not affect the measured times.
    let _ = std::fs::remove_file(&out);
    table.finish(&format!("{} bytes a footing in the file of four fields.", size / samples))
}
