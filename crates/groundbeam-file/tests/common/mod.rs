//! Checks that apply to all diagnostics of a text.

use groundbeam_file::{Diagnostic, Diagnostics, printable};

/// Checks that the diagnostics lie in their text, are in order, and can be shown.
pub fn well_placed(diagnostics: &Diagnostics, text: &str) {
    assert!(!diagnostics.as_slice().is_empty());
    let mut last = (false, 0);
    for diagnostic in diagnostics {
        let file = diagnostic.file.as_deref();
        let text = file.map_or(text, |file| &file.text);
        assert!(text.get(diagnostic.span.clone()).is_some(), "{diagnostic:?}");
        let place = (file.is_some(), diagnostic.span.start);
        assert!(place >= last, "{diagnostics}");
        last = place;
        let line = text.split('\n').nth(diagnostic.line - 1).unwrap();
        assert!((1..=line.chars().count() + 1).contains(&diagnostic.column));
        tells_numbers(diagnostic, text);
    }
    let shown = diagnostics.render("file.toml", text, false);
    for diagnostic in diagnostics.iter().take(100) {
        let file = diagnostic.file.as_deref();
        let (name, text) = file.map_or(("file.toml", text), |file| (&file.name, &file.text));
        // The position is computed here and by the renderer. They may differ only for a carriage return at
        // the very end of a line.
        let position = format!("{name}:{}:{}", diagnostic.line, diagnostic.column);
        let at_carriage_return = text[diagnostic.span.start..].starts_with('\r');
        assert!(at_carriage_return || shown.contains(&position), "{position} not in\n{shown}");
    }
    let unprintable = |c: &char| *c != '\n' && printable(&c.to_string()) != c.to_string();
    assert_eq!(shown.chars().find(unprintable), None, "{shown}");
    diagnostics.render("file.toml", text, true);
}

/// Checks that no message contains NaN or infinity, unless the text itself does.
fn tells_numbers(diagnostic: &Diagnostic, text: &str) {
    for said in [&diagnostic.message, &diagnostic.label, &diagnostic.hint] {
        for word in said.split(|c: char| !c.is_alphanumeric()) {
            let is_number = !["nan", "inf"].contains(&word.to_lowercase().as_str());
            assert!(
                is_number || text.to_lowercase().contains("nan") || text.contains("inf"),
                "{diagnostic:?}"
            );
        }
    }
}
