//! Units: symbols, their products and powers, their exact factors to N, m, rad and K, and their dimensions.
//!
//! A factor is a product of powers of ten and of a few definitions (inch, pound, standard gravity, …). Powers
//! are integers, so equal powers cancel exactly. A number times a power of ten remains a decimal number.

use super::number::Decimal;
use crate::Scalar;

/// Powers of force, length, angle and temperature difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Dimension {
    pub force: i32,
    pub length: i32,
    pub angle: i32,
    pub temperature: i32,
}

impl Dimension {
    pub const NONE: Dimension = Dimension::of(0, 0);

    /// force^`force` × length^`length`
    pub const fn of(force: i32, length: i32) -> Self {
        Dimension { force, length, angle: 0, temperature: 0 }
    }

    /// This dimension times a power of an angle.
    pub const fn with_angle(self, angle: i32) -> Self {
        Dimension { angle, ..self }
    }

    /// This dimension times a power of a temperature difference.
    pub const fn with_temperature(self, temperature: i32) -> Self {
        Dimension { temperature, ..self }
    }

    fn times(self, other: Dimension, power: i32) -> Option<Self> {
        let add = |a: i32, b: i32| a.checked_add(b.checked_mul(power)?);
        Some(Dimension {
            force: add(self.force, other.force)?,
            length: add(self.length, other.length)?,
            angle: add(self.angle, other.angle)?,
            temperature: add(self.temperature, other.temperature)?,
        })
    }

    /// Whether a quantity of this dimension may have a unit of another dimension. A radian has the value 1,
    /// so the unit of a quantity per angle may omit it.
    pub fn accepts(self, unit: Dimension) -> bool {
        unit == self || unit == self.with_angle(0)
    }
}

/// The bases of factors besides ten. 1 in = 0.0254 m, 1 lbf = 4.4482216152605 N and 1 kgf = 9.80665 N are definitions.
const BASES: [&str; 7] = ["0.0254", "12", "3", "4.4482216152605", "9.80665", "1.8", "2"];
/// Powers of the bases, and of π/180 after them.
type Powers = [i32; 8];
const INCH: Powers = [1, 0, 0, 0, 0, 0, 0, 0];
const FOOT: Powers = [1, 1, 0, 0, 0, 0, 0, 0];
const YARD: Powers = [1, 1, 1, 0, 0, 0, 0, 0];
const POUND: Powers = [0, 0, 0, 1, 0, 0, 0, 0];
const GRAVITY: Powers = [0, 0, 0, 0, 1, 0, 0, 0];
/// 5/9.
const FAHRENHEIT: Powers = [0, 0, 0, 0, 0, -1, 0, 0];
/// π/180, after the decimal bases.
const DEGREE: Powers = [0, 0, 0, 0, 0, 0, 0, 1];
const ONE: Powers = [0; 8];
/// Maximum power of a base.
const HIGHEST: i32 = 50;

/// A factor: 10^ten times powers of the bases and of π/180.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Factor {
    ten: i32,
    powers: Powers,
}

impl Factor {
    pub const ONE: Factor = Factor { ten: 0, powers: ONE };
    pub const INCH: Factor = Factor { ten: 0, powers: INCH };

    fn times(self, other: Factor, power: i32) -> Option<Self> {
        let mut product = self;
        product.ten = self.ten.checked_add(other.ten.checked_mul(power)?)?;
        for (mine, its) in product.powers.iter_mut().zip(other.powers) {
            *mine = mine.checked_add(its.checked_mul(power)?)?;
        }
        Some(product).filter(|p| p.powers.iter().all(|power| power.abs() <= HIGHEST))
    }
}

/// A number with its unit and with the digits of the file. Equal quantities compare as equal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Exact {
    number: Decimal,
    /// Powers of the bases in the unit. The power of ten is part of the number.
    powers: Powers,
}

impl Exact {
    pub fn new(number: Decimal, factor: Factor) -> Self {
        let powers = if number.is_zero() { ONE } else { factor.powers };
        Exact { number: number.shifted(factor.ten), powers }
    }

    pub fn is_zero(&self) -> bool {
        self.number.is_zero()
    }

    /// The value; `None` if the number is outside the range of the scalar.
    pub fn value<S: Scalar>(&self) -> Option<S> {
        let number = S::decimal(&self.number.text())?;
        let (mut above, mut below) = (None, None);
        for (i, power) in self.powers.iter().enumerate() {
            let base = match BASES.get(i) {
                Some(base) => S::decimal(base)?,
                None => pi::<S>()?.div(S::of(180.0)),
            };
            let product = if *power > 0 { &mut above } else { &mut below };
            for _ in 0..power.abs() {
                *product = Some(product.map_or(base, |product: S| product * base));
            }
        }
        let number = above.map_or(number, |above| number * above);
        Some(below.map_or(number, |below| number.div(below)))
    }
}

/// π.
pub(crate) fn pi<S: Scalar>() -> Option<S> {
    S::decimal("3.14159265358979323846264338327950288419716939937510582097494459")
}

/// A symbol: its dimension and factor, and whether it may have an SI prefix.
struct Symbol {
    names: &'static [&'static str],
    dimension: Dimension,
    ten: i32,
    powers: Powers,
    takes_prefix: bool,
}

const LENGTH: Dimension = Dimension::of(0, 1);
const FORCE: Dimension = Dimension::of(1, 0);
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

/// A pound per power of a length.
const fn per(length: Powers, power: i32) -> Powers {
    [-power * length[0], -power * length[1], 0, 1, 0, 0, 0, 0]
}

/// Twice a force of 1000 pounds: a ton of 2000 pounds.
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

/// A unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Unit {
    pub factor: Factor,
    pub dimension: Dimension,
}

impl Unit {
    const ONE: Unit = Unit { factor: Factor::ONE, dimension: Dimension::NONE };

    fn times(self, other: Unit, power: i32) -> Option<Unit> {
        let factor = self.factor.times(other.factor, power)?;
        Some(Unit { factor, dimension: self.dimension.times(other.dimension, power)? })
    }

    /// Reads a unit as engineers write it: `kN/m^2`, `kN m`, `kNm`, `kip-ft`, `kN/(m rad)`, `1/m`.
    pub fn read(text: &str) -> Option<Unit> {
        let mut reader = Reader { rest: text.trim() };
        let unit = reader.product(0)?;
        reader.rest.is_empty().then_some(unit)
    }
}

/// A symbol with or without a prefix.
fn symbol(word: &str) -> Option<Unit> {
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

/// Maximum depth of nested parentheses.
const DEEPEST: usize = 8;
/// The highest power of a symbol.
const HIGHEST_POWER: i32 = 12;
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

struct Reader<'t> {
    rest: &'t str,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn take(&mut self, wanted: &str) -> bool {
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Factors with spaces, signs or `/` between them. After a `/` only divisors may follow.
    fn product(&mut self, depth: usize) -> Option<Unit> {
        let mut unit = self.first(depth)?;
        let mut divided = false;
        loop {
            self.rest = self.rest.trim_start();
            match self.peek() {
                None | Some(')') => return Some(unit),
                Some('/') => {
                    self.take("/");
                    unit = unit.times(self.factor(depth)?, -1)?;
                    divided = true;
                }
                Some(_) if divided => return None,
                Some(next) => {
                    if "*·⋅×.-".contains(next) {
                        self.rest = self.rest.get(next.len_utf8()..)?;
                    }
                    unit = unit.times(self.factor(depth)?, 1)?;
                }
            }
        }
    }

    /// The first factor of a unit, which may be the 1 of `1/m`.
    fn first(&mut self, depth: usize) -> Option<Unit> {
        let after = self.rest.strip_prefix('1').map(str::trim_start);
        match after {
            Some(after) if depth == 0 && after.starts_with('/') => {
                self.rest = after;
                Some(Unit::ONE)
            }
            _ => self.factor(depth),
        }
    }

    /// A symbol, two symbols in one word, or a product in parentheses, with its power.
    fn factor(&mut self, depth: usize) -> Option<Unit> {
        self.rest = self.rest.trim_start();
        if self.take("(") {
            if depth == DEEPEST {
                return None;
            }
            let unit = self.product(depth + 1)?;
            if !self.take(")") {
                return None;
            }
            return Unit::ONE.times(unit, self.power()?);
        }
        let end = self.rest.find(|c| !is_letter(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at_checked(end)?;
        self.rest = rest;
        if let Some(power) = power_in_words(word) {
            // `sq ft`, `cu in`
            self.rest = self.rest.trim_start();
            let end = self.rest.find(|c| !is_letter(c)).unwrap_or(self.rest.len());
            let (word, rest) = self.rest.split_at_checked(end)?;
            self.rest = rest;
            return Unit::ONE.times(symbol(word)?, power);
        }
        let power = self.power()?;
        if let Some(unit) = symbol(word) {
            return Unit::ONE.times(unit, power);
        }
        // `sqft`
        let in_words = word.split_at_checked(2).and_then(|(words, length)| {
            let length = symbol(length).filter(|length| length.dimension == LENGTH)?;
            Unit::ONE.times(length, power_in_words(words)?)
        });
        if let Some(unit) = in_words {
            return Unit::ONE.times(unit, power);
        }
        // `kNm` is a force and a length; a power applies to the length. `k` is a symbol only if it stands
        // alone.
        word.char_indices().skip(1).find_map(|(i, _)| {
            let (force, length) = word.split_at_checked(i).filter(|(force, _)| *force != "k")?;
            let (force, length) = (symbol(force)?, symbol(length)?);
            let is_moment = force.dimension == FORCE && length.dimension == LENGTH;
            if is_moment { force.times(length, power) } else { None }
        })
    }

    /// The power after a factor; 1 if none is given.
    fn power(&mut self) -> Option<i32> {
        let after = self.rest.trim_start();
        let marked = after.strip_prefix('^').or(after.strip_prefix("**"));
        let mut rest = marked.map_or(self.rest, str::trim_start);
        let is_raised = rest.starts_with(|c| c == '⁻' || RAISED.contains(&c));
        let negative = rest.starts_with(['-', '\u{2212}', '⁻']);
        if negative || (marked.is_some() && rest.starts_with('+')) {
            let sign = rest.chars().next()?;
            rest = rest.get(sign.len_utf8()..)?;
        }
        let digit = |c: char| match is_raised {
            true => RAISED.iter().position(|raised| *raised == c).map(|digit| digit as i32),
            false => c.to_digit(10).map(|digit| digit as i32),
        };
        let mut power = None;
        while let Some((c, digit)) = rest.chars().next().and_then(|c| Some((c, digit(c)?))) {
            power = Some((10 * power.unwrap_or(0) + digit).min(1000));
            rest = rest.get(c.len_utf8()..)?;
        }
        let Some(power) = power else {
            // The minus sign is a separator between two symbols.
            return if marked.is_some() || is_raised { None } else { Some(1) };
        };
        let fraction =
            rest.strip_prefix('.').is_some_and(|r| r.starts_with(|c: char| c.is_ascii_digit()));
        self.rest = rest;
        (power <= HIGHEST_POWER && !fraction).then_some(if negative { -power } else { power })
    }
}

/// The power of the length that follows a word such as `sq`.
fn power_in_words(word: &str) -> Option<i32> {
    match word {
        "sq" => Some(2),
        "cu" => Some(3),
        _ => None,
    }
}

fn is_letter(c: char) -> bool {
    !(c.is_whitespace()
        || c.is_ascii_digit()
        || "*·⋅×.-\u{2212}/^()+,;⁻".contains(c)
        || RAISED.contains(&c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Wide;

    fn one(unit: &str) -> f64 {
        let unit = Unit::read(unit).unwrap_or_else(|| panic!("{unit}"));
        let number = Decimal::whole("1").unwrap();
        Exact::new(number, unit.factor).value::<Wide>().unwrap().middle()
    }

    /// Compares factors with NIST Special Publication 811 (2008), appendix B.8, to seven digits.
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

    #[test]
    fn one_unit_in_many_spellings() {
        let groups: [&[&str]; 4] = [
            &["kN/m^2", "kN/m2", "kN/m²", "kN/m**2", "kN m^-2", "kN m-2", "kN·m⁻²", "kN/m/m"],
            &["kN m", "kNm", "kN·m", "kN*m", "kN.m", "kN-m", "m kN", "(kN m)", "kN  m"],
            &["kN m^2", "kNm²", "kNm2", "(kN^2 m^4)/kN/m^2"],
            &["kip-ft", "kip ft", "kipft", "kip*ft", "ft kip"],
        ];
        for group in groups {
            for unit in group {
                assert_eq!(Unit::read(unit), Unit::read(group[0]), "{unit}");
            }
        }
        assert_eq!(Unit::read("1/m"), Unit::read("m^-1"));
        for wrong in [
            "",
            "kN/",
            "kN//m",
            "kN/m^",
            "m^x",
            "m^0.5",
            "m^13",
            "(kN m",
            "kN m)",
            "MN/m^2 m",
            "kN, m",
            "furlong",
            "1",
            "1 m",
            "2/m",
            "kn",
            "kin",
            "kkN",
            "((((((((((m))))))))))",
        ] {
            assert_eq!(Unit::read(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn equal_numbers_are_equal() {
        let exact = |number: &str, unit: &str| {
            Exact::new(Decimal::whole(number).unwrap(), Unit::read(unit).unwrap().factor)
        };
        assert_eq!(exact("25", "cm"), exact("0.25", "m"));
        assert_eq!(exact("0", "ft"), exact("0.0", "m"));
        assert_ne!(exact("1", "ft"), exact("1", "in"));
        assert_eq!(exact("9.3", "MPa").value::<f64>(), Some(9.3e6));
        assert_eq!(exact("3.6", "in").value::<Wide>().unwrap().middle(), 0.09144);
    }
}
