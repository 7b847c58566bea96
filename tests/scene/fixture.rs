//! Levels, a small catalogue and box models, built in code.

use std::collections::BTreeMap;
use std::sync::Arc;

use roomwright::internals::catalog::{
    Access, ById, Catalog, Class, DEFAULT_STYLE, Finish, Material, Palette, RoomType, Side, Size, Style,
    StyleRef, Untidiness, VariantRef,
};
use roomwright::internals::geometry::{Point, Polygon, Region};
use roomwright::internals::layout::{Furnished, Parent, Placement, Removal, RemovalReason};
use roomwright::internals::model::{Model, ModelMaterial, Primitive};
use roomwright::internals::plan::{
    Leaf, Level, Obstacle, Opening, OpeningKind, OpeningSide, Room, RoomOpening, SitePlacement,
};
use roomwright::internals::recipes::{GeometrySet, Slot, find};
use roomwright::internals::scene::{Parts, Scene, SceneInput, SceneOptions, build_scene};

/// Thickness of a wall to the open air, and of one room's half of a wall between rooms.
pub(crate) const OUTER: f64 = 0.3;
pub(crate) const INNER: f64 = 0.05;

pub(crate) fn point(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// A room with outer walls all round, as yet without openings.
pub(crate) fn room(id: &str, corners: &[(f64, f64)]) -> Room {
    let points: Vec<Point> = corners.iter().map(|&(x, y)| point(x, y)).collect();
    room_of_region(id, Region::simple(Polygon::new(&points).unwrap()))
}

pub(crate) fn room_of_region(id: &str, region: Region) -> Room {
    let mut room = Room::bare(id, "office", region, 2.6, OUTER);
    room.walls.iter_mut().for_each(|wall| wall.is_exterior = true);
    room
}

pub(crate) fn level(rooms: Vec<Room>) -> Level {
    Level { name: "First floor".to_owned(), elevation: 3.2, ..Level::bare("1", 3.2, rooms) }
}

/// A hole in the walls: kind, id, (room, wall, middle along it) per side, width, bottom, top.
pub(crate) struct OpeningPlan<'a> {
    pub(crate) kind: OpeningKind,
    pub(crate) id: &'a str,
    pub(crate) sides: &'a [(usize, usize, f64)],
    pub(crate) width: f64,
    pub(crate) heights: (f64, f64),
}

/// Adds an opening; hinged doors get one leaf that opens into the first room by a right angle.
pub(crate) fn add_opening(level: &mut Level, plan: &OpeningPlan<'_>) {
    let index = level.openings.len();
    let mut sides = Vec::new();
    let mut middles = Vec::new();
    for &(room, wall, at) in plan.sides {
        let (from, to) = (at - plan.width / 2.0, at + plan.width / 2.0);
        sides.push(OpeningSide { room, wall, from, to });
        level.rooms[room].openings.push(RoomOpening { opening: index, wall, from, to });
        let wall = &level.rooms[room].walls[wall];
        let inner = wall.start + wall.direction() * at;
        middles.push(inner);
        if plan.sides.len() == 1 {
            middles.push(inner - wall.normal() * wall.thickness);
        }
    }
    let first = &level.rooms[plan.sides[0].0].walls[plan.sides[0].1];
    let (along, normal) = (first.direction(), first.normal());
    let center = middles.iter().sum::<Point>() / middles.len() as f64;
    let hinge = middles[0] - along * plan.width / 2.0;
    let leaf = Leaf { hinge, closed_tip: hinge + along * plan.width, open_tip: hinge + normal * plan.width };
    let leaves = if plan.kind == OpeningKind::Door { vec![leaf] } else { Vec::new() };
    let (bottom, top) = plan.heights;
    let opening = Opening {
        id: plan.id.to_owned(),
        kind: plan.kind,
        center,
        along,
        width: plan.width,
        bottom,
        top,
        leaves,
        sides,
    };
    level.openings.push(opening);
}

/// Two rooms with an entrance, a door between them and a window:
///
/// ```text
///   +--------------+------------+
///   |  101         |  102       |   3 m deep, 4 m and 3 m wide,
///   |            door           |   0.1 m of wall between them
///   +---entrance---+---window---+
/// ```
pub(crate) fn two_rooms() -> Level {
    let mut left = room("101", &[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
    let mut right = room("102", &[(4.1, 0.0), (7.1, 0.0), (7.1, 3.0), (4.1, 3.0)]);
    for wall in [&mut left.walls[1], &mut right.walls[3]] {
        (wall.thickness, wall.is_exterior) = (INNER, false);
    }
    left.walls[0].tags = vec!["front".to_owned()];
    right.number = 2;
    let mut level = level(vec![left, right]);
    let door = OpeningPlan {
        kind: OpeningKind::Door,
        id: "d1",
        sides: &[(0, 0, 2.0)],
        width: 1.0,
        heights: (0.0, 2.1),
    };
    add_opening(&mut level, &door);
    add_opening(
        &mut level,
        &OpeningPlan { id: "d2", sides: &[(0, 1, 1.5), (1, 3, 1.5)], width: 0.9, ..door },
    );
    add_opening(
        &mut level,
        &OpeningPlan {
            kind: OpeningKind::Window,
            id: "w1",
            sides: &[(1, 0, 1.5)],
            width: 1.5,
            heights: (0.9, 2.2),
        },
    );
    level
}

fn class(id: &str, width: f64, depth: f64, height: f64) -> Class {
    Class {
        looks: 2,
        ..Class::plain(id, vec![Size { width, depth, height }], find("cabinet").expect("a recipe"))
    }
}

fn material(slot: Slot) -> Material {
    let shade = 0.3 + 0.6 * slot as usize as f32 / Slot::ALL.len() as f32;
    let is_glass = slot == Slot::Glass;
    Material {
        base_color: [shade, 0.5, 1.0 - shade, 1.0],
        metallic: 0.0,
        roughness: if is_glass { 0.05 } else { 0.8 },
        emissive: if slot == Slot::Lamp { [1.0; 3] } else { [0.0; 3] },
        emissive_strength: if slot == Slot::Lamp { 4.0 } else { 1.0 },
        transmission: if is_glass { 0.9 } else { 0.0 },
        texture: None,
        tints: Vec::new(),
    }
}

/// Classes `chair`, `desk`, `lamp`; room type `office`; the default style.
pub(crate) fn catalog() -> Catalog {
    let palette = |id: &str| Palette {
        id: id.to_owned(),
        materials: Slot::ALL.iter().map(|&slot| (slot, material(slot))).collect(),
    };
    let finish = Finish {
        floor: Slot::Carpet,
        wall: Slot::Plaster,
        ceiling: Slot::Ceiling,
        dado: None,
        sockets: Some(3.0),
        has_switches: true,
    };
    let office = RoomType {
        id: "office".into(),
        label: "Office".into(),
        is_furnished: true,
        joins_levels: false,
        programme: Vec::new(),
        excludes: Vec::new(),
        area: (0.0, 1e6),
        plausible: roomwright::internals::catalog::Plausible::default(),
        share: roomwright::internals::catalog::Share::default(),
        density: (0.2, 0.4),
        finish,
    };
    let palettes: ById<Palette> = ["modern", "warm"].map(palette).into_iter().collect();
    let style = |id: &str, palette: &str| Style {
        id: id.to_owned(),
        label: id.to_owned(),
        room_types: Vec::new(),
        programmes: BTreeMap::new(),
        additions: BTreeMap::new(),
        geometry: GeometrySet::Plain,
        palette: palettes.find(palette).unwrap(),
        untidiness: Untidiness::default(),
        density: 1.0,
        access: Access::default(),
        era: None,
        wealth: None,
    };
    Catalog {
        classes: vec![
            class("chair", 0.45, 0.45, 0.9),
            class("desk", 1.6, 0.8, 0.74),
            class("lamp", 0.2, 0.2, 0.4),
        ],
        room_types: BTreeMap::from([("office".to_owned(), office)]),
        // The default style is the first of them.
        styles: [style(DEFAULT_STYLE, "modern"), style("warm", "warm")].into_iter().collect(),
        palettes,
        ..Catalog::default()
    }
}

pub(crate) fn placement(catalog: &Catalog, class: &str, number: u32, parent: Parent) -> Placement {
    let class = catalog.class_index(class).unwrap();
    Placement {
        class,
        number,
        parent,
        side: Side::Above,
        position: Point::ZERO,
        elevation: 0.0,
        angle: 0.0,
        variant: 0,
        size: catalog.classes[class].size(0),
    }
}

pub(crate) fn furnished(room: usize, placements: Vec<Placement>) -> Furnished {
    Furnished {
        room,
        seed: 7 + room as u64,
        style: StyleRef::default(),
        requested: placements.len() as u32,
        placements,
        removals: Vec::new(),
    }
}

/// Room 101 with a desk, a lamp on it and a chair before it; room 102 with a chair and a removal.
pub(crate) fn two_furnished(catalog: &Catalog) -> Vec<Furnished> {
    let place = |class, number, parent, (x, y), elevation, angle| Placement {
        position: point(x, y),
        elevation,
        angle,
        ..placement(catalog, class, number, parent)
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut second = furnished(1, vec![place("chair", 1, Parent::Wall(2), (6.0, 2.7), 0.0, 0.0)]);
    second.removals = vec![Removal { class: 1, reason: RemovalReason::NoPlace, is_required: true }];
    second.requested = 2;
    let first = vec![
        place("desk", 1, Parent::Wall(3), (0.4, 1.5), 0.0, quarter),
        place("lamp", 1, Parent::Object(0), (0.3, 2.0), 0.74, 0.0),
        place("chair", 1, Parent::Object(0), (1.0, 1.5), 0.0, -quarter),
    ];
    vec![furnished(0, first), second]
}

/// A closed box in a class's frame.
pub(crate) fn box_model(size: Size, slot: Slot) -> Model {
    let (w, h, d) = (size.width as f32 / 2.0, size.height as f32, size.depth as f32 / 2.0);
    let faces: [([f32; 3], [[f32; 3]; 4]); 6] = [
        ([0., 0., 1.], [[-w, 0., d], [w, 0., d], [w, h, d], [-w, h, d]]),
        ([0., 0., -1.], [[w, 0., -d], [-w, 0., -d], [-w, h, -d], [w, h, -d]]),
        ([1., 0., 0.], [[w, 0., d], [w, 0., -d], [w, h, -d], [w, h, d]]),
        ([-1., 0., 0.], [[-w, 0., -d], [-w, 0., d], [-w, h, d], [-w, h, -d]]),
        ([0., 1., 0.], [[-w, h, d], [w, h, d], [w, h, -d], [-w, h, -d]]),
        ([0., -1., 0.], [[-w, 0., -d], [w, 0., -d], [w, 0., d], [-w, 0., d]]),
    ];
    let mut primitive = Primitive { material: ModelMaterial::Slot(slot), ..Primitive::default() };
    for (index, (normal, corners)) in faces.iter().enumerate() {
        primitive.positions.extend(corners);
        primitive.normals.extend([normal; 4]);
        primitive.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| index as u32 * 4 + corner));
    }
    Model { primitives: vec![primitive] }
}

/// One box per class and variant.
pub(crate) fn models(catalog: &Catalog) -> impl Fn(VariantRef, GeometrySet) -> Arc<Model> + Sync {
    let of_class = |class: &Class| {
        let box_of =
            |variant| Arc::new(box_model(class.size(variant), Slot::ALL[variant as usize % Slot::ALL.len()]));
        (0..class.variant_count()).map(box_of).collect::<Vec<_>>()
    };
    let models: Vec<Vec<Arc<Model>>> = catalog.classes.iter().map(of_class).collect();
    move |of, _| Arc::clone(&models[of.class][of.variant as usize])
}

/// The scene of a level with the small catalogue.
pub(crate) fn scene(level: &Level, furnished: &[Furnished]) -> Scene {
    scene_by(catalog(), level, furnished, Parts::Separate)
}

fn scene_by(catalog: Catalog, level: &Level, furnished: &[Furnished], parts: Parts) -> Scene {
    let models = models(&catalog);
    let options = SceneOptions { parts, ..SceneOptions::default() };
    build_scene(&SceneInput { options, ..input(level, furnished, &catalog, &models) })
}

/// The input of a scene without textures, with the usual options.
pub(crate) fn input<'a>(
    level: &'a Level,
    furnished: &'a [Furnished],
    catalog: &'a Catalog,
    models: &'a (dyn Fn(VariantRef, GeometrySet) -> Arc<Model> + Sync + 'a),
) -> SceneInput<'a> {
    SceneInput {
        style: None,
        level,
        building: "tower",
        attribution: None,
        site: SitePlacement::default(),
        furnished,
        verdicts: &[],
        catalog,
        models,
        textures: None,
        swatches: None,
        options: SceneOptions::default(),
        seed: 42,
    }
}

/// The scene of a level without furniture.
pub(crate) fn bare_scene(level: &Level) -> Scene {
    scene(level, &empty(level))
}

/// The scene of a level without furniture, what never moves apart in one mesh.
pub(crate) fn merged_scene(level: &Level) -> Scene {
    scene_by(catalog(), level, &empty(level), Parts::Merged)
}

fn empty(level: &Level) -> Vec<Furnished> {
    (0..level.rooms.len()).map(|room| furnished(room, Vec::new())).collect()
}

/// A square column.
pub(crate) fn column(center: Point, half: f64, height: f64) -> Obstacle {
    let low = center - Point::splat(half);
    Obstacle { outline: Polygon::rectangle(low, Point::splat(2.0 * half)), height }
}

/// The scene of a level with furniture, by another catalogue.
pub(crate) fn furnished_scene(level: &Level, catalog: &Catalog, furnished: &[Furnished]) -> Scene {
    scene_by(catalog.clone(), level, furnished, Parts::Separate)
}

/// The scene of a level without furniture, by another catalogue.
pub(crate) fn scene_of(level: &Level, catalog: &Catalog) -> Scene {
    scene_by(catalog.clone(), level, &empty(level), Parts::Separate)
}
