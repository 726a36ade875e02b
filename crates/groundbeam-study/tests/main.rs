//! Tests of studies, in one test program.

mod damaged;
mod stopped;
