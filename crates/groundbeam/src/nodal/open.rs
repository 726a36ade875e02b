//! Computes the deflection w, the slope w' and the ground settlement at the nodes between contact zones, in closed form.

use super::beam::NODAL_TERMS;
use super::grid::{Grid, Run};
use super::hull::{Hull, Zone};
use super::span::Span;
use crate::ground::link::TwoPort;
use crate::numeric::elementary::{exp, expm1};

/// Writes the deflection w, or the slope w' if `derivative` is true, at the nodes of a span. The value at an end of
/// the span is written only if this node is an end of the beam.
pub(crate) fn beam(grid: &Grid, span: &Span, v: &[f64; 4], derivative: bool, into: &mut [f64]) {
    let last = grid.last();
    span.unfold(v, |piece, own| {
        // The piece to the right of a node writes the value at this node.
        let ([from, to], length) = (piece.nodes, piece.length);
        let first = usize::from(from == span.from && from > 0);
        let nodes = from + first..to + usize::from(to == last);
        let sign = if span.mirrored { -1.0 } else { 1.0 };
        let Some((series, terms)) = piece.series(own) else {
            // A piece without a power series of the deflection is a single element, so it has no nodes between its
            // ends.
            let [w, theta, d1, d2] = own;
            let ends = if derivative {
                [sign * theta, sign * (theta + d2)]
            } else {
                [w, w + length * theta + d1]
            };
            for node in nodes {
                into[node] = ends[usize::from((node == to) != span.mirrored)];
            }
            return;
        };
        let start = if span.mirrored { 1.0 } else { 0.0 };
        let step = sign / (to - from) as f64;
        let s = move |i: usize| start + (first + i) as f64 * step;
        if !derivative {
            return values(&series, terms, s, &mut into[nodes]);
        }
        let (mut slope, scale) = ([0.0; NODAL_TERMS], sign / length);
        for (j, c) in series.iter().enumerate().take(terms).skip(1) {
            slope[j - 1] = j as f64 * c * scale;
        }
        values(&slope, terms - 1, s, &mut into[nodes]);
    });
}

/// Evaluates the significant terms of a power series at many positions.
fn values(c: &[f64; NODAL_TERMS], terms: usize, s: impl Fn(usize) -> f64, into: &mut [f64]) {
    match terms {
        0..=4 => horner::<4>(c, s, into),
        5..=6 => horner::<6>(c, s, into),
        7..=10 => horner::<10>(c, s, into),
        11..=14 => horner::<14>(c, s, into),
        _ => horner::<NODAL_TERMS>(c, s, into),
    }
}

/// Number of positions at which one loop evaluates a power series. The sums for different positions are independent,
/// so the processor can compute them at the same time.
const WIDTH: usize = 4;

fn horner<const N: usize>(c: &[f64; NODAL_TERMS], s: impl Fn(usize) -> f64, into: &mut [f64]) {
    for (block, values) in into.chunks_mut(WIDTH).enumerate() {
        let s: [f64; WIDTH] = std::array::from_fn(|i| s(block * WIDTH + i));
        let mut sums = [c[N - 1]; WIDTH];
        for c in c[..N - 1].iter().rev() {
            for (sum, s) in sums.iter_mut().zip(&s) {
                *sum = *sum * s + c;
            }
        }
        values.copy_from_slice(&sums[..values.len()]);
    }
}

/// Writes the settlement minus the free-field settlement at every node. Out of contact, it is that of ground without
/// pressure.
pub(crate) fn settlement(
    grid: &Grid,
    deflection: &[f64],
    contact: &[Zone],
    settlement: &mut Vec<f64>,
) {
    settlement.clear();
    settlement.resize(grid.last() + 1, 0.0);
    let hull = Hull { grid, deflection, near: &[] };
    let mut before: Option<(usize, f64)> = None;
    for &[from, to] in contact.iter() {
        if grid.flat {
            settlement[from..=to].copy_from_slice(&deflection[from..=to]);
        } else {
            (from..=to).for_each(|node| settlement[node] = hull.psi(node));
        }
        let ends = [before.map(|b| b.1), Some(settlement[from])];
        ground(grid, [before.map_or(0, |b| b.0), from], ends, settlement);
        before = Some((to, settlement[to]));
    }
    if let Some((to, psi)) = before
        && to < grid.last()
    {
        ground(grid, [to, grid.last()], [Some(psi), None], settlement);
    }
}

/// Adds the free-field settlement to the settlements at the nodes. Where it jumps, a node has that of its right side.
pub(crate) fn add_free_field(grid: &Grid, settlement: &mut [f64]) {
    for run in grid.runs.iter().filter(|run| run.cell.has_free_field()) {
        settlement[run.first] += run.cell.free_field_at(-1.0)[0];
    }
    if let Some(run) = grid.runs.last() {
        settlement[run.end()] += run.cell.free_field_at(1.0)[0];
    }
}

/// Writes the settlement of open ground between the nodes `from` and `to` with the settlements `left` and `right`.
/// `None` stands for an end of the beam out of contact, whose settlement is written too.
fn ground(
    grid: &Grid,
    [from, to]: [usize; 2],
    [left, right]: [Option<f64>; 2],
    settlement: &mut [f64],
) {
    // A first pass joins the two-ports of all parts from left to right. A second pass computes the settlements from
    // right to left.
    let parts: Vec<_> = grid.parts(from, to).collect();
    let beyond = TwoPort { shunt_right: grid.outside[0], ..TwoPort::default() };
    let mut before: Vec<TwoPort> = Vec::with_capacity(parts.len());
    let mut so_far = left.is_none().then_some(beyond);
    for &(run, a, b) in &parts {
        let own = grid.runs[run].open(a, b);
        let link = so_far.map_or(own, |so_far| so_far.then(own));
        before.push(link);
        so_far = Some(link);
    }
    let start = left.unwrap_or(0.0);
    // `held` computes the settlement of a node with the two-port `link` on its left. The ground on its right exerts
    // `force` at zero settlement.
    let held = |link: &TwoPort, force: f64, stiffness: f64| {
        let all = link.series + link.shunt_right + stiffness;
        if all > 0.0 { (link.series * start + force) / all } else { 0.0 }
    };
    let mut next =
        right.unwrap_or_else(|| before.last().map_or(0.0, |link| held(link, 0.0, grid.outside[1])));
    if right.is_none() {
        settlement[to] = next;
    }
    for (i, &(run, a, b)) in parts.iter().enumerate().rev() {
        let own = grid.runs[run].open(a, b);
        let (force, stiffness) = (own.series * next, own.series + own.shunt_left);
        let here = match i.checked_sub(1) {
            Some(i) => held(&before[i], force, stiffness),
            None if left.is_some() => start,
            None => held(&beyond, force, stiffness),
        };
        if i > 0 || left.is_none() {
            settlement[a] = here;
        }
        between(&grid.runs[run], here, next, &mut settlement[a + 1..b]);
        next = here;
    }
}

/// Writes the settlement u of ground without pressure, μu″ = ku, at equal distances between two ends with given
/// settlements.
fn between(run: &Run, left: f64, right: f64, into: &mut [f64]) {
    if run.cell.shear_layer == 0.0 {
        return into.fill(0.0);
    }
    let b = run.layer.rate;
    let count = into.len() + 1;
    let length = b * run.h * count as f64;
    if length < 0.5 {
        // Over a short distance, the settlement is computed as a multiple of cosh plus a multiple of sinh about the
        // middle.
        let z = 0.5 * length;
        let (even, odd) = series(z);
        let mean = 0.5 * (left + right) / value(&even, 1.0);
        let rise = 0.5 * (right - left) / value(&odd, 1.0);
        for (i, u) in into.iter_mut().enumerate() {
            let s = 2.0 * (i + 1) as f64 / count as f64 - 1.0;
            *u = mean * value(&even, s * s) + rise * (s * value(&odd, s * s));
        }
        return;
    }
    let faded = exp(-length);
    let whole = -expm1(-2.0 * length);
    let amplitudes = [(left - right * faded) / whole, (right - left * faded) / whole];
    // The falling and the rising exponential are computed by recurrence. The recurrence restarts in each block to
    // limit rounding errors.
    const STEPS: usize = 32;
    let step = b * run.h;
    let decay = exp(-step);
    let growth = exp(step);
    for (block, values) in into.chunks_mut(STEPS).enumerate() {
        let first = (block * STEPS + 1) as f64 * step;
        let mut falling = amplitudes[0] * exp(-first);
        let mut rising = amplitudes[1] * exp(first - length);
        for u in values {
            *u = falling + rising;
            falling *= decay;
            rising *= growth;
        }
    }
}

const SERIES: usize = 7;

/// Coefficients of the power series of cosh(zs) and sinh(zs)/s in s².
fn series(z: f64) -> ([f64; SERIES], [f64; SERIES]) {
    let (mut even, mut odd) = ([0.0; SERIES], [0.0; SERIES]);
    let mut term = 1.0;
    for i in 0..SERIES {
        even[i] = term;
        term *= z / (2 * i + 1) as f64;
        odd[i] = term;
        term *= z / (2 * i + 2) as f64;
    }
    (even, odd)
}

fn value(c: &[f64; SERIES], square: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * square + c)
}
