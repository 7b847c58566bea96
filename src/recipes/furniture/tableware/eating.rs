//! Place settings and bowls.

use super::{Profile, turned};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, Solid, lathe, loft};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A place setting: plate, fork on the left, knife on the right; on a mat with sharp or soft corners or, bought cheaply, on
/// the tray of a canteen.
pub(in super::super) static PLATE: Recipe = Recipe::accessory("plate", [0.45, 0.32, 0.03]).every_set(plate);

fn plate(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let thick = (bay.height() * 0.12).min(0.003);
    let mat = draft.sampler().pick(&[Slot::FabricLight, Slot::FabricAccent, Slot::Linen]);
    match draft.set() {
        GeometrySet::Budget => builder.add(Slot::PlasticDark, canteen_tray(bay, thick)),
        GeometrySet::Traditional => builder.add(mat, soft_mat(bay, thick)),
        GeometrySet::Plain | GeometrySet::Industrial => builder.cuboid(mat, bay.slab(Side::Below, thick)),
    }
    let above = bay.without(Side::Below, thick - SINK);
    let side = bay.depth().min(bay.width() * 0.72) * 0.88;
    let dish = Bay::around(above.center(), side, above.height(), side);
    builder.add(Slot::Ceramic, dish_of(draft.set(), dish));
    let rest = (bay.width() - side) / 2.0 - 0.004;
    let length = (side * 0.8).min(0.22);
    // Rims of trays stand before the ends.
    let edge = if draft.set() == GeometrySet::Budget { rest * 0.25 } else { 0.004 };
    let place =
        above.slab(Side::Below, thick + SINK).with_z([-length / 2.0, length / 2.0]).inset(edge, 0.0, 0.0);
    cutlery(builder, place.slab(Side::Left, rest - edge), place.slab(Side::Right, rest - edge));
}

/// A mat with soft corners.
fn soft_mat(bay: Bay, thick: f64) -> Solid {
    let half = bay.extent() / 2.0;
    let slice = |y: f64| Slice::new(y, half.x, half.z).softened(half.x.min(half.z) * 0.5);
    loft(&Outline::Soft(2), &[slice(0.0), slice(thick)])
}

/// A tray with soft corners and a low rim.
fn canteen_tray(bay: Bay, thick: f64) -> Solid {
    let half = bay.extent() / 2.0;
    let low = half.x.min(half.z);
    let slice = |y: f64, back: f64| {
        Slice::new(y, half.x - low * back, half.z - low * back).softened(low * (0.4 - back))
    };
    let rim = (bay.height() * 0.6).max(thick * 2.0);
    loft(&Outline::Soft(1), &[slice(0.0, 0.08), slice(rim, 0.0), slice(rim, 0.03), slice(thick, 0.1)])
}

/// The plate: with a slanting rim; with a broad rim round a well; square; or straight from a low wall.
fn dish_of(set: GeometrySet, bay: Bay) -> Solid {
    let profile: Profile = match set {
        GeometrySet::Plain => &[(0.0, 0.55), (0.9, 0.98), (1.0, 1.0), (0.95, 0.94), (0.45, 0.66), (0.4, 0.6)],
        GeometrySet::Traditional => {
            &[(0.0, 0.6), (0.55, 0.7), (0.96, 1.0), (1.0, 0.99), (0.7, 0.68), (0.28, 0.56)]
        }
        GeometrySet::Industrial => return square_dish(bay),
        GeometrySet::Budget => &[(0.0, 0.8), (1.0, 0.92), (1.0, 0.86), (0.3, 0.74)],
    };
    turned(bay, profile)
}

/// A square plate with upright edges.
fn square_dish(bay: Bay) -> Solid {
    let (half, middle) = (bay.extent() / 2.0, bay.center());
    let slice = |share: f64, shrink: f64| {
        let slice = Slice::new(bay.low.y + share * bay.height(), half.x * shrink, half.z * shrink);
        slice.softened(half.x * shrink * 0.12).at(middle.x, middle.z)
    };
    let slices = [slice(0.0, 0.84), slice(0.3, 0.88), slice(1.0, 0.9), slice(1.0, 0.86), slice(0.4, 0.82)];
    loft(&Outline::Soft(1), &slices)
}

/// A fork and a knife with their handles to the front.
fn cutlery(builder: &mut Builder, left: Bay, right: Bay) {
    let (length, thick) = (left.depth(), left.height());
    let fork = left.inset(left.width() * 0.28, 0.0, 0.0);
    let head = fork.slab(Side::Back, length * 0.34);
    let grip = fork.without(Side::Back, length * 0.34 - SINK).inset(fork.width() * 0.34, thick * 0.05, 0.0);
    builder.cuboid(Slot::Chrome, grip);
    builder.cuboid(Slot::Chrome, head.slab(Side::Front, length * 0.1));
    let tines = head.without(Side::Front, length * 0.1 - SINK).inset(0.0004, thick * 0.05, 0.0);
    tines.columns(3, fork.width() * 0.16).into_iter().for_each(|tine| builder.cuboid(Slot::Chrome, tine));
    let knife = right.inset(right.width() * 0.3, 0.0, 0.0);
    builder.cuboid(Slot::Chrome, knife.slab(Side::Front, length * 0.42).inset(knife.width() * 0.2, 0.0, 0.0));
    builder
        .cuboid(Slot::Chrome, knife.without(Side::Front, length * 0.42 - SINK).inset(0.0, thick * 0.1, 0.0));
}

/// A bowl, with fruit where the look says so: round; on a foot; a pan with a rolled rim; a cone with a lip.
pub(in super::super) static BOWL: Recipe = Recipe::accessory("bowl", [0.22, 0.22, 0.09]).every_set(bowl);

fn bowl(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let has_fruit = sampler.chance(0.6);
    let dish = if has_fruit { bay.without(Side::Above, bay.height() * 0.25) } else { bay };
    let slot = sampler.pick(&[Slot::Ceramic, Slot::Wood, Slot::Glass]);
    let profile: Profile = match draft.set() {
        GeometrySet::Plain => {
            &[(0.0, 0.45), (0.1, 0.45), (0.5, 0.85), (1.0, 1.0), (1.0, 0.95), (0.5, 0.8), (0.14, 0.4)]
        }
        GeometrySet::Traditional => {
            &[(0.0, 0.5), (0.08, 0.46), (0.24, 0.24), (0.42, 0.6), (1.0, 1.0), (1.0, 0.95), (0.44, 0.5)]
        }
        GeometrySet::Industrial => {
            &[(0.0, 0.8), (0.06, 0.86), (0.84, 0.93), (0.86, 1.0), (1.0, 1.0), (1.0, 0.91), (0.1, 0.8)]
        }
        GeometrySet::Budget => &[(0.0, 0.5), (0.88, 0.9), (0.88, 1.0), (1.0, 1.0), (1.0, 0.9), (0.08, 0.46)],
    };
    builder.add(slot, turned(dish, profile));
    if has_fruit {
        let floor = dish.low.y + dish.height() * profile[profile.len() - 1].0;
        fruit(builder, dish, floor);
    }
}

/// Three pieces of fruit in a bowl whose inside begins at a height.
fn fruit(builder: &mut Builder, dish: Bay, floor: f64) {
    let top = builder.bay().high.y;
    let radius = (dish.width().min(dish.depth()) * 0.19).min((top - floor) / 2.0);
    let places = [(0.42, 0.0), (-0.3, 0.4), (-0.25, -0.42)];
    for (index, (x, z)) in places.into_iter().enumerate() {
        let y = top - radius * if index == 0 { 1.0 } else { 1.25 };
        let round = [(0.0, -1.0), (0.75, -0.65), (1.0, 0.0), (0.75, 0.65), (0.0, 1.0)];
        let fruit = lathe(&round.map(|(share, rise)| (share * radius, rise * radius)), 6);
        let slot = [Slot::FabricAccent, Slot::Leaf, Slot::Book][index];
        builder.add(slot, fruit.moved(x * dish.width() / 2.0, y, z * dish.depth() / 2.0));
    }
}
