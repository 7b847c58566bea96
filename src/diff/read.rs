//! Reads the two sides: manifests, and files that differ. No other file of the stage opens any.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use super::pairs::Entry;
use crate::audit::Finding;
use crate::batch::{FileRecord, LARGEST_RECORDS, MANIFEST_NAME, catch_bug, parse_manifest};
use crate::catalog::Catalog;
use crate::disk::{file_hash, look_inside, open_inside, read_regular, stray_step};
use crate::document::Fault;
use crate::read_back::{Inventory, ReadLevel, parse_inventory, parse_level, read_bytes};
use crate::solve::judge_room;

/// One side of a comparison.
#[derive(Debug)]
pub(super) enum Side {
    /// A folder that a bake wrote.
    Folder(Folder),
    /// One level.
    File(PathBuf),
}

/// A folder with its manifest.
#[derive(Debug)]
pub(super) struct Folder {
    root: PathBuf,
    /// The levels.
    pub(super) levels: Vec<Entry>,
    /// Textures and geometry that levels share.
    pub(super) shared: Vec<FileRecord>,
    /// When the manifest was written: after the files that it lists. `None` where no file is trusted to be what was
    /// recorded.
    written: Option<SystemTime>,
}

/// The files of a level as they are now.
#[derive(Debug)]
pub(super) struct CurrentFiles {
    /// Their hashes, in the order of the record.
    pub(super) hashes: Vec<String>,
    /// Whether one of them is not what the bake wrote.
    pub(super) is_edited: bool,
}

/// A level that was read.
pub(super) struct Reading {
    /// The content.
    pub(super) inventory: Inventory,
    /// As the audit and the drawings take it; `None` where the catalogue does not suffice.
    pub(super) level: Option<ReadLevel>,
    /// The faults of parts that cannot be read.
    pub(super) faults: Vec<Fault>,
}

/// Opens a side. A thorough comparison reads every file, whatever its length and time.
///
/// # Errors
/// If there is neither a file nor a folder with a manifest.
pub(super) fn open(path: &Path, is_thorough: bool) -> Result<Side, Fault> {
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => open_folder(path, is_thorough).map(Side::Folder),
        Ok(_) => Ok(Side::File(path.to_owned())),
        Err(error) => Err(Fault::of_file(path, format!("cannot be read: {error}"))
            .with_hint("name a folder that `roomwright bake` wrote, or a .glb or .gltf file")),
    }
}

fn open_folder(root: &Path, is_thorough: bool) -> Result<Folder, Fault> {
    let path = root.join(MANIFEST_NAME);
    let hint =
        "`roomwright bake` writes it when it is done; `roomwright merge` joins what several machines baked";
    let fault = |message: String| Fault::of_file(&path, message).with_hint(hint);
    let text =
        read_regular(&path, LARGEST_RECORDS).map_err(|error| fault(format!("cannot be read: {error}")))?;
    let manifest = parse_manifest(&text).map_err(|message| fault(format!("is no manifest: {message}")))?;
    let levels = manifest.levels.iter().map(|level| serde_json::from_str::<Entry>(level.get()));
    let levels = levels.collect::<Result<Vec<_>, _>>();
    let levels = levels.map_err(|error| fault(format!("holds a level that cannot be read: {error}")))?;
    let written = || fs::metadata(&path).and_then(|found| found.modified()).ok();
    let written = if is_thorough { None } else { written() };
    Ok(Folder { root: root.to_owned(), levels, shared: manifest.library, written })
}

impl Folder {
    /// The path of the file to open for a level.
    ///
    /// # Errors
    /// If its record names none, or one outside the folder.
    pub(super) fn main_file(&self, entry: &Entry) -> Result<PathBuf, Fault> {
        let file = entry.files.first().ok_or_else(|| {
            let names = format!("{}/{}", entry.building, entry.level);
            Fault::of_file(&self.root.join(MANIFEST_NAME), format!("names no file of level {names}"))
        })?;
        self.inside(file, |path| look_inside(&self.root, path))?;
        Ok(self.root.join(&file.path))
    }

    /// The answer of `look` for a file that lies in the folder, with no link on the way.
    fn inside<T>(
        &self,
        file: &FileRecord,
        look: impl FnOnce(&str) -> io::Result<Option<T>>,
    ) -> Result<T, Fault> {
        if stray_step(&file.path).is_some() {
            let message = format!("names a file outside its folder: {:?}", file.path);
            return Err(
                Fault::of_file(&self.root.join(MANIFEST_NAME), message).with_hint("bake the folder anew")
            );
        }
        let found = look(&file.path).and_then(|found| found.ok_or_else(|| io::ErrorKind::NotFound.into()));
        found.map_err(|error| {
            let path = self.root.join(&file.path);
            Fault::of_file(&path, format!("is in the manifest, but cannot be read: {error}"))
                .with_hint("bake the folder again: missing files are written again")
        })
    }

    /// The present content of the files of a level. As in a bake that continues, a file of the recorded length that is older
    /// than the manifest is taken to be what was recorded; any other is read.
    ///
    /// # Errors
    /// If a file is missing.
    pub(super) fn current_files(&self, entry: &Entry) -> Result<CurrentFiles, Fault> {
        let hashes = entry.files.iter().map(|file| self.current_hash(file)).collect::<Result<Vec<_>, _>>()?;
        let is_edited = hashes.iter().zip(&entry.files).any(|(hash, file)| *hash != file.sha256);
        Ok(CurrentFiles { hashes, is_edited })
    }

    fn current_hash(&self, file: &FileRecord) -> Result<String, Fault> {
        let found = self.inside(file, |path| look_inside(&self.root, path))?;
        let times = found.modified().ok().zip(self.written);
        if found.len() == file.bytes && times.is_some_and(|(modified, written)| modified < written) {
            return Ok(file.sha256.clone());
        }
        let hash =
            |path: &str| open_inside(&self.root, path)?.map(|(opened, _)| file_hash(opened)).transpose();
        self.inside(file, hash)
    }
}

/// Reads a level. Of a file that is not as its bake left it, the findings are those of today; where the catalogue does
/// not suffice for a verdict, the recorded ones stay and a warning says so.
///
/// # Errors
/// If the file is no level.
pub(super) fn read(path: &Path, is_edited: bool, catalog: &Catalog) -> Result<Reading, Fault> {
    let bytes = read_bytes(path)?;
    let (mut inventory, faults) = parse_inventory(path, &bytes)?;
    let mut faults: Vec<Fault> = faults.0;
    let level = parse_level(path, &bytes, catalog).ok();
    if is_edited && let Some(level) = &level {
        faults.extend(judge(path, &mut inventory, level, catalog));
    }
    Ok(Reading { inventory, level, faults })
}

/// Puts the findings of today in the place of the recorded ones.
fn judge(path: &Path, inventory: &mut Inventory, read: &ReadLevel, catalog: &Catalog) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (index, (room, furnished)) in read.level.rooms.iter().zip(&read.furnished).enumerate() {
        let Some(contents) = inventory.rooms.get_mut(&room.id) else { continue };
        let verdict = furnished
            .as_ref()
            .map(|furnished| catch_bug(|| judge_room(read.level.room(index), furnished, catalog)));
        match verdict {
            Some(Ok(verdict)) => {
                contents.findings = verdict.findings.iter().map(Finding::extras).collect();
            }
            Some(Err(bug)) => {
                let fault =
                    Fault::of_file(path, format!("the program failed on room \"{}\": {bug}", room.id));
                faults.push(fault.with_hint("this is a fault of roomwright; please report it with the file"));
            }
            None => {
                let message = format!(
                    "room \"{}\" cannot be judged as it is now; its recorded findings are compared",
                    room.id
                );
                let hint = "`roomwright audit` reports why; --catalog names further classes";
                faults.push(Fault::of_file(path, message).with_hint(hint).as_warning());
            }
        }
    }
    faults
}

/// Whether two files have the same bytes.
///
/// # Errors
/// If one cannot be read.
pub(super) fn is_same_content(old: &Path, new: &Path) -> Result<bool, Fault> {
    Ok(read_bytes(old)? == read_bytes(new)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disk::content_hash;

    fn folder(root: &Path, path: &str, recorded: &str) -> Folder {
        let file = FileRecord {
            path: path.to_owned(),
            sha256: content_hash(recorded.as_bytes()),
            bytes: recorded.len() as u64,
        };
        let level = Entry {
            building: "house".to_owned(),
            level: "0".to_owned(),
            files: vec![file],
            totals: super::super::pairs::EntryTotals::default(),
        };
        Folder {
            root: root.to_owned(),
            levels: vec![level],
            shared: Vec::new(),
            written: Some(SystemTime::now()),
        }
    }

    #[test]
    fn an_edited_file_is_known_by_length_or_time() {
        let root = tempfile::tempdir().unwrap();
        fs::write(root.path().join("0.glb"), "first").unwrap();
        let older = |seconds| Some(SystemTime::now() - std::time::Duration::from_secs(seconds));
        let edited = |folder: &Folder| folder.current_files(&folder.levels[0]).unwrap().is_edited;
        let same = folder(root.path(), "0.glb", "first");
        assert!(!edited(&same) && !edited(&Folder { written: older(60), ..same }));
        let longer = folder(root.path(), "0.glb", "recorded");
        assert!(edited(&longer));
        // Of the recorded length: read only where it is younger than the manifest.
        let other = folder(root.path(), "0.glb", "other");
        assert!(edited(&Folder { written: older(60), ..other }));
    }

    #[test]
    fn files_that_are_missing_or_outside_are_faults_with_hints() {
        let root = tempfile::tempdir().unwrap();
        for (path, expected) in
            [("0.glb", "is in the manifest"), ("../0.glb", "outside"), ("/etc/hosts", "outside")]
        {
            let folder = folder(root.path(), path, "x");
            let fault = folder.current_files(&folder.levels[0]).unwrap_err();
            assert!(fault.message.contains(expected) && fault.hint.is_some(), "{fault:?}");
        }
    }

    #[test]
    fn a_folder_without_a_manifest_cannot_be_compared() {
        let root = tempfile::tempdir().unwrap();
        let fault = open(root.path(), false).unwrap_err();
        assert!(fault.file.ends_with("manifest.json") && fault.hint.unwrap().contains("merge"));
        fs::write(root.path().join("manifest.json"), "{\"name\": \"web app\"}").unwrap();
        assert!(open(root.path(), false).unwrap_err().message.contains("is no manifest"));
        assert!(open(&root.path().join("nowhere"), false).unwrap_err().hint.is_some());
    }
}
