//! Load combinations of ASCE/SEI 7-16 and 7-22 as tables, transcribed from chapter 2: 2.3.1, 2.3.6, 2.4.1, 2.4.5.

use super::codes::{Code, Formula, Micro, PLAIN, Set, Term, m, other};

const fn of(
    label: &'static str,
    always: &'static [(&'static str, &'static [Micro])],
    terms: &'static [Term],
) -> Formula {
    Formula { label, always, terms, ..PLAIN }
}

type Always = &'static [(&'static str, &'static [Micro])];

const SOIL: &[Micro] = &[m(1600), m(900)];
const SOIL_ASD: &[Micro] = &[m(1000), m(600)];
/// Factors of soil loads that are not permanent. The factor is 0 where the soil load resists the other loads.
const PASSING: &[Micro] = &[m(1600), 0];
const PASSING_ASD: &[Micro] = &[m(1000), 0];

const LRFD_1: Always =
    &[("dead", &[m(1400)]), ("fluid", &[m(1400)]), ("soil", SOIL), ("soil not permanent", PASSING)];
const LRFD_2: Always =
    &[("dead", &[m(1200)]), ("fluid", &[m(1200)]), ("soil", SOIL), ("soil not permanent", PASSING)];
const LRFD_5: Always = &[("dead", &[m(900)]), ("soil", SOIL), ("soil not permanent", PASSING)];
const LRFD_7: Always =
    &[("dead", &[m(900)]), ("fluid", &[m(900)]), ("soil", SOIL), ("soil not permanent", PASSING)];
const ASD_1: Always = &[
    ("dead", &[m(1000)]),
    ("fluid", &[m(1000)]),
    ("soil", SOIL_ASD),
    ("soil not permanent", PASSING_ASD),
];
const ASD_7: Always =
    &[("dead", &[m(600)]), ("soil", SOIL_ASD), ("soil not permanent", PASSING_ASD)];
const ASD_10: Always = &[
    ("dead", &[m(600)]),
    ("fluid", &[m(600)]),
    ("soil", SOIL_ASD),
    ("soil not permanent", PASSING_ASD),
];

const LIVE: Term = &[("live", m(1000))];
const LIVE_LEADS: Term = &[("live", m(1600))];
const LIVE_MOST: Term = &[("live", m(750))];
const LIVE_OR_WIND: Term = &[("live", m(1000)), ("wind", m(500))];
const WIND: Term = &[("wind", m(1000))];
const WIND_ASD: Term = &[("wind", m(600))];
const WIND_MOST: Term = &[("wind", m(450))];
const STORM: Term = &[("wind", m(1000)), ("tornado", m(1000))];
const STORM_ASD: Term = &[("wind", m(600)), ("tornado", m(600))];
const EH: Term = &[("earthquake horizontal", m(1000))];
const EV: Term = &[("earthquake vertical", m(1000))];
const LIFTS: Term = &[("earthquake vertical", m(-1000))];
const EH_ASD: Term = &[("earthquake horizontal", m(700))];
const EV_ASD: Term = &[("earthquake vertical", m(700))];
const LIFTS_ASD: Term = &[("earthquake vertical", m(-700))];
const EH_MOST: Term = &[("earthquake horizontal", m(525))];
const EV_MOST: Term = &[("earthquake vertical", m(525))];

const ROOF_HALF: Term = &[("roof live", m(500)), ("snow", m(500)), ("rain", m(500))];
const ROOF_FULL: Term = &[("roof live", m(1600)), ("snow", m(1600)), ("rain", m(1600))];
const ROOF_ONE: Term = &[("roof live", m(1000)), ("snow", m(1000)), ("rain", m(1000))];
const ROOF_MOST: Term = &[("roof live", m(750)), ("snow", m(750)), ("rain", m(750))];
/// In the edition of 2022, the snow load is a strength-level load.
const ROOF_HALF_22: Term = &[("roof live", m(500)), ("snow", m(300)), ("rain", m(500))];
const ROOF_FULL_22: Term = &[("roof live", m(1600)), ("snow", m(1000)), ("rain", m(1600))];
const ROOF_ONE_22: Term = &[("roof live", m(1000)), ("snow", m(700)), ("rain", m(1000))];
const ROOF_MOST_22: Term = &[("roof live", m(750)), ("snow", m(525)), ("rain", m(750))];

pub(crate) const OF_2016: Code = Code {
    actions: &[
        other("dead"),
        other("fluid"),
        other("soil"),
        other("soil not permanent"),
        other("live"),
        other("roof live"),
        other("snow"),
        other("rain"),
        other("wind"),
        other("earthquake horizontal"),
        other("earthquake vertical"),
    ],
    sets: &[
        Set {
            names: &["ASCE 7-16 LRFD"],
            formulas: &[
                of("LRFD 1", LRFD_1, &[]),
                of("LRFD 2", LRFD_2, &[LIVE_LEADS, ROOF_HALF]),
                of("LRFD 3", LRFD_2, &[ROOF_FULL, LIVE_OR_WIND]),
                of("LRFD 4", LRFD_2, &[WIND, LIVE, ROOF_HALF]),
                of("LRFD 5", LRFD_5, &[WIND]),
                of("LRFD 6", LRFD_2, &[EH, EV, LIVE, &[("snow", m(200))]]),
                of("LRFD 7", LRFD_7, &[EH, LIFTS]),
            ],
        },
        Set {
            names: &["ASCE 7-16 ASD"],
            formulas: &[
                of("ASD 1", ASD_1, &[]),
                of("ASD 2", ASD_1, &[LIVE]),
                of("ASD 3", ASD_1, &[ROOF_ONE]),
                of("ASD 4", ASD_1, &[LIVE_MOST, ROOF_MOST]),
                of("ASD 5", ASD_1, &[WIND_ASD]),
                of("ASD 6", ASD_1, &[LIVE_MOST, WIND_MOST, ROOF_MOST]),
                of("ASD 7", ASD_7, &[WIND_ASD]),
                of("ASD 8", ASD_1, &[EH_ASD, EV_ASD]),
                of("ASD 9", ASD_1, &[EH_MOST, EV_MOST, LIVE_MOST, &[("snow", m(750))]]),
                of("ASD 10", ASD_10, &[EH_ASD, LIFTS_ASD]),
            ],
        },
    ],
};

pub(crate) const OF_2022: Code = Code {
    actions: &[
        other("dead"),
        other("fluid"),
        other("soil"),
        other("soil not permanent"),
        other("live"),
        other("roof live"),
        other("snow"),
        other("rain"),
        other("wind"),
        other("tornado"),
        other("earthquake horizontal"),
        other("earthquake vertical"),
    ],
    sets: &[
        Set {
            names: &["ASCE 7-22 LRFD"],
            formulas: &[
                of("LRFD 1a", LRFD_1, &[]),
                of("LRFD 2a", LRFD_2, &[LIVE_LEADS, ROOF_HALF_22]),
                of("LRFD 3a", LRFD_2, &[ROOF_FULL_22, LIVE_OR_WIND]),
                of("LRFD 4a", LRFD_2, &[STORM, LIVE, ROOF_HALF_22]),
                of("LRFD 5a", LRFD_5, &[STORM]),
                of("LRFD 6", LRFD_2, &[EH, EV, LIVE, &[("snow", m(150))]]),
                of("LRFD 7", LRFD_7, &[EH, LIFTS]),
            ],
        },
        Set {
            names: &["ASCE 7-22 ASD"],
            formulas: &[
                of("ASD 1a", ASD_1, &[]),
                of("ASD 2a", ASD_1, &[LIVE]),
                of("ASD 3a", ASD_1, &[ROOF_ONE_22]),
                of("ASD 4a", ASD_1, &[LIVE_MOST, ROOF_MOST_22]),
                of("ASD 5a", ASD_1, &[STORM_ASD]),
                of("ASD 6a", ASD_1, &[LIVE_MOST, WIND_MOST, ROOF_MOST_22]),
                of("ASD 7a", ASD_7, &[STORM_ASD]),
                of("ASD 8", ASD_1, &[EH_ASD, EV_ASD]),
                of("ASD 9", ASD_1, &[EH_MOST, EV_MOST, LIVE_MOST, &[("snow", m(100))]]),
                of("ASD 10", ASD_10, &[EH_ASD, LIFTS_ASD]),
            ],
        },
    ],
};
