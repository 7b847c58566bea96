//! A format to copy: complete, compiled and tested, but no line of the table. It writes levels as Wavefront OBJ with a file of
//! materials beside it.

use std::fmt::Write;

use glam::{Affine3A, Vec3};

use crate::catalog::srgb_encoded;
use crate::contract::Extras;
use crate::mesh::Primitive;
use crate::output::{LevelOptions, LevelToWrite, Output, OutputFormat, TooLarge, WrittenLevel};
use crate::scene::{Node, Scene, SceneMaterial};

/// The line of the table.
const OBJ: OutputFormat = OutputFormat {
    name: "obj",
    about: "A text file of shapes and one of materials",
    extensions: &["obj", "mtl"],
    shows_textures: false,
    shares_all_images: false,
    has_index: false,
    is_read_back: false,
    begin: |_, options| Box::new(ObjOutput { options }),
};

/// The format in a run. Levels are written by many threads: what they share is behind a lock, and no file depends on their order.
struct ObjOutput<'a> {
    options: &'a LevelOptions,
}

impl Output for ObjOutput<'_> {
    fn level<'s>(&'s self, level: &LevelToWrite<'s>) -> Result<WrittenLevel<'s>, TooLarge> {
        let name = level.path.rsplit('/').next().unwrap_or(level.path);
        let mut shapes = Shapes { scene: level.scene, text: String::new(), corners: 0 };
        let _ = writeln!(shapes.text, "# seed {}\nmtllib {name}.mtl", self.options.seed);
        shapes.node(&level.scene.root, Affine3A::IDENTITY);
        let files = vec![("obj", shapes.text.into_bytes()), ("mtl", materials(level.scene).into_bytes())];
        // Images and geometry that several levels refer to would go into `shared`.
        Ok(WrittenLevel { files, ..WrittenLevel::default() })
    }
}

/// The text of a level so far.
struct Shapes<'s> {
    scene: &'s Scene,
    text: String,
    /// OBJ numbers corners over the whole file, from 1.
    corners: usize,
}

impl Shapes<'_> {
    /// A node and all below it. `parent` is the frame of the node that it is placed in.
    fn node(&mut self, node: &Node, parent: Affine3A) {
        let frame = parent * Affine3A::from_rotation_translation(node.rotation, node.translation);
        if let Some(mesh) = node.mesh.map(|mesh| &self.scene.meshes[mesh]) {
            let _ = writeln!(self.text, "o {}", node.name);
            if let Some(Extras::Furniture(facts)) = &node.extras {
                let _ = writeln!(self.text, "# class {}", facts.class);
            }
            for (primitive, &material) in mesh.model.primitives.iter().zip(&mesh.materials) {
                let _ = writeln!(self.text, "usemtl {}", material_name(self.scene, material));
                self.primitive(primitive, frame);
            }
        }
        node.children.iter().for_each(|child| self.node(child, frame));
    }

    fn primitive(&mut self, primitive: &Primitive, frame: Affine3A) {
        for &corner in &primitive.positions {
            let Vec3 { x, y, z } = frame.transform_point3(corner.into());
            let _ = writeln!(self.text, "v {x} {y} {z}");
        }
        // As many as corners, so that one number serves for both.
        for &normal in &primitive.normals {
            let Vec3 { x, y, z } = frame.transform_vector3(normal.into());
            let _ = writeln!(self.text, "vn {x} {y} {z}");
        }
        for triangle in primitive.indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|corner| self.corners + triangle[corner] as usize + 1);
            let _ = writeln!(self.text, "f {a}//{a} {b}//{b} {c}//{c}");
        }
        self.corners += primitive.positions.len();
    }
}

/// The name of a material in both files. Its index makes it unique, for materials of users' models may share a name; spaces
/// would end it.
fn material_name(scene: &Scene, index: usize) -> String {
    let name = match &scene.materials[index] {
        SceneMaterial::Slot { name, .. } => name,
        SceneMaterial::Own(own) => &own.name,
    };
    format!("{index}_{}", name.replace(char::is_whitespace, "_"))
}

/// Colours and opacities of all materials.
fn materials(scene: &Scene) -> String {
    let mut text = String::new();
    for (index, material) in scene.materials.iter().enumerate() {
        let look = match material {
            SceneMaterial::Slot { material, .. } => material,
            SceneMaterial::Own(own) => &own.material,
        };
        let [red, green, blue, alpha] = look.base_color;
        let [red, green, blue] = [red, green, blue].map(|channel| srgb_encoded(f64::from(channel)));
        // OBJ knows no light that passes through: clear glass is as transparent as it lets light pass.
        let opacity = alpha * (1.0 - look.transmission);
        let name = material_name(scene, index);
        let _ = writeln!(text, "newmtl {name}\nKd {red} {green} {blue}\nd {opacity}");
    }
    text
}

#[test]
fn a_level_is_written_with_all_its_corners_and_materials() {
    let project = crate::Project::read(&["configs/plans/house.yaml"].into_iter().collect()).unwrap();
    let options = LevelOptions {
        textures: crate::output::TextureOptions { size: None, ..Default::default() },
        ..project.level_options()
    };
    let rooms = project.rooms(&options);
    let room = rooms.furnish(&"house/ground/living".parse().unwrap()).unwrap();
    let scene = rooms.scene(&room);
    let shown = |_| scene.clone();
    let level = LevelToWrite { scene: &scene, path: "house/ground", shown: &shown };
    let output = (OBJ.begin)(&project.catalog, &options);
    let written = output.level(&level).unwrap_or_else(|refusal| panic!("{}", refusal.message));
    assert_eq!(written.files.iter().map(|(extension, _)| *extension).collect::<Vec<_>>(), OBJ.extensions);

    let texts: Vec<&str> =
        written.files.iter().map(|(_, bytes)| std::str::from_utf8(bytes).unwrap()).collect();
    let lines = |start: &'static str| texts[0].lines().filter_map(move |line| line.strip_prefix(start));
    let corners = lines("v ").count();
    assert!(corners > 1000, "{corners}");
    assert_eq!(lines("vn ").count(), corners);
    assert_eq!(lines("# class ").count(), room.furnished.placements.len());
    assert!(
        lines("f ")
            .flat_map(|face| face.split([' ', '/']).filter(|number| !number.is_empty()))
            .all(|corner| (1..=corners).contains(&corner.parse().unwrap()))
    );
    let named: Vec<&str> = texts[1].lines().filter_map(|line| line.strip_prefix("newmtl ")).collect();
    assert!(lines("usemtl ").all(|name| named.contains(&name) && !name.contains(' ')));
    assert_eq!(std::collections::BTreeSet::from_iter(&named).len(), scene.materials.len());
}
