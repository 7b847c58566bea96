//! Turns honeybee's rooms, which are bodies of faces, into spaces: floors seen from above, walls as edges.

use glam::DVec3;

use super::floor::{Part, floor_parts};
use super::model::{Edge, Hole, Place, Space, part};
use super::notes::{MULTIPLIED, Notes, PLENUM, SLOPING};
use super::room_types::is_plenum;
use super::schema::{BoundaryCondition, Face, Properties, Room, SubFace};
use crate::geometry::{Point, Segment};

/// Cosine between the normal of a face and the vertical above which it is a floor or ceiling, and no wall.
const LYING: f64 = 0.7;
/// Metres of the lowest ceiling: under a slope people stand where it is higher.
const LOWEST_CEILING: f64 = 2.0;
/// Metres by which a ceiling may rise and count as flat.
const FLAT: f64 = 0.02;

/// A face with its corners in metres.
struct Turned<'a> {
    face: &'a Face,
    corners: Vec<DVec3>,
    /// Of length 1, or zero for a face without area.
    normal: DVec3,
}

impl Turned<'_> {
    fn is_lying(&self) -> bool {
        self.normal.z.abs() > LYING
    }

    fn is(&self, kind: &str) -> bool {
        self.face.face_type == kind
    }

    fn heights(&self) -> impl Iterator<Item = f64> + '_ {
        self.corners.iter().map(|corner| corner.z)
    }
}

/// The spaces of rooms with the name of their storey; one room is several spaces where its floor lies in parts.
pub(super) fn spaces(
    rooms: &[Room],
    unit: f64,
    place: &Place,
    notes: &mut Notes,
) -> Vec<(Option<String>, Space)> {
    let mut spaces = Vec::new();
    for (number, room) in rooms.iter().enumerate() {
        let place = part(place, [number.into()]);
        let program = Properties::program(room.properties.as_ref());
        if is_plenum(room.display_name.as_deref(), program.as_deref()) {
            notes.count(PLENUM, || place);
            continue;
        }
        if room.multiplier.is_some_and(|multiplier| multiplier > 1) {
            notes.count(MULTIPLIED, || part(&place, ["multiplier".into()]));
        }
        let found = of_room(room, unit, &place, notes);
        spaces.extend(found.into_iter().map(|space| (room.story.clone(), space)));
    }
    spaces
}

fn of_room(room: &Room, unit: f64, place: &Place, notes: &mut Notes) -> Vec<Space> {
    let faces: Vec<Turned<'_>> = room.faces.iter().map(|face| turned(face, unit)).collect();
    let floors = floors(&faces);
    let parts = match floor_parts(floors.iter().map(|floor| (&floor.face.geometry, unit))) {
        Ok(parts) => parts,
        Err(fact) => {
            let message = format!("room \"{}\" {fact}", room.identifier);
            notes.error(&part(place, ["faces".into()]), message, "the room is left out; draw its floor flat");
            return Vec::new();
        }
    };
    let lowest = |heights: &mut dyn Iterator<Item = f64>| heights.fold(f64::INFINITY, f64::min);
    let floor = lowest(&mut floors.iter().flat_map(|floor| floor.heights()));
    let height = ceiling(&faces, floor, place, notes);
    let mut edges = vec![Vec::new(); parts.len()];
    for edge in faces.iter().filter_map(|face| edge(face, floor, unit)) {
        edges[part_beside(&parts, &edge)].push(edge);
    }
    let parts = parts.into_iter().zip(edges).enumerate();
    let spaces = parts.map(|(number, (Part { outline, holes }, edges))| Space {
        identifier: room.identifier.clone(),
        id: if number == 0 { room.identifier.clone() } else { format!("{}.{}", room.identifier, number + 1) },
        name: room.display_name.clone(),
        program: Properties::program(room.properties.as_ref()),
        floor,
        height,
        outline,
        holes,
        edges,
        place: place.clone(),
    });
    spaces.collect()
}

/// The part of a floor that a wall stands at.
fn part_beside(parts: &[Part], edge: &Edge) -> usize {
    if parts.len() == 1 {
        return 0;
    }
    let middle = edge.start.midpoint(edge.end);
    let distance = |part: &Part| {
        let ends = part.outline.iter().zip(part.outline.iter().cycle().skip(1));
        let distances = ends.map(|(&start, &end)| Segment::new(start, end).nearest(middle).distance(middle));
        distances.fold(f64::INFINITY, f64::min)
    };
    let nearest =
        (0..parts.len()).min_by(|&one, &two| distance(&parts[one]).total_cmp(&distance(&parts[two])));
    nearest.unwrap_or_default()
}

fn turned(face: &Face, unit: f64) -> Turned<'_> {
    let corners: Vec<DVec3> =
        face.geometry.boundary.iter().map(|&corner| DVec3::from(corner) * unit).collect();
    let first = corners.first().copied().unwrap_or_default();
    let next = corners.iter().copied().cycle().skip(1);
    // The sum of all sides' triangles: corners on one line do not matter.
    let twice: DVec3 = corners.iter().zip(next).map(|(&one, two)| (one - first).cross(two - first)).sum();
    Turned { face, normal: twice.normalize_or_zero(), corners }
}

/// The floors of a room: where it has none, the lowest of the faces that lie, as where it is open to the room below.
fn floors<'a, 'b>(faces: &'b [Turned<'a>]) -> Vec<&'b Turned<'a>> {
    let drawn: Vec<&Turned<'a>> = faces.iter().filter(|face| face.is("Floor")).collect();
    if !drawn.is_empty() {
        return drawn;
    }
    let lying = || faces.iter().filter(|face| face.is("AirBoundary") && face.is_lying());
    let lowest = lying().flat_map(Turned::heights).fold(f64::INFINITY, f64::min);
    lying().filter(|face| face.heights().all(|height| height <= lowest + FLAT)).collect()
}

/// Metres from the floor to the lowest part of the ceiling, but 2 m at least where some of it is higher.
fn ceiling(faces: &[Turned<'_>], floor: f64, place: &Place, notes: &mut Notes) -> f64 {
    let range = |heights: &mut dyn Iterator<Item = f64>| {
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)))
    };
    let (_, highest) = range(&mut faces.iter().flat_map(Turned::heights));
    let (low, high) =
        range(&mut faces.iter().filter(|face| face.is("RoofCeiling")).flat_map(Turned::heights));
    // Without a roof of its own, as below an air boundary, all of the room is high.
    let (low, high) = if low.is_finite() { (low, high.max(low)) } else { (highest, highest) };
    if high - low > FLAT {
        notes.count(SLOPING, || place.clone());
    }
    (low - floor).max(LOWEST_CEILING.min(high - floor))
}

/// A wall as an edge; its holes are those of its apertures and doors.
fn edge(face: &Turned<'_>, floor: f64, unit: f64) -> Option<Edge> {
    let is_wall = face.is("Wall") || (face.is("AirBoundary") && !face.is_lying());
    let outwards = Point::new(face.normal.x, face.normal.y).try_normalize().filter(|_| is_wall)?;
    // Seen from above, rooms lie to the left of their edges.
    let along = outwards.perp();
    let foot = face.corners.iter().copied().reduce(|low, next| if next.z < low.z { next } else { low })?;
    let places = face.corners.iter().map(|corner| (corner.truncate() - foot.truncate()).dot(along));
    let (low, high) =
        places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    let start = foot.truncate() + along * low;
    let frame = Frame { start, along, floor, unit };
    let Face { apertures, doors, boundary_condition, .. } = face.face;
    let windows = apertures.iter().flatten().map(|window| frame.hole(window, false));
    let doors = doors.iter().flatten().map(|door| frame.hole(door, true));
    Some(Edge {
        start,
        end: foot.truncate() + along * high,
        far: boundary_condition.as_ref().and_then(BoundaryCondition::room).cloned(),
        is_open: face.is("AirBoundary"),
        holes: windows.chain(doors).collect(),
    })
}

/// The plane of a wall.
struct Frame {
    start: Point,
    /// Of length 1.
    along: Point,
    /// Metres of the floor of the room.
    floor: f64,
    unit: f64,
}

impl Frame {
    fn hole(&self, sub: &SubFace, is_door: bool) -> Hole {
        let corners = sub.geometry.boundary.iter().map(|&corner| {
            let corner = DVec3::from(corner) * self.unit;
            ((corner.truncate() - self.start).dot(self.along), corner.z - self.floor)
        });
        Hole::around(sub.identifier.clone(), is_door, corners)
    }
}
