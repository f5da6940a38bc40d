//! What Coq has checked: the hashes of the files on which it agreed.

use sha2::{Digest as _, Sha256};

use super::Certificate;

/// Lines `sha256  file`, as `sha256sum` prints them; `proofs/check` writes it when all is well.
const MANIFEST: &str = include_str!("../../../proofs/checked.txt");

/// The checker and its proof.
const PROGRAM: [(&str, &str); 4] = [
    ("program/Script.v", include_str!("../../../proofs/coq/program/Script.v")),
    ("program/Polynomial.v", include_str!("../../../proofs/coq/program/Polynomial.v")),
    ("program/Fraction.v", include_str!("../../../proofs/coq/program/Fraction.v")),
    ("program/Checker.v", include_str!("../../../proofs/coq/program/Checker.v")),
];

/// The SHA-256 of a text, in hexadecimal digits.
fn hash(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether the manifest has this file with this text.
fn is_checked(manifest: &str, file: &str, text: &str) -> bool {
    let hash = hash(text);
    manifest.lines().any(|line| line.split_once("  ") == Some((&hash, file)))
}

impl Certificate {
    /// Its SHA-256 as a Coq file.
    pub fn hash(&self) -> String {
        hash(&self.coq())
    }

    /// Whether Coq has checked exactly this file, and the checker that it uses: their hashes stand
    /// in `proofs/checked.txt`.
    pub fn is_checked(&self) -> bool {
        self.is_checked_by(MANIFEST)
    }

    /// The same for another manifest.
    pub fn is_checked_by(&self, manifest: &str) -> bool {
        let file = format!("recorded/{}", self.file_name());
        PROGRAM.iter().all(|(file, text)| is_checked(manifest, file, text))
            && is_checked(manifest, &file, &self.coq())
    }
}
