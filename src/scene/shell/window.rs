//! Windows: bars, panes, handles and sills.

use super::frame::{BAR, GLASS, Reveal};
use super::slots::{FRAME_SLOT, GLASS_SLOT, HANDLE_SLOT};
use super::solid::Solid;
use super::ticks::Ticks;
use crate::recipes::Slot;

/// Depth of the bars of a window frame, and the least one behind a handle.
const BAR_DEPTH: Ticks = Ticks(7_000);
const LEAST_BAR_DEPTH: Ticks = Ticks(4_000);
/// How far sills, bars and handles may stand out of a wall: furniture and curtains touch the wall, and no piece may be more
/// than 1 cm in another.
const FLUSH: Ticks = Ticks(900);
/// Widest casement: a window has as many as it takes.
const CASEMENT: i32 = 90_000;
/// Height from which a window has a transom, and height of the lights above it.
const TRANSOM: [Ticks; 2] = [Ticks(180_000), Ticks(45_000)];
/// Board on the sill inside: thickness, and how far it stands into the room.
const SILL_BOARD: [Ticks; 2] = [Ticks(2_500), FLUSH];
/// Sheet on the sill outside: thickness, and how far it stands out.
const SILL_SHEET: [Ticks; 2] = [Ticks(1_500), Ticks(3_500)];
/// Material of the sheet.
const SHEET_SLOT: Slot = Slot::Metal;
/// Handle: height, width, distance from the bar, thickness.
const HANDLE: [Ticks; 4] = [Ticks(12_000), Ticks(1_600), Ticks(3_000), Ticks(1_200)];
/// Shortest casement with a handle, and highest sill above which hands do not reach it.
const HANDLE_FROM: Ticks = Ticks(50_000);
const HANDLE_UP_TO: Ticks = Ticks(170_000);

/// The panes of a window: columns along x, rows along y.
struct Panes {
    columns: Vec<[Ticks; 2]>,
    rows: Vec<[Ticks; 2]>,
}

impl Reveal {
    /// The bars around and in a window, then handles.
    pub(crate) fn window_frame(&self) -> [Solid; 2] {
        let panes = self.panes();
        let (back, front) = self.bar_depth();
        let mut solid = Solid::new(FRAME_SLOT);
        let mut bar = |x: [Ticks; 2], y: [Ticks; 2]| solid.cuboid([x[0], y[0], back], [x[1], y[1], front]);
        let (first, last) = (panes.columns[0], panes.columns[panes.columns.len() - 1]);
        let (lowest, highest) = (panes.rows[0], panes.rows[panes.rows.len() - 1]);
        bar([self.left, first[0]], [self.bottom, self.top]);
        bar([last[1], self.right], [self.bottom, self.top]);
        bar([first[0], last[1]], [self.bottom, lowest[0]]);
        bar([first[0], last[1]], [highest[1], self.top]);
        for pair in panes.columns.windows(2) {
            bar([pair[0][1], pair[1][0]], [lowest[0], highest[1]]);
        }
        for pair in panes.rows.windows(2) {
            panes.columns.iter().for_each(|&column| bar(column, [pair[0][1], pair[1][0]]));
        }
        [solid, self.window_handles(&panes)]
    }

    /// A lever at the edge of each casement.
    fn window_handles(&self, panes: &Panes) -> Solid {
        let [height, width, distance, thickness] = HANDLE;
        let mut solid = Solid::new(HANDLE_SLOT);
        let casement = panes.rows[0];
        let half = self.fitted(BAR);
        if casement[1] - casement[0] < HANDLE_FROM || self.bottom > HANDLE_UP_TO || half < BAR {
            return solid;
        }
        let middle = Ticks((casement[0].0 + casement[1].0) / 2);
        let face = self.bar_depth().1;
        if face + distance + thickness > self.front + FLUSH {
            return solid;
        }
        for column in &panes.columns {
            let left = column[1] + width;
            let right = left + width;
            let low = [left, middle - width, face];
            solid.cuboid(low, [right, middle, face + distance]);
            let low = [left, middle - height, face + distance];
            solid.cuboid(low, [right, middle, face + distance + thickness]);
        }
        solid
    }

    /// The panes of a window.
    pub(crate) fn window_glass(&self) -> Solid {
        let panes = self.panes();
        let half = Ticks(GLASS.0 / 2);
        let (behind, before) = self.bar_depth();
        let middle = Ticks((behind.0 + before.0) / 2);
        let (back, front) = (middle - half, middle + half);
        let mut solid = Solid::new(GLASS_SLOT);
        for row in &panes.rows {
            for column in &panes.columns {
                solid.cuboid([column[0], row[0], back], [column[1], row[1], front]);
            }
        }
        solid
    }

    /// The board on the sill, from the window's bars into the first room, then the sheet outside.
    pub(crate) fn sills(&self, is_exterior: bool) -> [Solid; 2] {
        let (behind, before) = self.bar_depth();
        let [thickness, projection] = SILL_BOARD;
        let (mut board, mut sheet) = (Solid::new(FRAME_SLOT), Solid::new(SHEET_SLOT));
        let high = [self.right, self.bottom + thickness, self.front + projection];
        board.cuboid([self.left, self.bottom, before], high);
        if is_exterior {
            let [thickness, projection] = SILL_SHEET;
            let low = [self.left, self.bottom, self.back - projection];
            sheet.cuboid(low, [self.right, self.bottom + thickness, behind]);
        }
        [board, sheet]
    }

    fn panes(&self) -> Panes {
        let bar = self.fitted(BAR);
        let count = ((self.right - self.left).0 - bar.0 + CASEMENT - 1).div_euclid(CASEMENT).max(1);
        let columns = split([self.left + bar, self.right - bar], count, bar);
        let (low, high) = (self.bottom + bar, self.top - bar);
        let rows = if self.top - self.bottom < TRANSOM[0] {
            vec![[low, high]]
        } else {
            let transom = high - TRANSOM[1];
            vec![[low, transom - bar], [transom, high]]
        };
        Panes { columns, rows }
    }

    /// Bars stand in the middle of the wall, or so far back that handles before them hardly stand out of it. In walls that
    /// are too thin for that, bars are as deep as the wall.
    fn bar_depth(&self) -> (Ticks, Ticks) {
        let half = Ticks(BAR_DEPTH.0 / 2);
        let [.., distance, thickness] = HANDLE;
        let (lowest, highest) = (self.back - FLUSH, self.front + FLUSH);
        let front = (self.middle_depth() + half).min(highest - distance - thickness);
        let back = (front - BAR_DEPTH).max(lowest);
        if front - back >= LEAST_BAR_DEPTH {
            return (back, front);
        }
        ((self.middle_depth() - half).max(lowest), (self.middle_depth() + half).min(highest))
    }
}

/// A span in equal parts with bars between them.
fn split([from, to]: [Ticks; 2], count: i32, bar: Ticks) -> Vec<[Ticks; 2]> {
    let clear = (to - from).0 - bar.0 * (count - 1);
    let start = |index: i32| {
        let share = i64::from(clear) * i64::from(index) / i64::from(count);
        from + Ticks(i32::try_from(share).expect("a share is no longer than its whole"))
            + Ticks(bar.0 * index)
    };
    (0..count).map(|index| [start(index), start(index + 1) - bar]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window(width: i32, height: i32) -> Reveal {
        Reveal {
            left: Ticks(-width / 2),
            right: Ticks(width / 2),
            bottom: Ticks(90_000),
            top: Ticks(90_000 + height),
            back: Ticks(-15_000),
            front: Ticks(15_000),
        }
    }

    #[test]
    fn casements_follow_the_width_and_transoms_the_height() {
        let count = |width, height| {
            let panes = window(width, height).panes();
            (panes.columns.len(), panes.rows.len())
        };
        assert_eq!(count(90_000, 120_000), (1, 1));
        assert_eq!(count(140_000, 120_000), (2, 1));
        assert_eq!(count(240_000, 120_000), (3, 1));
        assert_eq!(count(140_000, 200_000), (2, 2));
    }

    #[test]
    fn casements_are_between_the_bars() {
        let panes = window(240_000, 120_000).panes();
        assert_eq!(panes.columns[0][0], Ticks(-114_000));
        assert_eq!(panes.columns[2][1], Ticks(114_000));
        assert_eq!(panes.columns[1][0] - panes.columns[0][1], BAR);
    }
}
