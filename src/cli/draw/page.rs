//! Furnishes the levels of one file and draws them.

use rayon::prelude::*;

use super::super::arguments::DrawArguments;
use super::super::bake::DEFAULT_SEED;
use super::super::sources::Sources;
use super::chosen::{Page, Subject};
use crate::audit::Finding;
use crate::best::Judged;
use crate::catalog::Catalog;
use crate::draw::{Drawing, draw_level, draw_levels};
use crate::edits::furnish_edited;
use crate::layout::{FurnishOptions, Furnished};

/// The furnished rooms of a level and the findings in each.
type Judgement = (Vec<Furnished>, Vec<Vec<Finding>>);

/// Furnishes levels as `bake` does and draws them.
pub(super) fn draw_page(
    arguments: &DrawArguments,
    sources: &Sources,
    style: Option<&str>,
    page: &Page<'_>,
) -> String {
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    let furnish = |&subject: &Subject<'_>| furnish_level(arguments, sources, (seed, style), subject);
    let judged: Vec<Judgement> = page.iter().map(furnish).collect();
    let drawings: Vec<Drawing<'_>> = page
        .iter()
        .zip(&judged)
        .map(|(subject, judgement)| drawing(arguments, &sources.catalog, seed, (*subject, judgement)))
        .collect();
    match drawings.as_slice() {
        [one] => draw_level(one),
        several => draw_levels(several),
    }
}

fn drawing<'a>(
    arguments: &DrawArguments,
    catalog: &'a Catalog,
    seed: u64,
    ((placed, level), (furnished, findings)): (Subject<'a>, &'a Judgement),
) -> Drawing<'a> {
    Drawing {
        building: &placed.id,
        site: placed.site,
        level,
        furnished,
        findings,
        catalog,
        seed,
        has_clearances: arguments.clearances,
        has_findings: arguments.findings,
        has_legend: true,
    }
}

fn furnish_level(
    arguments: &DrawArguments,
    sources: &Sources,
    (seed, style): (u64, Option<&str>),
    (placed, level): Subject<'_>,
) -> Judgement {
    let rooms = (0..level.rooms.len()).into_par_iter();
    let run = FurnishOptions::new(seed, &placed.id).with_style(style);
    let edits = sources.edits.level(&placed.id, &level.id);
    let furnish =
        |room| furnish_edited((level, room), &sources.catalog, &run, arguments.furnish.effort, edits).judged;
    let judged = |judged: Judged| (judged.furnished, judged.verdict.findings);
    rooms.map(furnish).map(judged).unzip()
}
