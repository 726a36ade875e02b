//! Reads models and proves claimed solutions, in the number types whose operations enclose rounding errors.
//!
//! The functions are compiled here for each number type, so that other crates need not compile the whole proof again.

use crate::answer::Answer;
use crate::ball::Ball;
use crate::document::Document;
use crate::log::Log;
use crate::model::Model;
use crate::proof::{Proof, proven};
use crate::read::{self, ReadError};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::verification::{Verification, verified};
use crate::wide::Wide;

/// A number type whose operations enclose their rounding errors, so that proofs are rigorous: [`Ball`] or
/// [`Wide`].
pub trait Enclosing: Scalar {
    #[doc(hidden)]
    fn read(text: &str, combination: Option<&str>) -> Result<Model<Self>, ReadError>;

    #[doc(hidden)]
    fn prove(model: &Model<Self>, answer: &Answer) -> Result<Proof, NotProven>;

    #[doc(hidden)]
    fn verify(
        model: &Model<Self>,
        document: &Document,
        log: Option<&mut Log>,
    ) -> Result<Verification, NotProven>;
}

macro_rules! compiled {
    ($($number:ty),*) => {$(
        impl Enclosing for $number {
            fn read(text: &str, combination: Option<&str>) -> Result<Model<Self>, ReadError> {
                read::read_model(text, combination)
            }

            fn prove(model: &Model<Self>, answer: &Answer) -> Result<Proof, NotProven> {
                proven(model, answer, None, |_, proof| proof)
            }

            fn verify(
                model: &Model<Self>,
                document: &Document,
                log: Option<&mut Log>,
            ) -> Result<Verification, NotProven> {
                verified(model, document, log)
            }
        }
    )*};
}

compiled!(Ball, Wide);

/// Reads a model file, with the loads of a combination or with all loads at their values in the file.
///
/// If the file has units, numbers are converted to m, N and rad. Each number is exact, or enclosed if the number type
/// cannot represent it.
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
/// Returns the first fault of the file and its position.
pub fn read_model<S: Enclosing>(
    text: &str,
    combination: Option<&str>,
) -> Result<Model<S>, ReadError> {
    S::read(text, combination)
}

/// Bounds the difference between the claimed solution `answer` and the exact solution of the model.
///
/// # Errors
///
/// Returns the reason why nothing is proven.
pub fn prove<S: Enclosing>(model: &Model<S>, answer: &Answer) -> Result<Proof, NotProven> {
    S::prove(model, answer)
}

/// Proves that the solution in a document is correct, and checks the other numbers that the document lists.
///
/// # Errors
///
/// Returns the reason why nothing is proven.
pub fn verify<S: Enclosing>(
    model: &Model<S>,
    document: &Document,
) -> Result<Verification, NotProven> {
    S::verify(model, document, None)
}

/// Verifies a document as [`verify`] does, and writes the log of the proof to `log` if it is given.
///
/// # Errors
///
/// Returns the reason why nothing is proven.
pub fn verify_and_log<S: Enclosing>(
    model: &Model<S>,
    document: &Document,
    log: Option<&mut Log>,
) -> Result<Verification, NotProven> {
    S::verify(model, document, log)
}
