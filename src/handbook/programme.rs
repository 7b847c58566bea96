//! A programme in short.

use crate::catalog::{Catalog, Count, Request, RoomType};

use super::markdown::number;

/// Which lines of a programme are shown together.
type IsOfKind = fn(&Request) -> bool;

/// What a room type asks for: a line for the pieces without which the room is wrong, one for those that it gets
/// once or a few times, one for those that follow its area, its windows or other pieces.
pub(super) fn programme_lines(catalog: &Catalog, room_type: &RoomType) -> Vec<String> {
    let kinds: [(&str, IsOfKind); 3] = [
        ("Required", |request| request.is_required),
        ("Optional", |request| !request.is_required && !is_repeated(request.count)),
        ("Repeated", |request| !request.is_required && is_repeated(request.count)),
    ];
    let line = |(name, is_of_kind): (&str, IsOfKind)| {
        let pieces = pieces(catalog, room_type.programme.iter().filter(|request| is_of_kind(request)));
        (!pieces.is_empty()).then(|| format!("- {name}: {}\n", pieces.join(", ")))
    };
    kinds.into_iter().filter_map(line).collect()
}

/// Whether the count follows something else.
fn is_repeated(count: Count) -> bool {
    !matches!(count, Count::Fixed(_) | Count::Range(..))
}

/// One text for the lines that ask for the same.
fn pieces<'a>(catalog: &Catalog, requests: impl Iterator<Item = &'a Request>) -> Vec<String> {
    let mut pieces: Vec<(String, Vec<Count>)> = Vec::new();
    for request in requests {
        let name = name_of(catalog, request);
        match pieces.iter_mut().find(|(known, _)| *known == name) {
            Some((_, counts)) if counts.contains(&request.count) => {}
            Some((_, counts)) => counts.push(request.count),
            None => pieces.push((name, vec![request.count])),
        }
    }
    let show = |(name, counts): (String, Vec<Count>)| match show_counts(catalog, &counts) {
        Some(count) => format!("{name} ({count})"),
        None => name,
    };
    pieces.into_iter().map(show).collect()
}

fn name_of(catalog: &Catalog, request: &Request) -> String {
    let mut labels: Vec<&str> = Vec::new();
    for &class in &request.classes {
        let label = catalog.classes[class].label.as_str();
        if !labels.contains(&label) {
            labels.push(label);
        }
    }
    labels.join(" or ")
}

/// What several lines ask for: they go by other pieces, or apply to rooms of different areas.
fn show_counts(catalog: &Catalog, counts: &[Count]) -> Option<String> {
    if let [count] = counts {
        return show_count(catalog, *count);
    }
    let parent = |count: &Count| match count {
        Count::PerPiece(class, each) => Some((number(*each), catalog.classes[*class].label.as_str())),
        _ => None,
    };
    let Some(parents) = counts.iter().map(parent).collect::<Option<Vec<_>>>() else {
        return Some("by area".to_owned());
    };
    let show = |(each, label): &(String, &str)| format!("{each} for each {label}");
    Some(parents.iter().map(show).collect::<Vec<_>>().join(", "))
}

/// How many, where it is not one.
fn show_count(catalog: &Catalog, count: Count) -> Option<String> {
    match count {
        Count::Fixed(1) => None,
        Count::Fixed(count) => Some(count.to_string()),
        Count::Range(least, most) => Some(format!("{least} to {most}")),
        Count::PerArea(..) => Some("by area".to_owned()),
        Count::PerPiece(class, each) => {
            Some(format!("{} for each {}", number(each), catalog.classes[class].label))
        }
        Count::PerWindow(each) => Some(format!("{} for each window", number(each))),
        Count::Fill(_) => Some("as many as fit".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::load_catalog;

    fn request(class: usize, count: Count) -> Request {
        Request {
            classes: vec![class],
            count,
            area: (0.0, 1e9),
            is_required: false,
            chance: 1.0,
            needs_window: false,
        }
    }

    #[test]
    fn lines_of_one_piece_for_different_areas_are_one() {
        let catalog = load_catalog(&[]).unwrap().value;
        let [desk, chair, shelf] = ["desk", "chair", "bookshelf"].map(|id| catalog.class_index(id).unwrap());
        let programme = vec![
            Request { is_required: true, ..request(desk, Count::Fixed(1)) },
            request(shelf, Count::Fixed(1)),
            request(shelf, Count::Fixed(2)),
            request(chair, Count::PerPiece(desk, 1.0)),
            request(chair, Count::PerPiece(shelf, 0.5)),
        ];
        let room_type = RoomType { programme, ..catalog.room_types["office"].clone() };
        let lines = programme_lines(&catalog, &room_type);
        assert_eq!(
            lines,
            [
                "- Required: Desk\n",
                "- Optional: Bookshelf (by area)\n",
                "- Repeated: Chair (1 for each Desk, 0.5 for each Bookshelf)\n"
            ]
        );
    }
}
