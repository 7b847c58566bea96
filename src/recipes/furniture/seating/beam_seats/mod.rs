//! Seats side by side for waiting rooms: 0.5 to 0.6 m for each person, seats 0.43 to 0.46 m over the floor, 0.8 m high (DIN
//! EN 16139, typical).

mod budget;
mod industrial;
mod plain;
mod traditional;

use super::{depth_slats, seat_height};
use crate::recipes::kit::{Bay, Builder};
use crate::recipes::{Draft, GeometrySet, Recipe, Symbol};

/// Metres that one waiting person takes.
const PERSON: f64 = 0.55;
/// Radians by which backs lean.
const LEAN: f64 = 0.2;

/// Seats side by side: pads between frames of metal on a beam; a bench of slats on cast iron; bands of steel on a channel;
/// moulded shells on a beam.
pub(in super::super) static BEAM_SEATS: Recipe = Recipe::furniture("beam_seats", [2.0, 0.62, 0.82])
    .with(&[("seats", 0.0)])
    .symbol(Symbol::Sofa)
    .every_set(beam_seats);

fn beam_seats(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let row = Row {
        bay,
        count: draft.count_along("seats", bay.width(), PERSON, 8).min(8),
        seat: seat_height(bay.height()),
        look: draft.form(),
    };
    match draft.set() {
        GeometrySet::Plain => plain::build(&row, builder),
        GeometrySet::Traditional => traditional::build(&row, builder),
        GeometrySet::Industrial => industrial::build(&row, builder),
        GeometrySet::Budget => budget::build(&row, builder),
    }
}

/// The measures that all rows share.
struct Row {
    bay: Bay,
    count: u32,
    /// Metres of the seats over the floor.
    seat: f64,
    look: usize,
}

impl Row {
    /// The seats from left to right with gaps between them and a gap at both ends.
    fn cells(&self, gap: f64) -> Vec<Bay> {
        self.bay.inset(gap, 0.0, 0.0).columns(self.count, gap)
    }

    /// The middles of the gaps before, between and after the seats.
    fn joints(&self, gap: f64) -> Vec<f64> {
        let cells = self.cells(gap);
        let first = self.bay.low.x + gap / 2.0;
        std::iter::once(first)
            .chain(cells.windows(2).map(|pair| (pair[0].high.x + pair[1].low.x) / 2.0))
            .chain(std::iter::once(self.bay.high.x - gap / 2.0))
            .collect()
    }

    /// Where two legs stand along the row.
    fn legs(&self) -> [f64; 2] {
        let off = self.bay.width() / 2.0 - (self.bay.width() * 0.24).min(0.5);
        [-off, off]
    }
}
