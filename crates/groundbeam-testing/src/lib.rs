//! Reads repository files, compares generated texts with these files, and finds external programs for the tests of all crates.

mod expected;
mod files;
mod tools;

pub use expected::{expect, expect_by, expect_file, expect_file_by, updating};
pub use files::{files, read, repository};
pub use tools::{environment, succeed, tools_or_skip};
