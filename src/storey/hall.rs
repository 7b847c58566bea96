//! How far the hall of a dwelling reaches: it ends where no room needs it, for rooms may be entered from a living room too.

use super::fill::{DOOR_STRETCH, Slice, Wish};
use super::typology::Light;

/// Share of an end of the strip along which a living room lies that takes it.
const TAKING_SHARE: f64 = 0.8;
/// Rooms of a dwelling at most of which the hall is looked at: more are no dwelling.
const MOST_ROOMS: usize = 32;
/// Cost of a room that is entered from another than the best for it.
const ENTRY_COST: f64 = 0.2;

/// Metres of the shortest hall: a door and somebody before it.
const LEAST_HALL: f64 = 1.3;

/// What is known of a hall before its rooms are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hall<'a> {
    /// Its room type.
    pub(super) room_type: &'a str,
    /// From where to where along the strip people come in.
    pub(super) port: Option<(f64, f64)>,
    /// Cost of each metre of it.
    pub(super) per_metre: f64,
}

/// Rooms in rows along a strip of which the hall will be a part.
struct Strip<'a> {
    rooms: &'a [Slice],
    wishes: &'a [Wish<'a>],
    hall_type: &'a str,
    /// By room: where it borders on the strip.
    contacts: &'a [Option<(f64, f64)>],
    /// From where to where some room borders on the strip.
    extent: (f64, f64),
}

/// The rooms that are entered from the hall, as bits, and what the hall and the other ways cost.
#[derive(Clone, Copy, Debug)]
struct Reach {
    hall: (f64, f64),
    at_hall: u32,
    cost: f64,
}

/// Shortens the hall as far as that is worth it: rooms at its ends are then not at the hall but entered from a living room, or are
/// the living room that takes the end of the strip. Returns from where to where it reaches, and what it costs, with the rooms that
/// are entered from another than the best for them; `None` where no hall is worth its cost. `contacts` are by slice: where it
/// borders on the strip.
pub(super) fn shorten(
    contacts: &[Option<(f64, f64)>],
    wishes: &[Wish<'_>],
    hall: Hall<'_>,
    (slices, is_worth): (&mut [Slice], &dyn Fn(f64) -> bool),
) -> Option<((f64, f64), f64)> {
    if slices.len() > MOST_ROOMS {
        return None;
    }
    let extent = contacts.iter().flatten().fold((f64::INFINITY, f64::NEG_INFINITY), |extent, contact| {
        (contact.0.min(extent.0), contact.1.max(extent.1))
    });
    let strip = Strip { rooms: slices, wishes, hall_type: hall.room_type, contacts, extent };
    let best = strip.best_reach(hall, is_worth)?;
    for (index, slice) in slices.iter_mut().enumerate() {
        slice.is_at_hall = best.at_hall & (1 << index) != 0;
    }
    Some((best.hall, best.cost))
}

impl Strip<'_> {
    /// The cheapest of all places at which the hall may begin and end.
    fn best_reach(&self, hall: Hall<'_>, is_worth: &dyn Fn(f64) -> bool) -> Option<Reach> {
        let contacts = || self.contacts.iter().flatten().filter(|(from, to)| to - from >= DOOR_STRETCH);
        let (latest, earliest) = hall.port.unwrap_or((f64::INFINITY, f64::NEG_INFINITY));
        let mut lows: Vec<f64> = contacts().map(|(_, to)| (to - DOOR_STRETCH).min(latest)).collect();
        let mut highs: Vec<f64> = contacts().map(|(from, _)| (from + DOOR_STRETCH).max(earliest)).collect();
        for places in [&mut lows, &mut highs] {
            places.sort_by(f64::total_cmp);
            places.dedup();
        }
        let mut best: Option<Reach> = None;
        for &low in &lows {
            let start = low.max(self.extent.0);
            for &high in highs.iter().filter(|high| high.min(self.extent.1) - start >= LEAST_HALL) {
                let length_cost = (high - low) * hall.per_metre;
                // The rooms may add to that, and longer halls cost more.
                if best.is_some_and(|best| best.cost <= length_cost) || !is_worth(length_cost) {
                    break;
                }
                let reach = self.reach((low, high), length_cost);
                best = match (best, reach) {
                    (Some(best), Some(reach)) if reach.cost >= best.cost => Some(best),
                    (best, reach) => reach.or(best),
                };
            }
        }
        best
    }

    /// How all rooms are entered where the hall reaches so far; `None` where one is not.
    fn reach(&self, hall: (f64, f64), length_cost: f64) -> Option<Reach> {
        let mut at_hall = 0u32;
        for (index, contact) in self.contacts.iter().enumerate() {
            let shared = contact.map_or(0.0, |(from, to)| to.min(hall.1) - from.max(hall.0));
            at_hall |= u32::from(shared >= DOOR_STRETCH - 1e-6) << index;
        }
        let ends = [(self.extent.0, hall.0), (hall.1, self.extent.1)];
        let takers = ends.map(|end| (0..self.rooms.len()).find(|&room| self.takes(room, end)));
        let mut cost = length_cost;
        for room in 0..self.rooms.len() {
            if at_hall & (1 << room) != 0 {
                cost += if self.is_best_at_hall(room, at_hall) { 0.0 } else { ENTRY_COST };
                continue;
            }
            if takers.contains(&Some(room)) {
                continue;
            }
            let beside =
                self.beside(room).filter(|&host| at_hall & (1 << host) != 0 || takers.contains(&Some(host)));
            let before = (0..2).filter_map(|side| {
                let (from, to) = self.contacts[room]?;
                let shared = to.min(ends[side].1) - from.max(ends[side].0);
                takers[side].filter(|_| shared >= DOOR_STRETCH)
            });
            let ranks = beside.chain(before).filter_map(|host| self.rank(room, host, at_hall));
            let rank = ranks.min()?;
            cost += if rank == 0 { 0.0 } else { ENTRY_COST };
        }
        Some(Reach { hall, at_hall, cost })
    }

    /// Whether an end of the strip that is no hall becomes a part of a room.
    fn takes(&self, room: usize, (from, to): (f64, f64)) -> bool {
        let needs = self.wishes[self.rooms[room].wish].needs;
        let shared = self.contacts[room].map_or(0.0, |contact| contact.1.min(to) - contact.0.max(from));
        needs.passage && needs.light == Light::Required && to > from && shared >= TAKING_SHARE * (to - from)
    }

    /// The rooms beside a room in its row.
    fn beside(&self, room: usize) -> impl Iterator<Item = usize> {
        let is_near = |other: &usize| self.rooms[*other].row == self.rooms[room].row;
        let next = Some(room + 1).filter(|next| *next < self.rooms.len());
        let found = [room.checked_sub(1).filter(is_near), next.filter(is_near)];
        found.into_iter().flatten()
    }

    /// Whether the hall is the best for a room that borders on it: a kitchen is better beside the living room, a second bath beside a
    /// bedroom. Doors may lead there all the same.
    fn is_best_at_hall(&self, room: usize, at_hall: u32) -> bool {
        let needs = self.wishes[self.rooms[room].wish].needs;
        let is_beside = |types: &[String]| {
            self.beside(room)
                .any(|host| types.iter().any(|word| word == self.wishes[self.rooms[host].wish].room_type))
        };
        let best = needs.doors.first().map(std::slice::from_ref).unwrap_or_default();
        if best.iter().any(|word| word != self.hall_type) && !is_beside(best) {
            return false;
        }
        needs.suite_of.is_empty() || !self.has_alike(room, at_hall) || is_beside(&needs.suite_of)
    }

    /// Whether another room of its type is at the hall.
    fn has_alike(&self, room: usize, at_hall: u32) -> bool {
        let room_type = |room: usize| self.wishes[self.rooms[room].wish].room_type;
        (0..self.rooms.len())
            .any(|other| other != room && at_hall & (1 << other) != 0 && room_type(other) == room_type(room))
    }

    /// How gladly a room is entered from another, 0 best; `None` where it is not. A second bath may belong to a bedroom.
    fn rank(&self, room: usize, host: usize, at_hall: u32) -> Option<usize> {
        let wish = |room: usize| &self.wishes[self.rooms[room].wish];
        let host_type = wish(host).room_type;
        let needs = wish(room).needs;
        let rank = needs.doors.iter().position(|door| door == host_type);
        rank.or_else(|| {
            (needs.suite_of.iter().any(|word| word == host_type) && self.has_alike(room, at_hall))
                .then_some(0)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::facade::{Around, look_out};
    use super::super::fill::{Filling, Floor, Wanted, fill};
    use super::super::ring::Ring;
    use super::super::spine::{Ground, Spine};
    use super::*;
    use crate::geometry::Point;
    use crate::layout::seed::building_stream;

    const ROOMS: [(&str, f64); 6] = [
        ("living_dining", 36.0),
        ("kitchen", 9.0),
        ("bedroom", 16.0),
        ("bedroom", 14.0),
        ("bathroom", 5.0),
        ("bathroom", 4.0),
    ];

    /// These rooms in two rows beside a strip of 14 m that people come into at its left end.
    fn filling(per_metre: f64) -> Filling {
        let catalog = crate::catalog::builtin_catalog();
        let ring: Ring = [(0.0, 0.0), (14.0, 0.0), (14.0, 10.4), (0.0, 10.4)].map(Point::from).into();
        let facade = look_out(&ring, &[], &Around { neighbours: vec![], entrances: vec![], streets: vec![] });
        let spine = Spine::new(&Ground { ring, facade, wall: 0.0 }, 4.5, 5.9, &[]).expect("a strip");
        let wish = |(room_type, area): (&'static str, f64)| Wish {
            room_type,
            area,
            needs: &catalog.typologies.rooms[room_type],
        };
        let hall = Hall { room_type: "corridor", port: Some((-0.7, 0.7)), per_metre };
        let floor = Floor { rows: &spine.rows, hall: Some(hall) };
        let wishes = ROOMS.map(wish);
        fill(floor, &Wanted::of(&wishes), 60, &mut building_stream(1, "a", "b")).expect("a filling")
    }

    #[test]
    fn a_dear_hall_is_shorter_and_fewer_rooms_are_entered_from_it() {
        let length = |filling: &Filling| filling.hall.map_or(0.0, |(from, to)| to.min(14.0) - from.max(0.0));
        let doors = |filling: &Filling| filling.slices.iter().filter(|slice| slice.is_at_hall).count();
        let (free, dear) = (filling(0.0), filling(2.0));
        assert!(length(&dear) >= LEAST_HALL && length(&dear) < length(&free), "{dear:?} {free:?}");
        assert!(doors(&dear) < ROOMS.len() && doors(&dear) >= 2, "{dear:?}");
        let is_bath = |slice: &&Slice| ROOMS[slice.wish].0 == "bathroom";
        assert!(dear.slices.iter().filter(is_bath).any(|slice| slice.is_at_hall), "{dear:?}");
    }
}
