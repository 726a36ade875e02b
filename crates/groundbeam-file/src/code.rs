//! Codes of all diagnostics and their meanings; `docs/diagnostics.md` is generated from this table.

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

/// One row of the table of codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Code {
    /// `GB001` to `GB099`: faults in the text of the file. From `GB101` on: faults of the model.
    pub code: &'static str,
    /// The rule that the file or model breaks.
    pub meaning: &'static str,
    /// A file in `cases/errors/` with this fault. `None` if only a solve, a study or a model built in code
    /// has it.
    pub example: Option<&'static str>,
}

const fn row(code: &'static str, meaning: &'static str, example: &'static str) -> Code {
    Code { code, meaning, example: Some(example) }
}

const fn elsewhere(code: &'static str, meaning: &'static str) -> Code {
    Code { code, meaning, example: None }
}

/// Every code, in ascending order.
pub const CODES: &[Code] = &[
    row(SYNTAX, "the file is not valid TOML", "syntax.toml"),
    row(DUPLICATE, "a key or table is given twice", "duplicate.toml"),
    row(UNKNOWN_KEY, "a key or table is not known here", "unknown-key.toml"),
    row(MISSING, "a required key or table is missing", "missing.toml"),
    row(WRONG_TYPE, "a value or table is of the wrong type", "wrong-type.toml"),
    row(EXCLUSIVE, "two keys exclude each other", "exclusive.toml"),
    row(INCOMPLETE, "one of two keys that belong together is missing", "incomplete.toml"),
    row(MISPLACED, "a key belongs to another kind of load", "misplaced.toml"),
    row(UNKNOWN_WORD, "a word is not one of the allowed words", "unknown-word.toml"),
    row(TOO_MANY, "the file has too many combinations", "too-many-combinations.toml"),
    row(NUMBER, "a number cannot be read", "number.toml"),
    row(NOT_FINITE, "a number is not finite, too large or too small", "not-finite.toml"),
    row(UNIT_SYNTAX, "a unit cannot be read", "unit-syntax.toml"),
    row(UNKNOWN_UNIT, "a unit is not known", "unknown-unit.toml"),
    row(WRONG_UNIT, "a unit is of the wrong kind", "wrong-unit.toml"),
    row(MIXED, "some quantities have a unit and others do not", "mixed-units.toml"),
    row(FACTOR, "a factor of a stiffness must be positive", "factor.toml"),
    row(EMPTY, "the file contains no model", "empty.toml"),
    row(NOT_UTF8, "the file is not UTF-8 text", "not-utf8.toml"),
    row(EMPTY_NAME, "a name is empty", "empty-name.toml"),
    row(REPEATED, "two tables of one kind have the same name", "repeated-name.toml"),
    row(FILE, "a file that the model names cannot be read", "survey-missing.toml"),
    row(COLUMN, "a column of a table is missing", "survey-column.toml"),
    row("GB101", "the beam's length must be positive", "beam-length.toml"),
    row("GB102", "the bending stiffness EI must be positive", "bending-stiffness.toml"),
    elsewhere("GB103", "the axial force must be a finite number"),
    row("GB104", "the shear stiffness of the beam must be positive", "beam-shear.toml"),
    row("GB201", "the spring constant k must be positive", "foundation-spring.toml"),
    row("GB202", "the shear constant mu must be zero or positive", "foundation-shear.toml"),
    row("GB203", "ground outside the beam cannot vary along a segment", "foundation-off-beam.toml"),
    row("GB204", "a curve of k or mu has at most three control values", "ground-curve.toml"),
    row("GB205", "a varying shear constant mu must remain positive", "shear-fades.toml"),
    row(POISSON, "Poisson's ratio lies between 0 and 0.5", "poisson.toml"),
    row("GB207", "the ground ends beyond the beam's ends", "ground-end.toml"),
    row("GB208", "a load on the ground must lie where there is ground", "ground-load.toml"),
    row("GB209", "a force at a point of the ground needs a shear layer", "ground-load.toml"),
    row(
        "GB210",
        "loads on the ground need ground that is uniform along each segment",
        "ground-load-varying.toml",
    ),
    row("GB211", "a load on the ground must act downward", "ground-load.toml"),
    elsewhere("GB212", "ground defined by soil data is uniform and infinite"),
    row("GB301", "a position must lie on the beam", "off-the-beam.toml"),
    row("GB302", "a value must be a finite number", "out-of-range.toml"),
    row(STRETCH, "a stretch must have a positive length", "stretch-without-length.toml"),
    row("GB304", "segments may touch but not overlap", "overlap.toml"),
    row("GB402", "a support's spring constant must be zero or positive", "support-spring.toml"),
    row("GB403", "two supports must not share one position", "two-supports.toml"),
    row("GB404", "a hinge must be inside the beam", "hinge-at-an-end.toml"),
    row("GB405", "a hinge's spring constant must be zero or positive", "hinge-spring.toml"),
    row("GB406", "two hinges must not share one position", "two-hinges.toml"),
    row("GB407", "a moment or rotational spring must not act at a hinge", "hinge-and-moment.toml"),
    row("GB408", "only a force can act in a single direction", "one-way-clamp.toml"),
    row("GB501", "the points of the gap must be in order from left to right", "gap-order.toml"),
    row(CHORDS, "settlement troughs need too many chords", "trough-chords.toml"),
    elsewhere("GB603", "concentrated pressures need a shear layer"),
    elsewhere("GB604", "the nodal method applies to beams without supports"),
    elsewhere("GB605", "the nodal method applies to constant segments"),
    elsewhere("GB606", "the nodal method applies to beams without hinges"),
    elsewhere("GB607", "the paper's iteration applies to beams without hinges"),
    elsewhere("GB609", "loads on the ground need the methods `exact` or `active-set`"),
    elsewhere("GB611", "a local equilibrium needs the method `exact`"),
    elsewhere("GB612", "load factors of a local equilibrium"),
    elsewhere("GB614", "a beam with shear deformation needs the methods `exact` or `active-set`"),
    elsewhere("GB616", "a varying or shear-deformable beam must not have too many waves"),
    elsewhere("GB617", "a solve must not need more memory than the limit"),
    row(FIRST_AXLE, "a train is measured backward from its first axle", "first-axle.toml"),
    elsewhere(RANGE, "a number of a study is outside its range"),
    elsewhere(IMPLAUSIBLE, "a warning: a quantity has an implausible size"),
    elsewhere(NO_LOADS, "a warning: the model has no loads"),
];
