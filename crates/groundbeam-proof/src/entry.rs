//! The entry points: the model of a file, the proof of an answer, the verification of a document.

use crate::answer::Answer;
use crate::ball::Ball;
use crate::document::Document;
use crate::log::Log;
use crate::model::Model;
use crate::proof::{Proof, proven};
use crate::read::ReadError;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::verification::Verification;
use crate::wide::Wide;
use crate::{read, verification};

/// A number type in which a model is read and an answer is proven.
///
/// Generic code is compiled again in every crate that calls it with a type. `Wide` implements the methods, so that the
/// proof in this type is compiled once, in this crate.
pub trait Number: Scalar {
    #[doc(hidden)]
    fn model(text: &str, combination: Option<&str>) -> Result<Model<Self>, ReadError> {
        read::read_model(text, combination)
    }

    #[doc(hidden)]
    fn proof(model: &Model<Self>, answer: &Answer) -> Result<Proof, NotProven> {
        proven(model, answer, None, |_, proof| proof)
    }

    #[doc(hidden)]
    fn verification(
        model: &Model<Self>,
        document: &Document,
        log: Option<&mut Log>,
    ) -> Result<Verification, NotProven> {
        verification::verify_and_log(model, document, log)
    }
}

impl Number for f64 {}

impl Number for Ball {}

impl Number for Wide {
    fn model(text: &str, combination: Option<&str>) -> Result<Model<Self>, ReadError> {
        read::read_model(text, combination)
    }

    fn proof(model: &Model<Self>, answer: &Answer) -> Result<Proof, NotProven> {
        proven(model, answer, None, |_, proof| proof)
    }

    fn verification(
        model: &Model<Self>,
        document: &Document,
        log: Option<&mut Log>,
    ) -> Result<Verification, NotProven> {
        verification::verify_and_log(model, document, log)
    }
}

/// Reads a model file. Returns the model under the loads of a combination, or under all loads with their
/// values in the file.
///
/// Numbers are converted to m, N and rad if the file has units; otherwise they are unchanged. Decimals and
/// unit factors are exact. A scalar that cannot represent a number exactly encloses it.
///
/// ```
/// use groundbeam_proof::{Wide, Scalar, read_model};
///
/// let text = "[beam]\nlength = '10 ft'\nE = '30 GPa'\nsection = { width = '1 m', height = '0.8 m' }\n\
///             [foundation]\nk = '40 MN/m^2'\n[[load]]\npoint = '600 kN'\nat = '1 m'\n";
/// let model = read_model::<Wide>(text, None)?;
/// assert_eq!(model.beam.length.middle(), 3.048);
/// assert_eq!(model.beam.bending_stiffness.middle(), 1.28e9);
/// # Ok::<(), groundbeam_proof::ReadError>(())
/// ```
///
/// # Errors
///
/// The first fault of the file, with its position.
pub fn read_model<S: Number>(text: &str, combination: Option<&str>) -> Result<Model<S>, ReadError> {
    S::model(text, combination)
}

/// Bounds the distance of the answer from the solution of the model.
///
/// # Errors
///
/// The reason why nothing is proven.
pub fn prove<S: Number>(model: &Model<S>, answer: &Answer) -> Result<Proof, NotProven> {
    S::proof(model, answer)
}

/// Proves a document: its answer, and the other listed numbers.
///
/// # Errors
///
/// The reason why nothing is proven.
pub fn verify<S: Number>(model: &Model<S>, document: &Document) -> Result<Verification, NotProven> {
    S::verification(model, document, None)
}

/// Proves a document and writes the log of the proof.
///
/// # Errors
///
/// The reason why nothing is proven.
pub fn verify_and_log<S: Number>(
    model: &Model<S>,
    document: &Document,
    log: Option<&mut Log>,
) -> Result<Verification, NotProven> {
    S::verification(model, document, log)
}
