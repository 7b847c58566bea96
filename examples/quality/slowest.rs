//! The slowest rooms, with the time of each stage.

use std::time::{Duration, Instant};

use roomwright::internals::best::{Judged, best_of};
use roomwright::internals::catalog::Catalog;
use roomwright::internals::layout::{FurnishOptions, RoomLayout};
use roomwright::internals::plan::RoomRef;
use roomwright::internals::solve::RoomSolver;

/// What one room took.
pub struct Timed {
    /// Level, room, type, seed and area in square metres.
    words: String,
    /// How often it was furnished.
    alternatives: u32,
    layout: Duration,
    audit: Duration,
    suggesting: Duration,
    /// Of the layout, and of the audit's questions about the empty room.
    steps: (u64, u64),
}

impl Timed {
    fn total(&self) -> Duration {
        self.layout + self.audit + self.suggesting
    }
}

/// The rooms that took longest, the slowest first.
#[derive(Default)]
pub struct Slowest {
    most: usize,
    rooms: Vec<Timed>,
}

impl Slowest {
    /// A list of at most so many rooms that has one.
    pub fn of(room: Timed, most: usize) -> Self {
        let mut rooms = vec![room];
        rooms.truncate(most);
        Self { most, rooms }
    }

    /// Says how each of the rooms is found again.
    pub fn name(&mut self, name: &str) {
        self.rooms.iter_mut().for_each(|room| room.words = format!("{name}: {}", room.words));
    }

    /// The slowest of two lists.
    pub fn join(mut self, other: Self) -> Self {
        self.most = self.most.max(other.most);
        self.rooms.extend(other.rooms);
        self.rooms.sort_by_key(|room| std::cmp::Reverse(room.total()));
        self.rooms.truncate(self.most);
        self
    }

    /// One line a room.
    pub fn print(&self) {
        let milliseconds = |duration: Duration| duration.as_secs_f64() * 1e3;
        for room in &self.rooms {
            println!(
                "    {:9.1} ms: layout {:.1}, judging {:.1}, suggesting {:.1}; steps {}, {}; {} alternatives; {}",
                milliseconds(room.total()),
                milliseconds(room.layout),
                milliseconds(room.audit),
                milliseconds(room.suggesting),
                room.steps.0,
                room.steps.1,
                room.alternatives,
                room.words,
            );
        }
    }
}

/// Furnishes a room as `bake` does, and says what it took.
pub fn furnish(
    at: RoomRef<'_>,
    catalog: &Catalog,
    options: &FurnishOptions<'_>,
    effort: u32,
) -> (Judged, Timed) {
    let RoomRef { level, room: plan, .. } = at;
    let mut timed = Timed {
        words: format!(
            "level {} room {} ({}), seed {}, {:.1} m²",
            level.id,
            plan.id,
            plan.room_type,
            options.seed,
            plan.region.area()
        ),
        alternatives: 0,
        layout: Duration::ZERO,
        audit: Duration::ZERO,
        suggesting: Duration::ZERO,
        steps: (0, 0),
    };
    let Timed { alternatives, layout, audit, suggesting, steps, .. } = &mut timed;
    let furnisher = RoomLayout::new(at, catalog, options);
    let solver = RoomSolver::new(at, catalog);
    let judged = best_of(
        effort,
        |alternative| {
            *alternatives += 1;
            let made = measure(layout, || furnisher.furnish(alternative));
            steps.0 += made.steps;
            made
        },
        |furnished| measure(audit, || solver.judge(furnished)),
        |furnished| measure(suggesting, || solver.suggest_places(furnished)),
        || solver.steps(),
    );
    timed.steps.1 = solver.steps();
    (judged, timed)
}

fn measure<T>(total: &mut Duration, work: impl FnOnce() -> T) -> T {
    let (started, spent) = (Instant::now(), processor_time());
    let result = work();
    let spent = processor_time().zip(spent).map(|(after, before)| after - before);
    *total += spent.unwrap_or_else(|| started.elapsed());
    result
}

/// What this thread has worked, where the system tells it: on a machine that others use too, the clock tells more.
fn processor_time() -> Option<Duration> {
    let words = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    words.split_whitespace().next()?.parse().ok().map(Duration::from_nanos)
}
