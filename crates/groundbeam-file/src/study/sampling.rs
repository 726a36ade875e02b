//! `samples`, `seed`, `sampling`, `replicates`: how many samples, and how they are drawn.

use crate::code;
use crate::fault::Fault;
use crate::reader::Reader;
use crate::suggest::nearest;
use crate::table::Section;
use toml::de::DeValue;

/// How points are spread over the random numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// `monte-carlo`: each by itself.
    MonteCarlo,
    /// `latin-hypercube`: every number's range is cut into as many equally probable parts as there are samples in a
    /// replicate, and each part has one sample.
    LatinHypercube,
    /// `sobol`: Sobol's sequence, its digits scrambled after Owen, anew in each replicate.
    Sobol,
}

impl Sampling {
    const ALL: [Sampling; 3] = [Sampling::MonteCarlo, Sampling::LatinHypercube, Sampling::Sobol];

    /// As files spell it.
    pub fn name(self) -> &'static str {
        match self {
            Sampling::MonteCarlo => "monte-carlo",
            Sampling::LatinHypercube => "latin-hypercube",
            Sampling::Sobol => "sobol",
        }
    }
}

/// How many samples there are, and how they are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    /// How many.
    pub samples: u64,
    /// From which all random numbers follow.
    pub seed: u64,
    /// How they are spread.
    pub sampling: Sampling,
    /// Into how many parts they are divided that are drawn independently, so that their scatter tells the error;
    /// 1 for `monte-carlo`, where every sample is a part.
    pub replicates: u64,
}

/// Unless the file says otherwise.
const SAMPLES: u64 = 10_000;
const REPLICATES: u64 = 16;
/// An exact integer in every program that may read the results.
const MOST_SAMPLES: u64 = 1 << 48;
const MOST_REPLICATES: u64 = 1 << 16;

pub(super) fn read(reader: &mut Reader, root: &Section) -> Plan {
    let samples = reader.count(root, "samples", 1..=MOST_SAMPLES).unwrap_or(SAMPLES);
    let seed = reader.count(root, "seed", 0..=i64::MAX as u64).unwrap_or(0);
    let names = Sampling::ALL.map(Sampling::name);
    let sampling =
        reader.one_of(root, "sampling", &names).map_or(Sampling::MonteCarlo, |i| Sampling::ALL[i]);
    let written = reader.count(root, "replicates", 1..=MOST_REPLICATES);
    let replicates = match sampling {
        Sampling::MonteCarlo => {
            if let (Some(_), Some(value)) = (written, root.value("replicates")) {
                let message = "samples of `monte-carlo` are independent already";
                let hint = "leave `replicates` out, or take `latin-hypercube` or `sobol`";
                reader.report(Fault::new(code::MISPLACED, value.span(), message, "", hint));
            }
            1
        }
        _ => written.unwrap_or(REPLICATES),
    };
    Plan { samples, seed, sampling, replicates }
}

impl Plan {
    /// The same with other numbers than the file's.
    pub fn with(self, samples: Option<u64>, seed: Option<u64>) -> Self {
        Plan { samples: samples.unwrap_or(self.samples), seed: seed.unwrap_or(self.seed), ..self }
    }

    /// What is wrong with how many samples there are.
    pub fn problem(&self) -> Option<String> {
        let Plan { samples, replicates, .. } = *self;
        if !(1..=MOST_SAMPLES).contains(&samples) {
            return Some(format!("there must be from 1 to {MOST_SAMPLES} samples"));
        }
        if !samples.is_multiple_of(replicates) {
            let down = samples - samples % replicates;
            let near = if down == 0 { replicates } else { down };
            return Some(format!(
                "{samples} samples cannot be divided into {replicates} equal replicates; {near} can"
            ));
        }
        let each = samples / replicates;
        if self.sampling == Sampling::Sobol && each > 1 << 32 {
            return Some("a replicate of Sobol's sequence has at most 2^32 samples".to_owned());
        }
        if self.sampling == Sampling::Sobol && !each.is_power_of_two() {
            let up = replicates * each.next_power_of_two();
            return Some(format!(
                "Sobol's sequence is even only over powers of two, and {samples} samples in {replicates} replicates are \
                 {each} each; {up} samples are even"
            ));
        }
        None
    }
}

impl Reader<'_> {
    /// The whole number under `key`, if given.
    pub fn count(
        &mut self,
        section: &Section,
        key: &str,
        range: std::ops::RangeInclusive<u64>,
    ) -> Option<u64> {
        let value = section.value(key)?;
        let DeValue::Integer(integer) = value.get_ref() else {
            let hint = format!("write it without quotes, as in {key} = 1000");
            self.wrong_type(value, format!("`{key}` must be a whole number"), hint);
            return None;
        };
        let digits = integer.as_str().replace('_', "");
        let number = u64::from_str_radix(digits.trim_start_matches('+'), integer.radix()).ok();
        let fits = number.filter(|number| range.contains(number));
        if fits.is_none() {
            let message = format!("`{key}` must be from {} to {}", range.start(), range.end());
            let hint =
                format!("for example {key} = {}", (*range.start()).max(1000).min(*range.end()));
            self.report(Fault::new(code::RANGE, value.span(), message, "", hint));
        }
        fits
    }

    /// Which of the words stands under `key`, if any.
    pub fn one_of(&mut self, section: &Section, key: &str, words: &[&str]) -> Option<usize> {
        let (word, span) = self.words(section, key, words[0])?;
        let found = words.iter().position(|known| *known == word.trim());
        if found.is_none() {
            let message = format!("`{word}` is no `{key}`");
            let hint = match nearest(word, words.iter().copied()) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("what can stand here: {}", words.join(", ")),
            };
            self.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
        }
        found
    }
}
