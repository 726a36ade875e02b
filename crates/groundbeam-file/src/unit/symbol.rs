//! The table of unit symbols.
//!
//! Factors are exact by definition: the inch, the pound and the standard acceleration of free
//! fall as in NIST Special Publication 811 (2008), appendix B; only the degree is rounded.

use super::{Dimension, Scale};

/// What one symbol stands for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Symbol {
    pub name: &'static str,
    pub dimension: Dimension,
    /// In N, m and rad: numerator, denominator, power of ten.
    factor: (u64, u64, i32),
    takes_prefix: bool,
}

const STRESS: Dimension = Dimension::new(1, -2);
const SPECIFIC_WEIGHT: Dimension = Dimension::new(1, -3);
const LINE_LOAD: Dimension = Dimension::new(1, -1);

const fn metric(name: &'static str, dimension: Dimension) -> Symbol {
    Symbol { name, dimension, factor: (1, 1, 0), takes_prefix: true }
}

const fn other(name: &'static str, dimension: Dimension, factor: (u64, u64, i32)) -> Symbol {
    Symbol { name, dimension, factor, takes_prefix: false }
}

/// One pound-force, 0.453 592 37 kg × 9.806 65 m/s² = 4.448 221 615 260 5 N, in 10⁻¹³ N.
const POUND: u64 = 44_482_216_152_605;
const INCH: u64 = 254;
const FOOT: u64 = 3048;

pub(super) const SYMBOLS: &[Symbol] = &[
    metric("m", Dimension::LENGTH),
    metric("N", Dimension::FORCE),
    metric("Pa", STRESS),
    metric("rad", Dimension::ANGLE),
    // Differences of temperature.
    other("K", Dimension::TEMPERATURE, (1, 1, 0)),
    other("°C", Dimension::TEMPERATURE, (1, 1, 0)),
    other("degC", Dimension::TEMPERATURE, (1, 1, 0)),
    other("°F", Dimension::TEMPERATURE, (5, 9, 0)),
    other("degF", Dimension::TEMPERATURE, (5, 9, 0)),
    // π/180 to 19 figures.
    other("deg", Dimension::ANGLE, (1_745_329_251_994_329_577, 1, -20)),
    other("°", Dimension::ANGLE, (1_745_329_251_994_329_577, 1, -20)),
    // 1 in = 0.0254 m, 1 ft = 12 in, 1 yd = 3 ft.
    other("in", Dimension::LENGTH, (INCH, 1, -4)),
    other("ft", Dimension::LENGTH, (FOOT, 1, -4)),
    other("yd", Dimension::LENGTH, (9144, 1, -4)),
    // 1 kip = 1000 lbf; 1 kgf = 9.806 65 N, 1 tf = 1000 kgf.
    other("lbf", Dimension::FORCE, (POUND, 1, -13)),
    other("kip", Dimension::FORCE, (POUND, 1, -10)),
    other("kgf", Dimension::FORCE, (980_665, 1, -5)),
    other("tf", Dimension::FORCE, (980_665, 1, -2)),
    // Pounds or kips per linear foot.
    other("plf", LINE_LOAD, (POUND, FOOT, -9)),
    other("klf", LINE_LOAD, (POUND, FOOT, -6)),
    // Pounds or kips per square inch or square foot.
    other("psi", STRESS, (POUND, INCH * INCH, -5)),
    other("ksi", STRESS, (POUND, INCH * INCH, -2)),
    other("psf", STRESS, (POUND, FOOT * FOOT, -5)),
    other("ksf", STRESS, (POUND, FOOT * FOOT, -2)),
    // Pounds or kips per cubic inch or cubic foot.
    other("pci", SPECIFIC_WEIGHT, (POUND, INCH * INCH * INCH, -1)),
    other("kci", SPECIFIC_WEIGHT, (POUND, INCH * INCH * INCH, 2)),
    other("pcf", SPECIFIC_WEIGHT, (POUND, FOOT * FOOT * FOOT, -1)),
    other("kcf", SPECIFIC_WEIGHT, (POUND, FOOT * FOOT * FOOT, 2)),
];

/// SI prefixes and their powers of ten. Micro is written µ (U+00B5), μ (U+03BC) or u.
const PREFIXES: &[(&str, i32)] = &[
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

/// Symbols worth suggesting, the commonest first.
pub(super) const COMMON: &[&str] = &[
    "m", "mm", "cm", "km", "kN", "N", "MN", "GN", "MPa", "kPa", "GPa", "Pa", "rad", "mrad", "deg",
    "in", "ft", "yd", "lbf", "kip", "kgf", "tf", "daN", "psi", "ksi", "psf", "ksf", "pci", "pcf",
    "kcf", "plf", "klf", "K", "°C", "°F",
];

/// Names and other symbols people write, with the symbol that is understood.
const NAMES: &[(&str, &str)] = &[
    ("metre", "m"),
    ("metres", "m"),
    ("meter", "m"),
    ("meters", "m"),
    ("inch", "in"),
    ("inches", "in"),
    ("\"", "in"),
    ("″", "in"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("'", "ft"),
    ("′", "ft"),
    ("yard", "yd"),
    ("yards", "yd"),
    ("newton", "N"),
    ("newtons", "N"),
    ("kilonewton", "kN"),
    ("pascal", "Pa"),
    ("bar", "kPa"),
    ("lb", "lbf"),
    ("lbs", "lbf"),
    ("pound", "lbf"),
    ("pounds", "lbf"),
    ("kips", "kip"),
    ("k", "kip"),
    ("kg", "kgf"),
    ("t", "tf"),
    ("ton", "tf"),
    ("tons", "tf"),
    ("tonne", "tf"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("degree", "deg"),
    ("degrees", "deg"),
];

/// The factor and dimension of a symbol with or without a prefix.
pub(super) fn look_up(word: &str) -> Option<(Scale, Dimension)> {
    if let Some(symbol) = SYMBOLS.iter().find(|symbol| symbol.name == word) {
        let (numerator, denominator, ten) = symbol.factor;
        return Some((Scale::new(numerator, denominator, ten), symbol.dimension));
    }
    PREFIXES.iter().find_map(|&(prefix, ten)| {
        let rest = word.strip_prefix(prefix)?;
        let symbol = SYMBOLS.iter().find(|s| s.takes_prefix && s.name == rest)?;
        Some((Scale::new(1, 1, ten), symbol.dimension))
    })
}

/// The symbol that someone who wrote the name or foreign symbol `word` wants.
pub(super) fn symbol_for_name(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    NAMES.iter().find(|(name, _)| *name == lower).map(|&(_, symbol)| symbol)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Decimal;

    /// The value of "1 symbol" in N, m, rad.
    fn one(word: &str) -> f64 {
        let (scale, _) = look_up(word).unwrap_or_else(|| panic!("{word} is not known"));
        Decimal::read("1").unwrap().0.times(&scale)
    }

    /// NIST Special Publication 811 (2008), appendix B.8, prints these to seven figures, in bold
    /// where exact; here they stand as the exact quotients of their definitions.
    #[test]
    fn every_symbol_has_its_published_factor() {
        let pound = 4.448_221_615_260_5; // B.8: pound-force, 4.448 222 E+00
        let exact = [
            ("m", 1.0),
            ("N", 1.0),
            ("Pa", 1.0),
            ("rad", 1.0),
            ("K", 1.0),
            ("°C", 1.0), // B.8: degree Celsius, differences
            ("degC", 1.0),
            ("in", 0.0254), // B.8: inch, 2.54 E-02, exact
            ("ft", 0.3048), // B.8: foot, 3.048 E-01, exact
            ("yd", 0.9144), // B.8: yard, 9.144 E-01, exact
            ("lbf", pound),
            ("kip", 4_448.221_615_260_5), // B.8: kip, 4.448 222 E+03
            ("kgf", 9.80665),             // B.8: kilogram-force, 9.806 65 E+00, exact
            ("tf", 9806.65),
        ];
        for (word, factor) in exact {
            assert_eq!(one(word), factor, "{word}");
        }
        let quotients = [
            ("deg", std::f64::consts::PI / 180.0, 1.745_329e-2), // B.8: degree (angle)
            ("°", std::f64::consts::PI / 180.0, 1.745_329e-2),
            ("°F", 5.0 / 9.0, 5.555_556e-1), // B.8: degree Fahrenheit (interval)
            ("degF", 5.0 / 9.0, 5.555_556e-1),
            ("plf", pound / 0.3048, 1.459_390e1), // B.8: pound-force per foot
            ("klf", 1e3 * pound / 0.3048, 1.459_390e4),
            ("psi", pound / 0.0254_f64.powi(2), 6.894_757e3), // B.8: psi
            ("ksi", 1e3 * pound / 0.0254_f64.powi(2), 6.894_757e6), // B.8: ksi
            ("psf", pound / 0.3048_f64.powi(2), 4.788_026e1), // B.8: lbf/ft²
            ("ksf", 1e3 * pound / 0.3048_f64.powi(2), 4.788_026e4),
            ("pci", pound / 0.0254_f64.powi(3), 2.714_471e5),
            ("kci", 1e3 * pound / 0.0254_f64.powi(3), 2.714_471e8),
            ("pcf", pound / 0.3048_f64.powi(3), 1.570_875e2),
            ("kcf", 1e3 * pound / 0.3048_f64.powi(3), 1.570_875e5),
        ];
        for (word, quotient, printed) in quotients {
            let factor = one(word);
            assert!((factor / quotient - 1.0).abs() <= 4.0 * f64::EPSILON, "{word}: {factor:e}");
            assert!((factor / printed - 1.0).abs() <= 5e-7, "{word}: {factor:e} is not as printed");
        }
        let tested: Vec<&str> =
            exact.iter().map(|e| e.0).chain(quotients.iter().map(|q| q.0)).collect();
        for symbol in SYMBOLS {
            assert!(tested.contains(&symbol.name), "{} has no test", symbol.name);
        }
    }

    #[test]
    fn prefixes_move_the_decimal_point() {
        let expected = [
            ("km", 1e3),
            ("mm", 1e-3),
            ("cm", 1e-2),
            ("µm", 1e-6),
            ("μm", 1e-6),
            ("um", 1e-6),
            ("kN", 1e3),
            ("daN", 1e1),
            ("MN", 1e6),
            ("GN", 1e9),
            ("hPa", 1e2),
            ("GPa", 1e9),
            ("mrad", 1e-3),
        ];
        for (word, factor) in expected {
            assert_eq!(one(word), factor, "{word}");
        }
        for unknown in ["kin", "Mft", "kdeg", "kkN", "k", "", "mlbf"] {
            assert!(look_up(unknown).is_none(), "{unknown}");
        }
    }

    #[test]
    fn every_suggested_symbol_is_known() {
        for word in COMMON.iter().chain(NAMES.iter().map(|(_, symbol)| symbol)) {
            assert!(look_up(word).is_some(), "{word}");
        }
        for (name, _) in NAMES {
            assert!(look_up(name).is_none(), "{name} is a symbol itself");
        }
    }
}
