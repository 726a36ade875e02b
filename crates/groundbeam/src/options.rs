//! The method of solution and its options.

use crate::cancel::Cancel;

/// How the contact problem is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Closed forms between the edges of contact, which are the unknowns. No mesh.
    #[default]
    Exact,
    /// The discrete problem (5.10), (5.11) with forces at the nodes, (5.5): Newton's method on the convex energy.
    ActiveSet,
    /// The paper's (5.17) with (5.18), projected successive over-relaxation.
    Psor,
    /// The paper's iteration (5.14)–(5.17), after Uzawa.
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

/// Choices for [`solve_with`](crate::solve_with). The default needs none.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// How to solve.
    pub method: Method,
    /// Equal elements along the beam for the methods with a mesh; more are added where the model needs a
    /// node. Not used by [`Method::Exact`].
    pub elements: usize,
    /// Where `Uzawa` and `Psor` begin.
    pub start: Start,
    /// Sweeps after which `Uzawa` and `Psor` give up.
    pub most_sweeps: usize,
    /// The memory that a solve may need \[bytes\], by [estimate](crate::memory_estimate()); a model that needs more is
    /// refused.
    pub memory_limit: u64,
    /// Stops the solve.
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
    /// The pressure of the bilateral problem, its pulls left out.
    #[default]
    Bilateral,
    /// None.
    Zero,
}
