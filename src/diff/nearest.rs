//! Finds the nearest pairs of two lists of objects without comparing all with all.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::matching::Item;

/// Things that one is compared with in one search, at most: more lie at one distance only where they lie at one place.
const MOST_COMPARED: usize = 256;
/// Searches per object, on average, before the rest is paired in order. If a whole hall was moved by its length, all
/// objects search for the same few.
const SEARCHES_EACH: usize = 64;

/// An object and its place.
type Placed = GeomWithData<[f64; 3], usize>;
/// Bits of the distance, which order as the distance does, then both objects.
type Candidate = Reverse<(u64, usize, usize)>;

/// The rule by which two objects may be a pair.
pub(super) struct Rule<R, P> {
    /// Metres from an object within which its pair is.
    pub(super) reach: R,
    /// Whether two objects at some distance may be one.
    pub(super) is_pair: P,
}

/// The pairs of what is left of two lists, by index, the nearest first, equally near ones in the order of their places in
/// the lists.
pub(super) fn pairs<R: Fn(&Item<'_>) -> f64, P: Fn(&Item<'_>, &Item<'_>, f64) -> bool>(
    old: &[Item<'_>],
    new: &[Item<'_>],
    (left_old, left_new): (Vec<usize>, Vec<usize>),
    rule: &Rule<R, P>,
) -> Vec<(usize, usize)> {
    let is_somewhere = |item: &Item<'_>| item.place.is_finite();
    let places = left_new.iter().filter(|&&index| is_somewhere(&new[index]));
    let places = places.map(|&index| Placed::new(new[index].place.to_array(), index));
    let mut free = RTree::bulk_load(places.collect());
    let nearest = |free: &RTree<Placed>, a: usize| -> Option<Candidate> {
        let found = nearest_to(&old[a], new, free, rule);
        found.map(|(distance, b)| Reverse((distance.to_bits(), a, b)))
    };
    let searching = left_old.iter().filter(|&&index| is_somewhere(&old[index]));
    let mut queue: BinaryHeap<Candidate> = searching.filter_map(|&a| nearest(&free, a)).collect();
    let most = SEARCHES_EACH * (left_old.len() + left_new.len());
    let (mut pairs, mut searches) = (Vec::new(), 0);
    while let Some(Reverse((_, a, b))) = queue.pop() {
        if free.remove(&Placed::new(new[b].place.to_array(), b)).is_some() {
            pairs.push((a, b));
        } else if searches < most {
            // Somebody nearer took it.
            searches += 1;
            queue.extend(nearest(&free, a));
        } else {
            pairs.extend(first_free(&old[a], new, &mut free, rule).map(|b| (a, b)));
        }
    }
    pairs
}

/// The nearest free object that may be the pair of another, with its distance; of equally near ones the first in the list.
fn nearest_to<R: Fn(&Item<'_>) -> f64, P: Fn(&Item<'_>, &Item<'_>, f64) -> bool>(
    one: &Item<'_>,
    new: &[Item<'_>],
    free: &RTree<Placed>,
    rule: &Rule<R, P>,
) -> Option<(f64, usize)> {
    let (mut best, reach): (Option<(f64, usize)>, f64) = (None, (rule.reach)(one));
    for other in free.nearest_neighbor_iter(&one.place.to_array()).take(MOST_COMPARED) {
        let distance = one.place.distance(new[other.data].place);
        if distance > best.map_or(reach, |(nearest, _)| nearest) {
            break;
        }
        if (rule.is_pair)(one, &new[other.data], distance) {
            let first = best.map_or(other.data, |(_, known)| known.min(other.data));
            best = Some((distance, first));
        }
    }
    best
}

/// The first free object that may be the pair of another.
fn first_free<R, P: Fn(&Item<'_>, &Item<'_>, f64) -> bool>(
    one: &Item<'_>,
    new: &[Item<'_>],
    free: &mut RTree<Placed>,
    rule: &Rule<R, P>,
) -> Option<usize> {
    let may_be = |b: usize| (rule.is_pair)(one, &new[b], one.place.distance(new[b].place));
    let found = *free.iter().take(MOST_COMPARED).find(|other| may_be(other.data))?;
    free.remove(&found);
    Some(found.data)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn item(id: &str, place: (f64, f64)) -> Item<'_> {
        Item {
            id: id.to_owned(),
            class: "chair",
            place: DVec3::new(place.0, place.1, 0.0),
            on: "floor",
            reach: 0.25,
        }
    }

    #[expect(clippy::type_complexity, reason = "closures have no names")]
    fn anywhere() -> Rule<fn(&Item<'_>) -> f64, fn(&Item<'_>, &Item<'_>, f64) -> bool> {
        Rule { reach: |_| f64::INFINITY, is_pair: |_, _, _| true }
    }

    fn all(items: &[Item<'_>]) -> Vec<usize> {
        (0..items.len()).collect()
    }

    /// The pairs of asking all.
    fn slowly(old: &[Item<'_>], new: &[Item<'_>], most: f64) -> Vec<(usize, usize)> {
        let mut near: Vec<(f64, usize, usize)> = Vec::new();
        for (a, one) in old.iter().enumerate() {
            for (b, other) in new.iter().enumerate() {
                let distance = one.place.distance(other.place);
                if distance <= most {
                    near.push((distance, a, b));
                }
            }
        }
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for (_, a, b) in near {
            if !pairs.iter().any(|&(one, other)| one == a || other == b) {
                pairs.push((a, b));
            }
        }
        pairs
    }

    #[test]
    fn the_pairs_are_those_of_comparing_all_with_all() {
        let scatter = |index: usize, step: usize| ((index * step) % 97) as f64 / 8.0;
        let old: Vec<_> = (0..90).map(|index| item("", (scatter(index, 31), scatter(index, 53)))).collect();
        // Many at equal distances, on a lattice.
        let new: Vec<_> = (0..80).map(|index| item("", (scatter(index, 29), scatter(index, 61)))).collect();
        for most in [0.5, 2.0, f64::INFINITY] {
            let rule = Rule { reach: |_: &Item<'_>| most, is_pair: |_: &Item<'_>, _: &Item<'_>, _| true };
            let found = pairs(&old, &new, (all(&old), all(&new)), &rule);
            assert_eq!(found, slowly(&old, &new, most), "up to {most} m");
        }
    }

    #[test]
    fn objects_without_a_finite_place_have_no_pair() {
        let (old, new) =
            ([item("", (f64::NAN, 0.0))], [item("", (f64::INFINITY, 0.0)), item("", (0.0, 0.0))]);
        assert_eq!(pairs(&old, &new, (all(&old), all(&new)), &anywhere()), []);
    }

    #[test]
    fn eight_times_the_objects_take_little_more_than_eight_times_the_comparisons() {
        let scatter = |index: u64, step: u64| ((index * step) % 7919) as f64 / 80.0;
        let comparisons = |count: u64| {
            let things = |from: u64| {
                (from..from + count).map(|index| item("", (scatter(index, 31), scatter(index, 5413))))
            };
            let (old, new): (Vec<_>, Vec<_>) = (things(0).collect(), things(10_000).collect());
            let compared = core::cell::Cell::new(0_u32);
            let is_pair = |_: &Item<'_>, _: &Item<'_>, _| {
                compared.set(compared.get() + 1);
                true
            };
            let rule = Rule { reach: |_: &Item<'_>| f64::INFINITY, is_pair };
            assert_eq!(pairs(&old, &new, (all(&old), all(&new)), &rule).len(), old.len());
            f64::from(compared.get())
        };
        let ratio = comparisons(4000) / comparisons(500);
        assert!(ratio < libm::pow(8.0, 1.3), "{ratio}");
    }

    #[test]
    fn a_hall_that_was_moved_by_its_length_is_paired_all_the_same() {
        let row = |from: f64| (0..3000).map(move |index| item("", (from + f64::from(index) * 0.1, 0.0)));
        let (old, new): (Vec<_>, Vec<_>) = (row(0.0).collect(), row(1000.0).collect());
        assert_eq!(pairs(&old, &new, (all(&old), all(&new)), &anywhere()).len(), 3000);
    }
}
