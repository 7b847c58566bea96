//! Styles by their changes, and building styles by the styles that they draw from.

use crate::catalog::{BuildingStyle, Catalog, DefinitionKind, Style, WeightedStyle, style_differences};

use super::markdown::{code, codes, number, table};

/// All styles, each with what is not as in the one that it extends.
pub(super) fn style_section(catalog: &Catalog) -> String {
    let row = |style: &Style| {
        let id = &style.id;
        let origin = catalog.origins.get(&(DefinitionKind::Style, id.clone()));
        let base = origin.and_then(|origin| origin.extends.as_ref()).map(|base| code(base));
        let differences: Vec<String> = style_differences(catalog, style)
            .into_iter()
            .map(|(name, value)| format!("{name}: {value}"))
            .collect();
        [code(id), style.label.clone(), base.unwrap_or_default(), differences.join("; ")]
    };
    let head = "## Styles\n\nThe last column lists the differences from the style that it extends.\n\n";
    head.to_owned() + &table(["id", "label", "extends", "differences"], catalog.styles.values().map(row))
}

/// All building styles.
pub(super) fn building_style_section(catalog: &Catalog) -> String {
    let head = "## Building styles\n\nNumbers are the weights of the draw; styles without numbers are equally likely.\n\n";
    let names = ["id", "label", "drawn for each", "styles", "other styles for room types"];
    head.to_owned()
        + &table(names, catalog.building_styles.values().map(|style| building_row(catalog, style)))
}

fn building_row(catalog: &Catalog, style: &BuildingStyle) -> [String; 5] {
    let show = |(room_type, choice): (&String, &Vec<WeightedStyle>)| {
        format!("{room_type}: {}", show_choice(catalog, choice))
    };
    let apart: Vec<String> = style.rooms.iter().map(show).collect();
    let choice = show_choice(catalog, &style.styles);
    [code(&style.id), style.label.clone(), style.share.word().to_owned(), choice, apart.join("; ")]
}

fn show_choice(catalog: &Catalog, choice: &[WeightedStyle]) -> String {
    if choice.is_empty() {
        return code(crate::catalog::DEFAULT_STYLE);
    }
    let is_even = choice.windows(2).all(|pair| pair[0].weight == pair[1].weight);
    if is_even {
        return codes(choice.iter().map(|one| &catalog.styles[one.style].id));
    }
    let show =
        |one: &WeightedStyle| format!("{} {}", number(one.weight), code(&catalog.styles[one.style].id));
    choice.iter().map(show).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_weights_are_not_shown() {
        let catalog = crate::catalog::builtin_catalog();
        let weighted =
            |style: &str, weight: f64| WeightedStyle { style: catalog.styles.find(style).unwrap(), weight };
        let show = |choice: &[WeightedStyle]| show_choice(catalog, choice);
        assert_eq!(show(&[weighted("hotel", 1.0), weighted("default", 1.0)]), "`hotel`, `default`");
        assert_eq!(show(&[weighted("hotel", 3.0), weighted("default", 1.0)]), "3 `hotel`, 1 `default`");
        assert_eq!(show(&[]), "`default`");
    }

    #[test]
    fn a_building_style_shows_what_each_room_is_drawn_from() {
        let catalog = crate::catalog::builtin_catalog();
        let row = building_row(catalog, &catalog.building_styles["hotel_building"]);
        assert!(row[4].contains("hotel_room: 3 `hotel`, 1 `hotel_budget`"), "{}", row[4]);
        assert!(row[4].ends_with("restaurant: 3 `restaurant_fine`, 1 `restaurant_simple`"), "{}", row[4]);
    }

    #[test]
    fn a_style_shows_what_it_changes() {
        let catalog = crate::catalog::builtin_catalog();
        let text = style_section(catalog);
        let line = text.lines().find(|line| line.starts_with("| `hotel_budget` |")).unwrap();
        assert!(line.contains("| `hotel` |") && line.contains("palette: budget"), "{line}");
        assert!(!line.contains("made for"), "{line}");
    }
}
