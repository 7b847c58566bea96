//! Divides a site into quarters until few enough levels are left for one file.

/// The most levels that one file describes, unless they are of one building.
const LEVELS_OF_FILE: usize = 256;
/// Divisions after which what is left stays together: buildings may stand in one place.
const DEEPEST: usize = 16;

/// A square of the site.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Quarter {
    /// Indices of the buildings whose middles are in it.
    Buildings(Vec<usize>),
    /// Its quarters that have buildings, with their numbers: 1 is the east, 2 the north.
    Quarters(Vec<(usize, Quarter)>),
}

/// What is divided: the middle of each building, and how many levels it has.
pub(super) type Site<'a> = [([f64; 2], usize)];

/// Divides the square around all buildings.
pub(super) fn divide(site: &Site<'_>) -> Quarter {
    let all: Vec<usize> = (0..site.len()).collect();
    let empty = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    let [low, high] = site.iter().fold(empty, |[low, high], (middle, _)| {
        [[0, 1].map(|axis| low[axis].min(middle[axis])), [0, 1].map(|axis| high[axis].max(middle[axis]))]
    });
    let side = (high[0] - low[0]).max(high[1] - low[1]).max(0.0);
    divided(site, all, Square { low, side }, DEEPEST)
}

#[derive(Clone, Copy)]
struct Square {
    low: [f64; 2],
    side: f64,
}

fn divided(site: &Site<'_>, buildings: Vec<usize>, square: Square, depth: usize) -> Quarter {
    let levels: usize = buildings.iter().map(|&building| site[building].1).sum();
    if levels <= LEVELS_OF_FILE || buildings.len() < 2 || depth == 0 {
        return Quarter::Buildings(buildings);
    }
    let half = square.side / 2.0;
    let middle = square.low.map(|low| low + half);
    let number = |building: usize| {
        let [x, y] = site[building].0;
        usize::from(x >= middle[0]) + 2 * usize::from(y >= middle[1])
    };
    let mut parts: [Vec<usize>; 4] = Default::default();
    buildings.into_iter().for_each(|building| parts[number(building)].push(building));
    let quarter = |(number, buildings): (usize, Vec<usize>)| {
        let offset = [number % 2, number / 2].map(|step| step as f64 * half);
        let low = [square.low[0] + offset[0], square.low[1] + offset[1]];
        (number, divided(site, buildings, Square { low, side: half }, depth - 1))
    };
    let parts = parts.into_iter().enumerate().filter(|(_, buildings)| !buildings.is_empty());
    Quarter::Quarters(parts.map(quarter).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_levels_stay_together_and_many_are_divided() {
        assert_eq!(divide(&[([0.0, 0.0], 100), ([9.0, 9.0], 100)]), Quarter::Buildings(vec![0, 1]));
        let divided = divide(&[([0.0, 0.0], 200), ([9.0, 0.0], 100), ([9.0, 9.0], 90)]);
        let part = |buildings: &[usize]| Quarter::Buildings(buildings.to_vec());
        assert_eq!(divided, Quarter::Quarters(vec![(0, part(&[0])), (1, part(&[1])), (3, part(&[2]))]));
    }

    #[test]
    fn buildings_in_one_place_end_the_division() {
        let site = [([1.0, 1.0], 300), ([1.0, 1.0], 300)];
        let mut quarter = divide(&site);
        let mut depth = 0;
        while let Quarter::Quarters(mut parts) = quarter {
            assert_eq!(parts.len(), 1);
            quarter = parts.remove(0).1;
            depth += 1;
        }
        assert_eq!((quarter, depth), (Quarter::Buildings(vec![0, 1]), DEEPEST));
    }
}
