//! The formulas of the reports, in LaTeX, MathML and typst.

use serde::Serialize;

/// A formula in three notations.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Formula {
    /// Formula in LaTeX, the source of the other two notations.
    pub latex: &'static str,
    /// Formula in MathML, for web pages.
    pub mathml: &'static str,
    /// Formula in typst. All characters are escaped, so that parentheses do not group and commas do not separate
    /// arguments.
    pub typst: &'static str,
}

/// Equilibrium equation of a beam without shear deformation.
pub(super) const BEAM: Formula = Formula {
    latex: r"(EI\,w'')'' - P\,w'' + p = f - g'",
    mathml: r#"<math display="block"><mo symmetric="false" stretchy="false">(</mo><mi>E</mi><mi>I</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mi>′</mi><mo symmetric="false" stretchy="false">)</mo><mi>′</mi><mi>′</mi><mo>−</mo><mi>P</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mi>′</mi><mo>+</mo><mi>p</mi><mo>=</mo><mi>f</mi><mo>−</mo><mi>g</mi><mi>′</mi></math>"#,
    typst: r#"class("opening", \() E I #h(0.16666667em) scripts(w)^(′ ′) scripts(class("closing", \)))^(′ ′) − P #h(0.16666667em) scripts(w)^(′ ′) \+ p \= f − scripts(g)^(′)"#,
};

/// Equilibrium equations of a beam with shear deformation.
pub(super) const SHEARING_BEAM: Formula = Formula {
    latex: r"(EI\,φ')' + GA\,(w' - φ) + g = 0, \qquad -\bigl(GA\,(w' - φ)\bigr)' - P\,w'' + p = f",
    mathml: r#"<math display="block"><mo symmetric="false" stretchy="false">(</mo><mi>E</mi><mi>I</mi><mspace width="0.16666667em" /><mi>φ</mi><mi>′</mi><mo symmetric="false" stretchy="false">)</mo><mi>′</mi><mo>+</mo><mi>G</mi><mi>A</mi><mspace width="0.16666667em" /><mo symmetric="false" stretchy="false">(</mo><mi>w</mi><mi>′</mi><mo>−</mo><mi>φ</mi><mo symmetric="false" stretchy="false">)</mo><mo>+</mo><mi>g</mi><mo>=</mo><mn>0</mn><mo>,</mo><mspace width="2em" /><mi>−</mi><mo symmetric="true" stretchy="true" minsize="1.2em" maxsize="1.2em">(</mo><mi>G</mi><mi>A</mi><mspace width="0.16666667em" /><mo symmetric="false" stretchy="false">(</mo><mi>w</mi><mi>′</mi><mo>−</mo><mi>φ</mi><mo symmetric="false" stretchy="false">)</mo><mo symmetric="true" stretchy="true" minsize="1.2em" maxsize="1.2em">)</mo><mi>′</mi><mo>−</mo><mi>P</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mi>′</mi><mo>+</mo><mi>p</mi><mo>=</mo><mi>f</mi></math>"#,
    typst: r#"class("opening", \() E I #h(0.16666667em) scripts(φ)^(′) scripts(class("closing", \)))^(′) \+ G A #h(0.16666667em) class("opening", \() scripts(w)^(′) − φ class("closing", \)) \+ g \= "0" \, #h(2em) − class("opening", stretch(\(, size: #1.2em)) G A #h(0.16666667em) class("opening", \() scripts(w)^(′) − φ class("closing", \)) scripts(class("closing", stretch(\), size: #1.2em)))^(′) − P #h(0.16666667em) scripts(w)^(′ ′) \+ p \= f"#,
};

/// Equilibrium equation of the ground.
pub(super) const GROUND: Formula = Formula {
    latex: r"-(μ\,u')' + k\,u = p + p_0\,\delta(x) + p_l\,\delta(x-l)",
    mathml: r#"<math display="block"><mi>−</mi><mo symmetric="false" stretchy="false">(</mo><mi>μ</mi><mspace width="0.16666667em" /><mi>u</mi><mi>′</mi><mo symmetric="false" stretchy="false">)</mo><mi>′</mi><mo>+</mo><mi>k</mi><mspace width="0.16666667em" /><mi>u</mi><mo>=</mo><mi>p</mi><mo>+</mo><msub><mi>p</mi><mn>0</mn></msub><mspace width="0.16666667em" /><mi>δ</mi><mo symmetric="false" stretchy="false">(</mo><mi>x</mi><mo symmetric="false" stretchy="false">)</mo><mo>+</mo><msub><mi>p</mi><mi>l</mi></msub><mspace width="0.16666667em" /><mi>δ</mi><mo symmetric="false" stretchy="false">(</mo><mi>x</mi><mo>−</mo><mi>l</mi><mo symmetric="false" stretchy="false">)</mo></math>"#,
    typst: r#"− class("opening", \() μ #h(0.16666667em) scripts(u)^(′) scripts(class("closing", \)))^(′) \+ k #h(0.16666667em) u \= p \+ scripts(p)_("0") #h(0.16666667em) δ class("opening", \() x class("closing", \)) \+ scripts(p)_(l) #h(0.16666667em) δ class("opening", \() x − l class("closing", \))"#,
};

/// Contact conditions.
pub(super) const CONTACT: Formula = Formula {
    latex: r"p \ge 0, \qquad u + g_0 - w \ge 0, \qquad p\,(u + g_0 - w) = 0",
    mathml: r#"<math display="block"><mi>p</mi><mo>≥</mo><mn>0</mn><mo>,</mo><mspace width="2em" /><mi>u</mi><mo>+</mo><msub><mi>g</mi><mn>0</mn></msub><mo>−</mo><mi>w</mi><mo>≥</mo><mn>0</mn><mo>,</mo><mspace width="2em" /><mi>p</mi><mspace width="0.16666667em" /><mo symmetric="false" stretchy="false">(</mo><mi>u</mi><mo>+</mo><msub><mi>g</mi><mn>0</mn></msub><mo>−</mo><mi>w</mi><mo symmetric="false" stretchy="false">)</mo><mo>=</mo><mn>0</mn></math>"#,
    typst: r#"p ≥ "0" \, #h(2em) u \+ scripts(g)_("0") − w ≥ "0" \, #h(2em) p #h(0.16666667em) class("opening", \() u \+ scripts(g)_("0") − w class("closing", \)) \= "0""#,
};

/// Boundary conditions at the free ends of a beam without shear deformation.
pub(super) const ENDS: Formula = Formula {
    latex: r"EI\,w'' = 0, \qquad p_0 = V + P\,w' - g, \qquad p_l = -(V + P\,w' - g)",
    mathml: r#"<math display="block"><mi>E</mi><mi>I</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mi>′</mi><mo>=</mo><mn>0</mn><mo>,</mo><mspace width="2em" /><msub><mi>p</mi><mn>0</mn></msub><mo>=</mo><mi>V</mi><mo>+</mo><mi>P</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mo>−</mo><mi>g</mi><mo>,</mo><mspace width="2em" /><msub><mi>p</mi><mi>l</mi></msub><mo>=</mo><mi>−</mi><mo symmetric="false" stretchy="false">(</mo><mi>V</mi><mo>+</mo><mi>P</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mo>−</mo><mi>g</mi><mo symmetric="false" stretchy="false">)</mo></math>"#,
    typst: r#"E I #h(0.16666667em) scripts(w)^(′ ′) \= "0" \, #h(2em) scripts(p)_("0") \= V \+ P #h(0.16666667em) scripts(w)^(′) − g \, #h(2em) scripts(p)_(l) \= − class("opening", \() V \+ P #h(0.16666667em) scripts(w)^(′) − g class("closing", \))"#,
};

/// Boundary conditions at the free ends of a beam with shear deformation.
pub(super) const SHEARING_ENDS: Formula = Formula {
    latex: r"EI\,φ' = 0, \qquad p_0 = V + P\,w' - g, \qquad p_l = -(V + P\,w' - g)",
    mathml: r#"<math display="block"><mi>E</mi><mi>I</mi><mspace width="0.16666667em" /><mi>φ</mi><mi>′</mi><mo>=</mo><mn>0</mn><mo>,</mo><mspace width="2em" /><msub><mi>p</mi><mn>0</mn></msub><mo>=</mo><mi>V</mi><mo>+</mo><mi>P</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mo>−</mo><mi>g</mi><mo>,</mo><mspace width="2em" /><msub><mi>p</mi><mi>l</mi></msub><mo>=</mo><mi>−</mi><mo symmetric="false" stretchy="false">(</mo><mi>V</mi><mo>+</mo><mi>P</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mo>−</mo><mi>g</mi><mo symmetric="false" stretchy="false">)</mo></math>"#,
    typst: r#"E I #h(0.16666667em) scripts(φ)^(′) \= "0" \, #h(2em) scripts(p)_("0") \= V \+ P #h(0.16666667em) scripts(w)^(′) − g \, #h(2em) scripts(p)_(l) \= − class("opening", \() V \+ P #h(0.16666667em) scripts(w)^(′) − g class("closing", \))"#,
};

/// Static reactions under the two ends of the beam.
pub(super) const REACTIONS: Formula = Formula {
    latex: r"R_0 = \int_0^l \Bigl( f\,\bigl(1 - \tfrac{x}{l}\bigr) - \tfrac{g}{l} \Bigr) dx > 0, \qquad R_l = \int_0^l \Bigl( f\,\tfrac{x}{l} + \tfrac{g}{l} \Bigr) dx > 0",
    mathml: r#"<math display="block"><msub><mi>R</mi><mn>0</mn></msub><mo>=</mo><msubsup><mo movablelimits="false">∫</mo><mn>0</mn><mi>l</mi></msubsup><mo symmetric="true" stretchy="true" minsize="1.8em" maxsize="1.8em">(</mo><mi>f</mi><mspace width="0.16666667em" /><mo symmetric="true" stretchy="true" minsize="1.2em" maxsize="1.2em">(</mo><mn>1</mn><mo>−</mo><mrow displaystyle="false" scriptlevel="0"><mfrac><mrow><mi>x</mi></mrow><mrow><mi>l</mi></mrow></mfrac></mrow><mo symmetric="true" stretchy="true" minsize="1.2em" maxsize="1.2em">)</mo><mo>−</mo><mrow displaystyle="false" scriptlevel="0"><mfrac><mrow><mi>g</mi></mrow><mrow><mi>l</mi></mrow></mfrac></mrow><mo symmetric="true" stretchy="true" minsize="1.8em" maxsize="1.8em">)</mo><mi>d</mi><mi>x</mi><mo>></mo><mn>0</mn><mo>,</mo><mspace width="2em" /><msub><mi>R</mi><mi>l</mi></msub><mo>=</mo><msubsup><mo movablelimits="false">∫</mo><mn>0</mn><mi>l</mi></msubsup><mo symmetric="true" stretchy="true" minsize="1.8em" maxsize="1.8em">(</mo><mi>f</mi><mspace width="0.16666667em" /><mrow displaystyle="false" scriptlevel="0"><mfrac><mrow><mi>x</mi></mrow><mrow><mi>l</mi></mrow></mfrac></mrow><mo>+</mo><mrow displaystyle="false" scriptlevel="0"><mfrac><mrow><mi>g</mi></mrow><mrow><mi>l</mi></mrow></mfrac></mrow><mo symmetric="true" stretchy="true" minsize="1.8em" maxsize="1.8em">)</mo><mi>d</mi><mi>x</mi><mo>></mo><mn>0</mn></math>"#,
    typst: r#"scripts(R)_("0") \= scripts(∫)_("0")^(l) class("opening", stretch(\(, size: #1.8em)) f #h(0.16666667em) class("opening", stretch(\(, size: #1.2em)) "1" − inline(frac(x, l)) class("closing", stretch(\), size: #1.2em)) − inline(frac(g, l)) class("closing", stretch(\), size: #1.8em)) d x \> "0" \, #h(2em) scripts(R)_(l) \= scripts(∫)_("0")^(l) class("opening", stretch(\(, size: #1.8em)) f #h(0.16666667em) inline(frac(x, l)) \+ inline(frac(g, l)) class("closing", stretch(\), size: #1.8em)) d x \> "0""#,
};

/// Energy gap as an upper bound of the error of a solution.
pub(super) const ENERGY_GAP: Formula = Formula {
    latex: r"\tfrac12 \int_0^l \frac{(EI\,w'' + m)^2}{EI}\,dx + \tfrac12\,b(u - Gp,\,u - Gp) + \langle p,\,u + g_0 - w\rangle \;\ge\; \tfrac12\,\|(w, u) - (w^*, u^*)\|^2",
    mathml: r#"<math display="block"><mrow displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow><msubsup><mo movablelimits="false">∫</mo><mn>0</mn><mi>l</mi></msubsup><mfrac><mrow><mo symmetric="false" stretchy="false">(</mo><mi>E</mi><mi>I</mi><mspace width="0.16666667em" /><mi>w</mi><mi>′</mi><mi>′</mi><mo>+</mo><mi>m</mi><msup><mo symmetric="false" stretchy="false">)</mo><mn>2</mn></msup></mrow><mrow><mi>E</mi><mi>I</mi></mrow></mfrac><mspace width="0.16666667em" /><mi>d</mi><mi>x</mi><mo>+</mo><mrow displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow><mspace width="0.16666667em" /><mi>b</mi><mo symmetric="false" stretchy="false">(</mo><mi>u</mi><mo>−</mo><mi>G</mi><mi>p</mi><mo>,</mo><mspace width="0.16666667em" /><mi>u</mi><mo>−</mo><mi>G</mi><mi>p</mi><mo symmetric="false" stretchy="false">)</mo><mo>+</mo><mo symmetric="false" stretchy="false">⟨</mo><mi>p</mi><mo>,</mo><mspace width="0.16666667em" /><mi>u</mi><mo>+</mo><msub><mi>g</mi><mn>0</mn></msub><mo>−</mo><mi>w</mi><mo symmetric="false" stretchy="false">⟩</mo><mspace width="0.2777778em" /><mo>≥</mo><mspace width="0.2777778em" /><mrow displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow><mspace width="0.16666667em" /><mi>∥</mi><mo symmetric="false" stretchy="false">(</mo><mi>w</mi><mo>,</mo><mi>u</mi><mo symmetric="false" stretchy="false">)</mo><mo>−</mo><mo symmetric="false" stretchy="false">(</mo><msup><mi>w</mi><mi>∗</mi></msup><mo>,</mo><msup><mi>u</mi><mi>∗</mi></msup><mo symmetric="false" stretchy="false">)</mo><msup><mi>∥</mi><mn>2</mn></msup></math>"#,
    typst: r#"inline(frac("1", "2")) scripts(∫)_("0")^(l) frac(class("opening", \() E I #h(0.16666667em) scripts(w)^(′ ′) \+ m scripts(class("closing", \)))^("2"), E I) #h(0.16666667em) d x \+ inline(frac("1", "2")) #h(0.16666667em) b class("opening", \() u − G p \, #h(0.16666667em) u − G p class("closing", \)) \+ class("opening", \⟨) p \, #h(0.16666667em) u \+ scripts(g)_("0") − w class("closing", \⟩) #h(0.2777778em) ≥ #h(0.2777778em) inline(frac("1", "2")) #h(0.16666667em) ∥ class("opening", \() w \, u class("closing", \)) − class("opening", \() scripts(w)^(∗) \, scripts(u)^(∗) class("closing", \)) scripts(∥)^("2")"#,
};

#[cfg(test)]
mod tests {
    use super::*;
    use pulldown_latex::config::{DisplayMode, RenderConfig};
    use pulldown_latex::{Parser, Storage, push_mathml};

    const ALL: [Formula; 8] =
        [BEAM, SHEARING_BEAM, GROUND, CONTACT, ENDS, SHEARING_ENDS, REACTIONS, ENERGY_GAP];

    fn mathml_of(latex: &str) -> String {
        let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
        let (storage, mut written) = (Storage::new(), String::new());
        push_mathml(&mut written, Parser::new(latex, &storage), config).unwrap();
        // `push_mathml` omits the space before some `minsize` attributes.
        written.replace("\"minsize", "\" minsize")
    }

    #[test]
    fn mathml_equals_the_translated_latex() {
        for formula in ALL {
            assert_eq!(formula.mathml, mathml_of(formula.latex), "{}", formula.latex);
            assert!(!formula.mathml.contains("merror"), "{}", formula.latex);
        }
    }

    /// Returns the letters, digits and operators of a formula in order, without layout marks.
    fn signs_of_mathml(mathml: &str) -> String {
        let texts = mathml.split('<').filter_map(|part| Some(part.split_once('>')?.1));
        let signs: String = texts.collect::<String>().replace("&gt;", ">").replace("&lt;", "<");
        let signs = signs.replace('″', "′′").replace('-', "−").replace('*', "∗");
        signs.chars().filter(|sign| !sign.is_whitespace()).collect()
    }

    fn signs_of_typst(typst: &str) -> String {
        let mut text = typst.to_owned();
        while let Some(at) = text.find("#h(") {
            let length = text[at..].find(')').unwrap();
            text.replace_range(at..=at + length, "");
        }
        let layout =
            ["class(\"opening\", ", "class(\"closing\", ", "stretch(", "scripts(", "inline("];
        for mark in layout.into_iter().chain(["frac(", ", size: #1.2em", ", size: #1.8em"]) {
            text = text.replace(mark, "");
        }
        let mut signs = String::new();
        let mut rest = text.chars();
        while let Some(sign) = rest.next() {
            match sign {
                '\\' => signs.extend(rest.next()),
                '(' | ')' | ',' | '_' | '^' | '"' | ' ' => {}
                sign => signs.push(sign),
            }
        }
        signs
    }

    #[test]
    fn typst_and_mathml_have_the_same_symbols() {
        for formula in ALL {
            assert_eq!(signs_of_typst(formula.typst), signs_of_mathml(formula.mathml));
        }
    }
}
