//! Reads files into a project.

use std::path::{Path, PathBuf};

use super::plausible::check_plausible;
use super::rooms::Rooms;
use super::unknown::UnknownStyle;
use crate::batch::{BakeInput, BakeOptions, BakeReport, OutputFault, OutputFolder, bake};
use crate::catalog::{Catalog, load_catalog};
use crate::contract::RoomId;
use crate::document::{Faults, Source, Warned};
use crate::edits::{EditBook, read_edits};
use crate::model::ModelLibrary;
use crate::output::LevelOptions;
use crate::plan::{
    Level, PlacedBuilding, Plan, PlanOptions, ProjectSettings, parse_plan, project_settings, read_plans,
};
use crate::storey::Choices;

/// Plans, edits, catalogue and models.
#[derive(Debug)]
pub struct Project {
    /// The catalogue.
    pub catalog: Catalog,
    /// The models of its classes.
    pub models: ModelLibrary,
    /// The buildings that could be read.
    pub plan: Plan,
    /// The edits of the furnished rooms.
    pub edits: EditBook,
    /// The settings of project files for the run.
    pub settings: ProjectSettings,
    /// Errors and warnings; after an error some rooms or buildings are missing.
    pub faults: Faults,
}

/// Where the files of a project are.
#[derive(Clone, Debug, Default)]
pub struct ProjectPaths {
    /// Plans, project files, folders of these, in any format that is read.
    pub plans: Vec<PathBuf>,
    /// Further folders of configuration; later ones win, and all win over those that project files name.
    pub catalog: Vec<PathBuf>,
    /// Which edits are applied.
    pub edits: EditsChoice,
    /// How buildings are planned of which only the outline is known.
    pub choices: Choices,
}

/// Which edits are applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EditsChoice {
    /// Those beside the plans, then these files; later ones win.
    With(Vec<PathBuf>),
    /// None.
    Without,
}

impl Default for EditsChoice {
    fn default() -> Self {
        Self::With(Vec::new())
    }
}

impl<P: AsRef<Path>> FromIterator<P> for ProjectPaths {
    /// Plans alone, with the edits beside them.
    fn from_iter<I: IntoIterator<Item = P>>(plans: I) -> Self {
        Self { plans: plans.into_iter().map(|path| path.as_ref().to_owned()).collect(), ..Self::default() }
    }
}

impl Project {
    /// Reads the catalogue, its models, then plans and edits.
    ///
    /// # Errors
    /// If nothing could be read: all faults of the catalogue, of the project file, or of every plan.
    pub fn read(paths: &ProjectPaths) -> Result<Self, Faults> {
        let mut settings = project_settings(&paths.plans)?;
        let folders: Vec<PathBuf> = settings.catalog.iter().chain(&paths.catalog).cloned().collect();
        let Warned { value: catalog, warnings: mut faults } = load_catalog(&folders)?;
        let models = ModelLibrary::load(&catalog)?;
        let reading = read_plans(
            &paths.plans,
            &PlanOptions::new(&catalog.room_words).with_planning(&catalog.typologies, &paths.choices),
        );
        faults.merge(reading.faults);
        if reading.plan.buildings.is_empty() {
            return Err(faults);
        }
        settings.origin = settings.origin.or(reading.origin);
        let plan = reading.plan;
        let (edits, edit_faults) = match &paths.edits {
            EditsChoice::With(files) => read_edits(&plan, files, &catalog),
            EditsChoice::Without => (EditBook::default(), Faults::default()),
        };
        faults.merge(edit_faults);
        faults.merge(check_plausible(&plan, &catalog));
        Ok(Self { catalog, models, plan, edits, settings, faults })
    }

    /// As [`Project::read`], of one plan in YAML or JSON that is in memory, with the built-in catalogue and without edits: for
    /// programs without files. The name stands in the faults.
    ///
    /// # Errors
    /// All faults of the plan, if no building of it can be read.
    pub fn parse(name: &str, text: &str) -> Result<Self, Faults> {
        let Warned { value: catalog, warnings: mut faults } = load_catalog(&[])?;
        let models = ModelLibrary::load(&catalog)?;
        let reading = parse_plan(Source::new(Path::new(name), text), &PlanOptions::new(&catalog.room_words));
        faults.merge(reading.faults);
        if reading.plan.buildings.is_empty() {
            return Err(faults);
        }
        let plan = reading.plan;
        faults.merge(check_plausible(&plan, &catalog));
        let (edits, settings) = (EditBook::default(), ProjectSettings::default());
        Ok(Self { catalog, models, plan, edits, settings, faults })
    }

    /// Bakes all levels into a folder, which is made where there is none. Levels that are up to date stay as they are.
    ///
    /// One bad room or level does not stop the others; see [`BakeReport::failures`].
    ///
    /// # Errors
    /// If the folder holds files of other origin that would be replaced, or cannot be written.
    pub fn bake(&self, options: &BakeOptions, out: impl AsRef<Path>) -> Result<BakeReport, OutputFault> {
        let folder = OutputFolder::open(out.as_ref(), false)?;
        let Self { plan, edits, catalog, models, .. } = self;
        bake(&BakeInput { plan, edits, catalog, models, options }, &folder, &|_| ())
    }

    /// The options that apply where nobody says otherwise: seed and style of the project file, if it has them.
    #[must_use]
    pub fn level_options(&self) -> LevelOptions {
        let defaults = LevelOptions::default();
        let ProjectSettings { seed, style, .. } = &self.settings;
        LevelOptions { seed: seed.unwrap_or(defaults.seed), style: style.clone(), ..defaults }
    }

    /// The same with a style or building style of the catalogue ([`Catalog::style_ids`]). A style that the plan names for a room
    /// holds there all the same, and one that is made for other types of rooms than a room's leaves it the default style.
    ///
    /// # Errors
    /// If the catalogue has no such style.
    pub fn level_options_in(&self, style: &str) -> Result<LevelOptions, UnknownStyle> {
        if !self.catalog.has_style(style) {
            return Err(UnknownStyle::in_catalog(style, &self.catalog));
        }
        Ok(LevelOptions { style: Some(style.to_owned()), ..self.level_options() })
    }

    /// All rooms by their ids, in the order of the plan.
    pub fn room_ids(&self) -> impl Iterator<Item = RoomId> + '_ {
        self.plan.buildings.iter().flat_map(|placed| {
            placed
                .building
                .levels
                .iter()
                .flat_map(|level| level.rooms.iter().map(|room| RoomId::new(&placed.id, &level.id, &room.id)))
        })
    }

    /// Whether all rooms, their edits and their places are those of another project.
    pub(crate) fn is_equal(&self, other: &Self) -> bool {
        let is_level = |one: &Level, other: &Level| {
            (&one.id, &one.name, one.digest) == (&other.id, &other.name, other.digest)
        };
        let is_building = |one: &PlacedBuilding, other: &PlacedBuilding| {
            let (levels, others) = (&one.building.levels, &other.building.levels);
            (&one.id, one.site, &one.building.name) == (&other.id, other.site, &other.building.name)
                && levels.len() == others.len()
                && levels.iter().zip(others).all(|(one, other)| is_level(one, other))
        };
        let (buildings, others) = (&self.plan.buildings, &other.plan.buildings);
        self.catalog.digest == other.catalog.digest
            && self.edits.fingerprint() == other.edits.fingerprint()
            && buildings.len() == others.len()
            && buildings.iter().zip(others).all(|(one, other)| is_building(one, other))
    }

    /// Whether the plan has a room.
    pub(crate) fn has_room(&self, id: &RoomId) -> bool {
        let building = self.plan.buildings.iter().find(|placed| placed.id == id.building);
        let level =
            building.and_then(|placed| placed.building.levels.iter().find(|level| level.id == id.level));
        level.is_some_and(|level| level.rooms.iter().any(|room| room.id == id.room))
    }

    /// The rooms one by one, as a bake with these options furnishes them.
    #[must_use]
    pub fn rooms<'a>(&'a self, options: &'a LevelOptions) -> Rooms<'a> {
        Rooms::new(self, options)
    }
}
