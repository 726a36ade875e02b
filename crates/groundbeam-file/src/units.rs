//! Decides whether a file has units: either all quantities except 0 have a unit, or none has.

use crate::code;
use crate::document::Quantity;
use crate::fault::Fault;
use crate::number::Decimal;
use crate::print::{self, System, Units, UsUnits};
use crate::quantity::Kind;
use crate::reader::Reader;
use crate::unit::{Dimension, Marks, Unit, decimal_length};
use std::ops::Range;

/// Notation of the quantities in a file, which is also used for its results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnitSystem {
    /// All quantities have units. The numbers of the model are in m, N, rad and products of these units.
    Si,
    /// No quantity has a unit. All numbers belong to one consistent system of units.
    Plain,
}

impl From<UnitSystem> for Units {
    /// Returns SI units, or no units for a file without units.
    fn from(of: UnitSystem) -> Self {
        match of {
            UnitSystem::Si => Units::SI,
            UnitSystem::Plain => Units::PLAIN,
        }
    }
}

/// Returns the units of printed results for a file with these quantities.
pub(crate) fn printed(system: UnitSystem, quantities: &[Seen]) -> Units {
    let count = |any: Marks| quantities.iter().filter(|seen| seen.marks.has_any(any)).count();
    let (us, newton) = (count(Marks::US), count(Marks::NEWTON));
    let (metre, technical) = (count(Marks::METRE), count(Marks::TECHNICAL));
    match system {
        UnitSystem::Plain => Units::PLAIN,
        UnitSystem::Si if us > metre.max(newton).max(technical) => {
            Units::new(System::Us(us_units(quantities)))
        }
        UnitSystem::Si if technical > newton => Units::new(System::Technical),
        UnitSystem::Si => Units::SI,
    }
}

/// Chooses the US units of results. Each kind of quantity has its most frequent unit of length. A file without feet has
/// results in inches.
fn us_units(quantities: &[Seen]) -> UsUnits {
    let count = |kind: Option<print::Kind>, marks: Marks| {
        let of_kind = |seen: &&Seen| kind.is_none() || seen.kind.printed == kind;
        quantities.iter().filter(of_kind).filter(|seen| seen.marks.has_any(marks)).count()
    };
    let has_feet = count(None, Marks::FOOT) > 0;
    let has_inches = |kind: print::Kind| {
        let [inch, foot] = [Marks::INCH, Marks::FOOT].map(|marks| count(Some(kind), marks));
        inch > foot || (inch == foot && (!has_feet || UsUnits::USUAL.has_inches(kind)))
    };
    let loads = [print::Kind::Force, print::Kind::Pressure, print::Kind::Moment];
    let [pound, kip] = [Marks::POUND, Marks::KIP]
        .map(|marks| loads.iter().map(|&kind| count(Some(kind), marks)).sum::<usize>());
    let inches = print::Kind::ALL.iter().copied().filter(|&kind| has_inches(kind));
    UsUnits::new(inches, pound > 0 && kip == 0)
}

/// A quantity that was read.
#[derive(Debug, Clone)]
pub(crate) struct Seen {
    pub key: String,
    pub kind: &'static Kind,
    pub has_unit: bool,
    /// Whether the quantity is 0 without a unit, which is allowed in files with and without units.
    pub is_bare_zero: bool,
    /// Value in SI units, or the number as written in a file without units. It is 0 if the entry is the
    /// name of a built-in train, material or section instead of a number.
    pub value: f64,
    /// Flags of the unit.
    pub marks: Marks,
    pub span: Range<usize>,
}

impl Seen {
    /// Returns the entry of a built-in train, material or section. It counts as a quantity with a unit, so all others
    /// need units.
    pub fn of_built_in(key: &str, kind: &'static Kind, span: Range<usize>) -> Self {
        let (key, marks) = (key.to_owned(), Marks::NONE);
        Seen { key, kind, has_unit: true, is_bare_zero: false, value: 0.0, marks, span }
    }

    /// Returns the location of the number in the text and the factor of its unit; `None` if escape sequences
    /// hide the number.
    fn located(&self, text: &str) -> Option<Quantity> {
        let written = text.get(self.span.clone())?;
        let quote =
            ["\"\"\"", "'''", "\"", "'"].into_iter().find(|quote| written.starts_with(quote));
        let inner = match quote {
            Some(quote) => written.strip_prefix(quote)?.strip_suffix(quote)?,
            None => written,
        };
        // The inch sign is escaped in a basic string.
        let inner = inner.trim();
        let plain = inner.replace("\\\"", "\"");
        if plain.contains('\\') {
            return None;
        }
        let start = self.span.start + written.find(inner)?;
        let is_length = self.kind.dimension == Dimension::LENGTH;
        let decimal = decimal_length(&plain).filter(|_| is_length);
        let (length, unit) = match decimal {
            Some((_, unit)) => (inner.len(), unit),
            None => {
                let (_, length) = Decimal::read(inner)?;
                (length, plain[length..].trim())
            }
        };
        let one = if unit.is_empty() { 1.0 } else { Unit::read(unit).ok()?.scale.to_f64() };
        Some(Quantity {
            key: self.key.clone(),
            span: self.span.clone(),
            number: start..start + length,
            text: start..start + inner.len(),
            decimal,
            unit: one,
            sign: self.kind.sign,
            place: self.kind.place,
            usual: self.kind.listed(self.kind.example),
        })
    }
}

impl Reader<'_> {
    /// Returns all quantities in the order of the text. In a file with units, a 0 without a unit is left out, because
    /// it cannot be changed to another number without adding a unit.
    pub fn located(&self, units: UnitSystem) -> Vec<Quantity> {
        let fits = |seen: &&Seen| units == UnitSystem::Plain || !seen.is_bare_zero;
        let all = self.quantities.iter().filter(fits);
        let all = all.filter_map(|seen| seen.located(&self.source.text));
        let mut all: Vec<Quantity> = all.collect();
        all.sort_by_key(|quantity| quantity.span.start);
        all.dedup_by_key(|quantity| quantity.span.start);
        all
    }

    /// Returns the unit system of the file; `None` if no quantity differs from 0. If quantities with and
    /// without units are mixed, the first quantity of the smaller group is reported.
    pub fn unit_system(&mut self) -> Option<UnitSystem> {
        if self.bare_is_si {
            return Some(UnitSystem::Si);
        }
        let mut seen: Vec<Seen> =
            self.quantities.iter().filter(|seen| !seen.is_bare_zero).cloned().collect();
        seen.sort_by_key(|quantity| quantity.span.start);
        let with = seen.iter().filter(|quantity| quantity.has_unit).count();
        let without = seen.len() - with;
        let units_prevail = with >= without;
        let odd_one = seen.iter().find(|quantity| quantity.has_unit != units_prevail);
        let usual_one = seen.iter().find(|quantity| quantity.has_unit == units_prevail);
        if let (Some(odd), Some(usual)) = (odd_one, usual_one) {
            let rule = "give all quantities of the file a unit, or none of them; a 0 needs no unit";
            let (message, label, other, hint) = if units_prevail {
                let number = self.source.text[odd.span.clone()].trim_matches(['"', '\'']);
                let line = format!("{} = \"{} {}\"", odd.key, number.trim(), odd.kind.unit);
                (
                    format!("`{}` has no unit, but other quantities have one", odd.key),
                    "no unit here",
                    "a unit here",
                    format!("{rule}; write for example {line}"),
                )
            } else {
                (
                    format!("`{}` has a unit, but other quantities have none", odd.key),
                    "a unit here",
                    "no unit here",
                    rule.to_owned(),
                )
            };
            let few = with.min(without);
            let hint = if few > 1 { format!("{hint} ({few} are like this)") } else { hint };
            let fault = Fault::new(code::MIXED, odd.span.clone(), message, label, hint);
            self.report_with(fault, usual.span.clone(), other);
        }
        let units = if with > 0 { UnitSystem::Si } else { UnitSystem::Plain };
        (!seen.is_empty()).then_some(units)
    }
}
