//! Formulas in LaTeX's notation as typst writes them.

use pulldown_latex::event::{
    Content, DelimiterSize, DelimiterType, DimensionUnit, Event, Grouping, ScriptPosition,
    ScriptType, StateChange, Style, Visual,
};
use pulldown_latex::{Parser, Storage};
use std::vec::IntoIter;

/// A formula as typst writes it, without the signs around it; or what of it cannot be written.
///
/// Every sign stands for itself alone, so that typst takes none for its own: parentheses do not group, commas do not part
/// arguments.
pub(crate) fn formula(latex: &str) -> Result<String, String> {
    let storage = Storage::new();
    let events: Result<Vec<Event>, _> = Parser::new(latex, &storage).collect();
    let events = events.map_err(|error| format!("{latex}: {error}"))?;
    let mut rest = events.into_iter();
    let written = group(&mut rest).map_err(|what| format!("{latex}: {what}"))?;
    Ok(written)
}

/// As in w′.
const PRIME: char = '′';

/// Elements up to the end of their group.
fn group(rest: &mut IntoIter<Event>) -> Result<String, String> {
    let mut written = Vec::new();
    while let Some(event) = rest.next() {
        match event {
            Event::End => break,
            Event::StateChange(StateChange::Style(style)) => {
                // It holds for what is left of the group.
                let style = match style {
                    Style::Display => "display",
                    Style::Text => "inline",
                    Style::Script => "script",
                    Style::ScriptScript => "sscript",
                };
                written.push(format!("{style}({})", group(rest)?));
                break;
            }
            Event::Content(Content::Ordinary { content: PRIME, .. }) => {
                // It stands beside what is before it, and so do all that follow one another.
                let before = written.pop().unwrap_or_default();
                written.push(match before.strip_suffix(")") {
                    Some(open) if open.ends_with(PRIME) => format!("{open} {PRIME})"),
                    _ => format!("scripts({before})^({PRIME})"),
                });
            }
            event => written.push(element(event, rest)?),
        }
    }
    Ok(written.join(" "))
}

/// The next element, whatever it is.
fn next(rest: &mut IntoIter<Event>) -> Result<String, String> {
    let event = rest.next().ok_or("something is missing at its end")?;
    element(event, rest)
}

fn element(event: Event, rest: &mut IntoIter<Event>) -> Result<String, String> {
    Ok(match event {
        Event::Content(content) => sign(content)?,
        Event::Begin(Grouping::Normal) => group(rest)?,
        Event::Visual(Visual::Fraction(None)) => {
            format!("frac({}, {})", next(rest)?, next(rest)?)
        }
        Event::Visual(Visual::SquareRoot) => format!("sqrt({})", next(rest)?),
        Event::Script { ty, position } => {
            let base = next(rest)?;
            let place = if position == ScriptPosition::AboveBelow { "limits" } else { "scripts" };
            let base = format!("{place}({base})");
            match ty {
                ScriptType::Subscript => format!("{base}_({})", next(rest)?),
                ScriptType::Superscript => format!("{base}^({})", next(rest)?),
                ScriptType::SubSuperscript => {
                    format!("{base}_({})^({})", next(rest)?, next(rest)?)
                }
            }
        }
        Event::Space { width: Some(width), .. } => match width.unit {
            DimensionUnit::Em => format!("#h({}em)", width.value),
            // By definition.
            DimensionUnit::Mu => format!("#h({}em)", width.value / 18.0),
            other => return Err(format!("no spaces in {other:?}")),
        },
        other => return Err(format!("no {other:?}")),
    })
}

fn sign(content: Content) -> Result<String, String> {
    Ok(match content {
        Content::Number(digits) => literal(digits),
        Content::Text(words) => literal(words),
        Content::Function(name) => format!("op({})", literal(name)),
        Content::Ordinary { content, .. }
        | Content::BinaryOp { content, .. }
        | Content::LargeOp { content, .. }
        | Content::Punctuation(content) => alone(content),
        Content::Relation { content, .. } => {
            let mut bytes = [0; 8];
            let signs = content.encode_utf8_to_buf(&mut bytes);
            let signs = String::from_utf8_lossy(signs).into_owned();
            signs.chars().map(alone).collect::<Vec<_>>().join("")
        }
        Content::Delimiter { content, size, ty } => {
            let class = match ty {
                DelimiterType::Open => "opening",
                DelimiterType::Fence => "fence",
                DelimiterType::Close => "closing",
            };
            match size {
                None => format!("class(\"{class}\", \\{content})"),
                Some(size) => {
                    // As high as in LaTeX.
                    let em = match size {
                        DelimiterSize::Big => 1.2,
                        DelimiterSize::BIG => 1.8,
                        DelimiterSize::Bigg => 2.4,
                        DelimiterSize::BIGG => 3.0,
                    };
                    format!("class(\"{class}\", stretch(\\{content}, size: #{em:?}em))")
                }
            }
        }
    })
}

/// A sign that typst takes for nothing else: of ASCII, letters alone mean what they are.
fn alone(sign: char) -> String {
    match sign {
        // LaTeX's minus sign and its star.
        '-' => "−".to_owned(),
        '*' => "∗".to_owned(),
        sign if sign.is_ascii_punctuation() => format!("\\{sign}"),
        sign => sign.to_string(),
    }
}

/// Words in quotes.
fn literal(words: &str) -> String {
    format!("\"{}\"", words.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_of_every_kind() {
        let cases = [
            ("a", "a"),
            (r"\tfrac{x}{l}", "inline(frac(x, l))"),
            (r"p_0\,\delta", "scripts(p)_(\"0\") #h(0.16666667em) δ"),
            (r"\int_0^l", "scripts(∫)_(\"0\")^(l)"),
            (r"w'' + u'", "scripts(w)^(′ ′) \\+ scripts(u)^(′)"),
            (r"\bigl(1", "class(\"opening\", stretch(\\(, size: #1.2em)) \"1\""),
            (r"f(x, y)", "f class(\"opening\", \\() x \\, y class(\"closing\", \\))"),
            (r"\sqrt{a}", "sqrt(a)"),
        ];
        for (latex, expected) in cases {
            assert_eq!(formula(latex).as_deref(), Ok(expected));
        }
    }

    #[test]
    fn every_formula_of_a_report_can_be_written() {
        for latex in groundbeam_report::calculation::formulas() {
            formula(&latex).unwrap();
        }
    }

    #[test]
    fn what_cannot_be_written_is_told() {
        for latex in [r"\frac{1", r"\begin{matrix} a \end{matrix}", r"\nothing"] {
            assert!(formula(latex).unwrap_err().starts_with(latex), "{latex}");
        }
    }
}
