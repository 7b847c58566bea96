//! Lamps that stand on floors and tables.

use glam::DVec3;

use super::lights::{SIDES, bulb, cage, globe, pleated, shade};
use crate::recipes::kit::{Bay, Builder, SINK, Solid, cylinder, lathe, sweep};
use crate::recipes::{Draft, Recipe, Slot, Symbol};

/// Where the shade of a standing lamp begins and what it stands on.
struct Stand {
    /// Radius of the box.
    radius: f64,
    /// Underside of the shade.
    low: f64,
    /// Top of the box.
    top: f64,
    /// Radius of the rod.
    rod: f64,
}

/// A lamp that stands on the floor: a rod or three legs under a drum, a turned post under pleats, pipe fittings with a
/// cage, or a thin rod with a plastic dish. Usual ones are 1.5-1.7 m high with a shade of 0.4 m.
pub(super) static FLOOR_LAMP: Recipe = Recipe::furniture("floor_lamp", [0.4, 0.4, 1.6])
    .round()
    .symbol(Symbol::Lamp)
    .plain(on_disc_or_legs)
    .traditional(on_turned_post)
    .industrial(on_pipe)
    .budget(on_thin_rod);

/// The measures of a floor lamp.
fn floor_stand(bay: Bay) -> Stand {
    let radius = bay.width().min(bay.depth()) / 2.0;
    let tall = (radius * 1.4).min(bay.height() * 0.3);
    Stand { radius, low: bay.high.y - tall, top: bay.high.y, rod: 0.011 }
}

fn on_disc_or_legs(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (floor_stand(builder.bay()), draft.form());
    let slot = [Slot::MetalDark, Slot::Wood, Slot::Brass, Slot::WoodLight][look];
    if look.is_multiple_of(2) {
        disc_foot(builder, slot, &stand);
    } else {
        tripod(builder, slot, &stand);
    }
    let narrow = [0.95, 0.8, 0.7, 0.95][look];
    let radii = [stand.radius, stand.radius * narrow];
    cloth_head(builder, &stand, shade(radii, [stand.low, stand.top]));
}

fn on_turned_post(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (floor_stand(builder.bay()), draft.form());
    turned_post(builder, [Slot::Brass, Slot::WoodDark, Slot::Wood, Slot::Brass][look], &stand);
    let radii = [stand.radius, stand.radius * [0.5, 0.62, 0.4, 0.55][look]];
    cloth_head(builder, &stand, pleated(radii, [stand.low, stand.top], 24));
}

fn on_pipe(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (floor_stand(builder.bay()), draft.form());
    let tall = (stand.radius * 1.4).min(builder.bay().height() * 0.3);
    pipe_stand(builder, &stand);
    if look.is_multiple_of(2) {
        let mut head = builder.empty();
        cage(&mut head, Slot::MetalDark, stand.radius, [0.0, tall], 4);
        place_upside_down(builder, head, stand.top);
        bulb(builder, DVec3::new(0.0, stand.low + tall * 0.55, 0.0), 0.04, -1.0);
    } else {
        reflector(builder, [Slot::Metal, Slot::MetalDark][look / 2], &stand);
    }
}

fn on_thin_rod(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (floor_stand(builder.bay()), draft.form());
    disc_foot(builder, [Slot::MetalDark, Slot::Metal, Slot::Painted, Slot::Plastic][look], &stand);
    if look.is_multiple_of(2) {
        uplighter(builder, &stand);
    } else {
        cloth_head(builder, &stand, shade([stand.radius, stand.radius * 0.45], [stand.low, stand.top]));
    }
}

/// A shade with its bulb and the fitting that carries it.
fn cloth_head(builder: &mut Builder, stand: &Stand, shade: Solid) {
    builder.add(Slot::Shade, shade);
    let tall = stand.top - stand.low;
    let radius = (stand.radius * 0.3).min(0.035).min(tall * 0.16);
    let middle = stand.low + tall * 0.5;
    bulb(builder, DVec3::new(0.0, middle, 0.0), radius, -1.0);
    builder
        .add(Slot::MetalDark, cylinder(stand.rod * 0.7, [stand.low - tall * 0.3, middle - radius * 2.0], 6));
}

fn disc_foot(builder: &mut Builder, slot: Slot, stand: &Stand) {
    let foot = stand.radius * 0.72;
    let lift = stand.low * 0.03;
    builder.add(
        slot,
        lathe(&[(foot, 0.0), (foot, lift * 0.4), (foot * 0.3, lift * 0.7), (stand.rod, lift)], 10),
    );
    builder.add(slot, cylinder(stand.rod, [lift * 0.8, stand.low], 6));
}

fn tripod(builder: &mut Builder, slot: Slot, stand: &Stand) {
    let knot = stand.low * 0.93;
    builder.add(Slot::MetalDark, cylinder(stand.radius * 0.16, [knot - stand.low * 0.04, stand.low], 8));
    for leg in 0..3 {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * (f64::from(leg) / 3.0 + 0.25));
        let at = |share: f64, y: f64| DVec3::new(cosine, 0.0, sine) * stand.radius * share + DVec3::Y * y;
        builder.add(slot, sweep(&[at(0.92, 0.0), at(0.08, knot)], stand.radius * 0.07, 6));
    }
}

/// A post turned on a lathe.
fn turned_post(builder: &mut Builder, slot: Slot, stand: &Stand) {
    let (wide, high) = (stand.radius, stand.low);
    let profile = [
        (wide * 0.66, 0.0),
        (wide * 0.66, high * 0.02),
        (wide * 0.5, high * 0.035),
        (wide * 0.16, high * 0.06),
        (wide * 0.09, high * 0.1),
        (wide * 0.15, high * 0.36),
        (wide * 0.09, high * 0.4),
        (wide * 0.2, high * 0.46),
        (wide * 0.09, high * 0.52),
        (wide * 0.12, high * 0.86),
        (wide * 0.06, high * 0.9),
        (wide * 0.06, high),
    ];
    builder.add(slot, lathe(&profile, 8));
}

/// Pipes with sleeves on a flange.
fn pipe_stand(builder: &mut Builder, stand: &Stand) {
    let rod = stand.rod * 1.4;
    let flange = stand.radius * 0.66;
    builder.add(
        Slot::MetalDark,
        lathe(&[(flange, 0.0), (flange, stand.low * 0.02), (rod * 1.8, stand.low * 0.03)], 8),
    );
    builder.add(Slot::MetalDark, cylinder(rod, [stand.low * 0.02, stand.low], 6));
    for share in [0.05, 0.88] {
        builder.add(Slot::Metal, cylinder(rod * 1.5, [stand.low * share, stand.low * (share + 0.05)], 6));
    }
}

/// A dome of sheet metal over a bulb, open below.
fn reflector(builder: &mut Builder, slot: Slot, stand: &Stand) {
    let (wide, tall) = (stand.radius, stand.top - stand.low);
    let at = |share: f64| stand.low + tall * share;
    let profile = [
        (wide * 0.3, at(0.86)),
        (wide * 0.76, at(0.6)),
        (wide * 0.96, at(0.12)),
        (wide, at(0.1)),
        (wide * 0.8, at(0.62)),
        (wide * 0.34, at(0.92)),
        (wide * 0.2, at(1.0)),
    ];
    builder.add(slot, lathe(&profile, if wide < 0.15 { 8 } else { SIDES }));
    bulb(builder, DVec3::new(0.0, at(0.5), 0.0), (wide * 0.3).min(0.035), -1.0);
    builder.add(Slot::MetalDark, cylinder(stand.rod, [stand.low - tall * 0.1, at(0.34)], 6));
}

/// A dish that shines at the ceiling.
fn uplighter(builder: &mut Builder, stand: &Stand) {
    let (wide, tall) = (stand.radius, stand.top - stand.low);
    let at = |share: f64| stand.low + tall * share;
    let dish = [
        (wide * 0.12, at(0.3)),
        (wide * 0.55, at(0.5)),
        (wide, at(1.0)),
        (wide * 0.96, at(1.0)),
        (wide * 0.5, at(0.56)),
        (wide * 0.1, at(0.4)),
    ];
    builder.add(Slot::Plastic, lathe(&dish, SIDES));
    builder.add(
        Slot::Lamp,
        lathe(&[(wide * 0.1, at(0.45)), (wide * 0.62, at(0.72)), (wide * 0.3, at(0.82))], 10),
    );
    builder.add(Slot::MetalDark, cylinder(stand.rod * 0.8, [stand.low - SINK, at(0.34)], 6));
}

fn place_upside_down(builder: &mut Builder, head: Builder, top: f64) {
    for (slot, solid) in head.into_parts() {
        builder.add(slot, solid.turned_z(std::f64::consts::PI).moved(0.0, top, 0.0));
    }
}

/// A lamp for a bedside or side table: a body under a shade.
pub(super) static TABLE_LAMP: Recipe = Recipe::accessory("table_lamp", [0.2, 0.2, 0.4])
    .round()
    .plain(vessel_or_globe)
    .traditional(pleated_on_vessel)
    .industrial(pipe_on_table)
    .budget(thin_rod_on_table);

/// The measures of a table lamp.
fn table_stand(bay: Bay) -> Stand {
    let (radius, height) = (bay.width().min(bay.depth()) / 2.0, bay.height());
    Stand { radius, low: height * 0.52, top: height, rod: radius * 0.07 }
}

/// A vessel under a shade, or a globe on a puck of wood.
fn vessel_or_globe(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (table_stand(builder.bay()), draft.form());
    let (radius, height) = (stand.radius, stand.top);
    if look == 1 {
        let puck = [(radius * 0.6, 0.0), (radius * 0.62, height * 0.1), (radius * 0.4, height * 0.16)];
        builder.add(Slot::Wood, lathe(&puck, SIDES));
        builder.add(Slot::Lamp, globe(height - radius * 0.98, radius, [-0.92, 1.0], SIDES));
        builder.add(Slot::Brass, cylinder(radius * 0.3, [height * 0.1, height - radius * 1.85], 8));
    } else {
        let slot = [Slot::Ceramic, Slot::Wood, Slot::MetalDark, Slot::PaintedAccent][look];
        vessel(builder, slot, &stand, [[0.55, 0.55], [0.5, 0.5], [0.3, 0.9], [0.75, 0.35]][look]);
        let radii = [radius, radius * [0.92, 0.8, 0.75, 0.92][look]];
        cloth_head(builder, &stand, shade(radii, [stand.low, stand.top]));
    }
    flex(builder, radius);
}

fn pleated_on_vessel(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (table_stand(builder.bay()), draft.form());
    let slot = [Slot::Brass, Slot::WoodDark, Slot::Ceramic, Slot::Brass][look];
    vessel(builder, slot, &stand, [[0.66, 0.16], [0.5, 0.34], [0.5, 0.7], [0.3, 0.6]][look]);
    let radii = [stand.radius, stand.radius * [0.45, 0.6, 0.5, 0.35][look]];
    cloth_head(builder, &stand, pleated(radii, [stand.low, stand.top], 14));
}

fn pipe_on_table(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (table_stand(builder.bay()), draft.form());
    let (radius, height) = (stand.radius, stand.top);
    pipe_stand(builder, &Stand { rod: radius * 0.09, ..stand });
    if look.is_multiple_of(2) {
        let mut head = builder.empty();
        cage(&mut head, Slot::MetalDark, radius, [0.0, height * 0.48], 3);
        place_upside_down(builder, head, height);
        bulb(builder, DVec3::new(0.0, height * 0.78, 0.0), radius * 0.36, -1.0);
    } else {
        reflector(builder, [Slot::Metal, Slot::PaintedAccent][look / 2], &stand);
    }
}

fn thin_rod_on_table(draft: &Draft, builder: &mut Builder) {
    let (stand, look) = (table_stand(builder.bay()), draft.form());
    disc_foot(builder, [Slot::Plastic, Slot::Painted, Slot::PlasticDark, Slot::Metal][look], &stand);
    if look.is_multiple_of(2) {
        let radii = [stand.radius, stand.radius * 0.55];
        cloth_head(builder, &stand, shade(radii, [stand.low, stand.top]));
    } else {
        builder.add(Slot::Lamp, globe(stand.top - stand.radius * 0.98, stand.radius, [-0.92, 1.0], SIDES));
    }
    flex(builder, stand.radius);
}

/// A body between two widths, below and above, as shares of the radius.
fn vessel(builder: &mut Builder, slot: Slot, stand: &Stand, [low, high]: [f64; 2]) {
    let (wide, tall) = (stand.radius, stand.low);
    let profile = [
        (wide * low * 0.9, 0.0),
        (wide * low, tall * 0.05),
        (wide * (low + high) * 0.55, tall * 0.4),
        (wide * high * 0.8, tall * 0.72),
        (wide * 0.14, tall * 0.82),
        (wide * 0.12, tall * 0.95),
    ];
    builder.add(slot, lathe(&profile, 8));
}

/// A bit of cable behind the foot.
fn flex(builder: &mut Builder, radius: f64) {
    let thick = radius * 0.025;
    let at = |x: f64, z: f64| DVec3::new(x * radius, thick, -z * radius);
    builder.add(Slot::PlasticDark, sweep(&[at(0.0, 0.4), at(0.1, 0.75), at(0.35, 0.88)], thick, 3));
}

/// Where the box is low, a table lamp stretched to it.
pub(super) fn squat(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let radius = bay.width() / 2.0;
    let stretch = DVec3::new(1.0, 1.0, bay.depth() / bay.width());
    let stand = Stand { radius, low: bay.height() * 0.52, top: bay.height(), rod: radius * 0.07 };
    let mut round = builder.empty();
    turned_post(&mut round, if draft.is_traditional() { Slot::Brass } else { Slot::Ceramic }, &stand);
    cloth_head(&mut round, &stand, shade([radius, radius * 0.7], [stand.low, stand.top]));
    round.into_parts().for_each(|(slot, solid)| builder.add(slot, solid.stretched(stretch)));
}
