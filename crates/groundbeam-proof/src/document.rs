//! Reads the document of a result: the claimed answer, the listed values, and the keys that the proof does not cover.

use crate::json::{self, Json, JsonError};
use crate::json_object::{
    Object, all_numbers, elements, list, number, numbers, object, optional, pair, text_of, two,
    wrong,
};
use crate::{Answer, Force, Piece, Reaction};
use std::collections::BTreeSet;

/// Maximum number of pieces of an answer.
const MOST_PIECES: usize = 100_000;
/// Maximum number of coefficients of a polynomial.
const MOST_COEFFICIENTS: usize = 26;

/// The contents of a document for one model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Value of the key `status`, such as `solved` or `no-equilibrium`.
    pub status: Option<String>,
    /// Value of the key `units`: `SI`, or the names of the units of the numbers.
    pub units: Option<String>,
    /// Value of the key `model_digest`: the digest of the model file and of the table files to which it refers.
    pub model_digest: Option<String>,
    /// Value of the key `model`: the text of the solved model file. It is present only if the original file has a key
    /// that the proof checker does not read.
    pub model: Option<String>,
    /// Name of the combination of load cases.
    pub combination: Option<String>,
    /// The claimed answer: the pieces of the deflection, the concentrated contact forces and the reactions of the supports.
    pub answer: Answer,
    /// Verdict on existence that the document lists; `None` if it lists none.
    pub verdict: Option<String>,
    /// Number and listed state of each one-way support whose state is listed.
    pub states: Vec<(usize, String)>,
    /// Listed contact regions as (left end, right end) \[m\]. Both ends of a contact point are equal. `None` if the
    /// document lists no regions.
    pub contact: Option<Vec<[f64; 2]>>,
    /// Listed contact forces under the left and the right end of the beam \[N\].
    pub end_forces: Option<[f64; 2]>,
    /// Fields at positions along the beam. Where a field jumps, the value on the right is listed. At the right end
    /// of the beam, the value on the left is listed.
    pub stations: Stations,
    /// Left-hand limits of the fields at the positions where a field jumps.
    pub left_of_jumps: Stations,
    /// Largest and smallest values of the fields, as the document lists them.
    pub extremes: Vec<Extreme>,
    /// Stretches without contact that the document lists, each as (left end, right end, position of the largest
    /// gap, largest gap) \[m\].
    pub lift_off: Vec<[f64; 4]>,
    /// Listed hinges as (position \[m\], rotation \[rad\], moment \[N·m\]).
    pub hinges: Vec<[f64; 3]>,
    /// Names and values of the listed error bounds. An error bound has one or several values.
    pub bounds: Vec<(String, Vec<f64>)>,
    /// Claimed positions of extremes: name of the field, whether the extreme is the largest value, and intervals
    /// that contain all positions of the extreme.
    pub places: Vec<(String, bool, Vec<[f64; 2]>)>,
    /// Other keys with numbers, which the proof does not cover.
    pub not_covered: BTreeSet<String>,
}

/// Values of fields at positions along the beam.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stations {
    /// The positions \[m\].
    pub x: Vec<f64>,
    /// Name of each field, and its values at the positions.
    pub fields: Vec<(String, Vec<f64>)>,
}

/// A listed extreme of a field.
#[derive(Debug, Clone, PartialEq)]
pub struct Extreme {
    /// Name of the field.
    pub field: String,
    /// Whether the extreme is the largest value of the field; otherwise it is the smallest value.
    pub is_max: bool,
    /// Position \[m\] of the extreme along the beam, as the document lists it.
    pub x: f64,
    /// Value of the field at the extreme.
    pub value: f64,
}

impl Document {
    /// Reads a document with one result, or with one result for each combination.
    ///
    /// # Errors
    ///
    /// Returns an error if the text is not JSON, repeats a key, or is not a result.
    pub fn read(text: &str) -> Result<Vec<Document>, JsonError> {
        let mut root = object(json::read(text)?, "the document")?;
        let Some(combinations) = root.remove("combinations") else {
            return Ok(vec![Document::of(root)?]);
        };
        if root.contains_key("existence") {
            return wrong("`existence` must be in the elements of `combinations`");
        }
        let [digest, units] = [text_of(&mut root, "model_digest")?, text_of(&mut root, "units")?];
        let mut read: Vec<Document> = Vec::new();
        for combination in list(combinations, "combinations")? {
            let mut combination = object(combination, "combinations")?;
            let name = text_of(&mut combination, "name")?;
            let mut document = Document::of(combination)?;
            document.combination = agreed(document.combination, &name, "name")?;
            document.model_digest = agreed(document.model_digest, &digest, "model_digest")?;
            document.units = agreed(document.units, &units, "units")?;
            if read.iter().any(|other| other.combination == document.combination) {
                return wrong("`combinations` has two elements with the same name");
            }
            read.push(document);
        }
        let mut not_covered = BTreeSet::new();
        if let Some(proof) = root.remove("proof") {
            rest("proof", &object(proof, "proof")?, &mut not_covered);
        }
        rest("", &root, &mut not_covered);
        for document in &mut read {
            document.not_covered.extend(not_covered.iter().cloned());
        }
        Ok(read)
    }

    fn of(mut root: Object) -> Result<Document, JsonError> {
        let mut document = Document {
            status: text_of(&mut root, "status")?,
            units: text_of(&mut root, "units")?,
            model_digest: text_of(&mut root, "model_digest")?,
            model: text_of(&mut root, "model")?,
            combination: text_of(&mut root, "combination")?,
            ..Document::default()
        };
        let pieces = elements(&mut root, "pieces")?;
        if pieces.len() > MOST_PIECES {
            return wrong("`pieces` has more than 100000 elements");
        }
        document.answer.pieces = pieces.into_iter().map(piece).collect::<Result<_, _>>()?;
        if let Some(Json::Object(existence)) = root.get_mut("existence") {
            document.verdict = text_of(existence, "verdict")?;
        }
        document.forces(&mut root)?;
        document.contact(&mut root)?;
        document.stations = stations(&mut root, "stations")?;
        document.left_of_jumps = stations(&mut root, "left_of_jumps")?;
        document.extremes(&mut root)?;
        document.bounds(&mut root)?;
        rest("", &root, &mut document.not_covered);
        Ok(document)
    }

    fn forces(&mut self, root: &mut Object) -> Result<(), JsonError> {
        for mut force in elements(root, "forces")? {
            let (x, size) = (number(&mut force, "x")?, number(&mut force, "force")?);
            self.answer.forces.push(Force { x, force: size });
            rest("forces", &force, &mut self.not_covered);
        }
        let mut seen = BTreeSet::new();
        for (i, mut reaction) in elements(root, "reactions")?.into_iter().enumerate() {
            // Reactions without the key `support` are listed for all supports, in the order of the model.
            let support = match reaction.remove("support") {
                None => i,
                Some(support) => index(support)?,
            };
            if !seen.insert(support) {
                return wrong(format!("`reactions` lists support {support} twice"));
            }
            let force = number(&mut reaction, "force")?;
            let moment = optional(&mut reaction, "moment")?.unwrap_or(0.0);
            if let Some(state) = text_of(&mut reaction, "state")? {
                self.states.push((support, state));
            }
            self.answer.reactions.push(Reaction { support, force, moment });
            rest("reactions", &reaction, &mut self.not_covered);
        }
        Ok(())
    }

    fn contact(&mut self, root: &mut Object) -> Result<(), JsonError> {
        if root.contains_key("contact") {
            let mut contact = Vec::new();
            for mut region in elements(root, "contact")? {
                contact.push([number(&mut region, "from")?, number(&mut region, "to")?]);
                rest("contact", &region, &mut self.not_covered);
            }
            self.contact = Some(contact);
        }
        for mut stretch in elements(root, "lift_off")? {
            let ends = [number(&mut stretch, "from")?, number(&mut stretch, "to")?];
            if let Some(largest) = stretch.remove("largest_gap") {
                let mut largest = object(largest, "largest_gap")?;
                let [x, gap] = [number(&mut largest, "x")?, number(&mut largest, "value")?];
                self.lift_off.push([ends[0], ends[1], x, gap]);
            } else {
                self.not_covered.extend(["from", "to"].map(|key| format!("lift_off.{key}")));
            }
            rest("lift_off", &stretch, &mut self.not_covered);
        }
        for mut hinge in elements(root, "hinges")? {
            let [at, rotation] = [number(&mut hinge, "at")?, number(&mut hinge, "rotation")?];
            self.hinges.push([at, rotation, number(&mut hinge, "moment")?]);
            rest("hinges", &hinge, &mut self.not_covered);
        }
        if let Some(ends) = root.remove("end_forces") {
            let mut ends = object(ends, "end_forces")?;
            self.end_forces = Some([number(&mut ends, "left")?, number(&mut ends, "right")?]);
            rest("end_forces", &ends, &mut self.not_covered);
        }
        Ok(())
    }

    fn extremes(&mut self, root: &mut Object) -> Result<(), JsonError> {
        let Some(extremes) = root.remove("extremes") else { return Ok(()) };
        for (field, ends) in object(extremes, "extremes")? {
            let mut ends = object(ends, &field)?;
            for (key, is_max) in [("min", false), ("max", true)] {
                let Some(extreme) = ends.remove(key) else { continue };
                let mut extreme = object(extreme, key)?;
                let (x, value) = (number(&mut extreme, "x")?, number(&mut extreme, "value")?);
                self.extremes.push(Extreme { field: field.clone(), is_max, x, value });
                rest(&format!("extremes.{field}"), &extreme, &mut self.not_covered);
            }
            rest(&format!("extremes.{field}"), &ends, &mut self.not_covered);
        }
        Ok(())
    }

    fn bounds(&mut self, root: &mut Object) -> Result<(), JsonError> {
        let Some(proof) = root.remove("proof") else { return Ok(()) };
        let mut proof = object(proof, "proof")?;
        if let Some(bounds) = proof.remove("bounds") {
            for (name, bound) in object(bounds, "bounds")? {
                let bounds = match bound {
                    Json::List(bounds) => bounds
                        .into_iter()
                        .map(|bound| claimed(bound, &name))
                        .collect::<Result<_, _>>()?,
                    bound => vec![claimed(bound, &name)?],
                };
                self.bounds.push((name, bounds));
            }
        }
        if let Some(places) = proof.remove("places") {
            for (field, ends) in object(places, "places")? {
                let mut ends = object(ends, &field)?;
                for (key, is_max) in [("min", false), ("max", true)] {
                    let Some(intervals) = ends.remove(key) else { continue };
                    let intervals = list(intervals, key)?.into_iter();
                    let intervals =
                        intervals.map(|both| two(both, key)).collect::<Result<_, _>>()?;
                    self.places.push((field.clone(), is_max, intervals));
                }
                rest(&format!("proof.places.{field}"), &ends, &mut self.not_covered);
            }
        }
        rest("proof", &proof, &mut self.not_covered);
        Ok(())
    }
}

impl Answer {
    /// Reads the answer from a document with one result.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`Document::read`], and an error if the document contains several results.
    pub fn from_json(text: &str) -> Result<Answer, JsonError> {
        let mut read = Document::read(text)?;
        match (read.pop(), read.len()) {
            (Some(document), 0) => Ok(document.answer),
            _ => wrong("the document must contain exactly one result"),
        }
    }
}

/// Reads one element of `pieces`. An unknown key is an error, because it may change the meaning of the other keys.
fn piece(mut piece: Object) -> Result<Piece, JsonError> {
    let x = pair(&mut piece, "x")?;
    let Some(x) = x else { return wrong("a piece has no `x`") };
    let touches = match piece.remove("touches") {
        Some(Json::Boolean(touches)) => touches,
        _ => return wrong("`touches` of a piece must be true or false"),
    };
    let read = Piece {
        x,
        half: number(&mut piece, "half")?,
        touches,
        deflection: coefficients(&mut piece, "deflection")?,
        rotation: coefficients(&mut piece, "rotation")?,
        pressure: coefficients(&mut piece, "pressure")?,
        open: pair(&mut piece, "open")?,
        settlement: coefficients(&mut piece, "settlement")?,
    };
    if read.deflection.is_empty() {
        return wrong("a piece has no `deflection`");
    }
    match piece.keys().next() {
        Some(key) => wrong(format!("`{key}` is not a key of a piece")),
        None => Ok(read),
    }
}

/// Returns a text that a document may contain in two places. Two different texts are an error.
fn agreed(
    own: Option<String>,
    other: &Option<String>,
    key: &str,
) -> Result<Option<String>, JsonError> {
    match (&own, other) {
        (Some(a), Some(b)) if a != b => {
            wrong(format!("the document gives two values of `{key}`, `{a}` and `{b}`"))
        }
        (None, Some(b)) => Ok(Some(b.clone())),
        _ => Ok(own),
    }
}

/// Adds to `not_covered` the names of the keys of an object whose values contain numbers. The keys that the proof
/// covers must have been removed from the object.
fn rest(path: &str, object: &Object, not_covered: &mut BTreeSet<String>) {
    for (key, _) in object.iter().filter(|(_, value)| value.has_number()) {
        let name = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        not_covered.insert(name);
    }
}

/// Reads an error bound that a document claims. The value `null` claims no bound, and is returned as infinity.
fn claimed(bound: Json, name: &str) -> Result<f64, JsonError> {
    match bound {
        Json::Number(bound) => Ok(bound),
        Json::Null => Ok(f64::INFINITY),
        _ => wrong(format!("`{name}` contains a value that is neither a number nor null")),
    }
}

/// Reads the index of a support, 0 or a positive whole number.
fn index(value: Json) -> Result<usize, JsonError> {
    match value {
        Json::Number(n) if (0.0..1e9).contains(&n) && n.fract() == 0.0 => Ok(n as usize),
        _ => wrong("`support` must be 0 or a positive whole number"),
    }
}

/// Reads the coefficients of a polynomial. Returns an empty list if the key is missing.
fn coefficients(parent: &mut Object, key: &str) -> Result<Vec<f64>, JsonError> {
    let read = numbers(parent, key)?.unwrap_or_default();
    if read.len() > MOST_COEFFICIENTS {
        return wrong(format!("`{key}` of a piece has a degree above 25"));
    }
    Ok(read)
}

/// Reads positions along the beam, and the values of the deflection, the moment and other quantities there. Returns an
/// empty list of positions if the key is missing.
fn stations(root: &mut Object, key: &str) -> Result<Stations, JsonError> {
    let Some(value) = root.remove(key) else { return Ok(Stations::default()) };
    let mut value = object(value, key)?;
    let x = numbers(&mut value, "x")?.unwrap_or_default();
    let mut fields = Vec::new();
    for (name, values) in value {
        let values = all_numbers(values, &name)?;
        if values.len() != x.len() {
            return wrong(format!("`{name}` of `{key}` must have one value for each `x`"));
        }
        fields.push((name, values));
    }
    Ok(Stations { x, fields })
}

mod tests;
