//! Runs the real server, with a client that sends given bytes.

pub mod browser;

use browser::Browser;
use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A running server that ends with the test.
pub struct Server {
    child: Child,
    /// `http://127.0.0.1:PORT/`
    pub url: String,
    pub port: u16,
}

impl Server {
    pub fn start(file: Option<&Path>) -> Self {
        Server::with(file, &[])
    }

    /// The same with more options.
    pub fn with(file: Option<&Path>, options: &[&str]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_groundbeam"));
        command.arg("serve").args(file).args(["--port", "0", "--no-open"]).args(options);
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line).unwrap();
        let url = line.trim_end().strip_prefix("listening on ").expect(&line).to_owned();
        let port = url.trim_end_matches('/').rsplit(':').next().unwrap().parse().unwrap();
        Server { child, url, port }
    }

    /// Sends a request with these headers in addition to the host and the length of the body.
    pub fn ask(&self, method: &str, path: &str, headers: &[&str], body: &[u8]) -> Reply {
        let host = format!("Host: 127.0.0.1:{}", self.port);
        let length = format!("Content-Length: {}", body.len());
        let mut all = vec![&*host, &*length];
        all.extend(headers);
        self.say(&format!("{method} {path} HTTP/1.1\r\n{}\r\n\r\n", all.join("\r\n")), body)
    }

    pub fn post(&self, path: &str, body: &str) -> Reply {
        self.ask("POST", path, &["Content-Type: application/toml"], body.as_bytes())
    }

    pub fn get(&self, path: &str) -> Reply {
        self.ask("GET", path, &[], b"")
    }

    /// Sends exactly these bytes.
    pub fn say(&self, head: &str, body: &[u8]) -> Reply {
        talk(self.port, head, body)
    }
}

/// Sends one request on a new connection, and returns the reply.
pub fn talk(port: u16, head: &str, body: &[u8]) -> Reply {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
    let head = head.replacen("\r\n", "\r\nConnection: close\r\n", 1);
    stream.write_all(head.as_bytes()).unwrap();
    // A server may refuse a long body before it has read all of it.
    let _ = stream.write_all(body);
    let mut bytes = Vec::new();
    let _ = stream.read_to_end(&mut bytes);
    Reply::of(&bytes)
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A response.
#[derive(Debug)]
pub struct Reply {
    pub status: u16,
    pub head: String,
    pub body: Vec<u8>,
}

impl Reply {
    fn of(bytes: &[u8]) -> Self {
        let end = bytes.windows(4).position(|w| w == b"\r\n\r\n").expect("an answer");
        let head = String::from_utf8(bytes[..end].to_vec()).unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        let body = &bytes[end + 4..];
        let body = if head.to_lowercase().contains("transfer-encoding: chunked") {
            whole(body)
        } else {
            body.to_vec()
        };
        Reply { status, head, body }
    }

    pub fn text(&self) -> &str {
        std::str::from_utf8(&self.body).unwrap()
    }

    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|e| panic!("{e}: {}", self.text()))
    }
}

fn whole(mut chunks: &[u8]) -> Vec<u8> {
    let mut body = Vec::new();
    while let Some(end) = chunks.windows(2).position(|w| w == b"\r\n") {
        let size = std::str::from_utf8(&chunks[..end]).unwrap();
        let size = usize::from_str_radix(size.trim(), 16).unwrap();
        if size == 0 {
            break;
        }
        body.extend_from_slice(&chunks[end + 2..end + 2 + size]);
        chunks = &chunks[end + 4 + size..];
    }
    body
}

/// Opens the page of a server, and waits until its results are shown.
pub fn opened(browser: &Browser, server: &Server) {
    browser.window(1280, 1000, "light");
    browser.go(&server.url);
    settled(browser, "document.querySelectorAll('#results tr').length > 3");
}

/// Waits until a condition holds and the response to the last change is shown.
#[track_caller]
pub fn settled(browser: &Browser, so: &str) {
    browser.until(&format!("document.body.dataset.state === 'settled' && ({so})"));
}
