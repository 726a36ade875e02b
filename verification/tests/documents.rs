//! Checks that the documents agree with each other and with the code.

use groundbeam::Field;
use groundbeam::supported::{Feature, Way, refusal};
use groundbeam_testing::{expect, files, read, repository};
use groundbeam_verification::architecture::{crates, sources};
use groundbeam_verification::crossing;
use std::collections::BTreeSet;

#[test]
fn the_notation_contains_the_statement_of_the_problem() {
    expect("docs/notation.md", "problem", &read("crates/groundbeam/problem.md"));
}

fn named(feature: Feature) -> &'static str {
    match feature {
        Feature::LocalEquilibrium => "compression beyond the beam's own buckling load",
        Feature::OneWaySupports => "supports that act in one direction",
        Feature::IteratedGround => "k and μ that depend on the solution (modified Vlasov model)",
    }
}

/// The limits in the README: for each feature, the methods that refuse it.
#[test]
fn the_readme_lists_what_is_not_supported() {
    let mut lines = "| feature | refused by |\n|---|---|\n".to_owned();
    for feature in Feature::ALL {
        let refusing: Vec<&str> = Way::ALL
            .iter()
            .filter(|way| refusal(feature, **way).is_some())
            .map(|way| match way {
                Way::Exact => "the default method",
                Way::ActiveSet => "`active-set`",
                Way::Iteration => "`psor` and `uzawa`",
                Way::Nodes => "`NodalSolver`",
                Way::LoadFactors => "load factors",
            })
            .collect();
        if !refusing.is_empty() {
            lines += &format!("| {} | {} |\n", named(feature), refusing.join("; "));
        }
    }
    expect("README.md", "limits", &lines);
}

/// The table of methods and features in `docs/methods.md`.
#[test]
fn the_table_of_methods_and_features_agrees_with_the_program() {
    let rows = Feature::ALL.map(|feature| {
        let name = named(feature);
        let cells = Way::ALL.map(|way| refusal(feature, way).unwrap_or("yes"));
        format!("| {name} | {} |\n", cells.join(" | "))
    });
    let ways = Way::ALL.map(|way| match way {
        Way::Exact => "`exact`",
        Way::ActiveSet => "`active-set`",
        Way::Iteration => "`psor`, `uzawa`",
        Way::Nodes => "nodes alone (section 10)",
        Way::LoadFactors => "load factors",
    });
    let head = format!("| feature | {} |\n|---|{}\n", ways.join(" | "), "---|".repeat(ways.len()));
    expect("docs/methods.md", "features", &(head + &rows.concat()));
}

#[test]
fn examples_in_the_documents_equal_the_example_programs() {
    let (readme, rust) = (read("README.md"), read("docs/rust.md"));
    let example = read("crates/groundbeam/examples/footing.rs");
    let (_, code) = example.split_once("\n\n").expect("documentation, then code");
    assert!(rust.contains(&format!("```rust\n{code}```")), "docs/rust.md holds footing.rs");
    let printed = read("crates/groundbeam/examples/footing.expected");
    assert!(rust.contains(&format!("```text\n{printed}```")), "docs/rust.md holds its output");
    let model = read("docs/strip-footing.toml");
    assert!(readme.contains(&format!("```toml\n{model}```")), "README.md holds the model file");
}

#[test]
fn the_readme_and_the_merge_script_run_the_same_test_command() {
    let command = "\ncargo test --workspace\n";
    assert!(read("README.md").contains(command) && read(".ci/run").contains(command));
}

/// Compares the picture with the output of `cargo run --example crossing`.
#[test]
fn the_animated_picture_is_up_to_date() {
    let made = crossing::picture().expect("every position has an equilibrium");
    let path = repository().join("docs/pictures/crossing.svg");
    if std::env::var_os("UPDATE_EXPECTED").is_some() {
        std::fs::write(&path, &made).expect("the picture can be written");
    }
    assert!(
        read("docs/pictures/crossing.svg") == made,
        "docs/pictures/crossing.svg is another one"
    );
    assert!(made.len() < 500_000, "small enough for a README: {} bytes", made.len());
}

/// Reads every model in the documents; an incomplete model is completed first.
#[test]
fn models_in_documents_are_valid() {
    let mut count = 0;
    for path in ["README.md", "docs/file-format.md"] {
        for block in blocks(&read(path), "toml") {
            let mut model = block.clone();
            for (table, text) in [
                ("[beam]", "[beam]\nlength = \"12 m\"\nEI = \"1 GN m^2\"\n"),
                ("[foundation]", "[foundation]\nk = \"40 MN/m^2\"\nmu = \"9 MN\"\n"),
                ("[[load]]", "[[load]]\npoint = \"600 kN\"\nat = \"1 m\"\n"),
            ] {
                if !block.contains(table) {
                    model.push_str(text);
                }
            }
            count += 1;
            if let Err(faults) = groundbeam_file::parse(&model) {
                panic!("{path}:\n{model}\n{}", faults.render(path, &model, false));
            }
        }
    }
    assert!(count >= 6, "models in the documents");
}

/// The names in the table of notation exist: types and fields in the library, keys in files and results.
#[test]
fn every_name_in_the_notation_exists() {
    let text = |folder: &str| -> String {
        sources(folder).iter().map(|source| source.code().to_owned()).collect()
    };
    let core = text("crates/groundbeam/src");
    let files = text("crates/groundbeam-file/src");
    let results = text("crates/groundbeam-report/src/json")
        + &read("crates/groundbeam-report/src/json.rs")
        + &text("crates/groundbeam/src/solution");
    let notation = read("docs/notation.md");
    let mut part = "";
    let mut count = 0;
    for line in notation.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            part = heading;
        }
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, _, _, rust, key, ..] = cells[..] else { continue };
        if !rust.starts_with('`') || part.starts_with("In ") {
            continue;
        }
        count += 1;
        let (rust, key) = (rust.trim_matches('`'), key.trim_matches('`'));
        let (owner, name) = rust.split_once("::").unwrap_or(("", rust));
        let owned = owner.is_empty()
            || [format!("struct {owner} "), format!("enum {owner} ")]
                .iter()
                .any(|o| core.contains(o));
        let named = [
            format!("{name}:"),
            format!("{name} {{"),
            format!("fn {name}("),
            format!("struct {name} "),
        ];
        assert!(owned && named.iter().any(|n| core.contains(n)), "the library has no {rust}");
        let (spelled, place) =
            if part == "Given" { (&files, "a file") } else { (&results, "a result") };
        let keys = [format!("\"{key}\""), format!("{key}:")];
        assert!(keys.iter().any(|k| spelled.contains(k)), "{place} has no key {key}");
    }
    assert!(count >= 25, "{count} lines of notation were read");
}

#[test]
fn the_documents_describe_every_field() {
    let (notation, derivatives) = (read("docs/notation.md"), read("docs/derivatives.md"));
    for field in Field::ALL {
        let name = field.name();
        let row = notation.lines().find(|line| line.contains(&format!("`Fields::{name}`")));
        let cells: Vec<&str> = row.unwrap_or(name).split('|').map(str::trim).collect();
        let [_, symbol, _, _, key, unit, sign, ..] = cells[..] else { panic!("{row:?}") };
        assert_eq!((symbol, key.trim_matches('`'), unit), (field.symbol(), name, field.unit()));
        assert!(sign.ends_with(field.positive()), "{name}: {sign}");
    }
    let names = Field::ALL.map(|field| format!("`{}`", field.name())).join(", ");
    let row = format!("| `Value(field, x, side)` | {names}, with positions |");
    assert!(derivatives.contains(&row), "docs/derivatives.md has no row {row}");
}

#[test]
fn links_between_documents_have_existing_targets() {
    let mut faults = Vec::new();
    let docs = std::fs::read_dir(repository().join("docs")).expect("docs");
    let docs =
        docs.map(|entry| format!("docs/{}", entry.expect("entry").file_name().to_string_lossy()));
    let top = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "bench/README.md",
        "cases/README.md",
        "reference/README.md",
        "verification/frozen/README.md",
    ];
    for path in docs.filter(|path| path.ends_with(".md")).chain(top.map(str::to_owned)) {
        let folder = repository().join(&path).parent().expect("a folder").to_path_buf();
        let text = read(&path);
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = link.split('#').next().unwrap_or_default();
            if !(file.is_empty() || link.starts_with("http") || folder.join(file).exists()) {
                faults.push(format!("{path}: {link}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The path of every test file that a text names.
fn named_tests(text: &str) -> Vec<&str> {
    let is_test = |code: &&str| {
        let (folder, file) = code.split_once("/tests/").unwrap_or_default();
        let is_code = file.ends_with(".rs") || file.ends_with(".py");
        is_code
            && !code.contains(' ')
            && (folder == "verification" || folder.starts_with("crates/"))
    };
    text.split('`').filter(is_test).collect()
}

/// A page of `docs/` that names a test file stands in the first lines of this file, and the other way round.
#[test]
fn documents_and_the_tests_of_their_claims_name_each_other() {
    let mut claims = BTreeSet::new();
    for page in files(&repository().join("docs"), "md") {
        let page = format!("docs/{}", page.file_name().expect("a name").to_string_lossy());
        for test in named_tests(&read(&page)) {
            assert!(repository().join(test).exists(), "{page} names {test}, which is missing");
            claims.insert((page.clone(), test.to_owned()));
        }
    }
    let mut heads = BTreeSet::new();
    let folders = crates().into_values().map(|(folder, _)| repository().join(folder).join("tests"));
    for folder in folders.filter(|folder| folder.exists()) {
        for path in [files(&folder, "rs"), files(&folder, "py")].concat() {
            let test = path.strip_prefix(repository()).expect("a file of the repository");
            let test = test.to_string_lossy().replace('\\', "/");
            let text = read(&test);
            let claims = text.lines().find_map(|line| {
                line.trim_start_matches("//! ").strip_prefix("Claims: ")?.strip_suffix('.')
            });
            let pages = claims.into_iter().flat_map(|pages| pages.split(", "));
            heads.extend(pages.map(|page| (page.trim_matches('`').to_owned(), test.clone())));
        }
    }
    let [one, other] = [claims.difference(&heads), heads.difference(&claims)].map(Vec::from_iter);
    assert!(one.is_empty(), "the first lines of these tests do not name the page: {one:?}");
    assert!(other.is_empty(), "these pages do not name the test: {other:?}");
    assert!(claims.len() >= 20, "{claims:?}");
}

/// Expected texts are small enough to be read when they change.
#[test]
fn expected_texts_are_short() {
    for extension in ["snap", "expected"] {
        let found = ["crates", "cases"].map(|folder| files(&repository().join(folder), extension));
        for path in found.concat() {
            let length = std::fs::metadata(&path).expect("a file").len();
            assert!(length <= 12_000, "{} has {length} bytes", path.display());
        }
    }
}

/// The fenced blocks of one language.
fn blocks(text: &str, language: &str) -> Vec<String> {
    let fence = format!("```{language}\n");
    let parts = text.split(&fence).skip(1);
    parts.map(|part| part.split("```").next().unwrap_or_default().to_owned()).collect()
}
