//! Line search: finds a step fraction at which a convex energy along the step has decreased.

/// Largest accepted slope at the end of a line search, relative to the initial slope.
const REMAINING_SLOPE: f64 = 0.1;

/// Returns a step fraction t at which a convex function has decreased and its slope has almost vanished; 1 if possible.
/// `slope` computes the slope at t, and `fall` > 0 is minus the slope at 0.
pub(crate) fn settle(fall: f64, slope: impl Fn(f64) -> f64) -> f64 {
    let small = REMAINING_SLOPE * fall;
    let (mut low, mut low_slope) = (0.0, -fall);
    let (mut high, mut high_slope) = (1.0, slope(1.0));
    // The mean of the slopes at ½ and 1 is an upper bound of the change of a convex function.
    if high_slope.abs() <= small && (high_slope <= 0.0 || slope(0.5) + high_slope <= 0.0) {
        return 1.0;
    }
    while high_slope < -small && high < 1e12 {
        (low, low_slope) = (high, high_slope);
        high *= 2.0;
        high_slope = slope(high);
    }
    let mut t = high;
    let mut at_t = high_slope;
    let mut kept = 0;
    for _ in 0..60 {
        if at_t <= 0.0 && -at_t <= small {
            break;
        }
        // Regula falsi gives the next t. If one end of the bracket is kept twice in succession, the slope at this
        // end is halved (Illinois variant).
        t = low + (high - low) * (low_slope / (low_slope - high_slope));
        at_t = slope(t);
        if at_t < 0.0 {
            (low, low_slope) = (t, at_t);
            if kept < 0 {
                high_slope *= 0.5;
            }
            kept = -1;
        } else {
            (high, high_slope) = (t, at_t);
            if kept > 0 {
                low_slope *= 0.5;
            }
            kept = 1;
        }
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_steps_are_accepted_and_overshoots_are_shortened() {
        assert_eq!(settle(1.0, |t| t - 1.0), 1.0);
        // The function Φ = (t − ¼)²/2 has its minimum at ¼, and Φ = (t − 6)²/2 has its minimum at 6.
        for least in [0.25, 6.0] {
            let t = settle(least, |t| t - least);
            assert!(t <= least && least - t <= REMAINING_SLOPE * least, "{t}");
        }
    }
}
