//! Furnishes, judges, builds and writes one room on demand, without the other rooms of its level.

use std::slice::from_ref;
use std::sync::OnceLock;

use super::read::Project;
use super::unknown::UnknownRoom;
use super::writer::{RoomView, RoomWriter};
use crate::audit::Verdict;
use crate::contract::RoomId;
use crate::edits::{Finished, Misfit};
use crate::gltf::GltfError;
use crate::layout::Furnished;
use crate::output::LevelOptions;
use crate::plan::{Level, PlacedBuilding};

/// A furnished room.
#[derive(Clone, Debug)]
pub struct FinishedRoom<'a> {
    /// Its building.
    pub building: &'a PlacedBuilding,
    /// Its level.
    pub level: &'a Level,
    /// Its furniture; says which room of the level it is.
    pub furnished: Furnished,
    /// The findings of the audit.
    pub verdict: Verdict,
    /// Edits that were rejected, and edited objects with findings.
    pub misfits: Vec<Misfit>,
}

/// The rooms of a project, furnished when they are asked for. It may be asked by many threads at once, and keeps what rooms
/// share (textures, models), but no room.
pub struct Rooms<'a> {
    project: &'a Project,
    /// The buildings with people in them, each when it is first asked for.
    occupied: Vec<OnceLock<PlacedBuilding>>,
    options: &'a LevelOptions,
    writer: RoomWriter,
}

impl<'a> Rooms<'a> {
    pub(super) fn new(project: &'a Project, options: &'a LevelOptions) -> Self {
        Self {
            project,
            occupied: project.plan.buildings.iter().map(|_| OnceLock::new()).collect(),
            options,
            writer: RoomWriter::alone(&project.catalog, options),
        }
    }

    /// Furnishes a room, applies its edits and judges it. The same room every time, and the one that a bake writes.
    ///
    /// # Errors
    /// If the plan has no such room.
    pub fn furnish(&self, id: &RoomId) -> Result<FinishedRoom<'_>, UnknownRoom> {
        let (building, level, room) =
            self.find(id).ok_or_else(|| UnknownRoom::in_plan(id, &self.project.plan))?;
        let Finished { judged, misfits } =
            self.project.furnish_room(self.options, &building.id, level.room(room));
        Ok(FinishedRoom { building, level, furnished: judged.furnished, verdict: judged.verdict, misfits })
    }

    fn find(&self, id: &RoomId) -> Option<(&PlacedBuilding, &Level, usize)> {
        let buildings = &self.project.plan.buildings;
        let index = buildings.iter().position(|placed| placed.id == id.building)?;
        let building = self.occupied[index].get_or_init(|| self.project.occupied(index, self.options.seed));
        let level = building.building.levels.iter().find(|level| level.id == id.level)?;
        let room = level.rooms.iter().position(|room| room.id == id.room)?;
        Some((building, level, room))
    }

    /// The tree of nodes of a room, for tests.
    #[cfg(test)]
    pub(crate) fn scene(&self, room: &FinishedRoom<'_>) -> crate::scene::Scene {
        self.writer.scene(self.project, self.options, &room.view())
    }

    /// The room alone as one binary glTF file with all that it shows, whatever [`LevelOptions::format`] says.
    ///
    /// # Errors
    /// If the file would have 4 GiB or more.
    pub fn glb(&self, room: &FinishedRoom<'_>) -> Result<Vec<u8>, GltfError> {
        self.writer.glb(self.project, self.options, &room.view())
    }
}

impl FinishedRoom<'_> {
    fn view(&self) -> RoomView<'_> {
        let Self { building, level, furnished, verdict, .. } = self;
        RoomView { building, level, furnished: from_ref(furnished), verdicts: from_ref(verdict) }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::path::Path;

    use super::super::ProjectPaths;
    use super::*;
    use crate::dwelling::occupied;
    use crate::output::TextureOptions;
    use crate::scene::{Node, SceneInput, build_scene};

    fn house() -> Project {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/plans/house.yaml");
        Project::read(&ProjectPaths::from_iter([path])).unwrap()
    }

    fn plain() -> LevelOptions {
        let textures = TextureOptions { size: None, are_shared: false };
        LevelOptions { seed: 5, effort: 2, textures, ..LevelOptions::default() }
    }

    /// The nodes below a root by name: place and extras.
    fn nodes(root: &Node, found: &mut BTreeMap<String, String>) {
        for node in &root.children {
            let Node { name, translation, rotation, extras, .. } = node;
            found.insert(name.clone(), format!("{translation} {rotation} {extras:?}"));
            nodes(node, found);
        }
    }

    #[test]
    fn a_room_alone_is_the_room_of_the_level() {
        let (project, options) = (house(), plain());
        let rooms = project.rooms(&options);
        let placed = &project.plan.buildings[0];
        let people = occupied(&project.plan, &project.catalog, options.seed);
        let level = &people.buildings[0].building.levels[0];
        let of =
            |room: &crate::plan::Room| rooms.furnish(&RoomId::new(&placed.id, &level.id, &room.id)).unwrap();
        let all: Vec<FinishedRoom<'_>> = level.rooms.iter().map(of).collect();
        let furnished: Vec<Furnished> = all.iter().map(|room| room.furnished.clone()).collect();
        let verdicts: Vec<Verdict> = all.iter().map(|room| room.verdict.clone()).collect();
        let whole = build_scene(&SceneInput {
            level,
            building: &placed.id,
            attribution: None,
            site: placed.site,
            furnished: &furnished,
            verdicts: &verdicts,
            catalog: &project.catalog,
            models: &|of, geometry| project.models.model(of, geometry),
            textures: None,
            swatches: None,
            options: options.scene,
            seed: options.seed,
            style: None,
        });
        let (mut known, mut together) = (BTreeMap::new(), BTreeMap::new());
        nodes(&whole.root, &mut known);
        for room in &all {
            let alone = rooms.scene(room);
            assert_eq!(alone.root.name, whole.root.name);
            nodes(&alone.root, &mut together);
            assert!(rooms.glb(room).unwrap().starts_with(b"glTF"));
        }
        assert_eq!(together, known);
    }

    #[test]
    fn a_room_that_is_not_there_is_named() {
        let (project, options) = (house(), plain());
        let rooms = project.rooms(&options);
        let error = rooms.furnish(&RoomId::new("house", "ground", "ballroom")).unwrap_err();
        assert_eq!(error.id.room, "ballroom");
        let unknown = |id: &str| rooms.furnish(&id.parse().unwrap()).unwrap_err().to_string();
        assert_eq!(
            unknown("house/ground/livin"),
            "the plan has no room house/ground/livin; did you mean \"living\"?"
        );
        assert!(unknown("house/cellar/living").ends_with("possible here: ground, upper"));
        assert!(unknown("mill/ground/living").ends_with("possible here: house"));
        assert_eq!(
            "house/living".parse::<RoomId>().unwrap_err().to_string(),
            "the id \"house/living\" is not BUILDING/LEVEL/ROOM"
        );
    }

    #[test]
    fn a_style_that_is_not_there_is_named() {
        let project = house();
        assert_eq!(project.level_options_in("home_modern").unwrap().style.as_deref(), Some("home_modern"));
        let error = project.level_options_in("home_modem").unwrap_err();
        assert_eq!(error.to_string(), "unknown style \"home_modem\"; did you mean \"home_modern\"?");
    }
}
