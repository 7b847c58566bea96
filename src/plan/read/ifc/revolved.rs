//! Reads round solids: profiles that turn around an axis, tubes along a curve, cylinders, cones and spheres.

use glam::{DAffine3, DQuat, DVec3};

use super::curve::{Conic, pieces};
use super::model::{Entity, Read};
use super::placement::Geometry;
use super::profile::Rings;
use super::solid::{IfcBody, MOST_FACES};
use super::spline::quads;

/// Bytes of looking that a face costs: a short line makes many.
const COST: usize = 64;
/// Metres of the shortest piece of a tube.
const SHORTEST: f64 = 1e-6;

impl Geometry<'_> {
    /// A profile that turns around an axis in its plane, as flat faces.
    pub(super) fn revolved(&self, item: &Entity, depth: usize) -> Read<Vec<IfcBody>> {
        let rings = self.profile(item.reference(0)?, depth + 1)?;
        let frame = self.axes(item.value(1))?;
        let axis = self.model.get(item.reference(2)?)?;
        let origin = self.point(axis.reference(0)?)?;
        let direction = self.direction(axis.value(1))?.unwrap_or(DVec3::Z);
        let sweep = (item.positive(3)? * self.units.angle).min(std::f64::consts::TAU);
        let off_axis = |corner: DVec3| (corner - origin).reject_from_normalized(direction).length();
        let radius = rings.corners().map(off_axis).fold(0.0, f64::max);
        let count = pieces(radius, sweep);
        let face_count = rings.corners().count() * count as usize;
        if face_count > MOST_FACES || !self.model.charge(COST * face_count) {
            return Err(item.trouble(format!("more than {MOST_FACES} faces")));
        }
        let turned = |step: u32| {
            let angle = sweep * f64::from(step) / f64::from(count);
            let there = DAffine3::from_translation(origin);
            let turn =
                there * DAffine3::from_quat(DQuat::from_axis_angle(direction, angle)) * there.inverse();
            rings.moved(&(frame * turn))
        };
        let steps: Vec<Rings> = (0..=count).map(turned).collect();
        let mut faces: Vec<Rings> = [steps.first(), steps.last()].into_iter().flatten().cloned().collect();
        for ring in 0..=rings.holes.len() {
            let net: Vec<Vec<DVec3>> = steps.iter().map(|rings| closed(rings, ring)).collect();
            faces.extend(quads(&net));
        }
        Ok(vec![IfcBody::Faces(faces)])
    }

    /// A tube along a curve, as a straight one for each piece of it.
    pub(super) fn tube(&self, item: &Entity, depth: usize) -> Read<Vec<IfcBody>> {
        let line = self.curve(item.reference(0)?, depth + 1)?;
        let radius = item.positive(1)? * self.units.length;
        let piece = |ends: &[DVec3]| {
            let sweep = ends[1] - ends[0];
            let direction = sweep.try_normalize().filter(|_| sweep.length() > SHORTEST)?;
            let (x, y) = direction.any_orthonormal_pair();
            let frame = DAffine3::from_cols(x, y, direction, ends[0]);
            Some(IfcBody::Swept(disk(frame, radius), sweep))
        };
        Ok(line.windows(2).filter_map(piece).collect())
    }

    /// A cylinder, a cone or a sphere, as the upright cylinder around it.
    pub(super) fn primitive(&self, item: &Entity) -> Read<Vec<IfcBody>> {
        let frame = self.axes(item.value(0))?;
        let length = |place: usize| Ok(item.positive(place)? * self.units.length);
        let (low, height, radius) = if item.kind == "IFCSPHERE" {
            let radius = length(1)?;
            (-radius, 2.0 * radius, radius)
        } else {
            (0.0, length(1)?, length(2)?)
        };
        let base = DAffine3::from_translation(DVec3::Z * low);
        Ok(vec![IfcBody::Swept(disk(base, radius), DVec3::Z * height).moved(&frame)])
    }
}

/// A ring of rings that ends where it begins: the outline first, then the holes.
fn closed(rings: &Rings, ring: usize) -> Vec<DVec3> {
    let corners = if ring == 0 { &rings.outer } else { &rings.holes[ring - 1] };
    corners.iter().chain(corners.first()).copied().collect()
}

fn disk(frame: DAffine3, radius: f64) -> Rings {
    Rings { outer: Conic { frame, radii: (radius, radius) }.around(), holes: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::super::solid::tests::{assert_measures, measures};

    /// A profile of 0.2 by 3 m, 4 m from the axis z of the product.
    const PROFILE: &str = "#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCDIRECTION((0.,-1.,0.));#3=IFCDIRECTION((1.,0.,0.));\
        #5=IFCAXIS2PLACEMENT3D(#1,#2,#3);#6=IFCCARTESIANPOINT((4.,1.5));#7=IFCAXIS2PLACEMENT2D(#6,$);\
        #8=IFCRECTANGLEPROFILEDEF(.AREA.,$,#7,0.2,3.);#9=IFCDIRECTION((0.,1.,0.));#10=IFCAXIS1PLACEMENT(#1,#9);\n";

    #[test]
    fn a_round_wall_stands_on_a_ring() {
        let half = format!("{PROFILE}#4=IFCREVOLVEDAREASOLID(#8,#5,#10,3.141592653589793);");
        let (area, height) = measures(&half, 4).unwrap();
        let ring = std::f64::consts::PI * (4.1 * 4.1 - 3.9 * 3.9) / 2.0;
        assert!((area - ring).abs() < ring * 0.005 && (height - 3.0).abs() < 1e-9, "{area}, {height}");
        let broken = format!("{PROFILE}#4=IFCREVOLVEDAREASOLID(#8,#5,#10,0.);");
        assert!(measures(&broken, 4).is_err());
    }

    #[test]
    fn tubes_and_primitives_cover_their_shadow() {
        let tube = "#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCCARTESIANPOINT((0.,0.,3.));#3=IFCPOLYLINE((#1,#2,#2));\
                    #4=IFCSWEPTDISKSOLID(#3,0.5,$,$,$);";
        let (area, height) = measures(tube, 4).unwrap();
        assert!(
            (area - std::f64::consts::FRAC_PI_4).abs() < 0.03 && (height - 3.0).abs() < 1e-9,
            "{area}, {height}"
        );
        let round = "#1=IFCCARTESIANPOINT((0.,0.,1.));#2=IFCAXIS2PLACEMENT3D(#1,$,$);";
        let (sphere, height) = measures(&format!("{round}#4=IFCSPHERE(#2,2.);"), 4).unwrap();
        assert!((sphere - 12.566).abs() < 0.1 && (height - 4.0).abs() < 1e-9, "{sphere}, {height}");
        let (cylinder, height) =
            measures(&format!("{round}#4=IFCRIGHTCIRCULARCYLINDER(#2,2.5,2.);"), 4).unwrap();
        assert!((cylinder - sphere).abs() < 1e-9 && (height - 2.5).abs() < 1e-9);
        assert_measures(
            "#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCAXIS2PLACEMENT3D(#1,$,$);#4=IFCBLOCK(#2,4.,3.,2.);",
            4,
            (12.0, 2.0),
        );
    }
}
