//! The binary container: a header, a chunk of JSON, a chunk of data (glTF 2.0, section 4).

use super::GltfError;

const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;
const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;
/// Chunks begin and end at multiples of this.
const ALIGNMENT: usize = 4;

/// Joins both parts; the data chunk is left out if it is empty. `append` adds so many bytes, a multiple of four, to what it is given.
pub(crate) fn write(
    json: &[u8],
    data_bytes: usize,
    append: impl FnOnce(&mut Vec<u8>),
) -> Result<Vec<u8>, GltfError> {
    let json_bytes = json.len().next_multiple_of(ALIGNMENT);
    let data_chunk = if data_bytes == 0 { 0 } else { CHUNK_HEADER_BYTES + data_bytes };
    let total = HEADER_BYTES + CHUNK_HEADER_BYTES + json_bytes + data_chunk;
    let counted = |bytes: usize| u32::try_from(bytes).map_err(|_| GltfError::TooLarge(total as u64));
    let mut file = Vec::with_capacity(total);
    file.extend_from_slice(MAGIC);
    file.extend_from_slice(&VERSION.to_le_bytes());
    file.extend_from_slice(&counted(total)?.to_le_bytes());
    file.extend_from_slice(&counted(json_bytes)?.to_le_bytes());
    file.extend_from_slice(b"JSON");
    file.extend_from_slice(json);
    file.resize(HEADER_BYTES + CHUNK_HEADER_BYTES + json_bytes, b' ');
    if data_bytes > 0 {
        file.extend_from_slice(&counted(data_bytes)?.to_le_bytes());
        file.extend_from_slice(b"BIN\0");
        append(&mut file);
    }
    Ok(file)
}
