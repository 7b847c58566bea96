//! What a scene shows beyond rooms and furniture.

/// What a scene shows beyond rooms and furniture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneOptions {
    /// Whether lamps give light; default yes.
    pub has_lights: bool,
    /// Degrees by which leaves on hinges stand open, but no further than the plan lets them; default as far as that.
    pub door_angle: Option<u16>,
    /// Whether every palette of the catalogue is a material variant of the level; default no.
    pub has_variants: bool,
}

impl Default for SceneOptions {
    fn default() -> Self {
        Self { has_lights: true, door_angle: None, has_variants: false }
    }
}
