//! Tests the terminal reports.

use crate::common::{SOLVABLE, answers, context, document, solved};
use groundbeam::{Method, NotConverged, Stopped};
use groundbeam_report::{Context, Kind, text};

/// The report without the certificate's numbers, which are rounding errors, and without the iteration count.
fn steady(report: &str) -> &str {
    report.split("\nCertificate").next().unwrap()
}

#[test]
fn text_reports_are_the_recorded_ones() {
    for name in SOLVABLE {
        let document = document(name);
        let report = text::solved(&solved(&document), &context(&document), false);
        insta::assert_snapshot!(format!("text-{name}"), steady(&report));
    }
}

#[test]
fn lines_have_at_most_80_characters() {
    for name in SOLVABLE {
        let document = document(name);
        let report = text::solved(&solved(&document), &context(&document), false);
        for line in report.lines() {
            assert!(line.chars().count() <= 80 && line == line.trim_end(), "{name}: {line}");
        }
    }
}

/// A rail in pounds and feet: its envelope has the widest numbers of all units.
#[test]
fn the_envelope_of_passages_fits_a_terminal() {
    let passages = "[beam]\nlength = '150 ft'\nE = '30000 ksi'\nsection = { rail = '136RE' }\n\
                    [foundation]\nk = '3000 psi'\n[[load]]\ndistributed = '17 pli'\n\
                    [[train]]\naxles = [{ at = '0 ft', force = '100000 lb' }]\nfrom = '10 ft'\nto = '12 ft'\n\
                    [[train]]\nname = 'b'\naxles = [{ at = '0 ft', force = '500 lb' }]\nfrom = '10 ft'\nto = '11 ft'\n";
    let document = groundbeam_file::parse(passages).unwrap();
    let answers = answers(&document);
    let report = text::trains(&answers.passages(), &Context::of(&document), false);
    let mut rows = report.lines().skip_while(|line| !line.starts_with("Envelope"));
    let heading = rows.next().unwrap();
    assert!(heading.contains("   smallest  ") && heading.contains("   train #"), "{heading}");
    let row = rows.find(|row| row.starts_with("Moment")).unwrap();
    assert_eq!(row.chars().count(), heading.chars().count(), "{heading}\n{row}");
    for line in report.lines() {
        assert!(line.chars().count() <= 80, "{line}");
    }
}

/// k and μ of several combinations on layers of soil differ in digits that are not printed.
#[test]
fn the_ground_of_each_combination_is_listed_per_area() {
    let soil = "[beam]\nlength = '12 m'\nEI = '1 GN m^2'\n[foundation]\nwidth = '2 m'\n[foundation.soil]\n\
                method = 'modified-vlasov'\n[[foundation.soil.layer]]\nE = '15 MPa'\nnu = 0.3\nthickness = '4 m'\n\
                [[load]]\npoint = '450 kN'\nat = '5 m'\ncase = 'G'\n[[load]]\npoint = '45 kN'\nat = '6 m'\ncase = 'Q'\n\
                [[combination]]\nname = 'a'\nfactors = { G = 1 }\n[[combination]]\nname = 'b'\nfactors = { G = 1, Q = 0.001 }\n";
    let document = groundbeam_file::parse(soil).unwrap();
    let answers = answers(&document);
    let report = text::combinations(&answers, &Context::of(&document), false);
    let words = report.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("Stiffness β = 0.2") && !words.contains("0.2 to 0.2"), "{words}");
    let k = answers.list[0].solution().unwrap().model().foundation.subgrade;
    let area = document.printed.write(Kind::AreaSpring, k / 2.0);
    assert!(words.contains(&format!("bearing width b = 2 m: C1 = k/b = {area}, C2")), "{words}");
    assert!(words.contains("of each combination depend on its own solution by "), "{words}");
}

#[test]
fn the_text_of_a_missing_equilibrium_is_the_recorded_one() {
    let document = document("tips");
    let existence = groundbeam::exists(&document.model).unwrap();
    let report = text::existence(&document.model, &existence, &context(&document), false);
    insta::assert_snapshot!("text-tips", report);
}

#[test]
fn the_text_of_missing_convergence_is_the_recorded_one() {
    let reached =
        Stopped { method: Method::Uzawa, iterations: 1_000_000, why: NotConverged::Sweeps(3.2e-4) };
    insta::assert_snapshot!("text-not-converged", text::not_converged(&reached, false));
}

#[test]
fn colour_adds_only_escape_codes() {
    let document = document("kikuchi-4");
    let solution = solved(&document);
    let report = |colour| text::solved(&solution, &context(&document), colour);
    let (plain, coloured) = (report(false), report(true));
    assert!(!plain.contains('\u{1b}') && coloured.contains("\u{1b}[1;32mexactly one\u{1b}[0m"));
    let mut stripped = String::new();
    for (i, piece) in coloured.split('\u{1b}').enumerate() {
        stripped.push_str(if i == 0 { piece } else { piece.split_once('m').unwrap().1 });
    }
    assert_eq!(stripped, plain);
}

#[test]
fn terminal_drawings_are_the_recorded_ones() {
    for name in SOLVABLE {
        let document = document(name);
        let solution = solved(&document);
        let drawn = text::drawing(&solution, context(&document).units, false);
        assert!(drawn.lines().all(|line| line.chars().count() <= 80), "{drawn}");
        insta::assert_snapshot!(format!("drawing-{name}"), drawn);
        let painted = text::drawing(&solution, context(&document).units, true);
        let codes = ["\u{1b}[0m", "\u{1b}[2m", "\u{1b}[33m", "\u{1b}[34m"];
        let plain = codes.iter().fold(painted, |text, code| text.replace(code, ""));
        assert_eq!(plain, drawn, "colour adds colour alone");
    }
}
