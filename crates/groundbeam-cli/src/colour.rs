//! Decides whether the terminal shows colour.

use std::io::{self, IsTerminal};

/// Whether standard output shows colour.
pub fn standard_output_has_colour() -> bool {
    io::stdout().is_terminal() && colour_is_wanted()
}

/// Whether standard error shows colour.
pub fn standard_error_has_colour() -> bool {
    io::stderr().is_terminal() && colour_is_wanted()
}

/// Whether the environment allows colour, see no-color.org.
fn colour_is_wanted() -> bool {
    let unset = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    unset && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}
