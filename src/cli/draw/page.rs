//! Furnishes the levels of one file and draws them.

use rayon::prelude::*;

use super::super::arguments::DrawArguments;
use super::super::bake::DEFAULT_SEED;
use super::chosen::{Page, Subject};
use crate::audit::Finding;
use crate::catalog::Catalog;
use crate::draw::{Drawing, draw_level, draw_levels};
use crate::edits::{Finished, Misfit, furnish_edited};
use crate::layout::{FurnishOptions, Furnished};
use crate::project::Project;

/// The furnished rooms of a level, and the findings and the edits that do not fit in each.
struct Judgement {
    furnished: Vec<Furnished>,
    findings: Vec<Vec<Finding>>,
    misfits: Vec<Misfit>,
}

/// Furnishes levels as `bake` does and draws them; edits that do not fit come beside the drawing.
pub(super) fn draw_page(
    arguments: &DrawArguments,
    sources: &Project,
    style: Option<&str>,
    page: &Page<'_>,
) -> (String, Vec<Misfit>) {
    let seed = arguments.furnish.seed.or(sources.settings.seed).unwrap_or(DEFAULT_SEED);
    let furnish = |&subject: &Subject<'_>| furnish_level(arguments, sources, seed, style, subject);
    let judged: Vec<Judgement> = page.iter().map(furnish).collect();
    let drawings: Vec<Drawing<'_>> = page
        .iter()
        .zip(&judged)
        .map(|(subject, judgement)| drawing(arguments, &sources.catalog, seed, *subject, judgement))
        .collect();
    let svg = match drawings.as_slice() {
        [one] => draw_level(one),
        several => draw_levels(several),
    };
    (svg, judged.into_iter().flat_map(|level| level.misfits).collect())
}

fn drawing<'a>(
    arguments: &DrawArguments,
    catalog: &'a Catalog,
    seed: u64,
    subject: Subject<'a>,
    judged: &'a Judgement,
) -> Drawing<'a> {
    let Subject { placed, level } = subject;
    Drawing {
        building: &placed.id,
        site: placed.site,
        level,
        furnished: &judged.furnished,
        findings: &judged.findings,
        catalog,
        seed,
        has_clearances: arguments.clearances,
        has_findings: arguments.findings,
        has_legend: true,
    }
}

fn furnish_level(
    arguments: &DrawArguments,
    sources: &Project,
    seed: u64,
    style: Option<&str>,
    subject: Subject<'_>,
) -> Judgement {
    let Subject { placed, level } = subject;
    let rooms = (0..level.rooms.len()).into_par_iter();
    let run = FurnishOptions::new(seed, &placed.id).with_style(style);
    let edits = sources.edits.level(&placed.id, &level.id);
    let furnish =
        |room| furnish_edited(level.room(room), &sources.catalog, &run, arguments.furnish.effort, edits);
    let finished: Vec<Finished> = rooms.map(furnish).collect();
    let mut judgement = Judgement { furnished: Vec::new(), findings: Vec::new(), misfits: Vec::new() };
    for Finished { judged, misfits } in finished {
        judgement.furnished.push(judged.furnished);
        judgement.findings.push(judged.verdict.findings);
        judgement.misfits.extend(misfits);
    }
    judgement
}
