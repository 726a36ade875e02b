//! Files of the browser page, which are built into the program. The page needs no other file and no network.

use axum::body::Bytes;
use groundbeam_report::{fonts, svg};

/// A file of the page.
pub struct Asset {
    pub path: &'static str,
    pub kind: &'static str,
    pub bytes: Bytes,
}

const SCRIPT: &str = "text/javascript; charset=utf-8";

/// The files of the page.
pub fn assets() -> [Asset; 10] {
    let asset = |path, kind, bytes| Asset { path, kind, bytes: Bytes::from_static(bytes) };
    let style = "text/css; charset=utf-8";
    [
        asset("/", "text/html; charset=utf-8", include_bytes!("../../page/index.html")),
        asset("/page.css", style, include_bytes!("../../page/page.css")),
        Asset { path: "/dark.css", kind: style, bytes: svg::dark_style("#drawing").into() },
        asset("/page.js", SCRIPT, include_bytes!("../../page/page.js")),
        asset("/text.js", SCRIPT, include_bytes!("../../page/text.js")),
        asset("/picture.js", SCRIPT, include_bytes!("../../page/picture.js")),
        asset("/sliders.js", SCRIPT, include_bytes!("../../page/sliders.js")),
        asset("/share.js", SCRIPT, include_bytes!("../../page/share.js")),
        asset("/inter.ttf", "font/ttf", fonts::REGULAR),
        asset("/inter-semi-bold.ttf", "font/ttf", fonts::SEMI_BOLD),
    ]
}

/// Names and texts of the example models.
const EXAMPLES: [(&str, &str); 8] = [
    ("Strip footing", include_str!("../../../../docs/strip-footing.toml")),
    ("Crane base that tips", include_str!("../../../../docs/tipping.toml")),
    ("Footing beside a neighbour", include_str!("../../../../docs/neighbours.toml")),
    ("Frame under wind: combinations", include_str!("../../../../docs/combinations.toml")),
    ("Locomotive on a light rail", include_str!("../../page/locomotive.toml")),
    (
        "Pipeline over an uneven seabed",
        include_str!("../../../../cases/footings/pipeline-over-an-uneven-seabed.toml"),
    ),
    (
        "Grade beam between piles",
        include_str!("../../../../cases/footings/grade-beam-between-piles.toml"),
    ),
    ("Kikuchi 1980, case IV", include_str!("../../../../cases/kikuchi-1980/case-4.toml")),
];

/// Returns the names and texts of the example models, without the expected results that tests use.
pub fn examples() -> impl Iterator<Item = (&'static str, String)> {
    EXAMPLES.into_iter().map(|(name, text)| {
        let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("#:")).collect();
        (name, lines.join("\n").trim_end().to_owned() + "\n")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_are_valid_models() {
        for (name, text) in examples() {
            assert!(groundbeam_file::parse(&text).is_ok(), "{name}");
        }
    }
}
