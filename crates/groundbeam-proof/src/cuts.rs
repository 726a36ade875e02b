//! Divides the beam into cells for the equilibrium correction, at free hinges and at nodes between long stretches in contact.

use crate::frame::Frame;
use crate::scalar::Scalar;

/// Returns the nodes at which the beam is always cut: both ends and the free hinges.
pub(crate) fn fewest_cuts<S: Scalar>(frame: &Frame<S>) -> Vec<usize> {
    let last = frame.spans.len();
    (0..=last).filter(|i| *i == 0 || *i == last || frame.nodes[*i].is_free_hinge()).collect()
}

/// Returns the nodes of [`fewest_cuts`] and additional cuts. An additional cut needs lengths in contact, in units of
/// (4EI/k)^¼: more than 2 since the previous cut (1 if contact ends at the cut), and more than 1 to its right.
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
        let most = if waves[i] == 0.0 { 1.0 } else { 2.0 };
        let enough = passed > most && ahead > 1.0;
        if enough || frame.nodes[i].is_free_hinge() {
            cuts.push(i);
            passed = 0.0;
        }
    }
    cuts.push(last);
    cuts
}

#[cfg(test)]
mod tests {
    use super::{fewest_cuts, more_cuts};
    use crate::given_claim::with_fields;
    use serde_json::json;

    /// Returns the results of [`fewest_cuts`] and [`more_cuts`] for pieces with the given `lengths`, negative out of
    /// contact. The unit (4EI/k)^¼ is 1.
    fn cuts(lengths: &[f64], hinges: &str) -> [Vec<usize>; 2] {
        let total: f64 = lengths.iter().map(|length| length.abs()).sum();
        let model = format!("[beam]\nlength = {total}\nEI = 6\n[foundation]\nk = 24\n{hinges}");
        let mut to = 0.0;
        let piece = |length: &f64| {
            let from = to;
            to += length.abs();
            let half = 0.5 * length.abs();
            json!({"x": [from, to], "half": half, "touches": *length > 0.0, "deflection": [1]})
        };
        let pieces: Vec<_> = lengths.iter().map(piece).collect();
        with_fields(&model, &json!({"pieces": pieces}), |fields| {
            [fewest_cuts(fields.frame), more_cuts(fields.frame)]
        })
    }

    #[test]
    fn cuts_are_separated_by_waves_of_contact() {
        for (lengths, expected) in [
            // The beam is cut at a node under two conditions. The length in contact is more than 2 between the
            // previous cut and the node, and more than 1 to the right of the node.
            (&[1.5; 5][..], &[0, 2, 4, 5][..]),
            (&[1.5, 1.5, 0.5], &[0, 3]),
            (&[1.0; 4], &[0, 4]),
            (&[1.0; 5], &[0, 3, 5]),
            // The beam is also cut at the end of a contact zone, if a length of more than 1 is in contact between the
            // previous cut and this node.
            (&[1.5, -3.0, 1.5], &[0, 1, 3]),
            (&[1.0, -3.0, 1.5], &[0, 3]),
            (&[1.5, -3.0, 1.0], &[0, 3]),
            (&[0.75, 0.75, -0.5, 0.75, 0.75], &[0, 2, 5]),
            // The lengths of pieces out of contact do not count.
            (&[-9.0, 1.5, 1.5], &[0, 3]),
            (&[-9.0, 1.5, 1.0, 1.5], &[0, 3, 4]),
        ] {
            let last = lengths.len();
            assert_eq!(cuts(lengths, ""), [vec![0, last], expected.to_vec()], "{lengths:?}");
        }
    }

    #[test]
    fn a_free_hinge_is_a_cut() {
        let free = "[[hinge]]\nat = 1.5\n";
        assert_eq!(cuts(&[1.5; 5], free), [vec![0, 1, 5], vec![0, 1, 3, 5]]);
        let elastic = "[[hinge]]\nat = 1.5\nrotational_spring = 1\n";
        assert_eq!(cuts(&[1.5; 5], elastic), [vec![0, 5], vec![0, 2, 4, 5]]);
    }
}
