//! Turns the nodes and meshes of a document into triangles in one frame.

use std::collections::BTreeMap;

use glam::{DMat3, DMat4, DQuat, DVec3, Vec3};
use gltf::json::mesh::{Mode, Primitive as JsonPrimitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root, accessor, scene};

use super::accessor::Numbers;
use super::laying::Laying;
use super::material::ReadMaterial;
use super::problem::Problem;
use crate::mesh::{Model, ModelMaterial, Primitive};

/// The most triangles of one model. A piece stands in thousands of rooms; more than this belongs into a renderer's
/// close-up, not into a city.
pub(super) const MOST_TRIANGLES: usize = 200_000;

/// Units from the origin that no model reaches, whatever its unit; beyond it single precision has no detail left.
const FARTHEST: f64 = 1e6;

/// The colour that changes nothing.
const WHITE: [f32; 4] = [1.0; 4];

/// All triangles of the default scene, by material, turned about the y axis.
pub(super) fn read_geometry(
    numbers: &Numbers,
    materials: &[ReadMaterial],
    turn: f64,
) -> Result<Model, Problem> {
    let mut gathered = Gathered::new(*numbers, materials);
    let mut is_visited = vec![false; numbers.document.nodes.len()];
    let start = DMat4::from_rotation_y(turn);
    let mut open: Vec<(Index<scene::Node>, DMat4)> =
        roots(numbers.document).map(|node| (node, start)).collect();
    while let Some((index, parent)) = open.pop() {
        let Some(node) = numbers.document.get(index) else { continue };
        if std::mem::replace(&mut is_visited[index.value()], true) {
            return Err(Problem::new(format!("node {} is reached twice", index.value())));
        }
        let place = parent * transform(node);
        if let Some(mesh) = node.mesh.and_then(|mesh| numbers.document.get(mesh)) {
            mesh.primitives.iter().try_for_each(|part| gathered.add(part, place))?;
        }
        open.extend(node.children.iter().flatten().map(|&child| (child, place)));
    }
    gathered.into_model()
}

/// The roots of the default scene, or of the first, or all nodes that are no child.
pub(super) fn roots(document: &Root) -> impl Iterator<Item = Index<scene::Node>> {
    let scene = document.scene.and_then(|scene| document.get(scene)).or(document.scenes.first());
    let nodes = scene.map(|scene| scene.nodes.clone()).unwrap_or_else(|| {
        let children: Vec<usize> =
            document.nodes.iter().flat_map(|node| node.children.iter().flatten()).map(Index::value).collect();
        let count = u32::try_from(document.nodes.len()).unwrap_or(u32::MAX);
        (0..count).filter(|&index| !children.contains(&(index as usize))).map(Index::new).collect()
    });
    nodes.into_iter()
}

pub(super) fn transform(node: &scene::Node) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix.map(f64::from));
    }
    let vector = |values: Option<[f32; 3]>, default: f64| {
        values.map_or(DVec3::splat(default), |v| Vec3::from(v).as_dvec3())
    };
    let [x, y, z, w] = node.rotation.map_or([0.0, 0.0, 0.0, 1.0], |rotation| rotation.0.map(f64::from));
    let rotation = DQuat::from_xyzw(x, y, z, w);
    let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(vector(node.scale, 1.0), rotation, vector(node.translation, 0.0))
}

/// Parts by position of their material; the last material is for parts that name none.
pub(super) struct Gathered<'a> {
    numbers: Numbers<'a>,
    materials: &'a [ReadMaterial],
    parts: BTreeMap<usize, Primitive>,
    triangle_count: usize,
}

/// One primitive as read, in its node's frame.
struct Surface {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// By the laying of the material's images; empty where the file has none.
    coordinates: Vec<Vec<[f32; 2]>>,
    colors: Vec<[f32; 4]>,
    triangles: Vec<[u32; 3]>,
}

impl<'a> Gathered<'a> {
    /// Nothing yet.
    pub(super) fn new(numbers: Numbers<'a>, materials: &'a [ReadMaterial]) -> Self {
        Self { numbers, materials, parts: BTreeMap::new(), triangle_count: 0 }
    }

    /// Adds the triangles of a primitive in their place.
    pub(super) fn add(&mut self, part: &JsonPrimitive, place: DMat4) -> Result<(), Problem> {
        let material = part.material.map_or(self.materials.len() - 1, |material| material.value());
        let Some(surface) = self.surface(part, &self.materials[material].layings)? else {
            return Ok(());
        };
        self.triangle_count += surface.triangles.len();
        if self.triangle_count > MOST_TRIANGLES {
            return Err(Problem::new(format!("has over {MOST_TRIANGLES} triangles"))
                .with_hint("simplify it: gltf-transform simplify IN.glb OUT.glb"));
        }
        let target = self.parts.entry(material).or_insert_with(|| Primitive {
            material: ModelMaterial::Own(self.materials[material].material.clone()),
            ..Primitive::default()
        });
        append(target, &surface, place)
    }

    /// The triangles of a primitive; `None` for points and lines, which furniture can do without.
    fn surface(&self, part: &JsonPrimitive, layings: &[Laying]) -> Result<Option<Surface>, Problem> {
        let Checked::Valid(mode) = part.mode else { return Err(Problem::new("a mesh has an unknown mode")) };
        let attribute = |semantic| part.attributes.get(&Checked::Valid(semantic)).copied();
        let Some(positions) = attribute(Semantic::Positions) else { return Ok(None) };
        let positions = self.read_vectors(positions)?;
        let corner_count = u32::try_from(positions.len()).unwrap_or(u32::MAX);
        let indices = match part.indices {
            Some(indices) => self.numbers.indices(indices)?,
            None => (0..corner_count).collect(),
        };
        if let Some(index) = indices.iter().find(|&&index| index >= corner_count) {
            return Err(Problem::new(format!("a mesh names corner {index} of {corner_count}")));
        }
        let Some(triangles) = triangles(mode, &indices) else { return Ok(None) };
        let normals =
            attribute(Semantic::Normals).map_or(Ok(Vec::new()), |normals| self.read_vectors(normals))?;
        let coordinates = self.coordinates(part, layings, positions.len())?;
        let colors =
            attribute(Semantic::Colors(0)).map_or(Ok(Vec::new()), |colors| self.read_colors(colors))?;
        let counts = [("normals", normals.len()), ("colours", colors.len())];
        for (name, count) in counts {
            if count != 0 {
                check_count(name, count, positions.len())?;
            }
        }
        Ok(Some(Surface { positions, normals, coordinates, colors, triangles }))
    }

    /// Texture coordinates by laying, transformed; none where the file has none for any of them.
    fn coordinates(
        &self,
        part: &JsonPrimitive,
        layings: &[Laying],
        corner_count: usize,
    ) -> Result<Vec<Vec<[f32; 2]>>, Problem> {
        let attribute =
            |laying: &Laying| part.attributes.get(&Checked::Valid(Semantic::TexCoords(laying.set)));
        if layings.iter().all(|laying| attribute(laying).is_none()) {
            return Ok(Vec::new());
        }
        let of_laying = |laying: &Laying| {
            let Some(&accessor) = attribute(laying) else { return Ok(vec![[0.0; 2]; corner_count]) };
            let coordinates = self.numbers.vectors::<2>(accessor)?;
            check_count("texture coordinates", coordinates.len(), corner_count)?;
            let laid: Option<Vec<_>> = coordinates.into_iter().map(|place| laying.apply(place)).collect();
            laid.ok_or_else(|| Problem::new("an image's transform leads out of all bounds"))
        };
        layings.iter().map(of_laying).collect()
    }

    fn read_vectors(&self, accessor: Index<accessor::Accessor>) -> Result<Vec<DVec3>, Problem> {
        let vectors = self.numbers.vectors::<3>(accessor)?;
        Ok(vectors.into_iter().map(|vector| Vec3::from(vector).as_dvec3()).collect())
    }

    /// Colours with or without opacity; values outside 0 to 1 are clamped, as the format asks of viewers.
    fn read_colors(&self, accessor: Index<accessor::Accessor>) -> Result<Vec<[f32; 4]>, Problem> {
        let is_opaque = self
            .numbers
            .document
            .get(accessor)
            .is_some_and(|accessor| accessor.type_ == Checked::Valid(accessor::Type::Vec3));
        let colors = if is_opaque {
            let colors = self.numbers.vectors::<3>(accessor)?;
            colors.into_iter().map(|[red, green, blue]| [red, green, blue, 1.0]).collect()
        } else {
            self.numbers.vectors::<4>(accessor)?
        };
        Ok(colors.into_iter().map(|color| color.map(|share| share.clamp(0.0, 1.0))).collect())
    }

    /// What was added.
    pub(super) fn into_model(self) -> Result<Model, Problem> {
        let mut primitives: Vec<Primitive> =
            self.parts.into_values().filter(|part| !part.indices.is_empty()).collect();
        for part in &mut primitives {
            // Coordinates for some corners only: the rest take the image's corner; colours likewise.
            let corner_count = part.positions.len();
            for set in coordinate_sets(part).filter(|set| !set.is_empty()) {
                set.resize(corner_count, [0.0; 2]);
            }
            if !part.colors.is_empty() {
                part.colors.resize(part.positions.len(), WHITE);
            }
        }
        if primitives.is_empty() {
            return Err(Problem::new("has no triangles in its default scene"));
        }
        Ok(Model { primitives })
    }
}

/// All sets of texture coordinates of a primitive, in their order.
fn coordinate_sets(part: &mut Primitive) -> impl Iterator<Item = &mut Vec<[f32; 2]>> {
    std::iter::once(&mut part.texture_coordinates).chain(&mut part.further_coordinates)
}

fn check_count(name: &str, count: usize, corner_count: usize) -> Result<(), Problem> {
    match count == corner_count {
        true => Ok(()),
        false => Err(Problem::new(format!("a mesh has {corner_count} positions but {count} {name}"))),
    }
}

/// Strips and fans to triangles; those with a repeated corner are dropped.
fn triangles(mode: Mode, indices: &[u32]) -> Option<Vec<[u32; 3]>> {
    let triangles: Vec<[u32; 3]> = match mode {
        Mode::Triangles => {
            indices.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]).collect()
        }
        Mode::TriangleStrip => {
            let windows = indices.windows(3).enumerate();
            windows
                .map(|(step, w)| if step % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] })
                .collect()
        }
        Mode::TriangleFan => {
            indices.get(1..)?.windows(2).map(|pair| [indices[0], pair[0], pair[1]]).collect()
        }
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => return None,
    };
    let is_real = |[a, b, c]: &[u32; 3]| a != b && b != c && a != c;
    Some(triangles.into_iter().filter(is_real).collect())
}

/// Adds a surface in its place. Surfaces without usable normals get flat ones, as the format asks. Corners that no
/// triangle uses are dropped, so that the positions span what is seen.
fn append(target: &mut Primitive, surface: &Surface, place: DMat4) -> Result<(), Problem> {
    let linear = DMat3::from_mat4(place);
    let is_mirrored = linear.determinant() < 0.0;
    let positions: Vec<DVec3> =
        surface.positions.iter().map(|&position| place.transform_point3(position)).collect();
    if !positions.iter().all(|position| position.abs().max_element() <= FARTHEST) {
        return Err(Problem::new("a node's transform leads out of all bounds"));
    }
    let normals = placed_normals(&surface.normals, linear, is_mirrored);
    let mut kept: Vec<Option<u32>> = vec![None; positions.len()];
    for &[a, b, c] in &surface.triangles {
        let corners = if is_mirrored { [a, c, b] } else { [a, b, c] }.map(|corner| corner as usize);
        let [p, q, r] = corners.map(|corner| positions[corner]);
        let Some(face) = (q - p).cross(r - p).try_normalize() else { continue };
        for corner in corners {
            let known = kept[corner].filter(|_| normals.is_some());
            let index = known.unwrap_or_else(|| {
                let normal = normals.as_ref().map_or(face, |normals| normals[corner]);
                push_corner(target, positions[corner], normal, surface, corner)
            });
            kept[corner] = Some(index);
            target.indices.push(index);
        }
    }
    Ok(())
}

/// Unit normals under a linear map; `None` where there are none or one has no direction.
fn placed_normals(normals: &[DVec3], linear: DMat3, is_mirrored: bool) -> Option<Vec<DVec3>> {
    // The cofactor matrix is the inverse transposed, but also right where a scale is zero.
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let cofactors =
        DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * if is_mirrored { -1.0 } else { 1.0 };
    let placed: Option<Vec<DVec3>> =
        normals.iter().map(|&normal| (cofactors * normal).try_normalize()).collect();
    placed.filter(|placed| !placed.is_empty())
}

/// Adds a placed corner with the rest as the surface has it.
fn push_corner(
    target: &mut Primitive,
    position: DVec3,
    normal: DVec3,
    surface: &Surface,
    corner: usize,
) -> u32 {
    let corner_count = target.positions.len();
    target.further_coordinates.resize(
        surface.coordinates.len().saturating_sub(1).max(target.further_coordinates.len()),
        Vec::new(),
    );
    for (set, coordinates) in coordinate_sets(target).zip(&surface.coordinates) {
        set.resize(corner_count, [0.0; 2]);
        set.push(coordinates[corner]);
    }
    if let Some(&color) = surface.colors.get(corner) {
        target.colors.resize(target.positions.len(), WHITE);
        target.colors.push(color);
    }
    target.positions.push(position.as_vec3().to_array());
    target.normals.push(normal.as_vec3().normalize().to_array());
    u32::try_from(target.positions.len() - 1).expect("the limit of triangles keeps corners far below")
}
