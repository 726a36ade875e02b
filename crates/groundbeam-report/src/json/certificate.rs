//! The certificate in the result document.

use groundbeam::Certificate;
use serde::Serializer;

/// Its figures, by their names and in their order.
pub(super) fn figures<S: Serializer>(proof: &Certificate, to: S) -> Result<S::Ok, S::Error> {
    to.collect_map(proof.figures())
}
