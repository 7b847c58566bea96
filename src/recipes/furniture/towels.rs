//! Towels, folded or rolled, and the rails on walls that they hang on.

use glam::DVec3;

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a towel's border and of its distance from the hem.
const BORDER: [f64; 2] = [0.02, 0.03];
/// Metres of a bar's radius, and of the plates on the wall that carry pipes.
const BAR: f64 = 0.009;
const FLANGE: f64 = 0.024;
/// Metres of a flat bar's width and thickness.
const FLAT: [f64; 2] = [0.03, 0.007];

/// A rail on a wall with a towel over it; a ladder of rails where it is high: round bars, bars between posts with knobs,
/// one pipe back and forth, or flat bars with hooks.
pub(super) static TOWEL_RAIL: Recipe = Recipe::accessory("towel_rail", [0.5, 0.1, 0.8]).every_set(towel_rail);

fn towel_rail(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let rows = (bay.height() / 0.18).round().clamp(1.0, 8.0) as u32;
    let rail = Rail {
        bay,
        radius: BAR.min(bay.depth() * 0.15),
        z: bay.high.z - bay.depth() * 0.3,
        rows: if rows > 3 { rows } else { 1 },
    };
    let top = match draft.set() {
        GeometrySet::Plain => rail.bars(builder),
        GeometrySet::Traditional => rail.posts(builder),
        GeometrySet::Industrial => rail.pipe(builder),
        GeometrySet::Budget => rail.flats(builder),
    };
    let drop = if rail.rows > 1 { bay.height() * 0.4 } else { top };
    let width = (bay.width() * 0.55).min(0.5);
    let x = draft.sampler().between(-0.3, 0.3) * (bay.width() - width) * 0.5;
    let towel = Bay::new(
        [x - width / 2.0, x + width / 2.0],
        [top - drop, top],
        [rail.z - bay.depth() * 0.2, bay.high.z],
    );
    let [slot, border] = towel_slots(draft);
    builder.block(slot, towel, bay.depth() * 0.2);
    let low = towel.low.y + (drop * 0.1).min(0.06);
    let strip = towel.inset(-0.0006, 0.0, -0.0006).with_y([low, low + (drop * 0.06).min(0.03)]);
    builder.cuboid(border, strip);
}

/// A rail before it is built; each form gives the height over the bar that carries the towel.
struct Rail {
    bay: Bay,
    radius: f64,
    /// Where the bars lie.
    z: f64,
    rows: u32,
}

impl Rail {
    /// Height of the top of a towel over the bar at a height.
    fn over(&self, y: f64) -> f64 {
        if self.rows > 1 { y + self.radius * 2.0 } else { self.bay.high.y }
    }

    fn bar(&self, y: f64, [left, right]: [f64; 2], radius: f64) -> crate::recipes::kit::Solid {
        sweep(&[DVec3::new(left, y, self.z), DVec3::new(right, y, self.z)], radius, 6)
    }

    /// Round bars between two posts, or one bent to the wall at both ends.
    fn bars(&self, builder: &mut Builder) -> f64 {
        let (bay, radius, z) = (self.bay, self.radius, self.z);
        let ends = [bay.low.x + radius, bay.high.x - radius];
        if self.rows == 1 {
            let y = bay.high.y - bay.height() * 0.12;
            let back = bay.low.z;
            let path = [(ends[0], back), (ends[0], z), (ends[1], z), (ends[1], back)];
            builder.add(Slot::Chrome, sweep(&path.map(|(x, z)| DVec3::new(x, y, z)), radius, 6));
            return self.over(y);
        }
        for x in ends {
            builder.add(Slot::Chrome, cylinder(radius, bay.y(), 8).moved(x, 0.0, z));
            let foot = bay.high.y * 0.85;
            let bracket =
                Bay::new([x - radius * 0.6, x + radius * 0.6], [foot, foot + radius], [bay.low.z, z]);
            builder.cuboid(Slot::Chrome, bracket);
        }
        let rows = bay.inset(0.0, 0.03, 0.0).rows(self.rows, 0.0);
        for row in &rows {
            builder.add(Slot::Chrome, self.bar(row.center().y, ends, radius * 0.75));
        }
        self.over(rows[rows.len() - 2].center().y)
    }

    /// Three bars between posts with knobs, held by rosettes.
    fn posts(&self, builder: &mut Builder) -> f64 {
        let (bay, radius) = (self.bay, self.radius);
        let (knob, high) = (radius * 1.9, bay.high.y);
        let heights: &[f64] = if self.rows > 1 { &[0.2, 0.55, 0.9] } else { &[0.85] };
        let ends = [bay.low.x + knob, bay.high.x - knob];
        for x in ends {
            let first = if self.rows > 1 { 0.0 } else { high * 0.7 };
            let profile = [
                (0.0, first),
                (knob, first + knob),
                (radius, first + knob * 1.8),
                (radius, high - knob * 1.8),
                (knob, high - knob),
                (0.0, high),
            ];
            // Where it is low, the post is a knob alone.
            let is_long = high - first > knob * 4.0;
            let knob_alone = [profile[0], profile[1], (knob, high - knob), profile[5]];
            let turned = if is_long { lathe(&profile, 8) } else { lathe(&knob_alone, 8) };
            builder.add(Slot::Brass, turned.moved(x, 0.0, self.z));
            let rosette = knob;
            let reach = self.z - bay.low.z;
            let stem = [(rosette, 0.0), (radius * 0.8, reach * 0.3), (radius * 0.8, reach)];
            let y = high * heights[heights.len() - 1];
            builder.add(Slot::Brass, turned_forward(lathe(&stem, 5)).moved(x, y, bay.low.z));
        }
        for &rise in heights {
            builder.add(Slot::Brass, self.bar(high * rise, ends, radius));
        }
        self.over(high * heights[heights.len() - 1])
    }

    /// A pipe back and forth from one flange on the wall to another.
    fn pipe(&self, builder: &mut Builder) -> f64 {
        let (bay, z) = (self.bay, self.z);
        let radius = self.radius * 1.2;
        let flange = FLANGE.min(bay.height() * 0.1).max(radius * 1.5);
        let runs = self.rows.min(5);
        // An even number of runs ends where it began.
        let far = if runs.is_multiple_of(2) { radius } else { flange };
        let x = [bay.low.x + flange, bay.high.x - far];
        let pitch = (bay.height() - flange * 2.0) / f64::from(runs.max(2) - 1);
        let top = bay.high.y - flange;
        let mut path = vec![DVec3::new(x[0], top, bay.low.z)];
        for run in 0..runs {
            let y = top - f64::from(run) * pitch;
            let from = run as usize % 2;
            path.extend([DVec3::new(x[from], y, z), DVec3::new(x[1 - from], y, z)]);
        }
        let last = path[path.len() - 1];
        path.push(DVec3::new(last.x, last.y, bay.low.z));
        for end in [path[0], path[path.len() - 1]] {
            let plate = turned_forward(cylinder(flange, [0.0, 0.008], 8));
            builder.add(Slot::MetalDark, plate.moved(end.x, end.y, bay.low.z));
        }
        // The pipe begins inside its plates.
        let ends = path.len() - 1;
        path[0].z += 0.003;
        path[ends].z += 0.003;
        builder.add(Slot::MetalDark, sweep(&path, radius, 6));
        self.over(top - if runs > 1 { pitch } else { 0.0 })
    }

    /// Three flat bars on flat posts, the lowest with hooks.
    fn flats(&self, builder: &mut Builder) -> f64 {
        let (bay, z, [wide, thick]) = (self.bay, self.z, FLAT);
        let heights: &[f64] = if self.rows > 1 { &[0.14, 0.5, 0.86] } else { &[0.85] };
        for side in [Side::Left, Side::Right] {
            let post = bay.slab(side, wide);
            let y = if self.rows > 1 { bay.y() } else { [bay.high.y * 0.7, bay.high.y] };
            builder.cuboid(Slot::Metal, post.with_y(y).with_z([z - thick * 1.5, z - thick * 0.5 + SINK]));
            let middle = bay.high.y * heights[heights.len() - 1];
            let bracket = post.inset(wide * 0.25, 0.0, 0.0).with_y([middle - 0.01, middle + 0.01]);
            builder.cuboid(Slot::Metal, bracket.with_z([bay.low.z, z - thick]));
        }
        let high = (wide * 1.3).min(bay.height() * 0.2);
        for &rise in heights {
            let y = bay.high.y * rise;
            let slat = bay.inset(0.004, 0.0, 0.0).with_y([y - high / 2.0, y + high / 2.0]);
            builder.cuboid(Slot::Metal, slat.with_z([z - thick / 2.0, z + thick / 2.0]));
        }
        if self.rows > 1 {
            let y = bay.high.y * heights[0];
            for hook in bay.inset(bay.width() * 0.2, 0.0, 0.0).columns(3, bay.width() * 0.26) {
                let tongue = hook.with_z([z, z + bay.depth() * 0.25]);
                builder.cuboid(Slot::Plastic, tongue.with_y([y - high * 0.3, y + high * 0.1]));
            }
        }
        self.over(bay.high.y * heights[heights.len() - 1] + high / 2.0 - self.radius)
    }
}

/// Materials of a towel and of its border, which differ so that both show on white.
fn towel_slots(draft: &Draft) -> [Slot; 2] {
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => [
            [Slot::FabricAccent, Slot::Linen],
            [Slot::Fabric, Slot::Linen],
            [Slot::Linen, Slot::FabricAccent],
            [Slot::Leaf, Slot::Linen],
        ][form],
        GeometrySet::Traditional => [
            [Slot::Linen, Slot::FabricAccent],
            [Slot::Book, Slot::Brass],
            [Slot::FabricLight, Slot::Leather],
            [Slot::Fabric, Slot::Linen],
        ][form],
        GeometrySet::Industrial => [
            [Slot::Fabric, Slot::MetalDark],
            [Slot::Leather, Slot::Linen],
            [Slot::Concrete, Slot::Leather],
            [Slot::FabricAccent, Slot::Linen],
        ][form],
        GeometrySet::Budget => [
            [Slot::FabricAccent, Slot::Plastic],
            [Slot::Leaf, Slot::Paper],
            [Slot::Book, Slot::Paper],
            [Slot::Paper, Slot::FabricAccent],
        ][form],
    }
}

/// A towel: folded in layers, folded with a small one on it, rolled, or folded loosely.
pub(super) static TOWEL: Recipe = Recipe::accessory("towel", [0.4, 0.3, 0.08])
    .plain(layers)
    .traditional(with_small_one)
    .industrial(|draft, builder| rolls(builder, builder.bay(), towel_slots(draft)))
    .budget(loosely_folded);

/// Layers, each folded like the others; the second has the colour of the border.
fn layers(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let [slot, border] = towel_slots(draft);
    let count = ((bay.height() / 0.03).round() as u32).clamp(1, 3);
    for (index, layer) in bay.rows(count, -0.001).into_iter().enumerate() {
        let back = if index % 2 == 0 { 0.0 } else { bay.width() * 0.015 };
        let (slot, radius) = (if index == 1 { border } else { slot }, layer.height() * 0.4);
        if index + 1 < count as usize {
            builder.block(slot, layer.inset(back, 0.0, back), radius);
        } else {
            builder.cushion(slot, layer.inset(back, 0.0, back), radius);
        }
    }
}

/// Two layers with a small towel on them.
fn with_small_one(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let [slot, border] = towel_slots(draft);
    let small = bay.slab(Side::Above, bay.height() * 0.3);
    for layer in bay.without(Side::Above, small.height() - 0.001).rows(2, -0.001) {
        builder.block(slot, layer, layer.height() * 0.4);
    }
    let small = small.inset(bay.width() * 0.2, 0.0, bay.depth() * 0.1);
    builder.block(slot, small, small.height() * 0.4);
    bordered(builder, border, small);
}

/// Folded once, so that the upper half ends short of the lower one.
fn loosely_folded(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let [slot, border] = towel_slots(draft);
    let [low, high] = [Side::Below, Side::Above].map(|side| bay.slab(side, bay.height() * 0.5));
    builder.block(slot, low, low.height() * 0.4);
    let high = high.without(Side::Below, -0.001).without(Side::Front, bay.depth() * 0.2);
    builder.block(slot, high.inset(bay.width() * 0.015, 0.0, 0.0), high.height() * 0.4);
    bordered(builder, border, high.inset(bay.width() * 0.015, 0.0, 0.0));
}

/// A strip along the front of a folded towel, around its upper side and both ends.
fn bordered(builder: &mut Builder, slot: Slot, towel: Bay) {
    let [wide, from] = BORDER;
    let front = towel.high.z - from.min(towel.depth() * 0.3);
    let strip = towel.inset(-0.0006, 0.0, 0.0).with_z([front - wide.min(towel.depth() * 0.2), front]);
    builder.cuboid(slot, strip.without(Side::Below, towel.height() * 0.3).without(Side::Above, -0.0006));
}

/// Towels rolled up side by side, the end of the roll showing.
fn rolls(builder: &mut Builder, bay: Bay, [slot, border]: [Slot; 2]) {
    let count = (bay.width() / bay.height()).round().clamp(1.0, 4.0) as u32;
    for cell in bay.columns(count, 0.002) {
        let half = cell.extent() / 2.0;
        for (slot, share, reach) in [(slot, 1.0, half.z - 0.0012), (border, 0.4, half.z)] {
            let roll = turned_forward(cylinder(1.0, [-reach, reach], 10)).stretched(DVec3::new(
                half.x * share,
                half.y * share,
                1.0,
            ));
            let middle = cell.center();
            builder.add(slot, roll.moved(middle.x, middle.y, middle.z));
        }
    }
}
