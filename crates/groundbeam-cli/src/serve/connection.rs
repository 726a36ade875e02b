//! Accepts connections to the server, and closes connections that are silent for too long.

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio_io_timeout::TimeoutStream;

/// Limits of a connection.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Time limit for the head of a request, counted from the end of the previous response or from the start of the
    /// connection.
    pub head: Duration,
    /// Time limit for the client to accept the next bytes of a response.
    pub write: Duration,
    /// Maximum number of open connections. Further connections wait.
    pub open: usize,
}

pub const LIMITS: Limits =
    Limits { head: Duration::from_secs(10), write: Duration::from_secs(30), open: 256 };

/// Pause after a connection could not be accepted, for example because all file descriptors are in use.
const PAUSE: Duration = Duration::from_millis(200);

/// Accepts connections until the program ends.
pub async fn accept(listener: TcpListener, router: Router, limits: Limits) {
    let service = TowerToHyperService::new(router);
    let free = Arc::new(Semaphore::new(limits.open));
    while let Ok(permit) = Arc::clone(&free).acquire_owned().await {
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(PAUSE).await;
            continue;
        };
        let service = service.clone();
        tokio::spawn(async move {
            serve(stream, service, limits).await;
            drop(permit);
        });
    }
}

/// Serves the requests of one connection.
async fn serve(stream: TcpStream, service: TowerToHyperService<Router>, limits: Limits) {
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(limits.write));
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(limits.head);
    // An error of the connection cannot be reported to the client, so it is ignored.
    let _ = builder.serve_connection(TokioIo::new(Box::pin(stream)), service).await;
}

#[cfg(test)]
mod tests {
    use super::super::{Start, routes};
    use super::*;
    use std::io::{Read, Write};
    use std::net::{Ipv4Addr, SocketAddr};

    const SHORT: Limits =
        Limits { head: Duration::from_millis(300), write: Duration::from_millis(300), open: 4 };

    /// Starts a server with short time limits. The server stops when the runtime is dropped.
    fn server() -> (tokio::runtime::Runtime, SocketAddr) {
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(1)
            .enable_all()
            .build()
            .unwrap();
        let listener = runtime.block_on(TcpListener::bind((Ipv4Addr::LOCALHOST, 0))).unwrap();
        let address = listener.local_addr().unwrap();
        let router = routes::all(Start::empty(), address.port(), Duration::from_millis(300));
        runtime.spawn(accept(listener, router, SHORT));
        (runtime, address)
    }

    /// Sends a request and returns the text that the server sends until it closes the connection.
    #[track_caller]
    fn answer(address: SocketAddr, sent: &str) -> String {
        String::from_utf8_lossy(&bytes(address, sent)).into_owned()
    }

    #[track_caller]
    fn bytes(address: SocketAddr, sent: &str) -> Vec<u8> {
        let mut stream = std::net::TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream.write_all(sent.as_bytes()).unwrap();
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("the server closes the connection");
        bytes
    }

    #[test]
    fn a_silent_connection_is_closed() {
        let (_runtime, address) = server();
        assert_eq!(answer(address, ""), "");
        assert_eq!(answer(address, "POST /api/solve HTTP/1.1\r\nHost: "), "");
        let host = format!("Host: {address}\r\n");
        // This connection is kept alive after a response, and is then silent.
        let kept = answer(address, &format!("GET /text.js HTTP/1.1\r\n{host}\r\n"));
        assert!(kept.starts_with("HTTP/1.1 200 OK"), "{kept}");
        // The body of this request does not arrive.
        let head = format!("POST /api/solve HTTP/1.1\r\n{host}Content-Length: 100\r\n\r\n[beam]");
        let late = answer(address, &head);
        assert!(late.starts_with("HTTP/1.1 408 "), "{late}");
        assert!(late.contains(r#""status":"refused""#), "{late}");
    }

    #[test]
    fn connections_that_do_not_read_their_responses_are_closed() {
        let (_runtime, address) = server();
        let ask = format!("GET /inter.ttf HTTP/1.1\r\nHost: {address}\r\n\r\n");
        let idle: Vec<_> = (0..SHORT.open)
            .map(|_| {
                let mut stream = std::net::TcpStream::connect(address).unwrap();
                // The responses to 400 requests exceed the buffers of the operating system.
                let _ = stream.write_all(ask.repeat(400).as_bytes());
                stream
            })
            .collect();
        // All connections are in use. This request is served after the other connections time out.
        let last = ask.replace("\r\n\r\n", "\r\nConnection: close\r\n\r\n");
        let taken = bytes(address, &last);
        assert!(taken.starts_with(b"HTTP/1.1 200 OK") && taken.len() > 50_000);
        drop(idle);
    }

    #[test]
    fn silent_connections_do_not_block_other_clients() {
        let (_runtime, address) = server();
        let silent: Vec<_> =
            (0..40).map(|_| std::net::TcpStream::connect(address).unwrap()).collect();
        let ask = format!("GET /text.js HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n");
        let reply = answer(address, &ask);
        assert!(reply.starts_with("HTTP/1.1 200 OK"), "{reply}");
        drop(silent);
    }
}
