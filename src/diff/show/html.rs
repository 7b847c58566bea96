//! A report as one HTML page without scripts and without other files.

use std::collections::BTreeMap;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::lines::{Line, lines};
use super::{counted, kinds, name, sentence, sign};
use crate::diff::picture::RoomPictures;
use crate::diff::report::{LevelDiff, Presence, Report, RoomDiff};
use crate::draw::MarkKind;

/// How much a page shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HtmlLimits {
    /// Rooms with pictures and lists: a room takes about 60 KB. What is beyond is counted.
    pub rooms: usize,
    /// Levels in the table.
    pub levels: usize,
}

impl Default for HtmlLimits {
    fn default() -> Self {
        Self { rooms: 100, levels: 1000 }
    }
}

const STYLE: &str = "\
body { font: 15px/1.45 Helvetica, Arial, sans-serif; color: #222; margin: 2rem auto; max-width: 1240px; padding: 0 1rem }
h1 { font-size: 1.5rem } h2 { font-size: 1.2rem; border-bottom: 1px solid #ccc; margin-top: 2.2rem }
h3 { font-size: 1rem; margin: 1.4rem 0 .3rem } code { background: #f2f2f0; padding: 0 .25em; border-radius: 3px }
table { border-collapse: collapse; margin: .8rem 0 } td, th { border: 1px solid #ddd; padding: .2rem .6rem; text-align: left }
td.count { text-align: right } ul { list-style: none; padding-left: .5rem; margin: .3rem 0 }
.pair { display: flex; gap: 1rem; flex-wrap: wrap } .pair > div { flex: 1 1 420px; min-width: 0; border: 1px solid #ddd }
.pair svg { width: 100%; height: auto; display: block } .pair p { color: #777; text-align: center; padding: 3rem 0 }
.added { color: #2b8a3e } .removed { color: #c92a2a } .other { color: #b35c00 } .bad { color: #c92a2a; font-weight: bold }
.swatch { display: inline-block; width: .8em; height: .8em; margin: 0 .3em 0 1em; border: 2px solid }";

/// The page. `pictures` are by building, level and room.
#[must_use]
pub fn html(
    report: &Report,
    pictures: &BTreeMap<(String, String, String), RoomPictures>,
    limits: HtmlLimits,
) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width";
                title { "Furniture: what changed" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "Furniture: what changed" }
                p { code { (report.old) } " → " code { (report.new) } }
                p { (sentence(report)) }
                (counts(report))
                (troubles(report))
                (levels(report, limits))
                (legend())
                (rooms(report, pictures, limits.rooms))
                hr;
                p {
                    (report.program) ", structure " (report.diff) "; moved from " (report.tolerance.metres) " m, turned from "
                    (report.tolerance.degrees) "°."
                }
            }
        }
    };
    page.into_string()
}

fn counts(report: &Report) -> Markup {
    html! {
        @if !report.summary.changes.is_empty() {
            table {
                tr { @for (kind, _) in kinds(report) { th { (kind) } } }
                tr { @for (_, count) in kinds(report) { td.count { (count) } } }
            }
        }
    }
}

fn troubles(report: &Report) -> Markup {
    html! {
        @for trouble in &report.troubles {
            p.bad {
                "Cannot be read: " code { (trouble.file) } ": " (trouble.message)
                @if let Some(hint) = &trouble.hint { br; "hint: " (hint) }
            }
        }
        @for (path, state) in &report.shared {
            p { (sign(*state)) " shared file " code { (path) } }
        }
    }
}

/// A table of all levels, with links to their rooms below.
fn levels(report: &Report, limits: HtmlLimits) -> Markup {
    let below = shown_rooms(report, limits.rooms).len();
    html! {
        @if !report.levels.is_empty() {
            table {
                tr { th {} th { "level" } th { "rooms" } th { "changes" } }
                @for (index, level) in report.levels.iter().take(limits.levels).enumerate() {
                    tr {
                        td class=(class_of(sign(level.state))) { (sign(level.state)) }
                        td {
                            @if index < below { a href={ "#level-" (index) } { (name(level)) } } @else { (name(level)) }
                        }
                        td.count { (level.rooms.len()) }
                        td.count { (level.all_changes().count()) }
                    }
                }
            }
            (left_out(report.levels.len(), limits.levels, "level"))
        }
    }
}

fn legend() -> Markup {
    let kinds =
        [(MarkKind::Added, "added"), (MarkKind::Removed, "removed"), (MarkKind::Changed, "moved or changed")];
    html! {
        p {
            "Before on the left, after on the right; "
            @for (kind, word) in kinds {
                span.swatch style={ "border-color:" (kind.color()) ";background:" (kind.color()) "33" } {} (word)
            }
        }
    }
}

fn rooms(
    report: &Report,
    pictures: &BTreeMap<(String, String, String), RoomPictures>,
    most: usize,
) -> Markup {
    let picture = |level: &LevelDiff, room: &RoomDiff| {
        pictures.get(&(level.building.clone(), level.level.clone(), room.room.clone()))
    };
    html! {
        @for (index, (level, shown)) in report.levels.iter().zip(shown_rooms(report, most)).enumerate() {
            h2 id={ "level-" (index) } { (name(level)) }
            @if level.state == Presence::Unreadable { p.bad { "Cannot be compared." } }
            (list(&lines(&level.changes)))
            @for room in level.rooms.iter().take(shown) { (room_section(room, picture(level, room))) }
        }
        (left_out(rooms_of(report), most, "room"))
    }
}

/// How many rooms a page shows of each level, for as many levels as it shows. A level without rooms takes the place of
/// one.
#[must_use]
pub fn shown_rooms(report: &Report, most: usize) -> Vec<usize> {
    let mut left = most;
    let shown = report.levels.iter().map_while(|level| {
        let shown = level.rooms.len().min(left);
        let has_place = left > 0;
        left = left.saturating_sub(level.rooms.len().max(1));
        has_place.then_some(shown)
    });
    shown.collect()
}

/// Rooms of all levels; a level without any counts as one.
fn rooms_of(report: &Report) -> usize {
    report.levels.iter().map(|level: &LevelDiff| level.rooms.len().max(1)).sum()
}

fn room_section(room: &RoomDiff, pictures: Option<&RoomPictures>) -> Markup {
    html! {
        h3 {
            span class=(class_of(sign(room.state))) { (sign(room.state)) } " " (room.room) " "
            small { "(" (room.room_type) ")" }
        }
        (list(&lines(&room.changes)))
        @if let Some(RoomPictures { old, new, .. }) = pictures {
            div.pair { (side(old.as_deref())) (side(new.as_deref())) }
        }
    }
}

/// The drawings are SVG of our own, whose texts are escaped where they are drawn.
fn side(svg: Option<&str>) -> Markup {
    html! {
        div { @if let Some(svg) = svg { (PreEscaped(svg)) } @else { p { "not there" } } }
    }
}

fn list(lines: &[Line]) -> Markup {
    html! {
        @if !lines.is_empty() {
            ul {
                @for Line { sign, subject, text } in lines {
                    li {
                        span class=(class_of(sign)) { (sign) } " "
                        @if !subject.is_empty() { code { (subject) } " " }
                        (text)
                    }
                }
            }
        }
    }
}

fn class_of(sign: &str) -> &'static str {
    match sign {
        "+" => "added",
        "−" => "removed",
        "!" | "?" => "bad",
        _ => "other",
    }
}

fn left_out(count: usize, most: usize, what: &str) -> Markup {
    let more = count.saturating_sub(most);
    html! {
        @if more > 0 {
            p { "… and " (counted(more as u64, &format!("more {what}"))) " left out; the JSON report has them all." }
        }
    }
}
