//! Suggests known words and keys that are similar to an unknown one.

use strsim::osa_distance;

/// The candidate most similar to the written word, if one is similar enough.
///
/// Words that differ only in case are always similar. Otherwise one edit per three letters is allowed.
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
        // At least this number of letters must be added or removed.
        if letters.abs_diff(length) > allowed {
            continue;
        }
        let distance = osa_distance(&lower, &candidate.to_lowercase());
        // A word of one or two letters is one edit away from too many others. Only the removal of one extra
        // letter is accepted.
        let is_long_enough = letters > 2 || (letters == 2 && length == 3);
        let near = distance == 0 || (distance <= allowed && is_long_enough);
        if near && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Up to three candidates most similar to the written word, the best first.
pub(crate) fn nearest_three<'c>(written: &str, candidates: &[&'c str]) -> Vec<&'c str> {
    let lower = written.to_lowercase();
    let mut ranked: Vec<(usize, &str)> = candidates
        .iter()
        .map(|candidate| (osa_distance(&lower, &candidate.to_lowercase()), *candidate))
        .collect();
    ranked.sort_by_key(|(distance, _)| *distance);
    ranked.into_iter().take(3).map(|(_, candidate)| candidate).collect()
}

/// Hint: the similar known word, or the text `otherwise` with all known words in place of `{}`. A text
/// without `{}` always follows.
pub(crate) fn advice(written: &str, known: &[&str], otherwise: &str) -> String {
    let explains = !otherwise.is_empty() && !otherwise.contains("{}");
    match nearest(written, known.iter().copied()) {
        Some(meant) if explains => format!("did you mean `{meant}`? {otherwise}"),
        Some(meant) => format!("did you mean `{meant}`?"),
        None => otherwise.replace("{}", &known.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_name_gets_three_suggestions() {
        let names = ["6.10: 1.35 G", "6.10: G + 1.5 Q", "6.10: 1.35 G + 1.5 Q", "EQU: 0.9 G"];
        let near = nearest_three("6.10: 1.35 G + 1.5 W", &names);
        assert_eq!(near, [names[2], names[1], names[0]]);
    }

    #[test]
    fn only_similar_words_are_suggested() {
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
}
