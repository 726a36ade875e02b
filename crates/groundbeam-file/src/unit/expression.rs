//! Parses products, quotients and powers of unit symbols in the notations that engineers use.
//!
//! Examples are `kN/m²`, `kN m`, `kNm`, `kN·m`, `kip-ft`, `kN/m/m`, `kN/(m rad)`, `kN m-2`, `mm4` and `1/m`.

use super::{Dimension, Marks, Scale, symbol};
use crate::code;
use crate::fault::Fault;
use crate::suggest::nearest;

/// Largest allowed exponent of a unit. The limit keeps the integers in conversion factors small.
const HIGHEST_POWER: i32 = 12;
/// Maximum depth of nested parentheses.
const DEEPEST: usize = 8;
const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// A unit with its conversion factor to N, m and rad, its dimension and its flags.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit {
    pub scale: Scale,
    pub dimension: Dimension,
    pub marks: Marks,
}

impl Unit {
    const ONE: Unit = Unit { scale: Scale::ONE, dimension: Dimension::NONE, marks: Marks::NONE };

    /// Parses the whole of `text`, which must not be blank.
    pub fn read(text: &str) -> Result<Unit, Fault> {
        let mut reader = Reader { text, at: 0 };
        let unit = reader.product(0)?;
        match reader.peek() {
            None => Ok(unit),
            Some(_) => Err(reader.unexpected("this closing parenthesis has no opening one")),
        }
    }

    fn times(self, other: Unit, power: i32) -> Unit {
        Unit {
            scale: self.scale.times(other.scale, power),
            dimension: self.dimension.times(other.dimension, power),
            marks: self.marks.with(other.marks),
        }
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
}

impl Reader<'_> {
    fn product(&mut self, depth: usize) -> Result<Unit, Fault> {
        let mut unit = Unit::ONE.times(self.factor(depth)?, 1);
        let mut divided = false;
        loop {
            self.skip_spaces();
            match self.peek() {
                None | Some(')') => return Ok(unit),
                Some('/') => {
                    self.advance();
                    unit = unit.times(self.factor(depth)?, -1);
                    divided = true;
                }
                Some(next) => {
                    if is_product_sign(next) {
                        self.advance();
                        self.skip_spaces();
                    }
                    let start = self.at;
                    let factor = self.factor(depth)?;
                    if divided {
                        return Err(self.ambiguous(start));
                    }
                    unit = unit.times(factor, 1);
                }
            }
        }
    }

    /// Parses a symbol or a parenthesis, with its exponent.
    fn factor(&mut self, depth: usize) -> Result<Unit, Fault> {
        self.skip_spaces();
        if self.at == 0 && self.text.starts_with('1') {
            // A unit may begin with 1, as in `1/m`.
            self.advance();
            return Ok(Unit::ONE);
        }
        if self.peek() == Some('(') {
            if depth == DEEPEST {
                return Err(self.unexpected("too many nested parentheses"));
            }
            self.advance();
            let unit = self.product(depth + 1)?;
            if self.peek() != Some(')') {
                return Err(self.unexpected("a closing parenthesis is missing here"));
            }
            self.advance();
            return Ok(Unit::ONE.times(unit, self.power()?));
        }
        let start = self.at;
        while self.peek().is_some_and(is_symbol_letter) {
            self.advance();
        }
        let word = &self.text[start..self.at];
        if let Some(power) = Self::power_in_words(word) {
            // The unit begins with a separate word, as in "sq ft" or "cu in".
            self.skip_spaces();
            let from = self.at;
            while self.peek().is_some_and(is_symbol_letter) {
                self.advance();
            }
            let (first, last) = self.symbols(from, &self.text[from..self.at])?;
            return Ok(first.times(last, power));
        }
        if word.is_empty() {
            return Err(self.unexpected("a unit is expected here"));
        }
        // In "kNm2" the exponent belongs to the metre.
        let (first, last) = self.symbols(start, word)?;
        Ok(first.times(last, self.power()?))
    }

    /// Returns the exponent that the word `sq` or `cu` before a length stands for.
    fn power_in_words(word: &str) -> Option<i32> {
        match word {
            "sq" => Some(2),
            "cu" => Some(3),
            _ => None,
        }
    }

    /// Parses one symbol, or a force and a length in one word, such as `kNm`. Returns two units, of which the
    /// first is 1 if there is only one symbol.
    fn symbols(&self, start: usize, word: &str) -> Result<(Unit, Unit), Fault> {
        let unit = |(scale, dimension, marks)| Unit { scale, dimension, marks };
        if let Some(known) = symbol::look_up(word) {
            return Ok((Unit::ONE, unit(known)));
        }
        // The word contains the exponent, as in "sqft" or "cuin".
        if let Some((power, known)) = word.split_at_checked(2).and_then(|(words, length)| {
            let known = symbol::look_up(length).filter(|known| known.1 == Dimension::LENGTH);
            Self::power_in_words(words).zip(known)
        }) {
            return Ok((Unit::ONE, Unit::ONE.times(unit(known), power)));
        }
        // At the start of a word such as `kNm`, the letter `k` is a prefix and not the force kip.
        for (i, _) in word.char_indices().skip(1).filter(|(i, _)| !word[..*i].eq("k")) {
            let halves = symbol::look_up(&word[..i]).zip(symbol::look_up(&word[i..]));
            if let Some((force, length)) = halves
                && force.1 == Dimension::FORCE
                && length.1 == Dimension::LENGTH
            {
                return Ok((unit(force), unit(length)));
            }
        }
        Err(unknown(start, word))
    }

    /// Parses the exponent after a symbol; the exponent is 1 if none is written.
    fn power(&mut self) -> Result<i32, Fault> {
        let start = self.at;
        let rest = self.text[self.at..].trim_start();
        let marked = ["^", "**"].iter().find(|sign| rest.starts_with(**sign));
        if let Some(sign) = marked {
            self.at = self.text.len() - rest.len() + sign.len();
            self.skip_spaces();
        }
        let raised = self.peek().is_some_and(|c| c == '⁻' || superscript(c).is_some());
        let before_sign = self.at;
        let negative = self.peek().is_some_and(|c| is_minus(c) || c == '⁻');
        if negative || (marked.is_some() && self.peek() == Some('+')) {
            self.advance();
        }
        let mut power = None;
        while let Some(digit) =
            self.peek().and_then(|c| if raised { superscript(c) } else { c.to_digit(10) })
        {
            let so_far = power.unwrap_or(0_i32);
            power = Some(so_far.saturating_mul(10).saturating_add(digit as i32));
            self.advance();
        }
        let Some(power) = power else {
            if marked.is_some() || raised {
                return Err(self.unexpected("the exponent must be a whole number"));
            }
            self.at = before_sign; // a minus sign between two symbols: kip-ft
            return Ok(1);
        };
        let mut after = self.text[self.at..].chars();
        let fraction =
            after.next() == Some('.') && after.next().is_some_and(|c| c.is_ascii_digit());
        if fraction || power > HIGHEST_POWER {
            let message = "a unit cannot have this exponent";
            let hint =
                format!("exponents are whole numbers up to {HIGHEST_POWER}, as in \"0.04 m^4\"");
            return Err(Fault::new(code::UNIT_SYNTAX, start..self.at, message, "", hint));
        }
        Ok(if negative { -power } else { power })
    }

    fn ambiguous(&self, start: usize) -> Fault {
        let factor = self.text[start..self.at].trim_end();
        Fault::new(
            code::UNIT_SYNTAX,
            start..start + factor.len(),
            format!("it is unclear whether `{factor}` multiplies or divides"),
            "after a `/`",
            "put a divisor in parentheses, as in \"kN/(m rad)\", or write it last, as in \
             \"kN m/rad\"",
        )
    }

    fn unexpected(&self, label: &str) -> Fault {
        let width = self.peek().map_or(0, char::len_utf8);
        Fault::new(
            code::UNIT_SYNTAX,
            self.at..self.at + width,
            "this unit cannot be read",
            label,
            "write units as in \"20 kN/m\", \"40 MN/m^2\" or \"50 kN m\"",
        )
    }

    fn peek(&self) -> Option<char> {
        self.text[self.at..].chars().next()
    }

    fn advance(&mut self) {
        self.at += self.peek().map_or(0, char::len_utf8);
    }

    fn skip_spaces(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.advance();
        }
    }
}

fn unknown(start: usize, word: &str) -> Fault {
    let suggested =
        symbol::symbol_for_name(word).or_else(|| nearest(word, symbol::COMMON.iter().copied()));
    let hint = match (symbol::advice(word), suggested) {
        (Some(advice), _) => advice.to_owned(),
        (None, Some(symbol)) => format!("did you mean `{symbol}`?"),
        (None, None) => "units consist of m, N, Pa, rad with prefixes (mm, kN, MPa), or of in, \
                         ft, lbf, kip, psi, ksi, pci and the like"
            .to_owned(),
    };
    let at = start..start + word.len();
    Fault::new(code::UNKNOWN_UNIT, at, format!("the unit `{word}` is not known"), "", hint)
}

fn is_product_sign(c: char) -> bool {
    matches!(c, '*' | '·' | '⋅' | '×' | '.' | '-')
}

fn is_minus(c: char) -> bool {
    matches!(c, '-' | '\u{2212}')
}

fn is_symbol_letter(c: char) -> bool {
    !(c.is_whitespace()
        || c.is_ascii_digit()
        || is_product_sign(c)
        || is_minus(c)
        || matches!(c, '/' | '^' | '(' | ')' | '+' | ',' | ';' | '⁻')
        || superscript(c).is_some())
}

fn superscript(c: char) -> Option<u32> {
    SUPERSCRIPTS.iter().position(|&s| s == c).map(|digit| digit as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_unit_in_many_spellings() {
        let spellings: &[&[&str]] = &[
            &[
                "kN/m^2",
                "kN/m2",
                "kN/m²",
                "kN/m**2",
                "kN m^-2",
                "kN m-2",
                "kN·m⁻²",
                "kN/m/m",
                "kN/(m m)",
                "kN / m ^ 2",
                "kPa",
                "kN m\u{2212}2",
            ],
            &[
                "kN m", "kNm", "kN·m", "kN⋅m", "kN×m", "kN*m", "kN.m", "kN-m", "m kN", "(kN m)",
                "kN  m",
            ],
            &["kN m^2", "kNm²", "kNm2", "kN*m*m", "kN m m", "(kN^2 m^4)/kN/m^2"],
            &["kN m/rad", "kNm/rad", "kN/rad m^0/m^-1"],
            &["kip-ft", "kip ft", "kipft", "kip*ft", "k-ft", "ft-k", "ft-kips", "kip-feet", "k ft"],
            &["lbf ft", "lb-ft", "ft-lb", "ft-lbs", "lb ft"],
            &["psi", "lb/in2", "lb/sq in", "lb/sqin", "lb/in^2", "lb/in²", "#/in2"],
            &["ksf", "k/ft2", "kips/sq ft", "kip/ft^2"],
            &["pci", "lb/cu in", "lb/in3", "psi/in", "lb/in/in/in"],
            &["tcf", "tsf/ft"],
            &["klf", "kips/ft", "k/ft", "kip/ft"],
        ];
        for same in &spellings[..3] {
            let of = |text| Unit { marks: Marks::NONE, ..Unit::read(text).unwrap() };
            for other in *same {
                assert_eq!(of(other), of(same[0]), "{other}");
            }
        }
        let size = |text| {
            let unit = Unit::read(text).unwrap();
            let (a, b) = unit.scale.fraction().unwrap();
            (a as f64 / b as f64 * 10_f64.powi(unit.scale.ten()), unit.dimension)
        };
        for same in &spellings[4..] {
            let (first, dimension) = size(same[0]);
            for other in *same {
                let (found, of) = size(other);
                assert!((found / first - 1.0).abs() < 1e-15 && of == dimension, "{other}");
            }
        }
    }

    #[test]
    fn faults_point_at_their_characters() {
        let cases = [
            ("kN//m", code::UNIT_SYNTAX, 3..4),
            ("kN/", code::UNIT_SYNTAX, 3..3),
            ("kN/m^", code::UNIT_SYNTAX, 5..5),
            ("m^x", code::UNIT_SYNTAX, 2..3),
            ("m^0.5", code::UNIT_SYNTAX, 1..3),
            ("m^99999999999", code::UNIT_SYNTAX, 1..13),
            ("(kN m", code::UNIT_SYNTAX, 5..5),
            ("kN m)", code::UNIT_SYNTAX, 4..5),
            ("((((((((((m", code::UNIT_SYNTAX, 8..9),
            ("MN/m^2 m", code::UNIT_SYNTAX, 7..8),
            ("kN/m·rad", code::UNIT_SYNTAX, 6..9),
            ("kN, m", code::UNIT_SYNTAX, 2..3),
            ("kN furlong", code::UNKNOWN_UNIT, 3..10),
            ("½m", code::UNKNOWN_UNIT, 0..3),
        ];
        for (text, code, at) in cases {
            let fault = Unit::read(text).unwrap_err();
            assert_eq!((fault.code, fault.at), (code, at), "{text}");
        }
    }

    #[test]
    fn unknown_units_come_with_a_suggestion() {
        let cases = [
            ("kn", "did you mean `kN`?"),
            ("MPA", "did you mean `MPa`?"),
            ("metres", "did you mean `m`?"),
            ("thou", "did you mean `mil`?"),
        ];
        for (text, hint) in cases {
            assert_eq!(Unit::read(text).unwrap_err().hint, hint);
        }
        let advised = [
            ("t", "tf"),
            ("t/m", "tf"),
            ("kg/cm2", "kgf"),
            ("ton", "8.896 kN"),
            ("T", "2240 lbf"),
            ("ton/ft2", "9.807 kN"),
            ("mi", "5280 ft"),
            ("atm", "101.325 kPa"),
            ("F", "°F"),
            ("Mp", "tf"),
        ];
        for (text, words) in advised {
            let hint = Unit::read(text).unwrap_err().hint;
            assert!(hint.contains(words), "{text}: {hint}");
        }
    }
}
