//! Turns triangles into the arrays of a file: whole numbers wherever they suffice.

use glam::{DQuat, DVec3, Vec3};

use super::buffer::Kind;
use super::merged::Merged;

/// Parts of a metre at which the middle of a level's grid is.
const GRID_PARTS: f64 = 1000.0;
/// Parts of a metre of which its steps are whole numbers.
const STEP_PARTS: f64 = 1e6;
/// Metres of the smallest model: a step is never zero.
const SMALLEST: f64 = 1e-3;
/// The highest number of a quantised position.
const HIGHEST: f64 = i16::MAX as f64;

/// The arrays of a primitive, but for features.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct EncodedPart {
    pub(super) positions: (Kind, Vec<u8>),
    /// Lowest and highest positions, as they are in the file.
    pub(super) bounds: [[f64; 3]; 2],
    pub(super) normals: Vec<u8>,
    /// By set.
    pub(super) coordinates: Vec<(Kind, Vec<u8>)>,
    /// Empty without colours.
    pub(super) colors: Vec<u8>,
    pub(super) indices: (Kind, Vec<u8>),
}

/// The arrays of triangles on a grid.
pub(super) fn encode(part: &Merged, grid: &Grid) -> EncodedPart {
    let (positions, bounds) = grid.positions(&part.positions);
    EncodedPart {
        positions,
        bounds,
        normals: normals(&part.normals),
        coordinates: part.coordinates.iter().map(|set| coordinates(set)).collect(),
        colors: colors(&part.colors),
        indices: indices(&part.indices, part.positions.len()),
    }
}

/// The grid of positions.
pub(super) struct Grid {
    /// Metres of its middle in the frame of what is on it.
    pub(super) origin: DVec3,
    /// Metres; zero where positions stay metres.
    pub(super) step: f64,
}

impl Grid {
    /// The grid of a model whose corners are whole numbers.
    pub(super) const OF_WHOLE: Self = Self { origin: DVec3::ZERO, step: 1.0 };

    /// The grid of a model, whose steps are as fine as 16 bits make them, around the model's own origin.
    pub(super) fn of_model<'p>(corners: impl Iterator<Item = &'p DVec3>) -> Self {
        let farthest = corners.fold(SMALLEST, |most, corner| most.max(corner.abs().max_element()));
        // Instances are scaled by it in single precision.
        Self { origin: DVec3::ZERO, step: f64::from((farthest / HIGHEST) as f32) }
    }

    /// The grid of a level; none where it would be coarser than this.
    pub(super) fn of_level<'p>(corners: impl Iterator<Item = &'p DVec3>, coarsest_step: f64) -> Self {
        let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = corners.fold(empty, |(low, high), corner| (low.min(*corner), high.max(*corner)));
        let origin = ((low + high) / 2.0 * GRID_PARTS).round() / GRID_PARTS;
        let reach = (high - origin).max(origin - low).max_element();
        let step = (reach / HIGHEST * STEP_PARTS).ceil() / STEP_PARTS;
        if step <= coarsest_step { Self { origin, step } } else { Self { origin: DVec3::ZERO, step: 0.0 } }
    }

    fn positions(&self, corners: &[DVec3]) -> ((Kind, Vec<u8>), [[f64; 3]; 2]) {
        if self.step > 0.0 {
            let limit = |number: f64| number.round().clamp(-HIGHEST, HIGHEST) as i16;
            let steps: Vec<[i16; 4]> = corners
                .iter()
                .map(|corner| {
                    let [x, y, z] = ((*corner - self.origin) / self.step).to_array().map(limit);
                    [x, y, z, 0]
                })
                .collect();
            let bounds = bounds(steps.iter().map(|&[x, y, z, _]| [x, y, z].map(f64::from)));
            let bytes = steps.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
            return ((Kind::Steps, bytes), bounds);
        }
        let metres: Vec<[f32; 3]> = corners.iter().map(|corner| corner.as_vec3().to_array()).collect();
        let bounds = bounds(metres.iter().map(|corner| corner.map(f64::from)));
        ((Kind::Metres, numbers(metres.as_flattened().iter().copied())), bounds)
    }
}

fn bounds(corners: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    let empty = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    corners.fold(empty, |[low, high], corner| {
        [
            [0, 1, 2].map(|axis| low[axis].min(corner[axis])),
            [0, 1, 2].map(|axis| high[axis].max(corner[axis])),
        ]
    })
}

/// Texture coordinates, in half as many bytes where none repeats its image.
fn coordinates(coordinates: &[[f32; 2]]) -> (Kind, Vec<u8>) {
    let flat = coordinates.as_flattened();
    if flat.iter().all(|number| (0.0..=1.0).contains(number)) {
        let share = |number: &f32| ((number * f32::from(u16::MAX)).round() as u16).to_le_bytes();
        return (Kind::Shares, flat.iter().flat_map(share).collect());
    }
    (Kind::Coordinates, numbers(flat.iter().copied()))
}

fn indices(indices: &[u32], corner_count: usize) -> (Kind, Vec<u8>) {
    // The highest number is no corner but restarts a strip.
    if corner_count < usize::from(u16::MAX) {
        return (
            Kind::ShortIndices,
            indices.iter().flat_map(|&index| (index as u16).to_le_bytes()).collect(),
        );
    }
    (Kind::LongIndices, indices.iter().flat_map(|index| index.to_le_bytes()).collect())
}

fn normals(directions: &[Vec3]) -> Vec<u8> {
    let byte = |number: f32| ((number * f32::from(i8::MAX)).round() as i8) as u8;
    directions.iter().flat_map(|direction| [direction.x, direction.y, direction.z, 0.0].map(byte)).collect()
}

fn colors(colors: &[[f32; 4]]) -> Vec<u8> {
    colors.iter().copied().flat_map(color).collect()
}

/// A colour as it is in files.
pub(super) fn color(color: [f32; 4]) -> [u8; 4] {
    color.map(|channel| (channel.clamp(0.0, 1.0) * f32::from(u8::MAX)).round() as u8)
}

/// Rotations as they are in files.
pub(super) fn rotations(rotations: impl Iterator<Item = DQuat>) -> Vec<u8> {
    let share = |number: f64| ((number * HIGHEST).round() as i16).to_le_bytes();
    rotations.flat_map(|rotation| rotation.to_array()).flat_map(share).collect()
}

/// Numbers of features of instances as they are in files.
pub(super) fn instance_features(features: impl Iterator<Item = usize> + Clone) -> (Kind, Vec<u8>) {
    let shorts: Result<Vec<u16>, _> = features.clone().map(u16::try_from).collect();
    match shorts {
        Ok(shorts) => (Kind::InstanceFeatures, shorts.into_iter().flat_map(u16::to_le_bytes).collect()),
        Err(_) => (Kind::ManyInstanceFeatures, numbers(features.map(|feature| feature as f32))),
    }
}

/// Numbers as they are in files.
pub(super) fn numbers(numbers: impl Iterator<Item = f32>) -> Vec<u8> {
    // Without a negative zero.
    numbers.flat_map(|number| (number + 0.0).to_le_bytes()).collect()
}
