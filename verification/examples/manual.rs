//! Writes `docs/verification.md` from the files in `cases/`.

use groundbeam_verification::cases::{all, folder, manual::manual};
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut cases = Vec::new();
    for case in all() {
        match case {
            Ok(case) => cases.push(case),
            Err((path, misread)) => {
                eprintln!("cases/{path}: {misread}");
                return ExitCode::FAILURE;
            }
        }
    }
    let page = folder().join("../docs/verification.md");
    match std::fs::write(&page, manual(&cases)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}: {error}", page.display());
            ExitCode::FAILURE
        }
    }
}
