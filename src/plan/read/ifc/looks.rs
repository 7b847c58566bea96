//! Reads how transparent the surfaces of products are drawn, to tell glass from solid panels.

use std::collections::BTreeMap;

use super::model::{Entity, Model};
use super::placement::Geometry;

/// Styles in styles, and shapes in shapes.
const DEEPEST: usize = 4;
/// Share of the light that glass lets through at least.
const GLASS: f64 = 0.05;

/// Styles by the item that they are of.
pub(super) struct Looks(BTreeMap<u64, Vec<u64>>);

impl Looks {
    /// Goes through the styled items of a file.
    pub(super) fn of(model: &Model) -> Self {
        let mut looks: BTreeMap<u64, Vec<u64>> = BTreeMap::new();
        // Colours are no part of a plan: broken ones are passed over.
        for styled in model.ids(&["IFCSTYLEDITEM"]).filter_map(|id| model.get(id).ok()) {
            let (Some(item), Ok(styles)) = (styled.value(0).reference(), styled.references(1)) else {
                continue;
            };
            looks.entry(item).or_default().extend(styles);
        }
        Self(looks)
    }

    /// Whether a product is drawn as glass in any part; `None` where it has no style.
    pub(super) fn is_glass(&self, geometry: &Geometry<'_>, product: &Entity) -> Option<bool> {
        let items = geometry.representations(product).ok()?.into_iter().next()?;
        let seen = items.into_iter().flat_map(|item| self.transparencies(geometry.model, item, 0));
        seen.reduce(f64::max).map(|most| most >= GLASS)
    }

    fn transparencies(&self, model: &Model, item: u64, depth: usize) -> Vec<f64> {
        if let Some(styles) = self.0.get(&item) {
            return styles.iter().flat_map(|style| of_style(model, *style, depth)).collect();
        }
        let is_map = depth < DEEPEST && model.is(item, &["IFCMAPPEDITEM"]);
        let inner = is_map.then(|| {
            let map = model.get(model.get(item)?.reference(0)?)?;
            model.get(map.reference(1)?)?.references(3)
        });
        let inner = inner.and_then(Result::ok).unwrap_or_default();
        inner.into_iter().flat_map(|item| self.transparencies(model, item, depth + 1)).collect()
    }
}

fn of_style(model: &Model, id: u64, depth: usize) -> Vec<f64> {
    let Ok(style) = model.get(id) else { return Vec::new() };
    let inner = match style.kind.as_str() {
        "IFCPRESENTATIONSTYLEASSIGNMENT" => style.references(0),
        "IFCSURFACESTYLE" => style.references(2),
        "IFCSURFACESTYLERENDERING" | "IFCSURFACESTYLESHADING" => {
            return vec![style.value(1).number().unwrap_or(0.0)];
        }
        _ => return Vec::new(),
    };
    let inner = inner.ok().filter(|_| depth < DEEPEST).unwrap_or_default();
    inner.into_iter().flat_map(|style| of_style(model, style, depth + 1)).collect()
}
