//! Runs the command `groundbeam serve`, which starts a server on this machine and opens its page.

mod assets;
mod browser;
mod connection;
mod guard;
mod reply;
mod routes;

use crate::command::{Printed, Serve};
use crate::failure::Failure;
use crate::output::print;
use crate::status::Status;
use connection::LIMITS;
use std::net::Ipv4Addr;
use std::path::Path;
use tokio::net::TcpListener;

/// Model, units and number of displayed digits with which the page starts.
#[derive(Debug, Clone)]
pub struct Start {
    pub model: Option<StartingModel>,
    pub printed: Printed,
}

#[cfg(test)]
impl Start {
    /// Returns the initial state of a page without a model.
    fn empty() -> Self {
        let units = groundbeam_file::print::Asked::File;
        let printed = Printed { units, digits: groundbeam_file::print::RESULT_DIGITS };
        Start { model: None, printed }
    }
}

/// The initial model of the page.
#[derive(Debug, Clone)]
pub struct StartingModel {
    /// Name of the model file without its folder.
    pub name: String,
    /// Text of the model file, valid or not.
    pub text: String,
}

impl StartingModel {
    fn read(path: &Path) -> Result<Self, Failure> {
        let bytes =
            groundbeam_file::read_file(path).map_err(|error| Failure::file(path, &error))?;
        let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        Ok(StartingModel { name, text: String::from_utf8_lossy(&bytes).into_owned() })
    }
}

/// Runs the server on the loopback interface until the program ends.
pub fn run(request: &Serve) -> Result<Status, Failure> {
    let model = request.file.as_deref().map(StartingModel::read).transpose()?;
    let start = Start { model, printed: request.printed };
    let broken = |error: std::io::Error| {
        let port = request.port;
        Failure::usage(format!("cannot use port {port} of this machine: {error}"))
    };
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()
        .map_err(broken)?;
    runtime.block_on(async {
        let listener =
            TcpListener::bind((Ipv4Addr::LOCALHOST, request.port)).await.map_err(broken)?;
        let port = listener.local_addr().map_err(broken)?.port();
        let url = format!("http://127.0.0.1:{port}/");
        print(&format!("listening on {url}\n"))?;
        if !request.no_open {
            browser::open(&url);
        }
        connection::accept(listener, routes::all(start, port, routes::BODY), LIMITS).await;
        Ok(Status::Done)
    })
}
