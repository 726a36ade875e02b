//! Tests `groundbeam serve`: responses, and requests that must be refused.

use crate::common::{FOOTING, Folder, LIFTS, tips};
use crate::served::{Server, talk};
use serde_json::{Value, json};

/// A document without its duration.
fn timeless(mut document: Value) -> Value {
    document.as_object_mut().unwrap().remove("seconds");
    document
}

#[test]
fn a_solve_request_returns_the_result_document() {
    let server = Server::start(None);
    let combined = format!(
        "{LIFTS}case = 'Q'\n[[combination]]\nname = 'one'\nfactors = {{ Q = 1.0 }}\n\
         [[combination]]\nname = 'two'\nfactors = {{ Q = 0.5 }}\n"
    );
    let train = format!("{FOOTING}[[train]]\naxles = [{{ at = '0 m', force = '90 kN' }}]\n");
    for (model, status) in [(LIFTS, 0), (FOOTING, 0), (&tips(), 3), (&combined, 0), (&train, 0)] {
        let printed = Folder::with(model).run(&["solve", "model.toml", "--json"]);
        assert_eq!(printed.status, status);
        let reply = server.post("/api/solve", model);
        assert_eq!(reply.status, 200, "{}", reply.text());
        assert!(reply.head.contains("content-type: application/json"), "{}", reply.head);
        assert_eq!(timeless(reply.json()), timeless(printed.json()));
    }
}

#[test]
fn an_invalid_model_returns_its_diagnostics() {
    let server = Server::start(None);
    let reply = server.post("/api/solve", &LIFTS.replace("length", "lenght"));
    assert_eq!((reply.status, &reply.json()["status"]), (422, &json!("wrong-model")));
    let fault = &reply.json()["diagnostics"][0];
    let seen = ["code", "line", "column", "hint"].map(|key| fault[key].clone());
    assert_eq!(seen, [json!("GB003"), json!(3), json!(1), json!("did you mean `length`?")]);
    let many = server.post("/api/solve", &"[[load]]\n".repeat(2000)).json();
    assert_eq!(many["diagnostics"].as_array().unwrap().len(), 1000);
    assert!(many["count"].as_u64() > Some(1999), "{}", many["count"]);
    for body in [&b""[..], b"\xff\xfe\x00", b"{}", b"[beam", b"\x00\x01\x02", b"--boundary\r\n"] {
        let reply = server.ask("POST", "/api/solve", &[], body);
        assert_eq!(reply.status, 422, "{body:?}: {}", reply.text());
        assert!(!reply.json()["diagnostics"].as_array().unwrap().is_empty());
    }
}

#[test]
fn invalid_http_requests_are_refused() {
    let server = Server::start(None);
    let typed = |kind: &str| {
        let header = format!("Content-Type: {kind}");
        server.ask("POST", "/api/solve", &[&header], LIFTS.as_bytes()).status
    };
    for right in ["application/toml", "text/plain; charset=utf-8", "Application/Octet-Stream"] {
        assert_eq!(typed(right), 200, "{right}");
    }
    for wrong in ["application/json", "multipart/form-data; boundary=x", "image/png", "", "x"] {
        assert_eq!(typed(wrong), 415, "{wrong}");
    }
    let huge = vec![b'#'; 5 << 20];
    assert_eq!(server.ask("POST", "/api/solve", &[], &huge).status, 413);
    // An announced body that never arrives does not block other requests.
    let host = format!("Host: 127.0.0.1:{}", server.port);
    let endless = format!("POST /api/solve HTTP/1.1\r\n{host}\r\nContent-Length: 99999999\r\n\r\n");
    assert_eq!(server.say(&endless, b"[beam]").status, 413);
    assert_eq!(server.get("/api/solve").status, 405);
    assert_eq!(server.get("/nowhere").status, 404);
    assert_eq!(server.get("/../Cargo.toml").status, 404);
    assert_eq!(server.post("/api/file/exe", LIFTS).status, 404);
    assert_eq!(server.say("nonsense\r\n\r\n", b"").status, 400);
    assert_eq!(server.post("/api/solve", LIFTS).status, 200);
}

/// Two trains, the first of which moves from 1 m to 4 m, and two combinations.
fn trains() -> String {
    let axle = "axles = [{ at = '0 m', force = '90 kN' }]\n";
    format!(
        "{FOOTING}[[train]]\nfrom = '1 m'\nto = '4 m'\n{axle}[[train]]\nname = 'second'\n{axle}\
         [[load]]\npoint = '5 kN'\nat = '2 m'\ncase = 'Q'\n\
         [[combination]]\nname = 'one'\nfactors = {{ Q = 1.0 }}\n\
         [[combination]]\nname = 'two & more'\nfactors = {{ Q = 0.5 }}\n"
    )
}

#[test]
fn an_invalid_query_is_refused_with_its_key_value_and_allowed_values() {
    let server = Server::start(None);
    let trains = trains();
    let refused = |path: &str, model: &str, words: &[&str]| {
        let reply = server.post(path, model);
        assert_eq!(reply.status, 400, "{path}: {}", reply.text());
        assert!(reply.head.contains("content-type: application/json"), "{}", reply.head);
        let answer = reply.json();
        assert_eq!(answer["status"], "refused");
        let message = answer["message"].as_str().unwrap();
        let key = answer["query"]["key"].as_str().unwrap();
        let value = answer["query"]["value"].as_str().unwrap();
        assert!(message.contains(&format!("`{key}={value}`")), "{message}");
        for word in words {
            assert!(message.contains(word), "{path}: {message}");
        }
    };
    for address in ["/api/solve", "/api/view", "/api/file/svg", "/api/file/json"] {
        for (query, words) in [
            ("first_axle=nan&train=0", &["first_axle", "a finite number"][..]),
            ("first_axle=inf&train=0", &["a finite number"]),
            ("first_axle=&train=0", &["a finite number"]),
            ("first_axle=2", &["unless `train` is the index of a train"]),
            ("first_axle=2&train=all", &["unless `train` is the index of a train"]),
            ("first_axle=0.9&train=0", &["from 1 to 4 for this train"]),
            ("train=99", &["train=99", "0 to 1 or `all`, because this file has 2 trains"]),
            ("train=2", &["0 to 1"]),
            ("train=-1", &["counted from 0, or `all`"]),
            ("train=0.5", &["from 0, or `all`"]),
            ("train=", &["from 0, or `all`"]),
            ("train=99999999999999999999999", &["from 0, or `all`"]),
            ("train=0&train=1", &["given only once"]),
            (
                "combination=three",
                &["combination=three", "one of the combinations one, two & more"],
            ),
            ("combination=two%20%26%20less", &["combination=two & less"]),
            ("combination=%ff", &["one of the combinations one"]),
            ("combination=", &["one of the combinations one"]),
            ("trian=0", &["trian", "combination, train, first_axle"]),
            ("%00=%0a", &["this address allows only the query keys"]),
        ] {
            refused(&format!("{address}?{query}"), &trains, words);
        }
        refused(&format!("{address}?train=0"), FOOTING, &["this file has no trains"]);
        refused(&format!("{address}?combination=one"), FOOTING, &["this file has no combinations"]);
    }
    for width in ["wide", "nan", "0", "-100", "1e999", ""] {
        refused(&format!("/api/view?width={width}"), FOOTING, &["a positive number"]);
    }
    refused("/api/solve?width=700", FOOTING, &["combination, train, first_axle"]);
    refused(
        "/api/file/html?train=0",
        &trains,
        &["this address allows only the query keys combination"],
    );
    // A query that is invalid for every file is refused before the file is read.
    refused("/api/solve?train=x", "[beam", &["from 0"]);
    for path in ["/api/start?x=1", "/?train=0", "/page.js?v=2"] {
        let reply = server.get(path);
        assert_eq!((reply.status, &reply.json()["status"]), (400, &json!("refused")), "{path}");
    }
    assert_eq!(server.post("/api/file/%ff", FOOTING).json()["status"], "refused");
    // Valid queries are answered.
    for query in
        ["", "train=0", "train=1&first_axle=0.5", "train=all", "combination=two+%26%20more"]
    {
        let path = format!("/api/solve?{query}");
        assert_eq!(server.post(&path, &trains).status, 200, "{path}");
    }
    assert_eq!(server.post("/api/view?width=1e9", &trains).status, 200);
}

#[test]
fn a_view_of_trains_shows_the_first_train_at_one_position_by_default() {
    let server = Server::start(None);
    let view = |query: &str| {
        let reply = server.post(&format!("/api/view{query}"), &trains());
        reply.json()["picture"]["svg"]
            .as_str()
            .unwrap_or_else(|| panic!("{}", reply.text()))
            .to_owned()
    };
    assert_eq!(view(""), view("?train=0&first_axle=2.5"));
    assert_ne!(view(""), view("?train=all"));
}

/// Opens connections on which little or nothing arrives.
#[test]
fn slow_connections_do_not_stop_others() {
    use std::io::{Read, Write};
    let server = Server::start(None);
    let open = |sent: &str| {
        let mut stream = std::net::TcpStream::connect(("127.0.0.1", server.port)).unwrap();
        stream.write_all(sent.as_bytes()).unwrap();
        stream.set_read_timeout(Some(std::time::Duration::from_secs(120))).unwrap();
        stream
    };
    let body = format!(
        "POST /api/solve HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Length: 99\r\n\r\n[",
        server.port
    );
    let sent = ["", "GET", "POST /api/solve HTTP/1.1\r\n", &body];
    let slow: Vec<_> = (0..400).map(|i| open(sent[i % 3])).collect();
    let bodies: Vec<_> = (0..20).map(|_| open(&body)).collect();
    assert_eq!(server.post("/api/solve", LIFTS).status, 200);
    // The program closes each of them.
    for mut stream in slow {
        let mut rest = Vec::new();
        let ended = stream.read_to_end(&mut rest);
        assert!(ended.is_ok_and(|_| rest.is_empty()), "{rest:?}");
    }
    drop(bodies);
    assert_eq!(server.post("/api/solve", LIFTS).status, 200);
}

#[test]
fn requests_from_other_origins_and_host_names_are_refused() {
    let server = Server::start(None);
    let port = server.port;
    let from = |origin: &str| {
        server.ask("POST", "/api/solve", &[&format!("Origin: {origin}")], LIFTS.as_bytes()).status
    };
    assert_eq!(from(&format!("http://127.0.0.1:{port}")), 200);
    assert_eq!(from(&format!("http://localhost:{port}")), 200);
    let strangers = [
        "http://example.org".to_owned(),
        "null".to_owned(),
        format!("https://127.0.0.1:{port}"),
        "http://127.0.0.1".to_owned(),
        format!("http://127.0.0.1:{port}.example.org"),
        format!("http://127.0.0.1:{}", port.wrapping_add(1)),
    ];
    for origin in strangers {
        assert_eq!(from(&origin), 403, "{origin}");
    }
    let under = |host: &str| server.say(&format!("GET / HTTP/1.1\r\n{host}\r\n\r\n"), b"").status;
    assert_eq!(under(&format!("Host: 127.0.0.1:{port}")), 200);
    assert_eq!(under(&format!("Host: LOCALHOST:{port}")), 200);
    let own = format!("Host: 127.0.0.1:{port}");
    let rebound = [
        format!("Host: example.org:{port}"),
        "Host: 127.0.0.1".to_owned(),
        format!("{own}\r\nHost: example.org:{port}"),
        format!("{own}\r\nOrigin: http://127.0.0.1:{port}\r\nOrigin: http://example.org"),
    ];
    for host in rebound.iter().chain(&[format!("Host: 0.0.0.0:{port}"), "X: y".to_owned()]) {
        assert!([400, 403, 421].contains(&under(host)), "{host}");
    }
    let elsewhere = format!("GET http://example.org/ HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n");
    assert_eq!(server.say(&elsewhere, b"").status, 421);
}

#[test]
fn two_hundred_simultaneous_requests_are_served() {
    let server = Server::start(None);
    let port = server.port;
    let one = |i: usize| {
        let model = LIFTS.replace("0.49", &format!("{}", 0.001 * i as f64));
        let head = format!(
            "POST /api/solve HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nContent-Length: {}\r\n\r\n",
            model.len()
        );
        (model.clone(), talk(port, &head, model.as_bytes()))
    };
    let replies: Vec<_> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..200).map(|i| scope.spawn(move || one(i))).collect();
        all.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    for (i, (_, reply)) in replies.iter().enumerate() {
        assert_eq!((reply.status, &reply.json()["status"]), (200, &json!("solved")), "{i}");
    }
    // Each response belongs to its own request.
    for (model, reply) in replies.iter().step_by(50) {
        let printed = Folder::with(model).run(&["solve", "model.toml", "--json"]);
        assert_eq!(timeless(reply.json()), timeless(printed.json()));
    }
}

#[test]
fn a_view_returns_the_text_location_of_every_number() {
    let server = Server::start(None);
    let view = server.post("/api/view?width=700", FOOTING).json();
    assert_eq!(view["status"], "solved");
    let handle = &view["picture"]["handles"][0];
    let number = &view["numbers"][handle["position"].as_u64().unwrap() as usize];
    let [from, to] = ["from", "to"].map(|end| number[end].as_u64().unwrap() as usize);
    assert_eq!((&FOOTING[from..to], &number["unit"]), ("5", &json!("m")));
    // The handle is at the position in the picture.
    let [left, scale] = ["left", "scale"].map(|key| view["picture"][key].as_f64().unwrap());
    assert!((handle["x"].as_f64().unwrap() - (left + 5.0 * scale)).abs() < 1e-9);
    // The self-weight of a beam has no position to drag.
    let section = "E = \"30 GPa\"\nsection = { width = \"1 m\", height = \"1 m\" }\nunit_weight = \"25 kN/m^3\"";
    let heavy = FOOTING.replace("EI = \"1.2e6 kN m^2\"", section);
    let heavier = server.post("/api/view?width=700", &heavy).json();
    assert_ne!(heavier["document"], view["document"]);
    let handles = |view: &Value| view["picture"]["handles"].as_array().unwrap().len();
    assert_eq!(handles(&heavier), handles(&view));
    let lost = server.post("/api/view", &tips()).json();
    assert_eq!(lost["status"], "no-equilibrium");
    assert!(lost["sentence"].as_str().unwrap().contains("the beam tips about its right end"));
    assert!(
        lost["picture"]["svg"].as_str().unwrap().contains(r#"class="moves" data-still="matrix("#)
    );
}

/// A view, a file and a report have the units and digits of their query, as the output of the command line
/// does.
#[test]
fn responses_have_the_units_and_digits_of_the_query() {
    let server = Server::start(None);
    let folder = Folder::with(FOOTING);
    let untimed = |text: &str| text.split("\nMethod ").next().unwrap().to_owned();
    for (query, arguments) in [
        ("units=us", ["--units", "us"]),
        ("digits=7", ["--digits", "7"]),
        ("units=file", ["--units", "file"]),
    ] {
        let text = folder.run(&[&["solve", "model.toml"][..], &arguments[..]].concat()).stdout;
        let reply = server.post(&format!("/api/file/txt?{query}"), FOOTING);
        assert_eq!(untimed(reply.text()), untimed(&text), "{query}");
        let view = server.post(&format!("/api/view?{query}"), FOOTING).json();
        assert_eq!(untimed(view["report"].as_str().unwrap()), untimed(&text), "{query}");
    }
    let view = server.post("/api/view?units=us", FOOTING).json();
    assert_eq!(view["shown_in"], json!({ "name": "ft", "size": 0.3048 }));
    assert!(server.post("/api/file/html?units=us", FOOTING).text().contains(" kip-ft"));
    for (path, model, words) in [
        ("/api/view?units=yards", FOOTING, "`units` must be `file`, `si` or `us`"),
        ("/api/view?digits=1", FOOTING, "`digits` must be a whole number from 2 to 15"),
        ("/api/view?digits=4.5", FOOTING, "`digits` must be a whole number from 2 to 15"),
        (
            "/api/view?units=us",
            LIFTS,
            "`units` must be `file`, because the model file has no units",
        ),
        ("/api/solve?units=us", FOOTING, "this address allows only the query keys combination"),
    ] {
        let reply = server.post(path, model);
        let message = reply.json()["message"].as_str().unwrap_or_default().to_owned();
        assert!(reply.status == 400 && message.contains(words), "{path}: {message}");
    }
}

#[test]
fn downloaded_files_equal_those_of_the_command_line() {
    let server = Server::start(None);
    let folder = Folder::with(LIFTS);
    let arguments = ["solve", "model.toml", "--csv", "t.csv", "--plot", "p.svg"];
    let printed = folder.run(&arguments);
    folder.run(&["solve", "model.toml", "--report", "r.html"]).is_clean(0);
    assert_eq!(server.post("/api/file/html", LIFTS).text(), folder.read("r.html"));
    assert_eq!(server.post("/api/file/csv", LIFTS).text(), folder.read("t.csv"));
    assert_eq!(server.post("/api/file/svg", LIFTS).text(), folder.read("p.svg"));
    assert!(server.post("/api/file/png", LIFTS).body.starts_with(b"\x89PNG"));
    let untimed = |text: &str| text.split("\nMethod ").next().unwrap().to_owned();
    let report = server.post("/api/file/txt", LIFTS);
    assert_eq!(untimed(report.text()), untimed(&printed.stdout));
    assert_eq!(server.post("/api/file/svg", &tips()).status, 409);
    // A report explains why there is no equilibrium.
    let report = server.post("/api/file/html", &tips());
    assert!(report.status == 200 && report.text().contains("No equilibrium"));
    assert_eq!(server.post("/api/file/json", &tips()).json()["status"], "no-equilibrium");
}

#[test]
fn the_page_contacts_no_other_server() {
    let folder = Folder::with(FOOTING);
    let server = Server::start(Some(&folder.path("model.toml")));
    let start = server.get("/api/start").json();
    assert_eq!(start["start"], json!({ "name": "model.toml", "text": FOOTING }));
    let page = server.get("/");
    assert!(page.head.contains("content-security-policy: default-src 'none'"), "{}", page.head);
    let files = [
        "/page.css",
        "/dark.css",
        "/page.js",
        "/picture.js",
        "/share.js",
        "/sliders.js",
        "/text.js",
    ];
    for path in ["/"].iter().chain(&files) {
        let file = server.get(path);
        assert_eq!(file.status, 200, "{path}");
        let foreign = file.text().replace("http://www.w3.org/2000/svg", "");
        assert!(!foreign.contains("//www.") && !foreign.contains("https:"), "{path}");
        assert!(!foreign.contains("http:"), "{path}");
    }
    for path in ["/inter.ttf", "/inter-semi-bold.ttf"] {
        assert!(server.get(path).body.starts_with(b"\x00\x01\x00\x00"), "{path}");
    }
}

#[test]
fn the_serve_command_reports_missing_files_and_unusable_ports() {
    let folder = Folder::new();
    folder.run(&["serve", "missing.toml", "--no-open"]).fails(2, "missing.toml: ");
    folder.run(&["serve", "--port", "70000", "--no-open"]).fails(2, "70000");
    let server = Server::start(None);
    let taken = server.port.to_string();
    folder.run(&["serve", "--port", &taken, "--no-open"]).fails(2, &format!("port {taken}"));
}
