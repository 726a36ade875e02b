//! Table of unit symbols with their factors and dimensions.
//!
//! All factors except that of the degree are exact. Source: NIST Special Publication 811 (2008), appendix B.

use super::{Dimension, Marks, Scale};

/// One unit symbol.
#[derive(Debug, Clone, Copy)]
pub(super) struct Symbol {
    /// Names of the unit: the name that hints use, followed by alternative names.
    pub names: &'static [&'static str],
    pub dimension: Dimension,
    /// Conversion factor to N, m and rad: numerator, denominator and power of ten.
    factor: (u64, u64, i32),
    takes_prefix: bool,
    marks: Marks,
}

const FORCE: Dimension = Dimension::FORCE;
const LENGTH: Dimension = Dimension::LENGTH;
const STRESS: Dimension = Dimension::new(1, -2);
const SPECIFIC_WEIGHT: Dimension = Dimension::new(1, -3);
const LINE_LOAD: Dimension = Dimension::new(1, -1);

const fn metric(
    names: &'static [&'static str],
    dimension: Dimension,
    ten: i32,
    marks: Marks,
) -> Symbol {
    Symbol { names, dimension, factor: (1, 1, ten), takes_prefix: true, marks }
}

const fn other(
    names: &'static [&'static str],
    dimension: Dimension,
    factor: (u64, u64, i32),
    marks: Marks,
) -> Symbol {
    Symbol { names, dimension, factor, takes_prefix: false, marks }
}

/// The pound-force in units of 10⁻¹³ N: 0.453 592 37 kg × 9.806 65 m/s² = 4.448 221 615 260 5 N.
const POUND: u64 = 44_482_216_152_605;
const INCH: u64 = 254;
const FOOT: u64 = 3048;

const IN: Marks = Marks::INCH;
const FT: Marks = Marks::FOOT;
const LBF: Marks = Marks::POUND;
const KIP: Marks = Marks::KIP;
const TECHNICAL: Marks = Marks::TECHNICAL;

pub(super) const SYMBOLS: &[Symbol] = &[
    metric(&["m"], LENGTH, 0, Marks::METRE),
    metric(&["N"], FORCE, 0, Marks::NEWTON),
    metric(&["Pa"], STRESS, 0, Marks::NEWTON),
    metric(&["bar"], STRESS, 5, Marks::NEWTON),
    metric(&["rad"], Dimension::ANGLE, 0, Marks::NONE),
    // The next units are units of temperature differences.
    other(&["K", "°C", "degC"], Dimension::TEMPERATURE, (1, 1, 0), Marks::NONE),
    other(&["°F", "degF"], Dimension::TEMPERATURE, (5, 9, 0), Marks::NONE),
    // The factor of the degree is π/180, rounded to 19 figures.
    other(&["deg", "°"], Dimension::ANGLE, (1_745_329_251_994_329_577, 1, -20), Marks::NONE),
    // The US units of length are 1 in = 0.0254 m, 1 ft = 12 in, 1 yd = 3 ft and 1 mil = 0.001 in.
    other(INCHES, LENGTH, (INCH, 1, -4), IN),
    other(FEET, LENGTH, (FOOT, 1, -4), FT),
    other(&["yd"], LENGTH, (9144, 1, -4), FT),
    other(&["mil"], LENGTH, (INCH, 1, -7), IN),
    // The units of force are 1 kip = 1000 lbf, 1 kgf = 9.806 65 N and 1 tf = 1000 kgf. `lb` is a force, because
    // no quantity of a model is a mass.
    other(&["lbf", "lb", "lbs", "pound", "pounds", "#"], FORCE, (POUND, 1, -13), LBF),
    other(&["kip", "kips", "Kip", "Kips", "KIP", "KIPS", "k"], FORCE, (POUND, 1, -10), KIP),
    other(&["kgf", "kp"], FORCE, (980_665, 1, -5), TECHNICAL),
    other(&["tf"], FORCE, (980_665, 1, -2), TECHNICAL),
    // The next units are pounds or kips per foot and per inch of length.
    other(&["plf"], LINE_LOAD, (POUND, FOOT, -9), LBF.with(FT)),
    other(&["klf"], LINE_LOAD, (POUND, FOOT, -6), KIP.with(FT)),
    other(&["pli"], LINE_LOAD, (POUND, INCH, -9), LBF.with(IN)),
    other(&["kli"], LINE_LOAD, (POUND, INCH, -6), KIP.with(IN)),
    // The next units are pounds, kips or millions of pounds per square inch, and pounds, kips or tons of 2000
    // pounds per square foot.
    other(&["psi"], STRESS, (POUND, INCH * INCH, -5), LBF.with(IN)),
    other(&["ksi"], STRESS, (POUND, INCH * INCH, -2), KIP.with(IN)),
    other(&["Msi"], STRESS, (POUND, INCH * INCH, 1), KIP.with(IN)),
    other(&["psf"], STRESS, (POUND, FOOT * FOOT, -5), LBF.with(FT)),
    other(&["ksf"], STRESS, (POUND, FOOT * FOOT, -2), KIP.with(FT)),
    other(&["tsf"], STRESS, (2 * POUND, FOOT * FOOT, -2), KIP.with(FT)),
    // The next units are pounds, kips or tons of 2000 pounds per cubic inch or per cubic foot.
    other(&["pci"], SPECIFIC_WEIGHT, (POUND, INCH * INCH * INCH, -1), LBF.with(IN)),
    other(&["kci"], SPECIFIC_WEIGHT, (POUND, INCH * INCH * INCH, 2), KIP.with(IN)),
    other(&["pcf"], SPECIFIC_WEIGHT, (POUND, FOOT * FOOT * FOOT, -1), LBF.with(FT)),
    other(&["kcf"], SPECIFIC_WEIGHT, (POUND, FOOT * FOOT * FOOT, 2), KIP.with(FT)),
    other(&["tcf"], SPECIFIC_WEIGHT, (2 * POUND, FOOT * FOOT * FOOT, 2), KIP.with(FT)),
];

/// Names of the inch, including the signs that word processors substitute.
pub(super) const INCHES: &[&str] = &["in", "inch", "inches", "\"", "″", "”"];
pub(super) const FEET: &[&str] = &["ft", "foot", "feet", "'", "′", "’"];

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

/// Symbols that hints may suggest, the most common symbol first.
pub(super) const COMMON: &[&str] = &[
    "m", "mm", "cm", "km", "kN", "N", "MN", "GN", "MPa", "kPa", "GPa", "Pa", "bar", "rad", "mrad",
    "deg", "in", "ft", "yd", "mil", "lbf", "kip", "kgf", "tf", "daN", "psi", "ksi", "psf", "ksf",
    "tsf", "pci", "pcf", "kcf", "plf", "klf", "pli", "K", "°C", "°F",
];

/// Full names of units, each with the symbol of the unit.
const NAMES: &[(&str, &str)] = &[
    ("metre", "m"),
    ("metres", "m"),
    ("meter", "m"),
    ("meters", "m"),
    ("yard", "yd"),
    ("yards", "yd"),
    ("thou", "mil"),
    ("newton", "N"),
    ("newtons", "N"),
    ("kilonewton", "kN"),
    ("pascal", "Pa"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("degree", "deg"),
    ("degrees", "deg"),
];

const TONS: &str = "a ton is 2000 lbf = 8.896 kN (short), 2240 lbf = 9.964 kN (long) or 1000 kgf = 9.807 kN (metric): \
     write kip, kN or tf";
const TONNE: &str =
    "this is a mass; write `tf` for the weight of a tonne (9.80665 kN), or kip or kN";

/// Hints for symbols that are ambiguous, denote a mass, or are not supported.
const ADVICE: &[(&[&str], &str)] = &[
    (&["kg"], "this is a mass; write `kgf` for its weight (9.80665 N), or give the force in kN"),
    (&["t", "te", "Te", "tonne", "tonnes", "tm"], TONNE),
    (&["ton", "tons", "T", "Ton", "Tons"], TONS),
    (&["tlf"], "1 ton/ft = 2 kip/ft: convert the number and write klf"),
    (&["Mp"], "a megapond is 1000 kgf: write `tf`"),
    (&["lbm"], "a model has no masses; for a weight write `lbf`"),
    (&["mi", "mile", "miles"], "1 mile = 5280 ft = 1609.344 m: write ft or km"),
    (&["chain", "chains"], "1 chain = 66 ft = 20.1168 m: write ft or m"),
    (&["sf", "SF"], "write `sq ft` or `ft^2`"),
    (&["at"], "a technical atmosphere is 1 kgf/cm^2 = 98.0665 kPa"),
    (&["atm"], "an atmosphere is 101.325 kPa"),
    (&["F"], "write a temperature difference in `°F` or `degF`"),
    (&["C"], "write a temperature difference in `°C`, `degC` or `K`"),
    (&["MM"], "write millimetres as `mm`"),
];

/// Returns the factor, the dimension and the flags of a symbol with or without an SI prefix.
pub(super) fn look_up(word: &str) -> Option<(Scale, Dimension, Marks)> {
    if let Some(symbol) = SYMBOLS.iter().find(|symbol| symbol.names.contains(&word)) {
        let (numerator, denominator, ten) = symbol.factor;
        return Some((Scale::new(numerator, denominator, ten), symbol.dimension, symbol.marks));
    }
    PREFIXES.iter().find_map(|&(prefix, ten)| {
        let rest = word.strip_prefix(prefix)?;
        let symbol = SYMBOLS.iter().find(|s| s.takes_prefix && s.names.contains(&rest))?;
        Some((Scale::new(1, 1, ten + symbol.factor.2), symbol.dimension, symbol.marks))
    })
}

/// Returns the symbol of the unit that has the full name `word`.
pub(super) fn symbol_for_name(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    NAMES.iter().find(|(name, _)| *name == lower).map(|&(_, symbol)| symbol)
}

/// Returns the hint for a symbol that is not supported.
pub(super) fn advice(word: &str) -> Option<&'static str> {
    ADVICE.iter().find(|(words, _)| words.contains(&word)).map(|&(_, advice)| advice)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Decimal;

    /// Returns the factor that converts the unit with the symbol `word` to N, m and rad.
    fn one(word: &str) -> f64 {
        let (scale, ..) = look_up(word).unwrap_or_else(|| panic!("{word} is not known"));
        Decimal::read("1").unwrap().0.times(&scale)
    }

    /// Compares the factors with NIST Special Publication 811 (2008), appendix B.8, and rounded factors also with exact
    /// quotients.
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
            ("kp", 9.80665),
            ("tf", 9806.65),
            ("bar", 1e5), // B.8: bar, exact
            ("mbar", 100.0),
            ("mil", 2.54e-5), // B.8: mil, exact
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
            ("pli", pound / 0.0254, 1.751_268e2), // B.8: pound-force per inch
            ("kli", 1e3 * pound / 0.0254, 1.751_268e5),
            ("Msi", 1e6 * pound / 0.0254_f64.powi(2), 6.894_757e9),
            ("tsf", 2e3 * pound / 0.3048_f64.powi(2), 9.576_052e4),
            ("tcf", 2e3 * pound / 0.3048_f64.powi(3), 3.141_749e5),
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
            assert!(
                (factor / printed - 1.0).abs() <= 5e-7,
                "{word}: {factor:e} differs from the factor printed in NIST SP 811"
            );
        }
        let tested: Vec<&str> =
            exact.iter().map(|e| e.0).chain(quotients.iter().map(|q| q.0)).collect();
        for symbol in SYMBOLS {
            assert!(tested.contains(&symbol.names[0]), "{} has no test", symbol.names[0]);
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
        for unknown in ["kin", "Mft", "kdeg", "kkN", "", "mlbf", "kkip"] {
            assert!(look_up(unknown).is_none(), "{unknown}");
        }
    }

    #[test]
    fn other_names_have_the_same_factor() {
        let same = [
            ("lbf", &["lb", "lbs", "pound", "pounds", "#"][..]),
            ("kip", &["kips", "Kip", "KIP", "KIPS", "k"]),
            ("in", &["inch", "inches", "\"", "″", "”"]),
            ("ft", &["foot", "feet", "'", "′", "’"]),
            ("K", &["°C", "degC"]),
        ];
        for (name, others) in same {
            for other in others {
                assert_eq!(one(other), one(name), "{other}");
            }
        }
    }

    #[test]
    fn every_suggested_symbol_is_known() {
        for word in COMMON.iter().chain(NAMES.iter().map(|(_, symbol)| symbol)) {
            assert!(look_up(word).is_some(), "{word}");
        }
        let advised = ADVICE.iter().flat_map(|(words, _)| words.iter());
        for name in NAMES.iter().map(|(name, _)| name).chain(advised) {
            assert!(look_up(name).is_none(), "{name} is a symbol itself");
        }
    }
}
