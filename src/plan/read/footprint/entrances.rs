//! Gives doors that a map shows as points to the buildings on whose outlines they stand.

use crate::geometry::{Point, Region};
use crate::plan::assemble::BoxIndex;
use crate::storey::Footprint;

/// Metres that a door may be off the outline, which has been simplified.
const REACH: f64 = 0.5;

/// Adds each entrance to the nearest footprint, of equals to that with the first id.
pub(super) fn add_entrances(footprints: &mut [Footprint], entrances: &[Point]) {
    if entrances.is_empty() {
        return;
    }
    let boxes = footprints.iter().map(|footprint| footprint.region.outline.bounds().inflated(REACH));
    let places = BoxIndex::of(boxes.zip(0..));
    for &entrance in entrances {
        let here = crate::geometry::Bounds::around_point(entrance, 0.0);
        let near = places.near(here).into_iter();
        let measured = near.map(|index: usize| (index, distance(&footprints[index].region, entrance)));
        let nearest = measured.filter(|(_, distance)| *distance <= REACH).min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((index, _)) = nearest {
            footprints[index].entrances.push(entrance);
        }
    }
    for footprint in footprints {
        footprint.entrances.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        footprint.entrances.dedup();
    }
}

fn distance(region: &Region, point: Point) -> f64 {
    region.borders().map(|border| border.distance(point)).fold(f64::INFINITY, f64::min)
}
