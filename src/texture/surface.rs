//! The patterns of surfaces: shade, height and roughness at each point of a square metre that repeats.
//!
//! Along `x` runs the grain of wood and the length of planks. Sizes are those of common products: boards of strip
//! parquet 1000 × 125 mm, floor tiles 250 mm, wall tiles 200 × 100 mm, joints of 3 to 4 mm (EN 14411), the yarns of
//! upholstery 5 to 8 mm, pebbles of leather about 10 mm, coarser than real ones so that 2 mm pixels show them.

use super::noise::{grain, layered, nearest_two, noise, step, whole};
use crate::catalog::SURFACES;

/// Whether a surface is more than a flat pattern, so that it has a normal map. Lacquered wood, polished stone,
/// painted plaster and the like are level to the eye.
#[must_use]
pub fn has_relief(surface: &str) -> bool {
    SURFACES.contains(&surface) && !matches!(surface, "brushed" | "linoleum" | "plaster" | "stone" | "wood")
}

/// The properties of a surface at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// Multiplies the palette's linear colour, 0 to 1.
    pub shade: f64,
    /// Multiplies the palette's roughness, 0 to 1.
    pub roughness: f64,
    /// Metres above the lowest point.
    pub height: f64,
}

/// A surface at a point in metres; flat and even for an unknown name.
pub(super) fn sample(surface: &str, point: [f64; 2]) -> Sample {
    match surface {
        "brushed" => brushed(point),
        "carpet" => carpet(point),
        "concrete" => concrete(point),
        "fabric" => weave(point, 96.0, 0.000_9),
        "leather" => leather(point),
        "linen" => weave(point, 128.0, 0.000_3),
        "linoleum" => linoleum(point),
        "parquet" => parquet(point),
        "plaster" => plaster(point),
        "stone" => stone(point),
        "tile" => tiles(point, [4.0, 4.0], 0.003),
        "tile_wall" => tiles(point, [5.0, 10.0], 0.003),
        "wood" => wood(point, 0),
        _ => Sample { shade: 1.0, roughness: 1.0, height: 0.0 },
    }
}

/// Growth rings cut lengthwise, bent by slow noise, with fine fibres.
fn wood([x, y]: [f64; 2], seed: u32) -> Sample {
    let bend = noise([x, y], [2, 5], seed + 11);
    let rings = 14.0 * y + 3.0 * bend;
    // Early wood is light and wide, late wood a dark line: a saw tooth with a soft fall.
    let phase = rings - whole(rings) as f64;
    let late = step(0.55, 0.92, phase) * (1.0 - step(0.94, 1.0, phase));
    let fibre = noise([x, y], [6, 256], seed + 12);
    let cloud = noise([x, y], [3, 6], seed + 13);
    Sample {
        shade: 1.0 - 0.16 * late - 0.09 * fibre - 0.07 * cloud,
        roughness: 0.86 + 0.14 * fibre,
        height: 0.0,
    }
}

/// Boards of a metre, eight in the width, each shifted along and of its own shade, with narrow bevels.
fn parquet([x, y]: [f64; 2]) -> Sample {
    const ROWS: f64 = 8.0;
    const BEVEL: f64 = 0.002;
    let row = whole(y * ROWS);
    let number = row.rem_euclid(ROWS as i64);
    let along = x + grain(number, 0, 21);
    let across = y * ROWS - row as f64;
    let to_side = across.min(1.0 - across) / ROWS;
    let piece = whole(along * 2.0);
    let within = along * 2.0 - piece as f64;
    let to_end = within.min(1.0 - within) / 2.0;
    let joint = 1.0 - step(0.0, BEVEL, to_side.min(to_end));
    let own = grain(number, piece.rem_euclid(2), 22);
    let board = wood([x, y], 30 + (own * 64.0) as u32);
    Sample {
        shade: (board.shade - 0.13 * own) * (1.0 - 0.55 * joint),
        roughness: board.roughness,
        height: board.height + 0.000_9 * (1.0 - joint),
    }
}

/// Tiles in a grid with sunk, rough joints; each tile a little lighter or darker.
fn tiles([x, y]: [f64; 2], count: [f64; 2], joint: f64) -> Sample {
    let (column, row) = (whole(x * count[0]), whole(y * count[1]));
    let to_edge = |value: f64, tile: i64, count: f64| {
        let within = value * count - tile as f64;
        within.min(1.0 - within) / count
    };
    let distance = to_edge(x, column, count[0]).min(to_edge(y, row, count[1]));
    let body = step(joint * 0.5, joint * 0.5 + 0.002_5, distance);
    let own = grain(column.rem_euclid(count[0] as i64), row.rem_euclid(count[1] as i64), 41);
    let cloud = layered([x, y], [6, 6], 3, 42);
    Sample {
        shade: (1.0 - 0.05 * own - 0.05 * cloud) * (0.62 + 0.38 * body),
        roughness: 1.0 - 0.45 * body,
        height: 0.001_2 * body,
    }
}

/// Plain weave: warp and weft go over and under each other.
fn weave([x, y]: [f64; 2], yarns: f64, depth: f64) -> Sample {
    let (u, v) = (x * yarns, y * yarns);
    let (column, row) = (whole(u), whole(v));
    let arch = |along: f64| 4.0 * along * (1.0 - along);
    let arches = [arch(u - column as f64), arch(v - row as f64)];
    let is_warp_up = (column + row) % 2 == 0;
    let [over, under] = if is_warp_up { arches } else { [arches[1], arches[0]] };
    let height = over * (0.45 + 0.55 * under);
    let mottle = layered([x, y], [24, 24], 3, 51);
    Sample { shade: 0.80 + 0.13 * height + 0.07 * mottle, roughness: 1.0, height: depth * height }
}

/// Cut pile: tufts of a few millimetres, in drifts.
fn carpet(point: [f64; 2]) -> Sample {
    let tuft = noise(point, [160, 160], 61);
    let drift = layered(point, [5, 5], 3, 62);
    Sample { shade: 0.74 + 0.16 * tuft + 0.10 * drift, roughness: 1.0, height: 0.001_6 * tuft }
}

/// Pebbles with creases between them.
fn leather(point: [f64; 2]) -> Sample {
    let [near, next] = nearest_two(point, 72, 71);
    let pebble = step(0.0, 0.42, next - near);
    let wear = layered(point, [4, 4], 3, 72);
    Sample {
        shade: 0.80 + 0.10 * pebble + 0.10 * wear,
        roughness: 0.80 + 0.20 * (1.0 - wear),
        height: 0.000_5 * pebble,
    }
}

/// Roller-painted plaster: even in colour, since clouds would repeat along every wall, with a skin that shines unevenly.
fn plaster(point: [f64; 2]) -> Sample {
    Sample { shade: 1.0, roughness: 0.88 + 0.12 * layered(point, [40, 40], 2, 81), height: 0.0 }
}

/// Cast concrete: clouds and a few pores.
fn concrete(point: [f64; 2]) -> Sample {
    let cloud = layered(point, [4, 4], 5, 91);
    let [near, _] = nearest_two(point, 28, 92);
    let pore = 1.0 - step(0.05, 0.12, near);
    Sample {
        shade: (0.78 + 0.22 * cloud) * (1.0 - 0.35 * pore),
        roughness: 0.9 + 0.1 * cloud,
        height: 0.000_8 * (1.0 - pore) + 0.000_4 * cloud,
    }
}

/// Polished stone: clouds with thin veins where two slow noises meet.
fn stone(point: [f64; 2]) -> Sample {
    let warp = layered(point, [3, 3], 4, 101);
    let bent = [point[0] + 0.15 * warp, point[1] + 0.15 * warp];
    let vein = (layered(bent, [3, 3], 4, 102) - 0.5).abs();
    let line = 1.0 - step(0.0, 0.035, vein);
    let speckle = noise(point, [128, 128], 103);
    Sample {
        shade: 0.88 + 0.08 * warp + 0.04 * speckle - 0.14 * line,
        roughness: 0.85 + 0.15 * line,
        height: 0.0,
    }
}

/// Marbled flecks.
fn linoleum(point: [f64; 2]) -> Sample {
    let fleck = layered(point, [20, 48], 3, 111);
    Sample { shade: 0.86 + 0.14 * step(0.35, 0.65, fleck), roughness: 0.9 + 0.1 * fleck, height: 0.0 }
}

/// Strokes along `x`.
fn brushed(point: [f64; 2]) -> Sample {
    let stroke = noise(point, [4, 512], 121);
    Sample { shade: 0.93 + 0.07 * stroke, roughness: 0.78 + 0.22 * stroke, height: 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_are_named_once_in_order() {
        assert!(SURFACES.windows(2).all(|pair| pair[0] < pair[1]));
        let plain = sample("marzipan", [0.3, 0.3]);
        let differs =
            |surface: &&&str| (0..40).any(|index| sample(surface, [0.013 * f64::from(index), 0.37]) != plain);
        assert_eq!(SURFACES.iter().filter(differs).count(), SURFACES.len());
    }

    #[test]
    fn surfaces_with_relief_are_uneven_and_others_are_not() {
        for surface in SURFACES {
            let heights =
                (0..400).map(|index| sample(surface, [grain(index, 1, 1), grain(index, 2, 2)]).height);
            let highest = heights.fold(0.0, f64::max);
            assert_eq!(highest > 0.0, has_relief(surface), "{surface}");
        }
        assert!(!has_relief("marzipan"));
    }

    #[test]
    fn every_surface_repeats_without_a_seam_and_stays_within_bounds() {
        for surface in SURFACES {
            let mut lightest = 0.0_f64;
            for index in 0..500 {
                let point = [grain(index, 1, 1), grain(index, 2, 2)];
                let here = sample(surface, point);
                let beyond = sample(surface, [point[0] + 1.0, point[1] - 1.0]);
                assert!((here.shade - beyond.shade).abs() < 1e-6, "{surface} at {point:?}");
                assert!((here.height - beyond.height).abs() < 1e-8, "{surface} at {point:?}");
                assert!(
                    (0.0..=1.0).contains(&here.shade) && (0.0..=1.0).contains(&here.roughness),
                    "{surface}"
                );
                assert!((0.0..0.01).contains(&here.height), "{surface}");
                lightest = lightest.max(here.shade);
            }
            // The palette's colour is what one sees, not a darker one.
            assert!(lightest > 0.9, "{surface} is nowhere lighter than {lightest}");
        }
    }
}
