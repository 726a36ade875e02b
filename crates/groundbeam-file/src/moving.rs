//! A moving train, and the placement of its unbounded uniform loads. Codes of practice apply such loads only
//! where they are unfavourable.
//!
//! With lift-off, influence lines do not exist. So the program solves a list of placements, and the worst
//! result governs.

use groundbeam::Load;
use groundbeam::model::{Train, UniformPart};

/// A train, and the range that it travels.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingTrain {
    /// Its name in the file.
    pub name: String,
    /// The set it belongs to; `None` if the file gives its loads.
    pub set: Option<String>,
    /// Its load case. `None`: it passes in every combination with the factor 1.
    pub case: Option<String>,
    /// Factor already applied to its loads.
    pub factor: f64,
    /// Dynamic factor already applied to its axles.
    pub dynamic: f64,
    /// Placement of its unbounded loads.
    pub spread: Spread,
    /// The train with these factors applied.
    pub train: Train,
    /// First and last position of its first axle \[m\].
    pub range: [f64; 2],
}

/// Placement of the unbounded loads of a train.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Spread {
    /// As the train gives them.
    #[default]
    Everywhere,
    /// Only ahead of the train.
    Ahead,
    /// Only behind the train.
    Behind,
    /// On the left half of the beam, for a load without ends.
    LeftHalf,
    /// On the right half of the beam.
    RightHalf,
    /// Left out.
    Nowhere,
}

impl Spread {
    /// Name of the placement.
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

/// Whether a part is unbounded ahead of the train and behind it.
fn ends(part: &UniformPart) -> [bool; 2] {
    [part.from.is_finite(), part.to.is_finite()]
}

impl MovingTrain {
    /// Whether a load of the train is unbounded.
    pub fn has_endless_load(&self) -> bool {
        self.train.uniform.iter().any(|part| ends(part) != [true, true])
    }

    /// The train with its unbounded loads in each placement, and the loads that then act on the beam.
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

    /// The name of the train, followed by the placement of its unbounded loads unless they act everywhere.
    pub fn placed_name(&self) -> String {
        match self.spread {
            Spread::Everywhere => self.name.clone(),
            place => format!("{}, spread load {}", self.name, place.name()),
        }
    }

    /// The train with a partial factor applied.
    pub fn multiplied(&self, factor: f64) -> MovingTrain {
        let train = self.train.clone().scaled(factor);
        MovingTrain { train, factor: factor * self.factor, ..self.clone() }
    }

    /// A passage without a train: the beam under the other loads.
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
