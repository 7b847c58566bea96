//! Railings of posts and rails.

use super::solid::Solid;
use super::ticks::Ticks;
use crate::recipes::Slot;

/// A railing in the frame of a wall ([`super::wall::WallShape`]).
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct RailingShape {
    /// Length of the inner face.
    pub length: Ticks,
    /// Depth of the strip it stands on, behind the inner face.
    pub thickness: Ticks,
    /// Top of the handrail.
    pub height: Ticks,
    /// Where people pass, as `u`.
    pub gaps: Vec<(Ticks, Ticks)>,
    /// Material.
    pub slot: Slot,
}

/// Side of a post's square section.
const POST: Ticks = Ticks(4_000);
/// Handrail: height, depth.
const HANDRAIL: [Ticks; 2] = [Ticks(4_000), Ticks(5_000)];
/// Lower rails: height and depth.
const RAIL: Ticks = Ticks(2_000);
/// Least depth of a bar: in the thinnest strip it stands out by half of it.
const LEAST_DEPTH: Ticks = Ticks(1_600);
/// Furthest distance of posts.
const POST_INTERVAL: i32 = 120_000;
/// Furthest clear height between rails.
const RAIL_INTERVAL: i32 = 25_000;

impl RailingShape {
    /// The body; the underside of the posts stands in the floor.
    pub(crate) fn build(&self, bottom: Ticks) -> Solid {
        let mut solid = Solid::new(self.slot);
        for (from, to) in self.spans() {
            self.span(from, to, bottom, &mut solid);
        }
        solid
    }

    /// The stretches between the gaps.
    fn spans(&self) -> Vec<(Ticks, Ticks)> {
        let mut gaps = self.gaps.clone();
        gaps.sort_unstable();
        let mut spans = Vec::with_capacity(gaps.len() + 1);
        let mut start = Ticks(0);
        for (from, to) in gaps {
            spans.push((start, from));
            start = start.max(to);
        }
        spans.push((start, self.length));
        spans.retain(|(from, to)| *to - *from > POST);
        spans
    }

    fn span(&self, from: Ticks, to: Ticks, bottom: Ticks, solid: &mut Solid) {
        let under = self.height - HANDRAIL[0];
        self.bar([from, to], [under, self.height], HANDRAIL[1], solid);
        // Rails end inside the outer posts, so that their ends lie in no face of a post.
        let inset = Ticks(POST.0 / 2);
        let rails = under.0 / RAIL_INTERVAL;
        for rail in 1..=rails {
            let middle = share(under, rail, rails + 1);
            self.bar([from + inset, to - inset], [middle - RAIL, middle], RAIL, solid);
        }
        let fields = (to - from).0 / POST_INTERVAL + 1;
        for post in 0..=fields {
            let start = from + share(to - from - POST, post, fields);
            self.bar([start, start + POST], [bottom, under], POST, solid);
        }
    }

    /// A bar in the middle of the strip: along the wall, in height, and its depth; of a narrow strip it takes all.
    fn bar(&self, along: [Ticks; 2], height: [Ticks; 2], depth: Ticks, solid: &mut Solid) {
        let depth = depth.min(self.thickness.max(LEAST_DEPTH));
        let x = |u: Ticks| Ticks(self.length.0 / 2) - u;
        let back = Ticks((-self.thickness.0 - depth.0) / 2);
        solid.cuboid([x(along[1]), height[0], back], [x(along[0]), height[1], back + depth]);
    }
}

/// `part / whole` of a length.
fn share(length: Ticks, part: i32, whole: i32) -> Ticks {
    let value = i64::from(length.0) * i64::from(part) / i64::from(whole);
    Ticks(i32::try_from(value).expect("a share is no longer than its whole"))
}
