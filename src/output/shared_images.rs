//! Images that levels refer to instead of carrying them.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::format::SharedFile;
use crate::mesh::{Image, Texture};

/// The images of textures that have files of their own, sorted by path; `folder` is that of the building, which their URIs start from.
pub(crate) fn shared_images<'t>(
    textures: impl Iterator<Item = &'t Texture>,
    folder: &str,
) -> Vec<SharedFile<'static>> {
    let beside = textures.filter_map(|texture| Some((texture.image.uri.as_ref()?, &texture.image)));
    let by_path: BTreeMap<String, Arc<Image>> = beside
        .map(|(uri, image)| {
            let path = uri.strip_prefix("../").map_or_else(|| format!("{folder}/{uri}"), str::to_owned);
            (path, Arc::clone(image))
        })
        .collect();
    let file = |(path, image): (String, Arc<Image>)| SharedFile {
        path,
        content: Box::new(move || image.bytes.clone()),
    };
    by_path.into_iter().map(file).collect()
}
