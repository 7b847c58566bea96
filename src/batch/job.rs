//! The jobs of a bake: one for each level, in a fixed order.

use sha2::{Digest, Sha256};

use crate::catalog::Catalog;
use crate::dwelling::{LevelHomes, Occupancy};
use crate::edits::{EditBook, LevelEdits};
use crate::output::LevelOptions;
use crate::plan::{Building, Level, PlacedBuilding, Plan};

use super::file_name::distinct_names;
use crate::disk::FieldHash;

/// One level to bake.
#[derive(Clone, Debug)]
pub(crate) struct Job<'a> {
    /// The building on its site.
    pub(crate) placed: &'a PlacedBuilding,
    /// Its level.
    pub(crate) level: &'a Level,
    /// `<building>/<level>` in the output folder, without extension.
    pub(crate) path: String,
    /// Who lives there; `level` is as the plan has it.
    pub(crate) homes: LevelHomes,
    /// The edits of its rooms.
    pub(crate) edits: Option<&'a LevelEdits>,
    /// Hash of all that the level is made from, the program excepted.
    pub(crate) inputs: String,
}

/// All levels of the plan, sorted by building id, then level id: whatever order the files were named in,
/// shares and manifests are the same.
pub(crate) fn list_jobs<'a>(
    plan: &'a Plan,
    edits: &'a EditBook,
    catalog: &Catalog,
    options: &LevelOptions,
) -> Vec<Job<'a>> {
    let mut buildings: Vec<&PlacedBuilding> = plan.buildings.iter().collect();
    buildings.sort_by(|one, other| one.id.cmp(&other.id));
    let ids: Vec<&str> = buildings.iter().map(|placed| placed.id.as_str()).collect();
    let folders = distinct_names(&ids);
    let common = common_hash(catalog, options);
    let mut jobs = Vec::new();
    for (placed, folder) in buildings.into_iter().zip(folders) {
        let occupancy = Occupancy::new(&placed.building, &placed.id, &catalog.households, options.seed);
        for (index, name) in sorted_levels(&placed.building) {
            let (level, homes) = (&placed.building.levels[index], occupancy.level(index).clone());
            let edits = edits.level(&placed.id, &level.id);
            let inputs = input_hash(&common, placed, (level, &homes), edits);
            jobs.push(Job { placed, level, path: format!("{folder}/{name}"), homes, edits, inputs });
        }
    }
    jobs
}

/// The indices of the levels, with their names in the output.
fn sorted_levels(building: &Building) -> Vec<(usize, String)> {
    let id = |&level: &usize| building.levels[level].id.as_str();
    let mut levels: Vec<usize> = (0..building.levels.len()).collect();
    levels.sort_by(|one, other| id(one).cmp(id(other)));
    let ids: Vec<&str> = levels.iter().map(id).collect();
    let names = distinct_names(&ids);
    levels.into_iter().zip(names).collect()
}

/// Hash of what all levels have in common: the catalogue, and the options as they are written.
fn common_hash(catalog: &Catalog, options: &LevelOptions) -> [u8; 32] {
    let mut hash = Sha256::new();
    hash.update(catalog.digest);
    hash.update(serde_json::to_vec(options).expect("options are plain data"));
    hash.finalize().into()
}

fn input_hash(
    common: &[u8; 32],
    placed: &PlacedBuilding,
    (level, homes): (&Level, &LevelHomes),
    edits: Option<&LevelEdits>,
) -> String {
    let site = placed.site;
    let mut hash = FieldHash::new("level");
    hash.field(common).field(&level.digest).field(placed.id.as_bytes()).field(level.id.as_bytes());
    // They may depend on other levels of the building.
    hash.field(homes.fingerprint().as_bytes());
    // It is part of the manifest: a level from which another part was left out is no longer the same.
    for message in &level.left_out {
        hash.field(message.as_bytes());
    }
    if let Some(attribution) = &placed.building.attribution {
        hash.field(b"attribution").field(attribution.as_bytes());
    }
    for number in [site.position.x, site.position.y, site.turn] {
        hash.field(&number.to_le_bytes());
    }
    if let Some(edits) = edits {
        hash.field(edits.fingerprint().as_bytes());
    }
    hash.finish()
}

#[cfg(test)]
pub(crate) mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::batch::options::Shard;
    use crate::compact::Instancing;
    use crate::contract::RoomId;
    use crate::gltf::FlatNormals;
    use crate::model::Detail;
    use crate::output::{Format, TextureOptions};
    use crate::plan::SitePlacement;
    use crate::scene::{Lights, Parts, SceneOptions};
    use crate::texture::TextureSize;

    pub(crate) fn empty_level(id: &str, digest: u8) -> Level {
        Level { digest: [digest; 32], ..Level::bare(id, 3.0, Vec::new()) }
    }

    pub(crate) fn tower(id: &str, levels: &[&str]) -> PlacedBuilding {
        let levels = levels.iter().map(|level| empty_level(level, 7)).collect();
        PlacedBuilding {
            id: id.to_owned(),
            site: SitePlacement::default(),
            building: Arc::new(Building { name: None, attribution: None, levels }),
            source: Arc::default(),
        }
    }

    fn paths(plan: &Plan) -> Vec<String> {
        let no_edits = EditBook::default();
        let jobs = list_jobs(plan, &no_edits, &Catalog::default(), &LevelOptions::default());
        jobs.into_iter().map(|job| job.path).collect()
    }

    #[test]
    fn the_order_of_the_plan_does_not_matter() {
        let (a, b) = (tower("a", &["2", "1"]), tower("b", &["1"]));
        let one = paths(&Plan { buildings: vec![a.clone(), b.clone()] });
        let other = paths(&Plan { buildings: vec![b, a] });
        assert_eq!(one, ["a/1", "a/2", "b/1"]);
        assert_eq!(one, other);
    }

    #[test]
    fn every_level_is_in_exactly_one_shard() {
        let shards: Vec<Shard> = (1..=3).map(|index| Shard::new(index, 3).unwrap()).collect();
        for job in 0..20 {
            assert_eq!(shards.iter().filter(|shard| shard.takes(job)).count(), 1);
        }
        assert_eq!(Shard::new(0, 3), None);
        assert_eq!(Shard::new(4, 3), None);
    }

    #[test]
    fn every_input_changes_the_hash() {
        let plan = Plan { buildings: vec![tower("a", &["1"])] };
        let inputs = |plan: &Plan, options: &LevelOptions| {
            list_jobs(plan, &EditBook::default(), &Catalog::default(), options)[0].inputs.clone()
        };
        let base = inputs(&plan, &LevelOptions::default());
        let showing = |scene| LevelOptions { scene, ..LevelOptions::default() };
        let options = [
            LevelOptions { seed: 2, ..LevelOptions::default() },
            LevelOptions { effort: 1, ..LevelOptions::default() },
            LevelOptions { style: Some("hotel".to_owned()), ..LevelOptions::default() },
            LevelOptions { format: Format::named("gltf").unwrap(), ..LevelOptions::default() },
            LevelOptions { has_shared_library: true, ..LevelOptions::default() },
            showing(SceneOptions { lights: Lights::Physical, ..SceneOptions::default() }),
            showing(SceneOptions { lights: Lights::Off, ..SceneOptions::default() }),
            showing(SceneOptions { parts: Parts::Separate, ..SceneOptions::default() }),
            showing(SceneOptions { door_angle: Some(0), ..SceneOptions::default() }),
            showing(SceneOptions { has_variants: true, ..SceneOptions::default() }),
            LevelOptions { detail: Detail::Boxes, ..LevelOptions::default() },
            LevelOptions { instancing: Instancing::None, ..LevelOptions::default() },
            LevelOptions { flat_normals: FlatNormals::Implied, ..LevelOptions::default() },
            LevelOptions {
                textures: TextureOptions { size: None, are_shared: false },
                ..LevelOptions::default()
            },
            LevelOptions {
                textures: TextureOptions { size: Some(TextureSize::Large), are_shared: false },
                ..LevelOptions::default()
            },
            LevelOptions {
                textures: TextureOptions { size: Some(TextureSize::Small), are_shared: true },
                ..LevelOptions::default()
            },
        ];
        for changed in options {
            assert_ne!(inputs(&plan, &changed), base);
        }
        let mut moved = plan.clone();
        moved.buildings[0].site.turn = 1.0;
        assert_ne!(inputs(&moved, &LevelOptions::default()), base);
        let mut edits = EditBook::default();
        edits.pin(&RoomId::new("a", "1", "101"), 7);
        let edited = |edits: &EditBook| {
            list_jobs(&plan, edits, &Catalog::default(), &LevelOptions::default())[0].inputs.clone()
        };
        assert_ne!(edited(&edits), base);
        edits = EditBook::default();
        edits.pin(&RoomId::new("a", "2", "201"), 7);
        assert_eq!(edited(&edits), base, "of another level");
        let renamed = Plan { buildings: vec![tower("b", &["1"])] };
        assert_ne!(inputs(&renamed, &LevelOptions::default()), base);
    }
}
