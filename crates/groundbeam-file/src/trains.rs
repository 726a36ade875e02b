//! Reads the trains of codes of practice from the data files in `trains/`.

use crate::catalogue::{self, Entry};
use crate::quantity::{FORCE, LOAD_PER_LENGTH, POSITION};
use groundbeam::model::{Axle, Train, UniformPart};
use serde::Deserialize;
use std::sync::LazyLock;

/// A code of practice and its trains.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Practice {
    code: String,
    #[serde(rename = "train")]
    trains: Vec<Listed>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Listed {
    name: String,
    #[serde(default)]
    also: Vec<String>,
    source: String,
    remark: Option<String>,
    #[serde(default)]
    axles: Vec<ListedAxle>,
    #[serde(default)]
    uniform: Vec<ListedPart>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ListedAxle {
    at: String,
    force: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ListedPart {
    from: Option<String>,
    to: Option<String>,
    load: String,
}

/// A built-in train, which a model file selects with `[[train]] set = "…"`.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainSet {
    /// Name of the train.
    pub name: String,
    /// Alternative names.
    pub also: Vec<String>,
    /// The code of practice.
    pub code: String,
    /// Clause and figure of the code that define the train.
    pub source: String,
    /// The remark `one source …` if a value of the train is not confirmed by a second source.
    pub remark: Option<String>,
    /// The train, in N and m.
    pub train: Train,
}

static SETS: LazyLock<Vec<TrainSet>> = LazyLock::new(|| {
    let practices: Vec<Practice> = catalogue::files(&[
        include_str!("../trains/en-1991-2.toml"),
        include_str!("../trains/aashto-lrfd.toml"),
        include_str!("../trains/arema.toml"),
        include_str!("../trains/as-5100.toml"),
        include_str!("../trains/csa-s6.toml"),
        include_str!("../trains/irc-6.toml"),
    ]);
    practices.into_iter().flat_map(sets_of).collect()
});

/// Returns all built-in trains.
///
/// ```
/// let sets = groundbeam_file::train_sets();
/// let found = sets.iter().find(|set| set.name == "LM71").unwrap();
/// assert_eq!((found.train.axles.len(), found.train.axles[3].behind), (4, 4.8));
/// ```
pub fn train_sets() -> &'static [TrainSet] {
    &SETS
}

/// Returns the train with this name.
pub(crate) fn find(name: &str) -> Option<&'static TrainSet> {
    SETS.iter().find(|set| set.is_called(name))
}

/// Returns the names of all trains, without their alternative names.
pub(crate) fn names() -> Vec<&'static str> {
    SETS.iter().map(|set| &*set.name).collect()
}

/// Returns the main and alternative names of all trains.
pub(crate) fn spellings() -> Vec<&'static str> {
    catalogue::spellings(SETS.iter())
}

impl Entry for TrainSet {
    fn name(&self) -> &str {
        &self.name
    }

    fn also(&self) -> &[String] {
        &self.also
    }
}

fn sets_of(practice: Practice) -> impl Iterator<Item = TrainSet> {
    let Practice { code, trains } = practice;
    trains.into_iter().map(move |listed| TrainSet {
        train: listed.train(),
        name: listed.name,
        also: listed.also,
        code: code.clone(),
        source: listed.source,
        remark: listed.remark,
    })
}

impl Listed {
    fn train(&self) -> Train {
        let axle = |axle: &ListedAxle| Axle {
            behind: POSITION.listed(&axle.at),
            force: FORCE.listed(&axle.force),
        };
        let end = |end: &Option<String>, without: f64| {
            end.as_ref().map_or(without, |end| POSITION.listed(end))
        };
        let part = |part: &ListedPart| UniformPart {
            from: end(&part.from, f64::NEG_INFINITY),
            to: end(&part.to, f64::INFINITY),
            intensity: LOAD_PER_LENGTH.listed(&part.load),
        };
        Train {
            axles: self.axles.iter().map(axle).collect(),
            uniform: self.uniform.iter().map(part).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_train_begins_at_0_and_has_numbers_only() {
        for TrainSet { name, train, source, .. } in train_sets() {
            assert!(!source.is_empty());
            let ends = train.uniform.iter().map(|part| part.from.max(0.0));
            let head = train.axles.iter().map(|axle| axle.behind).chain(ends).reduce(f64::min);
            assert_eq!(head, Some(0.0), "{name}");
            assert!(train.axles.is_sorted_by(|a, b| a.behind < b.behind), "{name}");
            assert!(train.axles.iter().all(|axle| axle.force.is_finite()), "{name}");
            assert!(train.uniform.iter().all(|part| part.to > part.from), "{name}");
            assert!(train.uniform.iter().all(|part| part.intensity.is_finite()), "{name}");
        }
    }

    #[test]
    fn trains_agree_with_their_codes() {
        let sum = |name: &str| -> f64 {
            find(name).unwrap().train.axles.iter().map(|axle| axle.force).sum()
        };
        assert_eq!(sum("LM71"), 1e6);
        assert_eq!((sum("LM1"), find("LM1").unwrap().train.uniform[0].intensity), (600e3, 27e3));
        assert_eq!((sum("M1600"), sum("300LA"), sum("IRC class A")), (1440e3, 3960e3, 554e3));
        assert_eq!((sum("CL-625 truck"), sum("SW/0")), (625e3, 0.0));
        let spread: f64 =
            find("SW/0").unwrap().train.uniform.iter().map(|p| (p.to - p.from) * p.intensity).sum();
        assert!((spread - 2.0 * 15.0 * 133e3).abs() < 1e-6);
        // By EN 1991-2, 6.4.6.1.1, the train HSLM-A1 has 50 axles of 170 kN over 37.525 + (18 + 2) * 18 metres.
        let longest = &find("HSLM-A1").unwrap().train;
        assert_eq!((longest.axles.len(), sum("HSLM-A1")), (50, 8500e3));
        assert!((longest.length() - 397.525).abs() < 1e-9);
        // The loads are 72 kip (HL-93 truck), 50 kip (HL-93 tandem), and two engines of 568 kip (E80).
        let kip = 4448.2216152605;
        for (name, kips) in [("HL-93 truck", 72.0), ("HL-93 tandem", 50.0), ("E80", 1136.0)] {
            assert!((sum(name) / (kips * kip) - 1.0).abs() < 1e-14, "{name}");
        }
        assert!((find("E80").unwrap().train.length() - 104.0 * 0.3048).abs() < 1e-12);
    }
}
