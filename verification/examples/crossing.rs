//! Writes `docs/pictures/crossing.svg`, in which a load crosses a footing.

use groundbeam_verification::{crossing, documents};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = documents::repository().join("docs/pictures/crossing.svg");
    std::fs::write(path, crossing::picture()?)?;
    Ok(())
}
