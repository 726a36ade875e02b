//! The method of solution and its options.

use crate::cancel::Cancel;

/// The method of solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Closed forms between the contact edges, which are the unknowns; without a mesh.
    #[default]
    Exact,
    /// The discrete problem (5.10), (5.11) with forces at the nodes, (5.5): Newton's method on the convex energy.
    ActiveSet,
    /// Projected successive over-relaxation: (5.17) with (5.18) of the paper.
    Psor,
    /// Uzawa's iteration of the paper, (5.14)–(5.17).
    Uzawa,
}

impl Method {
    /// All methods, the default first.
    pub const ALL: [Method; 4] = [Method::Exact, Method::ActiveSet, Method::Psor, Method::Uzawa];

    /// The name that commands and results use: `exact`, `active-set`, `psor`, `uzawa`.
    pub fn name(self) -> &'static str {
        match self {
            Method::Exact => "exact",
            Method::ActiveSet => "active-set",
            Method::Psor => "psor",
            Method::Uzawa => "uzawa",
        }
    }
}

/// Options of [`solve_with`](crate::solve_with). Every option has a default.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The method.
    pub method: Method,
    /// Number of equal elements along the beam for the methods with a mesh. Loads, supports and other parts
    /// of the model add nodes. [`Method::ActiveSet`] doubles the number if its discrete problem is not solved and,
    /// on Winkler ground, until the energy gap is no larger than the strain energy. [`Method::Exact`] ignores the
    /// number.
    pub elements: usize,
    /// The start of `Uzawa` and `Psor`.
    pub start: Start,
    /// Maximum number of sweeps of `Uzawa` and `Psor`.
    pub most_sweeps: usize,
    /// The memory limit \[bytes\]; a model whose [estimate](crate::memory_estimate()) exceeds it is refused.
    pub memory_limit: u64,
    /// A flag that stops the solve.
    pub cancel: Cancel,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            method: Method::Exact,
            elements: 100,
            start: Start::Bilateral,
            most_sweeps: 1_000_000,
            memory_limit: 4_000_000_000,
            cancel: Cancel::default(),
        }
    }
}

/// The first pressure of Uzawa's iteration, (5.15).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Start {
    /// The pressure of the bilateral problem, without its tensile part.
    #[default]
    Bilateral,
    /// Zero pressure.
    Zero,
}
