//! The table of findings: a row has the meaning of a finding, its word, how bad it is, what it measures, the section of
//! `configs/audit.yaml` with its thresholds, and the check that finds it.
//!
//! A check is a file of this folder. It takes the evidence and gives [`Fault`]s; the table makes findings of them. A finding moves
//! nothing: `best` furnishes the room again, `--effort` times at most, and keeps the best arrangement. To have pieces stand well
//! from the start, give their class a relation (`docs/guide.md`). To add a finding:
//!
//! 1. Write its check. `crooked.rs` is a short one to copy, with tests in rooms that are furnished by hand; no other need be
//!    read. A fault is of one object, or of one wall or opening; further subjects are what it is measured to.
//! 2. Add its `mod` line and its row of the table below: meaning, name of the code, word in the output, severity (`Failed`, or
//!    `Minor`, a warning, if the room is usable all the same; `Given` is worked out and stands in no row), quantities, section
//!    of thresholds (`""` for none), check. The word is the name in small letters, and part of the output. The row may stand
//!    anywhere; checks that ask about the empty room share a budget in the order of the table. If no other arrangement of the
//!    same pieces can be without the finding, name it in `Code::is_of_places`, so that no further ones are tried for its sake.
//!    A new quantity is a line in each list of `quantity.rs`.
//! 3. Add a limit of its own, if it has one: a line with the figure and its source or reason in `configs/audit.yaml`, and a
//!    line with its unit (`Metres`, `Area`, `Degrees`, `Share`, `Factor`) in the list `thresholds!` of
//!    `src/catalog/audit.rs`. A limit may join the section that fits: layout reads the limits that it names, and no
//!    others. A new section is written like this, and nothing else names it:
//!
//!    ```text
//!    /// How far light is from work.                 in src/catalog/audit.rs, before `/// The view of a screen.`
//!    lamps: LampRules {
//!        /// Farthest lamp of a desk.
//!        desk: Metres,
//!    }
//!
//!      lamps:                                        in configs/audit.yaml, before `  screens:`
//!        desk: 1.5      # the arm of a desk lamp, and as much again
//!    ```
//!
//!    A user tries another figure with `--catalog DIR`, where `DIR/audit.yaml` has `version`, `thresholds` and that figure.
//! 4. Renew `docs/audit.md`, `docs/guide.md` and the schemas: `UPDATE_GOLDENS=1 cargo test --lib -- the_page_about_the_audit
//!    published_schemas the_guide_lists_the_groups` (the last for a new line of `groups.rs` alone). Rooms that have the new finding are furnished again for its sake, so that
//!    pinned levels and drawings of the catalogue may change: `cargo test --test command_line -- pinned handbook` says so, and
//!    renews them with `UPDATE_GOLDENS=1`. Then `cargo test --lib -- audit`, `cargo fmt` and
//!    `cargo clippy --all-targets -- -D warnings`. A finding needs no more; all tests (`bash scripts/test.sh`) take half an hour.
//!    Figures and pictures of other pages are renewed for a version. Nothing else lists the codes: the page of `view` is sent
//!    their meanings (`src/view/site.rs`), and `scripts/judge.py` has measures of its own. Until a version is released,
//!    CHANGELOG.md stays as it is.
//!
//! | quantity (`quantity.rs`) | unit of the figures | is |
//! |---|---|---|
//! | `Depth` | metres | how far something reaches into something else |
//! | `FreeDepth` | metres | free space between a side and the nearest body, column or wall before it |
//! | `Gap` | metres | gap between a body and its support |
//! | `Height` | metres | top of a body above the floor |
//! | `Width` | metres | the widest disc that gets through |
//! | `Distance` | metres | from one thing to another |
//! | `ScreenDistance` | diagonals of the screen | from a screen to who watches it |
//! | `Angle` | degrees | between two directions |
//! | `Share` | of 1 | a part of a whole |
//! | `Count` | pieces or sides | how many |
//!
//! | a check needs | from |
//! |---|---|
//! | room, level, furniture that found no place | `subject.at.room`, `subject.at.level`, `subject.furnished.removals` |
//! | objects | `subject.bodies`, in the order of the placements: `class`, `placement`, `solids` in the level's frame, `bounds`, `low()` and `high()` (metres above the floor), `is_in(groups::SEAT)`, `is_standing(rules)` (its underside at the floor, also on a rug, and no rug itself), `front()` (unit vector), `corners()` (of its box: the first two at its front, the last two at its back), `strip(Side::Front, margin, depth)` (the floor before a side); `placement.position` is the middle of the box |
//! | groups of classes | constants of `audit/groups.rs`: `groups::SEAT` (stools and benches too), `BED`, `SLEEPING` (beds and cots), `SCREEN` (televisions, no computers), `WORK_SURFACE` (desks), `SURFACE` (tables and desks), `MIRROR`, `BATHING`, `TOILET`, `FIXTURE` (of bathrooms), `COOKING`, `SMALL` (held in a hand), `LIGHT` (lamps, those of the ceiling too), `MOVABLE` (chairs), `PLANT` (pots, of which most stand on the floor and none hangs), `WINDOW_DRESSING`, `DISPLAY_SURFACE`, `KITCHEN_TOP`. Groups of the class files alone are asked for by their word, as in `body.is_in("soft_seat")` (armchairs, easy chairs and sofas; `computer_screen`; others: `grep -rhow "groups: .*" configs/classes`). A new group is a word of the `groups` of its classes (`grep -n -A9 "^  NAME:" configs/classes/*` shows one) and needs no more where one check asks for it; a class that `extends` another (`grep -rn "extends: NAME" configs/classes`) and lists none has those of the other, and a list of its own replaces them: write them again. What several checks ask for is also a line `/// Meaning.` and `NAME: "word";` of the list in `groups.rs`, and a word of this row |
//! | what belongs to what | `placement.parent` (`Parent::Object(index)` for what stands on or at another object; also `Floor`, `Wall(index)`, ...) and `placement.side`, the side of the parent; `subject.children(index)` of an object, directly; `subject.ancestors(index)`: the object, its parent, and so on; `subject.table_of(index)`: the table or desk that a seat stands at |
//! | bodies near each other | `subject.near_boxes().touching(&bounds)`; for places `let lamps = NearPoints::new(indices.map(|index| (index, place(index))))` (`use crate::audit::near::NearPoints;`), then `lamps.distance(here, place)`, metres to the nearest, if there is one, or `lamps.nearest(here)`, indices of the nearest 128, in no order of distance: the nearest is the least of them by distance, then by index. Not each body with each other: `audit/tests.rs` measures that the time of a verdict grows as the pieces do. Each body with each wall or opening is fine |
//! | distances, in metres | of two points `a.distance(b)`; `Segment::new(a, b).distance(point)`, `distance_to_convex(corners, point)`, `distance_of_convex(corners, others)` of `geometry`, 0 inside; rings have three corners or more. The outline of an object in the plan is the `footprint()`, such a ring, of each of its `solids`; `corners()` is that of its box |
//! | style, limits | `subject.style()`, `subject.rules().alignment.angle`: metres, radians, shares |
//! | the space before sides, doors and windows, and what is in it | `evidence.zones`, `evidence.hits` |
//! | where people get to | `evidence.floor`, which may be none: `floor.walk(diameter).reaches(door, goal)` |
//! | whether the empty room could hold a piece | `(evidence.ask)(&Question::Class(class))`, for `Fault::if_possible` |
//! | walls of the room | `subject.at.room.walls[index]`: `start`, `end`, `direction()`, `normal()` into the room |
//! | doors and windows of the room | `subject.at.room.openings`: each with its `wall`, the metres `from` and `to` along it (`subject.at.room.walls[wall].stretch(from, to)` is that [`Segment`](crate::geometry::Segment)), and `opening`, the index into `subject.at.level.openings`: `kind` (`OpeningKind::Window`, `Door`, `SlidingDoor`, `Passage`, `OpenBoundary`), `bottom`, `top`, `sides`, and its middle line: `center` (halfway through the wall; a `Point`, as `placement.position` is), `along`, `width`. A window between two rooms counts like one to the open air, in both rooms; it has two `sides`, one to the open air has one |
//! | whether the room is in the open air | `subject.catalog.households.homes.outdoors.contains(&subject.at.room.room_type)` |
//! | a comparison with a limit | `use crate::audit::rounding::ROUNDING;`, then `measured > limit + ROUNDING` or `measured < limit - ROUNDING`; of two limits a fault has the one that was passed |
//! | a fault | `Fault::new(Quantity::Angle, vec![subject.object(index), Subject::wall(wall)], measured, threshold)`, figures in the unit of the quantity, and 0 for `measured` where there is nothing to measure to, for JSON has no infinity; also `subject.opening(index)` (of the level), `Subject::column(index)`, `subject.class(index)` (of which a piece is missing); `.about(vec![body.strip(Side::Front, 0.0, limit).to_vec()])` marks floor, a ring of corners for each region. Answers list the subjects sorted by id |
//! | a room in a test | `let mut room = TestRoom::rectangle(3.0, 3.0)` (`audit/testing.rs`) with the classes `chest` (1 × 1 × 0.8 m), `stool` (0.4 × 0.4 × 0.45 m), `table`, `desk`, `lamp`, `picture`, all of no group; `room.stand("chest", at(1.5, 0.7))` or `room.add("chest", at(1.5, 0.7), Parent::Wall(0))` give the index of an object (wall 0 is the south wall, 1 the east wall; at angle 0 fronts face south). Ids are `stool.1`, `wall.0`, `window:0` (openings count from 0); the room's type is `office`, and `room.catalog.households.homes.outdoors.insert("office".to_owned())` puts it into the open air. A seat at a desk: `let stool = room.add("stool", at(1.5, 0.8), Parent::Object(desk))` at its front, then `room.placements[stool].side = Side::Front` and `.angle = PI`, so that it faces the desk, with the groups `SEAT` and `SURFACE`; `room.group("chest", groups::PLANT)`, `room.open(wall, OpeningKind::Window, (from, to), (bottom, top))`; `room.count(Code::Crooked)` is how many findings of a code there are, `room.audit()` gives them all, each with `code`, `objects` (their ids), `measured` and `threshold` |

mod access;
mod bare;
mod bedside;
mod blocked;
mod collision;
mod containment;
mod crooked;
mod doors;
mod facing;
mod halves;
mod open_leaf;
mod programme;
mod reach;
mod screens;
mod sight;
mod sparse;
mod support;
mod tight;
mod wet_room;
mod windows;

pub(crate) use crooked::{angle_off, stands_straight};
pub(crate) use doors::{swings, zones as door_zones};
pub(crate) use halves::middle_of;
pub(crate) use programme::missing_pieces;
pub(crate) use reach::{Rates, floor, rates};
pub(crate) use wet_room::zones as bowl_zones;
pub(crate) use windows::{is_before, zones as light_zones};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::evidence::Evidence;
use super::fault::Fault;
use super::quantity::Quantity::{self, *};
use super::severity::Severity::{self, Failed, Minor};

/// Finds the faults of a kind.
type Check = fn(&Evidence<'_, '_>) -> Vec<Fault>;

/// A row of the table.
struct Row {
    word: &'static str,
    severity: Severity,
    quantities: &'static [Quantity],
    thresholds: &'static str,
    meaning: &'static str,
    check: Check,
}

macro_rules! table {
    ($(#[doc = $meaning:literal] $code:ident: $word:literal, $severity:ident, [$($quantity:ident),+], $section:literal, $check:path;)+) => {
        /// The kinds of findings.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
        #[serde(rename_all = "snake_case")]
        pub enum Code {
            $(#[doc = $meaning] $code,)+
        }

        impl Code {
            /// All kinds, in the order of the table.
            pub const ALL: [Self; TABLE.len()] = [$(Self::$code),+];
        }

        const TABLE: &[Row] = &[$(Row {
            word: $word,
            severity: $severity,
            quantities: &[$($quantity),+],
            thresholds: $section,
            meaning: $meaning,
            check: $check,
        }),+];
    };
}

table! {
    /// Two bodies intersect.
    Collision: "collision", Failed, [Depth], "bodies", collision::check;
    /// Part of a body lies outside the room.
    OutOfRoom: "out_of_room", Failed, [Depth], "bodies", containment::check;
    /// A body does not touch its support.
    Floating: "floating", Failed, [Gap], "bodies", support::floating;
    /// A body hangs over the edge of its support.
    Unsupported: "unsupported", Failed, [Share], "bodies", support::unsupported;
    /// A body in a door's swing or approach.
    DoorBlocked: "door_blocked", Failed, [Depth], "doors", doors::check;
    /// People cannot walk to a door or to a side of an object that is used.
    Unreachable: "unreachable", Failed, [Width], "walking", reach::check;
    /// A body, a column or a wall in the space that people need before a side: less than the `minimum` clearance of the class.
    BlockedUse: "blocked_use", Failed, [FreeDepth], "clearances", blocked::check;
    /// A clearance between its `minimum` and its `good` depth.
    TightUse: "tight_use", Minor, [FreeDepth], "clearances", tight::check;
    /// A body before a window takes its light.
    WindowBlocked: "window_blocked", Minor, [Height], "windows", windows::check;
    /// A screen that nobody sees from a seat or bed, or that stands before a window.
    TvPosition: "tv_position", Failed, [ScreenDistance, FreeDepth], "screens", screens::check;
    /// A seat turned away from its table, a sofa that looks past the screen, a desk used from behind, a mirror over nothing.
    Facing: "facing", Minor, [Angle, Count], "facing", facing::check;
    /// A seat that does not see what its row looks at, such as a stage.
    OutOfSight: "out_of_sight", Minor, [Angle, Count], "", sight::check;
    /// A tub or shower right before the toilet, a toilet that faces a kitchen.
    WetRoom: "wet_room", Failed, [FreeDepth, Distance], "wet_rooms", wet_room::check;
    /// A double bed with one side to get in where the room allows two.
    Bedside: "bedside", Minor, [Count], "beds", bedside::check;
    /// Furniture beside a door that stands open closes the way to a door or to a side that is used.
    OpenLeaf: "open_leaf", Minor, [Width], "walking", open_leaf::check;
    /// Nearly all furniture in one half of the room.
    CrowdedHalf: "crowded_half", Minor, [Share], "balance", halves::check;
    /// Wall furniture that is not parallel to its wall, in a tidy style.
    Crooked: "crooked", Minor, [Angle], "alignment", crooked::check;
    /// A required piece is absent.
    MissingRequired: "missing_required", Failed, [Count], "", programme::missing_required;
    /// Too few of the requested pieces have a place.
    Unfulfilled: "unfulfilled", Minor, [Share], "fulfilment", programme::unfulfilled;
    /// Much less furniture than style and room type ask for.
    Sparse: "sparse", Minor, [Share], "fulfilment", sparse::check;
    /// Surfaces that should carry small things are empty.
    Bare: "bare", Minor, [Share], "fulfilment", bare::check;
    /// A way too narrow for a wheelchair, where the style asks for access.
    NarrowWay: "narrow_way", Minor, [Width], "access", access::narrow_way;
    /// No room to turn a wheelchair, where the style asks for access.
    NoTurningCircle: "no_turning_circle", Minor, [Width], "access", access::no_turning_circle;
}

impl Code {
    fn row(self) -> &'static Row {
        &TABLE[self as usize]
    }

    /// The word in the output.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().word
    }

    /// How bad a finding of this kind is, unless the plan leaves no other choice.
    #[must_use]
    pub fn severity(self) -> Severity {
        self.row().severity
    }

    /// The quantities that it measures, the usual one first.
    #[must_use]
    pub fn quantities(self) -> &'static [Quantity] {
        self.row().quantities
    }

    /// Its meaning, as a sentence.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        self.row().meaning.trim()
    }

    /// The section of `configs/audit.yaml` with its thresholds; empty where it has none.
    #[must_use]
    pub fn thresholds(self) -> &'static str {
        self.row().thresholds
    }

    /// Whether no room may ever have it: the laws of bodies, as against the customs of use.
    #[must_use]
    pub fn is_physical(self) -> bool {
        matches!(self, Self::Collision | Self::OutOfRoom | Self::Floating | Self::Unsupported)
    }

    /// Whether another arrangement of the same pieces may be without it. A room that is asked for too few pieces stays sparse.
    #[must_use]
    pub fn is_of_places(self) -> bool {
        self != Self::Sparse
    }
}

/// All faults of a room by their code, in the order of the table: checks share the budget for questions about the empty
/// room, so that the order in which they ask is fixed.
pub(crate) fn faults<'e>(evidence: &'e Evidence<'_, '_>) -> impl Iterator<Item = (Code, Fault)> + 'e {
    let of_code = |code: Code| (code.row().check)(evidence).into_iter().map(move |fault| (code, fault));
    let faults = Code::ALL.into_iter().flat_map(of_code);
    faults.inspect(|(code, fault)| {
        debug_assert!(code.quantities().contains(&fault.quantity), "{code:?} measures {:?}", fault.quantity);
    })
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use super::*;

    #[test]
    fn the_word_of_a_code_is_the_serialized_one_and_codes_are_in_the_order_of_the_table() {
        for code in Code::ALL {
            assert_eq!(serde_json::to_value(code).unwrap(), code.name());
        }
        assert!(Code::ALL.is_sorted());
    }

    /// The table as the page shows it.
    fn page_table() -> String {
        let mut table =
            String::from("| code | severity | finding | measures | thresholds |\n|---|---|---|---|---|\n");
        for code in Code::ALL {
            let sentence = code.meaning().trim_end_matches('.');
            let (first, rest) = sentence.split_at(1);
            let measures: Vec<String> = code
                .quantities()
                .iter()
                .map(|quantity| match quantity.unit().name() {
                    Some(unit) => format!("{} ({unit})", quantity.name()),
                    None => quantity.name().to_owned(),
                })
                .collect();
            let section = match code.thresholds() {
                "" => String::new(),
                section => format!("`{section}` "),
            };
            let _ = writeln!(
                table,
                "| `{}` | {} | {}{rest} | {} | {section}|",
                code.name(),
                code.severity().name(),
                first.to_lowercase(),
                measures.join(", ")
            );
        }
        table
    }

    #[test]
    fn the_page_about_the_audit_lists_the_codes_of_the_table_and_no_others() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/audit.md");
        let page = std::fs::read_to_string(path).unwrap();
        let is_row = |line: &&str| line.starts_with("| code |") || line.starts_with("| `");
        let from = page.find("| code | severity |").expect("the page has the table");
        let length = page[from..].find("\n\n").expect("the table ends") + 1;
        let shown = &page[from..from + length];
        assert!(shown.lines().filter(is_row).count() > 1);
        if std::env::var_os("UPDATE_GOLDENS").is_some() {
            return std::fs::write(path, page.replace(shown, &page_table())).unwrap();
        }
        assert_eq!(
            shown,
            page_table(),
            "renew it with UPDATE_GOLDENS=1 cargo test --lib the_page_about_the_audit"
        );
    }

    #[test]
    fn every_section_of_thresholds_exists() {
        let text = include_str!("../../../configs/audit.yaml");
        for code in Code::ALL.into_iter().filter(|code| !code.thresholds().is_empty()) {
            assert!(text.contains(&format!("\n  {}:", code.thresholds())), "{}", code.thresholds());
        }
    }
}
