//! The programme of a room: which pieces it asks for (sections 4.2 and 6.2: counts depend on room size).

use crate::catalog::{Catalog, ClassIndex, Count, Request, RoomType, Style};

use super::lock::Lock;
use super::seed::{Purpose, Stream};
use super::variant::Variants;

/// One piece that is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Index into the catalogue's classes.
    pub(crate) class: ClassIndex,
    /// Counts the pieces of a class from 1.
    pub(crate) number: u32,
    /// Which of the class's variants.
    pub(crate) variant: u32,
    /// Whether the room is wrong without it.
    pub(crate) is_required: bool,
    /// Whether it only fills what room is left and is not missed.
    pub(crate) is_fill: bool,
}

/// What a programme may look at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site {
    /// Square metres of floor.
    pub(crate) area: f64,
    /// Windows of the room.
    pub(crate) window_count: u32,
}

/// Draws the pieces of a room, in the order of the programme.
pub(crate) fn pieces(
    catalog: &Catalog,
    (style, room_type): (&Style, &RoomType),
    site: Site,
    variants: &Variants<'_>,
) -> Vec<Piece> {
    let mut counts = Counts { drawn: vec![0; catalog.classes.len()], asked: vec![0; catalog.classes.len()] };
    let mut pieces = Vec::new();
    for request in style.programme(room_type) {
        let name = &catalog.classes[request.classes[0]].id;
        // Lines that begin with the same class share a stream name; their order keeps them apart.
        let line = counts.drawn[request.classes[0]];
        let mut stream = variants.key.stream(Purpose::Programme, name, line);
        if !applies(request, site, &mut stream) {
            continue;
        }
        let mut fitting = style.fitting(&request.classes, &catalog.classes);
        if fitting.is_empty() && request.is_required {
            // The room is wrong without it, whatever it looks like.
            fitting.clone_from(&request.classes);
        }
        if fitting.is_empty() {
            continue;
        }
        let class = fitting[stream.below(fitting.len())];
        let count = count(request, style.density, site, &counts.asked, &mut stream);
        for _ in 0..count {
            let number = counts.add(catalog, class);
            pieces.push(Piece {
                class,
                number,
                variant: variants.draw(&catalog.classes[class], number),
                is_required: request.is_required,
                is_fill: matches!(request.count, Count::Fill(_)),
            });
        }
    }
    pieces
}

/// The pieces of a room with those that are locked: these have the variant that was asked for.
pub(crate) fn add_locked(pieces: &mut Vec<Piece>, locks: &[Lock], catalog: &Catalog) {
    for lock in locks {
        let is_it = |piece: &&mut Piece| piece.class == lock.class && piece.number == lock.number;
        let known = pieces.iter_mut().find(is_it);
        let variant = lock.variant.filter(|&variant| variant < catalog.classes[lock.class].variant_count());
        match (known, variant) {
            (Some(piece), Some(variant)) => piece.variant = variant,
            (Some(_), None) => {}
            (None, variant) => pieces.push(Piece {
                class: lock.class,
                number: lock.number,
                variant: variant.unwrap_or(0),
                is_required: false,
                is_fill: false,
            }),
        }
    }
}

/// How many pieces there are so far, by class.
struct Counts {
    /// Of the class itself.
    drawn: Vec<u32>,
    /// Those of classes that stand in for it too: they are in a group of its name.
    asked: Vec<u32>,
}

impl Counts {
    /// Adds a piece and answers its number in its class.
    fn add(&mut self, catalog: &Catalog, class: ClassIndex) -> u32 {
        let groups = catalog.classes[class].groups.iter();
        let stood_in_for = groups.filter_map(|group| catalog.class_index(group));
        stood_in_for.filter(|&other| other != class).for_each(|other| self.asked[other] += 1);
        self.asked[class] += 1;
        self.drawn[class] += 1;
        self.drawn[class]
    }
}

fn applies(request: &Request, site: Site, stream: &mut Stream) -> bool {
    // Drawn even where the line does not apply: the numbers after it stay the same.
    let is_lucky = stream.unit() < request.chance;
    let (least, most) = request.area;
    is_lucky && site.area >= least && site.area < most && (site.window_count > 0 || !request.needs_window)
}

fn count(request: &Request, density: f64, site: Site, counts: &[u32], stream: &mut Stream) -> u32 {
    let base = match request.count {
        Count::Fixed(count) | Count::Fill(count) => f64::from(count),
        Count::Range(least, most) => f64::from(stream.count(least, most)),
        Count::PerArea(per_area, least, most) => {
            (site.area * per_area).round().clamp(f64::from(least), f64::from(most))
        }
        Count::PerPiece(class, each) => f64::from(counts[class]) * each,
        Count::PerWindow(each) => f64::from(site.window_count) * each,
    };
    let factor = if request.is_required { 1.0 } else { density };
    (base * factor).round().max(0.0) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Class, DEFAULT_STYLE, Era, Share, Untidiness};
    use crate::layout::FurnishOptions;
    use crate::layout::choice::Series;
    use crate::layout::seed::RoomKey;
    use crate::layout::tests::{catalog, level};
    use crate::recipes::find;

    /// The pieces of an office that asks for a chair, in a style of an era, where chairs are of these eras and stools, which
    /// stand in for them, of those.
    fn chairs(style: Option<Era>, chair: &[Era], stool: &[Era]) -> Vec<String> {
        let mut catalog = catalog(&[(0, Count::Fixed(1))], Untidiness::default());
        catalog.classes[0].eras = chair.to_vec();
        let groups = vec!["chair".to_owned()];
        let size = catalog.classes[0].sizes[0];
        catalog.classes.push(Class {
            groups,
            eras: stool.to_vec(),
            ..Class::plain("stool", vec![size], find("stool").unwrap())
        });
        let programme = &mut catalog.room_types.get_mut("office").unwrap().programme;
        programme[0].classes = vec![0, 5];
        programme.push(Request { classes: vec![2], count: Count::PerPiece(0, 1.0), ..programme[0].clone() });
        catalog.styles.get_mut(DEFAULT_STYLE).unwrap().era = style;
        let level = level(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let key = RoomKey::new(1, "b", level.room(0));
        let room = (&catalog.styles[DEFAULT_STYLE], &catalog.room_types["office"]);
        let options = FurnishOptions::new(1, "b");
        let series = Series { at: level.room(0), options: &options, share: Share::Building };
        let variants = Variants { seed: 1, series, key: &key };
        let pieces = pieces(&catalog, room, Site { area: 16.0, window_count: 0 }, &variants);
        pieces.iter().map(|piece| catalog.classes[piece.class].id.clone()).collect()
    }

    #[test]
    fn pieces_are_of_the_era_of_their_style() {
        let (old, new) = (Era::Historic, Era::Contemporary);
        assert_eq!(chairs(Some(old), &[], &[old]), ["stool", "lamp"], "made for it, and counted as a chair");
        assert_eq!(chairs(Some(new), &[], &[old]), ["chair", "lamp"]);
        assert_eq!(
            chairs(None, &[], &[old]),
            ["chair", "lamp"],
            "a style that names no era takes what is of none"
        );
        assert_eq!(chairs(None, &[new], &[new, old])[1], "lamp", "or else anything");
        assert!(
            chairs(Some(old), &[new], &[new]).is_empty(),
            "a line without anything that goes with it asks for nothing"
        );
    }
}
