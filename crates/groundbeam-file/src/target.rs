//! Numbers of a model by the names that programs and studies know them by, and how to change them.

use crate::document::Document;
use crate::quantity::{
    BENDING_STIFFNESS, CURVATURE, FORCE, Kind, LOAD_PER_LENGTH, MOMENT, MOMENT_PER_LENGTH,
    POSITION, RATIO, SHEAR_CONSTANT, SPRING_PER_LENGTH,
};
use groundbeam::{Beam, Load, Model, Profile};

/// A number of a model, or a factor of several.
///
/// ```
/// use groundbeam_file::Target;
///
/// assert_eq!(Target::parse("k_factor"), Some(Target::SpringFactor));
/// assert!(Target::parse("load[2].at").is_some());
/// assert_eq!(Target::parse("spring"), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// `k` \[N/m²\], or k at even points along the beam.
    Spring,
    /// `mu` \[N\], or μ at even points along the beam.
    Shear,
    /// `EI` \[N·m²\], or EI at even points along the beam.
    Stiffness,
    /// `axial_force` \[N\], tension positive.
    AxialForce,
    /// `k_factor`: k is multiplied everywhere.
    SpringFactor,
    /// `mu_factor`: μ is multiplied everywhere.
    ShearFactor,
    /// `EI_factor`: EI is multiplied everywhere.
    StiffnessFactor,
    /// `load_factor`: all loads are multiplied.
    LoadFactor,
    /// `load[0]`, `load[0].at`, …: a number of a load, which count from 0.
    Load(usize, OfLoad),
}

/// A number of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfLoad {
    /// `load[0]`: its force, moment or intensity.
    Size,
    /// `load[0].at`: where it stands \[m\].
    At,
    /// `load[0].from`: where a spread load begins \[m\].
    From,
    /// `load[0].to`: where a spread load ends \[m\].
    To,
    /// `load[0].start`: the intensity of a spread load at its left end.
    Start,
    /// `load[0].end`: the intensity of a spread load at its right end.
    End,
}

/// How a quantity runs between numbers at even points from one end of the beam to the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Course {
    /// Straight from one point to the next.
    #[default]
    Lines,
    /// As many equal stretches as there are numbers, each with one of them.
    Steps,
}

impl Target {
    /// All names, for messages.
    pub const NAMES: &'static str = "k, mu, EI, axial_force, k_factor, mu_factor, EI_factor, load_factor, and of \
                                     loads load[0], load[0].at, load[0].from, load[0].to, load[0].start, load[0].end";

    /// The number of a name; none if nothing is called so.
    pub fn parse(name: &str) -> Option<Self> {
        Some(match name {
            "k" => Target::Spring,
            "mu" => Target::Shear,
            "EI" => Target::Stiffness,
            "axial_force" => Target::AxialForce,
            "k_factor" => Target::SpringFactor,
            "mu_factor" => Target::ShearFactor,
            "EI_factor" => Target::StiffnessFactor,
            "load_factor" => Target::LoadFactor,
            _ => {
                let (number, part) = name.strip_prefix("load[")?.split_once(']')?;
                let part = match part {
                    "" => OfLoad::Size,
                    ".at" => OfLoad::At,
                    ".from" => OfLoad::From,
                    ".to" => OfLoad::To,
                    ".start" => OfLoad::Start,
                    ".end" => OfLoad::End,
                    _ => return None,
                };
                Target::Load(number.parse().ok()?, part)
            }
        })
    }

    /// Whether it may be given at points along the beam.
    pub fn varies_along_the_beam(self) -> bool {
        matches!(self, Target::Spring | Target::Shear | Target::Stiffness)
    }

    /// Whether the model cannot be solved unless it is positive.
    pub fn must_be_positive(self) -> bool {
        use Target::{Spring, SpringFactor, Stiffness, StiffnessFactor};
        matches!(self, Spring | Stiffness | SpringFactor | StiffnessFactor)
    }

    fn is_of_ground(self) -> bool {
        use Target::{Shear, ShearFactor, Spring, SpringFactor};
        matches!(self, Spring | Shear | SpringFactor | ShearFactor)
    }

    /// What it counts, in a model that has it.
    pub(crate) fn kind(self, model: &Model) -> &'static Kind {
        match self {
            Target::Spring => &SPRING_PER_LENGTH,
            Target::Shear => &SHEAR_CONSTANT,
            Target::Stiffness => &BENDING_STIFFNESS,
            Target::AxialForce => &FORCE,
            Target::Load(_, OfLoad::At | OfLoad::From | OfLoad::To) => &POSITION,
            Target::Load(index, _) => match model.loads.get(index) {
                Some(Load::PointForce { .. } | Load::GroundForce { .. }) => &FORCE,
                Some(Load::PointMoment { .. }) => &MOMENT,
                Some(Load::DistributedMoment { .. }) => &MOMENT_PER_LENGTH,
                Some(Load::Curvature { .. }) => &CURVATURE,
                _ => &LOAD_PER_LENGTH,
            },
            _ => &RATIO,
        }
    }

    /// The number as the model has it; of factors 1, of what varies its value at the left end.
    pub fn value(self, model: &Model) -> Option<f64> {
        Some(match self {
            Target::Spring => model.foundation.spring,
            Target::Shear => model.foundation.shear,
            Target::Stiffness => model.beam.bending_stiffness,
            Target::AxialForce => model.beam.axial_force,
            Target::Load(index, part) => value_of(model.loads.get(index)?, part)?,
            _ => 1.0,
        })
    }

    /// Why it cannot be changed in a file's model, if it cannot.
    pub fn problem(self, name: &str, document: &Document) -> Option<String> {
        let model = &document.model;
        if self.is_of_ground() && document.bed.is_some() {
            return Some("the model's ground is made of its soil".to_owned());
        }
        let has_segments = match self {
            Target::Spring | Target::Shear => !model.foundation.segments.is_empty(),
            Target::Stiffness => !model.beam.segments.is_empty(),
            _ => false,
        };
        if has_segments {
            return Some(format!(
                "the model gives it by segments; `{name}_factor` multiplies it in all of them"
            ));
        }
        let Target::Load(index, part) = self else { return None };
        let Some(load) = model.loads.get(index) else {
            let count = model.loads.len();
            return Some(format!("loads count from 0, and the model has {count}"));
        };
        changed(*load, part, 0.0).is_none().then(|| "the load has no such number".to_owned())
    }
}

/// A number for a target, or several along the beam.
pub type Change<'a> = (Target, &'a [f64]);

/// The model with numbers changed: what is set is set first, then what multiplies multiplies.
pub fn change<'a>(
    model: &mut Model,
    course: Course,
    changes: impl Iterator<Item = Change<'a>> + Clone,
) {
    let mut ground: [Option<&[f64]>; 2] = [None, None];
    for (target, row) in changes.clone() {
        match target {
            Target::Spring if row.len() > 1 => ground[0] = Some(row),
            Target::Shear if row.len() > 1 => ground[1] = Some(row),
            Target::Stiffness if row.len() > 1 => vary_stiffness(&mut model.beam, course, row),
            Target::Spring => model.foundation.spring = row[0],
            Target::Shear => model.foundation.shear = row[0],
            Target::Stiffness => model.beam.bending_stiffness = row[0],
            Target::AxialForce => model.beam.axial_force = row[0],
            Target::Load(index, part) => {
                if let Some(load) = model.loads.get_mut(index)
                    && let Some(changed) = changed(*load, part, row[0])
                {
                    *load = changed;
                }
            }
            _ => {}
        }
    }
    vary_ground(model, course, ground);
    for (target, row) in changes {
        let factor = row[0];
        match target {
            Target::SpringFactor => scale_ground(model, factor, 1.0),
            Target::ShearFactor => scale_ground(model, 1.0, factor),
            Target::StiffnessFactor => {
                model.beam.bending_stiffness *= factor;
                for segment in &mut model.beam.segments {
                    segment.bending_stiffness = segment.bending_stiffness.scaled(factor);
                }
            }
            Target::LoadFactor => {
                for load in &mut model.loads {
                    *load = load.scaled(factor);
                }
            }
            _ => {}
        }
    }
}

fn scale_ground(model: &mut Model, spring: f64, shear: f64) {
    model.foundation = model.foundation.clone().scaled(spring, shear);
}

impl Course {
    /// How many stretches so many numbers make.
    fn stretches(self, numbers: usize) -> usize {
        match self {
            Course::Lines => numbers - 1,
            Course::Steps => numbers,
        }
    }

    /// The course of a stretch.
    fn of(self, values: &[f64], stretch: usize) -> Profile {
        match self {
            Course::Lines => Profile::linear(values[stretch], values[stretch + 1]),
            Course::Steps => Profile::constant(values[stretch]),
        }
    }
}

fn vary_stiffness(beam: &mut Beam, course: Course, values: &[f64]) {
    let length = beam.length;
    let count = course.stretches(values.len());
    for i in 0..count {
        let [from, to] = ends(length, i, count);
        *beam = std::mem::replace(beam, Beam::uniform(length, values[0])).with_varying_segment(
            from,
            to,
            course.of(values, i),
        );
    }
}

fn vary_ground(model: &mut Model, course: Course, ground: [Option<&[f64]>; 2]) {
    let Some(points) = ground.iter().flatten().map(|values| values.len()).next() else { return };
    let length = model.beam.length;
    let mut foundation = model.foundation.clone();
    let elsewhere = [foundation.spring, foundation.shear];
    let count = course.stretches(points);
    for i in 0..count {
        let [from, to] = ends(length, i, count);
        let [spring, shear] = [0, 1].map(|which| match ground[which] {
            Some(values) => course.of(values, i),
            None => Profile::constant(elsewhere[which]),
        });
        foundation = foundation.with_varying_segment(from, to, spring, shear);
    }
    model.foundation = foundation;
}

/// The ends of one of `count` equal parts of the beam: those of neighbours are the same number.
fn ends(length: f64, part: usize, count: usize) -> [f64; 2] {
    [part, part + 1].map(|i| length * (i as f64 / count as f64))
}

/// A load with one of its numbers changed; none if it has no such number.
fn changed(load: Load, part: OfLoad, value: f64) -> Option<Load> {
    let mut load = load;
    match (&mut load, part) {
        (Load::PointForce { force: size, .. }, OfLoad::Size)
        | (Load::PointMoment { moment: size, .. }, OfLoad::Size) => *size = value,
        (Load::PointForce { at, .. } | Load::PointMoment { at, .. }, OfLoad::At) => *at = value,
        (
            Load::Distributed { from, to, start, end }
            | Load::DistributedMoment { from, to, start, end }
            | Load::Curvature { from, to, start, end },
            part,
        ) => match part {
            OfLoad::Size => [*start, *end] = [value; 2],
            OfLoad::From => *from = value,
            OfLoad::To => *to = value,
            OfLoad::Start => *start = value,
            OfLoad::End => *end = value,
            OfLoad::At => return None,
        },
        _ => return None,
    }
    Some(load)
}

/// A number of a load; none if it has no such number.
fn value_of(load: &Load, part: OfLoad) -> Option<f64> {
    match (*load, part) {
        (Load::PointForce { force: size, .. }, OfLoad::Size)
        | (Load::PointMoment { moment: size, .. }, OfLoad::Size) => Some(size),
        (Load::PointForce { at, .. } | Load::PointMoment { at, .. }, OfLoad::At) => Some(at),
        (
            Load::Distributed { from, to, start, end }
            | Load::DistributedMoment { from, to, start, end }
            | Load::Curvature { from, to, start, end },
            part,
        ) => match part {
            OfLoad::Size | OfLoad::Start => Some(start),
            OfLoad::From => Some(from),
            OfLoad::To => Some(to),
            OfLoad::End => Some(end),
            OfLoad::At => None,
        },
        _ => None,
    }
}
