//! Palettes that a viewer can choose from: `KHR_materials_variants`.

use std::collections::BTreeMap;

use gltf_json::Root;
use gltf_json::extensions::mesh::{KhrMaterialsVariants as Mappings, Mapping, Primitive};
use gltf_json::extensions::root::KhrMaterialsVariants as Variants;
use gltf_json::extensions::scene::khr_materials_variants::Variant;

use crate::scene::SceneVariant;

/// The extension.
pub(crate) const VARIANTS: &str = "KHR_materials_variants";

/// Lists the variants, if there are any.
pub(crate) fn add_variants(root: &mut Root, variants: &[SceneVariant]) {
    if variants.is_empty() {
        return;
    }
    let variants = variants.iter().map(|variant| Variant { name: variant.name.clone() }).collect();
    root.extensions.get_or_insert_default().khr_materials_variants = Some(Variants { variants });
}

/// Which materials a primitive of a material has in the variants; each once, in the order of their indices.
pub(crate) fn mappings(material: usize, variants: &[SceneVariant]) -> Option<Primitive> {
    let mut by_material: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
    for (variant, index) in variants.iter().zip(0..) {
        if let Some(&replacement) = variant.materials.get(&material) {
            by_material.entry(replacement).or_default().push(index);
        }
    }
    let mapping = |(material, variants)| Mapping {
        material: u32::try_from(material).expect("a level has few materials"),
        variants,
    };
    let mappings: Vec<Mapping> = by_material.into_iter().map(mapping).collect();
    (!mappings.is_empty()).then_some(Primitive { khr_materials_variants: Some(Mappings { mappings }) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variant(name: &str, materials: &[(usize, usize)]) -> SceneVariant {
        SceneVariant { name: name.to_owned(), materials: materials.iter().copied().collect() }
    }

    #[test]
    fn variants_with_the_same_material_share_a_mapping() {
        let variants = [variant("a", &[(0, 0)]), variant("b", &[(0, 2)]), variant("c", &[(0, 0)])];
        let json = serde_json::to_value(mappings(0, &variants).unwrap()).unwrap();
        let expected = serde_json::json!({"KHR_materials_variants": {"mappings": [
            {"material": 0, "variants": [0, 2]}, {"material": 2, "variants": [1]},
        ]}});
        assert_eq!(json, expected);
    }

    #[test]
    fn a_material_without_replacement_has_no_mapping() {
        assert!(mappings(1, &[variant("a", &[(0, 0)])]).is_none());
    }
}
