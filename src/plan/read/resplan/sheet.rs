//! The plans of a file, with the geometries of each class, whatever its form.

use std::collections::BTreeMap;

use serde_json::Value;

use super::geometry::{Shapes, shapes};
use super::notes::{Notes, Place, below};

/// Square metres of flats: the data set has plans whose stated area is 0, or that of the canvas.
const FLAT_AREA: std::ops::Range<f64> = 5.0..5_000.0;
/// Plans of one file. The data set has 17,107.
const MOST_PLANS: usize = 20_000;

/// A plan in the units of its file.
#[derive(Debug)]
pub(super) struct Sheet {
    pub(super) place: Place,
    /// As the file says it, else its number.
    pub(super) id: String,
    /// Square metres, where stated and those of a flat.
    pub(super) net_area: Option<f64>,
    pub(super) area: Option<f64>,
    /// Whether the file says that its units are metres.
    pub(super) is_metres: bool,
    /// The shapes of each class, by the key of the class.
    pub(super) classes: BTreeMap<String, Shapes>,
}

/// All plans of a document.
pub(super) fn sheets(document: &Value, notes: &mut Notes) -> Vec<Sheet> {
    let plans: Vec<(Place, &Value)> = match document {
        Value::Array(plans) => {
            plans.iter().enumerate().map(|(number, plan)| (vec![number.into()], plan)).collect()
        }
        plan => vec![(Vec::new(), plan)],
    };
    if let Some((place, _)) = plans.get(MOST_PLANS) {
        let message = format!("{} plans are more than are read of one file", plans.len());
        notes.error(place, message, &format!("the first {MOST_PLANS} are read; divide the file"));
    }
    let plans = plans.into_iter().take(MOST_PLANS).enumerate();
    plans.filter_map(|(number, (place, plan))| sheet(plan, place, number, notes)).collect()
}

fn sheet(plan: &Value, place: Place, number: usize, notes: &mut Notes) -> Option<Sheet> {
    let Some(keys) = plan.as_object() else {
        notes.error(
            &place,
            "is no plan",
            "a plan is an object with a key for each class, such as \"bedroom\"",
        );
        return None;
    };
    let metadata = keys.get("metadata").and_then(Value::as_object);
    let stated = |key: &str| metadata.and_then(|metadata| metadata.get(key)).or_else(|| keys.get(key));
    let area = |key: &str| stated(key).and_then(Value::as_f64).filter(|area| FLAT_AREA.contains(area));
    let id = match stated("id") {
        Some(Value::String(id)) => id.clone(),
        Some(Value::Number(id)) => id.to_string(),
        _ => (number + 1).to_string(),
    };
    let mut sheet = Sheet {
        id,
        net_area: area("net_area"),
        area: area("area"),
        is_metres: stated("units").and_then(Value::as_str) == Some("m"),
        classes: BTreeMap::new(),
        place,
    };
    let mut groups: Vec<(Place, &Value)> = Vec::new();
    match (keys.get("instances"), keys.get("geometries")) {
        (Some(instances), _) => {
            let below_instances = below(&sheet.place, "instances");
            for group in ["room", "structural"] {
                groups.extend(instances.get(group).map(|found| (below(&below_instances, group), found)));
            }
        }
        (None, Some(geometries)) => groups.push((below(&sheet.place, "geometries"), geometries)),
        (None, None) => groups.push((sheet.place.clone(), plan)),
    }
    for (place, group) in groups {
        for (class, value) in group.as_object().into_iter().flatten() {
            let found = shapes(value, &below(&place, class.as_str()), notes);
            if let Some(found) = found.filter(|found| !found.is_empty()) {
                sheet.classes.entry(class.clone()).or_default().extend(found);
            }
        }
    }
    Some(sheet)
}
