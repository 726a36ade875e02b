//! Tests the requests that the page of `groundbeam serve` sends, and the sliders that it creates from a
//! response.

use crate::common::{FOOTING, Folder};
use crate::served::browser::Browser;
use crate::served::{Server, opened, settled};

const HOME: char = '\u{e011}';
const END: char = '\u{e010}';

/// Types a text into the editor.
fn type_in(browser: &Browser, text: &str) {
    let area = "document.getElementById('text')";
    browser.eval(&format!("({area}.value = {text:?}, {area}.dispatchEvent(new Event('input')))"));
}

#[test]
fn a_new_request_aborts_the_previous_one() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(FOOTING);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    // The next request has no response.
    browser.eval(
        "(() => { const real = window.fetch; window.aborted = 0;
            window.fetch = (address, { signal }) => { window.fetch = real;
                return new Promise((_, reject) => signal.addEventListener('abort', () => {
                    window.aborted += 1; reject(signal.reason); })); }; })()",
    );
    type_in(&browser, &FOOTING.replace("\"5 m\"", "\"4 m\""));
    browser.until("document.body.dataset.state === 'waiting'");
    assert_eq!(browser.eval("window.aborted"), 0);
    type_in(&browser, &FOOTING.replace("\"5 m\"", "\"3 m\""));
    settled(&browser, "window.aborted === 1");
    browser.until("document.querySelector('.grip').getAttribute('aria-valuenow') === '3'");
    assert!(browser.text("#verdict").starts_with("In equilibrium"));
}

#[test]
fn the_page_shows_the_message_of_a_refused_request() {
    let Some(browser) = Browser::start() else { return };
    let folder = Folder::with(FOOTING);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    browser.eval(
        "(window.real = window.fetch, window.fetch = (address, options) =>
            window.real(address.replace('?', '?width=wide&'), options))",
    );
    type_in(&browser, &format!("{FOOTING}\n"));
    settled(&browser, "document.body.classList.contains('wrong')");
    let said = browser.text("#verdict");
    assert!(said.starts_with("Invalid request: `width=wide` in the query"), "{said}");
    // A response that does not come from the program.
    browser.eval(
        "(window.fetch = async () => new Response('busy', { status: 503, statusText: 'Busy' }))",
    );
    type_in(&browser, &format!("{FOOTING}\n\n"));
    settled(&browser, "document.getElementById('verdict').textContent.includes('503')");
    assert!(
        browser
            .text("#verdict")
            .starts_with("No response: the server responded with 503 Busy: busy")
    );
    // Restores the real `fetch`.
    browser.eval("(window.fetch = window.real)");
    drop(server);
    type_in(&browser, FOOTING);
    settled(&browser, "document.getElementById('verdict').textContent.startsWith('No connection')");
}

/// A chosen train and combination are deselected when they are deleted from the text.
#[test]
fn a_selection_that_is_deleted_from_the_text_is_cleared() {
    let Some(browser) = Browser::start() else { return };
    let train = "[[train]]\naxles = [{ at = \"0 m\", force = \"90 kN\" }]\n";
    let both = format!("{FOOTING}{train}{train}name = \"second\"\n");
    let folder = Folder::with(&both);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    settled(&browser, "document.getElementById('train').value === '0'");
    browser.eval(
        "(() => { const s = document.getElementById('train'); s.value = '1';
            s.dispatchEvent(new Event('change')); })()",
    );
    settled(&browser, "document.getElementById('train').value === '1'");
    type_in(&browser, &format!("{FOOTING}{train}"));
    settled(&browser, "document.getElementById('train').value === '0'");
    assert!(!browser.text("#verdict").contains("refused"), "{}", browser.text("#verdict"));
    type_in(&browser, FOOTING);
    settled(&browser, "document.getElementById('train-choice').hidden");
    assert!(browser.text("#verdict").starts_with("In equilibrium"));
}

#[test]
fn sliders_respect_the_signs_of_the_file_format() {
    let Some(browser) = Browser::start() else { return };
    let model = FOOTING.replace("[foundation]", "shear_stiffness = \"900 MN\"\n[foundation]")
        + "[[load]]\ncurvature = \"1e-4 1/m\"\n[[gap]]\nat = \"1 m\"\nvalue = \"0 mm\"\n";
    let folder = Folder::with(&model);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    let at = |key: &str, end: char| {
        browser.eval(&format!("document.querySelector('[data-key={key:?}]').focus()"));
        browser.keys(&[], &end.to_string());
        settled(&browser, "true");
        let value = browser.eval(&format!(
            "parseFloat(document.querySelector('[data-key={key:?}] + input').value)"
        ));
        value.as_f64().unwrap()
    };
    assert_eq!(at("[beam].shear_stiffness", HOME), 90.0);
    assert_eq!(at("[[load]]2.curvature", HOME), -3e-4);
    assert_eq!(at("[[gap]]1.value", HOME), -10.0);
    assert_eq!(at("[[gap]]1.value", END), 10.0);
    assert_eq!(at("[[load]]1.at", HOME), 0.0);
    assert!(!browser.eval("document.body.classList.contains('wrong')").as_bool().unwrap());
}

/// A train in a file in feet: its first axle, the handle of a load and what the page adds to the file.
#[test]
fn the_page_writes_positions_in_the_units_of_the_file() {
    let Some(browser) = Browser::start() else { return };
    let model = "[beam]\nlength = \"40 ft\"\nEI = \"1e6 kip ft^2\"\n[foundation]\nk = \"1000 ksf\"\n\
                 [[load]]\npoint = \"200 kip\"\nat = \"10 ft\"\n\
                 [[train]]\naxles = [{ at = \"0 ft\", force = \"20 kip\" }]\n";
    let folder = Folder::with(model);
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    settled(&browser, "!document.getElementById('axle-choice').hidden");
    assert_eq!(browser.text("#axle-at"), "20 ft");
    let handle = "document.querySelector('.grip').getAttribute('aria-valuetext')";
    assert_eq!(browser.eval(handle), "at 10 ft");
    browser.eval(
        "[...document.querySelectorAll('#sliders button')]
            .find((button) => button.textContent.includes('shear layer')).click()",
    );
    settled(&browser, "document.getElementById('text').value.includes('mu = \"0 kip\"')");
    assert!(browser.text("#verdict").starts_with("In equilibrium"));
    // The options of the program choose other units; a file without units has none.
    let server =
        Server::with(Some(&folder.path("model.toml")), &["--units", "si", "--digits", "6"]);
    opened(&browser, &server);
    settled(&browser, "!document.getElementById('axle-choice').hidden");
    assert_eq!(browser.text("#axle-at"), "6.096 m");
    assert!(browser.text("#verdict").contains("978.609 kN"), "{}", browser.text("#verdict"));
    type_in(
        &browser,
        "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0.5\n",
    );
    settled(&browser, "document.getElementById('verdict').textContent.includes('resultant, 1 at')");
}

#[test]
fn each_number_of_a_list_has_a_slider_of_its_own_range() {
    let Some(browser) = Browser::start() else { return };
    let k = "k = [\"40 MN/m^2\", \"2 MN/m^2\"]";
    let lines: Vec<&str> =
        FOOTING.lines().map(|line| if line.starts_with("k = ") { k } else { line }).collect();
    let folder = Folder::with(&lines.join("\n"));
    let server = Server::start(Some(&folder.path("model.toml")));
    opened(&browser, &server);
    let value = |key: &str| {
        let field = format!("document.querySelector('[data-key={key:?}] + input').value");
        browser.eval(&format!("parseFloat({field})")).as_f64().unwrap()
    };
    browser.eval("document.querySelector('[data-key=\"[foundation].k\"]').focus()");
    browser.keys(&[], &END.to_string());
    settled(&browser, "true");
    assert_eq!(value("[foundation].k"), 400.0);
    assert_eq!(value("[foundation].k 2"), 2.0);
}
