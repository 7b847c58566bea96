//! A format to copy: complete, compiled and tested, but no line of the table. It writes levels as Wavefront OBJ with a file of
//! materials beside it.

use std::fmt::Write;

use glam::{Affine3A, Vec3};

use super::format::{LevelToWrite, Output, OutputFormat, TooLarge, WrittenLevel};
use super::options::LevelOptions;
use crate::catalog::srgb_encoded;
use crate::contract::Extras;
use crate::mesh::Primitive;
use crate::scene::{Node, Scene, SceneMaterial};

/// The line of the table.
const OBJ: OutputFormat = OutputFormat {
    name: "obj",
    about: "A text file of shapes and one of materials",
    extensions: &["obj", "mtl"],
    shows_textures: false,
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
                let _ = writeln!(self.text, "usemtl {}", material_name(&self.scene.materials[material]));
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
        for triangle in primitive.indices.chunks_exact(3) {
            let corners = [0, 1, 2].map(|corner| self.corners + triangle[corner] as usize + 1);
            let _ = writeln!(self.text, "f {} {} {}", corners[0], corners[1], corners[2]);
        }
        self.corners += primitive.positions.len();
    }
}

fn material_name(material: &SceneMaterial) -> &str {
    match material {
        SceneMaterial::Slot { name, .. } => name,
        SceneMaterial::Own(own) => &own.name,
    }
}

/// Colours and opacities of all materials.
fn materials(scene: &Scene) -> String {
    let mut text = String::new();
    for material in &scene.materials {
        let look = match material {
            SceneMaterial::Slot { material, .. } => material,
            SceneMaterial::Own(own) => &own.material,
        };
        let [red, green, blue, opacity] = look.base_color;
        let [red, green, blue] = [red, green, blue].map(|channel| srgb_encoded(f64::from(channel)));
        let _ = writeln!(text, "newmtl {}\nKd {red} {green} {blue}\nd {opacity}", material_name(material));
    }
    text
}

#[test]
fn a_level_is_written_with_all_its_corners_and_materials() {
    let project = crate::Project::read(&["configs/plans/house.yaml"].into_iter().collect()).unwrap();
    let options = LevelOptions {
        textures: super::TextureOptions { size: None, ..Default::default() },
        ..project.level_options()
    };
    let rooms = project.rooms(&options);
    let room = rooms.furnish(&crate::RoomId::new("house", "ground", "living")).unwrap();
    let scene = rooms.scene(&room);
    let level = LevelToWrite { scene: &scene, path: "house/ground" };
    let output = (OBJ.begin)(&project.catalog, &options);
    let written = output.level(&level).unwrap_or_else(|refusal| panic!("{}", refusal.message));
    assert_eq!(written.files.iter().map(|(extension, _)| *extension).collect::<Vec<_>>(), OBJ.extensions);

    let texts: Vec<&str> =
        written.files.iter().map(|(_, bytes)| std::str::from_utf8(bytes).unwrap()).collect();
    let lines = |start: &'static str| texts[0].lines().filter_map(move |line| line.strip_prefix(start));
    let corners = lines("v ").count();
    assert!(corners > 1000, "{corners}");
    assert_eq!(lines("# class ").count(), room.furnished.placements.len());
    assert!(
        lines("f ")
            .flat_map(str::split_whitespace)
            .all(|corner| (1..=corners).contains(&corner.parse().unwrap()))
    );
    assert!(lines("usemtl ").all(|name| texts[1].contains(&format!("newmtl {name}\n"))));
}
