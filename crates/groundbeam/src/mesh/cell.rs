//! A cell: a part of beam and ground within which all given quantities are polynomials.

use crate::ground::link::{between, settled, slope_between};
use crate::mesh::ground_stretch::{GROUND, GroundStretch};
use crate::model::{CellPolynomial, Profile};
use crate::numeric::dual::Dual;
use crate::numeric::polynomial::{Coefficients, jet, product, rescale, value, values};
use crate::numeric::real::Real;
use crate::numeric::roots::varies_little;

/// A part of beam and ground in which EI, k and μ are constant or polynomials. The loads, the imposed curvature
/// κ₀ and the initial gap g₀ are linear in this part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell<R = f64> {
    /// Positions of the left and the right end of the cell \[m\].
    pub x: [f64; 2],
    /// Bending stiffness EI \[N·m²\]. If EI varies, this is its value at the middle of the cell.
    pub stiffness: R,
    /// Subgrade modulus k \[N/m²\]. If k varies, this is its value at the middle of the cell.
    pub subgrade: R,
    /// Stiffness μ of the shear layer \[N\]. If μ varies, this is its value at the middle of the cell.
    pub shear_layer: R,
    /// Coefficients of the beam's shear stiffness S(s) \[N\]; `None` without shear deformation.
    pub beam_shear: Option<[R; Profile::MOST]>,
    /// Variation of EI, k and μ along the cell.
    pub varies: Varies<R>,
    /// Distributed load f on the beam at both ends of the cell \[N/m\].
    pub load: [R; 2],
    /// Distributed moment g on the beam at both ends of the cell \[N·m/m\].
    pub moment_load: [R; 2],
    /// Imposed curvature κ₀ at both ends of the cell \[1/m\].
    pub curvature: [R; 2],
    /// Initial gap g₀ at both ends of the cell \[m\].
    pub gap: [R; 2],
    /// Slope g₀' of the initial gap. It is bitwise equal in all cells between two corners of the gap.
    pub gap_slope: R,
    /// Distributed load q on the ground at both ends of the cell \[N/m\].
    pub ground_load: [R; 2],
    /// Homogeneous part u₀ − q/k of the free-field settlement [u₀](crate::mesh::free_field) at both ends of the cell
    /// \[m\]. Here q is the distributed load on the ground.
    pub homogeneous_field: [R; 2],
    /// Point force on the ground at the left end of the cell \[N\].
    pub ground_force: R,
}

/// Differences of EI, k and μ from their values at the middle of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Varies<R = f64> {
    /// Coefficients of s, s², … in EI, with the coordinate s ∈ \[−1, 1\] in the cell.
    stiffness: [R; Profile::MOST - 1],
    /// Coefficients of s, s², … in k and μ, with the coordinate s ∈ \[−1, 1\] in the cell.
    subgrade: [R; GROUND - 1],
    shear_layer: [R; GROUND - 1],
    /// Values of μ at both ends of the cell if μ varies. Neighbouring cells of a segment have bitwise equal values
    /// at their common end.
    shear_layer_ends: Option<[R; 2]>,
}

impl<R: Real> Cell<R> {
    /// Returns the coefficients of w − g₀ from those of the deflection w, with the initial gap g₀. In contact, w − g₀
    /// is the ground displacement u.
    pub fn above_gap(&self, deflection: &[R]) -> Coefficients<R> {
        let mut c = Coefficients::from(deflection);
        let [left, right] = self.gap;
        c[0] -= (left + right) * 0.5;
        c[1] -= (right - left) * 0.5;
        c
    }

    /// Returns the coefficients of the obstacle ψ = w − g₀ − u₀ from those of the deflection w, with the initial gap g₀
    /// and the free-field settlement u₀.
    pub fn obstacle(&self, deflection: &[R]) -> Coefficients<R> {
        let mut c = self.above_gap(deflection);
        if self.has_free_field() {
            let settled = self.free_field();
            c = c.at_least(settled.len());
            for (c, u) in c.iter_mut().zip(settled.iter()) {
                *c -= *u;
            }
        }
        c
    }

    /// Whether loads on the ground act on this cell or cause a free-field settlement in it.
    pub fn has_free_field(&self) -> bool {
        self.ground_load != [R::ZERO; 2] || self.homogeneous_field != [R::ZERO; 2]
    }

    /// Returns the length of the cell in decay lengths of the ground. It is b times the length, with b = √(k/μ).
    fn fading(&self) -> R {
        (self.subgrade / self.shear_layer).sqrt() * self.length()
    }

    /// Returns the free-field settlement u₀ and its slope du₀/dx at the local coordinate s ∈ \[−1, 1\] of the cell.
    pub fn free_field_at(&self, s: f64) -> [R; 2] {
        if !self.has_free_field() {
            return [R::ZERO; 2];
        }
        let [a, b] = self.ground_load.map(|q| q / self.subgrade);
        let mut u = [(a + b) * 0.5 + (b - a) * 0.5 * s, (b - a) / self.length()];
        if self.shear_layer.value() > 0.0 {
            let ([left, right], bh, t) = (self.homogeneous_field, self.fading(), 0.5 * (1.0 + s));
            u[0] += between(left, right, bh, t);
            u[1] += bh / self.length() * slope_between(left, right, bh, t);
        }
        u
    }

    /// Returns the coefficients of the free-field settlement u₀ as a power series in the local coordinate s of the
    /// cell. Cells with a free field are short enough for such a series.
    pub fn free_field(&self) -> Coefficients<R> {
        let mut c = if self.shear_layer.value() > 0.0 {
            settled(
                &[self.subgrade],
                &[self.shear_layer],
                0.5 * self.length(),
                self.homogeneous_field,
            )
        } else {
            Coefficients::zeros(2)
        };
        let [a, b] = self.ground_load.map(|q| q / self.subgrade);
        c[0] += (a + b) * 0.5;
        c[1] += (b - a) * 0.5;
        c
    }

    /// Whether EI varies.
    pub fn beam_varies(&self) -> bool {
        self.varies.stiffness.iter().any(|c| *c != 0.0)
    }

    /// Whether S varies.
    pub fn beam_shear_varies(&self) -> bool {
        self.beam_shear.is_some_and(|shear| shear[1..].iter().any(|c| *c != 0.0))
    }

    /// Whether k or μ varies.
    pub fn ground_varies(&self) -> bool {
        let Varies { subgrade: spring, shear_layer: shear, .. } = &self.varies;
        spring.iter().chain(shear).any(|c| *c != 0.0)
    }

    /// Whether two cells have the same constant ground.
    pub fn shares_even_ground(&self, other: &Cell<R>) -> bool {
        self.subgrade == other.subgrade
            && self.shear_layer == other.shear_layer
            && !self.ground_varies()
            && !other.ground_varies()
    }

    /// Whether a curvature is imposed on this cell.
    pub fn has_imposed_curvature(&self) -> bool {
        self.curvature != [R::ZERO; 2]
    }

    /// The coefficients of EI κ₀, where κ₀ is the imposed curvature.
    pub fn imposed_moment(&self) -> Coefficients<R> {
        let [left, right] = self.curvature;
        let curvature = [(left + right) * 0.5, (right - left) * 0.5];
        if self.beam_varies() {
            return product(&self.stiffness_along(), &curvature);
        }
        Coefficients::from(&curvature.map(|c| self.stiffness * c)[..])
    }

    /// Coefficients of the bending stiffness EI as a polynomial in the local coordinate s ∈ \[−1, 1\] of the cell.
    pub fn stiffness_along(&self) -> [R; Profile::MOST] {
        with_first(self.stiffness, &self.varies.stiffness)
    }

    /// k and μ along the cell.
    pub fn ground(&self) -> GroundStretch<R> {
        GroundStretch { subgrade: self.subgrade_along(), shear_layer: self.shear_layer_along() }
    }

    /// Coefficients of the subgrade modulus k as a polynomial in the local coordinate s ∈ \[−1, 1\] of the cell.
    pub fn subgrade_along(&self) -> [R; GROUND] {
        with_first(self.subgrade, &self.varies.subgrade)
    }

    /// Coefficients of the shear-layer stiffness μ as a polynomial in the local coordinate s ∈ \[−1, 1\] of the cell.
    pub fn shear_layer_along(&self) -> [R; GROUND] {
        with_first(self.shear_layer, &self.varies.shear_layer)
    }

    /// The values of μ at the left and the right end of the cell.
    pub fn shear_layer_ends(&self) -> [R; 2] {
        self.varies.shear_layer_ends.unwrap_or([self.shear_layer; 2])
    }

    /// Returns k and μ at the local coordinate s of the cell.
    pub fn ground_at(&self, s: f64) -> [R; 2] {
        if !self.ground_varies() {
            return [self.subgrade, self.shear_layer];
        }
        [value(&self.subgrade_along(), s), value(&self.shear_layer_along(), s)]
    }

    /// Returns k, μ and dμ/ds at the local coordinate s of the cell.
    pub fn ground_rising_at(&self, s: f64) -> [R; 3] {
        if !self.ground_varies() {
            return [self.subgrade, self.shear_layer, R::ZERO];
        }
        let [shear, rise, ..] = jet(&self.shear_layer_along(), s);
        [value(&self.subgrade_along(), s), shear, rise]
    }

    /// Whether EI, k and μ vary little enough for short power series.
    pub fn is_smooth(&self) -> bool {
        (!self.beam_varies() || varies_little(&values(&self.stiffness_along())))
            && (!self.ground_varies() || self.ground().is_smooth())
    }

    /// Whether the sum of the shear stiffness S and the axial force N varies little enough for short power
    /// series.
    pub fn shear_is_smooth(&self, axial_force: f64) -> bool {
        let uneven = self.beam_shear.filter(|_| self.beam_shear_varies());
        uneven.is_none_or(|shear| {
            let mut both = values(&shear);
            both[0] += axial_force;
            varies_little(&both)
        })
    }

    /// Whether one short power series represents the surface of ground without contact on a length of 2·`half` in the
    /// cell.
    pub fn is_short_for_open_ground(&self, half: f64) -> bool {
        !self.ground_varies() || self.ground().is_short(half)
    }

    /// The part of the cell between two values of its local coordinate s.
    pub fn part(&self, s: [f64; 2]) -> Self {
        let linear = |v: [R; 2]| s.map(|s| initial(v, s));
        let mut part = Cell {
            x: s.map(|s| self.global(s)),
            load: linear(self.load),
            moment_load: linear(self.moment_load),
            curvature: linear(self.curvature),
            gap: linear(self.gap),
            ground_load: linear(self.ground_load),
            ground_force: if s[0] == -1.0 { self.ground_force } else { R::ZERO },
            ..*self
        };
        if self.homogeneous_field != [R::ZERO; 2] {
            let [left, right] = self.homogeneous_field;
            part.homogeneous_field =
                s.map(|s| between(left, right, self.fading(), 0.5 * (1.0 + s)));
        }
        let (middle, half) = (0.5 * (s[0] + s[1]), 0.5 * (s[1] - s[0]));
        let course = |c: &[R]| {
            let mut coefficients = [R::ZERO; Profile::MOST];
            coefficients[..c.len()].copy_from_slice(&rescale(c, middle, half));
            coefficients
        };
        if self.beam_varies() {
            part.set_stiffness(&course(&self.stiffness_along()));
        }
        if self.beam_shear_varies() {
            part.beam_shear = self.beam_shear.map(|shear| course(&shear));
        }
        if self.ground_varies() {
            let ends = [0, 1].map(|i| {
                if s[i].abs() == 1.0 {
                    self.shear_layer_ends()[i]
                } else {
                    value(&self.shear_layer_along(), s[i])
                }
            });
            part.set_ground(&self.ground().part(s), ends);
        }
        part
    }

    fn set_stiffness(&mut self, coefficients: &[R; Profile::MOST]) {
        let [first, rest @ ..] = coefficients;
        (self.stiffness, self.varies.stiffness) = (*first, *rest);
    }

    fn set_ground(&mut self, ground: &GroundStretch<R>, shear_ends: [R; 2]) {
        let first = |c: &[R; GROUND]| (c[0], std::array::from_fn(|i| c[i + 1]));
        (self.subgrade, self.varies.subgrade) = first(&ground.subgrade);
        (self.shear_layer, self.varies.shear_layer) = first(&ground.shear_layer);
        let varies = self.varies.shear_layer.iter().any(|c| *c != 0.0);
        self.varies.shear_layer_ends = varies.then_some(shear_ends);
    }

    pub fn length(&self) -> f64 {
        self.x[1] - self.x[0]
    }

    /// The coordinate s ∈ \[−1, 1\] of a position x.
    pub fn local(&self, x: f64) -> f64 {
        let [from, to] = self.x;
        // The distance is measured from the nearer end, so that both ends map exactly to ±1.
        let s = if x - from <= to - x {
            2.0 * ((x - from) / (to - from)) - 1.0
        } else {
            1.0 - 2.0 * ((to - x) / (to - from))
        };
        s.clamp(-1.0, 1.0)
    }

    /// The position x of a coordinate s ∈ \[−1, 1\].
    pub fn global(&self, s: f64) -> f64 {
        let half = 0.5 * self.length();
        if s <= 0.0 { self.x[0] + half * (1.0 + s) } else { self.x[1] - half * (1.0 - s) }
    }

    /// The positions at which the cell is cut into `count` equal parts.
    pub fn cuts(&self, count: usize) -> impl Iterator<Item = f64> + '_ {
        (1..count).map(move |i| self.global(2.0 * i as f64 / count as f64 - 1.0))
    }
}

impl Cell {
    /// Sets EI and S from a segment.
    pub fn set_beam(&mut self, bending: &CellPolynomial, shear: Option<&CellPolynomial>) {
        self.set_stiffness(&bending.coefficients);
        self.beam_shear = shear.map(|course| course.coefficients);
    }

    /// Sets k and μ from a segment.
    pub fn set_courses(&mut self, [spring, shear]: &[CellPolynomial; 2]) {
        let [subgrade, shear_layer] =
            [spring, shear].map(|course| std::array::from_fn(|i| course.coefficients[i]));
        self.set_ground(&GroundStretch { subgrade, shear_layer }, shear.ends);
    }

    /// Returns the cell in dual numbers. Entry i of `by` contains the derivatives of all data with respect to parameter
    /// i; `None` stands for zero derivatives.
    pub fn lifted<const N: usize>(&self, by: [Option<&Cell>; N]) -> Cell<Dual<N>> {
        let dual = |number: &dyn Fn(&Cell) -> f64| Dual {
            value: number(self),
            by: by.map(|cell| cell.map_or(0.0, number)),
        };
        let ends = |pair: fn(&Cell) -> [f64; 2]| [0, 1].map(|end| dual(&|cell| pair(cell)[end]));
        let varies = Varies {
            stiffness: std::array::from_fn(|j| dual(&|cell| cell.varies.stiffness[j])),
            subgrade: std::array::from_fn(|j| dual(&|cell| cell.varies.subgrade[j])),
            shear_layer: std::array::from_fn(|j| dual(&|cell| cell.varies.shear_layer[j])),
            shear_layer_ends: self.varies.shear_layer_ends.map(|_| ends(Cell::shear_layer_ends)),
        };
        let shear = |j: usize| dual(&|cell| cell.beam_shear.map_or(0.0, |shear| shear[j]));
        Cell {
            x: self.x,
            stiffness: dual(&|cell| cell.stiffness),
            subgrade: dual(&|cell| cell.subgrade),
            shear_layer: dual(&|cell| cell.shear_layer),
            beam_shear: self.beam_shear.map(|_| std::array::from_fn(shear)),
            varies,
            load: ends(|cell| cell.load),
            moment_load: ends(|cell| cell.moment_load),
            curvature: ends(|cell| cell.curvature),
            gap: ends(|cell| cell.gap),
            gap_slope: dual(&|cell| cell.gap_slope),
            ground_load: ends(|cell| cell.ground_load),
            homogeneous_field: ends(|cell| cell.homogeneous_field),
            ground_force: dual(&|cell| cell.ground_force),
        }
    }

    /// Multiplies the bending stiffness EI and the shear stiffness S of the beam by a factor.
    pub fn stiffen(&mut self, times: f64) {
        self.stiffness *= times;
        self.varies.stiffness = self.varies.stiffness.map(|c| c * times);
        self.beam_shear = self.beam_shear.map(|shear| shear.map(|c| c * times));
    }
}

fn with_first<R: Real, const N: usize, const REST: usize>(first: R, rest: &[R; REST]) -> [R; N] {
    let mut all = [first; N];
    all[1..].copy_from_slice(rest);
    all
}

/// Returns the sum of the initial gap g₀ and the free-field settlement u₀ at the local coordinate s of a cell.
pub(crate) fn gap_at<R: Real>(cell: &Cell<R>, s: f64) -> R {
    initial_gap_at(cell, s) + cell.free_field_at(s)[0]
}

/// Returns the initial gap g₀ at the local coordinate s of a cell.
pub(crate) fn initial_gap_at<R: Real>(cell: &Cell<R>, s: f64) -> R {
    initial(cell.gap, s)
}

/// Returns the value of a linear function at the local coordinate s ∈ \[−1, 1\] of a cell, from its values at both ends
/// of the cell.
pub(crate) fn initial<R: Real>([left, right]: [R; 2], s: f64) -> R {
    (left + right) * 0.5 + (right - left) * 0.5 * s
}
