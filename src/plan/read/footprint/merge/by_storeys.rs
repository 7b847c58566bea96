//! Divides buildings whose parts have storeys of their own: a tower on a block becomes two buildings, wall to wall.

use geo::{BooleanOps, MultiPolygon};

use super::{Item, Whole};
use crate::geometry::Region;
use crate::plan::clean::mean_width;
use crate::plan::read::footprint::facts::Facts;
use crate::plan::read::footprint::notes::{SiteNotes, Split};
use crate::plan::read::footprint::sound::{regions_of, surface_of, united};
use crate::plan::read::footprint::tidy::tidied;
use crate::storey::StoreyFacts;

/// Storeys by which a part differs from the building around it, from which on it is a building of its own. One more or less is a
/// matter of roofs and counting.
const DIFFERENT: u32 = 2;
/// Square metres of the smallest piece that is a building of its own: stairs and a room on each storey.
const LEAST_AREA: f64 = 50.0;
/// Metres of the mean width of such a piece.
const LEAST_WIDTH: f64 = 4.5;
/// Parts of one building that are clipped; landmarks are drawn in hundreds.
const MOST_PARTS: usize = 64;
/// Words of parts in which nobody stands.
const NO_STOREYS: [&str; 4] = ["roof", "canopy", "bridge", "balcony"];

/// The buildings, those with parts of unlike heights in pieces of one height each. Their ids have `-1`, `-2` and so on behind the
/// id of the building, the largest first.
pub(in super::super) fn in_pieces(wholes: Vec<Whole>, notes: &mut SiteNotes) -> Vec<Whole> {
    let mut found = Vec::with_capacity(wholes.len());
    for whole in wholes {
        let pieces = pieces_of(&whole);
        if pieces.len() < 2 {
            found.push(whole);
            continue;
        }
        let Item { id, facts, .. } = whole.building;
        notes.split.push(Split { id: id.clone(), pieces: pieces.len() });
        found.extend(pieces.into_iter().zip(1..).map(|(piece, number)| {
            let storeys =
                StoreyFacts { above_ground: Some(f64::from(piece.storeys)), ..StoreyFacts::default() };
            // What the map counts of the whole is of no piece.
            let facts = Facts { storeys, flats: None, unreadable: Vec::new(), ..facts.clone() };
            let building = Item { id: format!("{id}-{number}"), parent: None, region: piece.region, facts };
            Whole { building, parts: Vec::new() }
        }));
    }
    found
}

/// A part of the ground with the storeys above it.
struct Piece {
    storeys: u32,
    region: Region,
}

/// The pieces of a building, the largest first: one where its parts differ in nothing.
fn pieces_of(whole: &Whole) -> Vec<Piece> {
    let told = |item: &Item| item.facts.storeys.told().map(|(storeys, _)| storeys);
    let mut parts: Vec<(u32, &Item)> = whole
        .parts
        .iter()
        .filter(|part| !part.facts.uses.iter().any(|(_, word)| NO_STOREYS.contains(&word.as_str())))
        .filter_map(|part| Some((told(part)?, part)))
        .collect();
    let largest = parts.iter().max_by(|a, b| a.1.region.area().total_cmp(&b.1.region.area()));
    let largest = largest.map(|(storeys, _)| *storeys);
    let Some(usual) = told(&whole.building).or(largest) else {
        return Vec::new();
    };
    parts.sort_by_key(|(storeys, _)| std::cmp::Reverse(*storeys));
    // What the map says of the whole is often the height of its tower: the ground around the parts is as high as most of them.
    let covered = united(parts.iter().map(|(_, part)| &part.region)).iter().map(Region::area).sum::<f64>();
    let is_covered = covered > 0.9 * whole.building.region.area();
    let base = if is_covered { largest.unwrap_or(usual) } else { usual };
    parts.truncate(MOST_PARTS);
    let mut groups: Vec<(u32, MultiPolygon<f64>)> = Vec::new();
    let mut rest = MultiPolygon::new(vec![surface_of(&whole.building.region)]);
    for (storeys, part) in parts {
        // The highest first: what lies under it is its lower storeys.
        let surface = MultiPolygon::new(vec![surface_of(&part.region)]);
        let own = rest.intersection(&surface);
        rest = rest.difference(&surface);
        let storeys = if storeys.abs_diff(base) < DIFFERENT { base } else { storeys };
        match groups.iter_mut().find(|(known, _)| *known == storeys) {
            Some((_, area)) => *area = area.union(&own),
            None => groups.push((storeys, own)),
        }
    }
    match groups.iter_mut().find(|(known, _)| *known == base) {
        Some((_, area)) => *area = area.union(&rest),
        None => groups.push((base, rest)),
    }
    let pieces = groups.into_iter().flat_map(|(storeys, area)| {
        regions_of(area).into_iter().map(move |region| Piece { storeys, region })
    });
    joined(pieces.collect())
}

/// Pieces too small for a building go to the neighbour with which they have most in common.
fn joined(mut pieces: Vec<Piece>) -> Vec<Piece> {
    pieces.sort_by(|a, b| b.region.area().total_cmp(&a.region.area()));
    let is_building =
        |piece: &Piece| piece.region.area() >= LEAST_AREA && mean_width(&piece.region.outline) >= LEAST_WIDTH;
    let (mut kept, small): (Vec<Piece>, Vec<Piece>) = pieces.into_iter().partition(is_building);
    for piece in small {
        let with = kept.iter_mut().find_map(|other| {
            let mut both = united([&other.region, &piece.region]);
            (both.len() == 1).then(|| (both.remove(0), other))
        });
        if let Some((region, other)) = with {
            other.region = region;
        }
    }
    kept.sort_by(|a, b| b.region.area().total_cmp(&a.region.area()));
    for piece in &mut kept {
        piece.region = tidied(piece.region.clone());
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Polygon};

    fn item(id: &str, low: (f64, f64), size: (f64, f64), storeys: Option<f64>) -> Item {
        let outline = Polygon::rectangle(Point::new(low.0, low.1), Point::new(size.0, size.1));
        let storeys = StoreyFacts { above_ground: storeys, ..StoreyFacts::default() };
        let facts = Facts { storeys, ..Facts::default() };
        Item { id: id.into(), parent: None, region: Region::simple(outline), facts }
    }

    fn divided(parts: Vec<Item>, storeys: Option<f64>) -> Vec<(String, f64, Option<f64>)> {
        let whole = Whole { building: item("a", (0.0, 0.0), (40.0, 20.0), storeys), parts };
        let wholes = in_pieces(vec![whole], &mut SiteNotes::default());
        let row = |whole: Whole| {
            let Item { id, region, facts, .. } = whole.building;
            (id, region.area().round(), facts.storeys.above_ground)
        };
        wholes.into_iter().map(row).collect()
    }

    #[test]
    fn a_tower_on_a_block_is_a_building_of_its_own() {
        let tower = || item("tower", (0.0, 0.0), (12.0, 20.0), Some(14.0));
        let expected = [("a-1".to_owned(), 560.0, Some(4.0)), ("a-2".to_owned(), 240.0, Some(14.0))];
        assert_eq!(divided(vec![tower()], Some(4.0)), expected);
        // The block is drawn as a part, too, and the map gives the whole the height of the tower.
        let block = item("block", (0.0, 0.0), (40.0, 20.0), Some(4.0));
        assert_eq!(divided(vec![block, tower()], Some(14.0)), expected);
    }

    #[test]
    fn a_storey_more_or_a_turret_divides_nothing() {
        let whole = [("a".to_owned(), 800.0, Some(4.0))];
        assert_eq!(divided(vec![item("b", (0.0, 0.0), (12.0, 20.0), Some(5.0))], Some(4.0)), whole);
        assert_eq!(divided(vec![item("b", (0.0, 0.0), (5.0, 5.0), Some(9.0))], Some(4.0)), whole);
        assert_eq!(divided(vec![item("b", (0.0, 0.0), (12.0, 20.0), None)], Some(4.0)), whole);
    }
}
