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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::document::Source;

    const PANE: &str = "#1=IFCPLATE('a',$,$,$,$,$,#2,$,$);#2=IFCPRODUCTDEFINITIONSHAPE($,$,(#3));\
        #3=IFCSHAPEREPRESENTATION($,'Body','x',(#4));#4=IFCMAPPEDITEM(#5,#9);#5=IFCREPRESENTATIONMAP(#9,#6);\
        #6=IFCSHAPEREPRESENTATION($,'Body','x',(#7));#7=IFCFACETEDBREP(#9);#10=IFCSTYLEDITEM(#7,(#11),$);\
        #11=IFCPRESENTATIONSTYLEASSIGNMENT((#12));#12=IFCSURFACESTYLE('Glas',.BOTH.,(#13));\
        #13=IFCSURFACESTYLERENDERING(#14,0.75,$,$,$,$,$,$,.FLAT.);";

    #[test]
    fn glass_lets_light_through_and_what_has_no_style_says_nothing() {
        for (from, to, is_glass) in [
            ("0.75", "0.75", Some(true)),
            ("0.75", "0.", Some(false)),
            ("0.75", "$", Some(false)),
            ("#10=IFCSTYLEDITEM(#7", "#10=IFCSTYLEDITEM(#8", None),
            ("(#12)", "(#11)", None),
        ] {
            let data = format!("DATA;\n{}\nENDSEC;\nEND-ISO-10303-21;", PANE.replacen(from, to, 1));
            let model = Model::new(Source::new(Path::new("pane.ifc"), &data));
            let (geometry, looks) = (Geometry::new(&model), Looks::of(&model));
            assert_eq!(looks.is_glass(&geometry, &model.get(1).unwrap()), is_glass, "{to}");
        }
    }
}
