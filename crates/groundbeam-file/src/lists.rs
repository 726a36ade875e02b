//! The tables of which a file may have several: `[[load]]` and the like.

/// A table of which a file may have several. Only the list below makes one, and
/// [`Reader::tables`](crate::reader::Reader::tables) takes nothing else: a table that is asked for as a list is known
/// here.
#[derive(Debug, PartialEq)]
pub(crate) struct List {
    /// The last name of its heading: `segment` of `[[beam.segment]]`.
    pub key: &'static str,
    /// As messages call it.
    pub name: &'static str,
}

macro_rules! lists {
    ($($constant:ident = $key:literal, $name:literal;)*) => {
        $(pub(crate) const $constant: List = List { key: $key, name: $name };)*
        const ALL: &[List] = &[$($constant),*];
    };
}

lists! {
    AXLES = "axles", "an axle";
    BEAM_SEGMENT = "segment", "[[beam.segment]]";
    CASE = "case", "[[case]]";
    COMBINATION = "combination", "[[combination]]";
    CORRELATED = "correlated", "[[correlated]]";
    EVENT = "event", "[[event]]";
    FOUNDATION_SEGMENT = "segment", "[[foundation.segment]]";
    GAP = "gap", "[[gap]]";
    GAP_TROUGH = "gap_trough", "[[gap_trough]]";
    GROUND_LOAD = "ground_load", "[[ground_load]]";
    HINGE = "hinge", "[[hinge]]";
    LAYER = "layer", "[[foundation.soil.layer]]";
    LOAD = "load", "[[load]]";
    RANDOM = "random", "[[random]]";
    SUPPORT = "support", "[[support]]";
    TRAIN = "train", "[[train]]";
    UNIFORM = "uniform", "a distributed load";
}

/// Whether a file may have several tables whose heading ends in this name.
pub(crate) fn may_be_several(key: &str) -> bool {
    ALL.iter().any(|list| list.key == key)
}

#[cfg(test)]
mod tests {
    use super::ALL;

    /// Every one of them is advised to be written with double brackets where it is given twice.
    #[test]
    fn a_table_given_twice_is_a_list() {
        for list in ALL {
            for heading in [format!("[{}]", list.key), format!("[beam.{}]", list.key)] {
                let text = format!("{heading}\nat = \"1 m\"\n{heading}\nat = \"2 m\"\n");
                let found = crate::parse(&text).unwrap_err();
                let hint = &found.iter().find(|d| d.code == crate::code::DUPLICATE).unwrap().hint;
                assert!(hint.contains("double brackets"), "{heading}: {hint}");
            }
        }
    }
}
