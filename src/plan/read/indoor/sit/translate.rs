//! Makes drafts of buildings from the parts of a map.

use std::collections::{BTreeMap, BTreeSet};

use super::WORDS;
use super::houses::{House, houses};
use super::levels::LevelNumber;
use super::mapped::Mapped;
use super::sort::{Door, Sorted, Space, corners, sorted};
use super::walls::{Fit, PlaceKey, fitted, key_of, on_plane};
use crate::document::{Fault, Faults};
use crate::geometry::Point;
use crate::plan::read::foreign::{TypeOfWord, unknown_words};
use crate::plan::read::geojson::plane_around;
use crate::plan::read::indoor::remarks::Remarks;
use crate::plan::read::indoor::storey::{STOREY_HEIGHT, Storey, opening};
use crate::plan::read::native::number_of_id;
use crate::plan::read::osm::ATTRIBUTION;
use crate::plan::read::reader::{DraftedBuilding, ReadBuildings, ReadResult};
use crate::plan::read::rings::Rings;
use crate::plan::units::{LocalPlane, length_of_words};
use crate::plan::{
    BuildingDraft, GENERIC_ROOM_TYPE, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, RoomWords,
    SiteOrigin, SitePlacement,
};

/// Metres of a door, and of the main entrance of a building, where the map does not say.
const DOOR_WIDTHS: (f64, f64) = (0.9, 1.6);
/// Metres of a door that are believed.
const BELIEVED_WIDTHS: std::ops::RangeInclusive<f64> = 0.5..=12.0;
/// Metres from floor to floor that are believed where height and storeys of a building are known.
const BELIEVED_HEIGHTS: std::ops::RangeInclusive<f64> = 2.5..=8.0;
/// Rooms that are looked at for a door: more than these meet in no corner.
const MOST_AT_CORNER: usize = 64;

/// All buildings with rooms, and warnings about what was left out.
pub(super) fn buildings(
    mapped: Vec<Mapped>,
    (words, own_id): (&RoomWords, &str),
    mut remarks: Remarks,
    fault: &dyn Fn(u64, &str) -> Fault,
) -> ReadResult {
    let sorted = sorted(mapped, &mut remarks);
    let all: Vec<Point> =
        sorted.spaces.iter().flat_map(|space| space.areas.iter().flat_map(corners)).collect();
    let Some(plane) = plane_around(&all) else {
        let mut faults = remarks.into_faults(fault);
        let message = "the file has no room that is anywhere on Earth";
        faults.push(fault(0, message).with_hint("rooms are closed ways with indoor=room, corridor or area"));
        return Err(faults);
    };
    let houses = houses(&sorted, &plane, own_id);
    let doors: BTreeSet<PlaceKey> = sorted.doors.iter().map(|door| key_of(door.at)).collect();
    let on_plane = |area: &Rings| on_plane(area, &plane, &doors);
    let areas = sorted.spaces.iter().map(|space| space.areas.iter().map(on_plane).collect()).collect();
    let mut translation = Translation { sorted: &sorted, areas, plane, words, unknown: BTreeMap::new() };
    let mut openings = translation.openings(&houses, &mut remarks);
    let drafted = houses.iter().zip(&mut openings);
    let buildings = drafted.map(|(house, openings)| translation.building(house, openings)).collect();
    let mut faults = Faults::default();
    for (place, message, hint) in unknown_words(WORDS, &translation.unknown) {
        faults.push(fault(*place, &message).with_hint(hint).as_warning());
    }
    faults.merge(remarks.into_faults(fault));
    let origin = plane.degrees(Point::ZERO);
    let read = ReadBuildings::new(buildings, faults)?;
    Ok(ReadBuildings { origin: SiteOrigin::at(origin.x, origin.y, 0.0), ..read })
}

/// Openings of a building by level.
type Openings = BTreeMap<LevelNumber, Vec<OpeningDraft>>;

struct Translation<'a> {
    sorted: &'a Sorted,
    /// The areas of the spaces on the plane, without corners that are nothing but doors.
    areas: Vec<Vec<Rings>>,
    plane: LocalPlane,
    words: &'a RoomWords,
    /// Word without a room type → (place of its first room, how many).
    unknown: BTreeMap<String, (u64, usize)>,
}

impl Translation<'_> {
    fn building(&mut self, house: &House<'_>, openings: &mut Openings) -> DraftedBuilding {
        let height = house.outline.map_or(STOREY_HEIGHT, storey_height);
        let mut rooms: BTreeMap<LevelNumber, Vec<RoomDraft>> = BTreeMap::new();
        for &space in &house.spaces {
            let drafts = self.rooms(space, house.position);
            for level in &self.sorted.spaces[space].levels {
                rooms.entry(*level).or_default().extend(drafts.iter().cloned());
            }
        }
        let storey = |(level, rooms): (LevelNumber, Vec<RoomDraft>)| {
            let storey = Storey {
                id: level.id(),
                name: self.sorted.level_names.get(&level).cloned().unwrap_or_default(),
                elevation: level.storeys() * height,
                height,
                rooms,
                openings: openings.remove(&level).unwrap_or_default(),
            };
            storey.into()
        };
        let levels = rooms.into_iter().map(storey).collect();
        let name = house.outline.and_then(|outline| outline.tag("name")).map(str::to_owned);
        DraftedBuilding {
            id: house.id.clone(),
            draft: BuildingDraft {
                name,
                attribution: Some(ATTRIBUTION.to_owned()),
                levels,
                ..BuildingDraft::default()
            },
            placement: SitePlacement { position: house.position, turn: 0.0 },
            is_settled: true,
        }
    }

    /// The rooms of a space: one, or several where it has parts.
    fn rooms(&mut self, number: usize, origin: Point) -> Vec<RoomDraft> {
        let space = &self.sorted.spaces[number];
        let TypeOfWord { room_type, unknown_word } = self.room_type(space);
        let name = space.mapped.tag("name").or(space.mapped.tag("ref")).map(str::to_owned);
        let moved =
            |ring: &Vec<Point>| -> Vec<Point> { ring.iter().map(|corner| *corner - origin).collect() };
        let room = |(part, area): (usize, &Rings)| {
            let own = &space.mapped.id;
            let id = if part == 0 { own.clone() } else { format!("{own}.{}", part + 1) };
            RoomDraft {
                number: Some(number_of_id(&id)),
                id,
                name: name.clone(),
                room_type: room_type.clone(),
                unknown_word: unknown_word.clone(),
                outline: moved(&area.outer),
                holes: area.holes.iter().map(moved).collect(),
                ..RoomDraft::default()
            }
        };
        self.areas[number].iter().enumerate().map(room).collect()
    }

    /// The type by the most specific word that says more than "room".
    fn room_type(&mut self, space: &Space) -> TypeOfWord {
        let candidates = words_of(&space.mapped);
        let types: Vec<Option<&str>> =
            candidates.iter().map(|word| self.words.room_type(WORDS, word)).collect();
        let known = types.iter().position(|found| found.is_some_and(|found| found != GENERIC_ROOM_TYPE));
        if let Some(index) = known {
            return TypeOfWord::known(candidates[index], types[index].unwrap_or(GENERIC_ROOM_TYPE));
        }
        match candidates.iter().zip(&types).find(|(_, found)| found.is_none()) {
            Some((word, _)) => {
                self.unknown.entry((*word).to_owned()).or_insert((space.mapped.place, 0)).1 += 1;
                TypeOfWord::unknown(word)
            }
            None => TypeOfWord::unknown(candidates.first().copied().unwrap_or("room")),
        }
    }

    /// The openings of all buildings. A door is a corner of the rooms that it joins.
    fn openings(&self, houses: &[House<'_>], remarks: &mut Remarks) -> Vec<Openings> {
        let mut house_of = vec![0; self.sorted.spaces.len()];
        for (number, house) in houses.iter().enumerate() {
            house.spaces.iter().for_each(|&space| house_of[space] = number);
        }
        let at_corners = self.spaces_at_corners();
        let mut openings = vec![Openings::new(); houses.len()];
        for door in &self.sorted.doors {
            let touching = at_corners.get(&key_of(door.at)).map(Vec::as_slice).unwrap_or_default();
            let mut levels = door.levels.clone();
            if levels.is_empty() {
                let spaces = touching.iter().map(|&space| &self.sorted.spaces[space]);
                levels = spaces.flat_map(|space| space.levels.iter().copied()).collect();
                levels.sort_unstable();
                levels.dedup();
            }
            let mut is_lost = true;
            for level in levels {
                let on_level = |space: &&usize| self.sorted.spaces[**space].levels.contains(&level);
                let rooms: Vec<usize> = touching.iter().filter(on_level).copied().collect();
                let Some(&first) = rooms.first() else { continue };
                let house = house_of[first];
                let draft = self.opening(door, &rooms, houses[house].position);
                openings[house].entry(level).or_default().push(draft);
                is_lost = false;
            }
            // Entrances of buildings without rooms are no fault of the rooms.
            if is_lost && door.mapped.tag("door").is_some() {
                let message = format!("door {} is a corner of no room on its level", door.mapped.id);
                remarks.leave_out(door.mapped.place, message);
            }
        }
        openings
    }

    fn spaces_at_corners(&self) -> BTreeMap<PlaceKey, Vec<usize>> {
        let mut at_corners: BTreeMap<PlaceKey, Vec<usize>> = BTreeMap::new();
        for (index, space) in self.sorted.spaces.iter().enumerate() {
            for corner in space.areas.iter().flat_map(corners) {
                let spaces = at_corners.entry(key_of(corner)).or_default();
                if spaces.last() != Some(&index) && spaces.len() < MOST_AT_CORNER {
                    spaces.push(index);
                }
            }
        }
        at_corners
    }

    /// A door between rooms.
    fn opening(&self, door: &Door, rooms: &[usize], origin: Point) -> OpeningDraft {
        let is_main = door.mapped.tag("entrance") == Some("main");
        let usual = if is_main { DOOR_WIDTHS.1 } else { DOOR_WIDTHS.0 };
        let said = ["width", "door:width"].into_iter().find_map(|key| length_of_words(door.mapped.tag(key)?));
        let width = said.filter(|width| BELIEVED_WIDTHS.contains(width)).unwrap_or(usual);
        let kind = match door.mapped.tag("door") {
            Some("no") => OpeningKind::Passage,
            // Leaves that turn within the opening, or go up, need as little room beside it.
            Some("sliding" | "revolving" | "folding" | "overhead" | "trapdoor") => OpeningKind::SlidingDoor,
            _ => OpeningKind::Door,
        };
        let at = self.plane.project(door.at.x, door.at.y);
        let areas = rooms.iter().flat_map(|&room| &self.areas[room]);
        let (center, along, width) = match fitted(at, width, areas) {
            Some(Fit { center, along, width }) => (center, Some(along), width),
            None => (at, None, width),
        };
        opening(&door.mapped.id, kind, OpeningPlace::Points { center: center - origin, along }, width)
    }
}

/// The words for a space, the most specific first.
fn words_of(mapped: &Mapped) -> Vec<&str> {
    let mut words: Vec<&str> = ["room", "amenity"].into_iter().filter_map(|key| mapped.tag(key)).collect();
    // The kinds of shops and offices are without number; all of them are shops and offices.
    words.extend(
        ["shop", "office"].into_iter().filter(|key| mapped.tag(key).is_some_and(|word| word != "no")),
    );
    words.extend(mapped.tag("stairs").filter(|word| *word != "no").map(|_| "stairs"));
    words.extend(mapped.tag("highway").filter(|word| *word == "elevator"));
    words.extend(mapped.tag("indoor"));
    words
}

/// Metres from floor to floor of a building, by its height and its number of storeys.
fn storey_height(outline: &Mapped) -> f64 {
    let storeys = outline.tag("building:levels").and_then(|words| words.parse::<f64>().ok());
    let height = outline.tag("height").and_then(length_of_words);
    let storey = height.zip(storeys).map(|(height, storeys)| height / storeys);
    storey.filter(|height| BELIEVED_HEIGHTS.contains(height)).unwrap_or(STOREY_HEIGHT)
}
