//! Tests of model files, in one test program: a file per subject, and what they share.

mod common;
mod documents;
mod errors;
mod mutations;
mod output;
mod properties;
mod refused;
mod schema;
mod segments;
mod zeros;
