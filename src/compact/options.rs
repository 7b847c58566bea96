//! Options of compact files.

use serde::Serialize;

/// What a compact file shows, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CompactOptions {
    /// Where colours come from.
    pub(crate) coloring: Coloring,
    /// Metres: what has no longer side is left out.
    pub(crate) least_size: f64,
    /// How far shapes are simplified beyond that.
    pub(crate) shapes: Shapes,
    /// Metres of the coarsest step of merged positions; levels too large for it have whole numbers no more.
    pub(crate) coarsest_step: f64,
    /// Whether equal models are instances.
    pub(crate) instancing: Instancing,
    /// Draw calls up to which equal models become instances, which makes files smaller; beyond, they are merged.
    pub(crate) most_draws: usize,
    /// Whether surfaces have normal maps.
    pub(crate) has_normal_maps: bool,
    /// Whether all nodes of the scene are there with their extras, though without meshes, so that programs which read levels back
    /// find what they look for.
    pub(crate) keeps_nodes: bool,
}

/// How far shapes are simplified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shapes {
    /// Not at all.
    Kept,
    /// To what is seen through windows.
    Coarse(Coarse),
}

/// How shapes are simplified to what is seen through windows: loose parts of meshes that are thinner than a width, and so no more than
/// a line, are left out, and so are faces that lie on something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coarse {
    /// Metres of the thinnest parts.
    pub(crate) least_width: f64,
    /// Metres: loose parts of furniture and doors that have no longer side are boxes.
    pub(crate) boxed: f64,
    /// Metres: loose parts of furniture and doors whose surface is nowhere farther below the faces of their box are boxes.
    pub(crate) rounding: f64,
    /// Metres: boxes that are no thicker have no narrow faces.
    pub(crate) sheet: f64,
    /// Whether what lies along the edges of walls and openings is shown; where it is not, leaves of doors are boxes.
    pub(crate) has_trim: bool,
}

/// Where colours come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Coloring {
    /// The materials of the scene.
    Materials,
    /// Each corner has the base colour of its material: one primitive for all that is opaque, one for all that is not.
    Corners,
}

/// Whether equal models are instances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub enum Instancing {
    /// By `EXT_mesh_gpu_instancing`.
    #[default]
    Gpu,
    /// All triangles are merged, for clients that do not know that extension.
    None,
}
