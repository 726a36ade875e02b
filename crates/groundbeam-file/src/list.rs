//! Parses comma-separated lists, as given on the command line.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::fault::Fault;
use crate::source::Source;

/// Reads each entry of a list without its surrounding spaces. The function `entry` parses one entry. It gives the
/// location of a fault relative to the start of the entry.
pub(crate) fn read<T>(
    list: &str,
    mut entry: impl FnMut(&str) -> Result<T, Fault>,
) -> Result<Vec<T>, Diagnostics> {
    let source = Source::new(list);
    let mut values = Vec::new();
    let mut found = Vec::new();
    let mut start = 0;
    for written in list.split(',') {
        let space = written.len() - written.trim_start().len();
        match entry(written.trim()) {
            Ok(value) => values.push(value),
            Err(fault) => found.push(Diagnostic::new(&source, fault.moved(start + space))),
        }
        start += written.len() + 1;
    }
    if found.is_empty() { Ok(values) } else { Err(Diagnostics::new(found)) }
}
