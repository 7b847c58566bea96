//! The depth of a wall by ray, as a line without steps.

use super::limits::Sector;

/// Metres along the wall in which its depth changes where a room behind begins or ends: its side does not lie in the plane
/// of that room's own wall.
pub(super) const RAMP: f64 = 1e-3;
/// Metres by which a point may lie off a line and count as one of it.
pub(super) const STRAIGHT: f64 = 5e-5;

/// A stretch with the depths at its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) ends: [f64; 2],
    pub(super) depths: [f64; 2],
}

impl Step {
    /// The depth at a place, as if it changed evenly.
    pub(super) fn at(&self, place: f64) -> f64 {
        let ([from, to], [start, end]) = (self.ends, self.depths);
        start + (end - start) * (place - from) / (to - from)
    }
}

/// The corners of a line below all steps: where two meet at unlike depths, the deeper one slopes down to the other.
pub(super) fn without_jumps(steps: &[Step], sector: &Sector) -> Vec<[f64; 2]> {
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else {
        return vec![[sector.from, sector.thickness], [sector.to, sector.thickness]];
    };
    let node = |before: Option<&Step>, after: Option<&Step>| {
        let depths = [before.map(|step| step.depths[1]), after.map(|step| step.depths[0])];
        depths.into_iter().flatten().fold(sector.thickness, f64::min)
    };
    let mut line = vec![[first.ends[0], node(None, Some(first))]];
    for (index, step) in steps.iter().enumerate() {
        let low = line.last().map_or(0.0, |corner| corner[1]);
        let high = node(Some(step), steps.get(index + 1));
        let ([from, to], [start, end]) = (step.ends, step.depths);
        if to - from > 2.0 * RAMP {
            line.extend((start > low + STRAIGHT).then(|| [from + RAMP, step.at(from + RAMP)]));
            line.extend((end > high + STRAIGHT).then(|| [to - RAMP, step.at(to - RAMP)]));
        }
        line.push([to, high]);
    }
    debug_assert!(
        line.last().is_some_and(|corner| corner[0] == last.ends[1]),
        "a line ends where its steps do"
    );
    line
}

/// Gives neighbouring sectors the same depth at the ray that they share; sectors without rays become empty.
pub(super) fn join(profiles: &mut [Vec<[f64; 2]>; 3]) {
    let is_empty =
        |profile: &Vec<[f64; 2]>| profile.first().map(|at| at[0]) == profile.last().map(|at| at[0]);
    let [start, strip, end] = profiles;
    for (fan, is_start) in [(start, true), (end, false)] {
        if is_empty(fan) {
            fan.clear();
            continue;
        }
        let ends = if is_start { (fan.len() - 1, 0) } else { (0, strip.len() - 1) };
        let depth = fan[ends.0][1].min(strip[ends.1][1]);
        lower_end(fan, ends.0, depth);
        lower_end(strip, ends.1, depth);
    }
}

/// Lowers the first or last corner of a line; the rest of the line stays, but for a ramp.
pub(super) fn lower_end(line: &mut Vec<[f64; 2]>, index: usize, depth: f64) {
    let next = if index == 0 { 1 } else { index - 1 };
    let ([at, old], [next_at, next_depth]) = (line[index], line[next]);
    line[index][1] = depth;
    let distance = next_at - at;
    if old > depth + STRAIGHT && distance.abs() > 2.0 * RAMP {
        let share = RAMP / distance.abs();
        line.insert(index.max(next), [at + distance * share, old + (next_depth - old) * share]);
    }
}
