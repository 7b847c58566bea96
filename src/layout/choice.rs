//! The style that a room is furnished in.

use std::borrow::Cow;

use super::options::FurnishOptions;
use crate::catalog::{BuildingStyle, Catalog, Class, Share, StyleRef};
use crate::dwelling::shared_draw;
use crate::plan::RoomRef;

/// The style of a room: its own, else the run's if that is made for such rooms, else the default. A building style
/// draws one; where that is not made for such rooms, the default takes its place.
#[must_use]
pub fn room_style(at: RoomRef<'_>, catalog: &Catalog, options: &FurnishOptions<'_>) -> StyleRef {
    let room = at.room;
    let suits = |style: &StyleRef| catalog.styles[*style].suits(&room.room_type);
    let of_building = |id: &str| {
        let building_style = catalog.building_styles.get(id)?;
        let drawn = building_style.style(&room.room_type, draw(building_style, at, options));
        // By a draw of its own: whether a dwelling is an exception changes no style of the others.
        let exception = drawn.and_then(|style| building_style.style_instead(style, single_draw(at, options)));
        let style = exception.filter(suits).or(drawn);
        Some(style.filter(suits).unwrap_or(catalog.default_style))
    };
    let own = room.style.as_deref().and_then(|id| catalog.styles.find(id).or_else(|| of_building(id)));
    let of_run =
        options.style.and_then(|id| catalog.styles.find(id).filter(suits).or_else(|| of_building(id)));
    // The style that a plan names for a room holds in any case; that of the run in rooms that it suits.
    own.or(of_run).unwrap_or(catalog.default_style)
}

/// The number that a building style draws with: equal for rooms that share it, whatever other rooms there are.
fn draw(style: &BuildingStyle, at: RoomRef<'_>, options: &FurnishOptions<'_>) -> f64 {
    shared_draw(options.seed, sharing(style.share, at, options))
}

/// The names that a room has in common with those that it shares with, and with no others.
fn sharing<'a>(share: Share, at: RoomRef<'a>, options: &FurnishOptions<'a>) -> Vec<Cow<'a, str>> {
    let building = Cow::Borrowed(options.building);
    let level = Cow::Borrowed(at.level.id.as_str());
    match (share, &at.room.dwelling) {
        (Share::Building, _) => vec![building],
        // Outside of all dwellings (a stairwell, a lobby) rooms of a level look alike.
        (Share::Level, _) | (Share::Dwelling, None) => vec![building, level],
        (Share::Dwelling, Some(dwelling)) => vec![building, level, dwelling.into()],
        (Share::Room, _) => vec![building, level, "".into(), at.room.number.to_string().into()],
    }
}

/// Which rooms have furniture that looks like a room's own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series<'a> {
    pub(crate) at: RoomRef<'a>,
    pub(crate) options: &'a FurnishOptions<'a>,
    /// Those that its building style draws for together, else those that its type says.
    pub(crate) share: Share,
}

impl<'a> Series<'a> {
    pub(crate) fn new(at: RoomRef<'a>, catalog: &Catalog, options: &'a FurnishOptions<'a>) -> Self {
        let ids = [at.room.style.as_deref(), options.style];
        let style = ids.into_iter().flatten().find_map(|id| catalog.building_styles.get(id));
        let of_type = || catalog.room_types.get(&at.room.room_type).map(|room_type| room_type.share);
        let share = style.map(|style| style.share).or_else(of_type).unwrap_or_default();
        Self { at, options, share }
    }

    /// A number from 0 up to 1 that pieces of a class have in common in all rooms where they look alike.
    pub(crate) fn look(&self, class: &Class, seed: u64) -> f64 {
        shared_draw(seed, self.names(class).iter().map(Cow::as_ref).chain(["look of", &class.id]))
    }

    /// The names that the room has in common with those where pieces of a class look alike.
    fn names(&self, class: &Class) -> Vec<Cow<'a, str>> {
        sharing(class.share.unwrap_or(self.share), self.at, self.options)
    }

    /// A number from 0 up to 1 for each of the kinds of a class that a level has.
    pub(crate) fn kind(&self, class: &Class, kind: u32, seed: u64) -> f64 {
        let kind = kind.to_string();
        shared_draw(seed, [self.options.building, &self.at.level.id, "kind of", &class.id, &kind])
    }
}

/// The number that decides whether a single dwelling, or a room that is part of none, is an exception.
fn single_draw(at: RoomRef<'_>, options: &FurnishOptions<'_>) -> f64 {
    let number = at.room.number.to_string();
    let unit = at.room.dwelling.as_deref().map_or(["room", &number], |dwelling| ["dwelling", dwelling]);
    shared_draw(options.seed, [options.building, &at.level.id, "instead", unit[0], unit[1]])
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use crate::plan::{Level, Room};

    use super::*;
    use crate::catalog::builtin_catalog;
    use crate::layout::tests::level;
    use crate::recipes::find;

    /// A level of one room of a type in a dwelling, numbered by its place.
    fn room(level: &Level, number: u32, room_type: &str, dwelling: Option<&str>) -> Level {
        let dwelling = dwelling.map(str::to_owned);
        let room = Room { number, room_type: room_type.to_owned(), dwelling, ..level.rooms[0].clone() };
        Level { rooms: vec![room].into(), ..level.clone() }
    }

    fn style_of<'a>(level: &Level, catalog: &'a Catalog, seed: u64, style: &str) -> &'a str {
        let options = FurnishOptions::new(seed, "block").with_style(Some(style));
        &catalog.styles[room_style(level.room(0), catalog, &options)].id
    }

    #[test]
    fn flats_differ_and_each_is_of_one_piece() {
        let catalog = builtin_catalog();
        let level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let mut styles = BTreeSet::new();
        for flat in 0..24 {
            let dwelling = format!("flat {flat}");
            let of = |number, room_type| {
                let room = room(&level, number, room_type, Some(&dwelling));
                style_of(&room, catalog, 1, "apartment_block")
            };
            let first = of(flat * 3, "living_room");
            assert_eq!(first, of(flat * 3 + 1, "bedroom"), "{dwelling}");
            assert_eq!(first, of(flat * 3 + 2, "kitchen"), "{dwelling}");
            assert_eq!(first, of(flat * 3, "living_room"), "the same seed gives the same");
            styles.insert(first);
        }
        assert!(styles.len() >= 4, "{styles:?}");
    }

    #[test]
    fn without_dwellings_a_level_is_of_one_piece_and_seeds_differ() {
        let catalog = builtin_catalog();
        let level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let of =
            |number, seed| style_of(&room(&level, number, "bedroom", None), catalog, seed, "apartment_block");
        assert!((0..12).all(|seed| of(1, seed) == of(2, seed)));
        assert!((0..12).map(|seed| of(1, seed)).collect::<BTreeSet<_>>().len() > 2);
    }

    #[test]
    fn furniture_looks_alike_in_what_the_building_style_shares_or_else_the_room_type() {
        let catalog = builtin_catalog();
        let level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let chair = Class::plain("chair", Vec::new(), find("chair").unwrap());
        let of = |room_type, dwelling, style| {
            let options = FurnishOptions::new(1, "block").with_style(style);
            Series::new(room(&level, 1, room_type, dwelling).room(0), catalog, &options).names(&chair).len()
        };
        let (building, level_of_building, dwelling) = (1, 2, 3);
        assert_eq!(of("living_room", Some("flat 1"), None), dwelling);
        assert_eq!(of("living_room", None, None), level_of_building);
        assert_eq!(of("hotel_room", Some("room 1"), None), building);
        assert_eq!(of("hotel_room", Some("room 1"), Some("apartment_block")), dwelling);
        assert_eq!(of("living_room", Some("flat 1"), Some("family_house")), building);
        assert_eq!(of("office", None, Some("office_building")), level_of_building);
        assert_eq!(of("office", None, Some("office_modern")), building, "a style of rooms shares nothing");
    }

    #[test]
    fn a_room_keeps_its_own_style_and_a_building_style_of_its_own_wins_over_that_of_the_run() {
        let catalog = builtin_catalog();
        let level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let own = |style: &str, room_type| {
            let mut level = room(&level, 1, room_type, None);
            level.rooms[0].style = Some(style.to_owned());
            level
        };
        let of = |room: &Level| style_of(room, catalog, 1, "apartment_block").to_owned();
        assert_eq!(of(&own("home_loft", "bedroom")), "home_loft");
        assert!(of(&own("student_residence", "lobby")).starts_with("hotel"), "inherited by room type");
        assert!(of(&own("school_campus", "library")).starts_with("library"));
        assert_eq!(of(&own("hotel_building", "bedroom")), "default", "nothing is said about bedrooms");
    }

    #[test]
    fn a_few_hotel_rooms_are_made_for_wheelchairs_each_with_its_bathroom() {
        let catalog = builtin_catalog();
        let level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let is_accessible = |number: u32, room_type: &str, dwelling: &str| {
            let room = room(&level, number, room_type, Some(dwelling));
            // Of this seed the hotel is no cheap one, which has none.
            style_of(&room, catalog, 1, "hotel_building") == "hotel_accessible"
        };
        let mut accessible = 0;
        for number in 0..400 {
            let dwelling = format!("room {number}");
            let is_one = is_accessible(2 * number, "hotel_room", &dwelling);
            assert_eq!(is_one, is_accessible(2 * number + 1, "hotel_bathroom", &dwelling), "{dwelling}");
            accessible += u32::from(is_one);
        }
        assert!((10..=30).contains(&accessible), "{accessible} of 400");
    }
}
