//! Tests calculation reports as PDF, with and without the built-in typesetter.

use crate::common::{Folder, LIFTS};

#[test]
#[cfg(not(feature = "pdf"))]
fn without_the_pdf_feature_the_message_says_how_to_install_it() {
    let folder = Folder::with(LIFTS);
    let wanted = ["solve", "model.toml", "--report", "out.pdf"];
    folder.run(&wanted).fails(2, "cargo install --path crates/groundbeam-cli --features pdf");
    assert_eq!(folder.names(), ["model.toml"]);
}

#[test]
#[cfg(feature = "pdf")]
fn the_same_file_gives_the_same_bytes() {
    let folder = Folder::with(LIFTS);
    let bytes = |arguments: &[&str]| {
        let all = [&["solve", "model.toml", "--report", "out.pdf"], arguments].concat();
        folder.run(&all).is_clean(0);
        std::fs::read(folder.path("out.pdf")).unwrap()
    };
    let first = bytes(&[]);
    assert!(first.starts_with(b"%PDF-1.") && first.trim_ascii_end().ends_with(b"%%EOF"));
    assert!(first == bytes(&[]), "the bytes differ");
    assert!(first == bytes(&["--paper", "a4"]), "A4 is what is taken");
    assert!(first != bytes(&["--paper", "letter"]));
}

#[test]
#[cfg(feature = "pdf")]
fn a_model_without_equilibrium_has_a_report() {
    let folder = Folder::with(&crate::common::tips());
    let done = folder.run(&["solve", "model.toml", "--report", "out.pdf"]);
    assert_eq!(done.status, 3, "{}", done.stderr);
    assert!(std::fs::read(folder.path("out.pdf")).unwrap().starts_with(b"%PDF-1."));
}
