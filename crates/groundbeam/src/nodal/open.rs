//! Between zones of contact: w, w' and the ground's surface at every node, in closed form.

use super::beam::TERMS;
use super::grid::{Grid, Run};
use super::span::Span;
use crate::numeric::elementary::{exp, expm1};

/// Writes w or w' at the nodes of a span but its ends that touch.
pub(crate) fn beam(grid: &Grid, span: &Span, v: &[f64; 4], derivative: bool, into: &mut [f64]) {
    let last = grid.last();
    span.unfold(v, |[from, to], length, series, terms| {
        // Every piece writes its left end unless that touches; the last one its right end too.
        let first = usize::from(from == span.from && from > 0);
        let nodes = from + first..to + usize::from(to == last);
        let (start, sign) = if span.mirrored { (1.0, -1.0) } else { (0.0, 1.0) };
        let step = sign / (to - from) as f64;
        let s = move |i: usize| start + (first + i) as f64 * step;
        if !derivative {
            return values(series, terms, s, &mut into[nodes]);
        }
        let (mut slope, scale) = ([0.0; TERMS], sign / length);
        for (j, c) in series.iter().enumerate().take(terms).skip(1) {
            slope[j - 1] = j as f64 * c * scale;
        }
        values(&slope, terms - 1, s, &mut into[nodes]);
    });
}

/// A series at many places, with as many terms as matter.
fn values(c: &[f64; TERMS], terms: usize, s: impl Fn(usize) -> f64, into: &mut [f64]) {
    match terms {
        0..=4 => horner::<4>(c, s, into),
        5..=6 => horner::<6>(c, s, into),
        7..=10 => horner::<10>(c, s, into),
        11..=14 => horner::<14>(c, s, into),
        _ => horner::<TERMS>(c, s, into),
    }
}

/// Places side by side: one sum would wait for itself.
const WIDTH: usize = 4;

fn horner<const N: usize>(c: &[f64; TERMS], s: impl Fn(usize) -> f64, into: &mut [f64]) {
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

/// Writes the settlement at the nodes strictly between two, of which those that touch are given by their
/// ψ; a missing one is the ground beyond the beam.
pub(crate) fn ground(
    grid: &Grid,
    [from, to]: [usize; 2],
    [left, right]: [Option<f64>; 2],
    settlement: &mut [f64],
) {
    // u at the ends of each part: the link from the start forwards, the values backwards.
    let start = left.unwrap_or(0.0);
    let mut next = right.unwrap_or(0.0);
    if right.is_none() {
        let link = grid.left_then(from, left.is_some(), to);
        next = link.series * start / (link.series + link.shunt_right + grid.outside[1]);
        settlement[to] = next;
    }
    let mut parts = grid.parts(from, to).collect::<Vec<_>>();
    while let Some((run, a, b)) = parts.pop() {
        let own = &grid.runs[run];
        let before = if parts.is_empty() {
            if left.is_some() {
                start
            } else {
                // The ground beyond the left end holds the part's left end.
                let link = own.open(a, b);
                link.series * next / (link.series + link.shunt_left + grid.outside[0])
            }
        } else {
            let link = grid.left_then(from, left.is_some(), a);
            let own = own.open(a, b);
            let pull = link.series * start + own.series * next;
            pull / (link.series + link.shunt_right + own.series + own.shunt_left)
        };
        if !(parts.is_empty() && left.is_some()) {
            settlement[a] = before;
        }
        between(own, before, next, &mut settlement[a + 1..b]);
        next = before;
    }
}

/// u = (left sinh b(L − x) + right sinh bx)/sinh bL at equal steps strictly between two ends.
fn between(run: &Run, left: f64, right: f64, into: &mut [f64]) {
    let b = run.layer.rate;
    let count = into.len() + 1;
    let length = b * run.h * count as f64;
    if length < 0.5 {
        // cosh and sinh about the middle, each over its value at the ends.
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
    // Both exponentials by steps, anew after every few.
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

/// cosh(zs) and sinh(zs)/s by powers of s².
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
