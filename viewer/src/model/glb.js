// The container of glTF: a header, a chunk of JSON and a chunk of bytes (glTF 2.0, section 4.4).

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** The document of a .glb file: {json, binary}, `binary` a view of the file or null. */
export function readGlb(buffer) {
  const view = new DataView(buffer);
  if (buffer.byteLength < 20 || view.getUint32(0, true) !== MAGIC) throw new Error('the answer is no .glb file');
  if (view.getUint32(8, true) > buffer.byteLength) throw new Error('the .glb file is cut off');
  const document = { json: null, binary: null };
  for (let offset = 12; offset + 8 <= buffer.byteLength;) {
    const length = view.getUint32(offset, true);
    const chunk = new Uint8Array(buffer, offset + 8, Math.min(length, buffer.byteLength - offset - 8));
    const kind = view.getUint32(offset + 4, true);
    if (kind === JSON_CHUNK) document.json = JSON.parse(new TextDecoder().decode(chunk));
    if (kind === BINARY_CHUNK) document.binary = chunk;
    offset += 8 + length;
  }
  if (document.json === null) throw new Error('the .glb file holds no description');
  return document;
}

/** The file of a document. */
export function writeGlb({ json, binary }) {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const chunks = [[JSON_CHUNK, text, 0x20]];
  if (binary) chunks.push([BINARY_CHUNK, binary, 0]);
  const padded = (length) => Math.ceil(length / 4) * 4;
  const total = chunks.reduce((sum, [, bytes]) => sum + 8 + padded(bytes.length), 12);
  const file = new Uint8Array(total);
  const view = new DataView(file.buffer);
  [MAGIC, 2, total].forEach((word, index) => view.setUint32(index * 4, word, true));
  let offset = 12;
  for (const [kind, bytes, filling] of chunks) {
    const length = padded(bytes.length);
    view.setUint32(offset, length, true);
    view.setUint32(offset + 4, kind, true);
    file.fill(filling, offset + 8 + bytes.length, offset + 8 + length);
    file.set(bytes, offset + 8);
    offset += 8 + length;
  }
  return file.buffer;
}
