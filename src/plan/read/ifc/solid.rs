//! Items of a shape: swept profiles, boxes and faces, with what they stand on.

use glam::{DAffine3, DVec3};

use super::curve::{DEEPEST, nth};
use super::model::{Entity, Read};
use super::placement::Geometry;
use super::profile::Rings;
use super::value::Value;

/// Faces of one item; more are no room, and nobody waits for their outline.
const MOST_FACES: usize = 50_000;

/// An item of a shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Body {
    /// One end of a swept profile, and the way to the other end; zero for a bare outline.
    Swept(Rings, DVec3),
    /// Flat faces.
    Faces(Vec<Rings>),
}

impl Body {
    /// The same elsewhere.
    pub(super) fn moved(&self, by: &DAffine3) -> Self {
        match self {
            Self::Swept(rings, sweep) => Self::Swept(rings.moved(by), by.transform_vector3(*sweep)),
            Self::Faces(faces) => Self::Faces(faces.iter().map(|face| face.moved(by)).collect()),
        }
    }

    /// All corners.
    pub(super) fn corners(&self) -> Vec<DVec3> {
        match self {
            Self::Swept(rings, sweep) => {
                rings.corners().flat_map(|corner| [corner, corner + *sweep]).collect()
            }
            Self::Faces(faces) => faces.iter().flat_map(Rings::corners).collect(),
        }
    }
}

impl Geometry<'_> {
    /// The bodies of an item, in the coordinates of its product.
    pub(super) fn item(&self, id: u64, depth: usize) -> Read<Vec<Body>> {
        let item = self.model.get(id)?;
        if depth > DEEPEST {
            return Err(item.trouble("shapes are nested too deep"));
        }
        match item.kind.as_str() {
            "IFCEXTRUDEDAREASOLID" | "IFCEXTRUDEDAREASOLIDTAPERED" => self.extruded(&item, depth),
            // What is cut off is at the ceiling, mostly; the floor is that of the first operand.
            "IFCBOOLEANCLIPPINGRESULT" | "IFCBOOLEANRESULT" => self.item(item.reference(1)?, depth + 1),
            "IFCCSGSOLID" => self.item(item.reference(0)?, depth + 1),
            "IFCMAPPEDITEM" => self.mapped(&item, depth),
            "IFCBOUNDINGBOX" => {
                let corner = DAffine3::from_translation(self.point(item.reference(0)?)?);
                self.block(&item, &corner)
            }
            "IFCBLOCK" => self.block(&item, &self.axes(item.value(0))?),
            "IFCFACETEDBREP" | "IFCFACETEDBREPWITHVOIDS" => self.shells(&[item.reference(0)?]),
            "IFCFACEBASEDSURFACEMODEL" | "IFCSHELLBASEDSURFACEMODEL" => self.shells(&item.references(0)?),
            "IFCPOLYGONALFACESET" | "IFCTRIANGULATEDFACESET" => self.face_set(&item),
            "IFCGEOMETRICSET" | "IFCGEOMETRICCURVESET" => {
                let curves = item.references(0)?;
                curves.into_iter().map(|curve| self.flat(curve, Vec::new(), depth)).collect()
            }
            "IFCANNOTATIONFILLAREA" => {
                let holes = item.references(1).unwrap_or_default();
                Ok(vec![self.flat(item.reference(0)?, holes, depth)?])
            }
            "IFCADVANCEDBREP" | "IFCADVANCEDBREPWITHVOIDS" => {
                Err(item.trouble("shapes with curved faces are not read"))
            }
            _ => Ok(vec![self.flat(id, Vec::new(), depth)?]),
        }
    }

    fn flat(&self, outline: u64, holes: Vec<u64>, depth: usize) -> Read<Body> {
        let outer = self.curve(outline, depth + 1)?;
        let holes = holes.into_iter().map(|hole| self.curve(hole, depth + 1)).collect::<Read<_>>()?;
        Ok(Body::Swept(Rings { outer, holes }, DVec3::ZERO))
    }

    fn extruded(&self, item: &Entity, depth: usize) -> Read<Vec<Body>> {
        let rings = self.profile(item.reference(0)?, depth + 1)?;
        let frame = self.axes(item.value(1))?;
        let direction = self.direction(item.value(2))?.unwrap_or(DVec3::Z);
        let sweep = direction * (item.positive(3)? * self.units.length);
        Ok(vec![Body::Swept(rings, sweep).moved(&frame)])
    }

    fn mapped(&self, item: &Entity, depth: usize) -> Read<Vec<Body>> {
        let map = self.model.get(item.reference(0)?)?;
        let target = self.operator(item.reference(1)?)?;
        let by = target * self.axes(map.value(0))?.inverse();
        let shape = self.model.get(map.reference(1)?)?;
        let mut bodies = Vec::new();
        for inner in shape.references(3)? {
            bodies.extend(self.item(inner, depth + 1)?.iter().map(|body| body.moved(&by)));
        }
        Ok(bodies)
    }

    fn block(&self, item: &Entity, frame: &DAffine3) -> Read<Vec<Body>> {
        let length = |place: usize| Ok(item.positive(place)? * self.units.length);
        let (x, y, z) = (length(1)?, length(2)?, length(3)?);
        let corners = [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)];
        let outer = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
        Ok(vec![Body::Swept(Rings { outer, holes: Vec::new() }, DVec3::Z * z).moved(frame)])
    }

    fn shells(&self, shells: &[u64]) -> Read<Vec<Body>> {
        let mut faces = Vec::new();
        for shell in shells {
            let shell = self.model.get(*shell)?;
            for face in shell.references(0)? {
                if faces.len() >= MOST_FACES {
                    return Err(shell.trouble(format!("more than {MOST_FACES} faces")));
                }
                faces.push(self.face(face)?);
            }
        }
        Ok(vec![Body::Faces(faces)])
    }

    /// A face with its bounds; the outer one is said to be, or the longest.
    fn face(&self, id: u64) -> Read<Rings> {
        let face = self.model.get(id)?;
        let mut rings = Rings::default();
        let mut longest = -1.0;
        for bound in face.references(0)? {
            let bound = self.model.get(bound)?;
            let edge = self.curve(bound.reference(0)?, 0)?;
            let length = if bound.kind == "IFCFACEOUTERBOUND" { f64::INFINITY } else { girth(&edge) };
            if length > longest {
                longest = length;
                let former = std::mem::replace(&mut rings.outer, edge);
                rings.holes.extend(Some(former).filter(|ring| !ring.is_empty()));
            } else {
                rings.holes.push(edge);
            }
        }
        Ok(rings)
    }

    /// Faces that name the points of one list.
    fn face_set(&self, item: &Entity) -> Read<Vec<Body>> {
        let points = self.point_list(item.reference(0)?)?;
        let is_polygons = item.kind == "IFCPOLYGONALFACESET";
        let (place, renumbering) = if is_polygons { (2, 3) } else { (3, 4) };
        let listed = item.value(place).items();
        if listed.len() > MOST_FACES {
            return Err(item.trouble(format!("more than {MOST_FACES} faces")));
        }
        let renumbered = item.value(renumbering).items();
        let corner = |number: &Value| match renumbered {
            [] => nth(&points, number),
            _ => {
                let place = number.number().filter(|number| *number >= 1.0)? as usize - 1;
                nth(&points, renumbered.get(place)?)
            }
        };
        let ring = |numbers: &Value| -> Read<Vec<DVec3>> {
            let corners: Option<Vec<DVec3>> = numbers.items().iter().map(corner).collect();
            corners.ok_or_else(|| item.trouble("a face names points that are not there"))
        };
        let mut faces = Vec::with_capacity(listed.len());
        for face in listed {
            let Some(id) = face.reference() else {
                faces.push(Rings { outer: ring(face)?, holes: Vec::new() });
                continue;
            };
            let face = self.model.get(id)?;
            let holes = face.value(1).items().iter().map(&ring).collect::<Read<_>>()?;
            faces.push(Rings { outer: ring(face.value(0))?, holes });
        }
        Ok(vec![Body::Faces(faces)])
    }
}

fn girth(ring: &[DVec3]) -> f64 {
    ring.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}
