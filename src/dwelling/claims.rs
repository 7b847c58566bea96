//! The household of a dwelling, and the rooms that it takes.

use crate::catalog::{Claim, Household, Households};

use super::living::{best, living_rooms, role_of};
use super::rooms::Chamber;

/// The people of a dwelling and what they make of its rooms.
#[derive(Debug, PartialEq)]
pub(super) struct Settled {
    /// Id of the household.
    pub(super) household: String,
    /// How many people.
    pub(super) persons: u32,
    /// Rooms in which somebody sleeps.
    pub(super) bedrooms: u32,
    /// By room of the dwelling: the role, where it differs from the type of the plan.
    pub(super) roles: Vec<Option<String>>,
}

/// Draws a household and gives it the rooms; none where no household fits. `draw` answers a number in [0, 1) for a purpose.
pub(super) fn settle(
    chambers: &[Chamber<'_>],
    households: &Households,
    draw: &dyn Fn(&str) -> f64,
) -> Option<Settled> {
    let mut rooms = Rooms::new(chambers, households);
    let count = rooms.sleeping_count();
    let id = household(chambers, households, count, draw("household"))?;
    let household = &households.kinds[id];
    let mut persons = household.persons;
    for (number, claim) in household.claims.iter().enumerate() {
        let is_wished = claim.chance >= 1.0 || draw(&format!("claim {number}")) < claim.chance;
        if holds(claim, count) && is_wished {
            persons += claim.persons * rooms.take(claim);
        }
    }
    rooms.share_out_spare();
    let bedrooms = rooms.bedrooms();
    Some(Settled { household: id.to_owned(), persons: persons.max(1), bedrooms, roles: rooms.roles })
}

fn holds(claim: &Claim, count: usize) -> bool {
    let count = u32::try_from(count).unwrap_or(u32::MAX);
    (claim.rooms.0..=claim.rooms.1).contains(&count)
}

/// The household that the plan wishes, else one drawn from those that have what the plan names; else from all.
fn household<'a>(
    chambers: &[Chamber<'_>],
    households: &'a Households,
    count: usize,
    drawn: f64,
) -> Option<&'a str> {
    let wished = chambers.iter().find_map(|chamber| chamber.room.household.as_ref());
    if let Some((id, _)) = wished.and_then(|id| households.kinds.get_key_value(id)) {
        return Some(id);
    }
    let fits = |household: &Household| has_what_is_named(household, chambers, households, count);
    let weight = |household: &Household| household.weight(count);
    let fitting = || households.kinds.iter().filter(|(_, household)| fits(household));
    let is_any = fitting().any(|(_, household)| weight(household) > 0.0);
    let candidates: Vec<(&String, f64)> = if is_any {
        fitting().map(|(id, household)| (id, weight(household))).collect()
    } else {
        households.kinds.iter().map(|(id, household)| (id, weight(household))).collect()
    };
    let total: f64 = candidates.iter().map(|(_, weight)| weight).sum();
    let mut left = drawn * total;
    let is_drawn = |(_, weight): &&(&String, f64)| {
        left -= weight;
        *weight > 0.0 && left < 0.0
    };
    candidates.iter().find(is_drawn).map(|(id, _)| id.as_str())
}

/// Whether a household has use for the rooms whose types say who lives there: each child's room has its child.
fn has_what_is_named(
    household: &Household,
    chambers: &[Chamber<'_>],
    households: &Households,
    count: usize,
) -> bool {
    let named = |kind: &str| chambers.iter().filter(|chamber| chamber.room.room_type == kind).count();
    let claims = |role: &str| {
        let claims = household.claims.iter().filter(|claim| claim.role == role && holds(claim, count));
        claims.map(|claim| claim.count as usize).sum::<usize>()
    };
    let claimed =
        households.kinds.values().flat_map(|one| one.claims.iter().map(|claim| claim.role.as_str()));
    let with = households.kinds.values().flat_map(|one| one.with.iter().map(String::as_str));
    let has_use = |role: &str| named(role) <= claims(role);
    let has_with = |kind: &str| named(kind) == 0 || household.with.contains(kind);
    claimed.into_iter().all(has_use) && with.into_iter().all(has_with)
}

/// The rooms of a dwelling while they are shared out.
struct Rooms<'a> {
    chambers: &'a [Chamber<'a>],
    households: &'a Households,
    roles: Vec<Option<String>>,
}

impl<'a> Rooms<'a> {
    /// All rooms, the living room taken.
    fn new(chambers: &'a [Chamber<'a>], households: &'a Households) -> Self {
        let mut roles = vec![None; chambers.len()];
        for (room, role) in living_rooms(chambers, households) {
            roles[room] = Some(role);
        }
        Self { chambers, households, roles }
    }

    fn is_open(&self, room: &usize) -> bool {
        self.roles[*room].is_none()
    }

    /// Rooms to sleep in, besides the living room.
    fn sleeping_count(&self) -> usize {
        let open = (0..self.chambers.len()).filter(|room| self.is_open(room));
        open.filter(|&room| self.chambers[room].may_sleep(self.households)).count()
    }

    /// Gives a claim its rooms; those that the plan names already count. Answers how many it has.
    fn take(&mut self, claim: &Claim) -> u32 {
        let named = self.chambers.iter().filter(|chamber| chamber.room.room_type == claim.role).count();
        let mut taken = u32::try_from(named).unwrap_or(u32::MAX).min(claim.count);
        let Some(role) = self.households.roles.get(&claim.role) else { return taken };
        let sign = if role.takes_smallest { -1.0 } else { 1.0 };
        while taken < claim.count {
            let suits = |room: &usize| self.is_open(room) && self.chambers[*room].suits(role);
            let is_light = |room: &usize| suits(room) && self.chambers[*room].is_light;
            let all = 0..self.chambers.len();
            let light = all.clone().filter(|room| role.wants_window && is_light(room));
            let area = |room: usize| sign * self.chambers[room].area;
            let found = best(light, area).or_else(|| best(all.filter(suits), area));
            let Some(room) = found else { break };
            self.roles[room] = Some(claim.role.clone());
            taken += 1;
        }
        taken
    }

    /// Gives the rooms that nobody claims what they are good for.
    fn share_out_spare(&mut self) {
        let spare = &self.households.homes.spare;
        for room in 0..self.chambers.len() {
            if self.is_open(&room) {
                let found = role_of(self.chambers, room, spare, self.households);
                self.roles[room] = found.map(|(_, role)| role);
            }
        }
    }

    /// Rooms in which somebody sleeps.
    fn bedrooms(&self) -> u32 {
        let kind = |room: usize| self.roles[room].as_ref().unwrap_or(&self.chambers[room].room.room_type);
        let sleeps = |room: &usize| self.households.roles.get(kind(*room)).is_some_and(|role| role.sleeps);
        u32::try_from((0..self.chambers.len()).filter(sleeps).count()).unwrap_or(u32::MAX)
    }
}
