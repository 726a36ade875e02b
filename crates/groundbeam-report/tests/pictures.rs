//! SVG and PNG.

#[allow(dead_code)]
mod common;

use common::{SOLVABLE, context, document, solved};
use groundbeam_report::{Context, Units, png, svg};

fn drawn(name: &str) -> String {
    let document = document(name);
    svg::picture(&solved(&document), &context(&document))
}

/// The words in a picture, one a line.
fn words(picture: &str) -> String {
    let texts = picture.split("<text ").skip(1);
    let words = texts.filter_map(|text| Some(text.split_once('>')?.1.split_once("</text>")?.0));
    words.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_whole_picture() {
    insta::assert_snapshot!("svg-kikuchi-4", drawn("kikuchi-4"));
}

#[test]
fn words_in_pictures() {
    for name in SOLVABLE {
        insta::assert_snapshot!(format!("words-{name}"), words(&drawn(name)));
    }
}

#[test]
fn equal_results_give_equal_bytes() {
    for name in SOLVABLE {
        let picture = drawn(name);
        assert_eq!(picture, drawn(name));
        assert!(!picture.contains("NaN") && !picture.contains("inf"), "{name}");
    }
}

#[test]
fn every_picture_can_be_drawn() {
    for name in ["kikuchi-4", "tiny"] {
        let document = document(name);
        let bytes = png::picture(&solved(&document), &context(&document)).unwrap();
        assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
        let width = u32::from_be_bytes(bytes[16..20].try_into().unwrap());
        assert_eq!(width, 1920);
    }
}

#[test]
fn a_beam_on_which_nothing_acts() {
    let model = groundbeam::Model::new(
        groundbeam::Beam::uniform(1.0, 1.0),
        groundbeam::Foundation::winkler(1.0),
    );
    let groundbeam::Outcome::Equilibrium(solution) = groundbeam::solve(&model).unwrap() else {
        panic!()
    };
    let picture = svg::picture(&solution, &Context::new(Units::Plain));
    assert_eq!(picture.matches("zero everywhere").count(), 3);
}
