//! Reads the furniture and fixtures of the architects, to compare Roomwright's with.

use glam::DVec3;

use super::NAME;
use super::columns::Products;
use super::level::Storey;
use super::model::{Entity, Read};
use crate::geometry::Point;
use crate::plan::read::drawn::DrawnPiece;

/// The kinds of products that are read here.
pub(super) const KINDS: [&str; 6] = [
    "IFCFURNISHINGELEMENT",
    "IFCFURNITURE",
    "IFCSYSTEMFURNITUREELEMENT",
    "IFCFLOWTERMINAL",
    "IFCSANITARYTERMINAL",
    "IFCELECTRICAPPLIANCE",
];

impl Products<'_> {
    /// The furniture on some storeys of a building.
    pub(super) fn furniture(&self, storeys: &[Storey], building: &str) -> Vec<DrawnPiece> {
        let products = self.all(&KINDS);
        products.filter_map(|product| self.piece(storeys, &product, building).ok().flatten()).collect()
    }

    fn piece(&self, storeys: &[Storey], product: &Entity, building: &str) -> Read<Option<DrawnPiece>> {
        let home = self.relations.within(product.id, |whole| storeys.iter().any(|storey| storey.id == whole));
        let Some(storey) = storeys.iter().find(|storey| Some(storey.id) == home) else { return Ok(None) };
        let axes = self.frame * self.geometry.place(product)?;
        let axis = axes.transform_vector3(DVec3::X).truncate().normalize_or(Point::X);
        let bodies = self.geometry.bodies(product, &self.frame)?;
        let corners: Vec<DVec3> = bodies.iter().flat_map(|body| body.corners()).collect();
        let span = |along: DVec3| {
            let places = corners.iter().map(|corner| corner.dot(along));
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        };
        let [x, y, z] = [axis.extend(0.0), axis.perp().extend(0.0), DVec3::Z].map(span);
        let middle = |span: (f64, f64)| (span.0 + span.1) / 2.0;
        Ok(Some(DrawnPiece {
            building: building.to_owned(),
            level: storey.draft.id.clone(),
            format: NAME,
            kind: String::new(),
            name: product.text(2).unwrap_or_default().to_owned(),
            center: axis * middle(x) + axis.perp() * middle(y),
            axis,
            size: Point::new(x.1 - x.0, y.1 - y.0),
            bottom: z.0 - storey.floor,
        })
        .filter(|piece| piece.size.is_finite()))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::drawn_furniture;
    use crate::plan::read::real_data::folder;
    use crate::plan::{PlanOptions, RoomWords};

    #[test]
    #[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
    fn the_furniture_of_the_duplex_stands_on_its_levels() {
        let Some(folder) = folder("ifc") else { return };
        let words = RoomWords::default();
        let options = PlanOptions::new(&words);
        let pieces = drawn_furniture(&folder.join("Duplex_A_20110907.ifc"), &options).unwrap();
        let on = |level: &str| pieces.iter().filter(|piece| piece.level == level).count();
        assert_eq!((pieces.len(), on("level_1") + on("level_2")), (61, 61));
        let named = |name: &'static str| pieces.iter().filter(move |piece| piece.name.contains(name));
        assert_eq!((named("Base Cabinet").count(), named("Vanity").count()), (16, 5));
        for cabinet in named("Base Cabinet") {
            assert!((cabinet.size.x - 1.0).abs() < 0.02 && cabinet.bottom.abs() < 0.05, "{cabinet:?}");
        }
        assert!(named("Upper Cabinet").all(|piece| piece.bottom > 1.3));
    }

    #[test]
    fn a_file_without_furniture_has_none() {
        let words = RoomWords::default();
        let options = PlanOptions::new(&words);
        let villa = Path::new("tests/cases/plan_import/villa/villa.ifc");
        assert_eq!(drawn_furniture(villa, &options).unwrap(), []);
        assert!(drawn_furniture(Path::new("configs/plans/house.yaml"), &options).is_err());
    }
}
