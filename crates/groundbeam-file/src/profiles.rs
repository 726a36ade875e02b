//! Finds rolled sections and rails by name in the data files of `sections/`, and computes their second moments of area.

use crate::quantity::{SECOND_MOMENT_OF_AREA, SHEAR_AREA};
use crate::suggest;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// A built-in section, which a model file selects with `section = { name = "IPE 300" }` or
/// `{ rail = "60E1" }`.
#[derive(Debug, Clone, PartialEq)]
pub struct RolledSection {
    /// Name of the section.
    pub name: String,
    /// Area of the section \[m²\].
    pub area: f64,
    /// Second moment of area about the horizontal axis \[m⁴\].
    pub inertia: f64,
    /// Shear area \[m²\]: the area of the webs between the flanges, or half the area of a circular tube;
    /// `None` for a rail.
    pub shear_area: Option<f64>,
    /// Height of the section \[m\]; `None` for a rail.
    pub height: Option<f64>,
    /// Standard or table from which the section comes.
    pub source: String,
    /// The text `one source` if no second source confirms a value of the section; otherwise `None`.
    pub remark: Option<String>,
    /// Area \[m²\] and second moment of area \[m⁴\] that the source prints, if any.
    printed: Option<[f64; 2]>,
}

const MM: f64 = 1e-3;
const INCH: f64 = 0.0254;
const ROLLED: &str = include_str!("../sections/rolled.tsv");
const AMERICAN: &str = include_str!("../sections/w.tsv");
const HOLLOW: &str = include_str!("../sections/hollow.tsv");
const RAILS: &str = include_str!("../sections/rails.tsv");

static SECTIONS: LazyLock<Vec<RolledSection>> = LazyLock::new(|| {
    let rolled = lines(ROLLED).filter_map(rolled);
    rolled
        .chain(lines(AMERICAN).filter_map(american))
        .chain(lines(HOLLOW).filter_map(hollow))
        .collect()
});

static RAIL_SECTIONS: LazyLock<Vec<RolledSection>> =
    LazyLock::new(|| lines(RAILS).filter_map(rail).collect());

/// All built-in rolled steel sections.
///
/// ```
/// let sections = groundbeam_file::rolled_sections();
/// let found = sections.iter().find(|section| section.name == "IPE 300").unwrap();
/// // With its fillets: 53.81 cm² and 8356 cm⁴.
/// assert!((found.area - 53.81e-4).abs() < 0.01e-4 && (found.inertia - 8356e-8).abs() < 1e-8);
/// ```
pub fn rolled_sections() -> &'static [RolledSection] {
    &SECTIONS
}

/// All built-in rails.
pub fn rail_sections() -> &'static [RolledSection] {
    &RAIL_SECTIONS
}

/// Finds the section with this name. The error is a hint: the rail with this name, or the three most similar names.
pub(crate) fn find(name: &str) -> Result<&'static RolledSection, String> {
    named(&SECTIONS, name).ok_or_else(|| {
        if let Some(rail) = named(&RAIL_SECTIONS, name) {
            return format!(
                "this is the name of a rail; write section = {{ rail = \"{}\" }}",
                rail.name
            );
        }
        let names: Vec<&str> = SECTIONS.iter().map(|section| &*section.name).collect();
        format!("the most similar names: {}", suggest::nearest_three(name, &names).join(", "))
    })
}

/// Finds the rail with this name. If there is no match, returns a hint that lists all rails, because rails
/// with similar names differ in their second moment of area.
pub(crate) fn find_rail(name: &str) -> Result<&'static RolledSection, String> {
    named(&RAIL_SECTIONS, name).ok_or_else(|| {
        let names: Vec<&str> = RAIL_SECTIONS.iter().map(|section| &*section.name).collect();
        format!("the known rails are {}; for other rails give `I`", names.join(", "))
    })
}

/// Finds the section with the name `name` in a list. Case, spaces and hyphens are ignored.
fn named(sections: &'static [RolledSection], name: &str) -> Option<&'static RolledSection> {
    let wanted = plain(name);
    sections.iter().find(|section| plain(&section.name) == wanted)
}

/// Returns the name in capitals, without spaces and hyphens.
fn plain(name: &str) -> String {
    name.to_uppercase().replace([' ', '-'], "").replace('×', "X")
}

fn lines(table: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect())
}

fn numbers(cells: &[&str], unit: f64) -> Vec<f64> {
    cells.iter().map(|cell| cell.parse::<f64>().map_or(f64::NAN, |number| number * unit)).collect()
}

fn printed(area: &str, inertia: &str) -> Option<[f64; 2]> {
    Some([area.parse::<f64>().ok()? * 1e-4, inertia.parse::<f64>().ok()? * 1e-8])
}

/// Area of a fillet of radius r, divided by r². The fillet is a square without a quarter of a disc.
const AREA: f64 = 1.0 - 0.25 * PI;
/// First moment of area of a fillet of radius r about one of its straight sides, divided by r³.
const FIRST: f64 = 5.0 / 6.0 - 0.25 * PI;
/// Second moment of area of a fillet of radius r about its own centroid, divided by r⁴.
const OWN: f64 = 1.0 - 0.3125 * PI - FIRST * FIRST / AREA;

/// Returns the area and the second moment of area of four fillets of radius `r`, with their corners at the heights
/// ±`corner`. `towards` is −1 if the fillets lie on the inner side of their corners, and 1 on the outer side.
pub(crate) fn fillets(r: f64, corner: f64, towards: f64) -> [f64; 2] {
    let area = AREA * r * r;
    let lever = corner + towards * FIRST / AREA * r;
    [4.0 * area, 4.0 * (OWN * r.powi(4) + area * lever * lever)]
}

/// Computes a rolled I-section, with fillets between web and flanges, from the dimensions in a line of the
/// data file.
fn rolled(cells: Vec<&'static str>) -> Option<RolledSection> {
    let [name, h, b, web, flange, r, area, inertia] = cells[..] else { return None };
    let [h, b, web, flange, r] = numbers(&[h, b, web, flange, r], MM)[..] else { return None };
    let between = h - 2.0 * flange;
    let [corners, steiner] = fillets(r, 0.5 * between, -1.0);
    let british = name.starts_with("UB") || name.starts_with("UC");
    let source = if british { "Blue Book, EN 10365:2017, BS 4-1:2005" } else { "EN 10365:2017" };
    Some(RolledSection {
        name: name.to_owned(),
        area: b * h - (b - web) * between + corners,
        inertia: (b * h.powi(3) - (b - web) * between.powi(3)) / 12.0 + steiner,
        shear_area: Some(web * between),
        height: Some(h),
        source: source.to_owned(),
        remark: None,
        printed: printed(area, inertia),
    })
}

/// Reads a W shape from a line of the data file. Its area A and its second moment of area I are the values
/// that AISC prints.
fn american(cells: Vec<&'static str>) -> Option<RolledSection> {
    let [name, d, _, web, flange, area, inertia] = cells[..] else { return None };
    let [d, web, flange] = numbers(&[d, web, flange], INCH)[..] else { return None };
    let [area, inertia] = numbers(&[area, inertia], 1.0)[..] else { return None };
    Some(RolledSection {
        name: name.to_owned(),
        area: area * INCH * INCH,
        inertia: inertia * INCH * INCH * INCH * INCH,
        shear_area: Some(web * (d - 2.0 * flange)),
        height: Some(d),
        source: "AISC Shapes Database v16".to_owned(),
        remark: None,
        printed: None,
    })
}

/// Computes a hollow section from a line of the data file. For the wall thickness t, rectangular sections have the
/// outer corner radius 1.5 t and the inner radius t (EN 10210-2, annex B).
fn hollow(cells: Vec<&'static str>) -> Option<RolledSection> {
    let [name, h, b, t, a, i] = cells[..] else { return None };
    let [h, b, t] = numbers(&[h, b, t], MM)[..] else { return None };
    let (area, inertia, shear_area);
    if b.is_nan() {
        // The area π(h² − inner²)/4 and the second moment of area π(h⁴ − inner⁴)/64 are factored. This avoids
        // cancellation.
        let inner = h - 2.0 * t;
        area = PI * t * (h - t);
        inertia = area * (h * h + inner * inner) / 16.0;
        shear_area = 0.5 * area;
    } else {
        let rounded = |h: f64, b: f64, r: f64| {
            let [corners, steiner] = fillets(r, 0.5 * h, -1.0);
            [b * h - corners, b * h.powi(3) / 12.0 - steiner]
        };
        let outer = rounded(h, b, 1.5 * t);
        let inner = rounded(h - 2.0 * t, b - 2.0 * t, t);
        [area, inertia] = [outer[0] - inner[0], outer[1] - inner[1]];
        shear_area = 2.0 * t * (h - 2.0 * t);
    }
    Some(RolledSection {
        name: name.to_owned(),
        area,
        inertia,
        shear_area: Some(shear_area),
        height: Some(h),
        source: "EN 10210-2:2006".to_owned(),
        remark: None,
        printed: printed(a, i),
    })
}

fn rail(cells: Vec<&'static str>) -> Option<RolledSection> {
    let [name, area, inertia, source, ref remark @ ..] = cells[..] else { return None };
    Some(RolledSection {
        name: name.to_owned(),
        area: SHEAR_AREA.listed(area),
        inertia: SECOND_MOMENT_OF_AREA.listed(inertia),
        shear_area: None,
        height: None,
        source: source.to_owned(),
        remark: remark.first().map(|remark| (*remark).to_owned()),
        printed: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the computed areas and second moments of area with the values that the sources print with
    /// three or four figures.
    #[test]
    fn sections_from_dimensions_have_the_printed_values() {
        let mut count = 0;
        for section in rolled_sections() {
            let name = &section.name;
            assert!(section.area > 0.0 && section.inertia > 0.0, "{name}");
            let Some([area, inertia]) = section.printed else { continue };
            count += 1;
            let figures = if section.source == "EN 10365:2017" { 0.06e-2 } else { 0.5e-2 };
            assert!((section.area / area - 1.0).abs() < figures, "{name}: {}", section.area);
            assert!(
                (section.inertia / inertia - 1.0).abs() < figures,
                "{name}: {}",
                section.inertia
            );
        }
        assert!(count > 800 && rolled_sections().len() > 1300, "{count}");
    }

    #[test]
    fn the_search_ignores_spaces_in_names() {
        assert_eq!(find("ipe300").unwrap().name, "IPE 300");
        assert_eq!(find("W12x26").unwrap().name, "W12X26");
        assert!(find("IPE 310").unwrap_err().contains("IPE 300"));
        let area = |name: &str| find_rail(name).unwrap().area;
        assert_eq!([area("60E1"), area("UIC60")], [76.70e-4, 76.86e-4]);
        assert!((area("136RE") / (INCH * INCH) - 13.32).abs() < 1e-12);
        assert!(find_rail("133RE").is_err());
    }

    /// Compares the area and the moments of area of a fillet, a square minus a quarter of a disc, with numerical
    /// integration.
    #[test]
    fn constants_of_a_fillet() {
        let steps = 100_000;
        let (mut area, mut first, mut second) = (0.0, 0.0, 0.0);
        for i in 0..steps {
            let y = (i as f64 + 0.5) / steps as f64;
            let width = (1.0 - (1.0 - (1.0 - y) * (1.0 - y)).sqrt()) / steps as f64;
            area += width;
            first += width * y;
            second += width * y * y;
        }
        assert!((area - AREA).abs() < 1e-7, "{area}");
        assert!((first / area - FIRST / AREA).abs() < 1e-6, "{}", first / area);
        assert!((second - first * first / area - OWN).abs() < 1e-7);
    }
}
