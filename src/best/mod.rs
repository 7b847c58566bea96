//! The best of several arrangements: furnishes a room from derived seeds until the audit has no finding, a few times at most.
//!
//! This is a stage of its own because `layout/` knows no audit, and `audit/` and `solve/` change no layout. The paper furnishes
//! each room once. Ranking arrangements by the quality of the room follows P. Merrell et al., "Interactive Furniture Layout Using
//! Interior Design Guidelines", 2011.

use core::cmp::Ordering;

use crate::audit::{Code, Finding, Severity, Verdict};
use crate::catalog::Catalog;
use crate::layout::{
    Alternative, Counted, FurnishOptions, Furnished, PoorPlaces, RoomLayout, Shortcomings, StandIns,
    Suggestion,
};
use crate::plan::RoomRef;
use crate::solve::RoomSolver;

/// How often a room is furnished at most where nothing else is said. Chosen by measurement: `docs/figures.md`, "Effort".
pub const DEFAULT_EFFORT: u32 = 16;

/// How many alternatives in a row may bring nothing better while the best room has no finding that depends on where its pieces
/// stand ([`Code::is_of_places`]): it may have no place for more. Larger: more time for such rooms, long corridors above
/// all, for a few pieces more.
const PATIENCE: u32 = 4;

/// Steps of the layout ([`Counted`]) and of the solver after which no further alternative begins. Of 10,454
/// random rooms, 91.2 % have no finding with so many, and 91.5 % without a limit, where the slowest takes fifty times as
/// long.
const MOST_STEPS: u64 = 700_000;

/// The same while the best room fails, and while nothing but something small is missing in it: of 138,000 pieces (14 levels of homes,
/// seeds 1 to 6) ten more have no place than without the latter, and a bake takes some 3 % less time.
const MOST_STEPS_OF_FAILING: u64 = 1_600_000;
const MOST_STEPS_OF_LACKING: u64 = 150_000;
/// Steps of the solver ([`RoomSolver::steps`]) in the time of one of the layout.
const SOLVER_STEPS_A_STEP: u64 = 40;

/// How often a room is furnished at most with the places that the solver suggests.
const SUGGESTED_ALTERNATIVES: u32 = 3;

/// How often a room that fails after all other help is furnished at most with all of it at once. Of 330,000 rooms of whole maps some
/// twenty come to this.
const ALTERNATIVES_WITH_ALL_HELP: u32 = 8;
/// The last of these put the required pieces before all others.
const ALTERNATIVES_WITH_REQUIRED_FIRST: u32 = 4;

/// Missing pieces that are as bad as a bed at the swing of a door, or as a tub, a tray or a bed for one that has both sides open.
/// Larger: fewer of them, for more small things that have no place.
const AT_SWING: usize = 2;
const OPEN_SIDES: usize = 2;
/// The same for a strip of a niche that nothing fits into.
const REST_OF_NICHE: usize = 1;

/// A furnished room with what the audit says about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The room.
    pub furnished: Furnished,
    /// The verdict on it.
    pub verdict: Verdict,
    /// Which alternative it is.
    pub alternative: Alternative,
    /// What it lacks, beside the removals and what the audit has findings of.
    pub shortcomings: Shortcomings,
}

/// Furnishes one room up to `effort` times (at least once) and keeps the best.
///
/// The answer depends on the arguments only. A greater effort never gives a
/// worse room, and with an effort of 1 the room is that of [`crate::layout::furnish`], but for rooms in which the solver
/// has to suggest places: these are furnished a few times more, from seeds that follow the effort.
#[must_use]
pub fn furnish_best(at: RoomRef<'_>, catalog: &Catalog, options: &FurnishOptions<'_>, effort: u32) -> Judged {
    let layout = RoomLayout::new(at, catalog, options);
    let solver = RoomSolver::new(at, catalog);
    best_of(
        effort,
        |alternative| layout.furnish(alternative),
        |furnished| solver.judge(furnished),
        |furnished| solver.suggest_places(furnished),
        || solver.steps(),
    )
}

/// The loop of [`furnish_best`], for callers that measure its parts: the first alternative without a finding,
/// with all that was asked for and no [`PoorPlaces`], else the best of `effort`; of equals the earlier one. A room without
/// a finding in which a piece is missing is not tried so often, for it may have no place. If the best misses a required piece and the
/// solver found a place for it, a few more follow that try this place first; if it still misses one, a last one in which
/// others may stand in for it. `solver_steps` says what the
/// solver spent on the room so far, as [`RoomSolver::steps`].
pub fn best_of(
    effort: u32,
    furnish: impl FnMut(&Alternative) -> Counted,
    judge: impl FnMut(&Furnished) -> Verdict,
    mut suggest: impl FnMut(&Furnished) -> Vec<Suggestion>,
    solver_steps: impl Fn() -> u64,
) -> Judged {
    let mut maker = Maker { furnish, judge, steps: 0 };
    // From the cheapest help to the dearest, each only where the one before left something missing.
    let best = best_numbered(effort, &mut maker, solver_steps);
    let best = with_suggested_places(best, effort, &mut maker, &mut suggest);
    let best = with_substitutes(best, effort, &mut maker);
    with_all_help(best, effort, &mut maker, &mut suggest)
}

/// Makes alternatives, and counts the steps of the layout.
struct Maker<F, J> {
    furnish: F,
    judge: J,
    steps: u64,
}

impl<F: FnMut(&Alternative) -> Counted, J: FnMut(&Furnished) -> Verdict> Maker<F, J> {
    fn make(&mut self, alternative: Alternative) -> Judged {
        let made = self.furnish(&alternative);
        self.judge(made, alternative)
    }

    /// An alternative if it is better than another; no more work is spent on one that cannot be.
    fn make_better(&mut self, than: &Judged, alternative: Alternative) -> Option<Judged> {
        let Flaws { failed, minor, given, lesser } = than.flaws();
        let has_no_finding = failed + minor + given == 0;
        let gives_up_at = has_no_finding.then(|| u32::try_from(lesser).unwrap_or(u32::MAX));
        let alternative = Alternative { gives_up_at, ..alternative };
        let made = self.furnish(&alternative);
        let is_worse = has_no_finding && lesser_flaws(&made.furnished, &made.shortcomings) > lesser;
        if made.is_given_up || is_worse {
            return None;
        }
        Some(self.judge(made, alternative)).filter(|next| next.is_better_than(than))
    }

    fn furnish(&mut self, alternative: &Alternative) -> Counted {
        let made = (self.furnish)(alternative);
        self.steps += made.steps;
        made
    }

    fn judge(&mut self, made: Counted, alternative: Alternative) -> Judged {
        let Counted { furnished, shortcomings, .. } = made;
        let verdict = (self.judge)(&furnished);
        Judged { furnished, verdict, alternative, shortcomings }
    }
}

/// The best of the alternatives up to `effort`.
fn best_numbered<F: FnMut(&Alternative) -> Counted, J: FnMut(&Furnished) -> Verdict>(
    effort: u32,
    maker: &mut Maker<F, J>,
    solver_steps: impl Fn() -> u64,
) -> Judged {
    let mut best = maker.make(Alternative::default());
    let mut in_vain = 0;
    for number in 1..effort {
        let is_enough = best.is_flawless() || (best.lacks_pieces_only() && in_vain >= PATIENCE);
        if is_enough || maker.steps + solver_steps() / SOLVER_STEPS_A_STEP >= best.most_steps() {
            break;
        }
        match maker.make_better(&best, Alternative::numbered(number)) {
            Some(next) => (best, in_vain) = (next, 0),
            None => in_vain += 1,
        }
    }
    best
}

/// The best of a room and of alternatives that try the places which the solver suggests for what it misses, numbered from
/// `effort` on.
fn with_suggested_places<F: FnMut(&Alternative) -> Counted, J: FnMut(&Furnished) -> Verdict>(
    mut best: Judged,
    effort: u32,
    maker: &mut Maker<F, J>,
    suggest: &mut impl FnMut(&Furnished) -> Vec<Suggestion>,
) -> Judged {
    for number in effort..effort.saturating_add(SUGGESTED_ALTERNATIVES) {
        if !best.misses_required() {
            break;
        }
        // Asked again each time: the best room may miss another piece by now.
        let suggestions = suggest(&best.furnished);
        if suggestions.is_empty() {
            break;
        }
        let alternative = Alternative { suggestions, ..Alternative::numbered(number) };
        best = maker.make_better(&best, alternative).unwrap_or(best);
    }
    best
}

/// The best of a room and, where it lacks a required piece after all, of one more alternative in which others may stand in
/// for such pieces.
fn with_substitutes<F: FnMut(&Alternative) -> Counted, J: FnMut(&Furnished) -> Verdict>(
    best: Judged,
    effort: u32,
    maker: &mut Maker<F, J>,
) -> Judged {
    if best.required_missing() == 0 || !best.shortcomings.stand_ins.are_left {
        return best;
    }
    let number = effort.saturating_add(SUGGESTED_ALTERNATIVES);
    let other = maker.make(Alternative { takes_substitutes: true, ..Alternative::numbered(number) });
    let lack = |judged: &Judged| {
        let Flaws { failed, minor, .. } = judged.flaws();
        // Before the minor findings: a stand-in with a tight side is better than nothing.
        (failed, judged.required_missing(), minor)
    };
    if lack(&other) < lack(&best) { other } else { best }
}

/// The best of a room and, where it fails after all, of a few more alternatives with all help at once: places that the solver
/// suggests, pieces that stand in for others, and ways that are cleared of what the room can do without; then with the required
/// pieces before all others, too.
fn with_all_help<F: FnMut(&Alternative) -> Counted, J: FnMut(&Furnished) -> Verdict>(
    mut best: Judged,
    effort: u32,
    maker: &mut Maker<F, J>,
    suggest: &mut impl FnMut(&Furnished) -> Vec<Suggestion>,
) -> Judged {
    // The numbers before are those of the other helps.
    let first = effort.saturating_add(SUGGESTED_ALTERNATIVES).saturating_add(1);
    for number in first..first.saturating_add(ALTERNATIVES_WITH_ALL_HELP) {
        if best.flaws().failed == 0 {
            break;
        }
        let alternative = Alternative {
            suggestions: suggest(&best.furnished),
            takes_substitutes: true,
            puts_required_first: number - first
                >= ALTERNATIVES_WITH_ALL_HELP - ALTERNATIVES_WITH_REQUIRED_FIRST,
            ..Alternative::numbered(number)
        };
        best = maker.make_better(&best, alternative).unwrap_or(best);
    }
    best
}

impl Judged {
    /// How many required pieces are missing, whether or not the room could hold them.
    fn required_missing(&self) -> usize {
        self.furnished.removals.iter().filter(|removal| removal.is_required).count()
    }

    /// Whether another alternative cannot be better.
    fn is_flawless(&self) -> bool {
        self.flaws() == Flaws::default()
    }

    /// Whether what stands there stands well, though something small may be missing.
    fn lacks_pieces_only(&self) -> bool {
        let is_given = |finding: &Finding| finding.severity == Severity::Given;
        let is_well =
            self.shortcomings.poor_places.at_swings == 0 && self.shortcomings.stand_ins.spent_lists == 0;
        is_well
            && self.verdict.findings.iter().all(|finding| is_given(finding) || !finding.code.is_of_places())
    }

    /// Whether no more is wrong than that something has no place which the room does not need, and for which nothing stands in.
    fn lacks_small_things_only(&self) -> bool {
        self.lacks_pieces_only()
            && self.required_missing() == 0
            && self.shortcomings.stand_ins.steps_down == 0
    }

    /// Steps after which no further alternative begins.
    fn most_steps(&self) -> u64 {
        // A room that fails may take longer than one that merely could be better.
        if self.flaws().failed > 0 {
            MOST_STEPS_OF_FAILING
        } else if self.lacks_small_things_only() {
            MOST_STEPS_OF_LACKING
        } else {
            MOST_STEPS
        }
    }

    /// Whether it fails because a required piece is missing.
    fn misses_required(&self) -> bool {
        let is_such =
            |finding: &Finding| finding.code == Code::MissingRequired && finding.severity == Severity::Failed;
        self.verdict.findings.iter().any(is_such)
    }

    /// Whether it has fewer flaws, or as few and a higher score.
    fn is_better_than(&self, other: &Self) -> bool {
        let score = |judged: &Self| judged.verdict.score.map_or(0.0, |score| score.value);
        // Counts before scores: a score is a mean, in which one failing finding is a small part.
        match self.flaws().cmp(&other.flaws()) {
            Ordering::Less => true,
            Ordering::Equal => score(self) > score(other),
            Ordering::Greater => false,
        }
    }

    /// What alternatives are compared by first.
    fn flaws(&self) -> Flaws {
        let count = |severity: Severity| {
            self.verdict.findings.iter().filter(|finding| finding.severity == severity).count()
        };
        Flaws {
            failed: count(Severity::Failed),
            minor: count(Severity::Minor),
            given: count(Severity::Given) + self.required_missing(),
            lesser: lesser_flaws(&self.furnished, &self.shortcomings),
        }
    }
}

/// What counts after all findings. A television that a reading corner stands in for, the third of its list, is as bad as three small
/// things that are missing.
fn lesser_flaws(furnished: &Furnished, shortcomings: &Shortcomings) -> usize {
    let StandIns { steps_down, .. } = shortcomings.stand_ins;
    let PoorPlaces { at_swings, open_sides, rests_of_niches } = shortcomings.poor_places;
    let missing = furnished.removals.len() + steps_down as usize;
    missing + AT_SWING * at_swings + OPEN_SIDES * open_sides + REST_OF_NICHE * rests_of_niches
}

/// What is wrong with an alternative, the worst first: they are compared in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Flaws {
    /// Findings that fail the room.
    failed: usize,
    /// Minor findings.
    minor: usize,
    /// Findings that the plan is said to make unavoidable, and required pieces that are missing.
    given: usize,
    /// Pieces that are missing or for which others stand in, and poor places.
    lesser: usize,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::testing::found;
    use crate::catalog::{Size, StyleRef};
    use crate::geometry::Point;
    use crate::layout::{Removal, RemovalReason};

    fn empty(_: &Alternative) -> Counted {
        counted(nothing())
    }

    fn counted(furnished: Furnished) -> Counted {
        Counted { furnished, steps: 1, shortcomings: Shortcomings::default(), is_given_up: false }
    }

    fn with_poor_places(poor_places: PoorPlaces) -> Counted {
        let shortcomings = Shortcomings { poor_places, ..Shortcomings::default() };
        Counted { shortcomings, ..counted(nothing()) }
    }

    fn nothing() -> Furnished {
        Furnished {
            room: 0,
            seed: 0,
            style: StyleRef::default(),
            requested: 0,
            placements: Vec::new(),
            removals: Vec::new(),
        }
    }

    /// A room with so many failing and minor findings; the last numbers are those of all that follow.
    fn judged(effort: u32, flaws: &[(usize, usize)]) -> (u32, usize) {
        let mut made = 0;
        let judge = |_: &Furnished| {
            let (failed, minor) = flaws[made.min(flaws.len() - 1)];
            made += 1;
            let findings = (0..failed).map(|_| found(Code::Collision, &[]));
            let findings = findings.chain((0..minor).map(|_| found(Code::TightUse, &[]))).collect();
            Verdict { findings, ..Verdict::default() }
        };
        let best = best_of(effort, empty, judge, |_| Vec::new(), || 0);
        (best.alternative.number, made)
    }

    #[test]
    fn no_alternative_begins_when_the_steps_of_a_room_are_spent() {
        let mut made = 0;
        let furnish = |_: &Alternative| {
            made += 1;
            Counted { steps: MOST_STEPS / 3, ..counted(nothing()) }
        };
        let judge =
            |_: &Furnished| Verdict { findings: vec![found(Code::TightUse, &[])], ..Verdict::default() };
        let _ = best_of(16, furnish, judge, |_| Vec::new(), || 0);
        assert_eq!(made, 4);
    }

    #[test]
    fn the_first_room_without_a_finding_ends_the_search() {
        assert_eq!(judged(8, &[(0, 0)]), (0, 1));
        assert_eq!(judged(8, &[(0, 2), (0, 0)]), (1, 2));
    }

    #[test]
    fn a_room_without_findings_that_lacks_a_piece_is_not_tried_for_ever() {
        let mut made = 0;
        let lacking = |_: &Alternative| {
            made += 1;
            let removals = vec![Removal { class: 0, reason: RemovalReason::NoPlace, is_required: false }];
            counted(Furnished { removals, ..nothing() })
        };
        let best = best_of(16, lacking, |_| Verdict::default(), |_| Vec::new(), || 0);
        assert_eq!((best.alternative.number, made), (0, 1 + PATIENCE));
    }

    #[test]
    fn of_a_room_that_lacks_small_things_no_alternative_is_judged_that_lacks_as_many() {
        // How many pieces the alternatives miss.
        let mut missing = [2, 2, 1, 1, 3].into_iter();
        let mut bounds = Vec::new();
        let furnish = |alternative: &Alternative| {
            bounds.push(alternative.gives_up_at);
            let removal = |_| Removal { class: 0, reason: RemovalReason::NoPlace, is_required: false };
            let removals: Vec<Removal> = (0..missing.next().unwrap()).map(removal).collect();
            let is_given_up = alternative.gives_up_at.is_some_and(|most| removals.len() >= most as usize);
            Counted { is_given_up, ..counted(Furnished { removals, ..nothing() }) }
        };
        let mut judged = 0;
        let judge = |_: &Furnished| {
            judged += 1;
            Verdict::default()
        };
        assert_eq!(best_of(5, furnish, judge, |_| Vec::new(), || 0).alternative.number, 2);
        assert_eq!(judged, 2);
        assert_eq!(bounds, [None, Some(2), Some(2), Some(1), Some(1)]);
    }

    #[test]
    fn a_room_with_findings_is_furnished_again_to_the_end() {
        let mut bounds = Vec::new();
        let furnish = |alternative: &Alternative| {
            bounds.push(alternative.gives_up_at);
            counted(nothing())
        };
        let judge =
            |_: &Furnished| Verdict { findings: vec![found(Code::TightUse, &[])], ..Verdict::default() };
        let _ = best_of(3, furnish, judge, |_| Vec::new(), || 0);
        assert_eq!(bounds, [None; 3]);
    }

    #[test]
    fn a_room_that_stays_sparse_is_not_tried_for_ever() {
        let mut made = 0;
        let judge = |_: &Furnished| {
            made += 1;
            Verdict { findings: vec![found(Code::Sparse, &[])], ..Verdict::default() }
        };
        assert_eq!(best_of(16, empty, judge, |_| Vec::new(), || 0).alternative.number, 0);
        assert_eq!(made, 1 + PATIENCE);
    }

    #[test]
    fn a_room_with_a_bed_at_a_swing_is_furnished_again_and_that_counts_less_than_a_finding() {
        // The arrangements have so many beds at swings, and so many minor findings.
        let chosen = |rooms: &[(usize, usize)]| {
            let (mut furnished, mut judged) = (0, 0);
            let furnish = |_: &Alternative| {
                furnished += 1;
                let poor_places = PoorPlaces { at_swings: rooms[furnished - 1].0, ..PoorPlaces::default() };
                with_poor_places(poor_places)
            };
            let judge = |_: &Furnished| {
                judged += 1;
                let findings = (0..rooms[judged - 1].1).map(|_| found(Code::TightUse, &[])).collect();
                Verdict { findings, ..Verdict::default() }
            };
            let effort = rooms.len() as u32;
            best_of(effort, furnish, judge, |_| Vec::new(), || 0).alternative.number
        };
        assert_eq!(chosen(&[(1, 0), (1, 0), (1, 0), (1, 0), (1, 0), (0, 0)]), 5);
        assert_eq!(chosen(&[(1, 0), (0, 1)]), 0);
    }

    #[test]
    fn of_rooms_without_findings_the_one_with_fewer_poor_places_is_kept() {
        let chosen = |first: PoorPlaces| {
            let mut rooms = [first, PoorPlaces::default()].into_iter();
            let furnish = |_: &Alternative| with_poor_places(rooms.next().unwrap());
            best_of(2, furnish, |_| Verdict::default(), |_| Vec::new(), || 0).alternative.number
        };
        assert_eq!(chosen(PoorPlaces { open_sides: 1, ..PoorPlaces::default() }), 1);
        assert_eq!(chosen(PoorPlaces { rests_of_niches: 1, ..PoorPlaces::default() }), 1);
        assert_eq!(chosen(PoorPlaces::default()), 0);
    }

    #[test]
    fn no_required_piece_is_given_up_for_a_better_place_of_another() {
        let removal = Removal { class: 0, reason: RemovalReason::NoPlace, is_required: true };
        let lacking = counted(Furnished { removals: vec![removal], ..nothing() });
        let poor_places = PoorPlaces { at_swings: 1, open_sides: 1, rests_of_niches: 0 };
        let mut rooms = [with_poor_places(poor_places), lacking].into_iter();
        let furnish = |_: &Alternative| rooms.next().unwrap();
        let best = best_of(2, furnish, |_| Verdict::default(), |_| Vec::new(), || 0);
        assert_eq!(best.alternative.number, 0);
    }

    #[test]
    fn findings_of_the_plan_count_more_than_poor_places() {
        let poor_places = PoorPlaces { open_sides: 1, ..PoorPlaces::default() };
        let mut rooms = [poor_places, PoorPlaces::default()].into_iter();
        let furnish = |_: &Alternative| with_poor_places(rooms.next().unwrap());
        let given = Finding { severity: Severity::Given, ..found(Code::TightUse, &[]) };
        let mut findings = [Vec::new(), vec![given]].into_iter();
        let judge = |_: &Furnished| Verdict { findings: findings.next().unwrap(), ..Verdict::default() };
        assert_eq!(best_of(2, furnish, judge, |_| Vec::new(), || 0).alternative.number, 0);
    }

    #[test]
    fn one_failing_finding_is_worse_than_many_minor_ones_and_of_equals_the_first_stays() {
        assert_eq!(judged(3, &[(1, 0), (0, 3), (0, 3)]), (1, 3));
        assert_eq!(judged(1, &[(0, 1)]), (0, 1));
    }

    #[test]
    fn a_room_that_lacks_a_required_piece_after_all_gets_what_may_stand_in_for_it() {
        let made = |are_left: bool, is_replaced: bool| {
            let lacking = move |alternative: &Alternative| {
                let removal = Removal { class: 0, reason: RemovalReason::NoPlace, is_required: true };
                let removals =
                    if alternative.takes_substitutes && is_replaced { Vec::new() } else { vec![removal] };
                let stand_ins = StandIns { are_left, ..StandIns::default() };
                let shortcomings = Shortcomings { stand_ins, ..Shortcomings::default() };
                Counted { shortcomings, ..counted(Furnished { removals, ..nothing() }) }
            };
            best_of(1, lacking, |_| Verdict::default(), |_| Vec::new(), || 0).alternative
        };
        assert!(made(true, true).takes_substitutes);
        assert!(!made(true, false).takes_substitutes, "nothing was gained");
        assert!(!made(false, true).takes_substitutes, "nothing could stand in");
    }

    #[test]
    fn a_room_that_fails_after_all_gets_all_help_at_once() {
        let last = |failed: usize| {
            let furnish = |alternative: &Alternative| {
                let requested = u32::from(alternative.takes_substitutes);
                counted(Furnished { requested, ..nothing() })
            };
            let judge = |furnished: &Furnished| {
                let failed = if furnished.requested == 0 { failed } else { 0 };
                let findings = (0..failed).map(|_| found(Code::Unreachable, &[])).collect();
                Verdict { findings, ..Verdict::default() }
            };
            best_of(2, furnish, judge, |_| Vec::new(), || 0).alternative
        };
        assert!(last(1).takes_substitutes);
        assert!(!last(0).takes_substitutes);
    }

    #[test]
    fn help_for_a_room_that_fails_after_all_comes_to_an_end() {
        let (_, made) = judged(1, &[(1, 0); 9]);
        assert_eq!(made, 1 + ALTERNATIVES_WITH_ALL_HELP as usize);
    }

    #[test]
    fn a_room_that_misses_a_piece_with_a_known_place_is_furnished_with_that_place_first() {
        let furnish = |alternative: &Alternative| {
            let requested = u32::from(!alternative.suggestions.is_empty());
            counted(Furnished { requested, ..nothing() })
        };
        let judge = |furnished: &Furnished| {
            let finding = found(Code::MissingRequired, &[]);
            let findings = if furnished.requested == 0 { vec![finding] } else { Vec::new() };
            Verdict { findings, ..Verdict::default() }
        };
        let place = || Suggestion {
            class: 0,
            size: Size { width: 1.0, depth: 1.0, height: 1.0 },
            position: Point::ZERO,
            angle: 0.0,
            wall: None,
        };
        let best = best_of(2, furnish, judge, |_| vec![place()], || 0);
        assert_eq!((best.alternative.number, best.verdict.findings.len()), (2, 0));
        let best = best_of(2, furnish, judge, |_| Vec::new(), || 0);
        assert_eq!((best.alternative.number, best.verdict.findings.len()), (0, 1));
    }
}
