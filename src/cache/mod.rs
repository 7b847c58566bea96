//! Keeps values that depend on the program alone, such as textures and models, in a folder between runs.
//!
//! Callers may rely on: an entry comes back as it was kept, or it is made again. A missing, damaged or unreadable entry
//! is no fault, and a folder that cannot be written keeps nothing. No byte of the output depends on a cache.

mod others;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

use crate::disk::{new_temporary, read_plain, sweep_temporaries};

/// A folder of entries that one state of the program has made. Clones share it; threads and processes may too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cache {
    program: Arc<str>,
    folder: Arc<Path>,
    is_swept: Arc<OnceLock<()>>,
}

/// Bytes of the hash that an entry begins with.
const HASH_BYTES: usize = 32;

/// How the names of entries end.
const ENTRY_ENDING: &str = ".entry";

/// How entries begin that are not yet whole.
const TEMPORARY_PREFIX: &str = "entry-";

/// The most bytes of an entry that are read: a model with its mesh takes a hundredth of it.
const LARGEST_ENTRY: u64 = 1 << 28;

/// Tells programs that make backups to leave the folder out (Cache Directory Tagging Specification 0.6).
const TAG: (&str, &str) = (
    "CACHEDIR.TAG",
    "Signature: 8a477f597d28d172789f06886806bc55\n# Made by roomwright; it may be deleted at any time.\n",
);

impl Cache {
    /// The entries of `program` (a name for this state of the code) below `root`. Nothing is read or written yet.
    #[must_use]
    pub fn new(root: &Path, program: &str) -> Self {
        let folder = root.join(others::folder_name(program)).into();
        Self { program: program.into(), folder, is_swept: Arc::default() }
    }

    /// The system's folder for what programs may lose; `None` where there is none, as for users without a home.
    #[cfg(feature = "cli")]
    #[must_use]
    pub fn default_root() -> Option<PathBuf> {
        use etcetera::BaseStrategy;
        Some(etcetera::choose_base_strategy().ok()?.cache_dir().join("roomwright"))
    }

    /// The value kept under a key; without one, `make` makes it, and it is kept. A key must name all that `make` depends on
    /// besides the program.
    pub fn get_or_make<T: Serialize + DeserializeOwned>(
        &self,
        key: &impl Serialize,
        make: impl FnOnce() -> T,
    ) -> T {
        let Ok(key) = postcard::to_stdvec(key) else { return make() };
        self.is_swept.get_or_init(|| sweep_temporaries(&self.folder, TEMPORARY_PREFIX));
        if let Some(kept) = self.read(&key) {
            return kept;
        }
        let made = make();
        // A value that cannot be kept is made again the next time.
        let _ = self.keep(&key, &made);
        made
    }

    fn path(&self, key: &[u8]) -> PathBuf {
        self.folder.join(format!("{}{ENTRY_ENDING}", hexadecimal(&Sha256::digest(key))))
    }

    /// The hash of an entry. It is of one key and one program: under the name of another entry it is damaged.
    fn hash(&self, key: &[u8], content: &[u8]) -> [u8; HASH_BYTES] {
        let mut hash = Sha256::new();
        for field in [self.program.as_bytes(), key, content] {
            hash.update((field.len() as u64).to_le_bytes());
            hash.update(field);
        }
        hash.finalize().into()
    }

    fn read<T: DeserializeOwned>(&self, key: &[u8]) -> Option<T> {
        let bytes = read_plain(&self.path(key), LARGEST_ENTRY).ok()?;
        let (hash, content) = bytes.split_at_checked(HASH_BYTES)?;
        let is_whole = self.hash(key, content) == hash;
        is_whole.then(|| postcard::from_bytes(content).ok()).flatten()
    }

    fn keep<T: Serialize>(&self, key: &[u8], value: &T) -> io::Result<()> {
        let content = postcard::to_stdvec(value).map_err(io::Error::other)?;
        if !self.folder.is_dir() {
            fs::create_dir_all(&self.folder)?;
            fs::write(self.folder.join(TAG.0), TAG.1)?;
            others::remove_oldest(&self.folder)?;
        }
        // Under another name until it is whole: other processes read while this one writes.
        let mut file = new_temporary(&self.folder, TEMPORARY_PREFIX)?;
        file.write_all(&self.hash(key, &content))?;
        file.write_all(&content)?;
        file.persist(self.path(key))?;
        Ok(())
    }
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
    fn values_are_kept_by_key_and_program() {
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
    fn entries_with_exchanged_names_count_as_damaged() {
        let root = tempfile::tempdir().unwrap();
        let [cache, other] = ["1.2.3+a", "1.2.3+b"].map(|program| Cache::new(root.path(), program));
        let made = |cache: &Cache, key: &str| cache.get_or_make(&key, || key.to_owned());
        let path = |cache: &Cache, key: &str| cache.path(&postcard::to_stdvec(key).unwrap());
        for (cache, key) in [(&cache, "a"), (&cache, "b"), (&other, "a")] {
            made(cache, key);
        }
        for (from, to, key) in
            [(path(&cache, "b"), path(&cache, "a"), "a"), (path(&other, "a"), path(&cache, "a"), "a")]
        {
            fs::copy(from, to).unwrap();
            let found = cache.get_or_make(&key, || "made again".to_owned());
            assert_eq!(found, "made again");
        }
    }

    #[test]
    fn temporary_files_of_killed_runs_are_removed() {
        let root = tempfile::tempdir().unwrap();
        let cache = Cache::new(root.path(), PROGRAM);
        assert_eq!(kept(&cache, "a"), None);
        fs::write(cache.folder.join("entry-a1B2c3"), "half").unwrap();
        assert!(kept(&Cache::new(root.path(), PROGRAM), "a").is_some());
        assert!(!cache.folder.join("entry-a1B2c3").exists());
    }

    #[test]
    fn a_folder_that_cannot_be_written_keeps_nothing() {
        let root = tempfile::NamedTempFile::new().unwrap();
        let cache = Cache::new(root.path(), PROGRAM);
        assert_eq!(kept(&cache, "a"), None);
        assert_eq!(kept(&cache, "a"), None);
    }
}
