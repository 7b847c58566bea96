//! A scene to the files of its level.

use crate::gltf;
use crate::scene::Scene;

use super::fault::{FaultCode, OutputFault};
use super::floor::Workshop;
use super::hash::content_hash;
use super::job::{Format, Job};
use super::record::FileRecord;

/// The files of a level with their content, the one to open first.
pub(crate) struct LevelFiles {
    pub(crate) files: Vec<(FileRecord, Vec<u8>)>,
    /// Paths in the output folder of the shared files that they refer to: models, then images, each sorted.
    pub(crate) shared: Vec<String>,
}

/// Encodes a scene in the format of the run.
///
/// # Errors
/// If the level is too large for the format.
pub(crate) fn encode(
    workshop: &Workshop<'_>,
    job: &Job<'_>,
    (scene, library): (&Scene, Option<&gltf::SharedLibrary>),
) -> Result<LevelFiles, OutputFault> {
    let options = gltf::WriteOptions {
        library,
        models: Some(&workshop.encoded),
        flat_normals: workshop.options.flat_normals,
    };
    let path = |extension: &str| format!("{}.{extension}", job.path);
    match workshop.options.format {
        Format::Glb => {
            let bytes = gltf::write_glb_with(scene, options);
            let path = path(Format::Glb.name());
            let bytes = bytes.map_err(|error| too_large(workshop, &path, &error))?;
            Ok(LevelFiles { files: vec![with_record(path, bytes)], shared: Vec::new() })
        }
        Format::Gltf => {
            let bin = path("bin");
            let name = bin.rsplit('/').next().unwrap_or(&bin);
            let (json, bytes) = gltf::write_gltf_with(scene, name, options);
            let mut files = vec![with_record(path(Format::Gltf.name()), json)];
            if !bytes.is_empty() {
                files.push(with_record(bin, bytes));
            }
            Ok(LevelFiles { files, shared: Vec::new() })
        }
    }
}

/// A file's bytes with what the manifest says about them.
pub(crate) fn with_record(path: String, bytes: Vec<u8>) -> (FileRecord, Vec<u8>) {
    let record = FileRecord { path, sha256: content_hash(&bytes), bytes: bytes.len() as u64 };
    (record, bytes)
}

fn too_large(workshop: &Workshop<'_>, path: &str, error: &gltf::GltfError) -> OutputFault {
    OutputFault {
        code: FaultCode::TooLarge,
        path: workshop.folder.root().join(path),
        message: error.to_string(),
        hint: Some("use --format gltf, or split the level".to_owned()),
    }
}
