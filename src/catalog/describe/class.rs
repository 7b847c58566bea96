//! Describes a class.

use serde_json::{Map, Value, json};

use super::lines::{Lines, class_names, degrees, parent_names, range, rounded};
use crate::catalog::{
    Catalog, Class, ClassIndex, Clearance, Extent, FittedPart, Light, ModelSource, ParentName, ParentRule,
    Relation, Shape, Share, Side, Size, Variety, WallWishes,
};

/// The label, and the size of the first variant.
pub(super) fn summary(catalog: &Catalog, id: &str) -> (String, String) {
    let class = catalog.class_index(id).map(|index| &catalog.classes[index]);
    class.map(|class| (class.label.clone(), show_size(&class.sizes[0]))).unwrap_or_default()
}

/// Everything about a class.
pub(super) fn describe_class(catalog: &Catalog, index: ClassIndex) -> (Lines, Value) {
    let class = &catalog.classes[index];
    let children = list_children(catalog, index);
    let room_types = list_room_types(catalog, index);
    let mut lines = Lines::default();
    lines.add("label", &class.label);
    lines.add("groups", &class.groups.join(", "));
    let in_niches = class.sizes.len() - class.niche_sizes;
    let spare = |index: usize| match index {
        _ if index < class.usual_sizes => "",
        _ if index < in_niches => ", where no larger one fits",
        _ => ", to fill a niche",
    };
    let sizes = class.sizes.iter().enumerate();
    lines.add_all("size", sizes.map(|(index, size)| show_size(size) + spare(index)));
    lines.add("looks", &format!("{} of each size, {}", class.looks, class.variety.describe()));
    lines.add("alike in", class.share.map_or("", Share::word));
    lines.add("shape", &show_shape(&class.shape));
    lines.add_all("light", class.light.iter().map(show_light));
    lines.add_all("stands", class.parents.iter().map(|rule| show_parent(catalog, rule)));
    lines.add("offers", &show_offers(class));
    lines.add_all(
        "keeps free",
        class.clearances.iter().map(|clearance| show_clearance(clearance.side.name(), clearance)),
    );
    let sides: Vec<&str> = class.either.iter().map(|clearance| clearance.side.name()).collect();
    let either = class.either.first().map(|clearance| show_clearance(&sides.join(" or "), clearance));
    lines.add_all("keeps free", either);
    lines.add_all("wishes", class.relations.iter().map(|relation| show_relation(catalog, relation)));
    lines.add("likes walls", &show_walls(catalog, &class.walls));
    lines.add("lies under", &class_names(catalog, &class.covers).join(", "));
    lines.add("is there for", &class_names(catalog, &class.carries).join(", "));
    lines.add("stands", if class.needs_company { "beside others of its class" } else { "" });
    lines.add(
        "grid",
        &class.grid.map_or_else(String::new, |grid| {
            let pairs = if grid.is_back_to_back { ", two back to back" } else { "" };
            format!("every {} × {} m{pairs}", rounded(grid.interval.x), rounded(grid.interval.y))
        }),
    );
    lines.add("fitted as", &class.fitted.map_or_else(String::new, |part| part.word().replace('_', " ")));
    lines.add("placed", if class.is_joint { "together with the other pieces that are" } else { "" });
    lines.add("priority", &class.priority.to_string());
    lines.add("depth", &class.depth.to_string());
    lines.add("eras", &class.eras.iter().map(|era| era.word()).collect::<Vec<_>>().join(", "));
    if let Some((least, most)) = class.wealth {
        lines.add("wealth", &if least == most { least.to_string() } else { format!("{least} to {most}") });
    }
    lines.add("model", &show_model(&class.model));
    lines.add("children", &class_names(catalog, &children).join(", "));
    lines.add("asked for", &room_types.join(", "));
    (lines, value_of(catalog, class, &children, &room_types))
}

fn show_size(size: &Size) -> String {
    format!("{} × {} × {} m", rounded(size.width), rounded(size.depth), rounded(size.height))
}

fn show_shape(shape: &Shape) -> String {
    match shape {
        Shape::Box => "box".to_owned(),
        Shape::Disc => "disc".to_owned(),
        Shape::Prisms(prisms) => format!("{} parts", prisms.len()),
    }
}

fn word<T: serde::Serialize>(value: T) -> String {
    json!(value).as_str().unwrap_or_default().replace('_', " ")
}

fn show_parent(catalog: &Catalog, rule: &ParentRule) -> String {
    let sides: Vec<&str> = rule.sides.iter().map(|side| side.name()).collect();
    let parents = show_target(catalog, &rule.parent);
    let mut text = format!("{} of {parents}; turned {}", sides.join(", "), word(rule.orientation.turn));
    if rule.orientation.jitter > 0.0 {
        text += &format!(" ± {}°", degrees(rule.orientation.jitter));
    }
    text += &format!(", along {}", word(rule.along));
    if rule.gap != (0.0, 0.0) {
        text += &format!(", gap {} m", range(rule.gap));
    }
    if rule.elevation != (0.0, 0.0) {
        text += &format!(", {} m up", range(rule.elevation));
    }
    if let Some(tag) = &rule.tag {
        text += &format!(", tagged {tag}");
    }
    text
}

/// A room part, a group, or classes.
fn show_target(catalog: &Catalog, target: &ParentName) -> String {
    match target {
        ParentName::Classes(classes) => catalog.class_names(classes),
        part => parent_names(catalog, part).join(", "),
    }
}

fn show_offers(class: &Class) -> String {
    let offers = Side::ALL.into_iter().filter(|&side| class.offer(side).places > 0);
    let offers: Vec<String> =
        offers.map(|side| format!("{} {}", side.name(), class.offer(side).places)).collect();
    offers.join(", ")
}

fn show_walls(catalog: &Catalog, walls: &WallWishes) -> String {
    let with = walls.with.iter().map(|(classes, points)| {
        format!("with {} {:+}", class_names(catalog, classes).join(" or "), rounded(*points))
    });
    let tags = walls.tags.iter().map(|(tag, points)| format!("{tag} {:+}", rounded(*points)));
    let metre = (walls.metre != 0.0).then(|| format!("each metre {:+}", rounded(walls.metre)));
    let corner = (walls.corner != 0.0).then(|| format!("in a corner {:+}", rounded(walls.corner)));
    let half_corner =
        (walls.half_corner != 0.0).then(|| format!("in half a corner {:+}", rounded(walls.half_corner)));
    tags.chain(with).chain(metre).chain(corner).chain(half_corner).collect::<Vec<_>>().join(", ")
}

fn show_relation(catalog: &Catalog, relation: &Relation) -> String {
    let targets = show_target(catalog, &relation.target);
    format!(
        "{} {targets}, {} m, weight {}{}",
        word(relation.kind),
        range(relation.distance),
        rounded(relation.weight),
        if relation.is_needed { ", needed" } else { "" }
    )
}

fn show_model(model: &ModelSource) -> String {
    match model {
        ModelSource::Recipe { recipe, parameters } => {
            let parameters: Vec<String> =
                parameters.iter().map(|(name, value)| format!("{name} {}", rounded(*value))).collect();
            format!("recipe {} {}", recipe.name(), parameters.join(", ")).trim_end().to_owned()
        }
        ModelSource::File { path, .. } => format!("file {}", path.display()),
    }
}

/// The classes that name this one as a parent, at a side where it has places.
fn list_children(catalog: &Catalog, parent: ClassIndex) -> Vec<ClassIndex> {
    let accepts = |rule: &ParentRule| {
        let is_named = matches!(&rule.parent, ParentName::Classes(classes) if classes.contains(&parent));
        is_named && rule.sides.iter().any(|&side| catalog.classes[parent].offer(side).places > 0)
    };
    (0..catalog.classes.len()).filter(|&child| catalog.classes[child].parents.iter().any(accepts)).collect()
}

/// The room types whose own programme asks for the class.
fn list_room_types(catalog: &Catalog, class: ClassIndex) -> Vec<&str> {
    let asks = catalog
        .room_types
        .values()
        .filter(|room_type| room_type.programme.iter().any(|request| request.asks_for(class)));
    asks.map(|room_type| room_type.id.as_str()).collect()
}

fn value_of(catalog: &Catalog, class: &Class, children: &[ClassIndex], room_types: &[&str]) -> Value {
    let all: Vec<[f64; 3]> = class.sizes.iter().map(|size| [size.width, size.depth, size.height]).collect();
    let (common, niche_sizes) = all.split_at(all.len() - class.niche_sizes);
    let (sizes, spare_sizes) = common.split_at(class.usual_sizes);
    let parents: Vec<Value> = class.parents.iter().map(|rule| value_of_parent(catalog, rule)).collect();
    let relations: Vec<Value> =
        class.relations.iter().map(|relation| value_of_relation(catalog, relation)).collect();
    json!({
        "label": class.label,
        "groups": class.groups,
        "sizes": sizes,
        "spare_sizes": spare_sizes,
        "niche_sizes": niche_sizes,
        "looks": class.looks,
        "varied": match class.variety {
            Variety::None => json!(false),
            Variety::Details => json!("details"),
            Variety::Full => json!(true),
        },
        "share": class.share.map(Share::word),
        "light": class.light.map(|light| json!({
            "lumens": rounded(light.lumens),
            "kelvin": rounded(light.kelvin),
            "from": light.from.name(),
        })),
        "shape": value_of_shape(&class.shape),
        "parents": parents,
        "sides": value_of_sides(class),
        "clearances": clearances(class),
        "relations": relations,
        "covers": class_names(catalog, &class.covers),
        "carries": class_names(catalog, &class.carries),
        "company": class.needs_company,
        "grid": class.grid.map(|grid| json!({
            "interval": [grid.interval.x, grid.interval.y], "block": grid.block, "aisle": grid.aisle, "centered": grid.is_centered,
            "halved": grid.is_halved, "back_to_back": grid.is_back_to_back, "margin": grid.margin
        })),
        "fitted": class.fitted.map(FittedPart::word),
        "joint": class.is_joint,
        "walls": json!({
            "tags": class.walls.tags.iter().map(|(tag, points)| (tag.clone(), json!(rounded(*points)))).collect::<serde_json::Map<_, _>>(),
            "with": class.walls.with.iter().map(|(classes, points)| json!({
                "classes": class_names(catalog, classes), "points": rounded(*points),
            })).collect::<Vec<_>>(),
            "metre": rounded(class.walls.metre),
        }),
        "priority": class.priority,
        "depth": class.depth,
        "eras": class.eras,
        "wealth": class.wealth,
        "model": value_of_model(&class.model),
        "children": class_names(catalog, children),
        "room_types": room_types,
    })
}

fn value_of_shape(shape: &Shape) -> Value {
    let prisms = match shape {
        Shape::Box => return json!("box"),
        Shape::Disc => return json!("disc"),
        Shape::Prisms(prisms) => prisms,
    };
    let extent = |extent: &Extent| {
        if extent.share == 0.0 {
            return json!(extent.offset);
        }
        let share = format!("{}%", rounded(extent.share * 100.0));
        json!(if extent.offset == 0.0 { share } else { format!("{share}{:+}", rounded(extent.offset)) })
    };
    let part = |low: &[Extent; 3], high: &[Extent; 3], is_disc: bool| json!({"disc": is_disc, "from": low.each_ref().map(extent), "to": high.each_ref().map(extent)});
    json!(prisms.iter().map(|prism| part(&prism.low, &prism.high, prism.is_disc)).collect::<Vec<_>>())
}

fn value_of_parent(catalog: &Catalog, rule: &ParentRule) -> Value {
    json!({
        "on": parent_names(catalog, &rule.parent),
        "side": rule.sides,
        "tag": rule.tag,
        "turn": rule.orientation.turn,
        "jitter": degrees(rule.orientation.jitter),
        "along": rule.along,
        "gap": [rule.gap.0, rule.gap.1],
        "elevation": [rule.elevation.0, rule.elevation.1],
        "above_head": rule.above_head,
    })
}

fn value_of_sides(class: &Class) -> Value {
    let mut sides = Map::new();
    for side in Side::ALL {
        let offer = class.offer(side);
        if offer.places > 0 {
            let value = json!({
                "places": offer.places, "space": offer.space, "surface": offer.surface, "margin": offer.margin
            });
            sides.insert(side.name().to_owned(), value);
        }
    }
    Value::Object(sides)
}

fn clearances(class: &Class) -> Vec<Value> {
    let all = class.all_clearances().enumerate();
    all.map(|(number, clearance)| value_of_clearance(clearance, class.is_either(number))).collect()
}

fn show_clearance(sides: &str, clearance: &Clearance) -> String {
    format!("{sides} {} m, better {} m", rounded(clearance.minimum), rounded(clearance.good))
}

fn value_of_clearance(clearance: &Clearance, is_either: bool) -> Value {
    json!({
        "side": clearance.side,
        "minimum": clearance.minimum,
        "good": clearance.good,
        "margin": clearance.margin,
        "height": clearance.height,
        "children": clearance.allows_children,
        "either": is_either,
    })
}

fn value_of_relation(catalog: &Catalog, relation: &Relation) -> Value {
    json!({
        json!(relation.kind).as_str().unwrap_or_default(): parent_names(catalog, &relation.target),
        "distance": [relation.distance.0, relation.distance.1],
        "angle": degrees(relation.angle),
        "weight": relation.weight,
        "needed": relation.is_needed,
    })
}

fn value_of_model(model: &ModelSource) -> Value {
    match model {
        ModelSource::Recipe { recipe, parameters } => {
            let mut value = json!({"recipe": recipe.name()});
            for (parameter, number) in parameters {
                value[parameter] = json!(number);
            }
            value
        }
        ModelSource::File { path, turn } => {
            json!({"file": path.display().to_string(), "turn": degrees(*turn)})
        }
    }
}

fn show_light(light: &Light) -> String {
    format!("{} lm, {} K, {}", rounded(light.lumens), rounded(light.kelvin), light.from.name())
}
