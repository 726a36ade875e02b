//! Load combinations of EN 1990 as tables, from annexes A1 (A1.1 to A1.4) and A2 (A2.1 to A2.6) and the UK national annex.

use super::codes::{Action, Code, Formula, Gammas, Micro, PLAIN, Psi, Set, m, other};

const fn permanent(name: &'static str, gammas: Gammas) -> Action {
    Action { name, psi: None, gammas, is_permanent: true }
}

/// A variable action. The arguments a, b and c are the combination factors ψ₀, ψ₁ and ψ₂ in thousandths.
const fn variable(name: &'static str, [a, b, c]: [Micro; 3], gammas: Gammas) -> Action {
    Action { name, psi: Some([m(a), m(b), m(c)]), gammas, is_permanent: false }
}

/// Expression (6.10). The leading action has the factor γ, and the accompanying actions have the factor γψ₀.
const fn fundamental(label: &'static str, letter: &'static str) -> Formula {
    let (leading, accompanying) = (Some(None), Some(Some(0)));
    Formula { label, letter: Some(letter), leading, accompanying, ..PLAIN }
}

/// An expression with partial factors of 1 and with the given ψ of the leading and of the accompanying actions.
const fn ones(label: &'static str, leading: Option<Psi>, accompanying: usize) -> Formula {
    Formula { label, leading, accompanying: Some(Some(accompanying)), ..PLAIN }
}

const fn set(names: &'static [&'static str], formulas: &'static [Formula]) -> Set {
    Set { names, formulas }
}

/// Partial factors of table A1.2. The letter A stands for the limit state EQU, and A2 for the alternative in note 2
/// to EQU.
const DEAD: Gammas = &[
    ("A", &[m(1100), m(900)]),
    ("A2", &[m(1350), m(1150)]),
    ("B", &[m(1350), m(1000)]),
    ("C", &[m(1000)]),
];
const LIVE: Gammas = &[("A", &[m(1500)]), ("A2", &[m(1500)]), ("B", &[m(1500)]), ("C", &[m(1300)])];

pub(crate) const BUILDINGS: Code = Code {
    actions: &[
        permanent("permanent", DEAD),
        variable("imposed A", [700, 500, 300], LIVE),
        variable("imposed B", [700, 500, 300], LIVE),
        variable("imposed C", [700, 700, 600], LIVE),
        variable("imposed D", [700, 700, 600], LIVE),
        variable("imposed E", [1000, 900, 800], LIVE),
        variable("imposed F", [700, 700, 600], LIVE),
        variable("imposed G", [700, 500, 300], LIVE),
        variable("imposed H", [0, 0, 0], LIVE),
        variable("snow", [500, 200, 0], LIVE),
        variable("snow above 1000 m", [700, 500, 200], LIVE),
        variable("snow in the Nordic countries", [700, 500, 200], LIVE),
        variable("wind", [600, 200, 0], LIVE),
        variable("temperature", [600, 500, 0], LIVE),
        other("accidental"),
        other("seismic"),
    ],
    sets: &[
        set(
            &["EN 1990 STR/GEO B", "EN 1990 6.10", "EN 1990 STR", "EN 1990 STR/GEO"],
            &[fundamental("6.10", "B")],
        ),
        set(
            &["EN 1990 6.10a/b", "EN 1990 6.10ab"],
            &[
                Formula { leading: None, ..fundamental("6.10a", "B") },
                Formula { xi: m(850), ..fundamental("6.10b", "B") },
            ],
        ),
        set(&["EN 1990 STR/GEO C", "EN 1990 6.10 set C"], &[fundamental("6.10 set C", "C")]),
        set(
            &["EN 1990 EQU", "EN 1990 EQU A"],
            &[Formula { by_parts: true, ..fundamental("EQU", "A") }],
        ),
        set(
            &["EN 1990 EQU with strength"],
            &[
                Formula { by_parts: true, ..fundamental("EQU", "A2") },
                Formula {
                    by_parts: true,
                    always: &[("permanent", &[m(1000)])],
                    ..fundamental("EQU", "A2")
                },
            ],
        ),
        set(
            &["EN 1990 accidental psi1", "EN 1990 6.11b psi1"],
            &[Formula { terms: &[&[("accidental", m(1000))]], ..ones("6.11b", Some(Some(1)), 2) }],
        ),
        set(
            &["EN 1990 accidental psi2", "EN 1990 6.11b psi2"],
            &[Formula { terms: &[&[("accidental", m(1000))]], ..ones("6.11b", Some(Some(2)), 2) }],
        ),
        set(
            &["EN 1990 seismic", "EN 1990 6.12b"],
            &[Formula {
                terms: &[&[("seismic", m(1000))]],
                needs_first: true,
                ..ones("6.12b", None, 2)
            }],
        ),
        set(
            &["EN 1990 characteristic", "EN 1990 SLS characteristic", "EN 1990 6.14"],
            &[ones("characteristic", Some(None), 0)],
        ),
        set(
            &["EN 1990 frequent", "EN 1990 SLS frequent", "EN 1990 6.15"],
            &[ones("frequent", Some(Some(1)), 2)],
        ),
        set(
            &["EN 1990 quasi-permanent", "EN 1990 SLS quasi-permanent", "EN 1990 6.16"],
            &[ones("quasi-permanent", None, 2)],
        ),
    ],
};

pub(crate) const BRITISH_BUILDINGS: Code = Code {
    actions: &[
        permanent("permanent", DEAD),
        variable("imposed A", [700, 500, 300], LIVE),
        variable("imposed B", [700, 500, 300], LIVE),
        variable("imposed C", [700, 700, 600], LIVE),
        variable("imposed D", [700, 700, 600], LIVE),
        variable("imposed E", [1000, 900, 800], LIVE),
        variable("imposed F", [700, 700, 600], LIVE),
        variable("imposed G", [700, 500, 300], LIVE),
        variable("imposed H", [700, 0, 0], LIVE),
        variable("snow", [500, 200, 0], LIVE),
        variable("snow above 1000 m", [700, 500, 200], LIVE),
        variable("wind", [500, 200, 0], LIVE),
        variable("temperature", [600, 500, 0], LIVE),
    ],
    sets: &[
        set(&["BS EN 1990 STR/GEO B", "BS EN 1990 6.10"], &[fundamental("6.10", "B")]),
        set(
            &["BS EN 1990 6.10a/b"],
            &[
                Formula { leading: None, ..fundamental("6.10a", "B") },
                Formula { xi: m(925), ..fundamental("6.10b", "B") },
            ],
        ),
        set(
            &["BS EN 1990 characteristic", "BS EN 1990 SLS characteristic", "BS EN 1990 6.14"],
            &[ones("characteristic", Some(None), 0)],
        ),
        set(
            &["BS EN 1990 frequent", "BS EN 1990 SLS frequent", "BS EN 1990 6.15"],
            &[ones("frequent", Some(Some(1)), 2)],
        ),
        set(
            &["BS EN 1990 quasi-permanent", "BS EN 1990 SLS quasi-permanent", "BS EN 1990 6.16"],
            &[ones("quasi-permanent", None, 2)],
        ),
    ],
};

/// Partial factors of EN 1990, tables A2.4(B) and A2.4(C): `ROAD` for road traffic, `OTHER` for other variable actions.
const ROAD: Gammas = &[("B", &[m(1350)]), ("C", &[m(1150)])];
const OTHER: Gammas = &[("B", &[m(1500)]), ("C", &[m(1300)])];
/// Partial factors of settlements, for linear and for non-linear analysis. The factor is 0 where a settlement is
/// favourable.
const LINEAR: Gammas = &[("B", &[m(1200), 0]), ("C", &[m(1000), 0])];
const NON_LINEAR: Gammas = &[("B", &[m(1350), 0]), ("C", &[m(1000), 0])];

pub(crate) const BRIDGES: Code = Code {
    actions: &[
        permanent("permanent", &[("B", &[m(1350), m(1000)]), ("C", &[m(1000)])]),
        permanent("settlement linear", LINEAR),
        permanent("settlement non-linear", NON_LINEAR),
        variable("road gr1a TS", [750, 750, 0], ROAD),
        variable("road gr1a UDL", [400, 400, 0], ROAD),
        variable("road gr1a footway", [400, 400, 0], ROAD),
        variable("road gr1b", [0, 750, 0], ROAD),
        variable("road gr2", [0, 0, 0], ROAD),
        variable("road gr3", [0, 0, 0], ROAD),
        variable("rail LM71 or SW/0", [800, 800, 0], &[("B", &[m(1450)])]),
        variable("wind on a bridge", [600, 200, 0], OTHER),
        variable("wind during execution", [800, 0, 0], OTHER),
        variable("temperature of a bridge", [600, 600, 500], OTHER),
        variable("snow during execution", [800, 0, 0], OTHER),
        variable("construction loads", [1000, 0, 1000], OTHER),
    ],
    sets: &[
        set(&["EN 1990 A2 STR/GEO B", "EN 1990 A2 6.10"], &[fundamental("bridge B", "B")]),
        set(&["EN 1990 A2 STR/GEO C"], &[fundamental("bridge C", "C")]),
        set(&["EN 1990 A2 characteristic"], &[ones("bridge characteristic", Some(None), 0)]),
        set(&["EN 1990 A2 frequent"], &[ones("bridge frequent", Some(Some(1)), 2)]),
        set(&["EN 1990 A2 quasi-permanent"], &[ones("bridge quasi-permanent", None, 2)]),
    ],
};

const BRITISH_WIND: Gammas = &[("B", &[m(1700)]), ("C", &[m(1450)])];
const BRITISH_HEAT: Gammas = &[("B", &[m(1550)]), ("C", &[m(1300)])];

pub(crate) const BRITISH_BRIDGES: Code = Code {
    actions: &[
        permanent("permanent concrete", &[("B", &[m(1350), m(950)]), ("C", &[m(1000)])]),
        permanent("permanent superimposed", &[("B", &[m(1200), m(950)]), ("C", &[m(1000)])]),
        permanent("settlement linear", LINEAR),
        permanent("settlement non-linear", NON_LINEAR),
        variable("road gr1a TS", [750, 750, 0], ROAD),
        variable("road gr1a UDL", [750, 750, 0], ROAD),
        variable("road gr1a footway", [400, 400, 0], ROAD),
        variable("road gr1b", [0, 750, 0], ROAD),
        variable("road gr2", [0, 0, 0], ROAD),
        variable("road gr3", [0, 400, 0], ROAD),
        variable("wind on a bridge", [500, 200, 0], BRITISH_WIND),
        variable("wind during execution", [800, 0, 0], BRITISH_WIND),
        variable("temperature of a bridge", [600, 600, 500], BRITISH_HEAT),
        variable("snow during execution", [800, 0, 0], OTHER),
        variable("construction loads", [1000, 0, 1000], OTHER),
    ],
    sets: &[
        set(&["BS EN 1990 A2 STR/GEO B", "BS EN 1990 A2 6.10"], &[fundamental("bridge B", "B")]),
        set(&["BS EN 1990 A2 STR/GEO C"], &[fundamental("bridge C", "C")]),
        set(&["BS EN 1990 A2 characteristic"], &[ones("bridge characteristic", Some(None), 0)]),
        set(&["BS EN 1990 A2 frequent"], &[ones("bridge frequent", Some(Some(1)), 2)]),
        set(&["BS EN 1990 A2 quasi-permanent"], &[ones("bridge quasi-permanent", None, 2)]),
    ],
};
