//! Lists the names of load cases without repetition, and gives the message for an unknown name.

/// Returns the names of the load cases, each once, in the order of the loads.
pub(crate) fn names(cases: &[Option<String>]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for case in cases.iter().flatten() {
        if !names.contains(&case.as_str()) {
            names.push(case);
        }
    }
    names
}

/// Message for a name that is not a load case.
pub(crate) const NO_LOAD: &str = "no load belongs to the load case `{}`";

/// Returns the hint for a name that resembles no load case.
pub(crate) fn otherwise(names: &[&str]) -> &'static str {
    match names {
        [] => "no load of the file has the key `case`; add this key to each load of the load case",
        _ => "the cases of the file: {}",
    }
}
