//! "Did you mean …?"

/// The candidate nearest to what was written, if one is near enough to be meant.
///
/// A difference in case alone always counts as near; otherwise one edit in three letters.
pub(crate) fn nearest<'c>(
    written: &str,
    candidates: impl IntoIterator<Item = &'c str>,
) -> Option<&'c str> {
    let lower = written.to_lowercase();
    let allowed = (written.chars().count() / 3).max(1);
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let distance = if candidate.to_lowercase() == lower {
            0
        } else {
            edits(&lower, &candidate.to_lowercase())
        };
        // A word of one or two letters is one edit away from too many others, unless the edit
        // takes away a letter too much.
        let letters = candidate.chars().count();
        let is_long_enough = letters > 2 || (letters == 2 && written.chars().count() == 3);
        let near = distance == 0 || (distance <= allowed && is_long_enough);
        if near && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// How many letters must be added, removed, changed or swapped with a neighbour.
fn edits(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().collect();
    let b: Vec<char> = b.chars().collect();
    if a.len().abs_diff(b.len()) > 8 {
        return usize::MAX; // far apart, and nobody waits for a table of a long text's size
    }
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let changed = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut least = changed.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    least = least.min(rows[i - 2][j - 2] + 1);
                }
                least
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn edits_are_counted() {
        assert_eq!(edits("", "abc"), 3);
        assert_eq!(edits("ab", "ba"), 1);
        assert_eq!(edits("kitten", "sitting"), 3);
    }
}
