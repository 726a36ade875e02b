//! Tests of the proof, in one test program: a file per subject, and exact arithmetic.

mod arithmetic;
mod attacks;
mod documents;
mod exact;
mod idle_supports;
mod listed;
mod one_document;
mod open_ground;
mod partial_contact;
mod places;
mod point_contact;
mod reader;
mod right_answers;
mod supports;
