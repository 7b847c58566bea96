//! Finished files are judged as the bake judged them, and edited ones as they are now.

use std::path::Path;

use serde_json::{Value, json};

use roomwright::internals::audit::{Code, Finding, Verdict};
use roomwright::internals::layout::Parent;
use roomwright::internals::plan::OpeningKind;
use roomwright::internals::read_back::{ReadLevel, parse_level};
use roomwright::internals::solve::judge_room;

use crate::pipeline::{BakedLevel, Pipeline, each_level};
use crate::root;

/// Files hold single precision; measures may differ by this.
const ROUNDING: f64 = 1e-3;

/// The level as its file has it, without a fault.
fn read(pipeline: &Pipeline, glb: &[u8], place: &str) -> ReadLevel {
    let read = parse_level(Path::new(place), glb, &pipeline.catalog).unwrap();
    assert!(read.faults.is_empty(), "{}", read.faults);
    read
}

fn verdict(pipeline: &Pipeline, read: &ReadLevel, room: &str) -> Verdict {
    let index = read.level.rooms.iter().position(|other| other.id == room).unwrap();
    judge_room(read.level.room(index), read.furnished[index].as_ref().unwrap(), &pipeline.catalog)
}

/// What differs between what the bake said of a level and what its file says, a line each.
fn differences(pipeline: &Pipeline, baked: &BakedLevel<'_>) -> Vec<String> {
    let place = format!("{}/{}", baked.building, baked.level.id);
    let read = read(pipeline, &baked.glb, &place);
    assert_eq!(read.level.rooms.len(), baked.level.rooms.len());
    let rooms = baked.level.rooms.iter().zip(&baked.verdicts);
    let lines = rooms.filter_map(|(room, expected)| {
        let found = verdict(pipeline, &read, &room.id);
        let scores = [expected.score, found.score];
        let is_scored = match scores {
            [Some(one), Some(two)] => (one.value - two.value).abs() <= ROUNDING,
            both => both == [None, None],
        };
        let is_same = expected.grade() == found.grade()
            && expected.findings.len() == found.findings.len()
            && expected.findings.iter().zip(&found.findings).all(|(one, two)| is_same_finding(one, two));
        (!is_scored || !is_same).then(|| {
            format!("{place}/{}: {scores:?}\n  {:?}\n  {:?}", room.id, expected.findings, found.findings)
        })
    });
    lines.collect()
}

fn is_same_finding(one: &Finding, two: &Finding) -> bool {
    (one.code, one.severity, &one.objects) == (two.code, two.severity, &two.objects)
        && (one.measured - two.measured).abs() <= ROUNDING
        && (one.threshold - two.threshold).abs() <= ROUNDING
}

/// Asserts that the audit says of a level's file what the bake said of the level.
pub fn check_agreement(pipeline: &Pipeline, baked: &BakedLevel<'_>) {
    let different = differences(pipeline, baked);
    assert!(different.is_empty(), "{}", different.join("\n"));
}

/// The document and the rest of a `.glb`.
fn split(glb: &[u8]) -> (Value, &[u8]) {
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    (serde_json::from_slice(&glb[20..20 + length]).unwrap(), &glb[20 + length..])
}

fn join(document: &Value, rest: &[u8]) -> Vec<u8> {
    let mut text = serde_json::to_vec(document).unwrap();
    text.resize(text.len().next_multiple_of(4), b' ');
    let word = |number: usize| u32::try_from(number).unwrap().to_le_bytes();
    let head = [*b"glTF", word(2), word(20 + text.len() + rest.len()), word(text.len()), *b"JSON"];
    [head.as_flattened(), &text, rest].concat()
}

#[test]
fn an_object_moved_into_a_door_is_found_there() {
    let pipeline = Pipeline::new();
    let reading = pipeline.read(&[root().join("configs/cases/flat.yaml")]);
    let mut moved = 0;
    each_level(&reading.plan, |building, level| {
        let baked = pipeline.bake(building, level);
        let (mut document, rest) = split(&baked.glb);
        assert!(parse_level(Path::new("same"), &join(&document, rest), &pipeline.catalog).is_ok());
        // A piece that stands on the floor of a room with a door.
        let rooms = || level.rooms.iter().zip(&baked.furnished);
        let Some((room, place, class)) = rooms().find_map(|(room, furnished)| {
            let door =
                room.openings.iter().find(|place| level.openings[place.opening].kind == OpeningKind::Door)?;
            let piece = furnished.placements.iter().find(|piece| {
                let is_low = piece.elevation == 0.0 && piece.size.height > 0.3;
                is_low && matches!(piece.parent, Parent::Floor | Parent::Wall(_))
            })?;
            Some((room, door, format!("{}.{}", pipeline.catalog.classes[piece.class].id, piece.number)))
        }) else {
            return;
        };
        let door = &level.openings[place.opening];
        let wall = &room.walls[place.wall];
        let before =
            wall.start + wall.direction() * f64::midpoint(place.from, place.to) + wall.normal() * 0.5;
        let nodes = document["nodes"].as_array_mut().unwrap();
        let node = nodes.iter_mut().find(|node| node["name"] == format!("{class}@{}", room.id)).unwrap();
        node["translation"] = json!([before.x, 0.0, -before.y]);
        let read = read(&pipeline, &join(&document, rest), "moved.glb");
        let findings = verdict(&pipeline, &read, &room.id).findings;
        let mut objects = [class.clone(), format!("door:{}", door.id)];
        objects.sort();
        let is_blocked = |finding: &Finding| finding.code == Code::DoorBlocked && finding.objects == objects;
        assert!(findings.iter().any(is_blocked), "{class} before door:{}: {findings:?}", door.id);
        let index = level.rooms.iter().position(|other| other.id == room.id).unwrap();
        assert!(!baked.verdicts[index].findings.iter().any(is_blocked));
        moved += 1;
    });
    assert!(moved > 0, "some room has a door and a piece on its floor");
}
