//! Formats tables in Markdown, and describes the machine.

use std::process::Command;

/// Markdown table with a heading.
#[derive(Debug, Default)]
pub struct Table {
    text: String,
}

impl Table {
    pub fn new(title: &str, columns: &[&str]) -> Self {
        let rule = "|---".repeat(columns.len());
        Table { text: format!("\n## {title}\n\n| {} |\n{rule}|\n", columns.join(" | ")) }
    }

    pub fn row(&mut self, cells: &[String]) {
        let line = format!("| {} |\n", cells.join(" | "));
        eprint!("{line}");
        self.text += &line;
    }

    /// Returns the table, followed by a remark.
    pub fn finish(self, remark: &str) -> String {
        if remark.is_empty() { self.text } else { format!("{}\n{remark}\n", self.text) }
    }
}

/// Formats a number with three significant digits.
pub fn short(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if (0.01..10_000.0).contains(&x.abs()) {
        let digits = (2 - x.abs().log10().floor() as i32).max(0) as usize;
        format!("{x:.digits$}")
    } else {
        format!("{x:.1e}")
    }
}

/// Returns the date, the processor, the number of cores, the program version and the compiler version as text.
pub fn setting() -> String {
    let said = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let processor = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?.to_owned();
        Some(line.split(':').nth(1)?.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let unknown = || "unknown".to_owned();
    format!(
        "{}; {}, {cores} cores.\ngroundbeam {}, {}, no machine-specific instructions.\n",
        said("date", &["-u", "+%Y-%m-%d %H:%M UTC"]).unwrap_or_else(unknown),
        processor.unwrap_or_else(unknown),
        env!("CARGO_PKG_VERSION"),
        said("rustc", &["--version"]).unwrap_or_else(unknown),
    )
}
