//! Fits a user's model to the box of a class.

use glam::Vec3;

use super::problem::Problem;
use crate::geometry::Size;
use crate::mesh::Model;

/// How much more one axis may be stretched than another: a model whose proportions differ from the box by more would
/// look wrong, and is more likely turned or named wrongly.
const MOST_STRETCH: f64 = 1.25;
/// Metres below which a model has no extent to be scaled.
const THINNEST: f64 = 1e-5;

/// The model moved and scaled so that it fills a box, standing on its underside.
///
/// All three axes are filled, whatever small difference of proportions that takes: every later stage relies on
/// the model being as large as its class.
pub(super) fn fit(model: &Model, class: &str, size: Size) -> Result<Model, Problem> {
    let (low, high) = bounds(model);
    let extent = (high - low).as_dvec3();
    let wanted = glam::DVec3::new(size.width, size.height, size.depth);
    if extent.min_element() < THINNEST {
        return Err(Problem::new(format!("is flat: {}", in_metres(extent)))
            .with_hint("give it some thickness, so that it can be scaled to the class's box"));
    }
    let scale = wanted / extent;
    let stretch = scale.max_element() / scale.min_element();
    if stretch > MOST_STRETCH {
        return Err(misfit(extent, wanted, class, stretch));
    }
    let scale = scale.as_vec3();
    let base = Vec3::new((low.x + high.x) / 2.0, low.y, (low.z + high.z) / 2.0);
    let mut fitted = model.clone();
    for part in &mut fitted.primitives {
        for position in &mut part.positions {
            *position = ((Vec3::from(*position) - base) * scale).to_array();
        }
        for normal in &mut part.normals {
            *normal = (Vec3::from(*normal) / scale).normalize_or(Vec3::Y).to_array();
        }
    }
    Ok(fitted)
}

/// How large a model is.
pub(super) fn size(model: &Model) -> Size {
    let (low, high) = bounds(model);
    let extent = (high - low).as_dvec3();
    Size { width: extent.x, depth: extent.z, height: extent.y }
}

fn bounds(model: &Model) -> (Vec3, Vec3) {
    let used = model
        .primitives
        .iter()
        .flat_map(|part| part.indices.iter().map(|&index| part.positions[index as usize]));
    used.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), position| {
        (low.min(position.into()), high.max(position.into()))
    })
}

/// Width × depth × height.
fn in_metres(extent: glam::DVec3) -> String {
    format!("{:.3} × {:.3} × {:.3} m (width × depth × height)", extent.x, extent.z, extent.y)
}

fn misfit(extent: glam::DVec3, wanted: glam::DVec3, class: &str, stretch: f64) -> Problem {
    let percent = (stretch - 1.0) * 100.0;
    let message = format!(
        "has the proportions of {}, which the box of class \"{class}\", {}, would distort by {percent:.0} %",
        in_metres(extent),
        in_metres(wanted)
    );
    let turned = wanted / glam::DVec3::new(extent.z, extent.y, extent.x);
    let fits_turned = turned.max_element() / turned.min_element() <= MOST_STRETCH;
    let scale = (wanted.x * wanted.y * wanted.z / (extent.x * extent.y * extent.z)).cbrt();
    let size = extent * scale;
    Problem::new(message).with_hint(if fits_turned {
        "it fits turned by a quarter: add `turn: 90` or `turn: -90`".to_owned()
    } else {
        let sizes = format!("[{:.2}, {:.2}, {:.2}]", size.x, size.z, size.y);
        format!("give the class the size {sizes}, or that of the model by `scale: 1` beside `file`")
    })
}
