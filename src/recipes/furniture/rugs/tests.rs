//! Rugs as they look from above.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::RUG;
use crate::geometry::Size;
use crate::recipes::{GeometrySet, Mesh, MeshPart, RecipeInput, Slot};

const SIZE: Size = Size { width: 2.4, depth: 1.7, height: 0.012 };

fn rug(geometry: GeometrySet, look: u32, size: Size) -> Mesh {
    RUG.build(&RecipeInput { size, look, geometry, parameters: &[] })
}

/// Every triangle with the number of its material.
fn triangles(model: &Mesh) -> Vec<(usize, [DVec3; 3])> {
    let corner =
        |positions: &[[f32; 3]], index: u32| DVec3::from_array(positions[index as usize].map(f64::from));
    let of_part = |(slot, part): (usize, &MeshPart)| {
        let at = |three: &[u32]| [0, 1, 2].map(|index| corner(&part.positions, three[index]));
        part.indices.chunks_exact(3).map(|three| (slot, at(three))).collect::<Vec<_>>()
    };
    model.parts.iter().enumerate().flat_map(of_part).collect()
}

/// Height of a triangle at a place seen from above.
fn height([a, b, c]: [DVec3; 3], at: DVec2) -> Option<f64> {
    let flat = |point: DVec3| DVec2::new(point.x, point.z);
    let (first, second, to) = (flat(b) - flat(a), flat(c) - flat(a), at - flat(a));
    let area = first.perp_dot(second);
    let (u, v) = (to.perp_dot(second) / area, first.perp_dot(to) / area);
    (area != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0).then_some(a.y + u * (b.y - a.y) + v * (c.y - a.y))
}

/// The materials on top at places spread over a rug, from above; each called by the order in which it is first met, so
/// that equal patterns are equal in any colours. `None` is the floor.
fn pattern(model: &Mesh) -> Vec<Option<usize>> {
    let triangles = triangles(model);
    let mut met: Vec<usize> = Vec::new();
    let (columns, rows) = (50, 36);
    let place = |index: usize| {
        let share = DVec2::new((index % columns) as f64 + 0.47, (index / columns) as f64 + 0.53);
        (share / DVec2::new(columns as f64, rows as f64) - 0.5) * DVec2::new(SIZE.width, SIZE.depth)
    };
    let on_top = |index: usize| {
        let here =
            triangles.iter().filter_map(|&(slot, corners)| Some((height(corners, place(index))?, slot)));
        here.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, slot)| slot)
    };
    let mut name = |slot: usize| {
        let known = met.iter().position(|&other| other == slot);
        known.unwrap_or_else(|| {
            met.push(slot);
            met.len() - 1
        })
    };
    (0..columns * rows).map(on_top).map(|top| top.map(&mut name)).collect()
}

#[test]
fn no_two_sets_or_looks_have_one_pattern() {
    let mut patterns: Vec<(String, Vec<Option<usize>>)> = Vec::new();
    for set in GeometrySet::ALL {
        patterns.extend((0..4).map(|look| (format!("{set} {look}"), pattern(&rug(set, look, SIZE)))));
    }
    for (index, (name, places)) in patterns.iter().enumerate() {
        for (other, others) in &patterns[..index] {
            let differing = places.iter().zip(others).filter(|(a, b)| a != b).count();
            let share = differing as f64 / places.len() as f64;
            assert!(share > 0.03, "{name} and {other} differ in {share} of their places");
        }
    }
}

#[test]
fn two_materials_at_least_show_from_above() {
    for (set, look) in GeometrySet::ALL.into_iter().flat_map(|set| (0..4).map(move |look| (set, look))) {
        let places = pattern(&rug(set, look, SIZE));
        let share =
            |slot| places.iter().filter(|&&top| top == Some(slot)).count() as f64 / places.len() as f64;
        let shown = (0..5).filter(|&slot| share(slot) > 0.03).count();
        assert!(shown >= 2, "{set} {look}: only {shown} with over 3 % of the places");
    }
}

#[test]
fn only_traditional_rugs_have_fringes_and_only_at_their_short_ends() {
    let across = Size { width: SIZE.depth, depth: SIZE.width, height: SIZE.height };
    for (size, axis, half) in [(SIZE, 0, SIZE.width / 2.0), (across, 2, across.depth / 2.0)] {
        for look in 0..4 {
            let model = rug(GeometrySet::Traditional, look, size);
            let linen = model.parts.iter().find(|part| part.slot == Slot::Linen);
            let ends: BTreeSet<bool> = linen
                .unwrap()
                .positions
                .iter()
                .map(|position| {
                    assert!(half - f64::from(position[axis]).abs() < 0.08, "{look}: {position:?}");
                    position[axis] > 0.0
                })
                .collect();
            assert_eq!(ends.len(), 2, "{look}");
        }
    }
    for set in [GeometrySet::Budget, GeometrySet::Industrial, GeometrySet::Plain] {
        let has_fringes = |part: &MeshPart| part.slot == Slot::Linen;
        assert!(!(0..4).any(|look| rug(set, look, SIZE).parts.iter().any(has_fringes)), "{set}");
    }
}

/// Whether anything lies at the corner of the box.
fn fills_its_corner(set: GeometrySet, look: u32) -> bool {
    let corner = DVec2::new(SIZE.width / 2.0 - 0.004, SIZE.depth / 2.0 - 0.004);
    triangles(&rug(set, look, SIZE)).into_iter().any(|(_, corners)| height(corners, corner).is_some())
}

#[test]
fn only_plain_rugs_are_rectangles_in_all_looks() {
    let looks = |set: GeometrySet| [0, 1, 2, 3].map(|look| fills_its_corner(set, look));
    assert_eq!(looks(GeometrySet::Plain), [true; 4]);
    // Round corners, and fringes that begin beside them.
    assert_eq!(looks(GeometrySet::Budget), [false; 4]);
    assert_eq!(looks(GeometrySet::Traditional), [false; 4]);
    // The strips of the first look alone begin with a long one.
    assert_eq!(looks(GeometrySet::Industrial), [true, false, false, false]);
}

#[test]
fn rugs_have_600_triangles_at_most() {
    let sizes = [[3.0, 2.4], [3.0, 2.0], [2.4, 1.7], [2.0, 1.4], [1.6, 1.1], [1.2, 2.4]];
    for (set, look) in GeometrySet::ALL.into_iter().flat_map(|set| (0..8).map(move |look| (set, look))) {
        for [width, depth] in sizes {
            let count = triangles(&rug(set, look, Size { width, depth, height: 0.012 })).len();
            assert!(count <= 600, "{set} {look} {width} x {depth}: {count}");
        }
    }
}
