//! Divides the ground outside the beam into stretches with constant k and μ, at the ends of the foundation segments.

use crate::model::foundation::Foundation;
use crate::model::foundation::GroundEnd;
use crate::numeric::real::Real;
use crate::numeric::tolerance::same_place;

/// Stretch of ground with constant k and μ > 0 outside the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OutsideLayer<R = f64> {
    /// Length of the stretch \[m\]; infinite for the last stretch of infinite ground.
    pub length: f64,
    /// k \[N/m²\].
    pub subgrade: R,
    /// μ \[N\], positive.
    pub shear_layer: R,
}

/// Ground with a shear layer outside one end of the beam, as stretches that are listed outward. Empty if the shear
/// layer ends at the beam's end.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct GroundOutside<R = f64> {
    pub layers: Vec<OutsideLayer<R>>,
    /// Whether the ground displacement is fixed to zero at the outer end of the ground, as by a wall. Otherwise this
    /// end is free.
    pub held: bool,
}

impl Foundation {
    /// Returns the ground outside one end of a beam of length `l`. `at_end` contains k and μ at this end. The result is
    /// empty on Winkler ground, whose surface may jump at the beam's end.
    pub(crate) fn beyond(&self, right: bool, l: f64, at_end: [f64; 2]) -> GroundOutside {
        let own = |i: usize| {
            let segment = &self.segments[i];
            [segment.subgrade.start(), segment.shear_layer.start()]
        };
        self.beyond_with(right, l, at_end, own)
    }

    /// Returns the ground outside the beam as [`Self::beyond`] does, for any number type. `own` returns k and μ of
    /// the segment with a given index.
    pub(crate) fn beyond_with<R: Real>(
        &self,
        right: bool,
        l: f64,
        [spring, shear]: [R; 2],
        own: impl Fn(usize) -> [R; 2],
    ) -> GroundOutside<R> {
        if shear.value() == 0.0 {
            return GroundOutside { layers: Vec::new(), held: false };
        }
        // A position within rounding error of the beam's end counts as the beam's end. The difference 0.0 − x avoids
        // a negative zero at x = 0.
        let outward = |x: f64| {
            let distance = if right { x - l } else { 0.0 - x };
            if distance.abs() <= same_place(l) { 0.0 } else { distance }
        };
        let mut stretches = vec![(0.0, spring, shear)];
        for (i, segment) in self.segments.iter().enumerate() {
            let (near, far) =
                if right { (segment.from, segment.to) } else { (segment.to, segment.from) };
            // A segment that begins under the beam is skipped, because the first stretch outside the beam already has
            // the k and μ of this segment.
            if outward(near) >= 0.0 && outward(far) > 0.0 {
                let [spring, shear] = own(i);
                stretches.push((outward(near), spring, shear));
            }
        }
        stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (end, mut held) = match self.ends[usize::from(right)] {
            GroundEnd::Endless => (f64::INFINITY, false),
            GroundEnd::Free { at } => (outward(at), false),
            GroundEnd::Held { at } => (outward(at), true),
        };
        let mut layers = Vec::new();
        for (i, &(from, spring, shear)) in stretches.iter().enumerate() {
            let to = stretches.get(i + 1).map_or(end, |next| next.0.min(end));
            if to <= from {
                continue;
            }
            if shear.value() == 0.0 {
                held = false;
                break;
            }
            layers.push(OutsideLayer { length: to - from, subgrade: spring, shear_layer: shear });
        }
        GroundOutside { layers, held }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ground_continues_until_a_segment_begins() {
        let mut ground = Foundation::pasternak(1.0, 2.0)
            .with_segment(-1.0, 3.0, 5.0, 6.0)
            .with_segment(-7.0, -4.0, 8.0, 9.0)
            .with_segment(12.0, 13.0, 3.0, 0.0);
        let lengths = |beyond: &GroundOutside| -> Vec<f64> {
            beyond.layers.iter().map(|layer| layer.length).collect()
        };
        let left = ground.beyond(false, 10.0, [5.0, 6.0]);
        assert_eq!(lengths(&left), [4.0, f64::INFINITY]);
        assert_eq!((left.layers[0].subgrade, left.layers[1].shear_layer), (5.0, 9.0));
        assert!(!left.held);
        let right = ground.beyond(true, 10.0, [1.0, 2.0]);
        assert_eq!(lengths(&right), [2.0], "the shear layer ends where Winkler ground begins");
        assert!(!right.held);
        ground.ends = [GroundEnd::Held { at: -3.0 }, GroundEnd::Free { at: 10.0 }];
        let left = ground.beyond(false, 10.0, [5.0, 6.0]);
        assert!(left.held && lengths(&left) == [3.0]);
        assert!(ground.beyond(true, 10.0, [1.0, 2.0]).layers.is_empty());
        let at_both_ends = Foundation::pasternak(1.0, 2.0)
            .with_segment(-1.0, 0.0, 3.0, 4.0)
            .with_segment(10.0, 11.0, 3.0, 4.0);
        for right in [false, true] {
            let beyond = at_both_ends.beyond(right, 10.0, [1.0, 2.0]);
            assert_eq!(beyond.layers.iter().map(|layer| layer.subgrade).collect::<Vec<_>>(), [3.0]);
            assert_eq!(at_both_ends.beyond(right, 10.0, [1.0, 0.0]), GroundOutside::default());
        }
        let l = 0.1 + 0.2;
        let within_rounding = Foundation::pasternak(1.0, 2.0)
            .with_segment(-1.0, 1e-17, 3.0, 4.0)
            .with_segment(0.3, 5.0, 3.0, 4.0);
        for right in [false, true] {
            assert_eq!(within_rounding.beyond(right, l, [1.0, 2.0]).layers[0].subgrade, 3.0);
        }
    }
}
