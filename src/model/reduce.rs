//! Users' models with fewer triangles.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use crate::model::{Detail, Model, Primitive};
use crate::recipes::kit::{TOLERANCES, simplified_surface};

/// The model with at most [`Detail::REDUCED_SHARE`] of its triangles, as far as its surface moves by no more than that of
/// built-in models does. No corner that is left changes in anything, and those at rims and seams, where materials, images or
/// sharp edges meet, all stay.
pub(crate) fn reduced(model: &Model) -> Model {
    let [low, high] = model.bounds();
    let diagonal = f64::from(high.distance(low));
    Model { primitives: model.primitives.iter().map(|part| simplified(part, diagonal)).collect() }
}

fn simplified(part: &Primitive, diagonal: f64) -> Primitive {
    let points: Vec<DVec3> = part.positions.iter().map(|&at| Vec3::from_array(at).as_dvec3()).collect();
    let corners = equal_corners(part);
    let whole = part.indices.as_chunks::<3>().0.iter();
    let mut triangles: Vec<[usize; 3]> =
        whole.map(|triangle| triangle.map(|index| corners[index as usize])).collect();
    let target = (triangles.len() as f64 * Detail::REDUCED_SHARE) as usize;
    for tolerance in TOLERANCES {
        if triangles.len() <= target {
            break;
        }
        triangles = simplified_surface(&points, &triangles, target, tolerance * diagonal);
    }
    part.with_triangles(triangles.into_iter().flatten().map(|corner| corner as u32))
}

/// For each corner the first one that is equal to it in all that corners carry.
fn equal_corners(part: &Primitive) -> Vec<usize> {
    let mut first: HashMap<Vec<u32>, usize> = HashMap::with_capacity(part.positions.len());
    let corner = |index: usize| {
        let mut numbers: Vec<f32> = part.positions[index].to_vec();
        numbers.extend(part.normals.get(index).into_iter().flatten());
        numbers.extend(part.coordinate_sets().filter_map(|set| set.get(index)).flatten());
        numbers.extend(part.colors.get(index).into_iter().flatten());
        numbers.into_iter().map(f32::to_bits).collect::<Vec<u32>>()
    };
    (0..part.positions.len()).map(|index| *first.entry(corner(index)).or_insert(index)).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;
    use std::f64::consts::{PI, TAU};

    use super::*;

    /// Steps of [`ball`] around and from pole to pole.
    const STEPS: [usize; 2] = [48, 24];

    /// A ball on which an image lies, so that it has a seam from pole to pole.
    fn ball() -> Primitive {
        let [around, down] = STEPS;
        let mut part = Primitive::default();
        for (row, column) in (0..=down).flat_map(|row| (0..=around).map(move |column| (row, column))) {
            let (share, turn) = (row as f64 / down as f64, column as f64 / around as f64);
            let (sine, cosine) = libm::sincos(TAU * (column % around) as f64 / around as f64);
            let (ring, height) = libm::sincos(PI * share);
            let at = DVec3::new(ring * cosine, height, ring * sine).as_vec3();
            part.positions.push((at * 0.5).to_array());
            part.normals.push(at.to_array());
            part.texture_coordinates.push([turn as f32, share as f32]);
        }
        let at = |row: usize, column: usize| (row * (around + 1) + column) as u32;
        for (row, column) in (0..down).flat_map(|row| (0..around).map(move |column| (row, column))) {
            let [a, b] = [at(row, column), at(row, column + 1)];
            let [c, d] = [at(row + 1, column + 1), at(row + 1, column)];
            // One triangle at the poles.
            part.indices.extend(if row > 0 { vec![a, b, c] } else { Vec::new() });
            part.indices.extend(if row + 1 < down { vec![a, c, d] } else { Vec::new() });
        }
        part
    }

    fn corner(part: &Primitive, index: u32) -> [u32; 8] {
        let index = index as usize;
        let numbers = [part.positions[index], part.normals[index]].concat();
        let coordinates = part.texture_coordinates[index];
        std::array::from_fn(|place| numbers.get(place).unwrap_or(&coordinates[place % 2]).to_bits())
    }

    #[test]
    fn a_ball_has_a_third_of_its_triangles_and_no_corner_that_it_had_not() {
        let whole = Model { primitives: vec![ball()] };
        let coarse = reduced(&whole).primitives.remove(0);
        let share = coarse.indices.len() as f64 / whole.primitives[0].indices.len() as f64;
        assert!(share <= Detail::REDUCED_SHARE + 0.01, "{share}");
        let known: HashSet<[u32; 8]> =
            (0..ball().positions.len() as u32).map(|index| corner(&ball(), index)).collect();
        assert!(coarse.indices.iter().all(|&index| known.contains(&corner(&coarse, index))));
        let far = coarse.positions.iter().map(|&at| Vec3::from_array(at).length());
        assert!(far.into_iter().all(|length| (length - 0.5).abs() < 1e-6));
    }

    #[test]
    fn seams_stay_closed() {
        let coarse = reduced(&Model { primitives: vec![ball()] }).primitives.remove(0);
        let place = |index: u32| coarse.positions[index as usize].map(|number| (number * 1e6).round() as i32);
        let mut balance: HashMap<[[i32; 3]; 2], i32> = HashMap::new();
        for &[a, b, c] in coarse.indices.as_chunks::<3>().0 {
            for [from, to] in [[a, b], [b, c], [c, a]].map(|edge| edge.map(place)) {
                *balance.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
            }
        }
        assert!(balance.values().all(|&count| count == 0));
        let on_seam = |part: &Primitive| {
            part.texture_coordinates.iter().filter(|coordinates| coordinates[0] == 1.0).count()
        };
        assert_eq!(on_seam(&coarse), STEPS[1], "all but the one of no triangle");
    }

    #[test]
    fn what_has_sharp_edges_only_stays() {
        let mut box_side = ball();
        box_side.indices.truncate(3);
        let whole = Model { primitives: vec![box_side] };
        assert_eq!(reduced(&whole).primitives[0].indices.len(), 3);
    }
}
