//! Trains of codes of practice: the data files in `trains/`.

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

/// A train that a model file can ask for, with `[[train]] set = "…"`.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainSet {
    /// Its name.
    pub name: String,
    /// Other names by which it can be asked for.
    pub also: Vec<String>,
    /// The code of practice.
    pub code: String,
    /// Clause and figure of the code.
    pub source: String,
    /// The train, in N and m.
    pub train: Train,
}

static SETS: LazyLock<Vec<TrainSet>> = LazyLock::new(|| {
    let practices: Vec<Practice> = catalogue::files(&[
        include_str!("../trains/en-1991-2.toml"),
        include_str!("../trains/aashto-lrfd.toml"),
        include_str!("../trains/arema.toml"),
    ]);
    practices.into_iter().flat_map(sets_of).collect()
});

/// Every train that a model file can ask for.
///
/// ```
/// let sets = groundbeam_file::train_sets();
/// let found = sets.iter().find(|set| set.name == "LM71").unwrap();
/// assert_eq!((found.train.axles.len(), found.train.axles[3].behind), (4, 4.8));
/// ```
pub fn train_sets() -> &'static [TrainSet] {
    &SETS
}

/// The set of a name.
pub(crate) fn find(name: &str) -> Option<&'static TrainSet> {
    SETS.iter().find(|set| set.is_called(name))
}

/// The names of all sets.
pub(crate) fn names() -> Vec<&'static str> {
    SETS.iter().map(|set| &*set.name).collect()
}

/// All names of all sets.
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
    fn every_train_begins_with_its_first_axle_and_has_numbers_only() {
        for TrainSet { name, train, source, .. } in train_sets() {
            assert!(!source.is_empty());
            assert_eq!(train.axles[0].behind, 0.0, "{name}");
            assert!(train.axles.is_sorted_by(|a, b| a.behind < b.behind), "{name}");
            assert!(train.axles.iter().all(|axle| axle.force.is_finite()), "{name}");
            assert!(train.uniform.iter().all(|part| part.to > part.from), "{name}");
            assert!(train.uniform.iter().all(|part| part.intensity.is_finite()), "{name}");
        }
    }

    #[test]
    fn numbers_of_the_codes() {
        let sum = |name: &str| -> f64 {
            find(name).unwrap().train.axles.iter().map(|axle| axle.force).sum()
        };
        assert_eq!(sum("LM71"), 1e6);
        assert_eq!(sum("LM1"), 600e3);
        // 72 kip, 50 kip, and two engines of 568 kip.
        let kip = 4448.2216152605;
        for (name, kips) in [("HL-93 truck", 72.0), ("HL-93 tandem", 50.0), ("E80", 1136.0)] {
            assert!((sum(name) / (kips * kip) - 1.0).abs() < 1e-14, "{name}");
        }
        assert!((find("E80").unwrap().train.length() - 104.0 * 0.3048).abs() < 1e-12);
    }
}
