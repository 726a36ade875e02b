//! Tests that every ball contains the exact result, by exact arithmetic on integers times powers of two.

use crate::exact::{self, Exact, Random};
use groundbeam_proof::{Ball, Scalar, Wide};

/// A ball whose midpoint and radius can be read.
trait Enclosure: Scalar {
    fn ends(self) -> Option<[Exact; 2]>;
}

impl Enclosure for Ball {
    fn ends(self) -> Option<[Exact; 2]> {
        let (m, r) = (self.middle(), self.radius());
        r.is_finite().then(|| [Exact::of(m) - Exact::of(r), Exact::of(m) + Exact::of(r)])
    }
}

impl Enclosure for Wide {
    fn ends(self) -> Option<[Exact; 2]> {
        let ([h, l], r) = (self.midpoint(), self.radius());
        let m = || Exact::of(h) + Exact::of(l);
        r.is_finite().then(|| [m() - Exact::of(r), m() + Exact::of(r)])
    }
}

/// The bounds as doubles contain the ball; an infinite ball has infinite bounds.
fn check_bounds<S: Enclosure>(x: S) {
    let Some([low, high]) = x.ends() else {
        assert_eq!((x.low(), x.high(), x.size()), (-f64::INFINITY, f64::INFINITY, f64::INFINITY));
        return;
    };
    assert!(Exact::of(x.low()) <= low, "{x:?}: low {:e}", x.low());
    assert!(Exact::of(x.high()) >= high, "{x:?}: high {:e}", x.high());
    assert!(Exact::of(x.size()) >= high.magnitude(), "{x:?}: size {:e}", x.size());
    assert!(Exact::of(x.size()) >= low.magnitude(), "{x:?}: size {:e}", x.size());
}

/// A random ball: a sum of two numbers, so that both halves of a wide midpoint are used, with a radius.
fn random<S: Enclosure>(random: &mut Random) -> S {
    let x = S::of(random.number()) + S::of(random.number());
    match random.below(4) {
        0 => x,
        1 => S::of(x.middle()),
        2 => x.widened(x.size() * random.unit()),
        _ => x.widened(random.number()),
    }
}

fn check_pair<S: Enclosure>(a: S, b: S) {
    for x in [a, b, a + b, a - b, a * b, a.div(b), a.sqrt()] {
        check_bounds(x);
    }
    let (Some(at), Some(bt)) = (a.ends(), b.ends()) else { return };
    let sum = (a + b).ends();
    let difference = (a - b).ends();
    let product = (a * b).ends();
    let quotient = a.div(b).ends();
    for x in &at {
        for y in &bt {
            let holds = |ends: &Option<[Exact; 2]>, exact: &Exact| {
                ends.as_ref().is_none_or(|[low, high]| low <= exact && exact <= high)
            };
            assert!(holds(&sum, &(x.clone() + y.clone())), "{a:?} + {b:?}");
            assert!(holds(&difference, &(x.clone() - y.clone())), "{a:?} - {b:?}");
            assert!(holds(&product, &(x.clone() * y.clone())), "{a:?} * {b:?}");
            if let Some([low, high]) = &quotient {
                assert!(!y.is_zero(), "{a:?} / {b:?}");
                let (low, high) = (low.clone() * y.clone(), high.clone() * y.clone());
                let (low, high) = if low <= high { (low, high) } else { (high, low) };
                assert!(low <= *x && *x <= high, "{a:?} / {b:?}");
            }
        }
        if let Some([low, high]) = a.sqrt().ends() {
            assert!(high.clone() * high >= *x, "root of {a:?}");
            assert!(low.is_negative() || low.clone() * low <= *x, "root of {a:?}");
        }
    }
}

fn check_operands<S: Enclosure>(seed: u64, count: usize) {
    let mut numbers = Random::new(seed);
    for i in 0..count {
        let a: S = random(&mut numbers);
        // Every third pair cancels up to the last digits.
        let b: S = if i % 3 == 0 {
            -a + S::of(a.size() * numbers.unit() * 1e-16) + S::of(a.size() * numbers.unit() * 1e-30)
        } else {
            random(&mut numbers)
        };
        check_pair(a, b);
        check_bounds(a.scaled(numbers.below(2400) as i32 - 1200));
    }
}

#[test]
fn sums_products_quotients_and_roots_are_enclosed() {
    check_operands::<Ball>(1, 100_000);
    check_operands::<Wide>(2, 100_000);
}

/// Takes minutes: `cargo test -p groundbeam-proof --release -- --ignored`.
#[test]
#[ignore = "ten million operands"]
fn ten_million_operands_are_enclosed() {
    check_operands::<Ball>(3, 5_000_000);
    check_operands::<Wide>(4, 5_000_000);
}

#[test]
fn scaling_by_powers_of_two_is_exact() {
    let mut numbers = Random::new(5);
    for _ in 0..50_000 {
        let x: Wide = random(&mut numbers);
        let exponent = numbers.below(800) as i32 - 400;
        let (Some([low, high]), Some(scaled)) = (x.ends(), x.scaled(exponent).ends()) else {
            continue;
        };
        let [low, high] = [low, high].map(|x| x.times_power_of_two(exponent));
        assert!(scaled[0] <= low && high <= scaled[1], "{x:?} · 2^{exponent}");
        if x.radius() == 0.0 && x.midpoint()[0].abs() > 1e-150 {
            assert_eq!(scaled[0], scaled[1], "{x:?} · 2^{exponent}");
        }
    }
}

/// The bounds also hold near subnormal numbers and at r ≈ |h|.
#[test]
fn bounds_hold_near_subnormal_numbers() {
    let nearly_zero = Wide::of(1.0).widened(1.0) - Wide::of(2.0_f64.powi(-55));
    check_bounds(nearly_zero);
    for x in [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-290, 9.9e-291] {
        check_bounds(Wide::of(x));
        check_bounds(Ball::of(x));
        check_pair(Wide::of(x), Wide::of(3.0));
        check_pair(Ball::of(x), Ball::of(x));
    }
}

/// 1 + 2⁻⁶⁰ is rounded to 1, so a radius of 1 would be too small.
#[test]
fn radii_are_rounded_up() {
    let least = 2.0_f64.powi(-60);
    assert!(Ball::of(0.0).widened(1.0).widened(least).radius() > 1.0);
    assert!(Wide::of(0.0).widened(1.0).widened(least).radius() > 1.0);
    assert!((Ball::of(0.0).widened(1.0) + Ball::of(0.0).widened(least)).radius() > 1.0);
    assert!((Wide::of(0.0).widened(1.0) + Wide::of(0.0).widened(least)).radius() > 1.0);
    assert!((Wide::of(1.0) + Wide::of(least)).widened(1.0).ball().radius() > 1.0);
}

#[test]
fn the_parts_of_a_ball_are_its_midpoint_and_radius() {
    let wide = (Wide::of(1.0) + Wide::of(2.0_f64.powi(-60))).widened(0.5);
    let [h, l] = wide.midpoint();
    assert_eq!(wide.parts(), [h, l, wide.radius()]);
    assert_eq!([h, l], [1.0, 2.0_f64.powi(-60)]);
    let ball = wide.ball();
    assert_eq!(ball.parts(), [1.0, 0.0, ball.radius()]);
    assert_eq!(Scalar::parts(1.5), [1.5, 0.0, 0.0]);
}

#[test]
fn nan_and_infinite_operands_give_valid_bounds() {
    let odd = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1e308];
    for x in odd {
        for y in odd.into_iter().chain([0.0, 1.0]) {
            let (a, b) = (Wide::of(x), Wide::of(y));
            for z in [a + b, a - b, a * b, a.div(b), b.div(a), a.sqrt(), a.expm1(), a.scaled(9)] {
                check_bounds(z);
                assert!(z.radius() == f64::INFINITY || y != x, "{x} {y} {z:?}");
            }
            let (a, b) = (Ball::of(x), Ball::of(y));
            for z in [a + b, a - b, a * b, a.div(b), b.div(a), a.sqrt(), a.expm1(), a.scaled(9)] {
                check_bounds(z);
            }
        }
    }
    assert_eq!(Ball::of(1.0).widened(f64::NAN).high(), f64::INFINITY);
    assert_eq!(Wide::of(1.0).div(Wide::of(0.0)).low(), -f64::INFINITY);
    assert_eq!(Wide::of(-1.0).sqrt().size(), f64::INFINITY);
}

/// exp(x) − 1 against bounds from 200 binary digits.
#[test]
fn expm1_is_enclosed() {
    let mut numbers = Random::new(6);
    for i in 0..3000 {
        let x = match i % 4 {
            0 => -numbers.unit(),
            1 => -numbers.unit() * 1e-3 / 2.0_f64.powi(numbers.below(60) as i32),
            2 => -numbers.unit() * 30.0,
            _ => -numbers.unit() * 500.0,
        };
        let [low, high] = exact::expm1(x);
        let check = |ends: Option<[Exact; 2]>, width: f64| {
            let ends = ends.expect("finite");
            assert!(ends[0] <= low && high <= ends[1], "expm1({x:e})");
            let span = ends[1].clone() - ends[0].clone();
            assert!(span <= Exact::of(width * x.abs().min(1.0)), "expm1({x:e}) is too wide");
        };
        check(Wide::of(x).expm1().ends(), 1e-28);
        check(Ball::of(x).expm1().ends(), 1e-13);
    }
    let far = Wide::of(-1e5).expm1();
    assert!(far.low() <= -1.0 && far.high() >= -1.0 && far.size() < 1.0 + 1e-14);
}

/// exp(x) − 1 of a ball from −701 to x: all numbers from nearly −1 to exp(x) − 1.
#[test]
fn expm1_of_a_wide_ball_contains_both_ends() {
    for high in [-695.0, -689.0, -1.0, 0.0, 0.5] {
        let (middle, radius) = (0.5 * (high - 701.0), 0.5 * (high + 701.0));
        let check = |[low, top]: [f64; 2]| {
            assert!(low <= -1.0 + f64::EPSILON && f64::exp_m1(high) <= top, "{high}: {low} {top}");
        };
        let (ball, wide) = (Ball::of(middle).widened(radius), Wide::of(middle).widened(radius));
        check([ball.expm1().low(), ball.expm1().high()]);
        check([wide.expm1().low(), wide.expm1().high()]);
    }
}

#[test]
fn decimals_are_read_exactly() {
    for (text, exact) in
        [("0.5", 0.5), ("1.28e9", 1.28e9), ("-3", -3.0), ("100e-2", 1.0), ("+.25", 0.25)]
    {
        let x = Wide::decimal(text).expect(text);
        assert_eq!((x.midpoint(), x.radius()), ([exact, 0.0], 0.0), "{text}");
    }
    for (text, digits, power) in [
        ("0.1", 1_i64, 1),
        ("0.3000000000000034", 3_000_000_000_000_034, 16),
        ("4.4482216152605", 44_482_216_152_605, 13),
        ("1e-30", 1, 30),
        ("0.99333333333333333", 99_333_333_333_333_333, 17),
    ] {
        let [low, high] = Wide::decimal(text).and_then(Wide::ends).expect(text);
        let ten = exact::power_of_ten(power);
        let exact = Exact::whole(digits);
        assert!(
            low.clone() * ten.clone() <= exact && exact <= high.clone() * ten.clone(),
            "{text}"
        );
        assert!((high - low) * ten <= exact * Exact::of(1e-29), "{text} is too wide");
        let near: f64 = text.parse().expect("a number");
        assert_eq!(<f64 as Scalar>::decimal(text), Some(near));
    }
    let third = Wide::decimal("0.333333333333333333333333333333333333333333333").expect("a number");
    assert!((third * Wide::of(3.0) - Wide::of(1.0)).size() < 1e-30);
    // Digits after the 37th are omitted: only nonzero ones make the radius larger.
    let zeros = "0".repeat(40);
    let exact = Wide::decimal(&format!("1.{zeros}")).expect("a number");
    assert_eq!((exact.midpoint(), exact.radius()), ([1.0, 0.0], 0.0));
    for last in ["9", "90", "09"] {
        let more = Wide::decimal(&format!("1.{zeros}{last}")).expect("a number");
        assert!(more.high() > 1.0 && more.radius() < 1e-30, "{last}");
    }
    for wrong in ["", ".", "-", "1e", "NaN", "inf", "1.2.3", "1e999", "0x1", "1_000", "1e300"] {
        assert!(Wide::decimal(wrong).is_none(), "{wrong}");
    }
}

/// The relative width of a root is a few units of rounding: 2⁻⁵³ of a ball, 2⁻¹⁰⁶ of a wide ball.
#[test]
fn roots_have_narrow_bounds() {
    let mut numbers = Random::new(7);
    for _ in 0..1000 {
        let x = (1.0 + numbers.unit()) * 2.0_f64.powi(numbers.below(800) as i32 - 400);
        let (ball, wide) = (Ball::of(x).sqrt(), Wide::of(x).sqrt());
        assert!(ball.radius() <= 1e-15 * ball.middle(), "{x:e}: {ball:?}");
        assert!(wide.radius() <= 1e-30 * wide.middle(), "{x:e}: {wide:?}");
    }
}

/// A midpoint whose second half becomes subnormal gets a radius of at most a few units of the smallest normal number.
#[test]
fn scaling_to_the_smallest_numbers_has_narrow_bounds() {
    let x = Wide::of(1.0) + Wide::of(2.0_f64.powi(-100));
    for exponent in [-900, -940, -960] {
        let scaled = x.scaled(exponent);
        check_bounds(scaled);
        assert!(scaled.radius() <= 1e-280, "{exponent}: {scaled:?}");
        let [low, high] = x.ends().expect("finite").map(|end| end.times_power_of_two(exponent));
        let ends = scaled.ends().expect("finite");
        assert!(ends[0] <= low && high <= ends[1], "{exponent}: {scaled:?}");
    }
}

/// The root of a ball with negative numbers has no bound. The root of zero is zero.
#[test]
fn roots_of_negative_numbers_have_no_bound() {
    fn check<S: Enclosure>() {
        for (middle, radius, bounded) in [
            (0.0, 0.0, true),
            (1.0, 0.0, true),
            (1.0, 0.5, true),
            (1.0, 1.5, false),
            (1e200, 2e200, false),
            (0.0, 1e-300, false),
            (0.0, 1.0, false),
            (-1.0, 0.5, false),
            (-1.0, 2.0, false),
            (1e-300, 0.0, false),
        ] {
            let root = S::of(middle).widened(radius).sqrt();
            assert_eq!(root.size() < f64::INFINITY, bounded, "{middle} {radius}: {root:?}");
            check_bounds(root);
        }
        assert_eq!(S::of(0.0).sqrt().ends(), Some([Exact::of(0.0), Exact::of(0.0)]));
    }
    check::<Ball>();
    check::<Wide>();
}
