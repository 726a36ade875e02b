//! What follows from all samples: probabilities with their intervals, means, deviations and quantiles.

use crate::draws::Draws;
use crate::row::Status;
use crate::store::{StoreError, Table, Whole};
use groundbeam::sensitivity::{LoadNumber, Parameter, Property};
use groundbeam::{Load, Model};
use groundbeam_file::study::{Exceeds, Judged, Plan, Sampling};
use groundbeam_report::{Estimate, Interval, Kind, Limit, Spread, Study, Way};
use statrs::distribution::{Beta, ContinuousCDF, StudentsT};
use std::path::Path;

/// The probability with which an interval holds what it is about.
const CONFIDENCE: f64 = 0.95;
/// A histogram has so many parts at most.
const MOST_PARTS: usize = 40;
/// From so many times on that something happened, the scatter of replicates tells its error.
const ENOUGH: u64 = 10;

/// Reads all results of a study.
///
/// # Errors
///
/// A file that cannot be read, or does not hold all samples of the study.
pub fn summary(draws: &Draws, out: &Path) -> Result<Study, StoreError> {
    let table = Table::of(draws);
    let plan = draws.plan();
    let missing = || StoreError::File(out.to_owned(), "there are no results yet".to_owned());
    let whole = Whole::of(out, &table.head, &(0..plan.samples))?.ok_or_else(missing)?;
    let statuses = statuses(&whole)?;
    let count = |status: Status| statuses.iter().filter(|s| **s == status).count() as u64;
    let lifted = whole.numbers("lifted_share")?;
    let mut events = vec![
        estimate("no equilibrium", None, &statuses, plan, |_| false),
        estimate("some of the beam lifts off", None, &statuses, plan, |i| lifted[i] > 0.0),
    ];
    let mut spreads = Vec::new();
    let model = &draws.study().document.model;
    for random in &draws.study().random {
        spreads.extend(spread(
            &random.name,
            kind(random.target, model),
            whole.numbers(&random.name)?,
        ));
    }
    spreads.extend(spread("lifted_share", None, lifted));
    for end in ["left", "right"] {
        spreads.extend(spread(end, Some(Kind::Force), whole.numbers(end)?));
    }
    for field in &table.wanted.extremes {
        for part in ["min", "max"] {
            let name = format!("{}_{part}", field.name());
            let values = whole.numbers(&name)?;
            spreads.extend(spread(&name, Some(Kind::of(*field)), values));
        }
    }
    for event in &draws.study().events {
        let (quantity, values) = judged(event.of, &whole)?;
        let above = event.side == Exceeds::Above;
        let happened =
            |i: usize| if above { values[i] > event.limit } else { values[i] < event.limit };
        let limit = Limit { quantity: quantity.clone(), above, limit: event.limit };
        events.push(estimate(&event.name, Some(limit), &statuses, plan, happened));
        if let Judged::Difference(field) = event.of
            && spreads.iter().all(|spread: &Spread| spread.name != quantity)
        {
            spreads.extend(spread(&quantity, Some(Kind::of(field)), values));
        }
    }
    let largest_gap = whole.numbers("relative_gap")?.into_iter().fold(0.0, f64::max);
    Ok(Study {
        title: draws.study().title.clone(),
        samples: plan.samples,
        seed: plan.seed,
        sampling: plan.sampling.name(),
        replicates: plan.replicates,
        dimensions: draws.dimensions(),
        variance: draws.variance(),
        solved: count(Status::Solved),
        without_equilibrium: count(Status::NoEquilibrium),
        not_converged: count(Status::NotConverged),
        wrong: count(Status::Wrong),
        largest_gap,
        events,
        spreads,
    })
}

fn statuses(whole: &Whole) -> Result<Vec<Status>, StoreError> {
    let mut all = Vec::new();
    whole.words("status", |word| {
        let known = Status::ALL.into_iter().find(|status| status.name() == word);
        all.push(known.unwrap_or(Status::Wrong));
    })?;
    Ok(all)
}

/// The number that an event is judged by, of each sample, and what it is called.
fn judged(of: Judged, whole: &Whole) -> Result<(String, Vec<f64>), StoreError> {
    let column = |name: String| Ok((name.clone(), whole.numbers(&name)?));
    let extreme = |field: groundbeam::Field, part| column(format!("{}_{part}", field.name()));
    match of {
        Judged::LiftedShare => column("lifted_share".to_owned()),
        Judged::EndForce(0) => column("left".to_owned()),
        Judged::EndForce(_) => column("right".to_owned()),
        Judged::Smallest(field) => extreme(field, "min"),
        Judged::Largest(field) => extreme(field, "max"),
        Judged::Difference(field) => {
            let ((_, min), (_, max)) = (extreme(field, "min")?, extreme(field, "max")?);
            let difference = max.iter().zip(&min).map(|(max, min)| max - min).collect();
            Ok((format!("{}_range", field.name()), difference))
        }
    }
}

/// What a random number measures.
fn kind(of: Parameter, model: &Model) -> Option<Kind> {
    match of {
        Parameter::AxialForce => Some(Kind::Force),
        Parameter::Value(Property::BendingStiffness, _) => Some(Kind::BendingStiffness),
        Parameter::Value(Property::Spring, _) => Some(Kind::Spring),
        Parameter::Value(Property::Shear | Property::ShearStiffness, _) => Some(Kind::Constant),
        Parameter::Load(_, LoadNumber::At | LoadNumber::From | LoadNumber::To) => {
            Some(Kind::Position)
        }
        Parameter::Load(index, _) => Some(match model.loads[index] {
            Load::PointForce { .. } | Load::GroundForce { .. } => Kind::Force,
            Load::PointMoment { .. } => Kind::Moment,
            Load::Distributed { .. } | Load::GroundDistributed { .. } => Kind::Pressure,
            // Moment per length is a force.
            Load::DistributedMoment { .. } => Kind::Force,
            Load::Curvature { .. } => Kind::PerLength,
        }),
        _ => None,
    }
}

/// How probable something is. A beam without equilibrium is one with which it has happened; of a sample without an answer
/// it is not known, and the interval reaches from none of them to all.
fn estimate(
    name: &str,
    limit: Option<Limit>,
    statuses: &[Status],
    plan: Plan,
    happened: impl Fn(usize) -> bool,
) -> Estimate {
    let is = |i: usize| match statuses[i] {
        Status::Solved => happened(i),
        status => status == Status::NoEquilibrium,
    };
    let is_open = |i: usize| matches!(statuses[i], Status::NotConverged | Status::Wrong);
    let samples = statuses.len();
    let count = (0..samples).filter(|i| is(*i)).count() as u64;
    let open = (0..samples).filter(|i| is_open(*i)).count() as u64;
    let total = samples as u64;
    let mut interval =
        if plan.sampling == Sampling::MonteCarlo || plan.replicates < 2 || count < ENOUGH {
            of_counts(count, count + open, total)
        } else {
            let each = samples / usize::try_from(plan.replicates).unwrap_or(1).max(1);
            let part = |counts: &dyn Fn(usize) -> bool| -> Vec<f64> {
                let parts = (0..samples).step_by(each.max(1));
                parts
                    .map(|from| {
                        (from..(from + each).min(samples)).filter(|i| counts(*i)).count() as f64
                            / each as f64
                    })
                    .collect()
            };
            let low = of_replicates(&part(&is))[0];
            let high = of_replicates(&part(&|i| is(i) || is_open(i)))[1];
            Interval { bounds: [low, high], by: Way::Replicates }
        };
    interval.bounds = interval.bounds.map(|bound| bound.clamp(0.0, 1.0));
    Estimate {
        name: name.to_owned(),
        limit,
        count,
        probability: count as f64 / total as f64,
        interval,
    }
}

/// Clopper and Pearson's interval, which holds the probability at least so often: its lower end for one count, its upper
/// end for another.
fn of_counts(low: u64, high: u64, total: u64) -> Interval {
    let tail = 0.5 * (1.0 - CONFIDENCE);
    let quantile = |a: u64, b: u64, at: f64| {
        Beta::new(a as f64, b as f64).map_or(f64::NAN, |beta| beta.inverse_cdf(at))
    };
    let lower = if low == 0 { 0.0 } else { quantile(low, total - low + 1, tail) };
    let upper = if high >= total { 1.0 } else { quantile(high + 1, total - high, 1.0 - tail) };
    Interval { bounds: [lower, upper], by: Way::Counts }
}

/// Student's interval of a mean.
fn of_replicates(values: &[f64]) -> [f64; 2] {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let t = StudentsT::new(0.0, 1.0, count - 1.0);
    let t = t.map_or(f64::NAN, |t| t.inverse_cdf(0.5 + 0.5 * CONFIDENCE));
    let half = t * (variance / count).sqrt();
    [mean - half, mean + half]
}

/// Mean, deviation and quantiles of what is known; none if nothing is.
fn spread(name: &str, kind: Option<Kind>, values: Vec<f64>) -> Option<Spread> {
    let mut known: Vec<f64> = values.into_iter().filter(|value| !value.is_nan()).collect();
    if known.is_empty() {
        return None;
    }
    let count = known.len() as f64;
    let mean = known.iter().sum::<f64>() / count;
    let squares: f64 = known.iter().map(|value| (value - mean).powi(2)).sum();
    let deviation = if known.len() < 2 { 0.0 } else { (squares / (count - 1.0)).sqrt() };
    known.sort_by(f64::total_cmp);
    // Linear between the order statistics: Hyndman and Fan's type 7.
    let quantile = |part: f64| {
        let place = part * (count - 1.0);
        let below = place.floor() as usize;
        let above = (below + 1).min(known.len() - 1);
        known[below] + (place - place.floor()) * (known[above] - known[below])
    };
    let quantiles = [0.0, 0.05, 0.5, 0.95, 1.0].map(quantile);
    let quartiles = [0.25, 0.75].map(quantile);
    let histogram = histogram(&known, quartiles);
    Some(Spread { name: name.to_owned(), kind, mean, deviation, quantiles, histogram })
}

/// How many of the sorted numbers lie in each of equal parts from the smallest to the largest, as many as Freedman and
/// Diaconis advise: twice the distance of the quartiles over the cube root of the count.
fn histogram(sorted: &[f64], [lower, upper]: [f64; 2]) -> Vec<u64> {
    let [Some(&least), Some(&most)] = [sorted.first(), sorted.last()] else { return Vec::new() };
    let width = 2.0 * (upper - lower) / (sorted.len() as f64).cbrt();
    // Where most are the same, as in a share that is zero, quartiles tell nothing.
    let advised = if width > 0.0 { (most - least) / width } else { MOST_PARTS as f64 };
    let parts = if least < most { (advised.ceil() as usize).clamp(1, MOST_PARTS) } else { 1 };
    let mut counts = vec![0; parts];
    for value in sorted {
        let part = (value - least) / (most - least) * parts as f64;
        counts[(part as usize).min(parts - 1)] += 1;
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Clopper and Pearson, *Biometrika* 26 (1934): 95 % intervals as `scipy.stats.binomtest(k, n).proportion_ci()` gives them.
    #[test]
    fn exact_intervals() {
        for (count, total, low, high) in [
            (0, 20, 0.0, 0.168_433_470_983_085_4),
            (3, 50, 0.012_548_587_835_334_06, 0.165_481_946_603_772_9),
            (20, 20, 0.831_566_529_016_914_7, 1.0),
        ] {
            let Interval { bounds, .. } = of_counts(count, count, total);
            assert!(
                (bounds[0] - low).abs() < 1e-9 && (bounds[1] - high).abs() < 1e-9,
                "{bounds:?}"
            );
        }
    }

    /// t = 2.776445 for four degrees of freedom.
    #[test]
    fn intervals_of_replicates() {
        let bounds = of_replicates(&[0.1, 0.2, 0.3, 0.4, 0.5]);
        let half = 2.776_445_105_197_8 * (0.025_f64 / 5.0).sqrt();
        assert!(
            (bounds[0] - (0.3 - half)).abs() < 1e-10 && (bounds[1] - (0.3 + half)).abs() < 1e-10
        );
    }

    #[test]
    fn what_is_not_known_widens_the_interval() {
        let plan = Plan { samples: 100, seed: 0, sampling: Sampling::MonteCarlo, replicates: 1 };
        let mut statuses = vec![Status::Solved; 100];
        let all_known = estimate("e", None, &statuses, plan, |i| i < 20);
        statuses[50..60].fill(Status::NotConverged);
        let some = estimate("e", None, &statuses, plan, |i| i < 20);
        assert_eq!(some.count, 20);
        assert_eq!(some.interval.bounds[0], all_known.interval.bounds[0]);
        assert!(some.interval.bounds[1] > all_known.interval.bounds[1] + 0.09);
        statuses[99] = Status::NoEquilibrium;
        assert_eq!(estimate("e", None, &statuses, plan, |i| i < 20).count, 21);
    }
}
