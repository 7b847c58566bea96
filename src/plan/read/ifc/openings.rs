//! Reads doors, windows and passages with their place and storey.

use glam::DVec3;

use super::bends::straighten;
use super::columns::Products;
use super::level::Storey;
use super::model::{Entity, Read};
use super::swing::{Doorway, closure};
use crate::geometry::Point;
use crate::plan::clean::to_simple;
use crate::plan::{LeafDraft, OpeningDraft, OpeningKind, OpeningPlace};

const DOORS: [&str; 2] = ["IFCDOOR", "IFCDOORSTANDARDCASE"];
const WINDOWS: [&str; 2] = ["IFCWINDOW", "IFCWINDOWSTANDARDCASE"];
const HOLES: [&str; 2] = ["IFCOPENINGELEMENT", "IFCOPENINGSTANDARDCASE"];
const WALLS: [&str; 3] = ["IFCWALL", "IFCWALLSTANDARDCASE", "IFCWALLELEMENTEDCASE"];
const ROOFS: [&str; 5] = ["IFCROOF", "IFCSLAB", "IFCSLABSTANDARDCASE", "IFCSLABELEMENTEDCASE", "IFCCOVERING"];
/// What windows and doors in roofs and floors say of themselves.
const OVERHEAD: [&str; 3] = ["SKYLIGHT", "LIGHTDOME", "TRAPDOOR"];
/// Horizontal part of a unit vector below which it stands upright.
const FLAT: f64 = 0.5;
/// Heights to depths of what is steeper than 60 degrees: the tangent, less what the thickness of a roof adds to the depth.
const STEEP: f64 = 1.5;
/// Smallest passage in metres, and how high above the floor it may begin: niches and ducts are none.
const PASSAGE_WIDTH: f64 = 0.6;
const PASSAGE_HEIGHT: f64 = 1.8;
const PASSAGE_SILL: f64 = 0.15;
/// Metres above the floor below which a door stands on it.
const DOOR_SILL: f64 = 0.15;
/// Metres by which a hole must fit better when it is taken to be turned by a right angle.
const BETTER: f64 = 0.05;
/// Metres between windows above each other that are one window with a bar across.
const TRANSOM: f64 = 0.3;
/// Metres by which such windows may differ in place and width.
const ONE_PLACE: f64 = 0.1;
/// Places are the same in steps of this many to the metre.
const STEPS: f64 = 1e4;
/// Metres from the middle of a door to places in its rooms.
const BESIDE: [f64; 4] = [0.1, 0.25, 0.4, 0.6];

/// The kinds of products that are read here.
pub(super) fn kinds() -> impl Iterator<Item = &'static str> {
    [DOORS, WINDOWS, HOLES].concat().into_iter()
}

/// An opening in the building's axes.
pub(super) struct Hole {
    pub(super) doorway: Doorway,
    pub(super) low: f64,
    pub(super) high: f64,
    /// Metres across the wall.
    pub(super) depth: f64,
}

/// What a product is to a plan.
enum Found {
    Opening(Hole),
    /// A window or hatch in a roof, a floor or a ceiling.
    Overhead,
    Nothing,
}

/// An element that fills a hole, or a hole itself.
struct Product<'a> {
    entity: &'a Entity,
    /// A door, a window or an opening.
    what: &'a str,
    /// What, with its name in the file.
    name: &'a str,
}

impl Products<'_> {
    /// Enters all openings of a building into its storeys, by kind and number.
    pub(super) fn open(&self, storeys: &mut [Storey]) {
        let model = self.geometry.model;
        let mut overhead: Vec<u64> = Vec::new();
        for (kinds, what) in [(&DOORS, "door"), (&WINDOWS, "window"), (&HOLES, "opening")] {
            for product in self.all(kinds) {
                let name = format!("{what} \"{}\"", product.text(2).or(product.text(0)).unwrap_or_default());
                let found = if what == "opening" { self.passage(&product) } else { self.filler(&product) };
                match found {
                    Ok(Found::Opening(hole)) => {
                        self.enter(storeys, &Product { entity: &product, what, name: &name }, hole)
                    }
                    Ok(Found::Overhead) => overhead.push(product.id),
                    Ok(Found::Nothing) => {}
                    Err(trouble) => {
                        let message = format!("{name}: {}", trouble.message);
                        model.warn(trouble.id, message, "it was left out");
                    }
                }
            }
        }
        self.glaze(storeys);
        for storey in storeys.iter_mut() {
            join_stacks(&mut storey.draft.openings);
            straighten(storey);
        }
        if let [first, ..] = overhead[..] {
            let count =
                if overhead.len() == 1 { "one is".to_owned() } else { format!("{} are", overhead.len()) };
            let message =
                format!("roof windows and hatches: {count} left out, as a plan has openings in walls only");
            let hint = "one that is steeper than 60 degrees is read as a window of the wall beside it";
            model.warn(first, message, hint);
        }
    }

    /// A door or window in its hole, or where it says that it stands.
    fn filler(&self, product: &Entity) -> Read<Found> {
        let axes = self.frame * self.geometry.place(product)?;
        let along = axes.transform_vector3(DVec3::X).truncate();
        let own = |place: usize| {
            let number = product.value(place).number().filter(|number| *number > 0.0);
            number.map(|number| number * self.geometry.units.length)
        };
        let (height, width) = (own(8), own(9));
        let hole = self.relations.hole_of.get(&product.id);
        let is_overhead = along.length() < FLAT || self.is_of_roof(product, hole);
        // Several in one hole stand where they say themselves.
        let hole = hole.filter(|hole| self.relations.fillers.get(hole) == Some(&1));
        let in_hole =
            hole.map(|hole| self.geometry.model.get(*hole).and_then(|hole| self.hole(&hole, along, width)));
        if is_overhead {
            // Holes are cut far through the roof; what fills them has the slope.
            let found = self.hole(product, along, width).or_else(|own| in_hole.unwrap_or(Err(own)));
            let steep = found.ok().filter(|hole| hole.high - hole.low >= STEEP * hole.depth);
            return Ok(steep.map_or(Found::Overhead, Found::Opening));
        }
        if let Some(Ok(hole)) = in_hole {
            return Ok(Found::Opening(hole));
        }
        // Panels of curtain walls have their origin in the middle, at a corner or elsewhere.
        let panel = if self.is_panel(product.id) { self.hole(product, along, width).ok() } else { None };
        if let Some(panel) = panel {
            return Ok(Found::Opening(panel));
        }
        let (Some(width), Some(height)) = (width, height) else {
            return self.hole(product, along, width).map(Found::Opening);
        };
        let along = along.normalize();
        let start = axes.translation;
        let doorway = Doorway { center: start.truncate() + along * (width / 2.0), along, width };
        Ok(Found::Opening(Hole { doorway, low: start.z, high: start.z + height, depth: 0.0 }))
    }

    /// Whether a window or a hatch is drawn into a roof, a floor or a ceiling, or says so itself or by its type.
    fn is_of_roof(&self, product: &Entity, hole: Option<&u64>) -> bool {
        let model = self.geometry.model;
        if let Some(host) = hole.and_then(|hole| self.relations.host_of.get(hole)) {
            return model.is(*host, &ROOFS);
        }
        let kind = self.relations.type_of.get(&product.id).and_then(|kind| model.get(*kind).ok());
        let said = kind.as_ref().filter(|kind| kind.is(&["IFCWINDOWTYPE", "IFCDOORTYPE"]));
        let words = [product.value(10).word(), said.and_then(|kind| kind.value(9).word())];
        words.into_iter().flatten().any(|word| OVERHEAD.contains(&word))
    }

    /// An opening that nothing fills, if people can walk through it.
    fn passage(&self, product: &Entity) -> Read<Found> {
        let host = self.relations.host_of.get(&product.id).copied();
        let is_niche = |place: usize, text: Option<&str>| {
            let word = product.value(place).word().or(text).unwrap_or_default();
            word.eq_ignore_ascii_case("RECESS")
        };
        let is_filled = self.relations.fillers.contains_key(&product.id);
        let Some(host) = host.filter(|host| self.geometry.model.is(*host, &WALLS)) else {
            return Ok(Found::Nothing);
        };
        if is_filled || is_niche(8, product.text(4)) {
            return Ok(Found::Nothing);
        }
        let wall = self.frame * self.geometry.place(&self.geometry.model.get(host)?)?;
        let hole = self.hole(product, wall.transform_vector3(DVec3::X).truncate(), None)?;
        let is_high = hole.high - hole.low >= PASSAGE_HEIGHT;
        let is_wide = hole.doorway.width >= PASSAGE_WIDTH;
        Ok(if is_high && is_wide { Found::Opening(hole) } else { Found::Nothing })
    }

    /// The box of a product's body, along an axis or across it, whichever is nearer to the width.
    pub(super) fn hole(&self, product: &Entity, along: Point, width: Option<f64>) -> Read<Hole> {
        let bodies = self.geometry.bodies(product, &self.frame)?;
        let corners: Vec<DVec3> = bodies.iter().flat_map(|body| body.corners()).collect();
        let span = |axis: DVec3| {
            let places = corners.iter().map(|corner| corner.dot(axis));
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        };
        let along = along.normalize_or_zero();
        if along == Point::ZERO {
            return Err(product.trouble("it lies flat"));
        }
        let axes = [along, along.perp()];
        let spans = axes.map(|axis| span(axis.extend(0.0)));
        let lengths = spans.map(|(low, high)| high - low);
        if !lengths.iter().all(|length| length.is_finite()) {
            return Err(product.trouble("its body has no place"));
        }
        let misfit = |length: f64| width.map_or(-length, |width| (length - width).abs());
        // Without a width the wall's own direction is believed.
        let is_turned = width.is_some() && misfit(lengths[1]) + BETTER < misfit(lengths[0]);
        let middle = |index: usize| axes[index] * (spans[index].0 + spans[index].1) / 2.0;
        let chosen = usize::from(is_turned);
        let (low, high) = span(DVec3::Z);
        let width = width.unwrap_or(lengths[chosen]);
        let doorway = Doorway { center: middle(0) + middle(1), along: axes[chosen], width };
        Ok(Hole { doorway, low, high, depth: lengths[1 - chosen] })
    }

    fn enter(&self, storeys: &mut [Storey], product: &Product<'_>, hole: Hole) {
        let &Product { entity: product, what, name } = product;
        let model = self.geometry.model;
        let home = self.relations.within(product.id, |whole| storeys.iter().any(|storey| storey.id == whole));
        let Some(storey) = storey_of(storeys, home, (hole.low + hole.high) / 2.0) else {
            let message = format!("{name} is on no storey with spaces");
            return model.warn(product.id, message, "it was left out");
        };
        let (bottom, top) = (hole.low - storey.floor, hole.high - storey.floor);
        if what == "opening" && bottom > PASSAGE_SILL {
            return;
        }
        let (kind, leaf) = match what {
            "door" => {
                let closure = closure(self.geometry, self.relations, &self.frame, product, &hole.doorway);
                closure.unwrap_or_else(|trouble| {
                    let hint = "it is hung as seems best";
                    model.warn(trouble.id, format!("how {name} opens: {}", trouble.message), hint);
                    (OpeningKind::Door, LeafDraft::Automatic)
                })
            }
            "window" => (OpeningKind::Window, LeafDraft::None),
            _ => (OpeningKind::Passage, LeafDraft::None),
        };
        let is_low = kind != OpeningKind::Window && bottom < DOOR_SILL;
        let rooms =
            if what == "door" { self.rooms_of(product.id, storey, &hole.doorway) } else { Vec::new() };
        let Doorway { center, along, width } = hole.doorway;
        let id = storey.free_opening_id(product);
        storey.draft.openings.push(OpeningDraft {
            id,
            kind,
            place: OpeningPlace::Points { center, along: Some(along) },
            rooms,
            width,
            bottom: if is_low { 0.0 } else { bottom.max(0.0) },
            top,
            leaf,
        });
    }

    /// The rooms that a door's space boundaries name, if they lie on its two sides; else the geometry decides.
    fn rooms_of(&self, door: u64, storey: &Storey, doorway: &Doorway) -> Vec<String> {
        let normal = doorway.along.perp();
        let side = |sign: f64| BESIDE.map(|distance| doorway.center + normal * (sign * distance));
        let sides = [side(1.0), side(-1.0)];
        let mut found: [Vec<String>; 2] = Default::default();
        let named = self.relations.spaces_of.get(&door);
        let rooms = named.into_iter().flatten().filter_map(|space| storey.rooms_of.get(space)).flatten();
        for room in rooms.filter_map(|index| storey.draft.rooms.get(*index)) {
            let Some(outline) = to_simple(&room.outline) else { continue };
            for (places, rooms) in sides.iter().zip(&mut found) {
                if places.iter().any(|place| outline.contains(*place)) {
                    rooms.push(room.id.clone());
                }
            }
        }
        // Two on one side: the door is drawn across their wall.
        let is_clear = found.iter().all(|rooms| rooms.len() < 2) && found[0] != found[1];
        if is_clear { found.concat() } else { Vec::new() }
    }
}

/// Makes one window of those that stand above each other with a bar between; a wall has one opening at a place.
fn join_stacks(openings: &mut Vec<OpeningDraft>) {
    let place = |opening: &OpeningDraft| match opening.place {
        OpeningPlace::Points { center, .. } => center,
        OpeningPlace::Edge { .. } => Point::NAN,
    };
    let step = |metres: f64| (metres * STEPS).round();
    let order = |a: &OpeningDraft, b: &OpeningDraft| {
        let (first, second) = (place(a), place(b));
        let across = step(first.x).total_cmp(&step(second.x)).then(step(first.y).total_cmp(&step(second.y)));
        across.then(a.bottom.total_cmp(&b.bottom))
    };
    let (mut windows, others): (Vec<_>, Vec<_>) =
        openings.drain(..).partition(|opening| opening.kind == OpeningKind::Window);
    *openings = others;
    windows.sort_by(order);
    let mut joined: Vec<OpeningDraft> = Vec::with_capacity(windows.len());
    for window in windows {
        let below = joined.last_mut().filter(|below| {
            place(below).distance(place(&window)) < ONE_PLACE
                && (below.width - window.width).abs() < ONE_PLACE
                && window.bottom - below.top < TRANSOM
        });
        match below {
            Some(below) => below.top = below.top.max(window.top),
            None => joined.push(window),
        }
    }
    openings.extend(joined);
}

/// The storey that holds a height: its own, or the one whose rooms reach there.
fn storey_of(storeys: &mut [Storey], home: Option<u64>, middle: f64) -> Option<&mut Storey> {
    let holds =
        |storey: &Storey| !storey.draft.rooms.is_empty() && (storey.floor..storey.top).contains(&middle);
    let own = |storey: &&Storey| Some(storey.id) == home;
    let index = storeys
        .iter()
        .position(|storey| own(&storey) && holds(storey))
        .or_else(|| storeys.iter().position(holds))
        .or_else(|| storeys.iter().position(|storey| own(&storey) && !storey.draft.rooms.is_empty()));
    index.map(|index| &mut storeys[index])
}
