//! Writes the catalogue as pages for people: what each room type requests, with a furnished sample, the classes and the
//! styles.
//!
//! The pages hold nothing but the catalogue; a folder of configuration of one's own gets pages of its own.

mod classes;
mod markdown;
mod programme;
mod rooms;
mod sample;
mod styles;

use crate::batch::distinct_names;
use crate::catalog::{Catalog, DefinitionKind};

/// One file of the handbook.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Page {
    /// Its path below the folder of the handbook, with `/` between folders.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// The page that shows the pictures.
const MAIN_PAGE: &str = "catalogue.md";

/// The folder of the pictures.
const PICTURES: &str = "catalogue";

/// Writes the catalogue as one page in Markdown, first of the answer, and a picture of each furnished room type.
///
/// The rooms are furnished by all threads; the answer depends on the catalogue only.
#[must_use]
pub fn handbook(catalog: &Catalog) -> Vec<Page> {
    let pictures = sample::draw_samples(catalog);
    let ids: Vec<&str> = pictures.iter().map(|(id, _)| id.as_str()).collect();
    let names = distinct_names(&ids);
    let shown = rooms::Pictures(ids.into_iter().zip(&names).collect());
    let text = [
        introduction(catalog),
        rooms::room_section(catalog, &shown),
        classes::class_section(catalog),
        styles::style_section(catalog),
        styles::building_style_section(catalog),
    ]
    .join("\n");
    let main = Page { path: MAIN_PAGE.to_owned(), text };
    let picture = |((_, text), name): ((String, String), &String)| Page {
        path: format!("{PICTURES}/{name}.svg"),
        text,
    };
    std::iter::once(main).chain(pictures.into_iter().zip(&names).map(picture)).collect()
}

fn introduction(catalog: &Catalog) -> String {
    let furnished = catalog.room_types.values().filter(|room_type| room_type.is_furnished).count();
    format!(
        "# Catalogue\n\n\
         Written by `roomwright catalog --docs DIR`; a test compares it with the configuration.\n\n\
         {furnished} [room types](#room-types) that are furnished, {} [classes of furniture](#classes), {} \
         [styles](#styles), {} [building styles](#building-styles).\n\
         `roomwright catalog ID` shows any of them in full.\n",
        catalog.classes.len(),
        catalog.styles.len(),
        catalog.building_styles.len(),
    )
}

/// The file that defines it, with `/` on every system.
fn file_of(catalog: &Catalog, kind: DefinitionKind, id: &str) -> String {
    let origin = catalog.origins.get(&(kind, id.to_owned()));
    origin.map(|origin| origin.file.display().to_string().replace('\\', "/")).unwrap_or_default()
}

/// Definitions by the file they are written in, the files sorted by their paths.
fn by_file<T>(
    catalog: &Catalog,
    kind: DefinitionKind,
    definitions: impl Iterator<Item = (String, T)>,
) -> Vec<(String, Vec<T>)> {
    let mut files: std::collections::BTreeMap<String, Vec<T>> = std::collections::BTreeMap::new();
    for (id, definition) in definitions {
        files.entry(file_of(catalog, kind, &id)).or_default().push(definition);
    }
    files.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::builtin_catalog;

    #[test]
    fn a_catalogue_without_rooms_has_one_page() {
        let pages = handbook(&Catalog::default());
        assert_eq!(pages.len(), 1);
        assert_eq!(pages[0].path, MAIN_PAGE);
        assert!(pages[0].text.contains("0 [room types]"));
    }

    #[test]
    fn a_room_type_has_a_picture_and_every_definition_a_line() {
        let mut catalog = builtin_catalog().clone();
        catalog.room_types.retain(|id, _| id == "toilet" || id == "shaft");
        let pages = handbook(&catalog);
        let paths: Vec<&str> = pages.iter().map(|page| page.path.as_str()).collect();
        assert_eq!(paths, ["catalogue.md", "catalogue/toilet.svg"]);
        assert!(pages[0].text.contains("![Toilet](catalogue/toilet.svg)"), "{}", pages[0].text);
        assert!(pages[0].text.contains("Not furnished: Shaft."));
        assert!(pages[1].text.starts_with("<svg"));
        let names = catalog.classes.iter().map(|class| class.id.as_str());
        let building_styles = catalog.building_styles.keys().map(String::as_str);
        for id in names.chain(catalog.styles.ids()).chain(building_styles) {
            assert!(pages[0].text.contains(&format!("\n| `{id}` |")), "{id}");
        }
    }
}
