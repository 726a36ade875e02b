//! Opens a page in the user's default browser.

use std::process::{Command, Stdio};

/// Opens the address in the default browser. If no browser starts, the user can open the printed address.
pub fn open(url: &str) {
    let (program, arguments): (&str, &[&str]) = if cfg!(target_os = "windows") {
        ("rundll32", &["url.dll,FileProtocolHandler"])
    } else if cfg!(target_os = "macos") {
        ("open", &[])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(arguments).arg(url);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    // The program does not wait for the browser.
    let _ = command.spawn();
}
