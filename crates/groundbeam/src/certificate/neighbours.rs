//! What acts on the ground besides the beam.

use super::outside::Outside;
use crate::model::{Extent, GroundOutside, Model, OutsideLayer};

/// Forces at points under the beam, and what the loads beside it push each of its ends with.
#[derive(Debug)]
pub(super) struct Neighbours {
    forces: Vec<(f64, f64)>,
    used: usize,
    near: f64,
    /// What holds the ground at an end of the beam that does not settle, less its own stiffness's share \[N\].
    pub beside: [f64; 2],
}

impl Neighbours {
    pub fn of(model: &Model, outside: &Outside) -> Self {
        let l = model.beam.length;
        let near = super::NEAR * l;
        let mut forces: Vec<(f64, f64)> = Vec::new();
        for load in model.ground_loads() {
            if let Extent::Point { at, size: force } = load.extent
                && at >= -near
                && at <= l + near
            {
                forces.push((at, force));
            }
        }
        forces.sort_by(|a, b| a.0.total_cmp(&b.0));
        let beside =
            [false, true].map(|right| push(model, &outside.beyond[usize::from(right)], right));
        Neighbours { forces, used: 0, near, beside }
    }

    /// The sum of the forces on the ground at a position; positions are asked for from left to right.
    pub fn force_at(&mut self, x: f64) -> f64 {
        let mut sum = 0.0;
        while let Some(&(at, force)) = self.forces.get(self.used) {
            if at > x + self.near {
                break;
            }
            self.used += 1;
            sum += force;
        }
        sum
    }
}

/// The loads spread on the ground along a piece, at its ends.
pub(super) fn spread(model: &Model, x: [f64; 2]) -> [f64; 2] {
    let middle = 0.5 * (x[0] + x[1]);
    let mut sum = [0.0; 2];
    for load in model.ground_loads() {
        let Extent::Distributed { from, to, start, end } = load.extent else { continue };
        if middle > from && middle < to {
            let rate = (end - start) / (to - from);
            sum = [0, 1].map(|i| sum[i] + start + rate * (x[i] - from));
        }
    }
    sum
}

/// What lies behind a place, seen from the beam: it takes S u − T.
#[derive(Debug, Clone, Copy)]
enum Behind {
    Held,
    Spring { stiffness: f64, push: f64 },
}

/// T at the beam's end, from the far end inward. Under a linear load u is q/k and ground without load v; with
/// C = cosh bh, s = sinh bh the latter has T = T′ K/(K C + S s) at its near end.
fn push(model: &Model, beyond: &GroundOutside, right: bool) -> f64 {
    let l = model.beam.length;
    let place = |distance: f64| if right { l + distance } else { -distance };
    let mut pieces: Vec<(f64, f64, OutsideLayer)> = Vec::new();
    let mut from = 0.0;
    for layer in &beyond.layers {
        let to = from + layer.length;
        let mut cuts = vec![from, to];
        for load in model.ground_loads() {
            let distances = load.extent.ends().map(|x| if right { x - l } else { -x });
            cuts.extend(distances.into_iter().filter(|d| *d > from && *d < to));
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        pieces.extend(cuts.windows(2).map(|pair| (pair[0], pair[1], *layer)));
        from = to;
    }
    let mut behind =
        if beyond.held { Behind::Held } else { Behind::Spring { stiffness: 0.0, push: 0.0 } };
    for (near, far, layer) in pieces.into_iter().rev() {
        let own = (layer.subgrade * layer.shear_layer).sqrt();
        if far == f64::INFINITY {
            behind = Behind::Spring { stiffness: own, push: 0.0 };
        } else {
            if let Behind::Spring { push, .. } = &mut behind {
                *push += points(model, place(far), super::NEAR * (far + l));
            }
            behind = across(model, behind, [place(near), place(far)], &layer);
        }
    }
    match behind {
        Behind::Spring { push, .. } => push,
        Behind::Held => 0.0,
    }
}

/// The forces at a place beside the beam.
fn points(model: &Model, x: f64, near: f64) -> f64 {
    let forces = model.ground_loads().map(|load| match load.extent {
        Extent::Point { at, size: force } if (at - x).abs() <= near => force,
        _ => 0.0,
    });
    forces.sum()
}

/// One stretch more, with the load on it.
fn across(model: &Model, behind: Behind, [near, far]: [f64; 2], layer: &OutsideLayer) -> Behind {
    let own = (layer.subgrade * layer.shear_layer).sqrt();
    let length = (far - near).abs();
    let z = (layer.subgrade / layer.shear_layer).sqrt() * length;
    let (tanh, faded, twice) = (z.tanh(), (-z).exp(), (-2.0 * z).exp());
    let mut x = [near, far];
    x.sort_by(f64::total_cmp);
    let mut load = spread(model, x);
    if far < near {
        load.reverse();
    }
    // m at the near and the far end, and μm' outward.
    let m = load.map(|q| q / layer.subgrade);
    let flux = layer.shear_layer * (m[1] - m[0]) / length;
    match behind {
        Behind::Held => {
            let stiffness = own / tanh;
            let carried = own * m[1] * 2.0 * faded / (1.0 - twice);
            Behind::Spring { stiffness, push: flux + stiffness * m[0] - carried }
        }
        Behind::Spring { stiffness: s, push } => {
            let rest = push - s * m[1] - flux;
            let passed = rest * 2.0 * own * faded / ((own + s) + (own - s) * twice);
            let stiffness = own * (s + own * tanh) / (own + s * tanh);
            Behind::Spring { stiffness, push: passed + stiffness * m[0] + flux }
        }
    }
}
