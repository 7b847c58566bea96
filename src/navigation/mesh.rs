//! The navigation mesh of a level.

use std::collections::BTreeMap;

use geo::Area as _;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::geometry::{Bounds, DisjointSets, Point};
use crate::plan::ring_surface;

use super::convex::{Convex, Corner, convex_parts, metres, sides, turn};
use super::file::{Agent, MeshFile, MeshPolygon, MeshPortal, MeshRoom, Part};
use super::floor::LevelFloor;
use super::shape::{self, Area};

/// Of the format of meshes.
const VERSION: u32 = 1;
/// Metres of the squares that wide rooms are cut into: triangles of a hall with a thousand chairs take long, and are needles.
const TILE: f64 = 16.0;
/// Square metres of the smallest island, but for the largest: where somebody's middle has no more room, nobody goes.
const LEAST_ISLAND: f64 = 0.02;
/// Millimetres that two sides of one line are apart at most.
const SAME_LINE: i64 = 2;
/// Millimetres that they have in common at least: an agent as wide as a passage has four in it (`floor`).
const LEAST_PORTAL: f64 = 3.0;

/// A side without a polygon behind it, by its polygon.
type Side = GeomWithData<Rectangle<[i64; 2]>, (usize, Corner, Corner)>;

/// The mesh for an agent.
#[must_use]
pub fn mesh(building: &str, floor: &LevelFloor<'_>, agent: Agent) -> MeshFile {
    let level = floor.level;
    let (rooms, openings) = floor.free(agent.radius);
    let room_parts = rooms.iter().zip(&level.rooms).flat_map(|(area, room)| {
        let tiles = tiles(area, room.region.outline.bounds());
        let convex = tiles.into_iter().flat_map(|tile| convex_parts(&tile));
        convex.map(|polygon| (polygon, Part::Room(room.id.clone()))).collect::<Vec<_>>()
    });
    let opening_parts = openings.iter().flat_map(|(opening, area)| {
        let part = Part::Opening(level.openings[*opening].id.clone());
        convex_parts(area).into_iter().map(move |polygon| (polygon, part.clone()))
    });
    let (polygons, parts): (Vec<Convex>, Vec<Part>) = room_parts.chain(opening_parts).unzip();
    let mut portals = portals(&polygons);
    let Islands { numbers, mut areas } = Islands::new(&polygons, &portals);
    // The smallest islands are the last; a portal joins polygons of one island.
    areas.truncate(areas.iter().skip(1).take_while(|area| **area >= LEAST_ISLAND).count() + 1);
    let is_kept = |island: u32| (island as usize) < areas.len();
    portals.retain(|portal| is_kept(numbers[portal.polygons[0] as usize]));
    let new_numbers = numbers_among(numbers.iter().map(|&island| is_kept(island)));
    for polygon in portals.iter_mut().flat_map(|portal| &mut portal.polygons) {
        *polygon = new_numbers[*polygon as usize];
    }
    let mut corners = Corners::default();
    let polygons = polygons.iter().zip(parts).zip(numbers).filter(|(_, island)| is_kept(*island));
    let polygons = polygons.map(|((polygon, part), island)| MeshPolygon {
        corners: polygon.iter().map(|&corner| corners.index(corner)).collect(),
        part,
        island,
    });
    MeshFile {
        version: VERSION,
        building: building.to_owned(),
        level: level.id.clone(),
        elevation: level.elevation,
        agent,
        polygons: polygons.collect(),
        corners: corners.places.into_iter().map(metres).collect(),
        portals,
        rooms: rooms.iter().enumerate().map(|(index, area)| room(floor, index, area)).collect(),
        islands: areas,
    }
}

fn room(floor: &LevelFloor<'_>, index: usize, free: &Area) -> MeshRoom {
    let room = &floor.level.rooms[index];
    MeshRoom {
        id: room.id.clone(),
        room_type: room.room_type.clone(),
        area: rounded(room.region.area()),
        free: rounded(free.unsigned_area()),
        joins_levels: floor.catalog.room_types.get(&room.room_type).is_some_and(|found| found.joins_levels),
    }
}

/// Square metres on whole square centimetres.
fn rounded(area: f64) -> f64 {
    libm::rint(area * 1e4) / 1e4
}

/// The places of a mesh, each once, in the order of their first use.
#[derive(Default)]
struct Corners {
    known: BTreeMap<Corner, u32>,
    places: Vec<Corner>,
}

impl Corners {
    fn index(&mut self, corner: Corner) -> u32 {
        *self.known.entry(corner).or_insert_with(|| {
            self.places.push(corner);
            u32::try_from(self.places.len() - 1)
                .expect("a level has fewer than four thousand million corners")
        })
    }
}

/// An area in squares, if it is wide.
fn tiles(area: &Area, bounds: Bounds) -> Vec<Area> {
    let count = |metres: f64| (metres / TILE).ceil().max(1.0) as usize;
    let (columns, rows) = (count(bounds.size().x), count(bounds.size().y));
    if columns * rows == 1 || area.0.is_empty() {
        return vec![area.clone()];
    }
    let tile = |index: usize| {
        let low = bounds.low + Point::new((index % columns) as f64, (index / columns) as f64) * TILE;
        let square = ring_surface(&Bounds::new(low, low + Point::splat(TILE)).corners());
        shape::common(area, &square.into())
    };
    (0..columns * rows).map(tile).collect()
}

/// Where polygons touch along a line, sorted by polygons.
fn portals(polygons: &[Convex]) -> Vec<MeshPortal> {
    let all = polygons.iter().enumerate().flat_map(|(index, polygon)| {
        sides(polygon).map(move |(a, b)| {
            let (low, high) = ([a[0].min(b[0]), a[1].min(b[1])], [a[0].max(b[0]), a[1].max(b[1])]);
            Side::new(Rectangle::from_corners(low, high), (index, a, b))
        })
    });
    let tree: RTree<Side> = RTree::bulk_load(all.collect());
    let mut portals = Vec::new();
    for (index, polygon) in polygons.iter().enumerate() {
        for (a, b) in sides(polygon) {
            let low = [a[0].min(b[0]) - SAME_LINE, a[1].min(b[1]) - SAME_LINE];
            let high = [a[0].max(b[0]) + SAME_LINE, a[1].max(b[1]) + SAME_LINE];
            for side in tree.locate_in_envelope_intersecting(&AABB::from_corners(low, high)) {
                let (other, c, d) = side.data;
                if other <= index {
                    continue;
                }
                if let Some(ends) = shared((a, b), (c, d)) {
                    portals.push(MeshPortal { polygons: [index, other].map(number), ends });
                }
            }
        }
    }
    portals.sort_by(|one, other| {
        let ends = |portal: &MeshPortal| portal.ends.as_flattened().to_vec();
        one.polygons.cmp(&other.polygons).then_with(|| ends(one).partial_cmp(&ends(other)).expect("numbers"))
    });
    portals
}

/// The left and the right end of what two sides have in common, which run against each other along one line.
fn shared((a, b): (Corner, Corner), (c, d): (Corner, Corner)) -> Option<[[f64; 2]; 2]> {
    let place = |corner: Corner| Point::new(corner[0] as f64, corner[1] as f64);
    let (start, along) = (place(a), (place(b) - place(a)).try_normalize()?);
    let (from, to) = ((place(d) - start).dot(along), (place(c) - start).dot(along));
    let off = |corner: Corner| (place(corner) - start).perp_dot(along).abs();
    let (low, high) = (from.max(0.0), to.min((place(b) - start).length()));
    let is_on_line = off(c) <= SAME_LINE as f64 && off(d) <= SAME_LINE as f64;
    if !is_on_line || high - low < LEAST_PORTAL {
        return None;
    }
    // Who leaves a polygon over a side has the end of the side on the left.
    Some([high, low].map(|distance| {
        let end = start + along * distance;
        metres([libm::rint(end.x) as i64, libm::rint(end.y) as i64])
    }))
}

/// Polygons that are reached from each other.
struct Islands {
    /// By polygon; the largest island is the first.
    numbers: Vec<u32>,
    /// Square metres by island.
    areas: Vec<f64>,
}

impl Islands {
    fn new(polygons: &[Convex], portals: &[MeshPortal]) -> Self {
        let mut sets = DisjointSets::new(polygons.len());
        for portal in portals {
            let [a, b] = portal.polygons;
            sets.join(a as usize, b as usize);
        }
        let roots: Vec<usize> = (0..polygons.len()).map(|polygon| sets.find(polygon)).collect();
        let mut areas: BTreeMap<usize, i128> = BTreeMap::new();
        for (polygon, &root) in polygons.iter().zip(&roots) {
            let doubled: i128 = polygon[1..].windows(2).map(|pair| turn(polygon[0], pair[0], pair[1])).sum();
            *areas.entry(root).or_default() += doubled;
        }
        let mut order: Vec<(usize, i128)> = areas.into_iter().collect();
        order.sort_by_key(|&(root, doubled)| (core::cmp::Reverse(doubled), root));
        let number_of: BTreeMap<usize, u32> =
            order.iter().enumerate().map(|(island, &(root, _))| (root, number(island))).collect();
        Self {
            numbers: roots.iter().map(|root| number_of[root]).collect(),
            areas: order.iter().map(|&(_, doubled)| rounded(doubled as f64 / 2e6)).collect(),
        }
    }
}

/// The number of each item among those that are kept; of others, that of the next one.
fn numbers_among(are_kept: impl Iterator<Item = bool>) -> Vec<u32> {
    let number = |next: &mut u32, is_kept: bool| {
        let number = *next;
        *next += u32::from(is_kept);
        Some(number)
    };
    are_kept.scan(0, number).collect()
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("a level has fewer than four thousand million polygons")
}
