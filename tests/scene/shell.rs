//! The shell is closed, faces outward, and is open at its openings only.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use roomwright::internals::catalog::{Catalog, Dado, FittedPart};
use roomwright::internals::geometry::{Bounds, Point};
use roomwright::internals::layout::{Parent, Placement};
use roomwright::internals::model::{Model, ModelMaterial, Primitive};
use roomwright::internals::plan::{Level, Opening, OpeningKind, Room, RoomOpening, WallKind};
use roomwright::internals::recipes::Slot;
use roomwright::internals::scene::Scene;

use crate::fixture::*;
use crate::levels;
use crate::triangles::{Body, bodies, directions, nearest};

/// Directed edges that are not met by one in the opposite direction.
fn open_edges(model: &Model) -> usize {
    let mut balance: BTreeMap<([u32; 3], [u32; 3]), i32> = BTreeMap::new();
    let corner = |primitive: &Primitive, index: u32| {
        primitive.positions[index as usize].map(|value| (value + 0.0).to_bits())
    };
    let triangles = model.primitives.iter().flat_map(|primitive| {
        primitive
            .indices
            .chunks(3)
            .map(move |triangle| [0, 1, 2].map(|side| corner(primitive, triangle[side])))
    });
    for triangle in triangles {
        for side in 0..3 {
            let (a, b) = (triangle[side], triangle[(side + 1) % 3]);
            let (key, step) = if a < b { ((a, b), 1) } else { ((b, a), -1) };
            *balance.entry(key).or_default() += step;
        }
    }
    balance.values().filter(|count| **count != 0).count()
}

fn volume(triangles: &[[DVec3; 3]]) -> f64 {
    triangles.iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum()
}

#[test]
fn every_body_is_closed_with_positive_volume() {
    for (name, level) in levels::all() {
        let scene = bare_scene(&level);
        for mesh in &scene.meshes {
            assert_eq!(open_edges(&mesh.model), 0, "{name}: {} has open edges", mesh.name);
        }
        for body in bodies(&scene) {
            assert!(volume(&body.triangles) > 0.0, "{name}: {} is inside out", body.name);
        }
    }
}

#[test]
fn triangles_have_area_and_normals_that_agree_with_their_winding() {
    for (name, level) in levels::all() {
        for mesh in &bare_scene(&level).meshes {
            for primitive in &mesh.model.primitives {
                check_triangles(primitive, &format!("{name}: {}", mesh.name));
            }
        }
    }
}

fn check_triangles(primitive: &Primitive, what: &str) {
    assert_eq!(primitive.positions.len(), primitive.normals.len());
    assert!(primitive.positions.iter().flatten().all(|value| value.is_finite()), "{what}");
    for triangle in primitive.indices.chunks(3) {
        let corner = |side: usize| Vec3::from_array(primitive.positions[triangle[side] as usize]).as_dvec3();
        let across = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        assert!(across.length() > 1e-10, "{what} has a triangle without area");
        let normal = Vec3::from_array(primitive.normals[triangle[0] as usize]);
        assert!((normal.length() - 1.0).abs() < 1e-5, "{what}");
        assert!(across.normalize().dot(normal.as_dvec3()) > 0.999, "{what} is lit from the wrong side");
    }
}

#[test]
fn a_wall_holds_its_volume_less_its_openings() {
    let level = two_rooms();
    let bodies = bodies(&bare_scene(&level));
    let volume_of = |name: &str| volume(&bodies.iter().find(|body| body.name == name).unwrap().triangles);
    // As high as the storey, from 1.9 cm below the floor on. Wall 0 of 101: 4 m long, 0.3 m thick,
    // its outer face reaching round one corner by 0.3 m and round the other by half the inner wall.
    let height = level.height;
    let footprint = 0.3 * (4.0 + (4.0 + 0.3 + INNER)) / 2.0;
    let door = 1.0 * 0.3 * (2.1 + 0.019);
    assert!((volume_of("wall.0@101") - (footprint * height - door)).abs() < 1e-4);
    let footprint = INNER * (3.0 + 3.0 + 2.0 * OUTER) / 2.0;
    let door = 0.9 * INNER * (2.1 + 0.019);
    assert!((volume_of("wall.1@101") - (footprint * height - door)).abs() < 1e-4);
}

/// What a ray from inside a room should meet.
#[derive(Debug)]
enum Expected {
    /// The room's surface at this distance.
    Surface(f64),
    /// An opening, or too near an edge to say.
    Open,
}

/// Nearer than this to the edge of an opening, or to a corner of the room, a ray may go either way.
const MARGIN: f64 = 1e-3;

fn expected(level: &Level, room: &Room, origin: DVec3, direction: DVec3) -> Expected {
    let vertical = match direction.y {
        y if y > 0.0 => (room.height - origin.y) / y,
        y => -origin.y / y,
    };
    let (from, along) = (Point::new(origin.x, -origin.z), Point::new(direction.x, -direction.z));
    let walls = room.walls.iter().enumerate().filter_map(|(index, wall)| {
        let edge = wall.end - wall.start;
        let determinant = along.perp_dot(edge);
        let distance = (wall.start - from).perp_dot(edge) / determinant;
        let share = (wall.start - from).perp_dot(along) / determinant;
        let is_met = determinant > 0.0 && distance > 0.0 && (-1e-9..=1.0 + 1e-9).contains(&share);
        is_met.then_some((distance, index, share * wall.length()))
    });
    let Some((distance, wall, at)) = walls.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return Expected::Surface(vertical);
    };
    if vertical < distance {
        return Expected::Surface(vertical);
    }
    let height = origin.y + direction.y * distance;
    if let WallKind::Railing(_) = room.walls[wall].kind {
        return Expected::Open;
    }
    let is_open = room.openings.iter().filter(|place| place.wall == wall).any(|place| {
        let opening = &level.openings[place.opening];
        let top = if opening.kind == OpeningKind::OpenBoundary { f64::INFINITY } else { opening.top };
        (place.from - MARGIN..place.to + MARGIN).contains(&at)
            && (opening.bottom - MARGIN..top + MARGIN).contains(&height)
    });
    if is_open { Expected::Open } else { Expected::Surface(distance) }
}

fn check_rays(name: &str, level: &Level, scene: &Scene) {
    let bodies = bodies(scene);
    let is_shell = |body: &&Body| matches!(body.part, Some("floor" | "ceiling" | "wall" | "threshold"));
    for (index, room) in level.rooms.iter().enumerate() {
        for origin in inside_points(room) {
            let mut surfaces = 0;
            for direction in directions(1500) {
                let shell = bodies.iter().filter(is_shell).flat_map(|body| &body.triangles);
                let found = nearest(shell, origin, direction);
                let Expected::Surface(distance) = expected(level, room, origin, direction) else { continue };
                surfaces += 1;
                let Some((hit, is_front)) = found else {
                    panic!("{name}: from room {index} at {origin} nothing lies towards {direction}")
                };
                assert!(is_front, "{name}: room {index}, {direction}: the back of a face at {hit}");
                assert!(
                    (hit - distance).abs() < 5e-3,
                    "{name}: room {index}, {direction}: {hit}, not {distance}"
                );
            }
            assert!(surfaces > 150, "{name}: the rays meet walls");
        }
    }
}

/// Points of a grid well inside the room, at eye height.
fn inside_points(room: &Room) -> Vec<DVec3> {
    let Bounds { low, high } = room.region.outline.bounds();
    let step = |share: f64| low + (high - low) * share;
    let shares = [0.13, 0.37, 0.63, 0.87];
    let grid = shares.iter().flat_map(|&x| shares.map(|y| Point::new(step(x).x, step(y).y)));
    let clear = grid.filter(|&point| {
        room.region.contains(point)
            && room.walls.iter().all(|wall| {
                let along = (point - wall.start).dot(wall.direction()).clamp(0.0, wall.length());
                (wall.start + wall.direction() * along).distance(point) > 0.1
            })
    });
    clear.map(|point| DVec3::new(point.x, 1.31, -point.y)).take(3).collect()
}

#[test]
fn rays_from_inside_meet_the_shell_where_the_plan_says() {
    for (name, level) in levels::all() {
        check_rays(name, &level, &bare_scene(&level));
    }
}

#[test]
fn the_floor_faces_up_at_zero_and_the_ceiling_down_at_the_rooms_height() {
    let scene = bare_scene(&levels::concave());
    for body in bodies(&scene) {
        let heights: Vec<f64> = body.triangles.iter().flatten().map(|corner| corner.y).collect();
        let (low, high) =
            heights.iter().fold((f64::MAX, f64::MIN), |(low, high), &y| (low.min(y), high.max(y)));
        match body.part {
            Some("floor") => assert_eq!((low as f32, high), (-0.02, 0.0)),
            Some("ceiling") => assert!((low - 2.6).abs() < 1e-6 && high > 2.6),
            _ => {}
        }
    }
}

/// Lowest and highest corner of the bodies of a part.
fn reach(level: &Level, part: &str) -> (f64, f64) {
    let bodies = bodies(&bare_scene(level));
    let corners =
        bodies.iter().filter(|body| body.part == Some(part)).flat_map(|body| body.triangles.iter().flatten());
    corners.fold((f64::MAX, f64::MIN), |(low, high), corner| (low.min(corner.y), high.max(corner.y)))
}

#[test]
fn levels_stand_on_each_other_without_a_gap() {
    let mut level = two_rooms();
    let (floor, ceiling, wall) = (reach(&level, "floor"), reach(&level, "ceiling"), reach(&level, "wall"));
    let is_near = |one: f64, two: f64| (one - two).abs() < 1e-6;
    assert!(level.height > 2.8, "there is a slab between the ceilings and the next floor");
    assert!(is_near(wall.1, level.height + wall.0), "walls end where those above begin: {wall:?}");
    assert!(is_near(ceiling.1, level.height + floor.0 - 0.001), "ceilings end below the floor: {ceiling:?}");
    // Rooms as high as their storey keep a ceiling, and walls that reach into it.
    level.height = 2.6;
    let (ceiling, wall) = (reach(&level, "ceiling"), reach(&level, "wall"));
    assert!(is_near(ceiling.1, 2.62) && is_near(wall.1, 2.619), "{ceiling:?} {wall:?}");
}

#[test]
fn doorways_have_a_floor_through_the_wall() {
    let level = two_rooms();
    let bodies = bodies(&bare_scene(&level));
    let shell = || bodies.iter().filter(|body| body.part != Some("frame")).flat_map(|body| &body.triangles);
    for opening in level.openings.iter().filter(|opening| opening.kind.is_walkable()) {
        let above = DVec3::new(opening.center.x, 1.0, -opening.center.y);
        let (distance, is_front) = nearest(shell(), above, DVec3::NEG_Y).unwrap();
        assert!((distance - 1.0).abs() < 1e-6 && is_front, "{}: {distance}", opening.id);
    }
}

/// Metres before a wall and from the edges of an opening where rays begin, and metres of rounding.
const EDGE: f64 = 6e-3;
const ROUNDING: f64 = 1e-3;

#[test]
fn nothing_stands_in_an_opening_through_all_of_the_wall() {
    for (name, level) in levels::all() {
        let bodies = bodies(&bare_scene(&level));
        let walls = || bodies.iter().filter(|body| body.part == Some("wall"));
        for (room, opening) in
            level.rooms.iter().flat_map(|room| room.openings.iter().map(move |at| (room, at)))
        {
            let (wall, &Opening { bottom, top, .. }) =
                (&room.walls[opening.wall], &level.openings[opening.opening]);
            let height = f64::midpoint(bottom, top.min(room.height));
            for at in [opening.from + EDGE, f64::midpoint(opening.from, opening.to), opening.to - EDGE] {
                let foot = wall.start + wall.direction() * at + wall.normal() * EDGE;
                let ray = (DVec3::new(foot.x, height, -foot.y), wall.normal());
                let out = DVec3::new(-ray.1.x, 0.0, ray.1.y);
                let hit = nearest(walls().flat_map(|body| &body.triangles), ray.0, out);
                let free = hit.is_none_or(|(distance, _)| distance > wall.thickness + EDGE - ROUNDING);
                assert!(free, "{name}: opening {} at {at} m: {hit:?}", level.openings[opening.opening].id);
            }
        }
    }
}

#[test]
fn no_post_stands_at_a_corner_of_open_sides() {
    let bodies = bodies(&bare_scene(&levels::open_corner()));
    let near = |corner: &DVec3| Point::new(corner.x, -corner.z).distance(Point::splat(2.005)) < 0.3;
    let low = |triangle: &&[DVec3; 3]| triangle.iter().any(|corner| near(corner) && corner.y < 2.0);
    for wall in bodies.iter().filter(|body| body.part == Some("wall")) {
        assert_eq!(wall.triangles.iter().find(low), None, "{}", wall.name);
    }
}

#[test]
fn frames_stand_hardly_out_of_walls_that_are_not_parallel() {
    const STANDS_OUT: f64 = 0.03;
    let left = room("1", &[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
    let right = room("2", &[(4.2, 0.0), (8.0, 0.0), (8.0, 3.0), (4.8, 3.0)]);
    let mut level = level(vec![left, right]);
    let at = level.rooms[1].walls[3].length() - 1.53;
    let door = OpeningPlan {
        kind: OpeningKind::Door,
        id: "a",
        sides: &[(0, 1, 1.5), (1, 3, at)],
        width: 0.9,
        heights: (0.0, 2.0),
    };
    add_opening(&mut level, &door);
    let bodies = bodies(&bare_scene(&level));
    let frame = bodies.iter().find(|body| body.part == Some("frame")).unwrap();
    for corner in frame.triangles.iter().flatten() {
        let point = Point::new(corner.x, -corner.z);
        for room in level.rooms.iter().filter(|room| room.region.contains(point)) {
            let depth =
                room.region.borders().map(|border| border.distance(point)).fold(f64::INFINITY, f64::min);
            assert!(depth < STANDS_OUT, "{point} is {depth} m in room {}", room.id);
        }
    }
}

#[test]
fn equal_rooms_share_their_shell() {
    let corners = |x: f64| [(x, 0.0), (x + 4.0, 0.0), (x + 4.0, 3.0), (x, 3.0)];
    let rooms: Vec<_> = (0..10).map(|i| room(&i.to_string(), &corners(f64::from(i) * 4.6 + 0.1))).collect();
    let one = bare_scene(&level(rooms[..1].to_vec())).meshes.len();
    assert_eq!(bare_scene(&level(rooms)).meshes.len(), one);
}

#[test]
fn skirting_runs_along_plaster_and_stops_at_doors() {
    let level = two_rooms();
    let bodies = bodies(&bare_scene(&level));
    let boards = &bodies.iter().find(|body| body.name == "skirting@101").unwrap().triangles;
    let meets = |x: f64| {
        let (origin, south) = (DVec3::new(x, 0.03, -0.5), DVec3::new(0.0, 0.0, 1.0));
        nearest(boards.iter(), origin, south).map(|(distance, is_front)| (is_front, (distance * 1e4).round()))
    };
    assert_eq!(meets(1.4), Some((true, 4880.0)), "1.2 cm before the wall");
    assert_eq!(meets(2.0), None, "the entrance is from 1.5 to 2.5");
    let mut tiled = catalog();
    tiled.room_types.get_mut("office").unwrap().finish.wall = Slot::TileWall;
    let scene = scene_of(&level, &tiled);
    assert!(!crate::triangles::bodies(&scene).iter().any(|body| body.part == Some("skirting")));
}

/// Middles of the bodies of a part in a room: name, x, height, z.
fn middles(scene: &Scene, part: &str) -> Vec<(String, DVec3)> {
    let middle = |body: &Body| {
        let corners = || body.triangles.iter().flatten();
        let low = corners().fold(DVec3::MAX, |low, corner| low.min(*corner));
        (body.name.clone(), (low + corners().fold(DVec3::MIN, |high, corner| high.max(*corner))) / 2.0)
    };
    bodies(scene).iter().filter(|body| body.part == Some(part)).map(middle).collect()
}

#[test]
fn switches_are_beside_the_handles_of_doors() {
    let mut level = two_rooms();
    let beside_entrance = |level: &Level| {
        let switches = middles(&bare_scene(level), "switch");
        switches.into_iter().find(|(name, _)| name == "switch.0.0@101").map(|(_, middle)| middle)
    };
    // The entrance is from 1.5 to 2.5 with boards of 6 cm, hinged at 1.5.
    let place = beside_entrance(&level).unwrap();
    assert!(
        (place.x - 2.68).abs() < 1e-5 && (place.y - 1.05).abs() < 1e-5 && place.z.abs() < 0.01,
        "{place}"
    );
    let leaf = &mut level.openings[0].leaves[0];
    std::mem::swap(&mut leaf.hinge, &mut leaf.closed_tip);
    assert!((beside_entrance(&level).unwrap().x - 1.32).abs() < 1e-5);
    // A window beside it, down to the hips, leaves room on the other side only.
    let mut window = level.openings.iter().find(|one| one.kind == OpeningKind::Window).unwrap().clone();
    (window.id, window.bottom) = ("w2".to_owned(), 0.9);
    level.openings.push(window);
    let place =
        RoomOpening { opening: level.openings.len() - 1, from: 0.3, to: 1.4, ..level.rooms[0].openings[0] };
    level.rooms[0].openings.push(place);
    assert!((beside_entrance(&level).unwrap().x - 2.6).abs() < 0.1);
}

#[test]
fn sockets_follow_the_walls_but_not_the_doors() {
    let level = two_rooms();
    let of_room = |scene: &Scene| {
        let found = middles(scene, "socket");
        found
            .into_iter()
            .filter(|(name, _)| name.ends_with("@101"))
            .map(|(_, middle)| middle)
            .collect::<Vec<_>>()
    };
    let sockets = of_room(&bare_scene(&level));
    assert_eq!(sockets.len(), 4, "two beside the entrance, one on each wall without a door");
    for middle in &sockets {
        assert!((middle.y - 0.3).abs() < 1e-5);
        assert!(middle.z.abs() > 0.1 || !(1.4..2.6).contains(&middle.x), "in the entrance: {middle}");
    }
    let mut bare = catalog();
    let finish = &mut bare.room_types.get_mut("office").unwrap().finish;
    (finish.sockets, finish.has_switches) = (None, false);
    let scene = scene_of(&level, &bare);
    assert!(of_room(&scene).is_empty() && middles(&scene, "switch").is_empty());
}

#[test]
fn sockets_are_over_worktops() {
    let level = two_rooms();
    let mut catalog = catalog();
    let desk = catalog.class_index("desk").unwrap();
    let heights_in_the_north = |catalog: &Catalog| {
        let place =
            Placement { position: Point::new(3.0, 2.6), ..placement(catalog, "desk", 1, Parent::Wall(2)) };
        let rooms = [furnished(0, vec![place]), furnished(1, Vec::new())];
        let found = middles(&furnished_scene(&level, catalog, &rooms), "socket");
        let in_the_north = found.into_iter().filter(|(name, _)| name.starts_with("socket.2."));
        in_the_north.map(|(_, middle)| (middle.y * 100.0).round() as i32).collect::<Vec<_>>()
    };
    assert_eq!(heights_in_the_north(&catalog), [30, 30], "behind a desk, in both rooms");
    catalog.classes[desk].fitted = Some(FittedPart::Worktop);
    let mut heights = heights_in_the_north(&catalog);
    heights.sort_unstable();
    assert_eq!(heights, [30, 115]);
}

#[test]
fn balconies_have_neither_sockets_nor_switches() {
    let mut level = two_rooms();
    level.rooms[0].walls[2].kind = WallKind::Railing(1.0);
    let names =
        |part: &str| middles(&bare_scene(&level), part).into_iter().map(|(name, _)| name).collect::<String>();
    assert!(!names("socket").contains("@101") && !names("switch").contains("@101"));
    assert!(names("socket").contains("@102"));
}

#[test]
fn a_dado_ends_at_its_height_and_closes_the_wall() {
    let mut tiled = catalog();
    let finish = &mut tiled.room_types.get_mut("office").unwrap().finish;
    finish.dado = Some(Dado { slot: Slot::TileWall, height: 1.2 });
    let scene = scene_of(&two_rooms(), &tiled);
    assert!(
        !bodies(&scene).iter().any(|body| body.part == Some("skirting")),
        "tiles reach down to the floor"
    );
    let walls = scene.meshes.iter().filter(|mesh| mesh.name.starts_with("wall."));
    for mesh in walls {
        assert_eq!(open_edges(&mesh.model), 0, "{}", mesh.name);
        let is_tile = |primitive: &&Primitive| primitive.material == ModelMaterial::Slot(Slot::TileWall);
        let tiles = mesh.model.primitives.iter().find(is_tile).unwrap();
        let heights = || tiles.positions.iter().map(|[_, y, _]| *y);
        assert!((heights().fold(f32::MIN, f32::max) - 1.2).abs() < 1e-6, "{}", mesh.name);
        assert!(tiles.normals.iter().all(|normal| *normal == [0.0, 0.0, 1.0]), "the inner face only");
    }
}
