//! Gives spaces without a body the area that walls enclose around their place.

use super::columns::Products;
use super::footprint::Footprint;
use super::level::Storey;
use super::model::Entity;
use super::rooms::{Naming, drafted};
use crate::geometry::{Bounds, Point, ring_contains};
use crate::plan::assemble::BoxIndex;
use crate::plan::read::walled::{WalledArea, are_tangled, joined, walled_areas};

/// Metres of the lowest wall that reaches the ceiling: lower ones divide no rooms.
const LOWEST_WALL: f64 = 1.8;
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
        if storeys.iter().all(|storey| storey.bodiless.is_empty()) {
            return;
        }
        let walls = self.walls();
        for storey in storeys {
            let spaces = std::mem::take(&mut storey.bodiless);
            let places = spaces.iter().filter_map(|space| self.floor_of(space));
            let lowest = places.map(|(_, floor)| floor).fold(f64::INFINITY, f64::min);
            if !storey.floor.is_finite() {
                storey.floor = lowest;
            }
            let enclosure = enclosure(storey, &walls);
            naming.taken = storey.draft.rooms.iter().map(|room| room.id.clone()).collect();
            for space in &spaces {
                match self.enclosed(space, storey, &enclosure) {
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
        let bounds = Bounds::around(outline.iter().copied());
        let beside = enclosure.walls.iter().filter(|wall| {
            let wall = Bounds::around(wall.outer.iter().copied());
            wall.touches(bounds)
        });
        let tops = beside.map(|wall| wall.high).filter(|high| high - low >= LOWEST_WALL);
        let high = tops.reduce(f64::min).unwrap_or(low);
        Ok(Footprint { outer: outline, holes, low, high })
    }
}

fn enclosure(storey: &Storey, walls: &[Footprint]) -> Enclosure {
    let walls: Vec<Footprint> = walls.iter().filter(|wall| storey.is_in_the_way(wall)).cloned().collect();
    let outlines: Vec<Vec<Point>> = walls.iter().flat_map(Footprint::pieces).collect();
    let boxes = || outlines.iter().map(|outline| Bounds::around(outline.iter().copied()));
    let is_tangled = are_tangled(&BoxIndex::of(boxes().zip(0..)), boxes());
    let all = outlines.iter().map(Vec::as_slice);
    let areas = if is_tangled { Vec::new() } else { walled_areas(&joined(all)) };
    Enclosure { walls, areas }
}
