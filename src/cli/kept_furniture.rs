//! `import --keep-furniture`: writes the furniture of plans as edits files beside them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::answer::KeptFurnitureAnswer;
use super::files::{Overwrite, write_text};
use crate::catalog::Catalog;
use crate::document::{Fault, Faults, counted};
use crate::edits::{KeptFurniture, edits_path, keep_drawn, write_edits};
use crate::plan::{DrawnPiece, PlacedBuilding, PlanOptions, drawn_furniture};
use crate::storey::Choices;

/// Words for pieces that are reported one by one.
const TOLD_WORDS: usize = 20;

/// An edits file that was written.
pub(crate) struct KeptFile {
    path: PathBuf,
    kept: usize,
    drawn: usize,
}

impl KeptFile {
    pub(crate) fn in_words(&self) -> String {
        let Self { path, kept, drawn } = self;
        format!("{}: {kept} of {} of furniture locked", path.display(), counted(*drawn, "piece"))
    }

    pub(crate) fn answer(&self) -> KeptFurnitureAnswer {
        KeptFurnitureAnswer { path: self.path.display().to_string(), kept: self.kept, drawn: self.drawn }
    }
}

/// Keeps the furniture of one building after the other, and the furniture of each file only once.
pub(crate) struct FurnitureKeeper<'a> {
    catalog: &'a Catalog,
    /// What is chosen of files that hold more.
    choices: Choices,
    overwrite: Overwrite,
    /// File → its furniture.
    drawn: BTreeMap<PathBuf, Vec<DrawnPiece>>,
}

impl<'a> FurnitureKeeper<'a> {
    /// `drawn` is what was read with the plans.
    pub(crate) fn new(
        catalog: &'a Catalog,
        choices: Choices,
        overwrite: Overwrite,
        drawn: BTreeMap<PathBuf, Vec<DrawnPiece>>,
    ) -> Self {
        Self { catalog, choices, overwrite, drawn }
    }

    /// Writes the furniture of a building beside its plan; nothing if none is drawn, or none is kept.
    pub(crate) fn keep(
        &mut self,
        placed: &PlacedBuilding,
        plan: &Path,
        faults: &mut Faults,
    ) -> Option<KeptFile> {
        let source = &placed.source.plan;
        if !self.drawn.contains_key(source) {
            let Catalog { room_words, typologies, .. } = self.catalog;
            let options = PlanOptions::new(room_words).with_planning(typologies, &self.choices);
            let read = drawn_furniture(source, &options);
            let pieces = read.map_err(|found| faults.merge(found)).unwrap_or_default();
            self.drawn.insert(source.clone(), pieces);
        }
        let pieces = &self.drawn[source];
        let drawn = pieces.iter().filter(|piece| piece.building == placed.id).count();
        let kept = keep_drawn(pieces, placed, self.catalog);
        report_left_out(&kept, source, pieces.first().map_or("", |piece| piece.format), faults);
        if kept.kept == 0 {
            return None;
        }
        let path = edits_path(plan);
        match write_text(&path, &write_edits(&kept.file), self.overwrite) {
            Ok(()) => Some(KeptFile { path, kept: kept.kept, drawn }),
            Err(found) => {
                faults.merge(found);
                None
            }
        }
    }
}

/// Warnings about pieces that are not kept: once for each word and each reason.
fn report_left_out(kept: &KeptFurniture, source: &Path, format: &str, faults: &mut Faults) {
    let mut warn = |message: String, hint: String| {
        faults.push(Fault::of_file(source, message).with_hint(hint).as_warning());
    };
    for (word, count) in kept.unknown.iter().take(TOLD_WORDS) {
        let message = format!("no class for furniture \"{word}\": {} left out", counted(*count, "piece"));
        warn(message, format!("add it under pieces.{format} in a room_words.yaml of yours"));
    }
    let others = kept.unknown.len().saturating_sub(TOLD_WORDS);
    if others > 0 {
        let count: usize = kept.unknown.values().skip(TOLD_WORDS).sum();
        let words = counted(others, "other word");
        let message = format!("no class for furniture of {words}: {} left out", counted(count, "piece"));
        warn(message, format!("add them under pieces.{format} in a room_words.yaml of yours"));
    }
    for (reason, count) in &kept.left_out {
        let message = format!("{} of furniture left out: {reason}", counted(*count, "piece"));
        warn(message, "the room is furnished around what is kept".to_owned());
    }
}
