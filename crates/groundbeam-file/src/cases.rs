//! Lists of load cases from outside the file, as on a command line.

use crate::code;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::document::Document;
use crate::fault::Fault;
use crate::source::Source;
use crate::suggest::nearest;

/// Reads names of load cases separated by commas: which of the document's loads belong to one of them, in
/// the order of the loads.
///
/// ```
/// let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n
///     [[load]]\npoint = 1\nat = 0.5\n
///     [[load]]\npoint = 2\nat = 0.1\ncase = 'Q'\n";
/// let document = groundbeam_file::parse(text)?;
/// assert_eq!(groundbeam_file::parse_cases("Q", &document)?, [false, true]);
/// assert!(groundbeam_file::parse_cases("G", &document).is_err());
/// # Ok::<(), groundbeam_file::Diagnostics>(())
/// ```
///
/// # Errors
///
/// Every entry to which no load belongs; places count from the start of `list`, so that
/// [`Diagnostics::render`] shows them with `list` as the text.
pub fn parse_cases(list: &str, document: &Document) -> Result<Vec<bool>, Diagnostics> {
    let source = Source::new(list);
    let mut chosen = vec![false; document.cases.len()];
    let mut found = Vec::new();
    let mut start = 0;
    for entry in list.split(',') {
        let name = entry.trim();
        let at = start + entry.len() - entry.trim_start().len();
        let mut known = false;
        for (chosen, case) in chosen.iter_mut().zip(&document.cases) {
            if case.as_deref() == Some(name) {
                (*chosen, known) = (true, true);
            }
        }
        if !known {
            let span = at..at + name.len();
            let (code, message) = if name.is_empty() {
                (code::EMPTY_NAME, "a load case is missing here".to_owned())
            } else {
                (code::UNKNOWN_WORD, format!("no load belongs to a case `{name}`"))
            };
            found.push(Diagnostic::new(
                &source,
                Fault::new(code, span, message, "", hint(name, document)),
            ));
        }
        start += entry.len() + 1;
    }
    if found.is_empty() { Ok(chosen) } else { Err(Diagnostics::new(found)) }
}

/// What would be right.
fn hint(name: &str, document: &Document) -> String {
    let mut names: Vec<&str> = Vec::new();
    for case in document.cases.iter().flatten() {
        if !names.contains(&case.as_str()) {
            names.push(case);
        }
    }
    if names.is_empty() {
        return "no load of the file has a `case`; give one to those that are meant".to_owned();
    }
    match nearest(name, names.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("the cases of the file: {}", names.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document(cases: &[&str]) -> Document {
        let mut text = String::from("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n");
        for case in cases {
            text += &format!("[[load]]\npoint = 1\nat = 0.5\n{case}\n");
        }
        crate::parse(&text).expect("a model")
    }

    #[test]
    fn every_wrong_entry_is_shown_at_its_place() {
        let document = document(&["case = 'dead'", "", "case = ' wind '", "case = 'dead'"]);
        assert_eq!(parse_cases(" dead", &document).unwrap(), [true, false, false, true]);
        assert_eq!(parse_cases("wind,dead,wind", &document).unwrap(), [true, false, true, true]);
        let list = "dead, snow,,wnd";
        let wrong = parse_cases(list, &document).unwrap_err();
        let seen: Vec<_> =
            wrong.iter().map(|d| (d.code, &list[d.span.clone()], &*d.hint)).collect();
        let all = "the cases of the file: dead, wind";
        let expected = [
            (code::UNKNOWN_WORD, "snow", all),
            (code::EMPTY_NAME, "", all),
            (code::UNKNOWN_WORD, "wnd", "did you mean `wind`?"),
        ];
        assert_eq!(seen, expected);
    }

    #[test]
    fn without_cases_it_says_how_to_give_one() {
        let wrong = parse_cases("G", &document(&[""])).unwrap_err();
        assert!(wrong.iter().all(|d| d.hint.contains("no load of the file has a `case`")));
    }
}
