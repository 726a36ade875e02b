//! A flag with which another thread stops a solve.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A flag that stops a solve. All clones share one flag. The default flag cannot be set.
///
/// A solve checks the flag in every step and at its end. If the flag is set, the solve returns
/// [`Error::Cancelled`](crate::Error::Cancelled).
///
/// ```
/// use groundbeam::{Beam, Cancel, Error, Foundation, Load, Model, Options, solve_with};
///
/// let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
///     .with_load(Load::point_force(0.5, 1.0));
/// let cancel = Cancel::new();
/// let options = Options { cancel: cancel.clone(), ..Options::default() };
/// assert!(solve_with(&model, &options).is_ok());
/// cancel.cancel();
/// assert_eq!(solve_with(&model, &options).err(), Some(Error::Cancelled));
/// ```
#[derive(Debug, Clone, Default)]
pub struct Cancel(Option<Arc<AtomicBool>>);

impl Cancel {
    /// A flag that is not set.
    pub fn new() -> Self {
        Cancel(Some(Arc::default()))
    }

    /// Sets the flag permanently, for all clones.
    pub fn cancel(&self) {
        if let Some(flag) = &self.0 {
            flag.store(true, Ordering::Relaxed);
        }
    }

    /// Whether the flag is set.
    pub fn is_cancelled(&self) -> bool {
        self.0.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed))
    }
}

/// Two values are equal if they share one flag.
impl PartialEq for Cancel {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (None, None) => true,
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}
