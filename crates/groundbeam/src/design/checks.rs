//! Design checks: limits beside the values of a solution.

use crate::existence::rigid_motions::Mechanism;
use crate::existence::statics::static_reactions;
use crate::model::Model;
use crate::solution::field::Field;
use crate::solution::solution::Solution;

/// Limits; none where nothing is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// The allowable bearing pressure \[Pa\], and the width on which the beam bears \[m\].
    pub bearing_pressure: Option<(f64, f64)>,
    /// The largest deflection down \[m\].
    pub settlement: Option<f64>,
    /// The largest part of the beam that may lift off, of its length.
    pub lifted_share: Option<f64>,
    /// The largest distance of the resultant from the beam's middle, of its length: 1/6 is the edge of the
    /// kern, beyond 1/3 EN 1997-1, 6.5.4 asks for special precautions.
    pub eccentricity: Option<f64>,
    /// The least factor on all loads that overturn at which the beam tips.
    pub overturning: Option<f64>,
}

/// What is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Checked {
    /// The largest contact pressure over the width \[Pa\]. Concentrated forces are no pressure.
    BearingPressure,
    /// The largest deflection down \[m\].
    Settlement,
    /// The part of the beam off the ground.
    LiftedShare,
    /// |x − l/2|/l of the resultant.
    Eccentricity,
    /// Stabilising over overturning moments about the end where it is smaller.
    Overturning,
}

/// A limit and what was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// What.
    pub what: Checked,
    /// What was found; infinite where nothing overturns.
    pub found: f64,
    /// The limit.
    pub limit: f64,
    /// Where it was found \[m\].
    pub at: Option<f64>,
}

impl Checked {
    /// The name that results use.
    pub fn name(self) -> &'static str {
        match self {
            Checked::BearingPressure => "bearing-pressure",
            Checked::Settlement => "settlement",
            Checked::LiftedShare => "lifted-share",
            Checked::Eccentricity => "eccentricity",
            Checked::Overturning => "overturning",
        }
    }

    /// The clause that asks for it; none where it is the engineer's own.
    pub fn clause(self) -> Option<&'static str> {
        match self {
            Checked::BearingPressure => Some("EN 1997-1, 6.5.2"),
            Checked::Settlement => Some("EN 1997-1, 6.6"),
            Checked::LiftedShare => None,
            Checked::Eccentricity => Some("EN 1997-1, 6.5.4"),
            Checked::Overturning => Some("EN 1990, 6.4.1(1)a"),
        }
    }
}

impl Check {
    /// Whether the limit is kept to.
    pub fn passes(&self) -> bool {
        match self.what {
            Checked::Overturning => self.found >= self.limit,
            _ => self.found <= self.limit,
        }
    }
}

impl Limits {
    /// The checks that are asked for, of a solution.
    ///
    /// ```
    /// use groundbeam::{Beam, Checked, Foundation, Limits, Load, Model, Outcome, solve};
    ///
    /// let model = Model::new(Beam::uniform(6.0, 1e9), Foundation::pasternak(40e6, 9e6))
    ///     .with_load(Load::point_force(4.0, 600e3));
    /// let Outcome::Equilibrium(solution) = solve(&model)? else { panic!("it stands") };
    /// let limits = Limits { eccentricity: Some(1.0 / 6.0), ..Limits::default() };
    /// let [check] = limits.check(&solution)[..] else { panic!("one") };
    /// assert!(check.passes() && (check.found - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok::<(), groundbeam::Error>(())
    /// ```
    pub fn check(&self, solution: &Solution) -> Vec<Check> {
        let model = solution.model();
        let l = model.beam.length;
        let mut checks = Vec::new();
        let mut add = |what, limit, found, at| checks.push(Check { what, found, limit, at });
        if let Some((allowable, width)) = self.bearing_pressure {
            let largest = solution.range(Field::Pressure).max;
            let found = largest.value / width;
            add(Checked::BearingPressure, allowable, found, Some(largest.x));
        }
        if let Some(limit) = self.settlement {
            let largest = solution.range(Field::Deflection).max;
            add(Checked::Settlement, limit, largest.value, Some(largest.x));
        }
        if let Some(limit) = self.lifted_share {
            add(Checked::LiftedShare, limit, solution.lifted_share(), None);
        }
        if let Some(limit) = self.eccentricity
            && let Some(x) = solution.existence().resultant_position(l)
        {
            // A resultant on the very edge is on the right side of it.
            let found = (x / l - 0.5).abs();
            let found = if (found - limit).abs() <= ROUNDED { limit } else { found };
            add(Checked::Eccentricity, limit, found, Some(x));
        }
        if let Some(limit) = self.overturning {
            add(Checked::Overturning, limit, overturning(model), None);
        }
        checks
    }
}

const ROUNDED: f64 = 8.0 * f64::EPSILON;

/// The factor on all loads that overturn a beam at which it tips: at each end, and at each free hinge, what the loads
/// that hold it down carry over what the others lift there. Infinite where none lifts.
pub fn overturning(model: &Model) -> f64 {
    let nodes = Mechanism::of(model).nodes;
    let mut sums = vec![[0.0; 2]; nodes.len()];
    for load in &model.loads {
        for (sums, reaction) in sums.iter_mut().zip(static_reactions(&[*load], &nodes)) {
            sums[usize::from(reaction.sum < 0.0)] += reaction.sum.abs();
        }
    }
    let margin = |[holding, lifting]: [f64; 2]| {
        if lifting == 0.0 { f64::INFINITY } else { holding / lifting }
    };
    sums.into_iter().map(margin).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};
    use crate::outcome::Outcome;
    use crate::solve::solve;

    /// Kikuchi's beam: (5.21), it tips as soon as M₀ reaches ½ f₀ l.
    #[test]
    fn the_margin_is_the_factor_on_the_moment() {
        let beam = || Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0));
        let model = |m: f64| {
            beam().with_load(Load::point_force(0.5, 1.0)).with_load(Load::point_moment(0.5, m))
        };
        assert!((overturning(&model(0.1)) - 5.0).abs() < 1e-14);
        assert!((overturning(&model(-0.4)) - 1.25).abs() < 1e-14);
        assert_eq!(overturning(&beam().with_load(Load::point_force(0.9, 1.0))), f64::INFINITY);
    }

    #[test]
    fn checks_of_a_beam_that_lifts_off() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let Outcome::Equilibrium(solution) = solve(&model).unwrap() else { panic!("it stands") };
        let limits = Limits {
            bearing_pressure: Some((10.0, 0.5)),
            settlement: Some(0.1),
            lifted_share: Some(0.811_326_256_449_156),
            eccentricity: Some(1.0 / 3.0),
            overturning: Some(1.0),
        };
        let checks = limits.check(&solution);
        let passed: Vec<bool> = checks.iter().map(Check::passes).collect();
        assert_eq!(passed, [true, false, true, false, true]);
        // The resultant at 0.99 l; the largest pressure twice over half the width.
        assert!((checks[3].found - 0.49).abs() < 1e-14);
        let largest = solution.range(Field::Pressure).max.value;
        assert_eq!(checks[0].found, 2.0 * largest);
    }
}
