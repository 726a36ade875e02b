//! The names of load cases: each once, and what is said of a name that no load case has.

/// The names of the load cases to which loads belong, each once, in the order of the loads.
pub(crate) fn names(cases: &[Option<String>]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for case in cases.iter().flatten() {
        if !names.contains(&case.as_str()) {
            names.push(case);
        }
    }
    names
}

/// The message about a name that no load case has.
pub(crate) const NO_LOAD: &str = "no load belongs to a case `{}`";

/// The advice where no load case has a name like the one that was written.
pub(crate) fn otherwise(names: &[&str]) -> &'static str {
    match names {
        [] => "no load of the file has a `case`; give one to those that are meant",
        _ => "the cases of the file: {}",
    }
}
