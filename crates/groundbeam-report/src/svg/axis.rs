//! Computes round numbers for axes.

use crate::quantity::Unit;

/// Returns the multiples of a step in a range. The step is 1, 2 or 5 times a power of ten. It is the largest
/// such step that gives at least `least` multiples.
pub(super) fn ticks([low, high]: [f64; 2], least: usize) -> Vec<f64> {
    let range = high - low;
    if !(range > 0.0 && range.is_finite()) {
        return vec![low];
    }
    let within = |step: f64| {
        let slack = 1e-9 * range / step;
        let first = (low / step - slack).ceil() as i64;
        let last = (high / step + slack).floor() as i64;
        first..=last.min(first.saturating_add(100))
    };
    let mut step = round_down_to(range, &LEADS, true);
    while within(step).count() < least {
        let finer = round_down_to(0.51 * step, &LEADS, false);
        if !(finer > 0.0 && finer < step) {
            break;
        }
        step = finer;
    }
    within(step).map(|i| i as f64 * step).collect()
}

/// Returns ticks in a range of a quantity, at round numbers of the unit `unit`.
pub(super) fn ticks_in(unit: Unit, range: [f64; 2], least: usize) -> Vec<f64> {
    let all = ticks(range.map(|end| end / unit.size), least);
    all.into_iter().map(|tick| tick * unit.size).collect()
}

const LEADS: [f64; 3] = [1.0, 2.0, 5.0];

/// Rounds a positive value down to one of `leads` times a power of ten. If `up` is true, rounds it up.
pub(super) fn round_down_to(value: f64, leads: &[f64], up: bool) -> f64 {
    let power = value.log10().floor() as i32;
    let size = |lead: f64, power: i32| lead * 10.0_f64.powi(power);
    let close = 1e-9;
    if up {
        let fits = leads.iter().find(|&&lead| size(lead, power) >= value * (1.0 - close));
        fits.map_or(size(leads[0], power + 1), |&lead| size(lead, power))
    } else {
        let fits = leads.iter().rev().find(|&&lead| size(lead, power) <= value * (1.0 + close));
        fits.map_or(size(leads[0], power), |&lead| size(lead, power))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axis_ticks_have_round_steps() {
        assert_eq!(ticks([0.0, 12.0], 7), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0]);
        assert_eq!(ticks([-0.9, 2.1], 3), [0.0, 1.0, 2.0]);
        assert_eq!(ticks([-430.0, 470.0], 3), [-400.0, -200.0, 0.0, 200.0, 400.0]);
        assert_eq!(ticks([0.0, 0.0], 4), [0.0]);
        assert_eq!(round_down_to(260.0, &[1.0, 1.5, 2.0, 2.5, 3.0, 5.0], false), 250.0);
        assert_eq!(round_down_to(0.3, &[1.0, 2.0, 5.0], false), 0.2);
    }
}
