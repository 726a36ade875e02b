//! Suggests known words and keys that are similar to an unknown one.

use strsim::osa_distance;

/// Returns the most similar candidate within one edit per three letters (at least one edit). Case is ignored.
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
        // Words whose numbers of letters differ by n are at least n edits apart.
        if letters.abs_diff(length) > allowed {
            continue;
        }
        let distance = osa_distance(&lower, &candidate.to_lowercase());
        // A candidate of one or two letters resembles too many words. It is accepted only if it has two letters
        // and the written word has three, or if the two words differ only in case.
        let is_long_enough = letters > 2 || (letters == 2 && length == 3);
        let near = distance == 0 || (distance <= allowed && is_long_enough);
        if near && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Returns the three candidates most similar to the word `written`, the most similar first.
pub(crate) fn nearest_three<'c>(written: &str, candidates: &[&'c str]) -> Vec<&'c str> {
    let lower = written.to_lowercase();
    let mut ranked: Vec<(usize, &str)> = candidates
        .iter()
        .map(|candidate| (osa_distance(&lower, &candidate.to_lowercase()), *candidate))
        .collect();
    ranked.sort_by_key(|(distance, _)| *distance);
    ranked.into_iter().take(3).map(|(_, candidate)| candidate).collect()
}

/// Returns a hint with the most similar known word, followed by `otherwise` unless it contains `{}`. Without a similar
/// word, returns `otherwise` with all known words in place of `{}`.
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
