//! Places the unbounded uniform loads of a moving train. Codes of practice apply such loads only where they are unfavourable.
//!
//! With lift-off, influence lines do not exist. The most unfavourable of several solved placements governs.

use groundbeam::Load;
use groundbeam::model::{Train, UniformPart};

/// Train, with the range of positions through which it moves.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingTrain {
    /// Name of the train in the file.
    pub name: String,
    /// Name of the built-in train set that defines the train, such as `LM71`; `None` if the file gives the loads of
    /// the train.
    pub set: Option<String>,
    /// Load case of the train. A train without a load case acts in every combination with the factor 1.
    pub case: Option<String>,
    /// Factor already applied to the loads of the train.
    pub factor: f64,
    /// Dynamic factor already applied to the axles of the train.
    pub dynamic: f64,
    /// Placement of those distributed loads of the train that have infinite length.
    pub spread: Spread,
    /// Axles and uniform loads of the train. All loads are already multiplied by `factor`, and the axle loads also by
    /// `dynamic`.
    pub train: Train,
    /// First and last position of the first axle \[m\].
    pub range: [f64; 2],
}

/// Placement of those distributed loads of a train that have infinite length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Spread {
    /// No load of infinite length is shortened or omitted.
    #[default]
    Everywhere,
    /// The loads of infinite length act only ahead of the train.
    Ahead,
    /// The loads of infinite length act only behind the train.
    Behind,
    /// Each lane load, a distributed load without front end and rear end, covers only the left half of the beam.
    LeftHalf,
    /// Each lane load, a distributed load without front end and rear end, covers only the right half of the beam.
    RightHalf,
    /// The loads of infinite length are omitted from the train.
    Nowhere,
}

impl Spread {
    /// Returns the name of the placement.
    pub fn name(self) -> &'static str {
        match self {
            Spread::Everywhere => "everywhere",
            Spread::Ahead => "ahead",
            Spread::Behind => "behind",
            Spread::LeftHalf => "on the left half",
            Spread::RightHalf => "on the right half",
            Spread::Nowhere => "nowhere",
        }
    }
}

/// Whether the front end and the rear end of a uniform load are each at a finite distance from the first axle.
fn ends(part: &UniformPart) -> [bool; 2] {
    [part.from.is_finite(), part.to.is_finite()]
}

impl MovingTrain {
    /// Whether a distributed load of the train has infinite length.
    pub fn has_endless_load(&self) -> bool {
        self.train.uniform.iter().any(|part| ends(part) != [true, true])
    }

    /// Returns the train and its fixed loads for each placement of its endless loads. Only a lane load (without ends)
    /// on one half of the beam is fixed.
    pub fn placements(&self, beam_length: f64) -> Vec<(MovingTrain, Vec<Load>)> {
        let has = |which: [bool; 2]| self.train.uniform.iter().any(|part| ends(part) == which);
        let (ahead, behind, lane) = (has([false, true]), has([true, false]), has([false, false]));
        let mut places = vec![Spread::Everywhere];
        if ahead && behind {
            places.extend([Spread::Ahead, Spread::Behind]);
        }
        if lane {
            places.extend([Spread::LeftHalf, Spread::RightHalf]);
        }
        let is_empty = self.train.axles.is_empty() && !has([true, true]);
        if self.has_endless_load() && !is_empty {
            places.push(Spread::Nowhere);
        }
        places.into_iter().map(|place| self.placed(place, beam_length)).collect()
    }

    fn placed(&self, spread: Spread, beam_length: f64) -> (MovingTrain, Vec<Load>) {
        let stays = |part: &&UniformPart| {
            let is_half = matches!(spread, Spread::LeftHalf | Spread::RightHalf);
            match (ends(part), spread) {
                ([true, true], _) | (_, Spread::Everywhere) => true,
                ([false, true], spread) => is_half || spread == Spread::Ahead,
                ([true, false], spread) => is_half || spread == Spread::Behind,
                ([false, false], _) => false,
            }
        };
        let middle = 0.5 * beam_length;
        let half = match spread {
            Spread::LeftHalf => Some([0.0, middle]),
            Spread::RightHalf => Some([middle, beam_length]),
            _ => None,
        };
        let lanes = self.train.uniform.iter().filter(|part| ends(part) == [false, false]);
        let fixed = half.map_or_else(Vec::new, |[from, to]| {
            lanes.map(|part| Load::uniform_force(from, to, part.intensity)).collect()
        });
        let uniform = self.train.uniform.iter().filter(stays).copied().collect();
        let train = Train { axles: self.train.axles.clone(), uniform };
        (MovingTrain { train, spread, ..self.clone() }, fixed)
    }

    /// Returns the name of the train. If its uniform loads of unlimited length act on a part of the beam only, the name
    /// of this part follows.
    pub fn placed_name(&self) -> String {
        match self.spread {
            Spread::Everywhere => self.name.clone(),
            place => format!("{}, spread load {}", self.name, place.name()),
        }
    }

    /// Returns the train with its loads multiplied by a partial factor.
    pub fn multiplied(&self, factor: f64) -> MovingTrain {
        let train = self.train.clone().scaled(factor);
        MovingTrain { train, factor: factor * self.factor, ..self.clone() }
    }

    /// Returns a train without axles and loads, for solves without a train.
    pub fn absent() -> MovingTrain {
        MovingTrain {
            name: "no train".to_owned(),
            set: None,
            case: None,
            factor: 1.0,
            dynamic: 1.0,
            spread: Spread::Everywhere,
            train: Train::default(),
            range: [0.0, 0.0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trains;

    fn of(set: &str) -> MovingTrain {
        MovingTrain { train: trains::find(set).unwrap().train.clone(), ..MovingTrain::absent() }
    }

    fn places(set: &str) -> Vec<Spread> {
        of(set).placements(20.0).into_iter().map(|(train, _)| train.spread).collect()
    }

    #[test]
    fn unbounded_loads_have_all_placements_that_may_be_unfavourable() {
        use Spread::{Ahead, Behind, Everywhere, LeftHalf, Nowhere, RightHalf};
        assert_eq!(places("LM71"), [Everywhere, Ahead, Behind, Nowhere]);
        assert_eq!(places("LM1"), [Everywhere, LeftHalf, RightHalf, Nowhere]);
        assert_eq!(places("Cooper E80"), [Everywhere, Nowhere]);
        assert_eq!(places("unloaded train"), [Everywhere, LeftHalf, RightHalf]);
        assert_eq!(places("SW/0"), [Everywhere]);
    }

    #[test]
    fn a_lane_load_on_half_of_the_beam_does_not_move() {
        let halves = &of("LM1").placements(20.0)[1..3];
        let loads: Vec<&[Load]> = halves.iter().map(|(_, loads)| &loads[..]).collect();
        let lane = |from, to| [Load::uniform_force(from, to, 27e3)];
        assert_eq!(loads, [lane(0.0, 10.0), lane(10.0, 20.0)]);
        assert!(halves.iter().all(|(train, _)| train.train.uniform.is_empty()));
        let ahead = &of("LM71").placements(20.0)[1].0.train.uniform;
        assert_eq!((ahead.len(), ahead[0].to), (1, -0.8));
    }
}
