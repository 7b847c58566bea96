//! Opening a `.glb` or `.gltf`: its document and its buffers.

use std::path::{Path, PathBuf};

use gltf::json::Root;
use serde::Deserialize;

use super::laying::Layings;
use super::problem::Problem;
use super::resource::Resources;
use crate::document::Fault;

/// An opened file.
#[derive(Debug)]
pub(super) struct Container {
    /// The document: valid, every index in it points somewhere.
    pub(super) document: Root,
    /// How its images are laid on.
    pub(super) layings: Layings,
    /// The bytes of each buffer.
    pub(super) buffers: Vec<Vec<u8>>,
    /// Where images come from that are no part of a buffer.
    pub(super) resources: Resources,
}

/// The extensions of a document, read before the rest because some change what is required elsewhere.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[derive(Default)]
struct Declared {
    extensions_used: Vec<String>,
    extensions_required: Vec<String>,
}

/// Extensions that change the geometry or the images, and how to get rid of them.
const REFUSED: [(&str, &str); 8] = [
    ("KHR_draco_mesh_compression", "decompress it: gltf-transform copy IN.glb OUT.glb"),
    ("EXT_meshopt_compression", "decompress it: gltf-transform copy IN.glb OUT.glb"),
    ("KHR_meshopt_compression", "decompress it: gltf-transform copy IN.glb OUT.glb"),
    ("KHR_texture_basisu", "convert its textures: gltf-transform ktxdecompress IN.glb OUT.glb"),
    ("EXT_texture_webp", "convert its textures: gltf-transform png IN.glb OUT.glb"),
    ("EXT_texture_avif", "convert its textures: gltf-transform png IN.glb OUT.glb"),
    ("MSFT_texture_dds", "export it again with PNG or JPEG textures"),
    (
        "KHR_materials_pbrSpecularGlossiness",
        "convert its materials: gltf-transform metalrough IN.glb OUT.glb",
    ),
];

/// Reads and checks a file.
pub(super) fn open(path: &Path) -> Result<Container, Problem> {
    let mut resources = Resources::beside(path);
    let bytes = resources.read_file(path)?;
    let (text, blob) = split(&bytes)?;
    let document = parse(&text)?;
    let layings = serde_json::from_slice(&text).map_err(not_json)?;
    refuse_motion(&document)?;
    let buffers = read_buffers(&document, blob, &mut resources)?;
    Ok(Container { document, layings, buffers, resources })
}

/// The files beside a model file that its document refers to, buffers first, in its order; `bytes` are the file's own.
///
/// Nothing is told of a file that is no glTF, or of places that are never read: whoever opens it does that.
pub(crate) fn companion_files(path: &Path, bytes: &[u8]) -> Vec<PathBuf> {
    let document: serde_json::Value =
        split(bytes).ok().and_then(|(text, _)| serde_json::from_slice(&text).ok()).unwrap_or_default();
    let resources = Resources::beside(path);
    ["buffers", "images"]
        .iter()
        .filter_map(|key| document.get(key)?.as_array())
        .flatten()
        .filter_map(|entry| entry.get("uri")?.as_str())
        .filter_map(|uri| resources.file_of_uri(uri).ok().flatten())
        .collect()
}

/// A document as it stands in a file: nothing in it has been checked, indices may point nowhere.
///
/// # Errors
/// Bytes that are no glTF document.
pub(crate) fn unchecked_document(file: &Path, bytes: &[u8]) -> Result<Root, Fault> {
    let parsed = split(bytes).and_then(|(text, _)| serde_json::from_slice(&text).map_err(not_json));
    parsed.map_err(|problem| problem.in_file(file))
}

/// The document's text and the binary chunk of a `.glb`.
fn split(bytes: &[u8]) -> Result<(Vec<u8>, Option<Vec<u8>>), Problem> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes.to_vec(), None));
    }
    // The reader subtracts the header from the length without looking.
    let length = bytes.get(8..12).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
    if length.is_none_or(|length| length < 12) {
        return Err(Problem::new("is cut off within its header").with_hint(DAMAGED_HINT));
    }
    let announced = length.unwrap_or_default() as usize;
    if announced > bytes.len() {
        let message =
            format!("is cut off: it has {} of the {announced} bytes that its header announces", bytes.len());
        return Err(Problem::new(message).with_hint(DAMAGED_HINT));
    }
    let glb = gltf::Glb::from_slice(bytes).map_err(|error| {
        Problem::new(format!("is no sound binary glTF 2.0 file: {error}")).with_hint(DAMAGED_HINT)
    })?;
    Ok((glb.json.into_owned(), glb.bin.map(std::borrow::Cow::into_owned)))
}

const DAMAGED_HINT: &str =
    "the file is cut off or damaged: copy it again, or write it anew where it comes from";

fn not_json(error: serde_json::Error) -> Problem {
    let hint = "a .glb begins with the letters glTF, a .gltf is JSON: is this another kind of file, or an empty one?";
    Problem::new(format!("is no glTF document: {error}")).with_hint(hint)
}

fn parse(text: &[u8]) -> Result<Root, Problem> {
    let declared: Declared = serde_json::from_slice(text).map_err(not_json)?;
    refuse_extensions(&declared)?;
    let mut document: Root = serde_json::from_slice(text).map_err(not_json)?;
    if !document.asset.version.starts_with("2.") {
        return Err(Problem::new(format!("is glTF version {:?}, not 2.0", document.asset.version)));
    }
    // The library's check of positions looks them up without asking whether they are there.
    let parts = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut attributes = parts.flat_map(|part| part.attributes.values());
    if let Some(missing) = attributes.find(|accessor| accessor.value() >= document.accessors.len()) {
        return Err(Problem::new(format!("a mesh names accessor {}, which does not exist", missing.value())));
    }
    // Those that remain are handled here; the library would refuse what it does not know itself.
    document.extensions_required.clear();
    let checked = gltf::Document::from_json(document)
        .map_err(|error| Problem::new(format!("is not valid: {error}")))?;
    Ok(checked.into_json())
}

fn refuse_extensions(declared: &Declared) -> Result<(), Problem> {
    let used = declared.extensions_used.iter().chain(&declared.extensions_required);
    for name in used {
        let refused = REFUSED.iter().find(|(refused, _)| refused == name);
        // A texture format that is not required has a plain image beside it.
        let is_optional = name.contains("_texture_");
        if let Some((_, hint)) = refused
            && (!is_optional || declared.extensions_required.contains(name))
        {
            return Err(
                Problem::new(format!("uses the extension {name}, which is not read")).with_hint(*hint)
            );
        }
    }
    let is_harmless = |name: &&String| {
        name.starts_with("KHR_materials_")
            || ["KHR_mesh_quantization", "KHR_lights_punctual", "KHR_texture_transform"]
                .contains(&name.as_str())
    };
    match declared.extensions_required.iter().find(|name| !is_harmless(name)) {
        Some(name) => Err(Problem::new(format!("requires the extension {name}, which is not read"))
            .with_hint("export it again without the extension")),
        None => Ok(()),
    }
}

/// Furniture stands still.
fn refuse_motion(document: &Root) -> Result<(), Problem> {
    let has_targets =
        document.meshes.iter().flat_map(|mesh| &mesh.primitives).any(|part| part.targets.is_some());
    let found = if !document.animations.is_empty() {
        "animations"
    } else if !document.skins.is_empty() {
        "skins"
    } else if has_targets {
        "morph targets"
    } else {
        return Ok(());
    };
    Err(Problem::new(format!("has {found}; furniture does not move"))
        .with_hint("apply the pose and export it again without them"))
}

fn read_buffers(
    document: &Root,
    blob: Option<Vec<u8>>,
    resources: &mut Resources,
) -> Result<Vec<Vec<u8>>, Problem> {
    let mut blob = blob;
    let mut buffers = Vec::with_capacity(document.buffers.len());
    for (index, buffer) in document.buffers.iter().enumerate() {
        let bytes = match &buffer.uri {
            Some(uri) => resources.read_uri(uri)?,
            None => blob.take().ok_or_else(|| Problem::new(format!("buffer {index} has no bytes")))?,
        };
        if (bytes.len() as u64) < buffer.byte_length.0 {
            let message =
                format!("buffer {index} has {} bytes, {} are announced", bytes.len(), buffer.byte_length.0);
            return Err(Problem::new(message));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}
