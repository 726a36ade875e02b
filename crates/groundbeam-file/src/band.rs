//! Represents uncertain ground by lower and upper factors on k and μ, and lists their combinations.

/// Lower and upper factors on k and μ, relative to their best estimates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// Lower and upper factor on the subgrade modulus k.
    pub spring: [f64; 2],
    /// Lower and upper factor on the stiffness μ of the shear layer.
    pub shear: [f64; 2],
}

impl Band {
    /// Returns the pairs of factors on k and μ: first the best estimates (1, 1), then all combinations of lower
    /// factor, 1 and upper factor.
    pub fn grounds(&self) -> Vec<[f64; 2]> {
        let mut grounds = vec![[1.0, 1.0]];
        for spring in steps(self.spring) {
            for shear in steps(self.shear) {
                if !grounds.contains(&[spring, shear]) {
                    grounds.push([spring, shear]);
                }
            }
        }
        grounds
    }

    /// Returns the name of the ground with these factors, such as `best ground` or `0.5 k, 2 mu`.
    pub fn name(&self, ground: [f64; 2]) -> String {
        if ground == [1.0, 1.0] {
            return "best ground".to_owned();
        }
        let of = |name: &str, range: [f64; 2], factor: f64| {
            (range != [1.0, 1.0]).then(|| format!("{factor} {name}"))
        };
        let [spring, shear] = ground;
        let parts = [of("k", self.spring, spring), of("mu", self.shear, shear)];
        parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }
}

fn steps([low, high]: [f64; 2]) -> [f64; 3] {
    [low, 1.0, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_band_has_at_most_nine_grounds() {
        let band = Band { spring: [0.5, 2.0], shear: [0.0, 3.0] };
        let grounds = band.grounds();
        assert_eq!((grounds.len(), grounds[0]), (9, [1.0, 1.0]));
        assert_eq!(band.name([0.5, 3.0]), "0.5 k, 3 mu");
        let springs = Band { shear: [1.0, 1.0], ..band };
        assert_eq!(springs.grounds(), [[1.0, 1.0], [0.5, 1.0], [2.0, 1.0]]);
        assert_eq!(springs.name([2.0, 1.0]), "2 k");
    }
}
