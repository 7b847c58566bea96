//! Walks through a world without a picture, and measures when rooms are there.
//!
//! Time is that of the walk: an eye moves from frame to frame, and each thread of the background furnishes one room after the
//! other, each as long as it really took on this machine. So a walk of ten kilometres takes seconds, and the figures are those of
//! somebody who walks it.

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::Serialize;

use super::graph::Key;
use super::path::{Stop, WalkPath, metres};
use super::store::Budget;
use super::wish::{Need, Wanted};
use super::world::{Eye, Job, MadeRoom, UnknownLevel, World};
use crate::geometry::Point;

/// Frames in a second of the walk.
const FRAMES: f64 = 60.0;

/// How one walks.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    /// Metres a second.
    pub speed: f64,
    /// Radians that one sees from side to side.
    pub field_of_view: f64,
    /// Metres of the way to rooms that have to be there though one does not see them.
    pub reach: f64,
    /// Threads in the background.
    pub threads: usize,
    /// How much the world may hold.
    pub budget: Budget,
}

/// What a walk was like.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct WalkReport {
    /// Metres a second.
    pub speed: f64,
    /// Metres walked.
    pub metres: f64,
    /// Seconds that it takes.
    pub seconds: f64,
    /// Frames, sixty a second.
    pub frames: u64,
    /// Places at which one arrived from elsewhere: the beginning of the walk, and of each further piece of a random one.
    pub arrivals: usize,
    /// Milliseconds until all that is in view is there after an arrival.
    pub arrival_ms: Spread,
    /// Rooms in view, frame by frame.
    pub rooms_in_view: Spread,
    /// Further rooms that one reaches within the distance of `--reach`, frame by frame.
    pub rooms_near: Spread,
    /// Pieces of furniture in the rooms in view, frame by frame.
    pub pieces_in_view: Spread,
    /// Rooms that came into view or near; each counts again when it comes again.
    pub needed: usize,
    /// Milliseconds from when such a room was needed until it was there; 0 where it was there before.
    pub latency_ms: Spread,
    /// Rooms that were in view before they were there.
    pub popped: usize,
    /// Frames in which a room in view was not there.
    pub late_frames: u64,
    /// Rooms that were furnished.
    pub made: usize,
    /// Of these, rooms that were furnished before and had been forgotten.
    pub made_again: usize,
    /// Milliseconds to furnish a room.
    pub make_ms: Spread,
    /// Microseconds of a look around.
    pub look_us: Spread,
    /// Rooms held at most.
    pub most_rooms: usize,
    /// Bytes of furnished rooms held at most.
    pub most_bytes: usize,
    /// The same in each tenth of the walk.
    pub bytes_by_tenth: Vec<usize>,
}

/// The distribution of a measure.
#[derive(Clone, Copy, Debug, Default, Serialize, JsonSchema)]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// Half of all are not above.
    pub p50: f64,
    /// 99 of 100 are not above.
    pub p99: f64,
    /// The largest.
    pub max: f64,
}

impl Spread {
    fn of(mut values: Vec<f64>) -> Self {
        if values.is_empty() {
            return Self::default();
        }
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        Self { mean, p50: at(0.5), p99: at(0.99), max: at(1.0) }
    }
}

/// A thread of the background, in the time of the walk.
#[derive(Default)]
struct Thread {
    /// The room that it makes, and the second at which it is there.
    busy: Option<(f64, MadeRoom)>,
}

/// What is noted on the way.
#[derive(Default)]
struct Notes {
    arrival_ms: Vec<f64>,
    in_view: Vec<f64>,
    near: Vec<f64>,
    pieces: Vec<f64>,
    latency_ms: Vec<f64>,
    make_ms: Vec<f64>,
    look_us: Vec<f64>,
    popped: usize,
    late_frames: u64,
    known: BTreeSet<Key>,
    made_again: usize,
    rooms: usize,
    bytes: Vec<(f64, usize)>,
    /// Rooms that are needed now: the second since when, until they are there, and whether they popped.
    needs: BTreeMap<Key, (f64, bool, bool)>,
}

/// Walks a path through a world that was just opened and has no threads of its own.
///
/// # Errors
/// If the path leads to a level that the world does not have.
pub fn walk(world: &mut World, path: &WalkPath, pace: &Pace) -> Result<WalkReport, UnknownLevel> {
    let mut notes = Notes::default();
    let (mut frames, mut seconds, mut walked) = (0_u64, 0.0, 0.0);
    for piece in &path.pieces {
        let mut threads: Vec<Thread> = (0..pace.threads.max(1)).map(|_| Thread::default()).collect();
        notes.needs.clear();
        arrive(world, piece, pace, &mut notes)?;
        let total = metres(piece);
        let begun = seconds;
        let mut way = Way { stops: piece, next: 1, before: 0.0 };
        loop {
            let gone = (seconds - begun) * pace.speed;
            if gone >= total {
                break;
            }
            for thread in threads.iter_mut().filter(|_| gone > 0.0) {
                thread.run(world, (seconds - 1.0 / FRAMES, seconds), &mut notes);
            }
            let eye = eye(world, way.at(gone), pace);
            look(world, &eye, pace, &mut notes)?;
            notes.frame(world, seconds, walked + gone);
            frames += 1;
            seconds += 1.0 / FRAMES;
        }
        walked += total;
    }
    let tenth = |index: usize| {
        let of = |metres: f64| (metres / walked * 10.0) as usize == index;
        notes.bytes.iter().filter(|(metres, _)| of(*metres)).map(|(_, bytes)| *bytes).max().unwrap_or(0)
    };
    Ok(WalkReport {
        speed: pace.speed,
        metres: walked,
        seconds,
        frames,
        arrivals: path.pieces.len(),
        rooms_in_view: Spread::of(notes.in_view),
        rooms_near: Spread::of(notes.near),
        pieces_in_view: Spread::of(notes.pieces),
        needed: notes.latency_ms.len(),
        popped: notes.popped,
        late_frames: notes.late_frames,
        made: notes.make_ms.len(),
        made_again: notes.made_again,
        most_rooms: notes.rooms,
        most_bytes: notes.bytes.iter().map(|(_, bytes)| *bytes).max().unwrap_or(0),
        bytes_by_tenth: (0..10).map(tenth).collect(),
        arrival_ms: Spread::of(notes.arrival_ms),
        latency_ms: Spread::of(notes.latency_ms),
        make_ms: Spread::of(notes.make_ms),
        look_us: Spread::of(notes.look_us),
    })
}

/// Waits at the beginning of a path until all that is wanted there is made, and notes when all in view was.
fn arrive(world: &mut World, piece: &[Stop], pace: &Pace, notes: &mut Notes) -> Result<(), UnknownLevel> {
    let mut way = Way { stops: piece, next: 1, before: 0.0 };
    look(world, &eye(world, way.at(0.0), pace), pace, notes)?;
    let mut spent = 0.0;
    let mut is_seen = false;
    loop {
        let mut is_complete = true;
        world.each_wanted(|wanted, room| is_complete &= wanted.need > Need::Visible || room.is_some());
        if is_complete && !is_seen {
            is_seen = true;
            notes.arrival_ms.push(spent * 1000.0 / pace.threads.max(1) as f64);
        }
        let Some(job) = world.take() else { break };
        let (made, took) = timed(job);
        notes.made(&made, took);
        spent += took.as_secs_f64();
        world.keep(made);
    }
    Ok(())
}

/// An eye at a place, looking along its way.
fn eye(world: &World, (stop, direction): (Stop, Point), pace: &Pace) -> Eye {
    let project = world.project();
    let placed = &project.plan.buildings[stop.building];
    Eye {
        velocity: direction * pace.speed,
        field_of_view: pace.field_of_view,
        reach: pace.reach,
        ..Eye::new(&placed.id, &placed.building.levels[stop.level].id, stop.at, direction)
    }
}

fn look(world: &mut World, eye: &Eye, pace: &Pace, notes: &mut Notes) -> Result<(), UnknownLevel> {
    let begun = Instant::now();
    world.update(eye, pace.budget)?;
    notes.look_us.push(begun.elapsed().as_secs_f64() * 1e6);
    Ok(())
}

fn timed(job: Job) -> (MadeRoom, Duration) {
    let begun = Instant::now();
    let made = job.make();
    (made, begun.elapsed())
}

impl Thread {
    /// Makes what the last look wanted, from its second of the walk until another.
    fn run(&mut self, world: &World, (since, until): (f64, f64), notes: &mut Notes) {
        let mut free_at = since;
        loop {
            if let Some((ready_at, made)) = self.busy.take() {
                if ready_at > until {
                    self.busy = Some((ready_at, made));
                    return;
                }
                notes.arrived(made.key(), ready_at);
                world.keep(made);
                free_at = ready_at;
            }
            let Some(job) = world.take() else { return };
            let (made, took) = timed(job);
            notes.made(&made, took);
            self.busy = Some((free_at + took.as_secs_f64(), made));
        }
    }
}

impl Notes {
    fn made(&mut self, made: &MadeRoom, took: Duration) {
        self.make_ms.push(took.as_secs_f64() * 1000.0);
        if !self.known.insert(made.key()) {
            self.made_again += 1;
        }
    }

    fn arrived(&mut self, key: Key, second: f64) {
        if let Some((since, is_there, _)) = self.needs.get_mut(&key)
            && !*is_there
        {
            *is_there = true;
            self.latency_ms.push((second - *since).max(0.0) * 1000.0);
        }
    }

    /// Notes what is needed in a frame and not there.
    fn frame(&mut self, world: &World, now: f64, metres: f64) {
        let (mut in_view, mut near, mut pieces, mut is_late) = (0, 0, 0, false);
        let mut needed = BTreeSet::new();
        world.each_wanted(|&Wanted { key, need, is_near, .. }, room| {
            let is_in_view = need == Need::Visible;
            if is_in_view {
                in_view += 1;
                pieces += room.map_or(0, |room| room.furnished.placements.len());
            }
            if is_in_view || is_near {
                near += u32::from(!is_in_view);
                needed.insert(key);
                let known = self.needs.entry(key).or_insert((now, false, false));
                if room.is_some() && !known.1 {
                    known.1 = true;
                    self.latency_ms.push((now - known.0).max(0.0) * 1000.0);
                }
                if is_in_view && room.is_none() {
                    is_late = true;
                    self.popped += usize::from(!known.2);
                    known.2 = true;
                }
            }
        });
        self.needs.retain(|key, _| needed.contains(key));
        self.late_frames += u64::from(is_late);
        self.in_view.push(f64::from(in_view));
        self.near.push(f64::from(near));
        self.pieces.push(pieces as f64);
        self.rooms = self.rooms.max(world.len());
        self.bytes.push((metres, world.bytes()));
    }
}

/// A path that is walked on and on.
struct Way<'a> {
    stops: &'a [Stop],
    /// Index of the stop that one walks to.
    next: usize,
    /// Metres to the stop before it.
    before: f64,
}

impl Way<'_> {
    /// The place after so many metres, and the direction in which one walks; not less than were asked for before.
    fn at(&mut self, metres: f64) -> (Stop, Point) {
        loop {
            let (from, to) = (self.stops[self.next - 1], self.stops[self.next]);
            let length = from.distance(to);
            if metres < self.before + length || self.next + 1 == self.stops.len() {
                let direction = (to.at - from.at).normalize_or(Point::X);
                let share =
                    if length > 0.0 { ((metres - self.before) / length).clamp(0.0, 1.0) } else { 1.0 };
                // Up to the end of a flight of stairs one is on the level where it begins.
                return (Stop { at: from.at.lerp(to.at, share), ..from }, direction);
            }
            self.before += length;
            self.next += 1;
        }
    }
}
