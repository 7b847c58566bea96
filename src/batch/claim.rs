//! Checks the claims of records: other programs may write into the output folder, so a record may only name files that
//! this program would have written itself. A path that passes is read, replaced and deleted.

use super::file_name::{is_name_of, is_safe_name};
use super::record::{FileRecord, LevelRecord};
use crate::document::{Fault, FaultSeverity, PathStep, Source};
use crate::output::{INDEX_FOLDER, INDEX_NAME, OUTPUTS};

/// Digits of a SHA-256.
const HASH_DIGITS: usize = 64;

/// How the folders of shared files begin.
const SHARED_PREFIX: &str = "shared-";

/// A value of a record that this program has not written: where in the record, and the fact.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct FalseClaim {
    pub(super) path: Vec<PathStep>,
    pub(super) message: String,
}

impl FalseClaim {
    /// A record that is none.
    pub(super) fn unreadable(error: &serde_json::Error) -> Self {
        Self { path: Vec::new(), message: format!("is no record of a level: {error}") }
    }

    /// The claim in front of people: where in a text of records it stands. The record is left out, so the text can be used.
    pub(super) fn fault(&self, source: &Source, before: &[PathStep]) -> Fault {
        let path: Vec<PathStep> = before.iter().chain(&self.path).cloned().collect();
        source.fault(&path, self.message.clone(), Some(HINT.to_owned()), FaultSeverity::Warning)
    }

    fn below(mut self, steps: &[PathStep]) -> Self {
        self.path.splice(0..0, steps.iter().cloned());
        self
    }
}

/// Advice for a false claim.
const HINT: &str = "the record is left out and nothing that it names is touched; bake again to write it anew";

/// Refuses the record of a level that names other files than those of its level, or shared ones that none can be.
pub(super) fn check_level(record: &LevelRecord) -> Result<(), FalseClaim> {
    if record.files.is_empty() {
        return Err(FalseClaim { path: vec!["files".into()], message: "names no file".to_owned() });
    }
    for (index, file) in record.files.iter().enumerate() {
        let place = ["files".into(), index.into()];
        check_file(file).map_err(|claim| claim.below(&place))?;
        if !is_file_of(&record.building, &record.level, &file.path) {
            let (building, level) = (&record.building, &record.level);
            let message = format!("{:?} is no file of level {level:?} of building {building:?}", file.path);
            return Err(FalseClaim { path: vec!["path".into()], message }.below(&place));
        }
    }
    for (index, path) in record.library.iter().enumerate() {
        check_shared_path(path).map_err(|claim| claim.below(&["library".into(), index.into()]))?;
    }
    Ok(())
}

/// Refuses the record of a shared file that none can be.
pub(super) fn check_shared(file: &FileRecord) -> Result<(), FalseClaim> {
    check_file(file)?;
    check_shared_path(&file.path).map_err(|claim| claim.below(&["path".into()]))
}

/// Refuses a file that no bake would write.
pub(super) fn check_file(file: &FileRecord) -> Result<(), FalseClaim> {
    let is_ours =
        is_index_path(&file.path) || file.path.contains('/') && file.path.split('/').all(is_safe_name);
    if !is_ours {
        let message = format!("{:?} is no path that a bake writes to", file.path);
        return Err(FalseClaim { path: vec!["path".into()], message });
    }
    let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
    if file.sha256.len() != HASH_DIGITS || !file.sha256.bytes().all(is_digit) {
        let message = format!("{:?} is no SHA-256", file.sha256);
        return Err(FalseClaim { path: vec!["sha256".into()], message });
    }
    Ok(())
}

/// Refuses the record of a file over all levels that none can be.
pub(super) fn check_index(file: &FileRecord) -> Result<(), FalseClaim> {
    if is_index_path(&file.path) {
        return check_file(file);
    }
    let message = format!("{:?} is no path of an index", file.path);
    Err(FalseClaim { path: vec!["path".into()], message })
}

/// Whether files over all levels lie there: `tileset.json`, and more of them in a folder of that name.
fn is_index_path(path: &str) -> bool {
    let name = path.strip_prefix(INDEX_FOLDER).unwrap_or(path);
    let is_whole = path == INDEX_NAME;
    is_whole || name.len() < path.len() && is_safe_name(name) && name.ends_with(".json")
}

/// Shared files lie in folders of their own, at the top or in that of a building.
fn check_shared_path(path: &str) -> Result<(), FalseClaim> {
    let folder = path.rsplit_once('/').map(|(folders, _)| folders.rsplit('/').next().unwrap_or(folders));
    let is_shared = folder.is_some_and(|folder| folder.starts_with(SHARED_PREFIX));
    if is_shared && path.split('/').all(is_safe_name) {
        return Ok(());
    }
    Err(FalseClaim { path: Vec::new(), message: format!("{path:?} is no path of a shared file") })
}

/// Whether a path is `<building>/<level>.<kind>`, as the ids are written as names.
fn is_file_of(building: &str, level: &str, path: &str) -> bool {
    let Some((folder, name)) = path.split_once('/') else { return false };
    let extensions = OUTPUTS.iter().flat_map(|output| output.extensions);
    let stems = extensions.filter_map(|kind| name.strip_suffix(kind)?.strip_suffix('.'));
    is_name_of(building, folder) && stems.into_iter().any(|stem| is_name_of(level, stem))
}

#[cfg(test)]
mod tests {
    use super::super::manifest::tests::record;
    use super::*;

    fn refusal(change: impl FnOnce(&mut LevelRecord)) -> Option<(String, String)> {
        let mut changed = record("alpha", "1");
        change(&mut changed);
        let claim = check_level(&changed).err()?;
        Some((crate::document::show_path(&claim.path), claim.message))
    }

    #[test]
    fn a_record_of_this_program_is_accepted() {
        assert_eq!(check_level(&record("alpha", "1")), Ok(()));
        let odd = ["..", "CON", "EG", "a/b", "", "ю"];
        for id in odd.into_iter().chain([&*"x".repeat(300)]) {
            let names = super::super::file_name::distinct_names(&[id, "eg"]);
            let mut found = record(id, id);
            found.files[0].path = format!("{0}/{0}.glb", names[0]);
            assert_eq!(check_level(&found), Ok(()), "{id}");
        }
    }

    #[test]
    fn records_with_foreign_paths_are_rejected_with_their_place() {
        for path in [
            "../victim",
            "/etc/passwd",
            "C:/x/1.glb",
            "alpha/../1.glb",
            "alpha\\1.glb",
            "alpha/2.glb",
            "alpha/1.yaml",
            "1.glb",
            ".roomwright/1.glb",
            "alpha/1.glb/",
            "alpha/\u{1b}[2J.glb",
            "",
        ] {
            let (place, message) = refusal(|record| record.files[0].path = path.to_owned()).unwrap();
            assert_eq!(place, "files[0].path", "{path}");
            assert!(message.contains(&format!("{path:?}")), "{message}");
        }
        let shared = |path: &str| refusal(|record| record.library = vec![path.to_owned()]);
        assert_eq!(shared("../shared-geometry/a.bin").unwrap().0, "library[0]");
        assert!(shared("documents/a.bin").is_some());
        assert_eq!(shared("shared-geometry/a.bin"), None);
        assert_eq!(shared("alpha/shared-geometry/a.bin"), None);
    }

    #[test]
    fn records_with_invalid_values_are_rejected() {
        assert_eq!(refusal(|record| record.files.clear()).unwrap().0, "files");
        let hash = refusal(|record| record.files[0].sha256 = "00".to_owned()).unwrap();
        assert_eq!(hash.0, "files[0].sha256");
    }
}
