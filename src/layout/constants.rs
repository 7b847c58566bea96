//! The tuning constants of the layout, in one place. The thresholds of findings are not among them: the layout reads those from
//! the catalogue, as the audit does ([`crate::catalog::AuditRules`]).
//!
//! Points: free places of an agent are compared by a sum of points (`rules/relation.rs`), of equal places the earlier one
//! is taken. A wish that is met gives its `weight` (0.3 to 6 in `configs/classes/`, 1 if none is written), one that is half met
//! half of it. The penalties and rewards below are in the same points.

/// Metres that bodies may overlap before it counts as a collision: contact must pass, and the audit's limit
/// is 1 mm. Larger lets bodies sink into each other, smaller makes touching bodies collide by rounding.
pub(crate) const CONTACT_TOLERANCE: f64 = 5e-4;
/// Metres by which a clearance may reach into a wall or another body: people do not measure centimetres. A little
/// less than the audit allows, so that a file's 32-bit numbers do not tip what stands at the limit.
pub(crate) const CLEARANCE_TOLERANCE: f64 = 0.0098;
/// Free places compared where an agent has wishes about other objects; more meet more wishes, and take as many steps more.
pub(crate) const CANDIDATES_WITH_RELATIONS: usize = 10;
/// Candidates compared where places differ in clearances and windows only.
pub(crate) const CANDIDATES_WITH_CLEARANCES: usize = 4;
/// Points, from none to so many, that the seed adds to the places at a parent (a wall, a side): of two whose points differ by
/// less, now the one is taken and now the other. A fifth of a usual wish (weight 1). Larger: more arrangements of a room over many
/// seeds, and more seats far from their tables.
pub(crate) const TASTE: f64 = 0.2;
/// Random positions tried on one side or surface before another parent is looked for (section 3.2: "a few
/// trials").
pub(crate) const TRIALS_PER_SIDE: usize = 8;
/// Random positions tried on a floor or ceiling.
pub(crate) const TRIALS_PER_FLOOR: usize = 40;
/// Positions along one wall that are compared; its free stretches are known exactly, so few suffice.
pub(crate) const TRIALS_PER_WALL: usize = 3;
/// Metres between the points of the scan that follows when random positions on a floor fail.
pub(crate) const SCAN_STEP: f64 = 0.2;
/// Points of that scan at most; larger floors are scanned more coarsely.
pub(crate) const SCAN_POINTS: f64 = 1500.0;
/// Directions of walls that such a scan tries at most, for what the room cannot do without.
pub(crate) const SCAN_DIRECTIONS: usize = 4;
/// Sine of the angle below which two walls have the same direction.
pub(crate) const SAME_DIRECTION: f64 = 0.02;
/// Metres between the points of a scan along the rows of a lattice.
pub(crate) const LINE_STEP: f64 = 0.1;
/// Metres between the points of a scan along a wall.
pub(crate) const WALL_STEP: f64 = 0.03;
/// Points of such a scan along all walls of a room at most; from 300 m of wall on they lie farther apart.
pub(crate) const WALL_POINTS: f64 = 10_000.0;
/// Metres between the points of a scan over a table top or shelf.
pub(crate) const SURFACE_STEP: f64 = 0.08;
/// Metres from the end of a free stretch of wall within which a piece slides flush to the end: nobody leaves a
/// gap that a broom does not fit into.
pub(crate) const SNAP_DISTANCE: f64 = 0.25;
/// Metres by which a curtain may be wider and higher than its window.
pub(crate) const COVER_MARGIN: f64 = 0.45;
/// Metres over its parent from which a piece hangs and needs a wall, and how far that may be behind it.
pub(crate) const HANGING_GAP: f64 = 0.008;
/// Metres from the front edge of a surface at which things at the front lie.
pub(crate) const FRONT_MARGIN: f64 = 0.04;
/// Points lost by a tall, wide body before a window. Compared with the weights of wishes: at 2, a piece darkens a window
/// for a wish of weight 3 and not for one of 1. Larger: fewer `window_blocked` findings, and fewer wishes met.
pub(crate) const WINDOW_PENALTY: f64 = 2.0;
/// Points lost by taking the place of a seat, or by leaving none for one's own. Above [`WINDOW_PENALTY`], for a room does
/// without light at one place rather than without a seat. Larger: fewer chairs without a place, and fewer wishes met.
pub(crate) const SEAT_PENALTY: f64 = 3.0;
/// Metres before a table or desk that a seat takes with somebody on it.
pub(crate) const SEAT_DEPTH: f64 = 0.55;
/// Metres above the floor from which a body fills the space under a table: a rug does not.
pub(crate) const RUG_HEIGHT: f64 = 0.05;
/// Points lost where a seat of its own would stand in a door's way. Below [`TIGHT_PENALTY`]: a room does with a chair less
/// rather than with too little space to use it. Larger: fewer chairs without a place, and more `tight_use` findings.
pub(crate) const SEAT_IN_WAY_PENALTY: f64 = 0.8;
/// Points lost for each of two: the own clearances are below their good depth, or those of others are. Below the other
/// penalties, for the place can be used. Larger: fewer `tight_use` findings, and fewer wishes met.
pub(crate) const TIGHT_PENALTY: f64 = 1.0;
/// Rounds in which agents that lost their parent may search again.
pub(crate) const SEARCH_ROUNDS: usize = 4;
/// Points gained by a long built-in piece that fills its wall from end to end (half of it gains nothing), and by the first
/// of a run at a wall of [`RUN_LENGTH`]. As much as one usual wish; larger: it goes there though wishes are not met.
pub(crate) const BUILT_IN_REWARD: f64 = 1.0;
/// Metres of wall that hold a whole run.
pub(crate) const RUN_LENGTH: f64 = 3.0;
/// Widths of a piece in depths from which it is long.
pub(crate) const LONG_PIECE: f64 = 2.0;
/// Candidates compared for what is built in and required: bathrooms and kitchens live by it.
pub(crate) const CANDIDATES_BUILT_IN: usize = 24;
/// Metres by which agents are pushed to have more room, tried in this order: of equally good places the nearest is taken.
pub(crate) const PUSH_DISTANCES: [f64; 10] = [0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.9, 1.2, 1.6];
/// Metres by which the middles of two pieces may be out of line and still stand in one: less than people see. Larger: more
/// pieces are pushed along the line only, and fewer `tight_use` findings are mended.
pub(crate) const LINE_WIDTH: f64 = 0.02;
/// Points by which a place must be better to be pushed to: a twentieth of a usual wish, so that nobody is moved for rounding.
/// Larger: fewer groups move, and more `tight_use` findings remain.
pub(crate) const PUSH_GAIN: f64 = 0.05;
/// Rounds of pushing: who moves makes room for others.
pub(crate) const PUSH_ROUNDS: usize = 3;
/// Rounds in which agents that close a way are sent away; what they close elsewhere is seen in the next round.
pub(crate) const WAY_ROUNDS: usize = 4;
/// Times that a room is furnished from derived seeds while many pieces are missing; rooms that come out well,
/// nearly all, are furnished once.
pub(crate) const ATTEMPTS: u32 = 4;
/// Alternatives of a room in which tagged walls come first, and [`ATTEMPTS`] in each: where the room does not come out
/// well that way, pieces that would be missing count for more than short pipes.
pub(crate) const ALTERNATIVES_WITH_TAGS: u32 = 4;
/// Times while there is none of what the room cannot do without or a way is closed: a bathroom of 3 m² has few good
/// arrangements.
pub(crate) const ATTEMPTS_IN_NEED: u32 = 16;
/// Steps of one alternative after which no further attempt begins, each about a tenth of a microsecond. Fewer lose rooms
/// that come out well late, more make rooms slow in which something has no place.
pub(crate) const MOST_STEPS: u64 = 400_000;
/// The same while a way is closed, which another attempt nearly always opens: halls of many seats take longest. Fewer
/// leave more `unreachable` findings in them.
pub(crate) const MOST_STEPS_FOR_WAYS: u64 = 3_000_000;
/// Steps of testing one place against everything in the room.
pub(crate) const STEPS_A_TEST: u64 = 3;
/// Steps of proposing poses at one side of a parent, and of scoring a place.
pub(crate) const STEPS_A_PROPOSAL: u64 = 6;
/// Cells of a floor that are looked at in the time of one step, and cells over which ways are looked for.
pub(crate) const CELLS_A_STEP: u64 = 16;
pub(crate) const CELLS_OF_WAYS_A_STEP: u64 = 2;
/// Share of the requested pieces that may be missing before another attempt: the audit calls a room `unfulfilled` below
/// nine tenths. Larger: fewer attempts, more `unfulfilled` findings.
pub(crate) const MISSING_SHARE: f64 = 0.1;
/// Classes of this group stand on the floor itself, not on rugs.
pub(crate) const STORAGE_GROUP: &str = "storage";
/// Groups of slim things that leave a window enough of its light, as the audit has them.
pub(crate) const LIGHT_GROUPS: [&str; 5] = ["greenery", "small", "light", "movable", "window_dressing"];
/// Classes of this group stand in bathrooms, and are used with the door shut.
pub(crate) const FIXTURE_GROUP: &str = "fixture";
