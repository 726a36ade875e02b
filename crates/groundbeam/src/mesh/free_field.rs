//! The free-field settlement u₀ under the beam and outside it, from the loads on the ground.
//!
//! u₀ solves −(μu₀′)′ + ku₀ = q on the whole line without a beam, where q is the load on the ground. It acts on the
//! beam like an additional initial gap.
//!
//! On a strip of ground with constant k and μ under linear q, u₀ = q/k + e, where e is a solution for unloaded ground.
//! The strips are [two-ports](TwoPort) in series, with equivalent forces at their ends in place of q.

use crate::ground::link::TwoPort;
use crate::mesh::cell::Cell;
use crate::model::{GroundOutside, Model};
use crate::numeric::elementary::{exp, expm1};
use crate::numeric::real::Real;

/// Stretch of ground with constant k and μ under a distributed load that varies linearly.
#[derive(Debug, Clone, Copy)]
struct Strip<R> {
    x: [f64; 2],
    spring: R,
    shear: R,
    load: [R; 2],
}

/// A load on the ground: a point force, or a distributed load that varies linearly.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GroundLoad<R = f64> {
    /// Positions of both ends of the load \[m\]; the two positions of a point force are equal.
    pub ends: [f64; 2],
    /// Values of the load at both ends, in \[N/m\], or in \[N\] for a point force.
    pub sizes: [R; 2],
}

impl<R: Real> GroundLoad<R> {
    fn is_point(&self) -> bool {
        self.ends[0] == self.ends[1]
    }

    fn at(&self, x: f64) -> R {
        let ([from, to], [start, end]) = (self.ends, self.sizes);
        if start == end { start } else { (start * (to - x) + end * (x - from)) / (to - from) }
    }
}

/// Returns the loads on the ground of a model.
pub(crate) fn ground_loads(model: &Model) -> Vec<GroundLoad> {
    let load = |load: &crate::model::Load| GroundLoad {
        ends: load.extent.ends(),
        sizes: load.extent.sizes(),
    };
    model.ground_loads().map(load).collect()
}

/// Data of the free field: the length of the beam, the ground outside both ends of the beam, and the loads on the
/// ground.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line<'a, R = f64> {
    pub length: f64,
    pub beyond: [&'a GroundOutside<R>; 2],
    pub loads: &'a [GroundLoad<R>],
}

/// Equivalent forces ∫q φ of the load q at both ends of a strip. Here φ is the settlement of unloaded ground that is
/// 1 at one end and 0 at the other end.
fn carried<R: Real>(strip: &Strip<R>, link: &TwoPort<R>) -> [R; 2] {
    let stiffness = (strip.spring * strip.shear).sqrt();
    let z = (strip.spring / strip.shear).sqrt() * (strip.x[1] - strip.x[0]);
    // 1/sinh z − 1/z.
    let less = if z.value() < 0.5 {
        let square = z * z;
        let terms =
            [-1.0 / 6.0, 7.0 / 360.0, -31.0 / 15120.0, 127.0 / 604_800.0, -73.0 / 3_421_440.0];
        z * terms.iter().rev().fold(R::ZERO, |sum, term| sum * square + *term)
    } else {
        exp(-z) * 2.0 / -expm1(z * -2.0) - R::ONE / z
    };
    let [a, b] = strip.load;
    [(a, b), (b, a)].map(|(here, there)| {
        (here * link.shunt_left + (here - there) * stiffness * less) / strip.spring
    })
}

/// Computes the free-field settlement from the loads on the ground, and stores its homogeneous part in every cell.
pub(crate) fn settle<R: Real>(line: &Line<R>, cells: &mut [Cell<R>]) {
    let (mut strips, held_left) = beside(line, false);
    strips.reverse();
    let begin = strips.len();
    strips.extend(cells.iter().map(under));
    let (outer, held_right) = beside(line, true);
    strips.extend(outer);
    let homogeneous = homogeneous(line, &strips, [held_left, held_right]);
    for (cell, homogeneous) in cells.iter_mut().zip(&homogeneous[begin..]) {
        cell.homogeneous_field = *homogeneous;
    }
}

/// Returns the work of all loads on the ground in the free-field settlement, minus the work of the loads outside the
/// beam with the settlement of the beam's ends fixed to zero.
pub(crate) fn work_of_loads<R: Real>(line: &Line<R>, cells: &[Cell<R>]) -> R {
    let [(mut strips, held_left), (right, held_right)] =
        [false, true].map(|right| beside(line, right));
    strips.reverse();
    let held = work(line, &strips, [held_left, true]) + work(line, &right, [true, held_right]);
    strips.extend(cells.iter().map(under));
    strips.extend(right);
    work(line, &strips, [held_left, held_right]) - held
}

fn work<R: Real>(line: &Line<R>, strips: &[Strip<R>], held: [bool; 2]) -> R {
    let homogeneous = homogeneous(line, strips, held);
    let mut work = R::ZERO;
    for load in line.loads.iter().filter(|load| load.is_point()) {
        let near = same_node(load.ends[0], line.length);
        let at = |(strip, ends): (&Strip<R>, &[R; 2])| {
            let end = (0..2).find(|end| (strip.x[*end] - load.ends[0]).abs() <= near)?;
            (strip.shear.value() > 0.0).then(|| ends[end] + strip.load[end] / strip.spring)
        };
        let u = strips.iter().zip(&homogeneous).find_map(at);
        work += load.sizes[0] * u.unwrap_or_default();
    }
    for (strip, ends) in strips.iter().zip(&homogeneous) {
        let [a, b] = strip.load;
        if strip.load == [R::ZERO; 2] {
            continue;
        }
        // The settlement is q/k + e, where e solves the equation for unloaded ground. So the work of the load q is
        // ∫q²/k dx + ∫q e dx.
        let length = strip.x[1] - strip.x[0];
        work += (a * a + a * b + b * b) * (length / 3.0) / strip.spring;
        if strip.shear.value() > 0.0 {
            let link = TwoPort::uniform(strip.spring, strip.shear, length);
            // ∫q e dx is the sum of the equivalent force of q times the value of e over both ends of the strip.
            let [left, right] = carried(strip, &link);
            work += left * ends[0] + right * ends[1];
        }
    }
    work
}

fn under<R: Real>(cell: &Cell<R>) -> Strip<R> {
    Strip { x: cell.x, spring: cell.subgrade, shear: cell.shear_layer, load: cell.ground_load }
}

/// Returns the free-field settlement outside the beam, at a distance from one end of the beam.
pub(crate) fn at<R: Real>(line: &Line<R>, right: bool, cells: &[Cell<R>], distance: f64) -> R {
    let (mut strips, held) = beside(line, right);
    let x = if right { line.length + distance } else { -distance };
    let Some(i) = strips.iter().position(|s| s.x[0] <= x && x <= s.x[1]) else { return R::ZERO };
    // The strip that contains the position x is cut at x, so that x is an end of a strip.
    let strip = strips[i];
    if x > strip.x[0] && x < strip.x[1] {
        let value = |at: f64| {
            // A strip without load may extend to infinity, so its load is not interpolated between its ends.
            if strip.load == [R::ZERO; 2] {
                return R::ZERO;
            }
            let t = (at - strip.x[0]) / (strip.x[1] - strip.x[0]);
            strip.load[0] * (1.0 - t) + strip.load[1] * t
        };
        let parts = [[strip.x[0], x], [x, strip.x[1]]];
        let mut parts = parts.map(|x| Strip { x, load: x.map(value), ..strip });
        if !right {
            parts.reverse();
        }
        strips.splice(i..=i, parts);
    }
    let (mut far, held_far) = beside(line, !right);
    far.reverse();
    if right {
        let begin = far.len() + cells.len();
        far.extend(cells.iter().map(under));
        far.extend(strips);
        value_at(line, &far, [held_far, held], x, begin)
    } else {
        strips.reverse();
        strips.extend(cells.iter().map(under));
        far.reverse();
        strips.extend(far);
        value_at(line, &strips, [held, held_far], x, 0)
    }
}

fn value_at<R: Real>(
    line: &Line<R>,
    strips: &[Strip<R>],
    held: [bool; 2],
    x: f64,
    begin: usize,
) -> R {
    let homogeneous = homogeneous(line, strips, held);
    let of = |i: usize, end: usize| homogeneous[i][end] + strips[i].load[end] / strips[i].spring;
    (begin..strips.len())
        .find_map(|i| {
            let ends = strips[i].x;
            if ends[1] == x { Some(of(i, 1)) } else { (ends[0] == x).then(|| of(i, 0)) }
        })
        .unwrap_or(R::ZERO)
}

/// Returns the strips of ground outside one end of the beam, ordered outward and cut at the ends of loads. Also returns
/// whether the settlement of the far end is held at zero.
fn beside<R: Real>(line: &Line<R>, right: bool) -> (Vec<Strip<R>>, bool) {
    let (l, beyond) = (line.length, line.beyond[usize::from(right)]);
    let outward = |x: f64| if right { x - l } else { -x };
    let mut cuts: Vec<f64> = line.loads.iter().flat_map(|load| load.ends).map(outward).collect();
    cuts.retain(|cut| *cut > 0.0);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut strips = Vec::new();
    let mut from = 0.0;
    for layer in &beyond.layers {
        let to = from + layer.length;
        let first = cuts.partition_point(|cut| *cut <= from);
        let inside = cuts[first..].iter().copied().take_while(|cut| *cut < to);
        let ends: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
        for pair in ends.windows(2) {
            let place = |d: f64| if right { l + d } else { -d };
            let mut x = [place(pair[0]), place(pair[1])];
            x.sort_by(f64::total_cmp);
            strips.push(Strip {
                x,
                spring: layer.subgrade,
                shear: layer.shear_layer,
                load: [R::ZERO; 2],
            });
        }
        from = to;
    }
    load_strips(line.loads, &mut strips, right);
    (strips, beyond.held)
}

/// Adds the distributed loads on the ground to the strips of ground outside one end of the beam. The strips are ordered
/// from this end outward.
fn load_strips<R: Real>(loads: &[GroundLoad<R>], strips: &mut [Strip<R>], right: bool) {
    let middle = |strip: &Strip<R>| 0.5 * (strip.x[0] + strip.x[1]);
    for load in loads.iter().filter(|load| !load.is_point()) {
        let [from, to] = load.ends;
        let within = if right {
            let first = strips.partition_point(|strip| middle(strip) <= from);
            first..strips.partition_point(|strip| middle(strip) < to).max(first)
        } else {
            let first = strips.partition_point(|strip| middle(strip) >= to);
            first..strips.partition_point(|strip| middle(strip) > from).max(first)
        };
        // Strips that extend to infinity have no load and are skipped.
        for strip in strips[within].iter_mut().filter(|s| s.x.iter().all(|x| x.is_finite())) {
            for (sum, x) in strip.load.iter_mut().zip(strip.x) {
                *sum += load.at(x);
            }
        }
    }
}

/// Computes the homogeneous part of the free-field settlement at both ends of each strip.
fn homogeneous<R: Real>(line: &Line<R>, strips: &[Strip<R>], held: [bool; 2]) -> Vec<[R; 2]> {
    let mut homogeneous = vec![[R::ZERO; 2]; strips.len()];
    let mut from = 0;
    while from < strips.len() {
        let layered = strips[from].shear.value() > 0.0;
        let same = |s: &&Strip<R>| (s.shear.value() > 0.0) == layered;
        let run = strips[from..].iter().take_while(same).count();
        let to = from + run;
        if layered {
            let held = [held[0] && from == 0, held[1] && to == strips.len()];
            let u = chain(line, &strips[from..to], held);
            for (i, strip) in strips[from..to].iter().enumerate() {
                let ends = [u[i], u[i + 1]];
                homogeneous[from + i] = [0, 1].map(|e| ends[e] - strip.load[e] / strip.spring);
            }
        }
        from = to;
    }
    homogeneous
}

/// Largest distance from a node at which a point force counts as acting at this node.
fn same_node(at: f64, length: f64) -> f64 {
    16.0 * f64::EPSILON * (at.abs() + length)
}

/// Computes the free-field settlement at the nodes of consecutive strips that have a shear layer.
fn chain<R: Real>(line: &Line<R>, strips: &[Strip<R>], held: [bool; 2]) -> Vec<R> {
    let n = strips.len();
    // `own` is the stiffness of the spring from each node to the fixed base, `series` the stiffness of the spring
    // from each node to the next node, and `force` the force on each node.
    let (mut own, mut series, mut force) =
        (vec![R::ZERO; n + 1], vec![R::ZERO; n], vec![R::ZERO; n + 1]);
    for (i, strip) in strips.iter().enumerate() {
        if strip.x[0] == f64::NEG_INFINITY {
            own[i + 1] += (strip.spring * strip.shear).sqrt();
        } else if strip.x[1] == f64::INFINITY {
            own[i] += (strip.spring * strip.shear).sqrt();
        } else {
            let link = TwoPort::uniform(strip.spring, strip.shear, strip.x[1] - strip.x[0]);
            own[i] += link.shunt_left;
            own[i + 1] += link.shunt_right;
            series[i] = link.series;
            let [left, right] = carried(strip, &link);
            force[i] += left;
            force[i + 1] += right;
        }
    }
    if held[0] {
        own[0] = R::from(f64::INFINITY);
    }
    if held[1] {
        own[n] = R::from(f64::INFINITY);
    }
    let nodes: Vec<f64> = strips.iter().map(|s| s.x[0]).chain([strips[n - 1].x[1]]).collect();
    for load in line.loads.iter().filter(|load| load.is_point()) {
        let (at, load) = (load.ends[0], load.sizes[0]);
        let near = same_node(at, line.length);
        if at >= nodes[0] - near && at <= nodes[n] + near {
            let right = nodes.partition_point(|x| *x < at).min(n);
            let left = right.saturating_sub(1);
            let node = if at - nodes[left] < nodes[right] - at { left } else { right };
            force[node] += load;
        }
    }
    // This loop condenses the ground on the left of each node to one spring and one force.
    for i in 0..n {
        let (spring, c) = (own[i], series[i]);
        if c.value() > 0.0 {
            own[i + 1] += c / (c / spring + 1.0);
            let before = force[i] * (c / (spring + c));
            force[i + 1] += before;
        }
    }
    let mut u = vec![R::ZERO; n + 1];
    for i in (0..=n).rev() {
        let (c, next) = if i < n { (series[i], u[i + 1]) } else { (R::ZERO, R::ZERO) };
        let spring = own[i] + c;
        u[i] = if spring.value() > 0.0 { (force[i] + c * next) / spring } else { R::ZERO };
    }
    u
}
