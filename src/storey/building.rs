//! A whole building: tries its kinds and simpler ways until a plan is sound, and drafts it.

use schemars::JsonSchema;
use serde::Serialize;

use crate::geometry::Segment;
use crate::layout::seed::{Stream, building_stream};
use crate::plan::{BuildingDraft, SitePlacement};

use super::balconies::balconies;
use super::brief::{Brief, Choices, Known, briefs};
use super::check::first_fault;
use super::corridor::corridors;
use super::disc::is_simple;
use super::draft::level_draft;
use super::dwelling::Cell;
use super::entrance_room::with_entrance_room;
use super::entries::links_of_ground;
use super::facade::Neighbourhood;
use super::faces::Partition;
use super::flats::flats;
use super::footprint::{Footprint, Site};
use super::hopeless::{Hopeless, Kind};
use super::house::{house, outer_ports};
use super::links::{Link, Links, link};
use super::open::{SmallRooms, WAYS, one_room, open_plan, within_limits};
use super::plate::Outline;
use super::ring::without_spikes;
use super::spine::Ground;
use super::street_level::street_level;
use super::thin::{Rules, trade_thin_parts};
use super::typology::{PlanKind, Typologies};
use super::windows::{Taken, Window, lit_rooms, windows};

/// How often a kind of building is tried with other random numbers before a simpler way is taken.
const TRIES: usize = 3;
/// Metres of the largest disc below which nobody can stand in a building.
const NARROWEST: f64 = 0.86;
/// Square metres of a part of the simplest open storeys at most: fire compartments are 40 by 40 m (German model code,
/// § 30).
const LARGEST_HALL: f64 = 1600.0;
/// Metres of the outer walls of the smallest sheds.
const THINNEST_WALL: f64 = 0.02;

/// A building with its plan.
#[derive(Clone, Debug)]
pub struct PlannedBuilding {
    /// Its id.
    pub id: String,
    /// Its storeys, in its own frame.
    pub draft: BuildingDraft,
    /// Where that frame is on the plane of the site.
    pub placement: SitePlacement,
    /// How it came about.
    pub report: PlanReport,
}

/// How the plan of a building came about.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct PlanReport {
    /// Id of the building.
    pub id: String,
    /// Its kind.
    pub typology: String,
    /// How that and its storeys are known.
    pub known: Known,
    /// Storeys above the ground.
    pub storeys: u32,
    /// Square metres of the outline.
    pub area: f64,
    /// Flats and other dwellings on all storeys.
    pub dwellings: usize,
    /// Rooms on all storeys.
    pub rooms: usize,
    /// Which way was taken: 0 the kind that was drawn for it, 1 another kind that fits, 2 an open plan, 3 one room on each storey.
    pub rung: u32,
    /// What was wrong with the ways before it.
    pub refused: Vec<String>,
}

/// What levels are planned from.
#[derive(Clone, Copy)]
struct Sketch<'a> {
    grounds: &'a [Ground],
    kind: Kind<'a>,
}

/// A level.
#[derive(Clone)]
pub(super) struct Storey {
    /// Its rooms.
    pub(super) cells: Vec<Cell>,
    /// Its doors.
    pub(super) links: Links,
    /// Its windows.
    pub(super) windows: Vec<Window>,
    /// Metres of its outer walls.
    pub(super) wall: f64,
    /// What is wrong with it, if anything is.
    fault: Option<String>,
}

impl Storey {
    fn sound(self) -> Result<Self, String> {
        match self.fault {
            Some(fault) => Err(fault),
            None => Ok(self),
        }
    }
}

/// Plans the building of a footprint of the site, by its number; `None` where it is too narrow to stand in.
#[must_use]
pub(crate) fn plan_building(
    site: &Site,
    around: &Neighbourhood<'_>,
    index: usize,
    typologies: &Typologies,
    choices: &Choices,
) -> Option<PlannedBuilding> {
    let footprint = &site.footprints[index];
    let outline = Outline::of(footprint, &around.near(index), &around.streets_near(index));
    let measures = outline.measures();
    if measures.depth < NARROWEST {
        return None;
    }
    let kinds = briefs(footprint, measures, typologies, choices);
    let mut refused = Vec::new();
    let hopeless = Hopeless::default();
    for (rung, brief) in kinds.iter().enumerate() {
        let grounds = outline.grounds_that_fill(brief.typology.exterior, brief.storeys);
        if grounds.is_empty() {
            refused.push(format!("{}: the walls leave no floor", brief.name));
            continue;
        }
        for attempt in 0..tries(brief.typology.plan) {
            let stream = building_stream(choices.seed, &footprint.id, &format!("{} {attempt}", brief.name));
            let sketch = Sketch { grounds: &grounds, kind: Kind { brief, typologies, hopeless: &hopeless } };
            match storeys(sketch, footprint.flats, attempt, stream) {
                Ok(storeys) => {
                    let rung = (rung as u32).min(1);
                    return Some(finished(
                        footprint,
                        &outline,
                        brief,
                        (storeys, rung, refused),
                        measures.area,
                    ));
                }
                Err(fault) => refused.push(format!("{}: {fault}", brief.name)),
            }
        }
    }
    let first = kinds.first()?;
    let most = (0.5 * (measures.depth - NARROWEST)).max(THINNEST_WALL);
    let mut grounds =
        outline.grounds(first.typology.exterior.min(measures.depth / 6.0).min(most), first.storeys);
    if grounds.is_empty() {
        grounds = vec![Ground { ring: outline.outer.clone(), facade: outline.facade.clone(), wall: 0.0 }];
    }
    let kind = Kind { brief: first, typologies, hopeless: &hopeless };
    let sketch = Sketch { grounds: &grounds, kind };
    let (storeys, rung) = simplest(sketch);
    Some(finished(footprint, &outline, first, (storeys, rung, refused), measures.area))
}

/// How often a kind is tried: open storeys with as many small rooms as people need, and then with few, from which the way out is shorter.
fn tries(plan: PlanKind) -> usize {
    if plan == PlanKind::Open { 2 * TRIES } else { TRIES }
}

/// All storeys by the plan of a kind, each checked.
fn storeys(
    sketch: Sketch<'_>,
    known_flats: Option<u32>,
    attempt: usize,
    mut stream: Stream,
) -> Result<Vec<Storey>, String> {
    let Sketch { grounds, kind } = sketch;
    let Kind { brief, typologies, .. } = kind;
    let main = brief.typology.main.as_deref().unwrap_or("generic");
    let is_house = brief.typology.plan == PlanKind::House;
    // The kinds of levels: the ground floor, and what stands on it.
    let levels = match brief.typology.plan {
        PlanKind::OneRoom => Some(vec![one_room(grounds, main)]),
        PlanKind::House if grounds.len() > 1 => None,
        PlanKind::House => house(&grounds[0], brief, typologies, &mut stream),
        PlanKind::Flats => flats(grounds, kind, known_flats, attempt, &mut stream).map(|cells| vec![cells]),
        PlanKind::Corridor | PlanKind::CorridorFlats => {
            corridors(grounds, kind, attempt, &mut stream).map(|cells| vec![cells])
        }
        PlanKind::Open => {
            let small = if attempt < TRIES { SmallRooms::Enough } else { SmallRooms::Few };
            open_plan(grounds, brief, typologies, attempt % TRIES, small).map(|cells| vec![cells])
        }
    };
    let mut levels = levels.ok_or("no arrangement keeps to what rooms need")?;
    if let Some(other) = &brief.typology.street_level {
        let ground = street_level(&levels[0], &grounds[0], other);
        levels.insert(0, ground.ok_or("no flat of the ground floor lies at the open air")?);
    }
    levels.splice(0..0, entrance_floor(sketch, &levels[0]));
    for cells in &mut levels {
        // Stairs of a house stand beside other rooms on each level.
        let rules = Rules::of_rooms(typologies);
        trade_thin_parts(cells, if is_house { rules.with_fixed("stairs") } else { rules });
        for cell in cells.iter_mut().filter(|cell| !is_simple(&cell.ring)) {
            cell.ring = without_spikes(std::mem::take(&mut cell.ring));
        }
    }
    let levels: Vec<Vec<Cell>> = levels.into_iter().map(within_limits).collect();
    let mut partition = partition_of(sketch, &levels[0]);
    let mut is_of = 0;
    // Where the ground floor with another room at the way in is not sound, it is as those above.
    let mut ground = storey(sketch, &partition, true, &mut stream);
    if ground.fault.is_some() && brief.typology.entrance.is_some() && levels.len() > 1 {
        (partition, is_of) = (partition_of(sketch, &levels[1]), 1);
        ground = storey(sketch, &partition, true, &mut stream);
    }
    let mut found = vec![ground.sound()?];
    if brief.storeys > 1 {
        let last = levels.len() - 1;
        if is_of != last {
            partition = partition_of(sketch, &levels[last]);
        }
        let upper = storey(sketch, &partition, false, &mut stream).sound()?;
        found.extend(vec![upper; brief.storeys as usize - 1]);
    }
    Ok(found)
}

fn partition_of<'a>(sketch: Sketch<'a>, cells: &'a [Cell]) -> Partition<'a> {
    Partition::new(cells, sketch.kind.typologies, sketch.kind.brief.typology.interior)
}

/// The ground floor with the room that people come into, where the kind has one.
fn entrance_floor(sketch: Sketch<'_>, cells: &[Cell]) -> Option<Vec<Cell>> {
    let Sketch { grounds, kind: Kind { brief, typologies, .. } } = sketch;
    let wanted = typologies.rooms.get_key_value(brief.typology.entrance.as_ref()?)?;
    let ports = grounds.iter().flat_map(outer_ports);
    ports.into_iter().find_map(|port| with_entrance_room(cells, port, brief.typology, wanted))
}

/// A level with its doors and windows.
fn storey(sketch: Sketch<'_>, partition: &Partition<'_>, is_ground: bool, stream: &mut Stream) -> Storey {
    let Sketch { grounds, kind: Kind { brief, .. } } = sketch;
    let links = if is_ground {
        links_of_ground(grounds, partition, stream)
    } else {
        let has_stairs = partition.cells.iter().any(|cell| cell.room_type == "stairs");
        link(partition, &[], has_stairs, stream)
    };
    let has_balconies = !is_ground && stream.unit() < brief.typology.balconies;
    let balconies = if has_balconies { balconies(&grounds[0], partition) } else { Vec::new() };
    let (outside, doors): (Vec<Cell>, Vec<Link>) =
        balconies.into_iter().map(|balcony| (balcony.cell, balcony.door)).unzip();
    let all_doors: Vec<Link> = links.links.iter().chain(&doors).cloned().collect();
    let fixed: Vec<Segment> = outside.iter().map(|cell| Segment::new(cell.ring[0], cell.ring[3])).collect();
    let windows = windows(&grounds[0], partition, Taken { doors: &all_doors, balconies: &fixed });
    let lit = lit_rooms(partition, &windows, &all_doors);
    let fault = first_fault(grounds, partition, &links, &lit, is_ground);
    let links = Links { links: all_doors, ..links };
    let cells = partition.cells.iter().cloned().chain(outside).collect();
    let wall = grounds[0].wall.max(THINNEST_WALL);
    Storey { cells, links, windows, wall, fault }
}

/// Storeys that always come out: open ones with stairs, or one room on each.
fn simplest(sketch: Sketch<'_>) -> (Vec<Storey>, u32) {
    let Sketch { grounds, kind: Kind { brief, typologies, .. } } = sketch;
    let mut stream = building_stream(0, "", "simplest");
    let mut open = brief.typology.clone();
    open.main = Some("generic".to_owned());
    open.services.clear();
    open.compartment = Some(open.compartment.unwrap_or(LARGEST_HALL).min(LARGEST_HALL));
    let plain = Brief { typology: &open, ..brief.clone() };
    let sketch = Sketch { kind: Kind { brief: &plain, ..sketch.kind }, ..sketch };
    // A ground floor, and one plan for all storeys above it.
    let mut levels = |cells: Vec<Cell>| -> Vec<Storey> {
        let cells = within_limits(cells);
        let partition = partition_of(sketch, &cells);
        let mut levels = vec![storey(sketch, &partition, true, &mut stream)];
        if brief.storeys > 1 {
            let upper = storey(sketch, &partition, false, &mut stream);
            levels.extend(vec![upper; brief.storeys as usize - 1]);
        }
        levels
    };
    for mut cells in
        (0..WAYS.len()).filter_map(|attempt| open_plan(grounds, &plain, typologies, attempt, SmallRooms::Few))
    {
        trade_thin_parts(&mut cells, Rules::of_rooms(typologies));
        let storeys = levels(cells);
        if storeys.iter().all(|storey| storey.fault.is_none()) {
            return (storeys, 2);
        }
    }
    (levels(one_room(grounds, "generic")), 3)
}

fn finished(
    footprint: &Footprint,
    outline: &Outline,
    brief: &Brief<'_>,
    (storeys, rung, refused): (Vec<Storey>, u32, Vec<String>),
    area: f64,
) -> PlannedBuilding {
    let units = |storey: &Storey| {
        let units: std::collections::BTreeSet<usize> =
            storey.cells.iter().filter_map(|cell| cell.unit).collect();
        units.len()
    };
    let dwellings = match brief.typology.plan {
        PlanKind::House => usize::from(rung < 2),
        _ => storeys.iter().map(units).sum(),
    };
    let report = PlanReport {
        id: footprint.id.clone(),
        typology: brief.name.to_owned(),
        known: brief.known.clone(),
        storeys: brief.storeys,
        area: (area * 10.0).round() / 10.0,
        dwellings,
        rooms: storeys.iter().map(|storey| storey.cells.len()).sum(),
        rung,
        refused,
    };
    let levels =
        storeys.iter().enumerate().map(|(number, storey)| level_draft(storey, number, brief)).collect();
    let draft = BuildingDraft { name: footprint.name.clone(), levels, ..BuildingDraft::default() };
    let placement = SitePlacement { position: outline.frame.origin, turn: outline.frame.turn };
    PlannedBuilding { id: footprint.id.clone(), draft, placement, report }
}
