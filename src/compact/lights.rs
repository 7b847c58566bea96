//! Which lamps are lights of a file: browsers draw few, and each costs them in every pixel.

use std::collections::BTreeSet;

use crate::contract::{Corner, Extras};
use crate::geometry::{Point, signed_area};
use crate::scene::{Node, Scene};

/// The most lights of a file.
const MOST_LIGHTS: usize = 8;

/// The numbers of the nodes, parents first, whose lights stay: the strongest of a room, those of the largest rooms.
pub(super) fn kept(scene: &Scene) -> BTreeSet<usize> {
    let mut rooms: Vec<(f64, Option<(f32, usize)>)> = Vec::new();
    let mut count = 0;
    visit(scene, &scene.root, &mut count, &mut rooms);
    let mut lit: Vec<(f64, usize)> =
        rooms.into_iter().filter_map(|(area, strongest)| Some((area, strongest?.1))).collect();
    lit.sort_by(|(one, first), (other, second)| other.total_cmp(one).then(first.cmp(second)));
    lit.into_iter().take(MOST_LIGHTS).map(|(_, node)| node).collect()
}

fn visit(scene: &Scene, node: &Node, count: &mut usize, rooms: &mut Vec<(f64, Option<(f32, usize)>)>) {
    let number = *count;
    *count += 1;
    if let Some(Extras::Room(room)) = &node.extras {
        rooms.push((area(&room.outline), None));
    }
    if let (Some(light), Some((_, strongest))) = (node.light, rooms.last_mut()) {
        let intensity = scene.lights[light].intensity;
        if strongest.is_none_or(|(most, _)| intensity > most) {
            *strongest = Some((intensity, number));
        }
    }
    node.children.iter().for_each(|child| visit(scene, child, count, rooms));
}

/// Square metres within an outline.
fn area(outline: &[Corner]) -> f64 {
    let corners: Vec<Point> = outline.iter().copied().map(Point::from).collect();
    signed_area(&corners).abs()
}
