//! Hints for numbers and units that cannot be read: commas in numbers, densities in place of unit weights.

/// Hint for a density where a force per volume is expected.
pub(crate) const DENSITY: &str =
    "a unit weight is a force per volume: 2400 kg/m3 × 9.80665 m/s2 = 23.536 kN/m3";

/// Whether a unit is a mass per volume.
pub(crate) fn is_density(unit: &str) -> bool {
    ["kg", "t", "lbm"].iter().any(|mass| {
        let per = unit.strip_prefix(mass).and_then(|rest| rest.trim_start().strip_prefix('/'));
        per.is_some_and(|volume| volume.contains(['3', '³']))
    })
}

/// Returns a hint on how to write a number that has a comma after `whole`. Three digits after a comma may be
/// thousands or decimals, so the hint offers both readings.
pub(crate) fn without_comma(whole: &str, after: &str) -> String {
    let mut thousands = whole.to_owned();
    let mut rest = after;
    loop {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let (group, further) = rest.split_at(digits);
        if digits != 3 {
            return format!("write a decimal point: {whole}.{group}");
        }
        thousands += group;
        match further.strip_prefix(',') {
            Some(next) => rest = next,
            None => {
                let is_decimal = further.strip_prefix('.').map(|part| part.bytes());
                let part = is_decimal.map(|part| part.take_while(u8::is_ascii_digit).count());
                return match part.filter(|count| *count > 0) {
                    Some(count) => format!(
                        "a number must not contain a comma: write {thousands}{}",
                        &further[..=count]
                    ),
                    None if rest.len() < after.len() => {
                        format!("a number must not contain a comma: write {thousands}")
                    }
                    None => format!(
                        "a number must not contain a comma: write {thousands}, or {whole}.{group} if \
                         the comma is a decimal comma"
                    ),
                };
            }
        }
    }
}
