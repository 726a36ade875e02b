//! The tokens of a TOML file: spaces, comments, names and strings.

use super::error::{Read, Reason, fault};

/// A text and the position of the next byte to be read.
pub(crate) struct Scanner<'t> {
    text: &'t str,
    /// The next byte.
    pub at: usize,
}

impl<'t> Scanner<'t> {
    /// A scanner at the start of a text, after a byte order mark if there is one.
    pub fn new(text: &'t str) -> Self {
        let at = if text.starts_with('\u{feff}') { 3 } else { 0 };
        Scanner { text, at }
    }

    fn rest(&self) -> &'t str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// The next byte.
    pub fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Skips `wanted` if the text continues with it. Returns whether `wanted` was skipped.
    pub fn take(&mut self, wanted: &str) -> bool {
        let stands = self.rest().starts_with(wanted);
        if stands {
            self.at += wanted.len();
        }
        stands
    }

    /// Returns a syntax fault at the current position.
    pub fn syntax<T>(&self, what: &'static str) -> Read<T> {
        fault(self.at, Reason::Syntax(what))
    }

    /// Skips spaces and tabs.
    pub fn skip_spaces(&mut self) {
        while let Some(b' ' | b'\t') = self.peek() {
            self.at += 1;
        }
    }

    /// Skips spaces, comments and ends of lines.
    pub fn skip_lines(&mut self) -> Read<()> {
        loop {
            self.skip_spaces();
            match self.peek() {
                Some(b'#') => self.skip_comment()?,
                Some(b'\n') => self.at += 1,
                Some(b'\r') if self.rest().starts_with("\r\n") => self.at += 2,
                _ => return Ok(()),
            }
        }
    }

    fn skip_comment(&mut self) -> Read<()> {
        while let Some(byte) = self.peek() {
            match byte {
                b'\n' => break,
                b'\r' if self.rest().starts_with("\r\n") => break,
                byte if is_control(byte) => {
                    return self.syntax("a control character is not allowed");
                }
                _ => self.at += 1,
            }
        }
        Ok(())
    }

    /// Skips the rest of a line, which may contain only spaces and a comment.
    pub fn end_of_line(&mut self) -> Read<()> {
        self.skip_spaces();
        if self.peek() == Some(b'#') {
            self.skip_comment()?;
        }
        if self.peek().is_none() || self.take("\n") || self.take("\r\n") {
            return Ok(());
        }
        self.syntax("a line must contain only one `key = value` or one heading")
    }

    /// A key, bare or in quotes.
    pub fn name(&mut self) -> Read<String> {
        if let Some(b'"' | b'\'') = self.peek() {
            if self.rest().starts_with("\"\"\"") || self.rest().starts_with("'''") {
                return self.syntax("a key must be on one line");
            }
            return self.string();
        }
        let start = self.at;
        while self.peek().is_some_and(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-') {
            self.at += 1;
        }
        match self.text.get(start..self.at) {
            Some(name) if !name.is_empty() => Ok(name.to_owned()),
            _ => self.syntax("a key is expected here"),
        }
    }

    /// Reads the characters of a number or of a word.
    pub fn word(&mut self) -> &'t str {
        let start = self.at;
        while self.peek().is_some_and(|b| b.is_ascii_alphanumeric() || b"_+-.:".contains(&b)) {
            self.at += 1;
        }
        self.text.get(start..self.at).unwrap_or("")
    }

    /// Reads a string of any of TOML's four kinds.
    pub fn string(&mut self) -> Read<String> {
        let quote = if self.peek() == Some(b'"') { b'"' } else { b'\'' };
        let three = if quote == b'"' { "\"\"\"" } else { "'''" };
        let long = self.take(three);
        if !long {
            self.at += 1;
        } else if !self.take("\n") {
            self.take("\r\n");
        }
        let mut found = String::new();
        loop {
            let Some(character) = self.rest().chars().next() else {
                return self.syntax("a string must end with the quote with which it begins");
            };
            match character {
                _ if long && self.rest().starts_with(three) => {
                    // One or two quotes that belong to the string may precede the three closing quotes.
                    let quotes = self.rest().bytes().take(5).take_while(|b| *b == quote).count();
                    found.extend((3..quotes).map(|_| char::from(quote)));
                    self.at += quotes;
                    return Ok(found);
                }
                _ if !long && character == char::from(quote) => {
                    self.at += 1;
                    return Ok(found);
                }
                '\\' if quote == b'"' => self.escape(&mut found, long)?,
                '\n' if long => {
                    found.push('\n');
                    self.at += 1;
                }
                '\r' if long && self.take("\r\n") => found.push('\n'),
                _ if u8::try_from(character).is_ok_and(is_control) => {
                    return self.syntax(
                        "a new line needs triple quotes; a control character needs an escape",
                    );
                }
                _ => {
                    found.push(character);
                    self.at += character.len_utf8();
                }
            }
        }
    }

    /// Reads an escape such as `\n`. In a string over several lines, also reads an escaped end of line.
    fn escape(&mut self, found: &mut String, long: bool) -> Read<()> {
        let start = self.at;
        self.at += 1;
        let Some(letter) = self.peek() else { return self.syntax("an escape is incomplete") };
        if long && matches!(letter, b' ' | b'\t' | b'\n' | b'\r') {
            self.skip_spaces();
            if !self.take("\n") && !self.take("\r\n") {
                return self.syntax("a backslash must be the last character of its line");
            }
            while self.take(" ") || self.take("\t") || self.take("\n") || self.take("\r\n") {}
            return Ok(());
        }
        self.at += 1;
        let digits = match letter {
            b'b' => return push(found, '\u{8}'),
            b't' => return push(found, '\t'),
            b'n' => return push(found, '\n'),
            b'f' => return push(found, '\u{c}'),
            b'r' => return push(found, '\r'),
            b'"' => return push(found, '"'),
            b'\\' => return push(found, '\\'),
            b'u' => 4,
            b'U' => 8,
            _ => return fault(start, Reason::Syntax("unknown escape")),
        };
        let written = self.text.get(self.at..self.at + digits).unwrap_or("");
        let is_hex = written.bytes().all(|b| b.is_ascii_hexdigit());
        let code = if is_hex { u32::from_str_radix(written, 16).ok() } else { None };
        let Some(character) = code.and_then(char::from_u32) else {
            return fault(start, Reason::Syntax("this escape is not a Unicode character"));
        };
        self.at += digits;
        push(found, character)
    }
}

fn push(found: &mut String, character: char) -> Read<()> {
    found.push(character);
    Ok(())
}

fn is_control(byte: u8) -> bool {
    (byte < 0x20 && byte != b'\t') || byte == 0x7f
}

#[cfg(test)]
mod tests {
    use super::*;

    fn string(text: &str) -> Option<String> {
        let mut scanner = Scanner::new(text);
        scanner.string().ok().filter(|_| scanner.peek().is_none())
    }

    #[test]
    fn strings_of_four_kinds() {
        let cases = [
            (r#""a \"b\" \u00b5 \\""#, "a \"b\" µ \\"),
            (r"'a \n'", r"a \n"),
            ("\"\"\"\na\\\n   b\r\nc\"\"\"", "ab\nc"),
            ("'''a'b'''''", "a'b''"),
            ("\"\"", ""),
            ("''''''", ""),
            ("\"°\"", "°"),
            ("\"\"\"\r\nab\"\"\"", "ab"),
            ("\"\"\"\n\r\nab\"\"\"", "\nab"),
            ("\"\"\"\n\nab\"\"\"", "\nab"),
            ("'''\r\n\r\nab'''", "\nab"),
        ];
        for (text, expected) in cases {
            assert_eq!(string(text).as_deref(), Some(expected), "{text}");
        }
        for text in [
            "\"a",
            "'a\n'",
            "\"\\x\"",
            "\"\\u12\"",
            "\"\\ud800\"",
            "\"\\u+123\"",
            "'''a''",
            "\"\\",
            "\"\u{7f}\"",
            "\"\\Uffffffff\"",
            "\"\\u00\u{b5}\u{b5}\"",
        ] {
            assert_eq!(string(text), None, "{text:?}");
        }
    }

    #[test]
    fn a_comment_has_no_control_characters() {
        let control = Reason::Syntax("a control character is not allowed");
        for (text, right) in [
            ("# a\n", true),
            ("# a\r\n", true),
            ("# a\tb\r\n", true),
            ("# a", true),
            ("# a\rb\n", false),
            ("# a\r", false),
            ("# a\u{1}\n", false),
        ] {
            for skip in [Scanner::skip_lines, Scanner::end_of_line] {
                let found = skip(&mut Scanner::new(text)).map_err(|fault| fault.reason);
                assert_eq!(found, if right { Ok(()) } else { Err(control.clone()) }, "{text:?}");
            }
        }
    }
}
