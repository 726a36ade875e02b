//! The equations of the problem, in LaTeX's notation.

use super::content::{Block, Equation};

/// The problem, in the equations of Kikuchi; of a beam that shears in those of Timoshenko.
pub(super) fn problem(shears: bool) -> Block {
    let beam = if shears {
        let sections = r"(EI\,φ')' + GA\,(w' - φ) + g = 0, \qquad \
                         -\bigl(GA\,(w' - φ)\bigr)' - P\,w'' + p = f";
        line(sections, "beam, 0 < x < l", "")
    } else {
        line(r"(EI\,w'')'' - P\,w'' + p = f - g'", "beam, 0 < x < l", "(2.11)")
    };
    let ends = if shears { r"EI\,φ' = 0" } else { r"EI\,w'' = 0" };
    let forces = r", \qquad p_0 = V + P\,w' - g, \qquad p_l = -(V + P\,w' - g)";
    Block::Equations {
        lines: vec![
            beam,
            line(
                r"-(μ\,u')' + k\,u = p + p_0\,\delta(x) + p_l\,\delta(x-l)",
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
    Equation { latex, words: words.to_owned(), number }
}
