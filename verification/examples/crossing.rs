//! Writes `docs/pictures/crossing.svg`, in which a load crosses a footing.

use groundbeam_testing::repository;
use groundbeam_verification::crossing;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = repository().join("docs/pictures/crossing.svg");
    std::fs::write(path, crossing::picture()?)?;
    Ok(())
}
