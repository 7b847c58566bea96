//! Whether the geometry sets of a recipe differ in shape, whatever their materials.

use glam::DVec3;

use roomwright::internals::geometry::Size;
use roomwright::internals::recipes::{GeometrySet, Recipe, RecipeInput, recipes};

/// Share of the box's diagonal by which the surfaces of two shapes lie apart somewhere: what one sees from across a room.
const LEAST_DIFFERENCE: f64 = 0.01;

/// A model as triangles, without materials.
struct Surface {
    triangles: Vec<[DVec3; 3]>,
}

impl Surface {
    fn of(recipe: &Recipe, look: u32, geometry: GeometrySet) -> Self {
        let size = recipe.usual_size();
        let mesh = recipe.build(&RecipeInput { size, look, geometry, parameters: &[] });
        let triangles = mesh.parts.iter().flat_map(|part| {
            let at = |&index: &u32| DVec3::from_array(part.positions[index as usize].map(f64::from));
            part.indices.as_chunks::<3>().0.iter().map(move |triangle| triangle.each_ref().map(at))
        });
        Self { triangles: triangles.collect() }
    }

    /// Whether a corner of this surface lies farther than a distance from all of another.
    fn leaves(&self, other: &Self, distance: f64) -> bool {
        let is_far =
            |&corner: &DVec3| other.triangles.iter().all(|face| distance_to(corner, face) > distance);
        self.triangles.iter().flatten().any(is_far)
    }

    fn differs(&self, other: &Self, distance: f64) -> bool {
        self.triangles != other.triangles && (self.leaves(other, distance) || other.leaves(self, distance))
    }
}

/// Distance of a point from a triangle (C. Ericson, "Real-Time Collision Detection", 2005, section 5.1.5, by edges).
fn distance_to(point: DVec3, &[a, b, c]: &[DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let is_over =
        [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| normal.dot((to - from).cross(point - from)) >= 0.0);
    if is_over {
        return (point - a).dot(normal.normalize()).abs();
    }
    let to_edge = |(from, to): (DVec3, DVec3)| {
        let along = ((point - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
        point.distance(from.lerp(to, along))
    };
    [(a, b), (b, c), (c, a)].map(to_edge).into_iter().fold(f64::MAX, f64::min)
}

/// The first two of the sets that a recipe serves that are alike in all looks.
fn alike(recipe: &Recipe) -> Option<[GeometrySet; 2]> {
    let Size { width, depth, height } = recipe.usual_size();
    let distance = DVec3::new(width, depth, height).length() * LEAST_DIFFERENCE;
    let sets: Vec<GeometrySet> =
        GeometrySet::ALL.into_iter().filter(|&set| recipe.served(set) == set).collect();
    let of_set = |&set: &GeometrySet| [0, 1, 2, 3].map(|look| Surface::of(recipe, look, set));
    let shapes: Vec<[Surface; 4]> = sets.iter().map(of_set).collect();
    let pairs = (0..shapes.len()).flat_map(|second| (0..second).map(move |first| [first, second]));
    let are_alike = |[first, second]: &[usize; 2]| {
        !shapes[*first].iter().zip(&shapes[*second]).any(|(one, other)| one.differs(other, distance))
    };
    pairs.into_iter().find(are_alike).map(|pair| pair.map(|set| sets[set]))
}

#[test]
fn recipes_have_a_shape_of_their_own_in_each_set_that_they_serve() {
    let fault = |recipe: &&Recipe| {
        alike(recipe).map(|[first, second]| format!("{} is alike in {first} and {second}", recipe.name()))
    };
    let faults: Vec<String> = recipes().iter().filter_map(fault).collect();
    assert!(faults.is_empty(), "{} recipes:\n{faults:#?}", faults.len());
}
