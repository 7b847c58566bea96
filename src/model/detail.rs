//! How finely furniture is modelled.

/// A level of detail of all furniture of a bake.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
pub enum Detail {
    /// As the recipes draw it.
    #[default]
    Full,
    /// At most [`Detail::REDUCED_SHARE`] of the triangles wherever the parts that one sees from across a room, and the seams
    /// of users' models, allow it.
    Reduced,
    /// The boxes and cylinders of the class's shape, which are also what furniture collides as.
    Boxes,
}

impl Detail {
    /// All levels, from fine to coarse.
    pub const ALL: [Self; 3] = [Self::Full, Self::Reduced, Self::Boxes];

    /// The share of a model's triangles that a reduced one aims at.
    pub const REDUCED_SHARE: f64 = 0.3;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{VariantRef, builtin_catalog};
    use crate::model::{Model, ModelLibrary};
    use crate::recipes::GeometrySet;

    fn triangle_count(model: &Model) -> usize {
        model.primitives.iter().map(|part| part.indices.len() / 3).sum()
    }

    /// How far a model's corners lie from the origin in each direction.
    fn extent(model: &Model) -> [f32; 3] {
        let points = model.primitives.iter().flat_map(|part| &part.positions);
        points.fold([0.0; 3], |most, point| [0, 1, 2].map(|axis| most[axis].max(point[axis].abs())))
    }

    /// What is left of a model must be triangles of some area with unit normals.
    fn assert_sound(model: &Model, name: &str) {
        for part in &model.primitives {
            let at = |index: u32| glam::Vec3::from_array(part.positions[index as usize]).as_dvec3();
            for &[a, b, c] in part.indices.as_chunks::<3>().0 {
                assert!((at(b) - at(a)).cross(at(c) - at(a)).length() > 1e-10, "{name} has a flat triangle");
            }
            let lengths = part.normals.iter().map(|&normal| glam::Vec3::from_array(normal).length());
            assert!(lengths.into_iter().all(|length| (length - 1.0).abs() < 1e-3), "{name}");
        }
    }

    #[test]
    fn every_class_is_coarser_and_fills_the_same_box() {
        let catalog = builtin_catalog();
        let library = ModelLibrary::load(catalog).unwrap();
        let mut sums = [0; Detail::ALL.len()];
        for (index, class) in catalog.classes.iter().enumerate() {
            // The sets take turns: all of them for each class would take a minute without optimization.
            for set in GeometrySet::ALL.into_iter().skip(index % 4).step_by(4) {
                let name = format!("{} ({set})", class.id);
                let models =
                    Detail::ALL.map(|detail| library.model_in_detail(VariantRef::new(index, 0), set, detail));
                let counts = models.each_ref().map(|model| triangle_count(model));
                assert!(counts[1] <= counts[0] && counts[1] > 0 && counts[2] > 0, "{name}: {counts:?}");
                sums = [0, 1, 2].map(|detail| sums[detail] + counts[detail]);
                let full = extent(&models[0]);
                for coarse in &models[1..] {
                    let is_alike = extent(coarse)
                        .into_iter()
                        .zip(full)
                        .all(|(part, whole)| (part - whole).abs() < 0.001);
                    assert!(is_alike, "{name} does not fill its box");
                    assert_sound(coarse, &name);
                }
            }
        }
        let [full, reduced, boxes] = sums;
        assert!((reduced as f64) < full as f64 * (Detail::REDUCED_SHARE + 0.05), "{reduced} of {full}");
        assert!(boxes * 4 < reduced, "{boxes} of {reduced}");
    }
}
