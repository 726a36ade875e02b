//! Reads the multiprecision answers in `reference/answers`, and computes the distance of a solution from such an answer.

use groundbeam::{Field, Model, Solution, model::Extent, solution::Side};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// The reference solution of one model, computed in multiprecision arithmetic; `reference/README.md` describes the keys.
#[derive(Debug, Deserialize)]
pub struct Answer {
    /// Name of the model.
    pub name: String,
    /// Family of models.
    pub family: String,
    /// The model file.
    pub model: String,
    /// Regions of contact.
    pub contact: Vec<[f64; 2]>,
    /// Forces p₀ and p_l under the ends of the beam.
    pub end_forces: BTreeMap<String, f64>,
    /// Concentrated contact forces between the ends of the beam.
    #[serde(default)]
    pub inner_forces: Vec<InnerForce>,
    /// Support reactions.
    pub reactions: Vec<AnswerReaction>,
    /// Primal energy.
    pub primal_energy: f64,
    /// The largest absolute value of each field.
    pub largest: BTreeMap<String, f64>,
    /// Fields at stations.
    pub stations: BTreeMap<String, serde_json::Value>,
}

/// The reaction of a support.
#[derive(Debug, Deserialize)]
pub struct AnswerReaction {
    /// Position.
    pub at: f64,
    /// Force, up.
    pub force: f64,
    /// Moment of the support on the beam, positive if it acts against a positive slope.
    pub moment: f64,
}

/// A concentrated contact force between the ends of the beam.
#[derive(Debug, Deserialize)]
pub struct InnerForce {
    /// Position.
    pub x: f64,
    /// Force, up.
    pub force: f64,
}

/// The answers in `reference/doubtful.json`, for models whose contact state depends on the rounding errors of double
/// precision.
#[derive(Debug, Deserialize)]
pub struct Doubtful {
    /// Models with a stretch of the beam where the contact force or the clearance is below the rounding error.
    pub zones: Vec<DoubtfulZone>,
    /// The answer for a beam that is balanced on one kink of the ground surface.
    pub balance: Balance,
}

/// The reference answer for a model with a stretch on which doubles cannot decide whether the beam touches the ground.
#[derive(Debug, Deserialize)]
pub struct DoubtfulZone {
    /// The reference answer.
    #[serde(flatten)]
    pub answer: Answer,
    /// The stretch of the beam on which a computation in double precision cannot decide whether there is contact.
    pub doubtful: Stretch,
}

/// A stretch of the beam and whether it is in contact.
#[derive(Debug, Deserialize)]
pub struct Stretch {
    /// Left end.
    pub from: f64,
    /// Right end.
    pub to: f64,
    /// Whether the beam is in contact on this stretch.
    pub touches: bool,
}

/// The multiprecision solution for a beam that is balanced on one kink of the ground surface.
#[derive(Debug, Deserialize)]
pub struct Balance {
    /// Name of the model.
    pub name: String,
    /// The model file.
    pub model: String,
    /// Position of the kink of the ground surface on which the beam is balanced.
    pub at: f64,
    /// Contact force at the kink of the ground surface on which the beam is balanced.
    pub force: f64,
    /// Deflection of the beam at the kink of the ground surface on which it is balanced.
    pub deflection: f64,
    /// Settlement of the ground surface at the kink on which the beam is balanced.
    pub settlement: f64,
    /// The least and the largest slope at which the beam is in equilibrium.
    pub slopes: [f64; 2],
}

impl Doubtful {
    /// The stored answers.
    pub fn read() -> Doubtful {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reference/doubtful.json");
        let text = std::fs::read_to_string(&path).expect("a readable file");
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }
}

/// Reads a model from its text.
pub fn parsed(name: &str, text: &str) -> Model {
    match groundbeam_file::parse(text) {
        Ok(document) => document.model,
        Err(faults) => panic!("{}", faults.render(name, text, false)),
    }
}

/// The largest differences between a computed solution and the reference answer, relative to the largest value of
/// each quantity.
#[derive(Debug, Default, Clone, Copy)]
pub struct Distance {
    /// Largest difference between a computed field and its reference values at the stations, relative to the largest
    /// value of the field.
    pub fields: f64,
    /// Largest distance between a computed contact edge and the same edge of the reference answer, relative to the
    /// beam length; infinite if the numbers of contact regions differ.
    pub edges: f64,
    /// Largest difference between a computed end force or reaction and its reference value, relative to the largest
    /// force.
    pub forces: f64,
}

impl Distance {
    /// Returns the largest relative difference from the reference answer, over the fields, the contact edges and the
    /// forces.
    pub fn worst(&self) -> f64 {
        self.fields.max(self.edges).max(self.forces)
    }
}

impl Answer {
    /// Reads all answers in `reference/answers`, sorted by file name.
    pub fn all() -> Vec<Answer> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reference/answers");
        let mut files: Vec<_> = std::fs::read_dir(folder)
            .expect("the folder of answers")
            .map(|entry| entry.expect("a file of answers").path())
            .collect();
        files.sort();
        let read = |path: &std::path::PathBuf| -> Vec<Answer> {
            let text = std::fs::read_to_string(path).expect("a readable file");
            serde_json::from_str(&text)
                .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        };
        files.iter().flat_map(read).collect()
    }

    /// The model.
    pub fn parsed(&self) -> Model {
        parsed(&self.name, &self.model)
    }

    fn loaded_near(&self, x: f64, near: f64) -> bool {
        self.parsed().beam_loads().any(|load| match load.extent() {
            Extent::Point { at, .. } => (at - x).abs() <= near,
            Extent::Distributed { .. } => false,
        })
    }

    /// Returns the values of a key at all stations.
    pub(crate) fn numbers(&self, key: &str) -> Vec<f64> {
        let list = self.stations[key].as_array().expect("a list of numbers");
        list.iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
    }

    /// Returns the largest error of a field at the stations away from contact edges, minus the rounding error of the
    /// reference values.
    pub fn largest_error(&self, solution: &Solution, field: Field) -> f64 {
        let x = self.numbers("x");
        let sides = self.stations["side"].as_array().expect("a list of sides");
        let mut largest: f64 = 0.0;
        for ((&x, side), wanted) in x.iter().zip(sides).zip(self.numbers(field.name())) {
            if side == "" {
                let found = solution.value(field, x);
                let rounding = 4.0 * f64::EPSILON * self.largest[field.name()];
                largest = largest.max((found - wanted).abs() - rounding);
            }
        }
        largest
    }

    /// Returns the largest differences between a computed solution and this reference answer.
    pub fn distance(&self, solution: &Solution) -> Distance {
        let mut distance = Distance::default();
        let l = solution.model().beam.length;
        let x = self.numbers("x");
        let sides = self.stations["side"].as_array().expect("a list of sides");
        for field in Field::of(&solution.model().beam) {
            // The gap is a difference of deflections, so its error is divided by the larger of the largest gap and
            // the largest deflection.
            let largest = match field {
                Field::Gap => self.largest["gap"].max(self.largest["deflection"]),
                Field::Settlement => {
                    self.largest["settlement"].max(1e-9 * self.largest["deflection"])
                }
                _ => self.largest[field.name()],
            };
            let wanted = self.numbers(field.name());
            for ((&x, side), wanted) in x.iter().zip(sides).zip(wanted) {
                // At a contact edge, the reference values are one-sided. They are compared with the one-sided values at
                // the contact edge of the computed solution.
                let edges = solution.contact().iter().flat_map(|region| [region.from, region.to]);
                let near = |edge: &f64| side != "" && (edge - x).abs() <= 1e-11 * l;
                let edge = edges.into_iter().find(near);
                // If a load is within rounding error of a contact edge, it is undetermined which of the two is further
                // left.
                if edge.is_some() && self.loaded_near(x, 1e-11 * l) {
                    continue;
                }
                let x = edge.unwrap_or(x);
                let side = if side == "-" || x == l { Side::Left } else { Side::Right };
                let error = (solution.at(x, side).get(field) - wanted).abs();
                if error > 0.0 {
                    distance.fields = distance.fields.max(error / largest);
                }
            }
        }
        let found: Vec<f64> =
            solution.contact().iter().flat_map(|region| [region.from, region.to]).collect();
        let wanted: Vec<f64> = self.contact.iter().flatten().copied().collect();
        if found.len() == wanted.len() {
            for (a, b) in found.iter().zip(&wanted) {
                distance.edges = distance.edges.max((a - b).abs() / l);
            }
        } else {
            distance.edges = f64::INFINITY;
        }
        let ends = solution.end_forces();
        let mut forces =
            vec![(ends.left, self.end_forces["left"]), (ends.right, self.end_forces["right"])];
        for wanted in &self.reactions {
            let found = solution.reactions().iter().find(|found| found.at == wanted.at);
            forces.push((found.map_or(f64::NAN, |found| found.force), wanted.force));
        }
        let shear = self.largest["shear_force"];
        let scale = forces.iter().fold(shear, |scale, f| scale.max(f.1.abs()));
        for (found, wanted) in forces {
            if found != wanted {
                distance.forces = distance.forces.max((found - wanted).abs() / scale);
            }
        }
        distance
    }
}
