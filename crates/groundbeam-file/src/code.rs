//! Codes of all diagnostics, with their meanings and remedies; `docs/diagnostics.md` is generated from this table.

pub(crate) const SYNTAX: &str = "GB001";
pub(crate) const DUPLICATE: &str = "GB002";
pub(crate) const UNKNOWN_KEY: &str = "GB003";
pub(crate) const MISSING: &str = "GB004";
pub(crate) const WRONG_TYPE: &str = "GB005";
pub(crate) const EXCLUSIVE: &str = "GB006";
pub(crate) const INCOMPLETE: &str = "GB007";
pub(crate) const MISPLACED: &str = "GB008";
pub(crate) const UNKNOWN_WORD: &str = "GB009";
pub(crate) const CHORDS: &str = "GB502";
pub(crate) const TOO_MANY: &str = "GB010";
pub(crate) const NUMBER: &str = "GB011";
pub(crate) const NOT_FINITE: &str = "GB012";
pub(crate) const UNIT_SYNTAX: &str = "GB013";
pub(crate) const UNKNOWN_UNIT: &str = "GB014";
pub(crate) const WRONG_UNIT: &str = "GB015";
pub(crate) const MIXED: &str = "GB016";
pub(crate) const FACTOR: &str = "GB017";
pub(crate) const EMPTY: &str = "GB018";
pub(crate) const NOT_UTF8: &str = "GB019";
pub(crate) const EMPTY_NAME: &str = "GB020";
pub(crate) const REPEATED: &str = "GB021";
pub(crate) const FILE: &str = "GB022";
pub(crate) const COLUMN: &str = "GB023";
pub(crate) const POISSON: &str = "GB206";
pub(crate) const STRETCH: &str = "GB303";
pub(crate) const FIRST_AXLE: &str = "GB701";
pub(crate) const RANGE: &str = "GB801";
pub(crate) const IMPLAUSIBLE: &str = "GB901";
pub(crate) const NO_LOADS: &str = "GB902";

const FORMAT: Page = Page { title: "Model files", target: "file-format.md" };
const SMALLEST: Page =
    Page { title: "The smallest file", target: "file-format.md#the-smallest-file" };
const EDITOR: Page = Page { title: "In an editor", target: "file-format.md#in-an-editor" };
const UNITS: Page = Page { title: "Units", target: "file-format.md#units" };
const BEAM: Page = Page { title: "Beam", target: "file-format.md#beam" };
const SHEAR: Page = Page { title: "Shear", target: "file-format.md#shear" };
const BENDING: Page =
    Page { title: "Stiffness that varies", target: "file-format.md#stiffness-that-varies" };
const GROUND: Page = Page { title: "Ground", target: "file-format.md#ground" };
const OUTSIDE: Page = Page {
    title: "Ground that ends or changes beside the beam",
    target: "file-format.md#ground-that-ends-or-changes-beside-the-beam",
};
const VARYING: Page =
    Page { title: "Ground that varies", target: "file-format.md#ground-that-varies" };
const SOIL: Page = Page { title: "Ground from soil", target: "file-format.md#ground-from-soil" };
const LOADS: Page = Page { title: "Loads", target: "file-format.md#loads" };
const ON_GROUND: Page =
    Page { title: "Loads on the ground", target: "file-format.md#loads-on-the-ground" };
const SETS: Page = Page { title: "Sets", target: "combinations.md#sets" };
const SUPPORTS: Page = Page { title: "Supports", target: "file-format.md#supports" };
const HINGES: Page = Page { title: "Hinges", target: "file-format.md#hinges" };
const GAP: Page = Page { title: "Initial gap", target: "file-format.md#initial-gap" };
const SURVEY: Page = Page { title: "From a survey", target: "file-format.md#from-a-survey" };
const TROUGHS: Page =
    Page { title: "Settlement troughs", target: "file-format.md#settlement-troughs" };
const TRAINS: Page = Page { title: "Trains", target: "file-format.md#trains" };
const STUDIES: Page = Page { title: "The study file", target: "studies.md#the-study-file" };
const METHODS: Page =
    Page { title: "What each method supports", target: "methods.md#what-each-method-supports" };
const COMPRESSION: Page = Page { title: "Compression", target: "existence.md#compression-p--0" };
const LIMITS: Page =
    Page { title: "How accurate a mesh is", target: "methods.md#8-how-accurate-a-mesh-is" };

/// Section of the documentation that a diagnostic refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// Title of the section of the documentation.
    pub title: &'static str,
    /// Link to the section of the documentation, relative to the folder `docs/`.
    pub target: &'static str,
}

/// Code of a diagnostic, with its meaning and remedy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Code {
    /// Code of the diagnostic. `GB001` to `GB099` are faults in the text of the file. Codes from `GB101` on are
    /// faults of the model.
    pub code: &'static str,
    /// Rule that the file or the model breaks, or description of the fault.
    pub meaning: &'static str,
    /// Remedy for the user, in one or two sentences.
    pub remedy: &'static str,
    /// Section of the documentation that explains the subject of this diagnostic.
    pub page: Page,
    /// File in `cases/errors/` with this fault. `None` if the fault occurs only in a solve, in a study or in a model
    /// built in code.
    pub example: Option<&'static str>,
}

const fn row(
    code: &'static str,
    page: Page,
    example: &'static str,
    meaning: &'static str,
    remedy: &'static str,
) -> Code {
    Code { code, meaning, remedy, page, example: Some(example) }
}

const fn elsewhere(
    code: &'static str,
    page: Page,
    meaning: &'static str,
    remedy: &'static str,
) -> Code {
    Code { code, meaning, remedy, page, example: None }
}

/// All codes of diagnostics, in ascending order.
#[rustfmt::skip]
pub const CODES: &[Code] = &[
    row(SYNTAX, FORMAT, "syntax.toml",
        "the file is not valid TOML",
        "Correct the text at the marked position."),
    row(DUPLICATE, FORMAT, "duplicate.toml",
        "a key or table is given twice",
        "Keep only one of the two keys or tables. If the table may occur several times, write its heading in double brackets."),
    row(UNKNOWN_KEY, EDITOR, "unknown-key.toml",
        "a table contains a key or table that is not allowed in it",
        "Correct the spelling of the key, or move the key to the table to which it belongs."),
    row(MISSING, FORMAT, "missing.toml",
        "a required key or table is missing",
        "Add the missing key or table."),
    row(WRONG_TYPE, FORMAT, "wrong-type.toml",
        "a value or table is of the wrong type",
        "Write the value as the message shows."),
    row(EXCLUSIVE, FORMAT, "exclusive.toml",
        "two mutually exclusive keys are given",
        "Keep only one of the two keys."),
    row(INCOMPLETE, FORMAT, "incomplete.toml",
        "one of two keys that belong together is missing",
        "Add the missing key."),
    row(MISPLACED, LOADS, "misplaced.toml",
        "a key does not belong to this kind of load",
        "Remove the key, or change the kind of the load."),
    row(UNKNOWN_WORD, FORMAT, "unknown-word.toml",
        "a word is not one of the allowed words",
        "Write one of the words that the message lists."),
    row(TOO_MANY, SETS, "too-many-combinations.toml",
        "the file has too many combinations",
        "Put load cases that never act together into one `group`, or write the combinations with `factors`."),
    row(NUMBER, UNITS, "number.toml",
        "a number cannot be read",
        "Write a decimal number with a point, followed by its unit."),
    row(NOT_FINITE, UNITS, "not-finite.toml",
        "a number is infinite or NaN, or its magnitude is too large or too small",
        "Give 0 or a number with a magnitude between 1e-60 and 1e60."),
    row(UNIT_SYNTAX, UNITS, "unit-syntax.toml",
        "a unit cannot be read",
        "Write the unit as a product, quotient or power of known units, as in `kN/m^2`."),
    row(UNKNOWN_UNIT, UNITS, "unknown-unit.toml",
        "a unit is unknown",
        "Use a unit from the list of units in the documentation."),
    row(WRONG_UNIT, UNITS, "wrong-unit.toml",
        "a unit does not fit the quantity",
        "Use a unit that fits the quantity named in the message."),
    row(MIXED, UNITS, "mixed-units.toml",
        "some quantities have a unit and others do not",
        "Give all quantities of the file a unit, or none."),
    row(FACTOR, FORMAT, "factor.toml",
        "a number is outside the range that its key allows",
        "Give a number in the range that the message names."),
    row(EMPTY, SMALLEST, "empty.toml",
        "the file contains no model",
        "Add `[beam]` with `length` and `EI`, and `[foundation]` with `k`."),
    row(NOT_UTF8, FORMAT, "not-utf8.toml",
        "the file is not UTF-8 text",
        "Save the file as UTF-8 text."),
    row(EMPTY_NAME, FORMAT, "empty-name.toml",
        "a name is empty",
        "Write a name, or remove the key."),
    row(REPEATED, FORMAT, "repeated-name.toml",
        "two tables of one kind have the same name",
        "Give each table a different name."),
    row(FILE, SURVEY, "survey-missing.toml",
        "a file that the model names cannot be read",
        "Correct the name of the file, which is relative to the folder of the model file."),
    row(COLUMN, SURVEY, "survey-column.toml",
        "a column of a table is missing",
        "Add the column, or name an existing column."),
    row("GB101", BEAM, "beam-length.toml",
        "the beam's length must be positive",
        "Give a positive length."),
    row("GB102", BEAM, "bending-stiffness.toml",
        "the bending stiffness EI must be positive",
        "Give a positive bending stiffness."),
    elsewhere("GB103", BEAM,
        "the axial force must be a finite number",
        "Give a finite force, positive in tension, or remove the key."),
    row("GB104", SHEAR, "beam-shear.toml",
        "the shear stiffness of the beam must be positive",
        "Give a positive shear stiffness, or omit the shear stiffness for a beam without shear deformation."),
    row("GB201", GROUND, "foundation-spring.toml",
        "the spring constant k must be positive",
        "Give a positive k."),
    row("GB202", GROUND, "foundation-shear.toml",
        "the shear constant mu must be zero or positive",
        "Give a positive mu, or 0 for Winkler ground."),
    row("GB203", OUTSIDE, "foundation-off-beam.toml",
        "ground outside the beam cannot vary along a segment",
        "Divide the segment into segments with constant values."),
    row("GB204", VARYING, "ground-curve.toml",
        "a list of more than three values is given for k or mu",
        "Divide the segment, or give at most three values."),
    row("GB205", VARYING, "shear-fades.toml",
        "a varying shear constant mu must remain positive",
        "End the segment at a small positive mu, and add a segment with mu = 0."),
    row(POISSON, SOIL, "poisson.toml",
        "Poisson's ratio must lie between 0 and 0.5",
        "Give a number between 0 and 0.5."),
    row("GB207", OUTSIDE, "ground-end.toml",
        "the ground must not end under the beam",
        "Put the end of the ground outside the beam."),
    row("GB208", ON_GROUND, "ground-load.toml",
        "a load on the ground must lie where there is ground",
        "Move the load, or extend the ground."),
    row("GB209", ON_GROUND, "ground-load.toml",
        "a force at a point of the ground needs a shear layer",
        "Distribute the force over a length, or give the ground a positive mu."),
    row("GB210", ON_GROUND, "ground-load-varying.toml",
        "loads on the ground need ground that is uniform along each segment",
        "Divide the segment into segments with constant values."),
    row("GB211", ON_GROUND, "ground-load.toml",
        "a load on the ground must act downward",
        "Change the sign of the load. Downward loads are positive."),
    elsewhere("GB212", SOIL,
        "ground defined by soil data is uniform and infinite",
        "Remove the ground segments and the definitions of the ground's ends, or give k and mu in place of the soil data."),
    row("GB301", FORMAT, "off-the-beam.toml",
        "a position must lie on the beam",
        "Give a position between 0 and the length of the beam."),
    row("GB302", UNITS, "out-of-range.toml",
        "a value must be a finite number",
        "Give 0 or a number with a magnitude between 1e-60 and 1e60, in SI units."),
    row(STRETCH, FORMAT, "stretch-without-length.toml",
        "a stretch must have a positive length",
        "Give `to` a larger value than `from`."),
    row("GB304", BENDING, "overlap.toml",
        "segments may touch but not overlap",
        "Change the ends of one of the two segments."),
    row("GB402", SUPPORTS, "support-spring.toml",
        "a support's spring constant must be zero or positive",
        "Give zero or a positive number."),
    row("GB403", SUPPORTS, "two-supports.toml",
        "two supports must not share one position",
        "Give all restraints at this position in one support."),
    row("GB404", HINGES, "hinge-at-an-end.toml",
        "a hinge must be inside the beam",
        "Move the hinge to a position between the ends of the beam, or remove the hinge."),
    row("GB405", HINGES, "hinge-spring.toml",
        "a hinge's spring constant must be zero or positive",
        "Give zero for a free hinge, or a positive number."),
    row("GB406", HINGES, "two-hinges.toml",
        "two hinges must not share one position",
        "Remove one of the two hinges."),
    row("GB407", HINGES, "hinge-and-moment.toml",
        "a moment or rotational spring must not act at a hinge",
        "Move the moment or spring to the side of the hinge on which it acts."),
    row("GB408", SUPPORTS, "one-way-clamp.toml",
        "a one-way support must not restrain rotation",
        "Make the one-way support pinned, or give the support only a translational spring."),
    row("GB501", GAP, "gap-order.toml",
        "the points of the gap must be in order from left to right",
        "Sort the points by position, and give each point a different position."),
    row(CHORDS, TROUGHS, "trough-chords.toml",
        "too many chords are needed to approximate the curves of the settlement troughs",
        "Check the settlement, the loads and the stiffnesses, or give the gap as points."),
    elsewhere("GB604", METHODS,
        "the nodal method does not solve beams on supports that act in one direction only",
        "Use the method `exact` or `active-set`."),
    elsewhere("GB605", METHODS,
        "the nodal method does not solve the modified Vlasov model, whose ground constants depend on the solution",
        "Use the method `exact` or `active-set`, or give `k` and `mu`."),
    elsewhere("GB611", COMPRESSION,
        "only the method `exact` supports a compression above the buckling load of the beam without the ground",
        "Use the method `exact`."),
    elsewhere("GB612", COMPRESSION,
        "load factors cannot be computed for a compression above the buckling load of the beam without the ground",
        "Omit the load factors. The result then contains the critical compression."),
    elsewhere("GB616", LIMITS,
        "the solve would need too many elements: the deflection waves of a varying or shear-deformable beam are too short",
        "Increase the bending stiffness, or give constant stiffnesses and no shear stiffness."),
    elsewhere("GB617", LIMITS,
        "the solve would need more memory than the limit",
        "Raise the limit, as in `--memory-limit \"8 GB\"`, shorten the beam, or use fewer elements."),
    row(FIRST_AXLE, TRAINS, "first-axle.toml",
        "the first axle of a train must be at 0",
        "Give the positions of the other axles as positive distances behind the first axle."),
    elsewhere(RANGE, STUDIES,
        "a number in the study file is outside the allowed range",
        "Give a number in the range that the message names."),
    elsewhere(IMPLAUSIBLE, UNITS,
        "a warning: a quantity has an implausible size",
        "Check the number and the unit of the quantity. The model is solved unchanged."),
    elsewhere(NO_LOADS, LOADS,
        "a warning: the model has no loads",
        "Add a load, unless the beam is meant to have no load."),
];
