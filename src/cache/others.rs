//! Removes the cache folders of other builds of the program; each build has its own, and they would pile up.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::disk::{read_plain, remove_temporaries};

/// The beginning of the name of every folder, so that other folders below the root are not taken for one.
const PREFIX: &str = "roomwright-";

/// Folders of other states that stay: people work with a release and a build or two of their own.
const KEPT: usize = 3;

/// The name of a program's folder.
pub(super) fn folder_name(program: &str) -> String {
    format!("{PREFIX}{program}")
}

/// Removes the folders beside this one that were added to longest ago, all but a few.
pub(super) fn remove_oldest(folder: &Path) -> io::Result<()> {
    let Some(root) = folder.parent() else { return Ok(()) };
    let mut others: Vec<(SystemTime, PathBuf)> = Vec::new();
    for entry in fs::read_dir(root)? {
        let entry = entry?;
        let path = entry.path();
        // Only folders with this program's tag are deleted: other programs tag theirs by the same file.
        let is_ours = entry.file_name().to_string_lossy().starts_with(PREFIX)
            && entry.file_type()?.is_dir()
            && read_plain(&path.join(super::TAG.0), super::TAG.1.len() as u64)
                .is_ok_and(|tag| tag == super::TAG.1.as_bytes());
        if is_ours && path != folder {
            others.push((entry.metadata()?.modified()?, path));
        }
    }
    others.sort();
    let surplus = others.len().saturating_sub(KEPT);
    others[..surplus].iter().try_for_each(|(_, path)| remove(path))
}

/// Removes the folder with all that the program puts into one; with anything else in it, it stays, without a tag.
fn remove(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if entry.file_type()?.is_file() && (name.ends_with(super::ENTRY_ENDING) || name == super::TAG.0) {
            fs::remove_file(entry.path())?;
        }
    }
    remove_temporaries(folder, super::TEMPORARY_PREFIX);
    match fs::remove_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::DirectoryNotEmpty => Ok(()),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::super::Cache;
    use super::*;

    #[test]
    fn caches_of_the_oldest_builds_are_removed_first() {
        let root = tempfile::tempdir().unwrap();
        let aliens = ["roomwright-notes", "roomwright-target"].map(|name| root.path().join(name));
        aliens.iter().for_each(|alien| fs::create_dir(alien).unwrap());
        let tag = "Signature: 8a477f597d28d172789f06886806bc55\n# Made by a compiler.\n";
        fs::write(aliens[1].join(super::super::TAG.0), tag).unwrap();
        let program = |number: usize| format!("1.0.0+{number:016x}");
        let made = |number: usize| root.path().join(folder_name(&program(number)));
        for number in 0..6 {
            Cache::new(root.path(), &program(number)).get_or_make(&"key", || number);
            if number == 0 {
                fs::create_dir(made(0).join("photos")).unwrap();
            }
            let time = SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(1_000 + number as u64);
            fs::File::open(made(number)).unwrap().set_modified(time).unwrap();
        }
        let left: Vec<usize> = (0..6).filter(|&number| made(number).is_dir()).collect();
        assert_eq!(left, [0, 2, 3, 4, 5], "somebody keeps photos in the oldest");
        assert_eq!(fs::read_dir(made(0)).unwrap().count(), 1);
        assert!(aliens.iter().all(|alien| alien.is_dir()));
    }
}
