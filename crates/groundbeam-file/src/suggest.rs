//! "Did you mean …?": known words and keys near to what was written.

use crate::keys::Key;
use strsim::osa_distance;

/// The candidate nearest to what was written, if one is near enough to be meant.
///
/// A difference in case alone always counts as near; otherwise one edit in three letters.
pub(crate) fn nearest<'c>(
    written: &str,
    candidates: impl IntoIterator<Item = &'c str>,
) -> Option<&'c str> {
    let lower = written.to_lowercase();
    let length = written.chars().count();
    let allowed = (length / 3).max(1);
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let letters = candidate.chars().count();
        // So many letters must be added or removed at least.
        if letters.abs_diff(length) > allowed {
            continue;
        }
        let distance = osa_distance(&lower, &candidate.to_lowercase());
        // A word of one or two letters is one edit away from too many others, unless the edit
        // takes away a letter too much.
        let is_long_enough = letters > 2 || (letters == 2 && length == 3);
        let near = distance == 0 || (distance <= allowed && is_long_enough);
        if near && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// What to write instead: the known word that is near, or the advice, in which all known words stand for `{}`. Advice that
/// does not list them says what they mean and follows either way.
pub(crate) fn advice(written: &str, known: &[&str], otherwise: &str) -> String {
    let explains = !otherwise.is_empty() && !otherwise.contains("{}");
    match nearest(written, known.iter().copied()) {
        Some(meant) if explains => format!("did you mean `{meant}`? {otherwise}"),
        Some(meant) => format!("did you mean `{meant}`?"),
        None => otherwise.replace("{}", &known.join(", ")),
    }
}

/// The key that someone who writes `written` probably means.
pub(crate) fn key(written: &str, keys: &[&Key]) -> Option<&'static str> {
    let lower = written.to_lowercase();
    let other = || keys.iter().find(|key| key.also.contains(&lower.as_str()));
    let near = nearest(written, keys.iter().map(|key| key.name));
    near.or_else(|| other().map(|key| key.name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::{Value, key};

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let keys = ["length", "axial_force", "EI", "E", "I", "section"];
        assert_eq!(nearest("lenght", keys), Some("length"));
        assert_eq!(nearest("Length", keys), Some("length"));
        assert_eq!(nearest("axialforce", keys), Some("axial_force"));
        assert_eq!(nearest("ei", keys), Some("EI"));
        assert_eq!(nearest("EII", keys), Some("EI"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest("a", keys), None);
        assert_eq!(nearest("", keys), None);
    }

    #[test]
    fn slips_and_other_names_lead_to_the_key() {
        let [length, stiffness, load, shear] = [
            key("length", Value::Flag, ""),
            key("EI", Value::Flag, "").also(&["bending_stiffness"]),
            key("load", Value::Flag, ""),
            key("mu", Value::Flag, "").also(&["shear"]),
        ];
        let meant = |written| super::key(written, &[&length, &stiffness, &load, &shear]);
        assert_eq!(meant("lenght"), Some("length"));
        assert_eq!(meant("ei"), Some("EI"));
        assert_eq!(meant("bending_stiffness"), Some("EI"));
        assert_eq!(meant("shear"), Some("mu"));
        assert_eq!(meant("loads"), Some("load"));
        assert_eq!(meant("colour"), None);
    }
}
