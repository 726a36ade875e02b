//! The nodes at which the balance cuts the beam, from its hinges and the wave lengths of contact between them.

use crate::frame::Frame;
use crate::scalar::Scalar;

/// The nodes at which the beam is cut: both ends and free hinges.
pub(crate) fn fewest_cuts<S: Scalar>(frame: &Frame<S>) -> Vec<usize> {
    let last = frame.spans.len();
    (0..=last).filter(|i| *i == 0 || *i == last || frame.nodes[*i].is_free_hinge()).collect()
}

/// As [`fewest_cuts`], with additional cuts. A cut is added after more than two wave lengths of contact since
/// the last cut (one wave length at the end of a contact zone), if more than one wave length of contact
/// follows.
pub(crate) fn more_cuts<S: Scalar>(frame: &Frame<S>) -> Vec<usize> {
    let last = frame.spans.len();
    let waves: Vec<f64> = frame
        .spans
        .iter()
        .map(|span| {
            let wave = (4.0 * span.bending.middle() / span.spring.middle()).sqrt().sqrt();
            if span.touches { span.h.middle() / wave } else { 0.0 }
        })
        .collect();
    let mut ahead: f64 = waves.iter().sum();
    let mut passed = 0.0;
    let mut cuts = vec![0];
    for i in 1..last {
        (passed, ahead) = (passed + waves[i - 1], ahead - waves[i - 1]);
        let ends = waves[i - 1] > 0.0 && waves[i] == 0.0;
        let enough = (passed > 2.0 || (ends && passed > 1.0)) && ahead > 1.0;
        if enough || frame.nodes[i].is_free_hinge() {
            cuts.push(i);
            passed = 0.0;
        }
    }
    cuts.push(last);
    cuts
}
