//! Floor, ceiling, walls, columns and fittings of a room.

use std::collections::BTreeMap;

use super::behind::Behind;
use super::corner::{Footprint, footprints};
use super::finish::RoomFinish;
use super::fitted::{Fitted, sockets, switches};
use super::fitting::Fitting;
use super::merge::Merged;
use super::opening_size::{casing, opening_heights};
use super::railing::RailingShape;
use super::skirting::{self, SkirtingShape};
use super::slab::SlabShape;
use super::slots::{FACADE_SLOT, RAILING_SLOT, SKIRTING_SLOT};
use super::stairs::{RAIL_HEIGHT, StairsShape};
use super::storey::Storey;
use super::ticks::Ticks;
use super::wall::{Cut, Hole, WallShape};
use super::{INSET, SLAB, Shape};
use crate::catalog::PaletteRef;
use crate::contract::{Extras, Part, PartExtras, PartId, owned_name};
use crate::geometry::{Convex, Point, Polygon, Region};
use crate::plan::{Flight, Level, Room, Stairs, Wall, WallKind, region_without};
use crate::recipes::{GeometrySet, Slot};
use crate::scene::axes::{Pose, angle_facing};
use crate::scene::extras::{corners, rounded};
use crate::scene::meshes::{Look, MeshTable};
use crate::scene::node::Node;

/// Railings at least this thick (metres) are parapets: low walls.
const PARAPET_FROM: f64 = 0.08;
/// Where walls begin.
const WALL_FOOT: Ticks = Ticks(INSET.0 - SLAB.0);
/// Sine of the angle below which walls run the same way, and metres below which they are equally long.
const PARALLEL: f64 = 0.02;
const ROUNDING: f64 = 1e-6;

/// How the shell of a room looks, and what it goes by.
pub(crate) struct Equipment<'p> {
    /// The look of its style.
    pub(crate) look: Look,
    /// Whether its parts are one mesh.
    pub(crate) is_merged: bool,
    /// The footprints of worktops at its walls: sockets are above them.
    pub(crate) worktops: &'p [Convex],
}

/// The nodes of a room's shell, in the order floor, ceiling, walls, skirting, columns, sockets, switches; where all but floor
/// and ceiling are merged, last the one that shows them.
pub(crate) fn room_parts<'a>(
    storey: &Storey<'_>,
    index: usize,
    finish: RoomFinish,
    equipment: &Equipment<'_>,
    meshes: &mut MeshTable<'a>,
) -> Vec<Node> {
    let Equipment { look, is_merged, worktops } = *equipment;
    let level = storey.level;
    let room = &level.rooms[index];
    let stairs = level.stairs_of(index);
    let origin = Pose::on_floor(room.region.outline.corners()[0], 0.0);
    let merged = is_merged.then(|| Merged::at(origin));
    let mut parts = RoomParts { room, palette: look.palette, origin, merged, meshes, nodes: Vec::new() };
    parts.slabs(level, finish, stairs);
    for (index, footprint) in footprints(storey, room).into_iter().enumerate() {
        parts.wall(level, index, footprint, finish);
    }
    parts.skirting(level, finish);
    parts.columns(finish.wall);
    parts.fittings(level, finish, look.geometry, worktops);
    parts.stairs(stairs, finish.floor);
    parts.finish()
}

struct RoomParts<'a, 'm, 'r> {
    room: &'r Room,
    palette: PaletteRef,
    /// Where the node stands that shows what is merged.
    origin: Pose,
    /// Walls and what is fixed to them; none where each part has its own mesh.
    merged: Option<Merged>,
    meshes: &'m mut MeshTable<'a>,
    nodes: Vec<Node>,
}

impl RoomParts<'_, '_, '_> {
    fn slabs(&mut self, level: &Level, finish: RoomFinish, stairs: Option<&Stairs>) {
        let region = &self.room.region;
        let anchor = region.outline.corners()[0];
        let well = stairs.and_then(|stairs| stairs.well.as_ref()).map(|well| &well.opening);
        let floor = SlabShape::of_regions(&around(region, well), anchor, [-SLAB, Ticks(0)], finish.floor);
        let floor = floor.laid_along(main_direction(&self.room.walls));
        self.part(PartExtras::of(PartId::only(Part::Floor)), Pose::on_floor(anchor, 0.0), Shape::Slab(floor));
        let thickness = storey_end(level, self.room).ceiling - Ticks::of(self.room.height);
        let above = stairs.and_then(|stairs| stairs.up.as_ref()).map(|flight| &flight.opening);
        let ceiling =
            SlabShape::of_regions(&around(region, above), anchor, [Ticks(0), thickness], finish.ceiling);
        let pose = Pose { position: anchor, elevation: self.room.height, angle: 0.0 };
        self.part(PartExtras::of(PartId::only(Part::Ceiling)), pose, Shape::Slab(ceiling));
    }

    fn wall(&mut self, level: &Level, index: usize, footprint: Footprint, finish: RoomFinish) {
        let wall = &self.room.walls[index];
        let pose = Pose::on_floor((wall.start + wall.end) / 2.0, angle_facing(wall.normal()));
        let holes = self.holes(level, index);
        let footprint = self.without_posts(level, index, footprint);
        let shape = match wall.kind {
            WallKind::Railing(height) if footprint.thickness < PARAPET_FROM => Shape::Railing(RailingShape {
                length: Ticks::of(wall.length()),
                thickness: Ticks::of(footprint.least_depth()),
                height: Ticks::of(height),
                gaps: holes.iter().map(|hole| (hole.from, hole.to)).collect(),
                slot: RAILING_SLOT,
            }),
            WallKind::Railing(height) => {
                self.body(wall_shape(wall, &footprint, Ticks::of(height), holes, finish))
            }
            WallKind::Solid => {
                let top = storey_end(level, self.room).walls;
                self.body(wall_shape(wall, &footprint, top, holes, finish))
            }
        };
        let id = PartId::numbered(Part::Wall, index);
        self.part(PartExtras { tags: wall.tags.clone(), ..PartExtras::of(id) }, pose, shape);
    }

    /// Where both sides of a corner are open, nothing stands there.
    fn without_posts(&self, level: &Level, index: usize, mut print: Footprint) -> Footprint {
        let wall = &self.room.walls[index];
        for is_start in [true, false] {
            let is_next =
                |other: &Wall| if is_start { other.end == wall.start } else { other.start == wall.end };
            let is_open = self.is_open_at(level, index, is_start)
                && self
                    .room
                    .walls
                    .iter()
                    .position(is_next)
                    .is_some_and(|next| self.is_open_at(level, next, !is_start));
            if is_open {
                print = print.square_at(is_start, wall.length());
            }
        }
        print
    }

    /// Whether a wall is open from floor to ceiling at its start, or at its end.
    fn is_open_at(&self, level: &Level, wall: usize, is_start: bool) -> bool {
        let (end, ceiling) = (Ticks::of(self.room.walls[wall].length()), Ticks::of(self.room.height));
        let is_at = |hole: &Hole| if is_start { hole.from <= Ticks(0) } else { hole.to >= end };
        self.holes(level, wall).iter().any(|hole| is_at(hole) && hole.low <= Ticks(0) && hole.high >= ceiling)
    }

    /// A wall by itself, or one of a mesh.
    fn body(&self, wall: WallShape) -> Shape {
        Shape::Wall(if self.merged.is_some() { wall.apart() } else { wall })
    }

    /// The holes of a wall, not above the ceiling.
    fn holes(&self, level: &Level, wall: usize) -> Vec<Hole> {
        let ceiling = Ticks::of(self.room.height);
        let openings = self.room.openings.iter().filter(|opening| opening.wall == wall);
        let hole = openings.map(|place| {
            let opening = &level.openings[place.opening];
            let (low, high) = opening_heights(level, opening);
            Hole { from: Ticks::of(place.from), to: Ticks::of(place.to), low, high: high.min(ceiling) }
        });
        hole.filter(|hole| hole.from < hole.to && hole.low < hole.high).collect()
    }

    /// Boards along plastered walls indoors: tiles, metal and concrete reach down to the floor.
    fn skirting(&mut self, level: &Level, finish: RoomFinish) {
        if self.is_outdoors() || finish.dado.is_some() || finish.wall != RoomFinish::PLAIN.wall {
            return;
        }
        let gaps = |wall: usize| {
            let places = self.room.openings.iter().filter(|place| place.wall == wall).map(|place| {
                let opening = &level.openings[place.opening];
                let casing = casing(level, opening).metres();
                let (low, _) = opening_heights(level, opening);
                (low, (place.from - casing, place.to + casing))
            });
            places.filter(|(low, _)| *low < skirting::HEIGHT).map(|(_, gap)| gap).collect()
        };
        let anchor = self.room.region.outline.corners()[0];
        let shape = SkirtingShape::along(&self.room.walls, gaps, anchor, SKIRTING_SLOT);
        if !shape.boards.is_empty() {
            let pose = Pose::on_floor(anchor, 0.0);
            self.part(PartExtras::of(PartId::only(Part::Skirting)), pose, Shape::Skirting(shape));
        }
    }

    /// Sockets and switches of a room indoors.
    fn fittings(&mut self, level: &Level, finish: RoomFinish, set: GeometrySet, worktops: &[Convex]) {
        if self.is_outdoors() {
            return;
        }
        let slot = if set == GeometrySet::Industrial { Slot::Metal } else { Slot::Plastic };
        let sockets = finish.sockets.map(|interval| sockets(level, self.room, interval, worktops));
        let mut fitted: Vec<Fitted> = sockets.unwrap_or_default();
        if finish.has_switches {
            fitted.extend(switches(level, self.room));
        }
        let mut counts: BTreeMap<(Fitting, usize), usize> = BTreeMap::new();
        for one in fitted {
            let number = counts.entry((one.fitting, one.wall)).or_insert(0);
            let id = PartId::on_wall(one.fitting.part(), one.wall, *number);
            *number += 1;
            let angle = angle_facing(self.room.walls[one.wall].normal());
            let pose = Pose { position: one.position, elevation: one.elevation, angle };
            self.part(PartExtras::of(id), pose, Shape::Fitting(one.fitting, slot));
        }
    }

    fn is_outdoors(&self) -> bool {
        self.room.walls.iter().any(|wall| wall.kind != WallKind::Solid)
    }

    fn columns(&mut self, slot: Slot) {
        // A column that ends at floor and ceiling reaches into both: faces in one plane flicker.
        let sunk = Ticks(SLAB.0 / 2);
        let ceiling = Ticks::of(self.room.height);
        for (index, obstacle) in self.room.obstacles.iter().enumerate() {
            let anchor = obstacle.outline.bounds().center();
            let height = Ticks::of(obstacle.height);
            let top = if height >= ceiling { ceiling + sunk } else { height };
            let region = Region::simple(obstacle.outline.clone());
            let shape = SlabShape::of_regions(&[region], anchor, [-sunk, top], slot);
            let extras = PartExtras {
                outline: Some(corners(&obstacle.outline)),
                height: Some(rounded(obstacle.height)),
                ..PartExtras::of(PartId::numbered(Part::Column, index))
            };
            self.part(extras, Pose::on_floor(anchor, 0.0), Shape::Slab(shape));
        }
    }

    /// Steps up, and the balustrade around the hole that one comes up through. Its outline is what it takes of the floor.
    fn stairs(&mut self, stairs: Option<&Stairs>, slot: Slot) {
        let Some(stairs) = stairs else { return };
        let Some(outline) = stairs.footprint() else { return };
        let (up, well) = (stairs.up.as_ref(), stairs.well.as_ref());
        let height = up.map_or(RAIL_HEIGHT, Flight::rise);
        let anchor = self.room.region.outline.corners()[0];
        let shape = StairsShape::of(up, well, anchor, slot);
        let extras = PartExtras {
            outline: Some(corners(outline)),
            height: Some(rounded(height)),
            ..PartExtras::of(PartId::only(Part::Stairs))
        };
        self.part(extras, Pose::on_floor(anchor, 0.0), Shape::Stairs(shape));
    }

    fn part(&mut self, extras: PartExtras, pose: Pose, shape: Shape) {
        let name = owned_name(&extras.id, &self.room.id);
        let has_own_mesh = matches!(extras.part, Part::Floor | Part::Ceiling | Part::Stairs);
        let mesh = match self.merged.as_mut().filter(|_| !has_own_mesh) {
            Some(merged) => {
                merged.add(shape, &pose, self.meshes);
                None
            }
            None => self.meshes.shell(shape, self.palette, &name),
        };
        self.nodes.push(Node::at(name, &pose, mesh, Extras::Part(extras)));
    }
}

impl RoomParts<'_, '_, '_> {
    /// The nodes; what is merged is shown by one more after them.
    fn finish(mut self) -> Vec<Node> {
        let Some(merged) = self.merged else { return self.nodes };
        let id = PartId::only(Part::Walls);
        let name = owned_name(&id, &self.room.id);
        if let Some(mesh) = merged.finish(self.palette, &name, self.meshes) {
            let extras = Extras::Part(PartExtras::of(id));
            self.nodes.push(Node::at(name, &self.origin, Some(mesh), extras));
        }
        self.nodes
    }
}

/// What is left of a floor or ceiling around a hole for stairs.
fn around(region: &Region, opening: Option<&Polygon>) -> Vec<Region> {
    opening.map_or_else(|| vec![region.clone()], |opening| region_without(region, opening))
}

/// Where a room's shell ends at the top.
struct StoreyEnd {
    ceiling: Ticks,
    walls: Ticks,
}

/// Ceilings are as thick as what lies between them and the storey above, and walls reach up to where its walls begin, so
/// that stacked storeys look whole from outside. Walls reach at least into the ceiling, so that no light passes the edge
/// between them.
fn storey_end(level: &Level, room: &Room) -> StoreyEnd {
    let (next_floor, ceiling) = (Ticks::of(level.height), Ticks::of(room.height));
    StoreyEnd {
        // A little below the floor above: faces in one plane flicker.
        ceiling: (next_floor - SLAB - INSET).max(ceiling + SLAB),
        walls: (next_floor + WALL_FOOT).max(ceiling + SLAB - INSET),
    }
}

/// The direction along which most metres of wall run, as a unit vector towards the east, or due north: floors are laid
/// along it.
fn main_direction(walls: &[Wall]) -> Point {
    let is_parallel = |one: Point, two: Point| one.perp_dot(two).abs() < PARALLEL;
    let mut longest = (0.0, Point::X);
    for direction in walls.iter().map(Wall::direction) {
        let alike = walls.iter().filter(|wall| is_parallel(wall.direction(), direction));
        let length: f64 = alike.map(Wall::length).sum();
        // Of equal lengths the first counts, however they are rounded.
        if length > longest.0 + ROUNDING {
            longest = (length, direction);
        }
    }
    let [x, y] = [Ticks::of(longest.1.x), Ticks::of(longest.1.y)];
    if x < Ticks(0) || (x == Ticks(0) && y < Ticks(0)) { -longest.1 } else { longest.1 }
}

fn wall_shape(wall: &Wall, print: &Footprint, top: Ticks, holes: Vec<Hole>, finish: RoomFinish) -> WallShape {
    let cut = |point: &Behind| Cut {
        inner: Ticks::of(point.inner),
        outer: [Ticks::of(point.outer.x), Ticks::of(point.outer.y)],
    };
    WallShape {
        length: Ticks::of(wall.length()),
        back: print.back.iter().map(cut).collect(),
        bottom: WALL_FOOT,
        top,
        holes,
        slot: finish.wall,
        outer_slot: if wall.is_exterior { FACADE_SLOT } else { finish.wall },
        dado: finish.dado,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction(corners: &[(f64, f64)]) -> Point {
        main_direction(&Wall::around(corners))
    }

    #[test]
    fn floors_are_laid_along_the_longest_walls() {
        assert_eq!(direction(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]), Point::X);
        assert_eq!(direction(&[(0.0, 0.0), (3.0, 0.0), (3.0, 4.0), (0.0, 4.0)]), Point::Y);
        let turned = direction(&[(0.0, 0.0), (3.2, 2.4), (1.4, 4.8), (-1.8, 2.4)]);
        assert!(turned.distance(Point::new(0.8, 0.6)) < 1e-12, "{turned}");
    }

    #[test]
    fn a_wall_in_pieces_counts_as_a_whole() {
        let pieces = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (3.0, 4.0), (0.0, 4.0), (0.0, 2.0)];
        assert_eq!(direction(&pieces), Point::Y);
    }
}
