//! The Python class of a solution: fields at any positions, contact, certificate, and reports.

use crate::derivatives::{self, Asked};
use crate::failure::{Failure, Tipping};
use crate::names::{field, side};
use crate::read::Read;
use groundbeam::Field;
use groundbeam_report::{Context, csv, json, sentence, svg, text, verdict_name};
use groundbeam_run::{Answer, Found, Ground, Label};
use numpy::{PyArray1, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

/// The solution of a model, of one of its combinations, or of one position of a train.
#[pyclass(frozen, module = "groundbeam._native")]
pub struct Solution {
    pub read: Arc<Read>,
    pub label: Label,
    pub found: Arc<groundbeam::Solution>,
    ground: Option<Ground>,
    seconds: f64,
}

impl Solution {
    /// Returns the solution of a result. Fails with the reason if the result has no solution.
    pub fn of(read: &Arc<Read>, answer: &Answer) -> Result<Self, Failure> {
        let Answer { label, found, ground, seconds, .. } = answer.clone();
        match found {
            Found::Equilibrium(found) => {
                Ok(Solution { read: read.clone(), label, found, ground, seconds })
            }
            Found::Exists(existence) | Found::NoEquilibrium(existence) => {
                let tipping = Tipping::of(&label.model(), &existence, read.units());
                Err(Failure::NoEquilibrium(tipping))
            }
            Found::NotConverged(reached) => Err(Failure::NotConverged(reached)),
            Found::Unsolved(error) => Err(read.refused(error)),
        }
    }

    /// Returns the data that a report prints in addition to the solution.
    fn context(&self) -> Context<'_> {
        let context = Context::of(&self.read.document).with_seconds(self.seconds);
        let combination = Some(&*self.label.combination).filter(|one| !one.name.is_empty());
        Context { ground: self.ground.as_ref(), combination, ..context }
    }

    fn stations_or(&self, at: Option<Vec<f64>>) -> Vec<f64> {
        at.unwrap_or_else(|| json::default_stations(&self.found))
    }
}

/// The values of outputs, their derivatives row by row, and the reasons why the derivatives are one-sided.
type GradientArrays<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Vec<Vec<String>>);

#[pymethods]
impl Solution {
    /// Returns one field at positions on the beam. Where the field jumps, `from_side` selects the value. The
    /// settlement is also defined outside the beam.
    fn field<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        x: PyReadonlyArray1<'py, f64>,
        from_side: &str,
    ) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let side = side(from_side)?;
        let field = field(name)?;
        let length = self.found.model().beam.length;
        let value = |x: f64| match field {
            Field::Settlement if !(0.0..=length).contains(&x) => self.found.settlement(x),
            field => self.found.at(x, side).get(field),
        };
        let mut values = Vec::with_capacity(x.len());
        values.extend(x.as_array().iter().map(|&x| value(x)));
        Ok(PyArray1::from_vec(py, values))
    }

    /// Reads a position from text, in the units of the file.
    fn read_position(&self, text: &str) -> Result<f64, Failure> {
        self.read.position(text)
    }

    #[getter]
    fn units(&self) -> &'static str {
        self.read.system()
    }

    #[getter]
    fn length(&self) -> f64 {
        self.found.model().beam.length
    }

    #[getter]
    fn combination(&self) -> Option<&str> {
        Some(&*self.label.combination.name).filter(|name| !name.is_empty())
    }

    #[getter]
    fn method(&self) -> &'static str {
        self.found.method().name()
    }

    #[getter]
    fn iterations(&self) -> usize {
        self.found.iterations()
    }

    #[getter]
    fn elements(&self) -> usize {
        self.found.elements()
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.seconds
    }

    #[getter]
    fn verdict(&self) -> &'static str {
        verdict_name(self.found.existence().verdict)
    }

    #[getter]
    fn sentence(&self) -> String {
        sentence(self.found.model(), self.found.existence(), self.read.units())
    }

    #[getter]
    fn contact(&self) -> Vec<(f64, f64)> {
        self.found.contact().iter().map(|region| (region.from, region.to)).collect()
    }

    /// Start, end, position of the largest gap, and largest gap of each stretch without contact.
    #[getter]
    fn lift_off(&self) -> Vec<(f64, f64, f64, f64)> {
        let each = self.found.lift_off().into_iter();
        each.map(|l| (l.from, l.to, l.largest_gap.x, l.largest_gap.value)).collect()
    }

    #[getter]
    fn end_forces(&self) -> (f64, f64) {
        let ends = self.found.end_forces();
        (ends.left, ends.right)
    }

    #[getter]
    fn concentrated_forces(&self) -> Vec<(f64, f64)> {
        self.found.concentrated_forces().iter().map(|force| (force.at, force.force)).collect()
    }

    #[getter]
    fn reactions(&self) -> Vec<(f64, f64, f64)> {
        self.found.reactions().iter().map(|r| (r.at, r.force, r.moment)).collect()
    }

    /// Position, rotation and moment of each hinge.
    #[getter]
    fn hinges(&self) -> Vec<(f64, f64, f64)> {
        self.found.hinges().iter().map(|h| (h.at, h.rotation, h.moment)).collect()
    }

    /// Primal energy, dual energy, energy gap, and relative energy gap of the certificate.
    #[getter]
    fn certificate(&self) -> [f64; 4] {
        self.found.certificate().figures().map(|(_, value)| value)
    }

    /// Returns the values of outputs, their derivatives with respect to parameters with one row for each output,
    /// and the reasons why derivatives are one-sided.
    fn gradients<'py>(
        &self,
        py: Python<'py>,
        outputs: Vec<Asked>,
        parameters: Vec<String>,
    ) -> Result<GradientArrays<'py>, Failure> {
        let found = py.detach(|| {
            let on_soil = self.found.soil().is_some();
            derivatives::gradients(&self.found, on_soil, self.read.units(), &outputs, &parameters)
        });
        let (values, derivatives, one_sided) = found?;
        Ok((PyArray1::from_vec(py, values), PyArray1::from_vec(py, derivatives), one_sided))
    }

    /// Returns the minimum and the maximum of a field, each as position and value.
    fn range(&self, name: &str) -> Result<(f64, f64, f64, f64), Failure> {
        let range = self.found.range(field(name)?);
        Ok((range.min.x, range.min.value, range.max.x, range.max.value))
    }

    fn stations<'py>(&self, py: Python<'py>, even: usize) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.found.stations(even))
    }

    fn to_json(&self, at: Option<Vec<f64>>) -> String {
        json::solved(&self.found, &self.stations_or(at), &self.context())
    }

    fn to_csv(&self, at: Option<Vec<f64>>) -> String {
        csv::table(&self.found, &self.stations_or(at), &self.context())
    }

    fn to_svg(&self, py: Python<'_>) -> String {
        py.detach(|| svg::picture(&self.found, &self.context()).to_string())
    }

    fn to_png<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyBytes>, Failure> {
        let drawn = py.detach(|| svg::picture(&self.found, &self.context()).png());
        let drawn = drawn.map_err(|error| Failure::Asked(error.to_string()))?;
        Ok(PyBytes::new(py, &drawn))
    }

    fn report(&self) -> String {
        text::solved(&self.found, &self.context(), false)
    }
}
