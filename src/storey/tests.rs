//! Plans of outlines of every shape and kind: what they promise, and that they are the same whoever asks.

use crate::catalog::builtin_catalog;
use crate::geometry::{Point, Polygon, Region, direction};
use crate::plan::{OpeningKind, OutlineKind};

use super::typology::PlanKind;
use super::*;

fn typologies() -> &'static Typologies {
    &builtin_catalog().typologies
}

fn region(corners: &[(f64, f64)]) -> Region {
    let corners: Vec<Point> = corners.iter().copied().map(Point::from).collect();
    Region::simple(Polygon::new(&corners).unwrap())
}

fn rectangle(x: f64, y: f64, width: f64, depth: f64) -> Region {
    region(&[(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)])
}

fn footprint(id: &str, region: Region, storeys: f64, use_word: &str) -> Footprint {
    Footprint {
        id: id.to_owned(),
        name: None,
        region,
        parts: Vec::new(),
        storeys: StoreyFacts { above_ground: Some(storeys), ..StoreyFacts::default() },
        uses: vec![("building".to_owned(), use_word.to_owned())],
        flats: None,
        entrances: Vec::new(),
    }
}

fn site(footprints: Vec<Footprint>) -> Site {
    Site { footprints, ..Site::default() }
}

fn plan(site: &Site, index: usize) -> PlannedBuilding {
    let around = Neighbourhood::new(site);
    plan_building(site, &around, index, typologies(), &Choices::default()).expect("there is always a plan")
}

/// The planned building of an outline that stands alone.
fn alone(region: Region, storeys: f64, use_word: &str) -> PlannedBuilding {
    plan(&site(vec![footprint("alone", region, storeys, use_word)]), 0)
}

fn rooms_of<'a>(
    building: &'a PlannedBuilding,
    level: usize,
    room_type: &str,
) -> Vec<&'a crate::plan::RoomDraft> {
    building.draft.levels[level].rooms.iter().filter(|room| room.room_type == room_type).collect()
}

fn area(corners: &[Point]) -> f64 {
    ring::area(corners)
}

#[test]
fn a_house_has_the_same_stairs_on_all_levels_and_a_bath_above() {
    let house = alone(rectangle(0.0, 0.0, 10.0, 9.0), 2.0, "house");
    assert_eq!((house.report.typology.as_str(), house.report.rung), ("house", 0), "{:?}", house.report);
    assert_eq!(house.draft.levels.len(), 2);
    let stairs: Vec<_> = (0..2).map(|level| rooms_of(&house, level, "stairs")[0].outline.clone()).collect();
    assert_eq!(stairs[0], stairs[1]);
    assert!(!rooms_of(&house, 1, "bathroom").is_empty());
    assert!(!rooms_of(&house, 1, "bedroom").is_empty());
    let has_way_in =
        |opening: &crate::plan::OpeningDraft| opening.rooms.len() == 1 && opening.kind == OpeningKind::Door;
    assert!(house.draft.levels[0].openings.iter().any(has_way_in));
    assert!(!house.draft.levels[1].openings.iter().any(has_way_in), "nobody walks out into the air");
}

#[test]
fn narrow_houses_of_a_terrace_have_rooms_as_wide_as_they_are() {
    for (width, depth) in [(3.8, 10.0), (4.0, 13.0), (4.3, 16.0), (4.6, 9.0)] {
        let row = |number: u32| {
            let outline = rectangle(width * f64::from(number), 0.0, width, depth);
            footprint(&format!("house {number}"), outline, 2.0, "terrace")
        };
        let house = plan(&site((0..5).map(row).collect()), 2);
        assert_eq!((house.report.typology.as_str(), house.report.rung), ("house", 0), "{:?}", house.report);
        // The plan's x runs along the house.
        let across = |room: &crate::plan::RoomDraft| ring::bounds(&room.outline).size().y;
        for (level, wanted) in [(0, "living"), (1, "bedroom")] {
            let rooms = &house.draft.levels[level].rooms;
            let mut wide = rooms.iter().filter(|room| room.room_type.starts_with(wanted));
            // But for the outer walls, 0.3 m each.
            assert!(wide.any(|room| across(room) > width - 0.7), "{width} by {depth}: {rooms:?}");
        }
        let stairs = [0, 1].map(|level| rooms_of(&house, level, "stairs")[0].outline.clone());
        assert_eq!(stairs[0], stairs[1]);
        assert_eq!(rooms_of(&house, 1, "bathroom").len(), 1);
    }
}

#[test]
fn flats_have_an_entrance_a_kitchen_and_a_bath_each() {
    let block = alone(rectangle(0.0, 0.0, 40.0, 12.0), 4.0, "apartments");
    assert_eq!((block.report.typology.as_str(), block.report.rung), ("flats", 0), "{:?}", block.report);
    for level in &block.draft.levels {
        let mut flats: Vec<&str> = level.rooms.iter().filter_map(|room| room.dwelling.as_deref()).collect();
        flats.sort_unstable();
        flats.dedup();
        assert!(flats.len() >= 3, "{flats:?}");
        for flat in flats {
            let types: Vec<&str> = level
                .rooms
                .iter()
                .filter(|room| room.dwelling.as_deref() == Some(flat))
                .map(|room| room.room_type.as_str())
                .collect();
            assert!(types.contains(&"bathroom"), "{types:?}");
            assert!(types.iter().any(|word| word.contains("kitchen") || *word == "studio"), "{types:?}");
            let dwelling_of = |id: &String| {
                let room = level.rooms.iter().find(|room| room.id == *id).unwrap();
                room.dwelling.as_deref() == Some(flat)
            };
            let entrances = level.openings.iter().filter(|opening| {
                opening.rooms.len() == 2 && opening.rooms.iter().filter(|id| dwelling_of(id)).count() == 1
            });
            assert_eq!(entrances.count(), 1, "{flat}");
        }
    }
}

#[test]
fn a_second_bath_may_belong_to_a_bedroom_and_the_first_never() {
    let block = alone(rectangle(0.0, 0.0, 72.0, 13.0), 4.0, "apartments");
    assert_eq!(block.report.rung, 0, "{:?}", block.report);
    let mut suites = 0;
    for level in &block.draft.levels {
        let room = |id: &String| level.rooms.iter().find(|room| room.id == *id).unwrap();
        let behind = |bath: &crate::plan::RoomDraft| -> Vec<String> {
            let own = level
                .openings
                .iter()
                .filter(|opening| opening.kind != OpeningKind::Window && opening.rooms.contains(&bath.id));
            let others = own.flat_map(|opening| opening.rooms.iter().filter(|id| **id != bath.id));
            others.map(|id| room(id).room_type.clone()).collect()
        };
        let baths: Vec<_> = level.rooms.iter().filter(|room| room.room_type == "bathroom").collect();
        for bath in baths.iter().filter(|bath| behind(bath) == ["bedroom"]) {
            suites += 1;
            let is_open = |other: &&crate::plan::RoomDraft| {
                other.dwelling == bath.dwelling && !behind(other).contains(&"bedroom".to_owned())
            };
            assert!(baths.iter().copied().any(|other| is_open(&other)), "{}", bath.id);
        }
    }
    assert!(suites > 0);
}

#[test]
fn corridors_of_wings_meet() {
    let corners = [(0., 0.), (50., 0.), (50., 14.), (14., 14.), (14., 45.), (0., 45.)];
    let offices = alone(region(&corners), 3.0, "office");
    assert_eq!(
        (offices.report.typology.as_str(), offices.report.rung),
        ("office_cells", 0),
        "{:?}",
        offices.report
    );
    assert!(rooms_of(&offices, 0, "walkway").len() >= 2);
    assert!(rooms_of(&offices, 0, "office").len() >= 10);
}

#[test]
fn a_wing_in_which_no_corridor_has_a_place_is_a_large_room() {
    // A leg that leans by 45 degrees.
    let corners = [
        (0.0, 0.0),
        (40.0, 0.0),
        (40.0, 14.0),
        (24.0, 14.0),
        (41.0, 31.0),
        (27.0, 31.0),
        (10.0, 14.0),
        (0.0, 14.0),
    ];
    let school = alone(region(&corners), 2.0, "school");
    assert_eq!((school.report.typology.as_str(), school.report.rung), ("school", 0), "{:?}", school.report);
    for level in 0..2 {
        assert!(rooms_of(&school, level, "classroom").len() > 2, "{:?}", school.report);
        assert_eq!(rooms_of(&school, level, "library").len(), 1, "{:?}", school.report);
    }
}

#[test]
fn a_large_storey_that_is_no_rectangle_is_no_open_plan() {
    // A leg that leans, and a block whose walls are not parallel.
    let corners = [
        (-24.0, -6.0),
        (-14.0, 19.0),
        (15.0, 20.0),
        (20.0, 4.0),
        (24.0, -20.5),
        (3.5, -20.3),
        (3.9, -8.8),
        (-16.5, -8.8),
    ];
    let mut corners: Vec<(f64, f64)> = corners.into();
    corners.reverse();
    let wards = alone(region(&corners), 3.0, "hospital");
    assert_eq!(wards.report.rung, 0, "{:?}", wards.report);
    assert!(rooms_of(&wards, 1, "ward").len() > 5, "{:?}", wards.report);
}

#[test]
fn corridors_that_meet_are_joined_though_each_has_stairs() {
    let school = alone(
        region(&[(0.0, 0.0), (50.0, 0.0), (50.0, 14.0), (12.0, 14.0), (12.0, 45.0), (0.0, 45.0)]),
        2.0,
        "school",
    );
    for (number, level) in school.draft.levels.iter().enumerate() {
        let corridors: Vec<&str> =
            rooms_of(&school, number, "walkway").iter().map(|room| room.id.as_str()).collect();
        assert_eq!(corridors.len(), 2, "one in each wing");
        let joins = |opening: &&crate::plan::OpeningDraft| {
            opening.rooms.len() == 2 && opening.rooms.iter().all(|room| corridors.contains(&room.as_str()))
        };
        assert_eq!(level.openings.iter().filter(joins).count(), 1, "level {number}");
    }
}

#[test]
fn rooms_of_a_deep_storey_lie_at_its_outer_walls_and_stairs_in_its_core() {
    let (length, depth) = (44.0, 30.0);
    let ward = alone(rectangle(0.0, 0.0, length, depth), 3.0, "hospital");
    assert_eq!((ward.report.typology.as_str(), ward.report.rung), ("hospital_ward", 0), "{:?}", ward.report);
    // From the outer wall that is nearest.
    let reach = |corners: &[Point]| {
        let extent = ring::bounds(corners);
        // A draft has its origin in the middle.
        let half = Point::new(length, depth) / 2.0;
        (extent.high + half).min_element().min((half - extent.low).min_element())
    };
    let wards = rooms_of(&ward, 1, "ward");
    let reaches: Vec<f64> = wards.iter().map(|room| reach(&room.outline)).collect();
    assert!(
        reaches.len() >= 10 && reaches.iter().all(|reach| *reach < 10.0),
        "{reaches:?}, {:?}",
        ward.report.refused
    );
    let stairs = rooms_of(&ward, 1, "stairs");
    assert!(stairs.iter().any(|room| ring::bounds(&room.outline).center().y.abs() < 8.0));
    let is_corridor = |id: &String| id.starts_with("walkway");
    let joins = |opening: &&crate::plan::OpeningDraft| {
        opening.rooms.len() == 2 && opening.rooms.iter().all(is_corridor)
    };
    let joined = ward.draft.levels[1].openings.iter().filter(joins).count();
    assert_eq!(joined, 5, "two corridors meet at one place and in two passages, each with two ends");
}

#[test]
fn stairs_lead_to_the_corridor_and_not_through_a_store() {
    for (use_word, depth) in [("office", 14.0), ("hotel", 16.0), ("hospital", 28.0), ("school", 18.0)] {
        let building = alone(rectangle(0.0, 0.0, 46.0, depth), 3.0, use_word);
        for (number, level) in building.draft.levels.iter().enumerate() {
            for stairs in rooms_of(&building, number, "stairs") {
                let leads = |opening: &&crate::plan::OpeningDraft| opening.rooms.contains(&stairs.id);
                let rooms = || level.openings.iter().filter(leads).flat_map(|opening| &opening.rooms);
                let what = format!("{use_word} {number} {}", stairs.id);
                assert!(rooms().any(|id| id.starts_with("walkway")), "{what}");
                assert!(!rooms().any(|id| id.starts_with("storeroom")), "{what}");
            }
        }
    }
}

#[test]
fn a_hotel_is_entered_through_a_lobby() {
    let hotel = alone(rectangle(0.0, 0.0, 30.0, 14.0), 3.0, "hotel");
    assert_eq!((hotel.report.typology.as_str(), hotel.report.rung), ("hotel", 0), "{:?}", hotel.report);
    let lobbies = |level: usize| rooms_of(&hotel, level, "lobby");
    assert_eq!([lobbies(0).len(), lobbies(1).len()], [1, 0]);
    let ground = &hotel.draft.levels[0];
    let lobby = &lobbies(0)[0].id;
    let is_way_in = |opening: &&crate::plan::OpeningDraft| {
        opening.kind == OpeningKind::Door && opening.rooms == [lobby.clone()]
    };
    assert!(ground.openings.iter().any(|opening| is_way_in(&opening)), "people come in there");
    let leads_on =
        |opening: &crate::plan::OpeningDraft| opening.rooms.len() == 2 && opening.rooms.contains(lobby);
    assert!(ground.openings.iter().any(leads_on), "and go on to the corridor");
}

#[test]
fn nobody_comes_into_an_exhibition_through_its_stores() {
    for seed in 0..12 {
        let width = 12.0 + f64::from(seed);
        let museum = alone(rectangle(0.0, 0.0, width, 8.5), 1.0, "museum");
        let level = &museum.draft.levels[0];
        let is_way_in = |opening: &&crate::plan::OpeningDraft| {
            opening.kind != OpeningKind::Window && opening.rooms.len() == 1
        };
        let first = level.openings.iter().find(is_way_in).expect("a way in");
        let room = level.rooms.iter().find(|room| room.id == first.rooms[0]).unwrap();
        assert_eq!(room.room_type, "exhibition", "{width} m wide: {:?}", museum.report);
    }
}

#[test]
fn large_open_storeys_are_parted_into_compartments() {
    let museum = alone(rectangle(0.0, 0.0, 80.0, 60.0), 1.0, "museum");
    let parts = rooms_of(&museum, 0, "exhibition");
    assert!(parts.len() >= 3, "{:?}", museum.report);
    let largest = parts.iter().map(|room| area(&room.outline)).fold(0.0, f64::max);
    assert!(largest < 1.25 * 1600.0, "{largest}");
    // No larger than a compartment, but around three sides of a court.
    let bent = region(&[
        (0.0, 0.0),
        (90.0, 0.0),
        (90.0, 60.0),
        (84.0, 60.0),
        (84.0, 6.0),
        (6.0, 6.0),
        (6.0, 60.0),
        (0.0, 60.0),
    ]);
    let museum = alone(bent, 1.0, "museum");
    let parts = rooms_of(&museum, 0, "exhibition");
    assert!(parts.len() > 1, "{:?}", museum.report);
}

#[test]
fn hotel_rooms_have_baths_in_shallow_rows_and_deep_ones() {
    for depth in [11.0, 12.5, 14.0, 16.0] {
        let hotel = alone(rectangle(0.0, 0.0, 40.0, depth), 3.0, "hotel");
        assert_eq!(hotel.report.typology, "hotel", "{depth}: {:?}", hotel.report);
        let count = |room_type: &str| rooms_of(&hotel, 1, room_type).len();
        assert_eq!(count("hotel_room"), count("hotel_bathroom"), "{depth}");
        assert!(count("hotel_room") > 6, "{depth}");
    }
}

/// Workplace rules of many countries ask for a toilet for some 15 to 25 people, each of whom has some 10 m².
#[test]
fn restrooms_grow_with_the_people_of_a_storey() {
    let restrooms = |width: f64, storeys: f64| {
        let office = alone(rectangle(0.0, 0.0, width, 30.0), storeys, "office");
        let rooms = rooms_of(&office, 0, "restroom");
        rooms.iter().map(|room| area(&room.outline)).sum::<f64>() / (width * 30.0)
    };
    for (width, storeys) in [(30.0, 1.0), (40.0, 1.0), (60.0, 3.0), (90.0, 3.0)] {
        let share = restrooms(width, storeys);
        assert!((0.02..0.06).contains(&share), "{width} m, {storeys} storeys: {share}");
    }
}

#[test]
fn small_rooms_of_deep_rows_are_no_tubes() {
    let offices = alone(rectangle(0.0, 0.0, 36.0, 16.0), 2.0, "office");
    let restrooms = rooms_of(&offices, 0, "restroom");
    assert!(!restrooms.is_empty(), "{:?}", offices.report);
    for room in restrooms {
        let size = ring::bounds(&room.outline).size();
        assert!(size.max_element() < 3.5 * size.min_element(), "{size:?}");
    }
}

#[test]
fn rooms_cover_the_floor_of_every_shape() {
    let circle: Vec<(f64, f64)> =
        (0..40).map(|step| direction(f64::from(step) * 0.157) * 14.0).map(|at| (at.x, at.y)).collect();
    let court = {
        let hole = Polygon::rectangle(Point::new(10.0, 10.0), Point::new(18.0, 14.0));
        Region { holes: vec![hole], ..rectangle(0.0, 0.0, 40.0, 36.0) }
    };
    let shapes = [
        rectangle(0.0, 0.0, 2.0, 1.5),
        rectangle(0.0, 0.0, 60.0, 3.0),
        region(&[(0.0, 0.0), (22.0, 0.0), (0.0, 17.0)]),
        region(&[
            (0.0, 0.0),
            (30.0, 0.0),
            (30.0, 11.0),
            (19.0, 11.0),
            (19.0, 5.0),
            (11.0, 5.0),
            (11.0, 11.0),
            (0.0, 11.0),
        ]),
        region(&[(0.0, 0.0), (9.0, -2.0), (14.0, 4.0), (11.0, 12.0), (2.0, 10.0)]),
        region(&circle),
        court,
        rectangle(0.0, 0.0, 130.0, 90.0),
    ];
    for (number, shape) in shapes.into_iter().enumerate() {
        for use_word in [
            "house",
            "apartments",
            "office",
            "hotel",
            "school",
            "hospital",
            "retail",
            "church",
            "garage",
            "?",
        ] {
            let planned = alone(shape.clone(), 3.0, use_word);
            // A kind of one room has one storey, whatever the map counts.
            let kind = typologies().typologies[&planned.report.typology].plan;
            let storeys = if kind == PlanKind::OneRoom { 1 } else { 3 };
            assert_eq!(planned.draft.levels.len(), storeys, "{number} {use_word}");
            for level in &planned.draft.levels {
                assert_eq!(level.outlines, OutlineKind::Center);
                let indoors = level.rooms.iter().filter(|room| room.room_type != "balcony");
                let covered: f64 = indoors.map(|room| area(&room.outline)).sum();
                let most = shape.area();
                assert!(covered <= most && covered > most * 0.2, "{number} {use_word}: {covered} of {most}");
                let is_simple = |room: &crate::plan::RoomDraft| Polygon::new(&room.outline).is_ok();
                assert!(level.rooms.iter().all(is_simple), "{number} {use_word}");
            }
        }
    }
}

#[test]
fn a_church_is_entered_across_from_its_apse_and_has_no_door_there() {
    let apse = [(30.0, 0.0), (33.0, 1.5), (35.0, 5.0), (35.0, 7.0), (33.0, 10.5), (30.0, 12.0)];
    let corners: Vec<(f64, f64)> = [(0.0, 0.0)].into_iter().chain(apse).chain([(0.0, 12.0)]).collect();
    let mirrored: Vec<(f64, f64)> = corners.iter().rev().map(|&(x, y)| (35.0 - x, y)).collect();
    for (corners, entrance) in [(corners, 0.0), (mirrored, 35.0)] {
        let church = alone(region(&corners), 1.0, "church");
        let ways = church.draft.levels[0].openings.iter().filter(|opening| opening.kind == OpeningKind::Door);
        let doors: Vec<Point> = ways
            .filter_map(|opening| match opening.place {
                crate::plan::OpeningPlace::Points { center, .. } => Some(center),
                _ => None,
            })
            .map(|center| church.placement.position + direction(church.placement.turn).rotate(center))
            .collect();
        assert!((doors[0].x - entrance).abs() < 1.0 && (doors[0].y - 6.0).abs() < 1.0, "{doors:?}");
        assert!(doors.iter().all(|door| (door.x - entrance).abs() < 28.0), "{doors:?}");
    }
}

#[test]
fn a_place_of_worship_is_that_of_its_religion() {
    let kind = |tags: &[(&str, &str)]| {
        let mut footprint = footprint("one", rectangle(0.0, 0.0, 20.0, 12.0), 1.0, "");
        footprint.uses = tags.iter().map(|&(key, word)| (key.to_owned(), word.to_owned())).collect();
        plan(&site(vec![footprint]), 0).report.typology
    };
    let place = ("amenity", "place_of_worship");
    assert_eq!(kind(&[place, ("religion", "muslim")]), "mosque");
    assert_eq!(kind(&[place, ("religion", "christian")]), "church");
    assert_eq!(kind(&[place]), "house_of_prayer");
    assert_eq!(kind(&[("building", "synagogue"), place]), "synagogue");
    assert_eq!(kind(&[("amenity", "school"), ("religion", "christian")]), "school", "a school of a church");
}

#[test]
fn nobody_is_far_from_stairs_or_doors() {
    let doors_of = |planned: &PlannedBuilding, level: usize| -> Vec<Point> {
        let openings = planned.draft.levels[level].openings.iter();
        let ways = openings.filter(|opening| opening.kind == OpeningKind::Door && opening.rooms.len() == 1);
        ways.filter_map(|opening| match opening.place {
            crate::plan::OpeningPlace::Points { center, .. } => Some(center),
            _ => None,
        })
        .collect()
    };
    let hall = alone(rectangle(0.0, 0.0, 70.0, 50.0), 1.0, "supermarket");
    let middle = super::ring::bounds(&rooms_of(&hall, 0, "supermarket")[0].outline).center();
    let nearest = doors_of(&hall, 0).iter().map(|door| door.distance(middle)).fold(f64::INFINITY, f64::min);
    assert!(nearest < 35.0, "{nearest}");
    let floors = alone(rectangle(0.0, 0.0, 70.0, 50.0), 3.0, "factory");
    let parts = rooms_of(&floors, 1, "workshop");
    let stairs = rooms_of(&floors, 1, "stairs");
    assert!(parts.len() > 1 && stairs.len() >= parts.len(), "{} parts, {} stairs", parts.len(), stairs.len());
}

#[test]
fn halls_whose_middle_is_far_from_all_walls_are_parted() {
    let offices = alone(rectangle(0.0, 0.0, 110.0, 110.0), 1.0, "office");
    assert_eq!(
        (offices.report.typology.as_str(), offices.report.rung),
        ("office_open", 0),
        "{:?}",
        offices.report
    );
    // Compartments of 1,600 m² at most, and as few as that gives.
    assert_eq!(rooms_of(&offices, 0, "office").len(), 8);
}

#[test]
fn wings_too_narrow_for_thick_walls_have_thin_ones() {
    let wing =
        [(0.0, 0.0), (14.0, 0.0), (14.0, 6.0), (6.25, 6.0), (6.25, 0.9), (4.8, 0.9), (4.8, 2.3), (0.0, 2.3)];
    let shape = region(&wing);
    let floor = |planned: &PlannedBuilding| -> f64 {
        planned.draft.levels[0].rooms.iter().map(|room| area(&room.outline)).sum()
    };
    let house = alone(shape.clone(), 2.0, "house");
    assert!(house.draft.levels.iter().all(|level| level.exterior_thickness < 0.2));
    assert!(floor(&house) > 0.85 * shape.area(), "{}", floor(&house));
    // One without such a wing has the walls of its kind.
    let plain = alone(rectangle(0.0, 0.0, 14.0, 6.0), 2.0, "house");
    assert!(plain.draft.levels.iter().all(|level| level.exterior_thickness > 0.28));
}

#[test]
fn what_nobody_can_stand_in_is_no_building() {
    let site = site(vec![footprint("strip", rectangle(0.0, 0.0, 9.0, 0.6), 1.0, "shed")]);
    let around = Neighbourhood::new(&site);
    assert!(plan_building(&site, &around, 0, typologies(), &Choices::default()).is_none());
}

#[test]
fn baths_of_deep_rows_end_before_the_outer_wall() {
    let flats = alone(rectangle(0.0, 0.0, 22.0, 14.0), 4.0, "apartments");
    let baths = rooms_of(&flats, 1, "bathroom");
    assert!(!baths.is_empty());
    for bath in baths {
        assert!(area(&bath.outline) < 9.0, "{} has {:.1} m²", bath.id, area(&bath.outline));
    }
}

#[test]
fn no_window_looks_at_a_neighbour() {
    let row = (0..3).map(|place| {
        let x = f64::from(place) * 6.0;
        footprint(&format!("row-{place}"), rectangle(x, 0.0, 6.0, 11.0), 2.0, "house")
    });
    let site = site(row.collect());
    let middle = plan(&site, 1);
    assert!(middle.report.rung < 2, "{:?}", middle.report);
    let turn = direction(middle.placement.turn);
    for opening in middle.draft.levels.iter().flat_map(|level| &level.openings) {
        let crate::plan::OpeningPlace::Points { center, .. } = opening.place else {
            panic!("not placed by points")
        };
        let at = middle.placement.position + turn.rotate(center);
        if opening.kind == OpeningKind::Window {
            assert!(at.x > 6.5 && at.x < 11.5, "{at}: in a party wall");
        }
    }
}

#[test]
fn a_plan_depends_on_its_surroundings_alone() {
    let own = || footprint("b", rectangle(0.0, 0.0, 24.0, 12.0), 4.0, "apartments");
    let far = |id: &str| footprint(id, rectangle(500.0, 0.0, 9.0, 9.0), 2.0, "house");
    let text = |planned: PlannedBuilding| format!("{:?} {:?}", planned.draft, planned.placement);
    let single = text(plan(&site(vec![own()]), 0));
    assert_eq!(single, text(plan(&site(vec![own(), far("a")]), 0)));
    assert_eq!(single, text(plan(&site(vec![far("c"), own()]), 1)));
    let near = footprint("n", rectangle(24.0, 0.0, 10.0, 12.0), 4.0, "apartments");
    assert_ne!(single, text(plan(&site(vec![own(), near]), 0)), "windows give way to a neighbour");
}

#[test]
fn choices_come_before_the_map() {
    let site = site(vec![footprint("one", rectangle(0.0, 0.0, 20.0, 14.0), 2.0, "house")]);
    let around = Neighbourhood::new(&site);
    let choices = Choices { use_name: Some("hotel".to_owned()), storeys: Some(5), ..Choices::default() };
    let planned = plan_building(&site, &around, 0, typologies(), &choices).unwrap();
    assert_eq!(planned.draft.levels.len(), 5);
    assert_eq!(planned.report.typology, "hotel");
    assert!(!rooms_of(&planned, 0, "hotel_room").is_empty());
}

#[test]
fn all_stairs_of_a_long_storey_have_doors_on_each_level() {
    let office = alone(rectangle(0.0, 0.0, 70.0, 15.0), 4.0, "office");
    for level in &office.draft.levels {
        let stairs: Vec<_> = level.rooms.iter().filter(|room| room.room_type == "stairs").collect();
        assert!(stairs.len() >= 2, "{:?}", office.report);
        let has_door = |room: &crate::plan::RoomDraft| {
            level.openings.iter().any(|opening| opening.rooms.len() == 2 && opening.rooms.contains(&room.id))
        };
        assert!(stairs.into_iter().all(has_door), "level {}", level.id);
    }
}

#[test]
fn nobody_looks_at_a_corner_of_a_neighbour() {
    // It reaches to 1 m before the wall, over 0.4 m of it.
    let wedge = region(&[(5.0, -6.0), (5.4, -6.0), (5.4, -1.0), (5.0, -1.0)]);
    let site = site(vec![
        footprint("a", rectangle(0.0, 0.0, 11.0, 9.0), 2.0, "house"),
        footprint("b", wedge, 1.0, "shed"),
    ]);
    let house = plan(&site, 0);
    let turn = |point: Point| direction(house.placement.turn).rotate(point) + house.placement.position;
    for opening in house.draft.levels.iter().flat_map(|level| &level.openings) {
        let crate::plan::OpeningPlace::Points { center, along } = opening.place else { continue };
        if opening.kind == OpeningKind::Window && turn(center).y < 1.0 {
            let half = along.unwrap_or(Point::X).length() * opening.width / 2.0;
            let gap = (turn(center).x - 5.2).abs() - half - 0.2;
            assert!(gap > 0.0, "a window of {} m at {}", opening.width, turn(center));
        }
    }
}

#[test]
fn what_neighbours_wall_in_has_a_door_and_no_windows() {
    let around = [(-9.0, 0.0, 9.0, 9.0), (9.0, 0.0, 9.0, 9.0), (0.0, 9.0, 9.0, 9.0), (0.0, -9.0, 9.0, 9.0)];
    let mut footprints = vec![footprint("a", rectangle(0.0, 0.0, 9.0, 9.0), 3.0, "office")];
    for (number, (x, y, width, depth)) in around.into_iter().enumerate() {
        footprints.push(footprint(&format!("n{number}"), rectangle(x, y, width, depth), 3.0, "office"));
    }
    let walled = plan(&site(footprints), 0);
    let ground = &walled.draft.levels[0];
    let outer = |opening: &&crate::plan::OpeningDraft| opening.rooms.len() == 1;
    assert!(ground.openings.iter().filter(outer).any(|opening| opening.kind == OpeningKind::Door));
    assert!(ground.openings.iter().all(|opening| opening.kind != OpeningKind::Window));
    assert!(
        walled.draft.levels.iter().all(|level| level.rooms.iter().any(|room| room.room_type == "stairs"))
    );
}

#[test]
fn a_garage_has_its_gate_where_a_car_has_room_behind_it() {
    // Longer from west to east, whatever the street is; too short for a car, it is a shed.
    let garage = alone(rectangle(0.0, 0.0, 6.0, 3.0), 1.0, "garage");
    assert_eq!(garage.report.typology, "garage");
    let openings = &garage.draft.levels[0].openings;
    let gates: Vec<_> = openings.iter().filter(|opening| opening.kind == OpeningKind::Door).collect();
    let [gate] = gates[..] else { panic!("{gates:?}") };
    let (crate::plan::OpeningPlace::Points { along: Some(along), .. }, 2.0..) = (&gate.place, gate.width)
    else {
        panic!("{gate:?}")
    };
    assert!(along.x.abs() < 0.1, "at a short side: {gate:?}");
    assert!(matches!(&gate.leaf, crate::plan::LeafDraft::Swing { into: None, count: 2, .. }), "outwards");
    assert_eq!(openings.len(), 2, "one window");
    assert_eq!(alone(rectangle(0.0, 0.0, 4.0, 4.0), 1.0, "garage").report.typology, "shed");
}

#[test]
fn outlines_that_lie_in_each_other_have_no_windows_there() {
    let inner = footprint("a", rectangle(10.0, 10.0, 8.0, 8.0), 1.0, "shop");
    let outer = footprint("b", rectangle(0.0, 0.0, 60.0, 60.0), 1.0, "warehouse");
    let shop = plan(&site(vec![inner, outer]), 0);
    assert!(shop.draft.levels[0].openings.iter().all(|opening| opening.kind != OpeningKind::Window));
}

#[test]
fn a_plate_of_a_thousand_sections_needs_no_deep_stack() {
    let ring: ring::Ring = [(0., 0.), (12_000., 0.), (12_000., 10.), (0., 10.)].map(Point::from).into();
    let cut = move || {
        let ground = spine::Ground { ring: ring.clone(), facade: facade::Facade::default(), wall: 0.0 };
        flats::sections(&ground, ring, 1_000).len()
    };
    let thread = std::thread::Builder::new().stack_size(256 * 1024).spawn(cut).unwrap();
    assert_eq!(thread.join().unwrap(), 1_000);
}

#[test]
fn rooms_larger_than_rooms_may_be_are_cut_in_halves() {
    let room = |width: f64, depth: f64, room_type: &str| {
        let corners = [(0., 0.), (width, 0.), (width, depth), (0., depth)];
        dwelling::Cell::shared(corners.map(Point::from).into(), room_type)
    };
    let cut = open::within_limits(vec![room(900.0, 900.0, "generic"), room(30.0, 20.0, "office")]);
    assert_eq!(cut.len(), 17);
    assert!(cut[..16].iter().all(|cell| (area(&cell.ring) - 50_625.0).abs() < 1e-6));
    assert_eq!(cut[16].room_type, "office");
    assert_eq!(open::within_limits(vec![room(3_000.0, 10.0, "generic")]).len(), 4);
}

#[test]
fn the_largest_outlines_are_planned_with_fewer_storeys_than_the_map_says() {
    let plant = alone(rectangle(0.0, 0.0, 900.0, 900.0), 200.0, "industrial");
    assert_eq!(plant.report.storeys, 1);
    let (_, faults) = crate::plan::finish_draft("plant", &plant.draft, &builtin_catalog().room_words);
    assert!(faults.is_empty(), "{faults}");
}

/// The block of flats of a site's first footprint, of a kind that always has balconies.
fn with_balconies(footprints: Vec<Footprint>) -> PlannedBuilding {
    let site = site(footprints);
    let mut typologies = typologies().clone();
    typologies.typologies.values_mut().for_each(|typology| typology.balconies = 1.0);
    plan_building(&site, &Neighbourhood::new(&site), 0, &typologies, &Choices::default()).unwrap()
}

#[test]
fn flats_above_the_ground_have_balconies_before_the_open_air() {
    let block = with_balconies(vec![footprint("alone", rectangle(0.0, 0.0, 40.0, 12.0), 4.0, "apartments")]);
    assert!(rooms_of(&block, 0, "balcony").is_empty());
    let turn = direction(block.placement.turn);
    for level in &block.draft.levels[1..] {
        let balconies: Vec<_> = level.rooms.iter().filter(|room| room.room_type == "balcony").collect();
        assert!(balconies.len() > 2 && balconies.len() == level.railings.len(), "{}", balconies.len());
        for balcony in balconies {
            let corners = balcony.outline.iter().map(|&at| block.placement.position + turn.rotate(at));
            let is_out = |at: Point| !(0.01..39.99).contains(&at.x) || !(0.01..11.99).contains(&at.y);
            assert!(corners.into_iter().all(is_out) && area(&balcony.outline) > 3.0);
            let doors = level.openings.iter().filter(|opening| opening.rooms.contains(&balcony.id));
            let doors: Vec<_> = doors.map(|opening| (opening.kind, opening.rooms.len())).collect();
            assert_eq!(doors, [(OpeningKind::SlidingDoor, 2)]);
        }
    }
}

#[test]
fn nobody_has_a_balcony_before_a_neighbours_wall() {
    let beside = |y: f64| footprint(&format!("at {y}"), rectangle(0.0, y, 40.0, 12.0), 4.0, "apartments");
    let mut rows = vec![footprint("a", rectangle(0.0, 0.0, 40.0, 12.0), 4.0, "apartments")];
    rows.extend([beside(-16.0), beside(16.0)]);
    let middle = with_balconies(rows);
    let turn = direction(middle.placement.turn);
    for balcony in rooms_of(&middle, 1, "balcony") {
        let at = middle.placement.position + turn.rotate(balcony.outline[1]);
        assert!(!(0.0..40.0).contains(&at.x), "{at} is before a wall 4 m away");
    }
}

#[test]
fn a_court_that_reaches_into_the_outer_wall_is_no_floor() {
    let hole = Polygon::rectangle(Point::new(0.2, 8.0), Point::new(12.0, 12.0));
    let shape = Region { holes: vec![hole], ..rectangle(0.0, 0.0, 40.0, 30.0) };
    let planned = alone(shape.clone(), 2.0, "office");
    for level in &planned.draft.levels {
        let covered: f64 = level.rooms.iter().map(|room| area(&room.outline)).sum();
        assert!(covered < shape.area() && covered > 0.85 * shape.area(), "{covered}");
    }
}
