//! Chooses the US units of printed quantities: kips or pounds, and feet or inches as in the file.

use super::kind::Kind;

const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
/// One pound-force \[N\]: 0.453 592 37 kg × 9.806 65 m/s².
const POUND: f64 = 4.448_221_615_260_5;

/// Choice among US units: feet or inches, and kips or pounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct UsUnits {
    /// Kinds of quantity whose printed unit contains inches, as a bit set with one bit for each kind.
    inches: u16,
    /// Whether forces of every size are printed in pounds.
    pounds: bool,
}

/// Names of the units force × lengthⁿ. The rows are for n from −3 to 2. The columns are for pounds and
/// inches, kips and inches, pounds and feet, and kips and feet.
const NAMES: [[&str; 4]; 6] = [
    ["pci", "kci", "pcf", "kcf"],
    ["psi", "ksi", "psf", "ksf"],
    ["lbf/in", "kip/in", "lbf/ft", "kip/ft"],
    ["lbf", "kip", "lbf", "kip"],
    ["lbf-in", "kip-in", "lbf-ft", "kip-ft"],
    ["lbf-in²", "kip-in²", "lbf-ft²", "kip-ft²"],
];

impl UsUnits {
    /// Usual US units: feet for lengths, inches for deflections, pci for the subgrade modulus, and kips for
    /// forces.
    pub const USUAL: UsUnits =
        UsUnits { inches: bit(Kind::Deflection) | bit(Kind::AreaSpring), pounds: false };

    /// Chooses inches for the given kinds of quantity and for deflections. If `pounds` is true, forces of
    /// every size are printed in pounds.
    pub fn new(inches: impl IntoIterator<Item = Kind>, pounds: bool) -> Self {
        let bits = inches.into_iter().fold(bit(Kind::Deflection), |bits, kind| bits | bit(kind));
        UsUnits { inches: bits, pounds }
    }

    /// Whether a kind of quantity is printed with inches.
    pub fn has_inches(self, kind: Kind) -> bool {
        self.inches & bit(kind) != 0
    }

    /// Returns the name and the size of the unit for a quantity of the magnitude `value`.
    pub(super) fn unit(self, kind: Kind, value: f64) -> (&'static str, f64) {
        let inches = self.has_inches(kind);
        let length = if inches { INCH } else { FOOT };
        let Some(power) = kind.power_of_length() else {
            return match kind {
                Kind::Slope if value == 0.0 || (1e-7..0.1).contains(&value) => ("mrad", 1e-3),
                Kind::Slope => ("rad", 1.0),
                Kind::PerLength if inches => ("1/in", 1.0 / INCH),
                Kind::PerLength => ("1/ft", 1.0 / FOOT),
                _ if inches => ("in", INCH),
                _ => ("ft", FOOT),
            };
        };
        let kip = 1e3 * POUND * length.powi(power);
        // Stresses and moduli per square or cubic inch are usually in pounds: 4000 psi, 200 pci.
        let from = if inches && power <= -2 { 10.0 * kip } else { 0.1 * kip };
        let in_kips = if value == 0.0 { from <= kip } else { value >= from };
        let in_kips = in_kips && !(self.pounds && power >= -1);
        let name = NAMES[(power + 3) as usize][2 * usize::from(!inches) + usize::from(in_kips)];
        (name, if in_kips { kip } else { POUND * length.powi(power) })
    }
}

const fn bit(kind: Kind) -> u16 {
    1 << kind as u16
}

/// All US units that may be printed.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    NAMES.iter().flatten().copied().chain(["in", "ft", "1/in", "1/ft"])
}
