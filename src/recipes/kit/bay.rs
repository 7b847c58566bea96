//! Axis-aligned pieces of a class's box; furniture is made by cutting them up.

use glam::DVec3;

use crate::geometry::{Side, Size};

/// An axis-aligned box in the model frame: `low` is left, under, back; `high` is right, above, front.
///
/// ```text
///          back (-z)
///        +-----------+
///  left  |           |  right (+x)      y points at the reader
///        +-----------+
///         front (+z)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bay {
    /// Left, underside, back.
    pub(crate) low: DVec3,
    /// Right, top, front.
    pub(crate) high: DVec3,
}

impl Bay {
    /// From the ends along each axis: x left to right, y upwards, z back to front.
    pub(crate) fn new(x: [f64; 2], y: [f64; 2], z: [f64; 2]) -> Self {
        Self { low: DVec3::new(x[0], y[0], z[0]), high: DVec3::new(x[1], y[1], z[1]) }
    }

    /// The box of a class.
    pub(crate) fn of_size(size: Size) -> Self {
        let (half_width, half_depth) = (size.width / 2.0, size.depth / 2.0);
        Self::new([-half_width, half_width], [0.0, size.height], [-half_depth, half_depth])
    }

    /// Width, height, depth.
    pub(crate) fn extent(self) -> DVec3 {
        self.high - self.low
    }

    /// Metres along x.
    pub(crate) fn width(self) -> f64 {
        self.high.x - self.low.x
    }

    /// Metres along y.
    pub(crate) fn height(self) -> f64 {
        self.high.y - self.low.y
    }

    /// Metres along z.
    pub(crate) fn depth(self) -> f64 {
        self.high.z - self.low.z
    }

    /// The middle.
    pub(crate) fn center(self) -> DVec3 {
        (self.low + self.high) / 2.0
    }

    /// The slab of a thickness along one side, inside this bay; never thicker than the bay.
    pub(crate) fn slab(self, side: Side, thickness: f64) -> Self {
        let mut piece = self;
        match side {
            Side::Left => piece.high.x = self.high.x.min(self.low.x + thickness),
            Side::Right => piece.low.x = self.low.x.max(self.high.x - thickness),
            Side::Below => piece.high.y = self.high.y.min(self.low.y + thickness),
            Side::Above => piece.low.y = self.low.y.max(self.high.y - thickness),
            Side::Back => piece.high.z = self.high.z.min(self.low.z + thickness),
            Side::Front => piece.low.z = self.low.z.max(self.high.z - thickness),
        }
        piece
    }

    /// The rest of the bay without a slab at one side; a negative thickness grows the bay.
    pub(crate) fn without(self, side: Side, thickness: f64) -> Self {
        let mut rest = self;
        match side {
            Side::Left => rest.low.x = self.high.x.min(self.low.x + thickness),
            Side::Right => rest.high.x = self.low.x.max(self.high.x - thickness),
            Side::Below => rest.low.y = self.high.y.min(self.low.y + thickness),
            Side::Above => rest.high.y = self.low.y.max(self.high.y - thickness),
            Side::Back => rest.low.z = self.high.z.min(self.low.z + thickness),
            Side::Front => rest.high.z = self.low.z.max(self.high.z - thickness),
        }
        rest
    }

    /// Smaller by these metres at both ends of each axis (larger where negative).
    pub(crate) fn inset(self, x: f64, y: f64, z: f64) -> Self {
        let by = DVec3::new(x, y, z).min(self.extent() / 2.0);
        Self { low: self.low + by, high: self.high - by }
    }

    /// The same box somewhere else.
    pub(crate) fn moved(self, x: f64, y: f64, z: f64) -> Self {
        let by = DVec3::new(x, y, z);
        Self { low: self.low + by, high: self.high + by }
    }

    /// Bays from left to right with gaps between them.
    pub(crate) fn columns(self, count: u32, gap: f64) -> Vec<Self> {
        let count = count.max(1);
        let width = (self.width() - gap * f64::from(count - 1)) / f64::from(count);
        let left = |index: u32| self.low.x + f64::from(index) * (width + gap);
        let column = |index| Self::new([left(index), left(index) + width], self.y(), self.z());
        (0..count).map(column).collect()
    }

    /// Bays from below upwards with gaps between them.
    pub(crate) fn rows(self, count: u32, gap: f64) -> Vec<Self> {
        let count = count.max(1);
        let height = (self.height() - gap * f64::from(count - 1)) / f64::from(count);
        let under = |index: u32| self.low.y + f64::from(index) * (height + gap);
        let row = |index| Self::new(self.x(), [under(index), under(index) + height], self.z());
        (0..count).map(row).collect()
    }

    /// The same bay between other ends along x.
    pub(crate) fn with_x(self, x: [f64; 2]) -> Self {
        Self::new(x, self.y(), self.z())
    }

    /// The same bay between other heights.
    pub(crate) fn with_y(self, y: [f64; 2]) -> Self {
        Self::new(self.x(), y, self.z())
    }

    /// The same bay between other ends along z.
    pub(crate) fn with_z(self, z: [f64; 2]) -> Self {
        Self::new(self.x(), self.y(), z)
    }

    /// Of a width, height and depth around a middle.
    pub(crate) fn around(middle: DVec3, width: f64, height: f64, depth: f64) -> Self {
        let half = DVec3::new(width, height, depth) / 2.0;
        Self { low: middle - half, high: middle + half }
    }

    /// The ends along x.
    pub(crate) fn x(self) -> [f64; 2] {
        [self.low.x, self.high.x]
    }

    /// The ends along y.
    pub(crate) fn y(self) -> [f64; 2] {
        [self.low.y, self.high.y]
    }

    /// The ends along z.
    pub(crate) fn z(self) -> [f64; 2] {
        [self.low.z, self.high.z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bay() -> Bay {
        Bay::of_size(Size { width: 2.0, depth: 1.0, height: 0.5 })
    }

    #[test]
    fn a_slab_and_the_rest_make_the_whole() {
        for side in Side::ALL {
            let (slab, rest) = (bay().slab(side, 0.1), bay().without(side, 0.1));
            let volume = |bay: Bay| bay.extent().x * bay.extent().y * bay.extent().z;
            assert!((volume(slab) + volume(rest) - 1.0).abs() < 1e-12, "{side:?}");
        }
    }

    #[test]
    fn the_front_slab_lies_at_positive_z() {
        let front = bay().slab(Side::Front, 0.2);
        assert_eq!((front.low.z, front.high.z), (0.3, 0.5));
        assert_eq!(bay().slab(Side::Right, 0.5).low.x, 0.5);
    }

    #[test]
    fn cuts_thicker_than_the_bay_leave_nothing_but_never_turn_it_inside_out() {
        for side in Side::ALL {
            assert_eq!(bay().slab(side, 9.0), bay());
            assert!(bay().without(side, 9.0).extent().min_element() >= 0.0);
        }
        assert!(bay().inset(9.0, 9.0, 9.0).extent().min_element() >= 0.0);
    }

    #[test]
    fn columns_and_rows_keep_their_gaps_and_reach_both_ends() {
        let columns = bay().columns(4, 0.1);
        assert_eq!(columns.len(), 4);
        assert!((columns[1].low.x - columns[0].high.x - 0.1).abs() < 1e-12);
        assert!((columns[3].high.x - 1.0).abs() < 1e-12);
        let rows = bay().rows(2, 0.1);
        assert!((rows[0].height() - 0.2).abs() < 1e-12 && (rows[1].high.y - 0.5).abs() < 1e-12);
    }
}
