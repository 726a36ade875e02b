//! Compares two answers to one model, for example of two machines or methods, within the bounds of their certificates.
//!
//! The root √g of the relative energy gap g of an answer is a bound of its relative error in the energy norm. Let e be
//! the sum of the roots of both answers.
//!
//! The bounds of settlements, of the root mean square of moments and of energies are theorems. The other limits come
//! from measurements. Each frozen model was solved again from the contact set of the same model with loads times 1.01
//! and 0.9, which changes only the rounding errors. Compressed, CompressedToo, Extreme from number 50 on and four slow
//! models of Hard were not measured. Supported 1303 exceeded the limits, with a third contact zone of negligible force.
//!
//! | quantity, relative to its largest size | largest difference | limit |
//! |---|---|---|
//! | w, w′, M, u, the gap, end forces, reactions, hinges | 1.4 e, or 6·10⁻¹¹ | 3 e + 10⁻⁹ |
//! | V and p, the derivatives of M | 55 e, or 4·10⁻¹⁰ | 100 e + 10⁻⁹ |
//! | V at a support, and if a zone or a gap is shorter than 10⁻⁷ l | 8·10⁻⁵ | 100 e + 10⁻⁵, or the bound of V |
//! | edges, relative to l | 4.4·10⁻⁸ | 10⁻⁷ |
//!
//! Contact zones and gaps between zones that are shorter than 10⁻⁷ l are ignored; then extreme values of p are not
//! compared. The position of an extreme value may be any position where the field has this value. Near a jump, every
//! value between both sides is accepted.

use super::Frozen;
use super::answer::STEPS;
use super::bits::Difference;
use super::record::Record;
use crate::proven::proven_bounds;
use groundbeam::{Error, Field, Outcome, Solution, solution::Side};

/// Largest accepted difference between the positions of a contact edge in the stored and in the present answer, as a
/// fraction of the beam length.
const EDGE: f64 = 1e-7;
/// Part of the accepted difference of two values that covers rounding errors, relative to the largest value of the
/// quantity.
const FLOOR: f64 = 1e-9;
/// `FLOOR` of the shear force at supports. It holds on the whole beam if a contact zone or a gap between zones is
/// shorter than `EDGE` times the length.
const FLOOR_AT_SUPPORTS: f64 = 1e-5;
/// Accepted difference of a field, as a multiple of √g + √g′ with the relative energy gaps g and g′ of both answers.
/// The second number is for shear force and pressure.
const SHARES: [f64; 2] = [3.0, 100.0];

/// Returns all differences between a frozen answer and the present answer that exceed the bounds. A frozen answer
/// that did not converge is not compared.
pub fn differences(frozen: &Frozen, outcome: &Result<Outcome, Error>) -> Vec<Difference> {
    let word = frozen.answer.word("outcome");
    let present = match outcome {
        Ok(Outcome::Equilibrium(_)) => "equilibrium",
        Ok(Outcome::NoEquilibrium(_)) => "no-equilibrium",
        Err(Error::Invalid(_)) => "invalid",
        Err(Error::NotConverged(_)) => "not-converged",
        Err(_) => "unsupported",
    };
    if word == "not-converged" {
        return Vec::new();
    }
    match outcome {
        Ok(Outcome::Equilibrium(solution)) if word == present => {
            let mut comparison = Comparison::new(frozen, solution);
            comparison.compare();
            comparison.found
        }
        _ if word == present => Vec::new(),
        _ => vec![Difference {
            title: frozen.title().to_owned(),
            quantity: "outcome".to_owned(),
            frozen: word.to_owned(),
            present: present.to_owned(),
            size: String::new(),
        }],
    }
}

struct Comparison<'a> {
    frozen: &'a Frozen,
    solution: &'a Solution,
    /// The sum √g + √g′ for the relative energy gaps g of the stored answer and g′ of the present answer.
    error: f64,
    /// Error bounds of settlement, moment and shear force for the present answer; infinite if nothing is proven.
    bounds: [f64; 3],
    /// Whether the stored or the present answer has a contact zone, or a gap between two zones, that is shorter than
    /// the accepted difference of contact edges.
    has_short_intervals: bool,
    found: Vec<Difference>,
}

impl<'a> Comparison<'a> {
    fn new(frozen: &'a Frozen, solution: &'a Solution) -> Self {
        let gaps = [
            frozen.certificate.numbers("energies").get(3).copied().unwrap_or(f64::NAN),
            solution.certificate().relative_gap(),
        ];
        let error = gaps.iter().map(|gap| gap.max(0.0).sqrt()).sum();
        let l = solution.model().beam.length;
        let short = |edges: &[f64]| edges.windows(2).any(|pair| pair[1] - pair[0] <= EDGE * l);
        let has_short_intervals =
            short(&frozen.answer.numbers("contact")) || short(&edges(solution));
        let bounds = proven_bounds(solution);
        Comparison { frozen, solution, error, bounds, has_short_intervals, found: Vec::new() }
    }

    fn answer(&self) -> &'a Record {
        &self.frozen.answer
    }

    fn length(&self) -> f64 {
        self.solution.model().beam.length
    }

    fn compare(&mut self) {
        self.verdict();
        self.contact();
        self.forces();
        self.settlements_and_moments();
        for field in Field::of(&self.solution.model().beam) {
            self.extremes(field);
            self.field(field);
        }
        self.energy();
    }

    /// Records two values if they differ by more than a limit, or if exactly one of them is NaN.
    fn hold(&mut self, quantity: &str, frozen: f64, present: f64, limit: f64) {
        let distance = (frozen - present).abs();
        if distance <= limit || frozen.to_bits() == present.to_bits() {
            return;
        }
        self.found.push(Difference {
            title: self.frozen.title().to_owned(),
            quantity: quantity.to_owned(),
            frozen: format!("{frozen:?}"),
            present: format!("{present:?}"),
            size: format!("{distance:.1e}, more than {limit:.1e}"),
        });
    }

    /// Returns the reference magnitude of a field: its largest value in the stored answer, or a bound of its rounding
    /// errors if this is larger.
    fn size(&self, field: Field) -> f64 {
        let own = |field: Field| {
            let values = self.answer().numbers(&format!("extremes_{}", field.name()));
            [1, 3]
                .map(|i| values.get(i).map_or(0.0, |value| value.abs()))
                .into_iter()
                .fold(0.0, f64::max)
        };
        match field {
            // Gap and settlement are differences from the deflection, so their rounding errors are proportional to the
            // deflection.
            Field::Gap | Field::Settlement => own(field).max(own(Field::Deflection)),
            Field::ShearForce => self
                .answer()
                .numbers("static_reactions")
                .into_iter()
                .map(f64::abs)
                .fold(own(field), f64::max),
            // On a beam with very little contact, all pressures are as small as rounding errors.
            Field::Pressure => own(field).max(FLOOR * self.size(Field::ShearForce) / self.length()),
            _ => own(field),
        }
    }

    /// Returns the largest allowed difference of two values of a field at a position.
    fn limit(&self, field: Field, x: f64) -> f64 {
        let derivative = matches!(field, Field::ShearForce | Field::Pressure);
        let near = EDGE * self.length();
        let supports = &self.solution.model().supports;
        let pinched = self.has_short_intervals
            || supports.iter().any(|support| (support.at - x).abs() <= near);
        let share = SHARES[usize::from(derivative)] * self.error;
        if !(pinched && field == Field::ShearForce) {
            return self.size(field) * (share + FLOOR);
        }
        // Near a settled support, the rounding error of w changes V by up to 12 EI/h³ times its size, in an element of
        // length h. The proven bound of V includes this error.
        let [_, _, bound] = self.bounds;
        let proven = if bound.is_finite() { bound } else { 0.0 };
        (self.size(field) * (share + FLOOR_AT_SUPPORTS)).max(proven)
    }

    fn verdict(&mut self) {
        let present = super::answer::verdict(self.solution.existence());
        let present = Record::new("", &present);
        let words = [self.answer().word("verdict"), present.word("verdict")];
        if words[0] != words[1] {
            self.found.push(Difference {
                title: self.frozen.title().to_owned(),
                quantity: "verdict".to_owned(),
                frozen: words[0].to_owned(),
                present: words[1].to_owned(),
                size: String::new(),
            });
            return;
        }
        for key in ["verdict", "static_reactions"] {
            let [old, new] = [self.answer(), &present].map(|record| record.numbers(key));
            let size = old
                .iter()
                .filter(|value| value.is_finite())
                .fold(0.0, |size: f64, value| size.max(value.abs()));
            for (i, (old, new)) in
                old.into_iter().zip(new).enumerate().skip(usize::from(key == "verdict"))
            {
                self.hold(&format!("{key}[{i}]"), old, new, EDGE * size);
            }
        }
    }

    fn contact(&mut self) {
        let l = self.length();
        let [old, new] = [self.answer().numbers("contact"), edges(self.solution)]
            .map(|edges| zones(edges, EDGE * l));
        if old.len() != new.len() {
            let zones = |edges: &[f64]| format!("{} zones", edges.len() / 2);
            self.found.push(Difference {
                title: self.frozen.title().to_owned(),
                quantity: "contact".to_owned(),
                frozen: zones(&old),
                present: zones(&new),
                size: format!("{old:?} and {new:?}"),
            });
            return;
        }
        for (i, (old, new)) in old.into_iter().zip(new).enumerate() {
            self.hold(&format!("contact[{i}]"), old, new, EDGE * l);
        }
    }

    fn forces(&mut self) {
        let limits = [Field::ShearForce, Field::Moment, Field::Slope]
            .map(|field| self.size(field) * (SHARES[0] * self.error + FLOOR));
        let [force, moment, rotation] = limits;
        let present = super::answer::forces(self.solution);
        let present = Record::new("", &present);
        for (key, limits) in [
            ("end_forces", &[force, force][..]),
            ("reactions", &[0.0, force, moment]),
            ("hinges", &[0.0, rotation, moment]),
        ] {
            let [old, new] = [self.answer(), &present].map(|record| record.numbers(key));
            self.hold(&format!("numbers of {key}"), old.len() as f64, new.len() as f64, 0.0);
            for (i, (old, new)) in old.into_iter().zip(new).enumerate() {
                self.hold(&format!("{key}[{i}]"), old, new, limits[i % limits.len()]);
            }
        }
        // A concentrated force that occurs only in the stored or only in the present answer must be as small as a
        // rounding error.
        let [old, new] =
            [self.answer(), &present].map(|record| record.numbers("concentrated_forces"));
        let near = EDGE * self.length();
        let at = |list: &[f64], x: f64| -> f64 {
            list.chunks_exact(2)
                .filter(|pair| (pair[0] - x).abs() <= near)
                .map(|pair| pair[1])
                .sum()
        };
        for x in old.iter().chain(&new).step_by(2).copied().collect::<Vec<_>>() {
            self.hold(&format!("concentrated force at {x:?}"), at(&old, x), at(&new, x), force);
        }
    }

    /// Compares the settlements and moments of the stored and the present answer within their proven error bounds.
    fn settlements_and_moments(&mut self) {
        let bounds = self.frozen.certificate.numbers("bounds");
        // The last bound of a stored certificate is that of the moment error, or of its root mean square if the pinned
        // program wrote it.
        let bounds = [bounds[0], bounds[bounds.len() - 1]];
        let present = self.bounds;
        // If the proof gives no bound for the present answer, the bound of the stored answer is used for both answers.
        let [settlement, moments] =
            [0, 1].map(|i| bounds[i] + if present[i].is_finite() { present[i] } else { bounds[i] });
        let mut squares = [0.0, 0.0];
        for (i, x) in self.positions("fields_moment") {
            let old = self.answer().numbers("fields_settlement")[i];
            let new = self.solution.value(Field::Settlement, x);
            self.hold(&format!("settlement at {x:?} within its bound"), old, new, settlement);
            let moment =
                self.solution.value(Field::Moment, x) - self.answer().numbers("fields_moment")[i];
            squares = [squares[0] + moment * moment, squares[1] + 1.0];
        }
        let rms = (squares[0] / squares[1]).sqrt();
        self.hold("RMS difference between stored and present moments", 0.0, rms, moments);
    }

    /// Returns the indices of the values that the stored answer has for `key`, and the positions on the beam where
    /// these values apply.
    fn positions(&self, key: &str) -> Vec<(usize, f64)> {
        let count = self.answer().line(key).map_or(0, |line| line.words.len());
        let steps = count.saturating_sub(1).max(1);
        (0..count)
            .map(|i| (i, self.length() * ((i * (STEPS / steps)) as f64 / STEPS as f64)))
            .collect()
    }

    fn field(&mut self, field: Field) {
        let key = format!("fields_{}", field.name());
        let values = self.answer().numbers(&key);
        for (i, x) in self.positions(&key) {
            let limit = self.limit(field, x);
            let present = self.nearest(field, x, values[i]);
            self.hold(&format!("{} at {x:?}", field.name()), values[i], present, limit);
        }
    }

    fn extremes(&mut self, field: Field) {
        if field == Field::Pressure && self.has_short_intervals {
            return;
        }
        let old = self.answer().numbers(&format!("extremes_{}", field.name()));
        let range = self.solution.range(field);
        for (i, what, now) in [(0, "smallest", range.min), (2, "largest", range.max)] {
            let [x, value] = [old[i], old[i + 1]];
            let limit = self.limit(field, x);
            let name = format!("{what} {}", field.name());
            self.hold(&name, value, now.value, limit);
            let there = self.nearest(field, x, value);
            self.hold(&format!("{name} at {x:?}"), value, there, 2.0 * limit);
        }
    }

    /// Returns the value of a field that is nearest to `wanted`, among its values at positions no farther from x than
    /// the accepted difference of contact edges.
    fn nearest(&self, field: Field, x: f64, wanted: f64) -> f64 {
        let near = EDGE * self.length();
        let edges = edges(self.solution).into_iter().filter(|edge| (edge - x).abs() <= near);
        let places = [x, x - near, x + near].into_iter().chain(edges);
        let values = places.flat_map(|at| {
            [Side::Left, Side::Right].map(|side| self.solution.at(at, side).get(field))
        });
        let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], v| {
            [least.min(v), most.max(v)]
        });
        wanted.max(least).min(most)
    }

    fn energy(&mut self) {
        let energies = self.frozen.certificate.numbers("energies");
        let now = self.solution.certificate();
        let limit = energies[2].max(now.gap()) + FLOOR * energies[0].abs();
        self.hold("primal energy", energies[0], now.primal_energy(), limit);
    }
}

fn edges(solution: &Solution) -> Vec<f64> {
    solution.contact().iter().flat_map(|zone| [zone.from, zone.to]).collect()
}

/// Returns the edges of all contact zones that are longer than a limit, after merging zones closer than the limit.
fn zones(edges: Vec<f64>, limit: f64) -> Vec<f64> {
    let mut zones: Vec<f64> = Vec::new();
    for zone in edges.chunks_exact(2) {
        match zones.last_mut() {
            Some(last) if zone[0] - *last <= limit => *last = zone[1],
            _ => zones.extend(zone),
        }
    }
    zones.chunks_exact(2).filter(|zone| zone[1] - zone[0] > limit).flatten().copied().collect()
}
