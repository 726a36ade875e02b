//! The page itself, part of the program: it needs no other file and no network.

use groundbeam_report::fonts;

/// A file of the page.
pub struct Asset {
    pub path: &'static str,
    pub kind: &'static str,
    pub bytes: &'static [u8],
}

const SCRIPT: &str = "text/javascript; charset=utf-8";

/// The files of the page.
pub const ASSETS: [Asset; 9] = [
    Asset {
        path: "/",
        kind: "text/html; charset=utf-8",
        bytes: include_bytes!("../../page/index.html"),
    },
    Asset {
        path: "/page.css",
        kind: "text/css; charset=utf-8",
        bytes: include_bytes!("../../page/page.css"),
    },
    Asset { path: "/page.js", kind: SCRIPT, bytes: include_bytes!("../../page/page.js") },
    Asset { path: "/text.js", kind: SCRIPT, bytes: include_bytes!("../../page/text.js") },
    Asset { path: "/picture.js", kind: SCRIPT, bytes: include_bytes!("../../page/picture.js") },
    Asset { path: "/sliders.js", kind: SCRIPT, bytes: include_bytes!("../../page/sliders.js") },
    Asset { path: "/share.js", kind: SCRIPT, bytes: include_bytes!("../../page/share.js") },
    Asset { path: "/inter.ttf", kind: "font/ttf", bytes: fonts::REGULAR },
    Asset { path: "/inter-semi-bold.ttf", kind: "font/ttf", bytes: fonts::SEMI_BOLD },
];

/// Models to begin with: a name, and the text of a file that a document or a case shows.
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

/// The examples without what a case expects, which is for tests.
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
    fn examples_are_right() {
        for (name, text) in examples() {
            assert!(groundbeam_file::parse(&text).is_ok(), "{name}");
        }
    }
}
