//! Stiffness of the ground beside the beam, as the beam's end feels it.
//!
//! The ground beside the beam is a row of even stretches. Over a stretch of length h with K = √(kμ) and t = tanh(h√(k/μ))
//! the stiffness S of all that lies beyond it becomes S⁺ = K(S + Kt)/(K + St). It begins with S = K on an endless stretch,
//! S = 0 where the layer ends free or meets separate springs, and with S⁺ = K/t where the surface is held.

use crate::frame::Frame;
use crate::model::{GroundEnd, Model};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::values::{constant, not_negative, positive};

/// K₀ and K_l with flux = K u at the beam's ends; exactly zero where the layer ends with the beam.
pub(crate) fn stiffness<S: Scalar>(
    model: &Model<S>,
    frame: &Frame<S>,
) -> Result<[S; 2], NotProven> {
    let mut both = [S::zero(); 2];
    for (side, outside) in both.iter_mut().enumerate() {
        let span = if side == 0 { &frame.spans[0] } else { &frame.spans[frame.spans.len() - 1] };
        if span.layered {
            let (row, end) = row(model, frame, side, [span.spring, span.shear])?;
            *outside = beyond(&row, end)?;
        }
    }
    Ok(both)
}

/// An even stretch that begins at a distance from the beam's end.
#[derive(Clone, Copy)]
struct Stretch<S> {
    from: S,
    ground: [S; 2],
}

/// How the row of stretches ends.
enum End<S> {
    Endless,
    Free(S),
    Held(S),
}

/// The stretches beside one end of the beam, outward.
fn row<S: Scalar>(
    model: &Model<S>,
    frame: &Frame<S>,
    side: usize,
    own: [S; 2],
) -> Result<(Vec<Stretch<S>>, End<S>), NotProven> {
    let units = frame.units;
    let outward = |at: S| {
        let (at, end) = (units.metres(at), if side == 0 { S::zero() } else { frame.length });
        match at == end {
            true => S::zero(),
            false if side == 0 => end - at,
            false => at - end,
        }
    };
    let mut row = vec![Stretch { from: S::zero(), ground: own }];
    for segment in &model.ground.segments {
        let (near, far) =
            if side == 0 { (segment.to, segment.from) } else { (segment.from, segment.to) };
        if outward(near).low() >= 0.0 && outward(far).low() > 0.0 {
            let spring = positive(units.scaled(constant(&segment.spring), 1, -2), "k")?;
            let shear = units.scaled(constant(&segment.shear), 1, 0);
            let shear = not_negative(shear, "the shear constant of the ground")?;
            row.push(Stretch { from: outward(near), ground: [spring, shear] });
        }
    }
    row.sort_by(|a, b| a.from.middle().total_cmp(&b.from.middle()));
    let end = match model.ground.ends[side] {
        GroundEnd::Endless => End::Endless,
        GroundEnd::Free(at) => End::Free(outward(at)),
        GroundEnd::Held(at) => End::Held(outward(at)),
    };
    Ok((row, end))
}

/// The stiffness of a row of stretches, from the far end inward.
fn beyond<S: Scalar>(row: &[Stretch<S>], end: End<S>) -> Result<S, NotProven> {
    let unclear =
        || NotProven::new("the ends of stretches of ground beside the beam are too close");
    let zero = S::zero();
    let (reach, mut held) = match end {
        End::Endless => (None, false),
        End::Free(at) => (Some(at), false),
        End::Held(at) => (Some(at), true),
    };
    let mut stretches: Vec<(Stretch<S>, Option<S>)> = Vec::new();
    for (i, stretch) in row.iter().enumerate() {
        if reach.is_some_and(|reach| reach == stretch.from || (stretch.from - reach).low() > 0.0) {
            break;
        }
        if stretch.ground[1] == zero {
            held = false;
            break;
        }
        let next = row.get(i + 1).map(|next| next.from);
        let to = match (next, reach) {
            (Some(next), Some(reach)) if (reach - next).low() > 0.0 => Some(next),
            (Some(next), Some(reach)) if (next - reach).low() >= 0.0 || next == reach => {
                Some(reach)
            }
            (Some(_), Some(_)) => return Err(unclear()),
            (next, reach) => next.or(reach),
        };
        let length = match to {
            Some(to) if to == stretch.from => continue,
            Some(to) if (to - stretch.from).low() > 0.0 => Some(to - stretch.from),
            Some(_) => return Err(unclear()),
            None => None,
        };
        stretches.push((*stretch, length));
    }
    let mut stiffness = None;
    for (stretch, length) in stretches.iter().rev() {
        let [spring, shear] = stretch.ground;
        let own = (spring * shear).sqrt();
        stiffness = Some(match length {
            None => own,
            Some(length) => {
                let t = hyperbolic_tangent(spring.div(shear).sqrt() * *length);
                match stiffness {
                    None if held => own.div(t),
                    behind => {
                        let behind = behind.unwrap_or(zero);
                        (own * (behind + own * t)).div(own + behind * t)
                    }
                }
            }
        });
    }
    match stiffness {
        None if held => Err(NotProven::new("the ground is held at the end of the beam")),
        stiffness => Ok(stiffness.unwrap_or(zero)),
    }
}

/// tanh z for z > 0.
fn hyperbolic_tangent<S: Scalar>(z: S) -> S {
    let fallen = (-z.scaled(1)).expm1();
    (-fallen).div(fallen + S::of(2.0))
}
