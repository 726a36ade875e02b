//! A strict reader of JSON: a single value with unique keys and finite doubles, without text after the value.

use std::collections::BTreeMap;
use std::fmt;

/// Maximum length of a document, in bytes.
const LONGEST: usize = 64 << 20;
/// Maximum number of values in a document.
const MOST: usize = 10_000_000;
/// Maximum depth of nested lists and objects.
const DEEPEST: usize = 32;

/// The reason why a document cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JsonError {
    /// Line of the fault in the document, counted from 1; 0 if the fault has no single position.
    pub line: usize,
    /// Column of the fault in its line, in characters counted from 1; 0 if the fault has no single position.
    pub column: usize,
    /// The fault.
    pub what: String,
}

impl fmt::Display for JsonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => f.write_str(&self.what),
            line => write!(f, "line {line}, column {}: {}", self.column, self.what),
        }
    }
}

impl std::error::Error for JsonError {}

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Json {
    Null,
    Boolean(bool),
    Number(f64),
    Text(String),
    List(Vec<Json>),
    Object(BTreeMap<String, Json>),
}

impl Json {
    /// Whether the value is a number or contains one.
    pub fn has_number(&self) -> bool {
        match self {
            Json::Number(_) => true,
            Json::List(list) => list.iter().any(Json::has_number),
            Json::Object(object) => object.values().any(Json::has_number),
            Json::Null | Json::Boolean(_) | Json::Text(_) => false,
        }
    }
}

/// Reads a whole document.
pub(crate) fn read(text: &str) -> Result<Json, JsonError> {
    read_within([LONGEST, MOST], text)
}

/// Reads a whole document with at most the given numbers of bytes and values.
fn read_within([longest, most]: [usize; 2], text: &str) -> Result<Json, JsonError> {
    let mut reader = Reader { text, at: 0, values: 0, most };
    reader.document(longest).map_err(|what| {
        let mut at = reader.at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &text[..at];
        let line = before.bytes().filter(|byte| *byte == b'\n').count() + 1;
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let column = before[start..].chars().count() + 1;
        JsonError { line, column, what: what.to_owned() }
    })
}

type Fault = &'static str;

struct Reader<'t> {
    text: &'t str,
    at: usize,
    values: usize,
    /// Maximum number of values.
    most: usize,
}

impl Reader<'_> {
    fn document(&mut self, longest: usize) -> Result<Json, Fault> {
        if self.text.len() > longest {
            return Err("the document is longer than 64 MB");
        }
        let value = self.value(0)?;
        self.skip_spaces();
        if self.peek().is_some() {
            Err("there is text after the end of the document")
        } else {
            Ok(value)
        }
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn take(&mut self, wanted: &str) -> bool {
        let stands = self.text.get(self.at..).is_some_and(|rest| rest.starts_with(wanted));
        if stands {
            self.at += wanted.len();
        }
        stands
    }

    fn skip_spaces(&mut self) {
        while let Some(b' ' | b'\t' | b'\n' | b'\r') = self.peek() {
            self.at += 1;
        }
    }

    fn value(&mut self, depth: usize) -> Result<Json, Fault> {
        self.skip_spaces();
        self.values += 1;
        if self.values > self.most {
            return Err("the document has more than 10 million values");
        }
        match self.peek() {
            Some(b'[' | b'{') if depth == DEEPEST => Err("values are nested too deeply"),
            Some(b'[') => self.list(depth + 1),
            Some(b'{') => self.object(depth + 1),
            Some(b'"') => self.string().map(Json::Text),
            Some(b'-' | b'0'..=b'9') => self.number().map(Json::Number),
            _ if self.take("null") => Ok(Json::Null),
            _ if self.take("true") => Ok(Json::Boolean(true)),
            _ if self.take("false") => Ok(Json::Boolean(false)),
            _ => Err("a value is expected here"),
        }
    }

    fn list(&mut self, depth: usize) -> Result<Json, Fault> {
        self.take("[");
        let mut list = Vec::new();
        self.skip_spaces();
        if self.take("]") {
            return Ok(Json::List(list));
        }
        loop {
            list.push(self.value(depth)?);
            self.skip_spaces();
            if self.take("]") {
                return Ok(Json::List(list));
            }
            if !self.take(",") {
                return Err("`,` or `]` is expected here");
            }
        }
    }

    fn object(&mut self, depth: usize) -> Result<Json, Fault> {
        self.take("{");
        let mut object = BTreeMap::new();
        self.skip_spaces();
        if self.take("}") {
            return Ok(Json::Object(object));
        }
        loop {
            self.skip_spaces();
            if self.peek() != Some(b'"') {
                return Err("a key in quotes is expected here");
            }
            let start = self.at;
            let key = self.string()?;
            if object.contains_key(&key) {
                self.at = start;
                return Err("this key is given twice");
            }
            self.skip_spaces();
            if !self.take(":") {
                return Err("`:` is expected here");
            }
            let value = self.value(depth)?;
            object.insert(key, value);
            self.skip_spaces();
            if self.take("}") {
                return Ok(Json::Object(object));
            }
            if !self.take(",") {
                return Err("`,` or `}` is expected here");
            }
        }
    }

    /// Skips digits. Returns whether at least one digit was skipped.
    fn digits(&mut self) -> bool {
        let start = self.at;
        while self.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        self.at > start
    }

    fn number(&mut self) -> Result<f64, Fault> {
        let start = self.at;
        self.take("-");
        let right = if self.take("0") { true } else { self.digits() };
        let right = right && (!self.take(".") || self.digits());
        let power = self.take("e") || self.take("E");
        if power && !self.take("+") {
            self.take("-");
        }
        if !right || (power && !self.digits()) {
            return Err("this number is incomplete");
        }
        let number = self.text.get(start..self.at).and_then(|text| text.parse::<f64>().ok());
        match number {
            Some(number) if number.is_finite() => Ok(number),
            _ => {
                self.at = start;
                Err("this number is too large")
            }
        }
    }

    fn string(&mut self) -> Result<String, Fault> {
        self.at += 1;
        let mut found = String::new();
        loop {
            let rest = self.text.get(self.at..).unwrap_or("");
            let plain = rest.find(|c: char| c == '"' || c == '\\' || c < ' ').unwrap_or(rest.len());
            found.push_str(rest.get(..plain).unwrap_or(""));
            self.at += plain;
            match self.peek() {
                Some(b'"') => {
                    self.at += 1;
                    return Ok(found);
                }
                Some(b'\\') => {
                    self.at += 1;
                    found.push(self.escape()?);
                }
                _ => return Err("a string must end with a quote on the same line"),
            }
        }
    }

    fn escape(&mut self) -> Result<char, Fault> {
        let letter = self.peek().ok_or("an escape is incomplete")?;
        self.at += 1;
        Ok(match letter {
            b'"' => '"',
            b'\\' => '\\',
            b'/' => '/',
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => {
                let first = self.hex()?;
                let code = match first {
                    0xd800..=0xdbff if self.take("\\u") => {
                        let second = self.hex()?;
                        match second {
                            0xdc00..=0xdfff => 0x10000 + (first - 0xd800) * 0x400 + second - 0xdc00,
                            _ => return Err("half a character"),
                        }
                    }
                    code => code,
                };
                char::from_u32(code).ok_or("half a character")?
            }
            _ => return Err("unknown escape sequence"),
        })
    }

    fn hex(&mut self) -> Result<u32, Fault> {
        let digits = self.text.get(self.at..self.at + 4).unwrap_or("");
        if digits.len() != 4 || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
            return Err("four hexadecimal digits are expected here");
        }
        self.at += 4;
        u32::from_str_radix(digits, 16).map_err(|_| "four hexadecimal digits are expected here")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_every_kind() {
        let text = r#" { "a" : [1, -0.5e+1, 1E-2, 0], "b": {"c\n\u00b5\ud83d\ude00": null},
            "d": [true, false, "x/\/"], "e": {}, "f": [] } "#;
        let Json::Object(object) = read(text).unwrap() else { panic!() };
        let numbers = [1.0, -5.0, 0.01, 0.0].map(Json::Number).to_vec();
        assert_eq!(object["a"], Json::List(numbers));
        let Json::Object(inner) = &object["b"] else { panic!() };
        assert_eq!(inner["c\nµ\u{1f600}"], Json::Null);
        assert!(object["a"].has_number() && !object["b"].has_number());
    }

    #[test]
    fn invalid_json_is_refused() {
        for text in [
            "",
            "{",
            "[1,]",
            "{\"a\":1,}",
            "[1 2]",
            "{\"a\" 1}",
            "{a:1}",
            "NaN",
            "[Infinity]",
            "-Infinity",
            "1e999",
            "-1e999",
            "01",
            "1.",
            ".5",
            "+1",
            "1e",
            "--1",
            "\"a",
            "\"\\x\"",
            "\"\\ud800\"",
            "\"\\ud800\\u0041\"",
            "\"\\u12g4\"",
            "\"a\nb\"",
            "1 2",
            "[1]]",
            "{\"a\":1,\"a\":2}",
            "{\"a\":1,\"\\u0061\":2}",
            "nul",
            "\u{feff}1",
            "'a'",
            "[1] x",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
        assert!(read(&"[".repeat(1_000_000)).is_err());
        let error = read("{\"a\": 1,\n \"a\": 2}").unwrap_err();
        assert_eq!((error.line, error.column), (2, 2));
    }

    #[test]
    fn every_escape_has_its_character() {
        let text = r#""a b\"\\\/\b\f\n\r\t\u00e9\u0000""#;
        let exact = "a b\"\\/\u{8}\u{c}\n\r\té\0";
        assert_eq!(read(text), Ok(Json::Text(exact.to_owned())));
        for wrong in [r#""\u+123""#, r#""\u 123""#, r#""\u12""#, r#""\u123é""#, r#""\v""#, r#""\"#]
        {
            assert!(read(wrong).is_err(), "{wrong}");
        }
        // The parser stops between the two bytes of é. The reported column is that of é.
        let error = read("[1,\n\"\\é\"]").unwrap_err();
        assert_eq!((error.line, error.column), (2, 3));
        assert_eq!(error.to_string(), "line 2, column 3: unknown escape sequence");
        let whole = JsonError { line: 0, column: 0, what: "wrong".to_owned() };
        assert_eq!(whole.to_string(), "wrong");
    }

    /// The text has 18 bytes and five values: two containers and three others.
    #[test]
    fn bytes_and_values_are_limited() {
        let text = r#"[1, null, {"a":2}]"#;
        for (limits, right) in [
            ([18, 5], true),
            ([17, 5], false),
            ([19, 5], true),
            ([18, 4], false),
            ([18, 6], true),
            ([5, 5], false),
            ([18, 1], false),
        ] {
            assert_eq!(read_within(limits, text).is_ok(), right, "{limits:?}");
        }
    }
}
