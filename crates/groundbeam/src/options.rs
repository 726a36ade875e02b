//! The method of solution and its options.

use crate::cancel::Cancel;

/// The method of solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// The exact method: closed forms between the contact edges, whose positions are the unknowns. It has no
    /// mesh.
    #[default]
    Exact,
    /// Newton's method for the discrete contact problem (5.10), (5.11) of Kikuchi's paper, with concentrated contact
    /// forces at the nodes as in (5.5). The method minimises a convex energy.
    ActiveSet,
    /// Projected successive over-relaxation: (5.17) with (5.18) of Kikuchi's paper.
    Psor,
    /// Uzawa's iteration, (5.14)–(5.17) of Kikuchi's paper.
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
    /// Number of equal elements for the methods with a mesh. Parts of the model add nodes. A method with a mesh
    /// doubles the number where *How accurate a mesh is* in docs/methods.md requires it.
    pub elements: usize,
    /// The initial pressure of [`Method::Uzawa`] and [`Method::Psor`].
    pub start: Start,
    /// Maximum number of sweeps of [`Method::Uzawa`] and [`Method::Psor`]. If the number of elements is doubled, the
    /// sweeps on all meshes together take no more operations than this number of sweeps on the first mesh.
    pub most_sweeps: usize,
    /// The memory limit \[bytes\]. A model whose [estimate](crate::memory_estimate()) exceeds this limit is
    /// refused.
    pub memory_limit: u64,
    /// A flag with which another thread can stop the solve.
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

/// The initial pressure of two iterations: Uzawa's iteration, (5.15) of Kikuchi's paper, and projected successive
/// over-relaxation (PSOR).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Start {
    /// The pressure of the bilateral problem, with tensile pressures set to zero.
    #[default]
    Bilateral,
    /// Zero pressure.
    Zero,
}
