//! "Did you mean …?": known words and keys near to what was written.

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

/// The three candidates nearest to what was written, the nearest first; fewer if there are fewer.
pub(crate) fn nearest_three<'c>(written: &str, candidates: &[&'c str]) -> Vec<&'c str> {
    let lower = written.to_lowercase();
    let mut ranked: Vec<(usize, &str)> = candidates
        .iter()
        .map(|candidate| (osa_distance(&lower, &candidate.to_lowercase()), *candidate))
        .collect();
    ranked.sort_by_key(|(distance, _)| *distance);
    ranked.into_iter().take(3).map(|(_, candidate)| candidate).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_names_answer_an_unknown_one() {
        let names = ["6.10: 1.35 G", "6.10: G + 1.5 Q", "6.10: 1.35 G + 1.5 Q", "EQU: 0.9 G"];
        let near = nearest_three("6.10: 1.35 G + 1.5 W", &names);
        assert_eq!(near, [names[2], names[1], names[0]]);
    }

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
}
