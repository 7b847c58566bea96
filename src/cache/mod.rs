//! What every run would make anew although it depends on the program alone, kept in a folder between runs.
//!
//! What later stages may rely on: an entry comes back as it was kept, or it is made again. A missing, damaged or unreadable
//! entry is no fault, and a folder that cannot be written keeps nothing. No byte of the output depends on a cache.

mod others;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

/// A folder of entries that one state of the program has made. Clones share it; threads and processes may too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cache {
    folder: Arc<Path>,
}

/// Bytes of the hash that an entry begins with.
const HASH_BYTES: usize = 32;

/// Tells programs that make backups to leave the folder out (Cache Directory Tagging Specification 0.6).
const TAG: (&str, &str) = (
    "CACHEDIR.TAG",
    "Signature: 8a477f597d28d172789f06886806bc55\n# Made by roomwright; it may be deleted at any time.\n",
);

impl Cache {
    /// The entries of `program` (a name for this state of the code) below `root`. Nothing is read or written yet.
    #[must_use]
    pub fn new(root: &Path, program: &str) -> Self {
        Self { folder: root.join(others::folder_name(program)).into() }
    }

    /// The system's folder for what programs may lose; `None` where there is none, as for users without a home.
    #[must_use]
    pub fn default_root() -> Option<PathBuf> {
        use etcetera::BaseStrategy;
        Some(etcetera::choose_base_strategy().ok()?.cache_dir().join("roomwright"))
    }

    /// What was kept under a key, else what `make` makes, which is then kept. A key must name all that `make` depends on
    /// besides the program.
    pub fn get_or_make<T: Serialize + DeserializeOwned>(
        &self,
        key: &impl Serialize,
        make: impl FnOnce() -> T,
    ) -> T {
        let Ok(key) = postcard::to_stdvec(key) else { return make() };
        let path = self.folder.join(format!("{}.entry", hexadecimal(&Sha256::digest(key))));
        if let Some(kept) = read(&path) {
            return kept;
        }
        let made = make();
        // Who cannot keep it, makes it again the next time.
        let _ = self.keep(&path, &made);
        made
    }

    fn keep<T: Serialize>(&self, path: &Path, value: &T) -> io::Result<()> {
        let content = postcard::to_stdvec(value).map_err(io::Error::other)?;
        if !self.folder.is_dir() {
            fs::create_dir_all(&self.folder)?;
            fs::write(self.folder.join(TAG.0), TAG.1)?;
            others::remove_oldest(&self.folder)?;
        }
        // Under another name until it is whole: other processes read while this one writes.
        let mut file = tempfile::NamedTempFile::new_in(&self.folder)?;
        file.write_all(&Sha256::digest(&content))?;
        file.write_all(&content)?;
        file.persist(path)?;
        Ok(())
    }
}

fn read<T: DeserializeOwned>(path: &Path) -> Option<T> {
    let bytes = fs::read(path).ok()?;
    let (hash, content) = bytes.split_at_checked(HASH_BYTES)?;
    let is_whole = Sha256::digest(content).as_slice() == hash;
    is_whole.then(|| postcard::from_bytes(content).ok()).flatten()
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROGRAM: &str = "1.2.3+0123456789abcdef";

    fn entry(cache: &Cache) -> PathBuf {
        let files = fs::read_dir(&cache.folder).unwrap().map(|file| file.unwrap().path());
        let mut entries = files.filter(|path| path.extension().is_some_and(|end| end == "entry"));
        let found = entries.next().unwrap();
        assert_eq!(entries.next(), None);
        found
    }

    fn kept(cache: &Cache, key: &str) -> Option<Vec<f32>> {
        let mut is_made = false;
        let found = cache.get_or_make(&key, || {
            is_made = true;
            vec![1.5, -0.0]
        });
        (!is_made).then_some(found)
    }

    #[test]
    fn what_was_made_once_is_kept_by_key_and_program() {
        let root = tempfile::tempdir().unwrap();
        let cache = Cache::new(root.path(), PROGRAM);
        assert_eq!(kept(&cache, "a"), None);
        assert_eq!(kept(&cache, "a"), Some(vec![1.5, -0.0]));
        assert_eq!(kept(&cache, "b"), None);
        assert_eq!(kept(&Cache::new(root.path(), "1.2.3+fedcba9876543210"), "a"), None);
        assert!(cache.folder.join(TAG.0).is_file());
    }

    #[test]
    fn damaged_entries_are_made_again() {
        let root = tempfile::tempdir().unwrap();
        let cache = Cache::new(root.path(), PROGRAM);
        assert_eq!(kept(&cache, "a"), None);
        let (path, whole) = (entry(&cache), fs::read(entry(&cache)).unwrap());
        for at in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[at] ^= 1;
            fs::write(&path, damaged).unwrap();
            assert_eq!(kept(&cache, "a"), None, "byte {at} differs");
            fs::write(&path, &whole[..at]).unwrap();
            assert_eq!(kept(&cache, "a"), None, "cut at {at}");
        }
        assert_eq!(kept(&cache, "a"), Some(vec![1.5, -0.0]));
    }

    #[test]
    fn a_folder_that_cannot_be_written_keeps_nothing() {
        let root = tempfile::NamedTempFile::new().unwrap();
        let cache = Cache::new(root.path(), PROGRAM);
        assert_eq!(kept(&cache, "a"), None);
        assert_eq!(kept(&cache, "a"), None);
    }
}
