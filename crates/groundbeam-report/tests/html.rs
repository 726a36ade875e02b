//! Tests the calculation report.

use crate::common::{SOLVABLE, answers, context, document};
use groundbeam::{Method, NotConverged, Stopped};
use groundbeam_file::Document;
use groundbeam_report::calculation::{Paper, Source};
use groundbeam_report::{Context, Units, calculation, html};
use groundbeam_run::{Answers, Found};

fn source(document: &Document) -> Source<'_> {
    let Document { model, cases, files, .. } = document;
    Source { name: "model.toml", text: document.text(), model, cases, files }
}

fn report(answers: &Answers, context: &Context, source: &Source) -> String {
    html::report(&calculation::report(answers, context, source), None).unwrap()
}

fn made(name: &str) -> String {
    let document = document(name);
    let context = context(&document).with_limits(&document.limits);
    report(&answers(&document), &context, &source(&document))
}

/// The text of a page without its style and figures, one block per line.
fn words(page: &str) -> String {
    let mut text = String::new();
    let mut rest = page.split_once("<body>").unwrap().1;
    while let Some(at) = rest.find('<') {
        text += &rest[..at];
        let skip = ["svg", "math"].into_iter().find(|name| rest[at + 1..].starts_with(name));
        let end = match skip {
            Some(name) => rest.find(&format!("</{name}>")).unwrap() + name.len() + 2,
            None => at + rest[at..].find('>').unwrap(),
        };
        let breaks = ["</tr", "</p", "</h", "</li", "</figc", "</dt", "</dd", "</capt"];
        text += if breaks.iter().any(|tag| rest[at..].starts_with(tag)) { "\n" } else { " " };
        rest = &rest[end + 1..];
    }
    let lines =
        text.lines().map(|line| line.split(' ').filter(|w| !w.is_empty()).collect::<Vec<_>>());
    lines.map(|line| line.join(" ")).filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")
}

/// Checks that every element is closed in the correct order.
fn is_well_formed(page: &str) {
    let mut open: Vec<&str> = Vec::new();
    // Text in quotes or in the style sheet is not a tag.
    let (head, rest) = page.split_once("<style>").unwrap();
    let (_, rest) = rest.split_once("</style>").unwrap();
    for tag in (head.to_owned() + rest).split('<').skip(1) {
        let inner = &tag[..tag.find('>').unwrap()];
        let name = inner.split([' ', '\n', '/']).find(|part| !part.is_empty()).unwrap();
        if inner.starts_with('/') {
            let last = open.pop().unwrap_or_default();
            assert_eq!(last, name);
        } else if !inner.ends_with('/') && !matches!(name, "!DOCTYPE" | "meta") {
            open.push(Box::leak(name.to_owned().into_boxed_str()));
        }
    }
    assert_eq!(open, Vec::<&str>::new());
}

#[test]
fn the_text_of_reports_is_the_recorded_one() {
    insta::assert_snapshot!("html-footing", words(&made("footing")));
    insta::assert_snapshot!("html-supports", words(&made("supports")));
}

#[test]
fn every_report_is_one_self_contained_file() {
    for name in SOLVABLE {
        let page = made(name);
        is_well_formed(&page);
        // The page loads nothing and runs nothing; XML namespace names are not addresses.
        let plain = page.split_once("</style>").unwrap().1.replace("http://www.w3.org/", "");
        for never in ["http", "<script", "<link", "<img", "src=", "NaN"] {
            assert!(!plain.contains(never), "{name}: {never}");
        }
        assert_eq!(page.matches("url(").count(), page.matches("url(data:").count());
        assert_eq!(page, made(name), "equal results give equal bytes");
    }
}

#[test]
fn the_digest_is_the_sha256_of_the_file() {
    // printf 'abc' | sha256sum
    let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    let document = document("footing");
    let source = Source { text: "abc", ..source(&document) };
    let page = report(&answers(&document), &context(&document), &source);
    assert!(page.contains(expected));
}

#[test]
fn text_of_the_model_file_is_escaped() {
    let document = document("footing");
    let evil = "</title><script>alert('&amp;')</script> -1e3 \\\"";
    let source = Source { name: evil, text: evil, ..source(&document) };
    let context = Context::new(Units::SI).with_title(evil);
    let page = report(&answers(&document), &context, &source);
    is_well_formed(&page);
    assert!(!page.contains("<script"), "markup of the file is in the page");
    assert!(page.contains("&lt;script&gt;"));
}

#[test]
fn a_report_without_equilibrium_states_the_reason() {
    let document = document("tips");
    let page = report(&answers(&document), &context(&document), &source(&document));
    is_well_formed(&page);
    insta::assert_snapshot!("html-tips", words(&page));
    // The tipping motion is drawn.
    assert_eq!(page.matches("stroke-dasharray=\"9 5\"").count(), 1);
}

#[test]
fn a_report_without_a_certified_answer_has_no_results() {
    let document = document("footing");
    let reached = Stopped { method: Method::Uzawa, iterations: 10, why: NotConverged::Sweeps(0.5) };
    let mut answers = answers(&document);
    answers.list[0].found = Found::NotConverged(reached);
    let page = report(&answers, &context(&document), &source(&document));
    is_well_formed(&page);
    let words = words(&page);
    assert!(words.contains("Not solved the method `uzawa` stopped after 10 iterations"), "{words}");
    assert!(!words.contains("Certificate") && !words.contains("Largest"), "{words}");
}

#[test]
fn the_report_has_the_requested_paper_size() {
    let document = document("footing");
    let of = calculation::report(&answers(&document), &context(&document), &source(&document));
    let page = |paper| html::report(&of, paper).unwrap();
    assert!(page(Some(Paper::A4)).contains("@page { size: A4;"));
    assert!(page(Some(Paper::Letter)).contains("@page { size: letter;"));
    assert!(!page(None).contains("size: A4") && !page(None).contains("size: letter"));
}
