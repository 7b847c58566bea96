//! Damaged entries of the cache.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use super::world::{World, plan};

/// The entries, with their hashes; notes of where plans lie are none.
fn kept(world: &World) -> BTreeMap<String, String> {
    let mut files = world.files("cache");
    files.retain(|name, _| name.ends_with(".entry"));
    files
}

fn entries(world: &World) -> Vec<PathBuf> {
    let entries = kept(world);
    assert!(entries.len() > 10, "{entries:?}");
    entries.into_keys().map(|name| world.path("cache").join(name)).collect()
}

fn bake(world: &World, out: &str) {
    let mut command = world.command(&["bake", "a.yaml", "--quiet", "--out", out]);
    let output = command.env("ROOMWRIGHT_CACHE", "cache").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// What becomes of an entry, by its number, and the bytes of the next.
type Damage = fn(usize, &mut Vec<u8>, &[u8]);

/// In each entry another bit, then other lengths, then each under the name of the next.
#[test]
fn damaged_entries_change_no_byte_and_are_made_anew() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    bake(&world, "whole");
    let whole = world.files("whole");
    let before = kept(&world);
    let damages: [Damage; 4] = [
        |index, bytes, _| {
            let place = index * 7919 % bytes.len();
            bytes[place] ^= 1 << (index % 8);
        },
        |index, bytes, _| bytes.truncate(index * 7919 % bytes.len()),
        |_, bytes, next| *bytes = next.to_vec(),
        |_, bytes, _| bytes.clear(),
    ];
    for (number, damage) in damages.into_iter().enumerate() {
        let entries = entries(&world);
        let contents: Vec<Vec<u8>> = entries.iter().map(|path| fs::read(path).unwrap()).collect();
        for (index, path) in entries.iter().enumerate() {
            let mut bytes = contents[index].clone();
            damage(index, &mut bytes, &contents[(index + 1) % contents.len()]);
            fs::write(path, bytes).unwrap();
        }
        let out = format!("out{number}");
        bake(&world, &out);
        assert_eq!(world.files(&out), whole, "damage {number}");
        assert_eq!(kept(&world), before, "damage {number}: entries are made anew");
    }
}
