//! `samples`, `seed`, `sampling`, `replicates`: how many samples, and how they are drawn.

use crate::code;
use crate::fault::Fault;
use crate::keys::{WHAT_CAN_STAND_HERE, Words};
use crate::reader::Reader;
use crate::table::Section;

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

pub(super) static NAMES: Words = Words {
    all: || Sampling::ALL.map(Sampling::name).to_vec(),
    also: &[],
    message: "`{}` is no `sampling`",
    hint: WHAT_CAN_STAND_HERE,
};

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
pub(super) const MOST_SAMPLES: u64 = 1 << 48;
pub(super) const MOST_REPLICATES: u64 = 1 << 16;

pub(super) fn read(reader: &mut Reader, root: &Section) -> Plan {
    let samples = reader.count(root, "samples").unwrap_or(SAMPLES);
    let seed = reader.count(root, "seed").unwrap_or(0);
    let word = reader.word(root, "sampling");
    let sampling = Sampling::ALL.into_iter().find(|sampling| Some(sampling.name()) == word);
    let sampling = sampling.unwrap_or(Sampling::MonteCarlo);
    let written = reader.count(root, "replicates");
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
