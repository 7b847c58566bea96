//! `sparse`: much less furniture on the floor than the style and the type of the room ask for.

use super::programme::programme;
use crate::audit::evidence::Evidence;
use crate::audit::fault::Fault;
use crate::audit::possible::{Ask, Held, Question};
use crate::audit::quantity::Quantity;
use crate::audit::rounding::ROUNDING;
use crate::audit::subject::Subject;
use crate::catalog::{ClassIndex, ParentName};

/// Judges the share of the floor that is covered. The low end of the type's range follows the style's
/// density where that is below one.
pub(crate) fn check(evidence: &Evidence<'_, '_>) -> Vec<Fault> {
    let Evidence { subject, ask, .. } = *evidence;
    let rules = subject.rules();
    let area = subject.at.room.region.area();
    let Some(room_type) = subject.catalog.room_types.get(&subject.at.room.room_type) else {
        return Vec::new();
    };
    if !room_type.is_furnished || area < rules.fulfilment.sparse_area {
        return Vec::new();
    }
    let factor = subject.style().density.min(1.0);
    let least = room_type.density.0 * factor * rules.fulfilment.sparse;
    let standing = subject.bodies.iter().filter(|body| body.is_standing(rules));
    let share = standing.fold(0.0, |sum, body| sum + body.footprint_area()) / area;
    if share >= least - ROUNDING {
        return Vec::new();
    }
    let fault = Fault::new(Quantity::Share, Vec::new(), share, least);
    vec![fault.if_possible(has_room_for_more(subject, area, ask))]
}

/// Whether the empty room could hold some standing piece of its programme.
fn has_room_for_more(subject: &Subject<'_>, area: f64, ask: Ask<'_>) -> Held {
    let lines = programme(subject).into_iter().filter(|line| (line.area.0..=line.area.1).contains(&area));
    let mut classes: Vec<ClassIndex> = lines.flat_map(|line| &line.classes).copied().collect();
    classes.sort_unstable();
    classes.dedup();
    let stands = |class: &ClassIndex| {
        let rules = &subject.catalog.classes[*class].parents;
        rules.iter().any(|rule| {
            matches!(rule.parent, ParentName::Floor | ParentName::Wall) && rule.elevation.0 == 0.0
        })
    };
    Held::any(classes.into_iter().filter(stands).map(|class| ask(&Question::Class(class))))
}

#[cfg(test)]
mod tests {
    use crate::audit::testing::{TestRoom, at, required};
    use crate::audit::{Code, Severity};

    /// A room of some square metres whose type asks for 10 % at least, with one chest of a square metre.
    fn room_of(area: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(area / 4.0, 4.0);
        room.set_density(0.1);
        room.ask(required("chest"));
        room.stand("chest", at(0.5, 0.5));
        room
    }

    #[test]
    fn a_square_metre_is_enough_for_twenty() {
        assert_eq!(room_of(19.0).audit(), []);
        let findings = room_of(22.0).audit();
        assert_eq!((findings[0].code, findings.len()), (Code::Sparse, 1));
        assert!(
            (findings[0].measured - 1.0 / 22.0).abs() < 1e-9 && (findings[0].threshold - 0.05).abs() < 1e-9
        );
    }

    #[test]
    fn a_rug_does_not_fill_a_room() {
        let mut room = room_of(22.0);
        let rug = room.stand("chest", at(3.0, 3.0));
        assert_eq!(room.audit(), []);
        room.placements[rug].size.height = 0.012;
        assert_eq!(room.audit()[0].code, Code::Sparse);
    }

    #[test]
    fn a_room_that_can_hold_nothing_of_its_programme_is_not_the_furnitures_fault() {
        let sparse = |width: f64| {
            let mut room = TestRoom::rectangle(8.0, width);
            room.set_density(0.1);
            room.ask(required("chest"));
            room.audit()[0].clone()
        };
        assert_eq!((sparse(1.1).code, sparse(1.1).severity), (Code::Sparse, Severity::Minor));
        assert_eq!((sparse(0.9).code, sparse(0.9).severity), (Code::Sparse, Severity::Given));
    }

    #[test]
    fn what_hangs_on_walls_does_not_count_and_a_thin_style_asks_for_less() {
        let mut room = room_of(19.0);
        room.placements[0].elevation = 1.0;
        assert_eq!(room.count(Code::Sparse), 1);
        let mut room = room_of(22.0);
        room.catalog.styles.get_mut("default").unwrap().density = 0.8;
        assert_eq!(room.audit(), []);
    }

    #[test]
    fn rooms_that_are_not_furnished_and_tiny_ones_are_not_judged() {
        let mut room = room_of(22.0);
        room.catalog.room_types.get_mut("office").unwrap().is_furnished = false;
        assert_eq!(room.audit(), []);
        let mut room = TestRoom::rectangle(1.9, 2.0);
        room.set_density(0.1);
        assert_eq!(room.audit(), []);
    }
}
