//! The second reader of model files understands them as the first one does, or refuses them.

use groundbeam_file::{Document, parse_beside, write_toml};
use groundbeam_proof::{Reason, Wide, read_model};
use groundbeam_verification::documents::repository;
use groundbeam_verification::hostile::{model, mutated, texts};
use groundbeam_verification::second::Comparison;
use std::path::{Path, PathBuf};

/// Units of the last place by which numbers may differ: the first reader computes sections, products and shares in
/// doubles, each step of which rounds.
const ALLOWED: f64 = 24.0;

/// The model files of the repository that the second reader refuses, with the key for which it does.
const REFUSED: &[(&str, &str)] = &[];

/// Every model file that is right, by its name from the repository.
fn files() -> Vec<(String, PathBuf)> {
    let mut files = Vec::new();
    let mut folders = vec![repository().join("cases"), repository().join("docs")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() && !path.ends_with("cases/errors") {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "toml") {
                let name = path.strip_prefix(repository()).unwrap_or(&path);
                files.push((name.display().to_string().replace('\\', "/"), path));
            }
        }
    }
    files.sort();
    files
}

/// Compares every model of a file; returns how many numbers were compared, and the largest difference.
fn compare(name: &str, text: &str, document: &Document) -> Result<(usize, f64), Reason> {
    let mut models = vec![(None, document.model.clone())];
    for combination in document.combinations() {
        models.push((Some(combination.name), combination.model));
    }
    let (mut numbers, mut largest) = (0, 0.0_f64);
    for (combination, first) in models {
        let second = read_model::<Wide>(text, combination.as_deref()).map_err(|e| e.reason)?;
        let comparison = Comparison::of(&first, &second, ALLOWED);
        let faults = comparison.faults.join("\n");
        assert!(faults.is_empty(), "{name}, {combination:?}:\n{faults}\n{text}");
        numbers += comparison.numbers;
        largest = largest.max(comparison.largest);
    }
    Ok((numbers, largest))
}

#[test]
fn every_model_file_is_read_alike_or_refused() {
    let mut refused = Vec::new();
    let (mut read, mut numbers, mut largest) = (0, 0, (0.0, String::new()));
    for (name, path) in files() {
        let text = std::fs::read_to_string(&path).expect("a text");
        let folder = path.parent().unwrap_or(Path::new("."));
        // Studies are no models.
        let Ok(document) = parse_beside(&text, folder) else { continue };
        match compare(&name, &text, &document) {
            Ok((count, most)) => {
                (read, numbers) = (read + 1, numbers + count);
                if most > largest.0 {
                    largest = (most, name);
                }
            }
            Err(reason) => refused.push((name, format!("{reason:?}"))),
        }
    }
    println!("{read} files read alike, {numbers} numbers, largest difference {largest:?}");
    let refused: Vec<(&str, &str)> =
        refused.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
    assert_eq!(refused, REFUSED);
    assert!(read > 80);
}

/// The blocks of the documents, which the first reader reads when what they leave out is added.
#[test]
fn the_blocks_of_the_documents_are_read_alike() {
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

/// Models of random numbers, as the product writes them.
#[test]
fn random_models_are_read_alike() {
    let mut read = 0;
    for number in 0..2000 {
        let first = model(number);
        for units in [groundbeam_file::UnitSystem::Si, groundbeam_file::UnitSystem::Plain] {
            let text = write_toml(&first, None, units);
            let Ok(document) = groundbeam_file::parse(&text) else { continue };
            match compare(&number.to_string(), &text, &document) {
                Ok(_) => read += 1,
                Err(reason) => println!("{number}: {reason:?}"),
            }
        }
    }
    println!("{read} read alike");
    assert!(read > 500);
}

/// Files with random changes: what both readers accept they understand alike.
#[test]
fn changed_files_are_read_alike() {
    let texts = texts();
    let (mut alike, mut only_first, mut only_second, mut neither) = (0, 0, 0, 0);
    for number in 0..20_000_u64 {
        let text = mutated(&texts[number as usize % texts.len()], number);
        match (groundbeam_file::parse(&text), read_model::<Wide>(&text, None)) {
            (Ok(document), Ok(_)) => match compare(&number.to_string(), &text, &document) {
                Ok(_) => alike += 1,
                Err(reason) => panic!("{number}: {reason:?}\n{text}"),
            },
            (Ok(_), Err(error)) => {
                only_first += 1;
                if !matches!(error.reason, Reason::NotRead(_)) {
                    println!("{number}: only the first reads it: {error}");
                }
            }
            (Err(found), Ok(_)) => {
                only_second += 1;
                let codes: Vec<_> = found.iter().map(|d| d.code).collect();
                println!("{number}: only the second reads it: {codes:?}");
            }
            (Err(_), Err(_)) => neither += 1,
        }
    }
    println!(
        "alike {alike}, only first {only_first}, only second {only_second}, neither {neither}"
    );
}
