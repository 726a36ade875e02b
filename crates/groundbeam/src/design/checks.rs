//! Computes design checks: values of a solution are compared with limits, in the limit states of each check.

use super::limit_states::{LimitState, LimitStates};
use crate::existence::rigid_motions::Mechanism;
use crate::existence::statics::static_reactions;
use crate::model::Model;
use crate::numeric::tolerance::SUM_ROUNDING;
use crate::solution::field::Field;
use crate::solution::fields::EndForces;
use crate::solution::solution::Solution;

/// Limits of the checks; `None` if a check is not requested.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// The allowable bearing pressure \[Pa\], and the width of the bearing area \[m\].
    pub bearing_pressure: Option<(f64, f64)>,
    /// The design resistance per effective area \[Pa\], and the width of this area \[m\]. In allowable stress design,
    /// the resistance is an allowable pressure.
    pub bearing_resistance: Option<(f64, f64)>,
    /// The limit of the downward deflection \[m\].
    pub settlement: Option<f64>,
    /// The limit of the lifted fraction of the beam's length.
    pub lifted_share: Option<f64>,
    /// The limit of the eccentricity of the load resultant, relative to the beam's length. The edge of the kern is at
    /// 1/6. Beyond 1/3, EN 1997-1, 6.5.4 requires special precautions.
    pub eccentricity: Option<f64>,
    /// The required minimum of the overturning factor: the factor on all overturning loads at which the beam tips.
    pub overturning: Option<f64>,
    /// The limit states to which each check in [`Checked::ALL`] applies; `None` for the default of
    /// [`Checked::limit_states`].
    pub judged_in: [Option<LimitStates>; Checked::ALL.len()],
}

/// The checked quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Checked {
    /// The largest contact pressure, averaged over the width \[Pa\]. Concentrated contact forces are excluded.
    BearingPressure,
    /// The contact force \[N\], including concentrated forces, compared with the resistance of the effective area
    /// (Meyerhof; EN 1997-1, 6.5.2 and annex D).
    BearingResistance,
    /// The largest downward deflection \[m\].
    Settlement,
    /// The fraction of the beam that is not in contact.
    LiftedShare,
    /// The eccentricity |x − l/2|/l of the load resultant, which acts at the position x.
    Eccentricity,
    /// The work of the stabilising loads divided by that of the overturning loads, in the tipping mode with the
    /// smallest ratio.
    Overturning,
}

/// A check: value and limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// The checked quantity.
    pub what: Checked,
    /// The computed value. For overturning, it is infinite if no load overturns the beam.
    pub found: f64,
    /// The limit.
    pub limit: f64,
    /// The position at which the value occurs \[m\]; `None` if the value has no position.
    pub at: Option<f64>,
    /// A further quantity that is reported together with the computed value of the check.
    pub beside: Beside,
}

/// A quantity reported together with a check.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Beside {
    /// No additional quantity.
    Nothing,
    /// The concentrated contact forces under both ends of the beam, which the checked pressure excludes.
    EndForces(EndForces),
    /// The dimensions of the effective area.
    EffectiveArea {
        /// The effective width B' \[m\].
        width: f64,
        /// The effective length L' = l - 2 e \[m\], with the eccentricity e \[m\] of the contact force.
        length: f64,
    },
}

impl Checked {
    /// All checks, in the order in which reports list them.
    pub const ALL: [Checked; 6] = [
        Checked::BearingPressure,
        Checked::BearingResistance,
        Checked::Settlement,
        Checked::LiftedShare,
        Checked::Eccentricity,
        Checked::Overturning,
    ];

    /// Returns the index of the check in [`Checked::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Returns the default limit states of the check (EN 1990, 6.4.1(1)a; EN 1997-1, 2.4.7.1 and 2.4.8). Bearing
    /// resistance is not judged in allowable stress design, because an allowable pressure is not a design resistance.
    pub const fn limit_states(self) -> LimitStates {
        use LimitState::{AllowableStress, Characteristic, Equ, Frequent, QuasiPermanent, StrGeo};
        LimitStates::of(match self {
            Checked::BearingPressure | Checked::LiftedShare => &[Characteristic, AllowableStress],
            Checked::BearingResistance => &[StrGeo],
            Checked::Eccentricity => &[StrGeo, AllowableStress],
            Checked::Settlement => &[Characteristic, Frequent, QuasiPermanent, AllowableStress],
            Checked::Overturning => &[Equ],
        })
    }

    /// The name of the check in results.
    pub fn name(self) -> &'static str {
        match self {
            Checked::BearingPressure => "bearing-pressure",
            Checked::BearingResistance => "bearing-resistance",
            Checked::Settlement => "settlement",
            Checked::LiftedShare => "lifted-share",
            Checked::Eccentricity => "eccentricity",
            Checked::Overturning => "overturning",
        }
    }

    /// The clause of the Eurocodes that requires the check; `None` if no clause requires it.
    pub fn clause(self) -> Option<&'static str> {
        match self {
            // EN 1997-1 has no clause for an allowable elastic pressure. The model file gives the limit.
            Checked::BearingPressure => None,
            Checked::BearingResistance => Some("EN 1997-1, 6.5.2"),
            Checked::Settlement => Some("EN 1997-1, 6.6"),
            Checked::LiftedShare => None,
            Checked::Eccentricity => Some("EN 1997-1, 6.5.4"),
            Checked::Overturning => Some("EN 1990, 6.4.1(1)a"),
        }
    }
}

impl Check {
    /// Returns whether the value satisfies the limit.
    pub fn passes(&self) -> bool {
        match self.what {
            Checked::Overturning => self.found >= self.limit,
            _ => self.found <= self.limit,
        }
    }

    /// Returns the utilisation of the limit. The utilisation is 1 if the value equals the limit.
    pub fn utilisation(&self) -> f64 {
        match self.what {
            Checked::Overturning => self.limit / self.found,
            // A value of zero has the utilisation zero, even if the limit is zero.
            _ if self.found == 0.0 => 0.0,
            _ => self.found / self.limit,
        }
    }
}

impl Limits {
    /// The requested checks, in the order of [`Checked::ALL`].
    pub fn asked(&self) -> impl Iterator<Item = Checked> + use<> {
        let asked = [
            self.bearing_pressure.is_some(),
            self.bearing_resistance.is_some(),
            self.settlement.is_some(),
            self.lifted_share.is_some(),
            self.eccentricity.is_some(),
            self.overturning.is_some(),
        ];
        Checked::ALL.into_iter().zip(asked).filter(|(_, asked)| *asked).map(|(what, _)| what)
    }

    /// Returns the limit states to which a check applies.
    pub fn limit_states(&self, what: Checked) -> LimitStates {
        self.judged_in[what.index()].unwrap_or(what.limit_states())
    }

    /// Computes the requested checks of a solution.
    ///
    /// ```
    /// use groundbeam::{Beam, Foundation, Load, Model, Outcome, solve, design::{Checked, Limits}};
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
        let mut with = |what, limit, found, at, beside| {
            checks.push(Check { what, found, limit, at, beside });
        };
        if let Some((allowable, width)) = self.bearing_pressure {
            let largest = solution.range(Field::Pressure).max;
            let found = largest.value / width;
            let ends = Beside::EndForces(solution.end_forces());
            with(Checked::BearingPressure, allowable, found, Some(largest.x), ends);
        }
        if let Some((resistance, width)) = self.bearing_resistance {
            let (force, at) = ground_reaction(solution);
            let eccentricity = at.map_or(0.0, |x| (x - 0.5 * l).abs());
            let length = (l - 2.0 * eccentricity).max(0.0);
            let area = Beside::EffectiveArea { width, length };
            with(Checked::BearingResistance, resistance * width * length, force, at, area);
        }
        let mut add = |what, limit, found, at| with(what, limit, found, at, Beside::Nothing);
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
            // An eccentricity that exceeds the limit only by rounding error passes.
            let found = (x / l - 0.5).abs();
            let found = if (found - limit).abs() <= SUM_ROUNDING { limit } else { found };
            add(Checked::Eccentricity, limit, found, Some(x));
        }
        if let Some(limit) = self.overturning {
            add(Checked::Overturning, limit, overturning(model), None);
        }
        checks
    }
}

/// Computes the contact force under the beam and its position, which is `None` for a zero force. Both follow from the
/// equilibrium of loads, support reactions and axial force.
fn ground_reaction(solution: &Solution) -> (f64, Option<f64>) {
    let model = solution.model();
    let l = model.beam.length;
    let [left, right] = solution.existence().static_reactions;
    let (mut force, mut moment) = (left + right, right * l);
    for reaction in solution.reactions() {
        force -= reaction.force;
        moment -= reaction.force * reaction.at - reaction.moment;
    }
    let ends = [0.0, l].map(|x| solution.value(Field::Deflection, x));
    moment -= model.beam.axial_force * (ends[1] - ends[0]);
    // If supports carry the whole beam, the contact force is rounding error.
    let total = left.abs() + right.abs();
    match force.abs() <= SUM_ROUNDING * total {
        true => (0.0, None),
        false => (force, Some(moment / force)),
    }
}

/// Computes the factor on all overturning loads at which the beam tips. It is the smallest ratio of holding to lifting
/// work over all tipping modes, and infinite if no load lifts the beam.
pub fn overturning(model: &Model) -> f64 {
    let mechanism = Mechanism::of(model);
    let groups = mechanism.free_groups();
    let mut sums = vec![[0.0; 2]; groups.len()];
    for load in &model.loads {
        let reactions = static_reactions(&[*load], &mechanism.nodes);
        for (sums, group) in sums.iter_mut().zip(&groups) {
            let of_group = || reactions[group.clone()].iter().map(|reaction| reaction.sum);
            let work: f64 = of_group().sum();
            // A moment does no work if the beam lifts without rotation.
            if work.abs() > SUM_ROUNDING * of_group().map(f64::abs).sum::<f64>() {
                sums[usize::from(work < 0.0)] += work.abs();
            }
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

    /// A beam of length l with the force f₀ and the moment M₀ at its middle tips if M₀ ≥ ½ f₀ l, by (5.21) of Kikuchi's
    /// paper.
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

    /// A beam pinned at 0 rotates only about the pin. A clamped beam does not tip. A beam in axial tension can
    /// translate but not rotate.
    #[test]
    fn a_beam_tips_only_in_motions_that_its_supports_allow() {
        let beam = |m: f64| {
            Model::new(Beam::uniform(2.0, 1.0), Foundation::pasternak(1.0, 1.0))
                .with_load(Load::point_force(1.0, 3.0))
                .with_load(Load::point_moment(1.0, m))
        };
        assert_eq!(overturning(&beam(1.0)), 3.0);
        let pinned = |m| beam(m).with_support(crate::model::Support::pinned(0.0));
        assert_eq!(overturning(&pinned(1.0)), f64::INFINITY);
        assert_eq!(overturning(&pinned(-1.0)), 3.0);
        let clamped = beam(-1.0).with_support(crate::model::Support::fixed(0.0));
        assert_eq!(overturning(&clamped), f64::INFINITY);
        let mut tied = beam(0.1).with_load(Load::point_force(0.3, -1.0));
        tied.beam.axial_force = 1.0;
        assert_eq!(overturning(&tied), 3.0);
    }

    #[test]
    fn checks_of_a_beam_that_lifts_off() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let Outcome::Equilibrium(solution) = solve(&model).unwrap() else { panic!("it stands") };
        let limits = Limits {
            bearing_pressure: Some((10.0, 0.5)),
            bearing_resistance: Some((100.0, 0.5)),
            settlement: Some(0.1),
            lifted_share: Some(0.811_326_256_449_156),
            eccentricity: Some(1.0 / 3.0),
            overturning: Some(1.0),
            ..Limits::default()
        };
        let checks = limits.check(&solution);
        let passed: Vec<bool> = checks.iter().map(Check::passes).collect();
        assert_eq!(passed, [true, true, false, true, false, true]);
        // The load resultant is at 0.99 l, so its eccentricity is 0.49 l. A bearing area 0.5 m wide has twice the
        // pressure of an area 1 m wide.
        assert!((checks[4].found - 0.49).abs() < 1e-14);
        let largest = solution.range(Field::Pressure).max.value;
        assert_eq!(checks[0].found, 2.0 * largest);
    }

    /// Computes the contact force and its position from equilibrium, and compares both with integrals of the contact
    /// pressure. The beam has a support and an axial force.
    #[test]
    fn the_reaction_of_the_ground_is_that_of_its_pressure() {
        let mut beam = Beam::uniform(10.0, 5e7);
        beam.axial_force = 2e6;
        let mut model = Model::new(beam, Foundation::pasternak(4e7, 9e6))
            .with_load(Load::point_force(1.0, 600e3))
            .with_load(Load::point_moment(6.0, 2e5))
            .with_load(Load::uniform_force(3.0, 9.0, 3e4));
        for support in
            [crate::model::Support::spring(8.0, 2e7, 3e7), crate::model::Support::fixed(4.0)]
        {
            model.supports = vec![support];
            let Outcome::Equilibrium(solution) = solve(&model).unwrap() else { panic!() };
            let ends = solution.end_forces();
            let (mut force, mut moment) = (ends.left + ends.right, 10.0 * ends.right);
            for concentrated in solution.concentrated_forces() {
                force += concentrated.force;
                moment += concentrated.force * concentrated.at;
            }
            // Between the stations the pressure has no jump.
            for ends in solution.stations(20_000).windows(2) {
                let x = 0.5 * (ends[0] + ends[1]);
                let part = solution.value(Field::Pressure, x) * (ends[1] - ends[0]);
                force += part;
                moment += part * x;
            }
            let (found, at) = ground_reaction(&solution);
            assert!((found / force - 1.0).abs() < 1e-7, "{found} {force}");
            assert!((at.unwrap() * force / moment - 1.0).abs() < 1e-6, "{at:?} {moment}");
        }
    }

    /// The effective length is L' = l - 2 e for the eccentricity e of the contact force (EN 1997-1, annex D.3). L' is
    /// 0 for a resultant at an end of the beam.
    #[test]
    fn the_resistance_is_that_of_the_effective_area() {
        let model = |x| {
            Model::new(Beam::uniform(6.0, 1e9), Foundation::pasternak(4e7, 9e6))
                .with_load(Load::point_force(x, 600e3))
        };
        let limits = Limits { bearing_resistance: Some((200e3, 1.5)), ..Limits::default() };
        let check = |x| {
            let Outcome::Equilibrium(solution) = solve(&model(x)).unwrap() else { panic!() };
            limits.check(&solution)[0]
        };
        let middle = check(3.0);
        assert_eq!((middle.found, middle.limit), (600e3, 1.8e6));
        assert_eq!(middle.utilisation(), 600e3 / 1.8e6);
        // For an eccentricity of 2 m, L' is 2 m and the resistance is 200 kPa * 1.5 m * 2 m = 600 kN.
        let off = check(5.0);
        assert!((off.limit - 600e3).abs() < 1e-6 && (off.found - 600e3).abs() < 1e-6);
        let Beside::EffectiveArea { width, length } = off.beside else { panic!() };
        assert!(width == 1.5 && (length - 2.0).abs() < 1e-12);
    }
}
