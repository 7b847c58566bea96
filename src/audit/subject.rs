//! The subject of an audit: one room with the bodies that stand in it.

use core::cell::OnceCell;
use std::borrow::Cow;
use std::collections::BTreeMap;

use crate::catalog::{AuditRules, Catalog, Class, ClassIndex, Side, Style};
use crate::contract::ElementId;
use crate::geometry::{Point, Solid, direction, edges};
use crate::layout::{Furnished, Parent, Placement, object_id, opening_id, solids};
use crate::plan::RoomRef;
use crate::walk::EmptyFloors;

use super::convex::area;
use super::fault::{Element, Named};
use super::groups::{SEAT, SURFACE};
use super::near::{NearBoxes, NearPoints};
use super::upright_box::UprightBox;

/// One furnished room.
pub(crate) struct Subject<'a> {
    /// The room.
    pub(crate) at: RoomRef<'a>,
    /// Where people walk in it while it is empty.
    pub(crate) empty_floors: &'a EmptyFloors<'a>,
    /// The result of the layout.
    pub(crate) furnished: &'a Furnished,
    /// The classes and programmes.
    pub(crate) catalog: &'a Catalog,
    /// One per placement, in its order.
    pub(crate) bodies: Vec<Body<'a>>,
    /// Objects with those that belong to them, by index, sorted.
    children: Vec<(usize, usize)>,
    /// The boxes around the bodies.
    near_boxes: OnceCell<NearBoxes>,
    /// The bodies of each class.
    by_class: OnceCell<BTreeMap<ClassIndex, NearPoints>>,
}

/// One placed object and the space that it fills.
pub(crate) struct Body<'a> {
    /// `<class>.<number>`.
    pub(crate) id: String,
    /// Where it stands.
    pub(crate) placement: &'a Placement,
    /// What it is.
    pub(crate) class: &'a Class,
    /// Its solid parts in the level's frame.
    pub(crate) solids: Vec<Solid>,
    /// The box around them.
    pub(crate) bounds: UprightBox,
}

impl<'a> Subject<'a> {
    /// Builds the bodies of a furnished room.
    pub(crate) fn new(
        empty_floors: &'a EmptyFloors<'a>,
        furnished: &'a Furnished,
        catalog: &'a Catalog,
    ) -> Self {
        let bodies = furnished.placements.iter().map(|placement| Body::new(placement, catalog)).collect();
        let parents = furnished.placements.iter().enumerate();
        let child = |(index, placement): (usize, &Placement)| match placement.parent {
            Parent::Object(parent) => Some((parent, index)),
            _ => None,
        };
        let mut children: Vec<(usize, usize)> = parents.filter_map(child).collect();
        children.sort_unstable();
        Self {
            at: empty_floors.at(),
            empty_floors,
            furnished,
            catalog,
            bodies,
            children,
            near_boxes: OnceCell::new(),
            by_class: OnceCell::new(),
        }
    }

    /// An object, by index into the placements.
    pub(crate) fn object(&self, index: usize) -> Named {
        Named { id: self.bodies[index].id.clone(), element: Element::Object(index) }
    }

    /// An opening, by index into the level's.
    pub(crate) fn opening(&self, index: usize) -> Named {
        Named { id: opening_id(&self.at.level.openings[index]).to_string(), element: Element::Opening(index) }
    }

    /// A class of which a piece is missing.
    pub(crate) fn class(&self, index: ClassIndex) -> Named {
        Named { id: self.catalog.classes[index].id.clone(), element: Element::Class(index) }
    }

    /// A wall, by index into the room's.
    pub(crate) fn wall(index: usize) -> Named {
        Named { id: ElementId::Wall(index).to_string(), element: Element::Wall(index) }
    }

    /// A column, by index into the room's obstacles.
    pub(crate) fn column(index: usize) -> Named {
        Named { id: ElementId::Column(index).to_string(), element: Element::Column(index) }
    }

    /// The thresholds.
    pub(crate) fn rules(&self) -> &'a AuditRules {
        &self.catalog.audit
    }

    /// The style that the room is furnished in.
    pub(crate) fn style(&self) -> &'a Style {
        &self.catalog.styles[self.furnished.style]
    }

    /// The solid parts of all bodies that people walk around: not of rugs.
    pub(crate) fn obstacles(&self) -> impl Iterator<Item = &Solid> {
        self.bodies.iter().filter(|body| !body.placement.is_covering()).flat_map(|body| &body.solids)
    }

    /// The boxes around the bodies, by index.
    pub(crate) fn near_boxes(&self) -> &NearBoxes {
        self.near_boxes.get_or_init(|| NearBoxes::new(self.bodies.iter().map(|body| body.bounds)))
    }

    /// The bodies of a class that are nearest to a place, by index, so many as [`NearPoints::nearest`] gives.
    pub(crate) fn nearest_of(&self, class: ClassIndex, place: Point) -> Cow<'_, [usize]> {
        let by_class = self.by_class.get_or_init(|| {
            let mut places: BTreeMap<ClassIndex, Vec<(usize, Point)>> = BTreeMap::new();
            for (index, body) in self.bodies.iter().enumerate() {
                places.entry(body.placement.class).or_default().push((index, body.placement.position));
            }
            places.into_iter().map(|(class, places)| (class, NearPoints::new(places.into_iter()))).collect()
        });
        by_class.get(&class).map(|bodies| bodies.nearest(place)).unwrap_or_default()
    }

    /// The objects that belong to another directly.
    pub(crate) fn children(&self, object: usize) -> impl Iterator<Item = usize> {
        let from = self.children.partition_point(|&(parent, _)| parent < object);
        self.children[from..]
            .iter()
            .take_while(move |&&(parent, _)| parent == object)
            .map(|&(_, child)| child)
    }

    /// The table or desk that a seat stands at.
    pub(crate) fn table_of(&self, seat: usize) -> Option<usize> {
        let body = &self.bodies[seat];
        let Parent::Object(parent) = body.placement.parent else { return None };
        let is_beside = !matches!(body.placement.side, Side::Above | Side::Below);
        (is_beside && body.is_in(SEAT) && self.bodies[parent].is_in(SURFACE)).then_some(parent)
    }

    /// An object, what it rests on, what that rests on, and so on.
    pub(crate) fn ancestors(&self, object: usize) -> impl Iterator<Item = usize> {
        core::iter::successors(Some(object), |&current| match self.bodies[current].placement.parent {
            // A parent is always an earlier placement, so this walk ends.
            Parent::Object(parent) if parent < current => Some(parent),
            _ => None,
        })
    }

    /// Whether `object` is `ancestor` or rests on it, directly or over others.
    pub(crate) fn descends_from(&self, object: usize, ancestor: usize) -> bool {
        self.ancestors(object).take_while(|&one| one >= ancestor).any(|one| one == ancestor)
    }
}

impl<'a> Body<'a> {
    fn new(placement: &'a Placement, catalog: &'a Catalog) -> Self {
        let class = &catalog.classes[placement.class];
        let solids = solids(class, placement);
        let bounds = solids.iter().map(solid_bounds).fold(UprightBox::EMPTY, UprightBox::union);
        Self { id: object_id(catalog, placement).to_string(), placement, class, solids, bounds }
    }

    /// Whether it belongs to a group of classes.
    pub(crate) fn is_in(&self, group: &str) -> bool {
        self.class.groups.binary_search_by(|one| one.as_str().cmp(group)).is_ok()
    }

    /// Unit vector of its front.
    pub(crate) fn front(&self) -> Point {
        -direction(self.placement.angle).perp()
    }

    /// A point of the class's frame in the level's frame.
    pub(crate) fn place(&self, local: Point) -> Point {
        self.placement.position + direction(self.placement.angle).rotate(local)
    }

    /// The corners of its box, counter-clockwise.
    pub(crate) fn corners(&self) -> [Point; 4] {
        let half = Point::new(self.placement.size.width, self.placement.size.depth) / 2.0;
        [-half, Point::new(half.x, -half.y), half, Point::new(-half.x, half.y)]
            .map(|corner| self.place(corner))
    }

    /// The floor before an upright side, `depth` metres deep and `margin` metres wider than the side at both ends: corners
    /// counter-clockwise, the first and the last at the side.
    pub(crate) fn strip(&self, side: Side, margin: f64, depth: f64) -> [Point; 4] {
        let half = Point::new(self.placement.size.width, self.placement.size.depth) / 2.0;
        // Out of the side, and how far the side lies from the middle and reaches left and right of it.
        let (out, reach, along) = match side {
            Side::Front => (Point::NEG_Y, half.y, half.x),
            Side::Back => (Point::Y, half.y, half.x),
            Side::Left => (Point::NEG_X, half.x, half.y),
            Side::Right => (Point::X, half.x, half.y),
            Side::Above | Side::Below => {
                unreachable!("the catalogue allows clearances at upright sides only")
            }
        };
        let along = along + margin;
        [(reach, -along), (reach + depth, -along), (reach + depth, along), (reach, along)]
            .map(|(out_by, along_by)| self.place(out * out_by + out.perp() * along_by))
    }

    /// Whether it stands on the floor and takes some of it: rugs do not.
    pub(crate) fn is_standing(&self, rules: &AuditRules) -> bool {
        self.low() <= rules.bodies.support_gap && !self.placement.is_covering()
    }

    /// Square metres of floor that it covers: its outline if it is of one piece, else its box.
    pub(crate) fn footprint_area(&self) -> f64 {
        match self.solids.as_slice() {
            [solid] => area(solid.footprint()),
            _ => self.placement.size.width * self.placement.size.depth,
        }
    }

    /// Metres of its underside above the floor.
    pub(crate) fn low(&self) -> f64 {
        self.bounds.low.z
    }

    /// Metres of its top above the floor.
    pub(crate) fn high(&self) -> f64 {
        self.bounds.high.z
    }
}

/// The box around a prism.
pub(crate) fn solid_bounds(solid: &Solid) -> UprightBox {
    let flat = edges(solid.footprint()).fold(UprightBox::EMPTY, |bounds, edge| {
        let corner = edge.start.extend(solid.low);
        bounds.union(UprightBox { low: corner, high: corner })
    });
    UprightBox { low: flat.low, high: flat.high.with_z(solid.high) }
}
