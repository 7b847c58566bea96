//! Works out the windows that dragonfly's window parameters ask for in a rectangular wall.
//!
//! The shapes follow the descriptions of dragonfly-schema; where these leave a choice, windows are centred.

use super::model::Hole;
use super::schema::WindowParameters;
use crate::geometry::Point;

/// Share of a wall that a window may have along and up; frames need the rest.
const LARGEST_SHARE: f64 = 0.98;
/// Share of a wall that all its windows may have.
const LARGEST_RATIO: f64 = 0.99;
/// Windows in a row in one wall: a façade of 200 m with one each metre.
const MOST_IN_ROW: f64 = 200.0;
/// Metres of the narrowest window of a row; of narrower ones one is made, which is reported.
const NARROWEST: f64 = 0.1;
/// Sill of a single window whose parameters name none, in the units of the model, as the schema has it.
const USUAL_SILL: f64 = 1.0;

/// A wall that windows are made for, in metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// The first corner of its edge, with the height of the floor.
    pub(super) start: Point,
    pub(super) floor: f64,
    /// Of length 1 unless the wall has none.
    pub(super) along: Point,
    pub(super) length: f64,
    pub(super) height: f64,
    /// Metres of a unit of the model.
    pub(super) unit: f64,
}

/// Windows in a row: so many of a width, in as many equal parts of the wall.
struct Row {
    count: f64,
    width: f64,
    bottom: f64,
    height: f64,
}

/// The holes that parameters ask for; `None` for parameters of an unknown kind or without what their kind needs.
pub(super) fn holes(parameters: &WindowParameters, face: &Face, id: &str) -> Option<Vec<Hole>> {
    let row = match parameters.kind.as_str() {
        "DetailedWindows" => return detailed(parameters, face, id),
        "RectangularWindows" => return rectangular(parameters, face, id),
        "SingleWindow" => single(parameters, face)?,
        "SimpleWindowRatio" => share(parameters.window_ratio?, face),
        "SimpleWindowArea" => {
            let area = parameters.window_area? * face.unit * face.unit;
            share(area / (face.length * face.height), face)
        }
        "RepeatingWindowRatio" => repeating_ratio(parameters, face)?,
        "RepeatingWindowWidthHeight" => repeating(parameters, face)?,
        _ => return None,
    };
    Some(row.holes(face, id))
}

impl Row {
    fn holes(&self, face: &Face, id: &str) -> Vec<Hole> {
        let Self { count, width, bottom, height } = *self;
        let slot = face.length / count;
        let is_sound = [width, bottom, height, slot].iter().all(|length| length.is_finite());
        let count = match (is_sound, width >= NARROWEST) {
            (true, true) => count as usize,
            (true, false) => 1,
            (false, _) => 0,
        };
        let hole = |number: usize| {
            let middle = slot * (number as f64 + 0.5);
            let (from, to) = (middle - width / 2.0, middle + width / 2.0);
            Hole { id: numbered(id, number), is_door: false, from, to, bottom, top: bottom + height }
        };
        (0..count).map(hole).collect()
    }
}

fn numbered(id: &str, number: usize) -> String {
    format!("{id}.{}", number + 1)
}

/// One window as wide and high as the wall, but for a share of its area.
fn share(ratio: f64, face: &Face) -> Row {
    let scale = ratio.clamp(0.0, LARGEST_RATIO).sqrt();
    let height = face.height * scale;
    Row { count: 1.0, width: face.length * scale, bottom: (face.height - height) / 2.0, height }
}

fn single(parameters: &WindowParameters, face: &Face) -> Option<Row> {
    let width = (parameters.width? * face.unit).min(face.length * LARGEST_SHARE);
    let (bottom, height) = upright(parameters.height?, parameters.sill_height, face);
    Some(Row { count: 1.0, width, bottom, height })
}

/// Sill and height of a window, lowered and cut where the wall is too low for it.
fn upright(height: f64, sill: Option<f64>, face: &Face) -> (f64, f64) {
    let height = (height * face.unit).min(face.height * LARGEST_SHARE);
    let highest = (face.height * (1.0 + LARGEST_SHARE) / 2.0 - height).max(0.0);
    ((sill.unwrap_or(USUAL_SILL) * face.unit).min(highest), height)
}

/// How many parts of a wall are a separation long.
fn parts(separation: f64, face: &Face) -> f64 {
    // Written so that no separation, or a negative one, gives the most.
    let count = if separation > 0.0 { (face.length / separation).floor() } else { MOST_IN_ROW };
    count.clamp(1.0, MOST_IN_ROW)
}

fn repeating_ratio(parameters: &WindowParameters, face: &Face) -> Option<Row> {
    let area = parameters.window_ratio?.clamp(0.0, LARGEST_RATIO) * face.length * face.height;
    let (_, wanted) = upright(parameters.window_height?, None, face);
    // The share of the wall counts more than the height of its windows.
    let height = wanted.max(area / (face.length * LARGEST_SHARE)).min(face.height * LARGEST_SHARE);
    let (bottom, height) = upright(height / face.unit, parameters.sill_height, face);
    let width = area / height;
    let separation = parameters.horizontal_separation? * face.unit;
    // No separation, or windows as wide as their parts: a ribbon.
    let count = if separation > 0.0 { parts(separation, face) } else { 1.0 };
    Some(Row { count, width: width / count, bottom, height })
}

fn repeating(parameters: &WindowParameters, face: &Face) -> Option<Row> {
    let width = (parameters.window_width? * face.unit).min(face.length * LARGEST_SHARE);
    let (bottom, height) = upright(parameters.window_height?, parameters.sill_height, face);
    let apart = parts((parameters.horizontal_separation? * face.unit).max(width), face);
    Some(Row { count: apart, width, bottom, height })
}

fn rectangular(parameters: &WindowParameters, face: &Face, id: &str) -> Option<Vec<Hole>> {
    let (origins, widths, heights) =
        (parameters.origins.as_ref()?, parameters.widths.as_ref()?, parameters.heights.as_ref()?);
    let sizes = origins.iter().zip(widths).zip(heights);
    let holes = sizes.enumerate().map(|(number, ((&[x, y], width), height))| {
        let corners = [(x, y), (x + width, y + height)].map(|(x, y)| (x * face.unit, y * face.unit));
        Hole::around(numbered(id, number), is_door(parameters, number), corners.into_iter())
    });
    Some(holes.collect())
}

fn detailed(parameters: &WindowParameters, face: &Face, id: &str) -> Option<Vec<Hole>> {
    let polygons = parameters.polygons.as_ref()?.iter().enumerate();
    let holes = polygons.map(|(number, polygon)| {
        let corners = polygon.iter().filter_map(|corner| in_plane(corner, face));
        Hole::around(numbered(id, number), is_door(parameters, number), corners)
    });
    Some(holes.collect())
}

/// Metres along a wall and above its floor of a corner; one of three numbers is a point in space.
fn in_plane(corner: &[f64], face: &Face) -> Option<(f64, f64)> {
    match *corner {
        [x, y] => Some((x * face.unit, y * face.unit)),
        [x, y, z] => {
            let place = Point::new(x, y) * face.unit;
            Some(((place - face.start).dot(face.along), z * face.unit - face.floor))
        }
        _ => None,
    }
}

fn is_door(parameters: &WindowParameters, number: usize) -> bool {
    parameters.are_doors.as_ref().and_then(|doors| doors.get(number)).copied().unwrap_or(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACE: Face =
        Face { start: Point::ZERO, floor: 0.0, along: Point::X, length: 10.0, height: 3.0, unit: 1.0 };

    fn of(kind: &str, fill: impl FnOnce(&mut WindowParameters)) -> Vec<Hole> {
        let mut parameters = WindowParameters { kind: kind.to_owned(), ..WindowParameters::default() };
        fill(&mut parameters);
        holes(&parameters, &FACE, "a.1").expect("known parameters")
    }

    fn area(holes: &[Hole]) -> f64 {
        holes.iter().map(|hole| hole.width() * (hole.top - hole.bottom)).sum()
    }

    #[test]
    fn ratios_and_areas_are_those_of_the_windows() {
        let cases = [
            (of("SimpleWindowRatio", |p| p.window_ratio = Some(0.4)), 12.0, 1),
            (of("SimpleWindowArea", |p| p.window_area = Some(6.0)), 6.0, 1),
            (of("SimpleWindowArea", |p| p.window_area = Some(600.0)), 29.7, 1),
        ];
        for (holes, expected, count) in cases {
            assert!((area(&holes) - expected).abs() < 1e-9, "{holes:?}");
            assert_eq!(holes.len(), count);
        }
    }

    #[test]
    fn rows_keep_their_share_their_height_and_their_number() {
        let row = |ratio: f64| {
            of("RepeatingWindowRatio", |p| {
                p.window_ratio = Some(ratio);
                p.window_height = Some(2.0);
                p.sill_height = Some(0.8);
                p.horizontal_separation = Some(3.0);
            })
        };
        let usual = row(0.3);
        assert_eq!(usual.len(), 3);
        assert!((area(&usual) - 9.0).abs() < 1e-9);
        assert!(usual.iter().all(|hole| (hole.bottom - 0.8).abs() < 1e-9 && (hole.top - 2.8).abs() < 1e-9));
        let large = row(0.9);
        assert!((area(&large) - 27.0).abs() < 1e-9, "the share counts more than the height");
        assert!(large.iter().all(|hole| hole.bottom < 0.8 && hole.top <= 3.0));
        assert!(large.windows(2).all(|pair| pair[0].to <= pair[1].from + 1e-9));
    }

    #[test]
    fn windows_of_a_size_stand_centred_in_equal_parts() {
        let row = of("RepeatingWindowWidthHeight", |p| {
            (p.window_width, p.window_height) = (Some(1.5), Some(2.0));
            (p.sill_height, p.horizontal_separation) = (Some(0.5), Some(4.0));
        });
        let spans: Vec<(f64, f64)> = row.iter().map(|hole| (hole.from, hole.to)).collect();
        assert_eq!(spans, [(1.75, 3.25), (6.75, 8.25)]);
        let wide = of("SingleWindow", |p| (p.width, p.height) = (Some(1e9), Some(1.0)));
        assert!((wide[0].width() - 9.8).abs() < 1e-9);
        assert_eq!((wide[0].bottom, wide[0].top), (1.0, 2.0));
    }

    #[test]
    fn hostile_separations_make_no_more_windows_than_a_row_has() {
        for separation in [0.0, -1.0, 1e-300] {
            let row = of("RepeatingWindowWidthHeight", |p| {
                (p.window_width, p.window_height) = (Some(1e-9), Some(2.0));
                (p.sill_height, p.horizontal_separation) = (Some(0.5), Some(separation));
            });
            assert!(row.len() <= MOST_IN_ROW as usize, "{}", row.len());
        }
    }

    #[test]
    fn corners_in_space_and_in_the_wall_are_the_same_window() {
        let face = Face { start: Point::new(2.0, 1.0), floor: 3.0, along: Point::Y, unit: 0.5, ..FACE };
        let flat = [[2.0, 1.0], [4.0, 1.0], [4.0, 5.0]];
        let deep = flat.map(|[x, y]| vec![4.0, 2.0 + x, 6.0 + y]);
        let made = |polygons: Vec<Vec<f64>>| {
            let parameters = WindowParameters {
                kind: "DetailedWindows".to_owned(),
                polygons: Some(vec![polygons]),
                are_doors: Some(vec![true]),
                ..WindowParameters::default()
            };
            holes(&parameters, &face, "a").expect("known parameters")
        };
        let holes = made(flat.map(|corner| corner.to_vec()).to_vec());
        assert_eq!(holes, made(deep.to_vec()));
        let expected =
            Hole { id: "a.1".to_owned(), is_door: true, from: 1.0, to: 2.0, bottom: 0.5, top: 2.5 };
        assert_eq!(holes, [expected]);
    }
}
