//! LaTeX's notation as MathML.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// A formula as MathML; as it is written where it cannot be read, which no formula of a report is.
pub(super) fn of(latex: &str) -> String {
    let storage = Storage::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut written = String::new();
    match push_mathml(&mut written, Parser::new(latex, &storage), config) {
        // Its signs of a size lack a space between two attributes.
        Ok(()) => written.replace("\"minsize", "\" minsize"),
        Err(_) => latex.replace('&', "&amp;").replace('<', "&lt;"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::calculation::formulas;

    #[test]
    fn every_formula_can_be_read() {
        for latex in formulas() {
            let written = of(&latex);
            assert!(written.starts_with("<math"), "{written}");
            assert!(!written.contains("merror"), "{written}");
        }
    }
}
