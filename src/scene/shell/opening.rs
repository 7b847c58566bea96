//! Doors, windows, passages and open boundaries.

use super::behind::least_depth;
use super::finish::RoomFinish;
use super::frame::Reveal;
use super::leaf::{LeafDesign, LeafShape};
use super::merge::Merged;
use super::opening_size::{casing, opening_heights};
use super::slots::{FRAME_SLOT, RAILING_SLOT};
use super::storey::Storey;
use super::thickness::built_thickness;
use super::ticks::Ticks;
use super::{SLAB, Shape};
use crate::catalog::PaletteRef;
use crate::contract::{Extras, Part, PartExtras, PartId, owned_name};
use crate::geometry::Point;
use crate::layout::opening_id;
use crate::plan::{Leaf, Level, Opening, OpeningKind, OpeningSide, Wall, WallKind};
use crate::recipes::Slot;
use crate::scene::axes::{Pose, angle_along, angle_facing, axes_at};
use crate::scene::extras::opening_extras;
use crate::scene::meshes::{Look, MeshTable};
use crate::scene::node::Node;
use crate::scene::options::Parts;

/// Depth of an opening that is in no wall.
const FREE_STANDING: f64 = 0.1;
/// Narrowest common span of both sides' holes that is taken for the opening's own width.
const LEAST_SPAN: f64 = 0.05;
/// Metres that a frame may stand further out of a wall at one end, where the walls of both rooms are not parallel.
const SKEW: f64 = 0.01;

/// How openings look.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OpeningLook {
    /// Of the first room.
    pub finish: RoomFinish,
    /// Of that room's style.
    pub look: Look,
    /// Degrees by which leaves stand open; as far as they go where nothing is said.
    pub door_angle: Option<u16>,
    /// Whether frame, sill and threshold are one mesh.
    pub parts: Parts,
}

/// The node of an opening with its pieces. It faces the first room it joins.
pub(crate) fn opening_node<'a>(
    storey: &Storey<'_>,
    opening: &Opening,
    &OpeningLook { finish, look, door_angle, parts }: &OpeningLook,
    meshes: &mut MeshTable<'a>,
) -> Node {
    let level = storey.level;
    let facing = opening.sides.first().map_or(opening.along.perp(), |side| wall_of(level, side).normal());
    let pose = Pose::on_floor(opening.center, angle_facing(facing));
    let hole = Hole::of(storey, opening, &pose);
    let name = opening_id(opening).to_string();
    let casing = casing(level, opening);
    let (threshold, reveal) = (hole.reveal(), hole.between_faces(casing.metres()).reveal());
    let mut pieces = Pieces {
        owner: &name,
        origin: pose,
        palette: look.palette,
        design: leaf_design(level, opening, look),
        casing,
        door_angle,
        merged: (parts == Parts::Merged).then(|| Merged::at(pose)),
        meshes,
        nodes: Vec::new(),
    };
    if opening.kind.is_walkable() {
        pieces.threshold(threshold, finish.floor);
    }
    match opening.kind {
        OpeningKind::Door => pieces.door(opening, reveal),
        OpeningKind::SlidingDoor => pieces.sliding_door(reveal),
        OpeningKind::Passage => pieces.frame(reveal),
        OpeningKind::OpenBoundary => {}
        OpeningKind::Window => pieces.window(reveal, opening.sides.len() == 1),
    }
    let children = pieces.finish();
    let mut node = Node::at(name, &pose, None, opening_extras(level, opening));
    node.children = children;
    node
}

fn wall_of<'l>(level: &'l Level, side: &OpeningSide) -> &'l crate::plan::Wall {
    &level.rooms[side.room].walls[side.wall]
}

/// Leaves to balconies and the like are glazed, others as the style has them.
fn leaf_design(level: &Level, opening: &Opening, look: Look) -> LeafDesign {
    let is_railing = |wall: &Wall| wall.kind != WallKind::Solid;
    let is_outdoors = opening.sides.iter().any(|side| level.rooms[side.room].walls.iter().any(is_railing));
    if is_outdoors { LeafDesign::Glazed } else { LeafDesign::of_set(look.geometry) }
}

/// The hole through all walls of an opening, in the frame of its node. Metres.
struct Hole {
    /// Along the wall.
    across: [f64; 2],
    /// Through the wall, where its faces are in the middle of the opening.
    through: [f64; 2],
    /// Metres that each face comes nearer to the other for each metre from the middle, at one side.
    lean: [f64; 2],
    heights: (Ticks, Ticks),
}

impl Hole {
    fn of(storey: &Storey<'_>, opening: &Opening, pose: &Pose) -> Self {
        let level = storey.level;
        let (axis, back) = axes_at(pose.angle);
        let local = |point: Point| (point - opening.center).dot(axis);
        let depth = |point: Point| -(point - opening.center).dot(back);
        let (mut across, mut lean) = ([f64::NEG_INFINITY, f64::INFINITY], [0.0; 2]);
        let mut through = [f64::INFINITY, f64::NEG_INFINITY];
        for side in &opening.sides {
            let wall = wall_of(level, side);
            let ends = [side.from, side.to].map(|at| wall.after(at));
            let [low, high] = [local(ends[0]).min(local(ends[1])), local(ends[0]).max(local(ends[1]))];
            across = [across[0].max(low), across[1].min(high)];
            let inner = depth((ends[0] + ends[1]) / 2.0);
            // Towards the far side of this room's part of the wall.
            let thick = least_depth(storey, wall, [side.from, side.to], built_thickness(wall));
            let facing = wall.normal().dot(-back);
            let outer = inner - facing * thick;
            through = [through[0].min(inner).min(outer), through[1].max(inner).max(outer)];
            let slope = (depth(ends[1]) - depth(ends[0])).abs() / (high - low).max(f64::EPSILON);
            let face = usize::from(facing > 0.0);
            lean[face] = slope.max(lean[face]);
        }
        if across[1] - across[0] < LEAST_SPAN || !(across[1] - across[0]).is_finite() {
            across = [-opening.width / 2.0, opening.width / 2.0];
        }
        if opening.sides.is_empty() {
            through = [-FREE_STANDING / 2.0, FREE_STANDING / 2.0];
        }
        let (bottom, top) = opening_heights(level, opening);
        Self { across, through, lean, heights: (bottom.max(Ticks(0)), top) }
    }

    /// The part of the hole in which a box with boards of the width `casing` beside it stands hardly out of walls that are
    /// not parallel.
    fn between_faces(self, casing: f64) -> Self {
        let half = (self.across[1] - self.across[0]) / 2.0 + casing;
        let [low, high] = self.lean.map(|lean| (lean * half - SKEW).max(0.0));
        let [back, front] = self.through;
        let front = front - high;
        Self { through: [(back + low).min(front), front], ..self }
    }

    fn reveal(&self) -> Reveal {
        let ([left, right], [back, front]) = (self.across.map(Ticks::of), self.through.map(Ticks::of));
        Reveal { left, right, bottom: self.heights.0, top: self.heights.1, back, front }
    }
}

/// The direction of a leaf that is opened by an angle in radians from `shut` towards `open`, at most so far.
fn opened(shut: Point, open: Point, angle: f64) -> Point {
    let swing = shut.angle_to(open);
    Point::from_angle(swing.clamp(-angle, angle)).rotate(shut)
}

/// Children of an opening's node.
struct Pieces<'a, 'm, 'n> {
    owner: &'n str,
    origin: Pose,
    palette: PaletteRef,
    design: LeafDesign,
    casing: Ticks,
    door_angle: Option<u16>,
    /// The parts that never move; none where each part has its own mesh.
    merged: Option<Merged>,
    meshes: &'m mut MeshTable<'a>,
    nodes: Vec<Node>,
}

impl Pieces<'_, '_, '_> {
    fn door(&mut self, opening: &Opening, reveal: Reveal) {
        self.frame(reveal);
        let count = opening.leaves.len();
        for (index, leaf) in opening.leaves.iter().enumerate() {
            let id = PartId { number: (count > 1).then_some(index + 1), ..PartId::only(Part::Leaf) };
            self.leaf(id, leaf, reveal.top, count == 1);
        }
    }

    /// The leaf stands as far open as is asked for, and no further than the plan lets it.
    fn leaf(&mut self, id: PartId, leaf: &Leaf, top: Ticks, meets_jamb: bool) {
        let (shut, open) = (leaf.closed_tip - leaf.hinge, leaf.open_tip - leaf.hinge);
        let length = shut.length();
        if open.length() <= f64::EPSILON || length <= f64::EPSILON {
            return;
        }
        // The body lies behind the hinge line, on the side it does not open to.
        let body_on_front = shut.perp_dot(open) > 0.0;
        let shape =
            LeafShape { length: Ticks::of(length), top, body_on_front, meets_jamb, design: self.design };
        let tip = self.door_angle.map_or(open, |degrees| opened(shut, open, f64::from(degrees).to_radians()));
        let pose = Pose::on_floor(leaf.hinge, angle_along(tip));
        self.piece(id, &pose, Shape::Leaf(shape));
    }

    fn sliding_door(&mut self, reveal: Reveal) {
        self.frame(reveal);
        let slot = if self.design == LeafDesign::Steel { RAILING_SLOT } else { FRAME_SLOT };
        for second in [false, true] {
            let id = PartId::numbered(Part::Leaf, if second { 2 } else { 1 });
            self.piece_here(id, Shape::SlidingPanel(reveal, second, slot));
        }
    }

    fn frame(&mut self, reveal: Reveal) {
        self.piece_here(PartId::only(Part::Frame), Shape::DoorFrame(reveal, self.casing));
    }

    fn threshold(&mut self, reveal: Reveal, floor: Slot) {
        if reveal.bottom <= Ticks(0) && reveal.front - reveal.back > Ticks(0) {
            let shape = Shape::Threshold(Reveal { top: SLAB, ..reveal }, floor);
            self.piece_here(PartId::only(Part::Threshold), shape);
        }
    }

    fn window(&mut self, reveal: Reveal, is_exterior: bool) {
        self.piece_here(PartId::only(Part::Frame), Shape::WindowFrame(reveal));
        self.piece_here(PartId::only(Part::Glass), Shape::WindowGlass(reveal));
        if reveal.bottom > Ticks(0) {
            self.piece_here(PartId::only(Part::Sill), Shape::Sill(reveal, is_exterior));
        }
    }

    fn piece_here(&mut self, id: PartId, shape: Shape) {
        let pose = self.origin;
        self.piece(id, &pose, shape);
    }

    /// Adds a piece unless the opening is too small for it.
    fn piece(&mut self, id: PartId, pose: &Pose, shape: Shape) {
        let name = owned_name(&id, self.owner);
        let moves = matches!(id.part, Part::Leaf | Part::Glass);
        let mesh = match self.merged.as_mut().filter(|_| !moves) {
            Some(merged) => merged.add(shape, pose, self.meshes).then_some(None),
            None => self.meshes.shell(shape, self.palette, &name).map(Some),
        };
        let Some(mesh) = mesh else { return };
        let extras = Extras::Part(PartExtras::of(id));
        self.nodes.push(Node::at(name, &pose.relative_to(&self.origin), mesh, extras));
    }

    /// The nodes; the frame, or else the first piece that never moves, shows all such pieces.
    fn finish(mut self) -> Vec<Node> {
        let is_frame =
            |node: &Node| matches!(&node.extras, Some(Extras::Part(part)) if part.part == Part::Frame);
        let frame = self.nodes.iter().position(is_frame);
        let shown = frame.or_else(|| self.nodes.iter().position(|node| node.mesh.is_none()));
        if let (Some(merged), Some(shown)) = (self.merged, shown) {
            let node = &mut self.nodes[shown];
            node.mesh = merged.finish(self.palette, &node.name, self.meshes);
        }
        self.nodes
    }
}
