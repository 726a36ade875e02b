//! Computes probabilities with confidence intervals, means, standard deviations and quantiles from the samples of a study.

use crate::draws::Draws;
use crate::interval::{of_counts, of_replicates};
use crate::progress::{Progress, Stage, Watch};
use crate::row::Status;
use crate::statistics::{Moments, Statistics};
use crate::store::{StoreError, Table, Whole};
use groundbeam::Model;
use groundbeam::derivatives::{LoadNumber, Parameter, Property};
use groundbeam_file::study::{BUILT_IN, Exceeds, Judged, Plan, Sampling};
use groundbeam_report::{Estimate, Interval, Kind, Limit, Spread, Study, Way, load_kind};
use std::path::Path;

/// Minimum number of events for which the error of their probability is estimated from the scatter of the
/// replicates.
const ENOUGH: u64 = 10;

/// Reads all results of a study and computes their summary.
///
/// # Errors
///
/// Fails if the file cannot be read or lacks samples. Returns [`StoreError::Stopped`] if `watch` stops the work.
pub fn summary(draws: &Draws, out: &Path, watch: &mut Watch) -> Result<Study, StoreError> {
    let table = Table::of(draws);
    let plan = draws.plan();
    let missing = || StoreError::File(out.to_owned(), "there are no results yet".to_owned());
    let whole = Whole::of(out, &table.head, &(0..plan.samples))?.ok_or_else(missing)?;
    let numbers = numbers(draws, &table);
    let mut tally = Tally::of(draws, &numbers);
    let mut moments = vec![Moments::new(); numbers.len()];
    let mut gaps = Moments::new();
    // The values of each quantity are read three times.
    let of = (3 * numbers.len() * whole.groups()) as u64;
    let mut done = 0;
    let mut read = |columns: usize| {
        done += columns as u64;
        let now = Progress { stage: Stage::Summarizing, done, before: 0, of };
        if watch(now).is_break() { Err(StoreError::Stopped) } else { Ok(()) }
    };
    for group in 0..whole.groups() {
        let statuses = statuses(&whole, group)?;
        let columns: Vec<Vec<f64>> =
            numbers.iter().map(|number| number.of.read(&whole, group)).collect::<Result<_, _>>()?;
        for (moments, column) in moments.iter_mut().zip(&columns) {
            column.iter().for_each(|value| moments.add(*value));
        }
        whole.numbers(group, "relative_gap")?.into_iter().for_each(|gap| gaps.add(gap));
        tally.add(&statuses, &columns);
        read(columns.len())?;
    }
    let spreads = spreads(&whole, numbers, moments, &mut read)?;
    let count = |status: Status| tally.statuses[status as usize];
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
        largest_gap: gaps.largest().map_or(0.0, |gap| gap.max(0.0)),
        events: tally.happenings.into_iter().map(|happening| happening.estimate(plan)).collect(),
        spreads,
    })
}

/// A quantity with exactly one number per sample.
struct Number {
    name: String,
    kind: Option<Kind>,
    of: Columns,
}

/// The columns from which a quantity is computed.
enum Columns {
    One(String),
    /// The first column minus the second.
    Difference(String, String),
}

impl Columns {
    fn read(&self, whole: &Whole, group: usize) -> Result<Vec<f64>, StoreError> {
        match self {
            Columns::One(name) => whole.numbers(group, name),
            Columns::Difference(more, less) => {
                let less = whole.numbers(group, less)?;
                let more = whole.numbers(group, more)?;
                Ok(more.iter().zip(less).map(|(more, less)| more - less).collect())
            }
        }
    }
}

/// Returns the quantities that the summary describes, and the quantities that decide whether events occur.
fn numbers(draws: &Draws, table: &Table) -> Vec<Number> {
    let one = |name: &str, kind| Number {
        name: name.to_owned(),
        kind,
        of: Columns::One(name.to_owned()),
    };
    let study = draws.study();
    let model = &study.document.model;
    let mut all: Vec<Number> =
        study.random.iter().map(|random| one(&random.name, kind(random.target, model))).collect();
    all.push(one("lifted_share", None));
    all.extend(["left", "right"].map(|end| one(end, Some(Kind::Force))));
    for field in &table.wanted.extremes {
        let kind = Some(Kind::of(*field));
        all.extend(["min", "max"].map(|part| one(&format!("{}_{part}", field.name()), kind)));
    }
    for event in &study.events {
        if let Judged::Difference(field) = event.of
            && all.iter().all(|number| number.name != judged(event.of))
        {
            let [min, max] = ["min", "max"].map(|part| format!("{}_{part}", field.name()));
            let (name, kind) = (judged(event.of), Some(Kind::of(field)));
            all.push(Number { name, kind, of: Columns::Difference(max, min) });
        }
    }
    all
}

/// Name of the quantity that decides whether an event occurs.
fn judged(of: Judged) -> String {
    match of {
        Judged::LiftedShare => "lifted_share".to_owned(),
        Judged::EndForce(0) => "left".to_owned(),
        Judged::EndForce(_) => "right".to_owned(),
        Judged::Smallest(field) => format!("{}_min", field.name()),
        Judged::Largest(field) => format!("{}_max", field.name()),
        Judged::Difference(field) => format!("{}_range", field.name()),
    }
}

/// Kind of physical quantity that a random parameter describes.
fn kind(of: Parameter, model: &Model) -> Option<Kind> {
    match of {
        Parameter::AxialForce => Some(Kind::Force),
        Parameter::Value(Property::BendingStiffness, _) => Some(Kind::BendingStiffness),
        Parameter::Value(Property::Spring, _) => Some(Kind::Spring),
        Parameter::Value(Property::Shear | Property::ShearStiffness, _) => Some(Kind::Constant),
        Parameter::Load(_, LoadNumber::At | LoadNumber::From | LoadNumber::To) => {
            Some(Kind::Position)
        }
        Parameter::Load(index, _) => Some(load_kind(&model.loads[index])),
        _ => None,
    }
}

/// Reads the statuses of the samples in a group of rows.
fn statuses(whole: &Whole, group: usize) -> Result<Vec<Status>, StoreError> {
    let mut all = Vec::new();
    whole.words(group, "status", |word| {
        let known = Status::ALL.into_iter().find(|status| status.name() == word);
        all.push(known.unwrap_or(Status::Wrong));
    })?;
    Ok(all)
}

/// Counts of outcomes and events.
struct Tally {
    /// Number of samples with each status.
    statuses: [u64; Status::ALL.len()],
    happenings: Vec<Happening>,
    samples: u64,
    /// Number of samples of a replicate.
    each: u64,
}

/// An event, and its count in each replicate.
struct Happening {
    name: String,
    limit: Option<Limit>,
    /// Index of the quantity that decides whether the event occurs; `None` for the loss of equilibrium.
    by: Option<usize>,
    /// For each replicate, the number of samples with the event and the number with unknown outcome.
    counts: Vec<[u64; 2]>,
}

impl Tally {
    fn of(draws: &Draws, numbers: &[Number]) -> Self {
        let plan = draws.plan();
        let place = |name: &str| numbers.iter().position(|number| number.name == name);
        let happening = |name: &str, limit, by| Happening {
            name: name.to_owned(),
            limit,
            by,
            counts: Vec::new(),
        };
        let above_zero = Limit { quantity: String::new(), above: true, limit: 0.0 };
        let [no_equilibrium, lifts] = BUILT_IN;
        let mut happenings = vec![
            happening(no_equilibrium, None, None),
            happening(lifts, Some(above_zero), place("lifted_share")),
        ];
        for event in &draws.study().events {
            let (quantity, above) = (judged(event.of), event.side == Exceeds::Above);
            let by = place(&quantity);
            let limit = Limit { quantity, above, limit: event.limit };
            happenings.push(happening(&event.name, Some(limit), by));
        }
        let each = (plan.samples / plan.replicates.max(1)).max(1);
        Tally { statuses: [0; Status::ALL.len()], happenings, samples: 0, each }
    }

    /// Counts the statuses and events of the next samples, in the order of their numbers. An event counts as occurred
    /// without equilibrium, and as unknown without a result.
    fn add(&mut self, statuses: &[Status], columns: &[Vec<f64>]) {
        for (i, status) in statuses.iter().enumerate() {
            self.statuses[*status as usize] += 1;
            let replicate = usize::try_from(self.samples / self.each).unwrap_or(usize::MAX);
            self.samples += 1;
            for happening in &mut self.happenings {
                if happening.counts.len() <= replicate {
                    happening.counts.resize(replicate + 1, [0; 2]);
                }
                let has = match status {
                    Status::Solved => happening.has(columns, i),
                    Status::NoEquilibrium => true,
                    Status::NotConverged | Status::Wrong => {
                        happening.counts[replicate][1] += 1;
                        continue;
                    }
                };
                happening.counts[replicate][0] += u64::from(has);
            }
        }
    }
}

impl Happening {
    fn has(&self, columns: &[Vec<f64>], i: usize) -> bool {
        let (Some(limit), Some(by)) = (&self.limit, self.by) else { return false };
        if limit.above { columns[by][i] > limit.limit } else { columns[by][i] < limit.limit }
    }

    /// Estimates the probability of the event, with a confidence interval. If the outcome of a sample is unknown, the
    /// interval covers both possible outcomes.
    fn estimate(self, plan: Plan) -> Estimate {
        let [count, open] = [0, 1].map(|i| self.counts.iter().map(|own| own[i]).sum::<u64>());
        let total = plan.samples;
        let alone = plan.sampling == Sampling::MonteCarlo || plan.replicates < 2 || count < ENOUGH;
        let mut interval = if alone {
            of_counts(count, count + open, total)
        } else {
            let each = (total / plan.replicates) as f64;
            let part = |of: fn(&[u64; 2]) -> u64| -> Vec<f64> {
                self.counts.iter().map(|own| of(own) as f64 / each).collect()
            };
            let low = of_replicates(&part(|own| own[0]))[0];
            let high = of_replicates(&part(|own| own[0] + own[1]))[1];
            Interval { bounds: [low, high], by: Way::Replicates }
        };
        interval.bounds = interval.bounds.map(|bound| bound.clamp(0.0, 1.0));
        let probability = count as f64 / total as f64;
        let limit = self.limit.filter(|limit| !limit.quantity.is_empty());
        Estimate { name: self.name, limit, count, probability, interval }
    }
}

/// Computes means, standard deviations and quantiles of the given quantities in two more passes over the
/// file.
fn spreads(
    whole: &Whole,
    numbers: Vec<Number>,
    moments: Vec<Moments>,
    read: &mut dyn FnMut(usize) -> Result<(), StoreError>,
) -> Result<Vec<Spread>, StoreError> {
    let mut all = Vec::new();
    for (number, moments) in numbers.into_iter().zip(moments) {
        let Some(mut counted) = moments.counted() else { continue };
        for group in 0..whole.groups() {
            number.of.read(whole, group)?.into_iter().for_each(|value| counted.add(value));
            read(1)?;
        }
        let mut ranked = counted.ranked();
        for group in 0..whole.groups() {
            number.of.read(whole, group)?.into_iter().for_each(|value| ranked.add(value));
            read(1)?;
        }
        let Number { name, kind, .. } = number;
        let Statistics { mean, deviation, quantiles, histogram } = ranked.finish();
        all.push(Spread { name, kind, mean, deviation, quantiles, histogram });
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_of_unknown_outcome_widen_the_interval() {
        let plan = Plan { samples: 100, seed: 0, sampling: Sampling::MonteCarlo, replicates: 1 };
        let limit = Limit { quantity: "e".to_owned(), above: false, limit: 20.0 };
        let estimate = |statuses: &[Status]| {
            let happening = Happening {
                name: "e".to_owned(),
                limit: Some(limit.clone()),
                by: Some(0),
                counts: Vec::new(),
            };
            let happenings = vec![happening];
            let mut tally = Tally { statuses: [0; 4], happenings, samples: 0, each: 100 };
            tally.add(statuses, &[(0..100).map(f64::from).collect()]);
            tally.happenings.remove(0).estimate(plan)
        };
        let mut statuses = vec![Status::Solved; 100];
        let all_known = estimate(&statuses);
        statuses[50..60].fill(Status::NotConverged);
        let some = estimate(&statuses);
        assert_eq!(some.count, 20);
        assert_eq!(some.interval.bounds[0], all_known.interval.bounds[0]);
        assert!(some.interval.bounds[1] > all_known.interval.bounds[1] + 0.09);
        statuses[99] = Status::NoEquilibrium;
        assert_eq!(estimate(&statuses).count, 21);
    }
}
