//! Tests SVG and PNG pictures.

use crate::common::{SOLVABLE, context, document, parts, solved};
use groundbeam_report::{Context, Units, svg};

fn drawn(name: &str) -> String {
    let document = document(name);
    svg::picture(&solved(&document), &context(&document)).to_string()
}

/// The words in a picture, one per line.
fn words(picture: &str) -> String {
    let texts = picture.split("<text ").skip(1);
    let words = texts.filter_map(|text| Some(text.split_once('>')?.1.split_once("</text>")?.0));
    words.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_complete_picture_is_the_recorded_one() {
    insta::assert_snapshot!("svg-kikuchi-4", drawn("kikuchi-4"));
}

#[test]
fn parts_of_pictures_are_the_recorded_ones() {
    for name in ["supports", "gap", "jointed", "compressed", "neighbours"] {
        insta::assert_snapshot!(format!("parts-{name}"), parts(&drawn(name)));
    }
}

#[test]
fn the_picture_of_a_tipping_beam_is_the_recorded_one() {
    let document = document("tips");
    let existence = groundbeam::exists(&document.model).unwrap();
    let view = svg::tipping(&document.model, &existence, &context(&document), 960.0);
    insta::assert_snapshot!("svg-tipping", view.svg);
}

/// Loads on the ground lie on its surface outside the beam and in it below the beam. The picture shows the
/// trench, and stiffer ground darker.
#[test]
fn loads_and_ground_outside_the_beam_are_drawn() {
    let of = |from: &str, to: &str| {
        let text = document("neighbours").text().replace(from, to);
        let document = groundbeam_file::parse(&text).unwrap();
        svg::picture(&solved(&document), &context(&document)).to_string()
    };
    let stiff = of("", "");
    assert!(stiff.contains(">300 kN<") && stiff.contains(">60 … 120 kN/m<"), "{stiff}");
    assert_eq!(stiff.matches("fill-opacity=\"0.28\"").count(), 1);
    let soft = of("k = \"160 MN/m^2\"", "k = \"16 MN/m^2\"");
    assert_eq!(soft.matches("fill-opacity=\"0.28\"").count(), 0);
    assert_eq!(soft.matches("fill=\"#ffffff\" fill-opacity=\"0.5\"").count(), 1);
    // Loads that are too far away to draw are labelled at the edge.
    let far = of("at = \"-1.2 m\"", "at = \"14.5 m\"");
    assert!(far.contains(">80 kN<"));
    let far = of("at = \"11 m\"", "at = \"40 m\"");
    assert!(far.contains(">300 kN at 40 m →<"), "{far}");
}

/// Handles of loads on the ground lie on the drawn surface, and can move as far as it is drawn.
#[test]
fn loads_on_the_ground_have_handles_on_the_surface() {
    let document = document("neighbours");
    let view = svg::view(&solved(&document), &context(&document), 960.0);
    let on_ground: Vec<_> = view
        .handles
        .iter()
        .filter(|handle| {
            matches!(handle.grip, svg::Grip::Load(1 | 3) | svg::Grip::From(2) | svg::Grip::To(2))
        })
        .collect();
    assert_eq!(on_ground.len(), 4);
    for handle in on_ground {
        assert!((handle.place[0] - (view.left + handle.at * view.scale)).abs() < 1e-9);
        // The limits are the trench on the left and the picture's edge on the right.
        assert!(handle.range[0] == -2.0 && handle.range[1] > 12.5 && handle.range[1] < 13.0);
    }
}

#[test]
fn text_in_pictures_is_the_recorded_one() {
    for name in SOLVABLE {
        insta::assert_snapshot!(format!("words-{name}"), words(&drawn(name)));
    }
}

#[test]
fn equal_results_give_pictures_of_equal_bytes() {
    for name in SOLVABLE {
        let picture = drawn(name);
        assert_eq!(picture, drawn(name));
        assert!(!picture.contains("NaN") && !picture.contains("inf"), "{name}");
    }
}

#[test]
fn pictures_are_rendered_to_png() {
    for name in ["kikuchi-4", "tiny"] {
        let document = document(name);
        let bytes = svg::picture(&solved(&document), &context(&document)).png().unwrap();
        assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
        let width = u32::from_be_bytes(bytes[16..20].try_into().unwrap());
        assert_eq!(width, 1920);
    }
}

#[test]
fn a_beam_without_loads_is_drawn() {
    let model = groundbeam::Model::new(
        groundbeam::Beam::uniform(1.0, 1.0),
        groundbeam::Foundation::winkler(1.0),
    );
    let groundbeam::Outcome::Equilibrium(solution) = groundbeam::solve(&model).unwrap() else {
        panic!()
    };
    let picture = svg::picture(&solution, &Context::new(Units::PLAIN)).to_string();
    assert_eq!(picture.matches("zero everywhere").count(), 3);
}
