//! Ground floors of another use than what is above: a shop in place of each flat that lies at the street.

use super::dwelling::Cell;
use super::ring::{Ring, join};
use super::spine::Ground;
use super::thin::joined_to_largest;

/// Metres of wall with light at which a shop has its door and its windows.
const FRONT: f64 = 3.0;

/// The ground floor below flats: where a flat was, a room of `main` type with the flat's bath as a toilet and its store; stairs,
/// lifts and baths stay where they are on the levels above. Flats without a wall of some metres to the open air stay flats.
/// `None` if none became a shop.
pub(super) fn street_level(cells: &[Cell], ground: &Ground, main: &str) -> Option<Vec<Cell>> {
    let units = cells.iter().filter_map(|cell| cell.unit).max()? + 1;
    let mut found: Vec<Cell> = cells.iter().filter(|cell| cell.unit.is_none()).cloned().collect();
    let mut shops = 0;
    for unit in 0..units {
        let flat: Vec<Cell> = cells.iter().filter(|cell| cell.unit == Some(unit)).cloned().collect();
        match shop(&flat, ground, main) {
            Some(rooms) => {
                found.extend(rooms);
                shops += 1;
            }
            None => found.extend(flat),
        }
    }
    (shops > 0).then_some(found)
}

/// A shop with a toilet and a store, of the rooms of a flat.
fn shop(flat: &[Cell], ground: &Ground, main: &str) -> Option<Vec<Cell>> {
    let (small, large): (Vec<&Cell>, Vec<&Cell>) = flat.iter().partition(|cell| kept_as(cell).is_some());
    let rings: Vec<Ring> = large.into_iter().map(|cell| cell.ring.clone()).collect();
    let (mut room, mut apart) = joined_to_largest(rings)?;
    let mut rooms = Vec::new();
    for cell in small {
        // What joined the others belongs to the shop too.
        let with_it = if apart.is_empty() { None } else { join(&room, &cell.ring) };
        match with_it {
            Some(joined) => (room, apart) = joined_to_largest([vec![joined], apart].concat())?,
            None => rooms.push(Cell::shared(cell.ring.clone(), kept_as(cell)?)),
        }
    }
    let front = ground.light(&room).into_iter().map(|piece| piece.length()).fold(0.0, f64::max);
    if !apart.is_empty() || front < FRONT {
        return None;
    }
    rooms.insert(0, Cell::shared(room, main));
    Some(rooms)
}

/// What a small room of a flat is in a shop.
fn kept_as(cell: &Cell) -> Option<&'static str> {
    match cell.room_type.as_str() {
        "bathroom" => Some("toilet"),
        "storeroom" => Some("storeroom"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    fn cell(room_type: &str, unit: usize, corners: [(f64, f64); 4]) -> Cell {
        Cell { unit: Some(unit), ..Cell::shared(corners.map(Point::from).into(), room_type) }
    }

    #[test]
    fn a_flat_without_light_stays_a_flat() {
        let cells = [cell("studio", 0, [(0., 0.), (6., 0.), (6., 6.), (0., 6.)])];
        let ground = Ground {
            ring: cells[0].ring.clone(),
            facade: super::super::facade::Facade::default(),
            wall: 0.3,
        };
        assert!(street_level(&cells, &ground, "shop").is_none());
    }

    #[test]
    fn the_rooms_of_a_flat_become_one_and_its_bath_stays() {
        let cells = [
            cell("corridor", 0, [(0., 0.), (6., 0.), (6., 1.), (0., 1.)]),
            cell("bedroom", 0, [(0., 1.), (4., 1.), (4., 6.), (0., 6.)]),
            cell("bathroom", 0, [(4., 1.), (6., 1.), (6., 6.), (4., 6.)]),
        ];
        let ring: Ring = [(0., 0.), (6., 0.), (6., 6.), (0., 6.)].map(Point::from).into();
        let around = super::super::facade::Around { neighbours: vec![], entrances: vec![], streets: vec![] };
        let facade = super::super::facade::look_out(&ring, &[], &around);
        let ground = Ground { ring, facade, wall: 0.0 };
        let found = street_level(&cells, &ground, "shop").expect("it lies at the open air");
        let types: Vec<&str> = found.iter().map(|cell| cell.room_type.as_str()).collect();
        assert_eq!(types, ["shop", "toilet"]);
        assert!((super::super::ring::area(&found[0].ring) - 26.0).abs() < 1e-9);
        assert!(found.iter().all(|cell| cell.unit.is_none()));
    }
}
