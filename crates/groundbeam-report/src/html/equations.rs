//! The equations of the problem, and LaTeX's notation as MathML.

use super::page::{Block, Equation};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// A formula as MathML; as it is written where it cannot be read, which no formula here is.
pub(super) fn mathml(latex: &str) -> String {
    let storage = Storage::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut written = String::new();
    match push_mathml(&mut written, Parser::new(latex, &storage), config) {
        Ok(()) => written,
        Err(_) => latex.replace('&', "&amp;").replace('<', "&lt;"),
    }
}

/// The problem, in the equations of Kikuchi; of a beam that shears in those of Timoshenko.
pub(super) fn problem(shears: bool) -> Block {
    let beam = if shears {
        let sections = r"(EI\,\varphi')' + GA\,(w' - \varphi) + g = 0, \qquad \
                         -\bigl(GA\,(w' - \varphi)\bigr)' - P\,w'' + p = f";
        line(sections, "beam, 0 < x < l", "")
    } else {
        line(r"(EI\,w'')'' - P\,w'' + p = f - g'", "beam, 0 < x < l", "(2.11)")
    };
    let ends = if shears { r"EI\,\varphi' = 0" } else { r"EI\,w'' = 0" };
    let forces = r", \qquad p_0 = V + P\,w' - g, \qquad p_l = -(V + P\,w' - g)";
    Block::Equations {
        lines: vec![
            beam,
            line(
                r"-(\mu\,u')' + k\,u = p + p_0\,\delta(x) + p_l\,\delta(x-l)",
                "ground, all x",
                "(2.2)",
            ),
            line(
                r"p \ge 0, \qquad u + g_0 - w \ge 0, \qquad p\,(u + g_0 - w) = 0",
                "contact, 0 < x < l",
                "(2.10)",
            ),
            line(&format!("{ends}{forces}"), "free ends x = 0 and x = l", "(2.13)"),
        ],
    }
}

/// The statics of a free beam.
pub(super) fn static_reactions() -> Block {
    Block::Equations {
        lines: vec![line(
            r"R_0 = \int_0^l \Bigl( f\,\bigl(1 - \tfrac{x}{l}\bigr) - \tfrac{g}{l} \Bigr) dx > 0, \qquad \
              R_l = \int_0^l \Bigl( f\,\tfrac{x}{l} + \tfrac{g}{l} \Bigr) dx > 0",
            "",
            "(4.25)",
        )],
    }
}

/// What bounds the error.
pub(super) fn energy_gap() -> Block {
    Block::Equations {
        lines: vec![line(
            r"\tfrac12 \int_0^l \frac{(EI\,w'' + m)^2}{EI}\,dx + \tfrac12\,b(u - Gp,\,u - Gp) + \
              \langle p,\,u + g_0 - w\rangle \;\ge\; \tfrac12\,\|(w, u) - (w^*, u^*)\|^2",
            "energy gap",
            "",
        )],
    }
}

fn line(latex: &str, words: &str, number: &'static str) -> Equation {
    // A line that goes on in the source is one line.
    let latex = latex.replace("\\\n", "");
    Equation { mathml: mathml(&latex), words: words.to_owned(), number }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_formula_can_be_read() {
        for block in [problem(false), problem(true), static_reactions(), energy_gap()] {
            let Block::Equations { lines } = block else { panic!() };
            for line in lines {
                assert!(line.mathml.starts_with("<math"), "{}", line.mathml);
                assert!(!line.mathml.contains("merror"), "{}", line.mathml);
            }
        }
    }
}
