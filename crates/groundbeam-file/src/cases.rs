//! Parses a comma-separated list of load cases, as given on the command line.

use crate::case_names::{NO_LOAD, names, otherwise};
use crate::code;
use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::fault::Fault;
use crate::{list, suggest};
use std::collections::HashSet;

/// Parses a comma-separated list of names of load cases. Returns each name once, in the order of the list.
///
/// ```
/// let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n
///     [[load]]\npoint = 1\nat = 0.5\n
///     [[load]]\npoint = 2\nat = 0.1\ncase = 'Q'\n";
/// let document = groundbeam_file::parse(text)?;
/// assert_eq!(groundbeam_file::parse_cases("Q,Q", &document)?, ["Q"]);
/// assert!(groundbeam_file::parse_cases("G", &document).is_err());
/// # Ok::<(), groundbeam_file::Diagnostics>(())
/// ```
///
/// # Errors
///
/// Returns one diagnostic for each entry that is not a load case. Its byte positions refer to `list`.
pub fn parse_cases(list: &str, document: &Document) -> Result<Vec<String>, Diagnostics> {
    let known = names(&document.cases);
    let mut chosen = list::read(list, |name| {
        if known.contains(&name) {
            return Ok(name.to_owned());
        }
        let (code, message) = match name {
            "" => (code::EMPTY_NAME, "a load case is missing here".to_owned()),
            _ => (code::UNKNOWN_WORD, NO_LOAD.replace("{}", name)),
        };
        let hint = suggest::advice(name, &known, otherwise(&known));
        Err(Fault::new(code, 0..name.len(), message, "", hint))
    })?;
    let mut seen = HashSet::new();
    chosen.retain(|name| seen.insert(name.clone()));
    Ok(chosen)
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
    fn each_wrong_entry_is_reported_at_its_location() {
        let document = document(&["case = 'dead'", "", "case = ' wind '", "case = 'dead'"]);
        assert_eq!(parse_cases(" dead", &document).unwrap(), ["dead"]);
        assert_eq!(parse_cases("wind,dead,wind", &document).unwrap(), ["wind", "dead"]);
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
    fn the_message_for_a_file_without_cases_shows_how_to_give_one() {
        let wrong = parse_cases("G", &document(&[""])).unwrap_err();
        assert!(wrong.iter().all(|d| d.hint.contains("no load of the file has the key `case`")));
    }
}
