//! Adds the special features of some families to random models with beam, ground and loads.

use super::{Dice, size_of};
use groundbeam::{
    Beam, Foundation, Hinge, Load, Model, Support, Verdict, exists,
    model::{Acts, GroundEnd, Profile},
};
use rand::Rng;

/// Applies a compression between the buckling load of the beam without ground (0 for an unsupported beam) and the
/// buckling load of the beam on its ground.
pub(super) fn compress<R: Rng>(model: &mut Model, dice: &mut Dice<R>) {
    let own = groundbeam::own_buckling_load(model);
    let unit = model.beam.bending_stiffness / (model.beam.length * model.beam.length);
    model.beam.axial_force = -(1.0001 * own).max(1e-3 * unit);
    if let Ok(Verdict::Local(local)) = exists(model).map(|existence| existence.verdict) {
        let least = -model.beam.axial_force;
        let part =
            if dice.happens(0.2) { 1.0 - dice.decades(-6.0, -2.0) } else { dice.even(0.0, 1.0) };
        model.beam.axial_force = -(least + part * (local.critical_compression - least));
    }
}

/// Varies EI along one to three stretches: linearly, as the third or fourth power of a linear depth, or as a random
/// polynomial.
pub(super) fn vary_beam<R: Rng>(mut beam: Beam, stiffness: f64, dice: &mut Dice<R>) -> Beam {
    let length = beam.length;
    for [from, to] in stretches(length, dice) {
        let (start, end) = (dice.decades(-1.0, 1.0), dice.decades(-1.0, 1.0));
        let profile = match dice.up_to(3) {
            0 | 1 => Profile::linear(start, end),
            2 => {
                let power = if dice.happens(0.5) { 3 } else { 4 };
                let depth = Profile::linear(start.sqrt(), end.sqrt());
                let first = Some(Profile::constant(1.0));
                let product = (0..power).fold(first, |all, _| all?.times(&depth));
                product.unwrap_or(depth)
            }
            _ => {
                let values: Vec<f64> =
                    (0..3 + dice.up_to(3)).map(|_| dice.decades(-1.0, 1.0)).collect();
                Profile::by_control_values(&values).unwrap_or(Profile::linear(start, end))
            }
        };
        beam = beam.with_varying_segment(from, to, profile.scaled(stiffness));
    }
    beam
}

/// Sets the shear stiffness of the beam or of segments to 10⁻² to 10⁴ times EI/L². L is 1/λ with the wave number λ, but
/// at most the beam length.
pub(super) fn shear_beam<R: Rng>(mut beam: Beam, lambda_l: f64, dice: &mut Dice<R>) -> Beam {
    let length = beam.length;
    let wave = length / lambda_l.max(1.0);
    let of =
        |stiffness: f64, dice: &mut Dice<R>| stiffness / (wave * wave) * dice.decades(-2.0, 4.0);
    if dice.happens(0.85) {
        beam.shear_stiffness = Some(of(beam.bending_stiffness, dice));
    }
    for segment in &mut beam.segments {
        if dice.happens(0.3) {
            let end = of(beam.bending_stiffness, dice);
            let start = if dice.happens(0.5) { end } else { end * dice.decades(-1.0, 1.0) };
            segment.shear_stiffness = Some(Profile::linear(start, end));
        }
    }
    if !beam.shears() {
        let (own, end) = (beam.bending_stiffness, of(beam.bending_stiffness, dice));
        let free = stretches(length, dice).into_iter().find(|[from, to]| {
            beam.segments.iter().all(|segment| segment.to <= *from || segment.from >= *to)
        });
        if let Some([from, to]) = free {
            beam = beam.with_shearing_segment(from, to, own, Profile::linear(end, 2.0 * end));
        }
    }
    beam
}

/// Adds one to five one-way supports, rigid or elastic, and loads that lift the beam off some of them.
pub(super) fn bearings<R: Rng>(mut model: Model, dice: &mut Dice<R>) -> Model {
    let (length, k) = (model.beam.length, model.foundation.subgrade);
    // A uniform weight makes the position of every part of the beam unique.
    model = model.with_load(Load::uniform_force(0.0, length, dice.even(0.1, 0.5) / length));
    for _ in 0..=dice.up_to(4) {
        let at = dice.place() * length;
        let support = if dice.happens(0.5) {
            Support::pinned(at)
        } else {
            Support::spring(at, k * length * dice.decades(-2.0, 2.0), 0.0)
        };
        let acts = if dice.happens(0.6) { Acts::Up } else { Acts::Down };
        if model.supports.iter().all(|other| other.at != at) {
            model = model.with_support(support.acting(acts));
        }
        if dice.happens(0.3) {
            let force = -dice.even(0.1, 1.0);
            model = model.with_load(Load::point_force(dice.place() * length, force));
        }
    }
    model
}

/// Adds one to four hinges, each of which is elastic with the probability 1/3. Sometimes removes the shear layer of the
/// ground.
pub(super) fn hinge<R: Rng>(mut model: Model, dice: &mut Dice<R>) -> Model {
    let (length, stiffness) = (model.beam.length, model.beam.bending_stiffness);
    if dice.happens(0.25) {
        model.foundation.shear_layer = 0.0;
    }
    for _ in 0..=dice.up_to(3) {
        let at = dice.even(0.02, 0.98) * length;
        model = model.with_hinge(if dice.up_to(2) == 0 {
            Hinge::elastic(at, stiffness / length * dice.decades(-2.0, 2.0))
        } else {
            Hinge::free(at)
        });
    }
    model
}

/// Varies k and μ along one to three stretches of the ground. With probability 1/10, a stretch has no shear layer.
pub(super) fn vary_ground<R: Rng>(
    mut ground: Foundation,
    length: f64,
    dice: &mut Dice<R>,
) -> Foundation {
    let curve = |dice: &mut Dice<R>, value: f64| {
        let values = [0, 1, 2].map(|_| value * dice.decades(-0.7, 0.7));
        match dice.up_to(2) {
            0 => Profile::constant(values[0]),
            1 => Profile::linear(values[0], values[1]),
            _ => Profile::by_control_values(&values).unwrap_or(Profile::constant(value)),
        }
    };
    let (k, mu) = (ground.subgrade, ground.shear_layer);
    for [from, to] in stretches(length, dice) {
        let spring = curve(dice, k);
        let shear = if dice.happens(0.1) { Profile::constant(0.0) } else { curve(dice, mu) };
        ground = ground.with_varying_segment(from, to, spring, shear);
    }
    ground
}

/// Adds segments with other values of k and μ outside the beam. On each side, the ground then has a free or a held end
/// at a random distance from the beam, or it is infinite.
pub(super) fn change_beside<R: Rng>(
    mut ground: Foundation,
    length: f64,
    dice: &mut Dice<R>,
) -> Foundation {
    let (k, mu) = (ground.subgrade, ground.shear_layer);
    // `fade` is the decay length of the ground, the unit of the following lengths.
    let fade = (mu / k).sqrt();
    for right in [false, true] {
        let at = |distance: f64| if right { length + distance } else { -distance };
        let mut near = if dice.happens(0.3) { 0.0 } else { fade * dice.decades(-2.0, 1.0) };
        for _ in 0..dice.up_to(2) {
            let far = near + fade * dice.decades(-2.0, 1.0);
            let (k, mut mu) = (k * dice.decades(-1.0, 1.0), mu * dice.decades(-1.0, 1.0));
            if dice.happens(0.1) {
                mu = 0.0;
            }
            let [from, to] = if right { [at(near), at(far)] } else { [at(far), at(near)] };
            ground = ground.with_segment(from, to, k, mu);
            near = far * if dice.happens(0.5) { 1.0 } else { 1.5 };
        }
        let distance = fade * dice.decades(-2.0, 1.0);
        ground.ends[usize::from(right)] = match dice.up_to(3) {
            0 => GroundEnd::Free { at: at(0.0) },
            1 => GroundEnd::Free { at: at(distance) },
            2 => GroundEnd::Held { at: at(distance) },
            _ => GroundEnd::Endless,
        };
    }
    ground
}

/// Adds loads on the ground under and next to the beam. Their magnitudes are comparable with those of the loads on the
/// beam.
pub(super) fn add_neighbours<R: Rng>(model: &mut Model, dice: &mut Dice<R>) {
    let (l, ground) = (model.beam.length, model.foundation.clone());
    let size: f64 = model.loads.iter().map(|load| size_of(load, l)).sum();
    let reach = (4.0 * (ground.shear_layer / ground.subgrade).sqrt()).min(l);
    let [left, right] = ground.ends;
    let from = left.at().unwrap_or(-reach).max(-reach);
    let to = right.at().unwrap_or(l + reach).min(l + reach);
    for _ in 0..=dice.up_to(2) {
        let force = size * dice.decades(-2.0, 0.3);
        let mut ends = [0, 1].map(|_| dice.even(from, to));
        ends.sort_by(f64::total_cmp);
        let [from, to] = ends;
        model.loads.push(match dice.up_to(2) {
            0 => Load::ground_force(from, force),
            1 => {
                Load::ground_force(if dice.happens(0.5) { from.min(0.0) } else { to.max(l) }, force)
            }
            _ => {
                let start = force / (to - from) * dice.even(0.0, 1.0);
                Load::distributed_ground_force(from, to, start, force / (to - from))
            }
        });
    }
}

/// Returns up to three stretches of a beam. With probability 1/3, the only stretch is the whole beam.
fn stretches<R: Rng>(length: f64, dice: &mut Dice<R>) -> Vec<[f64; 2]> {
    if dice.up_to(2) == 0 {
        return vec![[0.0, length]];
    }
    let mut ends: Vec<f64> = (0..2 + 2 * dice.up_to(2)).map(|_| dice.place() * length).collect();
    ends.sort_by(f64::total_cmp);
    ends.chunks_exact(2).filter(|pair| pair[0] < pair[1]).map(|pair| [pair[0], pair[1]]).collect()
}

/// Adds one to three imposed curvatures, whose moments are smaller than, similar to or larger than the moments of the
/// loads.
pub(super) fn curl<R: Rng>(model: &mut Model, lambda_l: f64, dice: &mut Dice<R>) {
    let l = model.beam.length;
    let loads: f64 = model.loads.iter().map(|load| size_of(load, l)).sum();
    let size = loads * l / lambda_l.max(1.0) / model.beam.bending_stiffness;
    for _ in 0..=dice.up_to(2) {
        let (mut from, mut to) = (dice.place() * l, dice.place() * l);
        if from > to {
            (from, to) = (to, from);
        }
        if from == to {
            (from, to) = (0.0, l);
        }
        let size = size * dice.decades(-1.5, 1.0);
        let start = dice.even(-1.0, 1.0) * size;
        let end = if dice.happens(0.5) { start } else { dice.even(-1.0, 1.0) * size };
        model.loads.push(Load::distributed_curvature(from, to, start, end));
    }
}
