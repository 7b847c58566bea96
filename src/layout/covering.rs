//! Rugs: what lies flat on the floor under other furniture.
//!
//! Not in the paper. They are laid when all others rest and are in nobody's way, so that a room is the same with and
//! without them.

use crate::catalog::{Access, Class, ClassIndex, Clearance, Side, Size};
use crate::geometry::{Point, Solid};

use super::agent::{Rest, State};
use super::arrange::{area, sizes_by, take_size};
use super::body::{Pose, box_solid};
use super::constants::CONTACT_TOLERANCE;
use super::environment::Environment;
use super::furnished::RemovalReason;
use super::place::{AgentIndex, ParentPart, Place};

/// Metres by which a rug is wider than what stands on its middle, on either side.
const OVERHANG: f64 = 0.25;
/// Metres by which it is wider than a table on the sides where people sit: a chair that is pulled back keeps its hind legs
/// on it.
const SEAT_OVERHANG: f64 = 0.6;
/// Metres that are good behind the edge of a table where grown-ups sit. Children's chairs want less, and rugs are also
/// played on.
const GROWN_UP: f64 = 0.9;
/// Metres by which it sticks out before what is too deep to stand on it whole: feet step on it.
const FOOT: f64 = 0.5;
/// Metres by which it is moved, to either side and to and fro, where it does not lie free in the middle.
const SHIFTS: [f64; 5] = [0.0, 0.1, -0.1, 0.2, -0.2];

/// Lays all that covers the floor, in the order of the programme.
pub(crate) fn lay(environment: &mut Environment<'_>) {
    for agent in 0..environment.agents.len() {
        let is_waiting = environment.agents[agent].state == State::Search;
        if !is_waiting || environment.class(agent).covers.is_empty() {
            continue;
        }
        match free_place(environment, agent) {
            Some((variant, place)) => {
                take_size(environment, agent, variant);
                environment.settle(agent, &place);
            }
            None => environment.agents[agent].state = State::Removed(RemovalReason::NoPlace),
        }
    }
}

/// Under the first piece that it has room under, in the largest size that has; nowhere where wheels would catch in it.
fn free_place(environment: &Environment<'_>, agent: AgentIndex) -> Option<(u32, Place)> {
    if environment.brief.style.access == Access::Wheelchair {
        return None;
    }
    let class = environment.class(agent);
    let sizes = sizes_by(environment, agent, area);
    let theirs = others_covered(environment, class);
    let anchors = class.covers.iter().flat_map(|&class| &environment.resting[class]);
    // The first piece with room for a rug, in the order of the class's list, then of coming to rest.
    anchors.into_iter().find_map(|&anchor| {
        let rest = environment.agents[anchor].rest()?;
        let under = Under::new(environment.class(anchor), environment.agents[anchor].size);
        // Around a table no rug is wider than it needs to be; elsewhere more is better.
        let count = sizes.len();
        let best = |rank: usize| sizes[if under.has_chairs { count - 1 - rank } else { rank }];
        (0..count).map(best).find_map(|variant| {
            let size = class.size(variant);
            let pose = poses(rest, under, size)
                .find(|pose| is_free(environment, &box_solid(size, pose), &theirs))?;
            Some((variant, Place { pose, parent: ParentPart::Floor, side: Side::Above }))
        })
    })
}

/// The classes that other rugs lie under and this one does not: half a rug under a dining table is under the wrong one.
fn others_covered(environment: &Environment<'_>, class: &Class) -> Vec<ClassIndex> {
    let others = environment.brief.catalog.classes.iter().filter(|other| other.id != class.id);
    others
        .flat_map(|other| &other.covers)
        .copied()
        .filter(|covered| !class.covers.contains(covered))
        .collect()
}

/// The piece that a rug lies under.
#[derive(Clone, Copy)]
struct Under {
    size: Size,
    /// Metres by which the rug is wider, on its left and right, and deeper, at its front and back.
    overhang: Point,
    /// Whether chairs stand on the rug, which lies around a table.
    has_chairs: bool,
}

impl Under {
    fn new(class: &Class, size: Size) -> Self {
        // By the clearance, not by the class: users' own tables have rugs of the right size too.
        let is_seat = |it: &Clearance| it.allows_children && it.good >= GROWN_UP;
        let is_sat_at = |side: Side| class.clearances.iter().any(|it| it.side == side && is_seat(it));
        let most = |a: Side, b: Side| if is_sat_at(a) || is_sat_at(b) { SEAT_OVERHANG } else { OVERHANG };
        // A place for a seat before a bed or sofa is none at a table.
        let has_chairs = is_sat_at(Side::Front) && is_sat_at(Side::Back);
        let around = Point::new(most(Side::Left, Side::Right), SEAT_OVERHANG);
        Self { size, overhang: if has_chairs { around } else { Point::splat(OVERHANG) }, has_chairs }
    }
}

/// Where a rug of a size may lie under a piece, best first: around its middle, or, under a bed, so far before it that feet
/// step on the rug. None where the rug is too narrow, or too small for the chairs around a table.
fn poses(rest: &Rest, under: Under, size: Size) -> impl Iterator<Item = Pose> {
    let right = rest.pose.right;
    let front = -right.perp();
    let Under { size: piece, overhang, has_chairs } = under;
    let holds_whole = size.depth >= piece.depth + 2.0 * overhang.y;
    let is_large_enough = size.width >= piece.width + 2.0 * overhang.x && (holds_whole || !has_chairs);
    // Of a bed the rug reaches FOOT beyond the foot end and goes under it as far as it is long.
    let before = if holds_whole { 0.0 } else { piece.depth / 2.0 + FOOT - size.depth / 2.0 };
    let middle = rest.pose.position + front * before;
    // Around a table it lies in the middle: moved, it would leave the chairs of one side. Under a bed, too, or, where that has a
    // wall or a cupboard at one side, at the other alone.
    let aside = (size.width - piece.width) / 2.0;
    let (across, along) = match (has_chairs, holds_whole) {
        (true, _) => (vec![0.0], vec![0.0]),
        (false, true) => (SHIFTS.to_vec(), SHIFTS.to_vec()),
        (false, false) => (vec![0.0, aside, -aside], SHIFTS.to_vec()),
    };
    let shifts = across
        .into_iter()
        .flat_map(move |across| along.clone().into_iter().map(move |along| Point::new(across, along)));
    let angle = rest.pose.angle;
    shifts
        .filter(move |_| is_large_enough)
        .map(move |shift| Pose::new(middle + right * shift.x + front * shift.y, 0.0, angle))
}

/// Whether a rug can lie there: two never lie on each other.
fn is_free(environment: &Environment<'_>, whole: &Solid, theirs: &[ClassIndex]) -> bool {
    let is_rug = |agent: &AgentIndex| !environment.class(*agent).covers.is_empty();
    let mut rugs = (0..environment.agents.len()).filter(is_rug).filter_map(|agent| {
        let rest = environment.agents[agent].rest()?;
        Some(box_solid(environment.agents[agent].size, &rest.pose))
    });
    environment.can_be_covered(whole, theirs) && !rugs.any(|rug| rug.overlaps(whole, CONTACT_TOLERANCE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Catalog, builtin_catalog};
    use crate::layout::tests::{WIDE, level, run};
    use crate::layout::{Furnished, Parent, Placement};

    const TABLE: Size = Size { width: 1.1, depth: 0.6, height: 0.4 };
    const BED: Size = Size { width: 1.6, depth: 2.1, height: 0.5 };
    const RUG: Size = Size { width: 2.4, depth: 1.7, height: 0.012 };

    fn at_zero() -> Rest {
        let pose = Pose::new(Point::ZERO, 0.0, 0.0);
        Rest { pose, parent: ParentPart::Floor, side: Side::Above, extent: 0.0 }
    }

    fn best(under: Size, rug: Size) -> Option<Point> {
        best_under(Under { size: under, overhang: Point::splat(OVERHANG), has_chairs: false }, rug)
    }

    fn best_under(under: Under, rug: Size) -> Option<Point> {
        poses(&at_zero(), under, rug).next().map(|pose| pose.position)
    }

    #[test]
    fn a_rug_lies_around_a_table_and_before_a_bed_that_it_is_wide_enough_for() {
        assert_eq!(best(TABLE, RUG), Some(Point::ZERO));
        // The front is to the south, where feet step on half a metre of it.
        let middle = best(BED, RUG).unwrap();
        assert!((middle.y - RUG.depth / 2.0 + BED.depth / 2.0 + FOOT).abs() < 1e-12);
        assert_eq!(best(BED, Size { width: 2.0, ..RUG }), None);
    }

    #[test]
    fn a_rug_under_a_dining_table_holds_the_chairs_around_it() {
        let catalog = builtin_catalog();
        let under = |id: &str| {
            let class = &catalog.classes[catalog.class_index(id).unwrap()];
            Under::new(class, class.sizes[0])
        };
        let table = under("dining_table");
        assert_eq!(table.overhang, Point::splat(SEAT_OVERHANG));
        assert_eq!(under("kitchen_table").overhang, Point::new(OVERHANG, SEAT_OVERHANG));
        assert!(!under("sofa").has_chairs && !under("child_table").has_chairs);
        let large = Size { width: 3.1, depth: 2.1, height: 0.012 };
        assert_eq!(best_under(table, large), Some(Point::ZERO));
        assert_eq!(best_under(table, Size { depth: 2.0, ..large }), None);
        assert_eq!(best_under(table, Size { width: 2.9, ..large }), None);
    }

    #[test]
    fn under_a_bed_at_a_wall_a_rug_reaches_out_at_the_other_side() {
        let under = Under { size: BED, overhang: Point::splat(OVERHANG), has_chairs: false };
        let mut decimetres: Vec<f64> =
            poses(&at_zero(), under, RUG).map(|pose| (pose.position.x * 10.0).round()).collect();
        decimetres.dedup();
        assert_eq!(decimetres, [0.0, 4.0, -4.0]);
    }

    #[test]
    fn no_rug_of_the_sofa_lies_under_a_piece_of_the_dining_table() {
        let catalog = builtin_catalog();
        let mut level = level(WIDE);
        level.rooms[0].room_type = "living_dining".to_owned();
        let rug = catalog.class_index("rug").unwrap();
        let dines = ["dining_table", "large_dining_table", "small_table", "dining_chair"];
        let dines: Vec<ClassIndex> = dines.iter().filter_map(|id| catalog.class_index(id)).collect();
        let floor = |placement: &Placement| {
            box_solid(placement.size, &Pose::new(placement.position, 0.0, placement.angle))
        };
        let mut count = 0;
        for room in (0..20).map(|seed| run(&level, catalog, seed)) {
            let at_table = || room.placements.iter().filter(|placement| dines.contains(&placement.class));
            for laid in room.placements.iter().filter(|placement| placement.class == rug) {
                count += at_table().count();
                assert!(!at_table().any(|piece| floor(piece).overlaps(&floor(laid), CONTACT_TOLERANCE)));
            }
        }
        assert!(count > 40, "{count} pieces at tables in rooms with a rug");
    }

    fn living_rooms(catalog: &Catalog) -> Vec<Furnished> {
        let mut level = level(WIDE);
        level.rooms[0].room_type = "living_room".to_owned();
        (0..20).map(|seed| run(&level, catalog, seed)).collect()
    }

    #[test]
    fn a_living_room_is_the_same_with_and_without_its_rug_which_lies_under_no_cupboard() {
        let with = builtin_catalog();
        let rug = with.class_index("rug").unwrap();
        let mut without = with.clone();
        let programme = &mut without.room_types.get_mut("living_room").unwrap().programme;
        programme.retain(|request| request.classes != [rug]);
        let is_rug = |placement: &&Placement| placement.class == rug;
        let mut count = 0;
        for (with_rug, bare) in living_rooms(with).iter().zip(living_rooms(&without)) {
            let all = &with_rug.placements;
            let others: Vec<_> = all.iter().filter(|placement| !is_rug(placement)).cloned().collect();
            assert_eq!(others.len(), bare.placements.len());
            let place =
                |placement: &Placement| (placement.class, placement.position.to_array().map(f64::to_bits));
            assert!(others.iter().map(place).eq(bare.placements.iter().map(place)));
            for laid in all.iter().filter(is_rug) {
                count += 1;
                let floor = |placement: &Placement| {
                    box_solid(placement.size, &Pose::new(placement.position, 0.0, placement.angle))
                };
                let is_storage = |placement: &&Placement| {
                    with.classes[placement.class].groups.iter().any(|group| group == "storage")
                };
                let standing = all
                    .iter()
                    .filter(|placement| placement.parent != Parent::Ceiling && placement.elevation < 0.1);
                assert!(laid.is_covering());
                assert!(!standing.filter(is_storage).any(|other| floor(other).overlaps(&floor(laid), 1e-3)));
            }
        }
        assert!(count > 8, "{count} of 20 rooms have one");
    }

    #[test]
    fn nobody_in_a_wheelchair_gets_a_rug() {
        let mut catalog = builtin_catalog().clone();
        let rug = catalog.class_index("rug").unwrap();
        catalog.styles.values_mut().for_each(|style| style.access = Access::Wheelchair);
        let rooms = living_rooms(&catalog);
        assert!(rooms.iter().flat_map(|room| &room.placements).all(|placement| placement.class != rug));
    }
}
