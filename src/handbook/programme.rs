//! A programme in short sentences.

use crate::catalog::{Catalog, Count, Request, RoomType};

use super::markdown::number;

/// Which lines of a programme are shown together.
type IsOfKind = fn(&Request) -> bool;

/// The programme of a room type: a line for the pieces without which the room is wrong, one for those that it gets
/// once or a few times, one for those that follow its area, its windows or other pieces.
pub(super) fn programme_lines(catalog: &Catalog, room_type: &RoomType) -> Vec<String> {
    let kinds: [(&str, IsOfKind); 3] = [
        ("Required", |request| request.is_required),
        ("Optional", |request| !request.is_required && !is_repeated(request.count)),
        ("Repeated", |request| !request.is_required && is_repeated(request.count)),
    ];
    let line = |(name, is_of_kind): (&str, IsOfKind)| {
        let pieces = pieces(catalog, room_type, is_of_kind);
        (!pieces.is_empty()).then(|| format!("- {name}: {}\n", pieces.join(", ")))
    };
    kinds.into_iter().filter_map(line).collect()
}

/// Whether the count follows something else.
fn is_repeated(count: Count) -> bool {
    !matches!(count, Count::Fixed(_) | Count::Range(..))
}

/// One text for the lines that ask for the same.
fn pieces(catalog: &Catalog, room_type: &RoomType, is_of_kind: IsOfKind) -> Vec<String> {
    let mut pieces: Vec<(String, Vec<&Request>)> = Vec::new();
    for request in room_type.programme.iter().filter(|request| is_of_kind(request)) {
        let name = name_of(catalog, request);
        match pieces.iter_mut().find(|(known, _)| *known == name) {
            Some((_, requests)) => requests.push(request),
            None => pieces.push((name, vec![request])),
        }
    }
    let show = |(name, requests): (String, Vec<&Request>)| {
        let terms: Vec<String> = match requests.as_slice() {
            [request] => {
                show_count(catalog, request.count).into_iter().chain(show_area(room_type, request)).collect()
            }
            _ => vec![show_counts(catalog, &requests)],
        };
        if terms.is_empty() { name } else { format!("{name} ({})", terms.join(", ")) }
    };
    pieces.into_iter().map(show).collect()
}

/// In which of the usual rooms of the type a line applies, where not in all.
fn show_area(room_type: &RoomType, request: &Request) -> Option<String> {
    let (low, high) = request.area;
    match (low > room_type.area.0, high < room_type.area.1) {
        (true, true) => Some(format!("{} to {} m²", number(low), number(high))),
        (true, false) => Some(format!("from {} m²", number(low))),
        (false, true) => Some(format!("up to {} m²", number(high))),
        (false, false) => None,
    }
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

/// The count of a class that several lines request: they go by other pieces, or apply to rooms of different areas.
fn show_counts(catalog: &Catalog, requests: &[&Request]) -> String {
    let show = |request: &&Request| match request.count {
        Count::PerPiece(..) => show_count(catalog, request.count),
        _ => None,
    };
    match requests.iter().map(show).collect::<Option<Vec<String>>>() {
        Some(mut counts) => {
            counts.dedup();
            counts.join(", ")
        }
        None => "by area".to_owned(),
    }
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
        Count::Fill(_) | Count::FillPerArea(..) => Some("as many as fit".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::builtin_catalog;

    fn request(class: usize, count: Count) -> Request {
        Request {
            classes: vec![class],
            substitutes: Vec::new(),
            count,
            area: (0.0, 1e9),
            is_required: false,
            chance: 1.0,
            needs_window: false,
            for_whom: crate::catalog::ForWhom::default(),
        }
    }

    #[test]
    fn lines_of_one_piece_for_different_areas_are_one() {
        let catalog = builtin_catalog();
        let [desk, chair, shelf, plant] =
            ["desk", "chair", "bookshelf", "plant"].map(|id| catalog.class_index(id).unwrap());
        let programme = vec![
            Request { is_required: true, ..request(desk, Count::Fixed(1)) },
            request(shelf, Count::Fixed(1)),
            request(shelf, Count::Fixed(2)),
            Request { area: (20.0, 1e3), ..request(plant, Count::Range(1, 2)) },
            request(chair, Count::PerPiece(desk, 1.0)),
            request(chair, Count::PerPiece(shelf, 0.5)),
        ];
        let room_type = RoomType { programme, ..catalog.room_types["office"].clone() };
        let lines = programme_lines(catalog, &room_type);
        assert_eq!(
            lines,
            [
                "- Required: Desk\n",
                "- Optional: Bookshelf (by area), House plant (1 to 2, from 20 m²)\n",
                "- Repeated: Chair (1 for each Desk, 0.5 for each Bookshelf)\n"
            ]
        );
    }
}
