//! Joins ways to rings.

use std::collections::BTreeMap;

/// The closed rings that ways make, as lists of nodes, and whether some ways are left over. A way may be closed by itself, or be
/// one of several that meet at their ends. The answer does not depend on the order of the ways, which are by id.
pub(super) fn rings_of(ways: &BTreeMap<i64, &[i64]>) -> (Vec<Vec<i64>>, bool) {
    let (closed, open): (Vec<_>, Vec<_>) = ways
        .iter()
        .filter(|(_, nodes)| nodes.len() > 1)
        .partition(|(_, nodes)| nodes.first() == nodes.last());
    let mut rings: Vec<Vec<i64>> = closed.into_iter().map(|(_, nodes)| nodes.to_vec()).collect();
    // The open ways at each end, the first by id last, so that it is taken first.
    let mut at_ends: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (index, (_, nodes)) in open.iter().enumerate().rev() {
        for end in [nodes[0], nodes[nodes.len() - 1]] {
            at_ends.entry(end).or_default().push(index);
        }
    }
    let mut is_used = vec![false; open.len()];
    let mut is_left_over = false;
    for first in 0..open.len() {
        if is_used[first] {
            continue;
        }
        is_used[first] = true;
        let mut ring = open[first].1.to_vec();
        while ring[0] != ring[ring.len() - 1] {
            let end = ring[ring.len() - 1];
            let Some(next) = next_at(end, &mut at_ends, &is_used) else { break };
            is_used[next] = true;
            let nodes = open[next].1;
            if nodes[0] == end {
                ring.extend(&nodes[1..]);
            } else {
                ring.extend(nodes.iter().rev().skip(1));
            }
        }
        if ring[0] == ring[ring.len() - 1] {
            rings.push(ring);
        } else {
            is_left_over = true;
        }
    }
    (rings, is_left_over)
}

/// The first way at a node that is not used; used ones are taken off its list, so that all lists are gone through once.
fn next_at(node: i64, at_ends: &mut BTreeMap<i64, Vec<usize>>, is_used: &[bool]) -> Option<usize> {
    let ways = at_ends.get_mut(&node)?;
    while let Some(way) = ways.pop() {
        if !is_used[way] {
            return Some(way);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rings(ways: &[(i64, &[i64])]) -> (Vec<Vec<i64>>, bool) {
        rings_of(&ways.iter().copied().collect())
    }

    #[test]
    fn ways_that_meet_at_their_ends_are_a_ring() {
        assert_eq!(
            rings(&[(1, &[1, 2, 3]), (2, &[1, 5, 4]), (3, &[4, 3])]),
            (vec![vec![1, 2, 3, 4, 5, 1]], false)
        );
        assert_eq!(rings(&[(9, &[1, 2, 3, 1]), (1, &[7, 8]), (2, &[8, 9, 7])]).0.len(), 2);
    }

    #[test]
    fn ways_without_a_ring_are_left_over() {
        assert_eq!(rings(&[(1, &[1, 2, 3]), (2, &[3, 4])]), (vec![], true));
        assert_eq!(rings(&[(1, &[1]), (2, &[])]), (vec![], false));
    }
}
