//! Hashes the sources, so that a floor baked by other code is not taken for up to date. Runs again when a
//! file of `configs/` changes, for these are part of the binary. Says to the tests whether the plans of others are there.
//!
//! The version number alone would not do: between two releases the code changes with every commit.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// Hexadecimal digits that are kept; enough that two states of the code never meet.
const DIGITS: usize = 16;

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=configs");
    println!("cargo::rerun-if-changed=src");
    println!("cargo::rerun-if-changed=Cargo.lock");
    tell_shared_data();
    let mut files = vec![PathBuf::from("Cargo.lock")];
    list_files(Path::new("src"), &mut files)?;
    files.sort();
    let mut hash = Sha256::new();
    for file in files.iter().filter(|file| file.exists()) {
        let content = fs::read(file)?;
        // The same name on every system, whatever its separator.
        let name: Vec<_> = file.iter().map(|part| part.to_string_lossy()).collect();
        hash.update(name.join("/"));
        hash.update((content.len() as u64).to_le_bytes());
        hash.update(content);
    }
    let digits: String = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    println!("cargo::rustc-env=ROOMWRIGHT_SOURCE_HASH={}", &digits[..DIGITS]);
    Ok(())
}

/// Tests of plans that are not part of the project are ignored, and said to be, where those are absent.
fn tell_shared_data() {
    let data = Path::new("../shared/data");
    println!("cargo::rustc-check-cfg=cfg(shared_data)");
    if data.is_dir() {
        println!("cargo::rustc-cfg=shared_data");
        println!("cargo::rerun-if-changed={}", data.display());
    }
}

fn list_files(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            list_files(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
