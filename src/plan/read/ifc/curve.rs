//! Turns curves into corners: lines stay, arcs and splines are flattened.

use std::f64::consts::{PI, TAU};

use glam::{DAffine3, DVec3};

use super::model::{Entity, Read};
use super::placement::Geometry;
use super::value::Value;

/// Metres that a flattened arc or spline may lie off the true one.
pub(super) const SAG: f64 = 0.005;
/// Radians of the longest and the shortest piece of an arc.
const STEPS: (f64, f64) = (PI / 8.0, PI / 48.0);
/// Radians between the ends of a whole turn.
const SAME_ANGLE: f64 = 1e-9;
/// Curves in curves.
pub(super) const DEEPEST: usize = 16;

/// A circle or an ellipse: its own axes, and metres along them.
pub(super) struct Conic {
    pub(super) frame: DAffine3,
    pub(super) radii: (f64, f64),
}

impl Conic {
    fn at(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.frame.transform_point3(DVec3::new(self.radii.0 * cosine, self.radii.1 * sine, 0.0))
    }

    pub(super) fn angle_of(&self, point: DVec3) -> f64 {
        let own = self.frame.inverse().transform_point3(point);
        libm::atan2(own.y / self.radii.1, own.x / self.radii.0)
    }

    /// Corners around an axis at the origin of a plane.
    pub(super) fn around(&self) -> Vec<DVec3> {
        self.arc(0.0, TAU)
    }

    /// Corners from one angle to another; the same angle makes a whole turn.
    pub(super) fn arc_between(&self, from: f64, to: f64, is_forward: bool) -> Vec<DVec3> {
        let turn = |angle: f64| {
            let rest = angle.rem_euclid(TAU);
            if rest < SAME_ANGLE || TAU - rest < SAME_ANGLE { TAU } else { rest }
        };
        self.arc(from, if is_forward { turn(to - from) } else { -turn(from - to) })
    }

    /// Corners from an angle on, both ends included.
    fn arc(&self, from: f64, sweep: f64) -> Vec<DVec3> {
        let count = pieces(self.radii.0.max(self.radii.1), sweep);
        (0..=count).map(|index| self.at(from + sweep * f64::from(index) / f64::from(count))).collect()
    }
}

/// Straight pieces of an arc of some radius in metres and sweep in radians.
pub(super) fn pieces(radius: f64, sweep: f64) -> u32 {
    let step = (2.0 * libm::acos(1.0 - SAG / radius.max(SAG))).clamp(STEPS.1, STEPS.0);
    (sweep.abs() / step).ceil().clamp(1.0, TAU / STEPS.1) as u32
}

impl Geometry<'_> {
    /// The corners of a curve, in its own coordinates; closed ones may repeat their first.
    pub(super) fn curve(&self, id: u64, depth: usize) -> Read<Vec<DVec3>> {
        let curve = self.model.get(id)?;
        if depth > DEEPEST {
            return Err(curve.trouble("curves are nested too deep"));
        }
        match curve.kind.as_str() {
            "IFCPOLYLINE" | "IFCPOLYLOOP" => {
                curve.references(0)?.into_iter().map(|point| self.point(point)).collect()
            }
            "IFCCOMPOSITECURVE" | "IFC2DCOMPOSITECURVE" | "IFCOUTERBOUNDARYCURVE" => {
                let mut corners = Vec::new();
                for segment in curve.references(0)? {
                    corners.extend(self.segment(segment, depth + 1)?);
                }
                Ok(corners)
            }
            "IFCTRIMMEDCURVE" => self.trimmed(&curve),
            "IFCCIRCLE" | "IFCELLIPSE" => Ok(self.conic(&curve)?.around()),
            "IFCINDEXEDPOLYCURVE" => self.indexed(&curve),
            "IFCBSPLINECURVEWITHKNOTS" | "IFCRATIONALBSPLINECURVEWITHKNOTS" => {
                Ok(self.spline(&curve)?.corners(self.model, None))
            }
            "IFCSURFACECURVE" | "IFCSEAMCURVE" | "IFCINTERSECTIONCURVE" => {
                self.curve(curve.reference(0)?, depth + 1)
            }
            "IFCEDGELOOP" => self.edge_loop(&curve, depth),
            "IFCVERTEXLOOP" => Ok(vec![self.vertex(curve.reference(0)?)?]),
            _ => Err(curve.trouble("curves of this kind are not read")),
        }
    }

    fn segment(&self, id: u64, depth: usize) -> Read<Vec<DVec3>> {
        let segment = self.model.get(id)?;
        let mut corners = self.curve(segment.reference(2)?, depth)?;
        if segment.value(1).word() == Some("F") {
            corners.reverse();
        }
        Ok(corners)
    }

    pub(super) fn conic(&self, curve: &Entity) -> Read<Conic> {
        let frame = self.axes(curve.value(0))?;
        let first = curve.positive(1)? * self.units.length;
        let second = if curve.kind == "IFCELLIPSE" { curve.positive(2)? * self.units.length } else { first };
        Ok(Conic { frame, radii: (first, second) })
    }

    fn trimmed(&self, curve: &Entity) -> Read<Vec<DVec3>> {
        let basis = self.model.get(curve.reference(0)?)?;
        let is_forward = curve.value(3).word() != Some("F");
        if basis.kind == "IFCLINE" {
            let ends = [1, 2].map(|end| self.on_line(curve, &basis, end));
            let [from, to] = ends;
            return Ok(vec![from?, to?]);
        }
        if basis.is(&["IFCBSPLINECURVEWITHKNOTS", "IFCRATIONALBSPLINECURVEWITHKNOTS"]) {
            return self.trimmed_spline(curve, &basis, is_forward);
        }
        if !basis.is(&["IFCCIRCLE", "IFCELLIPSE"]) {
            return Err(basis.trouble("curves of this kind are not read"));
        }
        let conic = self.conic(&basis)?;
        let from = self.on_conic(curve, &conic, 1)?;
        let to = self.on_conic(curve, &conic, 2)?;
        Ok(conic.arc_between(from, to, is_forward))
    }

    /// A spline between two parameters; its ends are hardly ever given as points.
    fn trimmed_spline(&self, curve: &Entity, basis: &Entity, is_forward: bool) -> Read<Vec<DVec3>> {
        let ends = [1, 2].map(|end| self.trim(curve, end).1);
        let [Some(from), Some(to)] = ends else {
            return Err(curve.trouble("a spline that is cut at points is not read"));
        };
        let mut corners = self.spline(basis)?.corners(self.model, Some((from.min(to), from.max(to))));
        if from > to || !is_forward {
            corners.reverse();
        }
        Ok(corners)
    }

    /// An end of a trimmed curve as a point or as a parameter.
    fn trim(&self, curve: &Entity, end: usize) -> (Option<u64>, Option<f64>) {
        let trims = curve.value(end).items();
        (trims.iter().find_map(Value::reference), trims.iter().find_map(Value::number))
    }

    fn on_line(&self, curve: &Entity, line: &Entity, end: usize) -> Read<DVec3> {
        let (point, parameter) = self.trim(curve, end);
        if let Some(point) = point {
            return self.point(point);
        }
        let parameter = parameter.ok_or_else(|| curve.trouble("an end without a place"))?;
        let vector = self.model.get(line.reference(1)?)?;
        let direction = self.direction(vector.value(0))?.unwrap_or(DVec3::X);
        let start = self.point(line.reference(0)?)?;
        Ok(start + direction * (vector.number(1)? * self.units.length * parameter))
    }

    fn on_conic(&self, curve: &Entity, conic: &Conic, end: usize) -> Read<f64> {
        let (point, parameter) = self.trim(curve, end);
        let by_point = curve.value(4).word() != Some("PARAMETER") || parameter.is_none();
        match (point, parameter) {
            (Some(point), _) if by_point => Ok(conic.angle_of(self.point(point)?)),
            (_, Some(parameter)) => Ok(parameter * self.units.angle),
            _ => Err(curve.trouble("an end without a place")),
        }
    }

    /// Points in one list, and segments that name them by their number from 1.
    fn indexed(&self, curve: &Entity) -> Read<Vec<DVec3>> {
        let points = self.point_list(curve.reference(0)?)?;
        let segments = curve.value(1).items();
        if segments.is_empty() {
            return Ok(points);
        }
        let mut corners = Vec::new();
        for segment in segments {
            let Value::Typed(kind, inner) = segment else {
                return Err(curve.trouble("a segment is no line and no arc"));
            };
            let numbers = inner.first().map(Value::items).unwrap_or_default();
            let chosen: Option<Vec<DVec3>> = numbers.iter().map(|number| nth(&points, number)).collect();
            match (kind.as_str(), chosen.as_deref()) {
                ("IFCLINEINDEX", Some(chosen)) => corners.extend(chosen),
                ("IFCARCINDEX", Some([from, over, to])) => corners.extend(arc_through(*from, *over, *to)),
                _ => return Err(curve.trouble("a segment names points that are not there")),
            }
        }
        Ok(corners)
    }

    /// The points of an `IfcCartesianPointList`.
    pub(super) fn point_list(&self, id: u64) -> Read<Vec<DVec3>> {
        let list = self.model.get(id)?;
        list.value(0).items().iter().map(|point| self.coordinates(&list, point)).collect()
    }
}

/// The point of a number from 1.
pub(super) fn nth(points: &[DVec3], number: &Value) -> Option<DVec3> {
    let number = number.number().filter(|number| *number >= 1.0)?;
    points.get(number as usize - 1).copied()
}

/// The arc through three points; straight where they lie on a line.
fn arc_through(from: DVec3, over: DVec3, to: DVec3) -> Vec<DVec3> {
    let (a, b) = (over - from, to - from);
    let normal = a.cross(b);
    let Some(axis) = normal.try_normalize().filter(|_| normal.length() > 1e-9) else { return vec![from, to] };
    let to_center = normal.cross(a) * b.length_squared() + b.cross(normal) * a.length_squared();
    let center = from + to_center / (2.0 * normal.length_squared());
    let x = (from - center).normalize_or_zero();
    let frame = DAffine3::from_cols(x, axis.cross(x), axis, center);
    let radius = from.distance(center);
    let conic = Conic { frame, radii: (radius, radius) };
    if !radius.is_finite() || radius <= 0.0 {
        return vec![from, over, to];
    }
    // The axis is that of the turn from the first over the second to the third.
    conic.arc(0.0, conic.angle_of(to).rem_euclid(TAU))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_goes_through_its_three_points() {
        let (from, to) = (DVec3::new(1.0, 0.0, 0.0), DVec3::new(-1.0, 0.0, 0.0));
        for over in [DVec3::Y, -DVec3::Y, DVec3::new(0.6, 0.8, 0.0)] {
            let arc = arc_through(from, over, to);
            assert!(arc[0].distance(from) < 1e-9 && arc[arc.len() - 1].distance(to) < 1e-9);
            assert!(arc.iter().all(|corner| (corner.length() - 1.0).abs() < 1e-9));
            assert!(arc[arc.len() / 2].dot(over) > 0.5, "{over}");
        }
        assert_eq!(arc_through(from, DVec3::ZERO, to).len(), 2);
    }

    #[test]
    fn arcs_are_flattened_within_the_sag() {
        for radius in [0.1, 1.0, 30.0] {
            let conic = Conic { frame: DAffine3::IDENTITY, radii: (radius, radius) };
            let arc = conic.arc(0.0, TAU);
            let least = arc.windows(2).map(|pair| pair[0].midpoint(pair[1]).length()).fold(radius, f64::min);
            assert!(radius - least < SAG.max(radius * 0.0022), "{radius}: {}", radius - least);
        }
    }
}
