//! Computes the stiffness and the load of one element of the beam by (2.11) and (5.1) of Kikuchi's paper.
//!
//! The deflection of an element solves (2.11) exactly. Uniform cells have a [closed form](uniform). Other cells and
//! beams with shear deformation have a [series](series). A long loaded stretch has a [quiet element](quiet) in its
//! middle.

pub(crate) mod element;
pub(crate) mod layers;
pub(crate) mod operator;
mod quiet;
pub(crate) mod series;
pub(crate) mod uniform;

use crate::mesh::cell::Cell;
use crate::numeric::polynomial::{Coefficients, TERMS, rescale};
use crate::numeric::real::Real;
use element::{Element, LONGEST_SERIES};
use layers::Layers;
use operator::{Operator, ZoneKind};
use series::Series;
use std::collections::VecDeque;
use std::rc::Rc;
use uniform::Uniform;

/// Appends the positions at which a cell is cut into equal elements.
pub(crate) fn cut_equally(operator: &Operator, cell: &Cell, x: &mut Vec<f64>) {
    x.extend(cell.cuts(parts(operator, cell.length())));
}

/// Appends the positions at which a cell is cut into elements. A long loaded cell in contact gets one long quiet
/// element in its middle and equal elements on both sides.
pub(crate) fn cut(operator: &Operator, cell: &Cell, x: &mut Vec<f64>) {
    let Some(depth) = quiet::depth(operator, cell.length()) else {
        return cut_equally(operator, cell, x);
    };
    let [from, to] = cell.x;
    let count = parts(operator, depth);
    let distance = |i: usize| depth * i as f64 / count as f64;
    x.extend((1..=count).map(|i| from + distance(i)));
    x.extend((1..=count).rev().map(|i| to - distance(i)));
}

/// Number of elements into which [`cut`] divides a stretch of `length`.
pub(crate) fn count(operator: &Operator, length: f64) -> usize {
    match quiet::depth(operator, length) {
        Some(depth) => 2 * parts(operator, depth) + 1,
        None => parts(operator, length),
    }
}

/// The number of equal elements into which a stretch of `length` must be cut.
pub(crate) fn parts<R: Real>(operator: &Operator<R>, length: f64) -> usize {
    let wave = match Layers::of(operator, length) {
        Some(layers) => layers.slow_squared.value().sqrt(),
        None => operator.wave_number(),
    };
    (wave * length / LONGEST_SERIES).ceil().max(1.0) as usize
}

/// An element, with the functions that give the deflection w along the element from its four unknowns.
#[derive(Debug, Clone)]
pub(crate) struct ExactElement<R = f64> {
    pub element: Element<R>,
    functions: Functions<R>,
}

#[derive(Debug, Clone)]
enum Functions<R> {
    Uniform(Uniform<R>),
    /// Power series coefficients of w in a quiet element. They do not depend on the motion of its ends.
    Quiet([R; TERMS]),
    /// Equal cells share the power series ([`ElementRow`]).
    Series(Rc<Series<R>>),
}

impl<R: Real> ExactElement<R> {
    /// Returns the element of a whole cell under an axial force.
    pub fn of(cell: &Cell<R>, axial_force: R, touch: ZoneKind) -> Self {
        Self::new(&Operator::of(cell, axial_force, touch), cell.length())
    }

    pub fn new(operator: &Operator<R>, length: f64) -> Self {
        if let Some(polynomials) = &operator.polynomials {
            let (element, series) = Series::new(polynomials, length);
            return ExactElement { element, functions: Functions::Series(Rc::new(series)) };
        }
        // Only a quiet element is longer than two equal elements.
        if parts(operator, length) > 2 {
            let (element, series) = quiet::element(operator, length);
            return ExactElement { element, functions: Functions::Quiet(series) };
        }
        let (element, uniform) = Uniform::new(operator, length);
        ExactElement { element, functions: Functions::Uniform(uniform) }
    }

    /// Returns the boundary layers of the element. The deflection w is the sum of a power series and of these layers.
    /// Returns `None` if w is a power series alone.
    pub fn layers(&self) -> Option<&Layers<R>> {
        match &self.functions {
            Functions::Uniform(uniform) => uniform.layers.as_ref(),
            Functions::Quiet(_) | Functions::Series(_) => None,
        }
    }

    /// Computes the power series coefficients of the deflection w on the part `x` of the element's cell, from the
    /// results of [`Self::unfold`].
    pub fn deflection_on<S: Real>(
        &self,
        cell: &Cell<S>,
        x: [f64; 2],
        (series, heights): &([R; TERMS], [R; 2]),
    ) -> Coefficients<R> {
        let mut c: Coefficients<R> = if x == cell.x {
            series[..].into()
        } else {
            let [a, b] = x.map(|x| cell.local(x));
            rescale(series, 0.5 * (a + b), (x[1] - x[0]) / cell.length())
        };
        if let Some(layers) = self.layers() {
            layers.add(cell.x, *heights, x, &mut c);
        }
        c
    }

    /// Computes the coefficients of φ(s), the rotation of the cross-sections at the local coordinate s. Returns `None`
    /// if the beam has no shear deformation.
    pub fn rotation(&self, v: &[R; 4]) -> Option<[R; TERMS]> {
        match &self.functions {
            Functions::Uniform(_) | Functions::Quiet(_) => None,
            Functions::Series(series) => series.rotation(v),
        }
    }

    /// Computes w from the four unknowns: its power series coefficients in the local coordinate, and the amplitudes of
    /// the boundary layers at both ends.
    pub fn unfold(&self, v: &[R; 4]) -> ([R; TERMS], [R; 2]) {
        match &self.functions {
            Functions::Uniform(uniform) => {
                uniform.unfold(self.element.basis, self.element.length, v)
            }
            Functions::Quiet(series) => (*series, [R::ZERO; 2]),
            Functions::Series(series) => (series.deflection(v), [R::ZERO; 2]),
        }
    }
}

/// Number of elements that [`ElementRow`] compares with the next cell. The lengths of equal cells differ by rounding
/// error, so they alternate between a few values.
const COMPARED: usize = 4;

/// Computes the elements of cells, from left to right. Equal cells share one power series. Elements without power series
/// are cheap, so they are not shared.
#[derive(Debug, Default)]
pub(crate) struct ElementRow {
    recent: VecDeque<(Operator, ExactElement)>,
}

impl ElementRow {
    /// Returns the element of the next cell. It is one of the last [`COMPARED`] elements if the coefficients and the
    /// lengths are equal.
    pub fn next(&mut self, cell: &Cell, axial_force: f64, touch: ZoneKind) -> ExactElement {
        let (operator, length) = (Operator::of(cell, axial_force, touch), cell.length());
        if operator.polynomials.is_none() {
            return ExactElement::new(&operator, length);
        }
        let is_equal = |(known, exact): &&(Operator, ExactElement)| {
            exact.element.length == length && *known == operator
        };
        if let Some((_, exact)) = self.recent.iter().find(is_equal) {
            return exact.clone();
        }
        let exact = ExactElement::new(&operator, length);
        self.recent.truncate(COMPARED - 1);
        self.recent.push_front((operator, exact.clone()));
        exact
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::mesh::Mesh;
    use crate::model::{Beam, Foundation, Load, Model};

    /// Cells of a beam with shear deformation under a uniform load.
    fn cells(count: usize) -> Vec<Cell> {
        let mut beam = Beam::uniform(1.0, 1.0);
        beam.shear_stiffness = Some(5.0);
        let model = Model::new(beam, Foundation::pasternak(3.0, 2.0))
            .with_load(Load::uniform_force(0.0, 1.0, 4.0));
        Mesh::build(&model, &[], |_| count).cells
    }

    /// Number of different power series in the elements of the cells.
    fn different(cells: &[Cell]) -> usize {
        let mut row = ElementRow::default();
        let mut all: Vec<Rc<Series>> = Vec::new();
        for cell in cells {
            let Functions::Series(series) = row.next(cell, 0.0, ZoneKind::Contact).functions else {
                panic!("an element without a power series")
            };
            if !all.iter().any(|known| Rc::ptr_eq(known, &series)) {
                all.push(series);
            }
        }
        all.len()
    }

    #[test]
    fn equal_cells_share_a_power_series() {
        assert_eq!(different(&cells(8)), 1);
        // The lengths of 500 equal cells differ by rounding error and take a few values.
        assert!(different(&cells(500)) < 50, "{}", different(&cells(500)));
        let mut pair = cells(2);
        pair[1].load[1] += 1e-15;
        assert_eq!(different(&pair), 2);
        pair[1] = Cell { x: [0.5, 1.0 - f64::EPSILON], ..pair[0] };
        assert_eq!(different(&pair), 2);
    }
}
