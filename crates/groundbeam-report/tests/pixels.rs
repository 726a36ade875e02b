//! Compares every kind of picture with stored pixels at a small scale, and three pictures by their parts or text.
//! `UPDATE_EXPECTED=1` stores new pixels.

use crate::common::{SOLVABLE, answers, context, document, parts, solved};
use groundbeam_file::Document;
use groundbeam_report::{
    Context, Estimate, Interval, Kind, Limit, Spread, Study, Units, Way, calculation, html, svg,
};
use groundbeam_run::{Answers, OneThread, Run};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::path::PathBuf;

/// Pixels per unit of a picture.
const SCALE: f32 = 0.25;
/// Allowed mean difference of all channels, of 255, for rounding differences.
const MEAN: f64 = 0.5;
/// A pixel that differs by more than this in a channel counts as different.
const OTHER: u8 = 64;
/// Allowed share of different pixels.
const FEW: f64 = 0.002;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn drawn(picture: &str) -> Pixmap {
    let mut options = Options { font_family: "Inter".to_owned(), ..Options::default() };
    for font in ["Inter-Regular.ttf", "Inter-SemiBold.ttf"] {
        let bytes = std::fs::read(folder().join("fonts").join(font)).unwrap();
        options.fontdb_mut().load_font_data(bytes);
    }
    let tree = Tree::from_str(picture, &options).unwrap();
    let [width, height] =
        [tree.size().width(), tree.size().height()].map(|side| (side * SCALE).ceil() as u32);
    let mut pixels = Pixmap::new(width, height).unwrap();
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels
}

fn differs(a: &Pixmap, b: &Pixmap) -> Option<String> {
    if (a.width(), a.height()) != (b.width(), b.height()) {
        return Some(format!("{} × {} pixels", a.width(), a.height()));
    }
    let apart = |(a, b): (&u8, &u8)| a.abs_diff(*b);
    let all: Vec<u8> = a.data().iter().zip(b.data()).map(apart).collect();
    let mean = all.iter().map(|d| f64::from(*d)).sum::<f64>() / all.len() as f64;
    let other = all.chunks(4).filter(|pixel| pixel.iter().any(|d| *d > OTHER)).count();
    let share = other as f64 / (all.len() / 4) as f64;
    (mean > MEAN || share > FEW).then(|| format!("mean {mean:.2}, {:.2} % other", 100.0 * share))
}

/// Compares a picture with the stored one.
fn looks_as_kept(name: &str, picture: &str) {
    let pixels = drawn(picture);
    let path = folder().join("tests/pictures").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_EXPECTED").is_some() {
        let kept = std::fs::read(&path).ok().and_then(|bytes| Pixmap::decode_png(&bytes).ok());
        if kept.is_none_or(|kept| differs(&pixels, &kept).is_some()) {
            std::fs::write(&path, pixels.encode_png().unwrap()).unwrap();
        }
    }
    let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    if let Some(how) = differs(&pixels, &Pixmap::decode_png(&bytes).unwrap()) {
        let new = std::env::temp_dir().join(format!("groundbeam-{name}.png"));
        std::fs::write(&new, pixels.encode_png().unwrap()).unwrap();
        panic!("{name} looks otherwise ({how}): {} is new", new.display());
    }
}

/// The figures of a calculation report.
fn figures(page: &str) -> Vec<String> {
    let parts = page.split("<svg ").skip(1);
    parts.map(|part| format!("<svg {}</svg>", part.split_once("</svg>").unwrap().0)).collect()
}

fn source(document: &Document) -> calculation::Source<'_> {
    let Document { model, cases, files, .. } = document;
    calculation::Source { name: "model.toml", text: document.text(), model, cases, files }
}

fn report(answers: &Answers, document: &Document) -> String {
    let report = calculation::report(answers, &context(document), &source(document));
    html::report(&report, None).unwrap()
}

#[test]
fn pictures_of_single_models_have_the_recorded_pixels() {
    for name in SOLVABLE {
        let document = document(name);
        looks_as_kept(name, &svg::picture(&solved(&document), &context(&document)).to_string());
    }
}

#[test]
fn figures_of_reports_have_the_recorded_pixels() {
    let document_of = document;
    let (document, tips) = (document_of("footing"), document_of("tips"));
    let page = report(&answers(&document), &document);
    let found = figures(&page);
    assert_eq!(found.len(), 7);
    for (i, figure) in found.iter().enumerate() {
        looks_as_kept(&format!("report-footing-{}", i + 1), figure);
    }
    let page = report(&answers(&tips), &tips);
    let [figure] = &figures(&page)[..] else { panic!("one figure") };
    looks_as_kept("report-tips", figure);
}

#[test]
fn pictures_of_combinations_have_the_recorded_pixels() {
    let document = document("combinations");
    let mut answers = answers(&document);
    answers.list.retain(|answer| answer.solution().is_some());
    let picture = svg::combinations(&answers, &context(&document)).to_string();
    looks_as_kept("combinations", &picture);
    insta::assert_snapshot!("parts-combinations", parts(&picture));
}

#[test]
fn pictures_of_trains_have_the_recorded_pixels() {
    let document = document("train");
    let answers = Run::of(&document).with_error(1e-2).solve(&OneThread).unwrap();
    let picture = svg::trains(&answers.passages(), &context(&document)).to_string();
    looks_as_kept("train", &picture);
    insta::assert_snapshot!("parts-train", parts(&picture));
    let page = report(&answers, &document);
    let found = figures(&page);
    // The model, the train at the position of the largest moment, and four envelopes.
    assert_eq!(found.len(), 6);
    looks_as_kept("report-train-moment", &found[4]);
}

/// A study of 2000 samples with invented numbers: events from certain to impossible, and histograms of many
/// shapes.
fn study() -> Study {
    let event =
        |name: &str, limit: Option<(&str, bool, f64)>, count: u64, bounds: [f64; 2]| Estimate {
            name: name.to_owned(),
            limit: limit.map(|(of, above, limit)| Limit { quantity: of.to_owned(), above, limit }),
            count,
            probability: count as f64 / 2000.0,
            interval: Interval { bounds, by: Way::Counts },
        };
    let spread = |name: &str, kind, quantiles: [f64; 5], histogram: &[u64]| Spread {
        name: name.to_owned(),
        kind,
        mean: quantiles[2],
        deviation: 0.3 * (quantiles[3] - quantiles[1]),
        quantiles,
        histogram: histogram.to_vec(),
    };
    Study {
        title: Some("A strip on <random> ground".to_owned()),
        samples: 2000,
        seed: 7,
        sampling: "sobol",
        replicates: 8,
        dimensions: 12,
        variance: Some(0.99),
        solved: 2000,
        without_equilibrium: 0,
        not_converged: 0,
        wrong: 0,
        largest_gap: 1e-13,
        events: vec![
            event("no equilibrium", None, 0, [0.0, 0.00184]),
            event("some of the beam lifts off", None, 2000, [0.998, 1.0]),
            event(
                "bearing pressure above 350 kPa",
                Some(("pressure_max", true, 350e3)),
                61,
                [0.0231, 0.039],
            ),
            event(
                "a name so long that it does not fit on the line that it stands on",
                Some(("left", false, 0.0)),
                3,
                [3e-4, 4.4e-3],
            ),
        ],
        spreads: vec![
            spread(
                "load[0]",
                Some(Kind::Force),
                [4e5, 4.6e5, 6e5, 7.7e5, 1.1e6],
                &[10, 300, 800, 500, 250, 100, 30, 10],
            ),
            spread("k_factor", None, [1.0, 1.0, 1.0, 1.0, 1.0], &[2000]),
            spread(
                "lifted_share",
                None,
                [0.0, 0.0, 0.0, 0.2, 0.31],
                &[1500, 0, 80, 120, 160, 90, 50],
            ),
            spread(
                "left",
                Some(Kind::Force),
                [-100.0, 5e3, 2e4, 3e4, 4e4],
                &[20, 300, 700, 700, 280],
            ),
            spread(
                "pressure_max",
                Some(Kind::Pressure),
                [2e5, 2.3e5, 2.8e5, 3.4e5, 4e5],
                &[150, 700, 800, 250, 90, 10],
            ),
        ],
    }
}

#[test]
fn pictures_of_studies_have_the_recorded_pixels() {
    let picture = svg::study(&study(), &Context::new(Units::SI)).to_string();
    looks_as_kept("study", &picture);
    insta::assert_snapshot!("svg-study", picture);
}
