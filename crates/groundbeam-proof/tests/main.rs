//! Tests of the proof, in one test program: a file per subject, and exact arithmetic.

mod arithmetic;
mod attacks;
mod documents;
mod exact;
mod listed;
mod one_document;
mod partial_contact;
mod reader;
mod right_answers;
mod supports;
