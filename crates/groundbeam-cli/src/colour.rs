//! Decides whether output on a terminal is coloured.

use std::io::{self, IsTerminal};

/// Whether text on standard output is coloured.
pub fn standard_output_has_colour() -> bool {
    io::stdout().is_terminal() && colour_is_wanted()
}

/// Whether text on standard error is coloured.
pub fn standard_error_has_colour() -> bool {
    io::stderr().is_terminal() && colour_is_wanted()
}

/// Whether the environment variables `NO_COLOR` and `TERM` allow colour (see no-color.org).
fn colour_is_wanted() -> bool {
    let unset = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    unset && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}
