//! Reads the items of a shape: swept profiles, boxes and faces, curved ones by their edges.

use glam::{DAffine3, DVec3};

use super::curve::{DEEPEST, nth};
use super::model::{Entity, Read};
use super::placement::Geometry;
use super::profile::Rings;
use super::value::Value;

/// Faces of one item; rooms do not have more, and their outline would take too long.
pub(super) const MOST_FACES: usize = 50_000;

/// Surfaces that bulge between the edges of a face.
const SPLINES: [&str; 2] = ["IFCBSPLINESURFACEWITHKNOTS", "IFCRATIONALBSPLINESURFACEWITHKNOTS"];

/// An item of a shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum IfcBody {
    /// One end of a swept profile, and the way to the other end; zero for a bare outline.
    Swept(Rings, DVec3),
    /// Flat faces.
    Faces(Vec<Rings>),
}

impl IfcBody {
    /// The same elsewhere.
    pub(super) fn moved(&self, by: &DAffine3) -> Self {
        match self {
            Self::Swept(rings, sweep) => Self::Swept(rings.moved(by), by.transform_vector3(*sweep)),
            Self::Faces(faces) => Self::Faces(faces.iter().map(|face| face.moved(by)).collect()),
        }
    }

    /// Its faces; of a swept profile the one at its beginning.
    pub(super) fn into_faces(self) -> Vec<Rings> {
        match self {
            Self::Swept(rings, _) => vec![rings],
            Self::Faces(faces) => faces,
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
    pub(super) fn item(&self, id: u64, depth: usize) -> Read<Vec<IfcBody>> {
        let item = self.model.get(id)?;
        if depth > DEEPEST {
            return Err(item.trouble("shapes are nested too deep"));
        }
        match item.kind.as_str() {
            "IFCEXTRUDEDAREASOLID" | "IFCEXTRUDEDAREASOLIDTAPERED" => self.extruded(&item, depth),
            // Cuts are mostly at the ceiling; the floor is that of the first operand.
            "IFCBOOLEANCLIPPINGRESULT" | "IFCBOOLEANRESULT" => self.item(item.reference(1)?, depth + 1),
            "IFCCSGSOLID" => self.item(item.reference(0)?, depth + 1),
            "IFCMAPPEDITEM" => self.mapped(&item, depth),
            "IFCBOUNDINGBOX" => {
                let corner = DAffine3::from_translation(self.point(item.reference(0)?)?);
                self.block(&item, &corner)
            }
            "IFCBLOCK" => self.block(&item, &self.axes(item.value(0))?),
            "IFCFACETEDBREP" | "IFCFACETEDBREPWITHVOIDS" | "IFCADVANCEDBREP" | "IFCADVANCEDBREPWITHVOIDS" => {
                self.shells(&[item.reference(0)?])
            }
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
            "IFCREVOLVEDAREASOLID" | "IFCREVOLVEDAREASOLIDTAPERED" => self.revolved(&item, depth),
            "IFCSWEPTDISKSOLID" | "IFCSWEPTDISKSOLIDPOLYGONAL" => self.tube(&item, depth),
            "IFCRIGHTCIRCULARCYLINDER" | "IFCRIGHTCIRCULARCONE" | "IFCSPHERE" => self.primitive(&item),
            _ => Ok(vec![self.flat(id, Vec::new(), depth)?]),
        }
    }

    fn flat(&self, outline: u64, holes: Vec<u64>, depth: usize) -> Read<IfcBody> {
        let outer = self.curve(outline, depth + 1)?;
        let holes = holes.into_iter().map(|hole| self.curve(hole, depth + 1)).collect::<Read<_>>()?;
        Ok(IfcBody::Swept(Rings { outer, holes }, DVec3::ZERO))
    }

    fn extruded(&self, item: &Entity, depth: usize) -> Read<Vec<IfcBody>> {
        let rings = self.profile(item.reference(0)?, depth + 1)?;
        let frame = self.axes(item.value(1))?;
        let direction = self.direction(item.value(2))?.unwrap_or(DVec3::Z);
        let sweep = direction * (item.positive(3)? * self.units.length);
        Ok(vec![IfcBody::Swept(rings, sweep).moved(&frame)])
    }

    fn mapped(&self, item: &Entity, depth: usize) -> Read<Vec<IfcBody>> {
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

    fn block(&self, item: &Entity, frame: &DAffine3) -> Read<Vec<IfcBody>> {
        let length = |place: usize| Ok(item.positive(place)? * self.units.length);
        let (x, y, z) = (length(1)?, length(2)?, length(3)?);
        let corners = [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)];
        let outer = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
        Ok(vec![IfcBody::Swept(Rings { outer, holes: Vec::new() }, DVec3::Z * z).moved(frame)])
    }

    /// The faces of shells, each with its edges; B-spline faces also with small ones that follow them.
    pub(super) fn shells(&self, shells: &[u64]) -> Read<Vec<IfcBody>> {
        let mut faces = Vec::new();
        for shell in shells {
            let shell = self.model.get(*shell)?;
            for face in shell.references(0)? {
                if faces.len() >= MOST_FACES {
                    return Err(shell.trouble(format!("more than {MOST_FACES} faces")));
                }
                faces.extend(self.faces(face)?);
            }
        }
        Ok(vec![IfcBody::Faces(faces)])
    }

    /// A face, and what follows its surface where that bulges: the edges of a dome say nothing of its top.
    pub(super) fn faces(&self, id: u64) -> Read<Vec<Rings>> {
        let face = self.model.get(id)?;
        let mut faces = vec![self.bounds(&face)?];
        let surface = face.value(1).reference().map(|surface| self.model.get(surface)).transpose()?;
        if let Some(surface) = surface.filter(|surface| surface.is(&SPLINES)) {
            faces.extend(self.spline_faces(&surface)?);
        }
        Ok(faces)
    }

    /// The bounds of a face; the outer one is said to be, or the longest.
    fn bounds(&self, face: &Entity) -> Read<Rings> {
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
    fn face_set(&self, item: &Entity) -> Read<Vec<IfcBody>> {
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
        Ok(vec![IfcBody::Faces(faces)])
    }
}

fn girth(ring: &[DVec3]) -> f64 {
    ring.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

#[cfg(test)]
pub(super) mod tests {
    use std::path::Path;

    use super::super::footprint::footprints;
    use super::super::model::Model;
    use super::*;
    use crate::document::Source;
    use crate::geometry::Polygon;

    /// The points of a box of 4 by 3 by 2.5 m, in one list.
    const POINTS: &str =
        "#1=IFCCARTESIANPOINTLIST3D(((0.,0.,0.),(4.,0.,0.),(4.,3.,0.),(0.,3.,0.),(0.,0.,2.5)));\n";

    fn model(data: &str) -> Model {
        Model::new(Source::new(Path::new("shape.ifc"), &format!("DATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;")))
    }

    /// Square metres and height of an item.
    pub(in super::super) fn measures(data: &str, item: u64) -> Read<(f64, f64)> {
        let model = model(data);
        let found = footprints(&Geometry::new(&model).item(item, 0)?);
        let areas = found.iter().map(|part| Polygon::new(&part.outer).map_or(0.0, |ring| ring.area()));
        Ok((areas.sum(), found.first().map_or(0.0, |part| part.high - part.low)))
    }

    pub(in super::super) fn assert_measures(data: &str, item: u64, expected: (f64, f64)) {
        let (area, height) = measures(data, item).unwrap_or_else(|trouble| panic!("{trouble:?}"));
        assert!(
            (area - expected.0).abs() < 1e-6 && (height - expected.1).abs() < 1e-6,
            "{data}: {area}, {height}"
        );
    }

    #[test]
    fn faces_that_share_a_list_of_points_cover_their_floor() {
        let polygons = "#2=IFCINDEXEDPOLYGONALFACE((1,2,3,4));#3=IFCINDEXEDPOLYGONALFACE((1,2,5));\n";
        let set = "#4=IFCPOLYGONALFACESET(#1,.F.,(#2,#3),$);";
        assert_measures(&format!("{POINTS}{polygons}{set}"), 4, (12.0, 2.5));
        let triangles = "#4=IFCTRIANGULATEDFACESET(#1,$,.F.,((1,2,3),(1,3,4),(1,2,5)),$);";
        assert_measures(&format!("{POINTS}{triangles}"), 4, (12.0, 2.5));
        let renumbered = "#4=IFCTRIANGULATEDFACESET(#1,$,.F.,((4,3,2)),(5,3,2,1));";
        assert_measures(&format!("{POINTS}{renumbered}"), 4, (6.0, 0.0));
        for broken in ["((1,2,9))", "((0,1,2))", "((1,2,-1))", "((1,2,'x'))"] {
            let set = format!("{POINTS}#4=IFCTRIANGULATEDFACESET(#1,$,.F.,{broken},$);");
            assert!(measures(&set, 4).unwrap_err().message.contains("points that are not there"), "{broken}");
        }
    }

    #[test]
    fn faces_with_holes_and_blocks_are_known() {
        let ring = |id: u64, low: f64, high: f64| {
            let point =
                |at: u64, x: f64, y: f64| format!("#{}=IFCCARTESIANPOINT(({x:?},{y:?},0.));", id + at);
            let corners =
                [point(1, low, low), point(2, high, low), point(3, high, high), point(4, low, high)].concat();
            format!("{corners}#{id}=IFCPOLYLOOP((#{},#{},#{},#{}));\n", id + 1, id + 2, id + 3, id + 4)
        };
        let face = "#20=IFCFACEBOUND(#10,.T.);#40=IFCFACEBOUND(#30,.T.);#2=IFCFACE((#40,#20));\n\
                    #3=IFCCONNECTEDFACESET((#2));#4=IFCFACEBASEDSURFACEMODEL((#3));";
        let data = format!("{}{}{face}", ring(10, 0.0, 10.0), ring(30, 4.0, 5.0));
        let model = model(&data);
        let found = footprints(&Geometry::new(&model).item(4, 0).unwrap());
        assert_eq!((found.len(), found[0].holes.len()), (1, 1));
        let block = "#1=IFCCARTESIANPOINT((1.,1.,0.));#2=IFCAXIS2PLACEMENT3D(#1,$,$);#4=IFCBLOCK(#2,4.,3.,2.);#5=IFCCSGSOLID(#4);";
        assert_measures(block, 5, (12.0, 2.0));
    }

    #[test]
    fn arcs_of_indexed_curves_and_trimmed_circles_bulge() {
        let quarter = std::f64::consts::FRAC_PI_4;
        let indexed = "#1=IFCCARTESIANPOINTLIST2D(((0.,0.),(1.,0.),(0.7071067811865476,0.7071067811865476),(0.,1.)));\
                       #4=IFCINDEXEDPOLYCURVE(#1,(IFCLINEINDEX((1,2)),IFCARCINDEX((2,3,4)),IFCLINEINDEX((4,1))),.F.);";
        let (area, _) = measures(indexed, 4).unwrap();
        assert!((area - quarter).abs() < 0.01, "{area}");
        let circle = "#1=IFCCARTESIANPOINT((0.,0.));#2=IFCAXIS2PLACEMENT2D(#1,$);#3=IFCCIRCLE(#2,1.);\
                      #5=IFCTRIMMEDCURVE(#3,(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(1.5707963267948966)),.T.,.PARAMETER.);\
                      #6=IFCCARTESIANPOINT((0.,1.));#7=IFCPOLYLINE((#6,#1));\
                      #8=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#5);#9=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#7);\
                      #4=IFCCOMPOSITECURVE((#8,#9),.F.);";
        let (area, _) = measures(circle, 4).unwrap();
        assert!((area - quarter).abs() < 0.01, "{area}");
    }

    #[test]
    fn shapes_of_types_are_turned_scaled_and_mirrored() {
        let shape = |operator: &str| {
            format!(
                "#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCAXIS2PLACEMENT3D(#1,$,$);#3=IFCBOUNDINGBOX(#1,4.,3.,2.);\
                 #5=IFCSHAPEREPRESENTATION($,'Body','x',(#3));#6=IFCREPRESENTATIONMAP(#2,#5);\
                 #7=IFCDIRECTION((0.,1.,0.));#8=IFCDIRECTION((1.,0.,0.));#9=IFCDIRECTION((0.,-1.,0.));\
                 #10={operator};#4=IFCMAPPEDITEM(#6,#10);"
            )
        };
        let far_corner = |operator: &str| {
            let model = model(&shape(operator));
            let bodies = Geometry::new(&model).item(4, 0).unwrap();
            bodies[0]
                .corners()
                .into_iter()
                .map(|corner| corner.truncate())
                .reduce(|a, b| if a.length() > b.length() { a } else { b })
        };
        for (operator, corner) in [
            ("IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#1,$,$)", (4.0, 3.0)),
            ("IFCCARTESIANTRANSFORMATIONOPERATOR3D(#7,$,#1,2.,$)", (-6.0, 8.0)),
            ("IFCCARTESIANTRANSFORMATIONOPERATOR3D(#8,#9,#1,1.,$)", (4.0, -3.0)),
            ("IFCCARTESIANTRANSFORMATIONOPERATOR3DNONUNIFORM(#8,#7,#1,1.,$,2.,1.)", (4.0, 6.0)),
        ] {
            let found = far_corner(operator).unwrap();
            assert!(found.distance(glam::DVec2::new(corner.0, corner.1)) < 1e-9, "{operator}: {found}");
        }
        let flat = shape("IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#1,0.,$)");
        assert!(measures(&flat, 4).unwrap_err().message.contains("onto nothing"));
    }
}
