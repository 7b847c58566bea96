//! The files of `configs/`, compiled into the binary so that it runs from any folder.

use include_dir::{Dir, DirEntry, include_dir};

static CONFIGS: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/configs");

/// The folder under whose name the built-in files are shown.
pub(crate) const BUILTIN_FOLDER: &str = "configs";

/// One file of `configs/` as it was when the program was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltinFile {
    /// Its path below `configs/`, with `/` between folders: `classes/seats.yaml`.
    pub path: &'static str,
    /// Its text.
    pub text: &'static str,
}

/// All built-in text files, sorted by path: the catalogue, and the plans and projects that come with it.
#[must_use]
pub fn builtin_files() -> Vec<BuiltinFile> {
    let mut files = Vec::new();
    collect(&CONFIGS, &mut files);
    files.sort_by_key(|file| file.path);
    files
}

/// The text of a built-in file by its path below `configs/`.
#[must_use]
pub fn builtin_file(path: &str) -> Option<&'static str> {
    CONFIGS.get_file(path)?.contents_utf8()
}

fn collect(folder: &Dir<'static>, files: &mut Vec<BuiltinFile>) {
    for entry in folder.entries() {
        match entry {
            DirEntry::Dir(inner) => collect(inner, files),
            DirEntry::File(file) => {
                let path = file.path().to_str();
                files.extend(path.zip(file.contents_utf8()).map(|(path, text)| BuiltinFile { path, text }));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_sorted_and_found_by_path() {
        let files = builtin_files();
        assert!(files.is_sorted_by_key(|file| file.path));
        assert!(files.iter().all(|file| builtin_file(file.path) == Some(file.text)));
        assert!(files.iter().any(|file| file.path == "schema/classes.schema.json"));
    }
}
