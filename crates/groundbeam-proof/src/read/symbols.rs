//! Symbols of units with their dimensions, exact factors and SI prefixes.

use super::unit::{Dimension, Factor, INCH, ONE, Powers, Unit};

const FOOT: Powers = [1, 1, 0, 0, 0, 0, 0, 0];
const YARD: Powers = [1, 1, 1, 0, 0, 0, 0, 0];
const POUND: Powers = [0, 0, 0, 1, 0, 0, 0, 0];
const GRAVITY: Powers = [0, 0, 0, 0, 1, 0, 0, 0];
/// 5/9.
const FAHRENHEIT: Powers = [0, 0, 0, 0, 0, -1, 0, 0];
/// The factor π/180 of a degree. Its exponent is the last number of `Powers`.
const DEGREE: Powers = [0, 0, 0, 0, 0, 0, 0, 1];

/// A unit symbol: its dimension and factor, and whether it may have an SI prefix.
struct Symbol {
    names: &'static [&'static str],
    dimension: Dimension,
    ten: i32,
    powers: Powers,
    takes_prefix: bool,
}

pub(super) const LENGTH: Dimension = Dimension::of(0, 1);
pub(super) const FORCE: Dimension = Dimension::of(1, 0);
const KELVIN: Dimension = Dimension::NONE.with_temperature(1);
const RADIAN: Dimension = Dimension::NONE.with_angle(1);

const fn si(names: &'static [&'static str], dimension: Dimension, ten: i32) -> Symbol {
    Symbol { names, dimension, ten, powers: ONE, takes_prefix: true }
}

const fn other(
    names: &'static [&'static str],
    dimension: Dimension,
    ten: i32,
    powers: Powers,
) -> Symbol {
    Symbol { names, dimension, ten, powers, takes_prefix: false }
}

/// Returns the conversion factor of a unit lbf/Lⁿ, such as lbf/ft², with n = `power`. `length` is the conversion factor
/// of the unit of length L.
const fn per(length: Powers, power: i32) -> Powers {
    [-power * length[0], -power * length[1], 0, 1, 0, 0, 0, 0]
}

/// Multiplies a factor by 2. A ton is twice 1000 pounds.
const fn twice(powers: Powers) -> Powers {
    let mut powers = powers;
    powers[6] = 1;
    powers
}

const SYMBOLS: &[Symbol] = &[
    si(&["m"], LENGTH, 0),
    si(&["N"], FORCE, 0),
    si(&["Pa"], Dimension::of(1, -2), 0),
    si(&["bar"], Dimension::of(1, -2), 5),
    si(&["rad"], RADIAN, 0),
    other(&["K", "°C", "degC"], KELVIN, 0, ONE),
    other(&["°F", "degF"], KELVIN, 0, FAHRENHEIT),
    other(&["deg", "°"], RADIAN, 0, DEGREE),
    other(&["in", "inch", "inches", "\"", "″", "”"], LENGTH, 0, INCH),
    other(&["ft", "foot", "feet", "'", "′", "’"], LENGTH, 0, FOOT),
    other(&["yd"], LENGTH, 0, YARD),
    other(&["mil"], LENGTH, -3, INCH),
    other(&["lbf", "lb", "lbs", "pound", "pounds", "#"], FORCE, 0, POUND),
    other(&["kip", "kips", "Kip", "Kips", "KIP", "KIPS", "k"], FORCE, 3, POUND),
    other(&["kgf", "kp"], FORCE, 0, GRAVITY),
    other(&["tf"], FORCE, 3, GRAVITY),
    other(&["plf"], Dimension::of(1, -1), 0, per(FOOT, 1)),
    other(&["klf"], Dimension::of(1, -1), 3, per(FOOT, 1)),
    other(&["pli"], Dimension::of(1, -1), 0, per(INCH, 1)),
    other(&["kli"], Dimension::of(1, -1), 3, per(INCH, 1)),
    other(&["Msi"], Dimension::of(1, -2), 6, per(INCH, 2)),
    other(&["tsf"], Dimension::of(1, -2), 3, twice(per(FOOT, 2))),
    other(&["tcf"], Dimension::of(1, -3), 3, twice(per(FOOT, 3))),
    other(&["psi"], Dimension::of(1, -2), 0, per(INCH, 2)),
    other(&["ksi"], Dimension::of(1, -2), 3, per(INCH, 2)),
    other(&["psf"], Dimension::of(1, -2), 0, per(FOOT, 2)),
    other(&["ksf"], Dimension::of(1, -2), 3, per(FOOT, 2)),
    other(&["pci"], Dimension::of(1, -3), 0, per(INCH, 3)),
    other(&["kci"], Dimension::of(1, -3), 3, per(INCH, 3)),
    other(&["pcf"], Dimension::of(1, -3), 0, per(FOOT, 3)),
    other(&["kcf"], Dimension::of(1, -3), 3, per(FOOT, 3)),
];

const PREFIXES: [(&str, i32); 13] = [
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("da", 1),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("u", -6),
    ("n", -9),
];

/// Reads a unit symbol with or without an SI prefix.
pub(super) fn symbol(word: &str) -> Option<Unit> {
    let unit = |symbol: &Symbol, ten| Unit {
        factor: Factor { ten: symbol.ten + ten, powers: symbol.powers },
        dimension: symbol.dimension,
    };
    if let Some(symbol) = SYMBOLS.iter().find(|symbol| symbol.names.contains(&word)) {
        return Some(unit(symbol, 0));
    }
    PREFIXES.iter().find_map(|(prefix, ten)| {
        let name = word.strip_prefix(prefix)?;
        let symbol = SYMBOLS.iter().find(|s| s.takes_prefix && s.names.contains(&name))?;
        Some(unit(symbol, *ten))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::number::Decimal;
    use crate::read::unit::Exact;
    use crate::{Scalar, Wide};

    fn one(unit: &str) -> f64 {
        let unit = Unit::read(unit).unwrap_or_else(|| panic!("{unit}"));
        let number = Decimal::whole("1").unwrap();
        Exact::new(number, unit.factor).value::<Wide>().unwrap().middle()
    }

    /// Compares the conversion factors of units with NIST Special Publication 811 (2008), appendix B.8, to seven
    /// digits.
    #[test]
    fn factors_are_as_published() {
        let published = [
            ("in", 2.54e-2),
            ("ft", 3.048e-1),
            ("mil", 2.54e-5),
            ("bar", 1e5),
            ("kp", 9.806_65),
            ("#", 4.448_222),
            ("k", 4.448_222e3),
            ("pli", 1.751_268e2),
            ("kli", 1.751_268e5),
            ("Msi", 6.894_757e9),
            ("tsf", 9.576_052e4),
            ("tcf", 3.141_749e5),
            ("lb/sq in", 6.894_757e3),
            ("kips/cu ft", 1.570_875e5),
            ("sqft", 9.290_304e-2),
            ("yd", 9.144e-1),
            ("lbf", 4.448_222),
            ("kip", 4.448_222e3),
            ("kgf", 9.806_65),
            ("tf", 9.806_65e3),
            ("plf", 1.459_390e1),
            ("klf", 1.459_390e4),
            ("psi", 6.894_757e3),
            ("ksi", 6.894_757e6),
            ("psf", 4.788_026e1),
            ("ksf", 4.788_026e4),
            ("pci", 2.714_471e5),
            ("kci", 2.714_471e8),
            ("pcf", 1.570_875e2),
            ("kcf", 1.570_875e5),
            ("deg", 1.745_329e-2),
            ("°F", 5.555_556e-1),
            ("kN", 1e3),
            ("mm", 1e-3),
            ("µm", 1e-6),
            ("daN", 1e1),
            ("GPa", 1e9),
        ];
        for (unit, factor) in published {
            assert!((one(unit) / factor - 1.0).abs() <= 5e-7, "{unit}: {:e}", one(unit));
        }
        assert_eq!(one("deg"), std::f64::consts::PI / 180.0);
        assert_eq!(one("lbf/lbf"), 1.0);
        assert_eq!(one("in^3/in^2"), 0.0254);
    }
}
