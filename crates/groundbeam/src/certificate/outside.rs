//! The ground beyond the beam's ends: how stiff it is seen from there, and how it ends.

use super::{Claim, ClaimedPiece};
use crate::model::{GroundOutside, Model, OutsideLayer};

/// The ground beyond the left and the right end.
#[derive(Debug)]
pub(super) struct Outside {
    pub beyond: [GroundOutside; 2],
    /// The force that it takes for one unit of settlement at the beam's end \[N/m\].
    pub stiffness: [f64; 2],
}

impl Outside {
    pub fn of(model: &Model, claim: &Claim) -> Self {
        let (ground, l) = (&model.foundation, model.beam.length);
        let pieces = [claim.pieces.first(), claim.pieces.last()];
        let at_end = |i: usize| {
            let constants =
                |piece: &ClaimedPiece| ground.constants_on(piece.x).map(|course| course.ends[i]);
            pieces[i].map_or([ground.subgrade, ground.shear_layer], constants)
        };
        let beyond = [ground.beyond(false, l, at_end(0)), ground.beyond(true, l, at_end(1))];
        let stiffness = [stiffness(&beyond[0]), stiffness(&beyond[1])];
        Outside { beyond, stiffness }
    }

    /// Whether the layer has a free end there.
    pub fn is_free(&self) -> [bool; 2] {
        [self.beyond[0].is_free(), self.beyond[1].is_free()]
    }

    /// How far the layer reaches beyond both ends, together.
    pub fn length(&self) -> f64 {
        self.beyond.iter().map(GroundOutside::length).sum()
    }

    pub fn layers(&self) -> impl Iterator<Item = &OutsideLayer> {
        self.beyond.iter().flat_map(|beyond| &beyond.layers)
    }
}

/// From the far end inward: a stretch of length h with the stiffness S behind it has
/// K (S + K tanh bh)/(K + S tanh bh), K = √(kμ), b = √(k/μ).
fn stiffness(beyond: &GroundOutside) -> f64 {
    // None: held.
    let mut behind = if beyond.held { None } else { Some(0.0) };
    for &OutsideLayer { length, subgrade: spring, shear_layer: shear } in beyond.layers.iter().rev()
    {
        let own = (spring * shear).sqrt();
        let tanh = ((spring / shear).sqrt() * length).tanh();
        behind = Some(match behind {
            Some(_) if length == f64::INFINITY => own,
            Some(behind) => own * (behind + own * tanh) / (own + behind * tanh),
            None => own / tanh,
        });
    }
    behind.unwrap_or(f64::INFINITY)
}

/// A bound of g(x, x) for the whole ground; infinite where there is no shear layer.
///
/// Less stiff ground gives more (the energy is monotone in k and μ), and so does ground that ends sooner, so
/// the softest constants bound it: endless ground, half of it, or a layer between two free ends, with
/// 1/2, 1 and coth(bL) times 1/√(kμ). Ground that is held gives less than ground that goes on.
pub(super) fn flexibility(model: &Model, outside: &Outside) -> f64 {
    let ground = &model.foundation;
    let under = |s: &&crate::model::FoundationSegment| s.to > 0.0 && s.from < model.beam.length;
    let segments = ground.segments.iter().filter(under);
    let all = segments.map(|s| (s.subgrade.smallest(), s.shear_layer.smallest()));
    let all = all.chain(outside.layers().map(|layer| (layer.subgrade, layer.shear_layer)));
    let (k, mu) = all
        .fold((ground.subgrade, ground.shear_layer), |(k, mu), (other_k, other_mu)| {
            (k.min(other_k), mu.min(other_mu))
        });
    if mu <= 0.0 {
        return f64::INFINITY;
    }
    let factor = match outside.is_free() {
        [false, false] => 0.5,
        [true, true] => {
            let length = model.beam.length + outside.length();
            1.0 / ((k / mu).sqrt() * length).tanh()
        }
        _ => 1.0,
    };
    factor / (k * mu).sqrt()
}
