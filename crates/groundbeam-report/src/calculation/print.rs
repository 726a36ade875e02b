//! Typesets words, numbers and units for print.

use crate::number::MINUS;
use crate::quantity::is_unit;

/// Typesets a sentence with true minus signs, superscript powers of ten, no-break spaces before units, and μ
/// for `mu`.
pub(super) fn words(said: &str) -> String {
    let mut printed = String::with_capacity(said.len());
    for (i, word) in said.split(' ').enumerate() {
        let follows_number = printed.ends_with(|c: char| c.is_ascii_digit() || is_raised(c));
        if i > 0 {
            let bare = word.trim_end_matches([',', '.', ';', ':', ')']);
            let joined = follows_number && (is_unit(bare) || ["%", "l"].contains(&bare));
            // The words before and after a space can form one unit, such as kN m.
            let (_, before) = printed.rsplit_once(['\u{a0}', ' ']).unwrap_or(("", &printed));
            let second = is_unit(&format!("{before} {bare}"));
            printed.push(if joined || second { '\u{a0}' } else { ' ' });
        }
        printed += &cell(&greek(word));
    }
    printed
}

/// Replaces `mu`, alone or in a quotient, by μ.
fn greek(word: &str) -> String {
    match word {
        "mu" => "μ".to_owned(),
        "mu/b" => "μ/b".to_owned(),
        _ => word.replace("√(mu/k)", "√(μ/k)"),
    }
}

/// Returns the text of a number or of a table cell with typeset minus signs and powers of ten.
pub(super) fn cell(word: &str) -> String {
    let mut printed = String::with_capacity(word.len());
    let letters: Vec<char> = word.chars().collect();
    let mut i = 0;
    while i < letters.len() {
        let before = if i > 0 { letters[i - 1] } else { ' ' };
        let after = letters.get(i + 1).copied().unwrap_or(' ');
        let power = power_of_ten(&letters[i..]);
        if letters[i] == '-' && after.is_ascii_digit() && !before.is_alphanumeric() {
            printed.push('\u{2212}');
            i += 1;
        } else if let (true, Some((power, length))) = (ends_in_number(&letters[..i]), power) {
            printed += "·10";
            printed += &power;
            i += length;
        } else {
            printed.push(letters[i]);
            i += 1;
        }
    }
    printed
}

/// Whether a word ends in a number. Digits after a letter, as in the digest `4e10198`, are not a number.
fn ends_in_number(letters: &[char]) -> bool {
    let is_part = |c: &&char| c.is_ascii_digit() || **c == '.';
    let length = letters.iter().rev().take_while(is_part).count();
    let before = letters.len().checked_sub(length + 1).map(|i| letters[i]);
    length > 0 && !before.is_some_and(char::is_alphanumeric)
}

/// Returns an exponent such as `e-13` at the start of `letters` as a superscript, and its length. Returns `None` if
/// there is no exponent or a letter follows.
fn power_of_ten(letters: &[char]) -> Option<(String, usize)> {
    let ['e', rest @ ..] = letters else { return None };
    let sign = usize::from(rest.first().is_some_and(|sign| ['-', MINUS].contains(sign)));
    let digits = rest[sign..].iter().take_while(|c| c.is_ascii_digit()).count();
    let next = rest.get(sign + digits);
    if digits == 0 || next.is_some_and(|c| c.is_alphanumeric()) {
        return None;
    }
    let raised = rest[..sign + digits].iter().map(|&c| raised(c)).collect();
    Some((raised, 1 + sign + digits))
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

fn raised(c: char) -> char {
    c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize])
}

fn is_raised(c: char) -> bool {
    RAISED.contains(&c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::units;

    #[test]
    fn numbers_and_units_are_formatted_for_print() {
        assert_eq!(cell("-1.5e-13"), "−1.5·10⁻¹³");
        assert_eq!(
            words("accurate to ± 7e-16 m everywhere"),
            "accurate to ± 7·10⁻¹⁶\u{a0}m everywhere"
        );
        assert_eq!(words("mu = 9 MN, 65 kN m of"), "μ = 9\u{a0}MN, 65\u{a0}kN\u{a0}m of");
        for unit in units().chain(["kN m/rad"]) {
            let said = format!("of 12.5 {unit}, and");
            let whole = format!("of 12.5\u{a0}{}, and", unit.replace(' ', "\u{a0}"));
            assert_eq!(words(&said), whole);
        }
        // The hexadecimal digits at the end of a digest are not typeset as a power of ten.
        assert_eq!(words("SHA-256 1714e4334d4e10198e5"), "SHA-256 1714e4334d4e10198e5");
        // Names and words that look like numbers stay unchanged.
        assert_eq!(words("pile-7 type e4, active-set"), "pile-7 type e4, active-set");
    }
}
