//! Computes digests of model files, which connect results with their input.

use groundbeam_file::Document;
use sha2::{Digest, Sha256};

/// SHA-256 digest of a text, in hexadecimal digits.
pub(crate) fn digest(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The digest of a model file and its table files, as `sha256:` and 64 hexadecimal digits.
///
/// Without table files, it is the SHA-256 digest of the model file. Otherwise, it is that of a text with the digest of
/// each file on its own line: model file first, then table files in the order of the model.
pub fn model_digest(document: &Document) -> String {
    let tables = document.files.iter().map(|file| file.text.as_str());
    of_files(document.text(), tables)
}

/// The digest of a model file that refers to no table files.
pub fn digest_of_text(model: &str) -> String {
    of_files(model, [])
}

fn of_files<'t>(model: &'t str, tables: impl IntoIterator<Item = &'t str>) -> String {
    let all: Vec<String> = [model].into_iter().chain(tables).map(digest).collect();
    let whole = match &all[..] {
        [alone] => alone.clone(),
        _ => digest(&all.iter().map(|one| format!("{one}\n")).collect::<String>()),
    };
    format!("sha256:{whole}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digests_agree_with_sha256sum() {
        // This digest is the output of `printf 'abc' | sha256sum`.
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(of_files("abc", []), format!("sha256:{abc}"));
        // This digest is the output of `sha256sum model.toml table.csv | cut -c 1-64 | sha256sum`.
        let both = "eba0bd5773c46903773599d5ea8d2d34d4cc1eafe604316a0f39b79b24200b4e";
        assert_eq!(of_files("abc", ["x"]), format!("sha256:{both}"));
    }
}
