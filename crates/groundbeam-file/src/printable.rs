//! Escapes control characters in text from the user, so that a terminal does not interpret them.

use std::borrow::Cow;

/// Replaces control characters, marks of text direction, line separators, U+FFFE and U+FFFF by escapes such as `\n`.
///
/// ```
/// assert_eq!(groundbeam_file::printable("a\u{1b}[31mb"), r"a\u{1b}[31mb");
/// assert_eq!(groundbeam_file::printable("梁 1 – µm"), "梁 1 – µm");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_unprintable) {
        return Cow::Borrowed(text);
    }
    let mut printed = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match is_unprintable(c) {
            true => printed.extend(c.escape_default()),
            false => printed.push(c),
        }
    }
    Cow::Owned(printed)
}

/// Whether a terminal would interpret the character instead of showing it.
pub fn is_unprintable(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}')
        || matches!(c, '\u{2066}'..='\u{2069}' | '\u{fffe}' | '\u{ffff}')
}
