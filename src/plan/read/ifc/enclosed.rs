//! Gives spaces without a body the area that walls enclose around their place, and cuts those that boundaries outline
//! back to the faces of the walls.

use geo::{Area, BooleanOps};

use super::columns::Products;
use super::footprint::Footprint;
use super::level::Storey;
use super::model::Entity;
use super::rooms::{Naming, drafted};
use crate::geometry::{Bounds, Point, ring_contains};
use crate::plan::assemble::BoxIndex;
use crate::plan::clean::{largest_part, ring_surface, to_points};
use crate::plan::read::walled::{SMALLEST_ROOM, WalledArea, are_tangled, joined, walled_areas};

/// Metres of the lowest wall that divides rooms.
const LOWEST_WALL: f64 = 1.8;
/// Share of a room that lies in walls before it is cut back: less is the error of coordinates.
const INTO_WALLS: f64 = 0.002;
/// Spaces of a storey that are looked for: each is compared with all rooms.
const MOST_SPACES: usize = 1_000;
const HINT: &str = "the room is left out; export spaces with their bodies, or with space boundaries";

/// The walls of a storey and the areas between them.
struct Enclosure {
    walls: Vec<Footprint>,
    areas: Vec<WalledArea>,
}

impl Products<'_> {
    /// Finds the rooms of spaces that have neither a body nor boundaries with a shape; those without walls all around
    /// are noted.
    pub(super) fn enclose(&self, storeys: &mut [Storey], naming: &mut Naming<'_>) {
        if storeys.iter().all(|storey| storey.bodiless.is_empty()) && naming.bounded.is_empty() {
            return;
        }
        let walls = self.walls();
        for storey in storeys {
            cut_back(storey, &walls, &naming.bounded);
            let spaces = std::mem::take(&mut storey.bodiless);
            let places = spaces.iter().filter_map(|space| self.floor_of(space));
            let lowest = places.map(|(_, floor)| floor).fold(f64::INFINITY, f64::min);
            if !storey.floor.is_finite() {
                storey.floor = lowest;
            }
            let enclosure = Enclosure::of(storey, &walls);
            naming.taken = storey.draft.rooms.iter().map(|room| room.id.clone()).collect();
            for (number, space) in spaces.iter().enumerate() {
                let found = match number < MOST_SPACES {
                    true => self.enclosed(space, storey, &enclosure),
                    false => Err(format!("{MOST_SPACES} others of its storey have none either")),
                };
                match found {
                    Ok(part) => {
                        let read = drafted(space, vec![part], naming);
                        storey.add(read);
                        naming.by_walls.push(space.id);
                    }
                    Err(reason) => {
                        let name = space.text(2).or(space.text(7)).unwrap_or_default();
                        let trouble = space.trouble(format!("it has no body, and {reason}"));
                        self.geometry.model.error(&trouble, &format!("space \"{name}\": "), HINT);
                    }
                }
            }
        }
    }

    /// The walls of a building that can be read; the others are noted with the storeys' own.
    fn walls(&self) -> Vec<Footprint> {
        let walls = self.all(&super::columns::WALLS);
        walls.filter_map(|wall| self.outlines(&wall).ok()).flatten().collect()
    }

    /// The place of a space on the floor, and the height of that floor.
    fn floor_of(&self, space: &Entity) -> Option<(Point, f64)> {
        let place = (self.frame * self.geometry.place(space).ok()?).translation;
        place.is_finite().then_some((place.truncate(), place.z))
    }

    /// The area around the place of a space, as high as the lowest wall beside it; or why there is none.
    fn enclosed(&self, space: &Entity, storey: &Storey, enclosure: &Enclosure) -> Result<Footprint, String> {
        let Some((place, _)) = self.floor_of(space) else { return Err("no place".to_owned()) };
        let low = storey.floor;
        let at = format!("({:.2}, {:.2})", place.x, place.y);
        if let Some(room) = storey.draft.rooms.iter().find(|room| ring_contains(&room.outline, place)) {
            return Err(format!("its place {at} lies in room \"{}\"", room.id));
        }
        let Some(area) = enclosure.areas.iter().find(|area| area.contains(place)) else {
            return Err(format!("no walls are all around its place {at}"));
        };
        let WalledArea { outline, holes } = area.clone();
        let around = bounds(&outline);
        let beside = enclosure.walls.iter().filter(|wall| bounds(&wall.outer).touches(around));
        let high = beside.map(|wall| wall.high).reduce(f64::min).unwrap_or(low);
        Ok(Footprint { outer: outline, holes, low, high })
    }
}

impl Enclosure {
    fn of(storey: &Storey, walls: &[Footprint]) -> Self {
        let walls: Vec<Footprint> = dividing(storey, walls).cloned().collect();
        let outlines: Vec<Vec<Point>> = walls.iter().flat_map(Footprint::pieces).collect();
        let is_tangled = are_tangled(&index(&outlines), outlines.iter().map(|outline| bounds(outline)));
        let all = outlines.iter().map(Vec::as_slice);
        let areas = if is_tangled { Vec::new() } else { walled_areas(&joined(all)) };
        Self { walls, areas }
    }
}

/// The walls that reach from the floor of a storey to above the heads of people.
fn dividing<'a>(storey: &Storey, walls: &'a [Footprint]) -> impl Iterator<Item = &'a Footprint> {
    let floor = storey.floor;
    let is_here = |wall: &&Footprint| storey.is_in_the_way(wall) && wall.high - floor >= LOWEST_WALL;
    walls.iter().filter(is_here).collect::<Vec<_>>().into_iter()
}

fn bounds(outline: &[Point]) -> Bounds {
    Bounds::around(outline.iter().copied())
}

fn index(outlines: &[Vec<Point>]) -> BoxIndex<usize> {
    BoxIndex::of(outlines.iter().map(|outline| bounds(outline)).zip(0..))
}

/// Cuts the rooms of spaces that are drawn into the walls of a storey back to the faces of these.
fn cut_back(storey: &mut Storey, walls: &[Footprint], spaces: &[u64]) {
    let outlines: Vec<Vec<Point>> = dividing(storey, walls).flat_map(Footprint::pieces).collect();
    let places = index(&outlines);
    if are_tangled(&places, outlines.iter().map(|outline| bounds(outline))) {
        return;
    }
    let rooms = spaces.iter().filter_map(|space| storey.rooms_of.get(space)).flatten();
    for room in rooms {
        let room = &mut storey.draft.rooms[*room];
        let near = places.near(bounds(&room.outline)).into_iter().map(|wall| outlines[wall].as_slice());
        let whole = ring_surface(&room.outline);
        let Some((rest, _)) = largest_part(whole.difference(&joined(near))) else { continue };
        if rest.unsigned_area() < SMALLEST_ROOM
            || rest.unsigned_area() > whole.unsigned_area() * (1.0 - INTO_WALLS)
        {
            continue;
        }
        room.outline = to_points(rest.exterior());
        room.holes.extend(rest.interiors().iter().map(to_points));
    }
}
