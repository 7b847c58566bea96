//! The occupancy map of a level, as robots load it: a picture and a text that says where it lies.
//!
//! `map_server` of ROS and of Nav2 reads the pair ("trinary" mode: <https://docs.nav2.org/configuration/packages/configuring-map-server.html>).

use png::{BitDepth, ColorType, Compression, Encoder};

use crate::geometry::{Bounds, Point, Segment, edges};
use crate::walk::{Raster, cell_around};

use super::floor::LevelFloor;

/// Grey of floor that nothing stands on, of walls and furniture, and of what no room of the level says anything about: those of
/// `map_saver`.
const FREE: u8 = 254;
const TAKEN: u8 = 0;
const UNKNOWN: u8 = 205;
/// The shares of black below and above which a reader takes a cell as free and as taken: the first is less than that of
/// `UNKNOWN`, as in `map_saver` of ROS 1.
const THRESHOLDS: [f64; 2] = [0.196, 0.65];
/// Metres of a wall that are drawn, whatever its thickness.
const WALL: f64 = 0.1;

/// A map.
#[derive(Clone, Debug, PartialEq)]
pub struct Occupancy {
    /// A PNG file, one grey pixel for each cell, north above.
    pub picture: Vec<u8>,
    /// Metres of a cell.
    cell: f64,
    /// The outer corner of the cell below on the left, in the frame of the plan.
    origin: Point,
}

impl Occupancy {
    /// The text that goes with the picture, in YAML.
    #[must_use]
    pub fn description(&self, picture: &str) -> String {
        let Point { x, y } = self.origin;
        let [free, taken] = THRESHOLDS;
        // JSON quotes as YAML does.
        let picture = serde_json::Value::from(picture);
        format!(
            "image: {picture}\nmode: trinary\nresolution: {}\norigin: [{x:.5}, {y:.5}, 0.0]\nnegate: 0\n\
             occupied_thresh: {taken}\nfree_thresh: {free}\n",
            self.cell
        )
    }
}

/// The map with cells of some metres: wider ones for levels whose box has more than 11 million such cells.
#[must_use]
pub fn occupancy(floor: &LevelFloor<'_>, resolution: f64) -> Occupancy {
    let rooms = floor.level.rooms.iter().enumerate();
    let known = || rooms.clone().filter_map(|(index, room)| Some((room, floor.bodies(index)?)));
    let bounds = known().map(|(room, _)| room.region.outline.bounds()).fold(Bounds::EMPTY, Bounds::union);
    let bounds = if known().next().is_none() { Bounds::new(Point::ZERO, Point::ZERO) } else { bounds };
    let cell = cell_around(bounds.size(), resolution);
    let mut raster = Raster::new(bounds.inflated(WALL + cell), cell);
    for (room, _) in known() {
        raster.paint(&room.region.borders().collect::<Vec<Segment>>(), true);
    }
    let is_known = |room: usize| floor.bodies(room).is_some();
    for threshold in floor.thresholds() {
        if floor.level.openings[threshold.opening].sides.iter().any(|side| is_known(side.room)) {
            raster.paint(&edges(&threshold.widened(cell)).collect::<Vec<_>>(), true);
        }
    }
    let mut cells = around_free(&raster, (WALL / cell).ceil() as usize);
    for (_, bodies) in known() {
        for body in bodies {
            raster.spans(&edges(&body.footprint).collect::<Vec<_>>(), |span| {
                cells[span].iter_mut().filter(|grey| **grey == FREE).for_each(|grey| *grey = TAKEN);
            });
        }
    }
    Occupancy { picture: png(&cells, raster.columns()), cell, origin: raster.corner() }
}

/// Free cells, taken ones for some cells around them, and unknown ones.
fn around_free(raster: &Raster, reach: usize) -> Vec<u8> {
    let columns = raster.columns();
    let free: Vec<bool> = (0..raster.len()).map(|cell| raster.is_free(cell)).collect();
    // Along rows first, then along columns: what is near in both ways.
    let in_rows: Vec<bool> = free.chunks(columns).flat_map(|row| spread(row, reach)).collect();
    let mut cells = vec![UNKNOWN; free.len()];
    for column in 0..columns {
        let line: Vec<bool> = in_rows[column..].iter().step_by(columns).copied().collect();
        for (row, is_near) in spread(&line, reach).into_iter().enumerate() {
            let cell = row * columns + column;
            if free[cell] {
                cells[cell] = FREE;
            } else if is_near {
                cells[cell] = TAKEN;
            }
        }
    }
    cells
}

/// A line in which everything so near to a true place is true.
fn spread(line: &[bool], reach: usize) -> Vec<bool> {
    let mut wide = line.to_vec();
    let mut start = 0;
    for run in line.chunk_by(|before, after| before == after) {
        let end = start + run.len();
        if run[0] {
            wide[start.saturating_sub(reach)..(end + reach).min(line.len())].fill(true);
        }
        start = end;
    }
    wide
}

/// Rows of grey pixels as a file; the last row is above.
fn png(cells: &[u8], columns: usize) -> Vec<u8> {
    let size =
        [columns, cells.len() / columns].map(|side| u32::try_from(side).expect("a level has few cells"));
    let pixels: Vec<u8> = cells.chunks(columns).rev().flatten().copied().collect();
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, size[0], size[1]);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&pixels));
    written.expect("memory takes all that is written, and the sizes agree");
    bytes
}
