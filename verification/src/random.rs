//! Draws random models that have an equilibrium, with parameters over their whole range.

mod features;

use features::{
    add_neighbours, bearings, change_beside, compress, curl, hinge, shear_beam, vary_beam,
    vary_ground,
};
use groundbeam::{
    Beam, Foundation, Load, Model, Support, Verdict, exists, load_factors,
    load_factors::{FirstLiftOff, LoadFactors},
};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The families of random models, which differ in the features of their models.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// A uniform beam on uniform ground with a few loads.
    Plain,
    /// A beam under axial tension.
    Tension,
    /// A beam and ground whose stiffnesses change from segment to segment.
    Segments,
    /// A beam on Winkler ground, without a shear layer.
    Winkler,
    /// A beam with pins, clamps or springs, sometimes under compression.
    Supported,
    /// A beam above ground with an initial gap.
    Gap,
    /// A beam with the resultant of its loads close to an end. λl is between 10⁻² (almost rigid beam) and 10³ (very
    /// flexible beam), with λ = (k/(4EI))^¼.
    Hard,
    /// A long beam with upward loads at several positions, which has many contact zones.
    Long,
    /// All features of the families above.
    Mixed,
    /// A beam and ground whose stiffnesses vary along segments, combined with features of other kinds of random
    /// models.
    Varying,
    /// Imposed curvatures in addition to loads, combined with features of other kinds of random models.
    Curled = 12,
    /// Settled supports, combined with features of other kinds of random models.
    Settled = 13,
    /// Free and elastic hinges, combined with features of other kinds of random models.
    Hinged = 10,
    /// One-way supports, combined with features of other kinds of random models.
    OneWay = 11,
    /// Ground that ends or changes outside the beam.
    Beside = 16,
    /// Ground that ends or changes outside the beam, with loads on the ground under and outside the beam.
    Neighbours = 17,
    /// Beams with shear deformation from negligible to dominant, combined with features of other kinds of random
    /// models.
    Shearing = 30,
    /// The features of `Mixed` except axial tension. The axial compression is so large that the beam would buckle
    /// without the ground.
    Compressed = 21,
    /// A compression as in `Compressed`, on beams with shear deformation, one-way supports or both, sometimes with
    /// hinges.
    CompressedToo = 22,
    /// The features of `Mixed` with extreme values: λl up to 10⁴, up to a hundred loads, some of them upward, and
    /// load resultants near an end of the beam.
    Extreme = 20,
}

impl Family {
    /// The families whose models `exact` and `active-set` solve within milliseconds: all except `Shearing`, `Extreme`,
    /// `Compressed` and `CompressedToo`.
    pub const ALL: [Family; 16] = [
        Family::Plain,
        Family::Tension,
        Family::Segments,
        Family::Winkler,
        Family::Supported,
        Family::Gap,
        Family::Hard,
        Family::Long,
        Family::Mixed,
        Family::Varying,
        Family::Curled,
        Family::Settled,
        Family::Hinged,
        Family::OneWay,
        Family::Beside,
        Family::Neighbours,
    ];
}

/// Returns the random model of a family with the given number. A family and a number always give the same model.
pub fn model(family: Family, number: u64) -> Model {
    let mut rng = ChaCha8Rng::seed_from_u64(number);
    rng.set_stream(family as u64);
    for _ in 0..1000 {
        let model = draw(family, &mut rng);
        let Ok(existence) = exists(&model) else { continue };
        if match family {
            Family::Compressed | Family::CompressedToo => {
                matches!(existence.verdict, Verdict::Local(_))
            }
            _ => existence.verdict == Verdict::Unique,
        } {
            return model;
        }
    }
    unreachable!("all 1000 drawn models of the family lack the required equilibrium")
}

struct Dice<'a, R>(&'a mut R);

impl<R: Rng> Dice<'_, R> {
    fn even(&mut self, low: f64, high: f64) -> f64 {
        self.0.random_range(low..high)
    }

    /// Returns a number whose logarithm is uniformly distributed.
    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.even(low, high))
    }

    fn up_to(&mut self, most: usize) -> usize {
        self.0.random_range(0..=most)
    }

    fn happens(&mut self, probability: f64) -> bool {
        self.0.random_bool(probability)
    }

    /// Returns true with probability one fifth. If `asked` is false, it returns false and draws no random number.
    fn now_and_then(&mut self, asked: bool) -> bool {
        asked && self.happens(0.2)
    }

    /// Returns a position on [0, 1], sometimes an end or the middle.
    fn place(&mut self) -> f64 {
        match self.up_to(9) {
            0 => 0.0,
            1 => 1.0,
            2 => 0.5,
            _ => self.even(0.0, 1.0),
        }
    }
}

fn draw(family: Family, rng: &mut impl Rng) -> Model {
    let dice = &mut Dice(rng);
    let extreme = family == Family::Extreme;
    let too = family == Family::CompressedToo;
    let compressed = too || family == Family::Compressed;
    let mixed = extreme || compressed || family == Family::Mixed;
    let hard = extreme || family == Family::Hard;
    let curled = family == Family::Curled;
    // Models of the kinds in `various` also get some features of other kinds, such as tension, supports and an
    // initial gap.
    let settles = family == Family::Settled;
    let hinged = family == Family::Hinged;
    let one_way = family == Family::OneWay;
    let shearing = family == Family::Shearing;
    let various = curled || settles || hinged || one_way || shearing || family == Family::Varying;
    let varying = family == Family::Varying || dice.now_and_then(curled || settles || shearing);
    let length = dice.decades(-1.0, 2.0);
    let k = dice.decades(-2.0, 2.0);
    // The bending stiffness EI follows from a drawn value of λl = l (k/4EI)^(1/4).
    let lambda_l = match family {
        Family::Hard => dice.decades(-2.0, 3.0),
        Family::Long => dice.decades(1.0, 2.0),
        Family::Extreme => dice.decades(-2.0, 4.0),
        _ => dice.decades(-1.0, 1.5),
    };
    let stiffness = 0.25 * k * (length / lambda_l).powi(4);
    // The stiffness μ of the shear layer follows from a drawn ratio of μ to √(k EI).
    let shear = match family {
        Family::Winkler => 0.0,
        _ if (mixed || curled || settles || shearing) && dice.happens(0.2) => 0.0,
        Family::Hard | Family::Extreme => (k * stiffness).sqrt() * dice.decades(-4.0, 3.0),
        _ => (k * stiffness).sqrt() * dice.decades(-2.0, 1.5),
    };
    let mut beam = Beam::uniform(length, stiffness);
    let mut ground = Foundation::pasternak(k, shear);
    let tension = family == Family::Tension || (mixed && !compressed && dice.happens(0.5));
    if tension || dice.now_and_then(various) {
        let own = stiffness / (length * length);
        beam.axial_force = own * dice.decades(-2.0, 3.0);
    }
    if family == Family::Segments
        || (mixed && dice.happens(0.5))
        || dice.now_and_then(curled || settles || shearing)
    {
        let mut ends: Vec<f64> = (0..2 + 2 * dice.up_to(2)).map(|_| dice.place()).collect();
        ends.sort_by(f64::total_cmp);
        for pair in ends.chunks_exact(2).filter(|pair| pair[0] < pair[1]) {
            let factor = dice.decades(-1.5, 1.5);
            beam = beam.with_segment(pair[0] * length, pair[1] * length, stiffness * factor);
        }
        let mut ends: Vec<f64> = (0..2 + 2 * dice.up_to(2)).map(|_| dice.place()).collect();
        ends.sort_by(f64::total_cmp);
        for pair in ends.chunks_exact(2).filter(|pair| pair[0] < pair[1]) {
            let (k, mut shear) = (k * dice.decades(-1.0, 1.0), shear * dice.decades(-1.0, 1.0));
            if dice.happens(0.15) {
                shear = 0.0;
            }
            ground = ground.with_segment(pair[0] * length, pair[1] * length, k, shear);
        }
    }
    let beside = matches!(family, Family::Beside | Family::Neighbours);
    // Winkler ground under the end of the beam is not coupled to a shear layer outside the beam.
    let layered = shear > 0.0 && !varying && ground.segments.is_empty();
    if beside || (layered && dice.now_and_then(shearing)) {
        ground = change_beside(ground, length, dice);
    }
    if varying || dice.now_and_then(compressed) {
        beam = vary_beam(beam, stiffness, dice);
        ground = vary_ground(ground, length, dice);
    }
    // `kind` is 1 for shear deformation, 2 for one-way supports, 3 for both and 0 for neither.
    let kind = if too { 1 + dice.up_to(2) } else { 0 };
    if shearing || kind & 1 > 0 {
        beam = shear_beam(beam, lambda_l, dice);
    }
    let mut model = Model::new(beam, ground);
    let alone = shearing && model.foundation.segments.is_empty();
    if hinged || dice.now_and_then(one_way || alone || too) {
        model = hinge(model, dice);
    }
    if one_way || dice.now_and_then(shearing) || kind & 2 > 0 {
        model = bearings(model, dice);
    }
    if family == Family::Supported
        || settles
        || (mixed && dice.happens(0.3))
        || dice.now_and_then(various)
    {
        let mut places: Vec<f64> = (0..=dice.up_to(2)).map(|_| dice.place()).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        for place in places {
            let at = place * length;
            let support = match dice.up_to(3) {
                0 => Support::pinned(at),
                1 => Support::fixed(at),
                2 => Support::spring(at, k * length * dice.decades(-2.0, 2.0), 0.0),
                _ => Support::spring(
                    at,
                    k * length * dice.decades(-2.0, 2.0),
                    stiffness / length * dice.decades(-2.0, 2.0),
                ),
            };
            let settled = (settles || shearing) && dice.happens(0.7);
            let settlement = if settled { dice.even(-1.0, 2.0) / (k * length) } else { 0.0 };
            model = model.with_support(support.settled(settlement));
        }
        if dice.happens(0.3) {
            let critical = groundbeam::own_buckling_load(&model);
            if critical.is_finite() && critical > 0.0 {
                model.beam.axial_force = -critical * dice.even(0.01, 0.95);
            }
        }
    }
    load(&mut model, family, lambda_l, dice);
    if curled || dice.now_and_then(shearing) {
        curl(&mut model, lambda_l, dice);
    }
    if family == Family::Gap || (mixed && dice.happens(0.5)) || dice.now_and_then(various) {
        let corners = 1 + dice.up_to(4);
        let mut places: Vec<f64> = (0..corners).map(|_| dice.place()).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        // The initial gaps are of the order of the expected deflections.
        let size = model.loads.iter().map(|load| size_of(load, length)).sum::<f64>() / (k * length);
        for place in places {
            let clearance = size * dice.even(-0.3, 1.0);
            model = model.with_gap(place * length, clearance);
        }
    }
    if family == Family::Neighbours {
        add_neighbours(&mut model, dice);
    }
    // At λl = 100, with the wave number λ, a moment that shifts the resultant to an end would lift the beam by more
    // than 10⁶ times its settlement.
    if hard && lambda_l < 30.0 {
        bring_to_the_edge(&mut model, dice);
    }
    if extreme && dice.happens(0.2) {
        bring_to_lift_off(&mut model, dice);
    }
    if compressed {
        compress(&mut model, dice);
    }
    model
}

fn size_of(load: &Load, length: f64) -> f64 {
    if load.is_on_ground() { 0.0 } else { load.as_force(length) }
}

fn load<R: Rng>(model: &mut Model, family: Family, lambda_l: f64, dice: &mut Dice<R>) {
    let l = model.beam.length;
    let count = match family {
        Family::Long => 10 + dice.up_to(90),
        Family::Extreme if dice.happens(0.5) => 10 + dice.up_to(90),
        _ => 1 + dice.up_to(5),
    };
    for _ in 0..count {
        let at = dice.place() * l;
        match dice.up_to(9) {
            0..=5 => {
                let force = dice.even(0.2, 2.0);
                let up = if matches!(family, Family::Long | Family::Extreme) { 0.2 } else { 0.15 };
                let sign = if dice.happens(up) { -0.4 } else { 1.0 };
                model.loads.push(Load::point_force(at, sign * force));
            }
            6 => {
                let arm: f64 = if family == Family::Long { 0.01 } else { 0.2 };
                let hard = matches!(family, Family::Hard | Family::Extreme);
                let arm = if hard { arm.min(1.0 / lambda_l) } else { arm };
                model.loads.push(Load::point_moment(at, dice.even(-1.0, 1.0) * arm * l));
            }
            kind => {
                let (mut from, mut to) = (dice.place(), dice.place());
                if from > to {
                    (from, to) = (to, from);
                }
                if from == to {
                    (from, to) = (0.0, 1.0);
                }
                let (from, to) = (from * l, to * l);
                let size = 2.0 / l;
                let (start, end) = (dice.even(-0.1, 1.0) * size, dice.even(-0.1, 1.0) * size);
                model.loads.push(if kind == 9 {
                    let arm = 0.1 * l / lambda_l.max(1.0);
                    Load::distributed_moment(from, to, start * arm, end * arm)
                } else {
                    Load::distributed_force(from, to, start, end)
                });
            }
        }
    }
}

/// Adds a moment that moves the resultant of the loads close to an end of the beam.
fn bring_to_the_edge<R: Rng>(model: &mut Model, dice: &mut Dice<R>) {
    if !model.supports.is_empty() || dice.happens(0.3) {
        return;
    }
    let Ok(existence) = exists(model) else { return };
    let l = model.beam.length;
    let total = existence.resultant();
    if total <= 0.0 {
        return;
    }
    let share = dice.decades(-6.0, -1.0);
    let share = if dice.happens(0.5) { share } else { 1.0 - share };
    let wanted = total * share * l;
    let moment = wanted - existence.static_reactions[1] * l;
    let at = dice.place() * l;
    model.loads.push(Load::point_moment(at, moment));
}

/// Adds a uniform load, and multiplies the other loads by a factor close to the factor of first lift-off.
fn bring_to_lift_off<R: Rng>(model: &mut Model, dice: &mut Dice<R>) {
    let (l, own) = (model.beam.length, model.loads.len());
    let size: f64 = model.loads.iter().map(|load| size_of(load, l)).sum();
    model.loads.push(Load::uniform_force(0.0, l, size / l * dice.decades(-1.0, 1.0)));
    let found = load_factors(model, |load| load < own);
    if let Ok(LoadFactors { first_lift_off: FirstLiftOff::At { factor, .. }, .. }) = found {
        let beside = dice.decades(-12.0, -2.0);
        let factor = factor * if dice.happens(0.5) { 1.0 + beside } else { 1.0 - beside };
        for load in &mut model.loads[..own] {
            *load = load.scaled(factor);
        }
    }
}
