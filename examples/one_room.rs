//! Furnishes one room of a plan on demand, prints its furniture and findings, and writes it as a file of its own.
//!
//! `cargo run --release --example one_room -- PLAN BUILDING/LEVEL/ROOM OUT.glb [STYLE]`; without arguments, the living room of
//! the built-in house.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program for the command line")]

use std::error::Error;
use std::fs;

use roomwright::Project;
use roomwright::furniture::{Catalog, Placement};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let defaults = ["configs/plans/house.yaml", "house/ground/living", "room.glb"];
    let [plan, room, out] =
        std::array::from_fn(|index| arguments.get(index).map_or(defaults[index], String::as_str));

    // What cannot be read is missing from the project, and named in its faults.
    let project = Project::read(&[plan].into_iter().collect())?;
    eprint!("{}", project.faults);
    let options = match arguments.get(3) {
        Some(style) => project.level_options_in(style)?,
        None => project.level_options(),
    };
    let rooms = project.rooms(&options);
    let room = rooms.furnish(&room.parse()?)?;

    for placement in &room.furnished.placements {
        println!("{}", line(placement, &project.catalog));
    }
    for finding in &room.verdict.findings {
        println!("{finding}");
    }
    fs::write(out, rooms.glb(&room)?)?;
    Ok(())
}

/// Id, place and size of a piece.
fn line(placement: &Placement, catalog: &Catalog) -> String {
    let (class, number) = (&catalog.classes[placement.class].id, placement.number);
    let (at, size) = (placement.position, placement.size);
    format!(
        "{class}.{number} at {:.2}, {:.2}: {:.2} x {:.2} x {:.2} m",
        at.x, at.y, size.width, size.depth, size.height
    )
}
