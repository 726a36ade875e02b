//! What is left of force and moment at the right end, given back to whatever carries the beam.
//!
//! A long beam is cut where its moments are known as well from w itself: what rounding leaves of one part
//! is then given back there, and not carried along all the rest.

use super::curve::ROUNDING;

/// Weights along the beam: their sum, their centre, and their second moment about it.
///
/// Kept about the centre, so that a short contact far from the origin keeps its lever.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Weights {
    pub sum: f64,
    pub centre: f64,
    pub spread: f64,
}

impl Weights {
    pub fn add(&mut self, other: Weights) {
        let sum = self.sum + other.sum;
        if sum > 0.0 {
            let apart = other.centre - self.centre;
            let share = other.sum / sum;
            self.spread += other.spread + apart * apart * self.sum * share;
            self.centre += apart * share;
            self.sum = sum;
        }
    }

    pub fn point(centre: f64, sum: f64) -> Self {
        Weights { sum, centre, spread: 0.0 }
    }
}

/// What may carry more or less than is claimed.
#[derive(Debug, Clone, Default)]
pub(super) struct Carriers {
    /// The ground's pressure and concentrated forces.
    pub pressure: Weights,
    /// Where the ground presses: first and last place; and ∫p u.
    pub from: Option<f64>,
    pub to: f64,
    pub sunk: f64,
    /// Supports, each with a weight of its force: rigid ones with the sum of all forces.
    pub supports: Weights,
    /// Moments of supports and of the tension, as weights times a length squared.
    pub turning: f64,
    /// Σ(force²/spring + moment²/rotational spring) and ∫P w'²: what pays for its share.
    pub stored: f64,
}

/// What remains: T and m beyond the right end, and by how much either may be wrong.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Remains {
    pub force: f64,
    pub moment: f64,
    pub force_noise: f64,
    pub moment_noise: f64,
}

/// What giving it back costs.
#[derive(Debug, Clone, Copy)]
struct Absorbed {
    /// Every pressure changes by at most this part of itself, which moves the ground by this much in the norm
    /// of the energies;
    pressure: f64,
    sunk: f64,
    /// all of them together by this force.
    pressed: f64,
    /// What it does to springs and the tension, and to the moments, in that norm.
    supports: f64,
    bent: f64,
}

impl Carriers {
    /// A place where the ground presses, and what its forces have done.
    pub fn press(&mut self, weights: Weights, [from, to]: [f64; 2], sunk: f64) {
        self.sunk += sunk.max(0.0);
        self.pressure.add(weights);
        self.from = self.from.or(Some(from));
        self.to = to;
    }

    fn join(&mut self, next: &Carriers) {
        self.pressure.add(next.pressure);
        self.supports.add(next.supports);
        self.from = self.from.or(next.from);
        self.to = if next.from.is_some() { next.to } else { self.to };
        self.sunk += next.sunk;
        self.turning += next.turning;
        self.stored += next.stored;
    }
}

/// A part of the beam along which shear and moment are integrated in one go.
#[derive(Debug, Default)]
pub(super) struct Segment {
    pub from: f64,
    pub to: f64,
    pub carriers: Carriers,
    pub remains: Remains,
    /// ∫1/EI and ∫P w'².
    pub flexibility: f64,
    pub axial: f64,
    /// P, and the moment by which m may be wrong besides.
    pub tension: f64,
    pub moment: f64,
    /// ∫1/S, the largest 1/S, and the sizes of all forces that remain: what a beam that shears feels of them.
    pub shear_flexibility: f64,
    pub shear_softness: f64,
    pub forces: f64,
}

impl Segment {
    /// Whether it carries itself: long enough for the waves of the beam, on ground that presses.
    pub fn stands(&self, wave: f64) -> bool {
        let pressure = &self.carriers.pressure;
        self.to - self.from >= 2.0 * wave && pressure.spread > 0.1 * wave * wave * pressure.sum
    }

    /// Whether nothing along it can carry a force.
    pub fn is_bare(&self) -> bool {
        self.carriers.pressure.sum + self.carriers.supports.sum == 0.0
    }

    /// The most that what remains does to the moment over a distance.
    fn reaches(&self, length: f64) -> f64 {
        let Remains { force, moment, force_noise, moment_noise } = self.remains;
        (force.abs() + force_noise) * length + moment.abs() + moment_noise
    }

    /// What supports and the tension can turn, as weights times a length squared.
    pub fn turning(&self) -> f64 {
        let length = self.to - self.from;
        let tension = (self.tension * self.axial / length).sqrt() * length * length;
        self.carriers.turning + if self.axial > 0.0 { tension } else { 0.0 }
    }

    /// The moment that remains, with what it may be wrong by.
    pub fn unbalanced(&self) -> f64 {
        self.remains.moment.abs() + self.remains.moment_noise
    }

    /// What a change of the shear force by this much all along costs, and of all that the tension does by this part.
    pub fn sheared(&self, by: f64, part: f64) -> f64 {
        let turned = part * (self.tension * self.shear_softness * self.axial).sqrt();
        by * self.shear_flexibility.sqrt() + turned
    }

    /// One that carries no force gives what remains of it to its neighbour.
    fn lean(&self, bare: &Segment, lever: f64) -> Segment {
        let (a, b) = (&self.remains, &bare.remains);
        let carriers = self.carriers.clone();
        Segment {
            carriers,
            remains: Remains {
                force: a.force + b.force,
                moment: a.moment + b.moment + b.force * lever,
                force_noise: a.force_noise + b.force_noise,
                moment_noise: a.moment_noise + b.moment_noise + b.force_noise * lever.abs(),
            },
            flexibility: self.flexibility + bare.flexibility,
            moment: self.moment + bare.moment + bare.reaches(lever.abs()),
            shear_flexibility: self.shear_flexibility + bare.shear_flexibility,
            forces: self.forces + bare.forces,
            ..*self
        }
    }

    /// Both as one: what remains of the first reaches the second's end with a lever.
    fn join(&self, next: &Segment) -> Segment {
        let lever = next.to - next.from;
        if self.is_bare() {
            return next.lean(self, lever);
        }
        if next.is_bare() {
            return self.lean(next, -lever);
        }
        let mut carriers = Carriers::default();
        carriers.join(&self.carriers);
        carriers.join(&next.carriers);
        let (a, b) = (&self.remains, &next.remains);
        Segment {
            from: self.from,
            to: next.to,
            carriers,
            remains: Remains {
                force: a.force + b.force,
                moment: a.moment + a.force * lever + b.moment,
                force_noise: a.force_noise + b.force_noise,
                moment_noise: a.moment_noise + a.force_noise * lever + b.moment_noise,
            },
            flexibility: self.flexibility + next.flexibility,
            axial: self.axial + next.axial,
            tension: self.tension,
            moment: self.moment + next.moment,
            shear_flexibility: self.shear_flexibility + next.shear_flexibility,
            shear_softness: self.shear_softness,
            forces: self.forces + next.forces,
        }
    }

    /// All of it changed by a common factor 1 + α + β(x − centre)/l, which keeps the sign of every
    /// pressure. None if there is no lever or too little to change.
    fn absorb(&self) -> Option<Absorbed> {
        let (carriers, remains, length) = (&self.carriers, &self.remains, self.to - self.from);
        let mut all = carriers.pressure;
        all.add(carriers.supports);
        let turning = self.turning();
        let about = self.to - all.centre;
        let force = remains.force.abs() + remains.force_noise;
        let turn = (remains.moment - about * remains.force).abs()
            + remains.moment_noise
            + ROUNDING * (remains.moment.abs() + about * remains.force.abs());
        let ratio = |x: f64, by: f64| if x == 0.0 { 0.0 } else { x / by };
        let alpha = ratio(force, all.sum);
        let beta = ratio(length * turn, all.spread + turning);
        let from = carriers.from.unwrap_or(all.centre);
        let farthest = (all.centre - from).abs().max((carriers.to - all.centre).abs());
        let pressure =
            if carriers.pressure.sum > 0.0 { alpha + beta * farthest / length } else { 0.0 };
        // ∫|x − centre| p ≤ √(∫p ∫(x − centre)² p), about the centre of all.
        let apart = carriers.pressure.centre - all.centre;
        let sum = carriers.pressure.sum;
        let spread = carriers.pressure.spread + sum * apart * apart;
        let pressed = alpha * sum + beta * (sum * spread).sqrt() / length;
        // The part with β is in equilibrium but for the moment `turn`: on neither side of the centre does it
        // reach more.
        let moment = force * length + 2.0 * turn + self.moment;
        // ∫|x − centre| dc ≤ √(∫dc ∫(x − centre)² dc) for the part with β.
        let sheared = 2.0 * self.forces + beta * (all.sum * all.spread).sqrt() / length;
        // The tension only turns.
        let part = |share: f64, stored: f64| if stored > 0.0 { share * stored.sqrt() } else { 0.0 };
        let supports = part(alpha + beta, carriers.stored).hypot(part(beta, self.axial));
        (pressure <= LARGEST && (alpha + beta).is_finite()).then_some(Absorbed {
            pressure,
            sunk: pressure * carriers.sunk.sqrt(),
            pressed,
            supports,
            bent: moment * self.flexibility.sqrt() + self.sheared(sheared, beta),
        })
    }
}

/// Sums of what giving back costs; `flexibility` bounds g(x, x).
#[derive(Debug)]
pub(super) struct GivenBack {
    flexibility: f64,
    pending: Option<Segment>,
    /// Squares: of pressures that change by a part of themselves, of supports, of moments; and the norm of
    /// what is rather bounded as forces anywhere.
    pub(super) sunk: f64,
    pub(super) supports: f64,
    pub(super) bent: f64,
    pressed: f64,
    /// The largest part by which a pressure changes.
    pub pressure: f64,
    /// What could not be given back, at the end of the beam.
    pub lost: Option<Remains>,
}

impl GivenBack {
    pub fn new(flexibility: f64) -> Self {
        GivenBack {
            flexibility,
            pending: None,
            sunk: 0.0,
            supports: 0.0,
            bent: 0.0,
            pressed: 0.0,
            pressure: 0.0,
            lost: None,
        }
    }

    /// A segment that stands by itself, or leans on a neighbour.
    pub fn add(&mut self, segment: Segment) {
        let next = match self.pending.take() {
            Some(before) if before.is_bare() || segment.is_bare() => before.join(&segment),
            Some(before) => {
                self.give(&before);
                segment
            }
            None => segment,
        };
        self.pending = Some(next);
    }

    /// The last one, by itself or with the one before it, whichever costs less.
    pub fn finish(&mut self, last: Segment) {
        let Some(before) = self.pending.take() else { return self.give(&last) };
        let joined = before.join(&last);
        let cost = |segment: &Segment| {
            let cost = |given: Absorbed| given.sunk + given.supports + given.bent;
            segment.absorb().map_or(f64::INFINITY, cost)
        };
        let bare = before.is_bare() || last.is_bare();
        if !bare && cost(&before) + cost(&last) < cost(&joined) {
            self.give(&before);
            self.give(&last);
        } else {
            self.give(&joined);
        }
    }

    fn give(&mut self, segment: &Segment) {
        let Some(given) = segment.absorb() else {
            self.lost = Some(segment.remains);
            return;
        };
        self.pressure = self.pressure.max(given.pressure);
        let pressed = given.pressed * (2.0 * self.flexibility).sqrt();
        if pressed < given.sunk {
            self.pressed += pressed;
        } else {
            self.sunk += given.sunk * given.sunk;
        }
        self.supports += given.supports * given.supports;
        self.bent += given.bent * given.bent;
    }

    /// What it does to the ground, to the supports and the tension, and to the moments.
    pub fn norms(&self) -> [f64; 3] {
        [self.sunk.sqrt() + self.pressed, self.supports.sqrt(), self.bent.sqrt()]
    }
}

/// A pressure may not change by more than this part of itself.
pub(super) const LARGEST: f64 = 0.5;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_far_away_keep_their_lever() {
        let mut weights = Weights::default();
        for i in 0..3 {
            weights.add(Weights::point(1.0 + 1e-9 * f64::from(i), 1.0));
        }
        assert!((weights.spread / 2e-18 - 1.0).abs() < 1e-6);
        assert_eq!(weights.sum, 3.0);
    }

    #[test]
    fn one_point_has_no_lever() {
        let mut segment = Segment { to: 1.0, flexibility: 1.0, ..Segment::default() };
        segment.carriers.press(Weights::point(1.0, 5.0), [1.0; 2], 5.0);
        segment.remains.force = 1e-16;
        let given = segment.absorb().expect("a force through the point");
        assert!(given.pressure > 1e-17 && given.pressure < 3e-17);
        segment.remains.moment = 1e-16;
        assert!(segment.absorb().is_none());
    }

    #[test]
    fn segments_joined_are_one() {
        let half = |from: f64, force: f64, moment: f64| {
            let mut segment =
                Segment { from, to: from + 1.0, flexibility: 1.0, ..Segment::default() };
            segment.carriers.press(
                Weights { sum: 1.0, centre: from + 0.5, spread: 0.1 },
                [from, from + 1.0],
                1.0,
            );
            segment.remains = Remains { force, moment, ..Remains::default() };
            segment
        };
        let joined = half(0.0, 1e-16, 3e-16).join(&half(1.0, 2e-16, 0.0));
        assert_eq!((joined.remains.force, joined.remains.moment), (3e-16, 4e-16));
        assert_eq!(joined.carriers.pressure.centre, 1.0);
        assert!((joined.carriers.pressure.spread - 0.7).abs() < 1e-15);
    }
}
