//! Constructs an admissible deflection and forces in equilibrium from a claimed solution, and bounds its error energy by E.

use crate::balance::{Balance, Balanced};
use crate::clearance::{Clearance, clearance};
use crate::cuts::{fewest_cuts, more_cuts};
use crate::deflection::{Deflection, admissible};
use crate::frame::Frame;
use crate::ground::{Surface, surface};
use crate::model::Acts;
use crate::polynomial::Budget;
use crate::pressure::{Pressure, carried, pressures, tension_norm};
use crate::refusal::NotProven;
use crate::residual::{Residual, residual};
use crate::scalar::Scalar;
use crate::shearing::shearing_energy;
use crate::size::Size;

/// The fields that are constructed from a claimed solution, for the bound E of the error energy.
pub(crate) struct Fields<'a, S> {
    pub frame: &'a Frame<S>,
    pub deflection: Deflection<S>,
    pub surface: Surface<S>,
    pub pressures: Vec<Pressure<S>>,
    pub residual: Residual<S>,
    pub clearance: Clearance,
    /// Upper bounds of ∫EI c″² and ∫c′² over the beam, with the correction c of the deflection.
    pub closing: [Size; 2],
    /// Upper bound of the norm of the residual of the ground equation, Y₀ in section 3 of docs/proof.md.
    missed: Size,
}

impl<'a, S: Scalar> Fields<'a, S> {
    pub fn of(frame: &'a Frame<S>) -> Result<Self, NotProven> {
        let mut budget = Budget::new(frame.spans.len());
        let deflection = admissible(frame)?;
        let surface = surface(frame, &deflection);
        let pressures = pressures(frame, &mut budget);
        let residual = residual(frame, &deflection, &surface, &pressures);
        let clearance = clearance(frame, &deflection, &surface, &mut budget);
        let closing = closing(frame, &deflection);
        let missed = carried(frame, &deflection).root()
            + surface.unclaimed
            + tension_norm(frame, &pressures);
        Ok(Fields { frame, deflection, surface, pressures, residual, clearance, closing, missed })
    }

    /// Returns the bound of the error energy and the corrections from which it follows. The axial tension takes part
    /// only if pressures and supports alone cannot balance the loads.
    pub fn energy(&self) -> Result<(Size, Balanced<S>), NotProven> {
        match (self.least_energy(0.0), self.frame.tension) {
            (Err(_), Some(_)) => self.least_energy(self.frame.carrier),
            (found, _) => found,
        }
    }

    /// Estimates, without proof, the error energy if contact and supports cannot balance the loads, as on a single pin.
    /// A fictitious transverse force balances the loads. Its work is added; work above `rounding` is an error.
    pub fn nearly_balanced_energy(&self, rounding: f64) -> Result<Size, NotProven> {
        let (energy, balanced) = self.least_energy(self.frame.carrier)?;
        let work = |i: usize| {
            let slope = self.deflection.claimed[i].slope.map(|slope| Size::of(slope.size()));
            balanced.pieces[i].drawn * self.frame.spans[i].length() * slope[0].worst(slope[1])
        };
        let added = 2.0 * (0..self.frame.spans.len()).map(work).sum::<Size>();
        if added.value() <= rounding {
            return Ok(energy + added);
        }
        Err(NotProven::new("the contact pressure does not balance the loads"))
    }

    /// Balances the residual forces with few and with more cuts of the beam, and returns the result with the smaller
    /// energy bound. `carrier` is the weighting factor of the axial tension.
    fn least_energy(&self, carrier: f64) -> Result<(Size, Balanced<S>), NotProven> {
        let (few, more) = (fewest_cuts(self.frame), more_cuts(self.frame));
        let with_more = (more.len() > few.len()).then(|| self.energy_with(more, carrier));
        match (self.energy_with(few, carrier), with_more) {
            (few, None) => few,
            (Err(_), Some(more)) => more,
            (few, Some(Err(_))) => few,
            (Ok(few), Some(Ok(more))) => Ok(if more.0 < few.0 { more } else { few }),
        }
    }

    /// Computes the bound of the error energy by (11) of docs/proof.md, or under compression by (2a). The beam is cut
    /// at the nodes `cuts` for the balance of the residual forces.
    fn energy_with(
        &self,
        cuts: Vec<usize>,
        carrier: f64,
    ) -> Result<(Size, Balanced<S>), NotProven> {
        let (frame, surface) = (self.frame, &self.surface);
        let (pressures, residual) = (&self.pressures, &self.residual);
        let balance = Balance { frame, surface, pressures, residual, cuts, carrier };
        let balanced = balance.solve()?;
        let given_back = balance.ground(&balanced, &self.deflection, self.missed).root();
        let ground = self.missed + given_back + self.clearance.lifted + self.clearance.risen;
        let [bent, turned] = self.closing;
        let beam = balance.bending(&balanced).root() + bent.root();
        let supports = self.supports(&balanced) + self.hinges(&balanced);
        let sheared = shearing_energy(frame, &self.residual, &balanced);
        let beam = beam.square() + sheared + supports;
        let closed = turned * Size::of(frame.tension.map_or(0.0, S::high));
        let drawn = closed.root() + balance.drawn(&balanced).root();
        let beam = match &frame.compression {
            None => beam + drawn.square(),
            Some(compression) => {
                (beam.root() + compression.misfit(turned)).square().over(compression.margin)
            }
        };
        let energy = 0.5 * (beam + ground.square());
        Ok((energy, balanced))
    }

    /// Returns a bound of the sum of (residual force)²/stiffness over all translational and rotational springs, for
    /// (11) of docs/proof.md.
    fn supports(&self, balanced: &Balanced<S>) -> Size {
        let mut sum = Size::ZERO;
        let missed = |stiffness: S, change: S, added: Size| {
            let force = Size::of(stiffness.high()) * Size::of(change.size()) + added;
            force.square().over(stiffness.low())
        };
        for (i, node) in self.frame.nodes.iter().enumerate() {
            let [w, _] = self.deflection.at_support(i);
            if let Some([spring, _]) = node.spring {
                let factor = Size::of(balanced.factors[i].size());
                sum += match node.acts {
                    Acts::Both => {
                        let added = factor * Size::of(node.weights.spring);
                        missed(spring, self.deflection.values[i] - w, added)
                    }
                    _ => missed(
                        spring,
                        S::zero(),
                        factor * Size::of(self.residual.pushing[i].size()),
                    ),
                };
            }
            if let Some(turning) = node.turning {
                let [piece, side] = self.deflection.felt[i];
                let turned = self.deflection.pieces[piece].slope[side];
                // A couple belongs to the cell on its right; at the right end of the beam, it belongs to the cell
                // on its left.
                let cell = if i < self.frame.spans.len() { i } else { i - 1 };
                let added = balanced.pieces[cell].steepness * Size::of(node.weights.turning);
                sum += missed(turning, turned, added);
            }
        }
        sum
    }

    /// Returns Σ(k_φθ + m)²/k_φ, the squared norm of the residuals of the elastic hinges. k_φ is the rotational
    /// stiffness of a hinge, θ its rotation, and m the moment at the hinge.
    fn hinges(&self, balanced: &Balanced<S>) -> Size {
        let mut sum = Size::ZERO;
        for (i, node) in self.frame.nodes.iter().enumerate() {
            let Some(spring) = node.hinge.filter(|_| !node.is_free_hinge()) else { continue };
            let slope = |piece: usize, side: usize| {
                self.deflection.claimed[piece].rotation[side]
                    + self.deflection.pieces[piece].slope[side]
            };
            let turn = slope(i, 0) - slope(i - 1, 1);
            let moment = self.residual.pieces[i - 1].bending[1] + balanced.pieces[i - 1].moments[1];
            let missed =
                Size::of((spring * turn + moment).size()) + balanced.pieces[i - 1].added[0];
            sum += missed.square().over(spring.low());
        }
        sum
    }
}

/// Returns upper bounds of ∫EI c″² and ∫c′² over the beam, with the correction c of the deflection.
fn closing<S: Scalar>(frame: &Frame<S>, deflection: &Deflection<S>) -> [Size; 2] {
    let mut both = [Size::ZERO; 2];
    for (span, c) in frame.spans.iter().zip(&deflection.pieces) {
        both[0] += span.length() * Size::of(span.bending.high()) * c.bounds[2].square();
        both[1] += span.length() * c.bounds[1].square();
    }
    both
}

#[cfg(test)]
mod tests {
    use crate::given_claim::{balanced, with_fields};
    use crate::pressure::carried;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::wide::Wide;
    use serde_json::json;

    /// Checks the norms of the correction of a claimed deflection. Each piece is longer than (4EI/k)^¼, so its
    /// correction is a cubic.
    #[test]
    fn the_norms_of_the_correction_are_sums_over_the_pieces() {
        let text = "[beam]\nlength = 12\nEI = 50\n[foundation]\nk = 10\nmu = 7\n";
        let ends = [0.0, 3.0, 7.0, 12.0];
        let piece = |i: usize| {
            let w = [[0.0, 0.25, 0.0][i], [0.0, 0.5, -0.5][i]];
            let x = [ends[i], ends[i + 1]];
            json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": true, "deflection": w})
        };
        let pieces = [0, 1, 2].map(piece);
        let document = json!({ "pieces": pieces });
        with_fields(text, &document, |fields| {
            let mut exact = [0.0; 2];
            for (span, c) in fields.frame.spans.iter().zip(&fields.deflection.pieces) {
                let [_, slope, bent] = c.bounds.map(|bound| bound.value());
                exact[0] += span.h.middle() * span.bending.middle() * bent * bent;
                exact[1] += span.h.middle() * slope * slope;
            }
            assert!(exact[0] > 0.0);
            let touching = fields.frame.spans.iter().zip(&fields.deflection.pieces);
            let carried_by = touching.map(|(span, c)| {
                let [value, slope, _] = c.bounds.map(|bound| bound.value());
                let springs = span.spring.middle() * value * value;
                span.h.middle() * (springs + span.shear.middle() * slope * slope)
            });
            let ratio = carried(fields.frame, &fields.deflection).value() / carried_by.sum::<f64>();
            assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
            for (found, exact) in fields.closing.iter().zip(exact) {
                assert!((found.value() / exact - 1.0).abs() < 1e-12, "{found:?} {exact}");
            }
        });
    }

    /// Checks the residual of a hinge with the stiffness 4. The slope jumps by −¼ in the claimed deflection and by 0.2
    /// in the correction.
    #[test]
    fn the_residual_of_an_elastic_hinge_contains_the_correction() {
        let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[hinge]]\nat = 0.5\nrotational_spring = 4\n";
        let piece = |i: usize| {
            let (from, slope) = (0.5 * i as f64, [0.125, 0.0625][i]);
            json!({"x": [from, from + 0.5], "half": 0.25, "touches": false, "deflection": [1.0, slope]})
        };
        with_fields(text, &json!({"pieces": [piece(0), piece(1)]}), |fields| {
            fields.deflection.pieces[0].slope[1] = Wide::of(0.1);
            fields.deflection.pieces[1].slope[0] = Wide::of(0.3);
            for (bent, added) in [(0.0, 0.0), (2.0, 0.0), (2.0, 0.5), (-2.0, 0.0)] {
                let mut balanced = balanced(2);
                balanced.pieces[0].moments[1] = Wide::of(bent);
                balanced.pieces[0].added[0] = Size::of(added);
                balanced.pieces[1].added[0] = Size::of(9.0);
                let exact = ((4.0 * (-0.25 + 0.3 - 0.1) + bent).abs() + added).powi(2) / 4.0;
                let found = fields.hinges(&balanced).value();
                assert!((found / exact - 1.0).abs() < 1e-12, "{bent} {added}: {found} {exact}");
            }
        });
    }
}
