//! Who lives in dwellings, and what that makes of their rooms.

use std::collections::{BTreeMap, BTreeSet};

/// Everything that configuration says about the people in dwellings.
#[derive(Clone, Debug, Default)]
pub struct Households {
    /// Which rooms are parts of dwellings, and what they are for.
    pub homes: Homes,
    /// By room type: which rooms may be furnished as one.
    pub roles: BTreeMap<String, Role>,
    /// The households by id.
    pub kinds: BTreeMap<String, Household>,
}

/// What the room types of plans say about dwellings.
#[derive(Clone, Debug, Default)]
pub struct Homes {
    /// The types of rooms of dwellings.
    pub inside: BTreeSet<String>,
    /// Types of what stands between dwellings or outside of them.
    pub between: BTreeSet<String>,
    /// Types of rooms in the open: a door to one lets light in.
    pub outdoors: BTreeSet<String>,
    /// Types of rooms in which meals are cooked.
    pub kitchens: BTreeSet<String>,
    /// Types of rooms with a sofa and a screen.
    pub living: BTreeSet<String>,
    /// Types of rooms with a table for meals.
    pub dining: BTreeSet<String>,
    /// Types of rooms with a bath or shower.
    pub bathrooms: BTreeSet<String>,
    /// Square metres from which on a kitchen has a table for meals.
    pub dining_kitchen: f64,
    /// The roles of a living room where no other room has a table for meals: the first that fits.
    pub living_with_table: Vec<String>,
    /// The roles of a living room where one has: the first that fits.
    pub living_without_table: Vec<String>,
    /// The role of a room in which people live and sleep, for there is no other.
    pub only_room: String,
    /// The role of a second living room, which has no screen.
    pub second_living: String,
    /// The roles of the living room of a flat whose plan names no kitchen: the first that fits.
    pub living_with_kitchen: Vec<String>,
    /// The roles of rooms that nobody claims: the first that fits.
    pub spare: Vec<String>,
}

/// Which rooms may be furnished as a room type.
#[derive(Clone, Debug)]
pub struct Role {
    /// The types of a plan that leave this role open.
    pub of: BTreeSet<String>,
    /// Square metres, least and most.
    pub area: (f64, f64),
    /// Whether it takes a room without daylight only where no other is left.
    pub wants_window: bool,
    /// Whether somebody sleeps there.
    pub sleeps: bool,
    /// Whether it takes the smallest room that suits it, not the largest.
    pub takes_smallest: bool,
}

/// A kind of household.
#[derive(Clone, Debug)]
pub struct Household {
    /// A title for people.
    pub label: String,
    /// How many people it is; those of its claims are added.
    pub persons: u32,
    /// Its weight in dwellings with no room to sleep in besides the living room, with one, and so on; the last counts for all
    /// with more.
    pub chances: Vec<f64>,
    /// Room types of a plan that only such households have.
    pub with: BTreeSet<String>,
    /// Who takes a room, in this order.
    pub claims: Vec<Claim>,
}

impl Household {
    /// Its weight in a dwelling with so many rooms to sleep in.
    #[must_use]
    pub fn weight(&self, rooms: usize) -> f64 {
        self.chances.get(rooms).or(self.chances.last()).copied().unwrap_or_default()
    }
}

/// A wish of a household for rooms.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What the rooms are then.
    pub role: String,
    /// How many rooms, at most.
    pub count: u32,
    /// The probability of the wish.
    pub chance: f64,
    /// The numbers of rooms to sleep in, least and most, with which it holds.
    pub rooms: (u32, u32),
    /// How many people each of these rooms adds to the household.
    pub persons: u32,
}
