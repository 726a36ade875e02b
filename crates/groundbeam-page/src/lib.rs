//! Computes the responses of the page from a model file and a query, as JSON or as a file.
//!
//! This crate opens no socket, so a server or a worker inside a browser can use it.
//!
//! ```
//! use groundbeam_page::{Asked, SOLVE, result};
//! use groundbeam_run::OneThread;
//!
//! let model = b"[beam]\nlength = 12\nEI = 1.2e9\n[foundation]\nk = 40e6\n[[load]]\npoint = 6e5\nat = 4\n";
//! let asked = Asked::read(&[], SOLVE).unwrap();
//! let reply = result(model, &asked, &OneThread);
//! assert_eq!((reply.status, reply.kind), (200, "application/json"));
//! ```

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod answer;
mod question;
mod reply;
mod view;
mod written;

pub use answer::{Form, file, result, view};
pub use question::{Asked, FILE, REPORT, SOLVE, Trains, VIEW, WrongQuery};
pub use reply::Reply;
