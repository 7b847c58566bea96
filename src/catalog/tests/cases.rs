//! `tests/cases/catalog/*.yaml`: small folders of configuration with expected faults.
//!
//! A case is one file of several parts. `#: [layer/]path` begins the next file of the case; layers `0/`, `1/` stand for
//! folders given one after the other. `#! message` at the end of a line expects a fault there, `#? message` a warning; a
//! hint follows after ` | `. Every fault has to be expected. All cases extend the folder `tests/cases/catalog/base`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::catalog::Catalog;
use crate::catalog::load::load_files;
use crate::catalog::read::Files;
use crate::document::{Fault, Faults};

/// A case written out to a temporary folder.
struct Case {
    folder: TempDir,
    layers: BTreeSet<String>,
    expected: BTreeSet<String>,
}

fn cases_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/catalog")
}

/// The catalogue of the base and then the folders.
pub(super) fn load_above_base(folders: &[PathBuf]) -> Result<(Catalog, Faults), Faults> {
    let mut files = Files::default();
    files.add_folder(&cases_folder().join("base"));
    folders.iter().for_each(|folder| files.add_folder(folder));
    load_files(&files).map(|warned| (warned.value, warned.warnings))
}

impl Case {
    fn read(path: &Path) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let mut case = Self { folder, layers: BTreeSet::new(), expected: BTreeSet::new() };
        let text = fs::read_to_string(path).unwrap();
        for part in text.split("\n#: ").skip(1) {
            let (name, text) = part.split_once('\n').unwrap();
            case.add(name.trim(), text);
        }
        case
    }

    fn add(&mut self, name: &str, text: &str) {
        let name = if name.starts_with(|c: char| c.is_ascii_digit()) {
            name.to_owned()
        } else {
            format!("0/{name}")
        };
        self.layers.insert(name.split('/').next().unwrap().to_owned());
        for (number, line) in text.lines().enumerate() {
            for (mark, kind) in [("#! ", "error"), ("#? ", "warning")] {
                if let Some((_, message)) = line.split_once(mark) {
                    self.expected.insert(format!("{name}:{}: {kind}: {}", number + 1, message.trim()));
                }
            }
        }
        let path = self.folder.path().join(&name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        // The marks are no part of what is read.
        fs::write(path, text.replace("#!", "#").replace("#?", "#")).unwrap();
    }

    fn folders(&self) -> Vec<PathBuf> {
        self.layers.iter().map(|layer| self.folder.path().join(layer)).collect()
    }

    /// A fault as the case writes it; hints are compared only where the case has one.
    fn show(&self, fault: &Fault) -> String {
        let file = fault.file.strip_prefix(self.folder.path()).unwrap_or(&fault.file);
        let line = fault.position.map_or(0, |(line, _)| line);
        let kind = if fault.is_error() { "error" } else { "warning" };
        let plain = format!("{}:{line}: {kind}: {}", file.display(), fault.message);
        let root = self.folder.path().display().to_string();
        let hinted = format!("{plain} | {}", fault.hint.as_deref().unwrap_or_default().replace(&root, ""));
        if self.expected.contains(&hinted) { hinted } else { plain }
    }
}

#[test]
fn every_case_has_the_faults_it_expects_and_no_others() {
    let mut paths: Vec<PathBuf> = fs::read_dir(cases_folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
        .collect();
    paths.sort();
    let mut differences = String::new();
    for path in paths {
        let case = Case::read(&path);
        let (Ok((_, faults)) | Err(faults)) = load_above_base(&case.folders());
        let found: BTreeSet<String> = faults.0.iter().map(|fault| case.show(fault)).collect();
        for missing in case.expected.difference(&found) {
            differences += &format!("{}: expected {missing}\n", path.display());
        }
        for extra in found.difference(&case.expected) {
            differences += &format!("{}: found    {extra}\n", path.display());
        }
    }
    assert!(differences.is_empty(), "\n{differences}");
}
