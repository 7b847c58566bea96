//! Buffers and the views into them.

use std::collections::BTreeMap;

use gltf_json::buffer::{Buffer, Stride, Target, View};
use gltf_json::validation::{Checked, USize64};
use gltf_json::{Index, Root};

use super::array::Section;
use super::library::SharedModel;
use super::pack::{Packed, Packer};

/// One view per section and buffer, made when first asked for, so that nothing in the file is unused.
pub(crate) struct Views<'l> {
    own: BufferViews<'l>,
    /// By the path of their file.
    shared: BTreeMap<&'l str, BufferViews<'l>>,
}

struct BufferViews<'l> {
    packer: &'l Packer,
    uri: Option<&'l str>,
    buffer: Option<Index<Buffer>>,
    views: [Option<Index<View>>; Section::ALL.len()],
}

impl<'l> Views<'l> {
    /// The level's own buffer comes first if it holds anything: a container's data chunk is buffer 0.
    pub(crate) fn new(root: &mut Root, packer: &'l Packer, uri: Option<&'l str>) -> Self {
        let mut own = BufferViews::new(packer, uri);
        if packer.byte_count() > 0 {
            own.buffer(root);
        }
        Self { own, shared: BTreeMap::new() }
    }

    /// The view that holds the elements of an accessor, in the file of a model or else in the level's own.
    pub(crate) fn section(
        &mut self,
        root: &mut Root,
        file: Option<&'l SharedModel>,
        section: Section,
    ) -> Index<View> {
        let buffer = match file {
            Some(file) => self
                .shared
                .entry(&file.path)
                .or_insert_with(|| BufferViews::new(&file.packer, Some(&file.path))),
            None => &mut self.own,
        };
        buffer.section(root, section)
    }

    /// A view of its own for an image.
    pub(crate) fn image(&mut self, root: &mut Root, image: &Packed) -> Index<View> {
        let buffer = self.own.buffer(root);
        let start = self.own.packer.extent(Section::Images).0 + image.offset;
        root.push(view(buffer, start, image.count))
    }
}

impl<'l> BufferViews<'l> {
    fn new(packer: &'l Packer, uri: Option<&'l str>) -> Self {
        Self { packer, uri, buffer: None, views: [None; Section::ALL.len()] }
    }

    fn buffer(&mut self, root: &mut Root) -> Index<Buffer> {
        *self.buffer.get_or_insert_with(|| {
            root.push(Buffer {
                byte_length: USize64::from(self.packer.byte_count()),
                name: None,
                uri: self.uri.map(percent_encoded),
                extensions: None,
                extras: None,
            })
        })
    }

    fn section(&mut self, root: &mut Root, section: Section) -> Index<View> {
        if let Some(view) = self.views[section as usize] {
            return view;
        }
        let (start, length) = self.packer.extent(section);
        let mut made = view(self.buffer(root), start, length);
        made.target = Some(Checked::Valid(target(section)));
        made.byte_stride = stride(section);
        let index = root.push(made);
        self.views[section as usize] = Some(index);
        index
    }
}

fn view(buffer: Index<Buffer>, start: usize, length: usize) -> View {
    View {
        buffer,
        byte_length: USize64::from(length),
        byte_offset: (start > 0).then(|| USize64::from(start)),
        byte_stride: None,
        name: None,
        target: None,
        extensions: None,
        extras: None,
    }
}

fn target(section: Section) -> Target {
    match section {
        Section::TinyIndices | Section::ShortIndices | Section::LongIndices => Target::ElementArrayBuffer,
        _ => Target::ArrayBuffer,
    }
}

/// Bytes from one element to the next; views of indices have none.
fn stride(section: Section) -> Option<Stride> {
    match section {
        Section::Vectors => Some(Stride(size_of::<[f32; 3]>())),
        Section::Coordinates => Some(Stride(size_of::<[f32; 2]>())),
        Section::Colors | Section::Tangents => Some(Stride(size_of::<[f32; 4]>())),
        _ => None,
    }
}

/// A relative path as a URI (RFC 3986): everything but letters, digits, `-._~` and `/` is encoded.
pub(crate) fn percent_encoded(path: &str) -> String {
    use std::fmt::Write;
    let mut uri = String::with_capacity(path.len());
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            uri.push(char::from(byte));
        } else {
            write!(uri, "%{byte:02X}").expect("a string takes all that is written");
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::percent_encoded;

    #[test]
    fn paths_become_uris() {
        assert_eq!(percent_encoded("../library.bin"), "../library.bin");
        assert_eq!(percent_encoded("étage 1#.bin"), "%C3%A9tage%201%23.bin");
    }
}
