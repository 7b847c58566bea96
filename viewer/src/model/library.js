// Models and materials by the keys of `tree.js`: each is parsed once, whichever room brings it first.
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { extract } from './extract.js';
import { textureKeys } from './tree.js';

const TEXTURE_SLOTS = ['map', 'normalMap', 'roughnessMap', 'metalnessMap', 'aoMap', 'emissiveMap'];

export class Library {
  /** `section` cuts the shell of rooms; `locate` gives the address of a file that rooms share. */
  constructor(batches, section, anisotropy, locate) {
    this.batches = batches;
    this.section = section;
    this.locate = locate;
    this.anisotropy = anisotropy;
    this.loader = new GLTFLoader();
    /** By key: {texture, uses}. */
    this.textures = new Map();
  }

  /** Makes the primitives of a document known. Rejects if the file or a file that it shares cannot be read. */
  async load(document, primitives) {
    const missing = new Map();
    for (const primitive of primitives) {
      if (!this.batches.has(primitive.key)) missing.set(primitive.key, primitive);
    }
    if (missing.size === 0) return;
    const wanted = [...missing.values()];
    const sources = wanted.map(({ source, material }) => ({ source, isPlain: this.batches.hasMaterial(material) }));
    const file = await extract(document, sources, this.locate);
    const textures = textureKeys(document);
    const { scene, parser } = await this.loader.parseAsync(file, '');
    // What is not adopted was never drawn: it holds nothing of the graphics card.
    wanted.forEach(({ key, material, isShell }, index) => {
      const mesh = firstMesh(scene.children[index]);
      const own = (shared) => isShell ? this.section.cut(shared.clone()) : shared;
      this.batches.addGeometry(key, material, () => this.adopt(own(mesh.material), parser, textures), mesh.geometry);
    });
  }

  /** The material with the textures that are there already. */
  adopt(material, parser, textures) {
    const keys = [];
    for (const slot of TEXTURE_SLOTS.filter((name) => material[name])) {
      const index = parser.associations.get(material[slot])?.textures;
      const key = `${slot === 'map' || slot === 'emissiveMap' ? 'colour' : 'data'} ${textures[index]}`;
      const known = this.textures.get(key) ?? { texture: material[slot], uses: 0 };
      known.uses += 1;
      known.texture.anisotropy = this.anisotropy;
      this.textures.set(key, known);
      material[slot] = known.texture;
      keys.push(key);
    }
    return { material, release: () => this.release(material, keys) };
  }

  release(material, keys) {
    material.dispose();
    for (const key of keys) {
      const known = this.textures.get(key);
      known.uses -= 1;
      if (known.uses > 0) continue;
      known.texture.dispose();
      this.textures.delete(key);
    }
  }
}

function firstMesh(object) {
  let found = null;
  object.traverse((child) => { found ??= child.isMesh ? child : null; });
  return found;
}
