//! B-spline curves and surfaces, rational ones too: their points by the basis functions of Piegl and Tiller, "The NURBS
//! Book", 2nd edition 1997, algorithms A2.1 and A2.2.

use glam::{DVec3, DVec4};

use super::curve::SAG;
use super::model::{Entity, Model, Read};
use super::placement::Geometry;
use super::profile::Rings;
use super::value::Value;

/// The highest degree that is read; modellers write 3, rarely more than 9.
const HIGHEST_DEGREE: usize = 15;
/// Times that a piece of a curve is halved at most where it lies off the true one.
const MOST_HALVINGS: u32 = 6;
/// Corners of one curve at most, and of a row of points of a surface.
const MOST_CORNERS: usize = 1024;
const MOST_ROW: usize = 48;
/// Bytes of looking that a point costs for each pair of degrees: amplified work counts as looked at.
const COST: usize = 8;

/// A knot vector with its degree: where each control point has its say.
struct Knots {
    degree: usize,
    values: Vec<f64>,
}

impl Knots {
    /// The knots of a curve or of one direction of a surface with so many control points.
    fn read(of: &Entity, degree: usize, [multiplicities, knots]: [usize; 2], count: usize) -> Read<Self> {
        let degree = of.number(degree)?;
        if !(1.0..=HIGHEST_DEGREE as f64).contains(&degree) || degree.fract() != 0.0 {
            return Err(of.trouble(format!("a spline of degree {degree}: 1 to {HIGHEST_DEGREE} are read")));
        }
        let degree = degree as usize;
        let wrong = || of.trouble("its knots do not fit its points");
        let knots = of.value(knots).items().iter().map(Value::number);
        let times = of.value(multiplicities).items().iter().map(Value::number);
        let mut values = Vec::new();
        for (knot, times) in knots.zip(times) {
            let (Some(knot), Some(times)) = (knot, times) else { return Err(wrong()) };
            let is_sound = (1.0..=(degree + 1) as f64).contains(&times)
                && values.last().is_none_or(|last| *last < knot)
                && values.len() <= count + degree;
            if !is_sound {
                return Err(wrong());
            }
            values.extend(std::iter::repeat_n(knot, times as usize));
        }
        let is_whole = count > degree && values.len() == count + degree + 1;
        if is_whole && values[degree] < values[count] { Ok(Self { degree, values }) } else { Err(wrong()) }
    }

    /// Where the spline begins and ends.
    fn ends(&self) -> (f64, f64) {
        (self.values[self.degree], self.values[self.values.len() - 1 - self.degree])
    }

    /// The distinct knots between two parameters, with both.
    fn breaks(&self, (from, to): (f64, f64)) -> Vec<f64> {
        let within = self.values.iter().copied().filter(|knot| *knot > from && *knot < to);
        let mut breaks: Vec<f64> = std::iter::once(from).chain(within).chain([to]).collect();
        breaks.dedup();
        breaks
    }

    /// The first control point that has a say at a parameter, and the weights of it and of those behind it.
    fn weights(&self, at: f64) -> (usize, Vec<f64>) {
        let (from, to) = self.ends();
        let at = at.clamp(from, to);
        let last = self.values.len() - self.degree - 2;
        let span = self.values.partition_point(|knot| *knot <= at).saturating_sub(1);
        let span = span.clamp(self.degree, last);
        let mut weights = vec![1.0];
        for order in 1..=self.degree {
            let mut next = vec![0.0; order + 1];
            for (index, weight) in weights.iter().enumerate() {
                let (left, right) = (self.values[span + 1 + index - order], self.values[span + 1 + index]);
                let share = if right > left { (at - left) / (right - left) } else { 0.0 };
                next[index] += weight * (1.0 - share);
                next[index + 1] += weight * share;
            }
            weights = next;
        }
        (span - self.degree, weights)
    }
}

/// A B-spline curve; its control points with their weights, multiplied by them.
pub(super) struct Spline {
    knots: Knots,
    points: Vec<DVec4>,
}

impl Spline {
    fn at(&self, parameter: f64) -> DVec3 {
        let (first, weights) = self.knots.weights(parameter);
        let sum: DVec4 =
            weights.iter().zip(&self.points[first..]).map(|(weight, point)| *point * *weight).sum();
        sum.truncate() / sum.w
    }

    /// Corners from one parameter to another, the smaller first; outside of the spline is its end.
    pub(super) fn corners(&self, model: &Model, span: Option<(f64, f64)>) -> Vec<DVec3> {
        let (from, to) = self.knots.ends();
        let (from, to) = span.map_or((from, to), |(a, b)| (a.clamp(from, to), b.clamp(from, to)));
        let mut corners = vec![self.at(from)];
        for ends in self.knots.breaks((from, to)).windows(2) {
            // Halves alone miss a bend that is the same on both sides.
            let pieces = self.knots.degree + 1;
            for piece in 0..pieces {
                let at = |piece: usize| ends[0] + (ends[1] - ends[0]) * piece as f64 / pieces as f64;
                self.halve(model, (at(piece), at(piece + 1)), MOST_HALVINGS, &mut corners);
            }
        }
        corners
    }

    /// Adds the corners behind the first of a piece.
    fn halve(&self, model: &Model, (from, to): (f64, f64), halvings: u32, corners: &mut Vec<DVec3>) {
        if corners.len() >= MOST_CORNERS || !model.charge(COST * self.knots.degree * self.knots.degree) {
            return;
        }
        let start = corners[corners.len() - 1];
        let (middle, end) = (self.at(from.midpoint(to)), self.at(to));
        if halvings > 0 && middle.distance(start.midpoint(end)) > SAG {
            self.halve(model, (from, from.midpoint(to)), halvings - 1, corners);
            self.halve(model, (from.midpoint(to), to), halvings - 1, corners);
        } else {
            corners.push(end);
        }
    }
}

impl Geometry<'_> {
    /// A B-spline curve with knots.
    pub(super) fn spline(&self, curve: &Entity) -> Read<Spline> {
        let points = curve.references(1)?;
        let knots = Knots::read(curve, 0, [5, 6], points.len())?;
        let points = self.control_points(curve, &points, curve.value(8).items())?;
        Ok(Spline { knots, points })
    }

    fn control_points(&self, of: &Entity, points: &[u64], weights: &[Value]) -> Read<Vec<DVec4>> {
        let weighted = points.iter().enumerate().map(|(index, point)| {
            let weight = match weights {
                [] => 1.0,
                _ => weights.get(index).and_then(Value::number).unwrap_or(0.0),
            };
            if weight <= 0.0 {
                return Err(of.trouble("a point has no weight above zero"));
            }
            Ok((self.point(*point)? * weight).extend(weight))
        });
        weighted.collect()
    }

    /// Small faces that follow a B-spline surface over all its knots, which modellers cut to the face.
    pub(super) fn spline_faces(&self, surface: &Entity) -> Read<Vec<Rings>> {
        let rows = surface.value(2).items();
        let first = rows.first().map_or(0, |row| row.items().len());
        if rows.iter().any(|row| row.items().len() != first) {
            return Err(surface.trouble("its rows of points differ in length"));
        }
        let u = Knots::read(surface, 0, [7, 9], rows.len())?;
        let v = Knots::read(surface, 1, [8, 10], first)?;
        let mut points = Vec::new();
        for (index, row) in rows.iter().enumerate() {
            let ids: Option<Vec<u64>> = row.items().iter().map(Value::reference).collect();
            let ids = ids.ok_or_else(|| surface.trouble("a control point is no reference"))?;
            let weights = surface.value(12).items().get(index).map(Value::items).unwrap_or_default();
            points.push(self.control_points(surface, &ids, weights)?);
        }
        let (rows, columns) = (places(&u), places(&v));
        let cost = COST * rows.len() * columns.len() * (u.degree + 1) * (v.degree + 1);
        if !self.model.charge(cost) {
            return Err(surface.trouble("the file has too many curved faces"));
        }
        let at = |u_weights: &(usize, Vec<f64>), v_weights: &(usize, Vec<f64>)| {
            let of_row = |row: &[DVec4]| -> DVec4 {
                v_weights.1.iter().zip(&row[v_weights.0..]).map(|(weight, point)| *point * *weight).sum()
            };
            let sum: DVec4 = u_weights
                .1
                .iter()
                .zip(&points[u_weights.0..])
                .map(|(weight, row)| of_row(row) * *weight)
                .sum();
            sum.truncate() / sum.w
        };
        let columns: Vec<(usize, Vec<f64>)> = columns.iter().map(|at| v.weights(*at)).collect();
        let net: Vec<Vec<DVec3>> = rows
            .iter()
            .map(|row| u.weights(*row))
            .map(|row| columns.iter().map(|column| at(&row, column)).collect())
            .collect();
        Ok(quads(&net))
    }
}

/// Parameters at which a surface is looked at: its knots, and some between.
fn places(knots: &Knots) -> Vec<f64> {
    let breaks = knots.breaks(knots.ends());
    let pieces = (2 * knots.degree).min(MOST_ROW / (breaks.len() - 1).max(1)).max(1);
    let step = breaks.len().div_ceil(MOST_ROW).max(1);
    let mut places = Vec::new();
    for ends in breaks.windows(2).step_by(step) {
        let between = (0..pieces).map(|piece| ends[0] + (ends[1] - ends[0]) * piece as f64 / pieces as f64);
        places.extend(between);
    }
    places.extend(breaks.last());
    places
}

/// The meshes of a net, row by row.
pub(super) fn quads(net: &[Vec<DVec3>]) -> Vec<Rings> {
    let mesh = |pair: &[Vec<DVec3>]| -> Vec<Rings> {
        let (one, other) = (&pair[0], &pair[1]);
        let sides = one.windows(2).zip(other.windows(2));
        sides
            .map(|(near, far)| Rings { outer: vec![near[0], near[1], far[1], far[0]], holes: Vec::new() })
            .collect()
    };
    net.windows(2).flat_map(mesh).collect()
}
