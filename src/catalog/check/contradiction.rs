//! Checks that programmes and the room types that they are for do not contradict.

use std::collections::BTreeMap;

use crate::catalog::ClassIndex;
use crate::catalog::report::{Report, Spot};
use crate::catalog::resolve::{Names, ResolvedProgramme, ResolvedRoomType, ResolvedStyle, StyleLines};

/// Reports what a room type or a style asks for although the room type excludes it, and counts that go by
/// a class that nothing asks for.
pub(crate) fn check_programmes(
    room_types: &[ResolvedRoomType],
    styles: &[ResolvedStyle],
    names: &Names<'_>,
    report: &mut Report<'_>,
) {
    let by_id: BTreeMap<&str, &ResolvedRoomType> =
        room_types.iter().map(|room_type| (room_type.room_type.id.as_str(), room_type)).collect();
    for room_type in room_types {
        let asks = format!("room type \"{}\"", room_type.room_type.id);
        check_excludes(&asks, &room_type.programme, room_type, names, report);
        check_counted(&room_type.programme, &[&room_type.programme], names, report);
    }
    for style in styles {
        for lines in &style.lines {
            let Some(room_type) = by_id.get(lines.room_type.as_str()) else { continue };
            let asks = format!("style \"{}\"", lines.written_by);
            check_excludes(&asks, &lines.programme, room_type, names, report);
            check_counted(&lines.programme, &programme_with(lines, style, room_type), names, report);
        }
    }
}

/// All lines that apply together with these: an addition stands beside the programme.
fn programme_with<'a>(
    lines: &'a StyleLines,
    style: &'a ResolvedStyle,
    room_type: &'a ResolvedRoomType,
) -> Vec<&'a ResolvedProgramme> {
    if !lines.is_addition {
        return vec![&lines.programme];
    }
    let own = style.lines.iter().find(|other| !other.is_addition && other.room_type == lines.room_type);
    vec![own.map_or(&room_type.programme, |own| &own.programme), &lines.programme]
}

fn check_excludes(
    asks: &str,
    programme: &ResolvedProgramme,
    room_type: &ResolvedRoomType,
    names: &Names<'_>,
    report: &mut Report<'_>,
) {
    for named in &programme.named {
        let contradiction = named.classes.iter().find_map(|class| {
            room_type
                .excluded
                .iter()
                .find(|excluded| excluded.classes.contains(class))
                .map(|excluded| (*class, excluded))
        });
        if let Some((class, excluded)) = contradiction {
            let message = format!(
                "{asks} asks for class \"{}\" in room type \"{}\", which excludes \"{}\"",
                names.id(class),
                room_type.room_type.id,
                excluded.word
            );
            let hint = "take the line away, or the word from `excludes` of the room type";
            report.error_with_hint(&named.spot, message, hint);
        }
    }
}

/// A count that goes by a class is always 0 where no line asks for the class.
fn check_counted(
    programme: &ResolvedProgramme,
    together: &[&ResolvedProgramme],
    names: &Names<'_>,
    report: &mut Report<'_>,
) {
    let is_asked = |class: ClassIndex| {
        together.iter().flat_map(|programme| &programme.requests).any(|request| request.asks_for(class))
    };
    let unasked: Vec<&(ClassIndex, Spot)> =
        programme.counted.iter().filter(|(class, _)| !is_asked(*class)).collect();
    for (class, spot) in unasked {
        let message = format!("this count goes by class \"{}\", which no line asks for", names.id(*class));
        report.warning(spot, message, "it is always 0; add a line for the class before it");
    }
}
