//! A real browser, controlled over the WebDriver protocol.

use groundbeam_testing::tools_or_skip;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Time limit that exceeds all durations on a busy machine.
const TIMEOUT: Duration = Duration::from_secs(60);

/// A browser without a window that ends with the test.
pub struct Browser {
    driver: Child,
    port: u16,
    session: String,
    _profile: tempfile::TempDir,
}

impl Browser {
    /// Starts the browser. Without a driver it reports that the test was skipped and returns `None`, or fails if
    /// `GROUNDBEAM_DEMAND` names `browser`.
    pub fn start() -> Option<Self> {
        let mut command = Command::new("chromedriver");
        command.arg("--port=0").stdout(Stdio::piped()).stderr(Stdio::null());
        let driver = command.spawn().map_err(|error| format!("chromedriver: {error}"));
        let mut driver = tools_or_skip(driver, "browser", "the page in a browser")?;
        let lines = BufReader::new(driver.stdout.as_mut().unwrap()).lines();
        let mark = "started successfully on port ";
        let port = lines.map_while(Result::ok).find_map(|line| {
            Some(line.split_once(mark)?.1.trim_end_matches('.').parse().expect("a port"))
        });
        let profile = tempfile::tempdir().unwrap();
        let folder = format!("--user-data-dir={}", profile.path().display());
        let mut browser = Browser {
            driver,
            port: port.expect("chromedriver starts"),
            session: String::new(),
            _profile: profile,
        };
        let arguments = [
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            &folder,
        ];
        let wanted = json!({ "capabilities": { "alwaysMatch": {
            "goog:chromeOptions": { "args": arguments }
        } } });
        let session = browser.call("POST", "/session", &wanted);
        browser.session = format!("/session/{}", session["sessionId"].as_str().unwrap());
        Some(browser)
    }

    pub fn go(&self, url: &str) {
        self.command("/url", &json!({ "url": url }));
    }

    /// The value of an expression in the page.
    pub fn eval(&self, expression: &str) -> Value {
        let script = format!("return ({expression});");
        self.command("/execute/sync", &json!({ "script": script, "args": [] }))
    }

    pub fn text(&self, selector: &str) -> String {
        let found = self.eval(&format!("document.querySelector({selector:?})?.textContent ?? ''"));
        found.as_str().unwrap().to_owned()
    }

    /// Waits until an expression in the page is true.
    #[track_caller]
    pub fn until(&self, expression: &str) {
        let started = Instant::now();
        while self.eval(&format!("Boolean({expression})")) != json!(true) {
            let state = "document.body.innerText.slice(0, 1500)";
            assert!(started.elapsed() < TIMEOUT, "never: {expression}\n{}", self.eval(state));
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// Position of the middle of an element in the window.
    pub fn middle(&self, selector: &str) -> [f64; 2] {
        let found = self.eval(&format!(
            "(() => {{ const e = document.querySelector({selector:?});
                e.scrollIntoView({{ block: 'center' }});
                const b = e.getBoundingClientRect();
                return [b.x + b.width / 2, b.y + b.height / 2]; }})()"
        ));
        [0, 1].map(|i| found[i].as_f64().unwrap())
    }

    pub fn click(&self, selector: &str) {
        let at = self.middle(selector);
        self.pointer(&[Pointer::To(at), Pointer::Down, Pointer::Up]);
    }

    /// Moves and presses the mouse.
    pub fn pointer(&self, acts: &[Pointer]) {
        let acts: Vec<Value> = acts
            .iter()
            .map(|act| match act {
                Pointer::To([x, y]) => {
                    json!({ "type": "pointerMove", "duration": 20, "x": x.round(), "y": y.round() })
                }
                Pointer::Down => json!({ "type": "pointerDown", "button": 0 }),
                Pointer::Up => json!({ "type": "pointerUp", "button": 0 }),
            })
            .collect();
        let mouse = json!({ "type": "pointer", "id": "mouse", "actions": acts });
        self.command("/actions", &json!({ "actions": [mouse] }));
    }

    /// Presses keys one after the other while the keys in `held` are down.
    pub fn keys(&self, held: &[char], keys: &str) {
        let act = |kind: &str, key: char| json!({ "type": kind, "value": key.to_string() });
        let mut acts: Vec<Value> = held.iter().map(|&key| act("keyDown", key)).collect();
        acts.extend(keys.chars().flat_map(|key| [act("keyDown", key), act("keyUp", key)]));
        acts.extend(held.iter().map(|&key| act("keyUp", key)));
        let keyboard = json!({ "type": "key", "id": "keyboard", "actions": acts });
        self.command("/actions", &json!({ "actions": [keyboard] }));
    }

    /// A command of the browser's own protocol.
    pub fn devtools(&self, command: &str, parameters: &Value) -> Value {
        self.command("/goog/cdp/execute", &json!({ "cmd": command, "params": parameters }))
    }

    /// Sets the size of the window and the colour scheme, light or dark.
    pub fn window(&self, width: u32, height: u32, scheme: &str) {
        let size =
            json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.devtools("Emulation.setDeviceMetricsOverride", &size);
        let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": scheme }] });
        self.devtools("Emulation.setEmulatedMedia", &media);
    }

    /// The window as a PNG.
    pub fn photograph(&self, path: &Path) {
        let shot = self.devtools("Page.captureScreenshot", &json!({ "format": "png" }));
        let letters = shot["data"].as_str().unwrap();
        std::fs::write(path, decoded(letters)).unwrap();
    }

    fn command(&self, path: &str, parameters: &Value) -> Value {
        self.call("POST", &format!("{}{path}", self.session), parameters)
    }

    fn call(&self, method: &str, path: &str, parameters: &Value) -> Value {
        let body = if method == "DELETE" { String::new() } else { parameters.to_string() };
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(2 * TIMEOUT)).unwrap();
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Length: {}\r\n\
             Content-Type: application/json\r\nConnection: close\r\n\r\n",
            self.port,
            body.len()
        );
        stream.write_all(head.as_bytes()).unwrap();
        stream.write_all(body.as_bytes()).unwrap();
        let mut reader = BufReader::new(stream);
        let mut length = 0;
        loop {
            let mut line = String::new();
            reader.read_line(&mut line).unwrap();
            if line.trim().is_empty() {
                break;
            }
            if let Some(("content-length", value)) = line.to_lowercase().split_once(':') {
                length = value.trim().parse().unwrap();
            }
        }
        let mut answer = vec![0; length];
        reader.read_exact(&mut answer).unwrap();
        let answer: Value = serde_json::from_slice(&answer).unwrap();
        let error = &answer["value"]["error"];
        assert!(error.is_null(), "{path} {parameters}: {error}: {}", answer["value"]["message"]);
        answer["value"].clone()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        if !self.session.is_empty() && !std::thread::panicking() {
            self.call("DELETE", &self.session.clone(), &Value::Null);
        }
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

/// An action of the mouse.
pub enum Pointer {
    To([f64; 2]),
    Down,
    Up,
}

/// Decodes Base64.
fn decoded(letters: &str) -> Vec<u8> {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let mut bytes = Vec::new();
    let (mut bits, mut count) = (0_u32, 0);
    for letter in letters.bytes().filter(|&letter| letter != b'=') {
        bits = bits << 6 | u32::from(value(letter));
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    bytes
}
