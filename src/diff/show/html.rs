//! A report as one HTML page without scripts and without other files.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::lines::{Line, lines};
use super::{counted, kinds, name, sentence, sign};
use crate::diff::picture::RoomPictures;
use crate::diff::report::{LevelDiff, Presence, Report, RoomDiff};
use crate::document::xml_text;
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
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>Furniture: what changed</title>\n\
         <style>\n{STYLE}\n</style>\n</head>\n<body>\n<h1>Furniture: what changed</h1>\n\
         <p><code>{}</code> → <code>{}</code></p>\n<p>{}</p>\n",
        xml_text(&report.old),
        xml_text(&report.new),
        xml_text(&sentence(report))
    );
    push_counts(&mut page, report);
    push_troubles(&mut page, report);
    push_levels(&mut page, report, limits);
    push_legend(&mut page);
    push_rooms(&mut page, report, pictures, limits.rooms);
    let _ = write!(
        page,
        "<hr>\n<p>{}, structure {}; moved from {} m, turned from {}°.</p>\n</body>\n</html>\n",
        xml_text(&report.program),
        report.diff,
        report.tolerance.metres,
        report.tolerance.degrees
    );
    page
}

fn push_counts(page: &mut String, report: &Report) {
    if report.summary.changes.is_empty() {
        return;
    }
    let heads: String = kinds(report).map(|(kind, _)| format!("<th>{kind}</th>")).collect();
    let counts: String =
        kinds(report).map(|(_, count)| format!("<td class=\"count\">{count}</td>")).collect();
    let _ = writeln!(page, "<table>\n<tr>{heads}</tr>\n<tr>{counts}</tr>\n</table>");
}

fn push_troubles(page: &mut String, report: &Report) {
    for trouble in &report.troubles {
        let hint =
            trouble.hint.as_ref().map_or_else(String::new, |hint| format!("<br>hint: {}", xml_text(hint)));
        let (file, message) = (xml_text(&trouble.file), xml_text(&trouble.message));
        let _ = writeln!(page, "<p class=\"bad\">Cannot be read: <code>{file}</code>: {message}{hint}</p>");
    }
    for (path, state) in &report.shared {
        let _ = writeln!(page, "<p>{} shared file <code>{}</code></p>", sign(*state), xml_text(path));
    }
}

/// A table of all levels, with links to their rooms below.
fn push_levels(page: &mut String, report: &Report, limits: HtmlLimits) {
    if report.levels.is_empty() {
        return;
    }
    page.push_str("<table>\n<tr><th></th><th>level</th><th>rooms</th><th>changes</th></tr>\n");
    let below = shown_rooms(report, limits.rooms).len();
    for (index, level) in report.levels.iter().take(limits.levels).enumerate() {
        let title = xml_text(&name(level));
        let title = if index < below { format!("<a href=\"#level-{index}\">{title}</a>") } else { title };
        let changes = level.all_changes().count();
        let _ = writeln!(
            page,
            "<tr><td class=\"{}\">{}</td><td>{title}</td><td class=\"count\">{}</td>\
             <td class=\"count\">{changes}</td></tr>",
            class_of(sign(level.state)),
            sign(level.state),
            level.rooms.len()
        );
    }
    page.push_str("</table>\n");
    push_left_out(page, report.levels.len(), limits.levels, "level");
}

fn push_legend(page: &mut String) {
    let kinds =
        [(MarkKind::Added, "added"), (MarkKind::Removed, "removed"), (MarkKind::Changed, "moved or changed")];
    let items = kinds.map(|(kind, word)| {
        format!(
            "<span class=\"swatch\" style=\"border-color:{0};background:{0}33\"></span>{word}",
            kind.color()
        )
    });
    let _ = writeln!(page, "<p>Before on the left, after on the right; {}</p>", items.concat());
}

fn push_rooms(
    page: &mut String,
    report: &Report,
    pictures: &BTreeMap<(String, String, String), RoomPictures>,
    most: usize,
) {
    for (index, (level, shown)) in report.levels.iter().zip(shown_rooms(report, most)).enumerate() {
        let _ = writeln!(page, "<h2 id=\"level-{index}\">{}</h2>", xml_text(&name(level)));
        if level.state == Presence::Unreadable {
            page.push_str("<p class=\"bad\">Cannot be compared.</p>\n");
        }
        push_lines(page, &lines(&level.changes));
        for room in level.rooms.iter().take(shown) {
            let key = (level.building.clone(), level.level.clone(), room.room.clone());
            push_room(page, room, pictures.get(&key));
        }
    }
    push_left_out(page, rooms_of(report), most, "room");
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

fn push_room(page: &mut String, room: &RoomDiff, pictures: Option<&RoomPictures>) {
    let (id, room_type) = (xml_text(&room.room), xml_text(&room.room_type));
    let class = class_of(sign(room.state));
    let _ = writeln!(
        page,
        "<h3><span class=\"{class}\">{}</span> {id} <small>({room_type})</small></h3>",
        sign(room.state)
    );
    push_lines(page, &lines(&room.changes));
    let Some(RoomPictures { old, new, .. }) = pictures else { return };
    let side = |svg: &Option<String>| match svg {
        Some(svg) => format!("<div>{svg}</div>"),
        None => "<div><p>not there</p></div>".to_owned(),
    };
    let _ = writeln!(page, "<div class=\"pair\">{}{}</div>", side(old), side(new));
}

fn push_lines(page: &mut String, lines: &[Line]) {
    if lines.is_empty() {
        return;
    }
    page.push_str("<ul>\n");
    for Line { sign, subject, text } in lines {
        let subject =
            if subject.is_empty() { String::new() } else { format!("<code>{}</code> ", xml_text(subject)) };
        let _ = writeln!(
            page,
            "<li><span class=\"{}\">{sign}</span> {subject}{}</li>",
            class_of(sign),
            xml_text(text)
        );
    }
    page.push_str("</ul>\n");
}

fn class_of(sign: &str) -> &'static str {
    match sign {
        "+" => "added",
        "−" => "removed",
        "!" | "?" => "bad",
        _ => "other",
    }
}

fn push_left_out(page: &mut String, count: usize, most: usize, what: &str) {
    if let Some(more) = count.checked_sub(most).filter(|&more| more > 0) {
        let more = counted(more as u64, &format!("more {what}"));
        let _ = writeln!(page, "<p>… and {more} left out; the JSON report has them all.</p>");
    }
}
