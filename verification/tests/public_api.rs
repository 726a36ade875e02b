//! Compares the public items of the library with the recorded items, so that a change of the interface is
//! detected.

use groundbeam_testing::expect_file;
use groundbeam_verification::public_api::PublicApi;

/// Maximum number of names at the root of the library.
const AT_ROOT: usize = 45;

#[test]
fn public_items_are_the_recorded_ones() {
    let api = PublicApi::read();
    assert!(api.root.len() <= AT_ROOT, "{} names: {:?}", api.root.len(), api.root);
    let root: Vec<&str> = api.root.iter().map(String::as_str).collect();
    let made = format!("{}\n\n{}\n", root.join("\n"), api.lines().join("\n"));
    expect_file("verification/recorded/public-api.txt", &made);
}
