//! Sets of combinations of codes of practice: EN 1990 with annex A1 and recommended values, ASCE/SEI 7-16.
//!
//! Transcribed from tables A1.1 and A1.2 of EN 1990 and chapter 2 of ASCE 7. Superposition is not valid with lift-off. So
//! every subset of the variable cases is combined with every leading action and every factor of the permanent cases.

/// A load case and its action.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Acting<'a> {
    pub name: &'a str,
    pub action: &'a str,
    /// At most one case of a group is present at a time.
    pub group: Option<&'a str>,
    /// Permanent cases from the same source have the same factor.
    pub source: Option<&'a str>,
}

/// A combination of a set: its name, and the decimal factor of each case by its index.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Made {
    pub name: String,
    pub factors: Vec<(usize, String)>,
}

/// A factor in millionths, so that the product of two decimals with three places is an integer.
type Micro = i64;
const UNIT: Micro = 1_000_000;

/// Actions that may be present, each with its factor. At most one action of a list is present at a time.
type Term = &'static [(&'static str, Micro)];

/// An expression of a code: the actions and factors of its combinations.
struct Formula {
    label: &'static str,
    /// Permanent actions, each with the factors to be tried.
    always: &'static [(&'static str, &'static [Micro])],
    terms: &'static [Term],
    /// The factor of the leading action, and the index of the ψ that multiplies it.
    leading: Option<(Micro, Option<usize>)>,
    /// The factor of the accompanying actions, and the index of the ψ that multiplies it.
    accompanying: Option<(Micro, Option<usize>)>,
    /// Whether permanent cases from the same source may have different factors, as in the limit state EQU.
    by_parts: bool,
}

/// A set: its names, the actions of its code, and its expressions.
struct Set {
    names: &'static [&'static str],
    actions: &'static [(&'static str, Option<[Micro; 3]>)],
    formulas: &'static [Formula],
}

/// A factor given in thousandths.
const fn m(thousandths: Micro) -> Micro {
    thousandths * 1000
}

const fn psi(a: Micro, b: Micro, c: Micro) -> Option<[Micro; 3]> {
    Some([m(a), m(b), m(c)])
}

/// EN 1990, table A1.1: ψ₀, ψ₁, ψ₂.
const EUROPEAN: &[(&str, Option<[Micro; 3]>)] = &[
    ("permanent", None),
    ("imposed A", psi(700, 500, 300)),
    ("imposed B", psi(700, 500, 300)),
    ("imposed C", psi(700, 700, 600)),
    ("imposed D", psi(700, 700, 600)),
    ("imposed E", psi(1000, 900, 800)),
    ("imposed F", psi(700, 700, 600)),
    ("imposed G", psi(700, 500, 300)),
    ("imposed H", psi(0, 0, 0)),
    ("snow", psi(500, 200, 0)),
    ("snow above 1000 m", psi(700, 500, 200)),
    ("snow in the Nordic countries", psi(700, 500, 200)),
    ("wind", psi(600, 200, 0)),
    ("temperature", psi(600, 500, 0)),
];

const AMERICAN: &[(&str, Option<[Micro; 3]>)] = &[
    ("dead", None),
    ("fluid", None),
    ("soil", None),
    ("soil not permanent", None),
    ("live", None),
    ("roof live", None),
    ("snow", None),
    ("rain", None),
    ("wind", None),
    ("earthquake horizontal", None),
    ("earthquake vertical", None),
];

const fn european(
    label: &'static str,
    always: &'static [(&'static str, &'static [Micro])],
    leading: Option<(Micro, Option<usize>)>,
    accompanying: (Micro, Option<usize>),
) -> Formula {
    let accompanying = Some(accompanying);
    Formula { label, always, terms: &[], leading, accompanying, by_parts: false }
}

const fn american(
    label: &'static str,
    always: &'static [(&'static str, &'static [Micro])],
    terms: &'static [Term],
) -> Formula {
    Formula { label, always, terms, leading: None, accompanying: None, by_parts: false }
}

const ONE: &[(&str, &[Micro])] = &[("permanent", &[m(1000)])];
const SOIL: &[Micro] = &[m(1600), m(900)];
const SOIL_ASD: &[Micro] = &[m(1000), m(600)];
/// Factors of soil loads that are not permanent; 0 where they resist the other loads.
const PASSING: &[Micro] = &[m(1600), 0];
const PASSING_ASD: &[Micro] = &[m(1000), 0];
const LRFD_12: &[(&str, &[Micro])] =
    &[("dead", &[m(1200)]), ("fluid", &[m(1200)]), ("soil", SOIL), ("soil not permanent", PASSING)];
const ASD_1: &[(&str, &[Micro])] = &[
    ("dead", &[m(1000)]),
    ("fluid", &[m(1000)]),
    ("soil", SOIL_ASD),
    ("soil not permanent", PASSING_ASD),
];
const ROOF_HALF: Term = &[("roof live", m(500)), ("snow", m(500)), ("rain", m(500))];
const ROOF_FULL: Term = &[("roof live", m(1600)), ("snow", m(1600)), ("rain", m(1600))];
const ROOF_ONE: Term = &[("roof live", m(1000)), ("snow", m(1000)), ("rain", m(1000))];
const ROOF_MOST: Term = &[("roof live", m(750)), ("snow", m(750)), ("rain", m(750))];
const EH: Term = &[("earthquake horizontal", m(1000))];
const EV: Term = &[("earthquake vertical", m(1000))];
const LIFTS: Term = &[("earthquake vertical", m(-1000))];
const EH_ASD: Term = &[("earthquake horizontal", m(700))];
const EV_ASD: Term = &[("earthquake vertical", m(700))];
const LIFTS_ASD: Term = &[("earthquake vertical", m(-700))];
const EH_MOST: Term = &[("earthquake horizontal", m(525))];
const EV_MOST: Term = &[("earthquake vertical", m(525))];
const LIVE: Term = &[("live", m(1000))];
const LIVE_MOST: Term = &[("live", m(750))];

const SETS: &[Set] = &[
    Set {
        names: &["EN 1990 STR/GEO B", "EN 1990 6.10", "EN 1990 STR", "EN 1990 STR/GEO"],
        actions: EUROPEAN,
        formulas: &[european(
            "6.10",
            &[("permanent", &[m(1350), m(1000)])],
            Some((m(1500), None)),
            (m(1500), Some(0)),
        )],
    },
    Set {
        names: &["EN 1990 6.10a/b", "EN 1990 6.10ab"],
        actions: EUROPEAN,
        formulas: &[
            european("6.10a", &[("permanent", &[m(1350), m(1000)])], None, (m(1500), Some(0))),
            // 0.85 × 1.35
            european(
                "6.10b",
                &[("permanent", &[1_147_500, m(1000)])],
                Some((m(1500), None)),
                (m(1500), Some(0)),
            ),
        ],
    },
    Set {
        names: &["EN 1990 STR/GEO C", "EN 1990 6.10 set C"],
        actions: EUROPEAN,
        formulas: &[european("6.10 set C", ONE, Some((m(1300), None)), (m(1300), Some(0)))],
    },
    Set {
        names: &["EN 1990 EQU", "EN 1990 EQU A"],
        actions: EUROPEAN,
        formulas: &[Formula {
            by_parts: true,
            ..european(
                "EQU",
                &[("permanent", &[m(1100), m(900)])],
                Some((m(1500), None)),
                (m(1500), Some(0)),
            )
        }],
    },
    Set {
        names: &["EN 1990 characteristic", "EN 1990 SLS characteristic", "EN 1990 6.14"],
        actions: EUROPEAN,
        formulas: &[european("characteristic", ONE, Some((m(1000), None)), (m(1000), Some(0)))],
    },
    Set {
        names: &["EN 1990 frequent", "EN 1990 SLS frequent", "EN 1990 6.15"],
        actions: EUROPEAN,
        formulas: &[european("frequent", ONE, Some((m(1000), Some(1))), (m(1000), Some(2)))],
    },
    Set {
        names: &["EN 1990 quasi-permanent", "EN 1990 SLS quasi-permanent", "EN 1990 6.16"],
        actions: EUROPEAN,
        formulas: &[european("quasi-permanent", ONE, None, (m(1000), Some(2)))],
    },
    Set {
        names: &["ASCE 7-16 LRFD"],
        actions: AMERICAN,
        formulas: &[
            american(
                "LRFD 1",
                &[
                    ("dead", &[m(1400)]),
                    ("fluid", &[m(1400)]),
                    ("soil", SOIL),
                    ("soil not permanent", PASSING),
                ],
                &[],
            ),
            american("LRFD 2", LRFD_12, &[&[("live", m(1600))], ROOF_HALF]),
            american("LRFD 3", LRFD_12, &[ROOF_FULL, &[("live", m(1000)), ("wind", m(500))]]),
            american("LRFD 4", LRFD_12, &[&[("wind", m(1000))], LIVE, ROOF_HALF]),
            american(
                "LRFD 5",
                &[("dead", &[m(900)]), ("soil", SOIL), ("soil not permanent", PASSING)],
                &[&[("wind", m(1000))]],
            ),
            american("LRFD 6", LRFD_12, &[EH, EV, LIVE, &[("snow", m(200))]]),
            american(
                "LRFD 7",
                &[
                    ("dead", &[m(900)]),
                    ("fluid", &[m(900)]),
                    ("soil", SOIL),
                    ("soil not permanent", PASSING),
                ],
                &[EH, LIFTS],
            ),
        ],
    },
    Set {
        names: &["ASCE 7-16 ASD"],
        actions: AMERICAN,
        formulas: &[
            american("ASD 1", ASD_1, &[]),
            american("ASD 2", ASD_1, &[LIVE]),
            american("ASD 3", ASD_1, &[ROOF_ONE]),
            american("ASD 4", ASD_1, &[LIVE_MOST, ROOF_MOST]),
            american("ASD 5", ASD_1, &[&[("wind", m(600))]]),
            american("ASD 6", ASD_1, &[LIVE_MOST, &[("wind", m(450))], ROOF_MOST]),
            american(
                "ASD 7",
                &[("dead", &[m(600)]), ("soil", SOIL_ASD), ("soil not permanent", PASSING_ASD)],
                &[&[("wind", m(600))]],
            ),
            american("ASD 8", ASD_1, &[EH_ASD, EV_ASD]),
            american("ASD 9", ASD_1, &[EH_MOST, EV_MOST, LIVE_MOST, &[("snow", m(750))]]),
            american(
                "ASD 10",
                &[
                    ("dead", &[m(600)]),
                    ("fluid", &[m(600)]),
                    ("soil", SOIL_ASD),
                    ("soil not permanent", PASSING_ASD),
                ],
                &[EH_ASD, LIFTS_ASD],
            ),
        ],
    },
];

/// Whether this reader knows a set.
pub(crate) fn is_known(set: &str) -> bool {
    SETS.iter().any(|known| known.names.contains(&set))
}

/// The combinations of a set without duplicates, in the order of the set.
pub(crate) fn expand(set: &str, cases: &[Acting], most: usize) -> Result<Vec<Made>, &'static str> {
    let set = SETS.iter().find(|known| known.names.contains(&set));
    let set = set.ok_or("unknown set of combinations")?;
    let is_known = |case: &Acting| set.actions.iter().any(|(action, _)| *action == case.action);
    if !cases.iter().all(is_known) {
        return Err("the action of a load case does not belong to this code");
    }
    let (made, chosen, rows) = (Vec::new(), Vec::new(), Vec::new());
    let mut found = Expansion { cases, most, made, chosen, rows };
    for formula in set.formulas {
        for (must_lead, terms) in variable_terms(formula, set.actions, cases) {
            found.permanent(formula, &terms, must_lead, 0)?;
        }
    }
    let name = |(label, factors): (&str, Vec<(usize, Micro)>)| {
        let term = |(case, factor): &(usize, Micro)| match *factor {
            UNIT => cases[*case].name.to_owned(),
            factor => format!("{} {}", decimal(factor), cases[*case].name),
        };
        let sum: Vec<String> = factors.iter().map(term).collect();
        let factors = factors.into_iter().map(|(case, factor)| (case, decimal(factor))).collect();
        let sum = sum.join(" + ").replace("+ -1 ", "- ").replace("+ -", "- ");
        Made { name: format!("{label}: {sum}"), factors }
    };
    Ok(found.made.into_iter().map(name).collect())
}

/// A factor as a decimal without superfluous zeros.
fn decimal(factor: Micro) -> String {
    let sign = if factor < 0 { "-" } else { "" };
    let (whole, part) = (factor.abs() / UNIT, factor.abs() % UNIT);
    match format!("{part:06}").trim_end_matches('0') {
        "" => format!("{sign}{whole}"),
        part => format!("{sign}{whole}.{part}"),
    }
}

/// Lists of variable actions. At most one action of each list is present. If a combination has a leading
/// action, it is an action of the first list.
fn variable_terms(
    formula: &Formula,
    actions: &'static [(&'static str, Option<[Micro; 3]>)],
    cases: &[Acting],
) -> Vec<(bool, Vec<Vec<(&'static str, Micro)>>)> {
    let share = |share: Option<(Micro, Option<usize>)>, action: &'static str, psi: [Micro; 3]| {
        let (factor, which) = share?;
        let psi = which.map_or(UNIT, |i| psi.get(i).copied().unwrap_or(UNIT));
        Some(vec![(action, factor * psi / UNIT)])
    };
    let mut variable: Vec<(&'static str, [Micro; 3])> = Vec::new();
    for (action, psi) in actions {
        if let Some(psi) = psi
            && cases.iter().any(|case| case.action == *action)
        {
            variable.push((action, *psi));
        }
    }
    let others = |leader: Option<&str>| -> Vec<Vec<(&'static str, Micro)>> {
        let others = variable.iter().filter(|(action, _)| Some(*action) != leader);
        others.filter_map(|(action, psi)| share(formula.accompanying, action, *psi)).collect()
    };
    if formula.leading.is_none() {
        let written = formula.terms.iter().map(|term| term.to_vec());
        return vec![(false, written.chain(others(None)).collect())];
    }
    let leads = |(action, psi): &(&'static str, [Micro; 3])| {
        let leader = share(formula.leading, action, *psi);
        (true, leader.into_iter().chain(others(Some(action))).collect())
    };
    let mut all: Vec<_> = variable.iter().map(leads).collect();
    all.push((false, Vec::new()));
    all
}

struct Expansion<'a> {
    cases: &'a [Acting<'a>],
    most: usize,
    made: Vec<(&'static str, Vec<(usize, Micro)>)>,
    chosen: Vec<(usize, Micro)>,
    /// The source of each permanent case, and the index of its factor in the list of factors.
    rows: Vec<(Option<&'a str>, usize)>,
}

type Lists = [Vec<(&'static str, Micro)>];

impl Expansion<'_> {
    /// Tries each factor of each permanent case, from a given case on.
    fn permanent(
        &mut self,
        formula: &Formula,
        terms: &Lists,
        must_lead: bool,
        case: usize,
    ) -> Result<(), &'static str> {
        let Some(acting) = self.cases.get(case) else {
            return self.variable(formula.label, terms, must_lead);
        };
        let always = formula.always.iter().find(|(action, _)| *action == acting.action);
        let Some((_, factors)) = always else {
            return self.permanent(formula, terms, must_lead, case + 1);
        };
        let source = acting.source;
        let same = self.rows.iter().find(|(other, _)| source.is_some() && *other == source);
        let bound = same.filter(|_| !formula.by_parts).map(|(_, row)| *row);
        let last = factors.len().saturating_sub(1);
        for (row, factor) in factors.iter().enumerate() {
            if bound.is_some_and(|bound| row != bound.min(last)) {
                continue;
            }
            let before = self.chosen.len();
            self.chosen.extend((*factor != 0).then_some((case, *factor)));
            self.rows.push((source, row));
            self.permanent(formula, terms, must_lead, case + 1)?;
            self.rows.pop();
            self.chosen.truncate(before);
        }
        Ok(())
    }

    /// Tries each action of the first list, and also no action unless one must lead. Then continues with the
    /// other lists.
    fn variable(
        &mut self,
        label: &'static str,
        terms: &Lists,
        must_lead: bool,
    ) -> Result<(), &'static str> {
        let Some((term, rest)) = terms.split_first() else { return self.keep(label) };
        for (action, factor) in term.iter().filter(|(_, factor)| *factor != 0) {
            let acts = |i: &usize| self.cases[*i].action == *action;
            let of_it: Vec<usize> = (0..self.cases.len()).filter(acts).collect();
            self.subsets(label, &of_it, *factor, rest, self.chosen.len())?;
        }
        if must_lead { Ok(()) } else { self.variable(label, rest, false) }
    }

    /// Each non-empty subset of the cases of an action.
    fn subsets(
        &mut self,
        label: &'static str,
        of_it: &[usize],
        factor: Micro,
        rest: &Lists,
        before: usize,
    ) -> Result<(), &'static str> {
        let Some((case, others)) = of_it.split_first() else {
            let is_empty = self.chosen.len() == before;
            return if is_empty { Ok(()) } else { self.variable(label, rest, false) };
        };
        let group = self.cases[*case].group;
        let is_taken = |(other, _): &(usize, Micro)| self.cases[*other].group == group;
        if group.is_none() || !self.chosen.iter().any(is_taken) {
            self.chosen.push((*case, factor));
            self.subsets(label, others, factor, rest, before)?;
            self.chosen.pop();
        }
        self.subsets(label, others, factor, rest, before)
    }

    /// Stores the current combination unless it is a duplicate.
    fn keep(&mut self, label: &'static str) -> Result<(), &'static str> {
        let mut sorted = self.chosen.clone();
        sorted.sort_unstable();
        let is_same = |(_, other): &(&str, Vec<(usize, Micro)>)| {
            other.len() == sorted.len() && sorted.iter().all(|entry| other.contains(entry))
        };
        if sorted.is_empty() || self.made.iter().any(is_same) {
            return Ok(());
        }
        if self.made.len() == self.most {
            return Err("the file asks for more than 1000 combinations");
        }
        self.made.push((label, self.chosen.clone()));
        Ok(())
    }
}
