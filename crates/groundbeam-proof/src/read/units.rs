//! Reads units as engineers write them: products and powers of symbols.

use super::symbols::{FORCE, LENGTH, symbol};
use super::unit::Unit;

impl Unit {
    /// Reads a unit as engineers write it: `kN/m^2`, `kN m`, `kNm`, `kip-ft`, `kN/(m rad)`, `1/m`.
    pub fn read(text: &str) -> Option<Unit> {
        let mut reader = Reader { rest: text.trim() };
        let unit = reader.product(0)?;
        reader.rest.is_empty().then_some(unit)
    }
}

/// Maximum depth of nested parentheses.
const DEEPEST: usize = 8;
/// Maximum exponent of a unit symbol, such as 2 in `m^2`.
const HIGHEST_POWER: i32 = 12;
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

struct Reader<'t> {
    rest: &'t str,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn take(&mut self, wanted: &str) -> bool {
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Reads a product of factors that are separated by spaces, multiplication signs or `/`. After the first `/`, a `/`
    /// must precede every further factor.
    fn product(&mut self, depth: usize) -> Option<Unit> {
        let mut unit = self.first(depth)?;
        let mut divided = false;
        loop {
            self.rest = self.rest.trim_start();
            match self.peek() {
                None | Some(')') => return Some(unit),
                Some('/') => {
                    self.take("/");
                    unit = unit.times(self.factor(depth)?, -1)?;
                    divided = true;
                }
                Some(_) if divided => return None,
                Some(next) => {
                    if "*·⋅×.-".contains(next) {
                        self.rest = self.rest.get(next.len_utf8()..)?;
                    }
                    unit = unit.times(self.factor(depth)?, 1)?;
                }
            }
        }
    }

    /// Reads the first factor of a unit, which may be the 1 of `1/m`.
    fn first(&mut self, depth: usize) -> Option<Unit> {
        let after = self.rest.strip_prefix('1').map(str::trim_start);
        match after {
            Some(after) if depth == 0 && after.starts_with('/') => {
                self.rest = after;
                Some(Unit::ONE)
            }
            _ => self.factor(depth),
        }
    }

    /// Reads a factor with its power: a symbol, two symbols in one word, or a product in parentheses.
    fn factor(&mut self, depth: usize) -> Option<Unit> {
        self.rest = self.rest.trim_start();
        if self.take("(") {
            if depth == DEEPEST {
                return None;
            }
            let unit = self.product(depth + 1)?;
            if !self.take(")") {
                return None;
            }
            return Unit::ONE.times(unit, self.power()?);
        }
        let end = self.rest.find(|c| !is_letter(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at_checked(end)?;
        self.rest = rest;
        if let Some(power) = power_in_words(word) {
            // `sq ft`, `cu in`
            self.rest = self.rest.trim_start();
            let end = self.rest.find(|c| !is_letter(c)).unwrap_or(self.rest.len());
            let (word, rest) = self.rest.split_at_checked(end)?;
            self.rest = rest;
            return Unit::ONE.times(symbol(word)?, power);
        }
        let power = self.power()?;
        if let Some(unit) = symbol(word) {
            return Unit::ONE.times(unit, power);
        }
        // `sqft`
        let in_words = word.split_at_checked(2).and_then(|(words, length)| {
            let length = symbol(length).filter(|length| length.dimension == LENGTH)?;
            Unit::ONE.times(length, power_in_words(words)?)
        });
        if let Some(unit) = in_words {
            return Unit::ONE.times(unit, power);
        }
        // A word such as `kNm` is a unit of force times a unit of length, and an exponent applies to the length only.
        // The symbol `k` for kip must not begin such a word.
        word.char_indices().skip(1).find_map(|(i, _)| {
            let (force, length) = word.split_at_checked(i).filter(|(force, _)| *force != "k")?;
            let (force, length) = (symbol(force)?, symbol(length)?);
            let is_moment = force.dimension == FORCE && length.dimension == LENGTH;
            if is_moment { force.times(length, power) } else { None }
        })
    }

    /// Reads the power after a factor; the power is 1 if none is given.
    fn power(&mut self) -> Option<i32> {
        let after = self.rest.trim_start();
        let marked = after.strip_prefix('^').or(after.strip_prefix("**"));
        let mut rest = marked.map_or(self.rest, str::trim_start);
        let is_raised = rest.starts_with(|c| c == '⁻' || RAISED.contains(&c));
        let negative = rest.starts_with(['-', '\u{2212}', '⁻']);
        if negative || (marked.is_some() && rest.starts_with('+')) {
            let sign = rest.chars().next()?;
            rest = rest.get(sign.len_utf8()..)?;
        }
        let digit = |c: char| match is_raised {
            true => RAISED.iter().position(|raised| *raised == c).map(|digit| digit as i32),
            false => c.to_digit(10).map(|digit| digit as i32),
        };
        let mut power = None;
        while let Some((c, digit)) = rest.chars().next().and_then(|c| Some((c, digit(c)?))) {
            power = Some((10 * power.unwrap_or(0) + digit).min(1000));
            rest = rest.get(c.len_utf8()..)?;
        }
        let Some(power) = power else {
            // Without digits after it, a minus sign separates two symbols.
            return if marked.is_some() || is_raised { None } else { Some(1) };
        };
        let fraction =
            rest.strip_prefix('.').is_some_and(|r| r.starts_with(|c: char| c.is_ascii_digit()));
        self.rest = rest;
        (power <= HIGHEST_POWER && !fraction).then_some(if negative { -power } else { power })
    }
}

/// The exponent that a word such as `sq` gives to the unit of length after it.
fn power_in_words(word: &str) -> Option<i32> {
    match word {
        "sq" => Some(2),
        "cu" => Some(3),
        _ => None,
    }
}

fn is_letter(c: char) -> bool {
    !(c.is_whitespace()
        || c.is_ascii_digit()
        || "*·⋅×.-\u{2212}/^()+,;⁻".contains(c)
        || RAISED.contains(&c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_unit_in_many_spellings() {
        let groups: [&[&str]; 4] = [
            &["kN/m^2", "kN/m2", "kN/m²", "kN/m**2", "kN m^-2", "kN m-2", "kN·m⁻²", "kN/m/m"],
            &["kN m", "kNm", "kN·m", "kN*m", "kN.m", "kN-m", "m kN", "(kN m)", "kN  m"],
            &["kN m^2", "kNm²", "kNm2", "(kN^2 m^4)/kN/m^2"],
            &["kip-ft", "kip ft", "kipft", "kip*ft", "ft kip"],
        ];
        for group in groups {
            for unit in group {
                assert_eq!(Unit::read(unit), Unit::read(group[0]), "{unit}");
            }
        }
        assert_eq!(Unit::read("1/m"), Unit::read("m^-1"));
        for wrong in [
            "",
            "kN/",
            "kN//m",
            "kN/m^",
            "m^x",
            "m^0.5",
            "m^13",
            "(kN m",
            "kN m)",
            "MN/m^2 m",
            "kN, m",
            "furlong",
            "1",
            "1 m",
            "2/m",
            "kn",
            "kin",
            "kkN",
            "((((((((((m))))))))))",
        ] {
            assert_eq!(Unit::read(wrong), None, "{wrong}");
        }
    }
}
