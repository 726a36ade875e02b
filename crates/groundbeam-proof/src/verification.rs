//! Verifies a result document: proves its claimed solution, and compares all other listed numbers with proven intervals.

use crate::bounds::Bound;
use crate::document::Document;
use crate::extremes::PlacedExtreme;
use crate::fields::Fields;
use crate::listed::{Checked, Differences, ListedErrors, differences, holds};
use crate::log::Log;
use crate::model::{Acts, Model};
use crate::patches::{FIELDS, GAP};
use crate::proof::{Proof, proven};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::scales::claimed;
use crate::size::Size;
use std::collections::BTreeSet;

/// The proven parts of a document.
#[derive(Debug, Clone, PartialEq)]
pub struct Verification {
    /// The proof of the claimed solution. Its error bounds of fields and reactions also hold for the numbers that the
    /// document lists.
    pub proof: Proof,
    /// Bound of the error of the gap u + g₀ − w.
    pub gap: Bound,
    /// The largest error of a listed edge of contact; infinite if the contact set is not proven.
    pub edges: Bound,
    /// The largest error of a listed concentrated force; infinite if the contact set is not proven.
    pub forces: Bound,
    /// The errors of each listed edge and of each listed concentrated force.
    pub listed: ListedErrors,
    /// The proven positions of the extremes that the document lists.
    pub extremes: Vec<PlacedExtreme>,
    /// Intervals on which the pressure has no bound \[m\]: intervals that contain edges of contact on a shear
    /// layer, or the whole beam if the contact set is not proven.
    pub without_pressure: Vec<[f64; 2]>,
    /// How many of the numbers in the document were compared with the proof, by kind.
    pub checked: Checked,
    /// Keys of the document whose numbers the proof does not cover.
    pub not_covered: BTreeSet<String>,
    /// The first reason why the document is not proven; `None` if it is proven.
    pub shortfall: Option<NotProven>,
}

/// Proves the solution in a document, and then compares the other numbers of the document with this solution. If `log`
/// is given, the steps of the proof are written to it.
pub(crate) fn verified<S: Scalar>(
    model: &Model<S>,
    document: &Document,
    log: Option<&mut Log>,
) -> Result<Verification, NotProven> {
    if let Some(status) = document.status.as_deref().filter(|status| *status != "solved") {
        return Err(NotProven::new(format!(
            "the status of the document is `{status}`, not `solved`"
        )));
    }
    if document.answer.pieces.is_empty() {
        return Err(NotProven::new("the document has no `pieces`"));
    }
    proven(model, &document.answer, log, |fields, proof| compared(document, fields, proof))
}

/// Compares the numbers that a document lists besides its solution with the fields and the proof of the solution.
fn compared<S: Scalar>(document: &Document, fields: &Fields<S>, mut proof: Proof) -> Verification {
    let found = differences(document, fields, &proof);
    let (edges, forces) = (
        Bound { error: found.contact.largest_edge(), scale: proof.scales.length },
        Bound { error: found.contact.largest_force(), scale: proof.scales.force },
    );
    let gap = Bound {
        error: sum(
            sum(proof.bounds.deflection.error, proof.bounds.settlement.error),
            found.fields[GAP],
        ),
        scale: proof.bounds.deflection.scale,
    };
    add(&mut proof, &found);
    if proof.contact.is_err() && !found.without_pressure.is_empty() {
        proof.bounds.pressure.error = f64::INFINITY;
    }
    let mut listed = found.contact;
    let bounds = &proof.bounds;
    let turned = sum(bounds.rotation.error, bounds.rotation.error);
    listed.hinges = vec![[turned, bounds.moment.error]; document.hinges.len()];
    let mut not_covered = document.not_covered.clone();
    not_covered.extend(found.unknown.iter().cloned());
    let mut verification = Verification {
        proof,
        gap,
        edges,
        forces,
        listed,
        extremes: found.extremes,
        without_pressure: found.without_pressure,
        checked: found.checked,
        not_covered,
        shortfall: None,
    };
    let claimed = verification.claimed(document);
    let far = far(fields, &found.fields, &verification.named());
    verification.shortfall = verification
        .proof
        .shortfall()
        .or_else(|| found.failed.or(verification.large()).or(verification.misplaced()))
        .or(far)
        .or(claimed)
        .or_else(|| verification.claimed_places(document))
        .or_else(|| verification.verdict(document, fields))
        .or_else(|| verification.state(document, fields));
    verification
}

impl Verification {
    /// All bounds with the names that documents use. The bounds of edges, forces and reactions are the largest
    /// of each kind.
    pub fn named(&self) -> Vec<(&'static str, Bound)> {
        let mut named = self.proof.bounds.named().to_vec();
        named.push(("gap", self.gap));
        named.push(("edges", self.edges));
        named.push(("forces", self.forces));
        let largest = |bounds: Vec<Bound>| {
            bounds.into_iter().reduce(|a, b| if b.error <= a.error { a } else { b })
        };
        let reactions = &self.proof.reactions;
        let forces = largest(reactions.iter().map(|reaction| reaction.force).collect());
        let moments = largest(reactions.iter().map(|reaction| reaction.moment).collect());
        named.extend(forces.map(|bound| ("reactions", bound)));
        named.extend(moments.map(|bound| ("reaction_moments", bound)));
        named
    }

    /// The bound of the error of a field along the beam; infinite if there is no bound.
    pub fn error_of(&self, field: &str) -> f64 {
        let named = self.named().into_iter().find(|(name, _)| *name == field);
        named.map_or(f64::INFINITY, |(_, bound)| bound.error)
    }

    /// The bound of the error of a field at one position; infinite for a pressure without a bound.
    pub fn error_at(&self, field: &str, x: f64) -> f64 {
        let has_none = field == "pressure" && holds(&self.without_pressure, x);
        if has_none { f64::INFINITY } else { self.error_of(field) }
    }

    /// Returns the first failed step of the proof. It is the reason why a quantity has no finite bound.
    pub fn without_bound(&self) -> Option<&NotProven> {
        let contact = self.proof.contact.as_ref().err();
        contact.or(self.proof.unique.as_ref().err()).or(self.shortfall.as_ref())
    }

    /// Returns the error bounds of the listed contact edges, forces, reactions and hinges, in the order of the
    /// document. Each list has the key that documents use for it.
    pub fn errors_of_numbers(&self) -> Vec<(&'static str, Vec<f64>)> {
        let (listed, reactions) = (&self.listed, self.proof.reactions.iter());
        let mut errors = vec![
            ("edges", listed.edges.iter().flatten().copied().collect()),
            ("forces", listed.forces.clone()),
            ("reactions", reactions.clone().map(|r| r.force.error).collect()),
            ("reaction_moments", reactions.map(|r| r.moment.error).collect()),
        ];
        errors.push(("hinge_rotations", listed.hinges.iter().map(|hinge| hinge[0]).collect()));
        errors.push(("hinge_moments", listed.hinges.iter().map(|hinge| hinge[1]).collect()));
        errors.extend(listed.end_forces.map(|ends| ("end_forces", ends.to_vec())));
        errors
    }

    /// Returns all error bounds: one for each field, and those of [`Self::errors_of_numbers`] for contact edges,
    /// forces, reactions and hinges.
    pub fn errors(&self) -> Vec<(&'static str, Vec<f64>)> {
        let one = |(name, bound): (&'static str, Bound)| (name, vec![bound.error]);
        let fields = self.proof.bounds.named().into_iter().chain([("gap", self.gap)]);
        fields.map(one).chain(self.errors_of_numbers()).collect()
    }

    /// Returns the first fault among the claimed bounds of the document: a bound that is smaller than the proven
    /// error. Records bounds with unknown names as not covered.
    fn claimed(&mut self, document: &Document) -> Option<NotProven> {
        let errors = self.errors();
        let mut first = None;
        for (name, claimed) in &document.bounds {
            let Some((_, proven)) = errors.iter().find(|(known, _)| known == name) else {
                self.not_covered.insert(format!("proof.bounds.{name}"));
                continue;
            };
            if claimed.len() != proven.len() {
                let what = format!(
                    "the document lists {} error bounds of `{name}`, but {} are required",
                    claimed.len(),
                    proven.len()
                );
                first = first.or(Some(NotProven::new(what)));
                continue;
            }
            for (claimed, proven) in claimed.iter().zip(proven) {
                self.checked.bounds += 1;
                if !(claimed >= proven) && first.is_none() {
                    let what = format!(
                        "the document claims {claimed:e} as the bound of `{name}`; the proven bound is {proven:e}"
                    );
                    first = Some(NotProven::new(what));
                }
            }
        }
        first
    }

    /// Reports a listed verdict that contradicts the proof: no equilibrium, several equilibria if it is unique, or a local
    /// equilibrium without compression.
    fn verdict<S: Scalar>(&self, document: &Document, fields: &Fields<S>) -> Option<NotProven> {
        let verdict = document.verdict.as_deref()?;
        let contradicts = match verdict {
            "unique" => false,
            "local" => fields.frame.compression.is_none(),
            "not-unique" => self.proof.unique.is_ok(),
            _ => true,
        };
        let what = || NotProven::new(format!("the listed verdict `{verdict}` is wrong"));
        contradicts.then(what)
    }

    /// Reports the first one-way support whose listed state is not proven. It is acting if its reaction exceeds the error
    /// bound, and otherwise lifted or, if it only pulls, slack.
    fn state<S: Scalar>(&self, document: &Document, fields: &Fields<S>) -> Option<NotProven> {
        let wrong = |(support, state): &&(usize, String)| {
            let reactions = &document.answer.reactions;
            let claimed = reactions.iter().find(|reaction| reaction.support == *support);
            let force = claimed.map_or(0.0, |reaction| reaction.force.abs());
            let error = self.proof.reactions.get(*support).map_or(f64::INFINITY, |r| r.force.error);
            let acts = fields.frame.supports.get(*support).map(|held| held.acts);
            match (state.as_str(), acts) {
                ("acting", Some(Acts::Up | Acts::Down)) => !(force > error),
                ("lifted", Some(Acts::Up)) | ("slack", Some(Acts::Down)) => force != 0.0,
                _ => true,
            }
        };
        let (support, state) = document.states.iter().find(wrong)?;
        Some(NotProven::new(format!(
            "the listed state `{state}` of support {support} is not proven"
        )))
    }

    /// Reports the first extreme whose claimed intervals do not contain all proven positions.
    fn claimed_places(&mut self, document: &Document) -> Option<NotProven> {
        let mut first = None;
        for (field, is_max, claimed) in &document.places {
            self.checked.bounds += claimed.len();
            let same = |e: &&PlacedExtreme| e.field == *field && e.is_max == *is_max;
            let placed = self.extremes.iter().find(same).map_or(&[][..], |e| &e.places);
            let held =
                |[low, high]: &[f64; 2]| claimed.iter().any(|c| c[0] <= *low && *high <= c[1]);
            if placed.is_empty() || !placed.iter().all(held) {
                let which = if *is_max { "largest" } else { "smallest" };
                let field = field.replace('_', " ");
                let what = format!(
                    "the document claims positions of the {which} {field} that are not proven"
                );
                first = first.or(Some(NotProven::new(what)));
            }
        }
        first
    }

    /// Reports the first listed extreme farther than 10⁻⁶ of the beam length from all intervals of its exact position.
    fn misplaced(&self) -> Option<NotProven> {
        let far = 1e-6 * self.proof.scales.length;
        let extreme = self.extremes.iter().find(|extreme| extreme.distance() > far)?;
        let which = if extreme.is_max { "largest" } else { "smallest" };
        let field = extreme.field.replace('_', " ");
        let what = format!("the listed position of the {which} {field} is wrong");
        Some(NotProven::new(what).at(extreme.listed))
    }

    /// Reports the first quantity whose error bound is not small: the gap between beam and ground, the listed edges of
    /// contact, or the listed concentrated forces.
    fn large(&self) -> Option<NotProven> {
        let all = [
            ("gap", self.gap),
            ("listed edges of contact", self.edges),
            ("listed concentrated forces", self.forces),
        ];
        let (name, Bound { error, scale }) =
            all.into_iter().find(|(_, bound)| !bound.is_small())?;
        Some(NotProven::new(format!(
            "the error bound of the {name} is too large: {error:.1e} is more than a millionth of the scale {scale:.1e}"
        )))
    }
}

/// Reports the first field with a listed number that is too far from the claimed solution. The limit is 10⁻⁶ of the
/// largest value of the field, plus 10⁻¹¹ of its scale for rounding errors. The scale may far exceed the values.
fn far<S: Scalar>(
    fields: &Fields<S>,
    differences: &[f64; 8],
    bounds: &[(&'static str, Bound)],
) -> Option<NotProven> {
    let fields_of = FIELDS.iter().zip(claimed(fields)).zip(differences);
    for (((name, force, length), largest), difference) in fields_of {
        let own = fields.frame.units.restored(largest, *force, *length);
        let bound = bounds.iter().find(|(known, _)| known == name);
        let scale = bound.map_or(0.0, |(_, bound)| bound.scale);
        if !(*difference <= 1e-6 * own + 1e-11 * scale) {
            let name = name.replace('_', " ");
            let what =
                format!("a listed {name} differs from the claimed solution by {difference:.1e}");
            return Some(NotProven::new(what));
        }
    }
    None
}

/// Increases the error bound of each field by the largest difference between the field's listed numbers and the claimed
/// solution.
fn add(proof: &mut Proof, found: &Differences) {
    let bounds = &mut proof.bounds;
    let [deflection, slope, rotation, moment, shear_force, settlement, _, pressure] = found.fields;
    for (bound, difference) in [
        (&mut bounds.deflection, deflection),
        (&mut bounds.slope, slope),
        (&mut bounds.rotation, rotation),
        (&mut bounds.moment, moment),
        (&mut bounds.shear_force, shear_force),
        (&mut bounds.settlement, settlement),
        (&mut bounds.pressure, pressure),
    ] {
        bound.error = sum(bound.error, difference);
    }
}

/// The sum, rounded up.
fn sum(a: f64, b: f64) -> f64 {
    (Size::of(a) + Size::of(b)).value()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::given_claim::with_fields;
    use serde_json::json;

    /// Checks the limit of `far`: 10⁻⁶ of the largest value plus 10⁻¹¹ of the scale. The largest deflection is 1, and
    /// the other tested fields are 0.
    #[test]
    fn listed_numbers_are_near_the_numbers_of_the_pieces() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n";
        let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [1]});
        with_fields(model, &json!({"pieces": [piece]}), |fields| {
            let names = ["deflection", "slope", "rotation", "moment", "shear_force"];
            for (i, name) in names.into_iter().enumerate() {
                let own = if i == 0 { 1e-6 } else { 0.0 };
                for scale in [0.0, 1e6] {
                    let bounds = names.map(|other| {
                        (
                            other,
                            Bound { error: 0.0, scale: if other == name { scale } else { 1.0 } },
                        )
                    });
                    let other = own + 1e-11 * scale;
                    for (part, near) in [(0.99, true), (1.01, other == 0.0)] {
                        let mut differences = [0.0; 8];
                        differences[i] = part * other;
                        let found = far(fields, &differences, &bounds);
                        assert_eq!(found.is_none(), near, "{name} {scale} {part}: {found:?}");
                    }
                    let mut differences = [0.0; 8];
                    differences[i] = 1.0;
                    assert!(far(fields, &differences, &bounds).is_some(), "{name} {scale}");
                }
            }
        });
    }
}
