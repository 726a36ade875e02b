//! Beam, ground, loads and claimed deflection for each piece of a claimed solution, and loads and supports at each node.

use crate::answer::{Answer, Piece};
use crate::beside::Row;
use crate::coefficient::Coefficient;
use crate::compression::Compression;
use crate::model::Acts;
use crate::polynomial::{HIGHEST, Line, Polynomial};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::units::Units;

/// A piece of the beam. Its local coordinate is t = (x − `middle`)/`half`, with the midpoint and half the length of the piece.
#[derive(Debug, Clone)]
pub(crate) struct Span<S> {
    /// Exact positions of the two ends of the piece.
    pub x: [S; 2],
    /// Length of the piece.
    pub h: S,
    /// Midpoint between the stored ends of the piece.
    pub middle: S,
    pub half: S,
    /// 1/`half`, the factor that converts a derivative with respect to the local coordinate t to a derivative with respect to x.
    pub per_length: S,
    /// Values of the local coordinate t at the left and right end of the piece.
    pub t: [S; 2],
    /// Largest |t| on the piece, but at least 1, where t is the local coordinate.
    pub tau: f64,
    /// ∫tʲ dt over the piece, where t is the local coordinate.
    powers: Vec<S>,
    pub touches: bool,
    /// Claimed deflection w, as a polynomial in the local coordinate t.
    pub deflection: Polynomial<S>,
    /// Rotation φ of a piece with shear deformation, as a polynomial in the local coordinate t; `None` if φ = w′.
    pub rotation: Option<Box<Polynomial<S>>>,
    /// Bending stiffness EI.
    pub bending: Coefficient<S>,
    /// Shear stiffness S of a beam with shear deformation.
    pub stiffness: Option<Coefficient<S>>,
    /// Subgrade modulus k.
    pub spring: Coefficient<S>,
    /// Stiffness μ of the shear layer; exactly 0 on Winkler ground.
    pub shear: Coefficient<S>,
    /// Whether μ > 0.
    pub layered: bool,
    /// Distributed force f on the beam, linear in the local coordinate t.
    pub force: Line<S>,
    /// Distributed moment g on the beam, linear in the local coordinate t.
    pub moment: Line<S>,
    /// Imposed curvature κ₀ of the beam, linear in the local coordinate t.
    pub curvature: Line<S>,
    /// Initial gap g₀ between beam and ground, linear in the local coordinate t.
    pub gap: Line<S>,
    /// Distributed load q on the ground, linear in the local coordinate t; `None` without such a load.
    pub ground_load: Option<Line<S>>,
    /// Ground displacement u at the two ends of a piece out of contact, as stored numbers; `None` if not stored.
    pub stored: Option<[S; 2]>,
    /// Ground displacement u along a piece out of contact, as a stored polynomial; `None` if not stored.
    pub settlement: Option<Box<Polynomial<S>>>,
}

/// A node: a position between two pieces, or an end of the beam.
#[derive(Debug, Clone)]
pub(crate) struct Node<S> {
    pub x: S,
    /// Point force on the beam at the node.
    pub force: S,
    /// Point moment on the beam at the node.
    pub moment: S,
    /// Point force Q on the ground at the node.
    pub ground_force: S,
    /// Settlement of the rigid support at the node; `None` without a rigid support.
    pub rigid: Option<S>,
    /// Whether a clamp at the node restrains the slope.
    pub clamped: bool,
    /// Directions in which the support at the node can act. A node with a one-way support has no other support.
    pub acts: Acts,
    /// Σκ and Σκδ of the translational springs at the node, with stiffness κ and settlement δ of each spring.
    pub spring: Option<[S; 2]>,
    /// Sum of the stiffnesses of the rotational springs at the node.
    pub turning: Option<S>,
    /// Rotational stiffness k_φ of a hinge at the node; exactly 0 for a free hinge, `None` without a hinge.
    pub hinge: Option<S>,
    /// Claimed reaction of the rigid supports: upward force, and moment that turns the beam on the right upward.
    pub reaction: [S; 2],
    /// Weighting factors of the supports at the node in the redistribution of residual forces.
    pub weights: Weights,
    /// Whether the claimed solution has a positive concentrated contact force at the node.
    pub pressed: bool,
    /// Whether the gap g₀ has a corner at the node.
    pub corner: bool,
    /// Whether the stiffness μ of the shear layer or the shear stiffness S of the beam jumps at the node.
    pub stepped: bool,
    /// Whether the free-field settlement q/k of Winkler ground may jump at the node: k jumps, or a load on the ground ends.
    pub uneven: bool,
}

/// Weighting factors of the supports in the redistribution of residual forces. Equilibrium holds for any positive factors.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Weights {
    /// Weighting factor W of a rigid support. Correcting the contact pressure p by λp changes the reaction of the support by λW.
    pub rigid: f64,
    /// Weighting factor W of a translational spring. Correcting the contact pressure p by λp changes the spring force by λW.
    pub spring: f64,
    /// Weighting factor W_θ of a clamp. Correcting the contact pressure p by λ(x)p changes the moment of the clamp by λ′W_θ.
    pub clamp: f64,
    /// Weighting factor W_θ of a rotational spring. Correcting the contact pressure p by λ(x)p changes the spring moment by
    /// λ′W_θ.
    pub turning: f64,
}

/// A support of the model, and its reaction in the claimed solution.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Held<S> {
    pub x: S,
    pub acts: Acts,
    /// Node of the support; `None` for an inactive support (a one-way support without reaction), which may lie inside a piece.
    pub node: Option<usize>,
    /// Stiffnesses κ and κ_θ of a translational and a rotational spring; `None` for a rigid support.
    pub springs: Option<[S; 2]>,
    /// Settlement δ of the support.
    pub settlement: S,
    /// Claimed reaction: the upward force, and the moment that turns the right side of the beam downward.
    pub claimed: [S; 2],
}

/// The model (beam, ground, loads, supports) and the claimed deflection, divided into the pieces of the claimed solution.
#[derive(Debug)]
pub(crate) struct Frame<S> {
    pub spans: Vec<Span<S>>,
    pub nodes: Vec<Node<S>>,
    /// The supports of the model, in the order of the model.
    pub supports: Vec<Held<S>>,
    /// Tension P; `None` if P ≤ 0.
    pub tension: Option<S>,
    /// Weighting factor B > 0 of the tension. Correcting the contact pressure p by λ(x)p adds the transverse force Bλ′.
    pub carrier: f64,
    /// Data of the axial compression; `None` if the axial force P (positive in tension) is zero or positive.
    pub compression: Option<Compression<S>>,
    /// Stiffnesses K₀ and K_l of the ground beyond the left and right end of the beam; exactly 0 without such ground.
    pub outside: [S; 2],
    /// Downward forces T₀ and T_l at the ends of the beam due to loads on the ground beyond it. If an end moves down by u,
    /// the ground beyond it exerts the upward force Ku − T, where K is its stiffness.
    pub pushed: [S; 2],
    /// Ground outside the two ends of the beam. `outside` and `pushed` follow from this ground.
    pub rows: [Row<S>; 2],
    pub length: S,
    pub units: Units,
}

impl<S: Scalar> Node<S> {
    pub fn at(x: S) -> Self {
        let zero = S::zero();
        Node {
            x,
            force: zero,
            moment: zero,
            ground_force: zero,
            rigid: None,
            clamped: false,
            acts: Acts::Both,
            spring: None,
            turning: None,
            hinge: None,
            reaction: [zero; 2],
            weights: Weights::default(),
            pressed: false,
            corner: false,
            stepped: false,
            uneven: false,
        }
    }

    /// Whether a hinge lets the slopes on the two sides of the node differ.
    pub fn is_hinged(&self) -> bool {
        self.hinge.is_some()
    }

    /// Whether the node is a free hinge, which transmits no moment.
    pub fn is_free_hinge(&self) -> bool {
        self.hinge == Some(S::zero())
    }
}

impl<S: Scalar> Span<S> {
    /// Returns a piece with its geometry and claimed fields.
    ///
    /// At the ends of the piece, the local coordinate t must be within ¼ of −1 and 1.
    pub fn of(piece: &Piece, x: [S; 2], units: Units) -> Result<Self, NotProven> {
        let wrong = |what: &str| NotProven::new(what).at(piece.x[0]);
        if piece.deflection.is_empty() {
            return Err(wrong("the deflection of a piece has no coefficients"));
        }
        if piece.pressure.len() > HIGHEST + 1 {
            return Err(wrong("a field has a degree above 25"));
        }
        let field = |coefficients: &[f64], length: i32| {
            if coefficients.len() > HIGHEST + 1 {
                return Err(wrong("a field has a degree above 25"));
            }
            let scaled = coefficients.iter().map(|c| units.scaled(S::of(*c), 0, length));
            let field = Polynomial::from_coefficients(scaled);
            match field.coefficients().iter().all(|c| c.size() <= 1e60) {
                true => Ok(field),
                false => Err(wrong("a coefficient is not finite, or too large")),
            }
        };
        let rotation = match piece.rotation.is_empty() {
            true => None,
            false => Some(Box::new(field(&piece.rotation, 0)?)),
        };
        let settlement = match piece.settlement.is_empty() {
            true => None,
            false => Some(Box::new(field(&piece.settlement, 1)?)),
        };
        let half = units.metres(S::of(piece.half));
        if !(half.low() > 0.0) {
            return Err(wrong("`half` of a piece is not positive"));
        }
        let ends = piece.x.map(|x| units.metres(S::of(x)));
        let middle = (ends[0] + ends[1]).scaled(-1);
        let t = match S::ENCLOSES {
            true => x.map(|x| (x - middle).div(half)),
            // In double precision, x − `middle` would lose digits. The small differences between `x` and `ends` lose none.
            false => {
                let stretch = (ends[1] - ends[0]).scaled(-1);
                [(x[0] - ends[0]) - stretch, (x[1] - ends[1]) + stretch].map(|x| x.div(half))
            }
        };
        let off = [t[0] + S::one(), t[1] - S::one()];
        if !off.iter().all(|off| off.size() <= 0.25) {
            return Err(wrong("`half` contradicts the ends of the piece"));
        }
        let largest = Size::of(1.0).worst(Size::of(t[0].size())).worst(Size::of(t[1].size()));
        let longest = piece.deflection.len().max(piece.rotation.len()).max(piece.pressure.len());
        let (zero, none) = (S::zero(), Line::zero());
        Ok(Span {
            x,
            h: x[1] - x[0],
            middle,
            half,
            per_length: S::one().div(half),
            t,
            tau: largest.value(),
            powers: powers(t, longest + 4),
            touches: piece.touches,
            deflection: field(&piece.deflection, 1)?,
            rotation,
            bending: Coefficient::Even(zero),
            stiffness: None,
            spring: Coefficient::Even(zero),
            shear: Coefficient::Even(zero),
            layered: false,
            force: none,
            moment: none,
            curvature: none,
            gap: none,
            ground_load: None,
            stored: piece.open.map(|ends| ends.map(|u| units.metres(S::of(u)))),
            settlement,
        })
    }

    /// Whether k and μ are constant on the piece.
    pub fn has_even_ground(&self) -> bool {
        self.spring.even().is_some() && self.shear.even().is_some()
    }

    /// Returns an upper bound of the length of the piece.
    pub fn length(&self) -> Size {
        Size::of(self.h.high())
    }

    /// Returns the linear function through two points (x, value), as a polynomial in the coordinate t of the piece.
    pub fn line(&self, [from, to]: [S; 2], [start, end]: [S; 2]) -> Line<S> {
        if start == end {
            return Line::from_coefficients([start]);
        }
        let slope = (end - start).div(to - from);
        Line::from_coefficients([start + slope * (self.middle - from), slope * self.half])
    }

    /// Returns ∫tᵏp dx over the piece for k = 0, …, N − 1, with the local coordinate t of the piece.
    pub fn integrals<const N: usize>(&self, p: &Polynomial<S>) -> [S; N] {
        let c = p.coefficients();
        let count = c.len() + N;
        let more = (count > self.powers.len() + 1).then(|| powers(self.t, count));
        let powers = more.as_ref().unwrap_or(&self.powers);
        std::array::from_fn(|k| {
            let terms = c.iter().zip(&powers[k..]);
            terms.fold(S::zero(), |sum, (c, power)| sum + *c * *power) * self.half
        })
    }

    /// Returns the derivative of p with respect to x.
    pub fn derivative(&self, p: &Polynomial<S>) -> Polynomial<S> {
        p.derivative_times(self.per_length)
    }

    /// Slope g₀′ of the initial gap.
    pub fn gap_slope(&self) -> S {
        self.gap.coefficient(1) * self.per_length
    }

    /// Returns the free-field settlement q/k under the load q on the ground; `None` if k varies or if there is no such load.
    pub fn free_field(&self) -> Option<Line<S>> {
        let spring = self.spring.even()?;
        self.ground_load.as_ref().map(|load| load.times(S::one().div(spring)))
    }

    /// Returns u − q/k at the ends of the piece, from the ground displacement u at these ends. q is the load on the ground.
    pub fn above_free_ends(&self, [left, right]: [S; 2]) -> [S; 2] {
        match self.free_field() {
            None => [left, right],
            Some(free) => [left - free.value(self.t[0]), right - free.value(self.t[1])],
        }
    }

    /// Returns w − g₀ − q/k: the deflection minus the initial gap and the free-field settlement.
    pub fn above_free_field(&self) -> Polynomial<S> {
        match self.free_field() {
            None => self.obstacle(),
            Some(free) => self.obstacle() - &free,
        }
    }

    /// Returns w − g₀, the deflection minus the initial gap.
    pub fn obstacle(&self) -> Polynomial<S> {
        self.deflection - &self.gap
    }

    /// Returns the pressure ku − q − (μ(w − g₀)′)′ of a beam in contact. `settlement` is u in the first term.
    pub fn pressure_under(&self, settlement: &Polynomial<S>) -> Polynomial<S> {
        let mut pressure = self.spring.times(*settlement);
        if self.layered {
            let gap = Line::from_coefficients([self.gap_slope()]);
            let flux = self.shear.times(self.derivative(&self.deflection) - &gap);
            pressure = pressure - &self.derivative(&flux);
        }
        match &self.ground_load {
            None => pressure,
            Some(load) => pressure - load,
        }
    }

    /// Upper bound of |dc/dx| on the piece, where the coefficient c is EI, k, μ or the shear stiffness S.
    pub fn steepness(&self, coefficient: &Coefficient<S>) -> Size {
        coefficient.along().map_or(Size::ZERO, |along| self.derivative(along).size(self.tau))
    }

    /// Returns the bending moment M = −EI (φ′ − κ₀), with the imposed curvature κ₀.
    pub fn bending_moment(&self, rotation: &Polynomial<S>) -> Polynomial<S> {
        self.bending.times(rotation.derivative_times(-self.per_length) + &self.curvature)
    }

    /// Returns the shear force V = M′ − g, with the distributed moment g.
    pub fn shear_force(&self, moment: &Polynomial<S>) -> Polynomial<S> {
        self.derivative(moment) - &self.moment
    }

    /// Returns a lower and an upper bound of the local coordinate t on the piece, in double precision.
    pub fn interval(&self) -> [f64; 2] {
        [self.t[0].low(), self.t[1].high()]
    }
}

/// Returns the integrals ∫tʲ from t_L to t_R for j = 0, …, `count` − 1.
fn powers<S: Scalar>(ends: [S; 2], count: usize) -> Vec<S> {
    let mut power = ends;
    let integral = |j: usize| {
        let integral = (power[1] - power[0]).div(S::of(j as f64));
        power = [power[0] * ends[0], power[1] * ends[1]];
        integral
    };
    (1..=count).map(integral).collect()
}

impl<S: Scalar> Frame<S> {
    /// Returns the largest penetration that is neglected: 10⁻²⁴ times the largest |w| at the middles of the pieces.
    pub fn negligible(&self) -> Size {
        let sizes = self.spans.iter().map(|span| span.deflection.coefficient(0).size());
        Size::of(1e-24 * sizes.fold(0.0, f64::max))
    }

    /// Whether the ground on the left and on the right of a node has a shear layer.
    pub fn layered(&self, node: usize) -> [bool; 2] {
        let left = node > 0 && self.spans[node - 1].layered;
        [left, self.spans.get(node).is_some_and(|span| span.layered)]
    }

    /// Whether the pieces on the left and on the right of a node touch the ground.
    pub fn touching(&self, node: usize) -> [bool; 2] {
        let left = node > 0 && self.spans[node - 1].touches;
        [left, self.spans.get(node).is_some_and(|span| span.touches)]
    }

    /// Whether a node lies inside a shear layer and has no hinge, no point force on the ground, and no jump of μ or of
    /// the shear stiffness.
    pub fn even(&self, node: usize) -> bool {
        self.layered(node) == [true; 2]
            && !self.nodes[node].stepped
            && self.nodes[node].ground_force == S::zero()
            && !self.nodes[node].is_hinged()
    }

    /// Whether a point force or a reaction causes a jump of the slope at a node. This requires shear deformation.
    pub fn kinks(&self, node: usize) -> bool {
        let here = &self.nodes[node];
        let forced = here.force != S::zero() || here.rigid.is_some() || here.spring.is_some();
        let beside = [node.checked_sub(1), Some(node)].into_iter().flatten();
        let shears = |i: usize| self.spans.get(i).is_some_and(|span| span.stiffness.is_some());
        forced && beside.into_iter().any(shears)
    }

    /// Whether [`Frame::even`] is true and the initial gap has no corner at the node. With shear deformation, the node
    /// must also have no point force and no support.
    pub fn smooth(&self, node: usize) -> bool {
        self.even(node) && !self.nodes[node].corner && !self.kinks(node)
    }

    /// Whether any piece of the beam has shear deformation.
    pub fn shears(&self) -> bool {
        self.spans.iter().any(|span| span.stiffness.is_some())
    }

    /// Axial force P; `None` if P = 0.
    pub fn axial_force(&self) -> Option<S> {
        self.tension.or(self.compression.as_ref().map(|compression| -compression.force))
    }

    /// Returns the position of a node in the units of the model.
    pub fn place(&self, node: usize) -> f64 {
        self.units.restored(self.nodes[node].x.middle(), 0, 1)
    }
}

/// Returns the pieces of a claimed solution. `exact` contains the exact positions of their ends.
pub(crate) fn spans<S: Scalar>(
    answer: &Answer,
    exact: &[S],
    units: Units,
) -> Result<Vec<Span<S>>, NotProven> {
    let ends = exact.windows(2).map(|ends| [ends[0], ends[1]]);
    let mut spans = Vec::with_capacity(answer.pieces.len());
    for (piece, x) in answer.pieces.iter().zip(ends) {
        spans.push(Span::of(piece, x, units)?);
    }
    Ok(spans)
}
