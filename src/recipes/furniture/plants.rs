//! Plants.

use glam::{DVec2, DVec3};

use super::parts::{Foliage, PotSize, Species, grow, pot};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Blade, Builder, Outline, SINK, Slice, blade, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Share of a plant's height that the pot takes.
const POT_SHARE: f64 = 0.27;
/// What grows, by look: each set begins with another.
const SPECIES: [Species; 4] = [Species::Tree, Species::Palm, Species::Sword, Species::Bush];

fn species(draft: &Draft) -> Species {
    let shift = match draft.set() {
        GeometrySet::Plain => 0,
        GeometrySet::Traditional => 1,
        GeometrySet::Industrial => 2,
        GeometrySet::Budget => 3,
    };
    SPECIES[(draft.input.look as usize + shift) % 4]
}

/// A plant in a pot on the floor: a fig, a palm, a snake plant or a bush.
pub(super) static PLANT: Recipe =
    Recipe::furniture("plant", [0.6, 0.6, 1.4]).round().symbol(Symbol::Plant).every_set(plant);

fn plant(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let height = (bay.height() * POT_SHARE).min(0.38);
    pot(builder, draft.set(), draft.input.look, PotSize { radius: radius * 0.62, height }, 14);
    let species = species(draft);
    let rise = bay.height() - height;
    let trunk = if species == Species::Palm && bay.height() > 1.0 { rise * 0.3 } else { 0.0 };
    if trunk > 0.0 {
        // Rings where old fronds fell.
        let rings = 5;
        let mut profile = Vec::new();
        for ring in 0..rings {
            let y = height * 0.8 + (trunk + height * 0.2) * f64::from(ring) / f64::from(rings);
            let step = (trunk + height * 0.2) / f64::from(rings);
            profile.extend([(0.026, y), (0.019, y + step * 0.9)]);
        }
        builder.add(Slot::WoodDark, lathe(&profile, 7));
    }
    let foliage = Foliage {
        species,
        root: DVec3::new(0.0, height * 0.86 + trunk, 0.0),
        count: match species {
            Species::Tree => 32,
            Species::Palm => 20,
            Species::Sword => 18,
            Species::Bush => 28,
        },
        spread: radius,
        height: rise - trunk + height * 0.14,
        // Fronds hang over in a bow.
        is_fine: species == Species::Palm,
    };
    grow(builder, &mut sampler, &foliage);
}

/// A small plant for sills and desks.
pub(super) static SMALL_PLANT: Recipe =
    Recipe::accessory("small_plant", [0.2, 0.2, 0.3]).round().symbol(Symbol::Plant).every_set(small_plant);

fn small_plant(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let height = bay.height() * 0.42;
    pot(builder, draft.set(), draft.input.look, PotSize { radius: radius * 0.7, height }, 7);
    let species = match species(draft) {
        Species::Tree => Species::Bush,
        other => other,
    };
    let foliage = Foliage {
        species,
        root: DVec3::new(0.0, height * 0.84, 0.0),
        count: 8,
        spread: radius,
        height: bay.height() - height * 0.84,
        is_fine: false,
    };
    grow(builder, &mut sampler, &foliage);
}

/// A long trough with a row of plants: cast, boarded with feet, of sheet metal, or of plastic.
pub(super) static PLANTER: Recipe =
    Recipe::furniture("planter", [1.2, 0.4, 0.9]).symbol(Symbol::Plant).every_set(planter);

fn planter(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let height = bay.height() * 0.45;
    trough(draft, builder, bay.with_y([0.0, height]));
    let species = species(draft);
    let count = (bay.width() / bay.depth().max(0.05) * 1.4).round().clamp(1.0, 5.0) as u32;
    for column in bay.columns(count, 0.0) {
        let foliage = Foliage {
            species,
            root: DVec3::new(column.center().x, height * 0.88, 0.0),
            count: 16,
            spread: column.width().min(bay.depth()) / 2.0,
            height: bay.height() - height * 0.88,
            is_fine: false,
        };
        grow(builder, &mut sampler, &foliage);
    }
}

fn trough(draft: &Draft, builder: &mut Builder, bay: Bay) {
    let half = bay.extent() / 2.0;
    let height = bay.height();
    let wall = 0.025_f64.min(half.x.min(half.z) * 0.2);
    let look = draft.form();
    let slice = |share: f64, back: f64| Slice::new(height * share, half.x - back, half.z - back);
    let (slot, outside): (Slot, Vec<Slice>) = match draft.set() {
        GeometrySet::Plain => (
            [Slot::Concrete, Slot::Ceramic, Slot::Stone, Slot::Painted][look],
            vec![slice(0.0, if look.is_multiple_of(2) { 0.0 } else { wall * 1.5 }), slice(1.0, 0.0)],
        ),
        GeometrySet::Traditional => (
            Slot::Terracotta,
            vec![
                slice(0.0, wall * 1.4),
                slice(0.08, wall * 1.4),
                slice(0.1, wall * 1.8),
                slice(0.8, wall * 0.9),
                slice(0.82, 0.0),
                slice(1.0, 0.0),
            ],
        ),
        GeometrySet::Industrial => (
            [Slot::Metal, Slot::MetalDark, Slot::Concrete, Slot::Metal][look],
            vec![slice(0.0, wall), slice(0.94, wall * 0.4), slice(0.95, 0.0), slice(1.0, 0.0)],
        ),
        GeometrySet::Budget => (
            [Slot::PlasticDark, Slot::Plastic, Slot::Terracotta, Slot::PaintedAccent][look],
            vec![slice(0.0, wall * 1.6), slice(0.85, wall * 0.6), slice(0.86, 0.0), slice(1.0, 0.0)],
        ),
    };
    let is_boarded = draft.set() == GeometrySet::Traditional && look.is_multiple_of(2);
    let inside = [slice(1.0, wall), slice(0.7, wall * 1.2)];
    builder.add(
        if is_boarded { Slot::WoodDark } else { slot },
        loft(&Outline::Square, &outside.into_iter().chain(inside).collect::<Vec<_>>()),
    );
    builder.cuboid(
        Slot::Soil,
        bay.with_y([height * 0.7 - SINK, height * 0.9]).inset(wall * 1.15, 0.0, wall * 1.15),
    );
    if is_boarded {
        boards_and_posts(builder, bay, wall);
    }
}

/// Boards before a trough, between posts at its corners.
fn boards_and_posts(builder: &mut Builder, bay: Bay, wall: f64) {
    let height = bay.height();
    let boards = bay.with_y([height * 0.12, height * 0.8]).inset(wall * 1.2, 0.0, 0.0);
    for side in [Side::Front, Side::Back] {
        let face = boards.slab(side, wall * 1.6).inset(0.0, 0.0, wall * 0.3);
        face.rows(3, 0.006).into_iter().for_each(|board| builder.block(Slot::Wood, board, 0.003));
    }
    for side in [Side::Left, Side::Right] {
        for end in [Side::Front, Side::Back] {
            let post = bay.slab(side, wall * 2.2).slab(end, wall * 2.2).with_y([0.001, height * 0.86]);
            builder.cuboid(Slot::Wood, post.inset(0.001, 0.0, 0.001));
        }
    }
}

/// A vase: empty, or with stems and blossoms or twigs in some looks.
pub(super) static VASE: Recipe = Recipe::accessory("vase", [0.15, 0.15, 0.3]).round().every_set(vase);

fn vase(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look % 4;
    let has_flowers = look % 2 == 1;
    let body = if has_flowers { bay.without(Side::Above, bay.height() * 0.45) } else { bay };
    let half = body.extent() / 2.0 * if has_flowers { 0.66 } else { 1.0 };
    let profiles: [[(f64, f64); 6]; 4] = [
        [(0.0, 0.55), (0.2, 0.9), (0.42, 1.0), (0.7, 0.7), (0.86, 0.42), (1.0, 0.5)],
        [(0.0, 0.8), (0.05, 0.82), (0.3, 0.86), (0.6, 0.92), (0.9, 0.98), (1.0, 1.0)],
        [(0.0, 0.7), (0.12, 0.96), (0.3, 1.0), (0.5, 0.72), (0.64, 0.3), (1.0, 0.34)],
        [(0.0, 0.7), (0.06, 0.5), (0.12, 0.6), (0.55, 1.0), (0.85, 0.8), (1.0, 0.9)],
    ];
    let shift = draft.set() as usize;
    let profile = profiles[(look as usize + shift) % 4];
    let slice = |share: f64, shrink: f64| Slice::new(share * body.height(), half.x * shrink, half.z * shrink);
    let (_, neck) = profile[5];
    let slices: Vec<Slice> = profile
        .iter()
        .map(|&(share, shrink)| slice(share, shrink))
        .chain([slice(1.0, neck - 0.12), slice(0.8, neck.min(profile[4].1) - 0.14)])
        .collect();
    let slot = match draft.set() {
        GeometrySet::Plain => [Slot::Ceramic, Slot::Glass, Slot::Concrete, Slot::PaintedAccent],
        GeometrySet::Traditional => [Slot::Ceramic, Slot::Glass, Slot::Brass, Slot::Ceramic],
        GeometrySet::Industrial => [Slot::MetalDark, Slot::Glass, Slot::Concrete, Slot::Metal],
        GeometrySet::Budget => [Slot::Glass, Slot::Ceramic, Slot::Plastic, Slot::Terracotta],
    }[look as usize];
    builder.add(slot, loft(&Outline::Round(if has_flowers { 8 } else { 12 }), &slices));
    if has_flowers {
        bunch(draft, builder, bay, body.height());
    }
}

/// Stems with a blossom or leaves each, out of a vase.
fn bunch(draft: &Draft, builder: &mut Builder, bay: Bay, rim: f64) {
    let half = bay.extent() / 2.0;
    let blossom = half.min_element() * 0.3;
    let slots = [Slot::FabricAccent, Slot::Linen, Slot::PaintedAccent, Slot::Book];
    let stalks = [((-0.7, 0.0), 1.0), ((0.7, 0.05), 0.84), ((0.05, 0.7), 0.9), ((0.0, -0.7), 0.78)];
    for (index, (place, rise)) in stalks.into_iter().enumerate() {
        let place = DVec2::from(place);
        let top = bay.height() * rise - blossom;
        let head = DVec3::new(place.x * half.x, top, place.y * half.z);
        let foot = DVec3::new(-place.x * half.x * 0.15, rim * 0.6, -place.y * half.z * 0.15);
        builder.add(Slot::Leaf, sweep(&[foot, head + DVec3::Y * blossom * 0.3], blossom * 0.1, 3));
        let petals = [(blossom * 0.3, -blossom * 0.6), (blossom, blossom), (0.0, blossom * 0.35)];
        let slot = slots[(draft.input.look as usize / 2 + index / 2) % 4];
        builder.add(slot, lathe(&petals, 5).moved(head.x, head.y, head.z));
        if index % 2 == 1 {
            let rib = [
                foot.lerp(head, 0.4),
                foot.lerp(head, 0.6) + DVec3::new(place.x, 0.0, place.y) * half.x * 0.2,
                foot.lerp(head, 0.8) + DVec3::new(place.x, 0.0, place.y) * half.x * 0.2,
            ];
            builder.add(
                Slot::Leaf,
                blade(&Blade { rib: &rib, half_widths: &[blossom * 0.4], thickness: 0.001, fold: 0.1 }),
            );
        }
    }
}
