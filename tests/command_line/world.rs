//! A folder of its own for each test, and the command in it.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use sha2::{Digest, Sha256};
use tempfile::TempDir;

/// An empty folder in which the command runs.
pub(crate) struct World {
    folder: TempDir,
}

/// How a command ended.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// A plan of `levels` levels with two furnished rooms each.
pub(crate) fn plan(id: &str, levels: usize) -> String {
    format!(
        "version: 1\nid: {id}\nwalls: {{exterior: 0.3, interior: 0.1}}\nlevels:\n  - id: \"{{n}}\"\n    number: 1\n    repeat: {levels}\n    \
         height: 3\n    rooms:\n      - {{id: bed, type: bedroom, rectangle: [0, 0, 4, 4]}}\n      \
         - {{id: study, type: study, rectangle: [4.1, 0, 4, 4]}}\n    openings:\n      \
         - {{kind: door, at: [4.05, 2], rooms: [bed, study]}}\n      - {{kind: window, at: [2, 0], width: 1.2}}\n"
    )
}

impl World {
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    pub(crate) fn path(&self, path: &str) -> PathBuf {
        self.folder.path().join(path)
    }

    pub(crate) fn write(&self, path: &str, text: impl AsRef<[u8]>) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    pub(crate) fn read(&self, path: &str) -> Vec<u8> {
        fs::read(self.path(path)).unwrap()
    }

    /// The command, not yet run.
    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_roomwright"));
        command.current_dir(self.folder.path()).args(arguments).stdin(Stdio::null());
        // Every test sees what is made, not what an earlier one left behind.
        command.env("ROOMWRIGHT_CACHE", "none");
        // Painting takes a while without optimisation: only tests that name textures have them.
        let is_bake = arguments.first().is_none_or(|word| ["bake", "tiles"].contains(word));
        if is_bake && !arguments.contains(&"--textures") {
            command.args(if arguments.is_empty() {
                &["bake", "--textures", "none"][..]
            } else {
                &["--textures", "none"]
            });
        }
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Ran {
        let output = self.command(arguments).output().unwrap();
        Ran {
            code: output.status.code(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Runs a command that must succeed.
    pub(crate) fn must(&self, arguments: &[&str]) -> Ran {
        let ran = self.run(arguments);
        assert_eq!(ran.code, Some(0), "{arguments:?}: {}{}", ran.stdout, ran.stderr);
        ran
    }

    /// Every file below a folder with the hash of its content, hidden ones included.
    pub(crate) fn files(&self, folder: &str) -> BTreeMap<String, String> {
        let hash = |bytes: Vec<u8>| Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        self.contents(folder).into_iter().map(|(name, bytes)| (name, hash(bytes))).collect()
    }

    /// Every file below a folder with its content, hidden ones included.
    pub(crate) fn contents(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let mut files = BTreeMap::new();
        let root = self.path(folder);
        collect(&root, &root, &mut files);
        files
    }

    /// The binary glTF files below a folder with their content, by name.
    pub(crate) fn levels(&self, folder: &str) -> Vec<(String, Vec<u8>)> {
        self.contents(folder).into_iter().filter(|(name, _)| name.ends_with(".glb")).collect()
    }

    /// The names of the files below a folder, without our own corner.
    pub(crate) fn names(&self, folder: &str) -> Vec<String> {
        self.contents(folder).into_keys().filter(|name| !name.starts_with(".roomwright/")).collect()
    }

    /// How many levels of building `alpha` are in place, asked while a bake is still writing: nothing is opened.
    pub(crate) fn levels_written(&self, folder: &str) -> usize {
        let Ok(list) = fs::read_dir(self.path(folder).join("alpha")) else { return 0 };
        list.filter(|entry| {
            entry.as_ref().is_ok_and(|entry| entry.path().extension().is_some_and(|kind| kind == "glb"))
        })
        .count()
    }
}

/// What a process that still writes takes away between the look into its folder and the look into the file is left out.
fn collect(root: &Path, folder: &Path, files: &mut BTreeMap<String, Vec<u8>>) {
    let Ok(list) = fs::read_dir(folder) else { return };
    for entry in list {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(root, &path, files);
            continue;
        }
        let bytes = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == ErrorKind::NotFound => continue,
            Err(error) => panic!("{}: {error}", path.display()),
        };
        let name = path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
        files.insert(name, bytes);
    }
}
