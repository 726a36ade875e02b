//! Properties of every text and every model.

use crate::common::well_placed;
use groundbeam::model::{Part, Problem};
use groundbeam::{
    Beam, Foundation, Hinge, Load, Model, Support, SupportKind,
    model::{Action, Acts, Profile},
};
use groundbeam_file::{UnitSystem, parse, parse_positions, text_of, write_toml};
use proptest::prelude::*;

fn never_panics(text: &str) {
    match parse(text) {
        Ok(document) => assert_eq!(document.model.problems(), []),
        Err(diagnostics) => well_placed(&diagnostics, text),
    }
}

/// Coordinates from 0 to `length`, ascending, the ends included.
fn joints(length: f64) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.01..0.99_f64, 0..4).prop_map(move |mut inner| {
        inner.sort_by(f64::total_cmp);
        inner.dedup();
        let inner = inner.into_iter().map(|x| x * length);
        std::iter::once(0.0).chain(inner).chain([length]).collect()
    })
}

fn size() -> impl Strategy<Value = f64> {
    (1.0..10.0_f64, -12..12_i32).prop_map(|(digits, power)| digits * 10_f64.powi(power))
}

fn value() -> impl Strategy<Value = f64> {
    prop_oneof![4 => size(), 4 => size().prop_map(|x| -x), 1 => Just(0.0), 1 => Just(-0.0)]
}

fn load(length: f64) -> impl Strategy<Value = Load> {
    let place = (0.0..=1.0_f64).prop_map(move |x| x * length);
    let stretch = (0.0..0.5_f64, 0.6..=1.0_f64).prop_map(move |(a, b)| (a * length, b * length));
    prop_oneof![
        (value(), place.clone()).prop_map(|(force, at)| Load::point_force(at, force)),
        (value(), place).prop_map(|(moment, at)| Load::point_moment(at, moment)),
        (value(), value(), stretch.clone())
            .prop_map(|(start, end, (from, to))| { Load::distributed_force(from, to, start, end) }),
        (value(), value(), stretch.clone()).prop_map(|(start, end, (from, to))| {
            Load::distributed_moment(from, to, start, end)
        }),
        (value(), value(), stretch).prop_map(|(start, end, (from, to))| {
            Load::distributed_curvature(from, to, start, end)
        }),
    ]
}

/// Constant or by control values.
fn profile(most: usize) -> impl Strategy<Value = Profile> {
    prop::collection::vec(size(), 1..=most)
        .prop_map(|values| Profile::by_control_values(&values).expect("not too many"))
}

fn model() -> impl Strategy<Value = Model> {
    size().prop_flat_map(|length| {
        let beam = (joints(length), prop::collection::vec(profile(6), 5), size(), value());
        let ground = (joints(length), prop::collection::vec((profile(3), profile(3)), 5), size());
        let loads = prop::collection::vec(load(length), 0..5);
        let supports = (joints(length), prop::collection::vec((0..3, size(), size()), 0..3));
        let gap = (joints(length), prop::collection::vec(value(), 0..5));
        (beam, ground, loads, supports, gap, joints(length)).prop_map(
            move |(beam, ground, loads, held, gap, hinges)| {
                let (joints, stiffness, ei, axial_force) = beam;
                let mut beam = Beam::uniform(length, ei).with_axial_force(axial_force);
                for (ends, ei) in joints.windows(2).skip(1).zip(stiffness) {
                    beam = beam.with_varying_segment(ends[0], ends[1], ei);
                }
                let (joints, constants, k) = ground;
                let mut foundation = Foundation::winkler(k);
                for (ends, (k, mu)) in joints.windows(2).skip(1).zip(constants) {
                    foundation = foundation.with_varying_segment(ends[0], ends[1], k, mu);
                }
                let mut model = Model { loads, ..Model::new(beam, foundation) };
                for (at, (kind, spring, rotational)) in held.0.into_iter().zip(held.1) {
                    model = model.with_support(match kind {
                        0 => Support::pinned(at),
                        1 => Support::fixed(at),
                        _ => Support::spring(at, spring, rotational).settled(0.01 * spring.sin()),
                    });
                }
                for (i, support) in model.supports.iter_mut().enumerate() {
                    if support.kind == SupportKind::Pinned {
                        support.acts = [Acts::Both, Acts::Up, Acts::Down][i % 3];
                    }
                }
                for (i, at) in hinges.into_iter().enumerate() {
                    let turns = |s: &Support| s.at == at && s.kind != SupportKind::Pinned;
                    let free = model
                        .loads
                        .iter()
                        .all(|load| load.at_point(Action::Moment).is_none_or(|(x, _)| x != at));
                    if at > 0.0
                        && at < model.beam.length
                        && free
                        && !model.supports.iter().any(turns)
                    {
                        let spring = if i == 0 { 0.0 } else { model.beam.bending_stiffness };
                        model = model.with_hinge(Hinge::elastic(at, spring));
                    }
                }
                for (at, value) in gap.0.into_iter().zip(gap.1) {
                    model = model.with_gap(at, value);
                }
                model
            },
        )
    })
}

fn units() -> impl Strategy<Value = UnitSystem> {
    prop_oneof![Just(UnitSystem::Si), Just(UnitSystem::Plain)]
}

/// A piece of a model file, so that random texts get past the first line.
const PIECES: &[&str] = &[
    "[beam]",
    "[foundation]",
    "[[load]]",
    "[[support]]",
    "[[hinge]]",
    "[[gap]]",
    "[[beam.segment]]",
    "[[foundation.segment]]",
    "[[case]]",
    "[[combination]]",
    "name",
    "action",
    "factors",
    "set",
    "\"EN 1990 6.10\"",
    "\"imposed B\"",
    "[load]",
    "[[beam]]",
    "beam",
    "length",
    "EI",
    "E",
    "I",
    "section",
    "k",
    "mu",
    "width",
    "subgrade_modulus",
    "point",
    "moment",
    "distributed",
    "at",
    "from",
    "to",
    "type",
    "spring",
    "value",
    "case",
    "title",
    " = ",
    "=",
    "\n",
    "\r\n",
    "\"",
    "'",
    "\"\"\"",
    "{",
    "}",
    "[",
    "]",
    ",",
    ".",
    "12",
    "\"12 m\"",
    "\"3 kN\"",
    "\"1e6 kN m^2\"",
    "\"5 MN/m²\"",
    "\"pinned\"",
    "1e400",
    "nan",
    "-inf",
    "0xff",
    "true",
    "1979-05-27",
    "#",
    "\t",
    "\\u00b3",
    "½",
    "\u{feff}",
    "梁",
    "\u{0}",
    "\u{301}",
    "\u{200b}",
    "\r",
];

fn pieces() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(PIECES), 0..60).prop_map(|pieces| pieces.concat())
}

const UNIT_PIECES: &[&str] = &[
    "k",
    "M",
    "m",
    "N",
    "Pa",
    "rad",
    "deg",
    "in",
    "ft",
    "lbf",
    "kip",
    "psi",
    "tf",
    "kNm",
    " ",
    "/",
    "^",
    "**",
    "*",
    "·",
    "-",
    "−",
    ".",
    "(",
    ")",
    "2",
    "²",
    "⁻",
    "12",
    "999999999999",
    "½",
    "°",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_bytes_are_read_without_panic(bytes: Vec<u8>) {
        let text = String::from_utf8_lossy(&bytes);
        match text_of(&bytes) {
            Ok(text) => never_panics(text),
            Err(diagnostics) => well_placed(&diagnostics, &text),
        }
    }

    #[test]
    fn any_text_is_read_without_panic(text in any::<String>()) {
        never_panics(&text);
    }

    #[test]
    fn any_mixture_of_pieces_is_read_without_panic(text in pieces()) {
        never_panics(&text);
    }

    #[test]
    fn any_unit_is_read_without_panic(
        number in "[-+−]?[0-9]{0,25}[.,]?[0-9]{0,25}([eE][-+]?[0-9]{1,12})?",
        unit in prop::collection::vec(prop::sample::select(UNIT_PIECES), 0..12),
    ) {
        let quantity = format!("{number} {}", unit.concat());
        never_panics(&format!("[beam]\nlength = \"{quantity}\"\nEI = '{quantity}'\n"));
        if let Err(diagnostics) = parse_positions(&quantity, UnitSystem::Si) {
            well_placed(&diagnostics, &quantity);
        }
    }

    #[test]
    fn a_written_model_is_read_back_bit_for_bit(model in model(), units in units(), title in any::<Option<String>>()) {
        prop_assert_eq!(model.problems(), []);
        let text = write_toml(&model, title.as_deref(), units);
        let document = match parse(&text) {
            Ok(document) => document,
            Err(diagnostics) => panic!("{}", diagnostics.render("written.toml", &text, false)),
        };
        prop_assert_eq!(document.title.as_ref(), title.as_ref());
        prop_assert_eq!(document.units, units);
        // `{:?}` distinguishes 0 from −0 and gives the shortest text of the same bits.
        prop_assert_eq!(format!("{:?}", &document.model), format!("{model:?}"));
        prop_assert_eq!(write_toml(&document.model, title.as_deref(), units), text);
    }

    #[test]
    fn a_file_with_one_change_is_read_without_panic(
        model in model(),
        units in units(),
        place: prop::sample::Index,
        length in 0..12_usize,
        inserted in prop_oneof![Just(String::new()), any::<String>(), pieces()],
    ) {
        let mut text = write_toml(&model, Some("½"), units);
        let boundaries: Vec<usize> = text.char_indices().map(|(i, _)| i).collect();
        let start = boundaries[place.index(boundaries.len())];
        let end = boundaries.iter().copied().find(|&i| i >= start + length).unwrap_or(text.len());
        text.replace_range(start..end, &inserted);
        never_panics(&text);
    }

    /// Every field that a problem can name has a location, also in a file that leaves out most values.
    #[test]
    fn every_problem_has_a_location(model in model(), units in units(), field in "[a-z_]{1,20}", i in 0..3_usize) {
        let text = write_toml(&model, None, units);
        let document = parse(&text).unwrap();
        let parts = [
            Part::Beam, Part::BeamSegment(i), Part::Foundation, Part::FoundationSegment(i),
            Part::Load(i), Part::Support(i), Part::Hinge(i), Part::Gap(i),
        ];
        for part in parts {
            let problem = Problem {
                code: "GB999",
                part,
                field: Box::leak(field.clone().into_boxed_str()),
                message: "at {0}".into(),
                hint: "not {1}".into(),
                numbers: vec![1.0, 2.0],
            };
            well_placed(&document.diagnostic_for(&problem).into(), &text);
        }
    }
}

/// Rust reads a decimal as the nearest 64-bit number; a prefix only moves the decimal point.
#[test]
fn unit_prefixes_are_applied_without_rounding_error() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let numbers = ("[0-9]{1,20}", "[0-9]{0,20}", -30..30_i32);
    let prefixes =
        [("km", 3), ("m", 0), ("dm", -1), ("cm", -2), ("mm", -3), ("µm", -6), ("nm", -9)];
    runner
        .run(&numbers, |(whole, fraction, power)| {
            for (unit, shift) in prefixes {
                let text = format!("{whole}.{fraction}e{power} {unit}");
                let shifted: f64 = format!("{whole}.{fraction}e{}", power + shift).parse().unwrap();
                prop_assert_eq!(parse_positions(&text, UnitSystem::Si).unwrap(), vec![shifted]);
            }
            Ok(())
        })
        .unwrap();
}
