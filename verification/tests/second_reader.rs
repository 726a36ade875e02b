//! Checks that the second reader of model files gives the same model as the first reader, or refuses the
//! file.

use groundbeam::{Model, Outcome, solve};
use groundbeam_file::{
    Document, combination_sets, parse_beside, rail_sections, rolled_sections, write_toml,
};
use groundbeam_proof::{GapCorner, Reason, Scalar, Wide, prove, read_model};
use groundbeam_testing::repository;
use groundbeam_verification::hostile::{model, mutated, texts};
use groundbeam_verification::second::Comparison;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Tolerance in units of the last place: the first reader computes sections, products and fractions in doubles, with a
/// rounding in each step.
const ALLOWED: f64 = 24.0;

/// The model files of the repository that the second reader refuses, with the key that it does not support.
const REFUSED: &[(&str, &str)] = &[
    ("cases/footings/strip-footing-on-layered-soil.toml", "modified-vlasov"),
    ("cases/ground/survey-of-an-even-slope.toml", "gap_survey"),
    ("cases/ground/trough-under-a-heavy-pipe.toml", "gap_trough"),
    ("cases/textbook/wheel-on-an-endless-rail.toml", "train"),
    ("docs/train.toml", "train"),
];

/// Every valid model file, by its path in the repository.
fn files() -> Vec<(String, PathBuf)> {
    let faulty = repository().join("cases/errors");
    let found = ["cases", "docs"]
        .map(|folder| groundbeam_testing::files(&repository().join(folder), "toml"));
    let valid = found.concat().into_iter().filter(|path| !path.starts_with(&faulty));
    let named = valid.map(|path| {
        let name = path.strip_prefix(repository()).unwrap_or(&path);
        (name.display().to_string().replace('\\', "/"), path)
    });
    named.collect()
}

/// Compares every model of a file; returns the number of compared numbers, and the largest difference.
fn compare(name: &str, text: &str, document: &Document) -> Result<(usize, f64), Reason> {
    let mut models = vec![(None, document.model.clone())];
    for combination in document.combinations() {
        models.push((Some(combination.name), combination.model));
    }
    let (mut numbers, mut largest) = (0, 0.0_f64);
    for (combination, first) in models {
        let second = match read_model::<Wide>(text, combination.as_deref()) {
            Ok(second) => second,
            // The factors of a set can carry a load out of the range; the first reader checks loads as written.
            Err(error) if matches!(error.reason, Reason::OutOfRange(_)) && !is_in_range(&first) => {
                continue;
            }
            Err(error) => return Err(error.reason),
        };
        let comparison = Comparison::of(&first, &second, ALLOWED);
        let faults = comparison.faults.join("\n");
        assert!(faults.is_empty(), "{name}, {combination:?}:\n{faults}\n{text}");
        numbers += comparison.numbers;
        largest = largest.max(comparison.largest);
    }
    Ok((numbers, largest))
}

/// Whether every load is 0 or has a magnitude between 1e-60 and 1e60.
fn is_in_range(model: &Model) -> bool {
    let sizes = model.loads.iter().flat_map(|load| load.extent().sizes());
    sizes.into_iter().all(|size| size == 0.0 || (1e-60..=1e60).contains(&size.abs()))
}

#[test]
fn both_readers_agree_on_every_model_file_but_the_listed_ones() {
    let mut refused = Vec::new();
    let (mut read, mut numbers, mut largest) = (0, 0, (0.0, String::new()));
    for (name, path) in files() {
        let text = std::fs::read_to_string(&path).expect("a text");
        let folder = path.parent().unwrap_or(Path::new("."));
        // Study files are skipped.
        let Ok(document) = parse_beside(&text, folder) else { continue };
        match compare(&name, &text, &document) {
            Ok((count, most)) => {
                (read, numbers) = (read + 1, numbers + count);
                if most > largest.0 {
                    largest = (most, name);
                }
            }
            Err(Reason::NotRead(key)) => refused.push((name, key)),
            Err(reason) => panic!("{name}: {reason:?}"),
        }
    }
    println!("{read} files read alike, {numbers} numbers, largest difference {largest:?}");
    let refused: Vec<(&str, &str)> =
        refused.iter().map(|(name, key)| (name.as_str(), *key)).collect();
    assert_eq!(refused, REFUSED);
    let page = include_str!("../../docs/file-format.md");
    let (_, section) = page.split_once("## The second reader").expect("its section");
    for (_, key) in REFUSED {
        assert!(section.contains(key), "docs/file-format.md does not list {key}");
    }
    assert!(read >= 117, "{read}");
}

/// A proof of an answer for the solver's model, in doubles, also holds for the decimals of the file.
#[test]
fn answers_are_proven_for_the_decimals_of_the_file() {
    let mut proven = 0;
    let mut largest = (0.0, String::new());
    for (name, path) in files() {
        let text = std::fs::read_to_string(&path).expect("a text");
        if read_model::<Wide>(&text, None).is_err() {
            continue;
        }
        let document = groundbeam_file::parse(&text).expect("a model");
        let combinations = document.combinations().into_iter().take(3);
        let combinations = combinations.map(|one| (Some(one.name), one.model));
        for (combination, model) in [(None, document.model.clone())].into_iter().chain(combinations)
        {
            let Ok(Outcome::Equilibrium(solution)) = solve(&model) else { continue };
            let (doubles, answer) = solution.claim::<Wide>();
            let decimals = match read_model::<Wide>(&text, combination.as_deref()) {
                Ok(decimals) => decimals,
                Err(error) if matches!(error.reason, Reason::NotRead(_)) => continue,
                Err(error) => panic!("{name}: {error}"),
            };
            match (prove(&doubles, &answer), prove(&decimals, &answer)) {
                (Ok(_), Ok(proof)) => {
                    proven += 1;
                    let gap = proof.energy / proof.strain_energy;
                    if gap > largest.0 {
                        largest = (gap, format!("{name} {combination:?}"));
                    }
                }
                (doubles, decimals) => {
                    let told = [doubles, decimals].map(|found| found.map_err(|e| e.to_string()));
                    assert!(told[0] == told[1] && told[0].is_err(), "{name}: {told:?}");
                }
            }
        }
    }
    println!("{proven} proven, largest relative gap {largest:?}");
    assert!(proven >= 80 && largest.0 < 2e-19, "{proven} {largest:?}");
}

/// The blocks of the documents, after their completion for the first reader.
#[test]
fn both_readers_agree_on_the_models_in_the_documents() {
    let mut read = 0;
    for entry in std::fs::read_dir(repository().join("docs")).into_iter().flatten().flatten() {
        if entry.path().extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        let page = std::fs::read_to_string(entry.path()).expect("a text");
        for block in page.split("```toml\n").skip(1) {
            let mut text = block.split("```").next().unwrap_or_default().to_owned();
            for (table, added) in [
                ("[beam]", "[beam]\nlength = \"12 m\"\nEI = \"1e6 kN m^2\"\n"),
                ("[foundation]", "[foundation]\nk = \"40 MN/m^2\"\nmu = \"1 MN\"\n"),
            ] {
                if !text.contains(table) {
                    text = format!("{text}\n{added}");
                }
            }
            let Ok(document) = groundbeam_file::parse(&text) else { continue };
            match compare("a block", &text, &document) {
                Ok(_) => read += 1,
                Err(reason) => assert!(matches!(reason, Reason::NotRead(_)), "{reason:?}\n{text}"),
            }
        }
    }
    assert!(read >= 12, "{read}");
}

/// Fillets of an I, constant and along a haunch; permanent cases of one source, which only EQU takes apart.
#[test]
fn both_readers_agree_on_fillets_and_sources() {
    let section = "section = { shape = 'I', width = '0.3 m', height = ['0.6 m', '0.5 m'], flange = '30 mm', web = '20 mm', \
                   fillet = '27 mm' }";
    let case = |name: &str, more: &str| {
        format!(
            "[[load]]\npoint = '100 kN'\nat = '3 m'\ncase = '{name}'\n[[case]]\nname = '{name}'\n{more}\n"
        )
    };
    let text = format!(
        "[beam]\nlength = '6 m'\nE = '210 GPa'\n{section}\n[foundation]\nk = '40 MN/m^2'\n{}{}{}{}\
         [[combination]]\nset = 'EN 1990 6.10'\n[[combination]]\nset = 'EN 1990 EQU'\n\
         [[combination]]\nset = 'EN 1990 6.10a/b'\n",
        case("G1", "action = 'permanent'\nsource = 'own weight'"),
        case("Q", "action = 'imposed B'"),
        case("G2", "action = 'permanent'\nsource = ' own weight'"),
        case("G3", "action = 'permanent'\nsource = 'soil'"),
    );
    let document = groundbeam_file::parse(&text).expect("a model");
    let (numbers, largest) = compare("fillets and sources", &text, &document).expect("read");
    assert!(numbers > 100 && document.combinations().len() > 30, "{numbers} {largest}");
}

/// Every rolled section and every rail, as a beam that shears and has a self-weight.
#[test]
fn both_readers_agree_on_every_rolled_section() {
    let (mut numbers, mut largest) = (0, 0.0_f64);
    let sections = rolled_sections().iter().map(|section| ("name", section));
    let rails = rail_sections().iter().map(|rail| ("rail", rail));
    for (key, section) in sections.chain(rails) {
        let shear = if section.shear_area.is_some() { "nu = 0.3" } else { "" };
        let curl = if section.height.is_some() { "" } else { "depth = '172 mm'" };
        let text = format!(
            "[beam]\nlength = '6 m'\nmaterial = 'S355'\nsection = {{ {key} = '{}' }}\nunit_weight = 'material'\n{shear}\n\
             [foundation]\nk = '40 MN/m^2'\n[[load]]\ntemperature_difference = '10 K'\n{curl}\n",
            section.name
        );
        let document = groundbeam_file::parse(&text).expect("a model");
        let (count, most) = compare(&section.name, &text, &document).expect("read");
        (numbers, largest) = (numbers + count, largest.max(most));
    }
    println!("{numbers} numbers, largest difference {largest}");
    assert!(numbers > 10_000, "{numbers}");
}

/// A model with a rolled section, a material and a set of combinations.
fn rolled(section: &str) -> String {
    format!(
        "[beam]\nlength = '6 m'\nmaterial = 'S355'\nsection = {{ {section} }}\nunit_weight = 'material'\n\
         weight_case = 'G'\n[foundation]\nk = '40 MN/m^2'\n[[load]]\npoint = '9 kN'\nat = '1 m'\ncase = 'Q'\n\
         [[case]]\nname = 'G'\naction = 'permanent'\n[[case]]\nname = 'Q'\naction = 'wind'\n\
         [[combination]]\nset = 'EN 1990 EQU with strength'\n"
    )
}

/// Every set of combinations under all of its names, with random cases of all of its actions.
#[test]
fn both_readers_agree_on_every_set_of_combinations() {
    let mut random = ChaCha8Rng::seed_from_u64(19);
    let known: Vec<&str> = combination_sets().iter().map(|set| set.name).collect();
    let (mut tried, mut refused, mut made) = (BTreeSet::new(), 0, 0);
    for path in groundbeam_testing::files(&repository().join("crates/groundbeam-file/sets"), "toml")
    {
        let data = std::fs::read_to_string(path).expect("a text");
        let [actions, sets] = ["[[action]]", "[[set]]"].map(|kind| words(&data, kind));
        for (i, set) in sets.iter().cycle().take(40 * sets.len()).enumerate() {
            let mut text = String::from(
                "[beam]\nlength = '6 m'\nEI = '1e6 kN m^2'\n[foundation]\nk = '40 MN/m^2'\n",
            );
            // In turn, every action is one of the cases.
            for case in 0..random.random_range(1..5) {
                let action = if case == 0 { i } else { random.random_range(0..actions.len()) };
                let action = &actions[action % actions.len()];
                let bound = |key: &str, drawn: u32| match drawn {
                    0 | 1 => format!("{key} = '{drawn}'\n"),
                    _ => String::new(),
                };
                let group = bound("group", random.random_range(0..5));
                let source = bound("source", random.random_range(0..5));
                text += &format!(
                    "[[load]]\npoint = '{} kN'\nat = '3 m'\ncase = '{case}'\n[[case]]\nname = '{case}'\n\
                     action = '{action}'\n{group}{source}",
                    100 + 7 * case
                );
            }
            if random.random_bool(0.3) {
                text += "[[load]]\npoint = '50 kN'\nat = '2 m'\n";
            }
            text += &format!("[[combination]]\nset = '{set}'\n");
            match groundbeam_file::parse(&text) {
                Ok(document) => {
                    made += document.combinations().len();
                    tried.insert(set.clone());
                    compare(set, &text, &document).unwrap_or_else(|why| panic!("{why:?}\n{text}"));
                }
                Err(found) => {
                    refused += 1;
                    let second = read_model::<Wide>(&text, Some("none")).map_err(|e| e.reason);
                    assert!(
                        matches!(second, Err(Reason::Value(_))),
                        "{found:?} {second:?}\n{text}"
                    );
                }
            }
        }
    }
    println!("{} sets, {made} combinations, {refused} refused", tried.len());
    assert!(known.iter().all(|set| tried.contains(*set)), "{tried:?}");
    assert!(made > 10_000 && refused > 5, "{made} {refused}");
}

/// Ground from soil data by every method that does not need the solution, with bands, under random beams.
#[test]
fn both_readers_agree_on_soil_and_bands() {
    let (mut grounds, mut largest) = (0, 0.0_f64);
    for number in 0..700 {
        let text = soil(number);
        let document =
            groundbeam_file::parse(&text).unwrap_or_else(|found| panic!("{found:?}\n{text}"));
        let (_, most) = compare(&number.to_string(), &text, &document).expect("read");
        (grounds, largest) = (grounds + document.combinations().len(), largest.max(most));
    }
    println!("{grounds} grounds, largest difference {largest}");
    assert!(grounds > 2000, "{grounds}");
}

/// A random model on ground from soil data, with a band.
fn soil(number: usize) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(number as u64);
    let mut size = |from: f64, to: f64| from * (to / from).powf(random.random_range(0.0..1.0));
    let mut elastic = || format!("E = '{} MPa'\nnu = {}\n", size(0.5, 500.0), size(0.01, 0.49));
    let layer = "[[foundation.soil.layer]]\n";
    let layers: String = (0..1 + number % 4).map(|_| layer.to_owned() + &elastic()).collect();
    let elastic = elastic();
    let layers = layers.replace(layer, &format!("{layer}thickness = '{} m'\n", size(0.1, 20.0)));
    let plate = "plate_modulus = '40 MN/m^3'\nplate_width = '0.3 m'\n".to_owned();
    let layered = format!("gamma = {}\n{layers}", size(0.01, 20.0));
    let (method, data) = [
        ("vlasov", &layered),
        ("vlasov", &layered),
        ("vesic", &elastic),
        ("biot", &elastic),
        ("meyerhof-baike", &elastic),
        ("selvadurai", &elastic),
        ("terzaghi-clay", &plate),
        ("terzaghi-sand", &plate),
    ][number % 8];
    let shear =
        if method == "vlasov" && number.is_multiple_of(3) { "mu = [0.25, 3]\n" } else { "" };
    format!(
        "[beam]\nlength = '{} m'\nEI = '{} MN m^2'\n[[load]]\npoint = '1 MN'\nat = '0.01 m'\ncase = 'a'\n\
         [[combination]]\nname = 'a'\nfactors = {{ a = 1.3 }}\n[foundation]\nwidth = '{} m'\n\
         [foundation.band]\nk = [0.{}, {}]\n{shear}[foundation.soil]\nmethod = '{method}'\n{data}",
        size(0.3, 300.0),
        size(0.1, 1e5),
        size(0.2, 5.0),
        1 + number % 9,
        1 + number % 5,
    )
}

/// The names under headings of one kind in a data file of sets.
fn words(data: &str, heading: &str) -> Vec<String> {
    let mut names = Vec::new();
    for part in data.split(heading).skip(1) {
        let part = part.split("\n\n[").next().unwrap_or_default();
        let lines =
            part.lines().filter(|line| ["name", "also"].iter().any(|k| line.starts_with(k)));
        names.extend(lines.flat_map(|line| line.split('"').skip(1).step_by(2)).map(str::to_owned));
    }
    names
}

/// Models with random numbers, as the product writes them.
#[test]
fn both_readers_agree_on_random_models() {
    let mut read = 0;
    for number in 0..2000 {
        let first = model(number);
        for units in [groundbeam_file::UnitSystem::Si, groundbeam_file::UnitSystem::Plain] {
            let text = write_toml(&first, None, units);
            let Ok(document) = groundbeam_file::parse(&text) else { continue };
            match compare(&number.to_string(), &text, &document) {
                Ok(_) => read += 1,
                Err(reason) => panic!("{number}: {reason:?}\n{text}"),
            }
        }
    }
    println!("{read} read alike");
    assert!(read > 2000);
}

/// Files with random changes: if both readers accept a file, they give the same model. The second reader distinguishes
/// corners of the gap whose positions are the same double.
#[test]
fn both_readers_agree_on_changed_files() {
    let mut texts = texts();
    texts.extend((0..16).map(soil));
    texts.extend(["name = 'IPE 300'", "name = 'SHS 100x5'", "rail = '60E1'"].map(rolled));
    let mut alike = 0;
    let mut faults = Vec::new();
    for number in 0..60_000_u64 {
        let text = mutated(&texts[number as usize % texts.len()], number);
        match (groundbeam_file::parse(&text), read_model::<Wide>(&text, None)) {
            (Ok(document), Ok(_)) => match compare(&number.to_string(), &text, &document) {
                Ok(_) => alike += 1,
                Err(Reason::NotRead(_)) => {}
                Err(reason) => faults.push(format!("{number}: {reason:?}")),
            },
            (Ok(_), Err(error)) if !matches!(error.reason, Reason::NotRead(_)) => {
                faults.push(format!("{number}: only the first reads it: {error}"));
            }
            (Err(found), Ok(second)) => {
                let equals = |pair: &[GapCorner<Wide>]| pair[0].at.middle() == pair[1].at.middle();
                let meet = second.gap.windows(2).any(equals);
                let of_gap = |code: &str| meet && code == "GB501";
                for diagnostic in
                    found.iter().filter(|d| !is_left_out(&text, d.line, d.code) && !of_gap(d.code))
                {
                    let said = &diagnostic.message;
                    faults.push(format!("{number}: only the second reads it: {said}"));
                }
            }
            (Ok(_) | Err(_), Err(_)) => {}
        }
    }
    println!("{alike} read alike");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(alike > 9000);
}

/// Whether the second reader ignores a line: titles, checks, and combinations that are not requested. It also accepts
/// two positions of supports or hinges that are equal to rounding.
fn is_left_out(text: &str, line: usize, code: &str) -> bool {
    let up_to: Vec<&str> = text.lines().take(line).map(str::trim).collect();
    let heading = up_to.iter().rev().find(|line| line.starts_with('[')).copied().unwrap_or("");
    let last = up_to.last().copied().unwrap_or("");
    let is_key = ["title", "case", "combination", "checks"].iter().any(|key| last.starts_with(key));
    let table = heading.trim_start_matches('[');
    (is_key && (heading.is_empty() || last.starts_with("title")))
        || ["checks]", "checks.limit_states]", "case]", "combination]"]
            .iter()
            .any(|name| table.starts_with(name))
        || ["GB403", "GB404", "GB406"].contains(&code)
}
