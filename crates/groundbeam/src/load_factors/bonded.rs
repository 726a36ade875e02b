//! The beam glued to the ground along its whole length, and what must push there for it to touch.

use crate::chain::node::Loose;
use crate::contact::glue::Glue;
use crate::contact::state::Found;
use crate::contact::surface::Surface;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::pressure_under;
use crate::model::Model;
use crate::numeric::polynomial::{Coefficients, derivative, rescale, sign_changes, value};

/// The deflection of a beam that touches along its whole length, whether the ground pushes or pulls.
pub(super) fn glued_all_along(model: &Model) -> Result<Found, Loose> {
    Glue::new(model).on(&[[0.0, model.beam.length]], None)
}

/// What must not be negative on a stretch of the beam or at a point of it: the pressure there, or a
/// concentrated force. It is the polynomial staying + λ·growing in s ∈ \[−1, 1\].
#[derive(Debug, Clone)]
pub(super) struct Watched {
    x: [f64; 2],
    staying: Side,
    growing: Side,
}

/// One of the two, with the size of what was added up in it.
#[derive(Debug, Clone, Default)]
struct Side {
    coefficients: Coefficients,
    size: f64,
}

/// What rounding leaves of a sum of terms of size 1: a few dozen operations on each.
const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// Newton's steps for one place; they end of themselves, long before.
const MOST_STEPS: usize = 200;

impl Watched {
    /// Whether the ground would have to pull before the first load grows.
    pub fn pulls_at_first(&self) -> bool {
        lowest(&self.staying.coefficients).1 < -ROUNDING * self.staying.size
    }

    /// The largest factor below `factor` up to which the ground need not pull here, and where it then is
    /// about to; none if it need not at `factor` itself, which may be infinite.
    ///
    /// Newton's method on the least value over s, which is concave in the factor: the steps go down, and
    /// never below the root.
    pub fn first_pull_below(&self, factor: f64) -> Option<(f64, f64)> {
        let (mut factor, mut found) = (factor, None);
        for _ in 0..MOST_STEPS {
            let Some(s) = self.pulled_at(factor) else { break };
            let [stays, grows] =
                [&self.staying, &self.growing].map(|side| value(&side.coefficients, s));
            let next = (stays / -grows).max(0.0);
            if grows >= 0.0 || next >= factor {
                break;
            }
            factor = next;
            found = Some((factor, self.position(s)));
        }
        found
    }

    /// Whether a factor of this place is zero but for rounding.
    pub fn is_nothing(&self, factor: f64) -> bool {
        factor * self.growing.size <= ROUNDING * self.staying.size
    }

    /// Where the ground would have to pull most at a factor, if at all.
    fn pulled_at(&self, factor: f64) -> Option<f64> {
        let (stays, grows) = (&self.staying, &self.growing);
        let (coefficients, size) = if factor.is_finite() {
            let both = stays.coefficients.iter().zip(grows.coefficients.iter());
            let sum = both.map(|(a, b)| a + factor * b).collect();
            (sum, stays.size + factor * grows.size)
        } else {
            (grows.coefficients, grows.size)
        };
        let (s, lowest) = lowest(&coefficients);
        (lowest < -ROUNDING * size).then_some(s)
    }

    fn position(&self, s: f64) -> f64 {
        let [from, to] = self.x;
        let half = 0.5 * (to - from);
        if s <= 0.0 { from + half * (1.0 + s) } else { to - half * (1.0 - s) }
    }
}

/// Where in \[−1, 1\] a polynomial is least, and how much that is; a bound, if that is not negative.
fn lowest(c: &[f64]) -> (f64, f64) {
    let spread: f64 = c.iter().skip(1).map(|a| a.abs()).sum();
    let bound = c.first().map_or(0.0, |constant| constant - spread);
    if bound >= 0.0 {
        return (-1.0, bound);
    }
    let mut places = vec![-1.0];
    sign_changes(&derivative(c), &mut places);
    places.push(1.0);
    let all = places.into_iter().map(|s| (s, value(c, s)));
    all.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((-1.0, bound))
}

/// Pressures and concentrated forces along the whole beam, from left to right, of two deflections of one
/// model under different loads. Their cells may differ: boundary layers are cut where there are any.
pub(super) fn watched(staying: &Found, growing: &Found) -> Vec<Watched> {
    let mut all = forces(staying, growing);
    let l = staying.mesh.cells.last().map_or(0.0, |cell| cell.x[1]);
    let (mut i, mut j, mut from) = (0, 0, 0.0);
    while let (Some(a), Some(b)) = (staying.mesh.cells.get(i), growing.mesh.cells.get(j)) {
        let same = (a.x[1] - b.x[1]).abs() <= SAME_PLACE * l;
        let to = if same { a.x[1] } else { a.x[1].min(b.x[1]) };
        let x = [from, to];
        let mut sides = [pressure(staying, i, x), pressure(growing, j, x)];
        for (end, root) in known_roots(staying, x, a) {
            for side in &mut sides {
                for _ in 0..root {
                    without_root(&mut side.coefficients, end);
                }
            }
        }
        let [stays, grows] = sides;
        all.push(Watched { x, staying: stays, growing: grows });
        i += usize::from(same || a.x[1] < b.x[1]);
        j += usize::from(same || b.x[1] < a.x[1]);
        from = to;
    }
    all.sort_by(|a, b| a.x[0].total_cmp(&b.x[0]));
    all
}

/// Positions closer than this part of the length are one.
const SAME_PLACE: f64 = 16.0 * f64::EPSILON;

/// p = k(w − g₀) − μ(w − g₀)″ − q on a part of a cell.
fn pressure(found: &Found, i: usize, x: [f64; 2]) -> Side {
    let cell = &found.mesh.cells[i];
    let half = 0.5 * cell.length();
    let deflection = Coefficients::from(found.deflection().cell(i));
    let whole = pressure_under(cell, half, &deflection);
    let factor = cell.shear / (half * half);
    let term =
        |(j, c): (usize, &f64)| (cell.spring + factor * (j * j.saturating_sub(1)) as f64) * c.abs();
    let [gap, load] = [cell.gap, cell.ground_load].map(|ends| ends[0].abs().max(ends[1].abs()));
    let size = deflection.iter().enumerate().map(term).sum::<f64>() + cell.spring * gap + load;
    let coefficients = if x == cell.x {
        whole
    } else {
        let [a, b] = x.map(|x| cell.local(x));
        rescale(&whole, 0.5 * (a + b), 0.5 * (b - a))
    };
    Side { coefficients, size }
}

/// Where a support keeps the beam at the undeformed ground, separate springs press with nothing whatever the
/// loads: what counts next to a pin is how fast the pressure rises from it, next to a clamp how it curves.
/// The ends s = ∓1 of a part of a cell at which that is so, and the order of the root.
fn known_roots(found: &Found, x: [f64; 2], cell: &Cell) -> Vec<(f64, usize)> {
    if cell.shear > 0.0 {
        return Vec::new();
    }
    let mut roots = Vec::new();
    for (i, end) in [(0, -1.0), (1, 1.0)] {
        let nodes = &found.mesh.nodes;
        let at = nodes.partition_point(|node| node.x < x[i]);
        let Some(node) = nodes.get(at).filter(|node| node.x == x[i] && node.pinned) else {
            continue;
        };
        if x[i] == cell.x[i] && cell.gap[i] == node.settlement {
            let flat = node.clamped && cell.gap_slope == 0.0;
            roots.push((end, if flat { 2 } else { 1 }));
        }
    }
    roots
}

/// Divides c(s) by 1 + s if `end` is −1, by 1 − s if it is 1: both are positive within.
fn without_root(c: &mut Coefficients, end: f64) {
    // From the highest power down; what remains at the end is the rounding of a zero.
    let mut carried = 0.0;
    for a in c.iter_mut().rev() {
        let quotient = if end < 0.0 { *a - carried } else { carried - *a };
        *a = carried;
        carried = quotient;
    }
    c.pop();
}

/// The concentrated forces: under the ends of the beam and of the shear layer, at corners and at kinks.
fn forces(staying: &Found, growing: &Found) -> Vec<Watched> {
    let [stays, grows] = [staying, growing].map(forces_of);
    let find = |all: &[(f64, Side)], x: f64| {
        let nothing = Side { coefficients: Coefficients::zeros(1), size: 0.0 };
        all.iter().find(|(at, _)| *at == x).map_or(nothing, |(_, side)| side.clone())
    };
    // Corners of the gap are corners only where the gap acts: with the loads that stay.
    let all = stays.iter().map(|(x, side)| {
        let growing = find(&grows, *x);
        Watched { x: [*x; 2], staying: side.clone(), growing }
    });
    // A beam that shears has kinks under the forces that grow.
    let kinks = grows.iter().filter(|(x, _)| stays.iter().all(|(at, _)| at != x));
    let kinks = kinks.map(|(x, side)| {
        let staying = find(&stays, *x);
        Watched { x: [*x; 2], staying, growing: side.clone() }
    });
    all.chain(kinks).collect()
}

fn forces_of(found: &Found) -> Vec<(f64, Side)> {
    let w = found.deflection();
    let surface = Surface::of(&w, &found.zones);
    let force = |atom: &crate::contact::surface::Atom| {
        let cell = &found.mesh.cells[atom.spot.cell];
        let slope = 2.0 * cell.shear / cell.length();
        let outside = (cell.spring * cell.shear).sqrt();
        let obstacle = w.obstacle(atom.spot.cell);
        let terms = obstacle.iter().enumerate();
        let size = terms.map(|(j, c)| (outside + slope * j as f64) * c.abs()).sum();
        (cell.global(atom.spot.s), Side { coefficients: [atom.force][..].into(), size })
    };
    surface.atoms.iter().map(force).collect()
}
