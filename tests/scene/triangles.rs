//! Triangles of a scene in the level's frame.

use glam::{DVec3, Quat, Vec3};
use roomwright::internals::contract::Extras;
use roomwright::internals::scene::{Node, Scene};

/// The triangles that a node shows.
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) part: Option<&'static str>,
    pub(crate) triangles: Vec<[DVec3; 3]>,
}

pub(crate) fn bodies(scene: &Scene) -> Vec<Body> {
    let mut found = Vec::new();
    collect(scene, &scene.root, (Vec3::ZERO, Quat::IDENTITY), &mut found);
    found
}

fn collect(scene: &Scene, node: &Node, origin: (Vec3, Quat), found: &mut Vec<Body>) {
    let (position, rotation) = (origin.0 + origin.1 * node.translation, origin.1 * node.rotation);
    if let Some(mesh) = node.mesh {
        let mut triangles = Vec::new();
        for primitive in &scene.meshes[mesh].model.primitives {
            let place = |&index: &u32| {
                let corner = Vec3::from_array(primitive.positions[index as usize]);
                position.as_dvec3() + rotation.as_dquat() * corner.as_dvec3()
            };
            triangles.extend(primitive.indices.chunks(3).map(|corners| {
                let [a, b, c] = corners else { panic!("three indices per triangle") };
                [place(a), place(b), place(c)]
            }));
        }
        let part = match &node.extras {
            Some(Extras::Part(part)) => Some(part.part.name()),
            _ => None,
        };
        found.push(Body { name: node.name.clone(), part, triangles });
    }
    for child in &node.children {
        collect(scene, child, (position, rotation), found);
    }
}

/// Distance along a ray to the nearest triangle and whether its front was hit (Möller, Trumbore, 1997).
pub(crate) fn nearest<'t>(
    triangles: impl Iterator<Item = &'t [DVec3; 3]>,
    origin: DVec3,
    direction: DVec3,
) -> Option<(f64, bool)> {
    triangles.filter_map(|triangle| hit(triangle, origin, direction)).min_by(|a, b| a.0.total_cmp(&b.0))
}

fn hit([a, b, c]: &[DVec3; 3], origin: DVec3, direction: DVec3) -> Option<(f64, bool)> {
    let (first, second) = (*b - *a, *c - *a);
    let across = direction.cross(second);
    let determinant = first.dot(across);
    if determinant.abs() < 1e-14 {
        return None;
    }
    let offset = origin - *a;
    let u = offset.dot(across) / determinant;
    let other = offset.cross(first);
    let v = direction.dot(other) / determinant;
    let distance = second.dot(other) / determinant;
    let slack = 1e-9;
    (u >= -slack && v >= -slack && u + v <= 1.0 + slack && distance > 0.0)
        .then_some((distance, determinant > 0.0))
}

/// Evenly spread unit vectors (a Fibonacci sphere).
pub(crate) fn directions(count: u32) -> impl Iterator<Item = DVec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |index| {
        let y = 1.0 - 2.0 * (f64::from(index) + 0.5) / f64::from(count);
        let (sine, cosine) = libm::sincos(golden * f64::from(index));
        let radius = (1.0 - y * y).sqrt();
        DVec3::new(radius * cosine, y, radius * sine)
    })
}
