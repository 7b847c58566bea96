//! Texts that tests compare with files of the project.

use std::path::Path;

/// Compares a text with its golden file. The file is written only when that is asked for with `UPDATE_GOLDENS=1`; a run that
/// writes fails, so that somebody looks at what it wrote.
pub(crate) fn check_golden(golden: &Path, text: &str) {
    let known = std::fs::read_to_string(golden).ok();
    if known.as_deref() == Some(text) {
        return;
    }
    if std::env::var_os("UPDATE_GOLDENS").is_some() {
        std::fs::write(golden, text).unwrap();
        panic!("wrote {}: look at it and run again", golden.display());
    }
    let known = known.unwrap_or_default();
    assert_eq!(text, known, "{} is missing or differs; renew with UPDATE_GOLDENS=1", golden.display());
}
