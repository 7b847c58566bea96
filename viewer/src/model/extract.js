// The smallest document with the primitives that are still unknown. A room repeats the furniture and materials of its neighbours;
// parsing only what is new decodes each image and copies each model once.
import { writeGlb } from './glb.js';

/** A .glb file whose scene has one node for each source [mesh, primitive], in this order; `isPlain`: its material is known already. */
export function extract({ json, binary }, wanted) {
  const plain = json.materials?.length ?? 0;
  const meshes = wanted.map(({ source: [mesh, primitive], isPlain }) => {
    const reduced = withoutTangents(json.meshes[mesh].primitives[primitive]);
    return { primitives: [isPlain ? { ...reduced, material: plain } : reduced] };
  });
  const nodes = meshes.map((_, index) => ({ mesh: index }));
  const scenes = [{ nodes: nodes.map((_, index) => index) }];
  const materials = [...json.materials ?? [], { name: 'known' }];
  return writeGlb({ json: { ...json, materials, meshes, nodes, scenes, scene: 0 }, binary });
}

/** The renderer derives tangents from the texture coordinates; to keep them would cost a third of the memory. */
function withoutTangents(primitive) {
  const attributes = { ...primitive.attributes };
  delete attributes.TANGENT;
  return { ...primitive, attributes };
}
