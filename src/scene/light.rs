//! The light of lamps in the units of `KHR_lights_punctual`.

use std::f64::consts::PI;

use glam::{DMat3, DVec3, Quat, Vec3};

use super::node::{Node, SceneLight};
use crate::catalog::{Light, LightSide, Size};
use crate::contract::{Extras, LightExtras, ObjectId, owned_name};

/// Metres between a lamp's box and where its light begins.
const OUTSIDE: f64 = 0.02;

/// The light of a class.
pub(crate) fn scene_light(light: &Light) -> SceneLight {
    SceneLight {
        name: format!("{} lm, {} K", light.lumens, light.kelvin),
        color: color_of(light.kelvin).as_vec3().to_array(),
        intensity: (light.lumens / (4.0 * PI)) as f32,
    }
}

/// The owner of a light.
#[derive(Clone, Copy)]
pub(crate) struct Owner<'a> {
    /// The lamp.
    pub(crate) id: &'a ObjectId,
    /// Id of its room.
    pub(crate) room: &'a str,
}

/// The node of a lamp's light, a child of the lamp's node: `light.<id>@<room>`. Its extras say the light; `index` is that
/// of the light in the scene, where viewers are to draw it.
pub(crate) fn light_node(light: &Light, size: Size, owner: Owner<'_>, index: Option<usize>) -> Node {
    let place = match light.from {
        LightSide::Below => DVec3::new(0.0, -OUTSIDE, 0.0),
        LightSide::Above => DVec3::new(0.0, size.height + OUTSIDE, 0.0),
        LightSide::Front => DVec3::new(0.0, size.height / 2.0, size.depth / 2.0 + OUTSIDE),
    };
    Node {
        name: owned_name(&format_args!("light.{}", owner.id), owner.room),
        translation: Vec3::new(place.x as f32, place.y as f32, place.z as f32),
        rotation: Quat::IDENTITY,
        mesh: None,
        light: index,
        extras: Some(Extras::Light(LightExtras { lumens: light.lumens, kelvin: light.kelvin })),
        children: Vec::new(),
    }
}

/// Linear sRGB of a black body, the strongest channel 1.
///
/// Chromaticity after B. Kang et al., "Design of Advanced Color Temperature Control System for HDTV Applications",
/// 2002, for 1667 to 25000 K; primaries of IEC 61966-2-1. Colours outside of sRGB are clipped.
fn color_of(kelvin: f64) -> DVec3 {
    let t = 1000.0 / kelvin;
    let x = if kelvin <= 4000.0 {
        -0.266_123_9 * t * t * t - 0.234_358_9 * t * t + 0.877_695_6 * t + 0.179_910
    } else {
        -3.025_846_9 * t * t * t + 2.107_037_9 * t * t + 0.222_634_7 * t + 0.240_390
    };
    let y = if kelvin <= 2222.0 {
        -1.106_381_4 * x * x * x - 1.348_110_20 * x * x + 2.185_558_32 * x - 0.202_196_83
    } else if kelvin <= 4000.0 {
        -0.954_947_6 * x * x * x - 1.374_185_93 * x * x + 2.091_370_15 * x - 0.167_488_67
    } else {
        3.081_758_0 * x * x * x - 5.873_386_70 * x * x + 3.751_129_97 * x - 0.370_014_83
    };
    let tristimulus = DVec3::new(x / y, 1.0, (1.0 - x - y) / y);
    let to_linear = DMat3::from_cols(
        DVec3::new(3.240_625_5, -0.968_930_7, 0.055_710_1),
        DVec3::new(-1.537_208, 1.875_756_1, -0.204_021_1),
        DVec3::new(-0.498_628_6, 0.041_517_5, 1.056_995_9),
    );
    let linear = (to_linear * tristimulus).max(DVec3::ZERO);
    linear / linear.max_element()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn daylight_is_white_and_bulbs_are_warm() {
        let [white, warm] = [color_of(6500.0), color_of(2700.0)];
        assert!(white.min_element() > 0.93, "{white}");
        assert!(warm.x == 1.0 && (0.3..0.6).contains(&warm.y) && (0.03..0.2).contains(&warm.z), "{warm}");
    }

    #[test]
    fn the_colour_changes_without_a_jump() {
        for kelvin in [2222.0, 4000.0] {
            assert!(color_of(kelvin - 1.0).distance(color_of(kelvin + 1.0)) < 0.01, "{kelvin}");
        }
    }

    #[test]
    fn a_bulb_spreads_its_lumens_over_the_sphere_and_shines_out_of_its_box() {
        let light = Light { lumens: 800.0, kelvin: 2700.0, from: LightSide::Above };
        assert!((scene_light(&light).intensity - 63.66).abs() < 0.01);
        let size = Size { width: 0.2, depth: 0.2, height: 0.4 };
        let node = light_node(&light, size, Owner { id: &ObjectId::new("table_lamp", 1), room: "12" }, None);
        assert_eq!(node.name, "light.table_lamp.1@12");
        assert!(node.translation.y > 0.4);
    }
}
