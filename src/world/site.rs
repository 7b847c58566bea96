//! Buildings on their site: which of them one stands in or before, and what each looks like from there.

use std::sync::OnceLock;

use crate::geometry::{Bounds, Point, direction};
use crate::plan::{PlacedBuilding, Plan, SitePlacement};

/// Metres to a building into which one looks from the open air.
const BESIDE: f64 = 30.0;

/// Where the buildings of a plan stand; worked out when somebody first asks.
#[derive(Debug, Default)]
pub(crate) struct Site(OnceLock<Vec<Bounds>>);

impl Site {
    /// The box of each building, in the frame of the site.
    fn boxes(&self, plan: &Plan) -> &[Bounds] {
        self.0.get_or_init(|| plan.buildings.iter().map(site_box).collect())
    }

    /// The buildings near a place in the frame of one of them, without that one. Buildings that no project places are alone.
    pub(crate) fn beside(&self, plan: &Plan, building: usize, position: Point) -> Vec<usize> {
        let placed = &plan.buildings[building];
        if placed.source.project.is_none() {
            return Vec::new();
        }
        let there = Bounds::around_point(on_site(placed.site, position), 0.0);
        let boxes = self.boxes(plan).iter().enumerate();
        let near = boxes.filter(|(index, bounds)| {
            let is_other = *index != building && plan.buildings[*index].source.project.is_some();
            is_other && bounds.gap(there) <= BESIDE
        });
        near.map(|(index, _)| index).collect()
    }

    /// The building whose box is nearest to a place on the site; none in a plan without buildings.
    pub(crate) fn nearest(&self, plan: &Plan, position: Point) -> Option<usize> {
        let there = Bounds::around_point(position, 0.0);
        let boxes = self.boxes(plan).iter().enumerate();
        let nearest = boxes.min_by(|(_, one), (_, other)| one.gap(there).total_cmp(&other.gap(there)));
        nearest.map(|(index, _)| index)
    }
}

fn site_box(placed: &PlacedBuilding) -> Bounds {
    let rooms = placed.building.levels.iter().flat_map(|level| &level.rooms);
    let corners = rooms.flat_map(|room| room.region.outline.corners());
    Bounds::around(corners.map(|corner| on_site(placed.site, *corner)))
}

/// A place in the frame of a building, seen from the site.
pub(crate) fn on_site(site: SitePlacement, position: Point) -> Point {
    site.position + turned(position, site.turn)
}

/// A place of the site, seen from a building.
pub(crate) fn in_building(site: SitePlacement, position: Point) -> Point {
    turned(position - site.position, -site.turn)
}

/// A vector turned counter-clockwise, in radians.
pub(crate) fn turned(vector: Point, angle: f64) -> Point {
    direction(angle).rotate(vector)
}
