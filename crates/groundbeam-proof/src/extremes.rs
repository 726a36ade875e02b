//! Finds intervals that contain every position where an exact field has its largest or smallest value.
//!
//! An interval is excluded if the claimed field on it differs from its extreme by more than twice the error bound, or
//! if the magnitude of its slope exceeds the error bound of the slope. See *Positions of extremes* in section 6 of
//! docs/proof.md.

use crate::bounds::Bounds;
use crate::document::Extreme;
use crate::fields::Fields;
use crate::patches::{FIELDS, Patch, Patches, field_named};
use crate::polynomial::{Budget, Polynomial, half_width};
use crate::scalar::Scalar;
use crate::size::Size;

/// Intervals of the local coordinate t up to this length are not halved: first with, then without an error bound of the
/// derivative of the field.
const SHORTEST: [f64; 2] = [1e-13, 1e-9];

/// An extreme of a field that a result document lists, and the proven positions of this extreme in the exact solution.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedExtreme {
    /// Name of the field.
    pub field: String,
    /// Whether the extreme is the largest value of the field; otherwise it is the smallest value.
    pub is_max: bool,
    /// Position of the extreme along the beam \[m\], as the result document states it.
    pub listed: f64,
    /// Intervals that contain all positions of the exact extreme \[m\], from left to right. The list is empty if no
    /// interval is proven.
    pub places: Vec<[f64; 2]>,
}

impl PlacedExtreme {
    /// Returns the proven interval that contains the position of the extreme in the result document. If no interval
    /// contains this position, returns the interval nearest to it.
    pub fn nearest(&self) -> Option<[f64; 2]> {
        let off = |place: &[f64; 2]| self.distance_from(*place);
        self.places.iter().copied().min_by(|a, b| off(a).total_cmp(&off(b)))
    }

    /// Returns the distance \[m\] from the listed position to the nearest proven interval; zero inside an interval, and
    /// if no interval is proven.
    pub fn distance(&self) -> f64 {
        self.nearest().map_or(0.0, |place| self.distance_from(place))
    }

    fn distance_from(&self, [low, high]: [f64; 2]) -> f64 {
        (low - self.listed).max(self.listed - high).max(0.0)
    }

    /// Returns the distance \[m\] from the listed position to the farther end of the nearest proven interval, rounded
    /// up; infinite if no interval is proven.
    pub fn error(&self) -> f64 {
        let Some([low, high]) = self.nearest() else { return f64::INFINITY };
        let [below, above] = [self.listed - low, high - self.listed].map(|d| d.abs().next_up());
        if self.listed == low && self.listed == high {
            0.0
        } else if below >= above {
            below
        } else {
            above
        }
    }
}

/// The data of the search for one extreme.
struct Search<'a, S: Scalar> {
    fields: &'a Fields<'a, S>,
    field: usize,
    /// Sign of the extreme: 1 for the largest value, −1 for the smallest value. The search maximises `sign` times the
    /// field.
    sign: f64,
    /// Lower limit of `sign` times the field at the exact extreme. The search excludes positions with smaller values.
    level: f64,
    /// Error bound of the derivative of the field with respect to x, on each piece; infinite if no bound is known.
    steep: Vec<Size>,
}

/// Finds intervals that contain every position of an extreme in the exact solution. `extreme` is the entry of the
/// result document for this extreme.
pub(crate) fn placed<S: Scalar>(
    extreme: &Extreme,
    fields: &Fields<S>,
    patches: &Patches<S>,
    bounds: &Bounds,
) -> PlacedExtreme {
    let places = search(extreme, fields, patches, bounds).map(|search| search.places(patches));
    PlacedExtreme {
        field: extreme.field.clone(),
        is_max: extreme.is_max,
        listed: extreme.x,
        places: places.unwrap_or_default(),
    }
}

fn search<'a, S: Scalar>(
    extreme: &Extreme,
    fields: &'a Fields<'a, S>,
    patches: &Patches<S>,
    bounds: &Bounds,
) -> Option<Search<'a, S>> {
    let field = field_named(&extreme.field)?;
    let (frame, (_, force, length)) = (fields.frame, FIELDS[field]);
    let named = bounds.named();
    let error = |name: &str| named.iter().find(|(known, _)| *known == name).map(|(_, b)| b.error);
    let scaled = |error: f64, force: i32, length: i32| {
        Size::of(frame.units.scaled(S::of(error), force, length).high())
    };
    let error = match extreme.field.as_str() {
        // The pressure has no error bound in an interval that contains an edge of contact.
        "pressure" => return None,
        "gap" => scaled(bounds.deflection.error, 0, 1) + scaled(bounds.settlement.error, 0, 1),
        name => scaled(error(name)?, force, length),
    };
    if !(error.value() < f64::INFINITY) {
        return None;
    }
    let sign = if extreme.is_max { 1.0 } else { -1.0 };
    // `top` is the largest value of `sign` times the field at two kinds of positions: the ends of all pieces, and the
    // position that the result document lists for the extreme.
    let mut top = -f64::INFINITY;
    let mut raise = |piece: usize, t: S| {
        let value = (patches.value(field, piece, t) * S::of(sign)).low();
        top = if value > top { value } else { top };
    };
    let listed = frame.units.metres(S::of(extreme.x));
    for (i, span) in frame.spans.iter().enumerate() {
        span.t.into_iter().for_each(|t| raise(i, t));
        if (listed - span.x[0]).low() >= 0.0 && (span.x[1] - listed).low() >= 0.0 {
            raise(i, (listed - span.middle).div(span.half));
        }
    }
    let level = (top - (2.0 * error).value()).next_down();
    let moment = scaled(bounds.moment.error, 1, 1);
    let steep = frame.spans.iter().map(|span| match extreme.field.as_str() {
        "deflection" => scaled(bounds.slope.error, 0, 0),
        "slope" if span.stiffness.is_none() => moment.over(span.bending.low()),
        "rotation" => moment.over(span.bending.low()),
        "moment" => scaled(bounds.shear_force.error, 1, 0),
        _ => Size::INFINITE,
    });
    Some(Search { fields, field, sign, level, steep: steep.collect() })
}

impl<S: Scalar> Search<'_, S> {
    /// Returns the intervals that may contain the extreme, from left to right. Adjacent intervals are merged.
    fn places(&self, patches: &Patches<S>) -> Vec<[f64; 2]> {
        let frame = self.fields.frame;
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut add = |low: S, high: S| {
            let [low, high] = [low.low(), high.high()].map(|x| if x > 1e-270 { x } else { 0.0 });
            let [low, high] = [low, high].map(|x| frame.units.restored(x, 0, 1));
            match found.last_mut() {
                Some(last) if low <= last[1] => {
                    last[1] = if high > last[1] { high } else { last[1] }
                }
                _ => found.push([low, high]),
            }
        };
        let mut budget = Budget::new(patches.pieces.iter().map(Vec::len).sum());
        for (i, span) in frame.spans.iter().enumerate() {
            let reaches = |side: usize| {
                let value = patches.value(self.field, i, span.t[side]) * S::of(self.sign);
                value.high() >= self.level
            };
            if reaches(0) {
                add(span.x[0], span.x[0]);
            }
            for patch in &patches.pieces[i] {
                for ends in self.on_patch(patch, i, &mut budget) {
                    let [a, b] =
                        ends.map(|s| span.middle + span.half * (S::of(patch.middle) + S::of(s)));
                    add(a, b);
                }
            }
            if reaches(1) {
                add(span.x[1], span.x[1]);
            }
        }
        found
    }

    /// Returns the parts of a patch that may contain the extreme, from left to right. A patch is a part of a piece.
    fn on_patch(&self, patch: &Patch<S>, piece: usize, budget: &mut Budget) -> Vec<[f64; 2]> {
        let field = patch.fields[self.field].times(S::of(self.sign)).coarse();
        let span = &self.fields.frame.spans[piece];
        let steep = (self.steep[piece] * Size::of(span.half.high())).value();
        let shortest = SHORTEST[usize::from(steep == f64::INFINITY)];
        let mut kept = Vec::new();
        let mut open = vec![patch.interval];
        budget.begin();
        while let Some([a, b]) = open.pop() {
            let m = 0.5 * (a + b);
            let r = half_width(a, m, b);
            let about: Polynomial<S::Coarse> = field.shifted(m);
            if (about.coefficient(0).high() + about.tail(r).value()).next_up() < self.level {
                continue;
            }
            let slope = about.derivative();
            // Neither half can be excluded if the whole interval reaches `level` and its slope is at most `steep`.
            let reaches =
                (about.coefficient(0).low() - about.tail(r).value()).next_down() >= self.level;
            if reaches && (slope.coefficient(0).size() + slope.tail(r).value()).next_up() <= steep
                || about.tail(r) == Size::ZERO
            {
                kept.push([a, b]);
                continue;
            }
            let [low, high] = [slope.coefficient(0).low(), slope.coefficient(0).high()];
            let least = if low > 0.0 { low } else { -high };
            if (least - slope.tail(r).value()).next_down() > steep {
                continue;
            }
            if b - a > shortest && budget.take() {
                open.extend([[m, b], [a, m]]);
            } else {
                kept.push([a, b]);
            }
        }
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::{PlacedExtreme, Search, search};
    use crate::bounds::{Bound, Bounds};
    use crate::document::Extreme;
    use crate::fields::Fields;
    use crate::given_claim::with_fields;
    use crate::patches::{FIELDS, Patches, field_named};
    use crate::polynomial::Budget;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::wide::Wide;
    use serde_json::json;

    /// Checks two distances from the listed position of an extreme: the distance to the nearest proven interval, and
    /// the distance to the farther end of this interval.
    #[test]
    fn a_listed_place_is_compared_with_the_nearest_interval() {
        for (listed, places, distance, error) in [
            (1.0, vec![[1.0, 1.0]], 0.0, 0.0),
            (1.0, vec![[1.0, 1.5]], 0.0, 0.5),
            (1.5, vec![[1.0, 1.5]], 0.0, 0.5),
            (1.125, vec![[1.0, 1.5]], 0.0, 0.375),
            (1.375, vec![[1.0, 1.5]], 0.0, 0.375),
            (0.75, vec![[1.0, 1.5], [3.0, 4.0]], 0.25, 0.75),
            (1.75, vec![[1.0, 1.5], [3.0, 4.0]], 0.25, 0.75),
            (2.75, vec![[1.0, 1.5], [3.0, 4.0]], 0.25, 1.25),
            (1.0, vec![], 0.0, f64::INFINITY),
        ] {
            let field = "moment".to_owned();
            let placed = PlacedExtreme { field, is_max: true, listed, places };
            assert_eq!(placed.distance(), distance, "{placed:?}");
            let off = placed.error();
            assert!(off >= error && (off == error || off - error < 1e-15), "{placed:?}: {off}");
        }
    }

    /// Passes the fields of a beam with length 1 and EI = 1 out of contact to `of`. `deflection` contains the
    /// coefficients of w in t.
    fn with_beam(deflection: &[f64], shears: bool, of: impl FnOnce(&Fields<Wide>, &Patches<Wide>)) {
        let stiffness = if shears { "shear_stiffness = 1\n" } else { "" };
        let model = format!("[foundation]\nk = 1\n[beam]\nlength = 1\nEI = 1\n{stiffness}");
        let mut piece =
            json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": deflection});
        if shears {
            piece["rotation"] = json!([0.25]);
        }
        with_fields(&model, &json!({"pieces": [piece]}), |fields| of(fields, &Patches::of(fields)));
    }

    /// Checks the limits of the search: `level` is the largest known value of the field minus twice its error bound,
    /// and `steep` is the error bound of its derivative.
    #[test]
    fn the_errors_of_a_field_and_of_its_derivative_bound_the_search() {
        let error = |error: f64| Bound { error, scale: 1.0 };
        let bounds = Bounds {
            deflection: error(0.01),
            slope: error(0.02),
            rotation: error(0.03),
            moment: error(0.04),
            shear_force: error(0.05),
            settlement: error(0.06),
            pressure: error(0.07),
        };
        for shears in [false, true] {
            with_beam(&[1.0, 0.0], shears, |fields, patches| {
                for (field, error, steep) in [
                    ("deflection", 0.01, Some(0.02)),
                    ("slope", 0.02, (!shears).then_some(0.04)),
                    ("rotation", 0.03, Some(0.04)),
                    ("moment", 0.04, Some(0.05)),
                    ("shear_force", 0.05, None),
                    ("settlement", 0.06, None),
                    ("gap", 0.07, None),
                ] {
                    for is_max in [true, false] {
                        let extreme =
                            Extreme { field: field.to_owned(), is_max, x: 0.0, value: 0.0 };
                        let found = search(&extreme, fields, patches, &bounds).expect("a search");
                        let index = field_named(field).expect("a field");
                        let sign = if is_max { 1.0 } else { -1.0 };
                        let top =
                            sign * patches.pieces[0][0].fields[index].value(Wide::of(1.0)).middle();
                        let level = top - 2.0 * error;
                        assert!(
                            (found.level - level).abs() < 1e-12 && found.level <= level + 1e-15,
                            "{field}"
                        );
                        let steep = steep.unwrap_or(f64::INFINITY);
                        let near = (found.steep[0].value() / steep - 1.0).abs() < 1e-12;
                        assert!(near || found.steep[0].value() == steep, "{field} {steep}");
                    }
                }
                let extreme =
                    Extreme { field: "pressure".to_owned(), is_max: true, x: 0.0, value: 0.0 };
                assert!(search(&extreme, fields, patches, &bounds).is_none());
            });
        }
    }

    /// w = 1 − t². The values reach the level 1 − s² for |t| ≤ s, and the slopes are at most 2s there.
    #[test]
    fn a_search_excludes_small_values_and_steep_parts() {
        assert_eq!(FIELDS[0].0, "deflection");
        with_beam(&[1.0, 0.0, -1.0], false, |fields, patches| {
            let kept = |sign: f64, level: f64, steep: f64| {
                let steep = vec![Size::of(steep)];
                let search = Search { fields, field: 0, sign, level, steep };
                search.on_patch(&patches.pieces[0][0], 0, &mut Budget::new(4))
            };
            for s in [0.1, 0.25, 0.7] {
                // The third argument of `kept` is the largest |dw/dx| that is not excluded. Since x = ½(t + 1), dw/dx = 2 dw/dt.
                for found in [kept(1.0, 1.0 - s * s, f64::INFINITY), kept(1.0, -9.0, 4.0 * s)] {
                    let [from, to] = [found[0][0], found[found.len() - 1][1]];
                    assert!(
                        from <= -s && -s - 1e-6 < from && s <= to && to < s + 1e-6,
                        "{s}: {from} {to}"
                    );
                    assert!(
                        found.windows(2).all(|pair| pair[0][1] == pair[1][0]),
                        "{s}: {found:?}"
                    );
                }
                let ends = kept(-1.0, s * s - 1.0, f64::INFINITY);
                let inner = ends.windows(2).find(|pair| pair[0][1] < pair[1][0]).expect("a gap");
                assert!(
                    (inner[0][1] + s).abs() < 1e-6 && (inner[1][0] - s).abs() < 1e-6,
                    "{inner:?}"
                );
            }
            // Neither half of an interval is excluded.
            assert_eq!(kept(1.0, -9.0, f64::INFINITY).len(), 1);
            assert_eq!(kept(1.0, -9.0, 4.1).len(), 1);
            assert_eq!(kept(1.0, 1.1, f64::INFINITY).len(), 0);
        });
    }
}
