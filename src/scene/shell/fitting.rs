//! The shapes of sockets and light switches.

use glam::Vec3;

use super::solid::Solid;
use super::ticks::Ticks;
use crate::contract::Part;
use crate::recipes::Slot;

/// A fitting of a wall, in its own frame: the origin on the wall's face in the middle of the plate, +Z into the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Fitting {
    /// A plate with a round well and two holes.
    Socket,
    /// A plate with a rocker.
    Switch,
}

/// Half of a plate's side at the wall and in front, and its thickness: the usual plates of 80 mm.
pub(super) const PLATE: Ticks = Ticks(4_000);
const PLATE_FRONT: Ticks = Ticks(3_700);
const PLATE_DEPTH: Ticks = Ticks(900);
/// Radius of the well, and its components towards a corner; where its bottom is.
const WELL: Ticks = Ticks(1_950);
const WELL_SLANT: Ticks = Ticks(1_379);
const WELL_BOTTOM: Ticks = Ticks(200);
/// Holes for pins, 19 mm apart: half of the distance, half of the side, and from where to where they are dark.
const PIN: [Ticks; 4] = [Ticks(950), Ticks(250), Ticks(100), Ticks(250)];
/// Half of a rocker's side, where it begins, and how far it stands out below and above.
const ROCKER: [Ticks; 4] = [Ticks(2_800), Ticks(800), Ticks(1_050), Ticks(1_400)];
/// Slot of holes.
const HOLE_SLOT: Slot = Slot::PlasticDark;

/// Corners of a rectangle at four depths: right above, left above, left below, right below; counter-clockwise as seen from
/// the room.
fn rectangle(half: Ticks, depths: [Ticks; 4]) -> [Vec3; 4] {
    let signs = [(1, 1), (-1, 1), (-1, -1), (1, -1)];
    [0, 1, 2, 3].map(|corner| {
        let (x, y) = signs[corner];
        Vec3::new(Ticks(x * half.0).narrow(), Ticks(y * half.0).narrow(), depths[corner].narrow())
    })
}

/// The corners of the well, from the right counter-clockwise.
fn well(depth: Ticks) -> [Vec3; 8] {
    let (far, slant, none) = (WELL, WELL_SLANT, Ticks(0));
    let corners = [
        [far, none],
        [slant, slant],
        [none, far],
        [-slant, slant],
        [-far, none],
        [-slant, -slant],
        [none, -far],
        [slant, -slant],
    ];
    corners.map(|[x, y]| Vec3::new(x.narrow(), y.narrow(), depth.narrow()))
}

/// The four faces between two rectangles, the second before the first.
fn sides(back: [Vec3; 4], front: [Vec3; 4], solid: &mut Solid) {
    for corner in 0..4 {
        let next = (corner + 1) % 4;
        solid.face(&[back[corner], back[next], front[next], front[corner]]);
    }
}

/// A closed block between two rectangles.
fn block(back: [Vec3; 4], front: [Vec3; 4], solid: &mut Solid) {
    sides(back, front, solid);
    solid.face(&front);
    let [a, b, c, d] = back;
    solid.face(&[d, c, b, a]);
}

impl Fitting {
    /// The part that it is.
    pub(crate) fn part(self) -> Part {
        match self {
            Self::Socket => Part::Socket,
            Self::Switch => Part::Switch,
        }
    }

    /// The plate and what moves in the slot, then what is dark.
    pub(crate) fn build(self, slot: Slot) -> [Solid; 2] {
        let (mut plate, mut holes) = (Solid::new(slot), Solid::new(HOLE_SLOT));
        let back = rectangle(PLATE, [Ticks(0); 4]);
        let front = rectangle(PLATE_FRONT, [PLATE_DEPTH; 4]);
        match self {
            Self::Switch => {
                block(back, front, &mut plate);
                let [half, begin, below, above] = ROCKER;
                let face = rectangle(half, [above, above, below, below]);
                block(rectangle(half, [begin; 4]), face, &mut plate);
            }
            Self::Socket => {
                sides(back, front, &mut plate);
                let [a, b, c, d] = back;
                plate.face(&[d, c, b, a]);
                dig_well(front, &mut plate);
                let [distance, half, low, high] = PIN;
                for x in [-distance, distance] {
                    holes.cuboid([x - half, -half, low], [x + half, half, high]);
                }
            }
        }
        [plate, holes]
    }
}

/// The front of a plate around its well, and the well.
fn dig_well(front: [Vec3; 4], solid: &mut Solid) {
    let (rim, bottom) = (well(PLATE_DEPTH), well(WELL_BOTTOM));
    for corner in 0..4 {
        let [before, at, after] = [2 * corner, 2 * corner + 1, (2 * corner + 2) % 8].map(|index| rim[index]);
        solid.face(&[before, front[corner], at]);
        solid.face(&[at, front[corner], after]);
        solid.face(&[after, front[corner], front[(corner + 1) % 4]]);
    }
    for corner in 0..8 {
        let next = (corner + 1) % 8;
        solid.face(&[rim[corner], rim[next], bottom[next], bottom[corner]]);
    }
    solid.face(&bottom);
}
