//! Where fields are largest and smallest: at joints, and where derivatives vanish.
//!
//! Nothing is sampled: the roots of a polynomial are told from its coefficients. So is on which stretches a field may
//! exceed what it is at their ends; on the others no root is sought.

use crate::numeric::polynomial::{derivative, jet, sign_changes, value, with_slope};
use crate::solution::solution::{Extreme, Field, Range, Solution, Stretch};

impl Solution {
    /// The smallest and largest value of a field, located by the roots of its derivative.
    pub fn range(&self, field: Field) -> Range {
        let hulls: Vec<Hull> = self.stretches.iter().map(|stretch| stretch.hull(field)).collect();
        let ends = hulls.iter().flat_map(|hull| hull.ends);
        let [least, most] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], end| {
            [least.min(end), most.max(end)]
        });
        let rounding = hulls.iter().map(|hull| hull.rounding).fold(0.0, f64::max);
        let mut found: Option<[Spot; 2]> = None;
        for (i, (hull, stretch)) in hulls.iter().zip(&self.stretches).enumerate() {
            for (s, end) in [-1.0, 1.0].into_iter().zip(hull.ends) {
                // All that may be the least or the most but for rounding are seen exactly.
                if end <= least + 2.0 * rounding || end >= most - 2.0 * rounding {
                    widen(&mut found, Spot { stretch: i, s, value: stretch.one(field, s) });
                }
            }
        }
        let mut inside = Vec::new();
        for (i, (hull, stretch)) in hulls.iter().zip(&self.stretches).enumerate() {
            let [low, high] = hull.bounds;
            if found.is_some_and(|[min, max]| min.value <= low && high <= max.value) {
                continue;
            }
            inside.clear();
            stretch.turning_points(field, &mut inside);
            for &s in &inside {
                widen(&mut found, Spot { stretch: i, s, value: stretch.one(field, s) });
            }
        }
        self.between(found)
    }

    /// The smallest and largest rotation of the sections; that of the slope where the beam does not shear.
    pub fn rotation_range(&self) -> Range {
        let mut found: Option<[Spot; 2]> = None;
        for (i, stretch) in self.stretches.iter().enumerate() {
            let mut all = vec![-1.0, 1.0];
            match stretch.rotation.is_empty() {
                true => stretch.turning_points(Field::Slope, &mut all),
                false => sign_changes(&derivative(&stretch.rotation), &mut all),
            }
            for s in all {
                widen(&mut found, Spot { stretch: i, s, value: stretch.fields(s).rotation });
            }
        }
        self.between(found)
    }

    fn between(&self, found: Option<[Spot; 2]>) -> Range {
        let extreme = |Spot { stretch, s, value }: Spot| {
            let x = self.stretches[stretch].global(s);
            Extreme { x, value }
        };
        found.map_or(NOTHING, |[min, max]| Range { min: extreme(min), max: extreme(max) })
    }
}

/// Of a beam without stretches.
const NOTHING: Range =
    Range { min: Extreme { x: 0.0, value: 0.0 }, max: Extreme { x: 0.0, value: 0.0 } };

/// Where a value is.
#[derive(Clone, Copy)]
struct Spot {
    stretch: usize,
    s: f64,
    value: f64,
}

/// Lets the smallest and the largest value take note of another. Of equal ones the leftmost counts.
fn widen(found: &mut Option<[Spot; 2]>, here: Spot) {
    let [min, max] = found.get_or_insert([here; 2]);
    let is_left = |of: &Spot| here.value == of.value && (here.stretch, here.s) < (of.stretch, of.s);
    if here.value < min.value || is_left(min) {
        *min = here;
    }
    if here.value > max.value || is_left(max) {
        *max = here;
    }
}

/// A field at the ends of a stretch, but for rounding, and between which values it lies on all of it.
struct Hull {
    ends: [f64; 2],
    bounds: [f64; 2],
    /// So much the ends may be wrong.
    rounding: f64,
}

impl Hull {
    /// Between the ends a polynomial is a straight line and Σ cⱼ (sʲ − 1) for even j, Σ cⱼ (sʲ − s) for odd ones,
    /// from j = 2 on; these factors lie between −1 and 0, and −1 and 1.
    fn of(c: &[f64]) -> Self {
        let [first, second] = [0, 1].map(|j| c.get(j).copied().unwrap_or(0.0));
        let ([mut even, mut odd], [mut above, mut apart]) = ([0.0; 2], [0.0; 2]);
        for pair in c.get(2..).unwrap_or_default().chunks(2).rev() {
            let [a, b] = [pair[0], pair.get(1).copied().unwrap_or(0.0)];
            even += a;
            odd += b;
            above += a.max(0.0);
            apart += b.abs();
        }
        let below = above - even;
        let (even, odd) = (first + even, second + odd);
        let ends = [even - odd, even + odd];
        let bounds = [ends[0].min(ends[1]) - above - apart, ends[0].max(ends[1]) + below + apart];
        let size = first.abs() + second.abs() + above + below + apart;
        Hull { ends, bounds, rounding: c.len() as f64 * f64::EPSILON * size }
    }

    fn times(self, factor: f64) -> Self {
        let [ends, bounds] = [self.ends, self.bounds].map(|pair| pair.map(|of| of * factor));
        Hull { ends, bounds, rounding: self.rounding * factor }
    }
}

impl Stretch {
    /// One field, to the bit what [`Stretch::fields`] says.
    fn one(&self, field: Field, s: f64) -> f64 {
        let per_length = 1.0 / self.half;
        match field {
            Field::Deflection => value(&self.deflection, s),
            Field::Slope => with_slope(&self.deflection, s)[1] * per_length,
            Field::Moment => value(&self.moment, s),
            Field::ShearForce => with_slope(&self.moment, s)[1] * per_length,
            Field::Pressure => value(&self.pressure, s),
            Field::Settlement | Field::Gap => self.fields(s).get(field),
        }
    }

    fn hull(&self, field: Field) -> Hull {
        let per_length = 1.0 / self.half;
        match field {
            Field::Deflection => Hull::of(&self.deflection),
            Field::Slope => Hull::of(&derivative(&self.deflection)).times(per_length),
            Field::Moment => Hull::of(&self.moment),
            Field::ShearForce => Hull::of(&derivative(&self.moment)).times(per_length),
            Field::Pressure => Hull::of(&self.pressure),
            Field::Settlement if self.open.is_none() => {
                let Hull { ends, bounds: [least, most], rounding } = Hull::of(&self.deflection);
                let [a, b] = self.cell.gap;
                let bounds = [least - a.max(b), most - a.min(b)];
                let rounding = rounding + f64::EPSILON * (a.abs() + b.abs());
                Hull { ends: [ends[0] - a, ends[1] - b], bounds, rounding }
            }
            Field::Gap if self.open.is_none() => Hull::of(&[]),
            // No polynomial.
            Field::Settlement | Field::Gap => Hull {
                ends: [-1.0, 1.0].map(|s| self.one(field, s)),
                bounds: [f64::NEG_INFINITY, f64::INFINITY],
                rounding: 0.0,
            },
        }
    }

    /// Where a field may be largest or smallest: its ends and where its derivative vanishes.
    pub(crate) fn candidates(&self, field: Field) -> Vec<f64> {
        let mut s = vec![-1.0];
        self.turning_points(field, &mut s);
        s.push(1.0);
        s
    }

    /// Where the derivative of a field changes its sign inside, from left to right, appended to `found`.
    fn turning_points(&self, field: Field, found: &mut Vec<f64>) {
        match field {
            Field::Deflection => sign_changes(&derivative(&self.deflection), found),
            Field::Slope => sign_changes(&derivative(&derivative(&self.deflection)), found),
            Field::Moment => sign_changes(&derivative(&self.moment), found),
            Field::ShearForce => sign_changes(&derivative(&derivative(&self.moment)), found),
            Field::Pressure => sign_changes(&derivative(&self.pressure), found),
            Field::Settlement if self.open.is_none() => {
                let mut c = derivative(&self.deflection);
                c[0] -= self.cell.gap_slope * self.half;
                sign_changes(&c, found);
            }
            // Open ground is convex where it is positive: one lowest point at most.
            Field::Settlement => self.turns(|at| self.settlement(at, 0.0, 0.0)[1], found),
            Field::Gap if self.open.is_some() => {
                let slope = |at: f64| {
                    let [_, dw, ..] = jet(&self.deflection, at);
                    self.settlement(at, 0.0, 0.0)[1] + self.cell.gap_slope - dw / self.half
                };
                self.turns(slope, found);
            }
            Field::Gap => {}
        }
    }

    /// Sign changes of a derivative that has no polynomial, between points close enough for one each.
    fn turns(&self, slope: impl Fn(f64) -> f64, found: &mut Vec<f64>) {
        const CUTS: usize = 16;
        let at = |i: usize| 2.0 * i as f64 / CUTS as f64 - 1.0;
        for i in 0..CUTS {
            let (mut low, mut high) = (at(i), at(i + 1));
            let sign = slope(low);
            if sign * slope(high) >= 0.0 {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if slope(middle) * sign > 0.0 {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            found.push(0.5 * (low + high));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Answer, Beam, Foundation, Load, Model, Solver};

    /// Loads, an open part and a stiff part: all fields, on a thousand points of each stretch.
    #[test]
    fn nothing_exceeds_a_range_and_ranges_are_reached() {
        let (mut solver, mut solved) = (Solver::new(), 0);
        for i in 0..60 {
            let part = |j: u32| f64::from((i * (2 * j + 7) + 3 * j) % 23) / 23.0;
            let stiffness = 10.0_f64.powf(-1.0 + 3.0 * part(1));
            let ground = Foundation::pasternak(1.0, part(2));
            let model = Model::new(Beam::uniform(10.0, stiffness), ground)
                .with_load(Load::point(10.0 * part(4), 1.0 + part(3)))
                .with_load(Load::point(4.0 + part(5), 2.0))
                .with_load(Load::uniform(0.2 * part(6) + 0.01, 0.0, 10.0));
            let Ok(Answer::Equilibrium(solution)) = solver.solve(&model) else { continue };
            solved += 1;
            for field in Field::ALL {
                let Range { min, max } = solution.range(field);
                let size = min.value.abs().max(max.value.abs());
                let mut seen = [f64::INFINITY, f64::NEG_INFINITY];
                for stretch in &solution.stretches {
                    for at in 0..=1000 {
                        let s = f64::from(at) / 500.0 - 1.0;
                        let value = stretch.fields(s).get(field);
                        assert_eq!(value.to_bits(), stretch.one(field, s).to_bits());
                        seen = [seen[0].min(value), seen[1].max(value)];
                    }
                }
                let reached = 1e-4 * (seen[1] - seen[0]);
                assert!(seen[0] >= min.value - 1e-14 * size && seen[1] <= max.value + 1e-14 * size);
                assert!(seen[0] - reached <= min.value && max.value <= seen[1] + reached);
                for extreme in [min, max] {
                    let at = |side| solution.at(extreme.x, side).get(field);
                    let near = [crate::Side::Left, crate::Side::Right]
                        .map(|side| (at(side) - extreme.value).abs());
                    assert!(near[0].min(near[1]) <= 1e-12 * size, "{field:?} at {}", extreme.x);
                }
            }
        }
        assert!(solved > 30, "{solved}");
    }
}
