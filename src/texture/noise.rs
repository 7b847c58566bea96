//! Noise that repeats after one metre, computed in whole numbers: the same on every machine.

/// A number from 0 up to 1 for a point of a grid and a seed: the finalizer of MurmurHash3 (A. Appleby, 2011).
pub(super) fn grain(x: i64, y: i64, seed: u32) -> f64 {
    let mut bits = (x as u32).wrapping_mul(0x9e37_79b1)
        ^ (y as u32).wrapping_mul(0x85eb_ca77)
        ^ seed.wrapping_mul(0xc2b2_ae3d);
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x85eb_ca6b);
    bits ^= bits >> 13;
    bits = bits.wrapping_mul(0xc2b2_ae35);
    bits ^= bits >> 16;
    f64::from(bits) / 4_294_967_296.0
}

/// Value noise from 0 to 1 of a grid with so many cells along a metre in each direction; `x` and `y` in metres.
pub(super) fn noise([x, y]: [f64; 2], cells: [i64; 2], seed: u32) -> f64 {
    let (u, v) = (x * cells[0] as f64, y * cells[1] as f64);
    let (column, row) = (whole(u), whole(v));
    let (right, up) = (ease(u - column as f64), ease(v - row as f64));
    let columns = [column, column + 1].map(|column| wrapped(column, cells[0]));
    let [low, high] = [row, row + 1].map(|row| {
        let row = wrapped(row, cells[1]);
        let [left, next] = columns.map(|column| grain(column, row, seed));
        left + (next - left) * right
    });
    low + (high - low) * up
}

/// The whole number below; `f64::floor` is a call on processors without SSE 4.1, and this is asked for each pixel.
pub(super) fn whole(value: f64) -> i64 {
    let towards_zero = value as i64;
    towards_zero - i64::from(value < towards_zero as f64)
}

/// A cell's number within its metre. Nearly all points lie in the first metre, and a division takes longer than the rest
/// of the noise.
fn wrapped(cell: i64, cells: i64) -> i64 {
    if (0..cells).contains(&cell) { cell } else { cell.rem_euclid(cells) }
}

/// Sums noise of finer and finer cells, each half as strong: from 0 to 1.
pub(super) fn layered(point: [f64; 2], cells: [i64; 2], layers: u32, seed: u32) -> f64 {
    let (mut sum, mut weight, mut total) = (0.0, 1.0, 0.0);
    for layer in 0..layers {
        let finer = cells.map(|count| count << layer);
        sum += weight * noise(point, finer, seed.wrapping_add(layer.wrapping_mul(101)));
        total += weight;
        weight /= 2.0;
    }
    sum / total
}

/// Distances, in cells, to the nearest and the second nearest of points strewn one to a cell (S. Worley, "A Cellular
/// Texture Basis Function", 1996).
pub(super) fn nearest_two([x, y]: [f64; 2], cells: i64, seed: u32) -> [f64; 2] {
    let (u, v) = (x * cells as f64, y * cells as f64);
    let (column, row) = (whole(u), whole(v));
    let mut nearest = [f64::MAX; 2];
    for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
        let (i, j) = (wrapped(column + dx, cells), wrapped(row + dy, cells));
        let offset = [
            (column + dx) as f64 + grain(i, j, seed) - u,
            (row + dy) as f64 + grain(i, j, seed ^ 0x5bd1) - v,
        ];
        let distance = offset[0] * offset[0] + offset[1] * offset[1];
        if distance < nearest[0] {
            nearest = [distance, nearest[0]];
        } else if distance < nearest[1] {
            nearest[1] = distance;
        }
    }
    nearest.map(f64::sqrt)
}

/// From 0 to 1 with level ends (Perlin's quintic, 2002).
pub(super) fn ease(t: f64) -> f64 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// 0 below `from`, 1 above `to`, smooth between.
pub(super) fn step(from: f64, to: f64, value: f64) -> f64 {
    ease(((value - from) / (to - from)).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_repeats_after_a_metre_and_stays_within_bounds() {
        let mut spread = [1.0_f64, 0.0_f64];
        for index in 0..400 {
            let point = [grain(index, 0, 1), grain(0, index, 2)];
            let moved = [point[0] + 1.0, point[1] + 1.0];
            let value = layered(point, [4, 16], 4, 7);
            assert!((value - layered(moved, [4, 16], 4, 7)).abs() < 1e-9);
            let [near, next] = nearest_two(point, 12, 3);
            assert!(near <= next && (near - nearest_two(moved, 12, 3)[0]).abs() < 1e-9);
            spread = [spread[0].min(value), spread[1].max(value)];
        }
        assert!(spread[0] >= 0.0 && spread[0] < 0.35 && spread[1] <= 1.0 && spread[1] > 0.65, "{spread:?}");
    }

    #[test]
    fn grains_of_neighbours_and_of_seeds_differ() {
        let draws: Vec<f64> = (0..5).flat_map(|x| (0..5).map(move |y| grain(x, y, 1))).collect();
        let mean = draws.iter().sum::<f64>() / draws.len() as f64;
        assert!((mean - 0.5).abs() < 0.15, "{mean}");
        assert!((grain(3, 4, 1) - grain(3, 4, 2)).abs() > 1e-6);
    }
}
