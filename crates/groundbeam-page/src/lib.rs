//! The questions and answers of the page: a model file and a query in, JSON or a file out.
//!
//! Nothing here opens a socket, so that the answers can come from a server or from a worker inside a browser.
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
pub use question::{Asked, REPORT, SOLVE, Trains, VIEW, WrongQuery};
pub use reply::Reply;
