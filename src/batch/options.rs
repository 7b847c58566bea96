//! The options of a bake.

use super::level_list::ChosenLevels;
use crate::cache::Cache;
use crate::output::{IndexOptions, LevelOptions};

/// How a bake goes. Beside `level`, nothing changes a byte of a level.
#[derive(Clone, Debug, PartialEq)]
pub struct BakeOptions {
    /// The options that the files of levels depend on.
    pub level: LevelOptions,
    /// The options that files over all levels depend on.
    pub index: IndexOptions,
    /// Threads; more bake faster and hold more levels in memory. Default 1.
    pub threads: usize,
    /// The share of the levels to bake; default all.
    pub shard: Option<Shard>,
    /// The levels of the share by name; default those that are dealt to it. The share then ends as a part of the manifest.
    pub only_levels: Option<ChosenLevels>,
    /// The treatment of levels in the output folder that the plan does not have; default listed apart.
    pub unplanned: Unplanned,
    /// Where textured surfaces are kept between runs; default nowhere.
    pub cache: Option<Cache>,
}

impl Default for BakeOptions {
    fn default() -> Self {
        Self {
            level: LevelOptions::default(),
            index: IndexOptions::default(),
            threads: 1,
            shard: None,
            only_levels: None,
            unplanned: Unplanned::default(),
            cache: None,
        }
    }
}

/// One of several shares of the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    index: u32,
    /// Of how many; at least `index`.
    count: u32,
}

impl Shard {
    /// The share `index` of `count`, counted from 1; `None` if there is no such share.
    #[must_use]
    pub fn new(index: u32, count: u32) -> Option<Self> {
        (1..=count).contains(&index).then_some(Self { index, count })
    }

    /// Whether a job belongs to the share. Jobs are dealt like cards, so that every share gets levels of
    /// every building.
    pub(crate) fn takes(self, job: usize) -> bool {
        job % self.count as usize == (self.index - 1) as usize
    }

    /// The file that keeps the share's records until all are there.
    pub(crate) fn part_name(self) -> String {
        format!("manifest.{}-of-{}.json", self.index, self.count)
    }
}

/// The treatment of levels in the output folder that the plan does not have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unplanned {
    /// They stay listed as they are: part of the plan could not be read, so that its levels are not known.
    Listed,
    /// Their files stay, and the manifest lists them apart.
    #[default]
    SetApart,
    /// Their files are removed unless they were changed.
    Removed,
}
