//! Fills the rows of a spine with rooms: which room in which row, in which order, and how wide.

use crate::layout::seed::Stream;

use super::hall::{Hall, shorten};
use super::spine::Row;
use super::typology::{Light, RoomNeeds};

/// Metres of border with the hall that a door needs: the door, its frame, and a hand's breadth beside it.
pub(super) const DOOR_STRETCH: f64 = 1.05;
/// Metres of outer wall that a window needs.
pub(super) const WINDOW_STRETCH: f64 = 1.0;
/// How much larger or smaller than wished all rooms of a row may be.
const ROW_SCALE: (f64, f64) = (0.5, 3.2);
/// Metres of outer wall with light for each room that needs windows, for any way of dividing it.
pub(super) const LIGHT_EACH: f64 = 1.6;
/// Metres of width for the walls of a room, and for places that are rounded.
const MARGIN: f64 = 0.15;
/// Metres by which a slice is wider and deeper than its room needs: rows are not quite rectangles.
const MORE_THAN_NEEDED: f64 = 0.1;
/// Least width of a room that ends before the outer wall, beside the side of a square of its size.
const INNER_WIDTH: f64 = 0.75;
/// Longer rooms than this many times their width are corridors to look at.
const SLENDER: f64 = 2.0;
/// Cost of each metre that a room lacks of the width at which it is good to furnish: a bedroom that is too narrow for a double bed
/// is worse than a hall that is two metres longer.
const NARROW_COST: f64 = 4.0;

/// Of its share, how much a room gets at most so that it is good to furnish. Larger: large bedrooms beside small living rooms.
const WIDENED: f64 = 1.4;
/// Of their share, how much the rooms beside it keep at least. Larger: more bedrooms stay narrow.
const NARROWED: f64 = 0.8;

/// A room that is wished for.
#[derive(Clone, Debug)]
pub(super) struct Wish<'a> {
    /// Id of its room type.
    pub(super) room_type: &'a str,
    /// Square metres.
    pub(super) area: f64,
    /// What such rooms need.
    pub(super) needs: &'a RoomNeeds,
}

impl Wish<'_> {
    /// Metres along a row and across it that its room has at least.
    fn least(&self) -> f64 {
        self.needs.width + MORE_THAN_NEEDED
    }

    /// Metres of outer wall that its room usually takes.
    fn stretch(&self) -> f64 {
        0.8 * self.area.sqrt()
    }
}

/// A room's place in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slice {
    /// Index of the wish.
    pub(super) wish: usize,
    /// Index of the row.
    pub(super) row: usize,
    /// From where to where along the strip.
    pub(super) from: f64,
    /// See `from`.
    pub(super) to: f64,
    /// Whether it borders on the strip so far that a door may lead there.
    pub(super) is_at_strip: bool,
    /// Whether its door leads to the hall: else to another room.
    pub(super) is_at_hall: bool,
}

/// Rooms in rows.
#[derive(Clone, Debug)]
pub(super) struct Filling {
    /// The slices, row by row, in order along the strip.
    pub(super) slices: Vec<Slice>,
    /// How far it is from what was wished for: 0 is perfect.
    pub(super) cost: f64,
    /// From where to where the hall reaches along the strip, where it may end before that does.
    pub(super) hall: Option<(f64, f64)>,
    /// What that costs.
    pub(super) hall_cost: f64,
}

impl Filling {
    fn total(&self) -> f64 {
        self.cost + self.hall_cost
    }
}

/// What rooms are set into.
#[derive(Clone, Copy)]
pub(super) struct Floor<'a> {
    /// The rows.
    pub(super) rows: &'a [Row],
    /// The hall between them, where it may end before the strip does.
    pub(super) hall: Option<Hall<'a>>,
}

/// The best of several ways to fill the rows; `None` if none keeps to what rooms need.
pub(super) fn fill(
    floor: Floor<'_>,
    wanted: &Wanted<'_>,
    tries: u32,
    stream: &mut Stream,
) -> Option<Filling> {
    if floor.rows.is_empty() || floor.rows.len() > wanted.wishes.len() {
        return None;
    }
    let mut ways = Ways::of(floor, wanted)?;
    let mut best: Option<Filling> = None;
    for attempt in 0..tries {
        let limit = best.as_ref().map_or(f64::INFINITY, Filling::total);
        let way = if ways.shuffle(stream) { ways.place(limit) } else { None };
        if let Some(way) = way.filter(|way| best.is_none() || way.total() < limit) {
            best = Some(way);
        }
        // Where nothing came out so far, hardly anything will.
        if best.is_none() && attempt >= tries / 2 {
            return None;
        }
    }
    best
}

/// How many rooms that take these stretches, rising, have light behind so many metres of outer wall at most.
fn housed_behind(length: f64, stretches: &[f64]) -> usize {
    let mut rest = length;
    let has_light = |stretch: &&f64| {
        let is_lit = rest >= WINDOW_STRETCH;
        rest -= **stretch;
        is_lit
    };
    stretches.iter().take_while(has_light).count()
}

/// A row with the figures that each way to fill it asks for.
struct Place<'a> {
    row: &'a Row,
    area: f64,
    length: f64,
    depth: f64,
    /// Metres of outer wall with light.
    light: f64,
    /// Square metres of wishes that are its share.
    share: f64,
}

/// The figures of a wish.
struct Want {
    area: f64,
    least: f64,
    stretch: f64,
    needs_light: bool,
    /// Metres along the row that a room which needs no light has at least.
    inner_width: f64,
    /// Metres along the row at which it is good to furnish.
    good_width: Option<f64>,
}

impl Want {
    fn of(wish: &Wish<'_>) -> Self {
        let width = wish.needs.width + MARGIN;
        // A room that ends before the outer wall is not much deeper than it is wide.
        let inner_width = if wish.needs.inner { width.max(INNER_WIDTH * wish.area.sqrt()) } else { width };
        let needs_light = wish.needs.light == Light::Required;
        let good_width = wish.needs.good_width.map(|good| good + MARGIN);
        Self {
            area: wish.area,
            least: wish.least(),
            stretch: wish.stretch(),
            needs_light,
            inner_width,
            good_width,
        }
    }
}

/// What is left of a row while wishes are dealt out.
#[derive(Clone, Copy)]
struct Rest {
    room: f64,
    light: f64,
    free: f64,
}

/// The wishes of a dwelling, with what each way to divide its ground asks of them.
pub(super) struct Wanted<'a> {
    wishes: &'a [Wish<'a>],
    wants: Vec<Want>,
    /// Metres of outer wall of those that need light, rising.
    stretches: Vec<f64>,
    /// Square metres of all.
    area: f64,
}

impl<'a> Wanted<'a> {
    /// Of some wishes.
    pub(super) fn of(wishes: &'a [Wish<'a>]) -> Self {
        let wants: Vec<Want> = wishes.iter().map(Want::of).collect();
        let needing = wants.iter().filter(|want| want.needs_light);
        let mut stretches: Vec<f64> = needing.map(|want| want.stretch).collect();
        stretches.sort_by(f64::total_cmp);
        let area = wants.iter().map(|want| want.area).sum();
        Self { wishes, wants, stretches, area }
    }
}

/// Ways to fill rows with wishes, one after the other.
struct Ways<'a> {
    wishes: &'a [Wish<'a>],
    hall: Option<Hall<'a>>,
    places: Vec<Place<'a>>,
    wants: &'a [Want],
    /// The wishes in the order in which they are dealt out.
    order: Vec<(f64, usize)>,
    rests: Vec<Rest>,
    /// By row: its wishes in order.
    chosen: Vec<Vec<usize>>,
    slices: Vec<Slice>,
    /// By slice: where it borders on the strip.
    contacts: Vec<Option<(f64, f64)>>,
}

impl<'a> Ways<'a> {
    /// `None` where no way can be sound.
    fn of(Floor { rows, hall }: Floor<'a>, wanted: &'a Wanted<'a>) -> Option<Self> {
        let Wanted { wishes, wants, stretches, area: total } = wanted;
        // Rooms that need windows share what light there is.
        let lengths = rows.iter().map(|row| row.light_between(row.from - 1.0, row.to + 1.0));
        let available: f64 = rows.iter().map(Row::area).sum();
        let place = |(row, light): (&'a Row, f64)| Place {
            row,
            area: row.area(),
            length: row.length(),
            depth: row.depth(),
            light,
            share: row.area() * total / available,
        };
        let places: Vec<Place<'a>> = rows.iter().zip(lengths).map(place).collect();
        let housed: usize = places.iter().map(|place| housed_behind(place.light, stretches)).sum();
        let light: f64 = places.iter().map(|place| place.light).sum();
        if housed < stretches.len() || light < LIGHT_EACH * stretches.len() as f64 {
            return None;
        }
        // Each row takes one of them at least.
        let suits = |place: &Place<'_>, want: &Want| want.least <= place.depth.min(place.length);
        let is_used = |place: &Place<'_>| wants.iter().any(|want| suits(place, want));
        let is_housed = |want: &Want| places.iter().any(|place| suits(place, want));
        if !places.iter().all(is_used) || !wants.iter().all(is_housed) {
            return None;
        }
        let chosen = vec![Vec::with_capacity(wishes.len()); rows.len()];
        let (order, slices, contacts) =
            (Vec::with_capacity(wishes.len()), Vec::with_capacity(wishes.len()), Vec::new());
        Some(Self { wishes, hall, places, wants, order, rests: Vec::new(), chosen, slices, contacts })
    }

    /// Deals the wishes out to the rows; `false` where one has no place, or a row has none.
    fn shuffle(&mut self, stream: &mut Stream) -> bool {
        let Self { places, wants, order, rests, chosen, .. } = self;
        rests.clear();
        rests.extend(places.iter().map(|place| Rest {
            room: place.share,
            light: place.light,
            free: place.length,
        }));
        order.clear();
        order.extend(
            wants.iter().enumerate().map(|(index, want)| (want.area * stream.between(0.6, 1.6), index)),
        );
        // No two are equal, for each has its number.
        order.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        chosen.iter_mut().for_each(Vec::clear);
        for &(_, index) in &*order {
            let want = &wants[index];
            let mut best: Option<(f64, usize)> = None;
            for (row, (place, rest)) in places.iter().zip(&*rests).enumerate() {
                let is_wide = want.least <= rest.free.min(place.depth);
                if !is_wide || (want.needs_light && rest.light < WINDOW_STRETCH) {
                    continue;
                }
                let waste = if !want.needs_light && place.light > WINDOW_STRETCH { 0.5 } else { 0.0 };
                let worth = rest.room / want.area.max(1.0) - waste + stream.between(0.0, 0.6);
                if best.is_none_or(|(known, _)| worth > known) {
                    best = Some((worth, row));
                }
            }
            let Some((_, row)) = best else { return false };
            rests[row].room -= want.area;
            rests[row].free -= want.least;
            rests[row].light -= want.stretch;
            let at = stream.below(chosen[row].len() + 1);
            chosen[row].insert(at, index);
        }
        chosen.iter().all(|row| !row.is_empty())
    }

    /// The rooms of the last shuffle; `None` where they do not keep to what they need, or cost no less than a limit.
    fn place(&mut self, limit: f64) -> Option<Filling> {
        self.slices.clear();
        self.contacts.clear();
        let mut cost = 0.0;
        for row in 0..self.places.len() {
            cost += self.place_row(row)?;
            // What is to come costs nothing less than nothing.
            if cost >= limit {
                return None;
            }
        }
        let Some(hall) = self.hall else {
            return Some(Filling { slices: self.slices.clone(), cost, hall: None, hall_cost: 0.0 });
        };
        let is_worth = |hall_cost: f64| cost + hall_cost < limit;
        let (reach, hall_cost) = shorten(&self.contacts, self.wishes, hall, (&mut self.slices, &is_worth))?;
        Some(Filling { slices: self.slices.clone(), cost, hall: Some(reach), hall_cost })
    }

    /// Sets the rooms of a row side by side; their cost.
    fn place_row(&mut self, row: usize) -> Option<f64> {
        let Self { places, wants, chosen, slices, .. } = self;
        let (place, chosen) = (&places[row], &chosen[row]);
        let wished: f64 = chosen.iter().map(|&wish| wants[wish].area).sum();
        let scale = place.area / wished;
        if !(ROW_SCALE.0..=ROW_SCALE.1).contains(&scale) {
            return None;
        }
        let shares = Shares::of(chosen, wants, place.area, place.depth);
        let (mut taken, mut from) = (0.0, place.row.from);
        let first = slices.len();
        for (number, &wish) in chosen.iter().enumerate() {
            taken += shares.area(&wants[wish]);
            let is_last = number + 1 == chosen.len();
            let to = if is_last { place.row.to } else { (place.row.place_of(taken) * 20.0).round() / 20.0 };
            slices.push(Slice { wish, row, from, to, is_at_strip: false, is_at_hall: false });
            from = to;
        }
        self.judge_row(row, first, scale)
    }

    /// What the slices of a row cost, from one on; `None` where one does not keep to what its room needs.
    fn judge_row(&mut self, row: usize, first: usize, scale: f64) -> Option<f64> {
        let Self { wishes, wants, places, slices, contacts, .. } = self;
        let (wishes, row) = (*wishes, places[row].row);
        let slices = &mut slices[first..];
        let depth = |slice: &Slice| row.depth_between(slice.from, slice.to);
        let is_wide = |slice: &Slice| (slice.to - slice.from).min(depth(slice)) >= wants[slice.wish].least;
        if !slices.iter().all(is_wide) {
            return None;
        }
        let mut cost = 0.0;
        let scale_cost = libm::log(scale).abs();
        for slice in &mut *slices {
            let (length, depth) = (slice.to - slice.from, depth(slice));
            if wants[slice.wish].needs_light && row.light_between(slice.from, slice.to) < WINDOW_STRETCH {
                return None;
            }
            let contact = row.contact_between(slice.from, slice.to);
            contacts.push(contact);
            slice.is_at_strip = contact.map_or(0.0, |(from, to)| to - from) >= DOOR_STRETCH;
            slice.is_at_hall = slice.is_at_strip;
            let slenderness = length.max(depth) / length.min(depth);
            let good_width = wants[slice.wish].good_width;
            let narrowness = good_width.map_or(0.0, |good| (good - length.min(depth)).max(0.0));
            cost += scale_cost + (slenderness - SLENDER).max(0.0) + NARROW_COST * narrowness;
        }
        for index in 0..slices.len() {
            if slices[index].is_at_hall {
                continue;
            }
            // A room that the hall does not reach is entered from a neighbour that may be walked through.
            let neighbours = [index.checked_sub(1), Some(index + 1).filter(|&next| next < slices.len())];
            let doors = &wishes[slices[index].wish].needs.doors;
            let leads = |other: usize| {
                slices[other].is_at_hall
                    && doors.iter().any(|door| door == wishes[slices[other].wish].room_type)
            };
            if !neighbours.into_iter().flatten().any(leads) {
                return None;
            }
            cost += 0.4;
        }
        Some(cost)
    }
}

/// How the rooms of a row share its floor, which they fill: where there is more than was wished for, baths and stores grow less
/// than rooms to live in, but to the width that they need.
#[derive(Clone, Copy)]
struct Shares {
    scale: f64,
    depth: f64,
    for_large: f64,
    for_small: f64,
    /// Rooms that are wished for with so many square metres are as wide as is good to furnish, and the others smaller for it.
    wide_from: f64,
    for_others: f64,
}

impl Shares {
    /// Of a row of so many square metres that is so many metres deep.
    fn of(chosen: &[usize], wants: &[Want], available: f64, depth: f64) -> Self {
        let chosen = || chosen.iter().map(|&wish| &wants[wish]);
        let large = || chosen().filter(|want| want.needs_light);
        let wished: f64 = chosen().map(|want| want.area).sum();
        let scale = available / wished;
        let plain =
            Self { scale, depth, for_large: 1.0, for_small: 1.0, wide_from: f64::INFINITY, for_others: 1.0 };
        let of_small: f64 = chosen().filter(|want| !want.needs_light).map(|want| plain.area(want)).sum();
        let of_large: f64 = large().map(|want| want.area).sum();
        let (for_large, for_small) = match of_large > 0.0 {
            true => ((available - of_small).max(0.0) / of_large, 1.0),
            false => (0.0, available / of_small),
        };
        let shares = Self { for_large, for_small, ..plain };
        let narrow = large().filter(|want| shares.lack(want).is_some()).map(|want| want.area);
        let Some(largest) = narrow.reduce(f64::max) else { return shares };
        // All that are too narrow, or else the largest of them: one bed for two has a good place.
        [0.0, largest].into_iter().find_map(|from| shares.widened(large(), from)).unwrap_or(shares)
    }

    /// Square metres that the share of a room lacks to be good to furnish.
    fn lack(&self, want: &Want) -> Option<f64> {
        // In a shallow row no width makes up for the depth.
        let good_width = want.good_width.filter(|&good| want.needs_light && good <= self.depth)?;
        let lack = good_width * self.depth - want.area * self.for_large;
        (lack > 0.0).then_some(lack)
    }

    /// What a room gets beyond its share so that it is good to furnish.
    fn gain(&self, want: &Want) -> Option<f64> {
        let most = want.area * self.for_large * (WIDENED - 1.0);
        self.lack(want).filter(|&lack| want.area >= self.wide_from && lack <= most)
    }

    /// Shares in which rooms of so many square metres and more are good to furnish; `None` where that makes others too small.
    fn widened<'w>(self, large: impl Iterator<Item = &'w Want> + Clone, from: f64) -> Option<Self> {
        let wide = Self { wide_from: from, ..self };
        let others = || large.clone().filter(|want| wide.lack(want).is_none());
        let more: f64 = large.clone().filter_map(|want| wide.gain(want)).sum();
        let of_others: f64 = others().map(|want| want.area * self.for_large).sum();
        let for_others = 1.0 - more / of_others;
        let shares = Self { for_others, ..wide };
        let keeps_its_width =
            |want: &Want| shares.area(want) >= want.good_width.unwrap_or(want.least) * self.depth;
        (more > 0.0 && for_others >= NARROWED && others().all(keeps_its_width)).then_some(shares)
    }

    /// Square metres of a room.
    fn area(&self, want: &Want) -> f64 {
        if want.needs_light {
            let share = want.area * self.for_large;
            let is_narrow = self.lack(want).is_some();
            return if is_narrow { share + self.gain(want).unwrap_or(0.0) } else { share * self.for_others };
        }
        let grown = want.area * if self.scale > 1.0 { self.scale.sqrt() } else { self.scale };
        grown.max(want.inner_width * self.depth) * self.for_small
    }
}

/// From where to where along the strip the hall is needed by these slices: each keeps [`DOOR_STRETCH`] of it.
pub(super) fn needed(rows: &[Row], slices: &[Slice]) -> Option<(f64, f64)> {
    let contacts = slices
        .iter()
        .filter(|slice| slice.is_at_hall)
        .filter_map(|slice| rows[slice.row].contact_between(slice.from, slice.to));
    let reach = contacts.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (from, to)| {
        (low.min(to - DOOR_STRETCH), high.max(from + DOOR_STRETCH))
    });
    (reach.0 < reach.1).then_some(reach)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_is_for_as_many_rooms_as_have_a_stretch_of_it() {
        assert_eq!(housed_behind(0.9, &[2.0, 2.0]), 0, "no window has a place");
        assert_eq!(housed_behind(4.5, &[2.0, 3.0, 3.0]), 2);
        assert_eq!(housed_behind(30.0, &[2.0, 3.0]), 2);
    }

    fn want(area: f64, least: f64, good_width: Option<f64>) -> Want {
        Want { area, least, stretch: 2.0, needs_light: true, inner_width: least, good_width }
    }

    /// Metres along a row 5 m deep, of as many square metres as are wished for.
    fn widths(wants: &[Want]) -> Vec<f64> {
        let chosen: Vec<usize> = (0..wants.len()).collect();
        let wished: f64 = wants.iter().map(|want| want.area).sum();
        let shares = Shares::of(&chosen, wants, wished, 5.0);
        let widths: Vec<f64> = wants.iter().map(|want| shares.area(want) / 5.0).collect();
        assert!((widths.iter().sum::<f64>() - wished / 5.0).abs() < 1e-9, "the row is full: {widths:?}");
        widths
    }

    #[test]
    fn bedrooms_are_wide_enough_for_a_bed_for_two_where_a_living_room_can_spare_it() {
        let bedroom = |area| want(area, 2.5, Some(3.25));
        let living = |area| want(area, 3.0, None);
        assert!((widths(&[living(25.0), bedroom(12.0)])[1] - 3.25).abs() < 1e-9);
        assert!((widths(&[living(12.0), bedroom(12.0)])[1] - 2.4).abs() < 1e-9, "nothing can be spared");
        // Of two, the larger.
        let two = widths(&[living(25.0), bedroom(14.0), bedroom(12.0)]);
        assert!((two[1] - 3.25).abs() < 1e-9 && (two[2] - 2.4).abs() < 1e-9, "{two:?}");
        // No bedroom that is wide enough is narrowed for another.
        let wide = widths(&[bedroom(18.0), bedroom(14.0)]);
        assert!((wide[0] - 3.6).abs() < 1e-9 && (wide[1] - 2.8).abs() < 1e-9, "{wide:?}");
    }
}
