//! Reads `samples`, `seed`, `sampling` and `replicates`: the number of samples and the sampling method.

use crate::code;
use crate::fault::Fault;
use crate::keys::{WHAT_CAN_STAND_HERE, Words};
use crate::reader::Reader;
use crate::table::Section;

/// Sampling method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// `monte-carlo`: independent samples.
    MonteCarlo,
    /// `latin-hypercube`: a replicate of n samples divides the range of each random number into n equally
    /// probable intervals. Each interval contains one sample.
    LatinHypercube,
    /// `sobol`: Sobol's sequence with Owen scrambling. The scrambling is different in each replicate.
    Sobol,
}

impl Sampling {
    const ALL: [Sampling; 3] = [Sampling::MonteCarlo, Sampling::LatinHypercube, Sampling::Sobol];

    /// Name in files.
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
    message: "`{}` is not a value of `sampling`",
    hint: WHAT_CAN_STAND_HERE,
};

/// Number of samples, seed and sampling method of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    /// Number of samples.
    pub samples: u64,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Sampling method.
    pub sampling: Sampling,
    /// Number of independent replicates. The scatter between the replicates estimates the sampling error. The
    /// number is 1 for `monte-carlo`, where all samples are independent.
    pub replicates: u64,
}

/// Default number of samples.
const SAMPLES: u64 = 10_000;
const REPLICATES: u64 = 16;
/// Maximum number of samples. It is below 2⁵³, so a program that stores numbers as doubles represents it
/// exactly.
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
                let message = "`replicates` does not apply to `monte-carlo`, whose samples are always independent";
                let hint = "leave `replicates` out, or use `latin-hypercube` or `sobol`";
                reader.report(Fault::new(code::MISPLACED, value.span(), message, "", hint));
            }
            1
        }
        _ => written.unwrap_or(REPLICATES),
    };
    Plan { samples, seed, sampling, replicates }
}

impl Plan {
    /// Returns the plan with another number of samples or another seed.
    pub fn with(self, samples: Option<u64>, seed: Option<u64>) -> Self {
        Plan { samples: samples.unwrap_or(self.samples), seed: seed.unwrap_or(self.seed), ..self }
    }

    /// Returns a message that explains why the number of samples is invalid; `None` if it is valid.
    pub fn problem(&self) -> Option<String> {
        let Plan { samples, replicates, .. } = *self;
        if !(1..=MOST_SAMPLES).contains(&samples) {
            return Some(format!("the number of samples must be from 1 to {MOST_SAMPLES}"));
        }
        if !samples.is_multiple_of(replicates) {
            let down = samples - samples % replicates;
            let near = if down == 0 { replicates } else { down };
            return Some(format!(
                "{samples} samples cannot be divided into {replicates} equal replicates; {near} samples can"
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
