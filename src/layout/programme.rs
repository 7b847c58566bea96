//! The programme of a room: which pieces it asks for (sections 4.2 and 6.2: counts depend on room size).

use crate::catalog::{Catalog, Class, ClassIndex, Count, ParentName, ParentRule, Request, RoomType, Style};
use crate::geometry::Point;

use crate::plan::Home;

use super::lattice::full_number;
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
    /// The piece that it stands in for, by index into the room's pieces: it searches only where that found no place.
    pub(crate) substitute_for: Option<usize>,
    /// The class of the pieces that it was counted by, if it does not stand by itself: it waits until one of them is there.
    pub(crate) companion: Option<ClassIndex>,
}

/// The facts about a room that its programme depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site<'a> {
    /// Square metres of floor.
    pub(crate) area: f64,
    /// Windows of the room.
    pub(crate) window_count: u32,
    /// The people that it is for, if it is part of a dwelling.
    pub(crate) home: Option<&'a Home>,
    /// Metres along its longest wall and across.
    pub(crate) extent: Point,
}

/// Draws the pieces of a room, in the order of the programme; then those that stand in for them, each list behind the piece
/// that it is for.
pub(crate) fn pieces(
    catalog: &Catalog,
    style: &Style,
    room_type: &RoomType,
    site: Site<'_>,
    variants: &Variants<'_>,
) -> Vec<Piece> {
    let counts = Counts { drawn: vec![0; catalog.classes.len()], asked: vec![0; catalog.classes.len()] };
    let mut draft = Draft { catalog, style, site, variants, counts, pieces: Vec::new() };
    let mut heads = Vec::new();
    for request in style.programme(room_type) {
        let first = draft.pieces.len();
        draft.add(request, None);
        heads.extend((first..draft.pieces.len()).map(|piece| (piece, request)));
    }
    for (piece, request) in heads {
        for class in draft.add_substitutes(piece, request) {
            let counts_by_it = |request: &&Request| matches!(request.count, Count::PerPiece(counted, _) if stands_for(catalog, class, counted));
            style
                .programme(room_type)
                .filter(counts_by_it)
                .for_each(|request| draft.add(request, Some(class)));
        }
    }
    draft.pieces
}

/// Whether a class is another, or stands in for it.
fn stands_for(catalog: &Catalog, class: ClassIndex, other: ClassIndex) -> bool {
    class == other || catalog.classes[other].stand_ins.contains(&class)
}

/// Whether a class may stand at any wall or anywhere on the floor, as a garden chair does. A rug lies under something.
fn stands_by_itself(class: &Class) -> bool {
    let is_free = |rule: &ParentRule| match rule.parent {
        ParentName::Floor => true,
        ParentName::Wall => rule.tag.is_none(),
        _ => false,
    };
    class.covers.is_empty() && class.parents.iter().any(is_free)
}

/// The pieces of a room that are drawn so far.
struct Draft<'a> {
    catalog: &'a Catalog,
    style: &'a Style,
    site: Site<'a>,
    variants: &'a Variants<'a>,
    counts: Counts,
    pieces: Vec<Piece>,
}

impl Draft<'_> {
    /// Adds the pieces of a line: with `companion`, those for one piece of that class.
    fn add(&mut self, request: &Request, companion: Option<ClassIndex>) {
        let name = &self.catalog.classes[request.classes[0]].id;
        // Lines that begin with the same class share a stream name; their order keeps them apart.
        let line = self.counts.drawn[request.classes[0]];
        let mut stream = self.variants.key.stream(Purpose::Programme, name, line);
        if !applies(request, self.site, &mut stream) {
            return;
        }
        let fitting = self.fitting(request);
        if fitting.is_empty() {
            return;
        }
        // Drawn for the whole line: four chairs of a table are one class.
        let class = fitting[stream.below(fitting.len())];
        let asked = |class: ClassIndex| companion.map_or(self.counts.asked[class], |_| 1);
        let count = count(request, self.style.density, self.site, asked, &mut stream);
        let count = self.in_full_rows(class, request, count);
        let of_line = match request.count {
            Count::PerPiece(counted, _) if !stands_by_itself(&self.catalog.classes[class]) => Some(counted),
            _ => None,
        };
        for _ in 0..count {
            let piece = self.piece(class, request);
            self.pieces.push(Piece { companion: companion.or(of_line), ..piece });
        }
    }

    /// As many lamps as make full rows at the ceiling, where their number goes with the area: five would leave a gap.
    fn in_full_rows(&self, class: ClassIndex, request: &Request, count: u32) -> u32 {
        let class = &self.catalog.classes[class];
        let hangs = class.parents.iter().all(|rule| rule.parent == ParentName::Ceiling);
        match (&class.grid, request.count) {
            (Some(grid), Count::PerArea(_, _, most)) if hangs && count > 1 => {
                let size = class.sizes[0];
                let room = self.site.extent - Point::new(size.width, size.depth);
                full_number(count, grid, room.max(Point::ZERO)).min(most)
            }
            _ => count,
        }
    }

    /// The classes that a line may ask for in the style: a substitute where nothing else goes with it.
    fn fitting(&self, request: &Request) -> Vec<ClassIndex> {
        let classes = &self.catalog.classes;
        let fitting = self.style.fitting(&request.classes, classes);
        match (fitting.is_empty(), request.is_required) {
            (false, _) => fitting,
            // The room is wrong without it, whatever it looks like.
            (true, true) => request.classes.clone(),
            (true, false) => {
                let goes = |class: &&ClassIndex| !self.style.fitting(&[**class], classes).is_empty();
                request.substitutes.iter().find(goes).copied().into_iter().collect()
            }
        }
    }

    /// Adds what stands in for a piece, one after the other, and answers their classes.
    fn add_substitutes(&mut self, piece: usize, request: &Request) -> Vec<ClassIndex> {
        let mut before = piece;
        let mut added = vec![self.pieces[piece].class];
        for &class in &request.substitutes {
            let goes = !self.style.fitting(&[class], &self.catalog.classes).is_empty();
            if goes && !added.contains(&class) {
                let substitute = Piece { substitute_for: Some(before), ..self.piece(class, request) };
                before = self.pieces.len();
                self.pieces.push(substitute);
                added.push(class);
            }
        }
        added.split_off(1)
    }

    fn piece(&mut self, class: ClassIndex, request: &Request) -> Piece {
        let number = self.counts.add(self.catalog, class);
        Piece {
            class,
            number,
            variant: self.variants.draw(&self.catalog.classes[class], number),
            is_required: request.is_required,
            is_fill: request.count.is_fill(),
            substitute_for: None,
            companion: None,
        }
    }
}

/// The pieces of a room with those that are locked: these have the variant that was asked for.
pub(crate) fn add_locked(pieces: &mut Vec<Piece>, locks: &[Lock], catalog: &Catalog) {
    for lock in locks {
        let is_it = |piece: &&mut Piece| piece.class == lock.class && piece.number == lock.number;
        let known = pieces.iter_mut().find(is_it);
        let variant = lock.variant.filter(|&variant| variant < catalog.classes[lock.class].variant_count());
        match (known, variant) {
            (Some(piece), Some(variant)) => piece.variant = variant,
            // A lock without a variant keeps the place only: the look is that of the seed.
            (Some(_), None) => {}
            (None, variant) => pieces.push(Piece {
                class: lock.class,
                number: lock.number,
                variant: variant.unwrap_or(0),
                is_required: false,
                is_fill: false,
                substitute_for: None,
                companion: None,
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
        // Members of a group with the name of a class do for that class: pieces that are counted by it count them too.
        let stood_in_for = groups.filter_map(|group| catalog.class_index(group));
        stood_in_for.filter(|&other| other != class).for_each(|other| self.asked[other] += 1);
        self.asked[class] += 1;
        self.drawn[class] += 1;
        self.drawn[class]
    }
}

fn applies(request: &Request, site: Site<'_>, stream: &mut Stream) -> bool {
    // Drawn even where the line does not apply: the numbers after it stay the same.
    let is_lucky = stream.unit() < request.chance;
    let (least, most) = request.area;
    let is_light = site.window_count > 0 || !request.needs_window;
    is_lucky && site.area >= least && site.area < most && is_light && request.for_whom.includes(site.home)
}

fn count(
    request: &Request,
    density: f64,
    site: Site<'_>,
    asked: impl Fn(ClassIndex) -> u32,
    stream: &mut Stream,
) -> u32 {
    let base = match request.count {
        Count::Fixed(count) | Count::Fill(count) => f64::from(count),
        Count::Range(least, most) => f64::from(stream.count(least, most)),
        Count::PerArea(per_area, least, most) => {
            (site.area * per_area).round().clamp(f64::from(least), f64::from(most))
        }
        Count::FillPerArea(per_area, most) => (site.area * per_area).min(f64::from(most)),
        Count::PerPiece(class, each) => f64::from(asked(class)) * each,
        Count::PerWindow(each) => f64::from(site.window_count) * each,
    };
    // A thin style leaves out what a room can do without; a bathroom keeps its toilet.
    let factor = if request.is_required { 1.0 } else { density };
    let most = request.for_whom.most(site.home).map_or(f64::INFINITY, f64::from);
    // Rounded, not drawn: rooms of a size and style ask for the same, so that a hotel has no odd rooms.
    (base * factor).round().clamp(0.0, most) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{DEFAULT_STYLE, Era, Share, Untidiness};
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
        let (style, room_type) = (&catalog.styles[catalog.default_style], &catalog.room_types["office"]);
        let options = FurnishOptions::new(1, "b");
        let series = Series { at: level.room(0), options: &options, share: Share::Building };
        let variants = Variants { seed: 1, series, key: &key };
        let site = Site { area: 16.0, window_count: 0, home: None, extent: Point::splat(4.0) };
        let pieces = pieces(&catalog, style, room_type, site, &variants);
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
