//! Bytes that a model file refers to: data URIs and files beside it.

use std::path::{Component, Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::problem::Problem;
use crate::disk::{open_regular, read_regular};

/// The most bytes of one model with everything it refers to: a scanned armchair with three 4K textures has 40 MB.
/// Larger ones would be copied into every floor that uses them.
pub(crate) const MODEL_BYTES_LIMIT: u64 = 128 << 20;

/// Reads what a model refers to, and counts its bytes.
#[derive(Debug)]
pub(super) struct Resources {
    folder: PathBuf,
    byte_count: u64,
}

impl Resources {
    /// For a model file.
    pub(super) fn beside(file: &Path) -> Self {
        Self { folder: file.parent().map(Path::to_owned).unwrap_or_default(), byte_count: 0 }
    }

    /// The bytes of a file, unless the limit is passed.
    pub(super) fn read_file(&mut self, path: &Path) -> Result<Vec<u8>, Problem> {
        let unreadable =
            |error: std::io::Error| Problem::new(format!("\"{}\" cannot be read: {error}", path.display()));
        let (_, found) = open_regular(path).map_err(unreadable)?;
        self.count(found.len())?;
        read_regular(path, MODEL_BYTES_LIMIT).map_err(unreadable)
    }

    /// The bytes that a URI stands for.
    pub(super) fn read_uri(&mut self, uri: &str) -> Result<Vec<u8>, Problem> {
        match self.file_of_uri(uri)? {
            Some(file) => self.read_file(&file),
            None => self.decode(uri),
        }
    }

    /// The file that a URI names; `None` for data URIs.
    pub(super) fn file_of_uri(&self, uri: &str) -> Result<Option<PathBuf>, Problem> {
        if uri.starts_with("data:") {
            return Ok(None);
        }
        local_path(uri).map(|path| Some(self.folder.join(path)))
    }

    fn decode(&mut self, data: &str) -> Result<Vec<u8>, Problem> {
        let Some((_, text)) = data.split_once(";base64,") else {
            return Err(Problem::new("a data URI is not in base64"));
        };
        self.count(text.len() as u64)?;
        STANDARD.decode(text).map_err(|error| Problem::new(format!("a data URI is not in base64: {error}")))
    }

    fn count(&mut self, bytes: u64) -> Result<(), Problem> {
        self.byte_count = self.byte_count.saturating_add(bytes);
        if self.byte_count <= MODEL_BYTES_LIMIT {
            return Ok(());
        }
        let limit = MODEL_BYTES_LIMIT >> 20;
        Err(Problem::new(format!(
            "the model and its files have {} MB, over {limit} MB",
            self.byte_count >> 20
        ))
        .with_hint("make its textures smaller; every floor that uses the model carries a copy"))
    }
}

/// The relative path in a URI. Only files beside or below the model are opened, so that a model from elsewhere cannot
/// copy other files of this machine into the output.
fn local_path(uri: &str) -> Result<PathBuf, Problem> {
    let refused = |what: &str| {
        Problem::new(format!("refers to \"{uri}\", {what}")).with_hint("put the file beside the model")
    };
    if uri.contains(':') {
        return Err(refused("which is not a file beside it"));
    }
    let decoded =
        percent_encoding::percent_decode_str(uri).decode_utf8().map_err(|_| refused("which is not UTF-8"))?;
    let path = PathBuf::from(decoded.as_ref());
    let is_below = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    if is_below { Ok(path) } else { Err(refused("which is outside its folder")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_uris_are_decoded() {
        let mut resources = Resources::beside(Path::new("models/chair.gltf"));
        assert_eq!(resources.read_uri("data:application/octet-stream;base64,AQID").unwrap(), [1, 2, 3]);
        assert!(resources.read_uri("data:text/plain,abc").is_err());
        assert!(resources.read_uri("data:;base64,????").is_err());
    }

    #[test]
    fn paths_stay_beside_the_model() {
        assert_eq!(local_path("tex/wood%20grain.png").unwrap(), Path::new("tex/wood grain.png"));
        for outside in
            ["../secret.png", "/etc/hosts", "https://example.org/a.png", "%2e%2e/a.png", "file:///a", "%ff"]
        {
            assert!(local_path(outside).is_err(), "{outside}");
        }
    }

    #[test]
    fn the_limit_counts_everything_together() {
        let mut resources = Resources::beside(Path::new("a.gltf"));
        assert!(resources.count(MODEL_BYTES_LIMIT).is_ok());
        assert!(resources.count(1).is_err());
    }
}
