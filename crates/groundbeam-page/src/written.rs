//! Finds all numbers in the text of a model file, so that the page can change them.

use groundbeam::model::Part;
use groundbeam_file::{Document, Place, Quantity, Sign};
use serde::Serialize;
use std::collections::HashMap;

/// A quantity in the text of a model file. Positions in the text count UTF-16 units, as in browsers.
#[derive(Debug, Serialize)]
pub struct Number {
    key: String,
    /// Heading of the table that contains the key: `[beam]`, `[[load]]`.
    table: String,
    /// Index of the table among the tables with this heading, from 1; 0 if the heading has single brackets.
    which: usize,
    /// Start of the number without its unit. For a length such as `1'-6"`, start of the whole text.
    from: usize,
    to: usize,
    /// Unit after the number, as written in the text.
    unit: String,
    /// The length as a decimal number with its unit, if the text gives it in feet and inches, such as `1'-6"`; `None`
    /// otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    decimal: Option<(f64, &'static str)>,
    /// Factor that converts the unit to SI units.
    size: f64,
    /// Signs that the file format allows for the number: `any`, `not negative` or `positive`.
    sign: &'static str,
    /// Whether a position must lie on the beam or on the ground; `None` for a quantity that is not a position.
    place: Option<&'static str>,
    /// Typical value of the quantity, in SI units.
    usual: f64,
}

impl Number {
    /// Returns all quantities of a file, in the order of the text.
    pub fn all(document: &Document) -> Vec<Number> {
        let text = document.text();
        let units = Utf16::of(text);
        let mut headings = Headings::of(text);
        let of = |quantity: &Quantity| {
            let (table, which) = headings.above(quantity.span.start);
            Number::of(quantity, text, &units, table, which)
        };
        document.quantities.iter().map(of).collect()
    }

    fn of(quantity: &Quantity, text: &str, units: &Utf16, table: &str, which: usize) -> Number {
        Number {
            key: quantity.key.clone(),
            table: table.to_owned(),
            which,
            from: units.at(quantity.number.start),
            to: units.at(quantity.number.end),
            unit: text[quantity.number.end..quantity.text.end].trim().to_owned(),
            decimal: quantity.decimal,
            size: quantity.unit,
            sign: match quantity.sign {
                Sign::Any => "any",
                Sign::NotNegative => "not negative",
                Sign::Positive => "positive",
            },
            place: quantity.place.map(|place| match place {
                Place::Beam => "beam",
                Place::Ground => "ground",
            }),
            usual: quantity.usual,
        }
    }

    /// Returns the index of the quantity from which a field of the model was read.
    pub fn behind(document: &Document, part: Part, field: &str) -> Option<usize> {
        let span = document.field_span(part, field)?;
        let quantities = &document.quantities;
        let found = quantities.binary_search_by_key(&span.start, |quantity| quantity.span.start);
        found.ok().filter(|&i| quantities[i].span == span)
    }
}

/// Reads the headings of a text line by line.
struct Headings<'t> {
    lines: std::iter::Peekable<std::str::SplitInclusive<'t, char>>,
    /// Byte position up to which lines have been read.
    end: usize,
    last: &'t str,
    counts: HashMap<&'t str, usize>,
}

impl<'t> Headings<'t> {
    fn of(text: &'t str) -> Self {
        let lines = text.split_inclusive('\n').peekable();
        Headings { lines, end: 0, last: "", counts: HashMap::new() }
    }

    /// Returns the last heading above a position, and its index among equal headings. The positions of
    /// successive calls must not decrease.
    fn above(&mut self, place: usize) -> (&'t str, usize) {
        while let Some(line) = self.lines.next_if(|line| self.end + line.len() <= place) {
            self.end += line.len();
            if let Some(heading) = heading(line.trim()) {
                self.last = heading;
                *self.counts.entry(heading).or_default() += 1;
            }
        }
        let which = self.counts.get(self.last).copied().unwrap_or_default();
        (self.last, if self.last.starts_with("[[") { which } else { 0 })
    }
}

/// Returns the heading of a line, such as `[beam]` for `[beam] # the footing`; `None` for a line that continues
/// a list.
fn heading(line: &str) -> Option<&str> {
    let end = line.rfind(']')?;
    let is_list = line[..end].contains(['=', ',', '"', '\'']);
    (line.starts_with('[') && !is_list).then_some(&line[..=end])
}

/// Table that converts byte positions to UTF-16 positions.
struct Utf16(Vec<usize>);

impl Utf16 {
    fn of(text: &str) -> Self {
        let mut units = Vec::with_capacity(text.len() + 1);
        let mut count = 0;
        for c in text.chars() {
            units.extend(std::iter::repeat_n(count, c.len_utf8()));
            count += c.len_utf16();
        }
        units.push(count);
        Utf16(units)
    }

    fn at(&self, byte: usize) -> usize {
        self.0[byte.min(self.0.len() - 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locations_of_numbers_count_utf16_units() {
        let text = "title = \"Größe 𝛽\"\n[beam]\nlength = \"12 m\"\nEI = \"1_000.5e3 kN m²\"\n\
                    [foundation]\nk = '40 MN/m^2'\n[[load]]\npoint = \" 5 kN\"\nat = \"1 m\"\n\
                    [[load]]\ndistributed = [\"1 kN/m\", \"2 kN/m\"]\n";
        let document = groundbeam_file::parse(text).unwrap();
        let wide: Vec<u16> = text.encode_utf16().collect();
        let seen: Vec<_> = Number::all(&document)
            .into_iter()
            .map(|n| {
                let digits = String::from_utf16(&wide[n.from..n.to]).unwrap();
                format!("{} {} {} = {digits} {} ({})", n.table, n.which, n.key, n.unit, n.size)
            })
            .collect();
        let expected = [
            "[beam] 0 length = 12 m (1)",
            "[beam] 0 EI = 1_000.5e3 kN m² (1000)",
            "[foundation] 0 k = 40 MN/m^2 (1000000)",
            "[[load]] 1 point = 5 kN (1000)",
            "[[load]] 1 at = 1 m (1)",
            "[[load]] 2 distributed = 1 kN/m (1000)",
            "[[load]] 2 distributed = 2 kN/m (1000)",
        ];
        assert_eq!(seen, expected);
        assert_eq!(Number::behind(&document, Part::Load(0), "at"), Some(4));
        assert_eq!(Number::behind(&document, Part::Load(1), "from"), None);
        let feet = "[beam]\nlength = \"12'-6\\\"\"\nEI = \"2 kip ft^2\"\n[foundation]\nk = \"1 ksf\"\n\
                    [[load]]\npoint = \"1 kip\"\nat = \"6\\\"\"\n";
        let document = groundbeam_file::parse(feet).unwrap();
        let all = Number::all(&document);
        let [length, .., at] = &all[..] else { panic!("{all:?}") };
        assert_eq!(&feet[length.from..length.to], "12'-6\\\"");
        assert_eq!((length.decimal, length.unit.as_str()), (Some((12.5, "ft")), ""));
        assert_eq!((at.decimal, at.unit.as_str()), (None, "\\\""));
        let plain = "[beam]\nlength = 2\nEI = 1.5e3\n[foundation]\nk = 0x10\n";
        let document = groundbeam_file::parse(plain).unwrap();
        let all = Number::all(&document);
        assert_eq!((all[1].key.as_str(), all[1].size), ("EI", 1.0));
    }
    /// Measures the time \[s\] of two steps on a file with `count` loads. The first step finds all numbers. The
    /// second step finds, for each load, the number that gives its position.
    fn time(count: usize) -> f64 {
        let load = "[[load]]\npoint = \"5 kN\"\nat = \"1 m\"\n".repeat(count);
        let text = format!(
            "[beam]\nlength = \"12 m\"\nEI = \"1 MN m^2\"\n[foundation]\nk = \"40 MPa\"\n{load}"
        );
        let document = groundbeam_file::parse(&text).unwrap();
        let started = std::time::Instant::now();
        let all = Number::all(&document);
        let behind = (0..count).map(|i| Number::behind(&document, Part::Load(i), "at"));
        assert!(behind.enumerate().all(|(i, found)| found == Some(3 + 2 * i + 1)));
        assert_eq!((all.len(), all[all.len() - 1].which), (3 + 2 * count, count));
        started.elapsed().as_secs_f64()
    }

    /// Linear growth multiplies the time by 16, quadratic growth by 256. The shortest of several runs excludes
    /// interruptions.
    #[test]
    fn the_time_is_proportional_to_the_number_of_loads() {
        let mut least = [f64::INFINITY; 2];
        for _ in 0..50 {
            least = [least[0].min(time(250)), least[1].min(time(4_000))];
            if least[1] < 80.0 * least[0] {
                return;
            }
        }
        panic!("{least:?}");
    }
}
