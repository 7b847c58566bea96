//! Reads loops of edges, as faces with curved sides have them.

use glam::DVec3;

use super::curve::DEEPEST;
use super::model::{Entity, Read};
use super::placement::Geometry;

impl Geometry<'_> {
    /// The corners of an `IfcEdgeLoop`, each edge with both ends.
    pub(super) fn edge_loop(&self, of: &Entity, depth: usize) -> Read<Vec<DVec3>> {
        let mut corners = Vec::new();
        for edge in of.references(0)? {
            corners.extend(self.edge(edge, depth + 1)?);
        }
        Ok(corners)
    }

    /// The point of an `IfcVertexPoint`.
    pub(super) fn vertex(&self, id: u64) -> Read<DVec3> {
        self.point(self.model.get(id)?.reference(0)?)
    }

    fn edge(&self, id: u64, depth: usize) -> Read<Vec<DVec3>> {
        let edge = self.model.get(id)?;
        if depth > DEEPEST {
            return Err(edge.trouble("edges are nested too deep"));
        }
        match edge.kind.as_str() {
            "IFCORIENTEDEDGE" => {
                let mut corners = self.edge(edge.reference(2)?, depth + 1)?;
                if edge.value(3).word() == Some("F") {
                    corners.reverse();
                }
                Ok(corners)
            }
            "IFCEDGE" | "IFCSUBEDGE" => {
                Ok(vec![self.vertex(edge.reference(0)?)?, self.vertex(edge.reference(1)?)?])
            }
            "IFCEDGECURVE" => self.edge_curve(&edge, depth),
            _ => Err(edge.trouble("edges of this kind are not read")),
        }
    }

    /// The part of a curve between two vertices, from the first to the second.
    fn edge_curve(&self, edge: &Entity, depth: usize) -> Read<Vec<DVec3>> {
        let (start, end) = (self.vertex(edge.reference(0)?)?, self.vertex(edge.reference(1)?)?);
        let is_forward = edge.value(3).word() != Some("F");
        let (from, to) = if is_forward { (start, end) } else { (end, start) };
        let mut corners = self.between(edge.reference(2)?, from, to, depth + 1)?;
        if !is_forward {
            corners.reverse();
        }
        Ok(corners)
    }

    /// The part of a curve from one of its points to another, in the curve's own direction.
    fn between(&self, id: u64, from: DVec3, to: DVec3, depth: usize) -> Read<Vec<DVec3>> {
        let curve = self.model.get(id)?;
        if depth > DEEPEST {
            return Err(curve.trouble("curves are nested too deep"));
        }
        match curve.kind.as_str() {
            "IFCLINE" => Ok(vec![from, to]),
            "IFCCIRCLE" | "IFCELLIPSE" => {
                let conic = self.conic(&curve)?;
                Ok(conic.arc_between(conic.angle_of(from), conic.angle_of(to), true))
            }
            "IFCSURFACECURVE" | "IFCSEAMCURVE" | "IFCINTERSECTIONCURVE" => {
                self.between(curve.reference(0)?, from, to, depth + 1)
            }
            _ => Ok(cut(self.curve(id, depth + 1)?, from, to)),
        }
    }
}

/// The corners from the one nearest to a point up to the one nearest to another, around the end where the curve is closed.
fn cut(corners: Vec<DVec3>, from: DVec3, to: DVec3) -> Vec<DVec3> {
    let nearest = |place: DVec3, is_last: bool| {
        let by_distance = |a: &(usize, &DVec3), b: &(usize, &DVec3)| {
            a.1.distance_squared(place).total_cmp(&b.1.distance_squared(place))
        };
        let all = corners.iter().enumerate();
        // The ends of a closed curve are at one place.
        let found = if is_last { all.rev().min_by(by_distance) } else { all.min_by(by_distance) };
        found.map_or(0, |(index, _)| index)
    };
    let (first, last) = (nearest(from, false), nearest(to, true));
    let mut part: Vec<DVec3> = if first < last {
        corners[first..=last].to_vec()
    } else {
        corners[first..].iter().chain(&corners[..=last.min(first)]).copied().collect()
    };
    if let [start, .., end] = &mut part[..] {
        (*start, *end) = (from, to);
    }
    part
}
