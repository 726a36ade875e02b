//! Tests of texts, tables, reports and pictures, in one test program: a file per subject, and what they share.

mod combinations;
mod common;
mod fields;
mod html;
mod json;
mod pictures;
mod pixels;
mod tables;
mod text;
