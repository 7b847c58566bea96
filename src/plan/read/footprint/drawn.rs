//! What a reader of a format finds in a file, in the coordinates of the file.

use super::facts::Facts;
use crate::geometry::Point;
pub(super) use crate::plan::read::rings::Rings;

/// A map as its file draws it. All places are in the units of its reference system: x is the longitude or the way east.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// The reference system as the file spells it.
    pub(super) reference_system: Option<String>,
    /// Whether a file without a reference system is in degrees.
    pub(super) is_degrees_unless_said: bool,
    /// Buildings and their parts.
    pub(super) buildings: Vec<Drawn>,
    /// Doors that the map shows.
    pub(super) entrances: Vec<Point>,
    /// Centre lines of streets.
    pub(super) streets: Vec<Vec<Point>>,
}

impl Drawing {
    /// The map with all places as `moved` has them, in another reference system.
    pub(super) fn moved(mut self, reference_system: &str, moved: impl Fn(Point) -> Point) -> Self {
        let mut move_all =
            |places: &mut Vec<Point>| places.iter_mut().for_each(|place| *place = moved(*place));
        for area in self.buildings.iter_mut().flat_map(|drawn| &mut drawn.areas) {
            move_all(&mut area.outer);
            area.holes.iter_mut().for_each(&mut move_all);
        }
        move_all(&mut self.entrances);
        self.streets.iter_mut().for_each(&mut move_all);
        self.reference_system = Some(reference_system.to_owned());
        self
    }
}

/// A building or a part of one.
#[derive(Clone, Debug, Default)]
pub(super) struct Drawn {
    /// The id in the file, if it has one, in letters that file names take.
    pub(super) id: Option<String>,
    /// Whether the file says that it is a part of a building.
    pub(super) is_part: bool,
    /// Id of the building it is a part of, if the file says.
    pub(super) parent: Option<String>,
    /// Its areas.
    pub(super) areas: Vec<Rings>,
    /// What the file says of it.
    pub(super) facts: Facts,
}
