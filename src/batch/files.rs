//! A scene to the files of its level.

use crate::gltf;
use crate::scene::Scene;

use super::context::Context;
use super::fault::{FaultCode, OutputFault};
use super::job::Job;
use super::options::Format;
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
    context: &Context<'_>,
    job: &Job<'_>,
    (scene, library): (&Scene, Option<&gltf::SharedLibrary>),
) -> Result<LevelFiles, OutputFault> {
    let options = gltf::WriteOptions {
        library,
        models: Some(&context.encoded),
        flat_normals: context.options.flat_normals,
    };
    let path = |extension: &str| format!("{}.{extension}", job.path);
    match context.options.format {
        Format::Glb => {
            let bytes = gltf::write_glb_with(scene, options);
            let path = path(Format::Glb.name());
            let bytes = bytes.map_err(|error| too_large(context, &path, &error))?;
            Ok(LevelFiles { files: vec![FileRecord::with_bytes(path, bytes)], shared: Vec::new() })
        }
        Format::Gltf => {
            let bin = path("bin");
            let name = bin.rsplit('/').next().unwrap_or(&bin);
            let (json, bytes) = gltf::write_gltf_with(scene, name, options);
            let mut files = vec![FileRecord::with_bytes(path(Format::Gltf.name()), json)];
            if !bytes.is_empty() {
                files.push(FileRecord::with_bytes(bin, bytes));
            }
            Ok(LevelFiles { files, shared: Vec::new() })
        }
    }
}

fn too_large(context: &Context<'_>, path: &str, error: &gltf::GltfError) -> OutputFault {
    OutputFault {
        code: FaultCode::TooLarge,
        path: context.folder.root().join(path),
        message: error.to_string(),
        hint: Some("use --format gltf, or split the level".to_owned()),
    }
}
