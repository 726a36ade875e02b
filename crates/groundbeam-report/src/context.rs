//! What a report says besides the result itself.

use crate::quantity::Units;
use groundbeam::soil::{Bed, OnSoil, Subgrade};
use groundbeam::{Beam, Foundation, Limits, LoadFactors};

/// What a report says besides the result itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Context<'a> {
    /// What the model is called.
    pub title: Option<&'a str>,
    /// How numbers are written.
    pub units: Units,
    /// How long it took \[s\]; left out where nobody measured it.
    pub seconds: Option<f64>,
    /// What becomes of the model as its loads grow; left out where nobody asked.
    pub factors: Option<Factors<'a>>,
    /// Where the model's ground comes from; left out where its constants were given per length of beam.
    pub ground: Option<Ground<'a>>,
    /// What the design must keep to; left out where nobody asked.
    pub limits: Option<&'a Limits>,
    /// How many chords of the initial gap replace settlement troughs; left out where there are no troughs.
    pub chords: Option<usize>,
}

/// A ground whose constants are those of an area times a width, or were made of soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground<'a> {
    /// The width on which the beam bears \[m\].
    pub width: f64,
    /// k and μ.
    pub subgrade: Subgrade,
    /// The soil, and the method.
    pub bed: Option<&'a Bed>,
    /// γ of layers, and how many solutions it took where it is taken from the solution.
    pub gamma: Option<(f64, usize)>,
}

impl<'a> Ground<'a> {
    /// The ground of an answer on soil.
    pub fn of(bed: &'a Bed, found: &OnSoil) -> Self {
        let gamma = found.gamma.map(|gamma| (gamma, found.rounds));
        Ground { width: bed.width, subgrade: found.subgrade, bed: Some(bed), gamma }
    }

    /// The ground that a soil makes before anything is solved.
    pub fn before(bed: &'a Bed, beam: &Beam) -> Self {
        Ground { width: bed.width, subgrade: bed.subgrade(beam), bed: Some(bed), gamma: None }
    }

    /// A ground that is the same everywhere, under a beam of a known width.
    pub fn of_area(foundation: &Foundation, width: f64) -> Option<Self> {
        let subgrade = Subgrade { spring: foundation.spring, shear: foundation.shear };
        let ground = Ground { width, subgrade, bed: None, gamma: None };
        foundation.segments.is_empty().then_some(ground)
    }
}

/// Load factors with the names of the load cases that grow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors<'a> {
    /// What was found.
    pub found: &'a LoadFactors,
    /// The load cases whose loads grow; empty where all loads do.
    pub cases: &'a [String],
}

impl<'a> Context<'a> {
    /// No title, no time.
    pub fn new(units: Units) -> Self {
        Context {
            title: None,
            units,
            seconds: None,
            factors: None,
            ground: None,
            limits: None,
            chords: None,
        }
    }

    /// The same with a title.
    pub fn with_title(self, title: &'a str) -> Self {
        Context { title: Some(title), ..self }
    }

    /// The same with the time it took \[s\].
    pub fn with_seconds(self, seconds: f64) -> Self {
        Context { seconds: Some(seconds), ..self }
    }

    /// The same with load factors.
    pub fn with_factors(self, factors: Factors<'a>) -> Self {
        Context { factors: Some(factors), ..self }
    }

    /// The same with where the ground comes from.
    pub fn with_ground(self, ground: Ground<'a>) -> Self {
        Context { ground: Some(ground), ..self }
    }

    /// The same with limits to check against.
    pub fn with_limits(self, limits: &'a Limits) -> Self {
        Context { limits: Some(limits), ..self }
    }

    /// The title on one line, without characters that would steer a terminal or break XML.
    pub(crate) fn clean_title(&self) -> Option<String> {
        self.title.map(clean).filter(|title| !title.is_empty())
    }
}

/// Words of a file on one line, without characters that would steer a terminal or break XML.
pub(crate) fn clean(words: &str) -> String {
    printable(&words.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// A text with every character that would steer a terminal, or break XML, written as an escape: `\u{1b}`.
pub(crate) fn printable(text: &str) -> String {
    let mut printed = String::with_capacity(text.len());
    for c in text.chars() {
        match is_plain(c) {
            true => printed.push(c),
            false => printed.extend(c.escape_default()),
        }
    }
    printed
}

/// Neither a control character nor one that turns the direction of text or ends a line, nor no character at all.
pub(crate) fn is_plain(c: char) -> bool {
    !c.is_control()
        && !matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}')
        && !matches!(c, '\u{2066}'..='\u{2069}' | '\u{fffe}' | '\u{ffff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_cannot_steer_a_terminal() {
        let context = Context::new(Units::Si).with_title(" a\u{1b}[31m\tb\n ");
        assert_eq!(context.clean_title().as_deref(), Some(r"a\u{1b}[31m b"));
        assert_eq!(Context::new(Units::Si).with_title(" \n").clean_title(), None);
    }
}
