//! Collects all model files of the repository: those in `cases/` and `docs/`, and those printed in documents.

use std::fs;
use std::path::{Path, PathBuf};

/// A model file.
#[derive(Debug, Clone)]
pub struct Sample {
    /// Folder of the files that it names.
    pub folder: PathBuf,
    pub text: String,
}

/// All of them, by name.
pub fn samples() -> Vec<Sample> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = Vec::new();
    for folder in ["cases", "docs"] {
        collect(&root.join(folder), &mut found);
    }
    assert!(found.len() > 200, "{}", found.len());
    found
}

fn collect(folder: &Path, found: &mut Vec<Sample>) {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            collect(&path, found);
            continue;
        }
        let folder = folder.to_owned();
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("toml") => {
                let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
                found.push(Sample { folder, text });
            }
            Some("md") => {
                let document = fs::read_to_string(&path).unwrap();
                for block in document.split("```toml\n").skip(1) {
                    let text = block.split("```").next().unwrap().to_owned();
                    found.push(Sample { folder: folder.clone(), text });
                }
            }
            _ => {}
        }
    }
}
