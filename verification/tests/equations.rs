//! Checks that a source file names every equation of the paper, or that a list gives the reason why it is not needed.
//!
//! Claims: `docs/equations.md`.

use groundbeam_testing::expect;
use groundbeam_verification::equations;

#[test]
fn every_equation_has_its_location_in_the_code() {
    let (table, missing) = equations::index();
    assert!(missing.is_empty(), "{}", missing.join("\n"));
    expect("docs/equations.md", "equations", &table);
}
