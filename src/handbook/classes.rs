//! The classes, by the file that they are written in.

use std::fmt::Write;

use crate::catalog::{Catalog, Class, DefinitionKind, Size};

use super::by_file;
use super::markdown::{code, number, table, title_of_file};

/// All classes, a table for each file.
pub(super) fn class_section(catalog: &Catalog) -> String {
    let classes = catalog.classes.iter().map(|class| (class.id.clone(), class));
    let mut text =
        "## Classes\n\nSizes are width × depth × height in metres; those in brackets are used only where no \
                    larger one fits, those after a plus only to fill a niche. The number of variants is that of the sizes times that of the looks.\n"
            .to_owned();
    for (file, classes) in by_file(catalog, DefinitionKind::Class, classes) {
        let _ = write!(text, "\n### {}\n\n{} in `{file}`.\n\n", title_of_file(&file), classes.len());
        text += &table(["id", "label", "sizes", "variants"], classes.into_iter().map(row));
    }
    text
}

fn row(class: &Class) -> [String; 4] {
    let sizes = class.sizes.iter().enumerate();
    let show = |(index, size): (usize, &Size)| {
        let text = format!("{} × {} × {}", number(size.width), number(size.depth), number(size.height));
        match index {
            _ if index < class.usual_sizes => text,
            _ if index < class.sizes.len() - class.niche_sizes => format!("({text})"),
            _ => format!("+ {text}"),
        }
    };
    let sizes: Vec<String> = sizes.map(show).collect();
    [code(&class.id), class.label.clone(), sizes.join(", "), class.variant_count().to_string()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipes::find;

    #[test]
    fn spare_sizes_stand_in_brackets_and_those_for_niches_after_a_plus() {
        let sizes = [1.0, 0.5, 1.5].map(|width| Size { width, depth: 0.6, height: 0.75 });
        let plain = Class::plain("desk", sizes.to_vec(), find("desk").unwrap());
        let row = row(&Class { usual_sizes: 1, niche_sizes: 1, looks: 3, ..plain });
        assert_eq!(row[2], "1 × 0.6 × 0.75, (0.5 × 0.6 × 0.75), + 1.5 × 0.6 × 0.75");
        assert_eq!(row[3], "9");
    }
}
