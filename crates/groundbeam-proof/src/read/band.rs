//! Reads `[foundation.band]`: the factors on k and μ, and the names of the resulting variants of the ground.

use super::error::{Read, wrong};
use super::fields::{Fields, NUMBER, Quantity, Section};
use super::toml::{Node, Value};
use crate::{Course, Ground, Scalar};

/// A variant of the ground: its name, and the factors on k and μ.
#[derive(Debug, Clone)]
pub(crate) struct Factored<S> {
    pub name: String,
    factors: [S; 2],
}

/// A factor on k or μ: first in the number type of the proof, then as the double that is printed in the name of the
/// resulting variant of the ground.
type Step<S> = (S, f64);

/// Returns the variants of the ground: the best estimate first, then every other combination of the low, best and high
/// factors on k and μ. The list is empty if the file has no `[foundation.band]`.
pub(crate) fn read<S: Scalar>(
    fields: &mut Fields,
    root: Section,
    ground: &Ground<S>,
) -> Read<Vec<Factored<S>>> {
    let Some(foundation) = root.table("foundation")? else { return Ok(Vec::new()) };
    let Some(table) = foundation.table("band")? else { return Ok(Vec::new()) };
    table.only(&[&["k", "mu"]], &[])?;
    let [k, mu] = ["k", "mu"].map(|key| table.table.get(key));
    if k.is_none() && mu.is_none() {
        return table.missing("k");
    }
    let is_layer = |mu: &S| mu.middle() != 0.0;
    let mut layers = ground.segments.iter().flat_map(|s| super::course::values(&s.shear));
    let shears = is_layer(&ground.shear) || layers.any(is_layer);
    if let (Some(mu), false) = (mu, shears) {
        return wrong(
            mu.at,
            "`[foundation.band]` has factors for `mu`, but the ground has no shear layer",
        );
    }
    let [k, mu] = [factors(fields, k, "k")?, factors(fields, mu, "mu")?];
    let changes = [&k, &mu].map(|steps: &[Step<S>; 3]| (steps[0].1, steps[2].1) != (1.0, 1.0));
    let best = Factored { name: "best ground".to_owned(), factors: [S::one(); 2] };
    let mut grounds: Vec<([f64; 2], Factored<S>)> = vec![([1.0; 2], best)];
    for spring in &k {
        for shear in &mu {
            let doubles = [spring.1, shear.1];
            if grounds.iter().any(|(known, _)| *known == doubles) {
                continue;
            }
            let parts = [(changes[0], spring.1, "k"), (changes[1], shear.1, "mu")];
            let parts = parts.into_iter().filter(|(changes, ..)| *changes);
            let parts: Vec<String> = parts.map(|(_, f, key)| format!("{f} {key}")).collect();
            let factored = Factored { name: parts.join(", "), factors: [spring.0, shear.0] };
            grounds.push((doubles, factored));
        }
    }
    Ok(grounds.into_iter().map(|(_, factored)| factored).collect())
}

/// Returns the factors on k or on μ for the low value, the best estimate and the high value.
fn factors<S: Scalar>(
    fields: &mut Fields,
    node: Option<&Node>,
    key: &'static str,
) -> Read<[Step<S>; 3]> {
    let best = (S::one(), 1.0);
    let Some(node) = node else { return Ok([best; 3]) };
    let Value::List(list) = &node.value else {
        return wrong(node.at, format!("the band of `{key}` must be a list of two factors"));
    };
    let [low, high] = &list[..] else {
        return wrong(node.at, format!("the band of `{key}` must be a list of two factors"));
    };
    let [low, high] = [step(fields, low, key)?, step(fields, high, key)?];
    let least = if key == "mu" { low.1 >= 0.0 } else { low.1 > 0.0 };
    if !(least && low.1 <= 1.0 && high.1 >= 1.0) {
        return wrong(node.at, format!("the band of `{key}` must include the factor 1"));
    }
    Ok([low, best, high])
}

fn step<S: Scalar>(fields: &mut Fields, node: &Node, key: &str) -> Read<Step<S>> {
    let Quantity { value, exact, .. } = fields.one::<S>(node, key, NUMBER)?;
    // The double nearest to the exact factor is printed in the name of the ground variant.
    Ok((value, exact.value::<f64>().unwrap_or(f64::NAN)))
}

impl<S: Scalar> Factored<S> {
    /// Multiplies k and μ of the whole ground by the factors.
    pub fn applied(&self, ground: Ground<S>) -> Ground<S> {
        let [spring, shear] = self.factors;
        let mut segments = ground.segments;
        for segment in &mut segments {
            segment.spring = along(&segment.spring, spring);
            segment.shear = along(&segment.shear, shear);
        }
        let [spring, shear] = [times(ground.spring, spring), times(ground.shear, shear)];
        Ground { spring, shear, segments, ..ground }
    }
}

/// Multiplies `value` by `factor`. The product is exactly 0 if one of them is exactly 0, because μ must be exactly 0
/// where the ground has no shear layer.
fn times<S: Scalar>(value: S, factor: S) -> S {
    if value.size() == 0.0 || factor.size() == 0.0 { S::zero() } else { value * factor }
}

fn along<S: Scalar>(course: &Course<S>, factor: S) -> Course<S> {
    match course {
        Course::Constant(value) => Course::Constant(times(*value, factor)),
        Course::Varying(values) => {
            Course::Varying(values.iter().map(|value| times(*value, factor)).collect())
        }
    }
}
