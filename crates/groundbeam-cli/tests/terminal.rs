//! Tests that names in a file and file names cannot control the terminal: control characters are escaped.

use crate::common::{Done, Folder};

/// Characters that a terminal interprets, or that hide the order of letters.
fn steering() -> impl Iterator<Item = char> {
    let control = ('\0'..='\u{1f}').chain('\u{7f}'..='\u{9f}');
    let direction = ['\u{61c}', '\u{200e}', '\u{200f}', '\u{2028}', '\u{2029}'];
    control.chain(direction).chain('\u{202a}'..='\u{202e}').chain('\u{2066}'..='\u{2069}')
}

/// A name with all of them, as written in a file.
fn name(word: &str) -> String {
    let escapes: String = steering().map(|c| format!("\\u{:04x}", u32::from(c))).collect();
    format!("\"{word}{escapes}\"")
}

#[track_caller]
fn steers_nothing(done: &Done) {
    for said in [&done.stdout, &done.stderr] {
        let found = said.chars().find(|&c| c != '\n' && steering().any(|steers| steers == c));
        assert_eq!(found, None, "{said}");
    }
}

fn model() -> String {
    let [title, dead, live, both] = ["title", "dead", "live", "both"].map(name);
    format!(
        "title = {title}\n[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n\
         [[load]]\npoint = 1\nat = 0.5\ncase = {dead}\n\
         [[load]]\nmoment = 0.1\nat = 0.5\ncase = {live}\n\
         [[combination]]\nname = {both}\nfactors = {{ {dead} = 1, {live} = 1 }}\n\
         [[combination]]\nname = \"one\"\nfactors = {{ {dead} = 1 }}\n"
    )
}

#[test]
fn reports_escape_control_characters() {
    let folder = Folder::with(&model());
    let commands: [&[&str]; 5] = [
        &["solve", "model.toml"],
        &["solve", "model.toml", "--combination", "one"],
        &["solve", "model.toml", "--combination", "one", "--factors"],
        &["solve", "model.toml", "--json"],
        &["check", "model.toml"],
    ];
    for arguments in commands {
        let done = folder.run(arguments);
        assert_eq!(done.status, 0, "{arguments:?}: {}", done.stderr);
        assert!(done.stdout.contains("u{1b}") || done.stdout.contains("u001b"), "{}", done.stdout);
        steers_nothing(&done);
    }
    let single = model().replace("[[combination]]", "[[case]]");
    let single = single.split("[[case]]").next().unwrap();
    folder.write("single.toml", single.as_bytes());
    steers_nothing(&folder.run(&["compare", "single.toml", "--elements", "10"]));
}

#[test]
fn train_results_escape_control_characters() {
    let train = name("train");
    let folder = Folder::with(&format!(
        "title = {}\n[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n\
         [[train]]\nname = {train}\naxles = [{{ at = 0, force = 1 }}]\nfrom = 0.4\nto = 0.6\n",
        name("title")
    ));
    for command in ["solve", "check"] {
        steers_nothing(&folder.run(&[command, "model.toml"]));
    }
}

#[test]
fn study_results_escape_control_characters() {
    let folder = Folder::with(
        "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0.5\n",
    );
    let study = format!(
        "title = {}\nmodel = \"model.toml\"\nsamples = 8\n\
         [[random]]\nwhat = \"load[0]\"\ndistribution = \"normal\"\ncov = 0.1\n\
         [[event]]\nname = {}\nquantity = \"deflection.max\"\nabove = 1\n",
        name("title"),
        name("event")
    );
    folder.write("study.toml", study.as_bytes());
    for form in [&[][..], &["--json"]] {
        let mut arguments = vec!["study", "study.toml", "--out", "results"];
        arguments.extend(form);
        let done = folder.run(&arguments);
        assert_eq!(done.status, 0, "{}", done.stderr);
        steers_nothing(&done);
    }
}

/// Characters are escaped in messages, in hints, in lines of the file and in the file name.
#[test]
fn diagnostics_escape_control_characters() {
    let folder = Folder::with(&model());
    let unknown = folder.run(&["solve", "model.toml", "--combination", "third"]);
    unknown.fails(2, r"both\u{0}\u{1}");
    steers_nothing(&unknown);
    steers_nothing(&folder.run(&["solve", "model.toml", "--factors", "nobody"]));
    let raw: String = steering().filter(|&c| c >= '\u{7f}').collect();
    let wrong = model().replace("= 1, ", "= 1, a = 1, ").replace("dead", &format!("dead{raw}"));
    folder.write("wrong.toml", wrong.as_bytes());
    let done = folder.run(&["check", "wrong.toml"]);
    assert_eq!(done.status, 2);
    steers_nothing(&done);
}

#[cfg(unix)]
#[test]
fn file_names_escape_control_characters() {
    let name: String = steering().filter(|&c| c != '\0').chain("x.toml".chars()).collect();
    let folder = Folder::new();
    folder.run(&["new", &name]);
    steers_nothing(&folder.run(&["solve", &name]));
    steers_nothing(&folder.run(&["new", &name]));
    folder.write(&name, b"[beam]\nlength = 0\n");
    let done = folder.run(&["solve", &name]);
    done.fails(2, r"\u{1b}");
    steers_nothing(&done);
    steers_nothing(&folder.run(&["solve", &format!("missing{name}")]));
    steers_nothing(&folder.run(&["merge", &name, "--out", &name]));
}
