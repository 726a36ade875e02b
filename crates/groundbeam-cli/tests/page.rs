//! Tests the page of `groundbeam serve` in a real browser.

use crate::common::Folder;
use crate::served::browser::{Browser, Pointer};
use crate::served::{Server, opened, settled};
use std::path::{Path, PathBuf};

/// A footing in full contact, with its column in the middle.
const MIDDLE: &str = "\
title = \"Footing under one column\"

[beam]
length = \"12 m\"
EI = \"1.2e6 kN m^2\"

[foundation]
k = \"40 MN/m^2\"
mu = \"9 MN\"

[[load]]
point = \"600 kN\"          # the column
at = \"6 m\"

[[load]]
distributed = \"26 kN/m\"
";

const TAB: char = '\u{e004}';
const HOME: char = '\u{e011}';
const RIGHT: char = '\u{e014}';
const UP: char = '\u{e013}';
const CONTROL: char = '\u{e009}';
const BACKSPACE: &str = "\u{e003}";

/// Checks that the page shows the same results as the program for the text in its editor.
#[track_caller]
fn agrees(browser: &Browser) {
    let report = browser.text("#report");
    let text = browser.eval("document.getElementById('text').value");
    let printed = Folder::with(text.as_str().unwrap()).run(&["solve", "model.toml"]);
    let untimed = |text: &str| text.split("\nMethod ").next().unwrap().trim_end().to_owned();
    assert_eq!(untimed(&report), untimed(&(printed.stdout + &printed.stderr)));
    // The rows beside the picture have the words of the report.
    for label in ["Contact", "Lift-off", "End forces"] {
        let words = row(browser, label);
        let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(flat(&report).contains(&flat(&format!("{label} {words}"))), "{label} {words}");
    }
}

fn row(browser: &Browser, label: &str) -> String {
    let found = browser.eval(&format!(
        "[...document.querySelectorAll('#results tr')]
            .find((row) => row.cells[0].textContent === {label:?})?.cells[1].textContent ?? ''"
    ));
    found.as_str().unwrap().to_owned()
}

#[test]
fn dragging_a_load_updates_the_lift_off() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(MIDDLE);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    assert_eq!(row(&browser, "Lift-off"), "none");
    assert!(browser.text("#verdict").starts_with("In equilibrium: the resultant, 912 kN at x = 6"));
    agrees(&browser);

    // Drag the column to the left until the right end lifts off.
    let [x, y] = browser.middle(".grip");
    let scale =
        browser.eval("document.querySelector('#drawing svg').getBoundingClientRect().width");
    let step = scale.as_f64().unwrap() / 60.0;
    browser.pointer(&[Pointer::To([x, y]), Pointer::Down]);
    let mut steps = 0.0;
    while row(&browser, "Lift-off") == "none" {
        steps += 1.0;
        assert!(steps < 40.0, "the right end does not lift");
        browser.pointer(&[Pointer::To([x - steps * step, y])]);
        settled(&browser, "true");
    }
    browser.pointer(&[Pointer::Up]);
    assert!(row(&browser, "Lift-off").contains("to 12 m, up to"), "{}", row(&browser, "Lift-off"));
    agrees(&browser);
    let text = browser.eval("document.getElementById('text').value");
    let text = text.as_str().unwrap();
    // Only the number has changed; comment and unit are the same.
    let at = text.lines().find_map(|line| line.strip_prefix("at = \"")?.strip_suffix(" m\""));
    let at: f64 = at.unwrap().parse().unwrap();
    assert!(at > 0.0 && at < 6.0, "{at}");
    assert_eq!(text.replace(&format!("{at} m"), "6 m"), MIDDLE);
    // One undo reverts the whole drag, and one redo restores it.
    browser.keys(&[CONTROL], "z");
    settled(&browser, "document.getElementById('text').value.includes('at = \"6 m\"')");
    assert_eq!(row(&browser, "Lift-off"), "none");
    browser.keys(&[CONTROL], "y");
    settled(&browser, "!document.getElementById('text').value.includes('at = \"6 m\"')");
    agrees(&browser);

    // By keyboard: moves the load to the right by a hundredth of the beam, and increases it.
    browser.eval("document.querySelector('.grip').focus()");
    browser.keys(&[], &format!("{HOME}{RIGHT}"));
    settled(&browser, "document.getElementById('text').value.includes('at = \"0.12 m\"')");
    browser.keys(&[], &UP.to_string());
    settled(&browser, "document.getElementById('text').value.includes('point = \"630 kN\"')");
    agrees(&browser);
    // All requests went to this server.
    let foreign = format!(
        "performance.getEntriesByType('resource').map((r) => r.name)
            .filter((name) => !name.startsWith({:?}) && !name.startsWith('data:'))",
        server.url
    );
    assert_eq!(browser.eval(&foreign), serde_json::json!([]));
}

/// The footing with a neighbouring load on the ground to its right.
fn neighbour(at: &str) -> String {
    format!("{MIDDLE}\n[[ground_load]]\npoint = \"200 kN\"\nat = \"{at}\"\n")
}

#[test]
fn a_load_on_the_ground_is_dragged_along_the_surface() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(&neighbour("13 m"));
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    let grip = ".grip[aria-label='load 3: force on the ground']";
    let stands = || {
        let at = browser.eval(&format!(
            "Number(document.querySelector({grip:?}).getAttribute('aria-valuenow'))"
        ));
        at.as_f64().unwrap()
    };
    assert_eq!(stands(), 13.0);
    let text =
        || browser.eval("document.getElementById('text').value").as_str().unwrap().to_owned();

    // Dragging changes the text: to the right, away from the beam.
    let [x, y] = browser.middle(grip);
    let to = |x: f64| Pointer::To([x, y]);
    browser.pointer(&[to(x), Pointer::Down, to(x + 20.0), to(x + 40.0), Pointer::Up]);
    settled(
        &browser,
        &format!("Number(document.querySelector({grip:?}).getAttribute('aria-valuenow')) > 13.2"),
    );
    let at = stands();
    assert_eq!(text(), neighbour(&format!("{at} m")));
    agrees(&browser);
    // The drag stops at the edge of the picture.
    let [x, y] = browser.middle(grip);
    browser.pointer(&[
        Pointer::To([x, y]),
        Pointer::Down,
        Pointer::To([x + 400.0, y]),
        Pointer::Up,
    ]);
    settled(
        &browser,
        &format!("Number(document.querySelector({grip:?}).getAttribute('aria-valuenow')) > {at}"),
    );
    assert!(stands() < 16.0, "{}", stands());
    // The keyboard moves the load under the beam to its other side.
    browser.eval(&format!("document.querySelector({grip:?}).focus()"));
    browser.keys(&[], &HOME.to_string());
    settled(
        &browser,
        &format!("Number(document.querySelector({grip:?}).getAttribute('aria-valuenow')) < -1"),
    );
    agrees(&browser);

    // A change of the text moves the load on the page.
    let wanted = neighbour("-1.5 m");
    let area = "document.getElementById('text')";
    browser.eval(&format!("({area}.value = {wanted:?}, {area}.dispatchEvent(new Event('input')))"));
    settled(
        &browser,
        &format!("document.querySelector({grip:?}).getAttribute('aria-valuenow') === '-1.5'"),
    );
    agrees(&browser);
}

/// Tab reaches every control, the focus is visible, and no control traps it.
#[test]
fn every_control_is_reached_by_keyboard() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(MIDDLE);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    // One change enables the undo button, so that it can be reached.
    browser.eval("document.querySelector('[data-key=\"[foundation].k\"]').focus()");
    browser.keys(&[], &RIGHT.to_string());
    settled(&browser, "!document.getElementById('undo').disabled");
    let controls = "[...document.querySelectorAll(
        'button, select, input, textarea, summary, .grip')].filter((e) => !e.disabled && e.checkVisibility())";
    let count = browser.eval(&format!("{controls}.length")).as_u64().unwrap();
    assert!(count > 25, "{count}");
    browser.eval("(window.met = new Set(), document.addEventListener('focusin', ({ target }) => {
        const seen = getComputedStyle(target.querySelector('circle') ?? target);
        const ring = target.matches('.grip') ? seen.strokeWidth === '2.5px' : seen.outlineStyle !== 'none';
        if (ring) window.met.add(target); }), document.activeElement.blur(), window.scrollTo(0, 0))");
    browser.eval("document.getElementById('examples').focus()");
    browser.keys(&[], &TAB.to_string().repeat(count as usize + 4));
    let missed = browser.eval(&format!(
        "{controls}.filter((e) => e.id !== 'examples' && !window.met.has(e)).map((e) => e.outerHTML.slice(0, 90))"
    ));
    assert_eq!(missed, serde_json::json!([]));
}

#[test]
fn sliders_and_text_are_synchronised() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(MIDDLE);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);

    // A slider changes the text.
    browser.eval("document.querySelector('[data-key=\"[foundation].k\"]').focus()");
    browser.keys(&[], &HOME.to_string());
    settled(&browser, "document.getElementById('text').value.includes('k = \"4 MN/m^2\"')");
    agrees(&browser);
    // The user types a value with its unit.
    let field = "document.querySelector('[data-key=\"[foundation].k\"] + input')";
    browser.eval(&format!(
        "({field}.value = '55 N/mm^2', {field}.dispatchEvent(new Event('change')))"
    ));
    settled(&browser, "document.getElementById('text').value.includes('k = \"55 N/mm^2\"')");
    agrees(&browser);
    // The buttons undo and redo one step.
    browser.click("#undo");
    settled(&browser, "document.getElementById('text').value.includes('k = \"4 MN/m^2\"')");
    browser.click("#redo");
    settled(&browser, "document.getElementById('text').value.includes('k = \"55 N/mm^2\"')");
    // The button adds a missing key.
    let add = "[...document.querySelectorAll('#sliders button')]
        .find((button) => button.textContent.startsWith('add P'))";
    browser.eval(&format!("{add}.click()"));
    settled(&browser, "document.querySelector('[data-key=\"[beam].axial_force\"]')");
    agrees(&browser);

    // A fault in the text is shown at its line, and the picture remains.
    browser.eval("(document.getElementById('text').focus(), document.getElementById('text').setSelectionRange(0, 0))");
    browser.keys(&[], "x");
    settled(&browser, "document.body.classList.contains('wrong')");
    assert_eq!(browser.text("#gutter .fault"), "1");
    assert!(
        browser.text("#faults").contains("`xtitle` is not a key"),
        "{}",
        browser.text("#faults")
    );
    assert!(browser.text("#verdict").starts_with("Error in the model file: line 1: "));
    assert!(browser.text("#behind .says").contains("xtitle"));
    assert_ne!(browser.text("#drawing"), "");
    // Repair the fault.
    browser.keys(&[], BACKSPACE);
    settled(&browser, "!document.body.classList.contains('wrong')");
    assert_eq!(browser.text("#faults"), "");
    agrees(&browser);
}

/// A length as `12'-6"` becomes a decimal number, because one number stands behind a slider and a handle.
#[test]
fn lengths_in_feet_and_inches_have_sliders_and_handles() {
    let Some(browser) = Browser::start() else { return };
    let model = r#"[beam]
length = "12'-6\""
EI = "3e5 kip ft^2"
[foundation]
k = "100 ksf"
[[load]]
point = "100 kip"
at = "1'-3\""
"#;
    let folder = Folder::with(model);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    let field = "document.querySelector('[data-key=\"[beam].length\"] + input')";
    assert_eq!(browser.eval(&format!("{field}.value")), "12'-6\"");
    // The range of a positive quantity begins at a tenth of it.
    browser.eval("document.querySelector('[data-key=\"[beam].length\"]').focus()");
    browser.keys(&[], &HOME.to_string());
    let text = "document.getElementById('text').value";
    settled(&browser, &format!("{text}.includes('length = \"1.25 ft\"')"));
    // The typed sign of inches is escaped in the file.
    browser.eval(&format!(
        "({field}.value = '20\\'-0\"', {field}.dispatchEvent(new Event('change')))"
    ));
    settled(&browser, &format!("{text}.includes('length = \"20\\'-0\\\\\"\"')"));
    agrees(&browser);
    browser.eval("document.querySelector('.grip').focus()");
    browser.keys(&[], &format!("{HOME}{RIGHT}"));
    settled(&browser, &format!("{text}.includes('at = \"0.2 ft\"')"));
    agrees(&browser);
}

#[test]
fn the_page_shows_tipping_and_shares_and_downloads_the_model() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(MIDDLE);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    // A moment that lifts the right side, larger than the loads can balance.
    let area = "document.getElementById('text')";
    browser.eval(&format!(
        "({area}.value += '[[load]]\\nmoment = \"-6 MN m\"\\nat = \"1 m\"\\n', {area}.dispatchEvent(new Event('input')))"
    ));
    settled(&browser, "document.body.classList.contains('lost')");
    let said = browser.text("#verdict");
    assert!(
        said.starts_with("No equilibrium: ") && said.contains("tips about its left end"),
        "{said}"
    );
    assert!(browser.eval("document.querySelector('#drawing .moves') !== null") == true);
    assert!(row(&browser, "Motion").starts_with("the right end lifts off"));
    let printed = browser.text("#report");
    assert!(printed.contains("none: "), "{printed}");

    // The address contains the model.
    browser.click("#share");
    browser.until("location.hash.startsWith('#model=')");
    let address = browser.eval("location.href").as_str().unwrap().to_owned();
    let text = browser.eval(&format!("{area}.value"));
    browser.go("about:blank");
    browser.go(&address);
    settled(&browser, "document.body.classList.contains('lost')");
    assert_eq!(browser.eval(&format!("{area}.value")), text);

    // Save the report of a beam in equilibrium.
    browser.eval(&format!("({area}.value = {MIDDLE:?}, {area}.dispatchEvent(new Event('input')))"));
    settled(&browser, "!document.body.classList.contains('lost')");
    let kept = tempfile::tempdir().unwrap();
    let behaviour = serde_json::json!({ "behavior": "allow", "downloadPath": kept.path() });
    browser.devtools("Browser.setDownloadBehavior", &behaviour);
    for form in ["toml", "svg", "png", "csv", "json", "txt", "html"] {
        browser.click(&format!("[data-form={form}]"));
        let file = arrived(kept.path(), form);
        let bytes = std::fs::read(&file).unwrap();
        match form {
            "toml" => assert_eq!(bytes, MIDDLE.as_bytes()),
            "png" => assert!(bytes.starts_with(b"\x89PNG")),
            "txt" => assert!(String::from_utf8(bytes).unwrap().contains("Certificate  ")),
            "csv" => assert!(bytes.starts_with(b"x_m,deflection_m,")),
            "json" => assert!(bytes.starts_with(b"{") && bytes.ends_with(b"}\n")),
            "html" => {
                let page = String::from_utf8(bytes).unwrap();
                assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
                assert!(page.contains("<h1>Footing under one column</h1>"));
            }
            _ => assert!(bytes.starts_with(b"<svg ")),
        }
    }
}

/// Waits for a file that a browser saves. The browser first creates an empty file with this name, and writes
/// into another one.
fn arrived(folder: &Path, extension: &str) -> PathBuf {
    for _ in 0..1500 {
        let mut entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let file = entries.find(|p| p.extension().is_some_and(|e| e == extension));
        let written = |file: &PathBuf| std::fs::metadata(file).is_ok_and(|m| m.len() > 0);
        if let Some(file) = file.filter(written) {
            return file;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    panic!("no .{extension} was saved");
}

#[test]
fn combinations_and_trains_can_be_selected() {
    let Some(browser) = Browser::start() else { return };
    let server = Server::start(None);
    opened(&browser, &server);
    let example = |words: &str| {
        browser.eval(&format!(
            "(() => {{ const s = document.getElementById('examples');
                s.value = [...s.options].find((o) => o.text.includes({words:?})).value;
                s.dispatchEvent(new Event('change')); }})()"
        ));
    };
    example("combinations");
    settled(&browser, "!document.getElementById('combination-choice').hidden");
    let first = browser.eval("document.getElementById('combination').value");
    assert!(first.as_str().unwrap().starts_with("6.10: 1.35 G"), "{first}");
    assert!(browser.eval("document.querySelectorAll('.grip').length").as_u64() > Some(2));
    browser.eval("(document.getElementById('combination').value = '', document.getElementById('combination').dispatchEvent(new Event('change')))");
    settled(&browser, "document.getElementById('drawing').textContent.includes('envelope of 1')");

    example("Locomotive");
    settled(&browser, "!document.getElementById('axle-choice').hidden");
    let lifted = |axle: u32| {
        browser.eval(&format!(
            "(document.getElementById('axle').value = {axle}, document.getElementById('axle').dispatchEvent(new Event('input')))"
        ));
        settled(&browser, "true");
        (row(&browser, "Lift-off"), browser.text("#axle-at"))
    };
    let (early, late) = (lifted(200), lifted(600));
    assert_eq!((early.1.as_str(), late.1.as_str()), ("7.2 m", "21.6 m"));
    assert_ne!(early.0, late.0);
}

/// Colours of the picture that are shown as written. In the dark scheme all of them should change.
fn as_written(browser: &Browser) -> Vec<String> {
    let found = browser.eval(
        "[...new Set(['fill', 'stroke'].flatMap((paint) =>
            [...document.querySelectorAll(`#drawing svg:not(.grips) [${paint}^=\"#\"]`)]
                .filter((e) => getComputedStyle(e)[paint] === e.getAttribute(paint).replace(
                    /#(..)(..)(..)/, (_, r, g, b) => `rgb(${[r, g, b].map((h) => parseInt(h, 16)).join(', ')})`))
                .map((e) => `${paint} ${e.getAttribute(paint)}`)))]",
    );
    serde_json::from_value(found).unwrap()
}

#[test]
fn every_picture_has_colours_for_the_dark_scheme() {
    let Some(browser) = Browser::start() else { return };
    let server = Server::start(None);
    opened(&browser, &server);
    browser.window(1280, 1000, "dark");
    let change = |id: &str, value: &str| {
        browser.eval(&format!(
            "(() => {{ const s = document.getElementById({id:?}); s.value = {value:?};
                s.dispatchEvent(new Event('change')); }})()"
        ));
        settled(&browser, "document.getElementById('verdict').textContent !== ''");
    };
    let count = browser.eval("document.getElementById('examples').options.length - 1");
    for example in 0..count.as_u64().unwrap() {
        change("examples", &example.to_string());
        assert_eq!(as_written(&browser), [""; 0], "example {example}");
        for envelope in ["combination", "train"] {
            if browser.eval(&format!("!document.getElementById('{envelope}-choice').hidden"))
                == true
            {
                change(envelope, if envelope == "train" { "all" } else { "" });
                assert_eq!(as_written(&browser), [""; 0], "example {example}, {envelope}");
            }
        }
    }
}

#[test]
fn the_page_is_readable_on_a_phone_and_in_the_dark_scheme() {
    let Some(browser) = Browser::start() else { return };
    let server = Server::start(None);
    opened(&browser, &server);
    for (width, height) in [(360, 780), (1280, 1000)] {
        for scheme in ["light", "dark"] {
            browser.window(width, height, scheme);
            browser.go(&server.url);
            settled(&browser, "document.querySelectorAll('#results tr').length > 3");
            let wide = browser.eval("document.documentElement.scrollWidth");
            assert!(wide.as_u64() <= Some(width.into()), "{wide} in {width}");
            let paper =
                browser.eval("getComputedStyle(document.querySelector('#drawing svg rect')).fill");
            let expected = if scheme == "dark" { "rgb(23, 27, 32)" } else { "rgb(255, 255, 255)" };
            assert_eq!(paper, expected);
            assert_eq!(as_written(&browser).is_empty(), scheme == "dark");
            if let Some(folder) = std::env::var_os("GROUNDBEAM_PHOTOGRAPHS") {
                let name = format!("page-{width}-{scheme}.png");
                browser.photograph(&Path::new(&folder).join(name));
            }
        }
    }
}
