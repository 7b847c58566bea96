//! Reports for people: text, Markdown for a pull request, an HTML page.

mod html;
mod lines;
mod markdown;
mod text;

pub use html::{HtmlLimits, html, shown_rooms};
pub use markdown::markdown;
pub use text::text;

use crate::document::counted;

use super::report::{LevelCounts, LevelDiff, Presence, Report};

/// One sentence about all levels.
fn sentence(report: &Report) -> String {
    let LevelCounts { identical, changed, added, removed, unreadable } = report.summary.levels;
    let all = identical + changed + added + removed + unreadable;
    if identical == all && report.shared.is_empty() {
        return format!("{}, no difference.", counted(all, "level"));
    }
    let parts = [
        (changed, "changed"),
        (added, "added"),
        (removed, "removed"),
        (unreadable, "not readable"),
        (identical, "identical"),
    ];
    let words: Vec<String> =
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, word)| format!("{count} {word}")).collect();
    let rooms = match report.summary.rooms {
        0 => String::new(),
        count => format!("; {} changed", counted(count, "room")),
    };
    format!("{}: {}{rooms}.", counted(all, "level"), words.join(", "))
}

/// Counts of the changes by kind: `moved 12`.
fn kinds(report: &Report) -> impl Iterator<Item = (&'static str, u64)> + '_ {
    report.summary.changes.iter().map(|(kind, count)| (kind.name(), *count))
}

/// The sign before a level, room or file that was added, removed or changed.
fn sign(state: Presence) -> &'static str {
    match state {
        Presence::Added => "+",
        Presence::Removed => "−",
        Presence::Changed => "~",
        Presence::Unreadable => "?",
    }
}

/// Building and level, as people read them; a file that cannot be read names neither.
fn name(level: &LevelDiff) -> String {
    if level.building.is_empty() && level.level.is_empty() {
        return "one of the files".to_owned();
    }
    format!("{} / {}", level.building, level.level)
}
