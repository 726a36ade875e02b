//! Computes the random numbers and the model of sample i of a study from its index i.

use crate::distribution::{lognormal, normal_of, of_normal};
use crate::fields::Field;
use crate::points::Points;
use crate::symmetric::Symmetric;
use groundbeam::Model;
use groundbeam::derivatives::{Domain, Parameter, Property};
use groundbeam_file::study::{Plan, StudyFile};
use groundbeam_file::{Change, Course, Shape, change};
use std::fmt;

/// The reason why samples cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Impossible {
    /// The number of samples is not allowed; the text gives the reason.
    Samples(String),
    /// The required correlations are contradictory.
    Correlations,
    /// The circulant embedding of the random field is not positive definite.
    Circle,
}

impl fmt::Display for Impossible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Impossible::Samples(words) => f.write_str(words),
            Impossible::Correlations => {
                f.write_str("the correlations in [[correlated]] are contradictory: reduce some values of rho")
            }
            Impossible::Circle => f.write_str(
                "the circulant method fails for this correlation: use method = \"karhunen-loeve\", more points, or a \
                 shorter correlation length",
            ),
        }
    }
}

impl std::error::Error for Impossible {}

/// The samples of a study; each is computed from its index only.
#[derive(Debug, Clone)]
pub struct Draws {
    study: StudyFile,
    plan: Plan,
    /// Number of independent standard normal variables of a sample.
    dimensions: usize,
    points: Points,
    field: Option<Field>,
    /// Cholesky factor L of the correlation matrix L Lᵀ of the random numbers; `None` if they are independent.
    joined: Option<Vec<Vec<f64>>>,
}

/// The random numbers and fields of a sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Draw {
    /// The random numbers, in the order of the study file.
    pub numbers: Vec<f64>,
    /// Values of the random fields at their points. The fields are in the order k, μ, EI.
    pub fields: Vec<Vec<f64>>,
}

impl Draws {
    /// Creates the samples of a study. `plan` may have another number of samples and another seed than the study file.
    ///
    /// # Errors
    ///
    /// Returns the reason if samples cannot be drawn.
    pub fn new(study: StudyFile, plan: Plan) -> Result<Self, Impossible> {
        if let Some(problem) = plan.problem() {
            return Err(Impossible::Samples(problem));
        }
        let count = study.random.len();
        let joined = if study.joined.is_empty() {
            None
        } else {
            let correlation = |i: usize, j: usize| {
                let joined =
                    study.joined.iter().find(|joined| joined.of == [i, j] || joined.of == [j, i]);
                joined.map_or(f64::from(i == j), |joined| joined.rho)
            };
            Some(Symmetric::new(count, correlation).root().ok_or(Impossible::Correlations)?)
        };
        let length = study.document.model.beam.length;
        let field = match &study.field {
            None => None,
            Some(random) => Some(Field::new(random, length).ok_or(Impossible::Circle)?),
        };
        let of_fields = field.as_ref().map_or(0, Field::numbers)
            * study.field.as_ref().map_or(0, |random| random.of.len());
        let dimensions = count + of_fields;
        let points = Points::new(plan, dimensions);
        Ok(Draws { study, plan, dimensions, points, field, joined })
    }

    /// The study that is sampled.
    pub fn study(&self) -> &StudyFile {
        &self.study
    }

    /// The sampling plan: number of samples, seed, sampling method and number of replicates.
    pub fn plan(&self) -> Plan {
        self.plan
    }

    /// Number of independent standard normal variables of a sample.
    pub fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// Fraction of the variance of the random fields that the kept terms of their series expansion represent;
    /// `None` without random fields.
    pub fn variance(&self) -> Option<f64> {
        self.field.as_ref().map(Field::variance)
    }

    /// Draws the random numbers and fields of the sample with this index. The first index is 0.
    pub fn draw(&self, sample: u64) -> Draw {
        let mut normal = vec![0.0; self.dimensions];
        self.points.fill(sample, &mut normal);
        for coordinate in &mut normal {
            *coordinate = normal_of(*coordinate);
        }
        let (own, rest) = normal.split_at(self.study.random.len());
        let joined = |i: usize| match &self.joined {
            None => own[i],
            Some(root) => root[i].iter().zip(own).map(|(entry, number)| entry * number).sum(),
        };
        let random = self.study.random.iter().enumerate();
        let numbers = random.map(|(i, random)| of_normal(&random.distribution, joined(i)));
        Draw { numbers: numbers.collect(), fields: self.fields(rest) }
    }

    fn fields(&self, numbers: &[f64]) -> Vec<Vec<f64>> {
        let (Some(random), Some(field)) = (&self.study.field, &self.field) else {
            return Vec::new();
        };
        // The first numbers of a sample are distributed most evenly over all samples. So every random field uses them
        // for its first and largest terms.
        let count = random.of.len();
        let normal: Vec<Vec<f64>> = (0..count)
            .map(|i| field.of(&numbers.iter().skip(i).step_by(count).copied().collect::<Vec<_>>()))
            .collect();
        let place = |property| random.of.iter().position(|of| of.property == property);
        let (spring, shear) = (place(Property::Spring), place(Property::Shear));
        let own = (1.0 - random.rho * random.rho).sqrt();
        let value = |i: usize, point: usize| {
            let z = match spring {
                Some(spring) if Some(i) == shear => {
                    random.rho * normal[spring][point] + own * normal[i][point]
                }
                _ => normal[i][point],
            };
            lognormal(random.of[i].mean, random.of[i].deviation, z)
        };
        (0..count).map(|i| (0..random.points).map(|point| value(i, point)).collect()).collect()
    }

    /// The model with the random numbers and fields of a draw.
    pub fn model(&self, draw: &Draw) -> Model {
        let StudyFile { document, random, field, .. } = &self.study;
        let mut model = document.model.clone();
        let numbers = random.iter().zip(&draw.numbers);
        let shape = Shape::Even(field.as_ref().map_or(Course::Lines, |field| field.course));
        let numbers =
            numbers.map(|(random, number)| (random.target, shape, std::slice::from_ref(number)));
        let fields = field.iter().flat_map(|field| &field.of).zip(&draw.fields);
        let fields = fields.map(|(of, values)| -> Change {
            (Parameter::Value(of.property, Domain::Whole), shape, values)
        });
        change(&mut model, numbers.chain(fields));
        model
    }
}
