//! Checks that printed intervals `value ± bound` of proven answers contain the answers in 60 digits.

use groundbeam::proof::{Document, Wide, verify};
use groundbeam::{Outcome, solve};
use groundbeam_file::UnitSystem;
use groundbeam_report::{Context, ModelOf, Named, json, text};
use groundbeam_verification::reference::Answer;
use rayon::prelude::*;

/// The intervals of a row of a report and of its continuation rows.
fn intervals(report: &str, label: &str) -> Vec<[f64; 2]> {
    let mut rows = report.lines().skip_while(|line| !line.starts_with(label));
    let first = rows.next().unwrap_or_default().replacen(label, "", 1);
    let others = rows.take_while(|line| line.starts_with(' '));
    let words: String = others.fold(first, |all, line| all + " " + line);
    let words: Vec<&str> = words.split_whitespace().collect();
    let signs = words.iter().enumerate().filter(|(_, word)| **word == "±");
    let number =
        |word: &str| -> f64 { word.trim_matches(',').replace('−', "-").parse().expect(word) };
    signs.map(|(i, _)| [number(words[i - 1]), number(words[i + 1])]).collect()
}

/// The report of an answer, if it is proven.
fn report(answer: &Answer) -> Option<String> {
    let Ok(Outcome::Equilibrium(solution)) = solve(&answer.parsed()) else { return None };
    let context = Context { pieces: true, ..Context::new(UnitSystem::Plain.into()) };
    let stations = json::default_stations(&solution);
    let written = json::solved(&solution, &stations, &context);
    let document = Document::read(&written).expect("a document").pop()?;
    // The decimals of these model files stand for their nearest doubles.
    let (model, _) = solution.claim::<Wide>();
    let found = verify(&model, &document);
    let proofs = [Named { combination: None, model: ModelOf::File, found }];
    let report = text::solved(&solution, &Context { proofs: &proofs, ..context }, false);
    proofs[0].found.as_ref().is_ok_and(|found| found.shortfall.is_none()).then_some(report)
}

/// Compares a report with an answer. Returns the number of compared values, or the wrong ones.
fn compared(answer: &Answer, report: &str) -> Result<usize, String> {
    // The rounding of the answer to doubles is allowed for.
    let holds = |[value, bound]: [f64; 2], exact: f64| {
        (value - exact).abs() <= bound + 2.0 * f64::EPSILON * exact.abs()
    };
    let wrong = |what: &str, found: &[[f64; 2]], exact: &[f64]| {
        Err(format!("{}: {what} {found:?}, exactly {exact:?}\n{report}", answer.name))
    };
    let mut count = 0;
    let lists = [
        ("End forces", vec![answer.end_forces["left"], answer.end_forces["right"]]),
        ("Forces", answer.inner_forces.iter().map(|force| force.force).collect()),
    ];
    for (label, exact) in lists {
        let found = intervals(report, label);
        let all = found.len() == exact.len();
        if !(all && found.iter().zip(&exact).all(|(found, exact)| holds(*found, *exact))) {
            return wrong(label, &found, &exact);
        }
        count += exact.len();
    }
    let edges = intervals(report, "Contact");
    let exact: Vec<f64> = answer.contact.iter().flatten().copied().collect();
    // A region that covers the whole beam, and a point, have a shorter form.
    let is_inside = |found: &[f64; 2]| exact.iter().any(|exact| holds(*found, *exact));
    if !edges.iter().all(is_inside) {
        return wrong("Contact", &edges, &exact);
    }
    count += edges.len();
    for (label, field) in
        [("Moment", "moment"), ("Pressure", "pressure"), ("Deflection", "deflection")]
    {
        let found = intervals(report, label);
        let exact = answer.largest[field];
        let most = found.iter().map(|[value, bound]| value.abs() + bound).fold(0.0, f64::max);
        if most < exact * (1.0 - 4.0 * f64::EPSILON) {
            return wrong(label, &found, &[exact]);
        }
        count += 1;
    }
    Ok(count)
}

#[test]
fn printed_intervals_hold_the_answers_in_sixty_digits() {
    let answers = Answer::all();
    let printed: Vec<_> =
        answers.par_iter().filter_map(|answer| Some((answer, report(answer)?))).collect();
    let counts: Result<Vec<usize>, String> =
        printed.par_iter().map(|(answer, report)| compared(answer, report)).collect();
    let counts = counts.unwrap_or_else(|wrong| panic!("{wrong}"));
    let numbers: usize = counts.iter().sum();
    println!("{numbers} numbers of {} proven answers of {}", counts.len(), answers.len());
    assert!(counts.len() >= 230 && numbers >= 1500, "{numbers} numbers of {}", counts.len());
}
