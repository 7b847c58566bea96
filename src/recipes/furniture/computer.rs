//! Screens of computers, with what stands beside them: 24 inches at 16 to 9 are 0.54 by 0.32 m, 17 inches at 5 to 4 0.34
//! by 0.27; a small case is 0.1 by 0.3 m.

use glam::{DVec2, DVec3};

use super::screens::{Shell, body, display};
use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, lathe, loft, sweep};
use crate::recipes::{Draft, Recipe, Slot};

/// A computer's screen: a wide one on a stand; one of 5 to 4 between two loudspeakers; one in a steel case with handles on
/// a post; one of 5 to 4 beside the case of its computer.
pub(super) static COMPUTER: Recipe = Recipe::accessory("computer", [0.55, 0.2, 0.45])
    .plain(wide)
    .traditional(|draft, builder| with_speakers(builder, draft.input.look % 2))
    .industrial(|draft, builder| in_steel(builder, body(draft).slot))
    .budget(|draft, builder| with_case(builder, body(draft)));

/// A cable from behind a screen down to the table.
fn cable(builder: &mut Builder, x: f64, lift: f64, z: f64) {
    let back = builder.bay().low.z;
    let path = [
        DVec3::new(x + 0.03, lift + 0.06, z - 0.012),
        DVec3::new(x + 0.05, lift * 0.4, back + 0.012),
        DVec3::new(x + 0.12, 0.004, back + 0.004),
    ];
    builder.add(Slot::PlasticDark, sweep(&path, 0.0035, 4));
}

/// A monitor on a stand: a plate, a disc, a forked foot, or a computer with everything behind its screen.
fn wide(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let lift = bay.height() * [0.26, 0.3, 0.22, 0.28][look];
    let thick = (bay.depth() * 0.2).min(0.035);
    let z = bay.center().z;
    let shell = body(draft);
    let slot = shell.slot;
    let panel = bay.without(Side::Below, lift).with_z([z, z + thick]);
    display(builder, panel, shell);
    let metal = if slot == Slot::Metal || look % 2 == 1 { Slot::Metal } else { Slot::PlasticDark };
    if look == 2 {
        // A chin under the screen, with a badge.
        let chin = panel
            .slab(Side::Below, panel.height() * 0.14)
            .slab(Side::Front, 0.004 + SINK)
            .moved(0.0, 0.0, 0.0008);
        builder.cuboid(Slot::Metal, chin.inset(0.001, 0.001, 0.0));
    }
    let hump = panel.inset(panel.width() * 0.34, panel.height() * 0.3, 0.0).with_z([z - 0.016, z + SINK]);
    builder.cuboid(Slot::PlasticDark, hump);
    let foot = bay.width() * 0.22;
    wide_foot(builder, metal, look, z, foot);
    let neck = [
        (z - 0.034, 0.006),
        (z - 0.014, 0.006),
        (z - 0.006, lift + bay.height() * 0.25),
        (z - 0.022, lift + bay.height() * 0.3),
    ];
    let half = foot * if look == 1 { 0.12 } else { 0.25 };
    builder.add(metal, extrude(&neck.map(DVec2::from), Axis::X, [-half, half]));
    cable(builder, 0.0, lift, z);
    let light = DVec3::new(panel.high.x - 0.03, panel.low.y + 0.004, panel.high.z - 0.004);
    builder.cuboid(Slot::Lamp, Bay::around(light, 0.01, 0.004, 0.003));
}

/// What a wide monitor stands on: a plate, a disc, or two bars; its screen is at `z`, its foot `foot` metres to either
/// side.
fn wide_foot(builder: &mut Builder, metal: Slot, look: usize, z: f64, foot: f64) {
    let bay = builder.bay();
    match look {
        1 => {
            let radius = bay.depth() / 2.0;
            let disc = lathe(&[(radius, 0.0), (radius, 0.008), (radius * 0.85, 0.012)], 12);
            builder.add(metal, disc);
        }
        3 => {
            for side in [-1.0, 1.0] {
                let y = 0.008 + 0.0002 * side;
                let path = [DVec3::new(0.0, y, z - 0.02), DVec3::new(side * foot, y, bay.high.z - 0.004)];
                builder.add(metal, sweep(&path, 0.0098, 4));
            }
            builder.cuboid(metal, Bay::new([-0.02, 0.02], [0.0, 0.012], [bay.low.z, z + 0.01]));
            builder.cuboid(metal, Bay::around(DVec3::new(0.0, 0.006, bay.high.z - 0.01), 0.012, 0.011, 0.02));
        }
        _ => builder.block(metal, Bay::new([-foot, foot], [0.0, 0.01], bay.z()), 0.003),
    }
}

/// A screen with a broad border before a back that tapers.
fn deep_screen(builder: &mut Builder, panel: Bay, slot: Slot, border: f64) {
    builder.cuboid(slot, panel);
    let glass = panel.inset(border, border, 0.0).without(Side::Below, border * 0.5);
    builder.cuboid(Slot::Screen, glass.with_z([panel.high.z - SINK, panel.high.z + 0.001]));
    let (half, depth) = (panel.extent() / 2.0, panel.low.z - builder.bay().low.z);
    let slice = |back: f64, share: f64| Slice::new(back, half.x * share, half.y * share);
    let back = loft(&Outline::Square, &[slice(-SINK, 0.9), slice(depth * 0.62, 0.55)]);
    // What is built upwards looks to the back.
    let back = back.turned_x(-std::f64::consts::FRAC_PI_2);
    builder.add(slot, back.moved(panel.center().x, panel.center().y, panel.low.z));
}

/// A screen on a ball and a round foot; loudspeakers that lean back, with cloth before them.
fn with_speakers(builder: &mut Builder, look: u32) {
    let bay = builder.bay();
    let slot = [Slot::Plastic, Slot::PlasticDark][look as usize];
    let (width, height, z) = (bay.width(), bay.height(), bay.center().z);
    let lift = height * 0.28;
    let panel = bay.with_x([-0.33, 0.33].map(|x| x * width)).without(Side::Below, lift);
    deep_screen(builder, panel.with_z([z, z + bay.depth() * 0.16]), slot, width * 0.036);
    let radius = bay.depth() * 0.44;
    let foot = [
        (radius, 0.0),
        (radius * 0.9, height * 0.035),
        (radius * 0.3, height * 0.06),
        (radius * 0.3, lift * 1.1),
    ];
    builder.add(slot, lathe(&foot, 8).moved(0.0, 0.0, z - radius * 0.05));
    for side in [Side::Left, Side::Right] {
        let speaker = bay.slab(side, width * 0.15).slab(Side::Below, height * 0.5);
        let (low, deep) = (speaker.low.z + bay.depth() * 0.12, bay.high.z);
        let top = speaker.high.y;
        let lean = (top * 0.16).min((deep - low) * 0.6);
        let section = [(low, 0.0), (deep, 0.0), (deep - lean, top), (low, top)];
        builder.add(slot, extrude(&section.map(DVec2::from), Axis::X, speaker.x()));
        let cloth = |share: f64, out: f64| (deep - lean * share + out, top * share);
        let cloth = [cloth(0.3, -SINK), cloth(0.3, 0.003), cloth(0.95, 0.003), cloth(0.95, -SINK)];
        let x = speaker.inset(width * 0.012, 0.0, 0.0).x();
        builder.add(Slot::Fabric, extrude(&cloth.map(DVec2::from), Axis::X, x));
    }
    let knob =
        Bay::around(DVec3::new(bay.high.x - width * 0.075, height * 0.075, bay.high.z), 0.018, 0.018, 0.0);
    builder.cuboid(Slot::Metal, knob.with_z([bay.high.z - 0.03, bay.high.z - 0.002]));
    cable(builder, 0.0, lift, z);
}

/// A sealed case with fins behind and bars to carry it by at its sides, on a round post and a plate: as beside machines.
fn in_steel(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (width, height, z) = (bay.width(), bay.height(), bay.center().z);
    let lift = height * 0.24;
    let panel = bay.without(Side::Below, lift).inset(width * 0.075, 0.0, 0.0);
    let panel = panel.with_z([z - bay.depth() * 0.08, z + bay.depth() * 0.22]);
    builder.cuboid(slot, panel);
    let glass = panel.inset(width * 0.06, width * 0.05, 0.0);
    builder.cuboid(
        Slot::Rubber,
        glass.inset(-0.008, -0.008, 0.0).with_z([panel.high.z - SINK, panel.high.z + 0.004]),
    );
    builder.cuboid(Slot::Screen, glass.with_z([panel.high.z, panel.high.z + 0.005]));
    // One bow and its mirror image.
    let (inner, outer) = (panel.high.x - SINK, bay.high.x);
    let bar = width * 0.022;
    let [low, high] = [0.24, 0.8].map(|share| panel.low.y + share * panel.height());
    let bow = [
        (inner, low),
        (outer, low),
        (outer, high),
        (inner, high),
        (inner, high - bar),
        (outer - bar, high - bar),
        (outer - bar, low + bar),
        (inner, low + bar),
    ];
    let depth = [panel.center().z - bar * 0.6, panel.center().z + bar * 0.6];
    builder.add_pair(Slot::MetalDark, extrude(&bow.map(DVec2::from), Axis::Z, depth));
    let fins = panel.inset(panel.width() * 0.14, panel.height() * 0.12, 0.0);
    for fin in fins.columns(5, fins.width() * 0.17) {
        builder.cuboid(slot, fin.with_z([panel.low.z - bay.depth() * 0.08, panel.low.z + SINK]));
    }
    let post = z - bay.depth() * 0.3;
    let radius = bay.depth() * 0.09;
    builder.add(Slot::MetalDark, cylinder(radius, [0.008, height * 0.78], 8).moved(0.0, 0.0, post));
    let arm = Bay::new(
        [-0.05, 0.05].map(|x| x * width),
        [0.5, 0.66].map(|y| y * height),
        [post, panel.low.z + SINK],
    );
    builder.cuboid(Slot::MetalDark, arm);
    builder.cuboid(Slot::MetalDark, Bay::new([-0.24, 0.24].map(|x| x * width), [0.0, 0.012], bay.z()));
}

/// A screen on a plain foot, with the case of its computer upright to its right: drives, a button, slits for air.
fn with_case(builder: &mut Builder, shell: Shell) {
    let slot = shell.slot;
    let bay = builder.bay();
    let (width, height, z) = (bay.width(), bay.height(), bay.center().z);
    let lift = height * 0.22;
    let case = bay.slab(Side::Right, width * 0.19).slab(Side::Below, height * 0.74);
    let panel = bay.without(Side::Right, width * 0.24).without(Side::Below, lift);
    let panel = panel.with_z([z, z + bay.depth() * 0.2]);
    display(builder, panel, shell);
    let middle = panel.center().x;
    let hump = panel.inset(panel.width() * 0.24, panel.height() * 0.2, 0.0);
    builder.cuboid(Slot::PlasticDark, hump.with_z([z - bay.depth() * 0.14, z + SINK]));
    let foot = Bay::around(DVec3::new(middle, 0.0, z), panel.width() * 0.56, 0.0, bay.depth() * 0.8);
    builder.cuboid(slot, foot.with_y([0.0, 0.014]));
    let neck = Bay::around(DVec3::new(middle, 0.0, z - bay.depth() * 0.07), panel.width() * 0.2, 0.0, 0.03);
    builder.cuboid(slot, neck.with_y([0.0135, lift + panel.height() * 0.24]));
    builder.cuboid(slot, case);
    let front = |bay: Bay, out: f64| bay.with_z([case.high.z - SINK, case.high.z + out]);
    let face = case.inset(case.width() * 0.14, case.height() * 0.05, 0.0);
    for (place, high, dark) in
        [(0.82, 0.1, Slot::MetalDark), (0.66, 0.06, Slot::MetalDark), (0.06, 0.3, Slot::Rubber)]
    {
        let y = [place, place + high].map(|share| face.low.y + share * face.height());
        builder.cuboid(dark, front(face.with_y(y), 0.002));
    }
    let button = Bay::around(face.center(), face.width() * 0.3, face.width() * 0.3, 0.0);
    builder.cuboid(Slot::Metal, front(button, 0.004));
    cable(builder, middle, lift, z);
}
