//! Checks the numbers, words and edges of a plan file before rooms are built.

use std::collections::BTreeSet;

use super::file::{ColumnFile, LevelFile, OpeningAt, OpeningFile, OpeningWord, PlanFile, RoomFile, VERSION};
use super::report::{Report, item, step};
use super::units::LengthUnit;
use crate::document::{PathStep, did_you_mean};
use crate::plan::RoomWords;
use crate::plan::limits::{COORDINATE, OPENING_WIDTH, ROOM_SIDE, STOREY_HEIGHT, WALL_THICKNESS};

/// Lowest and highest end of an opening in metres.
const OPENING_END: (f64, f64) = (0.0, 100.0);
/// Narrowest and widest column in metres.
const COLUMN_EXTENT: (f64, f64) = (0.01, 100.0);
/// Least and largest angle in degrees that a leaf opens.
const SWING: (f64, f64) = (10.0, 180.0);

/// Usual extent of a room in metres, for guessing units.
const USUAL_EXTENT: f64 = 4.0;
/// Where the range of a length begins at zero, its magnitude begins here, in metres.
const LEAST_MAGNITUDE: f64 = 0.05;

/// Checks everything that needs no other part of the file; gives the document paths of rooms that are left out.
pub(super) fn check_file(
    file: &PlanFile,
    words: &RoomWords,
    report: &mut Report<'_>,
) -> BTreeSet<Vec<PathStep>> {
    let mut check = Check { units: file.units, words, report, left_out: BTreeSet::new() };
    if file.version != VERSION {
        let message = format!("version {} is not known", file.version);
        check.report.error(
            &["version".into()],
            message,
            Some(format!("this program reads version {VERSION}")),
        );
    }
    if file.levels.is_empty() {
        let hint = "a plan has at least one level with a room";
        check.report.error(&["levels".into()], "the building has no level", Some(hint.to_owned()));
    }
    for (key, thickness) in [("exterior", file.walls.exterior), ("interior", file.walls.interior)] {
        check.length(&["walls".into(), key.into()], "wall thickness", thickness, WALL_THICKNESS);
    }
    for (name, prototype) in &file.prototypes {
        let path = ["prototypes".into(), name.as_str().into()];
        check.parts(&path, (&prototype.rooms, &prototype.openings, &prototype.columns));
        if prototype.rooms.is_empty() {
            check.report.error(&path, format!("prototype \"{name}\" has no room"), None);
        }
    }
    for (index, level) in file.levels.iter().enumerate() {
        check.level(&["levels".into(), index.into()], level);
    }
    check.left_out
}

struct Check<'a, 'b> {
    units: LengthUnit,
    words: &'a RoomWords,
    report: &'a mut Report<'b>,
    /// Document paths of rooms that no building has.
    left_out: BTreeSet<Vec<PathStep>>,
}

/// Where something is out of range, the fact and a hint.
type Misfit = (Vec<PathStep>, String, Option<String>);

type Parts<'a> = (&'a [RoomFile], &'a [OpeningFile], &'a [ColumnFile]);

impl Check<'_, '_> {
    fn level(&mut self, path: &[PathStep], level: &LevelFile) {
        self.length(&step(path, "height"), "height", level.height, STOREY_HEIGHT);
        self.length(&step(path, "elevation"), "elevation", level.elevation, (-COORDINATE, COORDINATE));
        self.parts(path, (&level.rooms, &level.openings, &level.columns));
        if level.rooms.is_empty() && level.place.is_empty() {
            let message = format!("level \"{}\" has no room", level.id);
            self.report.error(path, message, Some("give it `rooms`, or `place` a prototype".to_owned()));
        }
        for (index, railing) in level.railings.iter().enumerate() {
            self.refuse(self.points(&item(path, "railings", index), railing));
        }
        for (index, place) in level.place.iter().enumerate() {
            let path = item(path, "place", index);
            self.refuse(self.points(&step(&path, "at"), &[place.at]));
            if !place.turn.is_finite() {
                self.report.error(&step(&path, "turn"), format!("{} is no angle", place.turn), None);
            }
            if let Some(repeat) = &place.repeat {
                let far = repeat.step.map(|length| length * f64::from(repeat.count));
                self.refuse(self.points(&step(&step(&path, "repeat"), "step"), &[far]));
            }
        }
    }

    fn parts(&mut self, path: &[PathStep], (rooms, openings, columns): Parts<'_>) {
        for (index, room) in rooms.iter().enumerate() {
            self.room(&item(path, "rooms", index), room);
        }
        for (index, opening) in openings.iter().enumerate() {
            self.opening(&item(path, "openings", index), opening);
        }
        for (index, column) in columns.iter().enumerate() {
            self.column(&item(path, "columns", index), column);
        }
    }

    fn room(&mut self, path: &[PathStep], room: &RoomFile) {
        let known = &self.words.known;
        if !known.is_empty() && !known.contains(&room.room_type) {
            let message = format!("unknown room type \"{}\"", room.room_type);
            let meant = self.words.meant(&room.room_type).map(|meant| format!("did you mean \"{meant}\"?"));
            let hint = meant.or_else(|| did_you_mean(&room.room_type, known));
            self.report.error(&step(path, "type"), message, hint);
        }
        let what = format!("room \"{}\"", room.id);
        self.one_shape(
            path,
            &what,
            &[("outline", room.outline.is_some()), ("rectangle", room.rectangle.is_some())],
        );
        if let Some(outline) = &room.outline {
            let shape = step(path, "outline");
            let misfit = self.points(&shape, outline);
            self.leave_out(path, misfit.or_else(|| self.extent(&shape, &what, outline, ROOM_SIDE)));
        }
        if let Some(rectangle) = room.rectangle {
            let misfit = self.rectangle(&step(path, "rectangle"), &what, rectangle, ROOM_SIDE);
            self.leave_out(path, misfit);
        }
        for (index, hole) in room.holes.iter().enumerate() {
            self.leave_out(path, self.points(&item(path, "holes", index), hole));
        }
        self.length(&step(path, "height"), "height", room.height, STOREY_HEIGHT);
        let edge_count = room.outline.as_ref().map_or(4, Vec::len);
        for (index, tags) in room.walls.iter().enumerate() {
            for edge in tags.edge.as_slice().iter().filter(|edge| **edge >= edge_count) {
                let message = format!("{what} has no edge {edge}");
                let path = step(&item(path, "walls", index), "edge");
                self.report.error(&path, message, Some(edge_hint(edge_count)));
            }
        }
    }

    fn opening(&mut self, path: &[PathStep], opening: &OpeningFile) {
        match opening.at {
            Some(OpeningAt::Point(at)) => self.refuse(self.points(&step(path, "at"), &[at])),
            Some(OpeningAt::Distance(_)) if opening.edge.is_none() => {
                let hint = "write `at: [x, y]`, or name `room` and `edge` that it is measured along";
                self.report.error(
                    &step(path, "at"),
                    "`at` is a distance along no edge",
                    Some(hint.to_owned()),
                );
            }
            None if opening.edge.is_none() => {
                let hint = "write `at: [x, y]`, or `room` and `edge`";
                self.report.error(path, "the opening has no place", Some(hint.to_owned()));
            }
            _ => {}
        }
        if opening.edge.is_some() && opening.room.is_none() {
            let hint = Some("name the `room` whose edge it is".to_owned());
            self.report.error(&step(path, "edge"), "the edge of which room?", hint);
        }
        if opening.edge.is_some() && matches!(opening.at, Some(OpeningAt::Point(_))) {
            let hint = Some(
                "with `edge`, `at` is the distance along it; with `at: [x, y]` leave `edge` out".to_owned(),
            );
            self.report.error(&step(path, "at"), "the opening has two places", hint);
        }
        self.length(&step(path, "width"), "width", opening.width, OPENING_WIDTH);
        for (key, value) in [("sill", opening.sill), ("head", opening.head), ("height", opening.height)] {
            self.length(&step(path, key), key, value, OPENING_END);
        }
        self.ends(path, opening);
        self.leaf(path, opening);
    }

    fn ends(&mut self, path: &[PathStep], opening: &OpeningFile) {
        if opening.head.is_some() && opening.height.is_some() {
            let hint =
                Some("`head` is above the floor, `height` above the sill: keep one of them".to_owned());
            self.report.error(&step(path, "height"), "both `head` and `height` are given", hint);
        }
        if let (Some(sill), Some(head)) = (opening.sill, opening.head)
            && head <= sill
        {
            let message = format!("the head at {head} is not above the sill at {sill}");
            self.report.error(&step(path, "head"), message, None);
        }
        if opening.height == Some(0.0) {
            self.report.error(&step(path, "height"), "the opening has no height", None);
        }
    }

    fn leaf(&mut self, path: &[PathStep], opening: &OpeningFile) {
        let keys = [
            ("hinge", opening.hinge.is_some()),
            ("opens_into", opening.opens_into.is_some()),
            ("leaves", opening.leaves.is_some()),
            ("swing", opening.swing.is_some()),
        ];
        for (key, _) in keys.into_iter().filter(|(_, given)| *given && opening.kind != OpeningWord::Door) {
            let hint = Some("only `kind: door` has leaves on hinges".to_owned());
            self.report.error(
                &step(path, key),
                format!("`{key}` means nothing for this kind of opening"),
                hint,
            );
        }
        if let Some(swing) = opening.swing.filter(|swing| !(SWING.0..=SWING.1).contains(swing)) {
            let hint = Some(format!("{} to {} degrees", SWING.0, SWING.1));
            self.report.error(&step(path, "swing"), format!("a leaf cannot open {swing} degrees"), hint);
        }
    }

    fn column(&mut self, path: &[PathStep], column: &ColumnFile) {
        let shapes = [
            ("outline", column.outline.is_some()),
            ("rectangle", column.rectangle.is_some()),
            ("disc", column.disc.is_some()),
        ];
        self.one_shape(path, "the column", &shapes);
        if let Some(outline) = &column.outline {
            let shape = step(path, "outline");
            let misfit = self.points(&shape, outline);
            self.refuse(misfit.or_else(|| self.extent(&shape, "the column", outline, COLUMN_EXTENT)));
        }
        if let Some(rectangle) = column.rectangle {
            self.refuse(self.rectangle(&step(path, "rectangle"), "the column", rectangle, COLUMN_EXTENT));
        }
        if let Some(disc) = &column.disc {
            let path = step(path, "disc");
            self.refuse(self.points(&step(&path, "center"), &[disc.center]));
            self.length(&step(&path, "diameter"), "diameter", Some(disc.diameter), COLUMN_EXTENT);
        }
        self.length(&step(path, "height"), "height", column.height, OPENING_END);
    }

    fn one_shape(&mut self, path: &[PathStep], what: &str, shapes: &[(&str, bool)]) {
        let names: Vec<String> = shapes.iter().map(|(name, _)| format!("`{name}`")).collect();
        let given: Vec<&str> = shapes.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect();
        match given[..] {
            [] => self.report.error(
                path,
                format!("{what} has no shape"),
                Some(format!("write {}", names.join(" or "))),
            ),
            [_] => {}
            [_, second, ..] => {
                let hint = Some(format!("keep one of {}", names.join(" and ")));
                self.report.error(&step(path, second), format!("{what} has two shapes"), hint);
            }
        }
    }

    /// Reports what makes the file useless.
    fn refuse(&mut self, misfit: Option<Misfit>) {
        if let Some((path, message, hint)) = misfit {
            self.report.error(&path, message, hint);
        }
    }

    /// Reports what makes a room useless; the others are read.
    fn leave_out(&mut self, room: &[PathStep], misfit: Option<Misfit>) {
        if let Some((path, message, hint)) = misfit {
            self.report.lost(&path, message, hint);
            self.left_out.insert(room.to_vec());
        }
    }

    fn rectangle(
        &self,
        path: &[PathStep],
        what: &str,
        [x, y, width, depth]: [f64; 4],
        range: (f64, f64),
    ) -> Option<Misfit> {
        for (name, size) in [("width", width), ("depth", depth)] {
            if size.is_nan() || size <= 0.0 {
                let hint = Some("`rectangle` is [x, y, width, depth]".to_owned());
                return Some((path.to_vec(), format!("{what} has a {name} of {size}"), hint));
            }
        }
        let corners = [[x, y], [x + width, y + depth]];
        self.points(path, &corners).or_else(|| self.extent(path, what, &corners, range))
    }

    /// The first point that is not finite or far away.
    fn points(&self, path: &[PathStep], points: &[[f64; 2]]) -> Option<Misfit> {
        for (index, point) in points.iter().enumerate() {
            let is_near = point.iter().all(|value| self.units.to_metres(*value).abs() <= COORDINATE);
            if !is_near {
                let path = if points.len() > 1 { step(path, index) } else { path.to_vec() };
                let message = format!("[{}, {}] is farther than 100 km from the origin", point[0], point[1]);
                let hint =
                    Some("coordinates are lengths near the building's origin, not those of a map".to_owned());
                return Some((path, message, hint));
            }
        }
        None
    }

    /// A size that no room or column has.
    fn extent(
        &self,
        path: &[PathStep],
        what: &str,
        points: &[[f64; 2]],
        range: (f64, f64),
    ) -> Option<Misfit> {
        for (axis, name) in [(0, "wide"), (1, "deep")] {
            let values = points.iter().map(|point| point[axis]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let size = values.fold(f64::NEG_INFINITY, f64::max) - low;
            let metres = self.units.to_metres(size);
            if metres.is_finite() && !(range.0..=range.1).contains(&metres) && metres <= 2.0 * COORDINATE {
                // The difference of two written numbers: more digits than those are noise.
                let size = (size * 1e6).round() / 1e6;
                let message = format!("{what} is {size} {} {name}", self.units.word());
                return Some((path.to_vec(), message, self.unit_hint(size, range)));
            }
        }
        None
    }

    fn length(&mut self, path: &[PathStep], what: &str, value: Option<f64>, range: (f64, f64)) {
        let Some(value) = value else { return };
        if !(range.0..=range.1).contains(&self.units.to_metres(value)) {
            let message = format!("{what} of {value} {} is out of range", self.units.word());
            let bounds = format!("{} to {} m are possible", range.0, range.1);
            let unit = self.unit_hint(value, range);
            let hint = unit.map_or_else(|| bounds.clone(), |unit| format!("{bounds}; {unit}"));
            self.report.error(path, message, Some(hint));
        }
    }

    /// Names the unit that would make sense of a number.
    fn unit_hint(&self, value: f64, (low, high): (f64, f64)) -> Option<String> {
        // The likeliest size is about the middle of its range by magnitude, and not that of a hall.
        let usual = (low.max(LEAST_MAGNITUDE) * high).sqrt().min(USUAL_EXTENT);
        let misfit = |unit: &LengthUnit| (libm::log(unit.to_metres(value).abs()) - libm::log(usual)).abs();
        let is_imperial = |unit: &LengthUnit| matches!(unit, LengthUnit::Foot | LengthUnit::Inch);
        let fitting =
            LengthUnit::ALL.into_iter().filter(|unit| (low..=high).contains(&unit.to_metres(value)));
        // Half of all numbers would fit in feet or inches: they are named where nothing metric fits.
        let rank = |unit: &LengthUnit| (is_imperial(unit), misfit(unit));
        let unit =
            fitting.min_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(std::cmp::Ordering::Equal))?;
        Some(format!("wrong unit? `units: {}` would make it {} m", unit.word(), unit.to_metres(value)))
    }
}

/// Which edges there are.
pub(super) fn edge_hint(edge_count: usize) -> String {
    format!("its edges are 0 to {}; edge 0 runs from corner 0 to corner 1", edge_count.saturating_sub(1))
}
