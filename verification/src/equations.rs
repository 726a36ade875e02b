//! Lists for each equation of the paper the source files that name it, or the reason why the program does not need it.

use crate::architecture::{Source, sources};
use std::fmt::Write;

/// Numbers of the sections of the paper and of the equations in each section, (2.1) to (5.21).
pub const SECTIONS: [(u32, u32); 4] = [(2, 13), (3, 12), (4, 25), (5, 21)];

/// Folders with the source files that are searched for equation numbers of the paper.
const FOLDERS: [&str; 3] =
    ["crates/groundbeam/src", "crates/groundbeam-proof/src", "verification/src"];

/// Maximum number of source files that the index lists for one equation of the paper.
const MOST_FILES: usize = 4;

/// Equations of the paper that no source file names, each with its number, its statement, and the reason why the
/// program does not need it.
const NOT_NEEDED: &str = "\
2.7 | p̂ = 0 where the beam is open | part of (2.10)
2.8 | p̂ = 0 beside the beam | the pressure is defined on the beam only
2.9 | u ≥ w | part of (2.10)
3.1 | reciprocal energy of the ground | the methods minimise an energy in w and u
3.2 | the deflection extended by zero | the pressure is defined on the beam only
3.3 | u from pressure and end forces | G is never formed: its inverse is tridiagonal, (5.8)
3.4 | G is symmetric | two-ports are symmetric by construction
3.5 | the pairing with point forces | point forces are listed beside the pressure
3.6 | the work of the pressure | point forces are listed beside the pressure
3.7 | derivative of the reciprocal energy | the methods minimise an energy in w and u
3.10 | saddle point of the Lagrangian | the same point minimises the energy in w and u under u + g₀ ≥ w
3.11 | variational inequality of the pressure | equivalent to (2.10)
4.2 | the beam's energy is finite | functional analysis; data are bounded by the rules for models
4.3 | Sobolev norm | functional analysis
4.4 | Sobolev space of the deflection | functional analysis
4.5 | w and w′ are continuous | functional analysis
4.6 | the beam's energy is finite | functional analysis
4.8 | b is continuous | functional analysis
4.10 | b is coercive | functional analysis; k > 0 is a rule for models
4.11 | order of the dual space | functional analysis
4.12 | set of admissible pressures | functional analysis
4.13 | u = G(p̂) for ground that varies | the surface is solved element by element
4.14 | the energy at the best pressure | functional analysis
4.15 | deflection = rigid motion + rest | functional analysis
5.12 | the problem of one number | its solution is (5.13)
5.21 | the condition of the example | (4.25) for the models in `cases/kikuchi-1980/`
";

/// Returns the index of equations as a Markdown table, and a message for each fault. An equation must be either named
/// by a source file or listed in `NOT_NEEDED`, but not both.
pub fn index() -> (String, Vec<String>) {
    let files: Vec<Source> = FOLDERS.iter().flat_map(|folder| sources(folder)).collect();
    // This file is not searched, because it lists the equations that no other file names.
    let files = files.into_iter().filter(|file| !file.path.ends_with("src/equations.rs"));
    let files: Vec<Source> = files.collect();
    let mut table = String::from("| equation | where |\n|---|---|\n");
    let mut missing = Vec::new();
    for (section, last) in SECTIONS {
        for number in 1..=last {
            let name = format!("({section}.{number})");
            let places = places(&files, section, number);
            let reason = reason(section, number);
            let place = match (places.is_empty(), reason) {
                (false, None) => places.join("<br>"),
                (true, Some((statement, reason))) => format!("{statement}: {reason}"),
                (true, None) => {
                    missing.push(format!("{name}: no source file names this equation"));
                    continue;
                }
                (false, Some(_)) => {
                    missing.push(format!("{name}: {} names it", places[0]));
                    continue;
                }
            };
            writeln!(table, "| {name} | {place} |").expect("a string can be written");
        }
    }
    (table, missing)
}

/// Returns the statement of an equation and the reason why the program does not need it; `None` if the equation is not
/// listed in `NOT_NEEDED`.
fn reason(section: u32, number: u32) -> Option<(&'static str, &'static str)> {
    let name = format!("{section}.{number}");
    let mut rows = NOT_NEEDED.lines().map(|line| line.splitn(3, " | "));
    let row = rows.find_map(|mut row| (row.next()? == name).then_some(row));
    row.and_then(|mut row| Some((row.next()?, row.next()?)))
}

/// Returns the files that name an equation. Files that name the equation in their first comment come first.
fn places(files: &[Source], section: u32, number: u32) -> Vec<String> {
    let mut found: Vec<(bool, String)> = Vec::new();
    for file in files {
        let text: Vec<&str> = file.code().lines().filter(|line| is_text(line)).collect();
        if !names(&text.join("\n"), section, number) {
            continue;
        }
        let head = file.code().lines().take_while(|line| line.starts_with("//!"));
        let head: Vec<&str> = head.collect();
        found.push((!names(&head.join("\n"), section, number), format!("`{}`", file.path)));
    }
    found.sort();
    found.truncate(MOST_FILES);
    found.into_iter().map(|(_, path)| path).collect()
}

/// Whether a line is a comment or contains a message.
fn is_text(line: &str) -> bool {
    line.trim_start().starts_with("//") || line.contains('"')
}

/// Whether a text names an equation, directly or within a range like (5.14)–(5.18).
fn names(text: &str, section: u32, number: u32) -> bool {
    let mut rest = text;
    let mut before: Option<(u32, u32)> = None;
    while let Some(from) = rest.find('(') {
        let range_follows = before.is_some() && rest[..from].trim() == "–";
        rest = &rest[from + 1..];
        let Some(named) = equation(rest) else {
            before = None;
            continue;
        };
        let first = match before {
            Some((s, n)) if range_follows && s == named.0 => n,
            _ => named.1,
        };
        if named.0 == section && (first..=named.1).contains(&number) {
            return true;
        }
        before = Some(named);
        rest = &rest[rest.find(')').map_or(0, |end| end + 1)..];
    }
    false
}

/// Returns the section and the number of the equation at the start of a text without its opening bracket, as in
/// `5.14)…`.
fn equation(text: &str) -> Option<(u32, u32)> {
    let (inside, _) = text.split_once(')')?;
    let (section, number) = inside.split_once('.')?;
    let digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit()) && !text.is_empty();
    let (section, number) = (
        digits(section).then(|| section.parse().ok())??,
        digits(number).then(|| number.parse().ok())??,
    );
    let last = SECTIONS.iter().find(|(s, _)| *s == section)?.1;
    (1..=last).contains(&number).then_some((section, number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_found_alone_and_in_ranges() {
        let text = "Uzawa's iteration, (5.14)–(5.18), and (2.11); f(2.3x), (7.1), (12)";
        for (section, number, expected) in [
            (5, 14, true),
            (5, 16, true),
            (5, 18, true),
            (5, 19, false),
            (2, 11, true),
            (2, 3, false),
        ] {
            assert_eq!(names(text, section, number), expected, "({section}.{number})");
        }
    }
}
