//! An explanation for people: one block per object, short lines, figures in columns.

use std::fmt::Write;

use crate::audit::Finding;
use crate::catalog::Side;
use crate::document::printable;
use crate::layout::{MissingStory, ObjectStory, Parent, Placement, Refusal, SearchStory, Wish};

use super::Subject;

/// Obstacles that are named for each reason; the others are counted.
const NAMED_OBSTACLES: usize = 3;

/// Letters before the facts of a block.
const INDENT: &str = "           ";

/// The whole text.
pub(super) fn text(subject: &Subject<'_>) -> String {
    let mut text = heading(subject);
    for (story, placement) in subject.explanation.objects.iter().zip(&subject.furnished.placements) {
        text += "\n";
        text += &object(subject, story, placement);
    }
    if !subject.explanation.missing.is_empty() {
        text += "\nMissing\n";
    }
    for story in &subject.explanation.missing {
        text += "\n";
        text += &missing(story);
    }
    text
}

fn heading(subject: &Subject<'_>) -> String {
    let (found, furnished) = (subject.found, &subject.furnished);
    let room = found.at.room;
    let room_type = subject.sources.catalog.room_types.get(&room.room_type);
    let label = room_type.map_or(room.room_type.as_str(), |room_type| &room_type.label);
    let name = printable(&format!("{} / {} / {}: {label}", found.placed.id, found.at.level.id, room.id));
    let area = room.region.area();
    let style = &subject.sources.catalog.styles[furnished.style].id;
    let mut text = format!("{name}, {area:.1} m²\n  seed {}, style {style}\n", subject.seed);
    text += &home(subject);
    let explanation = &subject.explanation;
    if explanation.attempts == 0 {
        return text + "  rooms of this type are not furnished\n";
    }
    let _ = writeln!(
        text,
        "  arrangement {}, attempt {} of {}: {} of {} pieces placed",
        subject.alternative + 1,
        explanation.kept,
        explanation.attempts,
        furnished.placements.len(),
        furnished.requested
    );
    if !subject.edited.is_empty() {
        let _ = writeln!(text, "  edited after the layout, not explained: {}", subject.edited.join(", "));
    }
    for finding in subject.findings.iter().filter(|finding| finding.objects.is_empty()) {
        let _ = writeln!(text, "  found: {}", show_finding(finding, ""));
    }
    text
}

/// Who lives there, and what the plan calls the room.
fn home(subject: &Subject<'_>) -> String {
    let catalog = &subject.sources.catalog;
    let Some(home) = &subject.found.at.room.home else { return String::new() };
    let kind = catalog.households.kinds.get(&home.household);
    let household = kind.map_or(home.household.as_str(), |kind| &kind.label);
    let label =
        |id: &String| catalog.room_types.get(id).map_or(id.clone(), |room_type| room_type.label.clone());
    let planned = home.planned_type.as_ref().map(|id| format!("; the plan says: {}", label(id)));
    printable(&format!("  household: {household}, {}{}", home.persons, planned.unwrap_or_default())) + "\n"
}

fn object(subject: &Subject<'_>, story: &ObjectStory, placement: &Placement) -> String {
    let label = &subject.sources.catalog.classes[placement.class].label;
    let mut text = printable(&format!("{}  {label}", story.id)) + "\n";
    let (at, angle) = (placement.position, placement.angle.to_degrees().round().rem_euclid(360.0) + 0.0);
    fact(&mut text, "stands", &stands(subject, placement));
    let up =
        if placement.elevation == 0.0 { String::new() } else { format!(", {:.2} m up", placement.elevation) };
    fact(&mut text, "", &format!("at {:.2}, {:.2}{up}, turned {angle:.0}°", at.x, at.y));
    for finding in subject.findings.iter().filter(|finding| finding.objects.contains(&story.id)) {
        fact(&mut text, "found", &show_finding(finding, &story.id));
    }
    if !story.wishes.is_empty() {
        fact(&mut text, "score", &format!("{:+.2}", story.score));
        for wish in &story.wishes {
            fact(&mut text, "", &show_wish(wish));
        }
    }
    search(&mut text, &story.search);
    text
}

/// `tight_use 0.70 m, should be 0.91 m, with wall.0`.
fn show_finding(finding: &Finding, own_id: &str) -> String {
    let unit = finding.quantity.unit();
    let others: Vec<&str> = finding.objects.iter().map(String::as_str).filter(|id| *id != own_id).collect();
    let others = if others.is_empty() { String::new() } else { format!(", with {}", others.join(", ")) };
    let (measured, threshold) = (unit.show(finding.measured), unit.show(finding.threshold));
    format!("{}: {measured}, threshold {threshold}{others}", finding.code.name())
}

fn fact(text: &mut String, name: &str, fact: &str) {
    let _ = writeln!(text, "  {name:<9}{}", printable(fact));
}

/// The phrase for the place of an object at the side of its parent.
fn stands(subject: &Subject<'_>, placement: &Placement) -> String {
    match placement.parent {
        Parent::Floor => "on the floor".to_owned(),
        Parent::Ceiling => "under the ceiling".to_owned(),
        Parent::Wall(wall) => format!("at wall.{wall}"),
        Parent::Opening(index) => {
            format!("at {}", crate::layout::opening_id(&subject.found.at.level.openings[index]))
        }
        Parent::Column(column) => format!("at the {} of column.{column}", placement.side.name()),
        Parent::Object(index) => {
            let parent = &subject.explanation.objects[index].id;
            match placement.side {
                Side::Above => format!("on {parent}"),
                Side::Below => format!("under {parent}"),
                side => format!("at the {} of {parent}", side.name()),
            }
        }
    }
}

/// `+0.21 of 0.50  partly   near sofa.1, 1.90 m`.
fn show_wish(wish: &Wish) -> String {
    if wish.target.is_empty() {
        let degree = if wish.is_met { "good" } else { "bad" };
        return format!("{:+.2}          {degree:<7}  {}", wish.points, wish.about);
    }
    let what = wish.decided_by.as_ref().unwrap_or(&wish.target);
    let degree = match wish.is_met {
        true => "met",
        false if wish.points > 0.0 => "partly",
        false => "not met",
    };
    let mut text = format!("{:+.2} of {:.2}  {degree:<7}  {} {what}", wish.points, wish.weight, wish.about);
    if let Some(distance) = wish.distance {
        let _ = write!(text, ", {distance:.2} m");
    }
    if let Some(angle) = wish.angle {
        let _ = write!(text, ", {angle:.0}° off");
    }
    if wish.decided_by.is_none() && wish.distance.is_none() && wish.about != "not before" {
        text += " (there is none)";
    }
    text
}

fn search(text: &mut String, search: &SearchStory) {
    let refused: u32 = search.refused.iter().map(|refusal| refusal.places).sum();
    let times = match search.searches {
        0 | 1 => String::new(),
        searches => format!(" in {searches} searches"),
    };
    let word = if search.places == 1 { "place" } else { "places" };
    fact(text, "search", &format!("{} {word} tried{times}, {refused} refused", search.places));
    refusals(text, &search.refused);
    if search.was_sent_away {
        fact(text, "", "left a place that closed the only way to a door or a used side");
    }
    if search.was_pushed {
        fact(text, "", "was pushed to a place with more space");
    }
}

/// A line for each reason: how many places, and what stood in the way of most of them.
fn refusals(text: &mut String, refused: &[Refusal]) {
    let width = refused.iter().map(|refusal| refusal.places.to_string().len()).max().unwrap_or(0);
    for refusal in refused {
        let named = refusal.obstacles.iter().take(NAMED_OBSTACLES);
        let mut named: Vec<String> =
            named.map(|obstacle| format!("{} {}", obstacle.name, obstacle.places)).collect();
        if refusal.obstacles.len() > NAMED_OBSTACLES {
            named.push(format!("{} more", refusal.obstacles.len() - NAMED_OBSTACLES));
        }
        let line = format!("{INDENT}{:>width$} {:<10} {}", refusal.places, refusal.reason, named.join(", "));
        let _ = writeln!(text, "{}", line.trim_end());
    }
}

fn missing(story: &MissingStory) -> String {
    let required = if story.is_required { ", required" } else { "" };
    let mut text = format!("{}  {}{required}\n", story.id, story.reason);
    search(&mut text, &story.search);
    if let Some(walls) = &story.walls {
        let refused: u32 = walls.refused.iter().map(|refusal| refusal.places).sum();
        let free = walls.places - refused;
        fact(
            &mut text,
            "walls",
            &format!("{} places along them in the finished room, {free} free", walls.places),
        );
        refusals(&mut text, &walls.refused);
    }
    for (index, parent) in story.parents.iter().enumerate() {
        let side = parent.side.name();
        let name = if index == 0 { "parents" } else { "" };
        fact(
            &mut text,
            name,
            &format!("{} {side}: {} of {} places taken", parent.id, parent.taken, parent.places),
        );
    }
    text
}
