//! The compiled extension of the Python package `groundbeam`: reads and solves models, and returns numpy arrays.
//!
//! The documented public classes in `python/groundbeam` import this extension as `_native`.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod answers;
mod batch;
mod derivatives;
mod failure;
mod model;
mod names;
mod read;
mod solution;
mod study;
mod threads;

use groundbeam::Field;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::answers::Answers;
    #[pymodule_export]
    use super::batch::solve_many;
    #[pymodule_export]
    use super::model::{Model, text_of};
    #[pymodule_export]
    use super::solution::Solution;
    #[pymodule_export]
    use super::study::{Study, merge};

    use super::{Bound, Field, PyModule, PyModuleMethods, PyResult, PyTuple};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("FIELDS", PyTuple::new(module.py(), Field::ALL.map(Field::name))?)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
