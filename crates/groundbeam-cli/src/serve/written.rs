//! Where in the text the page changes a number: the text is the only thing that is changed.

use groundbeam::model::Part;
use groundbeam_file::{Document, Quantity};
use serde::Serialize;

/// A quantity of the text, with places as a browser counts them.
#[derive(Debug, Serialize)]
pub struct Number {
    key: String,
    /// The heading of the table it stands in: `[beam]`, `[[load]]`.
    table: String,
    /// Which one of the tables of that heading, from 1; 0 where there is only one.
    which: usize,
    /// Of the number alone, in UTF-16 units.
    from: usize,
    to: usize,
    /// The unit behind it, as it is written.
    unit: String,
    /// What the number counts, in SI units.
    size: f64,
}

impl Number {
    /// All quantities of a file, in the order of the text.
    pub fn all(document: &Document) -> Vec<Number> {
        let text = document.text();
        let units = Utf16::of(text);
        document.quantities.iter().map(|quantity| Number::of(quantity, text, &units)).collect()
    }

    fn of(quantity: &Quantity, text: &str, units: &Utf16) -> Number {
        let (table, which) = heading(text, quantity.span.start);
        let behind = text[quantity.number.end..quantity.span.end].trim_end_matches(['"', '\'']);
        Number {
            key: quantity.key.clone(),
            table: table.to_owned(),
            which,
            from: units.at(quantity.number.start),
            to: units.at(quantity.number.end),
            unit: behind.trim().to_owned(),
            size: quantity.unit,
        }
    }

    /// Which of the quantities a field of the model was read from.
    pub fn behind(document: &Document, part: Part, field: &str) -> Option<usize> {
        let span = document.field_span(part, field)?;
        document.quantities.iter().position(|quantity| quantity.span == span)
    }
}

/// The last heading above a place, and which of its kind it is.
fn heading(text: &str, place: usize) -> (&str, usize) {
    let headings = text[..place].lines().filter_map(|line| {
        let line = line.trim();
        let end = line.rfind(']')?;
        let is_list = line[..end].contains(['=', ',', '"', '\'']);
        (line.starts_with('[') && !is_list).then_some(&line[..=end])
    });
    let headings: Vec<&str> = headings.collect();
    let Some(&last) = headings.last() else { return ("", 0) };
    let which = headings.iter().filter(|heading| **heading == last).count();
    (last, if last.starts_with("[[") { which } else { 0 })
}

/// From bytes of a text to the units that a browser counts.
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
    fn numbers_are_found_where_a_browser_finds_them() {
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
        let plain = "[beam]\nlength = 2\nEI = 1.5e3\n[foundation]\nk = 0x10\n";
        let document = groundbeam_file::parse(plain).unwrap();
        let all = Number::all(&document);
        assert_eq!((all[1].key.as_str(), all[1].size), ("EI", 1.0));
    }
}
