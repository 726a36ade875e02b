//! Compares the exact method with answers in 60 digits.
//!
//! Claims: `docs/equations.md`, `docs/methods.md`.

use groundbeam::{Field, Model, Outcome, Solution, Verdict, solution::Side, solve};
use groundbeam_verification::reference::{Answer, Doubtful, parsed};

/// Models whose fields or regions doubles cannot determine to eleven digits: name, tolerance, whether regions are
/// compared. Their energies agree to eleven digits.
const KNOWN: [(&str, f64, bool); 5] = [
    // Shear layers 10⁴ to 10⁶ times stiffer than √(k EI) under beams lifted by thousands of settlements: the pressure
    // at some edges is 10⁻⁵ of the largest, so rounding of the slopes moves these edges by 10⁻⁹. In hard-006 an open
    // span is 6·10⁻²¹ deep.
    ("hard-005", 2e-5, false),
    ("hard-006", 1e-6, false),
    ("hard-007", 1e-6, false),
    // A load 3·10⁻⁹ from an edge: the shear force between them is a third difference over that length.
    ("hard-027", 2e-7, true),
    // Zero at both supports and no contact force: whether these points touch is a matter of definition, and so is the
    // scale of a zero settlement.
    ("supports-012", 1e-6, false),
];

/// Its deflection is 4·10⁷ settlements, so rounding error may decide on contact beside its zones.
const UNDECIDED: [&str; 1] = ["hard-006"];

#[test]
fn exact_solutions_agree_with_the_answers_in_sixty_digits() {
    let mut faults = Vec::new();
    let (mut count, mut worst, mut worst_gap) = (0, 0.0_f64, 0.0_f64);
    for answer in Answer::all() {
        count += 1;
        match solve(&answer.parsed()) {
            Ok(Outcome::Equilibrium(solution)) => {
                let distance = answer.distance(&solution);
                let gap = solution.certificate().relative_gap();
                worst = worst.max(distance.worst());
                worst_gap = worst_gap.max(gap);
                let known = KNOWN.iter().find(|known| known.0 == answer.name);
                let allowed = known.map_or(1e-11, |known| known.1);
                let energy =
                    (solution.certificate().primal_energy() / answer.primal_energy - 1.0).abs();
                let is_undecided = solution.undecided().len() > 0;
                if is_undecided && !UNDECIDED.contains(&answer.name.as_str())
                    || distance.fields.max(distance.forces) > allowed
                    || (distance.edges > 1e-11 && known.is_none_or(|known| known.2))
                    || gap > known.map_or(1e-12, |_| 1e-11)
                    || energy > 1e-11
                {
                    faults.push(format!(
                        "{}: {distance:?}, relative gap {gap:e} {:?}",
                        answer.name,
                        solution.certificate()
                    ));
                }
            }
            Ok(Outcome::NoEquilibrium(_)) => {
                faults.push(format!("{}: no equilibrium", answer.name))
            }
            Err(error) => faults.push(format!("{}: {error}", answer.name)),
        }
    }
    println!("{count} answers, largest distance {worst:.1e}, largest relative gap {worst_gap:.1e}");
    assert!(faults.is_empty(), "{} of {count}:\n{}", faults.len(), faults.join("\n"));
}

fn solved(name: &str, model: &Model) -> Box<Solution> {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => solution,
        other => panic!("{name}: {other:?}"),
    }
}

/// Rounding of an edge, relative to the length: its position is the sum of the origin of a cell and a part of the cell.
const ROUNDING_OF_EDGES: f64 = 1e-15;

#[test]
fn contact_below_the_rounding_error_agrees_with_sixty_digits() {
    let zones = Doubtful::read().zones;
    assert_eq!(zones.len(), 3);
    for one in zones {
        let (answer, doubtful) = (one.answer, one.doubtful);
        let solution = solved(&answer.name, &answer.parsed());
        let l = solution.model().beam.length;
        let distance = answer.distance(&solution);
        println!("{}: {distance:?}, edge error {:e}", answer.name, solution.edge_error());
        let allowed = solution.edge_error() / l + ROUNDING_OF_EDGES;
        assert!(distance.edges <= allowed, "{}: {:?}", answer.name, solution.contact());
        assert!(distance.fields.max(distance.forces) <= 1e-11, "{}: {distance:?}", answer.name);
        let [from, to] = [doubtful.from, doubtful.to];
        // A zone whose contact force is below its rounding error is undecided.
        let is_undecided = solution.undecided().any(|part| part.from < to && part.to > from);
        assert_eq!(is_undecided, !doubtful.touches, "{}", answer.name);
        let mut zones = solution.contact().iter();
        let agrees = if doubtful.touches {
            zones.any(|zone| zone.from <= from && zone.to >= to)
        } else {
            zones.all(|zone| zone.to < from || zone.from > to)
        };
        assert!(agrees, "{}: {:?}", answer.name, solution.contact());
    }
}

#[test]
fn a_beam_balanced_on_a_corner_agrees_with_sixty_digits() {
    let answer = Doubtful::read().balance;
    let solution = solved(&answer.name, &parsed(&answer.name, &answer.model));
    assert!(matches!(solution.existence().verdict, Verdict::NotUnique(_)));
    assert_eq!(solution.undecided().len(), 0);
    let at = answer.at;
    let contact = solution.contact();
    assert!(matches!(contact, [zone] if zone.from == at && zone.to == at), "{contact:?}");
    let forces = solution.concentrated_forces();
    let [force] = forces else { panic!("{forces:?}") };
    assert_eq!(force.at, at);
    let [least, largest] = answer.slopes;
    let close = |found: f64, wanted: f64| (found - wanted).abs() <= 1e-13 * wanted.abs();
    assert!(close(force.force, answer.force), "{force:?}");
    assert!(close(solution.value(Field::Deflection, at), answer.deflection));
    assert!(close(solution.value(Field::Settlement, at), answer.settlement));
    let l = solution.model().beam.length;
    for x in [0.0, at, l] {
        let slope = solution.at(x, if x == l { Side::Left } else { Side::Right }).get(Field::Slope);
        assert!(least < slope && close(slope, largest), "{slope:e}, not {largest:e}");
    }
}
