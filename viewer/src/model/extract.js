// The smallest document with the primitives that are still unknown. A room repeats the furniture and materials of its neighbours;
// parsing only what is new decodes each image and copies each model once.
import { writeGlb } from './glb.js';

/**
 * A document whose scene has one node for each source [mesh, primitive], in this order; `isPlain`: its material is known already.
 * `locate` gives the address of a file beside the document.
 */
export async function extract(document, wanted, locate) {
  const { json, binary } = document;
  const plain = json.materials?.length ?? 0;
  const meshes = wanted.map(({ source: [mesh, primitive], isPlain }) => {
    const reduced = withoutTangents(json.meshes[mesh].primitives[primitive]);
    return { primitives: [isPlain ? { ...reduced, material: plain } : reduced] };
  });
  const nodes = meshes.map((_, index) => ({ mesh: index }));
  const scenes = [{ nodes: nodes.map((_, index) => index) }];
  const materials = [...json.materials ?? [], { name: 'known' }];
  const reduced = { ...json, materials, meshes, nodes, scenes, scene: 0 };
  return writeGlb({ json: await located(reduced, locate), binary });
}

/** The renderer derives tangents from the texture coordinates; to keep them would cost a third of the memory. */
function withoutTangents(primitive) {
  const attributes = { ...primitive.attributes };
  delete attributes.TANGENT;
  return { ...primitive, attributes };
}

/** The document with the addresses of the files that its meshes need. */
async function located(json, locate) {
  const primitives = json.meshes.flatMap((mesh) => mesh.primitives);
  const accessors = primitives.flatMap(({ attributes, indices }) => [...Object.values(attributes), indices ?? []].flat());
  const buffers = new Set(accessors.map((accessor) => json.bufferViews[json.accessors[accessor].bufferView].buffer));
  const textures = new Set(primitives.flatMap(({ material }) => texturesOf(json.materials[material])));
  const images = new Set([...textures].map((texture) => json.textures[texture].source));
  const withAddress = (needed) => (file, index) => file.uri && needed.has(index)
    ? locate(file.uri).then((uri) => ({ ...file, uri })) : file;
  return {
    ...json,
    buffers: await Promise.all((json.buffers ?? []).map(withAddress(buffers))),
    images: await Promise.all((json.images ?? []).map(withAddress(images))),
  };
}

/** The textures of a material, wherever in it they are named. */
function texturesOf(material) {
  const textures = [];
  JSON.stringify(material ?? null, (name, value) => {
    if (name.endsWith('Texture') && typeof value?.index === 'number') textures.push(value.index);
    return value;
  });
  return textures;
}
