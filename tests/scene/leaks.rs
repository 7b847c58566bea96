//! Rays leave the shell of a room through its openings only, and no two faces lie in one place.
//!
//! The tests use levels built in code, the built-in plans, those after the paper, and a few real ones if the folder
//! `shared/data/floorplans` lies beside or above the project.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glam::{DVec2, DVec3};
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::geometry::{Bounds, Point, Polygon};
use roomwright::internals::plan::{Level, OpeningKind, PlanOptions, Room, WallKind, read_plans};
use roomwright::internals::scene::Scene;

use crate::fixture::scene_of;
use crate::levels;
use crate::triangles::{Body, bodies, directions, nearest};

/// Metres that a ray may pass the border of a room before it meets something.
const OUTSIDE: f64 = 5e-3;
/// Metres round the edge of a hole where a ray may go either way.
const MARGIN: f64 = 1e-3;
/// Rays in all directions from each point.
const RAYS: u32 = 300;

/// A level's name, for messages.
type Named = (String, Level);

fn plans(folder: &str) -> Vec<PathBuf> {
    let listed =
        std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("configs").join(folder)).unwrap();
    let mut files: Vec<PathBuf> = listed.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|kind| kind == "yaml"));
    files.sort();
    files
}

/// A few plans of other people, if they are there.
fn real_plans() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder =
        root.ancestors().map(|folder| folder.join("shared/data/floorplans")).find(|one| one.is_dir());
    let Some(folder) = folder else {
        println!("skipped: there is no shared/data/floorplans beside or above {}", root.display());
        return Vec::new();
    };
    ["archilyse/site_1440", "ifc/Duplex_A_20110907.ifc", "honeybee/single_family_home.hbjson"]
        .map(|path| folder.join(path))
        .into()
}

/// Levels of a building that are tried: the others are much like them.
const LEVELS: usize = 2;

/// The first distinct levels of each building of some plans.
fn read_levels(catalog: &Catalog, paths: &[PathBuf]) -> Vec<Named> {
    let reading = read_plans(paths, &PlanOptions::new(&catalog.room_words));
    let mut found: BTreeMap<[u8; 32], Named> = BTreeMap::new();
    for placed in &reading.plan.buildings {
        for level in placed.building.levels.iter().take(LEVELS) {
            let named = || (format!("{}/{}", placed.id, level.id), level.clone());
            found.entry(level.digest).or_insert_with(named);
        }
    }
    found.into_values().collect()
}

/// Synthetic levels, and all levels of the files.
fn each_scene(files: &[PathBuf], visit: impl Fn(&str, &Level, &Scene)) {
    let catalog = load_catalog(&[]).unwrap().value;
    let synthetic = levels::all().into_iter().map(|(name, level)| (name.to_owned(), level));
    let read = read_levels(&catalog, files);
    assert!(read.len() > 8, "{} levels", read.len());
    for (name, level) in synthetic.chain(read) {
        let scene = scene_of(&level, &catalog);
        visit(&name, &level, &scene);
    }
}

/// A plan point at a height, in the level's frame.
fn scene_point(point: Point, height: f64) -> DVec3 {
    DVec3::new(point.x, height, -point.y)
}

fn plan_point(point: DVec3) -> Point {
    Point::new(point.x, -point.z)
}

/// Where a ray from inside leaves a room by a hole: the nearest such distance.
fn way_out(level: &Level, room: &Room, origin: DVec3, direction: DVec3) -> f64 {
    let (from, along) = (plan_point(origin), plan_point(direction));
    let mut nearest = f64::INFINITY;
    let mut pass = |wall: usize, range: [f64; 2], heights: [f64; 2]| {
        let wall = &room.walls[wall];
        let edge = wall.direction();
        let determinant = along.perp_dot(edge);
        let distance = (wall.start - from).perp_dot(edge) / determinant;
        let at = (wall.start - from).perp_dot(along) / determinant;
        let height = origin.y + direction.y * distance;
        let is_within = |value: f64, [low, high]: [f64; 2]| value > low - MARGIN && value < high + MARGIN;
        if determinant > 0.0 && distance > 0.0 && is_within(at, range) && is_within(height, heights) {
            nearest = nearest.min(distance);
        }
    };
    for place in &room.openings {
        let opening = &level.openings[place.opening];
        let top = if opening.kind == OpeningKind::OpenBoundary { f64::INFINITY } else { opening.top };
        pass(place.wall, [place.from, place.to], [opening.bottom, top]);
    }
    for (index, wall) in room.walls.iter().enumerate() {
        if let WallKind::Railing(_) = wall.kind {
            pass(index, [0.0, wall.length()], [0.0, f64::INFINITY]);
        }
    }
    let mut climb = |hole: Option<&Polygon>, height: f64| {
        let distance = (height - origin.y) / direction.y;
        let is_in = hole.is_some_and(|hole| is_near_hole(hole, from + along * distance));
        if distance > 0.0 && is_in {
            nearest = nearest.min(distance);
        }
    };
    let stairs = level.rooms.iter().position(|other| other.id == room.id).and_then(|at| level.stairs_of(at));
    climb(stairs.and_then(|stairs| stairs.up.as_ref()).map(|flight| &flight.opening), room.height);
    climb(stairs.and_then(|stairs| stairs.well.as_ref()).map(|well| &well.opening), 0.0);
    nearest
}

/// Whether a point lies in a hole for stairs or at its edge.
fn is_near_hole(hole: &Polygon, at: Point) -> bool {
    // Floors are cut a little wider than the steps are.
    hole.contains(at) || hole.edges().any(|edge| edge.distance(at) < 4.0 * MARGIN)
}

/// How far a point lies outside a room.
fn distance_outside(room: &Room, point: DVec3) -> f64 {
    let floor = plan_point(point);
    let vertical = (-point.y).max(point.y - room.height).max(0.0);
    if room.region.contains(floor) {
        return vertical;
    }
    let to_wall = |wall: &roomwright::internals::plan::Wall| {
        let along = (floor - wall.start).dot(wall.direction()).clamp(0.0, wall.length());
        (wall.start + wall.direction() * along).distance(floor)
    };
    room.walls.iter().map(to_wall).fold(f64::INFINITY, f64::min).max(vertical)
}

/// Points well inside the room.
fn inside_points(room: &Room) -> Vec<DVec3> {
    let Bounds { low, high } = room.region.outline.bounds();
    let shares = [0.13, 0.37, 0.63, 0.87];
    let at = |x: f64, y: f64| Point::new(low.x + (high.x - low.x) * x, low.y + (high.y - low.y) * y);
    let is_clear = |point: &Point| {
        let is_inside = room.region.contains(*point);
        let is_in_column = room.obstacles.iter().any(|column| {
            let Bounds { low, high } = column.outline.bounds();
            point.x > low.x && point.x < high.x && point.y > low.y && point.y < high.y
        });
        let is_free = |wall: &roomwright::internals::plan::Wall| {
            let along = (*point - wall.start).dot(wall.direction()).clamp(0.0, wall.length());
            (wall.start + wall.direction() * along).distance(*point) > 0.05
        };
        is_inside && !is_in_column && room.walls.iter().all(is_free)
    };
    let grid = shares.iter().flat_map(|&x| shares.map(|y| at(x, y))).filter(is_clear);
    grid.take(2).map(|point| scene_point(point, room.height * 0.47)).collect()
}

/// What rays aim at besides all directions: corners of the room at several heights, and the edges between walls and
/// floor and between walls and ceiling.
fn targets(room: &Room) -> Vec<DVec3> {
    let heights = [0.0, 0.31, 0.5, 0.83, 1.0].map(|share| share * room.height);
    let shares = [0.11, 0.5, 0.77];
    let corners = room.walls.iter().flat_map(|wall| heights.map(|height| scene_point(wall.start, height)));
    let edges = room.walls.iter().flat_map(|wall| {
        let at = |share: f64| wall.start + (wall.end - wall.start) * share;
        shares.into_iter().flat_map(move |share| [0.0, room.height].map(|y| scene_point(at(share), y)))
    });
    corners.chain(edges).collect()
}

/// The triangles of floors, ceilings, walls and thresholds in or close to a room.
fn shell_near(bodies: &[Body], room: &Room) -> Vec<[DVec3; 3]> {
    const NEAR: f64 = 0.1;
    let Bounds { low, high } = room.region.outline.bounds();
    let is_near = |triangle: &&[DVec3; 3]| {
        let points = triangle.map(plan_point);
        let (least, most) =
            (points[0].min(points[1]).min(points[2]), points[0].max(points[1]).max(points[2]));
        least.x < high.x + NEAR && most.x > low.x - NEAR && least.y < high.y + NEAR && most.y > low.y - NEAR
    };
    let is_shell =
        |body: &&Body| matches!(body.part, Some("floor" | "ceiling" | "wall" | "threshold" | "column"));
    bodies.iter().filter(is_shell).flat_map(|body| body.triangles.iter().filter(is_near).copied()).collect()
}

/// Faults of the rays from inside one room.
fn leaks(level: &Level, room: &Room, shell: &[[DVec3; 3]]) -> Vec<String> {
    let mut faults = Vec::new();
    // Rooms of real plans overlap: a point in a column of another room sees that one from inside.
    let is_in_air =
        |origin: &DVec3| nearest(shell.iter(), *origin, DVec3::Y).is_none_or(|(_, is_front)| is_front);
    for origin in inside_points(room).into_iter().filter(is_in_air) {
        // Where two bodies meet, a ray at their very seam may as well touch the side of one as the front of the other.
        let aimed = targets(room).into_iter().map(|target| ((target - origin).normalize(), true));
        for (direction, is_at_seam) in aimed.chain(directions(RAYS).map(|direction| (direction, false))) {
            let found = nearest(shell.iter(), origin, direction);
            let out = way_out(level, room, origin, direction);
            let is_closed = match found {
                Some((distance, _)) if distance > out - MARGIN => true,
                Some((distance, is_front)) => {
                    (is_front || is_at_seam)
                        && distance_outside(room, origin + direction * distance) < OUTSIDE
                }
                None => out.is_finite(),
            };
            if !is_closed {
                faults.push(format!("room {}: from {origin} towards {direction}: {found:?}", room.id));
            }
        }
    }
    faults
}

#[test]
fn rays_leave_a_room_through_its_openings_only() {
    each_scene(&[plans("plans"), plans("paper"), real_plans()].concat(), |name, level, scene| {
        let bodies = bodies(scene);
        for room in &level.rooms {
            let faults = leaks(level, room, &shell_near(&bodies, room));
            assert!(
                faults.is_empty(),
                "{name}: {} rays: {:#?}",
                faults.len(),
                &faults[..faults.len().min(5)]
            );
        }
    });
}

#[test]
fn rays_leave_a_room_without_a_wall() {
    let (_, level) = levels::all().remove(0);
    let mut bodies = bodies(&crate::fixture::bare_scene(&level));
    bodies.retain(|body| body.name != "wall.2@101");
    let room = &level.rooms[0];
    assert!(!leaks(&level, room, &shell_near(&bodies, room)).is_empty());
}

/// A triangle in its plane: the name of its body and its corners.
struct Flat<'b> {
    owner: &'b str,
    corners: [DVec2; 3],
}

/// Ten micrometres: the rounding of shapes. Planes nearer than this are one.
const PLANE: f64 = 1e-5;
/// Square metres that two faces may share: slivers along an edge.
const SLIVER: f64 = 1e-5;

/// The triangles of a level by plane and facing.
fn by_plane(bodies: &[Body]) -> BTreeMap<[i64; 4], Vec<Flat<'_>>> {
    let mut planes: BTreeMap<[i64; 4], Vec<Flat<'_>>> = BTreeMap::new();
    for body in bodies {
        for [a, b, c] in &body.triangles {
            let normal = (*b - *a).cross(*c - *a).normalize();
            let key = [normal.x * 1e4, normal.y * 1e4, normal.z * 1e4, a.dot(normal) / PLANE / 4.0]
                .map(|value| value.round() as i64);
            // From the rounded normal, so that all faces of a plane have one frame.
            let rounded = DVec3::new(key[0] as f64, key[1] as f64, key[2] as f64).normalize();
            let (across, up) = rounded.any_orthonormal_pair();
            let corners = [a, b, c].map(|corner| DVec2::new(corner.dot(across), corner.dot(up)));
            planes.entry(key).or_default().push(Flat { owner: &body.name, corners });
        }
    }
    planes
}

/// The area that two triangles share (Sutherland, Hodgman, 1974).
fn shared_area(one: &[DVec2; 3], two: &[DVec2; 3]) -> f64 {
    let area = |points: &[DVec2]| {
        (0..points.len()).map(|i| points[i].perp_dot(points[(i + 1) % points.len()])).sum::<f64>() / 2.0
    };
    let sign = area(two).signum();
    let mut points = one.to_vec();
    for side in 0..3 {
        let (from, to) = (two[side], two[(side + 1) % 3]);
        let inside = |point: DVec2| sign * (to - from).perp_dot(point - from);
        let mut kept = Vec::new();
        for index in 0..points.len() {
            let (last, next) = (points[(index + points.len() - 1) % points.len()], points[index]);
            let (before, after) = (inside(last), inside(next));
            if before * after < 0.0 {
                kept.push(last + (next - last) * (before / (before - after)));
            }
            if after >= 0.0 {
                kept.push(next);
            }
        }
        points = kept;
    }
    area(&points).abs()
}

/// Pairs of bodies with faces in one plane that overlap and face the same way, with the largest shared area.
fn doubles(bodies: &[Body]) -> BTreeMap<(String, String), f64> {
    let mut found = BTreeMap::new();
    for flats in by_plane(bodies).values() {
        for (index, one) in flats.iter().enumerate() {
            for two in &flats[index + 1..] {
                let (low, high) =
                    (|c: &[DVec2; 3]| c[0].min(c[1]).min(c[2]), |c: &[DVec2; 3]| c[0].max(c[1]).max(c[2]));
                let gap =
                    low(&one.corners).max(low(&two.corners)) - high(&one.corners).min(high(&two.corners));
                if gap.max_element() > 0.0 {
                    continue;
                }
                let area = shared_area(&one.corners, &two.corners);
                if area > SLIVER {
                    let largest = found.entry((one.owner.to_owned(), two.owner.to_owned())).or_insert(0.0);
                    *largest = area.max(*largest);
                }
            }
        }
    }
    found
}

/// Undersides and tops of walls, which lie in the strips where walls of unlike heights or thickness meet, below the
/// floor and above the ceiling: nobody sees them.
fn is_hidden([a, b, c]: &[DVec3; 3], part: Option<&str>) -> bool {
    part == Some("wall") && (*b - *a).cross(*c - *a).normalize().y.abs() > 0.999
}

#[test]
fn no_two_faces_of_the_shell_lie_in_one_place() {
    // Two windows cannot be in one place, nor can two walls.
    let is_impossible = |name: &str| matches!(name, "openings at corners" | "outline folding back on itself");
    each_scene(&[plans("plans"), plans("paper")].concat(), |name, _, scene| {
        let mut bodies = bodies(scene);
        for body in &mut bodies {
            let part = body.part;
            body.triangles.retain(|triangle| !is_hidden(triangle, part));
        }
        let found = doubles(&bodies);
        assert!(found.is_empty() || is_impossible(name), "{name}: {found:?}");
    });
}
