//! Clocks that stand: the tests of all recipes build the size for walls.

use super::CLOCK;
use crate::geometry::Size;
use crate::recipes::tests::checks::{Welded, number_fault};
use crate::recipes::{GeometrySet, RecipeInput};

#[test]
fn clocks_that_stand_are_sound_and_differ_between_the_sets() {
    let size = Size { width: 0.14, depth: 0.08, height: 0.1 };
    for look in 0..4 {
        let models = GeometrySet::ALL
            .map(|geometry| CLOCK.build(&RecipeInput { size, look, geometry, parameters: &[] }));
        for (model, set) in models.iter().zip(GeometrySet::ALL) {
            let welded = Welded::new(model);
            let faults = [number_fault(model, size), welded.surface_fault(), welded.flicker_fault()];
            assert_eq!(faults, [None, None, None], "{set} {look}");
            let count: usize = model.parts.iter().map(|part| part.indices.len() / 3).sum();
            assert!(count <= 300, "{set} {look} has {count} triangles");
        }
        for (index, model) in models.iter().enumerate() {
            assert!(!models[..index].contains(model), "{look}");
        }
    }
}
