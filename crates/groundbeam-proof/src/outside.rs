//! Stiffness and load of the ground outside the beam, condensed to the beam's end.
//!
//! Stretches with constant k and μ are condensed one by one, from the outermost stretch inward. With the settlement u,
//! the force in the shear layer is S u − T at the outer end of a stretch and S⁺u − T⁺ at its inner end. For a stretch
//! of length h, S⁺ = K(S + Kt)/(K + St), with K = √(kμ), t = tanh z and z = h√(k/μ). S⁺ = K if the stretch is infinite,
//! and S⁺ = K/t if its outer end is held. S = 0 at a free end of the shear layer and where the layer meets Winkler
//! ground.
//!
//! The distributed load is q_f at the outer end and q_n at the inner end, with the slope q′ = (q_n − q_f)/h. Then
//!
//! ```text
//! T⁺ = (T + μq′/k − S q_f/k) K/(K cosh z + S sinh z) + S⁺q_n/k − μq′/k,   T⁺ = S⁺q_n/k − μq′/k − (q_f/k)K/sinh z if held.
//! ```
//!
//! A point force on the ground is added to T at its position.

use crate::beside::{LoadedStretch, Row};
use crate::frame::Frame;
use crate::model::{Extent, GroundEnd, Load, Model};
use crate::positions::is_near;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::units::Units;
use crate::values::{constant, not_negative, positive};

/// Stores in `frame` the ground outside each end of the beam, its stiffness K and its load term T. With the settlement
/// u of the beam's end, the shear layer transmits the force K u − T there.
pub(crate) fn beside<S: Scalar>(model: &Model<S>, frame: &mut Frame<S>) -> Result<(), NotProven> {
    for side in [0, 1] {
        let span = if side == 0 { &frame.spans[0] } else { &frame.spans[frame.spans.len() - 1] };
        if span.layered {
            let own = [span.spring.at_end(side), span.shear.at_end(side)];
            let beside = Beside { model, units: frame.units, length: frame.length, side };
            frame.rows[side] = beside.loaded(own)?;
            (frame.outside[side], frame.pushed[side]) = frame.rows[side].seen()?;
        }
    }
    Ok(())
}

/// A part of the ground between two distances from the beam's end. The second distance is `None` for an
/// infinite part.
#[derive(Clone, Copy)]
struct Stretch<S> {
    from: S,
    to: Option<S>,
    ground: [S; 2],
}

/// The ground outside one end of the beam.
struct Beside<'a, S> {
    model: &'a Model<S>,
    units: Units,
    length: S,
    side: usize,
}

fn unclear() -> NotProven {
    NotProven::new("two positions in the ground outside the beam are too close to tell apart")
}

/// Returns whether a < b. Fails if the balls `a` and `b` overlap without being equal.
fn is_before<S: Scalar>(a: S, b: S) -> Result<bool, NotProven> {
    if a == b || (a - b).low() > 0.0 {
        Ok(false)
    } else if (b - a).low() > 0.0 {
        Ok(true)
    } else {
        Err(unclear())
    }
}

impl<S: Scalar> Beside<'_, S> {
    /// The distance of a position from the beam's end, positive outside the beam.
    fn outward(&self, at: S) -> S {
        let at = self.units.metres(at);
        let end = [S::zero(), self.length][self.side];
        // A position at the beam's end has the distance +0, because sorting places −0 before +0. In plain doubles, a
        // position within rounding error of the end also has the distance +0.
        match self.side {
            _ if at == end || !S::ENCLOSES && is_near(at, end, self.length) => S::zero(),
            0 => -at,
            _ => at - self.length,
        }
    }

    /// The distances of both ends of a stretch from the beam's end, beginning with the end nearer to the beam.
    fn ends(&self, from: S, to: S) -> [S; 2] {
        let (near, far) = if self.side == 0 { (to, from) } else { (from, to) };
        [self.outward(near), self.outward(far)]
    }

    /// Returns the stretches of constant k and μ, listed outward to the end of the shear layer, and whether the
    /// ground's surface is held at that end.
    fn row(&self, own: [S; 2]) -> Result<(Vec<Stretch<S>>, bool), NotProven> {
        let zero = S::zero();
        let mut grounds = vec![(zero, own)];
        for segment in &self.model.ground.segments {
            let [near, far] = self.ends(segment.from, segment.to);
            if near.low() >= 0.0 && far.low() > 0.0 {
                let spring = constant(&segment.spring)?;
                let spring = positive(self.units.scaled(spring, 1, -2), "k")?;
                let shear = self.units.scaled(constant(&segment.shear)?, 1, 0);
                let shear = not_negative(shear, "the shear constant of the ground")?;
                grounds.push((near, [spring, shear]));
            }
        }
        grounds.sort_by(|a, b| a.0.middle().total_cmp(&b.0.middle()));
        let (reach, held) = match self.model.ground.ends[self.side] {
            GroundEnd::Endless => (None, false),
            GroundEnd::Free(at) => (Some(self.outward(at)), false),
            GroundEnd::Held(at) => (Some(self.outward(at)), true),
        };
        let mut row = Vec::new();
        for (i, (from, ground)) in grounds.iter().enumerate() {
            let next = grounds.get(i + 1).map(|next| next.0);
            if let Some(reach) = reach
                && !is_before(*from, reach)?
            {
                break;
            }
            if ground[1] == zero {
                return Ok((row, false));
            }
            let to = match (next, reach) {
                (Some(next), Some(reach)) if !is_before(next, reach)? => Some(reach),
                (next, reach) => next.or(reach),
            };
            if let Some(to) = to
                && !is_before(*from, to)?
            {
                continue;
            }
            row.push(Stretch { from: *from, to, ground: *ground });
        }
        Ok((row, held))
    }

    /// Cuts the stretches at the positions of point loads and at the ends of distributed loads.
    fn cut(&self, row: Vec<Stretch<S>>) -> Result<Vec<Stretch<S>>, NotProven> {
        let mut places = Vec::new();
        for load in self.loads() {
            places.extend(match load.extent {
                Extent::Point { at, .. } => [self.outward(at); 2],
                Extent::Distributed { from, to, .. } => self.ends(from, to),
            });
        }
        if places.is_empty() {
            return Ok(row);
        }
        places.sort_by(|a, b| a.middle().total_cmp(&b.middle()));
        let mut cut = Vec::new();
        for mut stretch in row {
            for place in &places {
                let after = is_before(stretch.from, *place)?;
                let before = stretch.to.map_or(Ok(true), |to| is_before(*place, to))?;
                if after && before {
                    cut.push(Stretch { to: Some(*place), ..stretch });
                    stretch.from = *place;
                }
            }
            cut.push(stretch);
        }
        Ok(cut)
    }

    fn loads(&self) -> impl Iterator<Item = &Load<S>> {
        self.model.loads.iter().filter(|load| load.on_ground)
    }

    /// The sum of the point forces on the ground at the distance `x` from the beam's end.
    fn forces_at(&self, x: S) -> Result<S, NotProven> {
        let mut sum = S::zero();
        for load in self.loads() {
            if let Extent::Point { at, size } = load.extent {
                let at = self.outward(at);
                if at == x {
                    sum = sum + self.units.scaled(size, 1, 0);
                } else {
                    // This call fails unless it is certain which of the positions `at` and `x` is nearer to the beam.
                    is_before(at, x)?;
                }
            }
        }
        Ok(sum)
    }

    /// The load q at the near and at the far end of a stretch. Each distributed load covers the whole stretch or
    /// lies outside the stretch.
    fn spread_over(&self, [near, far]: [S; 2]) -> Result<[S; 2], NotProven> {
        let mut sum = [S::zero(); 2];
        for load in self.loads() {
            let Extent::Distributed { from, to, start, end } = load.extent else { continue };
            let [first, last] = self.ends(from, to);
            if is_before(near, first)? || is_before(last, far)? {
                continue;
            }
            let sizes = [start, end].map(|size| self.units.scaled(size, 1, -1));
            let [inner, outer] = if self.side == 0 { [sizes[1], sizes[0]] } else { sizes };
            for (sum, x) in sum.iter_mut().zip([near, far]) {
                let part = (x - first).div(last - first);
                let value = if inner == outer { inner } else { inner + (outer - inner) * part };
                *sum = *sum + value;
            }
        }
        Ok(sum)
    }

    /// The ground outside this end of the beam, cut into stretches with their loads.
    fn loaded(&self, own: [S; 2]) -> Result<Row<S>, NotProven> {
        let (row, held) = self.row(own)?;
        let with_loads = |stretch: Stretch<S>| {
            let (mut spread, mut force) = ([S::zero(); 2], S::zero());
            if let Some(to) = stretch.to {
                (spread, force) = (self.spread_over([stretch.from, to])?, self.forces_at(to)?);
            }
            let length = stretch.to.map(|to| to - stretch.from);
            Ok(LoadedStretch { length, ground: stretch.ground, spread, force })
        };
        let stretches: Result<_, NotProven> = self.cut(row)?.into_iter().map(with_loads).collect();
        Ok(Row { stretches: stretches?, held })
    }
}

impl<S: Scalar> Row<S> {
    /// The stiffness K and the load term T of this ground. With the settlement u of the beam's end, the shear layer
    /// transmits the force K u − T there.
    fn seen(&self) -> Result<(S, S), NotProven> {
        let mut seen: Option<(S, S)> = None;
        for stretch in self.stretches.iter().rev() {
            let [spring, shear] = stretch.ground;
            let root = (spring * shear).sqrt();
            let Some(length) = stretch.length else {
                seen = Some((root, S::zero()));
                continue;
            };
            let z = spring.div(shear).sqrt() * length;
            let [near, far] = stretch.spread.map(|q| q.div(spring));
            let slope = shear * (near - far).div(length);
            seen = Some(match seen {
                None if self.held => {
                    let stiffness = root.div(hyperbolic_tangent(z));
                    (stiffness, stiffness * near - slope - far * root * inverse_sine(z))
                }
                behind => {
                    let (stiffness, pushed) = behind.unwrap_or((S::zero(), S::zero()));
                    let pushed = pushed + stretch.force;
                    let t = hyperbolic_tangent(z);
                    let next = (root * (stiffness + root * t)).div(root + stiffness * t);
                    // K/(K cosh z + S sinh z).
                    let fallen = (-z).expm1() + S::one();
                    let double = (-z.scaled(1)).expm1() + S::one();
                    let divisor = root + stiffness + (root - stiffness) * double;
                    let passed = (root * fallen).scaled(1).div(divisor);
                    let driven = pushed + slope - stiffness * far;
                    (next, driven * passed + next * near - slope)
                }
            });
        }
        match seen {
            None if self.held => Err(NotProven::new(
                "not covered: ground whose surface is held at the end of the beam",
            )),
            seen => Ok(seen.unwrap_or((S::zero(), S::zero()))),
        }
    }
}

/// tanh z for z > 0.
fn hyperbolic_tangent<S: Scalar>(z: S) -> S {
    let fallen = (-z.scaled(1)).expm1();
    (-fallen).div(fallen + S::of(2.0))
}

/// 1/sinh z for z > 0.
fn inverse_sine<S: Scalar>(z: S) -> S {
    let fallen = (-z).expm1() + S::one();
    fallen.scaled(1).div(-(-z.scaled(1)).expm1())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Action, Beam, Course, Ground, GroundSegment};

    fn segment(from: f64, to: f64, spring: f64, shear: f64) -> GroundSegment<f64> {
        let [spring, shear] = [spring, shear].map(Course::Constant);
        GroundSegment { from, to, spring, shear }
    }

    fn load(extent: Extent<f64>) -> Load<f64> {
        Load { action: Action::Force, extent, on_ground: true }
    }

    /// Returns a model of a beam from x = 0 to x = 2, with loads on the ground and jumps of k and μ on both sides. One
    /// ground segment ends at `to`.
    fn model(ends: [GroundEnd<f64>; 2], to: f64) -> Model<f64> {
        let segments = vec![
            segment(-0.7, to, 1.9, 0.6),
            segment(-2.5, -0.7, 3.0, 0.4),
            segment(-8.0, -2.5, 0.6, 2.0),
            segment(2.3, 4.0, 0.5, 1.7),
            segment(2.0, 2.3, 2.2, 0.9),
        ];
        let spread = |from, to, start, end| load(Extent::Distributed { from, to, start, end });
        let point = |at, size| load(Extent::Point { at, size });
        Model {
            beam: Beam {
                length: 2.0,
                bending_stiffness: 1.0,
                shear_stiffness: None,
                segments: Vec::new(),
                axial_force: 0.0,
            },
            ground: Ground { spring: 1.3, shear: 0.8, segments, ends },
            loads: vec![
                spread(-3.0, 1.0, 0.7, 2.0),
                spread(2.0, 3.5, 1.1, 0.2),
                point(-1.1, 0.9),
                point(2.9, 1.6),
                point(2.3, 0.3),
            ],
            supports: Vec::new(),
            hinges: Vec::new(),
            gap: Vec::new(),
        }
    }

    /// Computes the stiffness K and the load term T of the ground beyond an end of the beam by linear finite elements
    /// for −(μu′)′ + ku = q. The ground ends at the distance `far` from the beam.
    fn by_elements(model: &Model<f64>, side: usize, far: f64, held: bool) -> [f64; 2] {
        let h = 1.0 / 4000.0;
        let count = (far / h).round() as usize;
        let place = |distance: f64| if side == 0 { -distance } else { 2.0 + distance };
        let ground = |x: f64| {
            // Outside the beam a segment continues outward until the next segment begins.
            let outward = |at: f64| if side == 0 { -at } else { at - 2.0 };
            let mut best = (-1.0, [model.ground.spring, model.ground.shear]);
            for s in &model.ground.segments {
                let near = outward(if side == 0 { s.to } else { s.from });
                if near >= best.0 && near >= 0.0 && near <= outward(x) {
                    best = (near, [&s.spring, &s.shear].map(|course| constant(course).unwrap()));
                }
            }
            best.1
        };
        let spread = |x: f64| -> f64 {
            let of = |load: &Load<f64>| match load.extent {
                Extent::Distributed { from, to, start, end } if from <= x && x <= to => {
                    start + (end - start) * (x - from) / (to - from)
                }
                _ => 0.0,
            };
            model.loads.iter().map(of).sum()
        };
        let (mut stiffness, mut pushed) = if held { (1e30, 0.0) } else { (0.0, 0.0) };
        for i in (0..count).rev() {
            let [a, b] = [i, i + 1].map(|i| i as f64 * h);
            let [k, mu] = ground(place(0.5 * (a + b)));
            let q = spread(place(0.5 * (a + b))) * h;
            for load in &model.loads {
                if let Extent::Point { at, size } = load.extent
                    && (at - place(b)).abs() < 0.5 * h
                {
                    pushed += size;
                }
            }
            let [own, across] = [k * h / 3.0 + mu / h, k * h / 6.0 - mu / h];
            let all = stiffness + own;
            let next = own - across * across / all;
            pushed = 0.5 * q - across * (pushed + 0.5 * q) / all;
            stiffness = next;
        }
        [stiffness, pushed]
    }

    #[test]
    fn stiffness_and_load_agree_with_linear_elements() {
        let ends = [
            ([GroundEnd::Endless, GroundEnd::Endless], 60.0, false),
            ([GroundEnd::Free(-4.0), GroundEnd::Free(6.0)], 4.0, false),
            ([GroundEnd::Held(-3.0), GroundEnd::Held(5.0)], 3.0, true),
        ];
        let all = ends.into_iter().flat_map(|ends| [(ends, 0.0), (ends, 0.5)]);
        for ((ends, far, held), to) in all {
            let model = model(ends, to);
            for side in [0, 1] {
                let units = Units { length: 0, force: 0 };
                let beside = Beside { model: &model, units, length: 2.0, side };
                let (stiffness, pushed) =
                    beside.loaded([1.3, 0.8]).and_then(|row| row.seen()).expect("a row");
                let [k, t] = by_elements(&model, side, far, held);
                let near = |a: f64, b: f64| (a - b).abs() <= 2e-6 * b.abs();
                assert!(near(stiffness, k), "{far} {side}: K {stiffness} {k}");
                assert!(near(pushed, t), "{far} {side}: T {pushed} {t}");
            }
        }
    }

    /// Positions within rounding error of an end of the beam: a proof in `Wide` numbers computes their distance from
    /// the end, and an estimate in `f64` sets the distance to 0.
    #[test]
    fn a_position_beside_the_beam_is_exact_in_a_proof() {
        use crate::read::read_model;
        use crate::wide::Wide;
        let text = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n";
        let units = Units { length: 0, force: 0 };
        let near = 2.0 * f64::EPSILON;
        let model = read_model::<Wide>(text, None).expect("a model");
        let length = Wide::of(2.0);
        for (side, at) in [(0, -near), (1, 2.0 + near)] {
            let beside = Beside { model: &model, units, length, side };
            assert_eq!(beside.outward(Wide::of(at)).middle(), near);
            assert_eq!(beside.outward([Wide::zero(), length][side]), Wide::zero());
        }
        let model = read_model::<f64>(text, None).expect("a model");
        for (side, at) in [(0, -near), (1, 2.0 + near)] {
            let beside = Beside { model: &model, units, length: 2.0, side };
            assert_eq!(beside.outward(at), 0.0);
            assert_eq!(beside.outward([-0.5, 2.5][side]), 0.5);
        }
    }
}
