//! Resolves who lives in dwellings.

use std::collections::BTreeSet;

use super::number::{AREA, COUNT, FACTOR, Quantity, SHARE, check_count};
use crate::catalog::file::{
    ClaimEntry, HomesEntry, HouseholdEntry, HouseholdsFile, LivingEntry, PickWord, RoleEntry, RoomTypeEntry,
};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Table;
use crate::catalog::{Claim, Homes, Household, Households, Role};

/// The words for what files may name here.
const ROOM_TYPE: &str = "room type";
const ROLE: &str = "role";

/// Merges the files of all folders: homes key by key, roles and households by id; later ones win.
pub(crate) fn resolve_households(
    files: &[(usize, HouseholdsFile)],
    room_types: &Table<RoomTypeEntry>,
    report: &mut Report<'_>,
) -> Households {
    let is_room = |id: &&str| room_types.get(id).is_some_and(|definition| !definition.entry.is_abstract);
    let known: BTreeSet<&str> = room_types.ids().filter(is_room).collect();
    let mut households = Households::default();
    for (source, file) in files {
        let mut check = Check { known: &known, report };
        for (id, entry) in &file.roles {
            let spot = Spot::definition(*source, "roles", id);
            check.name(ROOM_TYPE, id, &spot);
            households.roles.insert(id.clone(), check.role(entry, &spot));
        }
        if let Some(entry) = &file.homes {
            check.homes(&mut households.homes, entry, &Spot { source: *source, path: vec!["homes".into()] });
        }
        for (id, entry) in &file.households {
            let spot = Spot::definition(*source, "households", id);
            households.kinds.insert(id.clone(), check.household(id, entry, &spot));
        }
    }
    check_roles(files, &households, report);
    households
}

/// Reports roles that nothing defines, once all files are read.
fn check_roles(files: &[(usize, HouseholdsFile)], households: &Households, report: &mut Report<'_>) {
    let known: BTreeSet<&str> = households.roles.keys().map(String::as_str).collect();
    let mut check = Check { known: &known, report };
    for (source, file) in files {
        for (id, entry) in &file.households {
            let rooms = Spot::definition(*source, "households", id).key("rooms");
            for (index, claim) in entry.rooms.iter().enumerate() {
                check.name(ROLE, &claim.role, &rooms.index(index).key("role"));
            }
        }
        let Some(homes) = &file.homes else { continue };
        let spot = Spot { source: *source, path: vec!["homes".into()] };
        for (index, role) in homes.spare.iter().flatten().enumerate() {
            check.name(ROLE, role, &spot.key("spare").index(index));
        }
        if let Some(living) = &homes.living_roles {
            let spot = spot.key("living_roles");
            let lists = [
                ("table_is_missing", &living.table_is_missing),
                ("table_is_there", &living.table_is_there),
                ("kitchen_is_missing", &living.kitchen_is_missing),
            ];
            for (key, roles) in lists {
                for (index, role) in roles.iter().enumerate() {
                    check.name(ROLE, role, &spot.key(key).index(index));
                }
            }
            check.name(ROLE, &living.only_room, &spot.key("only_room"));
            check.name(ROLE, &living.second, &spot.key("second"));
        }
    }
}

/// Checks words against those that are known.
struct Check<'a, 'b, 'c> {
    known: &'a BTreeSet<&'a str>,
    report: &'b mut Report<'c>,
}

impl Check<'_, '_, '_> {
    fn name(&mut self, what: &str, word: &str, spot: &Spot) {
        if !self.known.contains(word) {
            self.report.unknown(spot, what, word, self.known.iter().copied());
        }
    }

    fn types(&mut self, words: &[String], spot: &Spot) -> BTreeSet<String> {
        for (index, word) in words.iter().enumerate() {
            self.name(ROOM_TYPE, word, &spot.index(index));
        }
        words.iter().cloned().collect()
    }

    fn role(&mut self, entry: &RoleEntry, spot: &Spot) -> Role {
        let area = entry.area.map_or((*AREA.start(), *AREA.end()), |pair| pair.with_highest(*AREA.end()));
        let quantity = Quantity { name: "area", unit: " m²", range: AREA };
        Role {
            of: self.types(&entry.of, &spot.key("of")),
            area: quantity.check_pair(area, &spot.key("area"), self.report),
            wants_window: entry.window,
            sleeps: entry.sleeps,
            takes_smallest: entry.pick == PickWord::Smallest,
        }
    }

    fn homes(&mut self, homes: &mut Homes, entry: &HomesEntry, spot: &Spot) {
        let keys = [
            ("inside", &entry.inside, &mut homes.inside),
            ("between", &entry.between, &mut homes.between),
            ("outdoors", &entry.outdoors, &mut homes.outdoors),
            ("kitchens", &entry.kitchens, &mut homes.kitchens),
            ("living", &entry.living, &mut homes.living),
            ("dining", &entry.dining, &mut homes.dining),
            ("bathrooms", &entry.bathrooms, &mut homes.bathrooms),
        ];
        for (key, words, place) in keys {
            if let Some(words) = words {
                *place = self.types(words, &spot.key(key));
            }
        }
        if let Some(area) = entry.dining_kitchen {
            let quantity = Quantity { name: "dining_kitchen", unit: " m²", range: AREA };
            homes.dining_kitchen = quantity.check(area, &spot.key("dining_kitchen"), self.report);
        }
        if let Some(living) = &entry.living_roles {
            let LivingEntry { table_is_missing, table_is_there, only_room, second, kitchen_is_missing } =
                living;
            homes.living_with_table.clone_from(table_is_missing);
            homes.living_without_table.clone_from(table_is_there);
            homes.only_room.clone_from(only_room);
            homes.second_living.clone_from(second);
            homes.living_with_kitchen.clone_from(kitchen_is_missing);
        }
        if let Some(spare) = &entry.spare {
            homes.spare.clone_from(spare);
        }
    }

    fn household(&mut self, id: &str, entry: &HouseholdEntry, spot: &Spot) -> Household {
        let weight = Quantity::plain("chance", FACTOR);
        let chances = entry.chance.iter().enumerate();
        let chances = chances
            .map(|(index, chance)| weight.check(*chance, &spot.key("chance").index(index), self.report));
        let chances = chances.collect();
        let claims = entry.rooms.iter().enumerate();
        Household {
            label: entry.label.clone().unwrap_or_else(|| id.replace('_', " ")),
            persons: check_count("persons", entry.persons, &spot.key("persons"), self.report),
            chances,
            with: self.types(&entry.with, &spot.key("with")),
            claims: claims.map(|(index, claim)| self.claim(claim, &spot.key("rooms").index(index))).collect(),
        }
    }

    fn claim(&mut self, entry: &ClaimEntry, spot: &Spot) -> Claim {
        let most = *COUNT.end() as f64;
        let rooms = entry.rooms.map_or((0.0, most), |pair| pair.with_highest(most));
        let rooms = Quantity::plain("rooms", 0.0..=most).check_pair(rooms, &spot.key("rooms"), self.report);
        let chance = Quantity::plain("chance", SHARE);
        Claim {
            role: entry.role.clone(),
            count: check_count("count", entry.count.unwrap_or(1), &spot.key("count"), self.report),
            chance: chance.check(entry.chance.unwrap_or(1.0), &spot.key("chance"), self.report),
            rooms: (rooms.0 as u32, rooms.1 as u32),
            persons: check_count("persons", entry.persons.unwrap_or(0), &spot.key("persons"), self.report),
        }
    }
}
